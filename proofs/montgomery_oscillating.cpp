// The Montgomery phase of oscillating motion: the paper's theorem 1. The proof is in half_phase.hpp.

#include "polhode/arithmetic/elementary.hpp"
#include "proofs/claims.hpp"
#include "proofs/half_phase.hpp"

namespace polhode::proofs {
namespace {

void add_oscillating_body(certificate& c, const request& wanted) {
  const body rigid = requested_body(c, wanted);
  add_number(
      c, "greatest_lower_bound",
      [&](precision p) { return 2 * pi(p) * rigid.geometric_constant(p); }, wanted.digits, rigid);
  c.facts.push_back(
      {"at the given a, b the phase by the AGM at u = 1/4, 1/2, 3/4 decreases, is above "
       "2 pi I and 4 I arsinh(pi/(2 sqrt(u))), and below 2 pi I g(u)/g(1)",
       half_phase_obeys_its_bounds(rigid), step_kind::enclosed});
  const bool below_one = exceeds_geometric_constant(1, rigid);
  c.facts.push_back({std::string("at the given a, b, in rationals: the body is ") +
                         to_text(rigid.kind()) + ", and the greatest lower bound is " +
                         (below_one ? "below 2 pi" : "2 pi or more"),
                     below_one == (rigid.kind() == body_kind::non_physical), step_kind::exact});
}

certificate prove_oscillating(const request& wanted) {
  certificate c;
  c.formula =
      "dphi(c) = 2 G(u), u = -c/b: decreasing in u, inf = lim (u -> 1) = 2 pi I; inf >= 2 pi <=> I "
      ">= 1";
  c.method =
      "For all a > 0, 0 < b < 1: G(u) = b^(-1/2) times the integral of g(x) over 0 < t < pi with x "
      "= u + (1-u) cos^2(t/2); g decreases strictly in x and x increases in u, so G decreases "
      "strictly in u (the phase increases in c); u <= x <= 1 gives pi I <= G(u) <= pi I g(u)/g(1), "
      "so that pi I is the limit for u -> 1 and the greatest lower bound, which is not attained. "
      "By the "
      "claim physical it is at least pi exactly for physical bodies. Computed: the polynomial "
      "steps; the rest is monotonicity of the integral.";
  add_steps(c, half_phase_steps());
  add_oscillating_body(c, wanted);
  c.conclude();
  return c;
}

}  // namespace

claim montgomery_oscillating_claim() {
  return {"theorem 1",
          "The Montgomery phase of oscillating motion increases in c, and its greatest lower bound "
          "is 2 pi I; this is at least 2 pi if and only if the body is physical.",
          "exact derivative and signs; two-sided bounds for the limit",
          prove_oscillating,
          proof_tier::by_kernel,
          {{step_kind::kernel, "Theorems.oscillating_phase_at"},
           {step_kind::kernel, "Theorems.oscillating_phase_increases"},
           {step_kind::kernel, "Theorems.theorem_1_infimum"},
           {step_kind::kernel, "Theorems.theorem_1_not_attained"},
           {step_kind::kernel, "Theorems.theorem_1_physical"},
           bartky_transformation()}};
}

}  // namespace polhode::proofs
