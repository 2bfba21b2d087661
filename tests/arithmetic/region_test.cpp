// Regions: enclosures of analytic continuations against complex balls at members, and refusals
// where a function is not analytic.

#include "polhode/arithmetic/region.hpp"

#include <functional>

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "support/random.hpp"

namespace polhode {
namespace region_test {

region box(double re_low, double re_high, double im_low, double im_high) {
  return {double_interval(re_low, re_high), double_interval(im_low, im_high)};
}

/// Points of a rectangle, corners and edges among them.
std::vector<complex_ball> members(double re_low, double re_high, double im_low, double im_high) {
  constexpr precision p = 120;
  std::vector<complex_ball> points;
  for (const double s : {0.0, 0.25, 0.5, 1.0}) {
    for (const double t : {0.0, 0.375, 0.5, 1.0}) {
      const double re = std::clamp(re_low + s * (re_high - re_low), re_low, re_high);
      const double im = std::clamp(im_low + t * (im_high - im_low), im_low, im_high);
      points.emplace_back(ball::exactly(re, p), ball::exactly(im, p));
    }
  }
  return points;
}

template <class F>
void expect_holds_members(const char* name, const F& f, const region& z,
                          const std::vector<complex_ball>& points) {
  const region value = f(z);
  if (!value.is_analytic()) return;
  const complex_ball set = value.to_complex_ball();
  for (const complex_ball& point : points) {
    const complex_ball w = f(point);
    if (w.is_undefined()) continue;
    EXPECT_TRUE(overlaps(set.re, w.re) && overlaps(set.im, w.im))
        << name << " at " << point.re << " + i " << point.im;
  }
}

TEST(Region, HoldsTheValuesAtItsMembers) {
  support::random_source random(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random.bits() >> 11) * 0x1p-53;
  };
  for (int trial = 0; trial < static_cast<int>(300 * support::effort()) + 1; ++trial) {
    const double x = uniform(-3, 3);
    const double y = uniform(-3, 3);
    const double width = std::ldexp(1.0, -static_cast<int>(uniform(0, 20)));
    const region z = box(x, x + width, y, y + width);
    const auto points = members(x, x + width, y, y + width);
#define POLHODE_TRY(expression) \
  expect_holds_members(         \
      #expression, [](const auto& t) { return expression; }, z, points)
    POLHODE_TRY(sqrt(t));
    POLHODE_TRY(exp(t));
    POLHODE_TRY(log(t));
    POLHODE_TRY(sin(t));
    POLHODE_TRY(cos(t));
    POLHODE_TRY(tan(t));
    POLHODE_TRY(asin(t));
    POLHODE_TRY(acos(t));
    POLHODE_TRY(atan(t));
    POLHODE_TRY(sinh(t));
    POLHODE_TRY(cosh(t));
    POLHODE_TRY(tanh(t));
    POLHODE_TRY(asinh(t));
    POLHODE_TRY(acosh(t));
    POLHODE_TRY(atanh(t));
    POLHODE_TRY(square(t) + 3 * t - 1 / t);
    POLHODE_TRY(pow(t, -3));
    POLHODE_TRY(pow(t, 5));
    POLHODE_TRY(pow(t, t));
    POLHODE_TRY(exp(-t * t) / sqrt(1 - t * t / 2));
#undef POLHODE_TRY
  }
}

TEST(Region, RefusesWhatIsNotAnalytic) {
  const region across = box(-1, 1, -1, 1);
  const region on_cut = box(-2, -1, 0, 1);
  const region touching = box(0, 1, -1, 1);
  const region right = box(1, 2, -1, 1);
  const auto refused = [](const region& z, obstacle why, const char* where) {
    EXPECT_EQ(z.why(), why) << where;
    EXPECT_EQ(z.where(), where);
    EXPECT_FALSE(z.is_analytic());
    EXPECT_TRUE(z.magnitude_upper().is_infinite());
    EXPECT_TRUE(z.to_complex_ball().is_undefined());
  };
  refused(sqrt(across), obstacle::branch_cut, "sqrt");
  refused(sqrt(on_cut), obstacle::branch_cut, "sqrt");
  refused(sqrt(touching), obstacle::branch_cut, "sqrt");
  refused(log(across), obstacle::branch_cut, "log");
  refused(pow(across, region(double_interval(0.5))), obstacle::branch_cut, "pow");
  refused(pow(across, -1), obstacle::pole, "pow");
  refused(1 / across, obstacle::pole, "/");
  refused(1 / touching, obstacle::pole, "/");
  refused(tan(box(1, 2, -1, 1)), obstacle::pole, "tan");
  refused(tanh(box(-1, 1, 1, 2)), obstacle::pole, "tanh");
  refused(asin(right), obstacle::branch_cut, "asin");
  refused(acos(right), obstacle::branch_cut, "acos");
  refused(acosh(across), obstacle::branch_cut, "acosh");
  refused(atanh(right), obstacle::branch_cut, "atanh");
  refused(atan(box(-1, 1, 1, 2)), obstacle::branch_cut, "atan");
  refused(asinh(box(-1, 1, 1, 2)), obstacle::branch_cut, "asinh");
  refused(abs(across), obstacle::kink, "abs");
  refused(abs(touching), obstacle::kink, "abs");
  refused(min(across, region(double_interval(0))), obstacle::kink, "min");
  refused(max(right, region(double_interval(1.5))), obstacle::kink, "max");
  refused(floor(across), obstacle::jump, "floor");
  refused(floor(box(1, 1.5, -1, 1)), obstacle::jump, "floor");
  refused(ceil(box(1.5, 2, 0, 0)), obstacle::jump, "ceil");
  refused(region(double_interval::undefined()), obstacle::undefined, "argument");
  // The first obstacle is kept through whatever follows.
  refused(exp(sqrt(across)) * right + 1, obstacle::branch_cut, "sqrt");
  refused(right / sqrt(across), obstacle::branch_cut, "sqrt");
}

TEST(Region, ContinuesThePiecesOfRealFunctions) {
  const region right = box(0.5, 0.75, -1, 1);
  const region left = box(-0.75, -0.5, -1, 1);
  EXPECT_TRUE(contains(abs(left).re(), 0.5) && contains(abs(left).re(), 0.75));
  EXPECT_TRUE(abs(right).is_analytic());
  EXPECT_TRUE(contains(max(left, right).re(), 0.6) && !contains(max(left, right).re(), -0.6));
  EXPECT_TRUE(contains(min(left, right).re(), -0.6));
  EXPECT_TRUE(floor(right).is_analytic() && contains(floor(right).re(), 0.0));
  EXPECT_TRUE(ceil(right).is_analytic() && contains(ceil(right).re(), 1.0));
  EXPECT_TRUE(floor(left).is_analytic() && contains(floor(left).re(), -1.0));
}

TEST(Region, GoesOnBeyondTheRangeOfDoubles) {
  const region large = exp(region(double_interval(2000, 2000.5)));
  ASSERT_TRUE(large.is_analytic());
  EXPECT_TRUE(large.is_in_hardware());
  EXPECT_FALSE(large.magnitude_upper().is_infinite());
  const ball e2000 = exp(ball(2000, 100));
  EXPECT_TRUE(contains(large.to_complex_ball().re, e2000));
  // And back: the logarithm is near 2000 again, in hardware.
  const region back = log(large);
  ASSERT_TRUE(back.is_analytic());
  EXPECT_TRUE(back.is_in_hardware());
  EXPECT_TRUE(contains(back.re(), 2000.25));
  EXPECT_LT(back.re().width(), 0.51);
  const region tiny = 1 / large;
  EXPECT_FALSE(tiny.magnitude_lower().is_zero());
  // x^1000 e^-x at 3000: the power alone is 1e3477.
  const region x(double_interval(3000));
  const region product = pow(x, 1000) * exp(-x);
  ASSERT_TRUE(product.is_analytic());
  const ball exact = pow(ball(3000, 200), 1000) * exp(ball(-3000, 200));
  EXPECT_TRUE(overlaps(product.to_complex_ball().re, exact));
  EXPECT_LT(to_ball(double_interval(1), 64).precision(), 65);
}

// What a rectangle forgets: exp of a set with a large imaginary part lies in a ring.
TEST(Region, KnowsTheSizeOfRings) {
  const auto planck = [](const auto& x) { return x * x * x / (exp(x) - 1); };
  const auto fermi = [](const auto& x) { return 1 / (1 + exp(x)); };
  const auto sech = [](const auto& x) { return pow(cosh(x), -1); };
  const auto cosecant = [](const auto& x) { return 1 / sin(x); };
  const auto mixed = [](const auto& x) {
    return (x - 1 / (exp(-x) * 3 - square(exp(2 * x)))) / (sinh(x) - pow(cosh(x), 3) * exp(x));
  };
  const auto holds = [](const auto& f, double left, double right, double low, double high) {
    const region value = f(box(left, right, low, high));
    ASSERT_TRUE(value.is_analytic()) << value.where();
    for (const complex_ball& z : members(left, right, low, high)) {
      const complex_ball truth = f(z);
      const complex_ball set = value.to_complex_ball();
      EXPECT_TRUE(overlaps(set.re, truth.re) && overlaps(set.im, truth.im));
      EXPECT_TRUE(truth.magnitude_lower() <= value.magnitude_upper());
      EXPECT_TRUE(value.magnitude_lower() <= truth.magnitude_upper());
    }
  };
  for (const double left : {1.0, 2.5, 40.0, 700.0, 5000.0}) {
    for (const double height : {0.5, 4.0, 60.0}) {
      for (const double width : {0.0, 0.125, 1.5}) {
        holds(planck, left, left + width, -height, height / 2);
        holds(fermi, left, left + width, 0, height);
        holds(fermi, -left - width, -left, 0, height);
        holds(sech, left, left + width, -height, height);
        holds(sech, -left - width, -left, 1, height + 1);
        holds(cosecant, -height, height, left, left + width);
        holds([](const auto& x) { return -sqrt(square(x)) * exp(-x) / sinh(2 * x); }, left,
              left + width, 0, 0.5);
        if (left < 600) holds(mixed, left + 1, left + 1 + width / 8, 0, height);
      }
    }
  }
  // The size of the sum is not known to be away from 0.
  EXPECT_EQ(fermi(box(-0.5, 1, 0, 4)).why(), obstacle::pole);
  EXPECT_EQ(sech(box(-0.5, 1, 0, 4)).why(), obstacle::pole);
  EXPECT_EQ(planck(box(-0.5, 1, 0, 4)).why(), obstacle::pole);
  // The ring's upper bound serves too: |e^z| <= e, where the rectangle's corner is sqrt(2) e away.
  const region ring = exp(box(0, 1, 0, 7));
  EXPECT_TRUE(ring.magnitude_upper() <=
              (exp(ball(1, 64)) + ball::exactly(0x1p-40)).magnitude_upper());
  EXPECT_TRUE(magnitude::from_integer_up(1) <= scale(ring.magnitude_lower(), 1));
}

// Every function with a form of its own there, on sets whose values leave the range of doubles, and
// the ways back: against the same in balls.
TEST(Region, HoldsTheValuesBeyondTheRangeOfDoubles) {
  support::random_source random(4777);
  for (support::repeat trial(4000); trial.again();) {
    const auto number = [&](long size) {
      return static_cast<double>(random.between(-size, size)) / 64;
    };
    const double width = random.one_in(3) ? 0 : std::abs(number(300));
    const double left = number(200'000);
    const double low = number(2000);
    const region z(double_interval(left, left + width),
                   double_interval(low, low + std::abs(number(64))));
    const complex_ball at(ball(rational(left) + rational(width) / 3, 300),
                          ball(rational(z.im().upper()), 300));
    const long n = random.between(-3, 40);
    const auto holds = [&](const char* name, auto&& f) {
      SCOPED_TRACE(name);
      const region value = f(z);
      const complex_ball truth = f(at);
      if (!value.is_analytic() || is_undefined(truth)) return;
      const complex_ball set = value.to_complex_ball();
      EXPECT_TRUE(overlaps(set.re, truth.re) && overlaps(set.im, truth.im)) << set << ' ' << truth;
      EXPECT_TRUE(truth.magnitude_lower() <= value.magnitude_upper());
      EXPECT_TRUE(value.magnitude_lower() <= truth.magnitude_upper());
      EXPECT_TRUE(overlaps(to_ball(value.re(), 64), truth.re));
    };
    holds("exp", [](const auto& x) { return exp(x); });
    holds("sin", [](const auto& x) { return sin(x); });
    holds("cos", [](const auto& x) { return cos(x * x); });
    holds("sinh", [](const auto& x) { return sinh(x); });
    holds("cosh", [](const auto& x) { return cosh(x) - exp(x) * 3; });
    holds("pow", [n](const auto& x) { return pow(x, 11 * n) * pow(x + 1, -10 * n); });
    holds("product", [](const auto& x) { return exp(x) * exp(2 - x); });
    holds("sum", [](const auto& x) { return exp(x) + (exp(x - 3) - exp(2 - x)); });
    holds("quotient", [](const auto& x) { return (1 + exp(x)) / exp(x + 2000); });
    holds("root", [](const auto& x) { return sqrt(-exp(x / 50) * square(exp(x))); });
    holds("sech", [](const auto& x) { return x / cosh(x); });
  }
}

// An end that underflows to 0 in hardware is no pole and no branch point.
TEST(Region, KeepsTheSignOfWhatUnderflows) {
  const auto real = [](double low, double high) { return region(double_interval(low, high)); };
  const auto is_positive = [](const region& z) {
    if (!z.is_analytic()) return ::testing::AssertionFailure() << z.where();
    if (!certainly_positive(z.to_complex_ball().re)) {
      return ::testing::AssertionFailure() << "the sign is lost";
    }
    return ::testing::AssertionSuccess();
  };
  EXPECT_TRUE(is_positive(1 / real(1e-320, 1e-310)));
  EXPECT_TRUE(is_positive(1 / square(real(1e-200, 1))));
  EXPECT_TRUE(is_positive(sqrt(square(real(1e-200, 1)))));
  EXPECT_TRUE(is_positive(1 / (real(1e-200, 1) * real(1e-200, 2))));
  EXPECT_TRUE(is_positive(1 / (real(-1, -1e-200) * real(-1, -1e-200))));
  EXPECT_TRUE(is_positive(sqrt(exp(real(-1000, 0)))));
  EXPECT_TRUE(is_positive(-log(exp(real(-1000, -1)))));
  EXPECT_TRUE(is_positive(pow(pow(real(1e-200, 1), 2), -1)));
  EXPECT_TRUE(is_positive(abs(real(1e-300, 1) / real(1, 1e100))));
  EXPECT_TRUE(is_positive(1 / region(hull(parse_ball("1e-400", 64), ball(1, 64)))));
  // The set of squares is [1e-400, 1], whatever it is kept in.
  const complex_ball squares = square(real(1e-200, 1)).to_complex_ball();
  EXPECT_TRUE(contains(squares.re, parse_rational("1e-399")));
  EXPECT_FALSE(contains(squares.re, parse_rational("1e-401")));
  // What does end at 0 is refused as before.
  EXPECT_EQ((1 / square(real(0, 1))).why(), obstacle::pole);
  EXPECT_EQ(sqrt(real(0, 1) * real(1e-200, 1)).why(), obstacle::branch_cut);
  EXPECT_TRUE((real(0, 1) * real(0, 2)).is_in_hardware());
  EXPECT_TRUE((real(1, 2) - 1).is_in_hardware());
}

// A rectangle that reaches across the real axis by the least numbers there are has a reciprocal:
// the square of one side over the other is beyond all numbers.
TEST(Region, DividesByWhatReachesAcrossTheAxis) {
  const auto expect_near = [](const region& z, double lower, double upper) {
    ASSERT_TRUE(z.is_analytic());
    const complex_ball w = z.to_complex_ball();
    EXPECT_TRUE(certainly_positive(w.re));
    EXPECT_LE(upper_rational(w.re), rational(upper));
    EXPECT_GE(lower_rational(w.im), rational(lower));
  };
  const double_interval across(-5e-324, 1e5);
  const region hardware(double_interval(1e5, 2e5), across);
  expect_near(1 / hardware, -1e-5, 2e-5);
  const ball tiny = exp(ball(-744'000'000, 64));
  const ball big = parse_ball("1e34", 64);
  const region beyond = region::in_balls({hull(big, 10 * big), hull(-tiny, 9 * big)});
  expect_near(1 / beyond, -1e-34, 2e-34);
  EXPECT_TRUE((big / beyond).is_analytic());
}

TEST(Region, TakesBallsOfAnySize) {
  const region z(parse_ball("1e-400", 100));
  EXPECT_FALSE(z.is_in_hardware());
  EXPECT_TRUE(contains(z.to_complex_ball().re, parse_rational("1e-400")) ||
              overlaps(z.to_complex_ball().re, parse_ball("1e-400", 200)));
  EXPECT_TRUE(overlaps(sqrt(z).to_complex_ball().re, parse_ball("1e-200", 200)));
  EXPECT_TRUE(region(ball(2, 100)).is_in_hardware());
}

}  // namespace region_test
}  // namespace polhode
