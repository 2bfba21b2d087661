// The greatest lower bounds over all physical bodies.

#include "brackets.hpp"
#include "checker/elliptic.hpp"
#include "checker/facts.hpp"
#include "checker/functions.hpp"
#include "constants.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_limit_minimum(examination& e) {
  const body rigid = check_body_and_steps(e);
  e.number("epsilon0_min", epsilon0_min);
  const range beta = e.root_number("beta", false, mean_equation);
  e.fact(
      "agm(1, sin epsilon0_min) < 1/2 with sin epsilon0_min = 1/cosh(pi), so that K(cos^2 "
      "epsilon0_min) > pi: for beta < 0, chi <= 1 the limit's motion has either -beta > sin^2 "
      "epsilon0_min, and epsilon >= epsilon* > epsilon0_min, or is still before its first turning "
      "point",
      [&](precision bits) {
        const interval one = exactly(1, bits);
        const interval cosine = (exp(pi(bits)) + exp(-pi(bits))) / 2;
        return below(agm_with_sum(one, one / cosine).mean, exactly(rational(1, 2), bits));
      });
  if (rigid.kind() < 0) {
    e.add_to_method(" (The given body is not physical: the bounds are not for it.)");
    return;
  }
  if (!e.is_missing("the order of epsilon0 and epsilon0_min")) {
    // epsilon0 is above epsilon0_min where F(0, sin^2) - 2 pi is still positive.
    e.fact("at the given a, b, " + rigid.kind_in_words() +
               ": epsilon0, by interval Newton, is above epsilon0_min",
           [&](precision bits) {
             const sine_and_cosine at = sin_cos(epsilon0_min(bits));
             return below(pi(bits).scaled(1),
                          separatrix_phase(rigid.a, rigid.b, square(at.sine), square(at.cosine)));
           });
  }
  if (!rigid.is_above_J(2)) {
    e.add_to_method(facts::there_is_no_c0);
    return;
  }
  if (e.is_missing(facts::bracket_of_c0) ||
      e.is_missing("a bracket of c0 that lies on one side of b beta")) {
    return;
  }
  const range c0 = examination::bracket(e.witness("c0_over_a"));
  e.fact("at the given a, b: c0/b is above beta (c0/a between " + in_decimals(c0, e.work()) + ")",
         [&](precision bits) {
           return all_of({tri(beta.upper < rigid.a * c0.lower / rigid.b),
                          passes_rotating_phase(rigid, 2, c0, bits + size_of(c0))});
         });
}

}  // namespace

claim limit_minimum_claim() {
  return {
      .name = "limit_minimum",
      .reference = "section 7, eqs. (39), (40)",
      .statement =
          "Over all physical bodies the greatest lower bound of epsilon0 is epsilon0_min; over all "
          "physical bodies that have a c0 (J < 2) that of c0/b is beta; neither is attained. For "
          "beta < 0, chi <= 1 the limit's epsilon is above epsilon0_min, and tends to it as chi -> "
          "1, beta -> 0.",
      .formula =
          "ab + 2b <= 1  =>  epsilon0 > epsilon0_min = 2 arctan(e^-pi) and, where J < 2, c0/b > "
          "beta; both are greatest lower bounds",
      .method =
          "For all physical bodies: (1-bX)^2 > b(a+bX) for 0 <= X < 1, so that the integrand of "
          "the implicit equation exceeds (beta + cos^2 psi)^(-1/2), that of the limit for chi = 1, "
          "at every c = b beta; so epsilon0 and, where there is a c0, c0/b exceed their limits. "
          "Planar bodies a = 1/b - 2 approach them for b -> 0 by the limit formula. Computed: the "
          "polynomial step and both numbers.",
      .steps = {positive(
                    "(1-b*x)^2 - b*(a+b*x)", "p + b*y*(1+q+b*y)",
                    "b > 0, p = 1-a*b-2*b >= 0, q = 1-b > 0, y = 1-x > 0",
                    "p >= 0 for physical bodies: the integrand exceeds the limit's where X < 1"),
                identity("(1-2*b) + 2*b", "1", "a = 1/b - 2 is planar: ab + 2b = 1")},
      .tier = by_argument,
      .argument = {in_coq("Infima.epsilon0_infimum"), in_coq("Infima.beta_infimum"),
                   argued("The integrand exceeds the limit's at every psi > 0, so that the "
                          "integral does, and epsilon0 and c0/b exceed their limits."),
                   argued("Planar bodies approach both limits, by the claim limit_formula."),
                   argued("Before the first turning point the limit's integral is greater for beta "
                          "< 0 than for beta = 0 at every psi, and its value pi sqrt(chi) is at "
                          "most pi: psi is below that of beta = 0, chi = 1."),
                   facts::gauss_mean, facts::bartky_transformation},
      .check = check_limit_minimum};
}

}  // namespace polhode::checker
