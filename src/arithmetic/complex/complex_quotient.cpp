// Quotients of complex balls: to first order around the midpoints, and of others scaled to a
// moderate size first.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/exponent_range.hpp"
#include "arithmetic/complex/narrow.hpp"
#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode {

using namespace detail::complex_balls;
using detail::exponent_range;
using detail::mpfr_cell;

namespace {

range_of_size product(const range_of_size& x, const range_of_size& y) {
  return {multiply_down(x.least, y.least), multiply_up(x.most, y.most)};
}
/// The greatest |x + y| for two such sets of one sign, or of two; a set about 0 may have either.
magnitude size_of_sum(const range_of_size& x, const range_of_size& y, bool same_sign) {
  return same_sign || x.least.is_zero() || y.least.is_zero()
             ? add_up(x.most, y.most)
             : max(subtract_up(x.most, y.least), subtract_up(y.most, x.least));
}

}  // namespace

std::optional<complex_ball> detail::complex_balls::centred_quotient(const centred& a,
                                                                    const centred& b, precision p) {
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

namespace {

/// z / w by interval evaluation, with both brought near 1 in size by powers of two, and of w's
/// parts one at least: nothing leaves the range that is not negligible beside 1, and balls enclose
/// what does. Undefined where |w|^2 may be 0.
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

}  // namespace polhode
