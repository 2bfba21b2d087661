#include "polhode/elliptic/complete.hpp"

#include <algorithm>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode {
namespace {

// Steps that take any pair of positive numbers of MPFR's exponent range to agreement: the ratio's
// logarithm halves until it is of order 1 (about 32 steps), then digits double.
constexpr int most_steps = 200;

/// An upper bound of the tail after the term 2^(n-1) c_n^2, or infinity where q > 1/2.
magnitude tail_bound(const magnitude& term, const magnitude& c, const magnitude& mean_down) {
  const magnitude ratio = divide_up(scale(c, -2), mean_down);
  const magnitude q = scale(multiply_up(ratio, ratio), 1);
  if (q > magnitude::power_of_two(-1)) return magnitude::infinity();
  return multiply_up(term, divide_up(q, subtract_down(magnitude::power_of_two(0), q)));
}

/// The steps common to the functions of this file. visit(n, c_n, a_n) is called for n = 1, 2, ...
/// and returns the current relative size it still cares for.
struct agm_state {
  ball a, b;  // a_n, b_n
  ball c;     // c_n, n >= 1
  int n = 0;

  void step() {
    // c from the recurrence where it loses nothing; the first one by its definition.
    const ball mean = scale(a + b, -1);
    c = n == 0 ? scale(a - b, -1) : square(c) / (4 * mean);
    b = sqrt(a * b);
    a = mean;
    ++n;
  }
};

/// c_n is so small that c_{n+1}, of the order of c_n^2, is below the last place of the mean.
bool is_last(const agm_state& s, precision p) {
  const magnitude c = s.c.magnitude_upper();
  return c.is_zero() || c <= scale(s.a.magnitude_lower(), -(static_cast<std::int64_t>(p) / 2 + 2));
}

/// M in [b_n, a_n], and a_n - b_n = 2 c_{n+1} <= c_n^2 / (2 M): the mean from a_n by its error.
ball mean_from(const agm_state& s) {
  const magnitude c = s.c.magnitude_upper();
  const magnitude width = divide_up(scale(multiply_up(c, c), -1), s.b.magnitude_lower());
  return s.a.enlarged(width);
}

}  // namespace

agm_sums agm_with_sum(const ball& a, const ball& b) {
  const precision p = std::max(a.precision(), b.precision());
  agm_sums result{ball::undefined(p), ball::undefined(p), 0};
  if (!certainly_positive(a) || !certainly_positive(b)) return result;
  agm_state s{a, b, ball(0, p), 0};
  ball sum(0, p);
  while (s.n < most_steps) {
    s.step();
    const ball term = scale(square(s.c), s.n - 1);
    sum += term;
    if (is_last(s, p)) {
      const magnitude tail =
          tail_bound(term.magnitude_upper(), s.c.magnitude_upper(), s.b.magnitude_lower());
      if (tail.is_infinite()) continue;
      result.mean = mean_from(s);
      result.sum = sum.enlarged(tail);
      result.steps = s.n;
      return result;
    }
  }
  return result;
}

complete_integrals complete_legendre(const ball& m, const ball& m1) {
  const precision p = std::max(m.precision(), m1.precision());
  complete_integrals result{ball::undefined(p), ball::undefined(p), ball::undefined(p),
                            ball::undefined(p)};
  if (!certainly_positive(m1) || certainly_negative(m) || m.is_undefined()) return result;
  agm_state s{ball(1, p), sqrt(m1), ball(0, p), 0};
  ball ratio(0, p);  // c_n^2 / m
  ball sum(0, p);    // of 2^(n-1) c_n^2 / m
  while (s.n < most_steps) {
    const ball previous_c = s.c;
    if (s.n == 0) {
      // a_0 - b_0 = m / (a_0 + b_0), since a_0^2 - b_0^2 = m: c_1 = m / (2 (a_0 + b_0)).
      const ball twice_total = scale(s.a + s.b, 1);
      s.step();
      s.c = m / twice_total;
      ratio = s.c / twice_total;
    } else {
      s.step();  // c_{n+1}^2 / m = (c_n^2 / m) (c_n / (4 a_{n+1}))^2
      ratio = ratio * square(previous_c / (4 * s.a));
    }
    const ball term = scale(ratio, s.n - 1);
    sum += term;
    if (is_last(s, p)) {
      const magnitude tail =
          tail_bound(term.magnitude_upper(), s.c.magnitude_upper(), s.b.magnitude_lower());
      if (tail.is_infinite()) continue;
      result.k = pi(p) / scale(mean_from(s), 1);
      result.d = result.k * (scale(ball(1, p), -1) + sum.enlarged(tail));
      result.b = result.k - result.d;
      result.e = result.b + m1 * result.d;
      return result;
    }
  }
  return result;
}

ball complete_rd(const ball& y, const ball& z, const ball& one_minus_ratio) {
  const precision p = std::max(y.precision(), z.precision());
  if (!certainly_positive(y) || !certainly_positive(z)) return ball::undefined(p);
  if (certainly_less_equal(y, z)) {
    return 3 * complete_legendre(one_minus_ratio, y / z).d / (z * sqrt(z));
  }
  if (certainly_less_equal(z, y)) {
    return 3 * complete_legendre(one_minus_ratio, z / y).b / (sqrt(y) * z);
  }
  return ball::undefined(p);
}

}  // namespace polhode
