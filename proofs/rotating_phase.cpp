#include "proofs/rotating_phase.hpp"

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"

namespace polhode::proofs {

bool rotating_phase_obeys_its_bounds(const body& rigid) {
  return is_decided([&](precision p) {
    const ball limit = 2 * pi(p) * rigid.second_geometric_constant(p);
    ball before = ball::undefined(p);
    for (const int quarter : {1, 2, 3}) {
      const exact_real c = rigid.a() * quarter / 4;
      const ball value = montgomery_phase(rigid, c, p);
      const ball least =
          4 * rigid.geometric_constant(p) * asinh(pi(p) * sqrt((rigid.b() / (4 * c)).at(p)));
      const ball most = limit * sqrt(ball(rational(4, quarter), p));
      if (!certainly_less(limit, value) || !certainly_less(least, value) ||
          !certainly_less(value, most) || (quarter > 1 && !certainly_less(value, before))) {
        return false;
      }
      before = value;
    }
    return true;
  });
}

bool exceeds_second_geometric_constant(const rational& q, const body& rigid) {
  return q > -1 && rational((q + 1) * (q + 1)) > rigid.square_of_second_constant();
}

std::optional<root_bracket> bracket_rotating_phase_root(const body& rigid, const rational& q,
                                                        int bits) {
  if (!exceeds_second_geometric_constant(q, rigid)) return std::nullopt;
  return bracket_root(
      [&](const rational& s, precision p) {
        return scale(montgomery_phase(rigid, rigid.a() * s, p), -1);
      },
      [&](precision p) { return pi(p) * q; }, bits);
}

bool passes_rotating_phase(const body& rigid, const rational& q, const root_bracket& bracket) {
  const auto at = [&](const rational& s, precision p) {
    return montgomery_phase(rigid, rigid.a() * s, p);
  };
  return is_decided([&](precision p) {
    const ball value = 2 * q * pi(p);
    return certainly_less(at(bracket.upper, p), value) &&
           certainly_less(value, at(bracket.lower, p));
  });
}

}  // namespace polhode::proofs
