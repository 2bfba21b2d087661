// Tails of functions that have a period but for a decaying factor.

#include <gtest/gtest.h>

#include <string>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "quadrature/formula/periodic_tail.hpp"

namespace polhode {
namespace periodic_tail_test {

/// With few terms and orders, where what is left out is most of the error.
TEST(SumsOfPowers, HoldZeta) {
  constexpr precision p = 256;
  for (const long shifts : {0L, 1L, 2L, 5L}) {
    for (const long order : {0L, 1L, 2L, 4L}) {
      const auto sums = detail::sums_of_powers(2, 1, ball(1, p), 6, shifts, order, p);
      for (std::size_t j = 0; j < sums.size(); ++j) {
        const ball exact = zeta(j + 2, p);
        EXPECT_TRUE(contains(sums[j], exact)) << shifts << ' ' << order << ' ' << j;
        // The bound is twice a term that the error is nearly as great as.
        if (shifts == 5) {
          const ball middle(rational(lower_rational(sums[j]) + upper_rational(sums[j])), p);
          EXPECT_FALSE(
              certainly_less(abs(middle / 2 - exact) * 100,
                             ball(rational(upper_rational(sums[j]) - lower_rational(sums[j])), p)))
              << order << ' ' << j;
        }
      }
    }
  }
}

/// 1 + 1/9 + 1/25 + ... = pi^2/8, by a period and a start that are no whole numbers.
TEST(SumsOfPowers, ScaleWithThePeriod) {
  constexpr precision p = 200;
  const ball exact = square(pi(p)) / 8;
  for (const rational& unit : {rational(1), rational(1, 3), rational(7, 2)}) {
    const auto sums = detail::sums_of_powers(2, unit, ball(rational(2 * unit), p), 1, 3, 2, p);
    EXPECT_TRUE(contains(sums[0], exact / (unit * unit))) << unit;
  }
}

/// The integral beyond the start, which does not depend on p.
ball tail_of(const expression& f, const rational& from, precision p) {
  const auto tail = detail::periodic_tail_of(f, from, p);
  EXPECT_TRUE(tail) << f.to_text();
  if (!tail) return ball::undefined(p);
  const integral folded =
      integrate(tail->folded, end_point(-tail->half), end_point(tail->half), {.digits = 60});
  EXPECT_EQ(folded.verdict, status::certified) << f.to_text();
  return folded.enclosure.enlarged(tail->rest);
}

/// The same tail to few bits and to many.
void expect_one_value(const char* text, const rational& from) {
  const expression f = parse(text);
  const ball exact = tail_of(f, from, 200);
  for (const precision p : {1, 2, 4, 8, 16, 32, 64, 128}) {
    EXPECT_TRUE(contains(tail_of(f, from, p), exact)) << text << ", " << from << ", " << p;
  }
  EXPECT_TRUE(
      certainly_less(abs(tail_of(f, from, 64) - exact), abs(exact) / ball(integer(1) << 40, 64)))
      << text << ", " << from;
}

/// From far on, many periods are of nearly one size.
TEST(PeriodicTail, HoldsItsValueAtEveryPrecision) {
  for (const char* text : {"abs(sin(x))/x^2",
                           "1/(2 + sin(x))/x^2",
                           "log(2 + cos(x))/(1 + x^2)",
                           "floor(x)/x^3",
                           "exp(3*sin(x))/x^(3/2)",
                           "cos(2*pi*x)^2/(x^2 - x - 3)",
                           "(x - floor(x))/(x^2 + 3*x)",
                           "exp(cos(5*x))*(x + 1)/(2*x^3 + 7)",
                           "1/(3 + sin(x))/x^40",
                           "exp(14 + sin(x))/x^2",
                           "(x - floor(x) - 1/2)/x",
                           "(floor(3*x) - 3*x + 1/2)*x^(1/3)/(x + 2)",
                           "(2*(x/2 - floor(x/2))^3 - 1/2)/sqrt(x)",
                           "cos(x)/(5 + 4*sin(x))*(x - 1)/(x^2 + 1)",
                           "1/(x^2 + 3*x*sin(x) + 5)",
                           "sin(x)/(x + 2*cos(x) + 2)",
                           "1/(x^2*(3 + 2*sin(x)) + 1)",
                           "(x + 1)*sqrt(x + sin(x))/(x^3 + 2)/sqrt(x^2*(2 + cos(x)) + x)",
                           "1/floor(x + 3/2)^2",
                           "1/(x + sin(x)) - 1/x",
                           "(10^9)^2/(10^9*x + 10^9*sin(x))^2",
                           "1/(x^2/10^9 + 1/10^9 + sin(x)/10^9)"}) {
    for (const rational& from : {rational(1), rational(100000)}) expect_one_value(text, from);
  }
  for (const char* text : {"log(abs(sin(x)))/x^2", "log(abs(sin(x)))*exp(-x)",
                           "sqrt(x - floor(x))*exp(-x)", "x^2*exp(-x)*abs(cos(x))^(1/3)"}) {
    expect_one_value(text, 1);
  }
}

ball of(const char* f, const end_point& a, const end_point& b) {
  const integral found = integrate(parse(f), a, b, {.digits = 40});
  EXPECT_EQ(found.verdict, status::certified) << f << ": " << found.obstacle;
  return found.enclosure;
}

TEST(PeriodicTail, GivesKnownIntegrals) {
  constexpr precision p = 200;
  const end_point inf = end_point::infinity();
  const ball euler = -digamma(ball(1, p));
  EXPECT_TRUE(overlaps(of("floor(x)/x^3", 1, inf), square(pi(p)) / 12));
  EXPECT_TRUE(overlaps(of("(x - floor(x))/x^2", 1, inf), 1 - euler));
  EXPECT_TRUE(overlaps(of("(ceil(x) - x)/x^2", 1, inf), euler));
  // By the Fourier series of log(2 + cos x) and of 1/(2 + cos x), with q = 2 - sqrt 3.
  const ball q = 2 - sqrt(ball(3, p));
  const ball inner = q * exp(ball(-1, p));
  const ball whole = pi(p) * (2 * log(1 + inner) - log(2 * q));
  EXPECT_TRUE(overlaps(of("log(2 + cos(x))/(1 + x^2)", -inf, inf), whole));
  EXPECT_TRUE(overlaps(of("log(2 + cos(x))/(1 + x^2)", 0, inf), whole / 2));
  EXPECT_TRUE(overlaps(of("log(2 + cos(x))/(1 + x^2)", -inf, 0), whole / 2));
  EXPECT_TRUE(overlaps(of("1/(2 + cos(x))/(1 + x^2)", -inf, inf),
                       pi(p) / sqrt(ball(3, p)) * (1 - inner) / (1 + inner)));
  // Of several periods, in both orders.
  const ball faster = q * exp(ball(-2, p));
  const ball both =
      pi(p) / sqrt(ball(3, p)) * ((1 - inner) / (1 + inner) + (1 - faster) / (1 + faster));
  EXPECT_TRUE(overlaps(of("(1/(2 + cos(x)) + 1/(2 + cos(2*x)))/(1 + x^2)", -inf, inf), both));
  EXPECT_TRUE(overlaps(of("(1/(2 + cos(2*x)) + 1/(2 + cos(x)))/(1 + x^2)", -inf, inf), both));
  EXPECT_TRUE(overlaps(of("(x - floor(x) + 2*x - floor(2*x))/x^2", 1, inf),
                       4 - 3 * euler - 2 * log(ball(2, p))));
  // |sin| by its Fourier series, 2/pi - (4/pi) sum of cos(2 k x)/(4 k^2 - 1): over (-inf, inf)
  // with 1/(1 + x^2) it is 2 - 4 sum of e^-2k/(4 k^2 - 1) = 4 sinh(1) atanh(e^-1).
  const ball e = exp(ball(1, p));
  EXPECT_TRUE(
      overlaps(of("abs(sin(x))/(1 + x^2)", -inf, inf), 4 * sinh(ball(1, p)) * atanh(1 / e)));
  // Functions beyond the table, to both infinities.
  for (const char* even : {"ellipticK(sin(x)^2/2)/x^2", "ellipticK(cos(x)/2)/x^2"}) {
    EXPECT_TRUE(overlaps(of(even, -inf, -1), of(even, 1, inf))) << even;
  }
}

TEST(PeriodicTail, MayHavePowersOfPolynomialsWithPeriodicCoefficients) {
  constexpr precision p = 200;
  const end_point inf = end_point::infinity();
  EXPECT_TRUE(overlaps(of("1/floor(x)^2", 1, inf), square(pi(p)) / 6));
  EXPECT_TRUE(overlaps(of("1/(floor(x)*ceil(x))", 1, inf), ball(1, p)));
  EXPECT_TRUE(overlaps(of("1/floor(x)^3 - 1/ceil(x)^3", 1, inf), ball(1, p)));
  // Derivatives of 1/(x^2 + sin x), (x + sin x)^(-1/2), cos(x)/(x + sin x), and of one of these
  // times 1/x, whose leading coefficients have a period.
  const ball s = sin(ball(2, p));
  EXPECT_TRUE(overlaps(of("(2*x + cos(x))/(x^2 + sin(x))^2", 2, inf), 1 / (4 + s)));
  EXPECT_TRUE(overlaps(of("(1 + cos(x))/(x + sin(x))^(3/2)", 2, inf), 2 / sqrt(2 + s)));
  EXPECT_TRUE(overlaps(of("(sin(x)*(x + sin(x)) + cos(x)*(1 + cos(x)))/(x + sin(x))^2", 2, inf),
                       cos(ball(2, p)) / (2 + s)));
  EXPECT_TRUE(overlaps(of("(2 + sin(x) + x*cos(x))/(x*(2 + sin(x)) - 3)^2", 2, inf),
                       1 / (2 * (2 + s) - 3)));
  EXPECT_TRUE(overlaps(of("((1 + cos(x))/(x + sin(x)) + (2*x - sin(x))/(2*(x^2 + cos(x))))"
                          "/((x + sin(x))*sqrt(x^2 + cos(x)))",
                          2, inf),
                       1 / ((2 + s) * sqrt(4 + cos(ball(2, p))))));
  // sin(x)/(x + sin(x)) = sin(x)/x - sin(x)^2/x^2 + sin(x)^3/(x^2 (x + sin(x))).
  EXPECT_TRUE(overlaps(of("sin(x)/(x + sin(x))", 1, inf),
                       of("sin(x)/x", 1, inf) - of("sin(x)^2/x^2", 1, inf) +
                           of("sin(x)^3/(x^2*(x + sin(x)))", 1, inf)));
}

/// log|2 sin(x/2)| = -the sum of cos(n x)/n, and so its integral with 1/(1 + x^2) over the line is
/// -pi times the sum of e^-n/n; and |sin(pi x)|^(-1/2)/x^2 against its parts.
TEST(PeriodicTail, MayHaveIntegrablePoles) {
  constexpr precision p = 200;
  const end_point inf = end_point::infinity();
  EXPECT_TRUE(
      overlaps(of("log(abs(2*sin(x/2)))/(1 + x^2)", -inf, inf), pi(p) * log(1 - exp(ball(-1, p)))));
  EXPECT_TRUE(overlaps(of("log(abs(cos(x)))/x^2", 1, inf),
                       of("log(abs(cos(x)))/x^2", 1, 9) + of("log(abs(cos(x)))/x^2", 9, inf)));
  EXPECT_TRUE(overlaps(of("1/sqrt(abs(sin(pi*x)))/x^2", rational(3, 2), inf),
                       of("1/sqrt(abs(sin(pi*x)))/x^2", rational(3, 2), 7) +
                           of("1/sqrt(abs(sin(pi*x)))/x^2", 7, inf)));
}

TEST(PeriodicTail, MayDecayExponentiallyBesidePolesAndRoots) {
  constexpr precision p = 200;
  const end_point inf = end_point::infinity();
  // By the cosine series the sum of -1/(n (1 + n^2)).
  EXPECT_TRUE(
      overlaps(of("log(abs(2*sin(x/2)))*exp(-x)", 0, inf), -of("(1-cos(x))/(exp(x)-1)", 0, inf)));
  // Each period is e^-T times the one before.
  const end_point half_turn(pi_combination{0, 1});
  EXPECT_TRUE(overlaps(of("abs(sin(x))^(1/3)*exp(-x)", 0, inf) * (1 - exp(-pi(p))),
                       of("abs(sin(x))^(1/3)*exp(-x)", 0, half_turn)));
  EXPECT_TRUE(overlaps(of("exp(-x)/sqrt(x - floor(x))", 0, inf) * (1 - exp(ball(-1, p))),
                       of("exp(-x)/sqrt(x)", 0, 1)));
  EXPECT_TRUE(overlaps(of("log(abs(cos(x)))*x^2*exp(-x^2)", -inf, inf),
                       2 * of("log(abs(cos(x)))*x^2*exp(-x^2)", 0, 7) +
                           2 * of("log(abs(cos(x)))*x^2*exp(-x^2)", 7, inf)));
  for (const char* f : {"exp(-x)/abs(sin(x))", "log(abs(sin(x)))*exp(x)", "log(abs(sin(x)))",
                        "sqrt(sin(x))*exp(-x)", "log(abs(sin(x)))*(exp(-x) + 1)"}) {
    EXPECT_NE(integrate(parse(f), 1, inf, {.digits = 10}).verdict, status::certified) << f;
  }
}

TEST(PeriodicTail, OfMeanZeroMayDecaySlowly) {
  constexpr precision p = 200;
  const end_point inf = end_point::infinity();
  // Stirling's formula; and that of Euler and Maclaurin for x^(1/2), with zeta(-1/2) =
  // -zeta(3/2)/(4 pi), where zeta(3/2) is 2.612375348685488343348567567924...
  EXPECT_TRUE(overlaps(of("(x - floor(x) - 1/2)/x", 1, inf), log(2 * pi(p)) / 2 - 1));
  const ball zeta_3_2 = ball(parse_rational("2.6123753486854883433485675679"), p)
                            .enlarged(magnitude::power_of_two(-90));
  // The sum of (-1)^n log((n+1)/n) over n >= 1: Wallis's product.
  EXPECT_TRUE(overlaps(of("(-1)^floor(x)/x", 1, inf), log(2 / pi(p))));
  EXPECT_TRUE(overlaps(of("(x - floor(x) - 1/2)/sqrt(x)", 1, inf),
                       rational(1, 3) - zeta_3_2 / (2 * pi(p))));
  // Of several terms whose means cancel.
  EXPECT_TRUE(overlaps(of("(floor(2*x) - 2*floor(x) - 1/2)/x", 1, inf),
                       (log(2 * pi(p)) - 3 * log(ball(2, p))) / 2));
  EXPECT_TRUE(overlaps(of("floor(2/x) - 2*floor(1/x)", 0, 1), 2 * log(ball(2, p)) - 1));
  EXPECT_TRUE(overlaps(of("floor(1/x) - 1/x + 1/2", 0, 1), -digamma(ball(1, p)) - rational(1, 2)));
  // Odd about a quarter of a period.
  EXPECT_TRUE(overlaps(
      of("cos(x)/(5 + 4*sin(x))/sqrt(x)", 1, inf),
      of("cos(x)/(5 + 4*sin(x))/sqrt(x)", 1, 20) + of("cos(x)/(5 + 4*sin(x))/sqrt(x)", 20, inf)));
}

TEST(PeriodicTail, OfAnotherMeanIsRefused) {
  for (const char* f :
       {"(x - floor(x) - 1/3)/x", "(x - floor(x) - 1/2 - 1/10^30)/x", "x - floor(x) - 1/2",
        "x*(x - floor(x) - 1/2)", "(floor(2*x) - 2*floor(x) + 1/2)/x", "exp(sin(x))/x",
        "(x - floor(x) - 1/2)/x + (x - floor(x) - 1/3)/sqrt(x)", "(x - floor(x))/sqrt(x) - 1/2/x",
        "abs(sin(x))/x", "(abs(cos(x)) - 2/3)/x", "cos(x)/(1 + sin(x))/sqrt(x)",
        "sin(x)^2/(x + sin(x))", "1/(x + sin(x)) - 1/(x + 1)^2", "sin(x)/(x*(2 + sin(x)) + 1)",
        "(1 + 1/10^9)/(x + sin(x)) - 1/x", "1/sqrt(x^2 + x*sin(x))"}) {
    EXPECT_FALSE(detail::periodic_tail_of(parse(f), 1, 64)) << f;
    EXPECT_NE(integrate(parse(f), 1, end_point::infinity(), {.digits = 10}).verdict,
              status::certified)
        << f;
  }
}

TEST(PeriodicTail, IsRefusedWhereItMayNotConverge) {
  for (const char* f :
       {"abs(sin(x))/x", "floor(x)/x^2", "abs(sin(x))/sqrt(x)", "tan(x)^2/x^2", "1/sin(x)^2/x^2",
        "1/(1 + sin(x))/x^2", "exp(sin(x))", "x*exp(sin(x))", "exp(sin(x)*cos(pi*x))/x^2",
        "abs(sin(x^2))/x^2", "1/(2 + sin(x) + log(x))/x",
        // A divisor that vanishes ever again, or whose leading coefficient does.
        "1/(x*sin(x) + 1)/x^2", "1/(x*(1 + sin(x)) + 1)/x^2", "1/(x^2*sin(x)^2 + 2)/x",
        "sqrt(x*sin(x) + x^2*(1/2 - cos(x)))/x^4", "(x*sin(x) + x)/(x*sin(x) + x)/x^2",
        "sqrt(x*max(sin(x), 0) + x*max(sin(x), 0)^2)/sqrt(x*max(sin(x), 0) + x*max(sin(x), 0)^2)"
        "/x^2",
        // Defined on a part of each period alone.
        "sqrt(sin(x))/x^2", "exp(sin(x))/x^2 + acos(3/2 + sin(x))*(1/x - 1/x)"}) {
    EXPECT_FALSE(detail::periodic_tail_of(parse(f), 1, 64)) << f;
    EXPECT_NE(integrate(parse(f), 1, end_point::infinity(), {.digits = 10}).verdict,
              status::certified)
        << f;
  }
}

TEST(Reciprocals, OfStepsAndKinksHaveIntegralsUpToZero) {
  constexpr precision p = 200;
  const ball euler = -digamma(ball(1, p));
  EXPECT_TRUE(overlaps(of("1/x - floor(1/x)", 0, 1), 1 - euler));
  EXPECT_TRUE(overlaps(of("x*floor(1/x)", 0, 1), square(pi(p)) / 12));
  EXPECT_TRUE(overlaps(of("x*floor(1/x)", 1, 0), -square(pi(p)) / 12));
  EXPECT_TRUE(overlaps(of("x*floor(1/x)", -1, 0), square(pi(p)) / 12 + rational(1, 2)));
  EXPECT_TRUE(overlaps(of("x*floor(1/x)", -1, 1), square(pi(p)) / 6 + rational(1, 2)));
  // To an end that is no rational number, and to infinity.
  const end_point root([](precision q) { return sqrt(ball(2, q)); });
  EXPECT_TRUE(
      overlaps(of("x^2*floor(3/x)", 0, root) + of("x^2*floor(3/x)", root, 3), 9 * zeta(3, p)));
  EXPECT_TRUE(overlaps(of("x*abs(sin(1/x))/(1 + x)^3", 0, end_point::infinity()),
                       of("x*abs(sin(1/x))/(1 + x)^3", 0, rational(1, 4)) +
                           of("x*abs(sin(1/x))/(1 + x)^3", rational(1, 4), end_point::infinity())));
}

TEST(Tangents, OfABranchBeyondTheFirstAreShifted) {
  constexpr precision p = 200;
  const auto half_turns = [](long n) { return end_point::pi(rational(n, 2)); };
  EXPECT_TRUE(overlaps(
      of("cos(tan(x))*exp(x)", half_turns(1), 4),
      exp(pi(p)) * of("cos(tan(x))*exp(x)", half_turns(-1), end_point(pi_combination{4, -1}))));
}

// In u = tan(x): the integral of cos(u)/(1 + u^2) over (0, inf) is pi/(2 e).
TEST(Tangents, OfWavesHaveIntegralsAcrossTheirPoles) {
  constexpr precision p = 200;
  const auto half_turns = [](long n) { return end_point::pi(rational(n, 2)); };
  const ball half = pi(p) / 2 * exp(ball(-1, p));
  EXPECT_TRUE(overlaps(of("cos(tan(x))", 0, half_turns(1)), half));
  EXPECT_TRUE(overlaps(of("cos(tan(x))", half_turns(1), 0), -half));
  EXPECT_TRUE(overlaps(of("cos(tan(x))", half_turns(-1), half_turns(1)), 2 * half));
  EXPECT_TRUE(overlaps(of("cos(tan(x))", half_turns(1), half_turns(5)), 4 * half));
  EXPECT_TRUE(overlaps(of("cos(tan(x))", half_turns(-4), half_turns(6)), 10 * half));
  EXPECT_TRUE(overlaps(of("sin(tan(x))*tan(x)", 0, half_turns(1)), half));
  // By symmetry about pi/2, and to ends that are no multiples of pi.
  EXPECT_TRUE(overlaps(of("x*cos(tan(x))", 0, half_turns(2)), pi(p) * half));
  EXPECT_TRUE(overlaps(of("cos(tan(x))", 1, 3),
                       of("cos(tan(x))", 1, half_turns(1)) + of("cos(tan(x))", half_turns(1), 3)));
  for (const char* f : {"sin(tan(x))*tan(x)^2", "cos(tan(x))/cos(x)^3", "cos(tan(x))*tan(x)^2"}) {
    EXPECT_NE(integrate(parse(f), 0, half_turns(1), {.digits = 10}).verdict, status::certified)
        << f;
  }
}

TEST(Reciprocals, ThatMayNotConvergeAreRefused) {
  for (const char* f : {"floor(1/x)", "abs(sin(1/x))/x", "x^2*floor(1/x^3)", "1/floor(1/x^2)^-1"}) {
    EXPECT_NE(integrate(parse(f), 0, 1, {.digits = 10}).verdict, status::certified) << f;
  }
}

}  // namespace periodic_tail_test
}  // namespace polhode
