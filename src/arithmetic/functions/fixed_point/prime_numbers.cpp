#include "arithmetic/functions/fixed_point/prime_numbers.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "arithmetic/functions/fixed_point/powers_by_length.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail::fixed_point {

namespace prime_numbers_impl {
namespace {

/// The sum over k in [first, last) of s^k y^-(k - first + 1)/(2k + 1) is t/(b q), with s = 1 or -1,
/// b the product of the 2k + 1, and q = y^(last - first).
struct partial_sum {
  integer t;
  integer b;
};

// Up to so many terms are summed one by one.
constexpr long few_terms = 8;

/// From the last term on: t becomes s^k b y^n + (2k + 1) t with n terms before it.
partial_sum sum_of_few_terms(long first, long last, const powers_by_length& powers,
                             bool alternating) {
  const auto is_negative = [alternating](long k) { return alternating && k % 2 != 0; };
  const auto factor = [](long k) { return static_cast<unsigned long>(2 * k + 1); };
  partial_sum sum{is_negative(last - 1) ? integer(-1) : integer(1), integer(factor(last - 1))};
  for (long k = last - 2; k >= first; --k) {
    sum.t *= factor(k);
    (is_negative(k) ? mpz_submul : mpz_addmul)(sum.t.backend().data(), sum.b.backend().data(),
                                               powers.of(last - 1 - k).backend().data());
    sum.b *= factor(k);
  }
  return sum;
}

/// By halves: t = t_1 b_2 q_2 + t_2 b_1, b = b_1 b_2.
partial_sum sum_of_terms(long first, long last, const powers_by_length& powers, bool alternating) {
  if (last - first <= few_terms) return sum_of_few_terms(first, last, powers, alternating);
  const long middle = first + (last - first) / 2;
  partial_sum left = sum_of_terms(first, middle, powers, alternating);
  partial_sum right = sum_of_terms(middle, last, powers, alternating);
  left.t *= right.b;
  left.t *= powers.of(last - middle);
  right.t *= left.b;
  left.t += right.t;
  left.b *= right.b;
  return left;
}

/// 2^bits atan(1/x), or atanh(1/x) if the terms do not alternate, within 2: x times the sum from 0
/// to N of s^k y^-(k+1)/(2k+1), y = x^2. The first term left out is below y^-N/x <= 2^-bits/x, the
/// rest of them is below 2^-bits, and cutting off loses less than 1.
integer inverse_tangent(std::int64_t x, bool alternating, long bits) {
  const long bits_of_term =
      2 * (static_cast<long>(std::bit_width(static_cast<std::uint64_t>(x))) - 1);
  const long terms = (bits + bits_of_term - 1) / bits_of_term;
  const integer whole = x;
  powers_by_length powers(whole * whole);
  for (long n = 1; n <= few_terms; ++n) (void)powers.make(n);
  integer divisor = powers.make(terms);
  partial_sum sum = sum_of_terms(0, terms, powers, alternating);
  sum.t *= whole;
  sum.t <<= static_cast<unsigned long>(bits);
  divisor *= sum.b;
  sum.t /= divisor;
  return std::move(sum.t);
}

struct formula {
  const std::array<std::int64_t, prime_count>& arguments;
  const prime_matrix& weights;
  bool alternating;
};

/// The combinations are wrong by twice the sum of their weights at most, which is below 2^33. Where
/// that leaves the last limb undecided a few more limbs decide it: the numbers are irrational.
std::shared_ptr<const prime_numbers> make(const formula& f, long w) {
  constexpr std::int64_t most_error = std::int64_t{1} << 33;
  for (long more = 1;; ++more) {
    const long bits = 64 * (w + more);
    std::array<integer, prime_count> terms;
    for (std::size_t k = 0; k < prime_count; ++k) {
      terms[k] = inverse_tangent(f.arguments[k], f.alternating, bits);
    }
    auto values = std::make_unique<limb[]>(prime_count * static_cast<std::size_t>(w + 1));
    bool decided = true;
    for (std::size_t j = 0; j < prime_count && decided; ++j) {
      integer sum = 0;
      std::int64_t weights = 0;
      for (std::size_t k = 0; k < prime_count; ++k) {
        sum += terms[k] * f.weights[j][k];
        weights += std::abs(f.weights[j][k]);
      }
      if (2 * weights >= most_error) throw std::logic_error("a formula's weights are too great");
      integer low = sum - most_error;
      integer high = sum + most_error;
      low >>= static_cast<unsigned long>(64 * more);
      high >>= static_cast<unsigned long>(64 * more);
      decided = low == high;
      // Positive numbers below 2^64, the rest of their place being zero.
      const auto size = mpz_size(low.backend().data());
      if (low < 0 || size > static_cast<std::size_t>(w + 1)) {
        throw std::logic_error("a prime's logarithm or angle is out of its range");
      }
      mpn_copyi(values.get() + j * static_cast<std::size_t>(w + 1),
                mpz_limbs_read(low.backend().data()), static_cast<mp_size_t>(size));
    }
    if (decided) return std::make_shared<const prime_numbers>(w, std::move(values));
  }
}

/// The numbers with the most limbs that were asked for; others' are the same ones cut off.
class kept_numbers {
 public:
  explicit kept_numbers(const formula& f) : formula_(f) {}
  std::shared_ptr<const prime_numbers> with(long w) {
    const std::lock_guard lock(mutex_);
    if (!known_) {
      known_ = make(formula_, w);
    } else if (known_->limbs_of_fraction() < w) {
      // By steps of a quarter, so that many steps of little more cost little more.
      known_ = make(formula_, std::max(w, known_->limbs_of_fraction() * 5 / 4));
    }
    return known_;
  }

 private:
  formula formula_;
  std::mutex mutex_;
  std::shared_ptr<const prime_numbers> known_;
};

}  // namespace
}  // namespace prime_numbers_impl

std::shared_ptr<const prime_numbers> logarithms_of_primes(long w) {
  using namespace prime_numbers_impl;
  static kept_numbers known({logarithm_arguments, logarithm_weights, false});
  return known.with(w);
}

std::shared_ptr<const prime_numbers> angles_of_primes(long w) {
  using namespace prime_numbers_impl;
  static kept_numbers known({angle_arguments, angle_weights, true});
  return known.with(w);
}

}  // namespace polhode::detail::fixed_point
