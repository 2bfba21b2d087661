// Where C first meets S: the paper's lemma 2. The proof is in turning_points.hpp.

#include "proofs/claims.hpp"
#include "proofs/turning_points.hpp"

namespace polhode::proofs {
namespace {

certificate prove_intersection(const request& wanted) {
  certificate c;
  c.formula =
      "F(-bu,u) = 2 pi for some u in (0, 1)  <=>  I < 2; then u is the only one (u = 1 <=> I = 2)";
  c.method =
      "For all a > 0, 0 < b < 1: G(u) = F(-bu,u) maps (0, 1) one to one onto the values above pi "
      "I, decreasing, and tends to pi I at u = 1 (the steps are those of montgomery_oscillating). "
      "With u = 1 allowed, where F(-b,1) means this limit, the condition is the paper's I <= 2; u "
      "= 1 "
      "is the "
      "equilibrium c = -b, no motion. For a given body I < 2 is decided in rationals.";
  add_steps(c, half_phase_steps());
  add_steps(c, {identity("4*b*(a+b) - (1-b)^2", "4*a*b + 3*b^2 + 2*b - 1",
                         "I < 2 exactly where this is positive")});
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const bool meets = exceeds_geometric_constant(2, rigid);
  c.facts.push_back(
      {std::string("at the given a, b, in rationals: I ") + (meets ? "<" : ">=") +
           " 2, and 4ab + 3b^2 + 2b - 1 is " + (meets ? "positive" : "not positive"),
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

claim intersection_claim() {
  return {
      "lemma 2 and its remark",
      "The part of C given by the first implicit equation meets S in exactly one point with u in "
      "(0, 1) if I < 2 and in none otherwise; at I = 2 the point is the limit u = 1.",
      "one-to-one map onto (pi I, infinity), by exact signs; I < 2 in rationals",
      prove_intersection,
      proof_tier::with_words,
      {{step_kind::kernel, "MeetingPoint.lemma_2"},
       {step_kind::kernel, "Values.takes_each_value_once"},
       {step_kind::argued,
        "On the part of C of the first implicit equation C meets S where pi is the time from psi = "
        "0 to the turning point, G = 2 pi."},
       bartky_transformation()}};
}

}  // namespace polhode::proofs
