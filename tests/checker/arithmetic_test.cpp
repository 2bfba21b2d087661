// The checker's arithmetic against the prover's, with which it shares nothing: both hold the true
// value, so they overlap; and the checker's intervals are narrow.

#include <gtest/gtest.h>

#include <random>

#include "checker/elliptic.hpp"
#include "checker/interval.hpp"
#include "checker/polynomial.hpp"
#include "generous.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/elliptic/complete.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "support/random.hpp"

namespace polhode::checker {
namespace arithmetic_test {

using support::repeat;

polhode::rational as_provers(const rational& q) { return polhode::rational(q.str()); }

/// They overlap, and the checker's has at most so many units.
void expect_same(const interval& x, const ball& y, const integer& units, const char* what) {
  ASSERT_TRUE(y.is_bounded()) << what;
  EXPECT_LE(as_provers(x.lower()), upper_rational(y)) << what;
  EXPECT_LE(lower_rational(y), as_provers(x.upper())) << what;
  EXPECT_LE(x.high() - x.low(), units) << what << " at " << static_cast<long>(x.bits()) << " bits";
}

class draw {
 public:
  long whole(long low, long high) {
    return std::uniform_int_distribution<long>(low, high)(engine_);
  }
  /// n/d with d up to 10^6, of both signs, up to 2^(+-scale).
  rational fraction(long scale) {
    const rational q(integer(whole(-1'000'000, 1'000'000)), integer(whole(1, 1'000'000)));
    return q * power_of_two(whole(-scale, scale));
  }

 private:
  std::mt19937_64 engine_{20};
};

TEST(Interval, FunctionsHoldTheTrueValues) {
  draw d;
  for (repeat trial(300); trial.again();) {
    const precision bits = at_bits(d.whole(40, 700));
    const long p = bits + 40;
    const rational q = d.fraction(4) / 1000;
    const interval x(q, bits);
    const ball y(as_provers(q), p);
    // The argument's two ends are a unit apart, which e^x multiplies.
    if (q < 6) expect_same(exp(x), exp(y), 450, "exp");
    expect_same(atan(x), atan(y), 5, "atan");
    expect_same(sin_cos(x).sine, sin(y), 5, "sin");
    expect_same(sin_cos(x).cosine, cos(y), 5, "cos");
    expect_same(pi(bits), polhode::pi(p), 3, "pi");
    const rational size = abs(q) + rational(1, 8);
    expect_same(log(interval(size, bits)), log(ball(as_provers(size), p)), 12, "log");
    expect_same(sqrt(interval(size, bits)), sqrt(ball(as_provers(size), p)), 5, "sqrt");
    expect_same(asinh(interval(size, bits)), asinh(ball(as_provers(size), p)), 24, "asinh");
  }
}

TEST(Interval, WideArgumentsHoldTheValuesOfTheirMembers) {
  draw d;
  for (repeat trial(200); trial.again();) {
    const precision bits = at_bits(d.whole(30, 200));
    const rational a = d.fraction(3) / 100;
    const rational b = a + abs(d.fraction(3)) / 1'000'000;
    const rational m = a + (b - a) * rational(d.whole(0, 100), 100);
    const interval x = interval::between(a, b, bits);
    const ball y(as_provers(m), static_cast<long>(bits) + 30);
    const auto holds = [&](const interval& wide, const ball& value, const char* what) {
      EXPECT_LE(as_provers(wide.lower()), upper_rational(value)) << what;
      EXPECT_LE(lower_rational(value), as_provers(wide.upper())) << what;
    };
    if (b < 20) holds(exp(x), exp(y), "exp");
    holds(atan(x), atan(y), "atan");
    holds(sin_cos(x).sine, sin(y), "sin");
    holds(sin_cos(x).cosine, cos(y), "cos");
    holds(square(x), square(y), "square");
    if (x.is_positive()) {
      holds(log(x), log(y), "log");
      holds(sqrt(x), sqrt(y), "sqrt");
    }
  }
}

TEST(Interval, ArithmeticIsThatOfTheEnds) {
  draw d;
  for (repeat trial(500); trial.again();) {
    const precision bits = at_bits(d.whole(20, 90));
    const auto some = [&] {
      const rational a = d.fraction(2);
      return interval::between(a, a + abs(d.fraction(2)), bits);
    };
    const auto member = [&](const interval& x) {
      return x.lower() + (x.upper() - x.lower()) * rational(d.whole(0, 10), 10);
    };
    const interval x = some();
    const interval y = some();
    const rational p = member(x);
    const rational q = member(y);
    const auto holds = [](const interval& r, const rational& value) {
      return r.lower() <= value && value <= r.upper();
    };
    EXPECT_TRUE(holds(x + y, p + q));
    EXPECT_TRUE(holds(x - y, p - q));
    EXPECT_TRUE(holds(x * y, p * q));
    EXPECT_TRUE(holds(x / 7, p / 7));
    EXPECT_TRUE(holds(x * -7, p * -7));
    EXPECT_TRUE(holds(x.scaled(-3), p / 8));
    EXPECT_TRUE(holds(x.with_bits(bits + -15), p));
    if (y.is_positive() || y.is_negative()) {
      EXPECT_TRUE(holds(x / y, p / q));
    } else {
      EXPECT_THROW(static_cast<void>(x / y), undecided);
    }
  }
}

TEST(Interval, WhatIsNotDefinedIsUndecided) {
  const auto at = [](const char* q) { return interval(rational(q), at_bits(60)); };
  EXPECT_THROW(static_cast<void>(sqrt(at("-1/1000000"))), undecided);
  EXPECT_THROW(static_cast<void>(log(at("0"))), undecided);
  EXPECT_THROW(static_cast<void>(log(interval::between(-1, 1, at_bits(60)))), undecided);
  EXPECT_THROW(static_cast<void>(exp(at("1000000"))), undecided);
  EXPECT_THROW(static_cast<void>(sin_cos(at("-1000000"))), undecided);
}

TEST(Elliptic, CompleteIntegralsAreTheProvers) {
  draw d;
  for (repeat trial(60); trial.again();) {
    const rational a = abs(d.fraction(3)) + rational(1, 1000);
    const rational b(d.whole(1, 999), 1000);
    const rational u(d.whole(1, 1000), 1000);
    const precision bits = at_bits(d.whole(60, 300));
    const long p = bits + 60;
    const polhode::body rigid(as_provers(a), as_provers(b));
    const integer units = integer(1) << 22U;  // of values up to some 2^20
    if (u < 1) {
      expect_same(half_phase(a, b, u, bits).scaled(1),
                  montgomery_phase(rigid, as_provers(rational(-b * u)), p), units, "G");
    }
    expect_same(rotating_phase(a, b, rational(a * u), bits).scaled(1),
                montgomery_phase(rigid, as_provers(rational(a * u)), p), units, "F(c,0)");
    expect_same(half_phase_slope(a, b, u, bits),
                polhode::half_phase_slope({as_provers(a), as_provers(b), as_provers(u)}, p), units,
                "G'");
  }
  // Far out.
  const rational tiny = power_of_two(-900);
  const polhode::body rigid(as_provers(3), as_provers(rational(1, 4)));
  expect_same(half_phase(3, rational(1, 4), tiny, at_bits(100)).scaled(1),
              montgomery_phase(rigid, as_provers(rational(-tiny / 4)), 200), 64, "G(2^-900)");
}

TEST(Elliptic, PartialIntegralsAreTheProvers) {
  draw d;
  for (repeat trial(25); trial.again();) {
    const rational a = abs(d.fraction(2)) + rational(1, 100);
    const rational b(d.whole(10, 990), 1000);
    const bool oscillating = d.whole(0, 1) == 1;
    const rational s(d.whole(20, 980), 1000);
    const rational c = oscillating ? rational(-b * s) : rational(a * s);
    // cos^2 psi = u above the turning point's.
    const rational least = oscillating ? s : rational(0);
    const rational u = least + (1 - least) * rational(d.whole(50, 990), 1000);
    const precision bits = at_bits(128);
    const interval psi = atan(sqrt(interval(rational((1 - u) / u), bits)));
    const polhode::body rigid(as_provers(a), as_provers(b));
    expect_same(partial_phase(a, b, c, psi),
                polhode::phase_integral(rigid, as_provers(c), as_provers(u), 160),
                integer(1) << 76U, "F(c,u)");
  }
}

TEST(Elliptic, SeparatrixIsTheProvers) {
  const rational a(1265, 100);
  const rational b(629, 10000);
  for (const char* text : {"1/1000", "1/2", "999/1000"}) {
    const rational u(text);
    expect_same(
        separatrix_phase(a, b, interval(u, at_bits(200)), interval(rational(1 - u), at_bits(200))),
        polhode::phase_integral(polhode::body(as_provers(a), as_provers(b)), 0, as_provers(u), 260),
        integer(1) << 20U, "F(0,u)");
  }
}

TEST(Polynomial, IsExpanded) {
  const auto read = [](const char* text) { return polynomial::read(text); };
  EXPECT_EQ(read("(a+b)^2"), read("a*a + 2*a*b + b^2"));
  EXPECT_NE(read("(a+b)^2"), read("a*a + 3*a*b + b^2"));
  EXPECT_EQ(read("-(a-b)*x"), read("b*x - a*x"));
  EXPECT_EQ(read("x^3*y").derivative('x'), read("3*x^2*y"));
  EXPECT_EQ(letter_ranges("b > 0, q = 1-b > 0, y = 1-x >= 0").put_into(read("q + b*y")),
            read("1-b*x"));
  for (const char* wrong : {"", "a+", "(a", "a)", "a b", "A", "a^100", "a^-1", "1.5", "a/2"}) {
    EXPECT_THROW(static_cast<void>(read(wrong)), std::invalid_argument) << wrong;
  }
}

TEST(Polynomial, HasASignWhereItsLettersHave) {
  const auto shows = [](const char* letters, const char* p, bool strict = true) {
    return letter_ranges(letters).show_sign(polynomial::read(p), strict);
  };
  EXPECT_TRUE(shows("a > 0, b > 0", "a + 2*b"));
  EXPECT_FALSE(shows("a > 0, b > 0", "a - b"));
  EXPECT_FALSE(shows("a > 0", "a - a"));
  EXPECT_TRUE(shows("a > 0", "a - a", false));
  EXPECT_FALSE(shows("a > 0", "a + b")) << "b has no range";
  EXPECT_TRUE(shows("b > 0, y = 1-x >= 0", "b*y", false));
  EXPECT_FALSE(shows("b > 0, y = 1-x >= 0", "b*y")) << "it may be 0";
  EXPECT_TRUE(shows("b > 0, y = 1-x > 0", "b*y"));
  // What is no hypothesis of the claims.
  for (const char* letters : {"q = b-1 > 0", "q = b-1 >= 0", "q > 0", "q = 1-a > 0",
                              "q = 1-a*b-2*b > 0", "k > 0, q = 1-b > 0", "a > 0, a > 0"}) {
    EXPECT_FALSE(shows(letters, "q")) << letters;
  }
  EXPECT_FALSE(shows("a > 0, a > 0", "a")) << "two ranges";
  EXPECT_FALSE(shows("q = 1-b > 0, b = 1-x > 0", "q")) << "b stands for something else";
  for (const char* wrong : {"", "a", "a < 0", "a > 1", "q 1-b > 0", "a > 0,b > 0", "A > 0"}) {
    EXPECT_THROW(letter_ranges{wrong}, std::invalid_argument) << wrong;
  }
}

TEST(Decimals, AreCutOffAndRoundedOutward) {
  const rational q(-2, 3);
  EXPECT_EQ(decimal(q, 4, rounding::down, generous()), "-0.6667");
  EXPECT_EQ(decimal(q, 4, rounding::up, generous()), "-0.6666");
  EXPECT_EQ(decimal(q, 4, rounding::to_zero, generous()), "-0.6666");
  EXPECT_EQ(decimal(rational(9999, 10), 2, rounding::up, generous()), "1000");
  EXPECT_EQ(decimal(rational(1, 1'000'000'000), 3, rounding::to_zero, generous()), "1.00e-9");
  EXPECT_EQ(decimal(rational(123456), 3, rounding::to_zero, generous()), "1.23e5");
  EXPECT_EQ(decimal_for_reading(rational(1, 3), 5, generous()), "0.33333...");
  EXPECT_EQ(decimal_for_reading(rational(1, 4), 5, generous()), "0.25");
  rational value;
  for (const char* wrong : {"", "-", ".5", "5.", "1e", "1e1234567", "+1", "0x1", "1 ", "nan"}) {
    EXPECT_FALSE(read_decimal(wrong, value)) << wrong;
  }
  for (const char* wrong : {"", "1/0", "2/4", "1/-2", "01", "-0", "1/1", "/2", "1/"}) {
    EXPECT_FALSE(read_rational(wrong, value)) << wrong;
  }
}

}  // namespace arithmetic_test
}  // namespace polhode::checker
