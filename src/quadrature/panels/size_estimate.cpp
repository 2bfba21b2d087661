#include "size_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "panel_regions.hpp"
#include "quadrature/base/approximate.hpp"

namespace polhode::detail {

namespace {

/// A part of a range whose contribution is not known well.
struct suspected_part {
  panel where;
  double most;  // log2 of its length times a bound of |f| over it
  friend bool operator<(const suspected_part& x, const suspected_part& y) {
    return x.most < y.most;
  }
};

/// log2 of |f| at some points, times the length of what is around each.
double log2_of_samples(const segment& s, double log2_scale) {
  const auto f = evaluator_of(s, 64);
  double most = -infinite;
  const auto sample = [&](const ball& t, double log2_length) {
    complex_ball value = f(t);
    // Of what cannot be told from 0 the size is that of rounding errors.
    for (precision p = 256; p <= 4096 && contains_zero(value) && !value.is_exact(); p *= 2) {
      value = evaluator_of(s, p)(t.with_precision(p));
    }
    if (!value.is_bounded()) return;
    const double size = estimated_log2(value.magnitude_upper());
    most = std::max(most, size + log2_scale + log2_length);
  };
  for (long k = 1; k < 16; k += 2) sample(ball(rational(k, 16), 64), -2);
  for (long k = 5; k < 14 && !s.along; ++k) {
    // A piece of the real line may have the most of its size near t = 0.
    ball t(1, 64);
    scale(t, t, -k);
    sample(t, static_cast<double>(-k));
  }
  return most;
}

/// A lower bound of the integral of |f| over panels, from the ranges of F over pieces of them.
magnitude least_size_by(const std::vector<segment>& segments, const std::vector<panel>& panels,
                        long log2_pieces) {
  magnitude size;
  for (const panel& p : panels) {
    const segment& s = segments[p.segment];
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

}  // namespace

/// Shorter pieces serve where longer ones all hold a zero of F.
magnitude least_size(const std::vector<segment>& segments, const std::vector<panel>& panels) {
  constexpr std::size_t most_pieces = 1U << 16;
  for (const long log2_pieces : {4L, 8L, 12L}) {
    if (log2_pieces > 4 && panels.size() << log2_pieces > most_pieces) break;
    const magnitude size = least_size_by(segments, panels, log2_pieces);
    if (!size.is_zero()) return size;
  }
  return {};
}

/// By samples; and where the bounds of |f| say that
/// these may have missed the most of it, by branch and bound. The part with the greatest bound is
/// halved, and f sampled in the middle of the halves, until no bound is much above the greatest
/// sample.
double estimated_log2_size(const scaled_segments& of, long& region_evaluations) {
  const std::vector<segment>& segments = of.segments;
  const std::vector<double>& log2_scales = of.log2_scales;
  constexpr double enough = 16;
  constexpr int most_halvings = 400;
  constexpr long singular_level = 8;  // not halved further where f is not bounded
  double samples = -infinite;
  std::priority_queue<suspected_part> parts;
  const auto add = [&](panel p) {
    const segment& s = segments[p.segment];
    const panel_regions over(s, p, region_evaluations);
    const double bound =
        estimated_log2(over(double_interval(-1.0, 1.0), double_interval(0)).magnitude_upper());
    if (!std::isfinite(bound) && (bound < 0 || p.level > singular_level)) return;
    const double most = bound + log2_scales[p.segment] - static_cast<double>(p.level);
    parts.push({std::move(p), most});
  };
  for (std::size_t i = 0; i < segments.size(); ++i) {
    samples = std::max(samples, log2_of_samples(segments[i], log2_scales[i]));
    panel whole;
    whole.segment = i;
    whole.centre = rational(1, 2);
    add(std::move(whole));
  }
  for (int k = 0; k < most_halvings && !parts.empty(); ++k) {
    if (parts.top().most <= samples + enough) break;
    const panel p = parts.top().where;
    parts.pop();
    for (const int side : {-1, 1}) {
      panel half = p.half(side);
      const precision wide = 96 + 2 * half.level;
      const complex_ball value = evaluator_of(segments[p.segment], wide)(ball(half.centre, wide));
      if (value.is_bounded()) {
        const double size = estimated_log2(value.magnitude_upper());
        samples =
            std::max(samples, size + log2_scales[p.segment] - static_cast<double>(half.level));
      }
      add(std::move(half));
    }
  }
  return std::isfinite(samples) ? std::max(samples, -greatest_log2) : 0;
}

}  // namespace polhode::detail
