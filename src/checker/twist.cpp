#include "twist.hpp"

#include "elliptic.hpp"

namespace polhode::checker {
namespace {

int known_sign(const interval& x) {
  if (x.is_positive()) return 1;
  if (x.is_negative()) return -1;
  throw undecided("a sign is not known");
}

/// The sign of s - t, where s in [0, most] has F(c, cos^2 s) = value > 0 and F increases in s.
int side_of_amplitude(const body& rigid, const real& c, const interval& value, const interval& t) {
  const precision bits = t.bits();
  if (t.is_negative()) return 1;
  const interval half_pi = pi(bits) / 2;
  if (is_below(half_pi, t)) return -1;
  if (!t.is_positive() || !is_below(t, half_pi))
    throw undecided("an angle is not known well enough");
  const sine_and_cosine at = sin_cos(t);
  if (c == 0) {
    return known_sign(value -
                      separatrix_phase(rigid.a, rigid.b, square(at.cosine), square(at.sine)));
  }
  if (c < 0) {  // beyond the turning point, sin^2 t >= 1 + c/b
    const interval turning = (1 + c / rigid.b).at(bits);
    if (is_below(turning, square(at.sine))) return -1;
  }
  return known_sign(value - partial_phase(rigid.a, rigid.b, c, t));
}

}  // namespace

int side_of_defect(const body& rigid, const real& c, const rational& level, precision bits) {
  const interval whole = pi(bits);
  // psi against this: epsilon is above the level where psi is below.
  const interval psi = whole / 2 - interval(level, bits);
  if (c == 0) return -side_of_amplitude(rigid, c, whole.scaled(1), psi);
  const bool oscillates = c < 0;
  const interval half_turn = oscillates ? half_phase(rigid.a, rigid.b, -c / rigid.b, bits)
                                        : rotating_phase(rigid.a, rigid.b, c, bits);
  const interval turns = whole / half_turn + interval(rational(1, 2), bits);
  const integer n = floor_shift(turns.low(), bits);
  if (n != floor_shift(turns.high(), bits))
    throw undecided("the number of half turns is not known");
  const interval count(rational(n), bits);
  const interval rest = whole - half_turn * count;
  const interval from = oscillates ? psi : psi - whole * count;
  if (!rest.is_positive() && !rest.is_negative()) {
    // psi_c(pi) (- n pi) is between -s and s, s the amplitude of the greatest |rest|.
    const interval most = interval(rest.magnitude(), rest.magnitude(), bits).scaled(1);
    const bool up = from.is_positive();
    if (side_of_amplitude(rigid, c, most, up ? from : -from) >= 0) {
      throw undecided("a sign is not known");
    }
    return up ? 1 : -1;
  }
  const int sign = known_sign(rest) * (oscillates && n % 2 != 0 ? -1 : 1);
  const interval size = (rest.is_negative() ? -rest : rest).scaled(1);
  // psi_c(pi) = sign s (+ n pi): above psi where sign s > from.
  return -sign * side_of_amplitude(rigid, c, size, sign > 0 ? from : -from);
}

}  // namespace polhode::checker
