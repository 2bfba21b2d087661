#include "proofs/half_phase.hpp"

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::proofs {
namespace {

/// 1/I^2.
exact_real inverse_square(const body& rigid) { return 1 / rigid.square_of_geometric_constant(); }

/// The greatest whole n >= 0 with n^2 < q, for q > 0: n^2 <= ceil(q) - 1. Of an irrational q, with
/// n = floor(sqrt(least)) where q is enclosed from `least`, it is n or a little more.
integer greatest_with_square_below(const exact_real& q) {
  if (q.is_rational()) {
    const integer n = numerator(q.exact());
    const integer d = denominator(q.exact());
    const integer ceiling((n + d - 1) / d);
    return integer(sqrt(integer(ceiling - 1)));
  }
  constexpr precision enough = 256;
  integer n = sqrt(floor_of(lower_rational(q.at(enough))));
  while (rational((n + 1) * (n + 1)) < q) ++n;
  return n;
}

/// sqrt(b) g(x)/(1-b) relative to its value at 1: g(x)/g(1).
ball ratio_to_end(const body& rigid, const rational& x, precision p) {
  const exact_real& a = rigid.a();
  const exact_real& b = rigid.b();
  const exact_real linear = (1 - b * x) / (1 - b);
  return linear.at(p) * sqrt(((a + b) / (x * (a + b * x))).at(p));
}

}  // namespace

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
  return q > 0 && q * q > rigid.square_of_geometric_constant();
}

integer count_crossings(const body& rigid) {
  return greatest_with_square_below(inverse_square(rigid));
}

integer count_intersections(const body& rigid) {
  const integer last = greatest_with_square_below(4 * inverse_square(rigid));
  return integer((last + 1) / 2);
}

}  // namespace polhode::proofs
