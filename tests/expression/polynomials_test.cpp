// Orthogonal polynomials, binomials, whole and fractional parts: beside Boost.Math, identities in
// rational numbers, and refusals.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <boost/math/special_functions/hermite.hpp>
#include <boost/math/special_functions/laguerre.hpp>
#include <boost/math/special_functions/legendre.hpp>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/parse.hpp"
#include "support/random.hpp"

namespace polhode {
namespace polynomials_test {

rational value(const std::string& text) {
  const auto q = parse(text, {}).exact_value();
  EXPECT_TRUE(q) << text;
  return q.value_or(0);
}
std::string call(const std::string& name, long n, const rational& x) {
  return name + "(" + std::to_string(n) + ", " + to_text(x) + ")";
}

TEST(Polynomials, HaveTheValuesOfBoost) {
  support::random_source random(61);
  for (support::repeat trial(60); trial.again();) {
    const auto n = static_cast<unsigned>(random.between(0, 20));
    const rational x(random.between(-64, 64), 64);
    const auto at = x.convert_to<double>();
    const auto expect = [&](const char* name, double theirs) {
      const auto ours = value(call(name, n, x)).convert_to<double>();
      EXPECT_NEAR(ours, theirs, 1e-9 * std::max(1.0, std::abs(theirs))) << name << n << ' ' << x;
    };
    expect("legendreP", boost::math::legendre_p(static_cast<int>(n), at));
    expect("hermiteH", boost::math::hermite(n, at));
    expect("laguerreL", boost::math::laguerre(n, at));
  }
}

TEST(Polynomials, OfChebyshevAreThoseOfAngles) {
  support::random_source random(62);
  for (support::repeat trial(60); trial.again();) {
    const long n = random.between(0, 200);
    // x = (y + 1/y)/2: T_n is (y^n + y^-n)/2, and U_n is (y^(n+1) - y^-(n+1))/(y - 1/y).
    const rational y(random.between(2, 9), random.one_in(2) ? 1 : -10);
    const rational x((y + 1 / y) / 2);
    const auto power = [&](long k) {
      rational r = 1;
      for (long i = 0; i < k; ++i) r *= y;
      return r;
    };
    EXPECT_EQ(value(call("chebyshevT", n, x)), (power(n) + 1 / power(n)) / 2) << n;
    EXPECT_EQ(value(call("chebyshevU", n, x)), (power(n + 1) - 1 / power(n + 1)) / (y - 1 / y))
        << n;
  }
  // Of balls: no digits are lost to a recurrence.
  const ball at = parse("chebyshevT(1000, x)", {"x"})(ball(rational(1, 3), 128));
  EXPECT_LE(at.radius(), magnitude::power_of_two(-100));
}

TEST(Polynomials, HaveTheirStandardValues) {
  for (long n = 0; n <= 12; ++n) {
    EXPECT_EQ(value(call("legendreP", n, 1)), 1);
    EXPECT_EQ(value(call("laguerreL", n, 0)), 1);
    EXPECT_EQ(value(call("chebyshevU", n, 1)), n + 1);
    EXPECT_EQ(value(call("hermiteH", n, 0)) == 0, n % 2 == 1);
  }
  EXPECT_EQ(value("legendreP(3, 2)"), 17) << "x(5x^2 - 3)/2";
}

TEST(Polynomials, BinomialsAreThoseOfPascal) {
  support::random_source random(63);
  for (support::repeat trial(60); trial.again();) {
    const rational x(random.between(-40, 40), random.between(1, 4));
    const long k = random.between(0, 12);
    const auto binomial = [&](const rational& n, long j) {
      return value("binomial(" + to_text(n) + ", " + std::to_string(j) + ")");
    };
    EXPECT_EQ(binomial(x + 1, k + 1), binomial(x, k) + binomial(x, k + 1)) << x << ' ' << k;
  }
  EXPECT_EQ(value("binomial(10, 3)"), 120);
  EXPECT_EQ(value("factorial(6)"), 720);
  EXPECT_EQ(value("euler_beta(3, 4)"), rational(1, 60));
}

TEST(Polynomials, PartsOfNumbers) {
  support::random_source random(64);
  const expression trunc = parse("trunc(x)", {"x"});
  for (support::repeat trial(200); trial.again();) {
    const rational x(random.between(-60, 60), random.between(1, 6));
    const rational y(random.between(1, 20) * (random.one_in(2) ? 1 : -1), random.between(1, 6));
    const std::string at = "(" + to_text(x) + ")";
    const rational below(floor_of(x));
    EXPECT_EQ(value("frac" + at), x - below);
    EXPECT_EQ(value("round" + at), rational(floor_of(rational(x + rational(1, 2)))));
    EXPECT_EQ(value("trunc" + at), x < 0 ? rational(ceil_of(x)) : below);
    EXPECT_EQ(value("heaviside" + at), x == 0 ? rational(1, 2) : rational(x > 0 ? 1 : 0));
    const rational rest = value("mod(" + to_text(x) + ", " + to_text(y) + ")");
    EXPECT_EQ(denominator(rational((x - rest) / y)), 1);
    EXPECT_TRUE(y > 0 ? rest >= 0 && rest < y : rest <= 0 && rest > y) << x << ' ' << y;
    // Over sets, and at points of them.
    EXPECT_TRUE(contains(trunc(ball(x, 64)), value("trunc" + at)));
  }
  EXPECT_EQ(value("sinc(0)"), 1);
}

TEST(Polynomials, AreRefusedWhereTheyAreNotDefined) {
  for (const char* text :
       {"legendreP(-1, x)", "legendreP(1/2, x)", "legendreP(x, 3)", "chebyshevT(1001, x)",
        "hermiteH(10^9, x)", "binomial(x, -1)", "binomial(x, x)", "factorial(-2)", "mod(x, 0)",
        "euler_beta(0, 1)", "euler_beta(-1/2, 1/2)", "laguerreL(2)"}) {
    EXPECT_THROW((void)parse(text, {"x"}), expression_error) << text;
  }
}

}  // namespace polynomials_test
}  // namespace polhode
