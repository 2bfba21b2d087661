// The first implicit equation: the paper's proposition 2. The argument: proofs/arguments/
// first_equation.md.

#include "statements/first_equation.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

void add_decrease_in_both(certificate& c, const body& rigid) {
  const exact_real& a = rigid.a();
  const exact_real least = -rigid.b() / 8;
  const rational half(1, 2);
  const exact_real half_a = a / 2;
  add_comparisons(c, statements::decrease_at_given_body, statements::order_of_values,
                  [&](precision p) {
                    const auto f = [&](const exact_real& at, const rational& u) {
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
