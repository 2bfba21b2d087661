// The zeros of Legendre polynomials in fixed point with few limbs, against rules with so many bits
// that they are made in another way (proved_zero.cpp): that the sets hold the zeros, and that they
// are not much larger than they have to be.

#include "quadrature/rules/gauss_legendre/few_limbs/few_limbed_zeros.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/quadrature/gauss_legendre.hpp"
#include "quadrature/rules/gauss_legendre/proved_zero.hpp"
#include "support/random.hpp"

namespace polhode {
namespace legendre_zeros_test {

using detail::few_limbed_zeros;
using detail::legendre_shape;

struct known_zero {
  ball square;            // y
  ball size_of_slope;     // |q'(y)|
  std::uint64_t rounded;  // y in units of 2^-64, downward
};

/// Of q, increasing.
std::vector<known_zero> known_zeros(long n) {
  const gauss_legendre_rule rule = make_gauss_legendre(n, few_limbed_zeros::most_bits + 128);
  std::vector<known_zero> zeros;
  detail::mpfr_cell cell(64);
  for (std::size_t i = rule.n % 2 != 0 ? 1 : 0; i < rule.nodes.size(); ++i) {
    const ball y = square(rule.nodes[i]);
    // The weight is 2 / (4 y (1 - y) q'^2), and for odd n divided by y.
    ball square_of_slope = 1 / (2 * y * (1 - y) * rule.weights[i]);
    if (n % 2 != 0) square_of_slope /= y;
    mpfr_set_ui(cell.get(), 0, MPFR_RNDD);
    scale(y, 64).with_precision(64).midpoint(cell.get());
    zeros.push_back({y, sqrt(square_of_slope), mpfr_get_ui(cell.get(), MPFR_RNDD)});
  }
  return zeros;
}

/// A zero of q near Y/2^64 by a Taylor polynomial of balls, with terms for a zero within
/// 2^log2_reach; `at` are q and q' there.
std::optional<detail::legendre_zero> zero_by_taylor(
    const legendre_shape& s, std::uint64_t start,
    const detail::legendre::fixed_point_polynomial::values& at, double log2_reach, precision bits) {
  const auto series = detail::legendre::make_series(s, start, at, log2_reach, bits);
  return series ? detail::legendre::proved_zero(s, *series, bits) : std::nullopt;
}

/// |middle of x - y| / radius of x.
double share_of_radius(const ball& x, const ball& y) {
  const auto log2_of = [](const magnitude& m) {
    return m.is_zero()
               ? -1e9
               : std::log2(static_cast<double>(m.fraction())) + static_cast<double>(m.exponent());
  };
  return std::exp2(log2_of((x.middle() - y).magnitude_upper()) - log2_of(x.radius()));
}

struct shares {
  double of_square = 0;
  double of_slope = 0;
};

/// Looks for all zeros from starts that are off by up to 2^spread units of 2^-64.
shares expect_enclosures(long n, precision bits, int spread, const std::vector<known_zero>& zeros,
                         support::random_source& random) {
  const few_limbed_zeros finder(legendre_shape(n), bits);
  shares largest;
  for (const known_zero& known : zeros) {
    const std::uint64_t offset = random.bits() >> (64 - spread);
    const std::uint64_t start =
        random.bits() >> 63 != 0 ? known.rounded + offset : known.rounded - offset;
    const auto found = finder.near(start);
    EXPECT_TRUE(found) << n << " " << bits << " " << start;
    if (!found) continue;
    EXPECT_TRUE(contains(found->square, known.square)) << n << " " << bits;
    const ball slope = abs(found->slope / found->scale);
    EXPECT_TRUE(contains(slope, known.size_of_slope)) << n << " " << bits;
    // The set is small: of a few units for each term of the polynomial, or what the search was
    // asked for.
    EXPECT_TRUE(found->square.radius() <=
                magnitude::power_of_two(9 + 2 * static_cast<long>(std::log2(n)) - bits))
        << n << " " << bits;
    largest.of_square = std::max(largest.of_square, share_of_radius(found->square, known.square));
    largest.of_slope = std::max(
        largest.of_slope, share_of_radius(abs(found->slope), known.size_of_slope * found->scale));
  }
  return largest;
}

TEST(LegendreZeros, AreEnclosedFromNearbyStarts) {
  support::random_source random(11);
  for (const long n : {2L, 3L, 4L, 5L, 6L, 7L, 20L, 33L, 64L, 105L, 160L, 301L}) {
    const std::vector<known_zero> zeros = known_zeros(n);
    for (const precision bits : {1L, 128L, 162L, 229L, 424L, 640L, 1024L}) {
      for (const int spread : {1, 6, 9}) expect_enclosures(n, bits, spread, zeros, random);
    }
  }
}

TEST(LegendreZeros, AreEnclosedInSetsThatAreHardlyTooLarge) {
  support::random_source random(12);
  double greatest_when_searched = 0;
  double greatest_when_rounded = 0;
  double greatest_of_slope = 0;
  for (const long n : {40L, 81L, 160L}) {
    const std::vector<known_zero> zeros = known_zeros(n);
    // Where the search ends early, what is left is the radius; where it ends at the last bit,
    // Horner's scheme.
    for (const precision bits : {135L, 150L, 152L, 155L, 160L, 216L, 408L}) {
      greatest_when_searched =
          std::max(greatest_when_searched, expect_enclosures(n, bits, 9, zeros, random).of_square);
    }
    for (const precision bits : {128L, 192L, 384L}) {
      const shares found = expect_enclosures(n, bits, 9, zeros, random);
      greatest_when_rounded = std::max(greatest_when_rounded, found.of_square);
      greatest_of_slope = std::max(greatest_of_slope, found.of_slope);
    }
  }
  EXPECT_GT(greatest_when_searched, 0.9);
  EXPECT_GT(greatest_when_rounded, 0.3);
  EXPECT_GT(greatest_of_slope, 0.05);
}

// Why no test fails without E_0 and E_1, the errors of Horner's scheme (see "How generous that is"
// in few_limbed_zeros.cpp): at the zeros of every q they are less than what the other counts have
// to spare. With an effort of 10 for all n.
TEST(LegendreZeros, HideTheErrorsOfHornersScheme) {
  support::random_source random(16);
  detail::mpfr_cell cell(64);
  const auto to_double = [&](const ball& x) {
    x.midpoint(cell.get());
    return mpfr_get_d(cell.get(), MPFR_RNDN);
  };
  for (long n = 2; n <= few_limbed_zeros::greatest_n; ++n) {
    if (n > 60 && n != 130 && support::effort() < 10 && !random.one_in(50)) continue;
    const legendre_shape s(n);
    const gauss_legendre_rule rule = make_gauss_legendre(n, 64);
    const auto degree = static_cast<double>(n);
    const auto e = static_cast<double>(s.odd);
    const double c = n <= 128 ? 1 : 2;  // F is at least 128
    for (std::size_t i = rule.n % 2 != 0 ? 1 : 0; i < rule.nodes.size(); ++i) {
      const double x = to_double(rule.nodes[i]);
      const double y = x * x;
      // 1 / (2 y (1 - y) weight), and for odd n divided by y
      double slope = 1 / std::sqrt(2 * (1 - y) * to_double(rule.weights[i])) / x;
      if (s.odd != 0) slope /= x;
      double of_value = c - 1;
      double of_slope = 0;
      for (long j = s.degree - 1; j >= 0; --j) {
        of_slope = of_slope * y + of_value + (j == s.degree - 1 ? 0 : 1);
        of_value = of_value * y + c;
      }
      EXPECT_LT((of_value - 1.98) / slope, 0.95 * (1 - 1 / degree)) << n << " " << y;
      const double bend = std::abs(2 + 4 * e - (6 + 4 * e) * y) / degree;
      const auto counted = static_cast<double>(2 * (s.degree + 1));
      EXPECT_LT(of_slope * 4 * y * (1 - y) / degree + 1 / degree,
                0.9 + (counted + 1.98 - of_value) * bend)
          << n << " " << y;
    }
  }
}

// With rounded coefficients and next to y = 1, where no error is made smaller by the steps after
// it, Horner's scheme is off by half of its bounds on average: so where these are halved they are
// exceeded every other time. Near the last place where q' = 0 both numbers are below 1, so that
// balls add no roundings of their own.
TEST(LegendreZeros, HaveValuesAndSlopesThatAreOffByMoreThanHalfTheirBounds) {
  support::random_source random(17);
  double greatest_of_value = 0;
  double greatest_of_slope = 0;
  for (support::repeat trial(60); trial.again();) {
    const long n = random.between(40, 160);
    const legendre_shape s(n);
    const auto degree = static_cast<double>(n);
    const double angle = 3.8317059702 / (degree + 0.5);  // the zero of the Bessel function J_1
    const double y = std::cos(angle) * std::cos(angle);
    std::vector<std::uint64_t> starts;
    for (int k = 0; k < 12; ++k) {
      const double offset = static_cast<double>(random.between(-1000, 1000)) / 100;
      starts.push_back(static_cast<std::uint64_t>(
          std::ldexp(y + offset / (degree * degree * degree * degree), 64)));
    }
    // The coefficients have about n bits behind the point.
    const precision few = random.between(n / 2, n - 12);
    const auto rough = detail::legendre::fixed_point_polynomial(s, few).at(starts);
    const auto exact =
        detail::legendre::fixed_point_polynomial(s, n + 64 * (s.degree + 1)).at(starts);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      EXPECT_TRUE(contains(rough[i].value, exact[i].value)) << n << " " << few << " " << starts[i];
      EXPECT_TRUE(contains(rough[i].slope, exact[i].slope)) << n << " " << few << " " << starts[i];
      greatest_of_value =
          std::max(greatest_of_value, share_of_radius(rough[i].value, exact[i].value));
      greatest_of_slope =
          std::max(greatest_of_slope, share_of_radius(rough[i].slope, exact[i].slope));
    }
  }
  EXPECT_GT(greatest_of_value, 0.5);
  EXPECT_GT(greatest_of_slope, 0.5);
}

// Of Taylor polynomials with too few terms what they leave out is the greatest error: the zero is
// enclosed all the same, or not found.
TEST(LegendreZeros, AreEnclosedByTaylorPolynomialsOfLowOrder) {
  support::random_source random(18);
  long found_few = 0;
  long refused_few = 0;
  double greatest_of_square = 0;
  double greatest_of_slope = 0;
  for (const long n : {8L, 13L, 40L, 61L}) {
    const std::vector<known_zero> zeros = known_zeros(n);
    const legendre_shape shape(n);
    for (long order = 1; order <= 3; ++order) {
      for (const precision bits : {128L, 192L}) {
        const few_limbed_zeros finder(shape, bits, order);
        // With balls, as many terms as a zero that is so near would need.
        const detail::legendre::fixed_point_polynomial values(shape, bits);
        const double log2_reach = -static_cast<double>(bits + 100) / static_cast<double>(order);
        for (const known_zero& known : zeros) {
          const std::uint64_t offset = (random.bits() | 1) >> random.between(36, 63);
          const std::uint64_t start = known.rounded + offset;
          const auto check = [&](const detail::legendre_zero& zero, const char* how) {
            EXPECT_TRUE(contains(zero.square, known.square))
                << how << n << " " << order << " " << offset;
            EXPECT_TRUE(contains(abs(zero.slope / zero.scale), known.size_of_slope))
                << how << n << " " << order << " " << offset;
          };
          const auto by_integers = finder.near(start);
          if (by_integers) check(*by_integers, "in integers ");
          ++(by_integers ? found_few : refused_few);
          const auto by_balls =
              zero_by_taylor(shape, start, values.at({start}).front(), log2_reach, bits);
          if (!by_balls) continue;
          check(*by_balls, "in balls ");
          greatest_of_square =
              std::max(greatest_of_square, share_of_radius(by_balls->square, known.square));
          greatest_of_slope = std::max(
              greatest_of_slope,
              share_of_radius(abs(by_balls->slope), known.size_of_slope * by_balls->scale));
        }
      }
    }
  }
  EXPECT_GT(found_few, 50);
  EXPECT_GT(refused_few, 50);
  EXPECT_GT(greatest_of_square, 0.02);
  EXPECT_GT(greatest_of_slope, 0.02);
}

TEST(LegendreZeros, CoefficientsAreRoundedDownwardAndHaveRoom) {
  // From P_n(x) = 2^-n sum of (-1)^k C(n, k) C(2n - 2k, n) x^(n-2k), each by itself.
  support::random_source random(14);
  for (support::repeat trial(6); trial.again();) {
    const long n = random.between(1, few_limbed_zeros::greatest_n);
    const precision bits = random.one_in(2) ? 64 * random.between(2, 16) : random.between(83, 4000);
    const legendre_shape shape(n);
    const detail::legendre_coefficients all(shape, bits);
    const auto size = static_cast<std::size_t>(all.size);
    ASSERT_EQ(all.limbs.size(), size * static_cast<std::size_t>(shape.degree + 1));
    const auto last = static_cast<std::size_t>(64 * all.size);
    const integer one = 1;
    integer sum = 0;
    integer weighted_sum = 0;
    for (long k = 0; k <= shape.degree; ++k) {
      integer a;
      integer b;
      mpz_bin_uiui(a.backend().data(), static_cast<unsigned long>(n),
                   static_cast<unsigned long>(k));
      mpz_bin_uiui(b.backend().data(), static_cast<unsigned long>(2 * n - 2 * k),
                   static_cast<unsigned long>(n));
      a *= b;
      if (k % 2 != 0) a = -a;
      a <<= static_cast<unsigned>(bits);
      mpz_fdiv_q_2exp(a.backend().data(), a.backend().data(), static_cast<unsigned long>(n));
      integer found;
      mpz_import(found.backend().data(), size, -1, sizeof(mp_limb_t), 0, 0,
                 all.limbs.data() + static_cast<std::size_t>(k) * size);
      if (mpz_tstbit(found.backend().data(), last - 1) != 0) found -= one << last;
      EXPECT_EQ(found, a) << n << " " << bits << " " << k;
      const integer magnitude_up = abs(a) + 1;
      sum += magnitude_up;
      weighted_sum += magnitude_up * (shape.degree - k);
    }
    const integer room = one << (last - 3);
    EXPECT_LE(sum, room) << n << " " << bits;
    EXPECT_LE(weighted_sum, room) << n << " " << bits;
  }
}

TEST(LegendreZeros, AreEnclosedForRandomDegreesBitsAndStarts) {
  support::random_source random(15);
  for (support::repeat trial(4); trial.again();) {
    const long n = random.one_in(8) ? random.between(300, few_limbed_zeros::greatest_n)
                                    : random.between(2, 200);
    const std::vector<known_zero> zeros = known_zeros(n);
    for (int k = 0; k < 6; ++k) {
      const precision bits = random.between(1, few_limbed_zeros::most_bits);
      // In units of y/n^2, the distance of the zeros next to 0, a start of a large n is soon too
      // far off.
      const int spread = static_cast<int>(random.between(1, n > 150 ? 1 : 9));
      expect_enclosures(n, bits, spread, zeros, random);
    }
  }
}

TEST(LegendreZeros, AreNotInventedFromBadStarts) {
  // From anywhere: nothing, or a set that holds one of the zeros.
  support::random_source random(13);
  for (const long n : {2L, 3L, 8L, 25L, 60L, 150L}) {
    const std::vector<known_zero> zeros = known_zeros(n);
    const few_limbed_zeros finder(legendre_shape(n), 192);
    EXPECT_FALSE(finder.near(0));
    const auto check = [&](std::uint64_t start) {
      const auto found = finder.near(start);
      if (!found) return;
      const bool holds_one = std::any_of(zeros.begin(), zeros.end(), [&](const known_zero& known) {
        return contains(found->square, known.square);
      });
      EXPECT_TRUE(holds_one) << n << " " << start;
    };
    for (const std::uint64_t start :
         {std::uint64_t{1}, ~std::uint64_t{0}, std::uint64_t{1} << 63}) {
      check(start);
    }
    for (int trial = 0; trial < 200; ++trial) {
      check(random.bits());
      const known_zero& known = zeros[random.bits() % zeros.size()];
      check(known.rounded + (random.bits() >> (8 + random.bits() % 48)));
    }
  }
}

}  // namespace legendre_zeros_test
}  // namespace polhode
