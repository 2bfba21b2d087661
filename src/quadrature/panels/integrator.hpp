#pragma once

// Integrals over panels: a size, then a plan and its sum for one goal after the other.

#include <vector>

#include "plan.hpp"
#include "polhode/quadrature/contour.hpp"
#include "quadrature/pieces/segments.hpp"

namespace polhode::detail {

class integrator {
 public:
  /// What is given has to live as long.
  integrator(const preparation& prepared, const integrate_options& options,
             const range_knowledge& known)
      : segments_(prepared.segments), prepared_(prepared), options_(options), known_(known) {}

  contour_integral run();
  /// Where not empty, points at which f seems not to be analytic: run() has given up, and cutting
  /// the range there may help.
  [[nodiscard]] const std::vector<rational>& points_of_interest() const { return points_; }
  /// run() has come to its precision's limit, and 0 is a value within 10^-digits of the integral of
  /// |f|.
  [[nodiscard]] bool counts_as_zero() const;

 private:
  /// A lower bound of the integral of |f|, by the last plan.
  [[nodiscard]] magnitude least_size_of_integral() const;
  /// The obstacle of a plan that was not made.
  contour_integral refused();

  scaled_segments segments_;
  const preparation& prepared_;
  const integrate_options& options_;
  const range_knowledge& known_;
  std::vector<rational> points_;
  panel_plan plan_;
  contour_integral result_;
};

/// Certifies an integral that counts as 0.
template <class Integral>
void settle_as_zero(Integral& of) {
  of.verdict = status::certified;
  of.why = reason::none;
}

}  // namespace polhode::detail
