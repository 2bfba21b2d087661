// Where the curve C of the tennis racket effect meets the curve S (c = -b sin^2 epsilon) and the line epsilon = pi/2: the paper's
// lemmas 2 and 3 and its theorem 4, sharpened.
//
// For -b < c < 0 let psi_c(phi) be the solution with psi = 0 and cos theta > 0 at phi = 0, and epsilon(c) = pi/2 - psi_c(pi). The system
// keeps its form under (psi, phi) -> (-psi, -phi), and under (theta, phi) -> (pi - theta, -phi); its solutions are determined by their
// values at one phi (Picard and Lindeloef). By the first, psi_c is odd; psi increases up to the turning point,
// where cos theta = 0, in the angle F(c,u)/2 = G(u)/2, u = -c/b; by the second it returns as it came. So psi_c(phi + G) = -psi_c(phi), and
//   psi_c(pi) = 0           exactly where pi = k G(u), k = 1, 2, ...:          epsilon = pi/2, G(u) = pi/k;
//   psi_c(pi) is extreme    exactly where pi = (k - 1/2) G(u), k = 1, 2, ...:  C meets S,      G(u) = 2 pi/(2k - 1).
// G maps (0, 1) one to one onto (pi I, infinity), decreasing (half_phase.hpp). So
//   - C meets S first at G = 2 pi, at exactly one u in (0, 1) where I < 2, and nowhere there otherwise (the paper's "u in (0, 1], I <= 2"
//     counts the limit u = 1 at I = 2, where c = -b is an equilibrium);
//   - epsilon = pi/2 is crossed once for every k < 1/I: ceil(1/I) - 1 times, so at all exactly where I < 1;
//   - C meets S once for every k < 1/I + 1/2: N = ceil(1/I + 1/2) - 1 times, u_1 < u_2 < ..., and between u_k and u_(k+1), or u_N and 1,
//     at most one crossing, G = pi/k, since 2 pi/(2k-1) > pi/k > 2 pi/(2k+1).
// The paper's theorem: I < 2/(2n+1) is n + 1 < 1/I + 1/2, so N >= n + 1 (its "at least n" and "another one"), and c* with G = pi/n lies
// beyond the n-th. Both numbers are exact questions about b (a+b)/(1-b)^2 = 1/I^2.

#include "polhode/arithmetic/elementary.hpp"
#include "proofs/claims.hpp"
#include "proofs/half_phase.hpp"

namespace polhode::proofs {
namespace {

constexpr int most_brackets = 6;

/// "k = 1", "k = 1 ... 3", "no k"
std::string counted(const integer& count) {
  if (count == 0) return "no k";
  return count == 1 ? "k = 1" : "k = 1 ... " + count.str();
}

std::string multiple_of_pi(const rational& q) {
  std::string result = q == 1 ? "pi" : numerator(q) == 1 ? "pi" : numerator(q).str() + " pi";
  if (denominator(q) != 1) result += "/" + denominator(q).str();
  return result;
}

/// Brackets of G(u) = q(k) pi for k = 1 ... count, at most six of them, each a fact.
void add_brackets(certificate& c, const body& rigid, const integer& count,
                  const std::function<rational(int k)>& q, const std::string& what) {
  const int shown = count < most_brackets ? static_cast<int>(count) : most_brackets;
  for (int k = 1; k <= shown; ++k) {
    const auto bracket = bracket_half_phase_root(rigid, q(k));
    json& witness = c.witness[what];
    if (!bracket) {
      witness.push_back(nullptr);
      note_missing_witness(c, "a bracket of G(u) = " + multiple_of_pi(q(k)));
      continue;
    }
    c.facts.push_back({"at the given a, b, by the AGM: G(u) passes " + multiple_of_pi(q(k)) +
                           " between u = " + in_decimals(*bracket),
                       passes_half_phase(rigid, q(k), *bracket)});
    witness.push_back(as_json(*bracket));
  }
}

/// G(u) > q pi at u = 1/2 and 1 - 2^-20, where there is no root.
void add_absence(certificate& c, const body& rigid, const rational& q) {
  c.facts.push_back({"at the given a, b, in rationals: I >= " + to_text(q) +
                         "; by the AGM G(1/2) > " + multiple_of_pi(q),
                     !exceeds_geometric_constant(q, rigid) && is_decided([&](precision p) {
                       return certainly_less(pi(p) * q, half_phase(rigid, rational(1, 2), p));
                     })});
}

certificate prove_intersection(const request& wanted) {
  certificate c;
  c.formula =
      "F(-bu,u) = 2 pi for some u in (0, 1)  <=>  I < 2; then u is the only one (u = 1 <=> I = 2)";
  c.method =
      "For all a > 0, 0 < b < 1: G(u) = F(-bu,u) maps (0, 1) one to one onto the values above pi "
      "I, "
      "decreasing, and tends to pi I at u = 1 (the steps are those of montgomery_oscillating). "
      "With "
      "u = 1 allowed, where F(-b,1) means this limit, the condition is the paper's I <= 2; u = 1 "
      "is "
      "the "
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
       meets == (4 * rigid.a() * rigid.b() + 3 * rigid.b() * rigid.b() + 2 * rigid.b() > 1)});
  if (meets) {
    add_brackets(
        c, rigid, 1, [](int) { return rational(2); }, "intersection");
  } else {
    add_absence(c, rigid, 2);
  }
  c.conclude();
  return c;
}

certificate prove_crossing(const request& wanted) {
  certificate c;
  c.formula =
      "epsilon(c*) = pi/2 for some c* in (-b, 0)  <=>  I < 1; it has ceil(1/I) - 1 such solutions";
  c.method =
      "For all a > 0, 0 < b < 1: by the symmetries of the reduced system psi_c(phi + G) = "
      "-psi_c(phi), and psi_c(pi) = 0 exactly where pi = k G(u) for a whole k >= 1; G maps (0, 1) "
      "one to one onto the values above pi I, so that there is one solution for every k < 1/I. The "
      "first, G = pi, lies beyond the first intersection, G = 2 pi. Computed: the polynomial steps "
      "for G, and the count in rationals. Cited: uniqueness of solutions (Picard and Lindeloef).";
  add_steps(c, half_phase_steps());
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const integer count = count_crossings(rigid);
  c.witness["crossings_count"] = count.str();
  c.facts.push_back(
      {"at the given a, b, in rationals: k < 1/I for " + counted(count) +
           " and no other k >= 1, and the body is " + to_text(rigid.kind()),
       (count == 0 || exceeds_geometric_constant(rational(integer(1), count), rigid)) &&
           !exceeds_geometric_constant(rational(integer(1), integer(count + 1)), rigid) &&
           (count > 0) == (rigid.kind() == body_kind::non_physical)});
  if (count > 0) {
    add_brackets(
        c, rigid, count, [](int k) { return rational(1, k); }, "crossings");
  } else {
    add_absence(c, rigid, 1);
  }
  c.conclude();
  return c;
}

certificate prove_count(const request& wanted) {
  certificate c;
  c.formula =
      "C meets S in exactly N = ceil(1/I + 1/2) - 1 points with -b < c < 0, G(u_k) = 2 pi/(2k-1)";
  c.method =
      "For all a > 0, 0 < b < 1: by the symmetries of the reduced system psi_c(pi) is a turning "
      "point, which is where C meets S, exactly where pi = (k - 1/2) G(u) for a whole k >= 1; G "
      "maps (0, 1) one to one onto the values above pi I, so that there is one for every k < 1/I + "
      "1/2. I < 2/(2n+1) is n + 1 < 1/I + 1/2: N >= n + 1, the paper's theorem. Computed: the "
      "polynomial steps for G, and the count in rationals. Cited: uniqueness of solutions (Picard "
      "and Lindeloef).";
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
  c.facts.push_back({"at the given a, b, in rationals: I < 2/(2k-1) for " + counted(count) +
                         " and no other k >= 1",
                     (count == 0 || exceeds_geometric_constant(q(count), rigid)) &&
                         !exceeds_geometric_constant(q(count + 1), rigid)});
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

claim intersection_claim() {
  return {
      "intersection",
      "lemma 2 and its remark",
      "The part of C given by the first implicit equation meets S in exactly one point with u in "
      "(0, 1) if I < 2 and in none otherwise; at I = 2 the point is the limit u = 1.",
      "one-to-one map onto (pi I, infinity), by exact signs; I < 2 in rationals",
      claim_subject::body,
      prove_intersection};
}

claim crossing_claim() {
  return {
      "crossing",
      "lemma 3",
      "epsilon(c) takes the value pi/2 in (-b, 0) if and only if I < 1, that is, if the body is "
      "not physical: exactly ceil(1/I) - 1 times.",
      "symmetries of the motion; one-to-one map, by exact signs; the count in rationals",
      claim_subject::body,
      prove_crossing};
}

claim count_claim() {
  return {"count",
          "theorem 4",
          "C and S meet exactly N = ceil(1/I + 1/2) - 1 times; so at least n + 1 times if I < "
          "2/(2n+1), which the paper says less sharply.",
          "symmetries of the motion; one-to-one map, by exact signs; the count in rationals",
          claim_subject::body,
          prove_count};
}

}  // namespace polhode::proofs
