#include "turned.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "polhode/arithmetic/text.hpp"
#include "quadrature/approximate.hpp"

namespace polhode::detail {

namespace {

struct part {
  integrand f;
  end_point lower;
  end_point upper;
  int sign = 1;
};

/// Adds the parts beyond a point p >= |from| to the end of that sign, and returns p with that sign.
std::optional<rational> add_rays(std::vector<part>& parts, const integrand& f, const rational& from,
                                 int side) {
  auto rays = f.on_turned_rays(from, side);
  if (!rays) return std::nullopt;
  for (integrand& g : rays->parts) {
    parts.push_back({std::move(g), end_point(0), end_point::infinity()});
  }
  return rational(side * rays->start);
}

/// A rational number that is at least side * x, as near as its bits allow.
rational beyond(const end_point& x, int side) {
  if (x.exact()) return side * *x.exact();
  const ball at = x.at(64);
  return side > 0 ? upper_rational(at) : rational(-lower_rational(at));
}

/// The sum; its enclosure is undefined where a part's is.
integral sum_of(const std::vector<part>& parts, const integrate_options& options,
                integral_account& account) {
  integral result;
  result.enclosure = ball(0, bits_for_digits(options.digits) + 64);
  for (const part& p : parts) {
    const integral found = integrate_function(p.f, p.lower, p.upper, options);
    account += found.account;
    result.enclosure += p.sign * found.enclosure;
    if (!result.enclosure.is_bounded()) break;
  }
  return result;
}

/// The sum, first to few digits for its size, then to what it needs. Returns nullopt where a part
/// has no enclosure, or the goal is not met with twice the digits.
std::optional<integral> sum_to_goal(const std::vector<part>& parts,
                                    const integrate_options& options) {
  integral_account account;
  integrate_options of_parts = options;
  of_parts.rule = quadrature_rule::automatic;
  of_parts.progress = nullptr;
  of_parts.absolute_exponent.reset();
  const double log2_digits = options.goal().log2_relative();
  for (long digits = std::min(options.digits, 6L);;) {
    of_parts.digits = digits;
    integral found = sum_of(parts, of_parts, account);
    if (!found.enclosure.is_bounded()) return std::nullopt;
    if (options.goal().is_met_by(found.enclosure)) {
      found.verdict = status::certified;
      found.account = std::move(account);
      return found;
    }
    if (digits > 2 * options.digits + 8) return std::nullopt;
    const double size = estimated_log2(found.enclosure.magnitude_lower());
    digits = std::isfinite(size) ? std::max(options.digits + 1, digits + 3) : digits * 2;
    if (std::isfinite(size)) {
      const double goal = size - log2_digits - std::log2(static_cast<double>(parts.size())) - 2;
      of_parts.absolute_exponent = std::max(
          static_cast<long>(goal), options.absolute_exponent.value_or(static_cast<long>(goal)));
    }
  }
}

}  // namespace

std::optional<integral> integrate_over_turned_rays(const integrand& f, const end_point& a,
                                                   const end_point& b,
                                                   const integrate_options& options) {
  if (!f.on_turned_rays) return std::nullopt;
  std::vector<part> parts;
  end_point lower = a;
  end_point upper = b;
  if (b.infinite_sign() != 0) {
    const auto p = add_rays(parts, f, a.infinite_sign() != 0 ? rational(0) : beyond(a, 1), 1);
    if (!p) return std::nullopt;
    upper = end_point(*p);
  }
  if (a.infinite_sign() != 0) {
    const auto p = add_rays(parts, f, b.infinite_sign() != 0 ? rational(0) : beyond(b, -1), -1);
    if (!p) return std::nullopt;
    lower = end_point(*p);
  }
  if (!(lower.exact() && upper.exact() && *lower.exact() == *upper.exact())) {
    parts.push_back({f, lower, upper});
  }
  return sum_to_goal(parts, options);
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
