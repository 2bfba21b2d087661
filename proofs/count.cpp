// How often C and S meet: the paper's theorem 4, sharpened. The argument:
// proofs/arguments/count.md.

#include "statements/count.hpp"
#include "proofs/claims.hpp"
#include "proofs/turning_points.hpp"

namespace polhode::proofs {
namespace {

certificate prove_count(const request& wanted) {
  certificate c;
  add_steps(c, statements::count().steps);
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const integer count = count_intersections(rigid);
  c.witness["N"] = count.str();
  const auto q = [](const integer& k) { return rational(integer(2), integer(2 * k - 1)); };
  c.facts.push_back({statements::fill(statements::number_of_meetings, {counted(count)}),
                     (count == 0 || exceeds_geometric_constant(q(count), rigid)) &&
                         !exceeds_geometric_constant(q(count + 1), rigid),
                     step_kind::exact});
  if (count > 0) {
    add_brackets(
        c, rigid, count, [&](int k) { return q(k); }, "intersections");
  } else {
    add_absence(c, rigid, 2);
  }
  c.conclude();
  return c;
}

}  // namespace

claim count_claim() { return {statements::count(), prove_count}; }

}  // namespace polhode::proofs
