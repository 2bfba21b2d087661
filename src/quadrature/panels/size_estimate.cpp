// How large the integral of |f| is, about: to search with, what follows from it proves itself.

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "integrator.hpp"
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

}  // namespace

/// log2 of |f| at some points, times the length of what is around each.
double integrator::log2_of_samples(std::size_t index) const {
  const segment& s = segments_[index];
  const auto f = evaluator_of(s, 64);
  double most = -infinite;
  const auto sample = [&](const ball& t, double log2_length) {
    const complex_ball value = f(t);
    if (!value.is_bounded()) return;
    const double size = estimated_log2(value.magnitude_upper());
    most = std::max(most, size + log2_scales_[index] + log2_length);
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

/// An estimate of log2 of the integral of |f|: by samples; and where the bounds of |f| say that
/// these may have missed the most of it, by branch and bound. The part with the greatest bound is
/// halved, and f sampled in the middle of the halves, until no bound is much above the greatest
/// sample.
void integrator::estimate_size() {
  constexpr double enough = 16;
  constexpr int most_halvings = 400;
  constexpr long singular_level = 8;  // not halved further where f is not bounded
  double samples = -infinite;
  std::priority_queue<suspected_part> parts;
  const auto add = [&](panel p) {
    const segment& s = segments_[p.segment];
    const panel_regions over(s, p, result_.account.region_evaluations);
    const double bound =
        estimated_log2(over(double_interval(-1.0, 1.0), double_interval(0)).magnitude_upper());
    if (!std::isfinite(bound) && (bound < 0 || p.level > singular_level)) return;
    const double most = bound + log2_scales_[p.segment] - static_cast<double>(p.level);
    parts.push({std::move(p), most});
  };
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    samples = std::max(samples, log2_of_samples(i));
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
      const complex_ball value = evaluator_of(segments_[p.segment], wide)(ball(half.centre, wide));
      if (value.is_bounded()) {
        const double size = estimated_log2(value.magnitude_upper());
        samples =
            std::max(samples, size + log2_scales_[p.segment] - static_cast<double>(half.level));
      }
      add(std::move(half));
    }
  }
  log2_size_ = std::isfinite(samples) ? std::max(samples, -greatest_log2) : 0;
}

}  // namespace polhode::detail
