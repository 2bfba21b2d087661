// The class of complex balls, its sums, products and squares, and its functions, which are those of
// rectangles.

#include <algorithm>
#include <optional>
#include <utility>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/exact_product.hpp"
#include "arithmetic/ball/raw_error.hpp"
#include "arithmetic/complex/narrow.hpp"
#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode {

using namespace detail::complex_balls;
using detail::difference_of_products;
using detail::halved;
using detail::product_error;
using detail::raw_sum;
using detail::set_regular;
using detail::sum_of_products;

complex_ball::complex_ball(ball real_part, ball imaginary_part)
    : rectangle<ball>{std::move(real_part), std::move(imaginary_part)} {
  const polhode::precision p = std::max(re.precision(), im.precision());
  if (re.is_undefined() != im.is_undefined()) {
    re = ball::undefined(p);
    im = ball::undefined(p);
  }
  if (re.precision() != p) re = re.with_precision(p);
  if (im.precision() != p) im = im.with_precision(p);
}

complex_ball::complex_ball(ball real_part)
    : rectangle<ball>{std::move(real_part), ball(detail::room{64})} {
  im = re.is_undefined() ? re : ball(0, re.precision());
}

magnitude complex_ball::magnitude_upper() const {
  const magnitude x = re.magnitude_upper();
  const magnitude y = im.magnitude_upper();
  if (x.is_zero()) return y;
  if (y.is_zero()) return x;
  return sqrt_up(add_up(multiply_up(x, x), multiply_up(y, y)));
}
magnitude complex_ball::magnitude_lower() const {
  const magnitude x = re.magnitude_lower();
  const magnitude y = im.magnitude_lower();
  if (x.is_zero()) return y;
  if (y.is_zero()) return x;
  return sqrt_down(add_down(multiply_down(x, x), multiply_down(y, y)));
}

namespace {

const rectangle<ball>& base(const complex_ball& z) { return z; }

/// z, w with both raised to the greater precision, where they differ.
template <class F>
complex_ball at_common_precision(const complex_ball& z, const complex_ball& w, F&& f) {
  const precision p = std::max(z.precision(), w.precision());
  if (z.precision() != p) return f(base(z.with_precision(p)), base(w));
  if (w.precision() != p) return f(base(z), base(w.with_precision(p)));
  return f(base(z), base(w));
}

/// The error of a sum of two products of balls by midpoint.
detail::raw_error products_error(const ball& a, const ball& b, const ball& c, const ball& d) {
  return raw_sum(halved(product_error(a, b)), halved(product_error(c, d)));
}

/// z w for moderate z and w, each part rounded once. The error of a product of balls is that of
/// product_error, whatever is added to it.
complex_ball narrow_product(const rectangle<ball>& z, const rectangle<ball>& w) {
  const precision p = common_precision(z, w);
  const mpfr_srcptr a = ball_access::first(z.re);
  const mpfr_srcptr b = ball_access::first(z.im);
  const mpfr_srcptr c = ball_access::first(w.re);
  const mpfr_srcptr d = ball_access::first(w.im);
  complex_ball r(detail::room{p});
  set_regular(r.re, p, products_error(z.re, w.re, z.im, w.im),
              [&](mpfr_ptr m) { return difference_of_products(m, a, c, b, d); });
  set_regular(r.im, p, products_error(z.re, w.im, z.im, w.re),
              [&](mpfr_ptr m) { return sum_of_products(m, a, d, b, c); });
  return r;
}

/// z^2 for a moderate z, each part rounded once: a product of a ball with itself is a product of
/// balls.
complex_ball narrow_square(const rectangle<ball>& z) {
  const precision p = common_precision(z, z);
  const mpfr_srcptr a = ball_access::first(z.re);
  const mpfr_srcptr b = ball_access::first(z.im);
  complex_ball r(detail::room{p});
  set_regular(r.re, p, products_error(z.re, z.re, z.im, z.im),
              [&](mpfr_ptr m) { return difference_of_products(m, a, a, b, b); });
  if (detail::is_short(a) && detail::is_short(b)) {
    detail::raw_error error = product_error(z.re, z.im);
    ++error.exponent;
    set_regular(r.im, p, error, [&](mpfr_ptr m) {
      return mpfr_mul_2ui(m, detail::exact_product(a, b).get(), 1, MPFR_RNDN);
    });
  } else {
    multiply(r.im, z.re, z.im);
    scale(r.im, r.im, 1);
  }
  return r;
}

}  // namespace

complex_ball operator+(const complex_ball& z, const complex_ball& w) {
  complex_ball r(detail::room_for(z.re, w.re));
  add(r.re, z.re, w.re);
  add(r.im, z.im, w.im);
  return r;
}
complex_ball operator-(const complex_ball& z, const complex_ball& w) {
  complex_ball r(detail::room_for(z.re, w.re));
  subtract(r.re, z.re, w.re);
  subtract(r.im, z.im, w.im);
  return r;
}
complex_ball operator*(const complex_ball& z, const complex_ball& w) {
  if (are_narrow_and_moderate(z, w)) return narrow_product(z, w);
  return base(z) * base(w);
}
complex_ball operator/(const complex_ball& z, const complex_ball& w) {
  if (are_narrow_and_moderate(z, w) && !contains_zero(base(w))) {
    if (std::optional<complex_ball> r =
            centred_quotient(centred(z), centred(w), std::max(z.precision(), w.precision()))) {
      return *std::move(r);
    }
  }
  return at_common_precision(
      z, w, [](const rectangle<ball>& s, const rectangle<ball>& t) { return s / t; });
}

ball abs(const complex_ball& z) { return abs(base(z)); }
ball arg(const complex_ball& z) { return arg(base(z)); }
complex_ball square(const complex_ball& z) {
  if (is_narrow_and_moderate(z)) return narrow_square(z);
  return square(base(z));
}
complex_ball reciprocal(const complex_ball& z) { return reciprocal(base(z)); }

complex_ball exp(const complex_ball& z) { return exp(base(z)); }
complex_ball log(const complex_ball& z) { return log(base(z)); }
complex_ball sin(const complex_ball& z) { return sin(base(z)); }
complex_ball cos(const complex_ball& z) { return cos(base(z)); }
complex_ball tan(const complex_ball& z) { return tan(base(z)); }
complex_ball sinh(const complex_ball& z) { return sinh(base(z)); }
complex_ball cosh(const complex_ball& z) { return cosh(base(z)); }
complex_ball tanh(const complex_ball& z) { return tanh(base(z)); }
complex_ball asin(const complex_ball& z) { return asin(base(z)); }
complex_ball acos(const complex_ball& z) { return acos(base(z)); }
complex_ball atan(const complex_ball& z) { return atan(base(z)); }
complex_ball asinh(const complex_ball& z) { return asinh(base(z)); }
complex_ball acosh(const complex_ball& z) { return acosh(base(z)); }
complex_ball atanh(const complex_ball& z) { return atanh(base(z)); }
complex_ball pow(const complex_ball& z, long n) { return pow(base(z), n); }
complex_ball pow(const complex_ball& z, const complex_ball& w) {
  return at_common_precision(
      z, w, [](const rectangle<ball>& s, const rectangle<ball>& t) { return pow(s, t); });
}

}  // namespace polhode
