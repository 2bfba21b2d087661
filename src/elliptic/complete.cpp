#include "polhode/elliptic/complete.hpp"

#include <algorithm>
#include <utility>

#include "elliptic/enclose.hpp"
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

/// The steps with c_n to full relative accuracy, from the recurrence.
struct agm_state {
  ball a, b;  // a_n, b_n
  ball c;     // c_n, n >= 1
  int n = 0;

  void step() {
    const ball mean = scale(a + b, -1);
    if (n > 0) c = square(c) / (4 * mean);  // the caller knows c_1
    b = sqrt(a * b);
    a = mean;
    ++n;
  }
};

/// c_n is so small that c_{n+1}, of the order of c_n^2, is below the last place of the mean.
bool is_last(const magnitude& c, const magnitude& mean_down, precision p) {
  return c.is_zero() || c <= scale(mean_down, -(static_cast<std::int64_t>(p) / 2 + 2));
}

/// M in [b_n, a_n], and a_n - b_n = 2 c_{n+1} = c_n^2 / (2 a_{n+1}) <= c_n^2 / (2 M): the mean from
/// a_n.
ball mean_from(const ball& a, const magnitude& c, const magnitude& mean_down) {
  return a.enlarged(divide_up(scale(multiply_up(c, c), -1), mean_down));
}

}  // namespace

agm_sums agm_with_sum(const ball& a, const ball& b) {
  const precision p = std::max(a.precision(), b.precision());
  agm_sums result{ball::undefined(p), ball::undefined(p), 0};
  if (!certainly_positive(a) || !certainly_positive(b)) return result;
  // c from its definition: its absolute error is all that matters here, and a subtraction costs
  // less than the recurrence's division. The mean is at least b_(n-1), so the last square root is
  // not needed.
  ball upper = a;
  ball lower = b;
  ball next(0, p);
  ball c(0, p);
  magnitude last_c;
  ball sum(0, p);
  for (int n = 1; n <= most_steps; ++n) {
    subtract(c, upper, lower);
    scale(c, c, -1);
    add(next, upper, lower);
    scale(next, next, -1);
    const magnitude mean_down =
        n == 1 ? min(lower, upper).magnitude_lower() : lower.magnitude_lower();
    magnitude c_up = c.magnitude_upper();
    if (n > 1) {
      // |c_n| = c_(n-1)^2 / (4 a_n) too: where wide operands hide that c_n falls, it bounds c_n.
      const magnitude by_recurrence = divide_up(scale(multiply_up(last_c, last_c), -2), mean_down);
      if (scale(by_recurrence, 1) < c_up) {
        c = ball(0, p).enlarged(by_recurrence);
        c_up = by_recurrence;
      }
    }
    last_c = c_up;
    square(c, c);
    scale(c, c, n - 1);  // the term 2^(n-1) c_n^2
    add(sum, sum, c);
    if (is_last(c_up, mean_down, p)) {
      const magnitude tail = tail_bound(c.magnitude_upper(), c_up, mean_down);
      if (!tail.is_infinite()) {
        result.mean = mean_from(next, c_up, mean_down);
        result.sum = sum.enlarged(tail);
        result.steps = n;
        return result;
      }
    }
    multiply(lower, upper, lower);
    sqrt(lower, lower);
    std::swap(upper, next);
  }
  return result;
}

complete_integrals complete_legendre(const ball& m, const ball& m1) {
  const precision p = std::max(m.precision(), m1.precision());
  complete_integrals result{ball::undefined(p), ball::undefined(p), ball::undefined(p),
                            ball::undefined(p)};
  if (!certainly_positive(m1) || certainly_negative(m) || m.is_undefined()) return result;
  if (!overlaps(m + m1, ball(1, p))) return result;
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
    const magnitude c = s.c.magnitude_upper();
    const magnitude mean_down = s.b.magnitude_lower();
    if (is_last(c, mean_down, p)) {
      const magnitude tail = tail_bound(term.magnitude_upper(), c, mean_down);
      if (tail.is_infinite()) continue;
      result.k = pi(p) / scale(mean_from(s.a, c, mean_down), 1);
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
  const auto by_d = [&] { return 3 * complete_legendre(one_minus_ratio, y / z).d / (z * sqrt(z)); };
  const auto by_b = [&] { return 3 * complete_legendre(one_minus_ratio, z / y).b / (sqrt(y) * z); };
  if (certainly_less_equal(y, z)) return by_d();
  if (certainly_less_equal(z, y)) return by_b();
  return hull(by_d(), by_b());
}

ball agm_slope(const ball& x, const ball& y) {
  const precision p = std::max(x.precision(), y.precision());
  if (!certainly_positive(x) || !certainly_positive(y)) return ball::undefined(p);
  const auto at = [p](const ball& u, const ball& v) {
    const ball lost =
        certainly_less_equal(u, v) ? (v - u) * (v + u) / square(v) : (u - v) * (u + v) / square(u);
    return 2 * square(agm(u, v)) * v * complete_rd(square(u), square(v), lost) / (3 * pi(p));
  };
  if (x.is_exact() && y.is_exact()) return at(x, y);
  const ball low = at(detail::lower_end(x), detail::upper_end(y));
  const ball high = at(detail::upper_end(x), detail::lower_end(y));
  return low.is_undefined() || high.is_undefined() ? ball::undefined(p) : hull(low, high);
}

}  // namespace polhode
