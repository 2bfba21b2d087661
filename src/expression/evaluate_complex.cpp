// Complex balls and regions: the real functions continued off the real line, written once over
// both.
//
// A region may be one of several that cover a domain, so each function here is one function of the
// complex points, the same whichever set they come in: where it is a choice between two formulas,
// the real part of a point decides, and a set on which that is not the same has no answer.

#include <optional>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/elliptic/complex.hpp"
#include "polhode/expression/evaluation.hpp"

namespace polhode::detail {
namespace {

ball pi_for(const complex_ball& z) { return pi(z.precision()); }
ball pi_for(const region& z) { return pi(std::max<precision>(z.precision(), 64)); }

template <class Z>
Z sine_of_half_turns(const Z& z) {
  return sin(z * pi_for(z));
}
template <class Z>
Z cosine_of_half_turns(const Z& z) {
  return cos(z * pi_for(z));
}

/// On real numbers x > 0, or x < 0, or y not 0: the angle of (x, y) is twice that of (x + r, y),
/// which lies within a right angle. As a function of complex numbers it is this formula, with the
/// cuts of sqrt and atan.
template <class Z>
Z angle_of(const Z& y, const Z& x) {
  return atan(y / (sqrt(square(x) + square(y)) + x)) * 2;
}

/// z^(1/n) with log's cut.
template <class Z>
Z principal_root(const Z& z, long n) {
  return exp(log(z) / n);
}

// ---------------------------------------------------------------------------------------------

bool is_real(const complex_ball& z) { return sign_of(z.im) == certain_sign::zero; }
complex_ball real(const ball& x) { return complex_ball(x); }
complex_ball undefined_like(const complex_ball& z) {
  return complex_ball::undefined(z.precision());
}

}  // namespace

using complexes = supplement<complex_ball>;
using regions = supplement<region>;

complex_ball complexes::expm1(const complex_ball& z) {
  return is_real(z) ? real(polhode::expm1(z.re)) : exp(z) - 1;
}
complex_ball complexes::log1p(const complex_ball& z) {
  return is_real(z) && certainly_positive(z.re + 1) ? real(polhode::log1p(z.re)) : log(z + 1);
}
complex_ball complexes::sinpi(const complex_ball& z) {
  return is_real(z) ? real(polhode::sinpi(z.re)) : sine_of_half_turns(z);
}
complex_ball complexes::cospi(const complex_ball& z) {
  return is_real(z) ? real(polhode::cospi(z.re)) : cosine_of_half_turns(z);
}
complex_ball complexes::abs(const complex_ball& z) {
  if (is_real(z)) return real(polhode::abs(z.re));
  if (certainly_positive(z.re)) return z;
  return certainly_negative(z.re) ? -z : undefined_like(z);
}
complex_ball complexes::floor(const complex_ball& z) {
  return z.is_undefined() ? z : real(polhode::floor(z.re));
}
complex_ball complexes::ceil(const complex_ball& z) {
  return z.is_undefined() ? z : real(polhode::ceil(z.re));
}
complex_ball complexes::min(const complex_ball& z, const complex_ball& w) {
  if (is_real(z) && is_real(w)) return real(polhode::min(z.re, w.re));
  if (certainly_less(z.re, w.re)) return z;
  return certainly_less(w.re, z.re) ? w : undefined_like(z);
}
complex_ball complexes::max(const complex_ball& z, const complex_ball& w) {
  if (is_real(z) && is_real(w)) return real(polhode::max(z.re, w.re));
  if (certainly_less(z.re, w.re)) return w;
  return certainly_less(w.re, z.re) ? z : undefined_like(z);
}
complex_ball complexes::hypot(const complex_ball& z, const complex_ball& w) {
  if (is_real(z) && is_real(w)) return real(polhode::hypot(z.re, w.re));
  return sqrt(square(z) + square(w));
}
complex_ball complexes::agm(const complex_ball& z, const complex_ball& w) {
  if (is_real(z) && is_real(w)) return real(polhode::agm(z.re, w.re));
  return polhode::agm(z, w);
}
complex_ball complexes::atan2(const complex_ball& y, const complex_ball& x) {
  return is_real(x) && is_real(y) ? real(polhode::atan2(y.re, x.re)) : angle_of(y, x);
}
complex_ball complexes::root(const complex_ball& z, long n) {
  if (is_real(z) && (n % 2 != 0 || !certainly_negative(z.re))) {
    const ball x = polhode::root(z.re, static_cast<unsigned long>(n));
    if (!x.is_undefined()) return real(x);
  }
  if (n % 2 == 0 || certainly_positive(z.re)) return principal_root(z, n);
  return certainly_negative(z.re) ? -principal_root(-z, n) : undefined_like(z);
}

// ---------------------------------------------------------------------------------------------

namespace {

/// The sign of the real part of every member: 1, -1, or 0 where it is not the same or not proved.
int sign_of_real_part(const region& z) {
  const ball x = z.to_complex_ball().re;
  if (certainly_positive(x)) return 1;
  return certainly_negative(x) ? -1 : 0;
}

}  // namespace

region regions::expm1(const region& z) { return exp(z) - 1; }
region regions::log1p(const region& z) { return log(z + 1); }
region regions::sinpi(const region& z) { return sine_of_half_turns(z); }
region regions::cospi(const region& z) { return cosine_of_half_turns(z); }
region regions::hypot(const region& z, const region& w) { return sqrt(square(z) + square(w)); }
/// By agm(z, w) = agm((z + w)/2, sqrt(z w)). Both sides are analytic where Re z > 0 and Re w > 0:
/// the square of (z + w)/2 and z w are off the cut (-oo, 0] of R_F; and they agree for z, w > 0.
region regions::agm(const region& z, const region& w) {
  if (!z.is_analytic()) return z;
  if (!w.is_analytic()) return w;
  const int least = std::min(sign_of_real_part(z), sign_of_real_part(w));
  if (least <= 0)
    return region::blocked(least < 0 ? obstacle::unknown : obstacle::branch_cut, "agm");
  const region integral = carlson_rf(region(double_interval(0)), square((z + w) / 2), z * w);
  if (!integral.is_analytic()) return region::blocked(integral.why(), "agm");
  return region(pi_for(z)) / (integral * 2);
}
region regions::atan2(const region& y, const region& x) { return angle_of(y, x); }
region regions::root(const region& z, long n) {
  if (n % 2 == 0 || !z.is_analytic()) return principal_root(z, n);
  switch (sign_of_real_part(z)) {
    case 1:
      return principal_root(z, n);
    case -1:
      return -principal_root(-z, n);
    default:
      return region::blocked(obstacle::branch_cut, "root");
  }
}
/// With z + s for t in erfc(z) = (2/sqrt(pi)) times the integral of e^(-t^2) from z to infinity
/// (DLMF 7.2.2, along a line parallel to the real axis), where Re z >= r > 0:
///
///   |erfc(z)| <= (2/sqrt(pi)) |e^(-z^2)| times the integral of e^(-2 r s - s^2) over s > 0
///             <= |e^(-z^2)| min(1, 1/(sqrt(pi) r)),
///
/// of which the integral is at most sqrt(pi)/2, and at most 1/(2 r). erf(z) = 1 - erfc(z) is odd.
/// Nothing where the set is so small that the mean of the derivative over it says more.
std::optional<complex_ball> erf_far_from_imaginary_axis(const complex_ball& set) {
  const precision p = set.precision();
  const bool is_right = certainly_positive(set.re);
  if (!is_right && !certainly_negative(set.re)) return std::nullopt;
  const ball r(lower(abs(set.re)));
  const ball share = min(ball(1, p), 1 / (sqrt(pi(p)) * r));
  const magnitude width = (set - set.middle()).magnitude_upper();
  if (width < share.magnitude_upper()) return std::nullopt;
  const ball size = exp(square(set.im) - square(set.re)) * share;
  if (!size.is_bounded()) return std::nullopt;
  return complex_ball(ball(is_right ? 1 : -1, p)).enlarged(size.magnitude_upper());
}

region regions::erf(const region& z) {
  if (!z.is_analytic()) return z;
  const complex_ball set = z.to_complex_ball();
  if (!set.is_bounded()) return region::blocked(obstacle::undefined, "erf");
  const auto as_z_is = [&](const complex_ball& w) {
    return z.is_in_hardware() ? region(w) : region::in_balls(w);
  };
  if (const auto far = erf_far_from_imaginary_axis(set)) return as_z_is(*far);
  // m is real where the set touches the real axis, or is so large that erf(m) is not known.
  complex_ball m = set.middle();
  complex_ball value(ball(0, 64));
  if (!contains_zero(set.im)) value = polhode::erf(m);
  if (contains_zero(set.im) || value.is_undefined()) {
    m = complex_ball(m.re);
    value = polhode::erf(m);
  }
  const region between = as_z_is(hull(set, m));
  const region slope =
      (exp(-square(between)) * 2 / as_z_is(complex_ball(polhode::sqrt(pi(m.precision())))))
          .convex_hull();
  return as_z_is(value) + as_z_is(set - m) * slope;
}
region regions::erfc(const region& z) { return 1 - erf(z); }

}  // namespace polhode::detail

namespace polhode {

template class compiled_expression<complex_ball>;
template class compiled_expression<region>;

}  // namespace polhode
