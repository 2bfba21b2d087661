// Square roots of complex balls.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/exponent_range.hpp"
#include "arithmetic/complex/narrow.hpp"
#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode {

using namespace detail::complex_balls;
using detail::exponent_range;
using detail::mpfr_cell;

namespace {

/// The square root about that of the moderate midpoint m = x + iy; nothing where the set is not far
/// from 0 for its radii, or may meet the cut, or an intermediate number left MPFR's range.
///
/// With r = |m|, w = sqrt((r + |x|)/2) and |y|/(2w) are the parts' sizes, in this order for x >= 0.
/// r^2, r, the sum, w and the quotient are rounded once each, to p + 10 bits: relative errors, in
/// units of 2^-(p+10), below 1, 1.6, 2.7, 2.4 and 3.5. So both parts have one below 2^-(p+8).
///
/// For a member z = m + s + it of the set, |z| >= L: f(z) = sqrt z is off from f(m) by at most (|s|
/// + |t|)/(2 sqrt L) =: e, as |f'| = 1/(2 sqrt|z|). f' = conj(f)/(2|z|), so that the real part of f
/// changes by at most ((|Re f(m)| + e)|s| + (|Im f(m)| + e)|t|)/(2L), and the imaginary one by the
/// same with |s| and |t| exchanged.
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

complex_ball sqrt(const complex_ball& z) {
  if (is_narrow_and_moderate(z)) {
    if (std::optional<complex_ball> r = narrow_sqrt(z)) return *std::move(r);
  }
  return sqrt(static_cast<const rectangle<ball>&>(z));
}

}  // namespace polhode
