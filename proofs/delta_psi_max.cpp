// delta_psi_max = pi - 2 epsilon0_min.

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
  c.formula = "delta_psi_max = pi - 2 epsilon0_min = 4 arctan(e^pi) - pi";
  c.method =
      "The formula in ball arithmetic; the second route takes epsilon0_min from interval Newton on "
      "log(tan(x/2)) + pi.";
  c.numbers.push_back({"delta_psi_max", x, wanted.digits});
  c.facts.push_back(
      {"pi - 2 epsilon0_min with epsilon0_min from log and tan overlaps the formula in "
       "exp and arctan",
       epsilon.verdict == root_verdict::unique && overlaps(second, x), step_kind::enclosed});
  c.witness["second_route"] = to_json(second, wanted.digits);
  c.conclude();
  return c;
}

}  // namespace

claim delta_psi_max_claim() {
  return {"section 7, after eq. (40)",
          "delta_psi_max = pi - 2 epsilon0_min. What it says of bodies, that it is the least upper "
          "bound of the twist on the separatrix over all physical ones, follows by the claim "
          "limit_minimum. The paper prints 2.96884.",
          "ball arithmetic; interval Newton on log tan as a second route",
          prove_delta_psi_max,
          proof_tier::by_machine,
          {gudermannian()}};
}

}  // namespace polhode::proofs
