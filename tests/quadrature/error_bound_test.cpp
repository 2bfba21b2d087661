// The truncation bound of the periodic trapezoidal rule against errors that are known exactly.

#include <gtest/gtest.h>

#include "polhode/quadrature/error_bounds.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/integrands.hpp"
#include "quadrature/rules/periodic.hpp"
#include "quadrature/rules/rules.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace error_bound_test {

using support::poisson_kernel;

constexpr precision p = 128;

/// The bound for the half circle with n nodes, and 2 pi q^N/(1 + q^N), the error itself.
struct bound_and_error {
  ball bound;
  ball error;
};
bound_and_error for_poisson(const rational& q, const ball& half_width, long n) {
  const poisson_kernel g(q);
  const auto strip = g.bound_on_strip(half_width);
  EXPECT_TRUE(strip.has_value());
  return {scale(periodic_trapezoid_error(*strip, 2 * n), -1),
          rational(1 - g.rule_over_pi(n)) * pi(p)};
}

TEST(PeriodicTrapezoidError, IsAttainedByACosineOfTheRulesOwnFrequency) {
  // f = cos(N t) at the nodes (2k+1) pi/N is -1: the rule says -2 pi, the integral is 0. With M =
  // cosh(N H) the bound is 2 pi (1 + e^(-2NH))/(1 - e^(-NH)): just above 2 pi for N H = 80. No
  // factor can be missing.
  for (const long nodes : {2L, 3L, 10L, 64L, 1001L}) {
    const ball half_width(rational(80, nodes), p);
    const ball error = periodic_trapezoid_error({half_width, cosh(half_width * nodes)}, nodes);
    const ball ratio = error / (2 * pi(p));
    EXPECT_FALSE(certainly_less(ratio, 1)) << nodes;
    EXPECT_TRUE(certainly_less(ratio, ball(1 + rational(1, 1'000'000'000), p))) << nodes << ratio;
  }
}

// cos(2 pi n t) is -1 at the n nodes of the mean over [0, 1], where its integral is 0.
TEST(MeanTrapezoidError, IsNearlyAttainedByACosineOfTheRulesOwnFrequency) {
  for (const long n : {1L, 2L, 7L, 40L}) {
    const ball width(rational(3, 4), 128);
    const magnitude error = mean_trapezoid_error({width, cosh(2 * width * n)}, n);
    const ball bound = ball(0, 128).enlarged(error);
    EXPECT_TRUE(contains(bound, 1)) << n;
    // Beside e^(-2 H n), the rounding of a magnitude.
    const ball excess = 2 * exp(-2 * width * n) + rational(1, 1 << 25);
    EXPECT_FALSE(contains(bound, rational(upper_rational(1 + excess)))) << n;
  }
  EXPECT_TRUE(mean_trapezoid_error({ball(0, 64), ball(1, 64)}, 5).is_infinite());
  EXPECT_TRUE(mean_trapezoid_error({ball(1, 64), ball(1, 64)}, 0).is_infinite());
}

// The rule with n nodes, n odd, takes T_(n+1) for T_(n-3).
TEST(ClenshawCurtisOnPanels, IsNearlyOffByItsBound) {
  for (const long n : {3L, 5L, 9L, 33L}) {
    const auto rule = detail::clenshaw_curtis_panels().nodes(n, 200);
    const auto chebyshev = [](const ball& x, long k) {
      ball before(1, 200);
      ball value = x;
      for (long j = 1; j < k; ++j) {
        ball next = 2 * x * value - before;
        before = value;
        value = next;
      }
      return value;
    };
    ball sum(0, 200);
    for (std::size_t k = 0; k < rule->nodes.size(); ++k) {
      const ball term = rule->weights[k] * chebyshev(rule->nodes[k], n + 1);
      sum += k == 0 ? term : scale(term, 1);  // 0 is the first of the nodes
    }
    const ball error = abs(sum - rational(2, 1 - (n + 1) * (n + 1)));
    const ball rho(1000, 200);
    const ball supremum = scale(pow(rho, n + 1) + pow(rho, -n - 1), -1);
    const magnitude bound =
        detail::clenshaw_curtis_panels().truncation_error(n, rho, supremum.magnitude_upper());
    EXPECT_TRUE(error.magnitude_lower() <= bound) << n;
    // But for what the errors of T_k fall with k, from 2 on.
    EXPECT_TRUE(bound <= (error * (n * n * n)).magnitude_upper()) << n;
  }
}

TEST(SupremumAlongAStrip, CountsEveryPiece) {
  for (const bool rising : {false, true}) {
    detail::segment s;
    s.over = [rising](const region& t) { return exp(rising ? 9 * t : -9 * t); };
    for (const long pieces : {1L, 8L, 100L}) {
      long evaluations = 0;
      const magnitude supremum = detail::supremum_along(s, 0.125, pieces, evaluations);
      EXPECT_EQ(evaluations, pieces);
      const ball greatest = exp(ball(rising ? 9 : 0, 100));
      EXPECT_TRUE(greatest.magnitude_lower() <= supremum) << pieces;
    }
  }
}

TEST(PeriodicTrapezoidError, IsAboveTheTrueErrorAndWithinAFactorOfIt) {
  // At the strip (1 - 1/N)/q = e^H, M is about N and the bound e N times the error.
  for (const rational& q : {rational(1, 10), rational(1, 3), rational(1, 2), rational(9, 10)}) {
    for (const long n : {5L, 8L, 20L, 51L, 100L}) {
      const rational wide = (1 - rational(1, 2 * n)) / q;
      const rational narrow = 1 + (wide - 1) / 2;
      if (wide <= 1) continue;
      for (const rational& e_to_h : {wide, narrow}) {
        const auto [bound, error] = for_poisson(q, log(ball(e_to_h, p)), n);
        EXPECT_TRUE(certainly_less(error, bound)) << q << " " << n;
      }
      const auto [bound, error] = for_poisson(q, log(ball(wide, p)), n);
      if (q == rational(9, 10) && n < 50) continue;  // the strip is too narrow for "about N"
      EXPECT_TRUE(certainly_less(bound, error * (2 * n) * rational(16, 5)))
          << q << " " << n << " " << bound / error;
    }
  }
}

TEST(PeriodicTrapezoidError, HoldsOverWholeSetsOfParameters) {
  // A wide half width or supremum: the bound of every member is inside.
  support::random_source random(1);
  for (support::repeat trial(200); trial.again();) {
    const ball half_width(rational(random.between(1, 1000), 500), 64);
    const ball supremum(rational(random.between(1, 1000), 7), 64);
    const ball wide_width = hull(half_width, half_width * rational(random.between(10, 20), 10));
    const ball wide_supremum = hull(supremum, supremum * random.between(1, 3));
    const long nodes = random.between(1, 200);
    const ball wide = periodic_trapezoid_error({wide_width, wide_supremum}, nodes);
    EXPECT_TRUE(overlaps(wide, periodic_trapezoid_error({half_width, supremum}, nodes)));
    EXPECT_FALSE(wide.magnitude_upper() <
                 periodic_trapezoid_error({half_width, wide_supremum}, nodes).magnitude_lower());
  }
}

TEST(PeriodicTrapezoidError, FallsByTheStripWithEachNode) {
  const strip_bound strip{ball(rational(1, 4), p), ball(3, p)};
  for (const long n : {40L, 80L}) {
    const ball ratio = periodic_trapezoid_error(strip, n) / periodic_trapezoid_error(strip, n + 1);
    const ball step = exp(strip.half_width);
    const ball expected = (exp(strip.half_width * (n + 1)) - 1) / (exp(strip.half_width * n) - 1);
    EXPECT_TRUE(overlaps(ratio, expected));
    EXPECT_TRUE(certainly_less(step, ratio));
  }
}

TEST(PeriodicTrapezoidError, RefusesWhatHasNoStrip) {
  const ball one(1, p);
  EXPECT_TRUE(periodic_trapezoid_error({ball(0, p), one}, 10).is_undefined());
  EXPECT_TRUE(periodic_trapezoid_error({ball(-1, p), one}, 10).is_undefined());
  EXPECT_TRUE(periodic_trapezoid_error({hull(ball(0, p), one), one}, 10).is_undefined());
  EXPECT_TRUE(periodic_trapezoid_error({ball::undefined(p), one}, 10).is_undefined());
  EXPECT_TRUE(periodic_trapezoid_error({one, ball::undefined(p)}, 10).is_undefined());
  EXPECT_TRUE(periodic_trapezoid_error({one, one}, 0).is_undefined());
  EXPECT_TRUE(periodic_trapezoid_error({one, one}, -4).is_undefined());
  EXPECT_FALSE(periodic_trapezoid_error({one, ball::entire(p)}, 4).is_bounded());
}

}  // namespace error_bound_test
}  // namespace polhode
