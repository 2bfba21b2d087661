// Bodies with irrational principal moments: beside rational bodies that are near them, and where
// what is asked is decided exactly.

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/curve_motions.hpp"
#include "polhode/rigid_body/inertia_tensor.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "support/random.hpp"

namespace polhode {
namespace irrational_body_test {

using support::random_source;
using support::repeat;

/// The rational number of so many bits next to x.
rational near(const exact_real& x) { return lower_rational(x.at(400).middle()); }

/// The body with a and b as rational numbers, to 400 bits.
body beside(const body& rigid) { return {near(rigid.a()), near(rigid.b())}; }

/// Equal to 2^-bits of the size; both have more.
void expect_equal(const ball& x, const ball& y, long bits, const char* what) {
  ASSERT_TRUE(x.is_bounded() && y.is_bounded()) << what;
  EXPECT_TRUE((x - y).magnitude_upper() <= scale(y.magnitude_upper(), -bits))
      << what << ": " << x << " and " << y;
}

/// A tensor that is positive definite, or nothing; sizes and near-symmetries of all kinds.
std::optional<body> drawn(random_source& random) {
  const auto entry = [&](long most) { return rational(random.between(-most, most), 1000); };
  const rational unit(1, random.one_in(3) ? 1'000'000'000 : 1);
  const rational small(1, random.one_in(3) ? 1'000'000 : 1);
  const rational x(2 + entry(900));
  const rational y(random.one_in(4) ? rational(x + small / 7) : rational(2 + entry(900)));
  const rational z(2 + entry(900));
  try {
    const body rigid =
        body::from_inertia_tensor({unit * x, unit * y, unit * z, unit * small * entry(900),
                                   unit * entry(900), unit * small * entry(900)});
    if (rigid.irrational_tensor()) return rigid;
  } catch (const input_error&) {  // not positive definite, or symmetric
  }
  return std::nullopt;
}

TEST(IrrationalBody, HasTheNumbersOfRationalBodiesBesideIt) {
  random_source random(391);
  int compared = 0;
  for (repeat trial(60); trial.again();) {
    const auto rigid = drawn(random);
    if (!rigid) continue;
    ++compared;
    const body other = beside(*rigid);
    expect_equal(rigid->geometric_constant(200), other.geometric_constant(200), 190, "I");
    expect_equal(rigid->second_geometric_constant(200), other.second_geometric_constant(200), 190,
                 "J");
    EXPECT_EQ(rigid->kind(), other.kind());
    EXPECT_EQ(meeting_count(*rigid), meeting_count(other));
    EXPECT_EQ(has_perfect_twist(*rigid), has_perfect_twist(other));
    EXPECT_EQ(has_full_turn(*rigid), has_full_turn(other));
    const rational a = rational_below(rigid->a(), 16);
    const rational b = rational_below(rigid->b(), 16);
    for (const rational& c : {rational(-b * 999 / 1000), rational(-b / 3), rational(-b / 1'000'000),
                              rational(a / 1000), rational(a * 999 / 1000)}) {
      EXPECT_EQ(regime_of(*rigid, c), regime_of(other, c));
      expect_equal(montgomery_phase(*rigid, c, 200), montgomery_phase(other, c, 200), 150, "phase");
      expect_equal(rotation_period(*rigid, c, 200), rotation_period(other, c, 200), 150, "period");
      expect_equal(geometric_phase(*rigid, c, 200), geometric_phase(other, c, 200), 120, "parts");
      expect_equal(montgomery_phase_excess_to_digits(*rigid, c, 30).enclosure,
                   montgomery_phase_excess_to_digits(other, c, 30).enclosure, 90, "excess");
      const twist x = twist_to_digits(*rigid, c, 30);
      const twist y = twist_to_digits(other, c, 30);
      ASSERT_EQ(x.verdict, status::certified);
      EXPECT_EQ(x.branch, y.branch);
      expect_equal(x.epsilon, y.epsilon, 90, "epsilon");
      expect_equal(x.slope, y.slope, 90, "slope");
    }
    EXPECT_THROW((void)regime_of(*rigid, rational(a * 2)), input_error);
    EXPECT_THROW((void)regime_of(*rigid, rational(-b * 2)), input_error);
    expect_equal(separatrix_defect_to_digits(*rigid, 30).enclosure,
                 separatrix_defect_to_digits(other, 30).enclosure, 90, "epsilon0");
    if (has_perfect_twist(other)) {
      expect_equal(perfect_twist_to_digits(*rigid, 30).enclosure,
                   perfect_twist_to_digits(other, 30).enclosure, 90, "c0");
    }
    if (has_full_turn(other)) {
      expect_equal(full_turn_to_digits(*rigid, 30).enclosure,
                   full_turn_to_digits(other, 30).enclosure, 90, "full turn");
    }
    for (integer m = 1; m <= std::min(meeting_count(other), integer(4)); ++m) {
      const meeting x = meeting_to_digits(*rigid, m, 30);
      ASSERT_EQ(x.verdict, status::certified);
      expect_equal(x.c, meeting_to_digits(other, m, 30).c, 90, "meeting");
    }
  }
  EXPECT_GT(compared, 20 * support::effort());
}

/// The tensor with the moment m in its own axis, and beside it the block [[p, r], [r, q]].
body with_block(const rational& m, const rational& p, const rational& q, const rational& r) {
  const body result = body::from_inertia_tensor({m, p, q, 0, 0, r});
  EXPECT_TRUE(result.irrational_tensor());
  return result;
}

TEST(IrrationalBody, IsDecidedWhereTheConstantsAreRational) {
  // x = 3, and y, z = (5/2 -+ sqrt(29/20))/2: I = 2/3, so that m = 3 is a limit and no meeting.
  const body limit = with_block(3, rational(37, 20), rational(13, 20), rational(1, 20));
  EXPECT_EQ(limit.square_of_geometric_constant().as_rational(), rational(4, 9));
  EXPECT_EQ(limit.exact_geometric_constant(), rational(2, 3));
  EXPECT_FALSE(limit.square_of_second_constant().is_rational());
  EXPECT_EQ(meeting_count(limit), 2);
  EXPECT_EQ(intersection_count(limit), 1);
  EXPECT_EQ(meeting_to_digits(limit, 3, 10).why, reason::refuted);
  EXPECT_EQ(limit.kind(), body_kind::non_physical);
  // A hair beside it no moment is rational, and 4/I^2 is above 9 by some 10^-60.
  const rational hair = rational(1) / integer("1" + std::string(30, '0'));
  const body above =
      body::from_inertia_tensor({3, rational(37, 20), rational(13, 20), hair, 0, rational(1, 20)});
  EXPECT_FALSE(above.square_of_geometric_constant().is_rational());
  EXPECT_EQ(meeting_count(above), 3);
  EXPECT_EQ(meeting_count(beside(above)), 3);
  // z = 1, and x, y = 4 -+ sqrt(65/8): J = 2, and there is no perfect twist.
  const body no_twist = with_block(1, rational(27, 4), rational(5, 4), rational(3, 4));
  EXPECT_EQ(no_twist.square_of_second_constant().as_rational(), rational(9));
  EXPECT_EQ(no_twist.exact_second_geometric_constant(), rational(2));
  EXPECT_FALSE(no_twist.square_of_geometric_constant().is_rational());
  EXPECT_FALSE(has_perfect_twist(no_twist));
  EXPECT_TRUE(has_perfect_twist(with_block(1, rational(27, 4), rational(5, 4), rational(7, 8))) !=
              has_perfect_twist(with_block(1, rational(27, 4), rational(5, 4), rational(5, 8))));
  // y = 3, and x, z = 2 -+ sqrt 2: I^2 = (J + 1)^2 = 3/2.
  const body both = with_block(3, 3, 1, 1);
  EXPECT_EQ(both.square_of_geometric_constant().as_rational(), rational(3, 2));
  EXPECT_EQ(both.square_of_second_constant().as_rational(), rational(3, 2));
  EXPECT_FALSE(both.exact_geometric_constant());
  // y = 1 with the same x, z: a = b, and the curve's motions are within -b and a all the same.
  const body equal = with_block(1, 3, 1, 1);
  EXPECT_FALSE((equal.a() - equal.b()).at(64).is_bounded());
  const std::vector<rational> motions = curve_motions(equal, {}, 5);
  ASSERT_EQ(motions.size(), 5U);
  for (const rational& c : motions) EXPECT_NO_THROW((void)regime_of(equal, c));
  // Planar: I = 1, no crossing and one meeting.
  const body planar = with_block(5, 2, 3, 1);
  EXPECT_EQ(planar.kind(), body_kind::planar);
  EXPECT_EQ(planar.exact_geometric_constant(), rational(1));
  EXPECT_EQ(meeting_count(planar), 1);
  EXPECT_TRUE(is_injective(planar));
  // Each constant that is said to be rational is the one that balls enclose.
  for (const body& rigid : {limit, no_twist, both, planar}) {
    const body other = beside(rigid);
    expect_equal(rigid.square_of_geometric_constant().at(300),
                 other.square_of_geometric_constant().at(300), 290, "I^2");
    expect_equal(rigid.square_of_second_constant().at(300),
                 other.square_of_second_constant().at(300), 290, "(J+1)^2");
  }
}

TEST(IrrationalBody, OfTensorsWithOneRationalMomentHasTheRationalSquaresThatBallsSuggest) {
  random_source random(392);
  int rational_ones = 0;
  for (repeat trial(400); trial.again();) {
    const auto small = [&] { return rational(random.between(1, 8)); };
    std::optional<body> rigid;
    try {
      rigid = body::from_inertia_tensor(
          {small(), small(), small(), 0, 0, rational(random.between(1, 3))});
    } catch (const input_error&) {
      continue;
    }
    if (!rigid->irrational_tensor()) continue;
    const body other = beside(*rigid);
    for (const auto& [mine, right] :
         {std::pair(rigid->square_of_geometric_constant(), other.square_of_geometric_constant()),
          std::pair(rigid->square_of_second_constant(), other.square_of_second_constant())}) {
      // A rational square here has a short denominator; others are away from all of these.
      constexpr long most = 2000;
      const ball x = right.at(400);
      bool seems_rational = false;
      for (long d = 1; d <= most && !seems_rational; ++d) {
        const ball n = x * d;
        const ball nearest = floor(n + rational(1, 2));
        seems_rational = (n - nearest).magnitude_upper() <= magnitude::power_of_two(-200);
      }
      EXPECT_EQ(mine.is_rational(), seems_rational) << x;
      if (mine.is_rational()) {
        ++rational_ones;
        expect_equal(mine.at(300), x, 290, "the square");
      }
    }
  }
  EXPECT_GT(rational_ones, 10 * support::effort());
}

TEST(IrrationalBody, OfExtremeSizes) {
  // Moments that differ by 10^-60 of their size, and a tensor in units of 10^-200.
  const rational hair = rational(1) / integer("1" + std::string(60, '0'));
  const rational unit = rational(1) / integer("1" + std::string(200, '0'));
  for (const body& rigid :
       {body::from_inertia_tensor({2, 2 + hair, 4, hair, 0, 0}),
        body::from_inertia_tensor({2 * unit, 3 * unit, 4 * unit, unit / 3, unit / 5, unit / 7})}) {
    const rational c(-rational_below(rigid.b(), 16) / 3);
    const certain_number phase = montgomery_phase_to_digits(rigid, c, 40);
    EXPECT_EQ(phase.verdict, status::certified);
    const certain_number bound = montgomery_phase_limit_to_digits(rigid, c, 40);
    EXPECT_TRUE(certainly_less(bound.enclosure, phase.enclosure));
    EXPECT_EQ(twist_to_digits(rigid, c, 20).verdict, status::certified);
  }
}

}  // namespace irrational_body_test
}  // namespace polhode
