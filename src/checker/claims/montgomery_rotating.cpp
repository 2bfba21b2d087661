// The Montgomery phase of rotating motion.

#include "statements/montgomery_rotating.hpp"
#include "answers.hpp"
#include "checker/elliptic.hpp"
#include "checker/functions.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

/// At c = a/4, a/2, 3a/4 F(c,0) decreases and keeps within its bounds.
tri rotating_phase_obeys_its_bounds(const body& rigid, precision bits) {
  const interval limit = pi(bits) * rigid.J(bits);
  return phase_obeys_its_bounds(limit, [&](int quarter) -> bounded_phase {
    const real c = rigid.a * rational(quarter, 4);
    return {rotating_phase(rigid.a, rigid.b, c, bits),
            (rigid.I(bits) * asinh(pi(bits) * sqrt(exactly(rigid.b / (4 * c), bits)))).scaled(1),
            limit * sqrt(exactly(rational(4, quarter), bits))};
  });
}

void check_montgomery_rotating(examination& e) {
  const body rigid = check_body_and_steps(e);
  e.number("greatest_lower_bound",
           [&](precision bits) { return (pi(bits) * rigid.J(bits)).scaled(1); });
  e.fact(statements::rotating_phase_keeps_its_bounds,
         [&](precision bits) { return rotating_phase_obeys_its_bounds(rigid, bits); });
}

}  // namespace

claim montgomery_rotating_claim() {
  return {statements::montgomery_rotating(), check_montgomery_rotating};
}

}  // namespace polhode::checker
