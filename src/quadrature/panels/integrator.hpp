#pragma once

// Integrals over panels: a plan that a goal needs, the sums of the plan's rules, and the loop over
// goals. The plan is made in plan.cpp, the sums in sums.cpp, the loop in integrator.cpp, and what
// it begins with, the size of the integral, in size_estimate.cpp.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "panel.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/rule.hpp"
#include "quadrature/pieces/segments.hpp"
#include "segment_values.hpp"

namespace polhode::detail {

/// The rule on panels that was chosen: Gauss and Legendre's unless it is another one.
[[nodiscard]] const panel_rule& panel_rule_of(const quadrature_rule& chosen);

class ellipse_bounds;

class integrator {
 public:
  /// `known` are points that were tried as cuts, or are ends of segments: they are of no interest
  /// again. pole_in(x): what holds a pole in the set x, for which the integral is proved to
  /// diverge; may be empty.
  integrator(const preparation& prepared, const integrate_options& options,
             const std::vector<rational>& known,
             std::function<std::optional<ball>(const ball& x)> pole_in = {})
      : segments_(prepared.segments),
        remainder_(prepared.remainder),
        log2_periods_(prepared.log2_periods),
        options_(options),
        rule_(panel_rule_of(options.rule)),
        known_points_(known),
        pole_in_(std::move(pole_in)) {}

  contour_integral run();
  /// Where not empty, points at which f seems not to be analytic: run() has given up, and cutting
  /// the range there may help.
  [[nodiscard]] const std::vector<rational>& points_of_interest() const { return points_; }
  /// Panels that become ever shorter are no reason to look for such points: a long range has them.
  void take_short_panels() { takes_short_panels_ = true; }
  /// run() has come to its precision's limit, and 0 is a value within 10^-digits of the integral of
  /// |f|.
  [[nodiscard]] bool counts_as_zero() const;

 private:
  enum class outcome {
    done,
    too_many_evaluations,
    obstructed,
    cut_needed,
    divergent,
    precision_exhausted,
    not_applicable
  };

  /// The panels for an error of about 2^log2_goal in all.
  outcome plan(double log2_goal);
  outcome plan_segment(std::size_t index, double log2_goal);
  outcome plan_panel(panel p, double log2_goal);
  outcome plan_tried_panel(panel p, double own_nodes, double log2_goal);
  double try_panel(panel& p, double log2_goal);
  [[nodiscard]] double find_ellipse(panel& p, double goal, ellipse_bounds& bounds) const;
  [[nodiscard]] double mean_goal(const panel& p, double log2_goal) const;
  [[nodiscard]] double nodes_accepted(const panel& p, double log2_goal) const;
  outcome sum(double log2_goal);
  [[nodiscard]] panel_sum part_of_panel(panel& p, double share, precision most_precision,
                                        bool& exhausted);
  [[nodiscard]] bool has_room_for(const panel& p, precision working);
  [[nodiscard]] magnitude truncation_error(const panel& p) const;
  [[nodiscard]] panel_sum sum_of_panel(const panel& p, precision& working);
  [[nodiscard]] std::shared_ptr<const symmetric_nodes> nodes_of(const panel& p, precision working);
  [[nodiscard]] complex_ball sum_over_nodes(const panel& p, const symmetric_nodes& rule) const;
  [[nodiscard]] ball trapezoid_part(const panel& p, precision working) const;
  [[nodiscard]] double log2_of_typical(const panel& p, double log2_goal) const;
  [[nodiscard]] ball range_of(const panel& p, long around = 1) const;
  [[nodiscard]] std::optional<rational> point_in(const ball& both, long greatest_denominator) const;
  [[nodiscard]] bool is_hopeless_beyond(const panel& p) const;
  outcome obstructed_at(const panel& p);
  [[nodiscard]] double log2_of_samples(std::size_t index) const;
  void estimate_size();
  [[nodiscard]] magnitude least_size() const;
  [[nodiscard]] magnitude least_size_by(long log2_pieces) const;

  const std::vector<segment>& segments_;
  const ball& remainder_;
  long log2_periods_;
  const integrate_options& options_;
  const panel_rule& rule_;
  const std::vector<rational>& known_points_;
  std::function<std::optional<ball>(const ball& x)> pole_in_;
  std::vector<rational> points_;
  bool hopeless_ = false;  // a function is not available over regions
  // Beside a singular point there are few panels of one length of which the range is all that is
  // known. Where they do not end, F is known on the real line alone.
  static constexpr long most_ranges_in_a_row = 64;
  long ranges_in_a_row_ = 0;
  long short_panels_ = 0;  // that were halved again
  long failures_ = 0;      // the same, in all
  bool takes_short_panels_ = false;
  std::vector<panel> panels_;
  double planned_nodes_ = 0;
  std::vector<double> log2_scales_;
  std::map<long, double> bytes_of_rules_;  // by their numbers of nodes
  bool memory_exhausted_ = false;
  std::map<std::pair<long, precision>, std::shared_ptr<const symmetric_nodes>>
      nodes_;  // that were used
  long deepest_ = 0;
  double log2_size_ = 0;        // about log2 of the integral of |f|
  precision result_bits_ = 64;  // of sums of panels
  contour_integral result_;
};

/// Certifies an integral that counts as 0.
template <class Integral>
void settle_as_zero(Integral& of) {
  of.verdict = status::certified;
  of.why = reason::none;
}

}  // namespace polhode::detail
