// Intervals of doubles, and doubles.

#include <cmath>
#include <limits>
#include <numbers>

#include "polhode/expression/evaluation.hpp"

namespace polhode::detail {

double_interval supplement<double_interval>::atan2(double_interval y, double_interval x) {
  constexpr precision bits = 64;
  return double_interval::from_ball(polhode::atan2(to_ball(y, bits), to_ball(x, bits)));
}

// ---------------------------------------------------------------------------------------------

namespace {

double arithmetic_geometric_mean(double x, double y) {
  if (!(x >= 0) || !(y >= 0)) return std::numeric_limits<double>::quiet_NaN();
  constexpr int enough = 60;  // the relative distance halves at least, and soon is squared
  for (int i = 0; i < enough && x != y; ++i) {
    const double mean = x / 2 + y / 2;
    y = std::sqrt(x) * std::sqrt(y);
    x = mean;
  }
  return x;
}

}  // namespace

/// The standard library's functions.
template <>
struct supplement<double> {
#define POLHODE_STD_OF_ONE_AS(name, f) \
  static double name(double x) { return std::f(x); }
#define POLHODE_STD_OF_ONE(f) POLHODE_STD_OF_ONE_AS(f, f)
#define POLHODE_STD_OF_TWO_AS(name, f) \
  static double name(double x, double y) { return std::f(x, y); }
  POLHODE_STD_OF_ONE(sqrt)
  POLHODE_STD_OF_ONE(abs)
  POLHODE_STD_OF_ONE(floor)
  POLHODE_STD_OF_ONE(ceil)
  POLHODE_STD_OF_ONE(exp)
  POLHODE_STD_OF_ONE(expm1)
  POLHODE_STD_OF_ONE(log)
  POLHODE_STD_OF_ONE(log1p)
  POLHODE_STD_OF_ONE(sin)
  POLHODE_STD_OF_ONE(cos)
  POLHODE_STD_OF_ONE(tan)
  POLHODE_STD_OF_ONE(asin)
  POLHODE_STD_OF_ONE(acos)
  POLHODE_STD_OF_ONE(atan)
  POLHODE_STD_OF_ONE(sinh)
  POLHODE_STD_OF_ONE(cosh)
  POLHODE_STD_OF_ONE(tanh)
  POLHODE_STD_OF_ONE(asinh)
  POLHODE_STD_OF_ONE(acosh)
  POLHODE_STD_OF_ONE(atanh)
  POLHODE_STD_OF_ONE(erf)
  POLHODE_STD_OF_ONE(erfc)
  POLHODE_STD_OF_ONE_AS(gamma, tgamma)
  POLHODE_STD_OF_ONE_AS(log_gamma, lgamma)
  POLHODE_STD_OF_TWO_AS(power, pow)
  POLHODE_STD_OF_TWO_AS(min, fmin)
  POLHODE_STD_OF_TWO_AS(max, fmax)
  POLHODE_STD_OF_TWO_AS(hypot, hypot)
  POLHODE_STD_OF_TWO_AS(atan2, atan2)
#undef POLHODE_STD_OF_ONE
#undef POLHODE_STD_OF_ONE_AS
#undef POLHODE_STD_OF_TWO_AS
  static double sinpi(double x) { return std::sin(std::numbers::pi * std::fmod(x, 2.0)); }
  static double cospi(double x) { return std::cos(std::numbers::pi * std::fmod(x, 2.0)); }
  static double agm(double x, double y) { return arithmetic_geometric_mean(x, y); }
  static double from(const ball& x) {
    const mpfr_float middle = midpoint(x);
    return mpfr_get_d(middle.backend().data(), MPFR_RNDN);
  }
  template <class F, class Range>
  static double further(const F& f, const Range& x) {
    return from(value_at_balls(f, x, [](double a) { return ball::exactly(a, 64); }));
  }
  static double power_integer(double x, long n) { return std::pow(x, static_cast<double>(n)); }
  static double root(double x, long n) {
    const double size = std::pow(std::abs(x), 1.0 / static_cast<double>(n));
    if (x >= 0) return size;
    return n % 2 != 0 ? -size : std::numeric_limits<double>::quiet_NaN();
  }
};

}  // namespace polhode::detail

namespace polhode {

template class compiled_expression<double_interval>;
template class compiled_expression<double>;

}  // namespace polhode
