#include "polhode/quadrature/periodic_trapezoid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode {
namespace {

constexpr precision period_precision = 64;

ball from_estimate(double x) { return ball::exactly(x, period_precision); }

/// A strip and an estimate of the nodes it asks for.
struct candidate {
  double half_width = 0;
  double nodes = std::numeric_limits<double>::infinity();
};

}  // namespace

periodic_plan plan_periodic_trapezoid(
    const std::function<std::optional<strip_bound>(const ball& half_width)>& bound_on_strip,
    long bits, long most_nodes) {
  periodic_plan plan;
  plan.truncation_error = ball::undefined(period_precision);

  // Search. The bound 2 pi M / (e^(2 n H) - 1) falls below 2^-bits at about
  // n = (bits + log2(2 pi M)) log 2 / (2 H).
  const auto evaluate = [&](double half_width) {
    candidate c;
    c.half_width = half_width;
    const auto bound = bound_on_strip(from_estimate(half_width));
    if (bound.has_value() && bound->supremum.is_bounded()) {
      const double log2_bound = estimated_log2(bound->supremum.magnitude_upper());
      const double needed = static_cast<double>(bits) + std::max(log2_bound, -1e9) + 2.7;
      c.nodes = std::max(needed, 1.0) * 0.34657359 / half_width;
    }
    return c;
  };
  // From wide to narrow in factors of 2 until a strip is proved, and while it gets better: M falls
  // as the strip shrinks, so the best is near the widest that can be proved. Then between the
  // neighbours.
  candidate best;
  double half_width = 32;
  for (; half_width > 1e-300; half_width /= 2) {
    const candidate c = evaluate(half_width);
    if (c.nodes < best.nodes) {
      best = c;
    } else if (std::isfinite(best.nodes)) {
      break;
    }
  }
  if (!std::isfinite(best.nodes)) {
    plan.why = reason::not_analytic;
    return plan;
  }
  for (const double factor : {1.4, 1.18, 1.09, 1.04, 1.02}) {
    const candidate wider = evaluate(best.half_width * factor);
    const candidate narrower =
        wider.nodes < best.nodes ? candidate{} : evaluate(best.half_width / factor);
    for (const candidate& c : {wider, narrower}) {
      if (c.nodes < best.nodes) best = c;
    }
  }
  if (best.nodes > static_cast<double>(most_nodes)) {
    plan.why = reason::evaluation_limit;
    return plan;
  }

  // Proof. The error over (0, pi) is half of that over the circle with 2n nodes.
  const auto bound = bound_on_strip(from_estimate(best.half_width));
  const magnitude goal = magnitude::power_of_two(-bits);
  auto nodes = static_cast<long>(best.nodes) + 1;
  while (nodes <= most_nodes) {
    const ball error = scale(periodic_trapezoid_error(*bound, 2 * nodes), -1);
    if (!error.is_undefined() && error.magnitude_upper() <= goal) {
      plan.nodes = nodes;
      plan.strip = *bound;
      plan.truncation_error = error;
      return plan;
    }
    nodes += nodes / 64 + 1;
  }
  plan.why = reason::evaluation_limit;
  return plan;
}

trapezoid_integral detail::sum_to_bits(const std::function<ball(precision)>& sum, long nodes,
                                       const magnitude& left_out, long bits,
                                       precision most_precision) {
  trapezoid_integral result;
  const magnitude goal = magnitude::power_of_two(-bits);
  const precision first =
      std::max(bits, 32L) + 16 + static_cast<long>(std::log2(static_cast<double>(nodes)));
  double last = std::numeric_limits<double>::infinity();
  precision p = first;
  while (p <= most_precision) {
    const ball value = sum(p);
    result.evaluations += nodes;
    result.precision = p;
    if (value.is_undefined()) {
      result.why = reason::not_defined;
      return result;
    }
    result.enclosure = value.enlarged(left_out);
    const magnitude radius = result.enclosure.radius();
    if (radius <= goal) {
      result.verdict = status::certified;
      return result;
    }
    if (radius.is_infinite()) {
      if (p > 16 * first) break;
      p *= 2;
      continue;
    }
    const double excess = estimated_log2(radius) + static_cast<double>(bits);
    if (!(excess < last - 1)) break;  // more bits do not help any more
    last = excess;
    p += excess < 1e15 ? static_cast<long>(excess) + 12 : p;
  }
  result.why = reason::precision_limit;
  return result;
}

}  // namespace polhode
