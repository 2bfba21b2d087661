#include "polynomials.hpp"

#include <string>
#include <utility>

#include "polhode/expression/functions.hpp"

namespace polhode::detail {
namespace {

long degree_of(const graph& g, const char* name, node_id degree) {
  constexpr long most = 1000;
  const rational* q = g.value(degree);
  if (q == nullptr || denominator(*q) != 1 || *q < 0 || *q > most) {
    throw undefined_operation(std::string(name) + " has a whole number from 0 to " +
                              std::to_string(most) + " as its degree: write " + name +
                              (std::string(name) == "binomial" ? "(x, 3)" : "(3, x)"));
  }
  return mpz_get_si(numerator(*q).backend().data());
}

/// 1 where x is defined, and else as x is.
node_id one_like(graph& g, node_id x) { return power(g, x, g.number(0)); }

/// p_n, where p_0 = 1, p_1 = (a + b x)/c and p_(k+1) = ((a + b x) p_k - d p_(k-1))/c with the terms
/// at k = 0, 1, ....
struct terms {
  long a;
  long b;
  long c;
  long d;
};
template <class Terms>
node_id by_recurrence(graph& g, long n, node_id x, const Terms& at) {
  if (n == 0) return one_like(g, x);
  node_id before = g.number(0);
  node_id result = g.number(1);
  for (long k = 0; k < n; ++k) {
    const terms t = at(k);
    const node_id factor =
        divide(g, add(g, g.number(t.a), multiply(g, g.number(t.b), x)), g.number(t.c));
    const node_id next =
        subtract(g, multiply(g, factor, result), multiply(g, g.number(rational(t.d, t.c)), before));
    before = std::exchange(result, next);
  }
  return result;
}

struct chebyshev_pair {
  node_id t;       // T_n
  node_id t_next;  // T_(n+1)
  node_id u;       // U_n
};
/// With x = cos(y), T_n = cos(n y) and U_n = sin((n + 1) y)/sin(y): sums of angles give
///   T_2n = 2 T_n^2 - 1,    T_(2n+1) = 2 T_n T_(n+1) - x,
///   U_2n = 2 T_n U_n - 1,  U_(2n+1) = 2 T_(n+1) U_n.
/// The errors of balls grow as powers of n so, and exponentially by the recurrence.
chebyshev_pair chebyshev(graph& g, long n, node_id x) {
  const node_id one = g.number(1);
  if (n == 0) return {one, x, one};
  const chebyshev_pair half = chebyshev(g, n / 2, x);
  const auto twice = [&](node_id i, node_id j, node_id less) {
    return subtract(g, multiply(g, g.number(2), multiply(g, i, j)), less);
  };
  const node_id mixed = twice(half.t, half.t_next, x);
  if (n % 2 == 0) return {twice(half.t, half.t, one), mixed, twice(half.t, half.u, one)};
  return {mixed, twice(half.t_next, half.t_next, one), twice(half.t_next, half.u, g.number(0))};
}

}  // namespace

node_id binomial_of(graph& g, const std::vector<node_id>& x) {
  const long n = degree_of(g, "binomial", x[1]);
  if (n == 0) return one_like(g, x[0]);
  node_id result = g.number(1);
  for (long k = 0; k < n; ++k) {
    result = multiply(g, result, divide(g, subtract(g, x[0], g.number(k)), g.number(k + 1)));
  }
  return result;
}

node_id chebyshev_t(graph& g, const std::vector<node_id>& x) {
  const long n = degree_of(g, "chebyshevT", x[0]);
  return n == 0 ? one_like(g, x[1]) : chebyshev(g, n, x[1]).t;
}
node_id chebyshev_u(graph& g, const std::vector<node_id>& x) {
  const long n = degree_of(g, "chebyshevU", x[0]);
  return n == 0 ? one_like(g, x[1]) : chebyshev(g, n, x[1]).u;
}

// The recurrences of DLMF 18.9.1, table 18.9.1.
node_id legendre_p(graph& g, const std::vector<node_id>& x) {
  return by_recurrence(g, degree_of(g, "legendreP", x[0]), x[1], [](long k) {
    return terms{0, 2 * k + 1, k + 1, k};
  });
}
node_id hermite_h(graph& g, const std::vector<node_id>& x) {
  return by_recurrence(g, degree_of(g, "hermiteH", x[0]), x[1], [](long k) {
    return terms{0, 2, 1, 2 * k};
  });
}
node_id laguerre_l(graph& g, const std::vector<node_id>& x) {
  return by_recurrence(g, degree_of(g, "laguerreL", x[0]), x[1], [](long k) {
    return terms{2 * k + 1, -1, k + 1, k};
  });
}

}  // namespace polhode::detail
