#pragma once

// The sums of a plan's rules over their panels, and what they leave out.

#include <map>
#include <memory>
#include <utility>

#include "plan.hpp"

namespace polhode::detail {

/// Holds the integral, whatever was exhausted.
struct sum_of_plan {
  complex_ball value;
  /// More bits would be needed than are allowed, or do not help.
  bool precision_exhausted = false;
  /// Nodes and weights would take more memory than is allowed.
  bool memory_exhausted = false;
};

/// Adds up plans, one after the other; nodes and weights are kept for the next.
class summer {
 public:
  /// The remainder is what the segments leave out. Evaluations, precision and rules are noted in
  /// the account.
  summer(const scaled_segments& of, const ball& remainder, const integrate_options& options,
         double log2_size, integral_account& account)
      : segments_(of.segments),
        log2_scales_(of.log2_scales),
        remainder_(remainder),
        options_(options),
        log2_size_(log2_size),
        account_(account) {}

  /// To a radius of about 2^log2_goal. Chooses the numbers of nodes of the plan's panels.
  [[nodiscard]] sum_of_plan sum(panel_plan& plan, double log2_goal);

 private:
  struct place_in_plan {
    std::size_t panel;
    std::size_t panels;
  };
  [[nodiscard]] panel_sum part_of_panel(panel& p, const place_in_plan& at, double share,
                                        precision most_precision, sum_of_plan& result);
  [[nodiscard]] bool has_room_for(const panel& p, precision working);
  [[nodiscard]] panel_sum sum_of_panel(const panel& p, precision& working);
  [[nodiscard]] std::shared_ptr<const symmetric_nodes> nodes_of(const panel& p, precision working);
  [[nodiscard]] complex_ball sum_over_nodes(const panel& p, const symmetric_nodes& rule) const;
  [[nodiscard]] ball trapezoid_part(const panel& p, precision working) const;

  const std::vector<segment>& segments_;
  const std::vector<double>& log2_scales_;
  const ball& remainder_;
  const integrate_options& options_;
  double log2_size_;
  integral_account& account_;
  precision result_bits_ = 64;             // of sums of panels
  std::map<long, double> bytes_of_rules_;  // by their numbers of nodes
  std::map<std::pair<long, precision>, std::shared_ptr<const symmetric_nodes>>
      nodes_;  // that were used
};

}  // namespace polhode::detail
