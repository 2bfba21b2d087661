#include "integrator.hpp"

#include <algorithm>
#include <utility>

#include "base/clock.hpp"
#include "quadrature/base/approximate.hpp"
#include "size_estimate.hpp"
#include "sums.hpp"

namespace polhode::detail {

magnitude integrator::least_size_of_integral() const {
  return scale(least_size(segments_.segments, plan_.panels), -prepared_.log2_periods);
}

contour_integral integrator::refused() {
  using outcome = panel_plan::outcome;
  result_.obstacle = plan_.obstacle;
  switch (plan_.what) {
    case outcome::too_many_evaluations:
      result_.why = reason::evaluation_limit;
      result_.obstacle = "more evaluations needed than allowed";
      break;
    case outcome::not_applicable:
      result_.why = reason::not_applicable;
      break;
    case outcome::divergent:
      result_.why = reason::not_integrable;
      break;
    default:
      result_.why = reason::not_analytic;
      break;
  }
  return result_;
}

contour_integral integrator::run() {
  const double log2_digits = options_.goal().log2_relative();
  integral_account& account = result_.account;
  auto start = clock::now();
  const double log2_size = estimated_log2_size(segments_, account.region_evaluations);
  planner plans(segments_, options_, known_, log2_size, account.region_evaluations);
  summer sums(segments_, prepared_.remainder, options_, log2_size, account);
  double log2_goal = log2_size - log2_digits;
  if (options_.absolute_exponent) {
    log2_goal = std::max(log2_goal, static_cast<double>(*options_.absolute_exponent));
  }
  // Where a value counts as 0.
  double lowest_goal = log2_goal - log2_digits - static_cast<double>(prepared_.log2_periods);
  bool lowest_is_proved = false;
  for (int attempts = 0; attempts < 6; ++attempts) {
    plan_ = plans.plan(log2_goal);
    points_ = plans.points_of_interest();
    account.seconds_for_bounds += seconds_since(start);
    if (plan_.what != panel_plan::outcome::done) return refused();
    start = clock::now();
    const sum_of_plan sum = sums.sum(plan_, log2_goal - 1);
    account.seconds_for_sums += seconds_since(start);
    start = clock::now();
    const bool is_better =
        result_.enclosure.is_undefined() || radius_of(sum.value) < radius_of(result_.enclosure);
    if (is_better) result_.enclosure = sum.value;
    if (options_.goal().is_met_by(result_.enclosure)) {
      result_.verdict = status::certified;
      return result_;
    }
    if (sum.memory_exhausted) {
      result_.why = reason::evaluation_limit;
      result_.obstacle = "more memory needed than allowed";
      return result_;
    }
    if (sum.precision_exhausted) break;
    // The value is smaller than its integrand led to expect.
    const double value = estimated_log2(result_.enclosure.magnitude_upper());
    if (log2_goal <= lowest_goal + 2) {
      // 10^-digits of the integral of |f| stands for the value.
      const magnitude size = least_size_of_integral();
      if (goal{2 * options_.digits}.is_met(radius_of(result_.enclosure), size)) {
        result_.verdict = status::certified;
        return result_;
      }
      if (lowest_is_proved || size.is_zero()) break;
      lowest_is_proved = true;
      lowest_goal = estimated_log2(size) - 2 * log2_digits - 3;
    }
    log2_goal = std::max(std::min(value - log2_digits, log2_goal) - 3, lowest_goal);
  }
  result_.why = reason::precision_limit;
  return result_;
}

/// A value that cannot be told from 0 has no digits of its own: 10^-digits of the integral of |f|
/// counts in its place.
bool integrator::counts_as_zero() const {
  const complex_ball& value = result_.enclosure;
  if (result_.why != reason::precision_limit || value.is_undefined()) return false;
  if (!contains_zero(value.re) || !contains_zero(value.im)) return false;
  return goal{options_.digits}.is_met(radius_of(value), least_size_of_integral());
}

contour_integral integrate_segments(const preparation& prepared, const integrate_options& options) {
  const range_knowledge nothing;
  integrator work(prepared, options, nothing);
  contour_integral result = work.run();
  if (work.counts_as_zero()) settle_as_zero(result);
  return result;
}

}  // namespace polhode::detail
