#include "polhode/arithmetic/complex_ball.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <ostream>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/exact_product.hpp"
#include "arithmetic/ball/exponent_range.hpp"
#include "arithmetic/ball/raw_error.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode {

using detail::difference_of_products;
using detail::exponent_range;
using detail::halved;
using detail::mpfr_cell;
using detail::product_error;
using detail::raw_sum;
using detail::set_regular;
using detail::sum_of_products;
using form = ball_access::form;

// ---------------------------------------------------------------------------------------------
// What rectangle.hpp needs.

bool real_set<ball>::is_machine_integer(const ball& x, long& n) {
  if (!x.is_exact()) return false;
  const mpfr_srcptr m = ball_access::first(x);
  if (mpfr_integer_p(m) == 0 || mpfr_fits_slong_p(m, MPFR_RNDN) == 0) return false;
  n = mpfr_get_si(m, MPFR_RNDN);
  return true;
}

bool real_set<ball>::not_negative(const ball& x) {
  // In both forms: a radius is far below its midpoint.
  return !x.is_undefined() && mpfr_sgn(ball_access::first(x)) >= 0;
}

bool real_set<ball>::is_narrow(const ball& x) { return ball_access::is_midpoint_radius(x); }

namespace {
// The ends of a narrow ball are computed to so many bits more: see guard_bits in functions/elementary/carrying.hpp.
constexpr precision end_bits = 64;

/// An end as a point; the numbers beyond the greatest finite one where it is infinite.
ball end_of(const ball& x, int side) {
  const precision p = x.precision() + (ball_access::is_midpoint_radius(x) ? end_bits : 0);
  if (x.is_undefined() || x.is_exact()) return x;
  mpfr_cell end(p);
  if (side < 0) {
    x.lower(end.get());
  } else {
    x.upper(end.get());
  }
  if (mpfr_inf_p(end.get()) == 0) return ball(end.get());
  mpfr_cell greatest(p);
  mpfr_set_inf(greatest.get(), side);
  mpfr_nexttoward(greatest.get(), mpfr_cell(p).get());
  return side < 0 ? ball::from_end_points(end.get(), greatest.get(), p)
                  : ball::from_end_points(greatest.get(), end.get(), p);
}
}  // namespace

ball real_set<ball>::lower_end(const ball& x) { return end_of(x, -1); }
ball real_set<ball>::upper_end(const ball& x) { return end_of(x, 1); }

namespace {
/// By midpoint and radius, and moderate.
bool is_moderate(const ball& x, const exponent_range& range) {
  return ball_access::is_midpoint_radius(x) && range.is_moderate(ball_access::first(x));
}
/// The same for a bounded ball in either form.
bool has_moderate_ends(const ball& x, const exponent_range& range) {
  if (ball_access::is_midpoint_radius(x)) return is_moderate(x, range);
  return x.is_bounded() && range.is_moderate(ball_access::first(x)) &&
         range.is_moderate(ball_access::second(x));
}
bool has_moderate_ends(const rectangle<ball>& z, const exponent_range& range) {
  return has_moderate_ends(z.re, range) && has_moderate_ends(z.im, range);
}
}  // namespace

ball real_set<ball>::modulus(const ball& x, const ball& y) {
  const exponent_range range;
  if (!is_moderate(x, range) || !is_moderate(y, range)) return hypot(x, y);
  if (is_zero(y)) return abs(x);
  if (is_zero(x)) return abs(y);
  return sqrt(square(x) + square(y));
}

long real_set<ball>::bits_before_point(const ball& x) {
  const magnitude size = x.magnitude_upper();
  if (size.is_zero()) return 0;
  // Beyond this nothing is gained: the result overflows, or its angle is not reduced.
  const std::int64_t most = std::int64_t{x.precision()} + 1024;
  return static_cast<long>(
      size.is_infinite() ? 0 : std::clamp<std::int64_t>(size.log2_floor() + 1, 0, most));
}

bool real_set<ball>::is_steady(const rectangle<ball>& z) {
  if (!z.re.is_bounded() || !z.im.is_bounded()) return false;
  return scale(max(z.re.radius(), z.im.radius()), 5) <=
         max(z.re.magnitude_lower(), z.im.magnitude_lower());
}

bool real_set<ball>::enlarge(ball& value, const ball& s, const ball& x, const ball& t,
                             const ball& y) {
  const magnitude error = add_up(multiply_up(s.magnitude_upper(), x.radius()),
                                 multiply_up(t.magnitude_upper(), y.radius()));
  if (error.is_infinite()) return false;
  value = value.enlarged(error);
  return true;
}

std::pair<ball, ball> real_set<ball>::sinh_cosh(const ball& x) {
  constexpr mpfr_exp_t moderate = 20;  // e^|x| is far from overflow
  const bool is_thin =
      ball_access::is_midpoint_radius(x) && ball_access::radius(x) <= magnitude::power_of_two(-10);
  const mpfr_srcptr m = ball_access::first(x);
  const precision p = x.precision();
  // mpfr_sinh_cosh works with as many bits as a tiny x has zeros behind the point; mpfr_sinh and mpfr_cosh do not.
  if (!is_thin ||
      (mpfr_regular_p(m) != 0 && (mpfr_get_exp(m) > moderate || mpfr_get_exp(m) < -p))) {
    return {sinh(x), cosh(x)};
  }
  mpfr_cell s(p);
  mpfr_cell c(p);
  // The ternary values are packed as mpfr_sin_cos packs them.
  const int inexact = mpfr_sinh_cosh(s.get(), c.get(), m, MPFR_RNDN);
  const int sinh_ternary = inexact & 3;
  const int cosh_ternary = inexact >> 2;
  magnitude sinh_error;
  magnitude cosh_error;
  if (const magnitude& radius = ball_access::radius(x); !radius.is_zero()) {
    // sinh(m+h) - s = s (cosh h - 1) + c sinh h and cosh(m+h) - c = c (cosh h - 1) + s sinh h, with
    // cosh r - 1 <= r^2 and sinh r <= r + r^3 for r <= 1.
    const auto true_size = [](mpfr_srcptr v) {
      return add_up(magnitude::abs_up(v), detail::rounding_error(v));
    };
    const magnitude s_up = true_size(s.get());
    const magnitude c_up = true_size(c.get());
    const magnitude r2 = multiply_up(radius, radius);
    const magnitude sinh_r = multiply_up(radius, add_up(magnitude::power_of_two(0), r2));
    sinh_error = add_up(multiply_up(s_up, r2), multiply_up(c_up, sinh_r));
    cosh_error = add_up(multiply_up(c_up, r2), multiply_up(s_up, sinh_r));
  }
  std::pair<ball, ball> r;
  ball_access::first(r.first) = std::move(s);
  ball_access::finish(r.first, sinh_ternary, sinh_error);
  ball_access::first(r.second) = std::move(c);
  ball_access::finish(r.second, cosh_ternary, cosh_error);
  return r;
}

namespace {

/// The midpoints and the radii of both parts of a complex ball.
struct centred {
  /// Of narrow sets.
  explicit centred(const rectangle<ball>& z)
      : re(ball_access::first(z.re)),
        im(ball_access::first(z.im)),
        re_radius(ball_access::radius(z.re)),
        im_radius(ball_access::radius(z.im)) {}
  centred(mpfr_srcptr x, const magnitude& rx, mpfr_srcptr y, const magnitude& ry)
      : re(x), im(y), re_radius(rx), im_radius(ry) {}
  [[nodiscard]] bool is_exact() const { return re_radius.is_zero() && im_radius.is_zero(); }

  mpfr_srcptr re;
  mpfr_srcptr im;
  magnitude re_radius;
  magnitude im_radius;
};

/// The same of any bounded sets.
class centred_copy {
 public:
  explicit centred_copy(const rectangle<ball>& z)
      : x_(z.re.middle()),
        y_(z.im.middle()),
        view_(ball_access::first(std::as_const(x_)), z.re.radius(),
              ball_access::first(std::as_const(y_)), z.im.radius()) {}
  centred_copy(const centred_copy&) = delete;
  centred_copy(centred_copy&&) = delete;
  centred_copy& operator=(const centred_copy&) = delete;
  centred_copy& operator=(centred_copy&&) = delete;
  ~centred_copy() = default;
  [[nodiscard]] const centred& view() const { return view_; }

 private:
  ball x_;
  ball y_;
  centred view_;
};

bool is_narrow_and_moderate(const rectangle<ball>& z, const exponent_range& range = {}) {
  return is_moderate(z.re, range) && is_moderate(z.im, range);
}
bool are_narrow_and_moderate(const rectangle<ball>& z, const rectangle<ball>& w) {
  const exponent_range range;
  return is_narrow_and_moderate(z, range) && is_narrow_and_moderate(w, range);
}

precision common_precision(const rectangle<ball>& z, const rectangle<ball>& w) {
  return std::max({z.re.precision(), z.im.precision(), w.re.precision(), w.im.precision()});
}

/// a b + c d, rounded up.
magnitude sum_of_products_up(const magnitude& a, const magnitude& b, const magnitude& c,
                             const magnitude& d) {
  return add_up(multiply_up(a, b), multiply_up(c, d));
}

/// Bounds of the sizes of the members of a set; they have the midpoint's sign where least > 0.
struct range_of_size {
  magnitude least;
  magnitude most;
};
range_of_size size_of(mpfr_srcptr midpoint, const magnitude& radius) {
  return {subtract_down(magnitude::abs_down(midpoint), radius),
          add_up(magnitude::abs_up(midpoint), radius)};
}
range_of_size product(const range_of_size& x, const range_of_size& y) {
  return {multiply_down(x.least, y.least), multiply_up(x.most, y.most)};
}
/// The greatest |x + y| for two such sets of one sign, or of two; a set about 0 may have either.
magnitude size_of_sum(const range_of_size& x, const range_of_size& y, bool same_sign) {
  return same_sign || x.least.is_zero() || y.least.is_zero()
             ? add_up(x.most, y.most)
             : max(subtract_up(x.most, y.least), subtract_up(y.most, x.least));
}

/// Makes r the ball about `value`, rounded to r's precision, with that error and the rounding's.
void set_rounded(ball& r, mpfr_srcptr value, precision p, const magnitude& error) {
  detail::set_midpoint(r, p, error, [&](mpfr_ptr m) { return mpfr_set(m, value, MPFR_RNDN); });
}

/// The error of a sum of two products of balls by midpoint.
detail::raw_error products_error(const ball& a, const ball& b, const ball& c, const ball& d) {
  return raw_sum(halved(product_error(a, b)), halved(product_error(c, d)));
}

/// z w for moderate z and w, each part rounded once. The error of a product of balls is that of product_error,
/// whatever is added to it.
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

/// z^2 for a moderate z, each part rounded once: a product of a ball with itself is a product of balls.
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

/// The quotient of moderate sets, to first order; nothing where an intermediate number left MPFR's range, or b's
/// midpoint is 0.
std::optional<complex_ball> centred_quotient(const centred& a, const centred& b, precision p) {
  // m / n at the midpoints: numerators and |n|^2 are rounded once each, to p + 8 bits, and so is
  // their quotient: a relative error of each part below 3.1 * 2^-(p+8), below 2^-(p+6).
  const precision wp = p + 8;
  mpfr_cell norm(wp);
  mpfr_cell re(wp);
  mpfr_cell im(wp);
  const exponent_range range;
  bool faithful = true;
  const auto is_inexact = [&](const mpfr_cell& x, int ternary) {
    faithful = range.is_faithful(x.get(), ternary) && faithful;
    return ternary != 0;
  };
  const bool inexact_norm =
      is_inexact(norm, mpfr_fmma(norm.get(), b.re, b.re, b.im, b.im, MPFR_RNDN));
  bool inexact_re = is_inexact(re, mpfr_fmma(re.get(), a.re, b.re, a.im, b.im, MPFR_RNDN));
  bool inexact_im = is_inexact(im, mpfr_fmms(im.get(), a.im, b.re, a.re, b.im, MPFR_RNDN));
  inexact_re = is_inexact(re, mpfr_div(re.get(), re.get(), norm.get(), MPFR_RNDN)) || inexact_re;
  inexact_im = is_inexact(im, mpfr_div(im.get(), im.get(), norm.get(), MPFR_RNDN)) || inexact_im;
  if (!faithful) return std::nullopt;
  inexact_re = inexact_re || inexact_norm;
  inexact_im = inexact_im || inexact_norm;
  const magnitude re_up = magnitude::abs_up(re.get());
  const magnitude im_up = magnitude::abs_up(im.get());
  magnitude re_error;
  magnitude im_error;
  if (inexact_re) re_error = scale(re_up, -(std::int64_t{p} + 6));
  if (inexact_im) im_error = scale(im_up, -(std::int64_t{p} + 6));
  if (!a.is_exact() || !b.is_exact()) {
    // With z = m + s, w = n + t, q = m/n: z/w - q = (s conj(w) - t q conj(w)) / |w|^2.
    const range_of_size x = size_of(b.re, b.re_radius);
    const range_of_size y = size_of(b.im, b.im_radius);
    const range_of_size qx = size_of(re.get(), re_error);
    const range_of_size qy = size_of(im.get(), im_error);
    const bool agree = (mpfr_sgn(re.get()) < 0) == (mpfr_sgn(b.re) < 0);
    const bool im_agree = (mpfr_sgn(im.get()) < 0) == (mpfr_sgn(b.im) < 0);
    const bool crosswise = (mpfr_sgn(im.get()) < 0) == (mpfr_sgn(b.re) < 0);
    const bool im_crosswise = (mpfr_sgn(re.get()) < 0) == (mpfr_sgn(b.im) < 0);
    const magnitude slope_re = size_of_sum(product(qx, x), product(qy, y), agree == im_agree);
    const magnitude slope_im =
        size_of_sum(product(qy, x), product(qx, y), crosswise != im_crosswise);
    const magnitude least =
        add_down(multiply_down(x.least, x.least), multiply_down(y.least, y.least));
    const magnitude re_sum =
        add_up(sum_of_products_up(x.most, a.re_radius, y.most, a.im_radius),
               sum_of_products_up(slope_re, b.re_radius, slope_im, b.im_radius));
    const magnitude im_sum =
        add_up(sum_of_products_up(y.most, a.re_radius, x.most, a.im_radius),
               sum_of_products_up(slope_im, b.re_radius, slope_re, b.im_radius));
    re_error = add_up(re_error, divide_up(re_sum, least));
    im_error = add_up(im_error, divide_up(im_sum, least));
  }
  complex_ball r(detail::room{p});
  set_rounded(r.re, re.get(), p, re_error);
  set_rounded(r.im, im.get(), p, im_error);
  return r;
}

/// z / w by interval evaluation, with both brought near 1 in size by powers of two, and of w's parts one at least: nothing
/// leaves the range that is not negligible beside 1, and balls enclose what does. Undefined where |w|^2 may be 0.
rectangle<ball> scaled_quotient(const rectangle<ball>& z, const rectangle<ball>& w, precision p) {
  constexpr precision guard = 10;
  const auto exponent_of = [](const rectangle<ball>& x) {
    const magnitude size = max(x.re.magnitude_upper(), x.im.magnitude_upper());
    return size.is_zero() || size.is_infinite() ? 0L : static_cast<long>(size.log2_floor());
  };
  const auto scaled = [](const rectangle<ball>& x, long n) {
    return rectangle<ball>{scale(x.re, n), scale(x.im, n)};
  };
  const long ez = exponent_of(z);
  const long ew = exponent_of(w);
  const rectangle<ball> a = detail::rectangles::raised(scaled(z, -ez), guard);
  const rectangle<ball> b = detail::rectangles::raised(scaled(w, -ew), guard);
  const ball norm = square(b.re) + square(b.im);
  const rectangle<ball> r{(a.re * b.re + a.im * b.im) / norm, (a.im * b.re - a.re * b.im) / norm};
  return scaled(rectangle<ball>{r.re.with_precision(p), r.im.with_precision(p)}, ez - ew);
}

/// The square root about that of the moderate midpoint m = x + iy; nothing where the set is not far from 0 for its radii,
/// or may meet the cut, or an intermediate number left MPFR's range.
///
/// With r = |m|, w = sqrt((r + |x|)/2) and |y|/(2w) are the parts' sizes, in this order for x >= 0. r^2, r, the sum, w and
/// the quotient are rounded once each, to p + 10 bits: relative errors, in units of 2^-(p+10), below 1, 1.6, 2.7, 2.4 and
/// 3.5. So both parts have one below 2^-(p+8).
///
/// For a member z = m + s + it of the set, |z| >= L: f(z) = sqrt z is off from f(m) by at most (|s| + |t|)/(2 sqrt L) =: e,
/// as |f'| = 1/(2 sqrt|z|). f' = conj(f)/(2|z|), so that the real part of f changes by at most
/// ((|Re f(m)| + e)|s| + (|Im f(m)| + e)|t|)/(2L), and the imaginary one by the same with |s| and |t| exchanged.
std::optional<complex_ball> narrow_sqrt(const rectangle<ball>& z) {
  const centred c(z);
  if (mpfr_number_p(c.re) == 0 || mpfr_regular_p(c.im) == 0) return std::nullopt;
  const range_of_size x = size_of(c.re, c.re_radius);
  const range_of_size y = size_of(c.im, c.im_radius);
  const bool is_on_right = !x.least.is_zero() && mpfr_sgn(c.re) > 0;
  if (!is_on_right && y.least.is_zero()) return std::nullopt;
  const magnitude least =
      sqrt_down(add_down(multiply_down(x.least, x.least), multiply_down(y.least, y.least)));
  const magnitude radii = add_up(c.re_radius, c.im_radius);
  if (scale(radii, 5) > least) return std::nullopt;
  const precision p = common_precision(z, z);
  const precision wp = p + 10;
  mpfr_cell larger(wp);
  mpfr_cell smaller(wp);
  const mpfr_ptr w = larger.get();
  const exponent_range range;
  bool inexact = false;
  bool faithful = true;
  const auto rounded = [&](mpfr_srcptr number, int ternary) {
    inexact = ternary != 0 || inexact;
    faithful = range.is_faithful(number, ternary) && faithful;
  };
  rounded(w, mpfr_fmma(w, c.re, c.re, c.im, c.im, MPFR_RNDN));
  rounded(w, mpfr_sqrt(w, w, MPFR_RNDN));
  const bool is_left = mpfr_sgn(c.re) < 0;
  rounded(w, is_left ? mpfr_sub(w, w, c.re, MPFR_RNDN) : mpfr_add(w, w, c.re, MPFR_RNDN));
  rounded(w, mpfr_div_2ui(w, w, 1, MPFR_RNDN));
  rounded(w, mpfr_sqrt(w, w, MPFR_RNDN));
  rounded(smaller.get(), mpfr_div(smaller.get(), c.im, w, MPFR_RNDN));
  rounded(smaller.get(), mpfr_div_2ui(smaller.get(), smaller.get(), 1, MPFR_RNDN));
  if (!faithful) return std::nullopt;
  if (is_left) {
    mpfr_setsign(w, w, mpfr_sgn(c.im) < 0 ? 1 : 0, MPFR_RNDN);
    mpfr_abs(smaller.get(), smaller.get(), MPFR_RNDN);
  }
  const mpfr_srcptr re = is_left ? smaller.get() : w;
  const mpfr_srcptr im = is_left ? w : smaller.get();
  const magnitude re_up = magnitude::abs_up(re);
  const magnitude im_up = magnitude::abs_up(im);
  magnitude re_error;
  magnitude im_error;
  if (inexact) {
    // Relative to the computed number, not to the true one: 2^-(p+7) has room for that.
    re_error = scale(re_up, -(std::int64_t{p} + 7));
    im_error = scale(im_up, -(std::int64_t{p} + 7));
  }
  if (!c.is_exact()) {
    const magnitude e = scale(divide_up(radii, sqrt_down(least)), -1);
    const magnitude re_most = add_up(add_up(re_up, re_error), e);
    const magnitude im_most = add_up(add_up(im_up, im_error), e);
    const auto change = [&](const magnitude& of_re, const magnitude& of_im) {
      return scale(divide_up(sum_of_products_up(of_re, c.re_radius, of_im, c.im_radius), least),
                   -1);
    };
    re_error = add_up(re_error, change(re_most, im_most));
    im_error = add_up(im_error, change(im_most, re_most));
  }
  complex_ball r(detail::room{p});
  set_rounded(r.re, re, p, re_error);
  set_rounded(r.im, im, p, im_error);
  return r;
}

}  // namespace

rectangle<ball> real_set<ball>::quotient(const rectangle<ball>& z, const rectangle<ball>& w) {
  const precision p = common_precision(z, w);
  const exponent_range range;
  std::optional<complex_ball> r;
  if (is_narrow_and_moderate(z, range) && is_narrow_and_moderate(w, range)) {
    r = centred_quotient(centred(z), centred(w), p);
  } else if (has_moderate_ends(z, range) && has_moderate_ends(w, range)) {
    r = centred_quotient(centred_copy(z).view(), centred_copy(w).view(), p);
  }
  if (r) return *std::move(r);
  return scaled_quotient(z, w, p);
}

// ---------------------------------------------------------------------------------------------
// The class.

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
complex_ball sqrt(const complex_ball& z) {
  if (is_narrow_and_moderate(z)) {
    if (std::optional<complex_ball> r = narrow_sqrt(z)) return *std::move(r);
  }
  return sqrt(base(z));
}
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

// ---------------------------------------------------------------------------------------------
// The arithmetic-geometric mean.

namespace {

// The ratio's logarithm halves with each step until it is of order 1 (63 steps at most in MPFR's
// range of exponents), then digits double.
constexpr int most_agm_steps = 140;

/// The square of half side m: it holds every number of size up to m.
complex_ball square_of_half_side(const magnitude& m, precision p) {
  const ball side = ball(0, p).enlarged(m);
  return {side, side};
}

bool is_exactly_zero(const complex_ball& z) {
  return sign_of(z.re) == sign::zero && sign_of(z.im) == sign::zero;
}

ball without_negatives(const ball& x) {
  if (real_set<ball>::not_negative(x) || x.is_undefined()) return x;
  return intersection(x, hull(ball(0, x.precision()), abs(x)));
}

/// The mean of members a, b with arguments in [-pi/2, pi/2] that differ by less than pi. Then the
/// root of a b whose argument is half the sum of theirs, sqrt(a) sqrt(b), lies with (a + b) / 2 in
/// the convex cone between a and b, at its half angle: the two differ in argument by less than
/// pi/2, which makes it the right choice, and the hypothesis holds for the next pair. It is the
/// principal root of a b.
///
/// The error. For right choices, with roots so taken that b_{n+1} = sqrt(a_n) sqrt(b_n):
///     a_{n+1} - b_{n+1} = (sqrt a_n - sqrt b_n)^2 / 2,
///     a_{n+1} + b_{n+1} = (sqrt a_n + sqrt b_n)^2 / 2,
/// and the right choice says |sqrt a_n - sqrt b_n| <= |sqrt a_n + sqrt b_n|. So
///   (1) |a_{n+1} - b_{n+1}| <= |a_n - b_n| / 2 (Cox 1984, section 2), and as
///       |a_{n+1} - a_n| = |a_n - b_n| / 2, |M - a_n| <= |a_n - b_n|;
///   (2) |sqrt a_n + sqrt b_n|^2 >= |a_n| + |b_n| (the parallelogram law), hence
///       |M - a_{n+1}| <= |a_{n+1} - b_{n+1}| = |a_n - b_n|^2 / (2 |sqrt a_n + sqrt b_n|^2)
///                     <= |a_n - b_n|^2 / (2 (|a_n| + |b_n|));
///   (3) |M| <= max(|a_n|, |b_n|), as that maximum does not increase.
complex_ball mean_in_right_half_plane(complex_ball a, complex_ball b, precision p) {
  if (is_exactly_zero(a) || is_exactly_zero(b)) return {0, a.precision()};
  magnitude last = magnitude::infinity();
  for (int step = 0;; ++step) {
    a.re = without_negatives(a.re);
    b.re = without_negatives(b.re);
    const magnitude distance = (a - b).magnitude_upper();
    const magnitude size = add_down(a.magnitude_lower(), b.magnitude_lower());
    const magnitude error =
        divide_up(scale(multiply_up(distance, distance), -1), size);  // infinite for size 0
    const bool is_last = error <= scale(size, -(std::int64_t{p} + 1));
    // Where the distance of the sets hardly falls any more, it is that of members of wide sets.
    const bool stalls = scale(distance, 4) >= multiply_up(last, magnitude::from_integer_up(15));
    const complex_ball next = scale(a + b, -1);
    if (is_last || stalls || step == most_agm_steps) {
      complex_ball r =
          square_of_half_side(max(a.magnitude_upper(), b.magnitude_upper()), a.precision());
      const complex_ball by_distance = a.enlarged(distance);
      if (!distance.is_infinite()) r = intersection(r, by_distance);
      if (!error.is_infinite()) r = intersection(r, next.enlarged(error));
      return r;
    }
    last = distance;
    const complex_ball product = a * b;
    b = possibly_singular::sqrt(product) ? sqrt(a) * sqrt(b) : sqrt(product);
    a = next;
  }
}

/// agm(z) for im z >= 0, as a limit from above where im z = 0.
complex_ball agm_above(const complex_ball& z, precision p) {
  const complex_ball one(1, z.precision());
  if (real_set<ball>::not_negative(z.re)) return mean_in_right_half_plane(one, z, p);
  // After one step, with the root in the closed first quadrant: it is the right choice, or the
  // limit of it, since sqrt(z) / ((1 + z) / 2) = 2 / (s + 1/s) with s = sqrt(z), re s > 0 off the
  // cut. Both means lie in the closed upper half plane, and the geometric one on its edge only for
  // z >= 0; times -i they satisfy the hypothesis.
  const complex_ball arithmetic = scale(one + z, -1);
  const complex_ball geometric = sqrt(z);
  const auto turned = [](const complex_ball& w) { return complex_ball(w.im, -w.re); };
  return times_i(mean_in_right_half_plane(turned(arithmetic), turned(geometric), p));
}

}  // namespace

complex_ball agm(const complex_ball& z) {
  const precision p = z.precision();
  if (z.is_undefined()) return z;
  if (real_set<ball>::is_zero(z.im) && real_set<ball>::not_negative(z.re)) {
    return complex_ball(agm(ball(1, p), z.re));
  }
  // Each of some log2(p) + 70 steps adds a few roundings.
  const complex_ball w = z.with_precision(p + 12);
  if (certainly_positive(w.re)) {
    return mean_in_right_half_plane(complex_ball(1, w.precision()), w, p + 4).with_precision(p);
  }
  if (real_set<ball>::not_negative(w.im)) return agm_above(w, p + 4).with_precision(p);
  if (certainly_negative(w.im)) return conj(agm_above(conj(w), p + 4)).with_precision(p);
  const ball zero(0, w.precision());
  const complex_ball above(w.re, hull(zero, real_set<ball>::upper_end(w.im)));
  const complex_ball below(w.re, hull(zero, -real_set<ball>::lower_end(w.im)));
  return hull(agm_above(above, p + 4), conj(agm_above(below, p + 4))).with_precision(p);
}

complex_ball agm(const complex_ball& z, const complex_ball& w) {
  const precision p = std::max(z.precision(), w.precision());
  if (z.is_undefined() || w.is_undefined()) return complex_ball::undefined(p);
  if (is_exactly_zero(z) || is_exactly_zero(w)) return {0, p};
  const complex_ball a = z.with_precision(p + 8);
  const complex_ball b = w.with_precision(p + 8);
  if (!contains_zero(a)) return (a * agm(b / a)).with_precision(p);
  // The limit for im(w / z) from above is that for im(z / w) from below.
  if (!contains_zero(b)) return (b * conj(agm(conj(a / b)))).with_precision(p);
  return square_of_half_side(max(a.magnitude_upper(), b.magnitude_upper()), p);
}

// ---------------------------------------------------------------------------------------------
// Sets and text.

bool contains(const complex_ball& z, const complex_ball& w) {
  return contains(z.re, w.re) && contains(z.im, w.im);
}
bool overlaps(const complex_ball& z, const complex_ball& w) {
  return overlaps(z.re, w.re) && overlaps(z.im, w.im);
}
complex_ball hull(const complex_ball& z, const complex_ball& w) {
  return {hull(z.re, w.re), hull(z.im, w.im)};
}
complex_ball intersection(const complex_ball& z, const complex_ball& w) {
  return {intersection(z.re, w.re), intersection(z.im, w.im)};
}

std::string to_decimal(const complex_ball& z, long most_digits) {
  if (z.is_undefined()) return "undefined";
  const auto part = [&](const ball& x) {
    std::string text = to_decimal(x, most_digits);
    return text.find("±") == std::string::npos ? text : '(' + text + ')';
  };
  const std::string re = part(z.re);
  const std::string im = part(z.im);
  if (im.front() == '-') return re + " - " + im.substr(1) + "*I";
  return re + " + " + im + "*I";
}

std::ostream& operator<<(std::ostream& out, const complex_ball& z) {
  return out << to_decimal(z, std::max<long>(out.precision(), 1));
}

}  // namespace polhode
