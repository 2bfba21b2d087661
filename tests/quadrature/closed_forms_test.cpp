// integrate against closed forms.

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/special_functions.hpp"
#include "quadrature/known_integrals.hpp"
#include "support/exact_set.hpp"

namespace polhode {
namespace closed_forms_test {

using support::known;
using support::known_integral;
using support::known_zero;
using support::power_of_ten;
using support::real_power;
using support::right;
using support::sum_of_series;

const end_point infinity = end_point::infinity();
const auto pi_limit = [](const rational& factor) {
  return end_point([factor](precision p) { return pi(p) * factor; });
};
const auto exactly = [](const rational& q) { return [q](precision p) { return ball(q, p); }; };
ball number(long n, precision p) { return ball(n, p); }
ball gamma_at(const rational& q, precision p) { return gamma(ball(q, p)); }
ball factorial(long n, precision p) { return gamma(ball(n + 1, p)); }

const std::string antiderivative = "derivation: antiderivative";
const std::string odd = "derivation: odd function";

/// Analytic on the closed range.
std::vector<known_integral> smooth() {
  return {
      known(
          "constant", antiderivative, [](const auto&) { return rational(22, 7); }, 0, 5,
          exactly(rational(110, 7))),
      known(
          "polynomial", antiderivative, [](const auto& x) { return pow(x, 7) - 3 * x * x + 1; }, -1,
          2, exactly(rational(207, 8))),
      known(
          "x^100", antiderivative, [](const auto& x) { return pow(x, 100); }, 0, 1,
          exactly(rational(1, 101))),
      known(
          "1/(1+x^2)", antiderivative, [](const auto& x) { return 1 / (1 + x * x); }, 0, 1,
          [](precision p) { return pi(p) / 4; }),
      known(
          "1/x", antiderivative, [](const auto& x) { return 1 / x; }, 1, 2,
          [](precision p) { return log(number(2, p)); }),
      known(
          "Runge", antiderivative, [](const auto& x) { return 1 / (1 + 25 * x * x); }, -1, 1,
          [](precision p) { return 2 * atan(number(5, p)) / 5; }),
      known(
          "1/(1+x+x^2)", antiderivative, [](const auto& x) { return 1 / (1 + x + x * x); }, 0, 1,
          [](precision p) { return pi(p) / (3 * sqrt(number(3, p))); }),
      known(
          "1/(x^2-2)", antiderivative, [](const auto& x) { return 1 / (x * x - 2); }, 2, 3,
          [](precision p) {
            const ball r = sqrt(number(2, p));
            return (log((3 - r) / (3 + r)) - log((2 - r) / (2 + r))) / (2 * r);
          }),
      known(
          "x^4(1-x)^4/(1+x^2)", "derivation: polynomial division",
          [](const auto& x) { return pow(x * (1 - x), 4) / (1 + x * x); }, 0, 1,
          [](precision p) { return rational(22, 7) - pi(p); }),
      known(
          "sin", antiderivative, [](const auto& x) { return sin(x); }, 0, pi_limit(1), exactly(2)),
      known(
          "cos", antiderivative, [](const auto& x) { return cos(x); }, 0, 1,
          [](precision p) { return sin(number(1, p)); }),
      known(
          "sin^2", antiderivative, [](const auto& x) { return square(sin(x)); }, 0, pi_limit(2),
          [](precision p) { return pi(p); }),
      known(
          "x^2 to pi", antiderivative, [](const auto& x) { return x * x; }, 0, pi_limit(1),
          [](precision p) { return pow(pi(p), 3) / 3; }),
      known(
          "1/(2+cos)", "GR 3.613.1", [](const auto& x) { return 1 / (2 + cos(x)); }, 0, pi_limit(2),
          [](precision p) { return 2 * pi(p) / sqrt(number(3, p)); }),
      known(
          "sin(1000x)", antiderivative, [](const auto& x) { return sin(1000 * x); }, 0, 1,
          [](precision p) { return (1 - cos(number(1000, p))) / 1000; }),
      known(
          "cos(x)exp(-x)", antiderivative, [](const auto& x) { return cos(x) * exp(-x); }, 0, 10,
          [](precision p) {
            return (exp(number(-10, p)) * (sin(number(10, p)) - cos(number(10, p))) + 1) / 2;
          }),
      known(
          "exp", antiderivative, [](const auto& x) { return exp(x); }, 0, 1,
          [](precision p) { return exp(number(1, p)) - 1; }),
      known(
          "exp reversed", antiderivative, [](const auto& x) { return exp(x); }, 1, 0,
          [](precision p) { return 1 - exp(number(1, p)); }),
      known(
          "x exp(x)", antiderivative, [](const auto& x) { return x * exp(x); }, 0, 1, exactly(1)),
      known(
          "tan", antiderivative, [](const auto& x) { return tan(x); }, 0, 1,
          [](precision p) { return -log(cos(number(1, p))); }),
      known(
          "tanh", antiderivative, [](const auto& x) { return tanh(x); }, 0, 3,
          [](precision p) { return log(cosh(number(3, p))); }),
      known(
          "sinh", antiderivative, [](const auto& x) { return sinh(x); }, -1, 3,
          [](precision p) { return cosh(number(3, p)) - cosh(number(1, p)); }),
      known(
          "atan", antiderivative, [](const auto& x) { return atan(x); }, 0, 1,
          [](precision p) { return pi(p) / 4 - log(number(2, p)) / 2; }),
      known(
          "asinh", antiderivative, [](const auto& x) { return asinh(x); }, 0, 1,
          [](precision p) {
            const ball r = sqrt(number(2, p));
            return log(1 + r) - r + 1;
          }),
  };
}

/// Poles near the range, and sizes far from 1.
std::vector<known_integral> extreme() {
  const rational tiny = power_of_ten(-30);
  const rational huge = power_of_ten(2000);
  return {
      known(
          "1/(x^2+1e-20)", antiderivative,
          [](const auto& x) { return 1 / (x * x + power_of_ten(-20)); }, -1, 1,
          [](precision p) {
            const rational n = power_of_ten(10);
            return 2 * n * atan(ball(n, p));
          }),
      known(
          "1/(x+1e-30)", antiderivative, [=](const auto& x) { return 1 / (x + tiny); }, 0, 1,
          [=](precision p) { return log(ball(rational((1 + tiny) / tiny), p)); }),
      known(
          "1/(1+1e-30-x)", antiderivative, [=](const auto& x) { return 1 / ((1 + tiny) - x); }, 0,
          1, [=](precision p) { return log(ball(rational((1 + tiny) / tiny), p)); }),
      known(
          "1/((x-1/3)^2+1e-60)", antiderivative,
          [=](const auto& x) { return 1 / (square(x - rational(1, 3)) + tiny * tiny); }, 0, 1,
          [=](precision p) {
            const rational n = 1 / tiny;
            return n * (atan(ball(rational(2 * n / 3), p)) + atan(ball(rational(n / 3), p)));
          }),
      known(
          "1e2000 x^2", antiderivative, [=](const auto& x) { return huge * x * x; }, 0, 1,
          exactly(rational(huge / 3))),
      known(
          "1e-2000 cos", antiderivative, [=](const auto& x) { return cos(x) / huge; }, 0, 1,
          [=](precision p) { return sin(number(1, p)) / huge; }),
      known(
          "exp(5000x)", antiderivative, [](const auto& x) { return exp(5000 * x); }, 0, 1,
          [](precision p) { return (exp(number(5000, p)) - 1) / 5000; }),
      known(
          "exp(-5000-x)", antiderivative, [](const auto& x) { return exp(-5000 - x); }, 0, 1,
          [](precision p) { return exp(number(-5000, p)) - exp(number(-5001, p)); }),
      known(
          "tiny range", antiderivative, [](const auto& x) { return exp(x); }, 0,
          end_point(power_of_ten(-300)),
          [](precision p) { return expm1(ball(power_of_ten(-300), p)); }),
      known(
          "tiny range far from 0", antiderivative, [](const auto& x) { return 1 / x; }, 1,
          end_point(rational(1 + power_of_ten(-40))),
          [](precision p) { return log1p(ball(power_of_ten(-40), p)); }),
      known(
          "huge range", antiderivative, [](const auto& x) { return 1 / (1 + x * x); }, 0,
          end_point(power_of_ten(100)),
          [](precision p) { return atan(ball(power_of_ten(100), p)); }),
      known(
          "exp(-x) to 1e6", antiderivative, [](const auto& x) { return exp(-x); }, 0, 1'000'000,
          [](precision p) { return 1 - exp(number(-1'000'000, p)); }),
      known(
          "sech^2(1e4(x-0.6123))", antiderivative,
          [](const auto& x) { return 1 / square(cosh((x - rational(6123, 10'000)) * 10'000)); }, 0,
          1, [](precision p) { return (tanh(number(3877, p)) + tanh(number(6123, p))) / 10'000; }),
  };
}

/// Singular at an end: x^a, logarithms, and both.
std::vector<known_integral> singular() {
  const rational half(1, 2);
  const rational third(1, 3);
  return {
      known(
          "x^(-1/2)", antiderivative, [](const auto& x) { return 1 / sqrt(x); }, 0, 1, exactly(2)),
      known(
          "x^(-1/2) reversed", antiderivative, [](const auto& x) { return 1 / sqrt(x); }, 1, 0,
          exactly(-2)),
      known(
          "x^(-2/3)", antiderivative, [](const auto& x) { return real_power(x, rational(-2, 3)); },
          0, 1, exactly(3)),
      known(
          "(1-x)^(1/3)", antiderivative, [=](const auto& x) { return real_power(1 - x, third); }, 0,
          1, exactly(rational(3, 4))),
      known(
          "x^(-1/2) log x", "GR 4.253.1 at mu = 1/2, nu = 1",
          [](const auto& x) { return log(x) / sqrt(x); }, 0, 1, exactly(-4)),
      known(
          "log", antiderivative, [](const auto& x) { return log(x); }, 0, 1, exactly(-1)),
      known(
          "log^2", antiderivative, [](const auto& x) { return square(log(x)); }, 0, 1, exactly(2)),
      known(
          "log(1-x)", antiderivative, [](const auto& x) { return log(1 - x); }, 0, 1, exactly(-1)),
      known(
          "x log x", antiderivative, [](const auto& x) { return x * log(x); }, 0, 1,
          exactly(rational(-1, 4))),
      known(
          "sqrt(x) exp(x)", "derivation: term by term",
          [](const auto& x) { return sqrt(x) * exp(x); }, 0, 1,
          [](precision p) {
            return sum_of_series(p, [p](long n) { return 2 / ((2 * n + 3) * factorial(n, p)); });
          }),
      known(
          "sqrt(x) exp(-x)", "DLMF 8.4.1 and 8.8.1",
          [](const auto& x) { return sqrt(x) * exp(-x); }, 0, 1,
          [](precision p) { return sqrt(pi(p)) * erf(number(1, p)) / 2 - exp(number(-1, p)); }),
      known(
          "1/sqrt(1-x^2)", antiderivative, [](const auto& x) { return 1 / sqrt(1 - x * x); }, -1, 1,
          [](precision p) { return pi(p); }),
      known(
          "4 sqrt(1-x^2)", antiderivative, [](const auto& x) { return 4 * sqrt(1 - x * x); }, 0, 1,
          [](precision p) { return pi(p); }),
      known(
          "x/sqrt(x^2-1/4)", antiderivative,
          [](const auto& x) { return x / sqrt(x * x - rational(1, 4)); }, end_point(half), 1,
          [](precision p) { return sqrt(number(3, p)) / 2; }),
      known(
          "sqrt(x(1-x))", "DLMF 5.12.1", [](const auto& x) { return sqrt(x * (1 - x)); }, 0, 1,
          [](precision p) { return pi(p) / 8; }),
      known(
          "x^(1/3) (1-x)^(-1/4)", "DLMF 5.12.1",
          [=](const auto& x) { return real_power(x, third) * real_power(1 - x, rational(-1, 4)); },
          0, 1,
          [](precision p) {
            return gamma_at(rational(4, 3), p) * gamma_at(rational(3, 4), p) /
                   gamma_at(rational(25, 12), p);
          }),
      known(
          "asin", antiderivative, [](const auto& x) { return asin(x); }, 0, 1,
          [](precision p) { return pi(p) / 2 - 1; }),
      known(
          "acos", antiderivative, [](const auto& x) { return acos(x); }, -1, 1,
          [](precision p) { return pi(p); }),
      known(
          "acosh", antiderivative, [](const auto& x) { return acosh(x); }, 1, 2,
          [](precision p) { return 2 * acosh(number(2, p)) - sqrt(number(3, p)); }),
      known(
          "atanh", antiderivative, [](const auto& x) { return atanh(x); }, 0, 1,
          [](precision p) { return log(number(2, p)); }),
      known(
          "log sin", "GR 4.224.3", [](const auto& x) { return log(sin(x)); }, 0, pi_limit(half),
          [](precision p) { return -pi(p) * log(number(2, p)) / 2; }),
      known(
          "log(x)/(x-1)", "GR 4.231.2", [](const auto& x) { return log(x) / (x - 1); }, 0, 1,
          [](precision p) { return square(pi(p)) / 6; }),
      known(
          "log(x)/(1+x)", "GR 4.231.1", [](const auto& x) { return log(x) / (1 + x); }, 0, 1,
          [](precision p) { return -square(pi(p)) / 12; }),
      known(
          "log(1+x)/x", "GR 4.291.1", [](const auto& x) { return log(1 + x) / x; }, 0, 1,
          [](precision p) { return square(pi(p)) / 12; }),
      known(
          "log(1-x)/x", "GR 4.291.2", [](const auto& x) { return log(1 - x) / x; }, 0, 1,
          [](precision p) { return -square(pi(p)) / 6; }),
      known(
          "sin(x)/x", "derivation: term by term", [](const auto& x) { return sin(x) / x; }, 0, 1,
          [](precision p) {
            return sum_of_series(p, [p](long n) {
              return (n % 2 == 0 ? 1 : -1) / ((2 * n + 1) * factorial(2 * n + 1, p));
            });
          }),
      known(
          "(exp(x)-1)/x", "derivation: term by term",
          [](const auto& x) { return (exp(x) - 1) / x; }, 0, 1,
          [](precision p) {
            return sum_of_series(p, [p](long n) { return 1 / ((n + 1) * factorial(n + 1, p)); });
          }),
  };
}

std::vector<known_integral> infinite() {
  const rational third(1, 3);
  return {
      known(
          "exp(-x)", antiderivative, [](const auto& x) { return exp(-x); }, 0, infinity,
          exactly(1)),
      known(
          "exp(x) from -infinity", antiderivative, [](const auto& x) { return exp(x); }, -infinity,
          1, [](precision p) { return exp(number(1, p)); }),
      known(
          "exp(-x) reversed", antiderivative, [](const auto& x) { return exp(-x); }, infinity, 0,
          exactly(-1)),
      known(
          "Gauss", "DLMF 7.7.1 at 0, GR 3.321.3", [](const auto& x) { return exp(-x * x); },
          -infinity, infinity, [](precision p) { return sqrt(pi(p)); }),
      known(
          "half Gauss from 1", "DLMF 7.2.2", [](const auto& x) { return exp(-x * x); }, 1, infinity,
          [](precision p) { return sqrt(pi(p)) * erfc(number(1, p)) / 2; }),
      known(
          "x exp(-x^2)", antiderivative, [](const auto& x) { return x * exp(-x * x); }, 0, infinity,
          exactly(rational(1, 2))),
      known(
          "x^5 exp(-x)", "DLMF 5.2.1", [](const auto& x) { return pow(x, 5) * exp(-x); }, 0,
          infinity, exactly(120)),
      known(
          "x^(-2/3) exp(-x)", "DLMF 5.2.1",
          [](const auto& x) { return real_power(x, rational(-2, 3)) * exp(-x); }, 0, infinity,
          [=](precision p) { return gamma_at(third, p); }),
      known(
          "exp(-x) sin x", "GR 3.893.1", [](const auto& x) { return exp(-x) * sin(x); }, 0,
          infinity, exactly(rational(1, 2))),
      known(
          "1/cosh", antiderivative, [](const auto& x) { return 1 / cosh(x); }, -infinity, infinity,
          [](precision p) { return pi(p); }),
      known(
          "1/cosh^2", antiderivative, [](const auto& x) { return 1 / square(cosh(x)); }, 0,
          infinity, exactly(1)),
      known(
          "x^3/(exp(x)-1)", "DLMF 25.5.1 at s = 4",
          [](const auto& x) { return x * x * x / (exp(x) - 1); }, 0, infinity,
          [](precision p) { return pow(pi(p), 4) / 15; }),
      known(
          "x/(exp(x)+1)", "DLMF 25.5.3 at s = 2", [](const auto& x) { return x / (exp(x) + 1); }, 0,
          infinity, [](precision p) { return square(pi(p)) / 12; }),
      known(
          "1/(1+x^2) over the line", antiderivative, [](const auto& x) { return 1 / (1 + x * x); },
          -infinity, infinity, [](precision p) { return pi(p); }),
      known(
          "1/(1+x^4)", "GR 3.241.2", [](const auto& x) { return 1 / (1 + pow(x, 4)); }, 0, infinity,
          [](precision p) { return pi(p) / (2 * sqrt(number(2, p))); }),
      known(
          "x^-2", antiderivative, [](const auto& x) { return 1 / (x * x); }, 1, infinity,
          exactly(1)),
      known(
          "x^(-3/2)", antiderivative, [](const auto& x) { return 1 / (x * sqrt(x)); }, 1, infinity,
          exactly(2)),
      known(
          "1/(sqrt(x)(1+x))", "DLMF 5.12.3", [](const auto& x) { return 1 / (sqrt(x) * (1 + x)); },
          0, infinity, [](precision p) { return pi(p); }),
      known(
          "x^(-1/3)/(1+x)", "DLMF 5.12.3 and 5.5.3",
          [](const auto& x) { return real_power(x, rational(-1, 3)) / (1 + x); }, 0, infinity,
          [](precision p) { return 2 * pi(p) / sqrt(number(3, p)); }),
      known(
          "log(x)/x^2", antiderivative, [](const auto& x) { return log(x) / (x * x); }, 1, infinity,
          exactly(1)),
      known(
          "log^2(x)/(1+x)^2", "GR 4.261.5",
          [](const auto& x) { return square(log(x)) / square(1 + x); }, 0, infinity,
          [](precision p) { return square(pi(p)) / 3; }),
      known(
          "1/x^2 from -infinity", antiderivative, [](const auto& x) { return 1 / (x * x); },
          -infinity, -2, exactly(rational(1, 2))),
  };
}

/// Analytic in pieces: the breaks are found by halving.
std::vector<known_integral> broken() {
  return {
      known(
          "|x|", antiderivative, [](const auto& x) { return abs(x); }, -1, 2,
          exactly(rational(5, 2))),
      known(
          "|x-1/3|", antiderivative, [](const auto& x) { return abs(x - rational(1, 3)); }, 0, 1,
          exactly(rational(5, 18))),
      known(
          "min(x,1-x)", antiderivative, [](const auto& x) { return min(x, 1 - x); }, 0, 1,
          exactly(rational(1, 4))),
      known(
          "max(sin,cos)", "derivation: (sin + cos + |sin - cos|)/2",
          [](const auto& x) { return max(sin(x), cos(x)); }, 0, pi_limit(2),
          [](precision p) { return 2 * sqrt(number(2, p)); }),
      known(
          "floor", "derivation: 1 + ... + 10", [](const auto& x) { return floor(x); }, 1, 11,
          exactly(55)),
      known(
          "floor to 10/3", "derivation: 0 + 1 + 2 + 3/3", [](const auto& x) { return floor(x); }, 0,
          end_point(rational(10, 3)), exactly(4)),
      known(
          "ceil(3x)", "derivation: (1 + 2 + 3)/3", [](const auto& x) { return ceil(3 * x); }, 0, 1,
          exactly(2)),
      known(
          "|sin| exp(-x)", "derivation: geometric series of half waves",
          [](const auto& x) { return abs(sin(x)) * exp(-x); }, 0, pi_limit(2),
          [](precision p) { return square(1 + exp(-pi(p))) / 2; }),
  };
}

std::vector<known_integral> zero() {
  return {
      known_zero(
          "x^3", odd, [](const auto& x) { return x * x * x; }, -1, 1, exactly(rational(1, 2))),
      known_zero(
          "sin over the middle", odd, [](const auto& x) { return sin(x); }, -1, 1,
          [](precision p) { return 2 * (1 - cos(number(1, p))); }),
      known_zero(
          "tan over the middle", odd, [](const auto& x) { return tan(x); }, -1, 1,
          [](precision p) { return -2 * log(cos(number(1, p))); }),
      known_zero(
          "P_2 P_3", "DLMF 18.2.1 and table 18.3.1",
          [](const auto& x) { return (3 * x * x - 1) * (5 * x * x * x - 3 * x); }, -1, 1,
          // |f| >= 1 on no less than [9/10, 1], where it is at least 1.43 * 0.94.
          exactly(rational(1, 10))),
      known_zero(
          "x exp(-x^2) over the line", odd, [](const auto& x) { return x * exp(-x * x); },
          -infinity, infinity, exactly(1)),
      known_zero(
          "x/(1+x^4)", odd, [](const auto& x) { return x / (1 + pow(x, 4)); }, -infinity, infinity,
          [](precision p) { return pi(p) / 2; }),
      known_zero(
          "log(x)/(1+x^2)", "derivation: x to 1/x",
          [](const auto& x) { return log(x) / (1 + x * x); }, 0, infinity,
          // Twice Catalan's constant 0.91..., DLMF 25.11.40.
          exactly(rational(18, 10))),
  };
}

void all_right(const std::vector<known_integral>& forms, std::initializer_list<long> digits) {
  for (const long d : digits) {
    for (const known_integral& k : forms) {
      EXPECT_FALSE(k.source.empty());
      EXPECT_TRUE(right(k, d));
    }
  }
}

TEST(ClosedForms, AreMoreThanSixty) {
  const std::size_t count = smooth().size() + extreme().size() + singular().size() +
                            infinite().size() + broken().size() + zero().size();
  EXPECT_GE(count, 60U);
}
TEST(ClosedForms, OfSmoothFunctions) { all_right(smooth(), {1, 15, 40, 120}); }
TEST(ClosedForms, OfExtremeFunctions) { all_right(extreme(), {1, 15, 40, 120}); }
TEST(ClosedForms, OfFunctionsSingularAtAnEnd) { all_right(singular(), {1, 15, 40, 120}); }
TEST(ClosedForms, OverInfiniteRanges) { all_right(infinite(), {1, 15, 40, 120}); }
TEST(ClosedForms, OfFunctionsAnalyticInPieces) {
  all_right(broken(), {1, 15, 40});
  if (support::effort() >= 10) all_right(broken(), {120});
}
TEST(ClosedForms, ThatAreZero) { all_right(zero(), {1, 15, 40, 120}); }

/// A lambda and its formula's text are one function: the same bits.
TEST(ClosedForms, AreTheSameOfALambdaAndOfItsText) {
  for (const auto& forms : {smooth(), extreme(), singular(), infinite(), broken(), zero()}) {
    for (const known_integral& k : forms) {
      const integral of_lambda = k.run({.digits = 20});
      const integral of_text = k.run_text({.digits = 20});
      EXPECT_EQ(of_lambda.verdict, of_text.verdict) << k.name;
      EXPECT_TRUE(support::identical(of_lambda.enclosure, of_text.enclosure))
          << k.name << ": " << of_lambda.enclosure << " and " << of_text.enclosure;
    }
  }
}

TEST(ClosedForms, ToAThousandDigits) {
  if (support::effort() < 10) GTEST_SKIP() << "with POLHODE_TEST_EFFORT=10";
  all_right(smooth(), {1000});
  all_right(infinite(), {300});
}

TEST(ClosedForms, CostAsManyEvaluationsAsTheyDid) {
  struct row {
    std::string name;
    long evaluations;
    long region_evaluations;
  };
  const std::vector<row> rows = {
      {"1/(1+x^2)", 37, 44},
      {"exp", 14, 55},
      {"sin(1000x)", 537, 795},
      {"1/(x^2+1e-20)", 3276, 5076},
      {"x^(-1/2)", 67, 40},
      {"log", 305, 346},
      {"x^(-1/2) log x", 347, 646},
      {"sqrt(x) exp(x)", 67, 40},
      {"sin(x)/x", 24, 82},
      {"Gauss", 199, 288},
      {"1/cosh", 1480, 4634},
      {"x^3/(exp(x)-1)", 789, 2343},
      {"1/(1+x^2) over the line", 184, 175},
      {"|x|", 2920, 2617},
  };
  std::vector<known_integral> all;
  for (const auto& set : {smooth(), extreme(), singular(), infinite(), broken()}) {
    all.insert(all.end(), set.begin(), set.end());
  }
  for (const row& r : rows) {
    const auto at = std::find_if(all.begin(), all.end(),
                                 [&](const known_integral& k) { return k.name == r.name; });
    ASSERT_NE(at, all.end()) << r.name;
    const integral i = at->run({.digits = 40});
    EXPECT_EQ(i.verdict, status::certified) << r.name;
    EXPECT_LE(i.account.evaluations, r.evaluations) << r.name;
    EXPECT_LE(i.account.region_evaluations, r.region_evaluations) << r.name;
  }
}

TEST(Integrate, OverNothingIsZero) {
  for (const end_point& a : {end_point(0), end_point(rational(-7, 3)), end_point(1000)}) {
    const integral i = integrate([](const auto& x) { return 1 / x; }, a, a);
    EXPECT_EQ(i.verdict, status::certified);
    EXPECT_TRUE(i.enclosure.is_exact());
    EXPECT_TRUE(contains(i.enclosure, 0L));
  }
}

TEST(Integrate, TakesLimitsThatAreBalls) {
  const auto f = [](const auto& x) { return exp(x); };
  // A range of limits: the integral for each of them is inside, and the width is that of the
  // limits.
  const ball a = hull(ball(rational(-1, 1'000'000), 64), ball(rational(1, 1'000'000), 64));
  const integral wide = integrate(f, end_point(a), 1, {.digits = 15});
  EXPECT_EQ(wide.verdict, status::not_certified);
  EXPECT_EQ(wide.why, reason::precision_limit);
  for (const rational& q : {rational(-1, 1'000'000), rational(0), rational(1, 1'000'000)}) {
    EXPECT_TRUE(support::holds(wide, exp(ball(1, 300)) - exp(ball(q, 300)))) << q;
  }
  const integral enough = integrate(f, end_point(a), 1, {.digits = 5});
  EXPECT_EQ(enough.verdict, status::certified);
  EXPECT_TRUE(support::holds(enough, exp(ball(1, 300)) - 1));
}

TEST(Integrate, RefusesLimitsThatAreNoNumbers) {
  const auto f = [](const auto& x) { return exp(-x); };
  for (const ball& bad : {ball::undefined(64), ball::entire(64)}) {
    for (const integral& i : {integrate(f, end_point(bad), 1), integrate(f, 0, end_point(bad)),
                              integrate(f, end_point(bad), infinity)}) {
      EXPECT_EQ(i.verdict, status::not_certified);
      EXPECT_FALSE(i.enclosure.is_bounded());
    }
  }
  EXPECT_THROW((void)integrate(f, infinity, infinity), std::invalid_argument);
  EXPECT_THROW((void)integrate(f, 0, 1, {.digits = 0}), std::invalid_argument);
}

template <class F>
void refused(const char* name, F f, const end_point& a, const end_point& b, reason why,
             const std::string& says) {
  for (const long digits : {5L, 15L}) {
    const integral i = integrate(f, a, b, {.digits = digits});
    EXPECT_EQ(i.verdict, status::not_certified) << name;
    EXPECT_EQ(i.why, why) << name << ": " << i.obstacle;
    EXPECT_FALSE(i.enclosure.is_bounded()) << name << ": " << i.enclosure;
    EXPECT_NE(i.obstacle.find(says), std::string::npos) << name << ": " << i.obstacle;
  }
}

TEST(Integrate, RefusesPolesInsideAndNamesThem) {
  // At rational points, where the range is cut, the divergence is proved.
  const reason diverges = reason::not_integrable;
  refused(
      "1/x", [](const auto& x) { return 1 / x; }, -1, 1, diverges, "at x = 0");
  refused(
      "1/(x-1/3)", [](const auto& x) { return 1 / (x - rational(1, 3)); }, 0, 1, diverges,
      "at x = 0.33333333333333333");
  refused(
      "1/(x-1/2)^2", [](const auto& x) { return 1 / square(x - rational(1, 2)); }, 0, 1, diverges,
      "at x = 0.5");
  refused(
      "1/|x|", [](const auto& x) { return 1 / abs(x); }, -1, 1, diverges, "at x = 0");
  // And at others.
  refused(
      "1/(x^2-2)", [](const auto& x) { return 1 / (x * x - 2); }, 1, 2, diverges,
      "near x = 1.41421356237309504");
  refused(
      "tan", [](const auto& x) { return tan(x); }, 0, 2, diverges, "at x = 1.57079632679489661");
  refused(
      "a pole of order 4 beside others",
      [](const auto& x) { return 5 + exp(x) * pow(square(x) - 3, -4) + 1 / (x + 7); }, 1, 2,
      diverges, "x = 1.73205080756887729");
  refused(
      "1/cos^2", [](const auto& x) { return 1 / square(cos(x)); }, 0, 2, diverges,
      "x = 1.57079632679489661");
  refused(
      "1/(1/x-e)", [](const auto& x) { return 1 / (1 / x - exp(x - x + 1)); }, rational(1, 10), 1,
      diverges, "near x = 0.36787944117144232");
}

// 0/(x^2 - 2), the numerator in a form that no rule sees to be 0.
TEST(Integrate, OfZeroOverAPoleIsNotDivergent) {
  const auto f = [](const auto& x) {
    const auto v = square(x + 5) / (x + 7);
    return (1 / v - (x + 7) / square(x + 5)) / (square(x) - 2);
  };
  const integral i = integrate(f, 1, 2);
  EXPECT_NE(i.why, reason::not_integrable);
  EXPECT_TRUE(!i.enclosure.is_bounded() || contains_zero(i.enclosure));
}

// What is not in the range is not held against it.
// At a multiple of pi, sin and cos are 0 exactly.
TEST(Integrate, IsSingularAtMultiplesOfPi) {
  const auto is = [](const auto& f, const end_point& a, const end_point& b, const auto& value) {
    const integral i = integrate(f, a, b, {.digits = 40});
    EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
    EXPECT_TRUE(overlaps(i.enclosure, value(200))) << i.enclosure;
  };
  const end_point half = end_point::pi(rational(1, 2));
  const auto minus_pi_log_2 = [](precision p) { return -pi(p) * log(number(2, p)); };
  is([](const auto& x) { return log(sin(x)); }, 0, end_point::pi(), minus_pi_log_2);
  is([](const auto& x) { return log(square(cos(x))); }, 0, half, minus_pi_log_2);
  // DLMF 5.12.2: the integral of sin^(2a-1) cos^(2b-1) over (0, pi/2) is B(a, b)/2.
  is([](const auto& x) { return sqrt(tan(x)); }, 0, half,
     [](precision p) { return pi(p) / sqrt(number(2, p)); });
  is([](const auto& x) { return sqrt(sin(x)); }, 0, end_point::pi(),
     [](precision p) {
       return gamma_at(rational(3, 4), p) * sqrt(pi(p)) / gamma_at(rational(5, 4), p);
     });
  is([](const auto& x) { return 1 / sqrt(-cos(x)); }, half, end_point::pi(),
     [](precision p) {
       return gamma_at(rational(1, 4), p) * sqrt(pi(p)) / gamma_at(rational(3, 4), p) / 2;
     });
  const integral pole = integrate([](const auto& x) { return tan(x); }, 0, half);
  EXPECT_EQ(pole.why, reason::not_integrable);
  const integral beside = integrate([](const auto& x) { return 1 / sin(x); }, 1, end_point::pi(3));
  EXPECT_NE(beside.verdict, status::certified);
  // Not a multiple of pi, if not far from one.
  const end_point near([](precision p) { return pi(p) + scale(number(1, p), -200); });
  EXPECT_NE(integrate([](const auto& x) { return 1 / sin(x); }, 3, near).verdict,
            status::certified);
}

TEST(Integrate, LooksOnlyBetweenTheLimits) {
  const rational pole = boost::multiprecision::pow(integer(2), 41);
  const auto f = [=](const auto& x) { return 1 / square(x - pole); };
  const integral i = integrate(f, end_point(2 * pole), infinity, {.digits = 30});
  EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
  EXPECT_TRUE(contains(i.enclosure, rational(1 / pole)));
  // Of limits that may lie on either side of a pole, nothing is known.
  const ball around_1 = hull(ball(9, 64) / 10, ball(11, 64) / 10);
  const integral j =
      integrate([](const auto& x) { return 1 / square(1 - x); }, 0, end_point(around_1));
  EXPECT_EQ(j.verdict, status::not_certified);
  EXPECT_NE(j.why, reason::not_integrable);
}

TEST(Integrate, FindsTheSizeOfWhatFallsSteeply) {
  const auto f = [](const auto& x) { return pow(x, 9) * exp(-3 * x * x); };
  const integral i = integrate(f, -8000, -16000, {.digits = 10});
  EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
  EXPECT_LE(i.account.evaluations, 20'000);
}

TEST(Integrate, RefusesWhatDivergesAtAnEnd) {
  const reason why = reason::not_integrable;
  const std::string at_0 = "at x = 0";
  refused(
      "1/x", [](const auto& x) { return 1 / x; }, 0, 1, why, at_0);
  refused(
      "1/x from the left", [](const auto& x) { return 1 / x; }, -1, 0, why, at_0);
  refused(
      "log(x)/x", [](const auto& x) { return log(x) / x; }, 0, 1, why, at_0);
  refused(
      "1/(exp(x)-1)", [](const auto& x) { return 1 / (exp(x) - 1); }, 0, 1, why, at_0);
  refused(
      "1/sin", [](const auto& x) { return 1 / sin(x); }, 0, 1, why, at_0);
  refused(
      "max(x,1/x)", [](const auto& x) { return max(x, 1 / x); }, 0, 2, why, at_0);
  refused(
      "1/(1-x)", [](const auto& x) { return 1 / (1 - x); }, 0, 1, why, "at x = 1");
  refused(
      "1/x at infinity", [](const auto& x) { return 1 / x; }, 1, infinity, why, "at infinity");
  refused(
      "x^(-1/2) at infinity", [](const auto& x) { return 1 / sqrt(x); }, 1, infinity, why,
      "at infinity");
  refused(
      "1", [](const auto&) { return 1; }, 0, infinity, why, "at infinity");
}

/// Also where a closed form leaves it out.
TEST(Integrate, RefusesNumbersThatAreNotDefined) {
  const end_point inf = end_point::infinity();
  for (const std::string undefined : {"log(cos(2))", "(1/(sqrt(2)*sqrt(3) - sqrt(6)))", "acos(pi)",
                                      "(1/(exp(1000)*exp(-1000) - 1))"}) {
    for (const std::string form :
         {"exp(-x) + 0*(C*x)", "exp(-x + 0*(C*x))", "x + 0*(C*x)", "cos(x^2 + 0*(C*x))",
          "exp(-x)*(C*x - C*x)", "exp(-x) + 0*sin(C*x)", "sin(exp(x + 0*(C*x)))",
          "sin(x)/x + (C*x - C*x)/x", "C^0*exp(-x)", "legendreP(0, C*x)*exp(-x)"}) {
      std::string text = form;
      for (std::size_t at = 0; (at = text.find('C', at)) != std::string::npos;) {
        text.replace(at, 1, undefined);
      }
      const expression f = parse(text);
      EXPECT_FALSE(f.has_defined_constants()) << text;
      EXPECT_NE(integrate(f, 0, inf, {.digits = 10}).verdict, status::certified) << text;
      EXPECT_NE(integrate(f, 0, 1, {.digits = 10}).verdict, status::certified) << text;
      EXPECT_FALSE(exact_integral(f, 0, 1)) << text;
    }
  }
  // A number that needs many bits.
  EXPECT_EQ(integrate(parse("exp(-x)/(exp(-2000) - exp(-3000))"), 0, inf, {.digits = 10}).verdict,
            status::certified);
}

/// A polynomial of degree 0 is 1 where its argument is defined.
TEST(Integrate, RefusesPolynomialsOfWhatIsNotDefined) {
  for (const char* name : {"chebyshevT", "chebyshevU", "legendreP", "hermiteH", "laguerreL"}) {
    for (const char* degree : {"0", "1", "2", "3"}) {
      const std::string call = std::string(name) + "(" + degree;
      for (const char* x : {"log(-1-x^2)", "1/(x-x)", "log(cos(2))"}) {
        const expression f = parse(call + ", " + x + ")", {"x"});
        EXPECT_NE(integrate(f, 0, 1, {.digits = 10}).verdict, status::certified) << call << x;
        EXPECT_FALSE(exact_integral(f, 0, 1)) << call << x;
      }
      EXPECT_EQ(integrate(parse(call + ", x)"), 0, 1, {.digits = 10}).verdict, status::certified);
    }
  }
  EXPECT_NE(integrate(parse("binomial(log(-1-x^2), 0)"), 0, 1, {.digits = 10}).verdict,
            status::certified);
  EXPECT_EQ(exact_integral(parse("legendreP(0, x) + binomial(x, 0)", {"x"}), 0, 1), rational(2));
}

TEST(Integrate, RefusesWhatItCannotProve) {
  const reason why = reason::not_analytic;
  const reason undefined = reason::not_defined;
  refused(
      "sqrt", [](const auto& x) { return sqrt(x); }, -1, 1, undefined, "sqrt");
  refused(
      "log", [](const auto& x) { return log(x); }, -1, 1, undefined, "log");
  refused(
      "asin", [](const auto& x) { return asin(x); }, 0, 2, undefined, "asin");
  refused(
      "acosh", [](const auto& x) { return acosh(x); }, 0, 2, undefined, "acosh");
  refused(
      "sqrt(sin)", [](const auto& x) { return sqrt(sin(x)); }, 0, 4, undefined, "sqrt");
  refused(
      "exp(1/x)", [](const auto& x) { return exp(1 / x); }, 0, 1, why, "near x = ");
  refused(
      "floor(1/x)", [](const auto& x) { return floor(1 / x); }, 0, 1, why, "near x = ");
  refused(
      "1/floor", [](const auto& x) { return 1 / floor(x); }, 0, 2, undefined, "a division by zero");
  refused(
      "sin(x) + sinpi(x)", [](const auto& x) { return sin(x) + sinpi(x); }, 0, infinity, why,
      "no proof of decay at infinity");
  const reason diverges = reason::not_integrable;
  refused(
      "sin at infinity", [](const auto& x) { return sin(x); }, 0, infinity, diverges,
      "diverges at infinity");
  refused(
      "exp at infinity", [](const auto& x) { return exp(x); }, 0, infinity, diverges,
      "at infinity");
  refused(
      "exp(-x) at -infinity", [](const auto& x) { return exp(-x); }, -infinity, infinity, diverges,
      "at infinity");
}

// With L = log x, x^m = e^(m L), and the integral of x^m L^k from 0 to 1 is (-1)^k k!/(m +
// 1)^(k+1).
TEST(Integrate, OfPowersWithAVariableExponent) {
  const auto is = [](const char* name, const integral& i, long shift) {
    ball sum(0, 400);
    for (long k = 0; k < 60; ++k) {
      const ball term = 1 / pow(ball(k + shift, 400), k + 1);
      sum += k % 2 == 0 ? term : -term;
    }
    EXPECT_EQ(i.verdict, status::certified) << name << ": " << i.obstacle;
    EXPECT_TRUE(support::holds(i, sum.enlarged(magnitude::power_of_two(-300))))
        << name << i.enclosure;
  };
  for (const long digits : {5L, 15L, 40L}) {
    const integrate_options options{.digits = digits};
    // The sum of x^k L^k / k!, and that of x^(1+k) L^k / k!.
    is("x^x", integrate([](const auto& x) { return exp(x * log(x)); }, 0, 1, options), 1);
    // x^(1+x), whose exponent looks like 1 as far as its series goes.
    is("x^(1+x)",
       integrate(
           [](const auto& x) {
             const auto ratio = (1 / square(x)) / (1 / (square(x) + square(x) * x));
             return exp(log(x) * ratio);
           },
           0, 1, options),
       2);
  }
}

// A large constant hides nothing: the pole at 2 pi i/80 limits the panels.
TEST(Integrate, OfPlanckBesideAConstant) {
  const rational large("1000000000000000000000000000000");
  const auto f = [=](const auto& x) { return large + x / (exp(80 * x) - 1); };
  const auto g = [](const auto& x) { return x / (exp(80 * x) - 1); };
  const integral whole = integrate(f, 0, 1, {.digits = 120});
  const integral part = integrate(g, 0, 1, {.digits = 120});
  EXPECT_EQ(whole.verdict, status::certified) << whole.obstacle;
  EXPECT_EQ(part.verdict, status::certified) << part.obstacle;
  EXPECT_TRUE(overlaps(whole.enclosure, part.enclosure + large));
  EXPECT_TRUE(part.enclosure.radius() <= magnitude::power_of_two(-390));
}

TEST(Integrate, StopsAtTheLimits) {
  integrate_options options;
  options.most_evaluations = 1000;
  const integral i =
      integrate([](const auto& x) { return sin(1 / (x * x + rational(1, 1000))); }, -1, 1, options);
  EXPECT_EQ(i.verdict, status::not_certified);
  EXPECT_EQ(i.why, reason::evaluation_limit);
  EXPECT_LE(i.account.region_evaluations, 2000);
  options = {};
  options.absolute_exponent = -10;
  options.digits = 30;
  options.rule = quadrature_rule::gauss_legendre;
  const integral coarse = integrate([](const auto& x) { return exp(x); }, 0, 1, options);
  EXPECT_EQ(coarse.verdict, status::certified);
  EXPECT_TRUE(coarse.enclosure.radius() <= magnitude::power_of_two(-10));
  EXPECT_LE(coarse.account.evaluations, 5);
  options = {};
  options.digits = 60;
  options.most_memory = 1000;
  options.rule = quadrature_rule::gauss_legendre;
  const auto f = [](const auto& x) { return 1 / (1 + x * x); };
  const integral cramped = integrate(f, 0, 1, options);
  EXPECT_EQ(cramped.why, reason::evaluation_limit);
  EXPECT_EQ(cramped.obstacle, "more memory needed than allowed");
  EXPECT_TRUE(contains(cramped.enclosure, pi(100) / 4));
  options.most_memory = 100'000;
  EXPECT_EQ(integrate(f, 0, 1, options).verdict, status::certified);
}

}  // namespace closed_forms_test
}  // namespace polhode
