// No root is cut from a box, whatever the operation and however the sides of the box lie.

#include <array>
#include <cmath>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/jet.hpp"
#include "polhode/expression/expression.hpp"
#include "roots/contraction.hpp"
#include "roots/hardware_system.hpp"
#include "support/random.hpp"

namespace polhode {
namespace contraction_test {

using detail::contraction;
using support::random_source;
using support::repeat;
using box = std::vector<double_interval>;

constexpr std::array operations = {
    "-x",         "x+y",          "x-y",         "x*y",      "x/y",      "x*x",        "x/x",
    "x^2",        "x^3",          "x^4",         "x^7",      "x^(-1)",   "x^(-2)",     "x^(-3)",
    "x^0.5",      "x^(1/3)",      "x^0.7",       "x^(-1/2)", "x^y",      "root(x,3)",  "root(x,4)",
    "root(x,5)",  "sqrt(x)",      "exp(x)",      "expm1(x)", "log(x)",   "log1p(x)",   "sin(x)",
    "cos(x)",     "tan(x)",       "sinpi(x)",    "cospi(x)", "asin(x)",  "acos(x)",    "atan(x)",
    "atan2(x,y)", "sinh(x)",      "cosh(x)",     "tanh(x)",  "asinh(x)", "acosh(x)",   "atanh(x)",
    "abs(x)",     "min(x,y)",     "max(x,y)",    "floor(x)", "ceil(x)",  "hypot(x,y)", "agm(x,y)",
    "gamma(x)",   "log_gamma(x)", "erf(x)",      "erfc(x)",  "max(x,x)", "min(x,x)",   "x^x",
    "hypot(x,x)", "x-x",          "1/x-y",       "x*x*y",    "sin(x*y)", "exp(x)*y",   "sqrt(x-y)",
    "log(x)/y",   "abs(x)-y",     "(x+y)*(x-y)", "x^2*y^3",  "tan(x)*y", "floor(x*y)"};

/// A number at which much may happen: an integer, a fraction, something huge or tiny, or pi/2 in
/// doubles.
double any_number(random_source& random) {
  switch (random.between(0, 9)) {
    case 0:
      return static_cast<double>(random.between(-4, 4));
    case 1:
      return std::ldexp(static_cast<double>(random.between(-9, 9)),
                        static_cast<int>(random.between(-300, 300)));
    case 2:
      return static_cast<double>(random.between(-4, 4)) * 0x1.921fb54442d18p+0;
    case 3:
      return std::nextafter(static_cast<double>(random.between(-2, 2)),
                            random.one_in(2) ? 9.0 : -9.0);
    default:
      return static_cast<double>(random.between(-4000, 4000)) / 1000;
  }
}

/// A set around a number; of that number alone, from it on, or up to it at times.
double_interval any_set_around(random_source& random, double low, double high) {
  const auto room = [&]() -> double {
    switch (random.between(0, 5)) {
      case 0:
        return 0;
      case 1:
        return detail::infinity;
      case 2:
        return std::ldexp(1.0, static_cast<int>(random.between(-60, 60)));
      default:
        return static_cast<double>(random.between(1, 3000)) / 1000;
    }
  };
  return {std::min(low, low - room()), std::max(high, high + room())};
}

ball exactly(double x) { return ball::exactly(x, 200); }

// z = f(x, y) is kept, for x and y in the box and z in a set that holds f(x, y).
TEST(Contraction, KeepsWhatIsThere) {
  const expression_names names{{"x", "y", "z"}, {}};
  random_source random(41);
  long defined = 0;
  for (const std::string of : operations) {
    const expression f(of + "-z", names);
    const expression value(of + "+0*z", names);
    contraction filter(f);
    for (repeat trial(3000); trial.again();) {
      const double x = any_number(random);
      const double y = any_number(random);
      const std::vector<ball> at{exactly(x), exactly(y), exactly(0)};
      const ball z = value.evaluator<ball>(200)(std::span<const ball>(at));
      if (!z.is_bounded()) continue;
      ++defined;
      const double_interval about = double_interval::from_ball(z);
      if (!about.is_bounded()) continue;
      const box whole{any_set_around(random, x, x), any_set_around(random, y, y),
                      any_set_around(random, about.lower(), about.upper())};
      box cut = whole;
      ASSERT_TRUE(filter.apply(cut)) << of << " at " << x << ", " << y << " in " << whole[0] << ' '
                                     << whole[1] << ' ' << whole[2];
      EXPECT_TRUE(contains(cut[0], x) && contains(cut[1], y) && overlaps(cut[2], about))
          << of << " at " << x << ", " << y << " in " << whole[0] << ' ' << whole[1] << ' '
          << whole[2] << ": " << cut[0] << ' ' << cut[1] << ' ' << cut[2];
      for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(contains(whole[i], cut[i])) << of;
    }
  }
  EXPECT_GT(defined, 20000 * support::effort());
}

// Over boxes on which f is defined; the derivatives beside those of jets of balls at points.
TEST(Contraction, ValuesAndGradientsHoldThoseAtPoints) {
  using slope = jet<ball, 1>;
  const expression_names names{{"x", "y"}, {}};
  random_source random(42);
  long compared = 0;
  for (const std::string of : operations) {
    const expression f(of + "+0*y", names);
    contraction filter(f);
    const auto at = f.evaluator<slope>(200);
    for (repeat trial(1500); trial.again();) {
      const double x = any_number(random);
      const double y = any_number(random);
      const box sets{any_set_around(random, x, x), any_set_around(random, y, y)};
      const double_interval value = filter.value(sets);
      const std::vector<double_interval> gradient = filter.gradient(sets);
      if (value.is_undefined()) {
        EXPECT_TRUE(gradient.empty());
        continue;
      }
      for (std::size_t i = 0; i < 2; ++i) {
        const std::vector<slope> point{
            i == 0 ? slope::variable(exactly(x)) : slope::constant(exactly(x)),
            i == 1 ? slope::variable(exactly(y)) : slope::constant(exactly(y))};
        const slope exact = at(std::span<const slope>(point));
        EXPECT_TRUE(exact[0].is_undefined() ||
                    overlaps(value, double_interval::from_ball(exact[0])))
            << of << ' ' << x << ' ' << y << ' ' << sets[0] << ' ' << sets[1] << ' ' << value;
        EXPECT_FALSE(exact[0].is_undefined()) << of << ' ' << x << ' ' << y;
        if (gradient.empty() || exact[1].is_undefined()) continue;
        ++compared;
        EXPECT_TRUE(overlaps(gradient[i], double_interval::from_ball(exact[1])))
            << of << ' ' << x << ' ' << y << ' ' << sets[0] << ' ' << sets[1] << ' ' << gradient[i];
      }
    }
  }
  EXPECT_GT(compared, 10000 * support::effort());
}

// The same of functions of one variable, from the variable to the result.
TEST(Contraction, SlopesFromTheVariableHoldThoseAtPoints) {
  using slope = jet<ball, 1>;
  random_source random(43);
  long compared = 0;
  for (const std::string of : operations) {
    const expression f(std::regex_replace(of, std::regex("\\by\\b"), "(2*x-1)"), {{"x"}, {}});
    if (f.variables().empty()) continue;
    contraction filter(f);
    const auto at = f.evaluator<slope>(200);
    for (repeat trial(1500); trial.again();) {
      const double x = any_number(random);
      const double_interval set = any_set_around(random, x, x);
      const auto [value, derivative] = filter.over(set);
      EXPECT_TRUE(derivative.is_undefined() || !value.is_undefined());
      if (value.is_undefined()) continue;
      const slope exact = at(slope::variable(exactly(x)));
      EXPECT_TRUE(overlaps(value, double_interval::from_ball(exact[0]))) << of << ' ' << x;
      if (derivative.is_undefined() || exact[1].is_undefined()) continue;
      ++compared;
      EXPECT_TRUE(overlaps(derivative, double_interval::from_ball(exact[1])))
          << f.to_text() << ' ' << x << ' ' << set << ' ' << derivative;
    }
  }
  EXPECT_GT(compared, 5000 * support::effort());
}

box cut_by(const std::string& f, box x) {
  contraction filter(expression(f, {{"x", "y"}, {}}));
  EXPECT_TRUE(filter.apply(x)) << f;
  return x;
}
bool leaves_nothing(const std::string& f, box x) {
  return !contraction(expression(f, {{"x", "y"}, {}})).apply(x);
}
const double_interval all(-detail::infinity, detail::infinity);

/// x in y, and no more than `room` wider at either end.
void expect_about(const double_interval& y, double low, double high, double room = 1e-12) {
  EXPECT_TRUE(y.lower() <= low && low - y.lower() <= room) << y << ' ' << low;
  EXPECT_TRUE(y.upper() >= high && y.upper() - high <= room) << y << ' ' << high;
}

TEST(Contraction, CutsWhatItCan) {
  expect_about(cut_by("x^2+y^2-1", {all, all})[0], -1, 1);
  expect_about(cut_by("x-y^3", {{8, 27}, all})[1], 2, 3);
  expect_about(cut_by("x-y^2", {{4, 9}, {0, 10}})[1], 2, 3);
  expect_about(cut_by("x-y^2", {{4, 9}, all})[1], -3, 3);
  expect_about(cut_by("sqrt(x)-y", {all, {0, 2}})[0], 0, 4);
  expect_about(cut_by("log(x)-y", {all, {0, 1}})[0], 1, std::exp(1.0));
  expect_about(cut_by("exp(x)-y", {all, {1, 4}})[0], 0, std::log(4.0));
  expect_about(cut_by("sin(x)-y", {{0, 3}, {0.5, 2}})[0], std::asin(0.5),
               std::acos(-1.0) - std::asin(0.5));
  expect_about(cut_by("cos(x)-y", {{-1, 1}, {-1, 0.8}})[0], -1, 1);
  expect_about(cut_by("cos(x)-y", {{0, 2}, {-0.5, 0.5}})[0], std::acos(0.5), 2);
  expect_about(cut_by("abs(x)-y", {{-5, 0.5}, {1, 2}})[0], -2, -1);
  expect_about(cut_by("x*y-6", {{-3, 3}, {2, 12}})[0], 0.5, 3);
  expect_about(cut_by("1/x-y", {all, {2, 4}})[0], 0.25, 0.5);
  expect_about(cut_by("x^(-2)-y", {{0, 9}, {0.25, 4}})[0], 0.5, 2);
  expect_about(cut_by("x^0.5-y", {all, {2, 3}})[0], 4, 9, 1e-11);
  expect_about(cut_by("floor(x)-y", {all, {1.5, 2.5}})[0], 2, 3);
  expect_about(cut_by("min(x,y)-2", {{0, 9}, {3, 9}})[0], 2, 2);
  expect_about(cut_by("max(x,y)-2", {{0, 9}, {0, 1}})[0], 2, 2);
  expect_about(cut_by("hypot(x,y)-5", {{0, 9}, {3, 4}})[0], 3, 4);
  expect_about(cut_by("atanh(x)-y", {all, {0, 1}})[0], 0, std::tanh(1.0));
  expect_about(cut_by("cosh(x)-y", {{0, 9}, {1, 2}})[0], 0, std::acosh(2.0));
  expect_about(cut_by("gamma(x)-y", {{0, 0.5}, {0, 9}})[1], std::sqrt(std::acos(-1.0)), 9);
  expect_about(cut_by("gamma(x)-y", {{0, 1}, {0, 9}})[1], 1, 9);
}

TEST(Contraction, LeavesNothingWhereThereIsNoRoot) {
  EXPECT_TRUE(leaves_nothing("x^2+y^2+1", {all, all}));
  EXPECT_TRUE(leaves_nothing("sqrt(x)+y", {{-2, -1}, all}));
  EXPECT_TRUE(leaves_nothing("log(x)+y", {{-2, 0}, all}));
  EXPECT_TRUE(leaves_nothing("exp(x)+y", {all, {0, 9}}));
  EXPECT_TRUE(leaves_nothing("1/x+y", {{0, 0}, all}));
  EXPECT_TRUE(leaves_nothing("sin(x)-y", {all, {2, 3}}));
  EXPECT_TRUE(leaves_nothing("floor(x)-y", {all, {0.25, 0.75}}));
  EXPECT_TRUE(leaves_nothing("asin(x)-y", {{2, 3}, all}));
  EXPECT_TRUE(leaves_nothing("abs(x)+1+0*y", {all, all}));
  // 0^y is 0 for y > 0, and no other power of 0 is.
  EXPECT_FALSE(leaves_nothing("x^0.7-y", {{-1, 0}, {0, 0}}));
  EXPECT_FALSE(leaves_nothing("x^y", {{0, 1}, {1, 2}}));
}

TEST(HardwareSystem, NewtonCutsToTheRoot) {
  const expression_names names{{"x", "y"}, {}};
  detail::hardware_system f({expression("x^2+y^2-4", names), expression("exp(x)-y", names)});
  box x{{0.5, 0.75}, {1.75, 2}};
  EXPECT_EQ(f.cut(x), detail::hardware_system::outcome::regular);
  EXPECT_TRUE(contains(x[0], 0.6392630748084189));
  EXPECT_LT(x[0].width(), 1e-14);
  box none{{1, 2}, {1, 2}};
  EXPECT_EQ(f.cut(none), detail::hardware_system::outcome::empty);
}

}  // namespace contraction_test
}  // namespace polhode
