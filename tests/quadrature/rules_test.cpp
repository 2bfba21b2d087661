// The rules that are templates over the scalar: what they are exact for, their closed forms, and
// their bounds, which nearly are attained and never exceeded.

#include <gtest/gtest.h>

#include <vector>

#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/clenshaw_curtis.hpp"
#include "polhode/quadrature/double_exponential.hpp"
#include "polhode/quadrature/gauss_legendre.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "polhode/quadrature/rule_sum.hpp"
#include "quadrature/integrands.hpp"
#include "quadrature/rules/double_exponential_plan.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace rules_test {

using support::as_narrow_as;
using support::meet;

constexpr precision p = 512;

ball above(const magnitude& bound) { return ball(0, p).enlarged(bound); }

/// |error| <= bound, for an error that is known far better than to within the bound.
::testing::AssertionResult is_bound_of(const magnitude& bound, const ball& error) {
  if (error.magnitude_lower() <= bound && error.radius() <= scale(bound, -20)) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << above(bound) << " is not above " << error;
}
/// bound <= factor |error|, certainly.
::testing::AssertionResult is_at_most(const magnitude& bound, const rational& factor,
                                      const ball& error) {
  if (bound <= (abs(error) * factor).magnitude_lower()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << above(bound) << " is more than " << factor << " " << error;
}

template <scalar T>
auto power(long k, precision bits = p) {
  return [=](const T& x) -> T {
    T r = scalar_from<T>(1, bits);
    for (long i = 0; i < k; ++i) r = T(r * x);
    return r;
  };
}
/// T_k by its recurrence, and U_k.
ball chebyshev(long k, const ball& x, long second = 0) {
  ball before(1, p);
  ball now = x * (1 + second);
  if (k == 0) return before;
  for (long i = 1; i < k; ++i) {
    const ball next = 2 * x * now - before;
    before = now;
    now = next;
  }
  return now;
}
auto chebyshev_of(long k, long second = 0) {
  return [=](const ball& x) -> ball { return chebyshev(k, x, second); };
}
/// The greatest |T_k| inside the ellipse rho.
magnitude greatest_chebyshev(long k, const ball& rho) {
  return scale((pow(rho, k) + pow(rho, -k)).magnitude_upper(), -1);
}

/// 1/(a - x), a > 1, and its greatest value inside the ellipse rho.
struct reciprocal {
  rational a;
  precision bits = p;
  template <class T>
  T operator()(const T& x) const {
    return T(scalar_from<T>(1, bits) / T(scalar_from<T>(a, bits) - x));
  }
  [[nodiscard]] magnitude greatest(const ball& rho) const {
    return (1 / (a - (rho + 1 / rho) / 2)).magnitude_upper();
  }
};

// --------------------------------------------------------------------------------- Gauss and
// Legendre

TEST(GaussLegendreSum, IsExactForPolynomialsBelowTwiceTheNodes) {
  const rational centre(3, 7);
  const rational half(5, 3);
  for (const long n : {1L, 2L, 3L, 8L, 13L}) {
    const auto rule = gauss_legendre(n, p);
    rational right = centre + half;
    rational left = centre - half;
    for (long k = 0; k < 2 * n; ++k) {
      const ball sum = rule_sum<ball>(power<ball>(k), *rule, ball(centre, p), ball(half, p));
      EXPECT_TRUE(meet(sum, ball(rational((right - left) / (k + 1)), p))) << n << " " << k;
      EXPECT_TRUE(as_narrow_as(sum, 225)) << n << " " << k;
      right *= centre + half;
      left *= centre - half;
    }
    // Of degree 2n it misses half^(2n+1) 2^(2n+1) n!^4 / ((2n+1) (2n)!^2).
    const ball sum = rule_sum<ball>(power<ball>(2 * n), *rule, ball(centre, p), ball(half, p));
    rational error = 2 * half / (2 * n + 1);
    for (long k = 1; k <= n; ++k) {
      const rational factor = 2 * half * k * k / ((2 * k - 1) * (2 * k));
      error *= factor * factor;
    }
    EXPECT_TRUE(meet(sum, ball(rational((right - left) / (2 * n + 1) - error), p))) << n;
  }
}

TEST(GaussLegendreSum, CallsTheFunctionOnceANode) {
  for (const long n : {1L, 2L, 7L, 40L}) {
    long calls = 0;
    const auto f = [&](const ball& x) -> ball {
      ++calls;
      return x;
    };
    const ball sum = rule_sum<ball>(f, *gauss_legendre(n, p), ball(2, p), ball(1, p));
    EXPECT_TRUE(contains(sum, 4));
    EXPECT_EQ(calls, n);
  }
}

TEST(GaussLegendreSum, GivesTheMiddleOfTheBallInMpfrFloat) {
  for (const long n : {1L, 2L, 9L, 60L}) {
    const auto rule = gauss_legendre(n, p);
    const mpfr_float value = rule_sum<mpfr_float>(
        reciprocal{2, rule->bits}, *rule, scalar_from<mpfr_float>(rational(1, 3), rule->bits),
        scalar_from<mpfr_float>(rational(1, 2), rule->bits));
    const ball enclosure =
        rule_sum<ball>(reciprocal{2, rule->bits}, *rule, ball(rational(1, 3), rule->bits),
                       ball(rational(1, 2), rule->bits));
    EXPECT_TRUE(contains(enclosure, ball(value))) << n;
  }
}

// --------------------------------------------------------------------------------- Gauss and
// Chebyshev

TEST(GaussChebyshevSum, IsExactBelowTwiceTheNodesAndMissesWhatItsBoundSays) {
  const ball rho(1000, p);
  for (const long n : {1L, 2L, 3L, 6L, 11L}) {
    for (long k = 0; k < 4 * n; ++k) {
      const ball sum = gauss_chebyshev_sum<ball>(chebyshev_of(k), n, p);
      const long exact = k == 0 ? 1 : (k == 2 * n ? -1 : 0);
      EXPECT_TRUE(meet(sum, exact * pi(p))) << k << " " << n;
      EXPECT_TRUE(sum.radius() <= magnitude::power_of_two(-150));
    }
    const magnitude bound = gauss_chebyshev_error(n, rho, greatest_chebyshev(2 * n, rho));
    EXPECT_TRUE(is_bound_of(bound, pi(p)));
    EXPECT_TRUE(is_at_most(bound, rational(1'000'002, 1'000'000), pi(p))) << n;
  }
}

TEST(GaussChebyshevSecondSum, IsExactBelowTwiceTheNodesAndMissesWhatItsBoundSays) {
  const ball rho(1000, p);
  for (const long n : {1L, 2L, 3L, 6L, 11L}) {
    for (long k = 0; k < 2 * n; ++k) {
      const ball sum = gauss_chebyshev_second_sum<ball>(power<ball>(k), n, p);
      const rational exact = support::power_of_cosine(k).integral_over_pi() -
                             support::power_of_cosine(k + 2).integral_over_pi();
      EXPECT_TRUE(meet(sum, exact * pi(p))) << k << " " << n;
      EXPECT_TRUE(sum.radius() <= magnitude::power_of_two(-230));
    }
    // The integral with U_2n is 0.
    const ball error = gauss_chebyshev_second_sum<ball>(chebyshev_of(2 * n, 1), n, p);
    EXPECT_TRUE(meet(error, -pi(p) / 2)) << n;
    const ball greatest = (pow(rho, 2 * n + 1) - pow(rho, -2 * n - 1)) / (rho - 1 / rho);
    const magnitude bound = gauss_chebyshev_second_error(n, rho, greatest.magnitude_upper());
    EXPECT_TRUE(is_bound_of(bound, error)) << n;
    EXPECT_TRUE(is_at_most(bound, rational(1'000'004, 1'000'000), error)) << n;
  }
}

TEST(GaussChebyshevErrors, AreAboveTheTrueErrors) {
  for (const rational& a : {rational(11, 10), rational(2), rational(10)}) {
    const reciprocal f{a};
    const ball root = sqrt(ball(rational(a * a - 1), p));
    const ball greatest_rho = a + root;  // the pole's
    for (long n = 1; n <= 40; ++n) {
      const ball first = gauss_chebyshev_sum<ball>(f, n, p) - pi(p) / root;
      const ball second = gauss_chebyshev_second_sum<ball>(f, n, p) - pi(p) * (a - root);
      const auto curtis = clenshaw_curtis_rule<ball>(n, p);
      const auto fejer = fejer_rule<ball>(n, p);
      const ball exact = log(ball(rational((a + 1) / (a - 1)), p));
      const ball third = chebyshev_points_sum<ball>(f, curtis) - exact;
      const ball fourth = chebyshev_points_sum<ball>(f, fejer) - exact;
      for (const rational& part : {rational(1, 3), rational(9, 10), rational(99, 100)}) {
        const ball rho = 1 + (greatest_rho - 1) * part;
        const magnitude m = f.greatest(rho);
        EXPECT_TRUE(is_bound_of(gauss_chebyshev_error(n, rho, m), first)) << a << " " << n;
        EXPECT_TRUE(is_bound_of(gauss_chebyshev_second_error(n, rho, m), second)) << a << " " << n;
        EXPECT_TRUE(is_bound_of(clenshaw_curtis_error(n, rho, m), third)) << a << " " << n;
        EXPECT_TRUE(is_bound_of(fejer_error(n, rho, m), fourth)) << a << " " << n;
      }
    }
  }
}

TEST(GaussChebyshevErrors, RefuseWhatHasNoEllipse) {
  const magnitude one = magnitude::power_of_two(0);
  for (const auto error :
       {gauss_chebyshev_error, gauss_chebyshev_second_error, clenshaw_curtis_error, fejer_error}) {
    EXPECT_TRUE(error(0, ball(2, p), one).is_infinite());
    EXPECT_TRUE(error(-3, ball(2, p), one).is_infinite());
    EXPECT_TRUE(error(5, ball(1, p), one).is_infinite());
    EXPECT_TRUE(error(5, hull(ball(1, p), ball(3, p)), one).is_infinite());
    EXPECT_TRUE(error(5, ball::undefined(p), one).is_infinite());
    EXPECT_TRUE(error(5, ball(2, p), magnitude::infinity()).is_infinite());
    // A set of ellipses: the least.
    const magnitude least = error(5, ball(2, p), one);
    EXPECT_TRUE(error(5, hull(ball(2, p), ball(3, p)), one) >=
                subtract_down(least, scale(least, -24)));
    EXPECT_TRUE(error(6, ball(2, p), one) < error(5, ball(2, p), one));
  }
}

TEST(GaussChebyshevSums, GiveTheMiddleOfTheBallInMpfrFloat) {
  const reciprocal f{3};
  for (const long n : {1L, 2L, 5L, 12L, 101L}) {
    EXPECT_TRUE(contains(gauss_chebyshev_sum<ball>(f, n, p),
                         ball(gauss_chebyshev_sum<mpfr_float>(f, n, p))));
    EXPECT_TRUE(contains(gauss_chebyshev_second_sum<ball>(f, n, p),
                         ball(gauss_chebyshev_second_sum<mpfr_float>(f, n, p))));
    EXPECT_TRUE(contains(
        chebyshev_points_sum<ball>(f, clenshaw_curtis_rule<ball>(n, p)),
        ball(chebyshev_points_sum<mpfr_float>(f, clenshaw_curtis_rule<mpfr_float>(n, p)))));
    EXPECT_TRUE(contains(chebyshev_points_sum<ball>(f, fejer_rule<ball>(n, p)),
                         ball(chebyshev_points_sum<mpfr_float>(f, fejer_rule<mpfr_float>(n, p)))));
  }
}

TEST(GaussChebyshevSums, CallTheFunctionOnceANode) {
  for (const long n : {1L, 2L, 3L, 10L}) {
    long calls = 0;
    const auto f = [&](const ball& x) -> ball {
      ++calls;
      return x;
    };
    EXPECT_TRUE(contains_zero(gauss_chebyshev_sum<ball>(f, n, p)));
    EXPECT_EQ(calls, n);
    EXPECT_TRUE(contains_zero(gauss_chebyshev_second_sum<ball>(f, n, p)));
    EXPECT_EQ(calls, 2 * n);
  }
  EXPECT_THROW((void)gauss_chebyshev_sum<ball>(power<ball>(1), 0, p), std::invalid_argument);
  EXPECT_THROW((void)gauss_chebyshev_second_sum<ball>(power<ball>(1), 0, p), std::invalid_argument);
}

// --------------------------------------------------------------------------------- Clenshaw and
// Curtis, Fejer

/// The integral of T_k, k even: 2/(1 - k^2).
rational integral_of_chebyshev(long k) { return k % 2 != 0 ? rational(0) : rational(2, 1 - k * k); }

TEST(ClenshawCurtis, HasTheWeightsThatAreKnown) {
  const auto two = clenshaw_curtis_rule<ball>(1, p);
  EXPECT_TRUE(contains(two.weights[0], 1) && contains(two.weights[1], 1));
  const auto simpson = clenshaw_curtis_rule<ball>(2, p);
  EXPECT_TRUE(contains(simpson.weights[0], rational(1, 3)));
  EXPECT_TRUE(contains(simpson.weights[1], rational(4, 3)));
  EXPECT_TRUE(contains(simpson.weights[2], rational(1, 3)));
  // At the ends 1/n^2 for odd n and 1/(n^2 - 1) for even n.
  for (long n = 2; n <= 40; ++n) {
    const auto rule = clenshaw_curtis_rule<ball>(n, p);
    const rational end(1, n % 2 != 0 ? n * n : n * n - 1);
    EXPECT_TRUE(contains(rule.weights.front(), end)) << n;
    EXPECT_TRUE(contains(rule.weights.back(), end)) << n;
    EXPECT_TRUE(as_narrow_as(rule.weights.front(), 230)) << n;
  }
  EXPECT_TRUE(contains(fejer_rule<ball>(1, p).weights[0], 2));
  EXPECT_TRUE(contains(fejer_rule<ball>(3, p).weights[0], rational(4, 9)));
  EXPECT_TRUE(contains(fejer_rule<ball>(3, p).weights[1], rational(10, 9)));
  EXPECT_THROW((void)clenshaw_curtis_rule<ball>(0, p), std::invalid_argument);
  EXPECT_THROW((void)fejer_rule<ball>(0, p), std::invalid_argument);
}

TEST(ClenshawCurtis, DoesToEveryChebyshevPolynomialWhatTheProofSays) {
  for (long n = 1; n <= 24; ++n) {
    const auto curtis = clenshaw_curtis_rule<ball>(n, p);
    const auto fejer = fejer_rule<ball>(n, p);
    ASSERT_EQ(curtis.nodes.size(), static_cast<std::size_t>(n + 1));
    ASSERT_EQ(fejer.nodes.size(), static_cast<std::size_t>(n));
    for (long k = 0; k <= 3 * n; ++k) {
      const long i = (k + n) / (2 * n);
      const long m = std::abs(k - 2 * n * i);
      EXPECT_TRUE(meet(chebyshev_points_sum<ball>(chebyshev_of(k), curtis),
                       ball(integral_of_chebyshev(m), p)))
          << n << " " << k;
      const rational of_fejer =
          m == n ? rational(0) : rational((i % 2 == 0 ? 1 : -1) * integral_of_chebyshev(m));
      EXPECT_TRUE(meet(chebyshev_points_sum<ball>(chebyshev_of(k), fejer), ball(of_fejer, p)))
          << n << " " << k;
    }
  }
}

TEST(ClenshawCurtis, HasABoundThatIsAttainedByTheFirstPolynomialItMisses) {
  const ball rho(1'000'000, p);
  const rational just_above(1'000'001, 1'000'000);
  for (long n = 1; n <= 33; ++n) {
    const long first = n % 2 == 0 ? n + 2 : n + 1;
    const ball error =
        chebyshev_points_sum<ball>(chebyshev_of(first), clenshaw_curtis_rule<ball>(n, p)) -
        integral_of_chebyshev(first);
    const magnitude greatest = greatest_chebyshev(first, rho);
    const magnitude bound = clenshaw_curtis_error(n, rho, greatest);
    EXPECT_TRUE(is_bound_of(bound, error)) << n;
    EXPECT_TRUE(is_at_most(bound, just_above, error)) << n;
    if (n < 2) continue;
    const long first_of_fejer = n % 2 == 0 ? n : n + 1;
    const ball error_of_fejer =
        chebyshev_points_sum<ball>(chebyshev_of(first_of_fejer), fejer_rule<ball>(n, p)) -
        integral_of_chebyshev(first_of_fejer);
    const magnitude bound_of_fejer = fejer_error(n, rho, greatest_chebyshev(first_of_fejer, rho));
    EXPECT_TRUE(is_bound_of(bound_of_fejer, error_of_fejer)) << n;
    EXPECT_TRUE(is_at_most(bound_of_fejer, just_above, error_of_fejer)) << n;
  }
}

TEST(ClenshawCurtis, HasABoundBelowTrefethens) {
  for (long n = 2; n <= 60; ++n) {
    for (const rational& r : {rational(101, 100), rational(3, 2), rational(10)}) {
      const ball rho(r, p);
      const ball factor = rational(64, 15) / (1 - 1 / square(rho));
      const long first = n % 2 == 0 ? n + 2 : n + 1;
      const magnitude trefethen = (factor / pow(rho, first)).magnitude_upper();
      EXPECT_TRUE(clenshaw_curtis_error(n, rho, magnitude::power_of_two(0)) <=
                  multiply_up(trefethen, magnitude::from_bits_up((1 << 20) + 1, -20)))
          << n << " " << r;
    }
  }
}

// The bounds are the sums of 2 M rho^-k times the rules' errors on T_k, as the tests above know
// them, each of them bounded: they are no less than these sums, with all signs alike.
TEST(ClenshawCurtis, HasBoundsNotBelowTheSumOfAllErrors) {
  for (const rational& r : {rational(5, 4), rational(3), rational(10)}) {
    const ball rho(r, p);
    for (long n = 2; n <= 12; ++n) {
      ball curtis(0, p);
      ball fejer(0, p);
      for (long k = 2; k <= 12 * n; k += 2) {
        const long i = (k + n) / (2 * n);
        const long m = std::abs(k - 2 * n * i);
        const rational exact = integral_of_chebyshev(k);
        const rational of_fejer =
            m == n ? rational(0) : rational((i % 2 == 0 ? 1 : -1) * integral_of_chebyshev(m));
        const ball weight = 2 / pow(rho, k);
        if (k > n) curtis += abs(rational(integral_of_chebyshev(m) - exact)) * weight;
        if (k >= n) fejer += abs(rational(of_fejer - exact)) * weight;
      }
      const magnitude one = magnitude::power_of_two(0);
      EXPECT_TRUE(is_bound_of(clenshaw_curtis_error(n, rho, one), curtis)) << n << " " << r;
      EXPECT_TRUE(is_bound_of(fejer_error(n, rho, one), fejer)) << n << " " << r;
    }
  }
}

// --------------------------------------------------------------------------------- the trapezoidal
// rule

/// exp(-x^2) over [-x, x]: the bound from its true size.
rectangle_bound bound_of_gaussian(long x, double d) {
  const ball height = ball::exactly(d, p);
  rectangle_bound bound;
  bound.half_height = d;
  bound.horizontal = (2 * sqrt(pi(p)) * exp(square(height))).magnitude_upper();
  bound.left = {{0, d, exp(square(height) - x * x).magnitude_upper()}};
  bound.right = bound.left;
  return bound;
}

TEST(TrapezoidError, IsAttainedByTheGaussian) {
  const ball exact = sqrt(pi(p)).enlarged(magnitude::power_of_two(-500));  // erfc 20 < 2^-500
  const auto f = [](const ball& x) -> ball { return exp(-square(x)); };
  for (const long n : {40L, 53L, 60L, 79L, 80L}) {
    const ball h(rational(40, n), p);
    const double d = 3.14159265358979 * static_cast<double>(n) / 40;
    const ball error = trapezoid_sum<ball>(f, -20, 20, n, p) - exact;
    const magnitude bound = trapezoid_error(h, bound_of_gaussian(20, d));
    EXPECT_TRUE(is_bound_of(bound, error)) << n;
    EXPECT_TRUE(is_at_most(bound, rational(1'001, 1'000), error)) << n;
  }
}

TEST(TrapezoidError, IsNearlyAttainedAtAnEnd) {
  // e^(s x) over [-40, 0]: |f| = 1 at one side. The error, the sum less the integral, is
  // h/(2 sinh(s h/2)) - 1/s, but for e^(-40 s): 0.53 h log(2)/pi for s h = 5.
  const long n = 40;  // h = 1
  for (const long s : {2L, 3L, 5L, 6L, 10L}) {
    const auto f = [=](const ball& x) -> ball { return exp(s * x); };
    const ball exact = (1 - exp(ball(-40 * s, p))) / s;
    const ball error = trapezoid_sum<ball>(f, -40, 0, n, p) - exact;
    const double d = 20;
    rectangle_bound bound;
    bound.half_height = d;
    bound.horizontal = (2 * exact).magnitude_upper();
    bound.left = {{0, d, exp(ball(-40 * s, p)).magnitude_upper()}};
    bound.right = {{0, d, magnitude::power_of_two(0)}};
    const magnitude one_piece = trapezoid_error(ball(1, p), bound);
    EXPECT_TRUE(is_bound_of(one_piece, error)) << s;
    EXPECT_TRUE(s != 5 || is_at_most(one_piece, rational(19, 10), error));
    // Pieces of the same height add up to the same.
    bound.right.clear();
    for (long k = 0; k < 20; ++k) {
      bound.right.push_back(
          {static_cast<double>(k), static_cast<double>(k + 1), magnitude::power_of_two(0)});
    }
    const magnitude many_pieces = trapezoid_error(ball(1, p), bound);
    EXPECT_TRUE(many_pieces >= subtract_down(one_piece, scale(one_piece, -24)));
    EXPECT_TRUE(many_pieces <= add_up(one_piece, scale(one_piece, -24)));
  }
}

TEST(TrapezoidError, WeighsThePiecesOfASide) {
  // Of |f| = 1 for 1/4 <= |y| <= 1/2 alone: the integral of 1/(1 + e^(2 pi |y|/h)) there, twice.
  rectangle_bound bound;
  bound.half_height = 1;
  bound.left = {{0, 1, magnitude()}};
  bound.right = {
      {0, 0.25, magnitude()}, {0.25, 0.5, magnitude::power_of_two(0)}, {0.5, 1, magnitude()}};
  for (const rational& h : {rational(1, 3), rational(1), rational(5)}) {
    const auto weight = [&](const auto& y) { return 2 / (1 + exp(y * (2 / h) * pi(400))); };
    const integral exact =
        integrate(weight, end_point(rational(1, 4)), end_point(rational(1, 2)), {.digits = 20});
    ASSERT_EQ(exact.verdict, status::certified);
    const magnitude share = trapezoid_error(ball(h, p), bound);
    EXPECT_TRUE(is_bound_of(share, exact.enclosure)) << h;
    EXPECT_TRUE(is_at_most(share, rational(1'001, 1'000), exact.enclosure)) << h;
  }
}

// |exp(-z^2)| at the height d has the integral sqrt(pi) exp(d^2) over the line.
TEST(IntegralAlong, IsNearlyAttainedByTheGaussian) {
  const auto f = [](const region& z) { return exp(-z * z); };
  for (const double d : {0.0, 0.5, 1.5, 3.0}) {
    long evaluations = 0;
    const magnitude bound = detail::integral_along(f, -20, 20, d, evaluations);
    const ball exact = sqrt(pi(p)) * exp(square(ball::exactly(d, p)));
    EXPECT_TRUE(is_bound_of(bound, exact)) << d;
    EXPECT_TRUE(is_at_most(bound, rational(5, 4), exact)) << d;
    EXPECT_LE(evaluations, 1200);
  }
}

TEST(TrapezoidError, RefusesWhatIsNotARectangle) {
  const rectangle_bound good = bound_of_gaussian(10, 3);
  EXPECT_FALSE(trapezoid_error(ball(1, p), good).is_infinite());
  EXPECT_TRUE(trapezoid_error(ball(0, p), good).is_infinite());
  EXPECT_TRUE(trapezoid_error(ball(-1, p), good).is_infinite());
  EXPECT_TRUE(trapezoid_error(ball::undefined(p), good).is_infinite());
  const auto changed = [&](const auto& change) {
    rectangle_bound bad = good;
    change(bad);
    return trapezoid_error(ball(1, p), bad).is_infinite();
  };
  EXPECT_TRUE(changed([](auto& b) { b.half_height = 0; }));
  EXPECT_TRUE(changed([](auto& b) { b.half_height = -3; }));
  EXPECT_TRUE(changed([](auto& b) { b.half_height = 4; }));
  EXPECT_TRUE(changed([](auto& b) { b.left.clear(); }));
  EXPECT_TRUE(changed([](auto& b) { b.right[0].from = 0.5; }));
  EXPECT_TRUE(changed([](auto& b) { b.right.push_back({2.5, 3, {}}); }));
  EXPECT_TRUE(changed([](auto& b) { b.horizontal = magnitude::infinity(); }));
  EXPECT_TRUE(changed([](auto& b) { b.left[0].supremum = magnitude::infinity(); }));
}

::testing::AssertionResult certified_to(const detail::line_integral& q, long bits) {
  if (q.verdict != status::certified || q.why != reason::none) {
    return ::testing::AssertionFailure() << to_text(q.verdict) << ": " << to_text(q.why);
  }
  if (q.enclosure.radius() <= magnitude::power_of_two(-bits)) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << support::described(q.enclosure);
}

TEST(LineIntegral, CountsTheTruncationAndWhatIsBeyondTheRange) {
  detail::line_plan plan;
  plan.nodes = 1;
  plan.truncation_error = magnitude::power_of_two(-11);
  const magnitude beyond = magnitude::power_of_two(-12);
  const detail::line_integral found =
      detail::carry_out(plan, [](long, precision bits) { return ball(1, bits); }, 10, beyond, {});
  EXPECT_TRUE(certified_to(found, 10));
  EXPECT_TRUE(contains(found.enclosure, rational(1 + rational(3, 1 << 12))));
  EXPECT_TRUE(contains(found.enclosure, rational(1 - rational(3, 1 << 12))));
}

TEST(TrapezoidSum, GivesTheMiddleOfTheBallInMpfrFloat) {
  const reciprocal f{3};
  for (const long n : {1L, 2L, 5L, 100L}) {
    EXPECT_TRUE(contains(trapezoid_sum<ball>(f, -2, rational(7, 3), n, p),
                         ball(trapezoid_sum<mpfr_float>(f, -2, rational(7, 3), n, p))));
    EXPECT_TRUE(contains(double_exponential_sum<ball>(f, -2, rational(7, 3), 3, n, p),
                         ball(double_exponential_sum<mpfr_float>(f, -2, rational(7, 3), 3, n, p))));
  }
  EXPECT_THROW((void)trapezoid_sum<ball>(f, 0, 1, 0, p), std::invalid_argument);
}

// --------------------------------------------------------------------------------- double
// exponential

TEST(DoubleExponentialSum, HasThePointsAndWeightsOfTheSubstitution) {
  // Against the substitution written down in another way.
  const rational a(-1, 3);
  const rational b(5, 2);
  const rational range(7, 4);
  for (const long n : {1L, 2L, 3L, 8L, 17L}) {
    const auto in_t = [&](const ball& t) -> ball {
      const ball u = pi(p) / 2 * sinh(t);
      const ball x = (a + b) / 2 + (b - a) / 2 * tanh(u);
      return exp(x) * rational((b - a) / 2) * pi(p) / 2 * cosh(t) / square(cosh(u));
    };
    long calls = 0;
    const auto f = [&](const ball& x) -> ball {
      ++calls;
      return exp(x);
    };
    const ball sum = double_exponential_sum<ball>(f, a, b, range, n, p);
    EXPECT_TRUE(meet(sum, trapezoid_sum<ball>(in_t, -range, range, n, p))) << n;
    EXPECT_TRUE(as_narrow_as(sum, 235)) << n;
    EXPECT_EQ(calls, n);
    const auto of_distances = [&](const ball& u, const ball& v) -> ball {
      EXPECT_TRUE(meet(u + v, ball(rational(b - a), p)));
      return exp(a + u);
    };
    EXPECT_TRUE(meet(sum, double_exponential_sum<ball>(of_distances, a, b, range, n, p)));
  }
}

template <class F>
integral by_double_exponential(const F& f, const rational& a, const rational& b, long digits) {
  return integrate(f, a, b, {.digits = digits, .rule = quadrature_rule::double_exponential});
}

TEST(DoubleExponential, EnclosesIntegralsWithSingularEnds) {
  for (const long digits : {12L, 30L, 100L}) {
    const auto check = [&](const integral& q, const ball& exact, const char* what) {
      EXPECT_EQ(q.verdict, status::certified) << what << " " << digits << ": " << q.obstacle;
      EXPECT_TRUE(meet(q.enclosure, exact)) << what << " " << digits;
      EXPECT_TRUE(q.enclosure.radius() <= multiply_up(q.enclosure.magnitude_upper(),
                                                      pow(ball(10, 64), -digits).magnitude_upper()))
          << what << " " << digits;
    };
    const precision wide = 4 * digits + 64;
    check(by_double_exponential([](auto x) { return sqrt(x) * log(x); }, 0, 1, digits),
          ball(rational(-4, 9), wide), "sqrt(x) log x");
    check(by_double_exponential([](auto x) { return log(x) * log(x); }, 0, 1, digits),
          ball(2, wide), "log^2");
    check(by_double_exponential([](auto x) { return exp(x); }, 0, 1, digits),
          exp(ball(1, wide)) - 1, "exp");
    check(by_double_exponential([](auto x) { return 1 / sqrt(x * sqrt(x)); }, 0, 16, digits),
          ball(8, wide), "x^(-3/4)");
    check(by_double_exponential([](auto x) { return 1 / sqrt(-x); }, -4, 0, digits), ball(4, wide),
          "(-x)^(-1/2)");
    check(by_double_exponential(
              [](auto x) { return 1 / (1 + 400 * (x - rational(1, 3)) * (x - rational(1, 3))); }, 0,
              1, digits),
          (atan(ball(rational(20, 3), wide)) + atan(ball(rational(40, 3), wide))) / 20, "a pole");
  }
}

TEST(DoubleExponential, TakesSoManyNodes) {
  EXPECT_LE(
      by_double_exponential([](auto x) { return sqrt(x) * log(x); }, 0, 1, 100).account.most_nodes,
      335);
  EXPECT_LE(by_double_exponential([](auto x) { return 1 / sqrt(x); }, 0, 4, 100).account.most_nodes,
            450);
}

TEST(DoubleExponential, RefusesWhatItCannotProve) {
  const auto why = [](const auto& f) {
    const integral q = by_double_exponential(f, 0, 1, 18);
    EXPECT_NE(q.verdict, status::certified);
    EXPECT_TRUE(q.enclosure.is_undefined());
    return q.why;
  };
  EXPECT_EQ(why([](auto x) { return 1 / x; }), reason::not_integrable);
  EXPECT_EQ(why([](auto x) { return exp(-1 / x); }), reason::not_applicable);
  EXPECT_EQ(why([](auto x) { return abs(x - rational(1, 3)); }), reason::not_applicable);
  EXPECT_EQ(why([](auto x) { return 1 / (x - rational(1, 3)); }), reason::not_applicable);
  EXPECT_EQ(why([](auto x) { return floor(3 * x); }), reason::not_applicable);
  // Poles on other sheets of the logarithm, near x = 1.
  EXPECT_EQ(why([](auto x) { return 1 / (log(x) * log(x) + 40); }), reason::not_applicable);
}

TEST(DoubleExponentialProblem, BoundsWhatTheRangeLeavesOut) {
  // x^alpha log(1/x)^k over 0 < x < D: with k = 0 D^c/c, and with k = 1 D^c (log(1/D)/c + 1/c^2).
  detail::double_exponential_problem problem{0, 1, {}, {}, {}};
  problem.left = {rational(-1, 2), 0, magnitude::power_of_two(0), 0.5};
  problem.right = {0, 0, magnitude(), 0.5};
  for (const double t : {1.0, 2.0, 3.0}) {
    const ball range = ball::exactly(t, p);
    const ball distance = 1 / (1 + exp(pi(p) * sinh(range)));
    const ball tail = 2 * sqrt(distance);
    EXPECT_TRUE(is_bound_of(problem.beyond(t), tail));
    EXPECT_TRUE(is_at_most(problem.beyond(t), rational(1'001, 1'000), tail));
    problem.left.log_degree = 1;
    const ball log_tail = sqrt(distance) * (2 * (1 - log(distance)) + 4);
    EXPECT_TRUE(is_bound_of(problem.beyond(t), log_tail));
    EXPECT_TRUE(is_at_most(problem.beyond(t), rational(1'001, 1'000), log_tail));
    problem.left.log_degree = 0;
  }
  EXPECT_TRUE(problem.beyond(0).is_infinite());
  EXPECT_TRUE(problem.beyond(-1).is_infinite());
  problem.left.reach = 1e-30;
  EXPECT_TRUE(problem.beyond(1).is_infinite());
}

/// x^(-1/2) over (0, 1).
detail::double_exponential_problem reciprocal_root() {
  detail::double_exponential_problem problem{0, 1, {}, {}, {}};
  problem.over = [](const region& u, const region&) { return 1 / sqrt(u); };
  problem.left = {rational(-1, 2), 0, magnitude::power_of_two(0), 0.5};
  problem.right = {0, 0, magnitude::from_integer_up(2), 0.5};
  return problem;
}
/// It is, after the substitution: x = v/(1 + v), v = e^(pi sinh t), so that x^(-1/2) dx/dt is
/// pi cosh(t) v^(1/2)/(1 + v)^(3/2).
ball size_of_reciprocal_root(const complex_ball& t) {
  const complex_ball u = pi(p) * sinh(t);
  return pi(p) * abs(cosh(t)) * exp(u.re / 2) / pow(sqrt(abs(1 + exp(u))), 3);
}

TEST(DoubleExponentialProblem, BoundsTheIntegrandAtTheSides) {
  const detail::double_exponential_problem problem = reciprocal_root();
  detail::double_exponential_problem with_logarithm = problem;
  with_logarithm.left.log_degree = 1;
  long evaluations = 0;
  for (const double range : {1.75, 2.0, 3.0}) {
    const auto bound = problem.rectangle(range, 0.75, evaluations);
    const auto other = with_logarithm.rectangle(range, 0.75, evaluations);
    ASSERT_TRUE(bound && other);
    for (std::size_t k = 0; k < bound->left.size(); ++k) {
      const side_piece& piece = bound->left[k];
      const complex_ball t(ball::exactly(-range, p), ball::exactly(piece.to, p));
      const ball size = size_of_reciprocal_root(t);
      EXPECT_TRUE(is_bound_of(piece.supremum, size)) << range << " " << piece.to;
      EXPECT_TRUE(is_at_most(piece.supremum, rational(3, 2), size)) << range << " " << piece.to;
      // With the logarithm of x as it is continued, which may have gone around 0.
      const complex_ball u = pi(p) * sinh(t);
      const ball logarithm = abs(complex_ball(u - log(1 + exp(u))));
      EXPECT_TRUE(is_bound_of(other->left[k].supremum, size * (1 + logarithm)));
      EXPECT_TRUE(is_at_most(other->left[k].supremum, 2, size * (1 + logarithm)));
    }
  }
}

TEST(DoubleExponentialProblem, BoundsIntegrandsOfAnySize) {
  // 5 x^(-1/2) (1 + x): 5 (1 + reach) x^(-1/2) is not below it within reach of 0.
  const double reach = 0.5;
  const known_number zero;
  const end_series x = end_series::argument(zero, known_number(rational(1)), 1, reach);
  const auto growth = detail::growth_from_series(5 * (1 + x) / sqrt(x), reach);
  ASSERT_TRUE(growth.has_value());
  EXPECT_EQ(growth->exponent, rational(-1, 2));
  EXPECT_TRUE(is_bound_of(growth->factor, ball(rational(15, 2), p)));
  // The sides of 5 x^(-1/2).
  detail::double_exponential_problem problem = reciprocal_root();
  problem.left.factor = magnitude::from_integer_up(5);
  long evaluations = 0;
  const auto bound = problem.rectangle(2, 0.75, evaluations);
  ASSERT_TRUE(bound.has_value());
  for (const side_piece& piece : bound->left) {
    const complex_ball t(ball(-2, p), ball::exactly(piece.to, p));
    EXPECT_TRUE(is_bound_of(piece.supremum, 5 * size_of_reciprocal_root(t))) << piece.to;
  }
}

TEST(DoubleExponentialProblem, BoundsTheIntegralAlongBothHorizontalSides) {
  const detail::double_exponential_problem problem = reciprocal_root();
  long evaluations = 0;
  for (const double d : {0.25, 0.5, 0.875}) {
    const auto along = [=](const ball& t) -> ball {
      return size_of_reciprocal_root(complex_ball(t, ball::exactly(d, p)));
    };
    const ball sides = 2 * trapezoid_sum<ball>(along, -4, 4, 2000, p);
    const auto bound = problem.rectangle(4, d, evaluations);
    ASSERT_TRUE(bound.has_value());
    EXPECT_TRUE(is_bound_of(bound->horizontal, sides)) << d;
    EXPECT_TRUE(is_at_most(bound->horizontal, rational(5, 3), sides)) << d;
  }
  // There x goes around 0 before it is within reach of the bound at the end: onto another sheet of
  // the root.
  EXPECT_FALSE(problem.rectangle(4, 1.25, evaluations).has_value());
  EXPECT_FALSE(problem.rectangle(4, 1.58, evaluations).has_value());
  // Where the cosine is positive again.
  EXPECT_FALSE(problem.rectangle(4, 6, evaluations).has_value());
}

}  // namespace rules_test
}  // namespace polhode
