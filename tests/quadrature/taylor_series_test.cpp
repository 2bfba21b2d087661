// integrate by Taylor series: hyperexponential functions in x, e^(k x) and sin^2 (k x).

#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/special_functions.hpp"
#include "quadrature/known_integrals.hpp"

namespace polhode {
namespace taylor_series_test {

using support::holds;
using support::known;
using support::known_integral;
using support::power_of_ten;

const end_point infinity = end_point::infinity();
const auto exactly = [](const rational& q) { return [q](precision p) { return ball(q, p); }; };
const rational half(1, 2);
ball gamma_at(const rational& q, precision p) { return gamma(ball(q, p)); }
/// Euler's integral of the first kind.
ball beta(const rational& a, const rational& b, precision p) {
  return gamma_at(a, p) * gamma_at(b, p) / gamma_at(a + b, p);
}
/// A limit that is not known as a rational number, nor as a multiple of pi.
end_point irrational(const rational& q) {
  return end_point([q](precision p) { return sqrt(ball(q, p)); });
}

const std::string antiderivative = "derivation: antiderivative";
const std::string euler = "GR 3.191.3";

/// In x itself.
std::vector<known_integral> in_the_argument() {
  return {
      known(
          "4/(1+x^2)", antiderivative, [](const auto& x) { return 4 / (1 + square(x)); }, 0, 1,
          [](precision p) { return pi(p); }),
      known(
          "x^(-1/2)", antiderivative, [](const auto& x) { return 1 / sqrt(x); }, 0, 1, exactly(2)),
      known(
          "4 sqrt(1-x^2)", "area of the circle",
          [](const auto& x) { return 4 * sqrt(1 - square(x)); }, 0, 1,
          [](precision p) { return pi(p); }),
      known(
          "1/sqrt(1-x^2)", antiderivative, [](const auto& x) { return 1 / sqrt(1 - square(x)); },
          -1, 1, [](precision p) { return pi(p); }),
      known(
          "x^(-2/3) (1-x)^(-1/4)", euler,
          [](const auto& x) {
            return support::real_power(x, rational(-2, 3)) *
                   support::real_power(1 - x, rational(-1, 4));
          },
          0, 1, [](precision p) { return beta(rational(1, 3), rational(3, 4), p); }),
      known(
          "x^(-999/1000)", antiderivative,
          [](const auto& x) { return support::real_power(x, rational(-999, 1000)); }, 0, 1,
          exactly(1000)),
      known(
          "1/x to a far end", antiderivative, [](const auto& x) { return 1 / x; }, 1,
          parse_rational("1e30"), [](precision p) { return 30 * log(ball(10, p)); }),
      known(
          "1/(x (x+1))", antiderivative, [](const auto& x) { return 1 / (x * (x + 1)); }, 1,
          infinity, [](precision p) { return log(ball(2, p)); }),
      known(
          "x^(-1/2)/(1+x)", "GR 3.222.2", [](const auto& x) { return 1 / (sqrt(x) * (1 + x)); }, 0,
          infinity, [](precision p) { return pi(p); }),
      known(
          "1/(1+x^4) on the line", "GR 3.241.2", [](const auto& x) { return 1 / (1 + pow(x, 4)); },
          -infinity, infinity, [](precision p) { return pi(p) / sqrt(ball(2, p)); }),
      known(
          "a narrow Lorentz curve", antiderivative,
          [](const auto& x) { return 1 / (square(x) + parse_rational("1e-20")); }, -1, 1,
          [](precision p) {
            return 2 * atan(ball(parse_rational("1e10"), p)) * parse_rational("1e10");
          }),
      known(
          "(x^2-2) e^x, which has a zero", antiderivative,
          [](const auto& x) { return (square(x) - 2) * exp(x); }, 0, 3,
          [](precision p) { return 3 * exp(ball(3, p)); }),
      known(
          "e^(-x^2) on the line", "GR 3.321.3", [](const auto& x) { return exp(-square(x)); },
          -infinity, infinity, [](precision p) { return sqrt(pi(p)); }),
      known(
          "a narrow bell", "GR 3.321.3",
          [](const auto& x) { return exp(-square(1000 * (x - rational(1, 3)))); }, 0, 1,
          [](precision p) {
            return sqrt(pi(p)) / 2000 *
                   (erf(ball(rational(1000, 3), p)) + erf(ball(rational(2000, 3), p)));
          }),
      known(
          "x^1000 e^(-x)", "GR 3.381.4", [](const auto& x) { return pow(x, 1000) * exp(-x); }, 0,
          infinity, [](precision p) { return gamma_at(1001, p); }),
      known(
          "x^(-3/4) e^(-x)", "GR 3.381.4",
          [](const auto& x) { return support::real_power(x, rational(-3, 4)) * exp(-x); }, 0,
          infinity, [](precision p) { return gamma_at(rational(1, 4), p); }),
      known(
          "e^x from -infinity", antiderivative, [](const auto& x) { return exp(x); }, -infinity, 0,
          exactly(1)),
      known(
          "x sinh x", antiderivative, [](const auto& x) { return x * sinh(x); }, 0, 1,
          [](precision p) { return exp(-ball(1, p)); }),
      known(
          "an irrational end", antiderivative, [](const auto& x) { return 1 / square(1 + x); }, 0,
          irrational(2), [](precision p) { return 2 - sqrt(ball(2, p)); }),
      known(
          "two irrational ends", antiderivative, [](const auto& x) { return exp(x); },
          irrational(2), irrational(3),
          [](precision p) { return exp(sqrt(ball(3, p))) - exp(sqrt(ball(2, p))); }),
      known(
          "constants that are not rational", antiderivative,
          [](const auto& x) {
            const auto root = sqrt(x * 0 + 2);
            return root * sqrt(3 * x) / (1 + x);
          },
          0, 1, [](precision p) { return sqrt(ball(6, p)) * (2 - pi(p) / 2); }),
      known(
          "|x| as sqrt(x^2), where x < 0", antiderivative,
          [](const auto& x) { return sqrt(square(x)); }, -3, -1, exactly(4)),
      known(
          "e^x e^(1-x)/(1+x^2), where the exponent is constant", antiderivative,
          [](const auto& x) { return exp(x) * exp(1 - x) / (1 + square(x)); }, 0, infinity,
          [](precision p) { return exp(ball(1, p)) * pi(p) / 2; }),
      known(
          "the same far out, and finite", antiderivative,
          [](const auto& x) { return exp(square(x)) * exp(2 - square(x)) / square(1 + x); }, 0,
          1000, [](precision p) { return exp(ball(2, p)) * 1000 / 1001; }),
      known(
          "cosh(x/x) x^-2", antiderivative, [](const auto& x) { return cosh(x / x) / square(x); },
          1, infinity, [](precision p) { return cosh(ball(1, p)); }),
      known(
          "a constant phase", antiderivative,
          [](const auto& x) {
            return sin(x + 1) * cos(x) / square(1 + x) * 2 - sin(2 * x + 1) / square(1 + x);
          },
          0, 1000, [](precision p) { return sin(ball(1, p)) * 1000 / 1001; }),
      known(
          "a sum of different kinds", antiderivative,
          [](const auto& x) { return 1 / (1 + x) + exp(-x) - sqrt(x); }, 0, 1,
          [](precision p) { return log(ball(2, p)) + 1 - exp(-ball(1, p)) - rational(2, 3); }),
  };
}

/// Times cosines and sines of polynomials.
std::vector<known_integral> with_a_phase() {
  return {
      known(
          "e^(-x) cos x", "GR 3.893.2", [](const auto& x) { return exp(-x) * cos(x); }, 0, infinity,
          exactly(half)),
      known(
          "e^(-x) sin(3x)", "GR 3.893.1", [](const auto& x) { return exp(-x) * sin(3 * x); }, 0,
          infinity, exactly(rational(3, 10))),
      known(
          "e^(-x^2) cos(3x)", "GR 3.896.4",
          [](const auto& x) { return exp(-square(x)) * cos(3 * x); }, -infinity, infinity,
          [](precision p) { return sqrt(pi(p)) * exp(ball(rational(-9, 4), p)); }),
      known(
          "x sin x", antiderivative, [](const auto& x) { return x * sin(x); }, 0, end_point::pi(),
          [](precision p) { return pi(p); }),
      known(
          "x^2 cos(5x+1)", antiderivative, [](const auto& x) { return square(x) * cos(5 * x + 1); },
          -1, 3,
          [](precision p) {
            const auto f = [p](long x) {
              const ball w(5 * x + 1, p);
              return ball(x * x, p) * sin(w) / 5 + 2 * x * cos(w) / 25 - 2 * sin(w) / 125;
            };
            return f(3) - f(-1);
          }),
      known(
          "sin(x) sin(2x) cos(-x)", "derivation: (cos 0 - cos 4x)/4 + sums that end in sin 2x^2/2",
          [](const auto& x) { return sin(x) * sin(2 * x) * cos(-x) * 2; }, 0, 1,
          [](precision p) { return half - sin(ball(4, p)) / 8; }),
      known(
          "2x cos(x^2+1)", antiderivative, [](const auto& x) { return 2 * x * cos(square(x) + 1); },
          -2, irrational(3), [](precision p) { return sin(ball(4, p)) - sin(ball(5, p)); }),
      known(
          "cos(x)/sqrt(x) + 2 sqrt(x) (-sin x)", antiderivative,
          [](const auto& x) { return cos(x) / sqrt(x) - 2 * sqrt(x) * sin(x); }, 0, 4,
          [](precision p) { return 4 * cos(ball(4, p)); }),
      known(
          "sin(1000 x) e^x", antiderivative, [](const auto& x) { return sin(1000 * x) * exp(x); },
          0, 1,
          [](precision p) {
            const ball e = exp(ball(1, p));
            const ball w(1000, p);
            return (e * (sin(w) - 1000 * cos(w)) + 1000) / 1'000'001;
          }),
  };
}

/// In e^(k x).
std::vector<known_integral> in_exponentials() {
  return {
      known(
          "sech x", antiderivative, [](const auto& x) { return 1 / cosh(x); }, 0, infinity,
          [](precision p) { return pi(p) / 2; }),
      known(
          "sech far beyond what counts", antiderivative,
          [](const auto& x) { return 1 / cosh(100'000'000 * x); }, 0, 1,
          [](precision p) { return pi(p) / 200'000'000; }),
      known(
          "tanh x", antiderivative, [](const auto& x) { return tanh(x); }, 0, 10,
          [](precision p) { return log(cosh(ball(10, p))); }),
      known(
          "1/(1+e^x)", antiderivative, [](const auto& x) { return 1 / (1 + exp(x)); }, 0, infinity,
          [](precision p) { return log(ball(2, p)); }),
      known(
          "a narrow sech^6", antiderivative,
          [](const auto& x) { return pow(1 / cosh(10000 * x - 6123), 6); }, 0, 1,
          [](precision p) {
            const auto f = [](const ball& t) { return t - 2 * pow(t, 3) / 3 + pow(t, 5) / 5; };
            return (f(tanh(ball(3877, p))) + f(tanh(ball(6123, p)))) / 10000;
          }),
      known(
          "sqrt(1+e^x)", antiderivative, [](const auto& x) { return sqrt(1 + exp(x)); }, 0, 1,
          [](precision p) {
            const auto f = [](const ball& u) { return 2 * u + log((u - 1) / (u + 1)); };
            return f(sqrt(1 + exp(ball(1, p)))) - f(sqrt(ball(2, p)));
          }),
      known(
          "1/(e^x+e^(-x/2))", "derivation: with y = e^(x/2) it is 2 y^2/(y (y^3 + 1)) dy/y",
          [](const auto& x) { return 1 / (exp(x) + exp(-x / 2)); }, -infinity, infinity,
          [](precision p) { return 4 * pi(p) / (3 * sqrt(ball(3, p))); }),
  };
}

/// In sin^2 (k x).
std::vector<known_integral> in_circular_functions() {
  const end_point quarter_turn = end_point::pi(half);
  return {
      known(
          "1/(2+cos x) over a period", "GR 3.613.1", [](const auto& x) { return 1 / (2 + cos(x)); },
          0, end_point::pi(2), [](precision p) { return 2 * pi(p) / sqrt(ball(3, p)); }),
      known(
          "1/(2+sin x) over a period", "GR 3.613.1", [](const auto& x) { return 1 / (2 + sin(x)); },
          0, end_point::pi(2), [](precision p) { return 2 * pi(p) / sqrt(ball(3, p)); }),
      known(
          "sqrt(sin x)", "GR 3.621.5", [](const auto& x) { return sqrt(sin(x)); }, 0,
          end_point::pi(), [](precision p) { return beta(rational(3, 4), half, p); }),
      known(
          "sqrt(tan x)", "GR 3.629", [](const auto& x) { return sqrt(tan(x)); }, 0, quarter_turn,
          [](precision p) { return pi(p) / sqrt(ball(2, p)); }),
      known(
          "tan x", antiderivative, [](const auto& x) { return tan(x); }, 0, 1,
          [](precision p) { return -log(cos(ball(1, p))); }),
      known(
          "sin(2x) cos(x)", antiderivative, [](const auto& x) { return sin(2 * x) * cos(x); }, 0, 1,
          [](precision p) { return 2 * (1 - pow(cos(ball(1, p)), 3)) / 3; }),
      known(
          "cos(-3x)^2, from below 0", antiderivative,
          [](const auto& x) { return square(cos(-3 * x)); }, -1, 2,
          [](precision p) { return rational(3, 2) + (sin(ball(12, p)) + sin(ball(6, p))) / 12; }),
      known(
          "sin(-x)^3", antiderivative, [](const auto& x) { return pow(sin(-x), 3); }, 1, 5,
          [](precision p) {
            const auto f = [](const ball& c) { return c - pow(c, 3) / 3; };
            return f(cos(ball(5, p))) - f(cos(ball(1, p)));
          }),
      known(
          "cos^1000 x", "GR 3.621.3", [](const auto& x) { return pow(cos(x), 1000); }, 0,
          quarter_turn, [](precision p) { return beta(half, rational(1001, 2), p) / 2; }),
      known(
          "a complete elliptic integral", "GR 8.112.1",
          [](const auto& x) { return 1 / sqrt(1 - square(sin(x)) * rational(8, 9)); }, 0,
          quarter_turn,
          [](precision p) { return pi(p) / 2 / agm(ball(1, p), ball(rational(1, 3), p)); }),
  };
}

std::vector<known_integral> all() {
  std::vector<known_integral> result = in_the_argument();
  for (const auto& more : {with_a_phase(), in_exponentials(), in_circular_functions()}) {
    result.insert(result.end(), more.begin(), more.end());
  }
  return result;
}

TEST(TaylorSeries, GiveTheKnownValues) {
  for (const known_integral& k : all()) {
    for (const long digits : {1L, 17L, 60L, 300L}) {
      const integral i = k.run({.digits = digits, .rule = quadrature_rule::taylor_series});
      const precision p = bits_for_digits(2 * digits) + 300;
      ASSERT_EQ(i.verdict, status::certified) << k.name << " to " << digits << ": " << i.obstacle;
      EXPECT_TRUE(holds(i, k.value(p))) << k.name << " to " << digits;
      EXPECT_LE(i.enclosure.radius(), (abs(k.value(p)) * power_of_ten(-digits)).magnitude_upper())
          << k.name;
      EXPECT_EQ(i.account.rules, std::vector{quadrature_rule::taylor_series}) << k.name;
      EXPECT_GT(i.account.terms, 0) << k.name;
    }
  }
}

TEST(TaylorSeries, AreChosenByTheFrontDoorAndTakeAReversedRange) {
  const auto f = [](const auto& x) { return 1 / (1 + square(x)); };
  const integral forward = integrate(f, 0, 2, {.digits = 30});
  const integral backward = integrate(f, 2, 0, {.digits = 30});
  EXPECT_EQ(forward.account.rules, std::vector{quadrature_rule::taylor_series});
  EXPECT_EQ(backward.account.rules, std::vector{quadrature_rule::taylor_series});
  EXPECT_TRUE(contains(forward.enclosure, atan(ball(2, 300))));
  EXPECT_TRUE(contains(backward.enclosure, -atan(ball(2, 300))));
}

// With what a rounded recurrence leaves over, a root that was taken of a negative number, or a
// pole, must be seen.
template <class F>
void expect_refused(const std::string& name, F f, end_point a, end_point b) {
  for (const long digits : {5L, 40L}) {
    const integral i =
        integrate(f, a, b, {.digits = digits, .rule = quadrature_rule::taylor_series});
    EXPECT_EQ(i.verdict, status::not_certified) << name;
    EXPECT_EQ(i.why, reason::not_applicable) << name;
    EXPECT_TRUE(i.enclosure.is_undefined()) << name;
    EXPECT_NE(i.obstacle.find("Taylor series"), std::string::npos) << name;
  }
}

TEST(TaylorSeries, AreRefusedWhereTheFunctionIsNotDefined) {
  expect_refused(
      "sqrt(x)^2", [](const auto& x) { return square(sqrt(x)); }, -1, 2);
  expect_refused(
      "sqrt(x) sqrt(x)", [](const auto& x) { return sqrt(x) * sqrt(x); }, -1, 2);
  expect_refused(
      "sqrt(x)/sqrt(x)", [](const auto& x) { return sqrt(x) / sqrt(x); }, -1, 2);
  expect_refused(
      "sqrt(x)-sqrt(x)", [](const auto& x) { return sqrt(x) - sqrt(x); }, -1, 2);
  expect_refused(
      "sqrt(x^2), which is |x|", [](const auto& x) { return sqrt(square(x)); }, -1, 2);
  expect_refused(
      "sqrt(x^3)", [](const auto& x) { return sqrt(pow(x, 3)); }, -2, -1);
  expect_refused(
      "(sqrt(x^2-2))^4", [](const auto& x) { return pow(sqrt(square(x) - 2), 4); }, 0, 2);
  expect_refused(
      "0 sqrt(x)", [](const auto& x) { return 0 * sqrt(x); }, -1, 2);
  expect_refused(
      "sqrt(-2) x", [](const auto& x) { return sqrt(x * 0 - 2) * x; }, 0, 1);
  expect_refused(
      "sqrt(cos x)^2", [](const auto& x) { return square(sqrt(cos(x))); }, 0, 3);
  expect_refused(
      "sqrt(e^x-2)^2", [](const auto& x) { return square(sqrt(exp(x) - 2)); }, 0, 1);
}

// The condition of a root must not get lost in what a function is taken of, nor where terms cancel.
TEST(TaylorSeries, AreRefusedWhereARootIsInsideAnotherFunction) {
  expect_refused(
      "e^-|x|", [](const auto& x) { return exp(-sqrt(square(x))); }, -1, 1);
  expect_refused(
      "e^-|x-3|", [](const auto& x) { return exp(sqrt(square(x - 3))); }, 4, 5);
  expect_refused(
      "sinh |x|", [](const auto& x) { return sinh(pow(pow(x, 4), rational(1, 4))); }, -2, 1);
  expect_refused(
      "tan |x|", [](const auto& x) { return tan(sqrt(square(x))); }, -1, half);
  expect_refused(
      "cos(sqrt(x)^2)", [](const auto& x) { return cos(square(sqrt(x))); }, -1, half);
  expect_refused(
      "tanh |x|", [](const auto& x) { return sinh(sqrt(square(x))) / cosh(sqrt(square(x))); }, -1,
      2);
  expect_refused(
      "e^x+x-sqrt(x)^2", [](const auto& x) { return exp(x) + x - square(sqrt(x)); }, -1, 1);
  expect_refused(
      "e^x+sqrt(x)^2-x", [](const auto& x) { return exp(x) + square(sqrt(x)) - x; }, -1, 1);
}

// What would be found to be too long is left alone at once.
TEST(TaylorSeries, AreRefusedForLongFormulas) {
  expect_refused(
      "a tower of powers",
      [](const auto& x) {
        auto y = 3 * x;
        for (int k = 0; k < 6; ++k) y = pow(y, 64);
        return y;
      },
      0, rational(1, 10));
  expect_refused(
      "many factors",
      [](const auto& x) {
        auto y = exp(-x);
        for (long k = 1; k <= 150; ++k) y = y * sqrt(x + k);
        return y;
      },
      0, infinity);
  expect_refused(
      "many terms",
      [](const auto& x) {
        auto y = sin(square(x));
        for (long k = 1; k <= 600; ++k) y = y + sin(square(x) + k);
        return y;
      },
      0, 1);
}

TEST(TaylorSeries, AreRefusedAtPolesAndWhereAnIntegralDiverges) {
  expect_refused(
      "1/x", [](const auto& x) { return 1 / x; }, -1, 2);
  expect_refused(
      "1/x to 0", [](const auto& x) { return 1 / x; }, 0, 1);
  expect_refused(
      "1/x^2", [](const auto& x) { return 1 / square(x); }, -1, 1);
  expect_refused(
      "1/(x^2-2)", [](const auto& x) { return 1 / (square(x) - 2); }, 0, 2);
  expect_refused(
      "1/(x^2-2)^(1/2)", [](const auto& x) { return 1 / sqrt(square(x) - 2); }, 0, 2);
  expect_refused(
      "1/(x-1/3)^2", [](const auto& x) { return 1 / square(x - rational(1, 3)); }, 0, 1);
  expect_refused(
      "tan x", [](const auto& x) { return tan(x); }, 0, 2);
  expect_refused(
      "1/cos^2 x", [](const auto& x) { return 1 / square(cos(x)); }, 0, end_point::pi());
  expect_refused(
      "1/sinh x", [](const auto& x) { return 1 / sinh(x); }, -1, 2);
  expect_refused(
      "1/(e^x-2)", [](const auto& x) { return 1 / (exp(x) - 2); }, 0, 1);
  expect_refused(
      "1/x to infinity", [](const auto& x) { return 1 / x; }, 1, infinity);
  expect_refused(
      "e^x to infinity", [](const auto& x) { return exp(x); }, 0, infinity);
  expect_refused(
      "e^(-x) from -infinity", [](const auto& x) { return exp(-x); }, -infinity, 0);
  expect_refused(
      "tanh x to infinity", [](const auto& x) { return tanh(x); }, 0, infinity);
}

TEST(TaylorSeries, AreRefusedWhereTheFunctionIsOfAnotherKind) {
  expect_refused(
      "log x", [](const auto& x) { return log(x); }, 1, 2);
  expect_refused(
      "sin(x+e^x)", [](const auto& x) { return sin(x + exp(x)); }, 0, 1);
  expect_refused(
      "|x|", [](const auto& x) { return abs(x); }, -1, 2);
  expect_refused(
      "e^x/(2+sin x)", [](const auto& x) { return exp(x) / (2 + sin(x)); }, 0, 1);
  expect_refused(
      "sin x to infinity", [](const auto& x) { return sin(x); }, 0, infinity);
  expect_refused(
      "cos(x)/(1+x^2) to infinity", [](const auto& x) { return cos(x) / (1 + square(x)); }, 0,
      infinity);
  expect_refused(
      "1/(e^x+x)", [](const auto& x) { return 1 / (exp(x) + x); }, 0, 1);
  expect_refused(
      "1/(e^x+e^(sqrt(2) x))",
      [](const auto& x) { return 1 / (exp(x) + exp(x * sqrt(x * 0 + 2))); }, 0, 1);
}

TEST(TaylorSeries, KeepTheLimitOfEvaluations) {
  const auto f = [](const auto& x) { return exp(-square(x)); };
  const integral i = integrate(
      f, 0, 1, {.digits = 50, .most_evaluations = 20, .rule = quadrature_rule::taylor_series});
  EXPECT_EQ(i.why, reason::not_applicable);
}

/// The value from `text`, with an error of one unit of the last digit that is given.
ball rounded(const std::string& text, const std::string& unit) {
  const precision p = 256;
  return parse_ball(text, p).enlarged(ball(parse_rational(unit), p).magnitude_upper());
}

// Steep functions over ranges that begin or end in the middle of nowhere: what is negligible of a
// panel must not stand for a range that ends in another one. The values are those of two other
// programs.
TEST(TaylorSeries, EndWhereTheRangeDoes) {
  const auto expect = [](const char* what, const auto& f, const end_point& a, const end_point& b,
                         const ball& value) {
    const integral i = integrate(f, a, b, {.digits = 20});
    EXPECT_EQ(i.verdict, status::certified) << what;
    EXPECT_TRUE(overlaps(i.enclosure, value)) << what << ": " << support::described(i.enclosure);
  };
  const auto q = [](const char* text) { return parse_rational(text); };
  expect(
      "e^x (1+e^x)^400", [](const auto& x) { return exp(x) * pow(1 + exp(x), 400); }, q("-1.4"),
      q("-1.3999"), rounded("4.83231007601602947e33", "1e16"));
  expect(
      "sin x cos x (1+sin^2 x)^400",
      [](const auto& x) { return sin(x) * cos(x) * pow(1 + square(sin(x)), 400); }, q("0.5"),
      q("0.51"), rounded("1.96224333045310705e34", "1e17"));
  expect(
      "1/(1+e^-x)^400", [](const auto& x) { return 1 / pow(1 + exp(-x), 400); }, q("-1.5"),
      q("-1.499"), rounded("3.21501712832247458e-299", "1e-316"));
  expect(
      "sin^700 x cos^233 x", [](const auto& x) { return pow(sin(x), 700) * pow(cos(x), 233); }, 1,
      q("1.05"), rounded("4.12247083255237085e-116", "1e-133"));
  expect(
      "(1+cos^2 x)^400", [](const auto& x) { return pow(1 + square(cos(x)), 400); }, 1, q("1.1"),
      rounded("1.11162885750378317e42", "1e25"));
  expect(
      "(4+cos x)^(2001/2)",
      [](const auto& x) { return support::real_power(4 + cos(x), rational(2001, 2)); }, 2,
      q("2.05"), rounded("1.67173057245511802e552", "1e535"));
}

// Poles at irrational ends, next to which the integrand is too small to be seen.
TEST(TaylorSeries, SeeThePoleAtAnEndWhereTheIntegrandIsSmall) {
  const end_point cube_root([](precision p) { return root(ball(18, p), 3); });
  const end_point of_square([](precision p) { return (4 + sqrt(ball(40, p))) / 2; });
  const auto is_refused = [](const auto& f, const end_point& b) {
    return integrate(f, 0, b, {.digits = 20}).verdict == status::not_certified;
  };
  EXPECT_TRUE(
      is_refused([](const auto& x) { return exp(-20 * square(x)) / (18 - pow(x, 3)); }, cube_root));
  EXPECT_TRUE(is_refused(
      [](const auto& x) {
        return 1 / (1 + exp(x)) + parse_rational("1e-40") / square(18 - pow(x, 3));
      },
      cube_root));
  EXPECT_TRUE(is_refused(
      [](const auto& x) { return exp(-16 * square(x)) / (square(x) - 4 * x - 6); }, of_square));
}

TEST(TaylorSeries, KeepANarrowIrrationalRange) {
  const end_point a([](precision p) { return sqrt(ball(2, p)); });
  const rational length = parse_rational("4.29e-16");
  const end_point b([=](precision p) { return sqrt(ball(2, p)) + length; });
  const rational slope = parse_rational("1.32e-308");
  const integral i =
      integrate([=](const auto& x) { return rational(1013, 1000) / (1 + exp(7 * x)) + slope * x; },
                a, b, {.digits = 300});
  ASSERT_EQ(i.verdict, status::certified);
  // The antiderivative of 1/(1+e^(7x)) is x - log(1+e^(7x))/7.
  const precision p = 2048;
  const auto of = [&](const ball& x) {
    return (x - log(1 + exp(7 * x)) / 7) * rational(1013, 1000) + square(x) * slope / 2;
  };
  EXPECT_TRUE(overlaps(i.enclosure, of(b.at(p)) - of(a.at(p))));
}

// The same over random ranges of all lengths: by both rules, and cut in two.
TEST(TaylorSeries, OfSteepFunctionsAreRight) {
  std::mt19937_64 random(29);
  const auto pick = [&](long low, long high) {
    return std::uniform_int_distribution<long>(low, high)(random);
  };
  const std::vector<
      std::function<integral(long, const end_point&, const end_point&, const integrate_options&)>>
      families{
          [](long n, const end_point& a, const end_point& b, const integrate_options& o) {
            return integrate([n](const auto& x) { return exp(x) * pow(1 + exp(x), n); }, a, b, o);
          },
          [](long n, const end_point& a, const end_point& b, const integrate_options& o) {
            return integrate([n](const auto& x) { return pow(1 + exp(-x), -n); }, a, b, o);
          },
          [](long n, const end_point& a, const end_point& b, const integrate_options& o) {
            return integrate([n](const auto& x) { return pow(1 + square(cos(x)), n); }, a, b, o);
          },
          [](long n, const end_point& a, const end_point& b, const integrate_options& o) {
            return integrate(
                [n](const auto& x) { return sin(x) * cos(x) * pow(2 + square(sin(x)), n); }, a, b,
                o);
          },
          [](long n, const end_point& a, const end_point& b, const integrate_options& o) {
            return integrate([n](const auto& x) { return pow(x, n) * exp(-n * x); }, a, b, o);
          },
      };
  int compared = 0;
  for (support::repeat trial(100); trial.again();) {
    const auto& f = families[static_cast<std::size_t>(pick(0, 4))];
    const long n = pick(0, 1) * pick(1, 1000) + pick(1, 40);
    const rational length = rational(pick(1, 99)) / support::power_of_ten(pick(2, 12));
    const rational start(pick(1, 150), 100);
    const auto point = [&](const rational& q) {
      return pick(0, 2) == 0
                 ? end_point([q](precision p) { return ball(q, p) + sqrt(ball(2, p)) / 10000; })
                 : end_point(q);
    };
    const end_point a = point(start);
    const end_point b = point(start + length + rational(1, 1000));
    const end_point middle = end_point(start + length / 2 + rational(1, 2000) + rational(1, 14142));
    const long digits = pick(5, 30);
    const integral x = f(n, a, b, {.digits = digits, .rule = quadrature_rule::taylor_series});
    if (x.verdict != status::certified) continue;
    ++compared;
    const integral y = f(n, a, b, {.digits = digits, .rule = quadrature_rule::gauss_legendre});
    const integral left = f(n, a, middle, {.digits = digits});
    const integral right = f(n, middle, b, {.digits = digits});
    EXPECT_TRUE(overlaps(x.enclosure, y.enclosure)) << n << ": " << support::described(x.enclosure);
    EXPECT_TRUE(overlaps(x.enclosure, left.enclosure + right.enclosure))
        << n << ": " << support::described(x.enclosure);
  }
  EXPECT_GE(compared, 50 * std::min(1.0, support::effort()) - 5);
}

// Rational functions' roots, exponential functions, and limits at random: by both rules.
TEST(TaylorSeries, AgreeWithGaussLegendre) {
  std::mt19937_64 random(23);
  const auto pick = [&](long low, long high) {
    return std::uniform_int_distribution<long>(low, high)(random);
  };
  int rounds = 0;
  int compared = 0;
  for (support::repeat trial(60); trial.again(); ++rounds) {
    const rational a(pick(-20, 20), pick(1, 7));
    const rational b = a + rational(pick(1, 30), pick(1, 9));
    const rational p(pick(-30, 30), pick(1, 9));
    const rational q(pick(1, 40), pick(1, 9));  // a pair of roots p +- i sqrt(q)
    const rational root = b + rational(pick(1, 20), pick(1, 9));
    const rational e(pick(-9, 9), pick(1, 5));
    const rational of_root(pick(-9, 9), pick(1, 4));
    const rational s(pick(-3, 3), pick(1, 3));
    const rational c(pick(-3, 3));
    const bool is_irrational = pick(0, 3) == 0;
    const rational frequency = pick(0, 1) * rational(pick(-9, 9), 4);
    const auto f = [=](const auto& x) {
      return (x - c + sin(frequency * x)) * cos(frequency * (square(x) - c)) *
             support::real_power(square(x - p) + q, e) * support::real_power(root - x, of_root) *
             exp(s * square(x) / 4 - x);
    };
    const end_point to = is_irrational ? end_point([=](precision bits) {
      return ball(a, bits) + (b - a) / sqrt(ball(2, bits));
    })
                                       : end_point(b);
    const long digits = pick(3, 40);
    const integral x =
        integrate(f, a, to, {.digits = digits, .rule = quadrature_rule::taylor_series});
    const integral y =
        integrate(f, a, to, {.digits = digits + 3, .rule = quadrature_rule::gauss_legendre});
    ASSERT_EQ(y.verdict, status::certified);
    if (x.verdict != status::certified) continue;
    ++compared;
    EXPECT_TRUE(overlaps(x.enclosure, y.enclosure))
        << "a = " << to_text(a) << ", b = " << to_text(b) << ", p = " << to_text(p)
        << ", q = " << to_text(q) << ", e = " << to_text(e) << ", root = " << to_text(root) << "^"
        << to_text(of_root) << ", s = " << to_text(s) << ": " << support::described(x.enclosure)
        << " and " << support::described(y.enclosure);
  }
  EXPECT_GE(compared, rounds * 9 / 10);
}

}  // namespace taylor_series_test
}  // namespace polhode
