#include "proofs/twist.hpp"

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "proofs/body_facts.hpp"

namespace polhode::proofs {
namespace {

/// The whole number that all members' floors are; nothing where they differ.
std::optional<integer> common_floor(const ball& x) {
  const ball below = floor(x);
  if (!below.is_exact()) return std::nullopt;
  return numerator(lower_rational(below));
}

/// An enclosure of arcsin(sqrt(w)) for the w in [0, most] with F(c, 1 - w) = value, where F
/// increases in w from 0. Hypotheses: 0 < most <= 1, and value holds a number from 0 to the
/// supremum of F on [0, most). w/most is enclosed, by rational numbers.
ball amplitude(const body& rigid, const exact_real& c, const ball& value, const exact_real& most,
               precision p) {
  constexpr unsigned most_halvings = 8192;
  constexpr unsigned wanted_bits = 40;
  rational lower = 0;
  rational upper = 1;
  // Whether part is an end now: F(c, 1 - w) at w = part most is on one side of value.
  const auto becomes_end = [&](const rational& part) {
    const ball at_w = phase_integral(rigid, c, 1 - part * most, p);
    if (certainly_less_equal(at_w, value)) {
      lower = part;
    } else if (certainly_less_equal(value, at_w)) {
      upper = part;
    } else {
      return false;
    }
    return true;
  };
  for (unsigned k = 1; k <= most_halvings && lower == 0; k *= 2) {
    if (!becomes_end(rational(integer(1), integer(1) << k))) break;
  }
  const rational tolerance(integer(1), integer(1) << wanted_bits);
  while (lower > 0 && upper - lower > tolerance * lower) {
    if (!becomes_end(upper < 1 ? between(lower, upper) : rational((lower + upper) / 2))) break;
  }
  return asin(sqrt(most * hull(ball(lower, p), ball(upper, p))));
}

}  // namespace

ball twist_defect(const body& rigid, const exact_real& c, precision p) {
  const regime r = regime_of(rigid, c);
  const bool oscillating = r == regime::oscillating;
  const exact_real most_w = oscillating ? 1 + c / rigid.b() : exact_real(1);
  integer n = 0;
  ball rest = pi(p);
  if (r != regime::separatrix) {
    const ball half_turn =
        oscillating ? scale(montgomery_phase(rigid, c, p), -1) : phase_integral(rigid, c, 0, p);
    const auto whole = common_floor(pi(p) / half_turn + rational(1, 2));
    if (!whole) return ball::undefined(p);
    n = *whole;
    rest -= half_turn * n;
  }
  ball psi = amplitude(rigid, c, 2 * abs(rest), most_w, p);
  switch (sign_of(rest)) {
    case certain_sign::positive:
      break;
    case certain_sign::negative:
      psi = -psi;
      break;
    case certain_sign::zero:
    case certain_sign::unknown:
      psi = hull(-psi, psi);
      break;
  }
  if (oscillating) {
    if (n % 2 != 0) psi = -psi;
  } else {
    psi += pi(p) * n;
  }
  return scale(pi(p), -1) - psi;
}

}  // namespace polhode::proofs
