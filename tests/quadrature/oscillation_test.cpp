// Integrals that converge by oscillation.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "quadrature/known_integrals.hpp"
#include "support/exact_set.hpp"
#include "support/integrals_as_text.hpp"

namespace polhode {
namespace oscillation_test {

using support::known;
using support::known_integral;
using support::real_power;

const end_point infinity = end_point::infinity();
ball number(long n, precision p) { return ball(n, p); }
ball half_pi(precision p) { return pi(p) / 2; }

const std::string rotated = "derivation: residue at i, or at 1 + i";

std::vector<known_integral> oscillating() {
  return {
      known(
          "sin(x)/x", "DLMF 6.2.14", [](const auto& x) { return sin(x) / x; }, 0, infinity,
          half_pi),
      known(
          "sin(x)/x both ways", "DLMF 6.2.14", [](const auto& x) { return sin(x) / x; }, -infinity,
          infinity, [](precision p) { return pi(p); }),
      known(
          "sin(x)^2/x^2", "derivation: by parts", [](const auto& x) { return square(sin(x) / x); },
          0, infinity, half_pi),
      known(
          "(sin(x)/x)^8", "derivation: by parts, seven times",
          [](const auto& x) { return pow(sin(x) / x, 8); }, 0, infinity,
          [](precision p) { return 151 * pi(p) / 630; }),
      known(
          "(1-cos(x))/x^2", "derivation: by parts",
          [](const auto& x) { return (1 - cos(x)) / square(x); }, 0, infinity, half_pi),
      known(
          "sin(x)sin(2x)/x^2", "derivation: half of pi min(1, 2)",
          [](const auto& x) { return sin(x) * sin(2 * x) / square(x); }, 0, infinity, half_pi),
      known(
          "cos(x)/(1+x^2)", rotated, [](const auto& x) { return cos(x) / (1 + square(x)); }, 0,
          infinity, [](precision p) { return pi(p) / (2 * exp(number(1, p))); }),
      known(
          "x sin(x)/(1+x^2)", rotated, [](const auto& x) { return x * sin(x) / (1 + square(x)); },
          0, infinity, [](precision p) { return pi(p) / (2 * exp(number(1, p))); }),
      known(
          "cos(x)/((x-1)^2+1)", rotated, [](const auto& x) { return cos(x) / (square(x - 1) + 1); },
          -infinity, infinity,
          [](precision p) { return pi(p) * cos(number(1, p)) / exp(number(1, p)); }),
      known(
          "sin(x)/((x-1)^2+1)", rotated, [](const auto& x) { return sin(x) / (square(x - 1) + 1); },
          -infinity, infinity,
          [](precision p) { return pi(p) * sin(number(1, p)) / exp(number(1, p)); }),
      known(
          "Fresnel", "DLMF 7.2.9", [](const auto& x) { return sin(square(x)); }, 0, infinity,
          [](precision p) { return sqrt(pi(p) / 8); }),
      known(
          "sin(x)/sqrt(x)", "DLMF 5.9.7",
          [](const auto& x) { return sin(x) * real_power(x, rational(-1, 2)); }, 0, infinity,
          [](precision p) { return sqrt(pi(p) / 2); }),
      known(
          "sin(1/x)/x", "DLMF 6.2.14", [](const auto& x) { return sin(1 / x) / x; }, 0, infinity,
          half_pi),
      known(
          "sin(1/(1-x))/(1-x)", "the same to 1, with 1 - x for x",
          [](const auto& x) { return sin(1 / (x - 1)) / (x - 1); }, -infinity, 1, half_pi),
      known(
          "sin(x+1/x)(1-1/x^2)/(x+1/x)", "derivation: x + 1/x as the variable",
          [](const auto& x) { return sin(x + 1 / x) * (1 - 1 / square(x)) / (x + 1 / x); }, 1,
          infinity,
          // With v = x + 1/x >= 2: the integral of sin(v)/v from 2.
          [](precision p) {
            ball sum(0, p);
            ball term(2, p);
            for (long k = 1; k < 200; k += 2) {
              sum += term / k;
              term *= ball(rational(-4, (k + 1) * (k + 2)), p);
            }
            return half_pi(p) - sum;
          }),
  };
}

TEST(Oscillation, OfClosedForms) {
  for (const known_integral& k : oscillating()) {
    for (const long digits : {12L, 60L}) {
      const integral i = k.run({.digits = digits});
      EXPECT_EQ(i.verdict, status::certified) << k.name << ": " << i.obstacle;
      EXPECT_TRUE(support::holds(i, k.value(400))) << k.name;
      EXPECT_LE(i.account.evaluations, 2000) << k.name;
    }
  }
}

// Another way to the same: a range cut in two, of which the first part has no end at infinity.
TEST(Oscillation, DoesNotDependOnTheStart) {
  const auto f = [](const auto& x) {
    return cos(3 * x - rational(1, 2)) * sin(x) * log(x) / (x + rational(1, 3));
  };
  const integrate_options options{.digits = 40};
  const integral whole = integrate(f, 1, infinity, options);
  ASSERT_EQ(whole.verdict, status::certified) << whole.obstacle;
  for (const long start : {2L, 7L, 40L}) {
    const integral first = integrate(f, 1, start, options);
    const integral rest = integrate(f, start, infinity, options);
    EXPECT_EQ(rest.verdict, status::certified) << rest.obstacle;
    EXPECT_TRUE(overlaps(first.enclosure + rest.enclosure, whole.enclosure)) << start;
    EXPECT_TRUE((first.enclosure + rest.enclosure).radius() <= magnitude::power_of_two(-120));
  }
}

// The square of a cosine has a term whose frequency is 0.
TEST(Oscillation, KnowsFrequenciesThatCancel) {
  const auto g = [](const auto& x) { return square(cos(rational(7, 5) * x)) / (1 + square(x)); };
  const integral i = integrate(g, 0, infinity, {.digits = 50});
  EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
  const ball value = pi(300) / 4 * (1 + exp(ball(rational(-14, 5), 300)));
  EXPECT_TRUE(support::holds(i, value));
}

template <class F>
void refused(const char* name, F f, const end_point& a, const end_point& b, reason why) {
  const integral i = integrate(f, a, b, {.digits = 10});
  EXPECT_EQ(i.verdict, status::not_certified) << name;
  EXPECT_EQ(i.why, why) << name << ": " << i.obstacle;
  EXPECT_FALSE(i.enclosure.is_bounded()) << name << ": " << i.enclosure;
}

TEST(Oscillation, IsNoDecay) {
  refused(
      "sin(x)", [](const auto& x) { return sin(x); }, 0, infinity, reason::not_integrable);
  refused(
      "x sin(x)", [](const auto& x) { return x * sin(x); }, 0, infinity, reason::not_integrable);
  refused(
      "x sin(x)/(x+1)", [](const auto& x) { return x * sin(x) / (x + 1); }, 0, infinity,
      reason::not_integrable);
  // What does not oscillate diverges.
  refused(
      "sin(x)^2/x", [](const auto& x) { return square(sin(x)) / x; }, 1, infinity,
      reason::not_integrable);
  refused(
      "(1+sin(x))/x", [](const auto& x) { return (1 + sin(x)) / x; }, 1, infinity,
      reason::not_integrable);
  refused(
      "tan(x)/x^2", [](const auto& x) { return tan(x) / square(x); }, 2, infinity,
      reason::not_analytic);
  refused(
      "1/(2+sin(x))/x", [](const auto& x) { return 1 / (2 + sin(x)) / x; }, 1, infinity,
      reason::not_integrable);
  refused(
      "sin(x^2+sin(x))", [](const auto& x) { return sin(square(x) + sin(x)); }, 0, infinity,
      reason::not_analytic);
  refused(
      "sin(1/x)/x^2", [](const auto& x) { return sin(1 / x) / pow(x, 2); }, 0, 1,
      reason::not_analytic);
}

// On the line up from 2 or 4, 1 + z^4 crosses the cut of sqrt and log, z^2 those of asinh and atan:
// what principal values are beyond is not the continuation of the function.
TEST(Oscillation, IsNotContinuedThroughCuts) {
  const auto check = [](const char* name, const auto& f, const char* value) {
    for (const long digits : {2L, 4L, 6L, 10L, 30L}) {
      for (const quadrature_rule rule :
           {quadrature_rule::automatic, quadrature_rule::clenshaw_curtis}) {
        const integral i = integrate(f, 1, infinity, {.digits = digits, .rule = rule});
        const ball near = ball(parse_rational(value), 100).enlarged(magnitude::power_of_two(-40));
        EXPECT_TRUE(!i.enclosure.is_bounded() || overlaps(i.enclosure, near))
            << name << ", " << digits << " digits: " << i.enclosure;
      }
    }
  };
  // Values by summing over half-periods (with another program, to 12 digits).
  check(
      "sqrt", [](const auto& x) { return sin(x) * sqrt(1 + pow(x, 4)) / pow(x, 3); },
      "0.725824637823");
  check(
      "log", [](const auto& x) { return sin(x) * log(1 + pow(x, 4)) / x; }, "0.484321800014");
}

TEST(Oscillation, OfNestedPowersIsGivenUpSoon) {
  const auto f = [](const auto& x) {
    auto v = 3 * x;
    for (int k = 0; k < 12; ++k) v = pow(v, 16);
    return sin(x) / v;
  };
  const integral i = integrate(f, 1, infinity, {.digits = 5, .most_evaluations = 1000});
  EXPECT_TRUE(i.verdict == status::not_certified || i.enclosure.is_bounded());
}

TEST(Oscillation, OfAnUnknownFrequencyIsRefused) {
  const ball w = ball(0, 64).enlarged(magnitude::power_of_two(-40));
  const integral i =
      integrate([=](const auto& x) { return sin(w * x) / x; }, 1, infinity, {.digits = 10});
  EXPECT_EQ(i.verdict, status::not_certified);
  EXPECT_FALSE(i.enclosure.is_bounded());
}

// The quadrature takes w as the set that it is: the integrals for all its members.
TEST(Oscillation, HoldsTheIntegralsForAllFrequencies) {
  const ball w = ball(1, 64).enlarged(magnitude::power_of_two(-10));
  const auto f = [=](const auto& x) { return cos(w * x) / (1 + square(x)); };
  const integral i = integrate(f, 0, infinity, {.digits = 2});
  for (const rational& member : {rational(1023, 1024), rational(1), rational(1025, 1024)}) {
    EXPECT_TRUE(support::holds(i, half_pi(300) * exp(ball(rational(-member), 300))));
  }
  EXPECT_TRUE(i.enclosure.radius() <= magnitude::power_of_two(-3));
}

TEST(Oscillation, IsTheSameOnThreads) {
  const auto f = [](const auto& x) { return sin(x) / x; };
  const integral one = integrate(f, 0, infinity, {.digits = 100});
  const integral two = integrate(f, 0, infinity, {.digits = 100, .threads = 2});
  EXPECT_TRUE(support::identical(one.enclosure, two.enclosure));
}

// A factor that tends to 1 or -1 beside what oscillates: the limit and the rest, of one formula.
TEST(Oscillation, FactorsWithLimits) {
  struct split {
    const char* f;
    const char* limit;
    const char* rest;
  };
  for (const auto& [f, limit, rest] :
       {split{"tanh(x)*sin(x)/x", "sin(x)/x", "-2/(exp(2*x)+1)*sin(x)/x"},
        split{"cos(3*x)/(tanh(-x/2)*sqrt(x))", "-cos(3*x)/sqrt(x)",
              "-2/(exp(x)-1)*cos(3*x)/sqrt(x)"},
        split{"-erf(x-1)*sin(x)/x", "-sin(x)/x", "erfc(x-1)*sin(x)/x"},
        split{"sin(x)/(x*(1+exp(-x)))", "sin(x)/x", "-sin(x)/(x*(1+exp(x)))"},
        split{"cos(x)/((exp(-2*x)+1)*x)", "cos(x)/x", "-cos(x)/(x*(1+exp(2*x)))"}}) {
    const auto over = [](const char* g) { return support::integral_of(g, "1", "inf"); };
    const integral whole = over(f);
    EXPECT_EQ(whole.verdict, status::certified) << f << ": " << whole.obstacle;
    EXPECT_TRUE(overlaps(whole.enclosure, over(limit).enclosure + over(rest).enclosure)) << f;
  }
  for (const char* f : {"tanh(x)*sin(x)", "sin(x)^2*tanh(x)/x", "cos(x)/(1+exp(-x))"}) {
    EXPECT_EQ(support::integral_of(f, "1", "inf").verdict, status::not_certified) << f;
  }
  EXPECT_EQ(support::integral_of("tanh(x)*cos(x)/x", "-inf", "inf").verdict, status::certified);
}

}  // namespace oscillation_test
}  // namespace polhode
