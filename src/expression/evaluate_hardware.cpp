// Intervals of doubles, and doubles.

#include <cmath>
#include <limits>
#include <numbers>

#include "polhode/expression/evaluation.hpp"

namespace polhode::detail {

using intervals = supplement<double_interval>;
using on_balls = supplement<ball>;

namespace {

constexpr precision ball_bits = 64;

/// What has no code in doubles goes by balls.
template <class F>
double_interval by_ball(double_interval x, F&& f) {
  return double_interval::from_ball(f(to_ball(x, ball_bits)));
}
template <class F>
double_interval by_balls(double_interval x, double_interval y, F&& f) {
  return double_interval::from_ball(f(to_ball(x, ball_bits), to_ball(y, ball_bits)));
}

/// Functions that are found by their arguments only, under names that no member of `supplement` hides.
double_interval size_of(double_interval x) { return abs(x); }
double_interval smaller(double_interval x, double_interval y) { return min(x, y); }
double_interval greater(double_interval x, double_interval y) { return max(x, y); }

}  // namespace

double_interval intervals::expm1(double_interval x) { return polhode::expm1(x); }
double_interval intervals::log1p(double_interval x) { return polhode::log1p(x); }
double_interval intervals::sinpi(double_interval x) { return by_ball(x, on_balls::sinpi); }
double_interval intervals::cospi(double_interval x) { return by_ball(x, on_balls::cospi); }
double_interval intervals::abs(double_interval x) { return size_of(x); }
double_interval intervals::floor(double_interval x) { return by_ball(x, on_balls::floor); }
double_interval intervals::ceil(double_interval x) { return by_ball(x, on_balls::ceil); }
double_interval intervals::min(double_interval x, double_interval y) { return smaller(x, y); }
double_interval intervals::max(double_interval x, double_interval y) { return greater(x, y); }
double_interval intervals::hypot(double_interval x, double_interval y) {
  return polhode::hypot(x, y);
}
double_interval intervals::agm(double_interval x, double_interval y) {
  return by_balls(x, y, on_balls::agm);
}
double_interval intervals::atan2(double_interval y, double_interval x) {
  return by_balls(y, x, on_balls::atan2);
}
double_interval intervals::power_integer(double_interval x, long n) { return pow(x, n); }
double_interval intervals::power(double_interval x, double_interval y) {
  return by_balls(x, y, on_balls::power);
}
double_interval intervals::root(double_interval x, long n) {
  return by_ball(x, [n](const ball& b) { return on_balls::root(b, n); });
}
double_interval intervals::gamma(double_interval x) { return by_ball(x, on_balls::gamma); }
double_interval intervals::log_gamma(double_interval x) { return by_ball(x, on_balls::log_gamma); }
double_interval intervals::erf(double_interval x) { return by_ball(x, on_balls::erf); }
double_interval intervals::erfc(double_interval x) { return by_ball(x, on_balls::erfc); }

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
    default:
      throw std::logic_error("an instruction without operands in the body of an expression");
  }
#undef POLHODE_DOUBLE
}

}  // namespace polhode::detail

namespace polhode {

template class compiled_expression<double_interval>;
template class compiled_expression<double>;

}  // namespace polhode
