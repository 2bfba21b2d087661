// Exact facts about polynomials.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
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

/// By Euclid's algorithm.
rational_polynomial euclidean_gcd(rational_polynomial p, rational_polynomial q) {
  while (!q.is_zero()) {
    rational_polynomial rest = divide(p, q).second;
    p = std::move(q);
    q = std::move(rest);
  }
  return p.is_zero() ? p : p * rational_polynomial({rational(1) / p.leading()});
}

TEST(RationalPolynomial, GcdIsEuclids) {
  random_source random(71);
  for (repeat trial(300); trial.again();) {
    const auto any = [&](long degree) {
      std::vector<rational> c;
      const long bits = random.between(1, 200);
      for (long k = 0; k <= degree; ++k) {
        c.push_back(
            random.any_rational(20) * rational(integer(1) << static_cast<unsigned long>(bits)) + k);
      }
      return rational_polynomial(c);
    };
    const rational_polynomial common = any(random.between(0, 6));
    const rational_polynomial p = any(random.between(0, 8)) * common;
    const rational_polynomial q = any(random.between(0, 8)) * common * common;
    EXPECT_EQ(gcd(p, q), euclidean_gcd(p, q));
  }
  // The images modulo the first prime above 2^30 have a common root that p and q have not.
  const integer prime = 1'073'741'827;
  const rational_polynomial p({rational(-1), rational(1)});
  const rational_polynomial q({rational(-1 - prime), rational(1)});
  EXPECT_EQ(gcd(p, q), rational_polynomial({rational(1)}));
  EXPECT_EQ(gcd(p * q, q * q), q);
  // The prime divides the leading coefficients.
  const rational_polynomial r({rational(1), rational(prime)});
  EXPECT_EQ(gcd(r * p, r * q), euclidean_gcd(r, rational_polynomial()));
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
    for (const rational& r : roots) EXPECT_GE(root_bound(p), abs(r));
  }
}

TEST(RootBound, IsNearlyAttained) {
  // (x - 2^k)^n has the bound 2^(k + 1) n; x^n - x^(n-1) - ... - 1 has a root near 2.
  for (const long n : {1L, 2L, 7L}) {
    for (const long size : {-40L, -1L, 0L, 1L, 40L}) {
      const integer power_of_two = integer(1) << static_cast<unsigned long>(std::abs(size));
      const rational root = size >= 0 ? rational(power_of_two) : rational(1, power_of_two);
      const rational_polynomial p = power(linear(root), n);
      EXPECT_GE(root_bound(p), root);
      EXPECT_LE(root_bound(p), 8 * n * root);
    }
  }
  // The root of x^n - ... - 1 is above 2 - 2^(1-n): the least power of two that bounds it is 2.
  std::vector<rational> c(12, rational(-1));
  c.back() = 1;
  EXPECT_GE(root_bound(rational_polynomial(c)), 2);
  // All of the weight is in one coefficient, a power of two less 1 or plus 1, of one sign.
  for (const long k : {1L, 2L, 3L, 5L}) {
    for (const long change : {-1L, 0L, 1L}) {
      std::vector<rational> one(static_cast<std::size_t>(k) + 1, rational(0));
      one.front() = -((integer(1) << 30UL) + change);
      one.back() = 1;
      const rational bound = root_bound(rational_polynomial(one));
      EXPECT_GE(power(rational_polynomial({bound}), k)(0), rational((integer(1) << 30UL) + change));
    }
  }
  EXPECT_EQ(root_bound(power(linear(0), 3)), 0);
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
