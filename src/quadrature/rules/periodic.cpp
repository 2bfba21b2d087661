#include "periodic.hpp"

#include <algorithm>
#include <cmath>

#include "polhode/arithmetic/elementary.hpp"
#include "quadrature/rules/trapezoid_plan.hpp"

namespace polhode::detail {

magnitude supremum_along(const segment& s, double h, long pieces, long& evaluations) {
  magnitude supremum;
  double left = 0;
  for (long k = 1; k <= pieces; ++k) {
    const double right = static_cast<double>(k) / static_cast<double>(pieces);
    ++evaluations;
    const region value = s.over(region(double_interval(left, right), double_interval(h)));
    supremum = max(supremum, value.magnitude_upper());
    if (supremum.is_infinite()) break;
    left = right;
  }
  return supremum;
}

namespace {

/// The search for the strip that takes the fewest nodes.
class strip_search {
 public:
  strip_search(const segment& s, double log2_goal, double most_nodes, long& evaluations)
      : segment_(s), log2_goal_(log2_goal), evaluations_(evaluations) {
    const double bits = std::max(-log2_goal, 16.0);
    price_ = 1 / (0.3 + std::pow(bits / 300, 1.5));
    narrowest_ = 0.3 * bits / most_nodes;
    best_.nodes = most_nodes;
  }

  [[nodiscard]] std::optional<periodic_strip> run() {
    constexpr double first = 1;
    constexpr double widest = 64;
    if (consider(first)) {
      double width = first;
      while (width < widest && pays(0.33) && consider(width * 1.5)) width *= 1.5;
    } else {
      for (double width = first / 2; !found_ && width > narrowest_; width /= 2) consider(width);
    }
    for (const double factor : {1.25, 1.1, 1.05, 1.02}) {
      if (!found_ || !pays(factor - 1)) break;
      const double width = best_.half_width;
      if (!consider(width * factor)) consider(width / factor);
    }
    if (!found_) return std::nullopt;
    return best_;
  }

 private:
  /// Whether that part of the nodes is worth the evaluations over regions that looking for it
  /// takes.
  [[nodiscard]] bool pays(double part) const {
    constexpr double evaluations = 12;
    return best_.nodes * part > evaluations * price_;
  }

  /// Whether the strip of this half-width in s = pi t is proved, and takes fewer nodes than the
  /// best so far.
  bool consider(double half_width) {
    // In t, made sure to be no narrower.
    const double h = (double_interval(half_width) / (4 * atan(double_interval(1)))).upper();
    if (!is_analytic_on(segment_.over, 0, 1, h, evaluations_)) return false;
    constexpr long fewest = 8;
    constexpr long most = 1024;
    magnitude supremum = supremum_along(segment_, h, fewest, evaluations_);
    double nodes = nodes_for(half_width, supremum);
    // More pieces, while they save more nodes than they cost.
    for (long pieces = 2 * fewest; pieces <= most; pieces *= 2) {
      const double pieces_price = static_cast<double>(pieces) * price_;
      if (std::isfinite(nodes) && pieces_price > 0.5 * nodes) break;
      supremum = min(supremum, supremum_along(segment_, h, pieces, evaluations_));
      const double before = nodes;
      nodes = nodes_for(half_width, supremum);
      if (std::isfinite(before) && before - nodes < pieces_price) break;
    }
    if (supremum.is_infinite() || !(nodes < best_.nodes)) return false;
    found_ = true;
    best_ = {half_width, supremum, nodes};
    return true;
  }

  [[nodiscard]] double nodes_for(double half_width, const magnitude& supremum) const {
    return nodes_in_strip(half_width, supremum, log2_goal_);
  }

  const segment& segment_;
  double log2_goal_;
  long& evaluations_;
  double price_ = 0;      // of a region's evaluation in those of f at a node
  double narrowest_ = 0;  // below it the nodes are too many even where F is as small as the goal
  periodic_strip best_;
  bool found_ = false;
};

}  // namespace

double nodes_in_strip(double half_width, const magnitude& supremum, double log2_goal) {
  // 2 M e^(-2 H n) <= 2^log2_goal.
  constexpr double half_log_2 = 0.34657360;
  const double excess = estimated_log2(supremum) + 1.1 - log2_goal;
  return std::max(1.0, std::ceil(excess * half_log_2 / half_width));
}

std::optional<periodic_strip> find_strip(const segment& s, double log2_goal, double most_nodes,
                                         long& evaluations) {
  return strip_search(s, log2_goal, most_nodes, evaluations).run();
}

}  // namespace polhode::detail
