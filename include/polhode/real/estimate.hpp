#pragma once

// Integrals of black boxes: by Boost.Math's rules, with Boost's own estimate of the error. Nothing
// is proved.
//
//   const auto e = polhode::estimate(f, Real(0), Real(1));     // e.value, e.claimed_error
//
// For a function that takes one type only (a measurement, a simulation, a function of another
// library), of which nothing can be known between its values. The type of the result is of its own,
// so that it is never taken for a proved one.

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/sinh_sinh.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include "polhode/real/function.hpp"
#include "polhode/real/number.hpp"

namespace polhode {

enum class estimate_rule { automatic, tanh_sinh, exp_sinh, sinh_sinh, gauss_kronrod };

struct estimate_options {
  /// By default tanh_sinh for a finite range, exp_sinh for a half line, sinh_sinh for the line.
  estimate_rule rule = estimate_rule::automatic;
  /// Relative digits to ask for; by default two thirds of those of Real, which Boost's rules take
  /// for the square root of a unit in the last place.
  std::optional<long> digits = std::nullopt;
};

/// An integral of which nothing is proved.
template <floating_real Real>
struct estimated_integral {
  Real value{};
  /// What Boost says of the error: an estimate, which may be too small.
  Real claimed_error{};
  /// Of |f|.
  Real l1_norm{};
  std::string method;
};

/// The integral of f from a to b by Boost's rule, for ends in either order. f takes a Real and
/// returns one. Throws input_error for NaN ends and a rule that is not for the range; and what
/// Boost's rules throw (boost::math::evaluation_error).
template <floating_real Real, class F>
[[nodiscard]] estimated_integral<Real> estimate(const F& f, const Real& a, const Real& b,
                                                const estimate_options& options = {}) {
  if (a != a || b != b) {
    throw input_error("an end of the range is a NaN; it must be a number or an infinity");
  }
  if (a > b) {
    estimated_integral<Real> result = estimate<Real>(f, b, a, options);
    result.value = -result.value;
    return result;
  }
  const bool from_infinity = a - a != 0;
  const bool to_infinity = b - b != 0;
  estimate_rule rule = options.rule;
  if (rule == estimate_rule::automatic) {
    rule = from_infinity && to_infinity ? estimate_rule::sinh_sinh
                                        : (from_infinity || to_infinity ? estimate_rule::exp_sinh
                                                                        : estimate_rule::tanh_sinh);
  }
  precision p = usual_bits<Real>();
  if constexpr (detail::has_variable_precision<Real>)
    p = std::max(precision_of(a), precision_of(b));
  const detail::thread_precision<Real> scope(p);
  const long digits = options.digits.value_or(detail::digits_in_bits(p) * 2 / 3);
  if (digits < 1) {
    throw input_error("digits is " + std::to_string(digits) + "; it must be a number from 1");
  }
  using std::pow;
  const Real tolerance = pow(Real(10), static_cast<int>(-digits));
  const auto value = [&f](const Real& x) { return Real(f(x)); };
  estimated_integral<Real> result;
  using namespace boost::math::quadrature;
  switch (rule) {
    case estimate_rule::exp_sinh:
      if (from_infinity == to_infinity) {
        throw input_error("exp_sinh is for a range with one infinite end");
      }
      result.method = "exp_sinh";
      result.value = exp_sinh<Real>().integrate(value, a, b, tolerance, &result.claimed_error,
                                                &result.l1_norm);
      break;
    case estimate_rule::sinh_sinh:
      if (!from_infinity || !to_infinity) throw input_error("sinh_sinh is for the whole line");
      result.method = "sinh_sinh";
      result.value =
          sinh_sinh<Real>().integrate(value, tolerance, &result.claimed_error, &result.l1_norm);
      break;
    case estimate_rule::gauss_kronrod: {
      constexpr unsigned most_depth = 15;
      result.method = "gauss_kronrod 61";
      result.value = gauss_kronrod<Real, 61>::integrate(value, a, b, most_depth, tolerance,
                                                        &result.claimed_error, &result.l1_norm);
      break;
    }
    default:
      result.method = "tanh_sinh";
      result.value = tanh_sinh<Real>().integrate(value, a, b, tolerance, &result.claimed_error,
                                                 &result.l1_norm);
  }
  return result;
}

}  // namespace polhode
