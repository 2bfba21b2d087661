// How often C and S meet: the paper's theorem 4, sharpened. The proof is in turning_points.hpp.

#include "proofs/claims.hpp"
#include "proofs/turning_points.hpp"

namespace polhode::proofs {
namespace {

certificate prove_count(const request& wanted) {
  certificate c;
  c.formula =
      "C meets S in exactly N = ceil(1/I + 1/2) - 1 points with -b < c < 0, G(u_k) = 2 pi/(2k-1)";
  c.method =
      "For all a > 0, 0 < b < 1: by the symmetries of the reduced system psi_c(pi) is a turning "
      "point, which is where C meets S, exactly where pi = (k - 1/2) G(u) for a whole k >= 1; G "
      "maps (0, 1) one to one onto the values above pi I, so that there is one for every k < 1/I + "
      "1/2. I < 2/(2n+1) is n + 1 < 1/I + 1/2: N >= n + 1, the paper's theorem. Computed: the "
      "polynomial steps for G, and the count in rationals.";
  add_steps(c, half_phase_steps());
  add_steps(c, {identity("2*k - (2*k-1)", "1",
                         "2 pi/(2k-1) > pi/k: the k-th crossing of pi/2 "
                         "comes after the k-th intersection"),
                identity("(2*k+1) - 2*k", "1", "pi/k > 2 pi/(2k+1): and before the next")});
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const integer count = count_intersections(rigid);
  c.witness["N"] = count.str();
  const auto q = [](const integer& k) { return rational(integer(2), integer(2 * k - 1)); };
  c.facts.push_back({"at the given a, b, in rationals: I < 2/(2k-1) for " + counted(count),
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

claim count_claim() {
  return {"theorem 4",
          "C and S meet exactly N = ceil(1/I + 1/2) - 1 times: n + 1 times for 2/(2n+3) <= I < "
          "2/(2n+1), "
          "where the paper says at least.",
          "symmetries of the motion; one-to-one map, by exact signs; the count in rationals",
          prove_count,
          proof_tier::by_kernel,
          {{step_kind::kernel, "Curve.theorem_4_sharp"}, bartky_transformation()}};
}

}  // namespace polhode::proofs
