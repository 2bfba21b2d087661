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

double real_root(double x, long n) {
  const double size = std::pow(std::abs(x), 1.0 / static_cast<double>(n));
  if (x >= 0) return size;
  return n % 2 != 0 ? -size : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

template <>
void execute(const instruction& i, double& r, const double& x, const double& y) {
  constexpr double pi = std::numbers::pi;
#define POLHODE_DOUBLE(f) \
  case operation::f:      \
    r = std::f(x);        \
    return;
  switch (i.what) {
    POLHODE_DOUBLE(sqrt)
    POLHODE_DOUBLE(abs)
    POLHODE_DOUBLE(floor)
    POLHODE_DOUBLE(ceil)
    POLHODE_DOUBLE(exp)
    POLHODE_DOUBLE(expm1)
    POLHODE_DOUBLE(log)
    POLHODE_DOUBLE(log1p)
    POLHODE_DOUBLE(sin)
    POLHODE_DOUBLE(cos)
    POLHODE_DOUBLE(tan)
    POLHODE_DOUBLE(asin)
    POLHODE_DOUBLE(acos)
    POLHODE_DOUBLE(atan)
    POLHODE_DOUBLE(sinh)
    POLHODE_DOUBLE(cosh)
    POLHODE_DOUBLE(tanh)
    POLHODE_DOUBLE(asinh)
    POLHODE_DOUBLE(acosh)
    POLHODE_DOUBLE(atanh)
    POLHODE_DOUBLE(erf)
    POLHODE_DOUBLE(erfc)
    case operation::add:
      r = x + y;
      return;
    case operation::subtract:
      r = x - y;
      return;
    case operation::multiply:
      r = x * y;
      return;
    case operation::divide:
      r = x / y;
      return;
    case operation::negate:
      r = -x;
      return;
    case operation::power_integer:
      r = std::pow(x, static_cast<double>(i.number));
      return;
    case operation::power:
      r = std::pow(x, y);
      return;
    case operation::root:
      r = real_root(x, i.number);
      return;
    case operation::sinpi:
      r = std::sin(pi * std::fmod(x, 2.0));
      return;
    case operation::cospi:
      r = std::cos(pi * std::fmod(x, 2.0));
      return;
    case operation::gamma:
      r = std::tgamma(x);
      return;
    case operation::log_gamma:
      r = std::lgamma(x);
      return;
    case operation::min:
      r = std::fmin(x, y);
      return;
    case operation::max:
      r = std::fmax(x, y);
      return;
    case operation::hypot:
      r = std::hypot(x, y);
      return;
    case operation::agm:
      r = arithmetic_geometric_mean(x, y);
      return;
    case operation::atan2:
      r = std::atan2(x, y);
      return;
    default: {
      ball value;
      execute<ball>(i, value, ball::exactly(x, 64), ball::exactly(y, 64));
      r = converted<double>(value);
      return;
    }
  }
#undef POLHODE_DOUBLE
}

}  // namespace polhode::detail

namespace polhode {

template class compiled_expression<double_interval>;
template class compiled_expression<double>;

}  // namespace polhode
