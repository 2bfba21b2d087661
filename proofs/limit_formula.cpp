// The limit a -> infinity, b -> 0: the paper's section 7, eqs. (33) to (38).
//
// With X = cos^2 psi, c = b beta: sqrt(ab) h = v (beta + X)^(-1/2), where v^2 = a (1 - b X)^2/(a + b X) and
// a (1-b)^2/(a+b) <= v^2 <= 1. So sqrt(ab) T(c, psi) lies between sqrt(a/(a+b)) (1-b) t and t, where
// t(beta, psi) = integral from 0 to psi of (beta + cos^2)^(-1/2) = F(psi | 1/(1+beta))/sqrt(1+beta), for beta + cos^2 = (1+beta)(1 - sin^2/(1+beta)).
// T(c, psi) = pi, so t(beta, psi) tends to pi sqrt(chi) for ab -> chi: psi -> am(pi sqrt(chi (1+beta)) | 1/(1+beta)), as t is continuous and increases
// strictly in psi. This is the paper's eq. (38), on the part of C that the first implicit equation gives: all of beta >= 0, and
// -1 < beta < 0 before the first meeting with S, at pi = G/2. There sin = sqrt(1+beta) sin(theta) gives t = K(1+beta) at the turning point, the limit of
// sqrt(ab) G/2 by the same bounds; so for pi sqrt(chi) < K(1+beta) all but finitely many bodies of a sequence have pi < G/2.

#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

polynomial_step upper_step() {
  return not_negative("(a+b*x) - a*(1-b*x)^2", "b*x + a*b*x*(1+q+b*y)",
                      "a > 0, b > 0, x >= 0, q = 1-b > 0, y = 1-x >= 0",
                      "v^2 = a(1-bX)^2/(a+bX) <= 1");
}

certificate prove_limit(const request&) {
  certificate c;
  c.formula =
      "epsilon -> pi/2 - am(pi sqrt(chi(1+beta)) | 1/(1+beta)) as a -> infinity, b -> 0, ab -> "
      "chi, c = b beta, where beta >= 0, or -1 < beta < 0 and pi sqrt(chi) < K(1+beta)";
  c.method =
      "For all a > 0, 0 < b < 1: sqrt(ab) times the integrand is v (beta + cos^2 psi)^(-1/2) with "
      "(1-b) sqrt(a/(a+b)) <= v <= 1, so the integral divided by its limit form lies between these "
      "bounds, which tend to 1. The limit form is F(psi | 1/(1+beta))/sqrt(1+beta), continuous and "
      "increasing in psi. The first implicit equation holds for beta >= 0, and for -1 < beta < 0 "
      "where pi comes "
      "before the turning point, at which the limit form is K(1+beta). Computed: the polynomial "
      "steps.";
  add_steps(c, {upper_step(),
                not_negative("(1-b*x) - (1-b)", "b*y", "b > 0, y = 1-x >= 0", "1 - bX >= 1 - b"),
                not_negative("(a+b) - (a+b*x)", "b*y", "b > 0, y = 1-x >= 0",
                             "a + bX <= a + b, so that v^2 >= a(1-b)^2/(a+b)"),
                identity("d + (1-s)", "(1+d) - s",
                         "beta + cos^2 = (1+beta)(1 - sin^2/(1+beta)): the limit form is "
                         "F(psi | 1/(1+beta))/sqrt(1+beta)")});
  c.conclude();
  return c;
}

}  // namespace

claim limit_formula_claim() {
  return {"limit_formula",
          "eqs. (33)-(38)",
          "As a -> infinity, b -> 0 with ab -> chi and c/b = beta, epsilon tends to pi/2 - "
          "am(pi sqrt(chi(1+beta)) | 1/(1+beta)), on the part of C of the first implicit equation: "
          "beta >= 0, or -1 < beta < 0 and pi sqrt(chi) < K(1+beta).",
          "two-sided bound of the integrand, by exact signs",
          claim_subject::none,
          prove_limit,
          proof_tier::by_argument,
          {{step_kind::argued,
            "The integral divided by its limit form lies between two bounds that tend to 1. The "
            "limit form is continuous and increases strictly in psi, so that the psi at which it "
            "is pi has a limit."}}};
}

}  // namespace polhode::proofs
