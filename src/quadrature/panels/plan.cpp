// The plan of an integral over panels: which panels, each with its proof and its rule.

#include <algorithm>
#include <array>
#include <cmath>

#include "ellipse_bounds.hpp"
#include "plan.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "quadrature/base/approximate.hpp"
#include "quadrature/pieces/breaks.hpp"
#include "quadrature/rules/rule_estimates.hpp"
#include "quadrature/rules/rules.hpp"

namespace polhode::detail {

const panel_rule& panel_rule_of(const quadrature_rule& chosen) {
  const auto* rule = dynamic_cast<const panel_rule*>(chosen.strategy());
  return rule != nullptr ? *rule : gauss_legendre_panels();
}

namespace {

/// How often a segment may be halved.
long deepest_level(const std::vector<segment>& segments, const integrate_options& options) {
  if (options.most_depth) return *options.most_depth;
  // Along a path nothing is gained by coming nearer to a cut or a pole that is met.
  const double least = !segments.empty() && segments.front().along ? 160 : 420;
  return static_cast<long>(least + 1.1 * options.goal().log2_relative());
}

}  // namespace

scaled_segments::scaled_segments(const std::vector<segment>& all) : segments(all) {
  for (const segment& s : segments) {
    // With as many bits as tell a short range's ends apart.
    precision p = 64;
    while (p < 40'000 && scale_of(s, p).magnitude_lower().is_zero()) p *= 2;
    log2_scales.push_back(estimated_log2(scale_of(s, p).magnitude_upper()));
  }
}

planner::planner(const scaled_segments& of, const integrate_options& options,
                 const range_knowledge& known, double log2_size, long& region_evaluations)
    : segments_(of.segments),
      log2_scales_(of.log2_scales),
      options_(options),
      known_(known),
      rule_(panel_rule_of(options.rule)),
      log2_size_(log2_size),
      region_evaluations_(region_evaluations),
      deepest_(deepest_level(of.segments, options)) {}

double planner::log2_of_typical(const panel& p, double log2_goal) const {
  // The middle and two points beside it, so that a zero of F does not mislead; with more bits where
  // F cannot tell them from a singularity nearby.
  double largest = -infinite;
  const auto most = static_cast<precision>(8 * std::max(log2_size_ - log2_goal, 48.0));
  for (precision wide = 96 + 2 * p.level; wide == 96 + 2 * p.level || wide < most; wide *= 4) {
    const auto f = evaluator_of(segments_[p.segment], wide);
    const ball centre(p.centre, wide);
    bool defined = false;
    for (const long offset : {-5, 0, 3}) {
      const complex_ball value = f(centre + scale(ball(offset, wide), -p.level - 4));  // exact
      if (!value.is_bounded()) continue;
      defined = true;
      largest = std::max(largest, estimated_log2(value.magnitude_upper()));
    }
    if (defined) break;
  }
  return largest;
}

/// log2 of the goal for the mean of F over the panel.
double planner::mean_goal(const panel& p, double log2_goal) const {
  return log2_goal - log2_scales_[p.segment] + static_cast<double>(p.level);
}

/// A panel that needs no more nodes is not worth halving.
double planner::nodes_accepted(const panel& p, double log2_goal) const {
  return 0.42 * std::max(p.log2_typical - mean_goal(p, log2_goal), 8.0) + 10;
}

/// The best ellipse found around the panel, in p. The number of nodes it needs for a mean of F to
/// 2^goal; infinite where none was found.
double planner::find_ellipse(panel& p, double goal, ellipse_bounds& bounds) const {
  // The price of a region's evaluation in those of f at a node.
  const double bits = std::max(p.log2_typical - goal, 8.0);
  const int halves = segments_[p.segment].along ? 2 : 1;
  const double region_price = halves / (0.3 + std::pow(bits / 300, 1.5));
  const double most_nodes = std::min(2 * bits, bits + 32) + 16;
  double best_nodes = infinite;
  const auto consider = [&](double rho) {
    const ellipse e(rho);
    const double log2_limit =
        std::clamp(goal + 2 * std::log2(rho) * std::min(most_nodes, best_nodes), -greatest_log2,
                   greatest_log2);
    const std::optional<magnitude> inside =
        bounds.inside(e, magnitude::power_of_two(static_cast<long>(log2_limit)));
    if (!inside) return false;
    magnitude supremum = *inside;
    double nodes = estimated_gauss_nodes(rho, estimated_log2(supremum), goal);
    for (int arcs = 6; arcs * region_price < 0.5 * nodes && arcs <= 1024; arcs *= 2) {
      supremum = min(supremum, bounds.on_boundary(e, arcs));
      const double fewer = estimated_gauss_nodes(rho, estimated_log2(supremum), goal);
      const bool worthwhile = nodes - fewer > arcs * region_price;
      nodes = fewer;
      if (!worthwhile) break;
    }
    if (nodes < best_nodes) {
      best_nodes = nodes;
      p.rho = rho;
      p.supremum = supremum;
    }
    return std::isfinite(nodes) && nodes <= best_nodes;
  };
  constexpr double first = 3;
  constexpr double step = 1.5;
  if (consider(first)) {
    double rho = first;
    while (rho < 1e4 && consider(rho * step)) rho *= step;
  } else {
    consider(2.2);
  }
  // Between the steps, while what may be saved is more than the price of some tiles and arcs.
  constexpr double regions_of_step = 12;
  for (double finer = std::sqrt(step); finer > 1.02; finer = std::sqrt(finer)) {
    const double saved = best_nodes * (1 - std::log2(p.rho) / std::log2(p.rho * finer));
    if (!std::isfinite(best_nodes) || saved < regions_of_step * region_price) break;
    consider(p.rho * finer);
  }
  return best_nodes;
}

/// How the panel's integral is to be had, in p. The number of nodes that takes; infinite where no
/// way was found.
double planner::try_panel(panel& p, double log2_goal) {
  const segment& s = segments_[p.segment];
  p.log2_typical = log2_of_typical(p, log2_goal);
  const panel_regions f(s, p, region_evaluations_);
  const double goal = mean_goal(p, log2_goal);
  // So small that the bound is enough.
  const region over_panel = f(double_interval(-1.0, 1.0), double_interval(0));
  p.is_analytic = over_panel.is_analytic();
  const double most = estimated_log2(over_panel.magnitude_upper());
  if (most <= goal) {
    p.closed_by = at_most(s, over_panel.magnitude_upper());
    return 0;
  }
  // Where points of the panel are too close to an end for the samples, the bound stands for them.
  if (!std::isfinite(p.log2_typical)) p.log2_typical = std::isfinite(most) ? most : goal + 64;
  constexpr long short_level = 8;  // of such a panel smaller tiles tell little more than the whole
  ellipse_bounds bounds(f, 24, s.along.has_value(), p.suspect);
  if (over_panel.is_analytic() || p.level < short_level) {
    const double nodes = find_ellipse(p, goal, bounds);
    if (std::isfinite(nodes)) return nodes;
    p.suspect = bounds.suspect();
  } else {
    bounds.note(over_panel);
  }
  // Where F is available on a real panel, or on smaller ones, ellipses around these may be, too.
  const bool smaller_may_do = !s.along && over_panel.why() != obstacle::unknown;
  hopeless_ = bounds.report().why == obstacle::unknown && !smaller_may_do;
  plan_.obstacle = in_words(bounds.report());
  // So short that the range of F over it is enough. It says nothing of F being analytic, which it
  // must be along a path, but for the ends, and where it is continued.
  const bool need_not_be_analytic = !s.continued && (!s.along || p.is_at_end());
  const bool may_be_range = over_panel.is_analytic() || need_not_be_analytic;
  if (p.level >= short_level && may_be_range) {
    const rational half = p.half_length();
    const precision wide = 96 + p.level;
    const ball t =
        hull(ball(rational(p.centre - half), wide), ball(rational(p.centre + half), wide));
    const complex_ball range = evaluator_of(s, wide)(t);
    if (range.is_bounded() && estimated_log2(radius_of(range)) <= goal - 4) {
      p.closed_by = range;
      p.by_range_only = true;
      return 0;
    }
  }
  return infinite;
}

panel_plan planner::plan(double log2_goal) {
  plan_ = {};
  planned_nodes_ = 0;
  ranges_in_a_row_ = 0;
  short_panels_ = 0;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    plan_.what = plan_segment(i, log2_goal - 6);
    if (plan_.what != outcome::done) return std::move(plan_);
  }
  if (!points_.empty()) plan_.what = outcome::cut_needed;
  return std::move(plan_);
}

/// By the trapezoidal rule where that applies and does not need more nodes.
panel_plan::outcome planner::plan_segment(std::size_t index, double log2_goal) {
  panel whole;
  whole.segment = index;
  whole.centre = rational(1, 2);
  whole.rule = &rule_;
  const bool insisted = options_.rule == quadrature_rule::trapezoid;
  const bool is_possible = insisted || options_.rule.is_automatic();
  if (rule_.has_ends_as_nodes()) {
    const auto f = segments_[index].evaluator(64);
    if (!f(ball(0, 64)).is_bounded() || !f(ball(1, 64)).is_bounded()) {
      plan_.obstacle = "the rule " + std::string(rule_.name()) +
                       " needs values at the ends of the range, where the integrand has none";
      return outcome::not_applicable;
    }
  }
  if (!segments_[index].equidistant || !is_possible) {
    if (!insisted) return plan_panel(std::move(whole), log2_goal);
    plan_.obstacle =
        "the trapezoidal rule needs an integrand that is proved periodic over the range, "
        "or even about both limits";
    return outcome::not_applicable;
  }
  panel on_circle = whole;
  on_circle.log2_typical = log2_of_typical(whole, log2_goal);
  const double accepted = nodes_accepted(on_circle, log2_goal);
  const auto most_evaluations = static_cast<double>(options_.most_evaluations);
  const double most_nodes = insisted ? most_evaluations : std::min(20 * accepted, most_evaluations);
  const std::optional<periodic_strip> found =
      find_strip(segments_[index], mean_goal(whole, log2_goal), most_nodes, region_evaluations_);
  const double nodes = found ? found->nodes : 0;
  if (found) {
    on_circle.strip = found;
    on_circle.supremum = found->supremum;
  }
  const std::size_t panels_before = plan_.panels.size();
  const double nodes_before = planned_nodes_;
  if (insisted && !found) {
    plan_.obstacle =
        "no strip was found in which the integrand is proved analytic, so wide that the "
        "trapezoidal rule takes few enough nodes";
    return outcome::not_applicable;
  }
  if (!insisted && (!found || nodes > accepted)) {
    const outcome o = plan_panel(std::move(whole), log2_goal);
    const bool fewer = o == outcome::done && planned_nodes_ - nodes_before < nodes;
    if (!found || fewer || !points_.empty()) return o;
  }
  plan_.panels.resize(panels_before);
  planned_nodes_ = nodes_before + nodes;
  plan_.panels.push_back(std::move(on_circle));
  const auto regions = static_cast<double>(region_evaluations_);
  return planned_nodes_ + regions > most_evaluations ? outcome::too_many_evaluations
                                                     : outcome::done;
}

/// From one end to the other; with what is beside it, as far as the segment reaches, where `around`
/// is above 1.
ball planner::range_of(const panel& p, long around) const {
  const segment& s = segments_[p.segment];
  const rational half = p.half_length() * around;
  const rational low = std::max(rational(p.centre - half), rational(0));
  const rational high = std::min(rational(p.centre + half), rational(1));
  const auto& x = s.place ? s.place : s.position;
  return hull(x(ball(low, 192)), x(ball(high, 192)));
}

/// A rational number of small denominator in a range of x that is not known yet; at most one of a
/// few neighbouring panels has the same.
std::optional<rational> planner::point_in(const ball& both, long greatest_denominator) const {
  if (!both.is_bounded()) return std::nullopt;
  const rational q = simplest_between(lower_rational(both), upper_rational(both));
  if (denominator(q) > greatest_denominator) return std::nullopt;
  const bool known =
      std::find(known_.points.begin(), known_.points.end(), q) != known_.points.end();
  return known ? std::nullopt : std::optional(q);
}

/// Ranges over panels as short as p would take too many of them up to the segment's end: each costs
/// hundreds of evaluations, with what is tried before.
bool planner::is_hopeless_beyond(const panel& p) const {
  constexpr double evaluations_of_panel = 200;
  const auto left = static_cast<double>(1 - p.centre);
  return std::ldexp(left, static_cast<int>(std::min(p.level, 1000L))) * evaluations_of_panel >
         static_cast<double>(options_.most_evaluations);
}

/// Says in the result where no way on was found.
panel_plan::outcome planner::obstructed_at(const panel& p) {
  const segment& own = segments_[p.segment];
  // So near to the start that no other point is meant.
  constexpr long deep = 100;
  const bool is_start =
      p.level > deep && estimated_log2(ball(p.centre, 64).magnitude_upper()) < -deep;
  const ball t = is_start ? ball(0, 128) : ball(p.centre, 64 + p.level);
  const complex_ball x = own.place ? complex_ball(own.place(t)) : position_of(own, t);
  if (own.continued) {
    plan_.obstacle += " on the line that the path is turned to";
  } else {
    const bool is_real = !own.along;
    plan_.obstacle +=
        is_real ? " near x = " + to_decimal(x.re, 20) : " near z = " + to_decimal(x, 20);
  }
  return outcome::obstructed;
}

/// Appends to plan_.panels what covers p: itself, or what covers its halves.
panel_plan::outcome planner::plan_panel(panel p, double log2_goal) {
  const double own_nodes = try_panel(p, log2_goal);
  return plan_tried_panel(std::move(p), own_nodes, log2_goal);
}

/// The same of a panel that takes so many nodes, of which `try_panel` has told.
panel_plan::outcome planner::plan_tried_panel(panel p, double own_nodes, double log2_goal) {
  constexpr double most_nodes_of_a_rule = 28'000;  // of greatest_gauss_legendre_degree
  const bool accepted = own_nodes <= std::min(nodes_accepted(p, log2_goal), most_nodes_of_a_rule);
  const double evaluations =
      planned_nodes_ + (accepted ? own_nodes : 0) + static_cast<double>(region_evaluations_);
  if (evaluations > static_cast<double>(options_.most_evaluations)) {
    return outcome::too_many_evaluations;
  }
  if (accepted) {
    const bool as_short = !plan_.panels.empty() && plan_.panels.back().level == p.level;
    ranges_in_a_row_ = p.by_range_only ? (as_short ? ranges_in_a_row_ + 1 : 1) : 0;
    if (ranges_in_a_row_ > most_ranges_in_a_row && is_hopeless_beyond(p)) return obstructed_at(p);
    planned_nodes_ += own_nodes;
    plan_.panels.push_back(std::move(p));
    return outcome::done;
  }
  const double bits = std::max(log2_size_ - log2_goal, 16.0);
  constexpr long suspicious_level = 40;
  const segment& own = segments_[p.segment];
  const bool is_real = !own.along && !own.continued;
  // Ever shorter panels on the way to a point: such as it takes where numbers cancel in f, as in x
  // - sin x, whose sets are wider than the values by then.
  constexpr long short_level = 10;
  constexpr long most_short_panels = 48;
  if (is_real && !known_.is_long && p.level >= short_level && !std::isfinite(own_nodes) &&
      ++short_panels_ > most_short_panels) {
    constexpr long panels_around = 256;
    short_panels_ = 0;
    if (const std::optional<rational> point = point_in(range_of(p, panels_around), 16)) {
      points_.push_back(*point);
      return outcome::cut_needed;
    }
  }
  if (is_real && p.level == suspicious_level && !std::isfinite(own_nodes)) {
    if (const std::optional<rational> point = point_in(range_of(p), 10'000)) {
      constexpr std::size_t most_points = 200;
      points_.push_back(*point);
      return points_.size() < most_points ? outcome::done : outcome::cut_needed;  // for now
    }
    if (const auto pole = known_.pole_in ? known_.pole_in(range_of(p)) : std::nullopt) {
      plan_.obstacle = "the integrand has a pole near x = " + to_decimal(pole->middle(), 20);
      return outcome::divergent;
    }
  }
  // Where numbers cancel in f, as in a double zero under a root, panels beside a point at the
  // distance d have to be as short as d^2: no end is in sight, unless the caller says how deep it
  // may go.
  constexpr long most_failures = 3'000;
  const bool has_failed = p.level >= short_level && !std::isfinite(own_nodes) && !p.is_analytic;
  const bool is_endless =
      is_real && !options_.most_depth && has_failed && ++failures_ > most_failures;
  if (p.level >= deepest_ || hopeless_ || is_endless) return obstructed_at(p);
  const std::size_t before = plan_.panels.size();
  const double nodes_before = planned_nodes_;
  const double most_own_nodes = std::min(bits + 32, most_nodes_of_a_rule);
  const auto keep_whole = [&] {
    plan_.panels.resize(before);
    planned_nodes_ = nodes_before + own_nodes;
    plan_.panels.push_back(std::move(p));
    return outcome::done;
  };
  std::array<panel, 2> halves{p.half(-1), p.half(1)};
  std::array<double, 2> nodes_of_halves{infinite, infinite};
  // Where the halves take no fewer nodes theirs mostly do not: with so few bits, at which regions
  // cost more than nodes, they are not looked at.
  constexpr double few_bits = 600;
  if (bits < few_bits && own_nodes <= most_own_nodes) {
    for (std::size_t k = 0; k < 2; ++k) nodes_of_halves[k] = try_panel(halves[k], log2_goal);
    if (own_nodes <= nodes_of_halves[0] + nodes_of_halves[1]) return keep_whole();
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const bool is_tried = std::isfinite(nodes_of_halves[k]);
    const outcome o = is_tried
                          ? plan_tried_panel(std::move(halves[k]), nodes_of_halves[k], log2_goal)
                          : plan_panel(std::move(halves[k]), log2_goal);
    if (o != outcome::done) return o;
  }
  if (own_nodes <= std::min(planned_nodes_ - nodes_before, most_own_nodes)) return keep_whole();
  return outcome::done;
}

}  // namespace polhode::detail
