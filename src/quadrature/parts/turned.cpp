#include "turned.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "quadrature/parts/sum_of_parts.hpp"

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
  if (!f.between_turned_rays) return std::nullopt;
  // Rays start at rational numbers, of which there is one beside each end that is none. A number of
  // more bits is far beyond those that programs compute with.
  constexpr double most_bits = 10000;
  const auto near = [&](const end_point& x) -> std::optional<ball> {
    const double size = estimated_log2(x.at(64).magnitude_upper());
    if (!(size < most_bits)) return std::nullopt;
    return x.at(64 + static_cast<precision>(std::max(0.0, size)));
  };
  const auto near_a = near(a);
  const auto near_b = near(b);
  if (!near_a || !near_b) return std::nullopt;
  const rational first = a.exact() ? *a.exact() : upper_rational(*near_a);
  const rational last = b.exact() ? *b.exact() : lower_rational(*near_b);
  if (!(first < last)) return std::nullopt;
  // On each side of 0 by itself.
  std::vector<std::pair<rational, rational>> sides{{first, last}};
  if (first < 0 && last > 0) sides = {{first, 0}, {0, last}};
  std::vector<std::optional<rays_of_range>> rays_of_sides;
  rays_of_sides.reserve(sides.size());
  for (const auto& [lower, upper] : sides) {
    rays_of_sides.push_back(f.between_turned_rays(lower, upper, least_turns));
  }
  const auto has_rays = [](const auto& rays) { return rays.has_value(); };
  if (std::ranges::none_of(rays_of_sides, has_rays)) return std::nullopt;
  std::vector<part> parts;
  if (!a.exact()) parts.push_back({f, a, first});
  if (!b.exact()) parts.push_back({f, last, b});
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto& [lower, upper] = sides[i];
    const auto& rays = rays_of_sides[i];
    if (!rays) {
      parts.push_back({f, lower, upper});
      continue;
    }
    for (const integrand& g : rays->added) parts.push_back({g, 0, end_point::infinity()});
    for (const integrand& g : rays->subtracted) parts.push_back({g, 0, end_point::infinity(), -1});
    for (const integrand& g : rays->steady) parts.push_back({g, rays->lower, rays->upper});
    if (lower != rays->lower) parts.push_back({f, lower, rays->lower});
    if (upper != rays->upper) parts.push_back({f, rays->upper, upper});
  }
  return sum_to_goal(parts, options);
}

std::optional<integral> integrate_by_exponential(const integrand& f, const end_point& a,
                                                 const end_point& b, double least_turns,
                                                 const integrate_options& options) {
  if (!f.by_exponential) return std::nullopt;
  const auto in_u = f.by_exponential(a, b);
  if (!in_u) return std::nullopt;
  const auto& [g, lower, upper] = *in_u;
  if (lower.is_infinite() || upper.is_infinite()) {
    integral found = integrate_function(g, lower, upper, options);
    return found.verdict == status::certified ? std::optional(std::move(found)) : std::nullopt;
  }
  if (certainly_less(lower.at(64), upper.at(64))) {
    return integrate_between_turned_rays(g, lower, upper, least_turns, options);
  }
  auto found = integrate_between_turned_rays(g, upper, lower, least_turns, options);
  if (found) found->enclosure = -found->enclosure;
  return found;
}

}  // namespace polhode::detail
