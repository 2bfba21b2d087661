#include <array>
#include <cmath>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/arithmetic/special_functions.hpp"

// Stirling's series, for Re w > 0, with the Bernoulli numbers B_2k:
//
//   log Gamma(w) = (w - 1/2) log w - w + log(2 pi)/2 + sum over 0 < k < N of B_2k/(2k (2k-1)
//   w^(2k-1)) + R_N(w), R_N(w) = (1/2N) integral over t > 0 of (B_2N - B_2N({t})) (w + t)^(-2N) dt
//
// (Euler and Maclaurin; E. T. Whittaker, G. N. Watson, A Course of Modern Analysis, 12.33).
// B_2N({t}) is at most
// |B_2N| in size, so that the numerator has the sign of B_2N or is 0, and B_2N alternates in sign
// with N. So R_N(x) and R_(N+1)(x) have opposite signs for x > 0, and each is smaller than their
// difference: |R_N(x)| is at most the first term left out; and so for the derivative R_N', whose
// integral has (w + t)^(-2N-1). For complex w = |w| e^(i a): |w + t|^2 - (|w| + t)^2 cos^2(a/2) =
// (1 - cos a)/2 (|w| - t)^2 >= 0, so that
//   |R_N(w)| <= sec^(2N)(a/2) |R_N(|w|)|,  |R_N'(w)| <= sec^(2N+1)(a/2) |R_N'(|w|)|,
// with sec^2(a/2) < 2 for Re w > 0.

namespace polhode {

namespace {

constexpr int terms = 8;               // N
constexpr double least_real_part = 7;  // of w

/// B_2, B_4, ..., B_16.
const std::array<rational, terms>& bernoulli_numbers() {
  static const std::array<rational, terms> numbers{
      rational(1, 6),  rational(-1, 30),     rational(1, 42), rational(-1, 30),
      rational(5, 66), rational(-691, 2730), rational(7, 6),  rational(-3617, 510)};
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

/// The digamma function, the derivative of log Gamma, for Re z > 0.
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

/// A set around z, and its middle.
struct centred {
  region set;
  region middle;
};
centred about_middle(const region& z) {
  const complex_ball set = z.to_complex_ball();
  const complex_ball middle{real_set<ball>::middle(set.re), real_set<ball>::middle(set.im)};
  if (z.is_in_hardware()) return {region(set), region(middle)};
  return {region::in_balls(set), region::in_balls(middle)};
}

bool is_right_of_zero(const region& z) { return certainly_positive(z.to_complex_ball().re); }

}  // namespace

region log_gamma(const region& z) {
  if (!z.is_analytic()) return z;
  // Of a set on both sides smaller ones may be right of 0.
  if (!is_right_of_zero(z)) {
    return region::blocked(z.re().upper() > 0 ? obstacle::branch_cut : obstacle::unknown,
                           "log_gamma");
  }
  // log Gamma(m) and z - m times a mean of the derivative over the segment between them.
  const auto [set, m] = about_middle(z);
  return series_of_log(m) + (set - m) * series_of_derivative(set).convex_hull();
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
