// Where C first meets S: the paper's lemma 2. The argument: proofs/arguments/intersection.md.

#include "statements/intersection.hpp"
#include "proofs/claims.hpp"
#include "proofs/turning_points.hpp"

namespace polhode::proofs {
namespace {

certificate prove_intersection(const request& wanted) {
  certificate c;
  add_steps(c, statements::intersection().steps);
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const bool meets = exceeds_geometric_constant(2, rigid);
  c.facts.push_back(
      {statements::fill(statements::meets_or_not,
                        {(meets ? "<" : ">="), (meets ? "positive" : "not positive")}),
       meets == (4 * rigid.a().exact() * rigid.b().exact() +
                     3 * rigid.b().exact() * rigid.b().exact() + 2 * rigid.b().exact() >
                 1),
       step_kind::exact});
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
