// The limits, the order in which the rules are tried, and an affine map. Each rule has a file in
// rules/; the planner and the sums of those on panels are in panels/.

#include "polhode/quadrature/integrate.hpp"

#include <algorithm>
#include <stdexcept>

#include "polhode/quadrature/rule.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/parts/folded.hpp"
#include "quadrature/parts/sum_of_parts.hpp"
#include "quadrature/parts/turned.hpp"

namespace polhode {

integral_account& integral_account::operator+=(const integral_account& other) {
  evaluations += other.evaluations;
  region_evaluations += other.region_evaluations;
  panels += other.panels;
  most_nodes = std::max(most_nodes, other.most_nodes);
  terms += other.terms;
  precision = std::max(precision, other.precision);
  seconds_for_bounds += other.seconds_for_bounds;
  seconds_for_sums += other.seconds_for_sums;
  for (const quadrature_rule& rule : other.rules) {
    if (std::ranges::find(rules, rule) == rules.end()) rules.push_back(rule);
  }
  return *this;
}

}  // namespace polhode

namespace polhode::detail {

affine_map::affine_map(const end_point& a, const end_point& b)
    : a_(a), b_(b), a_hardware_(a_.at(64)), length_hardware_(length(128)) {}

region affine_map::operator()(const region& t) const {
  if (t.is_in_hardware()) return a_hardware_ + length_hardware_ * t;
  const precision p = t.precision();
  return a_.at(p) + length(p) * t;
}

ball affine_map::operator()(const ball& t) const {
  const precision p = t.precision();
  return a_.at(p) + length(p) * t;
}

namespace {
/// The sum of the parts of an infinite range, or that it diverges; nullopt where there are none, or
/// they do not help.
std::optional<integral> sum_of_parts(const std::vector<part>& parts, const end_point& a,
                                     const end_point& b, const integrate_options& options) {
  if (parts.empty()) return std::nullopt;
  if (auto sum = sum_to_goal(parts, options)) return sum;
  const auto is_infinite = [](const part& p) {
    return p.lower.is_infinite() || p.upper.is_infinite();
  };
  // Two functions over one tail may diverge and cancel. Where there is one, it is f itself: where
  // it diverges, so does the whole.
  const long tails = std::count_if(parts.begin(), parts.end(), is_infinite);
  if (tails != (a.is_infinite() ? 1 : 0) + (b.is_infinite() ? 1 : 0)) return std::nullopt;
  for (const part& p : parts) {
    if (!is_infinite(p)) continue;
    integral found = integrate_function(p.f, p.lower, p.upper, options);
    if (found.why == reason::not_integrable) return found;
  }
  return std::nullopt;
}
}  // namespace

integral integrate_function(const integrand& f, const end_point& a, const end_point& b,
                            const integrate_options& options) {
  if (options.digits < 1) throw std::invalid_argument("integrate: digits must be at least 1");
  if (options.threads < 0) {
    throw std::invalid_argument("integrate: threads must be at least 0 (0: all processors)");
  }
  integral result;
  if (a.form() && b.form() && *a.form() == *b.form()) {
    result.enclosure = ball(0, 64);
    result.verdict = status::certified;
    return result;
  }
  const bool same_infinity = a.infinite_sign() != 0 && a.infinite_sign() == b.infinite_sign();
  if (same_infinity) {
    throw std::invalid_argument("integrate: both limits are the same infinity");
  }
  for (const end_point& end : {a, b}) {
    if (end.infinite_sign() == 0 && !end.at(64).is_bounded()) {
      result.why = reason::not_defined;
      result.obstacle = "a limit is not a number";
      return result;
    }
  }
  const bool infinite = a.infinite_sign() != 0 || b.infinite_sign() != 0;
  if (a.infinite_sign() > 0 || b.infinite_sign() < 0 ||
      (!infinite && certainly_less(b.at(128), a.at(128)))) {
    result = integrate_function(f, b, a, options);
    result.enclosure = -result.enclosure;
    return result;
  }
  if (const quadrature_strategy* insisted = options.rule.strategy()) {
    if (std::optional<integral> found = insisted->attempt(f, a, b, options)) return *found;
    result.why = reason::not_applicable;
    result.obstacle = insisted->need();
    return result;
  }
  if (f.pieces) {
    const std::vector<part> parts = f.pieces(a, b);
    if (!parts.empty()) {
      if (auto sum = sum_to_goal(parts, options)) return *std::move(sum);
    }
  }
  if (infinite && f.scaled) {
    if (auto found = sum_of_parts(f.scaled(a, b), a, b, options)) return *std::move(found);
  }
  for (const quadrature_rule& rule : quadrature_rule::all()) {
    if (!rule.strategy()->is_automatic()) continue;
    std::optional<integral> found = rule.strategy()->attempt(f, a, b, options);
    if (!found) continue;
    if (infinite && found->why == reason::not_analytic) {
      if (auto turned = integrate_over_turned_rays(f, a, b, options)) return *turned;
      if (auto folded = integrate_over_periods(f, a, b, options)) return *folded;
      if (f.with_limits) {
        if (auto sum = sum_of_parts(f.with_limits(a, b), a, b, options)) return *std::move(sum);
      }
    }
    return *found;
  }
  throw std::logic_error("integrate: internal error: no rule attempts everything");
}

}  // namespace polhode::detail
