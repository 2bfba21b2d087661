#include "turned.hpp"

#include <utility>
#include <vector>

#include "quadrature/sum_of_parts.hpp"

namespace polhode::detail {

std::optional<integral> integrate_over_turned_rays(const integrand& f, const end_point& a,
                                                   const end_point& b,
                                                   const integrate_options& options) {
  if (!f.on_turned_rays) return std::nullopt;
  const auto tail = [&](const rational& from, int side) -> std::optional<known_tail> {
    auto rays = f.on_turned_rays(from, side);
    if (!rays) return std::nullopt;
    known_tail result{end_point(rational(side * rays->start)), {}};
    for (integrand& g : rays->parts) {
      result.parts.push_back({std::move(g), end_point(0), end_point::infinity()});
    }
    return result;
  };
  return integrate_with_tails(f, a, b, tail, options);
}

std::optional<integral> integrate_between_turned_rays(const integrand& f, const end_point& a,
                                                      const end_point& b, double least_turns,
                                                      const integrate_options& options) {
  if (!f.between_turned_rays || !a.exact() || !b.exact()) return std::nullopt;
  // On each side of 0 by itself.
  std::vector<std::pair<rational, rational>> sides{{*a.exact(), *b.exact()}};
  if (*a.exact() < 0 && *b.exact() > 0) sides = {{*a.exact(), 0}, {0, *b.exact()}};
  std::vector<part> parts;
  bool any = false;
  for (const auto& [lower, upper] : sides) {
    const auto rays = f.between_turned_rays(lower, upper, least_turns);
    if (!rays) {
      parts.push_back({f, lower, upper});
      continue;
    }
    any = true;
    for (const integrand& g : rays->added) parts.push_back({g, 0, end_point::infinity()});
    for (const integrand& g : rays->subtracted) parts.push_back({g, 0, end_point::infinity(), -1});
    for (const integrand& g : rays->steady) parts.push_back({g, rays->lower, rays->upper});
    if (lower != rays->lower) parts.push_back({f, lower, rays->lower});
    if (upper != rays->upper) parts.push_back({f, rays->upper, upper});
  }
  return any ? sum_to_goal(parts, options) : std::nullopt;
}

}  // namespace polhode::detail
