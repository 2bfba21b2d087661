// delta_psi_max = pi - 2 epsilon0_min.

#include "statements/delta_psi_max.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "proofs/claims.hpp"
#include "proofs/epsilon0_min.hpp"

namespace polhode::proofs {
namespace {

certificate prove_delta_psi_max(const request& wanted) {
  certificate c;
  const ball x = enclose_to_digits(*find_constant("delta_psi_max"), wanted.digits);
  const root_enclosure epsilon = epsilon0_min_by_logarithm(x.precision());
  const ball second = pi(x.precision()) - 2 * epsilon.root;
  c.numbers.push_back({"delta_psi_max", x, wanted.digits});
  c.facts.push_back({statements::second_route_overlaps,
                     epsilon.verdict == root_verdict::unique && overlaps(second, x),
                     step_kind::enclosed});
  c.witness["second_route"] = to_json(second, wanted.digits);
  c.conclude();
  return c;
}

}  // namespace

claim delta_psi_max_claim() { return {statements::delta_psi_max(), prove_delta_psi_max}; }

}  // namespace polhode::proofs
