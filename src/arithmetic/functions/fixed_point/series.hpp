#pragma once

// The two series that exp, sin and cos are computed by, that of e^z and that of 1 - cos(sqrt(z)),
// which halving the argument makes short; and the powers that they and the arc tangent's series are
// summed with.

#include <cstdint>

#include "arithmetic/functions/fixed_point/fraction.hpp"

namespace polhode::detail::fixed_point {

constexpr long most_block = 40;
// More terms would lose more in the limbs that are left out than the errors below count.
constexpr long most_terms = 5000;

/// The sums over k >= 1 of z^k/k! = e^z - 1, of (-1)^(k+1) z^k/(2k)! = 1 - cos(sqrt(z)), of
/// z^k/(2k+1)! = sinh(y)/y - 1 and of (-1)^(k+1) z^k/(2k+1)! = 1 - sin(y)/y with y = sqrt(z).
enum class series { exponential, circular, hyperbolic_sine, sine };

/// Terms of a series that are needed for z < 2^-small: the first one left out is below a unit, and
/// so is the rest. (Of positive terms each is less than half of the one before, so it is 2 units.)
[[nodiscard]] long terms_needed(series s, long small, long w);

/// z, z^2, ..., z^m, and sums of them. A power is cut off at each product: for z <= 1/4 it is less
/// than 2 units too small, as e' <= 1 + 2 (1/4)^(i/2) e for a square and 1 + e/4 for a product.
class power_table {
 public:
  power_table(const limb* z, long w, long m) : w_(w), m_(m), powers_(m * w) {
    mpn_copyi(power(1), z, w);
    for (long i = 2; i <= m; ++i) {
      if (i % 2 == 0) {
        square(power(i), power(i / 2), w);
      } else {
        multiply(power(i), power(i - 1), z, w);
      }
    }
  }
  /// The number of low limbs that may be left out of a sum which is still to be multiplied by z^n,
  /// n the greatest multiple of m up to k, where z < 2^-small: a unit of the limb above them
  /// becomes at most 2^-20 units.
  [[nodiscard]] long low_limbs(long k, long small) const {
    constexpr long spare = 20;
    return std::clamp((small * (k / m_ * m_) - spare) / 64, 0L, w_ - 1);
  }
  /// sum += c z^(k mod m), or less, in the limbs from `low` on.
  void add(number& sum, long k, limb c, bool subtracted, long low = 0) const {
    const long i = k % m_;
    if (i == 0) {
      sum[w_] += subtracted ? -c : c;
    } else if (subtracted) {
      sum[w_] -= mpn_submul_1(sum.data() + low, power(i) + low, w_ - low, c);
    } else {
      sum[w_] += mpn_addmul_1(sum.data() + low, power(i) + low, w_ - low, c);
    }
  }
  /// sum *= z^m where k begins a block. Of the sum the limbs from `low` on are used, of the product
  /// those from next_low <= low on are made.
  void end_block(number& sum, long k, long low = 0, long next_low = 0) const {
    if (k % m_ != 0) return;
    on_size(sum, w_, [&] {
      double_fraction product(w_);
      const long sum_limbs = w_ + 1 - low;
      const long power_limbs = w_ - next_low;
      const limb* const factor = power(m_) + next_low;
      if (sum_limbs >= power_limbs) {
        mpn_mul(product.data(), sum.data() + low, sum_limbs, factor, power_limbs);
      } else {
        mpn_mul(product.data(), factor, power_limbs, sum.data() + low, sum_limbs);
      }
      // Its lowest limb is that of 2^(64 (low + next_low - w)) units.
      mpn_copyi(sum.data() + next_low, product.data() + (w_ - low), w_ + 1 - next_low);
    });
  }

 private:
  [[nodiscard]] limb* power(long i) { return powers_.data() + (i - 1) * w_; }
  [[nodiscard]] const limb* power(long i) const { return powers_.data() + (i - 1) * w_; }

  long w_;
  long m_;
  limbs<24 * few_limbs> powers_;
};

/// sum = the series at z < 2^-small <= 1/4, within 34 units.
///
/// The coefficients are integers c over common denominators D, each the product of a run a..b of
/// factors:
///     sum over k >= a of z^k / (f(a) ... f(k)) = (sum over k = a..b of c_k z^k + rest) / D,
/// c_k = f(k+1) ... f(b), where `rest` is the same sum from b + 1 on. In blocks of m terms the
/// powers below z^m are at hand, and a block is multiplied by z^m to join the next lower one (M. S.
/// Paterson and L. J. Stockmeyer 1973; D. M. Smith 1989).
///
/// Error, in units. A power is less than 2 too small. In a run, S = sum of c_k / D <= 1/f(a) +
/// 1/(f(a) f(a+1)) + ... < 1.72. So the terms of a run are wrong by less than 2 S D < 3.5 D; the
/// sum before a division stays below 1.75 D + 2 < 2^63, each product of it with z^m, itself 2 units
/// wrong, loses less than 3.5 D + 5 and divides the error from before by 16 at least (m >= 2); a
/// run's products together then lose less than 16/15 (3.5 D + 5) < 4 D + 6. With the division, and
/// the error e of the run above,
///     e' < 3.5 + 4 + 6 / D + 1 + e / D < 15 + e / 2 for D >= 2,
/// below 30 for every run with D >= 2; a run with D = 1 would be the factor 1 alone, which never
/// is by itself: it is joined to the run above. With the terms left out, 2 more, it is below 32.
///
/// Where the sum is still to be multiplied by z^n, n a multiple of m, low limbs are left out of it:
/// a unit of the lowest limb in use becomes at most 2^-20 units of the result. There, too, terms,
/// products and divisions lose less than 32 of these units each time. They are at most three for
/// each term, fewer than 2^14, so that together they lose less than 2^14 2^5 2^-20 = 1/2. In all
/// the error is below 34.
void sum_series(number& sum, series s, const limb* z, long w, long small);

}  // namespace polhode::detail::fixed_point
