#include "integrator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/clock.hpp"
#include "quadrature/base/approximate.hpp"

namespace polhode::detail {

/// A lower bound of the integral of |f|: from the ranges of F over pieces of the panels, which are
/// shorter where longer ones all hold a zero of F.
magnitude integrator::least_size() const {
  constexpr std::size_t most_pieces = 1U << 16;
  for (const long log2_pieces : {4L, 8L, 12L}) {
    if (log2_pieces > 4 && panels_.size() << log2_pieces > most_pieces) break;
    const magnitude size = least_size_by(log2_pieces);
    if (!size.is_zero()) return size;
  }
  return {};
}

magnitude integrator::least_size_by(long log2_pieces) const {
  magnitude size;
  for (const panel& p : panels_) {
    const segment& s = segments_[p.segment];
    const precision wide = 96 + p.level;
    const auto f = evaluator_of(s, wide);
    const ball piece = hull(ball(-1, wide), ball(1, wide));
    magnitude sum;
    for (long k = 1 - (1L << log2_pieces); k < 1L << log2_pieces; k += 2) {
      const ball t = p.centre + scale(piece + k, -p.level - 1 - log2_pieces);
      sum = add_down(sum, f(t).magnitude_lower());
    }
    const magnitude mean = multiply_down(sum, scale_of(s, wide).magnitude_lower());
    size = add_down(size, scale(mean, -p.level - log2_pieces));
  }
  return size;
}

contour_integral integrator::run() {
  const double log2_digits = options_.goal().log2_relative();
  for (const segment& s : segments_) {
    // With as many bits as tell a short range's ends apart.
    precision p = 64;
    while (p < 40'000 && scale_of(s, p).magnitude_lower().is_zero()) p *= 2;
    log2_scales_.push_back(estimated_log2(scale_of(s, p).magnitude_upper()));
  }
  // Along a path nothing is gained by coming nearer to a cut or a pole that is met.
  const double least_depth = !segments_.empty() && segments_.front().along ? 160 : 420;
  deepest_ = options_.most_depth.value_or(static_cast<long>(least_depth + 1.1 * log2_digits));
  auto start = clock::now();
  estimate_size();
  outcome o = outcome::done;
  double log2_goal = log2_size_ - log2_digits;
  if (options_.absolute_exponent) {
    log2_goal = std::max(log2_goal, static_cast<double>(*options_.absolute_exponent));
  }
  // Where a value counts as 0.
  double lowest_goal = log2_goal - log2_digits - static_cast<double>(log2_periods_);
  bool lowest_is_proved = false;
  for (int attempts = 0; attempts < 6; ++attempts) {
    if (o == outcome::done) o = plan(log2_goal);
    result_.account.seconds_for_bounds += seconds_since(start);
    start = clock::now();
    if (o == outcome::done) o = sum(log2_goal - 1);
    result_.account.seconds_for_sums += seconds_since(start);
    start = clock::now();
    if (o == outcome::too_many_evaluations) {
      result_.why = reason::evaluation_limit;
      result_.obstacle = "more evaluations needed than allowed";
      return result_;
    }
    if (o == outcome::not_applicable) {
      result_.why = reason::not_applicable;
      return result_;
    }
    if (o == outcome::divergent) {
      result_.why = reason::not_integrable;
      return result_;
    }
    if (o == outcome::obstructed || o == outcome::cut_needed) {
      result_.why = reason::not_analytic;
      return result_;
    }
    result_.obstacle.clear();
    if (options_.goal().is_met_by(result_.enclosure)) {
      result_.verdict = status::certified;
      return result_;
    }
    if (o == outcome::precision_exhausted && memory_exhausted_) {
      result_.why = reason::evaluation_limit;
      result_.obstacle = "more memory needed than allowed";
      return result_;
    }
    if (o == outcome::precision_exhausted) {
      result_.why = reason::precision_limit;
      return result_;
    }
    // The value is smaller than its integrand led to expect.
    const double value = estimated_log2(result_.enclosure.magnitude_upper());
    if (log2_goal <= lowest_goal + 2) {
      // 10^-digits of the integral of |f| stands for the value.
      const magnitude size = scale(least_size(), -log2_periods_);
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
  return goal{options_.digits}.is_met(radius_of(value), scale(least_size(), -log2_periods_));
}

contour_integral integrate_segments(const preparation& prepared, const integrate_options& options) {
  integrator work(prepared, options, {});
  contour_integral result = work.run();
  if (work.counts_as_zero()) settle_as_zero(result);
  return result;
}

}  // namespace polhode::detail
