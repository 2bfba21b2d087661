// The Gauss and Legendre rules: against closed forms, against the equations that define them,
// against Arb; and the cache, which must not be believed more than it deserves.

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "base/sha256.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/quadrature/error_bounds.hpp"
#include "polhode/quadrature/gauss_legendre.hpp"
#include "quadrature/rules/gauss_legendre/nodes_and_weights.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"
#include "support/scratch_directory.hpp"

#ifdef POLHODE_HAVE_ARB
#include <arb_hypgeom.h>
#endif

namespace polhode {
namespace gauss_legendre_test {

namespace fs = std::filesystem;
using support::exact;
using support::exact_set;
using support::meet;

// ---------------------------------------------------------------------------------------------
// What a rule must satisfy.

/// The rule applied to f, which is even: twice the positive nodes, and the node 0 once.
template <class F>
ball applied(const gauss_legendre_rule& rule, F&& even_function) {
  ball sum(0, rule.bits);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const ball term = rule.weights[i] * even_function(rule.nodes[i]);
    sum += rule.n % 2 != 0 && i == 0 ? term : scale(term, 1);
  }
  return sum;
}

rational power_of_two(long n) {
  const integer one = 1;
  return n >= 0 ? rational(integer(one << static_cast<unsigned>(n)))
                : rational(integer(1), integer(one << static_cast<unsigned>(-n)));
}

void expect_promised_form(const gauss_legendre_rule& rule, long n, precision bits) {
  ASSERT_EQ(rule.n, n);
  ASSERT_EQ(rule.bits, bits);
  ASSERT_EQ(rule.nodes.size(), static_cast<std::size_t>((n + 1) / 2));
  ASSERT_EQ(rule.weights.size(), rule.nodes.size());
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const ball& x = rule.nodes[i];
    const ball& w = rule.weights[i];
    EXPECT_EQ(x.precision(), bits);
    EXPECT_EQ(w.precision(), bits);
    EXPECT_TRUE(x.radius() <= magnitude::power_of_two(-bits)) << n;
    EXPECT_TRUE(w.radius() <= scale(w.middle().magnitude_lower(), 1 - bits)) << n;
    EXPECT_TRUE(certainly_positive(w)) << n;
    if (i > 0) {
      EXPECT_TRUE(certainly_less(rule.nodes[i - 1], x)) << n;
    }
  }
  EXPECT_TRUE(certainly_less(rule.nodes.back(), 1)) << n;
  if (n % 2 != 0) {
    EXPECT_TRUE(rule.nodes.front().is_exact());
    EXPECT_TRUE(contains(rule.nodes.front(), 0L));
  } else {
    EXPECT_TRUE(certainly_positive(rule.nodes.front()));
  }
}

/// The sign of P_n at a rational x = a / 2^b, by the recurrence in integers: P_k k! 2^(b k) is an
/// integer.
int sign_of_legendre(long n, const rational& x) {
  const integer a = numerator(x);
  const integer d = denominator(x);
  integer before = 1;
  integer value = a;
  for (long k = 1; k < n; ++k) {
    // (k+1)! d^(k+1) P_(k+1) = (2k+1) a (k! d^k P_k) - k^2 d^2 ((k-1)! d^(k-1) P_(k-1)).
    const integer next = (2 * k + 1) * a * value - integer(k) * k * d * d * before;
    before = value;
    value = next;
  }
  return value.sign();
}

/// P_n changes its sign over each enclosure of a positive node: so it holds a zero, and being n/2
/// disjoint sets each holds one. In exact integers, without any of the code under test but the end
/// points.
void expect_sign_changes(const gauss_legendre_rule& rule) {
  for (std::size_t i = rule.n % 2 != 0 ? 1 : 0; i < rule.nodes.size(); ++i) {
    const exact_set set = exact(rule.nodes[i]);
    EXPECT_EQ(sign_of_legendre(rule.n, *set.lower) * sign_of_legendre(rule.n, *set.upper), -1)
        << "n = " << rule.n << ", node " << i;
  }
}

TEST(GaussLegendre, HasThePublishedClosedForms) {
  const precision p = 200;
  const ball one(1, p);
  for (const precision bits : {64L, 128L, 192L}) {
    const auto r1 = make_gauss_legendre(1, bits);
    EXPECT_TRUE(contains(r1.weights[0], 2L));
    const auto r2 = make_gauss_legendre(2, bits);
    EXPECT_TRUE(meet(r2.nodes[0], sqrt(one / 3)));
    EXPECT_TRUE(contains(r2.weights[0], 1L));
    const auto r3 = make_gauss_legendre(3, bits);
    EXPECT_TRUE(meet(r3.nodes[1], sqrt(ball(rational(3, 5), p))));
    EXPECT_TRUE(contains(r3.weights[0], rational(8, 9)));
    EXPECT_TRUE(contains(r3.weights[1], rational(5, 9)));
    const auto r5 = make_gauss_legendre(5, bits);
    const ball inner = 2 * sqrt(ball(rational(10, 7), p));
    EXPECT_TRUE(meet(r5.nodes[1], sqrt(5 - inner) / 3));
    EXPECT_TRUE(meet(r5.nodes[2], sqrt(5 + inner) / 3));
    EXPECT_TRUE(contains(r5.weights[0], rational(128, 225)));
    const ball part = 13 * sqrt(ball(70, p));
    EXPECT_TRUE(meet(r5.weights[1], (322 + part) / 900));
    EXPECT_TRUE(meet(r5.weights[2], (322 - part) / 900));
  }
}

TEST(GaussLegendre, EnclosesTheZerosForAllSmallDegrees) {
  for (long n = 1; n <= 80; ++n) {
    for (const precision bits : {64L, 128L, 192L, 448L}) {
      const auto rule = make_gauss_legendre(n, bits);
      expect_promised_form(rule, n, bits);
      if (bits == 64 || n % 8 < 2) expect_sign_changes(rule);
    }
  }
}

TEST(GaussLegendre, EnclosesTheZerosForLargeDegrees) {
  for (const long n : {150L, 333L}) {
    const auto rule = make_gauss_legendre(n, 64);
    expect_promised_form(rule, n, 64);
    if (n == 150) expect_sign_changes(rule);
  }
  expect_promised_form(make_gauss_legendre(1000, 64), 1000, 64);
  expect_promised_form(make_gauss_legendre(333, 1152), 333, 1152);
  expect_promised_form(make_gauss_legendre(4, 8000), 4, 8000);
  expect_promised_form(make_gauss_legendre(37, 4096), 37, 4096);
}

TEST(GaussLegendre, IsExactBelowTwiceTheDegreeAndNotAtIt) {
  for (long n = 1; n <= 80; ++n) {
    const precision bits = 320;
    const auto rule = make_gauss_legendre(n, bits);
    for (long k = 0; k < n; ++k) {
      const ball sum = applied(rule, [k](const ball& x) { return pow(x, 2 * k); });
      EXPECT_TRUE(contains(sum, rational(2, 2 * k + 1))) << "x^" << 2 * k << ", n = " << n;
      EXPECT_TRUE(sum.radius() <= magnitude::power_of_two(10 - bits)) << n;
    }
    // On x^(2n) it falls short by 2^(2n+1) (n!)^4 / ((2n+1) ((2n)!)^2), the integral of the monic
    // P_n^2.
    rational missing(2, 2 * n + 1);
    for (long k = 1; k <= n; ++k) {
      // (2^n (n!)^2 / (2n)!)^2, factor by factor: k/(2k-1) squared.
      missing *= rational(k * k, (2 * k - 1) * (2 * k - 1));
    }
    const ball sum = applied(rule, [n](const ball& x) { return pow(x, 2 * n); });
    EXPECT_TRUE(contains(sum, rational(2, 2 * n + 1) - missing)) << n;
    EXPECT_FALSE(contains(sum, rational(2, 2 * n + 1))) << n;
  }
}

TEST(GaussLegendre, AgreesWithAFinerRule) {
  // The sets at one precision hold the numbers that the sets at another hold.
  for (const long n : {7L, 64L, 129L, 333L}) {
    const auto fine = make_gauss_legendre(n, 640);
    for (const precision bits : {64L, 192L, 576L}) {
      const auto coarse = make_gauss_legendre(n, bits);
      for (std::size_t i = 0; i < fine.nodes.size(); ++i) {
        EXPECT_TRUE(contains(coarse.nodes[i], fine.nodes[i])) << n << " " << i;
        EXPECT_TRUE(contains(coarse.weights[i], fine.weights[i])) << n << " " << i;
      }
    }
  }
}

#ifdef POLHODE_HAVE_ARB
ball from_arb(arb_srcptr x, precision p) {
  detail::mpfr_cell lower(p);
  detail::mpfr_cell upper(p);
  arb_get_interval_mpfr(lower.get(), upper.get(), x);
  return ball::from_end_points(lower.get(), upper.get(), p);
}

TEST(GaussLegendre, AgreesWithArb) {
  struct degree_and_bits {
    long n;
    precision bits;
    std::size_t step;
  };
  for (const auto& [n, bits, step] : {degree_and_bits{1, 64, 1},
                                      {2, 64, 1},
                                      {3, 192, 1},
                                      {10, 128, 1},
                                      {31, 1152, 1},
                                      {64, 64, 1},
                                      {333, 128, 7},
                                      {333, 1152, 7},
                                      {1000, 3456, 31}}) {
    const auto rule = make_gauss_legendre(n, bits);
    arb_t x;
    arb_t w;
    arb_init(x);
    arb_init(w);
    for (std::size_t i = 0; i < rule.nodes.size(); i += step) {
      // Arb counts from the greatest node.
      arb_hypgeom_legendre_p_ui_root(x, w, static_cast<ulong>(n), rule.nodes.size() - 1 - i,
                                     bits + 30);
      EXPECT_TRUE(contains(rule.nodes[i], from_arb(x, bits + 40))) << n << " " << i;
      EXPECT_TRUE(contains(rule.weights[i], from_arb(w, bits + 40))) << n << " " << i;
    }
    arb_clear(x);
    arb_clear(w);
  }
}
#endif

TEST(GaussLegendre, DoesNotDependOnTheEstimates) {
  // The squares of the nodes, moved a little, moved a lot, in the wrong order, or invented: the
  // right rule or none.
  const auto squares = [](const gauss_legendre_rule& rule) {
    std::vector<std::uint64_t> result;
    detail::mpfr_cell cell(64);
    for (std::size_t i = rule.n % 2 != 0 ? 1 : 0; i < rule.nodes.size(); ++i) {
      scale(square(rule.nodes[i]), 64).with_precision(64).midpoint(cell.get());
      result.push_back(mpfr_get_ui(cell.get(), MPFR_RNDD));
    }
    return result;
  };
  support::random_source random(7);
  for (const long n : {2L, 3L, 8L, 25L, 60L}) {
    const auto right = make_gauss_legendre(n, 128);
    const auto starts = squares(right);
    const auto check = [&](const std::vector<std::uint64_t>& from, bool must_succeed) {
      try {
        const auto rule = detail::make_gauss_legendre_from(n, 128, [&](long) { return from; });
        ASSERT_EQ(rule.nodes.size(), right.nodes.size());
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
          EXPECT_TRUE(overlaps(rule.nodes[i], right.nodes[i])) << n;
          EXPECT_TRUE(overlaps(rule.weights[i], right.weights[i])) << n;
        }
        expect_sign_changes(rule);
      } catch (const std::runtime_error&) {
        EXPECT_FALSE(must_succeed) << n;
      }
    };
    check(starts, true);
    for (const int shift : {8, 16, 24, 32, 40, 44}) {
      auto moved = starts;
      for (auto& y : moved) {
        y += (random.bits() >> 63) != 0 ? std::uint64_t{1} << shift : -(std::uint64_t{1} << shift);
      }
      check(moved, true);
    }
    auto reversed = starts;
    std::reverse(reversed.begin(), reversed.end());
    if (reversed != starts) {
      EXPECT_THROW((void)detail::make_gauss_legendre_from(n, 128, [&](long) { return reversed; }),
                   std::runtime_error);
    }
    for (int trial = 0; trial < 5; ++trial) {
      std::vector<std::uint64_t> invented;
      for (std::size_t i = 0; i < starts.size(); ++i) invented.push_back(random.bits());
      check(invented, false);
    }
    for (const std::uint64_t y : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
      check(std::vector<std::uint64_t>(starts.size(), y), false);
    }
    auto missing = starts;
    missing.pop_back();
    EXPECT_THROW((void)detail::make_gauss_legendre_from(n, 128, [&](long) { return missing; }),
                 std::invalid_argument);
  }
}

rational exactly(const magnitude& x) { return x.fraction() * power_of_two(x.exponent()); }

TEST(GaussLegendre, BoundsWhatATaylorPolynomialLeavesOut) {
  // Exactly, for q(y) = P_n(x) / x^e: the Taylor coefficients at y_0, and the terms of order j and
  // more at y_0 +- h.
  for (const long n : {1L, 2L, 3L, 6L, 11L, 20L, 41L}) {
    // P_n(x) = 2^-n sum of (-1)^k C(n, k) C(2n - 2k, n) x^(n - 2k).
    const long degree = n / 2;
    std::vector<rational> q(static_cast<std::size_t>(degree) + 1);
    integer a;
    integer b;
    for (long k = 0; k <= degree; ++k) {
      mpz_bin_uiui(a.backend().data(), static_cast<unsigned long>(n),
                   static_cast<unsigned long>(k));
      mpz_bin_uiui(b.backend().data(), static_cast<unsigned long>(2 * n - 2 * k),
                   static_cast<unsigned long>(n));
      q[static_cast<std::size_t>(degree - k)] =
          (k % 2 == 0 ? 1 : -1) * rational(integer(a * b)) * power_of_two(-n);
    }
    for (const rational& centre : {rational(0), rational(1, 10), rational(5, 7), rational(1)}) {
      std::vector<rational> c = q;  // Horner's scheme, again and again
      for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t k = c.size() - 1; k > i; --k) c[k - 1] += centre * c[k];
      }
      for (const long exponent : {-1L, -4L, -7L, -10L, -30L}) {
        const rational h = power_of_two(exponent);
        for (long j = 1; j <= degree + 1; ++j) {
          const auto bound =
              detail::legendre_taylor_remainder(n, j, magnitude::power_of_two(exponent));
          for (const rational& at : {h, rational(-h)}) {
            rational value = 0;
            rational slope = 0;
            for (long k = degree; k >= j; --k) {
              value = value * at + c[static_cast<std::size_t>(k)];
              slope = slope * at + k * c[static_cast<std::size_t>(k)];
            }
            for (long k = 1; k < j; ++k) {
              value *= at;
              slope *= at;
            }
            value *= at;
            if (!bound.of_value.is_infinite()) {
              EXPECT_LE(abs(value), exactly(bound.of_value)) << n << " " << j << " " << exponent;
            }
            if (!bound.of_slope.is_infinite()) {
              EXPECT_LE(abs(slope), exactly(bound.of_slope)) << n << " " << j << " " << exponent;
            }
            // And not by far: the largest coefficients are those at y = 1.
            if (centre == 1 && exponent == -30 && j <= degree / 2) {
              EXPECT_GE(abs(value) * power_of_two(4 * j + 6), exactly(bound.of_value)) << n << j;
              EXPECT_GE(abs(slope) * power_of_two(4 * j + 6), exactly(bound.of_slope)) << n << j;
            }
          }
        }
      }
    }
  }
}

// For n odd and large the terms are the largest at y = 0, where q = P_n(x)/x is about n times as
// large as at 1.
TEST(GaussLegendre, BoundsWhatATaylorPolynomialOfAnOddOneLeavesOut) {
  for (const long n : {251L, 401L, 1001L}) {
    // The coefficient of x^3: that of x is (-1)^m (2m+1) C(2m, m) / 4^m, n = 2m + 1, and of q(y) =
    // c_0 + c_1 y + ... 6 c_1 = -(n(n+1) - 2) c_0, by Legendre's equation.
    const auto m = static_cast<unsigned long>(n / 2);
    integer binomial;
    mpz_bin_uiui(binomial.backend().data(), 2 * m, m);
    const rational first = rational(integer(n * binomial)) * power_of_two(1 - n);
    const rational second = first * rational(n * (n + 1) - 2, 6);
    const rational third = second * rational(n * (n + 1) - 12, 20);
    const rational h = power_of_two(-60);
    // The rest falls as the terms do, and is alternating for h > 0.
    const auto bound = detail::legendre_taylor_remainder(n, 1, magnitude::power_of_two(-60));
    EXPECT_LE((second - third * h) * h, exactly(bound.of_value)) << n;
    EXPECT_LE(second - 2 * third * h, exactly(bound.of_slope)) << n;
    EXPECT_GE(second * n, exactly(bound.of_slope)) << n;
  }
}

TEST(GaussLegendre, GivesNodesNoRadiusThatIsTooSmall) {
  const auto with = [](const rational& radius, bool relative) {
    const magnitude size = scale(ball(radius, 64).magnitude_upper(), -128);
    const ball x = ball(rational(3, 16), 200).enlarged(size);
    return detail::legendre::with_radius(x, 128, relative);
  };
  const auto is_set = [](const std::optional<ball>& x, long exponent) {
    return x && x->radius() == magnitude::power_of_two(exponent) && contains(*x, rational(3, 16));
  };
  EXPECT_TRUE(is_set(with(0, false), -128));
  EXPECT_TRUE(is_set(with(rational(9, 10), false), -128));
  EXPECT_FALSE(with(rational(11, 10), false));
  EXPECT_FALSE(with(rational(19, 10), false));
  EXPECT_FALSE(with(1000, false));
  // 3/16 is below 1/4.
  EXPECT_TRUE(is_set(with(rational(9, 40), true), -130));
  EXPECT_FALSE(with(rational(11, 40), true));
  EXPECT_FALSE(with(rational(19, 40), true));
  EXPECT_FALSE(detail::legendre::with_radius(ball::undefined(200), 128, false));
  EXPECT_FALSE(detail::legendre::with_radius(ball(0, 200), 128, true));
}

TEST(GaussLegendre, RefusesWhatIsNoRule) {
  EXPECT_THROW((void)make_gauss_legendre(0, 64), std::invalid_argument);
  EXPECT_THROW((void)make_gauss_legendre(-3, 64), std::invalid_argument);
  EXPECT_THROW((void)make_gauss_legendre(greatest_gauss_legendre_degree + 1, 64),
               std::invalid_argument);
  EXPECT_THROW((void)make_gauss_legendre(5, 0), std::invalid_argument);
  EXPECT_THROW((void)make_gauss_legendre(5, 100), std::invalid_argument);
  node_cache cache;
  EXPECT_THROW((void)gauss_legendre(0, 64, cache), std::invalid_argument);
  EXPECT_THROW((void)gauss_legendre(5, 0, cache), std::invalid_argument);
}

TEST(GaussLegendreLadder, HasFewDegreesAndPrecisions) {
  for (long n = 1; n <= 16; ++n) EXPECT_EQ(gauss_legendre_degree_at_least(n), n);
  long degrees = 0;
  for (long n = 1; n <= 20000; ++n) {
    const long degree = gauss_legendre_degree_at_least(n);
    EXPECT_GE(degree, n);
    EXPECT_LE(4 * degree, 5 * n);  // never more than a quarter too many
    EXPECT_EQ(gauss_legendre_degree_at_least(degree), degree);
    if (degree == n) ++degrees;
  }
  EXPECT_EQ(degrees, 16 + 61);  // 18 ... 18432: ten octaves and a step or two
  EXPECT_THROW((void)gauss_legendre_degree_at_least(0), std::invalid_argument);
  EXPECT_EQ(gauss_legendre_degree_at_least(greatest_gauss_legendre_degree),
            greatest_gauss_legendre_degree);
  for (precision p = 2; p <= 20000; ++p) {
    const precision bits = gauss_legendre_precision_at_least(p);
    EXPECT_EQ(bits % 64, 0);
    EXPECT_GE(bits, p + 2);
    EXPECT_LE(bits, p + 2 + std::max<precision>(63, p / 8));
  }
}

// ---------------------------------------------------------------------------------------------
// The error bound.

TEST(GaussLegendreError, IsNearlyAttainedByAChebyshevPolynomial) {
  // f = T_2n is (z^2n + z^-2n)/2, at most M = (rho^2n + rho^-2n)/2 in the ellipse, and the rule's
  // error is 2^(2n-1) times that on x^(2n), known exactly. The bound is close to 32/15 for large
  // rho, the error to pi/2.
  for (const long n : {1L, 2L, 3L, 5L, 17L, 80L}) {
    rational missing = rational(2, 2 * n + 1) * power_of_two(2 * n - 1);
    for (long k = 1; k <= n; ++k) missing *= rational(k * k, (2 * k - 1) * (2 * k - 1));
    for (const rational& rho : {rational(11, 10), rational(2), rational(10), rational(1000)}) {
      const ball r(rho, 256);
      const ball supremum = scale(pow(r, 2 * n) + pow(r, -2 * n), -1);
      const magnitude bound = gauss_legendre_error(n, r, supremum.magnitude_upper());
      const ball error(missing, 256);
      EXPECT_TRUE(error.magnitude_upper() <= bound) << n << " " << rho;
      if (rho >= 10) {
        EXPECT_TRUE(scale(error.magnitude_lower(), 1) >= bound) << n << " " << rho;
      }
    }
    // The error that was taken for known is the rule's.
    const auto rule = make_gauss_legendre(n, 512);
    const ball sum = applied(rule, [n](const ball& x) {
      ball before(1, 512);
      ball value = x;
      for (long k = 1; k < 2 * n; ++k) {
        ball next = 2 * x * value - before;
        before = value;
        value = next;
      }
      return value;
    });
    EXPECT_TRUE(overlaps(rational(2, 1 - 4 * n * n) - sum, ball(missing, 512))) << n;
  }
}

TEST(GaussLegendreError, IsAboveTheErrorOfAPole) {
  // 1/(x - c), c > 1, even part c/(x^2 - c^2): the integral is -log((c+1)/(c-1)).
  const precision p = 2048;
  for (const rational& c : {rational(101, 100), rational(5, 4), rational(3)}) {
    const ball pole(c, p);
    const ball most = pole + sqrt(square(pole) - 1);
    for (const long n : {1L, 2L, 5L, 20L, 60L}) {
      const auto rule = make_gauss_legendre(n, p);
      const ball sum =
          applied(rule, [&](const ball& x) { return pole / (square(x) - square(pole)); });
      const ball error = sum + log((pole + 1) / (pole - 1));
      std::optional<magnitude> best;
      for (const long tenths : {1L, 3L, 5L, 7L, 9L}) {
        const ball rho = 1 + (most - 1) * rational(tenths, 10);
        const ball supremum = 1 / (pole - scale(rho + 1 / rho, -1));
        const magnitude bound = gauss_legendre_error(n, rho, supremum.magnitude_upper());
        EXPECT_TRUE(error.magnitude_upper() <= bound) << c << " " << n << " " << tenths;
        best = best ? min(*best, bound) : bound;
      }
      // With the best of a fine choice of rho, M and the sum cost a factor of about 2 e n; n <= 5
      // shows that no more is lost.
      if (n == 5 && c == 3) {
        EXPECT_TRUE(error.magnitude_lower() >= divide_up(*best, magnitude::from_integer_down(60)));
      }
    }
  }
}

TEST(GaussLegendreError, IsInfiniteWithoutItsHypotheses) {
  const magnitude one = magnitude::from_integer_up(1);
  EXPECT_TRUE(gauss_legendre_error(5, ball(1, 64), one).is_infinite());
  EXPECT_TRUE(gauss_legendre_error(5, ball(rational(1, 2), 64), one).is_infinite());
  EXPECT_TRUE(gauss_legendre_error(5, hull(ball(1, 64), ball(2, 64)), one).is_infinite());
  EXPECT_TRUE(gauss_legendre_error(5, ball::undefined(64), one).is_infinite());
  EXPECT_TRUE(gauss_legendre_error(0, ball(2, 64), one).is_infinite());
  EXPECT_TRUE(gauss_legendre_error(5, ball(2, 64), magnitude::infinity()).is_infinite());
  EXPECT_FALSE(gauss_legendre_error(5, ball(2, 64), one).is_infinite());
  // A ball of parameters stands for the least of them: 64 / (15 * 3 * 4^4).
  const magnitude bound = gauss_legendre_error(5, hull(ball(2, 64), ball(3, 64)), one);
  const ball expected(rational(64, 45 * 256), 64);
  EXPECT_TRUE(expected.magnitude_lower() <= bound);
  EXPECT_TRUE(bound <= scale(expected.magnitude_upper(), 1));
}

// ---------------------------------------------------------------------------------------------
// SHA-256.

TEST(Sha256, HasThePublishedValues) {
  const auto hex = [](std::string_view text) {
    std::string result;
    for (const auto byte : sha256(std::as_bytes(std::span(text)))) {
      constexpr std::string_view digits = "0123456789abcdef";
      result += digits[byte >> 4];
      result += digits[byte & 15];
    }
    return result;
  };
  // FIPS 180-4's examples, and NIST's: the empty text, one block, two, and a million letters.
  EXPECT_EQ(hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(
      hex("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqklmn"
          "opqrlmnopqrsmnopqrstnopqrstu"),
      "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  EXPECT_EQ(hex(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// ---------------------------------------------------------------------------------------------
// The cache.

/// A directory of this test's own, and a name for a cache in it.
class own_directory {
 public:
  [[nodiscard]] fs::path path() const { return directory_.path(); }
  [[nodiscard]] std::string cache() const { return (path() / "a" / "cache").string(); }

 private:
  support::scratch_directory directory_;
};

/// The environment variables that name the user's cache, as they were before.
class kept_environment {
 public:
  kept_environment() {
    for (const char* name : names) {
      const char* text = std::getenv(name);
      old_.push_back(text == nullptr ? std::nullopt : std::optional<std::string>(text));
    }
  }
  kept_environment(const kept_environment&) = delete;
  kept_environment& operator=(const kept_environment&) = delete;
  ~kept_environment() {
    for (std::size_t i = 0; i < names.size(); ++i) set(names[i], old_[i]);
  }
  static void set(const char* name, const std::optional<std::string>& text) {
    if (text) {
      ::setenv(name, text->c_str(), 1);
    } else {
      ::unsetenv(name);
    }
  }

 private:
  static constexpr std::array names = {"POLHODE_CACHE", "XDG_CACHE_HOME", "HOME"};
  std::vector<std::optional<std::string>> old_;
};

std::vector<fs::path> files_in(const std::string& directory) {
  std::vector<fs::path> result;
  std::error_code failure;
  for (const auto& file : fs::directory_iterator(directory, failure)) result.push_back(file.path());
  return result;
}

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void set_content(const fs::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
}

/// The same sets, bit for bit.
bool same(const ball& x, const ball& y) {
  detail::mpfr_cell a(x.precision());
  detail::mpfr_cell b(y.precision());
  x.midpoint(a.get());
  y.midpoint(b.get());
  return x.precision() == y.precision() && mpfr_equal_p(a.get(), b.get()) != 0 &&
         x.radius() == y.radius();
}

bool same(const gauss_legendre_rule& x, const gauss_legendre_rule& y) {
  if (x.n != y.n || x.bits != y.bits || x.nodes.size() != y.nodes.size()) return false;
  for (std::size_t i = 0; i < x.nodes.size(); ++i) {
    if (!same(x.nodes[i], y.nodes[i]) || !same(x.weights[i], y.weights[i])) return false;
  }
  return true;
}

constexpr std::uintmax_t much = std::uintmax_t{1} << 30;

/// A cache that writes every rule.
node_cache eager(const std::string& directory, std::uintmax_t most_bytes = much) {
  return node_cache(directory, most_bytes, 0);
}

TEST(NodeCache, RemembersInMemory) {
  node_cache cache;
  const auto first = cache.get(12, 128);
  EXPECT_EQ(first, cache.get(12, 128));
  EXPECT_EQ(cache.statistics().made, 1);
  EXPECT_NE(first, cache.get(12, 192));
  EXPECT_NE(first, cache.get(13, 128));
  EXPECT_EQ(cache.statistics().made, 3);
  EXPECT_EQ(cache.statistics().read, 0);
  EXPECT_EQ(cache.statistics().written, 0);
  EXPECT_EQ(gauss_legendre(12, 126, cache), first);  // the ladder's precision
  EXPECT_TRUE(same(*first, make_gauss_legendre(12, 128)));
}

TEST(NodeCache, ReadsBackTheSameBits) {
  const own_directory own;
  for (const long n : {1L, 2L, 3L, 4L, 15L, 40L, 101L}) {
    for (const precision bits : {64L, 128L, 1152L}) {
      node_cache writer = eager(own.cache());
      const auto made = writer.get(n, bits);
      EXPECT_EQ(writer.statistics().written, 1);
      node_cache reader = eager(own.cache());
      const auto read = reader.get(n, bits);
      EXPECT_EQ(reader.statistics().read, 1) << n;
      EXPECT_EQ(reader.statistics().made, 0) << n;
      EXPECT_TRUE(same(*made, *read)) << n;
    }
  }
  EXPECT_EQ(files_in(own.cache()).size(), 21U);
}

TEST(NodeCache, WritesOnlyWhatTookLong) {
  const own_directory own;
  node_cache cache(own.cache(), much, 1e9);
  (void)cache.get(20, 128);
  EXPECT_EQ(cache.statistics().written, 0);
  EXPECT_FALSE(fs::exists(own.cache()));
}

class damaged_file : public ::testing::Test {
 protected:
  damaged_file() {
    (void)eager(own_.cache()).get(n, bits);
    file_ = files_in(own_.cache()).at(0);
    good_ = content_of(file_);
  }
  /// The rule is made anew and right, and the file is good again.
  void expect_refused(const std::string& content) {
    set_content(file_, content);
    node_cache cache = eager(own_.cache());
    EXPECT_TRUE(same(*cache.get(n, bits), right_));
    EXPECT_EQ(cache.statistics().read, 0);
    EXPECT_EQ(cache.statistics().refused, 1);
    EXPECT_EQ(cache.statistics().made, 1);
    EXPECT_EQ(content_of(file_), good_);
    EXPECT_EQ(files_in(own_.cache()).size(), 1U);
  }
  /// The content with the digest that belongs to it.
  static std::string with_digest(std::string content) {
    const std::size_t end = content.size() - 32;
    const auto digest = sha256(std::as_bytes(std::span(content).first(end)));
    std::copy(digest.begin(), digest.end(), content.begin() + static_cast<std::ptrdiff_t>(end));
    return content;
  }

  static constexpr long n = 7;
  static constexpr precision bits = 128;
  own_directory own_;
  fs::path file_;
  std::string good_;
  gauss_legendre_rule right_ = make_gauss_legendre(n, bits);
};

TEST_F(damaged_file, IsRefusedForAnyByte) {
  for (std::size_t i = 0; i < good_.size(); ++i) {
    for (const int change : {1, 0x80}) {
      std::string bad = good_;
      bad[i] = static_cast<char>(bad[i] ^ change);
      expect_refused(bad);
    }
  }
}

TEST_F(damaged_file, IsRefusedAtAnyOtherLength) {
  for (std::size_t length = 0; length < good_.size(); ++length) {
    expect_refused(good_.substr(0, length));
  }
  expect_refused(good_ + '\0');
  expect_refused(good_ + good_);
  expect_refused(std::string(good_.size(), '\0'));
  expect_refused(std::string(good_.size(), '\xff'));
}

TEST_F(damaged_file, IsRefusedForAnotherHeader) {
  // Each word of the header changed, with a digest that is right.
  for (std::size_t i = 0; i < 64; ++i) {
    std::string bad = good_;
    bad[i] = static_cast<char>(bad[i] ^ 2);
    expect_refused(with_digest(bad));
  }
  // Another degree's or precision's rule under this name.
  for (const auto& [other_n, other_bits] : {std::pair{6L, 128L}, {8L, 128L}, {7L, 192L}}) {
    const own_directory elsewhere;
    (void)eager(elsewhere.cache()).get(other_n, other_bits);
    expect_refused(content_of(files_in(elsewhere.cache()).at(0)));
  }
}

TEST_F(damaged_file, IsRefusedWhereItIsNoRule) {
  // With a digest that is right: each number's exponent and highest limb changed, and its
  // fifth-highest bits; two nodes exchanged; two weights exchanged.
  constexpr std::size_t start = 64;
  constexpr std::size_t number = 8 * (1 + bits / 64);
  for (std::size_t at = start; at + 32 < good_.size(); at += number) {
    for (const std::size_t byte : {at, at + 7, at + number - 1, at + number - 5, at + number - 9}) {
      for (const int change : {1, 8, 0x80}) {
        std::string bad = good_;
        bad[byte] = static_cast<char>(bad[byte] ^ change);
        expect_refused(with_digest(bad));
      }
    }
  }
  const auto exchanged = [&](std::size_t i, std::size_t j) {
    std::string bad = good_;
    bad.replace(start + i * number, number, good_, start + j * number, number);
    bad.replace(start + j * number, number, good_, start + i * number, number);
    return with_digest(bad);
  };
  expect_refused(exchanged(0, 1));  // n = 7: three nodes above 0, then four weights
  expect_refused(exchanged(1, 2));
  expect_refused(exchanged(3, 4));
  expect_refused(exchanged(5, 6));
  expect_refused(exchanged(2, 3));
}

TEST(NodeCache, DoesWithoutAPlaceToWrite) {
  const own_directory own;
  const gauss_legendre_rule right = make_gauss_legendre(9, 128);
  const auto works = [&](const std::string& directory) {
    node_cache cache = eager(directory);
    EXPECT_TRUE(same(*cache.get(9, 128), right)) << directory;
    EXPECT_EQ(cache.statistics().made, 1) << directory;
    EXPECT_EQ(cache.statistics().written, 0) << directory;
  };
  works("");
  works("/proc/nowhere");
  works("/dev/null/cache");
  set_content(own.path() / "file", "a file");
  works((own.path() / "file").string());
  works((own.path() / "file" / "below").string());
  // A directory in the place of the rule's file: it cannot be renamed over, and nothing is left
  // behind.
  fs::create_directories(own.path() / "b" / "gauss-legendre-9-128.rule" / "full");
  works((own.path() / "b").string());
  EXPECT_EQ(files_in((own.path() / "b").string()).size(), 1U);
  // Not for root, who may write everywhere.
  if (::geteuid() != 0) {
    fs::create_directories(own.path() / "c");
    fs::permissions(own.path() / "c", fs::perms::owner_read | fs::perms::owner_exec);
    works((own.path() / "c").string());
    EXPECT_TRUE(files_in((own.path() / "c").string()).empty());
  }
}

TEST(NodeCache, SurvivesAFullDisk) {
  // In a child whose files may have no more than a few bytes.
  const own_directory own;
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const ::rlimit few{100, 100};
    ::setrlimit(RLIMIT_FSIZE, &few);
    node_cache cache = eager(own.cache());
    const bool right = same(*cache.get(9, 128), make_gauss_legendre(9, 128));
    ::_exit(right && cache.statistics().written == 0 ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(files_in(own.cache()).empty());
}

TEST(NodeCache, KeepsItsTotalSize) {
  const own_directory own;
  std::uintmax_t most = 0;
  {
    (void)eager(own.cache()).get(20, 128);
    most = 3 * fs::file_size(files_in(own.cache()).at(0)) + 10;
  }
  set_content(fs::path(own.cache()) / "someone-elses", std::string(100'000, 'x'));
  const fs::path old = fs::path(own.cache()) / "gauss-legendre-5-64.rule.unfinished-abcdef";
  const fs::path young = fs::path(own.cache()) / "gauss-legendre-6-64.rule.unfinished-abcdef";
  set_content(old, "half");
  set_content(young, "half");
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(2));
  const auto name = [](long n) { return "gauss-legendre-" + std::to_string(n) + "-128.rule"; };
  node_cache cache = eager(own.cache(), most);
  auto time = fs::file_time_type::clock::now() - std::chrono::minutes(30);
  fs::last_write_time(fs::path(own.cache()) / name(20), time);
  for (long n = 21; n <= 26; ++n) {
    (void)cache.get(n, 128);
    const fs::path file = fs::path(own.cache()) / name(n);
    EXPECT_TRUE(fs::exists(file)) << n;
    fs::last_write_time(file, time += std::chrono::minutes(1));
  }
  std::uintmax_t total = 0;
  for (const auto& file : files_in(own.cache())) {
    if (file.extension() == ".rule") total += fs::file_size(file);
  }
  EXPECT_LE(total, most);
  EXPECT_GT(total, most / 2);
  EXPECT_FALSE(fs::exists(fs::path(own.cache()) / name(20)));
  EXPECT_TRUE(fs::exists(fs::path(own.cache()) / "someone-elses"));
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(young));
  // What is larger than the total is not written at all.
  const auto before = files_in(own.cache()).size();
  (void)cache.get(300, 128);
  EXPECT_EQ(files_in(own.cache()).size(), before);
}

TEST(NodeCache, ServesManyThreadsAtOnce) {
  const own_directory own;
  node_cache shared = eager(own.cache());
  const auto job = [&](node_cache& cache,
                       std::vector<std::shared_ptr<const gauss_legendre_rule>>& out) {
    for (long n = 30; n < 50; ++n) out.push_back(cache.get(n, 192));
  };
  // Three on one cache, and two on caches of their own with the same directory.
  std::vector<std::vector<std::shared_ptr<const gauss_legendre_rule>>> results(5);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < results.size(); ++i) {
    threads.emplace_back([&, i] {
      node_cache own_cache = eager(own.cache());
      job(i < 3 ? shared : own_cache, results[i]);
    });
  }
  for (auto& thread : threads) thread.join();
  const auto counts = shared.statistics();
  EXPECT_EQ(counts.made + counts.read, 20);
  EXPECT_EQ(counts.refused, 0);
  for (std::size_t i = 0; i < 20; ++i) {
    for (const auto& result : results) EXPECT_TRUE(same(*result[i], *results[0][i]));
    EXPECT_EQ(results[0][i], results[1][i]);
    EXPECT_EQ(results[0][i], results[2][i]);
  }
  EXPECT_EQ(files_in(own.cache()).size(), 20U);
}

TEST(NodeCache, ServesTwoProcessesAtOnce) {
  const own_directory own;
  const auto all_right = [&] {
    for (int round = 0; round < 20; ++round) {
      node_cache cache = eager(own.cache());
      for (long n = 30; n < 40; ++n) {
        if (!same(*cache.get(n, 128), make_gauss_legendre(n, 128))) return false;
        if (cache.statistics().refused != 0) return false;
      }
      // And again: another process may be reading them at this moment.
      for (const auto& file : files_in(own.cache())) {
        std::error_code gone;
        if (round % 2 == 0) fs::remove(file, gone);
      }
    }
    return true;
  };
  std::vector<pid_t> children;
  for (int i = 0; i < 2; ++i) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) ::_exit(all_right() ? 0 : 1);
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  for (const auto& file : files_in(own.cache())) EXPECT_EQ(file.extension(), ".rule");
}

TEST(NodeCache, FindsTheUsersDirectory) {
  const kept_environment kept;
  const auto expect = [](const std::optional<std::string>& own,
                         const std::optional<std::string>& xdg,
                         const std::optional<std::string>& home, const std::string& directory) {
    kept_environment::set("POLHODE_CACHE", own);
    kept_environment::set("XDG_CACHE_HOME", xdg);
    kept_environment::set("HOME", home);
    EXPECT_EQ(node_cache::directory_of_user(), directory);
  };
  expect("/x/y", "/c", "/h", "/x/y");
  expect("off", "/c", "/h", "");
  expect("", "/c", "/h", "");
  expect("relative", "/c", "/h", "");
  expect({}, "/c", "/h", "/c/polhode");
  expect({}, {}, "/h", "/h/.cache/polhode");
  expect({}, "", "/h", "/h/.cache/polhode");
  expect({}, "relative", "/h", "/h/.cache/polhode");
  expect({}, {}, {}, "");
  expect({}, {}, "relative", "");
}

TEST(NodeCache, OfTheProcessIsAMemo) {
  const own_directory own;
  const kept_environment kept;
  kept_environment::set("POLHODE_CACHE", own.cache());
  const auto rule = gauss_legendre(11, 100);
  EXPECT_EQ(rule, gauss_legendre(11, 100));
  EXPECT_TRUE(same(*rule, make_gauss_legendre(11, 128)));
}

}  // namespace gauss_legendre_test
}  // namespace polhode
