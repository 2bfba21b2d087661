#include "bernoulli.hpp"

#include <algorithm>
#include <map>
#include <mutex>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {

namespace bernoulli_impl {
namespace {

/// The tangent numbers T_1, T_2, ..., with tan x = sum over k of T_k x^(2k-1)/(2k-1)!, by the
/// algorithm TangentNumbers of R. P. Brent and D. Harvey, Fast computation of Bernoulli, Tangent
/// and Secant numbers (2011), section 6: whole numbers, all of them exact.
std::vector<integer> tangent_numbers(std::size_t count) {
  std::vector<integer> t(count + 1);
  t[1] = 1;
  for (std::size_t k = 2; k <= count; ++k) t[k] = t[k - 1] * static_cast<unsigned long>(k - 1);
  for (std::size_t k = 2; k <= count; ++k) {
    for (std::size_t j = k; j <= count; ++j) {
      t[j] *= static_cast<unsigned long>(j - k + 2);
      mpz_addmul_ui(t[j].backend().data(), t[j - 1].backend().data(), j - k);
    }
  }
  return t;
}

/// The tangent numbers so far, and the constants by their precision.
struct table {
  std::mutex mutex;
  std::vector<integer> tangents;
  std::map<precision, std::shared_ptr<const stirling_constants>> constants;
};
table& the_table() {
  static table all;
  return all;
}

/// Hypothesis: the table's mutex is held.
const integer& tangent_number(table& known, std::size_t k) {
  constexpr std::size_t first = 32;
  if (known.tangents.size() <= k) known.tangents = tangent_numbers(std::max(first, k + k / 2));
  return known.tangents[k];
}

/// 4^k (4^k - 1).
integer power_product(std::size_t k) {
  const integer four_to_k = integer(1) << (2 * k);
  return four_to_k * (four_to_k - 1);
}

}  // namespace
}  // namespace bernoulli_impl

// B_2k = (-1)^(k-1) 2k T_k/(4^k (4^k - 1)) (DLMF 24.15.4, with T_k its T_(2k-1)).
rational bernoulli_number(std::size_t k) {
  using namespace bernoulli_impl;
  table& known = the_table();
  const std::lock_guard lock(known.mutex);
  const integer numerator = tangent_number(known, k) * static_cast<unsigned long>(2 * k);
  return {k % 2 == 0 ? integer(-numerator) : numerator, power_product(k)};
}

std::shared_ptr<const stirling_constants> stirling_constants_for(std::size_t count, precision p) {
  using namespace bernoulli_impl;
  constexpr precision step = 64;
  constexpr std::size_t most_kept = 32;
  const precision rounded = (p + step - 1) / step * step;
  table& known = the_table();
  const std::lock_guard lock(known.mutex);
  if (known.constants.size() > most_kept) known.constants.clear();
  std::shared_ptr<const stirling_constants>& found = known.constants[rounded];
  if (found && found->coefficients.size() >= count) return found;
  auto made = std::make_shared<stirling_constants>();
  if (found) *made = *found;
  if (!found) made->half_log_two_pi = scale(log(scale(pi(rounded), 1)), -1);
  for (std::size_t k = made->coefficients.size() + 1; k <= count; ++k) {
    // B_2k/(2k (2k - 1)) = (-1)^(k-1) T_k/((2k - 1) 4^k (4^k - 1)).
    const ball c = ball(tangent_number(known, k), rounded) /
                   ball(power_product(k) * static_cast<unsigned long>(2 * k - 1), rounded);
    made->coefficients.push_back(k % 2 == 0 ? -c : c);
  }
  found = std::move(made);
  return found;
}

}  // namespace polhode::detail
