// What the functions of rectangles (polhode/arithmetic/rectangle.hpp) ask of balls as their parts.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/exponent_range.hpp"
#include "arithmetic/complex/narrow.hpp"
#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode {

using namespace detail::complex_balls;
using detail::exponent_range;
using detail::mpfr_cell;

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

// The ends of a narrow ball are computed to so many bits more: see guard_bits in
// functions/elementary/carrying.hpp.
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
  // mpfr_sinh_cosh works with as many bits as a tiny x has zeros behind the point; mpfr_sinh and
  // mpfr_cosh do not.
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

}  // namespace polhode
