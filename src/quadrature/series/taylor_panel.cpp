#include "taylor_panel.hpp"

#include <utility>

namespace polhode::detail {

std::optional<std::vector<taylor_panel>> cut_to(const smooth_range& range,
                                                const std::vector<taylor_panel>& panels) {
  std::vector<taylor_panel> result;
  for (taylor_panel p : panels) {
    const exact_interval all = p.interval();
    // Panels before the lower end are left out, and those after the upper end.
    if (!range.lower.exact() && result.empty()) {
      const std::optional<int> at_upper = side_of(range.lower, *all.upper);
      if (!at_upper) return std::nullopt;
      if (*at_upper > 0) continue;
      const std::optional<int> at_lower = side_of(range.lower, *all.lower);
      if (!at_lower) return std::nullopt;
      p.from_lower = *at_lower > 0;
    }
    if (!range.upper.exact()) {
      const std::optional<int> at_lower = side_of(range.upper, *all.lower);
      if (!at_lower) return std::nullopt;
      if (*at_lower < 0) break;
      const std::optional<int> at_upper = side_of(range.upper, *all.upper);
      if (!at_upper) return std::nullopt;
      p.to_upper = *at_upper < 0;
    }
    result.push_back(std::move(p));
  }
  return result;
}

std::vector<taylor_panel> halves_of(const taylor_panel& p) {
  const rational half = p.radius / 2;
  if (!p.at_end) return {{p.centre - half, half}, {p.centre + half, half}};
  const taylor_panel inner{p.centre, half, true};
  const rational quarter = abs(rational(half / 2));
  const taylor_panel outer{p.centre + half + half / 2, quarter};
  return p.radius > 0 ? std::vector{inner, outer} : std::vector{outer, inner};
}

}  // namespace polhode::detail
