#include "polhode/elliptic/theta.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "elliptic/enclose.hpp"
#include "elliptic/theta_series.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode {
namespace {

/// cos and sin of k t for k = 0, 1, ..., each from two of half the angle: errors grow with log k.
class multiples {
 public:
  explicit multiples(const ball& t)
      : cosines_{ball(1, t.precision())}, sines_{ball(0, t.precision())} {
    auto [s, c] = sin_cos(t);
    cosines_.push_back(std::move(c));
    sines_.push_back(std::move(s));
  }
  const ball& cosine(std::size_t k) { return reach(k), cosines_[k]; }
  const ball& sine(std::size_t k) { return reach(k), sines_[k]; }

 private:
  void reach(std::size_t k) {
    while (cosines_.size() <= k) {
      const std::size_t low = cosines_.size() / 2;
      const std::size_t high = cosines_.size() - low;
      ball c = cosines_[low] * cosines_[high] - sines_[low] * sines_[high];
      ball s = sines_[low] * cosines_[high] + cosines_[low] * sines_[high];
      cosines_.push_back(std::move(c));
      sines_.push_back(std::move(s));
    }
  }
  std::vector<ball> cosines_;
  std::vector<ball> sines_;
};

}  // namespace

/// The series of the definition, for q <= 1/20. With k = 2n+1 (theta_1, theta_2) or k = 2n, the
/// terms are in size at most 2 k q^(k^2/4) (k = 1 in the value), and the next one at most (k+2)/k
/// q^(k+1) <= 3/20 times as great for k >= 1: the rest is at most twice its first term.
theta_values detail::theta_by_definition(int j, const ball& z, const ball& q, precision p) {
  const bool half = j <= 2;
  multiples of_z(z);
  const ball root = half ? sqrt(sqrt(q)) : ball(1, p);
  ball power = half ? 2 * root : 2 * q;  // 2 q^(k^2/4)
  const ball qq = square(q);
  ball ratio = half ? qq : qq * q;  // q^(k+1)
  theta_values result{half ? ball(0, p) : ball(1, p), ball(0, p)};
  for (long n = half ? 0 : 1;; ++n) {
    const long k = half ? 2 * n + 1 : 2 * n;
    const magnitude first = power.magnitude_upper();
    // theta_1 and theta_2 are of the size of their first term.
    const magnitude size = half ? scale(root.magnitude_upper(), -2) : magnitude::power_of_two(-2);
    if (n > 1 && multiply_up(first, magnitude::from_integer_up(static_cast<std::uint64_t>(k))) <=
                     scale(size, -p)) {
      result.value = result.value.enlarged(scale(first, 1));
      result.derivative = result.derivative.enlarged(
          multiply_up(scale(first, 1), magnitude::from_integer_up(static_cast<std::uint64_t>(k))));
      return result;
    }
    const bool negative = (j == 1 || j == 4) && n % 2 != 0;
    const auto at = static_cast<std::size_t>(k);
    const ball term = negative ? -power : power;
    if (j == 1) {
      result.value += term * of_z.sine(at);
      result.derivative += k * term * of_z.cosine(at);
    } else {
      result.value += term * of_z.cosine(at);
      result.derivative -= k * term * of_z.sine(at);
    }
    power *= ratio;
    ratio *= qq;
  }
}

/// The other series, for q > 1/25, so that L < 3.22 and pi^2/L > 3. On either side the terms are
/// exp(-x^2/L) and, in the derivative, 2x/L exp(-x^2/L) at x, x + pi, ...; from an x >= pi/2 on the
/// next one is at most (x+pi)/x exp(-pi(2x+pi)/L) <= 3 exp(-2 pi^2/L) < 3 e^(-6) times as great:
/// the rest is at most twice its first term.
theta_values detail::theta_by_poisson(int j, const ball& z, const ball& q, precision p) {
  const ball L = -log(q);
  const ball period = pi(std::max({p, z.precision(), q.precision()}));
  ball from = z;
  if (j == 1) from = z - scale(period, -1);
  if (j == 4) from = z + scale(period, -1);
  const ball turns = round_ties_to_even((from / period).middle());
  from -= turns * period;
  const bool alternating = j <= 2;
  const ball half_turns = scale(turns, -1);
  const bool negative = alternating && !overlaps(half_turns, round_ties_to_even(half_turns));
  theta_values result{ball(0, p), ball(0, p)};
  const ball first = exp(-square(from) / L);
  const magnitude greatest =
      first.magnitude_lower().is_zero() ? first.magnitude_upper() : first.magnitude_lower();
  const magnitude negligible =
      magnitude::power_of_two(-1'000'000'000);  // MPFR's least is 2^(-2^30)
  const auto add = [&](long n) {                // false where the term is below the last place
    const ball x = from + n * period;
    ball term = exp(-square(x) / L);
    if (alternating && n % 2 != 0) term = -term;
    const ball slope = -2 * x / L * term;
    const ball size = abs(x);
    const magnitude bound = max(term.magnitude_upper(), slope.magnitude_upper());
    const bool rest = n != 0 && !possibly_less(size, scale(period, -1)) &&
                      (bound <= scale(greatest, -p) || bound <= negligible);
    if (rest) {
      result.value = result.value.enlarged(scale(term.magnitude_upper(), 1));
      result.derivative = result.derivative.enlarged(scale(slope.magnitude_upper(), 1));
      return false;
    }
    result.value += term;
    result.derivative += slope;
    return true;
  };
  constexpr long most_terms = 1'000'000;
  add(0);
  for (const long side : {1L, -1L}) {
    long n = side;
    while (add(n)) {
      n += side;
      if (n * side > most_terms) return {ball::undefined(p), ball::undefined(p)};
    }
  }
  const ball factor = sqrt(period / L);
  result.value *= negative ? -factor : factor;
  result.derivative *= negative ? -factor : factor;
  return result;
}

namespace {

theta_values theta_with(int j, const ball& z, const ball& q, precision p) {
  if (certainly_less(q, ball(rational(1, 20), p))) return detail::theta_by_definition(j, z, q, p);
  if (certainly_less(ball(rational(1, 25), p), q)) return detail::theta_by_poisson(j, z, q, p);
  return {ball::undefined(p), ball::undefined(p)};  // a wide set, for which no one series will do
}

}  // namespace

theta_values theta(int j, const ball& z, const ball& q) {
  if (j < 1 || j > 4) {
    throw std::invalid_argument("theta functions are numbered 1 to 4, not " + std::to_string(j));
  }
  const precision p = std::max(z.precision(), q.precision());
  theta_values none{ball::undefined(p), ball::undefined(p)};
  if (!z.is_bounded() || !detail::not_negative(q) || !certainly_less(q, 1)) return none;
  if (sign_of(q) == certain_sign::zero) return {ball(j <= 2 ? 0 : 1, p), ball(0, p)};
  const bool exact = z.is_exact() && q.is_exact();
  // A set longer than the period, pi or 2 pi: [-4, 4] stands for it, whole periods away.
  if (magnitude::power_of_two(3) <= z.radius()) {
    constexpr precision few_bits = 64;
    const theta_values range = theta(j, ball(0, few_bits).enlarged(magnitude::power_of_two(2)),
                                     q.with_precision(few_bits));
    return {range.value.with_precision(p), range.derivative.with_precision(p)};
  }
  const std::int64_t before_point = std::max<std::int64_t>(
      z.magnitude_upper().is_zero() ? 0 : z.magnitude_upper().log2_floor() + 1, 0);
  if (before_point > (std::int64_t{1} << 24)) return none;
  const auto with = [&](precision bits) {
    const precision working = bits + static_cast<precision>(before_point);
    const auto raised = [working](const ball& x) {
      return x.with_precision(std::max(working, x.precision()));
    };
    return theta_with(j, raised(z), raised(q), working);
  };
  if (!exact) {
    const theta_values w = with(p + 16);
    return {w.value.with_precision(p), w.derivative.with_precision(p)};
  }
  return {detail::to_accuracy(p, [&](precision bits) { return with(bits).value; }),
          detail::to_accuracy(p, [&](precision bits) { return with(bits).derivative; })};
}

}  // namespace polhode
