#include "proofs/rotating_phase.hpp"

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"

namespace polhode::proofs {

std::vector<polynomial_step> rotating_phase_steps() {
  return {
      slope('c', "(1-b*x)^2", "(a+b*x)*(c+b*x)", "-(1-b*x)^2*(a+b*x)",
            "the derivative in c of the square of the integrand"),
      positive("1-b*x", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
               "1 - bX > 0 for 0 <= X <= 1: the integrand is positive and decreases in c"),
      positive("(a+b*x)-(c+b*x)", "d", "d = a-c > 0", "(a+bX)/(c+bX) > 1 for c < a"),
      not_negative("a*(c+b*x)-c*(a+b*x)", "b*x*d", "b > 0, x >= 0, d = a-c > 0",
                   "(a+bX)/(c+bX) <= a/c for c < a"),
      identity("1-b*x", "(1+a)-(a+b*x)", "(1-bX)/(a+bX) = (1+a)/(a+bX) - 1"),
      identity("a*(1+t^2)+b", "(a+b)+a*t^2",
               "with T = tan psi, X = 1/(1+T^2), k^2 = a/(a+b): the derivative of arctan(kT)/"
               "sqrt(a(a+b)), (1+T^2)/((a+b)(1+k^2 T^2)), is 1/(a+bX), so the limit is pi J"),
      not_negative("(a+b)-(a+b*x)", "b*y", "b > 0, y = 1-x >= 0",
                   "a + bX <= a + b: F(c,0) >= 2 I arsinh((pi/2) sqrt(b/c)), unbounded as c -> 0"),
  };
}

bool rotating_phase_obeys_its_bounds(const body& rigid) {
  return is_decided([&](precision p) {
    const ball limit = 2 * pi(p) * rigid.second_geometric_constant(p);
    ball before = ball::undefined(p);
    for (const int quarter : {1, 2, 3}) {
      const rational c(rigid.a().exact() * quarter / 4);
      const ball value = montgomery_phase(rigid, c, p);
      const ball least = 4 * rigid.geometric_constant(p) *
                         asinh(pi(p) * sqrt(ball(rational(rigid.b().exact() / (4 * c)), p)));
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
  const rational& a = rigid.a().exact();
  return q > -1 && (q + 1) * (q + 1) * a * (a + rigid.b().exact()) > (a + 1) * (a + 1);
}

std::optional<root_bracket> bracket_rotating_phase_root(const body& rigid, const rational& q,
                                                        int bits) {
  if (!exceeds_second_geometric_constant(q, rigid)) return std::nullopt;
  return bracket_root(
      [&](const rational& s, precision p) {
        return scale(montgomery_phase(rigid, rational(rigid.a().exact() * s), p), -1);
      },
      [&](precision p) { return pi(p) * q; }, bits);
}

bool passes_rotating_phase(const body& rigid, const rational& q, const root_bracket& bracket) {
  const auto at = [&](const rational& s, precision p) {
    return montgomery_phase(rigid, rational(rigid.a().exact() * s), p);
  };
  return is_decided([&](precision p) {
    const ball value = 2 * q * pi(p);
    return certainly_less(at(bracket.upper, p), value) &&
           certainly_less(value, at(bracket.lower, p));
  });
}

}  // namespace polhode::proofs
