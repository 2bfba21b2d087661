#include <array>
#include <cmath>

#include "arithmetic/functions/bernoulli.hpp"
#include "arithmetic/functions/gamma_series.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/arithmetic/special_functions.hpp"

// Stirling's series over regions: the series and the bound of its remainder are those of
// gamma_series.hpp, with sec^2(a/2) < 2 for Re w > 0.

namespace polhode {

namespace {

constexpr int terms = 8;               // N
constexpr double least_real_part = 7;  // of w

/// B_2, B_4, ..., B_16.
const std::array<rational, terms>& bernoulli_numbers() {
  static const std::array<rational, terms> numbers = [] {
    std::array<rational, terms> made;
    for (std::size_t k = 0; k < made.size(); ++k) made.at(k) = detail::bernoulli_number(k + 1);
    return made;
  }();
  return numbers;
}

/// All complex numbers whose parts are at most c 2^half_powers 7^-power in size.
region remainder(const rational& c, int half_powers, long power) {
  const double_interval most = abs(double_interval(c)) *
                               scale(double_interval(1), (half_powers + 1) / 2) /
                               pow(double_interval(least_real_part), power);
  const double_interval both(-most.upper(), most.upper());
  return {both, both};
}

/// How many steps of 1 lead to Re w >= 7, with some room for this difference's rounding.
long steps_from(const region& z) {
  return static_cast<long>(std::ceil(std::max(0.0, least_real_part + 0.01 - z.re().lower())));
}

/// log Gamma for Re z > 0.
region series_of_log(const region& z) {
  static const region error = remainder(bernoulli_numbers().back() / (2 * terms * (2 * terms - 1)),
                                        2 * terms, 2 * terms - 1);
  const long steps = steps_from(z);
  const region w = z + steps;
  const region inverse = 1 / w;
  const region inverse_square = square(inverse);
  region sum(double_interval(0));
  for (int k = terms - 1; k >= 1; --k) {
    const rational c =
        bernoulli_numbers().at(static_cast<std::size_t>(k - 1)) / (2 * k * (2 * k - 1));
    sum = sum * inverse_square + c;
  }
  region result = (w - rational(1, 2)) * log(w) - w + log(2 * pi(64)) / 2 + sum * inverse + error;
  for (long k = 0; k < steps; ++k) result -= log(z + k);
  return result;
}

/// The digamma function, the derivative of log Gamma; that of w = z + n less the sum of 1/(z + k)
/// over 0 <= k < n (DLMF 5.5.2), blocked at poles.
region series_of_derivative(const region& z) {
  static const region error =
      remainder(bernoulli_numbers().back() / (2 * terms), 2 * terms + 1, 2L * terms);
  const long steps = steps_from(z);
  const region w = z + steps;
  const region inverse = 1 / w;
  const region inverse_square = square(inverse);
  region sum(double_interval(0));
  for (int k = terms - 1; k >= 1; --k) {
    sum = sum * inverse_square + bernoulli_numbers().at(static_cast<std::size_t>(k - 1)) / (2 * k);
  }
  region result = log(w) - inverse / 2 - sum * inverse_square + error;
  for (long k = 0; k < steps; ++k) result -= 1 / (z + k);
  return result;
}

/// log Gamma at the middle of z; with all bits where z is kept in balls.
region log_at_middle(const complex_ball& set, const region& z) {
  const complex_ball middle = set.middle();
  if (z.is_in_hardware()) return series_of_log(region(middle));
  return region::in_balls(detail::log_gamma_by_series(middle));
}

bool is_right_of_zero(const region& z) { return certainly_positive(z.to_complex_ball().re); }

}  // namespace

region digamma(const region& z) {
  constexpr double most_steps = 1000;
  if (!z.is_analytic()) return z;
  if (z.re().lower() < -most_steps) return region::blocked(obstacle::unknown, "digamma");
  const region value = series_of_derivative(z);
  return value.is_analytic() ? value : region::blocked(obstacle::pole, "digamma");
}

region log_gamma(const region& z) {
  if (!z.is_analytic()) return z;
  // Of a set on both sides smaller ones may be right of 0.
  if (!is_right_of_zero(z)) {
    return region::blocked(z.re().upper() > 0 ? obstacle::branch_cut : obstacle::unknown,
                           "log_gamma");
  }
  // log Gamma(m) and z - m times a mean of the derivative over the segment between them.
  const complex_ball set = z.to_complex_ball();
  const auto as_z_is = [&](const complex_ball& w) {
    return z.is_in_hardware() ? region(w) : region::in_balls(w);
  };
  return log_at_middle(set, z) +
         as_z_is(set - set.middle()) * series_of_derivative(as_z_is(set)).convex_hull();
}

region gamma(const region& z) {
  if (!z.is_analytic()) return z;
  // Gamma(z) = Gamma(z + n)/(z (z + 1) ... (z + n - 1)), n such that Re z + n > 0.
  constexpr double most_steps = 1000;
  const double left = z.re().lower();
  if (left < -most_steps)
    return region::blocked(z.re().upper() > 0 ? obstacle::pole : obstacle::unknown, "gamma");
  const long steps = is_right_of_zero(z) ? 0 : static_cast<long>(std::floor(-left)) + 1;
  region divisor(double_interval(1));
  for (long k = 0; k < steps; ++k) divisor *= z + k;
  if (steps > 0 && contains_zero(divisor.to_complex_ball())) {
    return region::blocked(obstacle::pole, "gamma");
  }
  const region value = exp(log_gamma(z + steps));
  return steps == 0 ? value : value / divisor;
}

}  // namespace polhode
