// The Montgomery phase of rotating motion: the paper's theorem 2. The proof is in rotating_phase.hpp.

#include "polhode/arithmetic/elementary.hpp"
#include "proofs/claims.hpp"
#include "proofs/rotating_phase.hpp"

namespace polhode::proofs {
namespace {

certificate prove_rotating(const request& wanted) {
  certificate c;
  c.formula = "dphi(c) = 2 F(c,0): decreasing in c, inf = lim (c -> a) = 2 pi J";
  c.method =
      "For all a > 0, 0 < b < 1: the integrand decreases strictly in c; (a+bX)/(c+bX) lies between "
      "1 and a/c, so that P < F(c,0) <= P sqrt(a/c) with P the integral at c = a, which is pi J by "
      "an antiderivative. So pi J is the limit for c -> a and the greatest lower bound, which is "
      "not attained for c < a. Computed: the polynomial steps; the rest is monotonicity of the "
      "integral.";
  add_steps(c, rotating_phase_steps());
  const body rigid = requested_body(c, wanted);
  add_number(
      c, "greatest_lower_bound",
      [&](precision p) { return 2 * pi(p) * rigid.second_geometric_constant(p); }, wanted.digits,
      rigid);
  c.facts.push_back(
      {"at the given a, b the phase by the AGM at c = a/4, a/2, 3a/4 decreases, is "
       "above 2 pi J and 4 I arsinh((pi/2) sqrt(b/c)), and below 2 pi J sqrt(a/c)",
       rotating_phase_obeys_its_bounds(rigid), step_kind::enclosed});
  c.conclude();
  return c;
}

}  // namespace

claim montgomery_rotating_claim() {
  return {"theorem 2, eq. (17)",
          "The Montgomery phase of rotating motion decreases in c, and its greatest lower bound is "
          "2 pi J.",
          "exact derivative and signs; two-sided bounds and an antiderivative for the limit",
          prove_rotating,
          proof_tier::by_kernel,
          {{step_kind::kernel, "Theorems.rotating_phase_at"},
           {step_kind::kernel, "Theorems.rotating_phase_decreases"},
           {step_kind::kernel, "Theorems.theorem_2_infimum"},
           {step_kind::kernel, "Theorems.theorem_2_not_attained"},
           bartky_transformation()}};
}

}  // namespace polhode::proofs
