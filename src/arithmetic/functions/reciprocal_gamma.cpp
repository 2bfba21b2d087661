#include "reciprocal_gamma.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/functions/fixed_point/fraction.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/special_functions.hpp"
#include "rising_product.hpp"

namespace polhode::detail {

namespace reciprocal_gamma_impl {
namespace {

using namespace fixed_point;

/// About the natural logarithm of 2 B/R^K: a choice, which decides nothing but the time.
double log_of_bound(double radius, double terms) {
  return std::log(8.0 / 3) + std::numbers::pi * radius / 2 + std::lgamma(2 * radius + 1) -
         std::lgamma(radius + 1) - terms * std::log(radius);
}
/// The R with about the least bound; any R >= 1 has one.
long radius_for(std::size_t terms) {
  const auto n = static_cast<double>(terms);
  long radius = 1;
  while (log_of_bound(static_cast<double>(radius + 1), n) <
         log_of_bound(static_cast<double>(radius), n)) {
    ++radius;
  }
  return radius;
}

/// At least 2 B/R^K for an R.
magnitude bound_of_rest(std::size_t terms) {
  const long radius = radius_for(terms);
  // e^(pi/2) < 4.811.
  const magnitude e_to_half_pi =
      divide_up(magnitude::from_integer_up(4811), magnitude::from_integer_up(1000));
  magnitude bound = divide_up(magnitude::from_integer_up(8), magnitude::from_integer_up(3));
  for (long i = 1; i <= radius; ++i) {
    bound = multiply_up(bound, magnitude::from_integer_up(static_cast<std::uint64_t>(radius + i)));
    bound = multiply_up(bound, e_to_half_pi);
  }
  const magnitude divisor = magnitude::from_integer_up(static_cast<std::uint64_t>(radius));
  for (std::size_t i = 0; i < terms; ++i) bound = divide_up(bound, divisor);
  return bound;
}

/// d_0, d_1, ... with so many bits.
std::vector<ball> taylor_coefficients(std::size_t terms, precision bits) {
  std::vector<ball> s(std::max<std::size_t>(terms, 2));  // -psi(1 + t) = s_1 + s_2 t + ...
  set_midpoint(s[1], bits, {}, [](mpfr_ptr value) { return mpfr_const_euler(value, MPFR_RNDN); });
  for (std::size_t j = 2; j < terms; ++j) {
    s[j] = zeta(j, bits);
    if (j % 2 == 0) s[j] = -s[j];
  }
  std::vector<ball> d{ball(1, bits)};
  for (std::size_t k = 1; k < terms; ++k) {
    ball sum(0, bits);
    for (std::size_t j = 1; j <= k; ++j) fma(sum, s[j], d[k - j], sum);
    d.push_back(sum / static_cast<long>(k));
  }
  return d;
}

/// About the number of terms for which the rest is below 2^-bits for |t| <= 1/2.
std::size_t terms_for(precision bits) {
  const double wanted = -static_cast<double>(bits) * std::numbers::ln2;
  std::size_t terms = 8;
  while (true) {
    const auto radius = static_cast<double>(radius_for(terms));
    const auto n = static_cast<double>(terms);
    if (log_of_bound(radius, n) - n * std::numbers::ln2 < wanted) return terms;
    terms += 1 + terms / 16;
  }
}

/// d_1, d_2, ... as fractions of w limbs, each within two units, all below 1 in size.
struct series_in_limbs {
  long terms = 0;  // d_0 among them
  std::vector<limb> sizes;
  std::vector<bool> signs;  // true where d_k < 0

  [[nodiscard]] const limb* size(long k, long w) const { return sizes.data() + (k - 1) * w; }
};

series_in_limbs make_series(long w) {
  constexpr precision spare = 32;
  std::size_t terms = terms_for(64 * w);
  const auto is_below_a_unit = [w](std::size_t n) {
    return scale(bound_of_rest(n), -static_cast<std::int64_t>(n)) <=
           magnitude::power_of_two(-64 * w);
  };
  while (!is_below_a_unit(terms)) ++terms;
  const std::vector<ball> d = taylor_coefficients(terms, 64 * w + spare);
  series_in_limbs result;
  result.terms = static_cast<long>(terms);
  result.sizes.resize((terms - 1) * static_cast<std::size_t>(w));
  result.signs.resize(terms);
  for (std::size_t k = 1; k < terms; ++k) {
    if (!(d[k].magnitude_upper() < magnitude::power_of_two(0)) ||
        d[k].radius() > magnitude::power_of_two(-64 * w)) {
      throw std::logic_error("1/Gamma: a coefficient of its series is not below 1, or not known");
    }
    const mpfr_srcptr middle = ball_access::first(d[k]);
    number x(w);
    load(x, middle, mpfr_get_exp(middle), w);
    std::copy_n(x.data(), w, result.sizes.begin() + static_cast<std::ptrdiff_t>(k - 1) * w);
    result.signs[k] = mpfr_sgn(middle) < 0;
  }
  return result;
}

/// Kept for later calls; any thread may ask.
const series_in_limbs& series_for(long w) {
  static std::mutex mutex;
  static std::map<long, std::unique_ptr<const series_in_limbs>> known;
  const std::lock_guard lock(mutex);
  std::unique_ptr<const series_in_limbs>& found = known[w];
  if (!found) found = std::make_unique<const series_in_limbs>(make_series(w));
  return *found;
}

/// A number with a sign, s * {size, w + 1}.
struct signed_number {
  number size;
  bool negative = false;

  /// Adds a fraction with that sign.
  void add(const limb* y, bool y_negative, long w) {
    if (negative == y_negative) {
      size[w] += mpn_add_n(size.data(), size.data(), y, w);
    } else if (size[w] != 0 || mpn_cmp(size.data(), y, w) >= 0) {
      size[w] -= mpn_sub_n(size.data(), size.data(), y, w);
    } else {
      mpn_sub_n(size.data(), y, size.data(), w);
      negative = y_negative;
    }
  }
};

/// sum *= t for a fraction t, of the limbs of the sum from `low` on, within two units of the limb
/// `low`: one for the limbs of t that are left out, and one for the end of the product.
void multiply_above(number& sum, const limb* t, long low, long w) {
  long high = w + 1;
  while (high > low && sum[high - 1] == 0) --high;
  mpn_zero(sum.data(), low);
  const long n = high - low;
  if (n == 0) return;
  double_fraction product(w);
  if (n > w) {  // only where sum >= 1 and low is 0
    mpn_mul(product.data(), sum.data(), n, t, w);
    mpn_copyi(sum.data(), product.data() + w, n);
    return;
  }
  mpn_mul_n(product.data(), sum.data() + low, t + (w - n), n);
  mpn_copyi(sum.data() + low, product.data() + n, n);
}

/// r = 1/Gamma(1 + t) at a number t, |t| <= 1/2, with w limbs.
///
/// Horner's scheme, S_k = d_k + t S_(k+1), |S_k| <= 2, as all |d_k| <= 1. In S_k the limbs below
/// the one of floor(k/64) are left out: a unit u_k of that limb becomes |t|^k u_k <= 2^-k 2^(64
/// floor(k/64)) units of the result. A step adds an error of 7 u_k at most: 3 from the product and
/// from the limbs of S_(k+1) that are left out, 2 from t, which is cut off (times |S|), 2 from d_k.
/// Over the 64 k that share their lowest limb the sum of the factors 2^-k 2^(64 floor(k/64)) is
/// below 2, so that these steps add up to 14 units at most. The terms left out are below a unit.
bool near_reciprocal_gamma(mpfr_ptr r, mpfr_srcptr t, long w, magnitude& error) {
  const series_in_limbs& series = series_for(w);
  number size(w);
  load(size, t, mpfr_get_exp(t), w);
  const bool t_negative = mpfr_sgn(t) < 0;
  signed_number sum{number(w)};
  mpn_zero(sum.size.data(), w + 1);
  for (long k = series.terms - 1; k >= 0; --k) {
    multiply_above(sum.size, size.data(), std::min(k / 64, w - 1), w);
    sum.negative = sum.negative != t_negative;
    if (k > 0) {
      sum.add(series.size(k, w), series.signs[static_cast<std::size_t>(k)], w);
    }
  }
  // d_0 = 1 is greater than the rest.
  if (sum.negative) mpn_neg(sum.size.data(), sum.size.data(), w + 1);
  ++sum.size[w];
  const auto blocks = static_cast<std::uint64_t>((series.terms + 63) / 64);
  return store(r, sum.size, w, 1, 0, 14 * blocks + 1, error);
}

}  // namespace
}  // namespace reciprocal_gamma_impl

ball reciprocal_gamma_by_terms(const ball& t, std::size_t terms) {
  using namespace reciprocal_gamma_impl;
  const std::vector<ball> d = taylor_coefficients(terms, t.precision());
  ball sum(0, t.precision());
  for (std::size_t k = terms; k-- > 0;) fma(sum, sum, t, d[k]);
  magnitude rest = bound_of_rest(terms);
  for (std::size_t k = 0; k < terms; ++k) rest = multiply_up(rest, t.magnitude_upper());
  return sum.enlarged(rest);
}

std::optional<ball> gamma_by_taylor_series(const ball& x, precision p) {
  using namespace reciprocal_gamma_impl;
  // Beyond, the coefficients take long to make; and Stirling's series needs no product.
  constexpr precision most_bits = 448;
  const double about = mpfr_get_d(ball_access::first(x), MPFR_RNDN);
  if (p > most_bits || !(about < 8 + static_cast<double>(p) / 8)) return std::nullopt;
  const auto n = static_cast<long>(std::nearbyint(about));
  constexpr precision guard = 16;
  constexpr precision more_in_limbs = 22;
  constexpr mpfr_exp_t small = 64;
  const precision bits = p + guard;
  const precision own = x.precision();
  // t = x - n has not more bits than these.
  if (own > 4 * most_bits || (n != 0 && mpfr_get_exp(ball_access::first(x)) < -small)) {
    return std::nullopt;
  }
  const ball t = x.with_precision(own + small) - n;
  if (!t.is_exact() || !(t.magnitude_upper() <= magnitude::power_of_two(-1))) return std::nullopt;
  ball reciprocal(1, bits);
  if (sign_of(t) != certain_sign::zero) {
    mpfr_cell value(bits);
    magnitude error;
    const long w = (bits + more_in_limbs + 63) / 64;
    if (!near_reciprocal_gamma(value.get(), ball_access::first(t), w, error)) return std::nullopt;
    ball_access::first(reciprocal) = std::move(value);
    ball_access::finish(reciprocal, 0, error);
  }
  const ball value = 1 / reciprocal;
  // Gamma(x) = Gamma(1 + t) (1 + t)(2 + t)...(n - 1 + t), or Gamma(1 + t)/t for n = 0.
  if (n == 0) return value / x.with_precision(std::max(bits, own));
  return value * rising_product((t + 1).with_precision(bits), n - 1);
}

}  // namespace polhode::detail
