// Where C first meets S: the paper's lemma 2. The argument: proofs/arguments/intersection.md.

#include "statements/intersection.hpp"
#include "proofs/claims.hpp"
#include "proofs/turning_points.hpp"

namespace polhode::proofs {
namespace {

/// Whether 4ab + 3b^2 + 2b - 1 > 0. Where I^2 is rational without a and b, it is not asked of
/// these: it is b (a + b)(4 - I^2).
bool has_positive_excess(const body& rigid) {
  const exact_real& a = rigid.a();
  const exact_real& b = rigid.b();
  const exact_real square = rigid.square_of_geometric_constant();
  if (square.is_rational()) return square < 4;
  return 4 * a * b + 3 * b * b + 2 * b > 1;
}

certificate prove_intersection(const request& wanted) {
  certificate c;
  add_steps(c, statements::intersection().steps);
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const bool meets = exceeds_geometric_constant(2, rigid);
  c.facts.push_back(
      {statements::fill(statements::meets_or_not,
                        {(meets ? "<" : ">="), (meets ? "positive" : "not positive")}),
       meets == has_positive_excess(rigid), step_kind::exact});
  if (meets) {
    add_brackets(
        c, rigid, 1, [](int) { return rational(2); }, "intersection");
  } else {
    add_absence(c, rigid, 2);
  }
  c.conclude();
  return c;
}

}  // namespace

claim intersection_claim() { return {statements::intersection(), prove_intersection}; }

}  // namespace polhode::proofs
