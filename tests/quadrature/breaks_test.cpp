// integrate across breaks: kinks and jumps at irrational points.

#include <vector>

#include <gtest/gtest.h>

#include "polhode/expression/parse.hpp"
#include "quadrature/known_integrals.hpp"

namespace polhode {
namespace breaks_test {

using support::holds;
using support::known;
using support::known_integral;
using support::power_of_ten;
using support::right;

const end_point infinity = end_point::infinity();
const end_point pi_limit([](precision p) { return pi(p); });
ball number(long n, precision p) { return {n, p}; }
ball root_of(long n, precision p) { return sqrt(number(n, p)); }
const std::string antiderivative = "derivation: antiderivatives between the breaks";

/// One break or a few.
std::vector<known_integral> kinks() {
  const rational d = power_of_ten(-12);
  // Less than 1e-30 below and above the square root of 2.
  const rational below(parse_rational("1.414213562373095048801688724209"));
  const rational above = below + power_of_ten(-30);
  const auto kink = [](const auto& x) { return abs(x * x - 2); };
  // F = x^3/3 - 2x, F(sqrt 2) = -4 sqrt(2)/3.
  const auto primitive = [](const rational& x) { return rational(x * x * x / 3 - 2 * x); };
  return {
      known("|x^2-2|", antiderivative, kink, 1, 2,
            [](precision p) { return 8 * root_of(2, p) / 3 - 3; }),
      known("|x^2-2| from 1e-30 before the break", antiderivative, kink, below, 2,
            [=](precision p) { return primitive(below) + primitive(2) + 8 * root_of(2, p) / 3; }),
      known("|x^2-2| from 1e-30 beyond the break", antiderivative, kink, above, 2,
            [=](precision p) { return ball(rational(primitive(2) - primitive(above)), p); }),
      known("|x^2-2| from the break", antiderivative, kink,
            end_point([](precision p) { return root_of(2, p); }), 2,
            [=](precision p) { return primitive(2) + 4 * root_of(2, p) / 3; }),
      known("|x^2-2| up to the break", antiderivative, kink, 1,
            end_point([](precision p) { return root_of(2, p); }),
            [=](precision p) { return primitive(1) + 4 * root_of(2, p) / 3; }),
      known(
          "|x^3-2|", antiderivative, [](const auto& x) { return abs(pow(x, 3) - 2); }, 0, 2,
          [](precision p) { return 3 * root(number(2, p), 3); }),
      known(
          "|log(x)-1|", antiderivative, [](const auto& x) { return abs(log(x) - 1); }, 1, 4,
          [](precision p) { return 2 * exp(number(1, p)) + 8 * log(number(2, p)) - 10; }),
      known(
          "max(sin,cos)", antiderivative, [](const auto& x) { return max(sin(x), cos(x)); }, 0, 10,
          [](precision p) { return 3 * root_of(2, p) - cos(number(10, p)); }),
      known(
          "min(sin,cos)", "derivation: sin + cos - max(sin, cos)",
          [](const auto& x) { return min(sin(x), cos(x)); }, 0, 10,
          [](precision p) { return sin(number(10, p)) + 1 - 3 * root_of(2, p); }),
      known(
          "|(x^2-2)(x^2-2-1e-12)|", antiderivative,
          [=](const auto& x) { return abs((x * x - 2) * (x * x - (2 + d))); }, 0, 2,
          [=](precision p) {
            const auto g = [=](const ball& x) {
              return pow(x, 5) / 5 - (4 + d) * pow(x, 3) / 3 + (4 + 2 * d) * x;
            };
            return 2 * g(root_of(2, p)) - 2 * g(sqrt(ball(rational(2 + d), p))) + g(number(2, p));
          }),
      known(
          "|x^2-2|/x^4 to infinity", antiderivative,
          [](const auto& x) { return abs(x * x - 2) / pow(x, 4); }, 1, infinity,
          [](precision p) { return (2 * root_of(2, p) - 1) / 3; }),
      known(
          "|x^2-2|/x^4 from -infinity", "derivation: even function",
          [](const auto& x) { return abs(x * x - 2) / pow(x, 4); }, -infinity, -1,
          [](precision p) { return (2 * root_of(2, p) - 1) / 3; }),
  };
}

/// Many of them, and jumps.
std::vector<known_integral> waves_and_steps() {
  return {
      known(
          "|sin|", "derivation: 31 half waves and a part",
          [](const auto& x) { return abs(sin(x)); }, 0, 100,
          [](precision p) { return 63 + cos(number(100, p)); }),
      known(
          "|sin| to pi", antiderivative, [](const auto& x) { return abs(sin(x)); }, 0, pi_limit,
          [](precision p) { return number(2, p); }),
      known(
          "|sin| exp(-x)", "derivation: geometric series of half waves",
          [](const auto& x) { return abs(sin(x)) * exp(-x); }, 0, infinity,
          [](precision p) { return (1 + exp(-pi(p))) / (1 - exp(-pi(p))) / 2; }),
      known(
          "floor(x^2)", "derivation: the sum of 10 - sqrt(n)",
          [](const auto& x) { return floor(x * x); }, 0, 10,
          [](precision p) {
            ball sum(1000, p);
            for (long n = 1; n <= 100; ++n) sum -= root_of(n, p);
            return sum;
          }),
      known(
          "floor(exp)", "derivation: the sum of 5 - log(n)",
          [](const auto& x) { return floor(exp(x)); }, 0, 5,
          [](precision p) {
            ball sum(0, p);
            for (long n = 1; n <= 148; ++n) sum += 5 - log(number(n, p));
            return sum;
          }),
      known(
          "ceil(-x^2)", "derivation: minus that of floor(x^2)",
          [](const auto& x) { return ceil(-x * x); }, 0, 2,
          [](precision p) { return root_of(2, p) + root_of(3, p) - 5; }),
      known(
          "floor(exp(-x))", "derivation: 1 before log 2, and 0 beyond",
          [](const auto& x) { return floor(2 * exp(-x)); }, rational(1, 2), 2,
          [](precision p) { return log(number(2, p)) - rational(1, 2); }),
      known(
          "x ceil(x^2)", antiderivative, [](const auto& x) { return x * ceil(x * x); }, 0, 2,
          [](precision p) { return number(5, p); }),
      // At 1/2, a node, the value is 2.
      known(
          "floor(2-(x-1/2)^2)", "derivation: 1 but for one point",
          [](const auto& x) { return floor(2 - square(x - rational(1, 2))); }, 0, 1,
          [](precision p) { return number(1, p); }),
      known(
          "(1+ceil(x(1-x)(3-4x)^2-1)) exp(x)", "derivation: exp but for three points",
          [](const auto& x) { return (1 + ceil(x * (1 - x) * square(3 - 4 * x) - 1)) * exp(x); }, 0,
          1, [](precision p) { return exp(number(1, p)) - 1; }),
      known(
          "floor of a touching wave", "derivation: two steps; 3 is reached at a point only",
          [](const auto& x) { return floor(3 * sin(x)); }, 0, pi_limit,
          [](precision p) {
            return 2 * (pi(p) - asin(ball(rational(1, 3), p)) - asin(ball(rational(2, 3), p)));
          }),
  };
}

/// Breaks inside of functions that have breaks, and of several functions at one point.
std::vector<known_integral> nested() {
  return {
      known(
          "|(x-floor(x))^2-1/2|", antiderivative,
          [](const auto& x) { return abs(square(x - floor(x)) - rational(1, 2)); }, 0, 3,
          [](precision p) { return root_of(2, p) - rational(1, 2); }),
      known(
          "max(min(x^2,3-x),1/2)", antiderivative,
          [](const auto& x) {
            const auto half = 0 * x + rational(1, 2);
            return max(min(x * x, 3 - x), half);
          },
          0, 2,
          [](precision p) {
            const ball a = sqrt(ball(rational(1, 2), p));
            const ball b = (root_of(13, p) - 1) / 2;
            return a / 2 + (pow(b, 3) - pow(a, 3)) / 3 + 4 - (3 * b - b * b / 2);
          }),
      known(
          "floor(x)|x^2-3|", antiderivative,
          [](const auto& x) { return floor(x) * abs(x * x - 3); }, 1, 3,
          [](precision p) { return 4 * root_of(3, p) + rational(2, 3); }),
      known(
          "||x^2-3|-1|", antiderivative, [](const auto& x) { return abs(abs(x * x - 3) - 1); }, 0,
          3,
          [](precision p) {
            // x^2 - 2 up to sqrt 2 with a minus, then 2 - |..| pieces: G = x^3/3 - 2x, H = x^3/3 -
            // 4x.
            const ball s = root_of(2, p);
            const ball t = root_of(3, p);
            const auto g = [](const ball& x) { return pow(x, 3) / 3 - 2 * x; };
            const auto h = [](const ball& x) { return pow(x, 3) / 3 - 4 * x; };
            return -g(s) + (g(t) - g(s)) + (h(t) - h(number(2, p))) +
                   (h(number(3, p)) - h(number(2, p)));
          }),
      known(
          "|sin|+|sin 2x|", "derivation: half waves; both break at the multiples of pi",
          [](const auto& x) { return abs(sin(x)) + abs(sin(2 * x)); }, 0, 7,
          [](precision p) { return rational(19, 2) - cos(number(7, p)) - cos(number(14, p)) / 2; }),
      known(
          "|x^4-4x^2+4|", "derivation: the square of x^2 - 2 is not negative",
          [](const auto& x) { return abs(pow(x, 4) - 4 * x * x + 4); }, 0, 2,
          [](precision p) { return ball(rational(56, 15), p); }),
      known(
          "-|-(x^2-2)^2|", "derivation: minus the square of x^2 - 2",
          [](const auto& x) { return -abs(-square(x * x - 2)); }, 0, 2,
          [](precision p) { return ball(rational(-56, 15), p); }),
  };
}

/// The break is a singularity, too.
std::vector<known_integral> singular() {
  return {
      known(
          "|x^2-2|/(x^2-2)", "derivation: a jump from -1 to 1",
          [](const auto& x) { return abs(x * x - 2) / (x * x - 2); }, 1, 2,
          [](precision p) { return 3 - 2 * root_of(2, p); }),
      known(
          "1/sqrt|x^2-2|", antiderivative, [](const auto& x) { return 1 / sqrt(abs(x * x - 2)); },
          1, 2, [](precision p) { return pi(p) / 4 + log(1 + root_of(2, p)); }),
      known(
          "log|x^2-2|", antiderivative, [](const auto& x) { return log(abs(x * x - 2)); }, 0, 2,
          [](precision p) {
            const ball near = 2 - root_of(2, p);
            const ball far = 2 + root_of(2, p);
            return near * log(near) + far * log(far) - 4;
          }),
      known(
          "sqrt(max(0,x^2-2))", antiderivative,
          [](const auto& x) { return sqrt(max(0 * x, x * x - 2)); }, 0, 2,
          [](precision p) { return root_of(2, p) - log(1 + root_of(2, p)); }),
  };
}

/// Deciders that are 0 of an order above 1, at rational points.
std::vector<known_integral> of_high_order() {
  const auto remainder = [](const auto& x) { return sin(x) - x + pow(x, 3) / 6; };
  const rational r(7, 10);
  // Of (sin(x) - x + x^3/6)(r - x).
  const auto primitive = [=](const rational& q, precision p) {
    const ball x(q, p);
    return r * (-cos(x) - square(x) / 2 + pow(x, 4) / 24) - sin(x) + x * cos(x) + pow(x, 3) / 3 -
           pow(x, 5) / 30;
  };
  return {
      known(
          "|sin(x)-x+x^3/6|", antiderivative, [=](const auto& x) { return abs(remainder(x)); }, -1,
          1, [](precision p) { return rational(13, 12) - 2 * cos(number(1, p)); }),
      known(
          "|(sin(x)-x+x^3/6)(7/10-x)|", antiderivative,
          [=](const auto& x) { return abs(remainder(x) * (r - x)); }, -1, 1,
          [=](precision p) {
            return primitive(-1, p) - 2 * primitive(0, p) + 2 * primitive(r, p) - primitive(1, p);
          }),
      known(
          "|sin(x)-x+x^3/6| floor(x+1/2)", antiderivative,
          [=](const auto& x) { return abs(remainder(x)) * floor(x + rational(1, 2)); }, -1, 3,
          [](precision p) {
            const auto f = [&](long n) {
              const ball x(rational(n, 2), p);
              return -cos(x) - square(x) / 2 + pow(x, 4) / 24;
            };
            return f(-1) - f(-2) + 3 * f(6) - f(1) - f(3) - f(5);
          }),
      known(
          "max(cos(x),1-x^2/2)", "derivation: cos(x) > 1 - x^2/2 but at 0",
          [](const auto& x) { return max(cos(x), 1 - x * x / 2); }, -1, 2,
          [](precision p) { return sin(number(2, p)) + sin(number(1, p)); }),
      known(
          "|(x-1/3)^3 exp(x)|", antiderivative,
          [](const auto& x) { return abs(pow(x - rational(1, 3), 3) * exp(x)); }, -1, 2,
          [](precision p) {
            // e^x (w^3 - 3 w^2 + 6 w - 6), w = x - 1/3.
            const auto f = [&](const rational& x) {
              const rational w = x - rational(1, 3);
              return exp(ball(x, p)) * (w * w * w - 3 * w * w + 6 * w - 6);
            };
            return f(2) - 2 * f(rational(1, 3)) + f(-1);
          }),
      known(
          "min(|exp(x)-1-x|,exp(x)/2)", "derivation: exp(x) >= 1 + x; below exp(x)/2 here",
          [](const auto& x) { return min(abs(exp(x) - 1 - x), exp(x) / 2); }, -rational(1, 4),
          rational(1, 4),
          [](precision p) {
            const ball q(rational(1, 4), p);
            return exp(q) - exp(-q) - rational(1, 2);
          }),
  };
}

TEST(Breaks, ToFiftyDigits) {
  for (const auto& group : {kinks(), waves_and_steps(), nested(), singular(), of_high_order()}) {
    for (const known_integral& k : group) EXPECT_TRUE(right(k, 50));
  }
}

/// At multiples of pi: where both sides have one sign there is no break, where they have not there
/// is one, of the third order.
TEST(Breaks, AtMultiplesOfPi) {
  const auto value = [](const char* f, long from, long to) {
    const integral i = integrate(parse(f), from, to, {.digits = 20});
    EXPECT_EQ(i.verdict, status::certified) << f << ": " << i.obstacle;
    EXPECT_LE(i.account.panels, 100) << f;
    return i.enclosure;
  };
  // 11 + sin(11) - 2 - sin(2).
  EXPECT_TRUE(
      overlaps(value("abs(1+cos(x))", 2, 11), 9 + sin(number(11, 200)) - sin(number(2, 200))));
  // F = cos(x)^3/3 - cos(x) is that of sin(x)^3, and 2/3 at pi, -2/3 at 2 pi and at 0.
  const auto primitive = [](long x) {
    const ball c = cos(number(x, 200));
    return c * c * c / 3 - c;
  };
  const integral cubed = integrate(parse("abs(sin(x)^3)"), 1, 5, {.digits = 10});
  EXPECT_TRUE(cubed.verdict != status::certified ||
              overlaps(cubed.enclosure, rational(4, 3) - primitive(1) - primitive(5)));
}

TEST(Breaks, ToFewDigits) {
  for (const auto& group : {kinks(), waves_and_steps(), nested(), singular(), of_high_order()}) {
    for (const known_integral& k : group) EXPECT_TRUE(right(k, 5));
  }
}

/// What it takes: a few panels for each piece.
TEST(Breaks, AThousandDigitsTakeFewPanels) {
  struct row {
    known_integral what;
    long panels;
    long evaluations;
  };
  const auto kink = kinks();
  const auto single = singular();
  for (const row& r : {row{kink[0], 2, 260}, row{kink[1], 2, 400}, row{kink[6], 4, 1700},
                       row{kink[7], 5, 1300}, row{kink[9], 3, 700}, row{single[1], 4, 3000}}) {
    EXPECT_TRUE(right(r.what, 1000));
    const integral i = r.what.run({.digits = 1000});
    EXPECT_LE(i.account.panels, r.panels) << r.what.name;
    EXPECT_LE(i.account.evaluations, r.evaluations) << r.what.name;
  }
}

/// The integral of |x^2 - q|, F(sqrt q) = -2 q sqrt(q)/3 for F = x^3/3 - q x.
TEST(Breaks, AnywhereInTheRange) {
  support::random_source random(20240607);
  for (support::repeat trial(60); trial.again();) {
    const rational q(random.between(1, 4'000'000), 1'000'003);
    const rational a(random.between(0, 1000), 1001);
    const rational b = a + rational(random.between(1, 3000), 997);
    const auto primitive = [&](const rational& x) { return rational(x * x * x / 3 - q * x); };
    const integral i =
        integrate([=](const auto& x) { return abs(x * x - q); }, a, b, {.digits = 30});
    EXPECT_EQ(i.verdict, status::certified);
    const ball r = sqrt(ball(q, 300));
    ball value(rational(primitive(b) - primitive(a)), 300);
    if (certainly_less(r, ball(a, 300))) {
    } else if (certainly_less(ball(b, 300), r)) {
      value = -value;
    } else {
      value = rational(primitive(a) + primitive(b)) + 4 * q * r / 3;
    }
    EXPECT_TRUE(holds(i, value)) << q << " " << a << " " << b;
    EXPECT_LE(i.account.panels, 4);
  }
}

template <class F>
void refused(const F& f, const end_point& a, const end_point& b, reason why) {
  const integral i = integrate(f, a, b, {.digits = 5});
  EXPECT_EQ(i.verdict, status::not_certified);
  EXPECT_EQ(to_text(i.why), to_text(why)) << i.obstacle;
  EXPECT_TRUE(i.enclosure.is_undefined());
}

TEST(Breaks, RefusesWhatIsNotIntegrable) {
  const auto kink = [](const auto& x) { return abs(x * x - 2); };
  refused([](const auto& x) { return abs(1 / (x * x - 2)); }, 1, 2, reason::not_analytic);
  refused([=](const auto& x) { return 1 / kink(x); }, 1, 2, reason::not_integrable);
  refused([=](const auto& x) { return 1 / square(kink(x)); }, 1, 2, reason::not_integrable);
  refused([](const auto& x) { return abs(log(x - 3)); }, 1, 4, reason::not_defined);
  refused([](const auto& x) { return 1 / sqrt(abs(tan(x) - x)); }, -1, 1, reason::not_integrable);
}

/// Breaks that crowd at a point.
TEST(Breaks, GivesUpOnInfinitelyMany) {
  refused([](const auto& x) { return abs(sin(exp(1 / x))); }, 0, 1, reason::not_analytic);
}

/// Constants that are balls limit how well a break is known; the answer is as wide as they make it.
TEST(Breaks, OfConstantsInBalls) {
  const ball c = sqrt(ball(2, 80));
  const auto f = [=](const auto& x) { return abs(x - c); };
  const integral coarse = integrate(f, 1, 2, {.digits = 15});
  EXPECT_EQ(coarse.verdict, status::certified);
  const ball value = (square(root_of(2, 300) - 1) + square(2 - root_of(2, 300))) / 2;
  EXPECT_TRUE(holds(coarse, value));
  const integral fine = integrate(f, 1, 2, {.digits = 100});
  EXPECT_EQ(fine.why, reason::precision_limit);
  EXPECT_TRUE(holds(fine, value));
}

}  // namespace breaks_test
}  // namespace polhode
