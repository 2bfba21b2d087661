#include "folded.hpp"

#include <utility>

#include "polhode/arithmetic/text.hpp"
#include "quadrature/parts/sum_of_parts.hpp"

namespace polhode::detail {

std::optional<integral> integrate_over_periods(const integrand& f, const end_point& a,
                                               const end_point& b,
                                               const integrate_options& options) {
  if (!f.folded_at_infinity) return std::nullopt;
  // The rest is of the size of the tail, which may be greater than the integral: once more.
  const precision first = bits_for_digits(options.digits) + 32;
  for (const precision p : {first, 2 * first + 64}) {
    const auto tail = [&](const rational& from, int side) -> std::optional<known_tail> {
      auto one = f.folded_at_infinity(from, side, p);
      if (!one) return std::nullopt;
      return known_tail{one->start, {{std::move(one->folded), one->lower, one->upper}}, one->rest};
    };
    if (auto found = integrate_with_tails(f, a, b, tail, options)) return found;
  }
  return std::nullopt;
}

}  // namespace polhode::detail
