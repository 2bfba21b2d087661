#include "proofs/half_phase.hpp"

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::proofs {
namespace {

/// 1/I^2.
rational inverse_square(const body& rigid) {
  const rational& a = rigid.a().exact();
  const rational& b = rigid.b().exact();
  return rational(b * (a + b) / ((1 - b) * (1 - b)));
}

/// The greatest whole n >= 0 with n^2 < q, for q > 0: n^2 <= ceil(q) - 1.
integer greatest_with_square_below(const rational& q) {
  const integer n = numerator(q);
  const integer d = denominator(q);
  const integer ceiling((n + d - 1) / d);
  return integer(sqrt(integer(ceiling - 1)));
}

/// sqrt(b) g(x)/(1-b) relative to its value at 1: g(x)/g(1).
ball ratio_to_end(const body& rigid, const rational& x, precision p) {
  const rational& a = rigid.a().exact();
  const rational& b = rigid.b().exact();
  const rational linear((1 - b * x) / (1 - b));
  return ball(linear, p) * sqrt(ball(rational((a + b) / (x * (a + b * x))), p));
}

}  // namespace

std::vector<polynomial_step> half_phase_steps() {
  return {
      identity("(1-(u+(1-u)*k)) * ((u+(1-u)*k)-u)", "(1-u)^2*k*(1-k)",
               "x = u + (1-u) k with k = cos^2(t/2) turns F(-bu,u) into b^(-1/2) times the "
               "integral over (0, pi) of g(x) dt, g(x) = (1-bx)/sqrt(x(a+bx))"),
      slope('x', "(1-b*x)^2", "x*(a+b*x)", "-(1-b*x)*(a+(a+2)*b*x)", "the derivative of g^2"),
      positive("1-b*x", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0", "1 - bx > 0 for 0 < x <= 1"),
      positive("a+(a+2)*b*x", "a + a*b*x + 2*b*x", "a > 0, b > 0, x > 0",
               "so g decreases strictly on 0 < x <= 1"),
      identity("(v+(1-v)*k) - (u+(1-u)*k)", "(v-u)*(1-k)",
               "x is greater for v > u where 0 < t < pi, so G decreases"),
      not_negative("(a+b)-(a+b*x)", "b*y", "b > 0, y = 1-x >= 0",
                   "a + bx <= a + b: g(x) >= (1-b)/sqrt((a+b) x)"),
      not_negative("(u+k)-(u+(1-u)*k)", "u*k", "u > 0, k >= 0",
                   "x <= u + k: G(u) >= 2 I arsinh(pi/(2 sqrt(u)))"),
  };
}

bool half_phase_obeys_its_bounds(const body& rigid) {
  return is_decided([&](precision p) {
    const ball limit = pi(p) * rigid.geometric_constant(p);
    ball before = ball::undefined(p);
    for (const int quarter : {1, 2, 3}) {
      const rational u(quarter, 4);
      const ball value = half_phase(rigid, u, p);
      const ball least = 2 * rigid.geometric_constant(p) * asinh(pi(p) / sqrt(ball(4 * u, p)));
      if (!certainly_less(limit, value) || !certainly_less(least, value) ||
          !certainly_less(value, limit * ratio_to_end(rigid, u, p)) ||
          (quarter > 1 && !certainly_less(value, before))) {
        return false;
      }
      before = value;
    }
    return true;
  });
}

std::optional<root_bracket> bracket_half_phase_root(const body& rigid, const rational& q,
                                                    int bits) {
  if (!exceeds_geometric_constant(q, rigid)) return std::nullopt;
  return bracket_root([&](const rational& u, precision p) { return half_phase(rigid, u, p); },
                      [&](precision p) { return pi(p) * q; }, bits);
}

bool passes_half_phase(const body& rigid, const rational& q, const root_bracket& bracket) {
  return is_decided([&](precision p) {
    return certainly_less(half_phase(rigid, bracket.upper, p), pi(p) * q) &&
           certainly_less(pi(p) * q, half_phase(rigid, bracket.lower, p));
  });
}

bool exceeds_geometric_constant(const rational& q, const body& rigid) {
  return q > 0 && q * q * inverse_square(rigid) > 1;
}

integer count_crossings(const body& rigid) {
  return greatest_with_square_below(inverse_square(rigid));
}

integer count_intersections(const body& rigid) {
  const integer last = greatest_with_square_below(rational(4 * inverse_square(rigid)));
  return integer((last + 1) / 2);
}

}  // namespace polhode::proofs
