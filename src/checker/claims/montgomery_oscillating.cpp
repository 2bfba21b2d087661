// The Montgomery phase of oscillating motion.

#include "checker/facts.hpp"
#include "checker/functions.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_montgomery_oscillating(examination& e) {
  const body rigid = check_body_and_steps(e);
  e.number("greatest_lower_bound",
           [&](precision bits) { return (pi(bits) * rigid.I(bits)).scaled(1); });
  e.fact(
      "at the given a, b the phase by the AGM at u = 1/4, 1/2, 3/4 decreases, is above 2 pi I and "
      "4 I arsinh(pi/(2 sqrt(u))), and below 2 pi I g(u)/g(1)",
      [&](precision bits) { return half_phase_obeys_its_bounds(rigid, bits); });
  const bool below_one = rigid.is_above_I(1);
  e.fact("at the given a, b, in rationals: the body is " + rigid.kind_in_words() +
             ", and the greatest lower bound is " + (below_one ? "below 2 pi" : "2 pi or more"),
         below_one == (rigid.kind() < 0));
}

}  // namespace

claim montgomery_oscillating_claim() {
  return {
      .name = "montgomery_oscillating",
      .reference = "theorem 1",
      .statement =
          "The Montgomery phase of oscillating motion increases in c, and its greatest lower bound "
          "is 2 pi I; this is at least 2 pi if and only if the body is physical.",
      .formula =
          "dphi(c) = 2 G(u), u = -c/b: decreasing in u, inf = lim (u -> 1) = 2 pi I; inf >= 2 pi "
          "<=> I >= 1",
      .method =
          "For all a > 0, 0 < b < 1: G(u) = b^(-1/2) times the integral of g(x) over 0 < t < pi "
          "with x = u + (1-u) cos^2(t/2); g decreases strictly in x and x increases in u, so G "
          "decreases strictly in u (the phase increases in c); u <= x <= 1 gives pi I <= G(u) <= "
          "pi I g(u)/g(1), so that pi I is the limit for u -> 1 and the greatest lower bound, "
          "which is not attained. By the claim physical it is at least pi exactly for physical "
          "bodies. Computed: the polynomial steps; the rest is monotonicity of the integral.",
      .steps = facts::with_more(facts::half_phase_steps),
      .tier = by_kernel,
      .argument = {in_coq("Theorems.oscillating_phase_at"),
                   in_coq("Theorems.oscillating_phase_increases"),
                   in_coq("Theorems.theorem_1_infimum"), in_coq("Theorems.theorem_1_not_attained"),
                   in_coq("Theorems.theorem_1_physical"), facts::bartky_transformation},
      .check = check_montgomery_oscillating};
}

}  // namespace polhode::checker
