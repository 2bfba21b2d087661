#pragma once

// The plan of an integral over panels: which panels, each with its proof and its rule.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "panel.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/rule.hpp"
#include "segment_values.hpp"

namespace polhode::detail {

/// The rule on panels that was chosen: Gauss and Legendre's unless it is another one.
[[nodiscard]] const panel_rule& panel_rule_of(const quadrature_rule& chosen);

struct panel_plan {
  enum class outcome : std::uint8_t {
    done,
    too_many_evaluations,
    obstructed,  // by the obstacle
    cut_needed,  // at the points of interest
    divergent,   // proved, for the obstacle
    not_applicable
  };
  outcome what = outcome::done;
  std::string obstacle;
  std::vector<panel> panels;  // which cover all segments once
};

/// What is known of an integral's range before panels are planned.
struct range_knowledge {
  /// Points that were tried as cuts, or are ends of segments: they are of no interest again.
  std::vector<rational> points;
  /// What holds a pole in the set x, for which the integral is proved to diverge; may be empty.
  std::function<std::optional<ball>(const ball& x)> pole_in = nullptr;
  /// Panels that become ever shorter are no reason to look for points of interest: a long range has
  /// them.
  bool is_long = false;
};

class ellipse_bounds;

/// Plans for ever smaller goals.
class planner {
 public:
  /// log2_size is about that of the integral of |f|. All evaluations over regions are counted.
  planner(const scaled_segments& of, const integrate_options& options, const range_knowledge& known,
          double log2_size, long& region_evaluations);

  /// The panels for an error of about 2^log2_goal in all.
  [[nodiscard]] panel_plan plan(double log2_goal);
  /// Where not empty, points at which f seems not to be analytic: cutting the range there may help.
  [[nodiscard]] const std::vector<rational>& points_of_interest() const { return points_; }

 private:
  using outcome = panel_plan::outcome;

  outcome plan_segment(std::size_t index, double log2_goal);
  outcome plan_panel(panel p, double log2_goal);
  outcome plan_tried_panel(panel p, double own_nodes, double log2_goal);
  double try_panel(panel& p, double log2_goal);
  [[nodiscard]] double find_ellipse(panel& p, double goal, ellipse_bounds& bounds) const;
  [[nodiscard]] double mean_goal(const panel& p, double log2_goal) const;
  [[nodiscard]] double nodes_accepted(const panel& p, double log2_goal) const;
  [[nodiscard]] double log2_of_typical(const panel& p, double log2_goal) const;
  [[nodiscard]] ball range_of(const panel& p, long around = 1) const;
  [[nodiscard]] std::optional<rational> point_in(const ball& both, long greatest_denominator) const;
  [[nodiscard]] bool is_hopeless_beyond(const panel& p) const;
  outcome obstructed_at(const panel& p);

  const std::vector<segment>& segments_;
  const std::vector<double>& log2_scales_;
  const integrate_options& options_;
  const range_knowledge& known_;
  const panel_rule& rule_;
  double log2_size_;
  long& region_evaluations_;
  long deepest_;
  panel_plan plan_;  // that is being made
  double planned_nodes_ = 0;
  std::vector<rational> points_;
  bool hopeless_ = false;  // a function is not available over regions
  // Beside a singular point there are few panels of one length of which the range is all that is
  // known. Where they do not end, F is known on the real line alone.
  static constexpr long most_ranges_in_a_row = 64;
  long ranges_in_a_row_ = 0;
  long short_panels_ = 0;  // that were halved again
  long failures_ = 0;      // the same, in all
};

}  // namespace polhode::detail
