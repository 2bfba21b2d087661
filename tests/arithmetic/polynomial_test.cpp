// Exact facts about polynomials.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "polhode/arithmetic/polynomial.hpp"
#include "support/random.hpp"

namespace polhode {
namespace polynomial_test {

using support::random_source;
using support::repeat;

rational_polynomial linear(const rational& root) {
  return rational_polynomial({rational(-root), rational(1)});
}
rational_polynomial power(const rational_polynomial& p, long n) {
  rational_polynomial r({rational(1)});
  for (long k = 0; k < n; ++k) r = r * p;
  return r;
}

TEST(RationalPolynomial, DivisionAndGcdAreExact) {
  random_source random(7);
  for (repeat trial(200); trial.again();) {
    const auto any = [&](long degree) {
      std::vector<rational> c;
      for (long k = 0; k <= degree; ++k) c.push_back(random.any_rational(20));
      c.back() = c.back() == 0 ? rational(1) : c.back();
      return rational_polynomial(c);
    };
    const rational_polynomial p = any(random.between(0, 9));
    const rational_polynomial d = any(random.between(0, 5));
    const auto [q, r] = divide(p, d);
    EXPECT_EQ(q * d + r, p);
    EXPECT_LT(r.degree(), std::max(d.degree(), 1L));
    const rational_polynomial g = gcd(p * d, d * any(2));
    EXPECT_TRUE(divide(g, divide(d, rational_polynomial({d.leading()})).first).second.is_zero());
    const rational x = random.any_rational(30);
    EXPECT_EQ((p * d)(x), rational(p(x) * d(x)));
    EXPECT_TRUE(contains(p(ball(x, 100)), p(x)));
  }
}

TEST(RationalPolynomial, SeriesAreTaylorCoefficients) {
  const rational_polynomial p(
      {rational(1), rational(-2), rational(0), rational(5), rational(1, 3)});
  const rational x(3, 7);
  const auto s = p.series(ball(x, 128), 6);
  rational_polynomial d = p;
  rational factorial = 1;
  for (int k = 0; k <= 6; ++k) {
    if (k > 0) {
      d = d.derivative();
      factorial *= k;
    }
    EXPECT_TRUE(contains(s[k], rational(d(x) / factorial))) << k;
  }
}

TEST(SquareFreeDecomposition, FindsEveryMultiplicity) {
  random_source random(11);
  for (repeat trial(60); trial.again();) {
    std::vector<rational> roots;
    while (roots.size() < 4) {
      const rational r(random.between(-20, 20), random.between(1, 9));
      if (std::find(roots.begin(), roots.end(), r) == roots.end()) roots.push_back(r);
    }
    std::vector<long> multiplicities;
    rational_polynomial p({rational(3, 5)});
    for (const rational& r : roots) {
      multiplicities.push_back(random.between(1, 5));
      p = p * power(linear(r), multiplicities.back());
    }
    p = p * power(rational_polynomial({rational(1), rational(0), rational(1)}), 2);
    const auto parts = square_free_decomposition(p);
    for (std::size_t i = 0; i < roots.size(); ++i) {
      for (const repeated_factor& part : parts) {
        EXPECT_EQ(part.factor(roots[i]) == 0, part.multiplicity == multiplicities[i]);
      }
    }
    EXPECT_EQ(count_real_roots(p, -20, 20), 4);
    EXPECT_GE(root_bound(p), abs(roots[0]));
  }
}

TEST(CountRealRoots, CountsTheEnds) {
  const rational_polynomial p = power(linear(0), 3) * linear(1) * power(linear(2), 2);
  EXPECT_EQ(count_real_roots(p, 0, 2), 3);
  EXPECT_EQ(count_real_roots(p, rational(1, 100), 2), 2);
  EXPECT_EQ(count_real_roots(p, 0, rational(199, 100)), 2);
  EXPECT_EQ(count_real_roots(p, 1, 1), 1);
  EXPECT_EQ(count_real_roots(p, 3, 4), 0);
}

TEST(SimplestBetween, IsTheLeastDenominator) {
  EXPECT_EQ(simplest_between(rational(314, 100), rational(315, 100)), rational(22, 7));
  EXPECT_EQ(simplest_between(rational(-1, 3), rational(1, 7)), 0);
  EXPECT_EQ(simplest_between(rational(-7, 2), rational(-3, 2)), -2);
  EXPECT_EQ(simplest_between(rational(1, 3), rational(1, 3)), rational(1, 3));
  EXPECT_EQ(simplest_between(rational(-22, 7), rational(-22, 7), 2), rational(-22, 7));
  EXPECT_EQ(simplest_between(rational(22, 7), rational(22, 7), 1), std::nullopt);
  random_source random(13);
  for (repeat trial(300); trial.again();) {
    const rational a(random.between(0, 400), random.between(1, 60));
    const rational b = a + rational(random.between(0, 30), random.between(1, 400));
    const rational found = simplest_between(a, b);
    EXPECT_TRUE(a <= found && found <= b);
    for (long d = 1; rational(d) < rational(denominator(found)); ++d) {
      const integer up = numerator(rational(b * d)) / denominator(rational(b * d));
      EXPECT_LT(rational(up) / d, a) << d;
    }
  }
}

}  // namespace polynomial_test
}  // namespace polhode
