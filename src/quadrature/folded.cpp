#include "folded.hpp"

#include <vector>

#include "polhode/arithmetic/text.hpp"
#include "quadrature/sum_of_parts.hpp"

namespace polhode::detail {

std::optional<integral> integrate_over_periods(const integrand& f, const end_point& a,
                                               const end_point& b,
                                               const integrate_options& options) {
  if (!f.folded_at_infinity) return std::nullopt;
  // The rest is of the size of the tail, which may be greater than the integral: once more.
  const precision first = bits_for_digits(options.digits) + 32;
  for (const precision p : {first, 2 * first + 64}) {
    std::vector<part> parts;
    magnitude rest;
    end_point lower = a;
    end_point upper = b;
    const auto fold = [&](end_point& end, const end_point& other) {
      const int side = end.infinite_sign();
      if (side == 0) return true;
      const rational from = other.is_infinite() ? rational(0) : bound_beyond(other, side);
      auto tail = f.folded_at_infinity(from, side, p);
      if (!tail) return false;
      parts.push_back({std::move(tail->folded), tail->lower, tail->upper});
      rest = add_up(rest, tail->rest);
      end = tail->start;
      return true;
    };
    if (!fold(upper, a) || !fold(lower, b)) return std::nullopt;
    parts.push_back({f, lower, upper});
    if (auto found = sum_to_goal(parts, options, rest)) return found;
  }
  return std::nullopt;
}

}  // namespace polhode::detail
