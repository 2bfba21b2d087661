#pragma once

// A segment's functions in complex numbers, whether F is real for real t or not.

#include <functional>
#include <vector>

#include "polhode/arithmetic/complex_ball.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The segments of an integral, and about log2 of each one's scale, to search with.
struct scaled_segments {
  explicit scaled_segments(const std::vector<segment>& all);

  const std::vector<segment>& segments;
  std::vector<double> log2_scales;
};

/// The greater of the radii of both parts.
[[nodiscard]] inline magnitude radius_of(const complex_ball& z) {
  return max(z.re.radius(), z.im.radius());
}

[[nodiscard]] inline std::function<complex_ball(const ball& t)> evaluator_of(const segment& s,
                                                                             precision p) {
  if (s.along) return s.along->evaluator(p);
  return [f = s.evaluator(p)](const ball& t) { return complex_ball(f(t)); };
}
[[nodiscard]] inline complex_ball scale_of(const segment& s, precision p) {
  return s.along ? s.along->scale(p) : complex_ball(s.scale(p));
}
[[nodiscard]] inline complex_ball position_of(const segment& s, const ball& t) {
  return s.along ? s.along->position(t) : complex_ball(s.position(t));
}
/// z with what F's values may be off by.
[[nodiscard]] inline complex_ball enlarged(const segment& s, const complex_ball& z,
                                           const magnitude& error) {
  return {z.re.enlarged(error), s.along ? z.im.enlarged(error) : z.im};
}
[[nodiscard]] inline complex_ball at_most(const segment& s, const magnitude& bound) {
  return enlarged(s, complex_ball(0, 64), bound);
}

}  // namespace polhode::detail
