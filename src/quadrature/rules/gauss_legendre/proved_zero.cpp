#include "quadrature/rules/gauss_legendre/proved_zero.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/quadrature/gauss_legendre.hpp"

namespace polhode::detail::legendre {
namespace {

/// Newton's method at growing precision: a number near the zero of the series, to about half its
/// bits. A search: the midpoints of balls are taken for numbers.
ball approximate_zero(const local_series& series, precision bits) {
  const auto& d = series.coefficients;
  const auto log2_of = [](const ball& x) {
    constexpr double most = 0x1p+40;  // of 0, too
    return std::clamp(estimated_log2(x.magnitude_upper()), -most, most);
  };
  constexpr precision bits_of_start = 192;
  const ball slope = d[1].with_precision(bits_of_start);
  ball g = -(d[0].with_precision(bits_of_start) / slope);
  // The error after a step of Newton's method is 2^bend times the square of the one before.
  double bend = 0;
  long good = static_cast<long>(-2 * log2_of(g));
  if (series.last >= 2) {
    bend = std::max(log2_of(d[2]) - log2_of(d[1]), 0.0);
    // That of the start, with the second term of the inverse series, is |2 (d_2/d_1)^2 - d_3/d_1|
    // |g|^3, and d_2 is small in the middle of [0, 1].
    double third = 2 * bend + 1;
    if (series.last >= 3) third = std::max(third, log2_of(d[3]) - log2_of(d[1]));
    good = static_cast<long>(-3 * log2_of(g) - third) - 5;
    g -= d[2].with_precision(bits_of_start) * square(g) / slope;
  }
  g = g.middle();
  std::vector<double> goals;
  for (double goal = (static_cast<double>(bits) + bend) / 2 + 6;
       goal > static_cast<double>(good) && goals.size() < 64; goal = (goal + bend) / 2 + 4) {
    goals.push_back(goal);
  }
  const auto last_for = [&](precision fewer) {
    long last = series.last;
    while (last > 1 && series.bits[static_cast<std::size_t>(last)] <= fewer) --last;
    return last;
  };
  std::reverse(goals.begin(), goals.end());
  for (const double goal : goals) {
    const precision working = std::min(bits, whole_limbs(goal + 16));
    const precision fewer = bits - working;
    const precision fewer_of_slope = bits - std::min(bits, whole_limbs(goal / 2 + 16));
    g = g.with_precision(working).middle();
    const ball value = sum_of<false>(series, g, fewer, last_for(fewer)).with_precision(working);
    g = (g - value / sum_of<true>(series, g, fewer_of_slope, last_for(fewer_of_slope)))
            .with_precision(working)
            .middle();
  }
  return g;
}

}  // namespace

std::optional<legendre_zero> proved_zero(const legendre_shape& s, const local_series& series,
                                         precision bits) {
  if (contains_zero(series.coefficients[1])) return std::nullopt;
  const ball g = approximate_zero(series, bits);
  if (!g.is_bounded()) return std::nullopt;
  const auto reach_of = [&](const ball& x) {
    return max((series.scale * x).magnitude_upper(), magnitude::power_of_two(-bits));
  };
  const bool complete = series.last >= s.degree;  // the series is all of q
  const auto remainder = [&](const ball& x) {
    return legendre_taylor_remainder(s.n, series.last + 1, reach_of(x));
  };
  const auto value_of = [&](const ball& x) {
    const ball sum = sum_of<false>(series, x, 0, series.last);
    return complete ? sum : sum.enlarged(remainder(x).of_value);
  };
  const auto slope_of = [&](const ball& x, precision fewer) {
    ball sum = sum_of<true>(series, x, fewer, series.last);
    if (complete) return sum;
    return sum.enlarged(multiply_up(series.scale.magnitude_upper(), remainder(x).of_slope));
  };

  const ball value = value_of(g);
  const magnitude step =
      divide_up(value.magnitude_upper(), series.coefficients[1].magnitude_lower());
  if (step.is_infinite()) return std::nullopt;
  const ball neighbourhood =
      g.with_precision(bits).enlarged(add_up(scale(step, 2), magnitude::power_of_two(-bits)));
  const precision fewer =
      std::clamp(static_cast<precision>(-step.log2_floor()) - 32, precision{0}, bits / 2);
  // Of the value's bits only those below the step are left.
  const ball quotient = value.with_precision(bits - fewer) / slope_of(neighbourhood, fewer);
  const ball position = g.with_precision(bits) - quotient;
  if (!position.is_bounded() || !contains(neighbourhood, position)) return std::nullopt;
  return legendre_zero{series.centre + series.scale * position, slope_of(position, 0),
                       series.scale};
}

}  // namespace polhode::detail::legendre
