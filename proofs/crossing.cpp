// Where epsilon(c) = pi/2: the paper's lemma 3. The argument: proofs/arguments/crossing.md.

#include "statements/crossing.hpp"
#include "proofs/claims.hpp"
#include "proofs/turning_points.hpp"

namespace polhode::proofs {
namespace {

certificate prove_crossing(const request& wanted) {
  certificate c;
  add_steps(c, statements::crossing().steps);
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const integer count = count_crossings(rigid);
  c.witness["crossings_count"] = count.str();
  c.facts.push_back(
      {statements::fill(statements::number_of_crossings, {counted(count), to_text(rigid.kind())}),
       (count == 0 || exceeds_geometric_constant(rational(integer(1), count), rigid)) &&
           !exceeds_geometric_constant(rational(integer(1), integer(count + 1)), rigid) &&
           (count > 0) == (rigid.kind() == body_kind::non_physical),
       step_kind::exact});
  if (count > 0) {
    add_brackets(
        c, rigid, count, [](int k) { return rational(1, k); }, "crossings");
  } else {
    add_absence(c, rigid, 1);
  }
  c.conclude();
  return c;
}

}  // namespace

claim crossing_claim() { return {statements::crossing(), prove_crossing}; }

}  // namespace polhode::proofs
