// The first implicit equation: the paper's proposition 2, eqs. (21) to (24).
//
// T(c, psi) = integral from 0 to psi of h, h = (1 - b X)/sqrt((a + b X)(c + b X)), X = cos^2, is
// the angle phi in which the solution with psi = 0 at phi = 0 reaches psi; the first equation is
// T(c, pi/2 - epsilon) = pi. h > 0, so T increases strictly in psi; h decreases strictly in c, so T
// does (for psi > 0). Let c < c' both have solutions psi, psi' > 0: T(c', psi) < T(c, psi) = pi =
// T(c', psi'), so psi < psi', and epsilon > epsilon': it decreases strictly. (The paper's "<= 0
// with a discrete set of zeros" is < 0 throughout, but where the integral is empty, at epsilon =
// pi/2. With x = cos^2, T(c, psi) = F(c, u)/2, u = cos^2 psi.)

#include "statements/first_equation.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

void add_decrease_in_both(certificate& c, const body& rigid) {
  const rational& a = rigid.a().exact();
  const rational least(-rigid.b().exact() / 8);
  const rational half(1, 2);
  const rational half_a(a / 2);
  add_comparisons(c, statements::decrease_at_given_body, statements::order_of_values,
                  [&](precision p) {
                    const auto f = [&](const rational& at, const rational& u) {
                      return phase_integral(rigid, at, u, p);
                    };
                    const ball middle = f(half_a, half);
                    const ball at_zero = f(0, half);
                    return std::vector<comparison>{{middle, at_zero},
                                                   {at_zero, f(least, half)},
                                                   {f(a, half), middle},
                                                   {middle, f(half_a, rational(1, 4))},
                                                   {f(half_a, rational(3, 4)), middle}};
                  });
}

certificate prove_decrease(const request& wanted) {
  certificate c;
  add_steps(c, statements::first_equation().steps);
  const body rigid = requested_body(c, wanted);
  add_decrease_in_both(c, rigid);
  c.conclude();
  return c;
}

}  // namespace

claim first_equation_claim() { return {statements::first_equation(), prove_decrease}; }

}  // namespace polhode::proofs
