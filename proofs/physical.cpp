// A body is physical exactly where I >= 1: the paper's proposition 1.
//
// With x = I_x > y = I_y > z = I_z > 0, a = (y - z)/z and b = (x - y)/x:
//   1 - b = y/x, and a + b = y (x - z)/(x z) by the first identity below, so that
//   I^2 = (1-b)^2/(b (a+b)) = y z/((x - y)(x - z)).
// Both sides of y z - (x - y)(x - z) = x (y + z - x) have one sign, and I > 0: I >= 1 exactly where y + z >= x, I = 1 exactly where
// y + z = x. The other two triangle inequalities hold by the order of the moments. Every a > 0, 0 < b < 1 comes from
// moments (y = 1, z = 1/(1+a), x = 1/(1-b)), so that this settles all bodies.

#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

int sign_of_rational(const rational& q) { return q > 0 ? 1 : q < 0 ? -1 : 0; }

void add_physical_body(certificate& c, const request& wanted) {
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const rational& a = rigid.a().exact();
  const rational& b = rigid.b().exact();
  const rational x(1 / (1 - b));
  const rational z(1 / (1 + a));
  const rational excess(1 + z - x);
  const rational square((1 - b) * (1 - b) / (b * (a + b)));
  c.facts.push_back({"at the given a, b, in rationals: I_y + I_z - I_x = " + to_text(excess) +
                         " for I_y = 1, and I^2 - 1 = " + to_text(rational(square - 1)) +
                         ", of the same sign: " + to_text(rigid.kind()),
                     sign_of_rational(excess) == sign_of_rational(square - 1) &&
                         (rigid.kind() == body_kind::planar) == (excess == 0) &&
                         (rigid.kind() == body_kind::physical) == (excess > 0),
                     step_kind::exact});
}

certificate prove_physical(const request& wanted) {
  certificate c;
  c.formula = "I_y + I_z >= I_x  <=>  I = (1-b)/sqrt(b(a+b)) >= 1  <=>  ab + 2b <= 1";
  c.method =
      "For all bodies: with x = I_x, y = I_y, z = I_z the square of I is yz/((x-y)(x-z)), and "
      "yz - (x-y)(x-z) = x(y+z-x); every a > 0, 0 < b < 1 is that of some moments. All steps are "
      "identities of polynomials, decided by expansion. For the given body: signs of rational "
      "numbers.";
  add_steps(c,
            {identity("(y-z)*x + (x-y)*z", "y*(x-z)",
                      "a + b = y(x-z)/(xz) with a = (y-z)/z, b = (x-y)/x, so that I^2 = "
                      "yz/((x-y)(x-z))"),
             identity("y*z - (x-y)*(x-z)", "x*(y+z-x)", "I^2 - 1 has the sign of I_y + I_z - I_x"),
             identity("(1-b)^2 - b*(a+b)", "1 - 2*b - a*b", "and that of 1 - 2b - ab"),
             positive("x+z-y", "z + p", "z > 0, p = x-y > 0", "I_x + I_z > I_y always"),
             positive("x+y-z", "x + p", "x > 0, p = y-z > 0", "I_x + I_y > I_z always")});
  add_physical_body(c, wanted);
  c.conclude();
  return c;
}

}  // namespace

claim physical_claim() {
  return {
      "proposition 1",
      "A rigid body with moments of inertia I_z < I_y < I_x is physical, I_y + I_z >= I_x, if and "
      "only if its geometric constant is I >= 1; it is planar if and only if I = 1.",
      "identities of polynomials over all moments; signs of rationals for a body",
      prove_physical,
      proof_tier::with_words,
      {{step_kind::kernel, "Prop1.proposition_1"},
       {step_kind::argued,
        "With I_z < I_y < I_x all denominators are positive, and I > 0: I >= 1 exactly where I^2 - "
        "1 >= 0, where I_y + I_z - I_x >= 0."}}};
}

}  // namespace polhode::proofs
