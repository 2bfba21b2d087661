// Properties of integrate, for random functions and ranges.

#include <gtest/gtest.h>

#include "quadrature/known_integrals.hpp"

namespace polhode {
namespace integrate_property_test {

using support::holds;
using support::meet;

constexpr precision exact_bits = 700;

ball number(const rational& q) { return ball(q, exact_bits); }

rational between(support::random_source& random, const rational& low, const rational& high) {
  return low + (high - low) * rational(random.between(0, 1'000'000), 1'000'000);
}

/// Where it is certified the value is inside; and it is certified, where that is asked for.
void check(const integral& i, const ball& value, bool must_be_certified) {
  if (must_be_certified) {
    EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
  }
  if (i.enclosure.is_undefined()) {
    EXPECT_NE(i.verdict, status::certified);
    return;
  }
  EXPECT_TRUE(holds(i, value));
}

TEST(IntegrateProperty, OfSimpleFractionsIsTheirLogarithms) {
  // c/(x - p) + d/((x - u)^2 + v^2) with p outside of the range, as near as 10^-20 to it.
  support::random_source random(11);
  for (support::repeat trial(60); trial.again();) {
    const rational a = between(random, -3, 3);
    const rational b = between(random, -3, 3);
    if (a == b) continue;
    const rational gap =
        rational(1 + random.between(0, 8)) * support::power_of_ten(-random.between(0, 20));
    const rational p =
        random.one_in(2) ? rational(std::max(a, b) + gap) : rational(std::min(a, b) - gap);
    const rational c = random.between(-9, 9);
    const rational d = random.between(1, 9);
    const rational u = between(random, -3, 3);
    const rational v =
        rational(random.between(1, 9)) * support::power_of_ten(-random.between(0, 12));
    const long digits = random.between(1, 60);
    const integral i =
        integrate([=](const auto& x) { return c / (x - p) + d / (square(x - u) + v * v); },
                  end_point(a), end_point(b), {.digits = digits});
    const ball logs = c * log(number((b - p) / (a - p)));
    const ball angles = d / v * (atan(number((b - u) / v)) - atan(number((a - u) / v)));
    check(i, logs + angles, true);
  }
}

TEST(IntegrateProperty, OfExponentialsTimesSines) {
  // e^(cx) (A sin wx + B cos wx): the real part of an exponential's antiderivative.
  support::random_source random(12);
  for (support::repeat trial(60); trial.again();) {
    const rational a = between(random, -4, 4);
    const rational b = between(random, -4, 4);
    if (a == b) continue;
    const rational c = between(random, -8, 8);
    const rational w = between(random, 1, 60);
    const integral i = integrate([=](const auto& x) { return exp(c * x) * sin(w * x); },
                                 end_point(a), end_point(b), {.digits = random.between(1, 60)});
    const auto antiderivative = [&](const rational& x) {
      return exp(number(c * x)) * (c * sin(number(w * x)) - w * cos(number(w * x))) /
             rational(c * c + w * w);
    };
    check(i, antiderivative(b) - antiderivative(a), true);
  }
}

TEST(IntegrateProperty, OfPowersAndLogarithmsAtAnEnd) {
  // Of s^alpha log^k s, s the distance from an end: the integral over [0, h] by parts.
  support::random_source random(13);
  for (support::repeat trial(60); trial.again();) {
    const rational end = between(random, -3, 3);
    const rational h = rational(random.between(1, 1000), 250);
    const rational alpha(random.between(-5, 9), random.between(6, 8));
    const bool with_log = random.one_in(2);
    const bool from_right = random.one_in(2);
    const end_point near{end};
    const end_point far{rational(from_right ? end - h : end + h)};
    const auto f = [=](const auto& x) {
      const auto s = from_right ? end - x : x - end;
      const auto power = support::real_power(s, alpha);
      return with_log ? power * log(s) : power * 1;
    };
    const long digits = random.between(1, 50);
    const integral i = from_right ? integrate(f, far, near, {.digits = digits})
                                  : integrate(f, near, far, {.digits = digits});
    const ball power = pow(number(h), number(alpha + 1)) / (alpha + 1);
    check(i, with_log ? power * (log(number(h)) - 1 / number(alpha + 1)) : power, true);
  }
}

TEST(IntegrateProperty, IsAdditiveAndTurnsItsSign) {
  support::random_source random(14);
  const auto f = [](const auto& x) {
    return exp(sin(3 * x)) / (x * x + rational(1, 50)) + sqrt(x + 4) * log(5 - x);
  };
  for (support::repeat trial(40); trial.again();) {
    const end_point a{between(random, -4, 5)};
    const end_point b{between(random, -4, 5)};
    const end_point c{between(random, -4, 5)};
    const auto over = [&](const end_point& from, const end_point& to) {
      return integrate(f, from, to, {.digits = random.between(1, 40)}).enclosure;
    };
    EXPECT_TRUE(meet(over(a, b) + over(b, c), over(a, c)));
    EXPECT_TRUE(meet(over(a, b), -over(b, a)));
    EXPECT_TRUE(meet(over(a, b), over(a, b)));
  }
}

TEST(IntegrateProperty, DoesNotMindScalingAndReflection) {
  support::random_source random(15);
  for (support::repeat trial(30); trial.again();) {
    const rational a = between(random, 0, 1);
    const rational b = between(random, 1, 2);
    const rational k = rational(random.between(1, 50), random.between(1, 50));
    const rational q = between(random, 0, 3);
    const auto f = [=](const auto& x) { return abs(x - q) * atan(8 * x - 7) / sqrt(x + 1); };
    const integrate_options options{.digits = random.between(1, 25)};
    const ball plain = integrate(f, end_point(a), end_point(b), options).enclosure;
    const ball scaled = integrate([=](const auto& x) { return f(x * k); },
                                  end_point(rational(a / k)), end_point(rational(b / k)), options)
                            .enclosure;
    const ball reflected = integrate([=](const auto& x) { return f(-x); }, end_point(rational(-b)),
                                     end_point(rational(-a)), options)
                               .enclosure;
    EXPECT_TRUE(plain.is_bounded());
    EXPECT_TRUE(meet(plain, scaled * k));
    EXPECT_TRUE(meet(plain, reflected));
  }
}

}  // namespace integrate_property_test
}  // namespace polhode
