// Where epsilon(c) = pi/2: the paper's lemma 3. The proof is in turning_points.hpp.

#include "proofs/claims.hpp"
#include "proofs/turning_points.hpp"

namespace polhode::proofs {
namespace {

certificate prove_crossing(const request& wanted) {
  certificate c;
  c.formula =
      "epsilon(c*) = pi/2 for some c* in (-b, 0)  <=>  I < 1; it has ceil(1/I) - 1 such solutions";
  c.method =
      "For all a > 0, 0 < b < 1: by the symmetries of the reduced system psi_c(phi + G) = "
      "-psi_c(phi), and psi_c(pi) = 0 exactly where pi = k G(u) for a whole k >= 1; G maps (0, 1) "
      "one to one onto the values above pi I, so that there is one solution for every k < 1/I. The "
      "first, G = pi, lies beyond the first intersection, G = 2 pi. Computed: the polynomial steps "
      "for G, and the count in rationals.";
  add_steps(c, half_phase_steps());
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const integer count = count_crossings(rigid);
  c.witness["crossings_count"] = count.str();
  c.facts.push_back(
      {"at the given a, b, in rationals: k < 1/I for " + counted(count) + ", and the body is " +
           to_text(rigid.kind()),
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

claim crossing_claim() {
  return {
      "lemma 3",
      "epsilon(c) takes the value pi/2 in (-b, 0) if and only if I < 1, that is, if the body is "
      "not physical: exactly ceil(1/I) - 1 times.",
      "symmetries of the motion; one-to-one map, by exact signs; the count in rationals",
      prove_crossing,
      proof_tier::by_kernel,
      {{step_kind::kernel, "Curve.lemma_3_sharp"}, bartky_transformation()}};
}

}  // namespace polhode::proofs
