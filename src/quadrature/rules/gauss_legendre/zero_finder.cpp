#include "quadrature/rules/gauss_legendre/zero_finder.hpp"

#include <algorithm>
#include <cstddef>

#include "polhode/arithmetic/elementary.hpp"
#include "quadrature/rules/gauss_legendre/proved_zero.hpp"
#include "quadrature/rules/gauss_legendre/taylor_polynomial.hpp"

namespace polhode::detail::legendre {
namespace {

/// A better start by a step of Newton's method, in units of 2^-64; the old one where that leaves
/// (0, 1).
std::uint64_t improved(std::uint64_t argument, const fixed_point_polynomial::values& at) {
  constexpr precision p = 128;
  const ball step = scale(at.value.with_precision(p) / at.slope.with_precision(p), 64);
  const ball target = ball(argument, p) - step.middle();
  if (!target.is_bounded()) return argument;
  mpfr_cell cell(p);
  target.midpoint(cell.get());
  const bool usable =
      mpfr_fits_ulong_p(cell.get(), MPFR_RNDD) != 0 && mpfr_cmp_ui(cell.get(), 1) >= 0;
  return usable ? mpfr_get_ui(cell.get(), MPFR_RNDD) : argument;
}

}  // namespace

std::optional<legendre_zero> zero_finder::found(std::uint64_t start,
                                                fixed_point_polynomial::values at) const {
  for (int attempt = 0; attempt < 12; ++attempt) {
    if (attempt > 0) {
      start = improved(start, at);
      at = polynomial_->at({start}).front();
    }
    // A start that hits the zero tells nothing of its distance: a unit of y_0 at least.
    const double log2_reach = std::max(
        estimated_log2(divide_up(at.value.magnitude_upper(), at.slope.magnitude_lower())), -70.0);
    const auto series = make_series(shape_, start, at, log2_reach + 1, bits_at_work_);
    if (!series) continue;
    if (auto zero = proved_zero(shape_, *series, bits_at_work_)) return zero;
  }
  return std::nullopt;
}

std::vector<std::optional<legendre_zero>> zero_finder::near(
    const std::vector<std::uint64_t>& starts) {
  std::vector<std::optional<legendre_zero>> zeros(starts.size());
  std::vector<std::uint64_t> left;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (few_limbed_) zeros[i] = few_limbed_->near(starts[i]);
    if (!zeros[i]) left.push_back(starts[i]);
  }
  if (left.empty()) return zeros;
  polynomial_.emplace(shape_, bits_at_work_);
  const std::vector<fixed_point_polynomial::values> at = polynomial_->at(left);
  std::size_t next = 0;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (zeros[i]) continue;
    zeros[i] = found(starts[i], at[next++]);
    if (!zeros[i]) break;
  }
  return zeros;
}

}  // namespace polhode::detail::legendre
