// The Montgomery phase of rotating motion: the paper's theorem 2.
//
// For 0 < c <= a, with X = cos^2 psi, half of it is
//   F(c,0) = 2 integral from 0 to pi/2 of (1 - b X)/sqrt((a + b X)(c + b X)) dpsi.
//   (1) The integrand is positive and decreases strictly in c, so F(c,0) does; it is continuous in (psi, c) for c > 0, so F(c,0) is.
//   (2) 1 <= (a + b X)/(c + b X) <= a/c. So, with P = 2 integral of (1 - b X)/(a + b X),  P < F(c,0) <= P sqrt(a/c)
//       for c < a, and P is the limit for c -> a and the greatest lower bound.
//   (3) P = pi J: (1 - b X)/(a + b X) = (1 + a)/(a + b X) - 1, and with T = tan psi and k^2 = a/(a + b) the derivative of
//       arctan(k T)/sqrt(a (a+b)) is 1/(a + b X), so that the integral of the latter is pi/(2 sqrt(a (a+b))).
//   (4) F(c,0) >= 2 I arsinh((pi/2) sqrt(b/c)), which has no bound as c -> 0: 1 - b X >= 1 - b, a + b X <= a + b, and
//       cos psi <= pi/2 - psi = s, where the integral of ds/sqrt(c + b s^2) is arsinh(s sqrt(b/c))/sqrt(b).
// So F(c,0) maps (0, a) one to one onto (pi J, infinity), decreasing.

#include "proofs/rotating_phase.hpp"

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "proofs/claims.hpp"

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
       rotating_phase_obeys_its_bounds(rigid)});
  c.conclude();
  return c;
}

}  // namespace

std::vector<polynomial_step> rotating_phase_steps() {
  return {
      slope('c', "(1-b*x)^2", "(a+b*x)*(c+b*x)", "-(1-b*x)^2*(a+b*x)",
            "the derivative in c of the square of the integrand"),
      positive("1-b*x", "q + b*y", "q = 1-b, y = 1-x",
               "1 - bX > 0 for 0 <= X <= 1: the integrand is positive and decreases in c"),
      positive("(a+b*x)-(c+b*x)", "d", "d = a-c", "(a+bX)/(c+bX) > 1 for c < a"),
      positive("a*(c+b*x)-c*(a+b*x)", "b*x*d", "d = a-c", "(a+bX)/(c+bX) <= a/c for c < a"),
      identity("1-b*x", "(1+a)-(a+b*x)", "(1-bX)/(a+bX) = (1+a)/(a+bX) - 1"),
      identity("a*(1+t^2)+b", "(a+b)+a*t^2",
               "with T = tan psi, X = 1/(1+T^2), k^2 = a/(a+b): the derivative of arctan(kT)/"
               "sqrt(a(a+b)), (1+T^2)/((a+b)(1+k^2 T^2)), is 1/(a+bX), so the limit is pi J"),
      positive("(a+b)-(a+b*x)", "b*y", "y = 1-x",
               "a + bX <= a + b: F(c,0) >= 2 I arsinh((pi/2) sqrt(b/c)), unbounded as c -> 0"),
  };
}

bool rotating_phase_obeys_its_bounds(const body& rigid) {
  return is_decided([&](precision p) {
    const ball limit = 2 * pi(p) * rigid.second_geometric_constant(p);
    ball before = ball::undefined(p);
    for (const int quarter : {1, 2, 3}) {
      const rational c(rigid.a() * quarter / 4);
      const ball value = montgomery_phase(rigid, c, p);
      const ball least = 4 * rigid.geometric_constant(p) *
                         asinh(pi(p) * sqrt(ball(rational(rigid.b() / (4 * c)), p)));
      const ball most = limit * sqrt(ball(rational(4, quarter), p));
      if (!certainly_less(limit, value) || !certainly_less(least, value) ||
          !certainly_less(value, most) || (quarter > 1 && !certainly_less(value, before))) {
        return false;
      }
      before = value;
    }
    return true;
  });
}

bool exceeds_second_geometric_constant(const rational& q, const body& rigid) {
  const rational& a = rigid.a();
  return q > -1 && (q + 1) * (q + 1) * a * (a + rigid.b()) > (a + 1) * (a + 1);
}

std::optional<root_bracket> bracket_rotating_phase_root(const body& rigid, const rational& q,
                                                        int bits) {
  if (!exceeds_second_geometric_constant(q, rigid)) return std::nullopt;
  return bracket_root(
      [&](const rational& s, precision p) {
        return scale(montgomery_phase(rigid, rational(rigid.a() * s), p), -1);
      },
      [&](precision p) { return pi(p) * q; }, bits);
}

bool passes_rotating_phase(const body& rigid, const rational& q, const root_bracket& bracket) {
  const auto at = [&](const rational& s, precision p) {
    return montgomery_phase(rigid, rational(rigid.a() * s), p);
  };
  return is_decided([&](precision p) {
    const ball value = 2 * q * pi(p);
    return certainly_less(at(bracket.upper, p), value) &&
           certainly_less(value, at(bracket.lower, p));
  });
}

claim montgomery_rotating_claim() {
  return {"montgomery_rotating",
          "theorem 2, eq. (17)",
          "The Montgomery phase of rotating motion decreases in c, and its greatest lower bound is "
          "2 pi J.",
          "exact derivative and signs; two-sided bounds and an antiderivative for the limit",
          claim_subject::body,
          prove_rotating};
}

}  // namespace polhode::proofs
