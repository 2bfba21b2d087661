#include "sums.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "polhode/quadrature/error_bounds.hpp"
#include "polhode/quadrature/rule_sum.hpp"
#include "quadrature/base/approximate.hpp"
#include "quadrature/base/parallel.hpp"

namespace polhode::detail {

namespace {

/// How many nodes a panel's rule takes for an error of about 2^log2_goal of the mean of F.
long nodes_of_panel(const panel& p, double log2_goal) {
  if (!p.strip) return p.rule->nodes_for(p.rho, estimated_log2(p.supremum), log2_goal);
  return static_cast<long>(
      std::min(nodes_in_strip(p.strip->half_width, p.supremum, log2_goal), greatest_log2));
}

void note(const quadrature_rule& rule, std::vector<quadrature_rule>& rules) {
  if (std::find(rules.begin(), rules.end(), rule) == rules.end()) rules.push_back(rule);
}

/// Where the nodes of a rule on [-1, 1] lie on a panel: the product with the half-length is exact.
struct dyadic_panel {
  ball centre;
  long level;
  void offset(ball& result, const ball& node) const { scale(result, node, -level - 1); }
};

/// What the rule leaves out of the panel's integral of F.
magnitude truncation_error(const panel& p) {
  if (p.strip) {
    const ball supremum = ball(0, 64).enlarged(p.supremum);
    return mean_trapezoid_error({ball::exactly(p.strip->half_width, 64), supremum}, p.nodes);
  }
  const magnitude error = p.rule->truncation_error(p.nodes, ball::exactly(p.rho, 64), p.supremum);
  return scale(error, -p.level - 1);
}

}  // namespace

std::shared_ptr<const symmetric_nodes> summer::nodes_of(const panel& p, precision working) {
  std::shared_ptr<const symmetric_nodes>& kept = nodes_[{p.nodes, working}];
  if (!kept) kept = p.rule->nodes(p.nodes, working);
  return kept;
}

/// The rule on one panel, with at least `working` bits, which become those that were used.
panel_sum summer::sum_of_panel(const panel& p, precision& working) {
  if (p.strip) {  // which is for a whole segment
    return {complex_ball(trapezoid_part(p, working)), {piece_end(0), piece_end(1)}};
  }
  const auto rule = nodes_of(p, working);
  working = rule->bits;
  return {sum_over_nodes(p, *rule), p.piece()};
}

/// Half-length times the sum of w_k F(centre + half-length x_k).
complex_ball summer::sum_over_nodes(const panel& p, const symmetric_nodes& rule) const {
  const dyadic_panel at{ball(p.centre, rule.bits), p.level};
  const auto count = static_cast<long>(rule.nodes.size());
  const segment& s = segments_[p.segment];
  if (s.along) {
    complex_ball sum(0, rule.bits);
    add_nodes(s.along->evaluator(rule.bits), rule, at, 0, count, sum);
    return scale(sum, -p.level - 1);
  }
  const auto adder = [&]() -> add_terms {
    return [&, f = s.evaluator(rule.bits)](long first, long last, ball& sum) {
      add_nodes(f, rule, at, first, last, sum);
    };
  };
  ball sum = sum_in_chunks(count, rule.bits, options_.threads, adder);
  scale(sum, sum, -p.level - 1);
  return complex_ball(std::move(sum));
}

/// The mean of F((k + 1/2)/n).
ball summer::trapezoid_part(const panel& p, precision working) const {
  const auto functions = segments_[p.segment].equidistant(p.nodes, working);
  const auto adder = [&]() -> add_terms {
    return [f = functions()](long first, long last, ball& sum) {
      for (long k = first; k < last; ++k) sum += f(k);
    };
  };
  return sum_in_chunks(p.nodes, working, options_.threads, adder) / p.nodes;
}

/// Its part of the integral, to a radius of about 2^share; whatever it is, the enclosure holds.
/// The result is told where the precision or the memory that this would take is not allowed, or
/// does not help.
panel_sum summer::part_of_panel(panel& p, const place_in_plan& at, double share,
                                precision most_precision, sum_of_plan& result) {
  const segment& s = segments_[p.segment];
  if (p.closed_by) {
    return {scale(*p.closed_by, -p.level) * scale_of(s, result_bits_), p.piece()};
  }
  const auto bound_alone = [&]() -> panel_sum {
    return {at_most(s, scale(p.supremum, -p.level)) * scale_of(s, 64), p.piece()};
  };
  const auto allowed = static_cast<double>(most_precision);
  const double goal = share - log2_scales_[p.segment] + static_cast<double>(p.level);
  p.nodes = nodes_of_panel(p, goal);
  if (options_.progress) {
    options_.progress({static_cast<long>(at.panel), static_cast<long>(at.panels), p.nodes});
  }
  account_.most_nodes = std::max(account_.most_nodes, p.nodes);
  note(p.strip ? quadrature_rule::trapezoid : quadrature_rule(*p.rule), account_.rules);
  const magnitude truncation = truncation_error(p);
  double needed =
      std::max(p.log2_typical - goal, 16.0) + 12 + std::log2(static_cast<double>(p.nodes));
  if (needed > allowed) {
    result.precision_exhausted = true;
    return bound_alone();
  }
  std::optional<double> last_radius;  // log2, where it is finite
  while (true) {
    auto working = static_cast<precision>(std::max(needed, 53.0));
    if (!has_room_for(p, working)) {
      result.memory_exhausted = true;
      result.precision_exhausted = true;
      return bound_alone();
    }
    const panel_sum sum = sum_of_panel(p, working);
    account_.evaluations += p.nodes;
    account_.precision = std::max(account_.precision, working);
    panel_sum part{enlarged(s, sum.value, truncation) * scale_of(s, working), sum.done};
    const double radius = estimated_log2(radius_of(part.value));
    if (radius <= share + 1) return part;
    // More bits, until they do not help any more; to tell a short panel's nodes from what is beside
    // it, they may have to be many before they do.
    const bool helps = !last_radius || radius <= *last_radius - 4;
    const bool stuck = !helps && working >= 128 + 2 * p.level;
    if (stuck || working >= most_precision) {
      result.precision_exhausted = true;
      return part;
    }
    last_radius = std::isfinite(radius) ? std::optional(radius) : std::nullopt;
    const auto bits_used = static_cast<double>(working);
    needed = std::min(bits_used + (helps && last_radius ? radius - share + 4 : bits_used), allowed);
  }
}

/// The nodes and weights of the panel's rule, beside those of the others, keep to the limit.
bool summer::has_room_for(const panel& p, precision working) {
  if (!options_.most_memory || p.strip) return true;
  // A number takes its bits, and some more for its place on the heap and its radius; of nodes that
  // lie symmetrically one half is kept.
  const double bytes_of_number = static_cast<double>(working) / 8 + 96;
  double& bytes = bytes_of_rules_[p.nodes];
  bytes = std::max(bytes, static_cast<double>(p.nodes) * bytes_of_number);
  double sum = 0;
  for (const auto& [nodes, size] : bytes_of_rules_) sum += size;
  return sum <= *options_.most_memory;
}

sum_of_plan summer::sum(panel_plan& plan, double log2_goal) {
  // Half of the goal for truncation and half for rounding, in equal shares.
  const double share = log2_goal - std::log2(static_cast<double>(plan.panels.size())) - 1.5;
  const double bits = std::max(log2_size_ - log2_goal, 16.0);
  result_bits_ = static_cast<precision>(bits) + 64;
  const auto most_precision =
      options_.most_precision.value_or(static_cast<precision>(64 * (bits + 64)));
  sum_of_plan result;
  // Of each segment, 0 <= t <= 1.
  const complex_ball zero(0, result_bits_);
  std::vector<tiled_sum<complex_ball>> of_segments(segments_.size(),
                                                   tiled_sum<complex_ball>(0, 1, zero));
  for (std::size_t k = 0; k < plan.panels.size(); ++k) {
    panel& p = plan.panels[k];
    const place_in_plan at{k, plan.panels.size()};
    const panel_sum part = part_of_panel(p, at, share, most_precision, result);
    of_segments[p.segment].add(part.done, p.interval(), part.value);
  }
  complex_ball total(remainder_.with_precision(result_bits_));
  for (const tiled_sum<complex_ball>& sum : of_segments) {
    const std::optional<complex_ball> value = sum.total();
    if (!value) {
      throw std::logic_error("integrate: internal error: the panels of a range do not tile it");
    }
    total += *value;
  }
  account_.panels = static_cast<long>(plan.panels.size());
  result.value = total;
  return result;
}

}  // namespace polhode::detail
