// Boxes of bodies: members drawn inside must have what is said of the box, and the ends of the
// ranges must be nearly attained.

#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/body_box.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "polhode/rigid_body/twist_curve.hpp"
#include "support/random.hpp"

namespace polhode {
namespace body_box_test {

using support::random_source;
using support::repeat;

rational number_between(random_source& random, const rational& low, const rational& high) {
  // The ends are drawn often: a range that leaves one out is found there.
  if (random.one_in(4)) return random.one_in(2) ? low : high;
  return low + (high - low) * rational(random.between(0, 1000), 1000);
}

/// From near 0 to near 1, or far above it for a.
rational any_size(random_source& random, long decades) {
  const rational digits(random.between(100, 999), 1000);
  const long exponent = random.between(-3, decades);
  rational result = digits;
  for (long k = 0; k < (exponent < 0 ? -exponent : exponent); ++k) {
    result = exponent < 0 ? rational(result / 10) : rational(result * 10);
  }
  return result;
}

rational_range wider(random_source& random, const rational& low, const rational& most) {
  const rational part(random.between(0, 50), random.one_in(2) ? 100 : 100000);
  return {low, std::min(rational(low * (1 + part)), most)};
}

body_box any_box(random_source& random) {
  return {wider(random, any_size(random, 2), 10000),
          wider(random, any_size(random, 0), rational(999, 1000))};
}

body member(random_source& random, const body_box& box) {
  return {number_between(random, box.a().low, box.a().high),
          number_between(random, box.b().low, box.b().high)};
}

TEST(BodyBox, HoldsForEveryMember) {
  random_source random(411);
  for (repeat trial(300); trial.again();) {
    const body_box box = any_box(random);
    const body_kind kind = box.kind();
    const auto meetings = box.meeting_count();
    const auto intersections = box.intersection_count();
    const auto injective = box.is_injective();
    const auto twist = box.has_perfect_twist();
    const auto turn = box.has_full_turn();
    for (int k = 0; k < 6; ++k) {
      const body rigid = member(random, box);
      const bool is_physical = rigid.kind() != body_kind::non_physical;
      EXPECT_TRUE(kind == body_kind::undecided || is_physical == (kind != body_kind::non_physical));
      EXPECT_EQ(meeting_count(rigid), meetings.value_or(meeting_count(rigid)));
      EXPECT_EQ(intersection_count(rigid), intersections.value_or(intersection_count(rigid)));
      EXPECT_EQ(is_injective(rigid), injective.value_or(is_injective(rigid)));
      EXPECT_EQ(has_perfect_twist(rigid), twist.value_or(has_perfect_twist(rigid)));
      EXPECT_EQ(has_full_turn(rigid), turn.value_or(has_full_turn(rigid)));
      EXPECT_TRUE(contains(box.geometric_constant(100), rigid.geometric_constant(300).middle()));
      EXPECT_TRUE(contains(box.second_geometric_constant(100),
                           rigid.second_geometric_constant(300).middle()));
    }
  }
}

TEST(BodyBox, IsDecidedUnlessItsCornersDiffer) {
  // ab + 2b = 1 at a = 2, b = 1/4.
  const rational b(1, 4);
  EXPECT_EQ(body_box({1, 2}, {rational(1, 8), b}).kind(), body_kind::physical);
  EXPECT_EQ(body_box({2, 2}, {b, b}).kind(), body_kind::planar);
  EXPECT_EQ(body_box({1, rational(21, 10)}, {b, b}).kind(), body_kind::undecided);
  EXPECT_EQ(body_box({rational(21, 10), 3}, {b, b}).kind(), body_kind::non_physical);
  EXPECT_EQ(body_box({2, 3}, {b, b}).kind(), body_kind::undecided);
  EXPECT_EQ(body_box({1, rational(21, 10)}, {b, b}).is_injective(), std::nullopt);
  EXPECT_EQ(body_box({1, 2}, {b, b}).is_injective(), true);
  // J = 2 where (a+1)^2 = 9 a (a+b): with b = 1/8 between a = 0.11 and a = 1.
  EXPECT_EQ(body_box({rational(1, 10), 1}, {rational(1, 8), b}).has_perfect_twist(), std::nullopt);
  EXPECT_FALSE(body_box({rational(1, 10), 1}, {rational(1, 8), b}).perfect_twist(20).is_bounded());
  EXPECT_THROW(body_box({2, 1}, {b, b}), input_error);
  EXPECT_THROW(body_box({0, 1}, {b, b}), input_error);
  EXPECT_THROW(body_box({1, 2}, {b, 1}), input_error);
}

TEST(BodyBox, RangesHoldTheNumbersOfEveryMember) {
  random_source random(412);
  constexpr long digits = 20;
  int meetings = 0;
  for (repeat trial(60); trial.again();) {
    const body_box box = any_box(random);
    const ball epsilon0 = box.separatrix_defect(digits);
    const ball c0 = box.perfect_twist(digits);
    const ball turn = box.full_turn(digits);
    ASSERT_TRUE(epsilon0.is_bounded());
    EXPECT_EQ(c0.is_bounded(), box.has_perfect_twist() == true);
    EXPECT_EQ(turn.is_bounded(), box.has_full_turn() == true);
    const integer m = random.between(1, 3);
    const body_box::meeting_range met = box.meeting(m, digits);
    EXPECT_EQ(met.c.is_bounded(), m <= meeting_count(box.greatest()));
    meetings += met.c.is_bounded() ? 1 : 0;
    for (int k = 0; k < 3; ++k) {
      const body rigid = member(random, box);
      EXPECT_TRUE(overlaps(epsilon0, separatrix_defect_to_digits(rigid, 30).enclosure));
      if (c0.is_bounded()) {
        EXPECT_TRUE(overlaps(c0, perfect_twist_to_digits(rigid, 30).enclosure));
      }
      if (turn.is_bounded()) {
        EXPECT_TRUE(overlaps(turn, full_turn_to_digits(rigid, 30).enclosure));
      }
      if (met.c.is_bounded()) {
        const meeting one = meeting_to_digits(rigid, m, 30);
        EXPECT_TRUE(overlaps(met.c, one.c));
        EXPECT_TRUE(m % 2 == 0 || overlaps(met.epsilon, one.epsilon));
      }
    }
  }
  EXPECT_GT(meetings, 5 * support::effort());
}

TEST(BodyBox, RangesHoldTheNumbersOfEveryMotion) {
  random_source random(413);
  constexpr long digits = 20;
  int rotating = 0;
  int oscillating = 0;
  int twists = 0;
  for (repeat trial(200); trial.again();) {
    const body_box box = any_box(random);
    const bool rotates = random.one_in(2);
    const rational most = rotates ? box.a().high : box.b().high;
    const rational s = number_between(random, 0, most);
    const rational t = s + number_between(random, 0, most) / (random.one_in(2) ? 3 : 3000);
    const rational_range c = rotates ? rational_range{s, t} : rational_range{-t, -s};
    const ball period = box.period(c, 100);
    const ball phase = box.montgomery_phase(c, 100);
    const ball rate = box.mean_rate(c, 100);
    const ball twist = box.twist(c, digits);
    EXPECT_EQ(period.is_bounded(), phase.is_bounded());
    EXPECT_TRUE(s != 0 || !period.is_bounded());
    for (int k = 0; k < 4; ++k) {
      const body rigid = member(random, box);
      const rational at = number_between(random, c.low, c.high);
      if (!(at > -rigid.b().exact() && at < rigid.a().exact())) continue;
      if (at != 0) {
        if (s != 0) {
          ASSERT_TRUE(period.is_bounded());
        }
        EXPECT_TRUE(overlaps(period, rotation_period(rigid, at, 200)));
        EXPECT_TRUE(overlaps(phase, montgomery_phase(rigid, at, 200)));
        EXPECT_TRUE(
            overlaps(rate, montgomery_phase(rigid, at, 200) / rotation_period(rigid, at, 200)));
        ++(rotates ? rotating : oscillating);
      }
      if (twist.is_bounded()) {
        ++twists;
        const polhode::twist one = twist_to_digits(rigid, at, 30, with_slope::no);
        EXPECT_TRUE(overlaps(twist, one.epsilon))
            << rigid.a().at(60) << ' ' << rigid.b().at(60) << ' ' << at << ": " << twist << " "
            << one.epsilon;
      }
    }
  }
  EXPECT_GT(rotating, 50 * support::effort());
  EXPECT_GT(oscillating, 50 * support::effort());
  EXPECT_GT(twists, 50 * support::effort());
}

TEST(BodyBox, HasNoTwistWhereSomeMemberHasTurnedBack) {
  // epsilon(c) is enclosed where the phase of all members is above 4 pi. Towards the separatrix it
  // is above that first for the least a.
  const rational b(3, 10);
  const body_box box({rational(1, 2), 5}, {b, b});
  int least_only = 0;
  for (rational c = -b / 2; c < rational(-1, 1'000'000'000); c /= 2) {
    const bool least = certainly_less(4 * pi(100), montgomery_phase(box.least(), c, 100));
    const bool greatest = certainly_less(4 * pi(100), montgomery_phase(box.greatest(), c, 100));
    EXPECT_EQ(box.twist({c, c}, 15).is_bounded(), least && greatest) << c;
    if (least && !greatest) ++least_only;
  }
  EXPECT_GT(least_only, 2);
  EXPECT_TRUE(box.twist({rational(-1, 1'000'000'000), 0}, 15).is_bounded());
}

TEST(BodyBox, EndsAreAttained) {
  random_source random(414);
  for (repeat trial(40); trial.again();) {
    const body_box box = any_box(random);
    const body least(box.a().low, box.b().low);
    const body greatest(box.a().high, box.b().high);
    const rational c = box.a().low / 3;
    const rational more = c + box.a().low / 10;
    // The hull of two members is no smaller than the range but for the roundings.
    const auto expect_in = [](const ball& range, const ball& members) {
      EXPECT_TRUE(contains(members.enlarged(scale(members.magnitude_upper(), -60)), range))
          << range << members;
    };
    expect_in(box.montgomery_phase({c, more}, 100),
              hull(montgomery_phase(least, c, 200), montgomery_phase(greatest, more, 200)));
    expect_in(box.period({c, more}, 100),
              hull(rotation_period(least, c, 200), rotation_period(greatest, more, 200)));
    expect_in(box.separatrix_defect(30), hull(separatrix_defect_to_digits(least, 30).enclosure,
                                              separatrix_defect_to_digits(greatest, 30).enclosure));
    const rational high = -box.b().low / 5;
    const rational low = high * 2;
    expect_in(box.montgomery_phase({low, high}, 100),
              hull(montgomery_phase(least, high, 200), montgomery_phase(greatest, low, 200)));
    expect_in(box.period({low, high}, 100),
              hull(rotation_period(least, high, 200), rotation_period(greatest, low, 200)));
  }
}

TEST(BodyBox, OfMomentsHoldsEveryBody) {
  random_source random(415);
  for (repeat trial(200); trial.again();) {
    const auto range = [&](long from) {
      const rational low = from + rational(random.between(0, 400), 1000);
      return rational_range{low, low + rational(random.between(0, 400), 1000)};
    };
    const std::array<rational_range, 3> moments{range(3), range(2), range(1)};
    const body_box box = body_box::of_moments(moments);
    const auto [x, y, z] = moments;
    const body rigid = body::from_moments({number_between(random, x.low, x.high),
                                           number_between(random, y.low, y.high),
                                           number_between(random, z.low, z.high)});
    EXPECT_TRUE(box.a().low <= rigid.a().exact() && rigid.a().exact() <= box.a().high);
    EXPECT_TRUE(box.b().low <= rigid.b().exact() && rigid.b().exact() <= box.b().high);
  }
}

/// A cell of the limit, often across beta = 0 or a turning point.
struct limit_cell {
  rational_range chi, beta;
};
limit_cell any_limit(random_source& random) {
  const auto side = [&](const rational& low, const rational& high) {
    const rational from = low + (high - low) * rational(random.between(1, 999), 1000);
    const rational part(random.between(0, 400), random.one_in(2) ? 1000 : 1000000);
    return rational_range{from, std::min(rational(from + part), high)};
  };
  limit_cell cell{side(rational(1, 100), 2), side(rational(-999, 1000), rational(3, 2))};
  if (random.one_in(4)) cell.beta.high = std::max(cell.beta.low, rational(0));
  if (random.one_in(8)) cell.beta.low = std::min(cell.beta.high, rational(0));
  return cell;
}

TEST(LimitBox, RangesHoldTheDefectOfEveryMember) {
  random_source random(417);
  int bounded = 0;
  for (repeat trial(300); trial.again();) {
    const limit_cell cell = any_limit(random);
    const ball range = limit_defect_range(cell.chi, cell.beta, 20);
    if (!range.is_bounded()) {
      EXPECT_TRUE(cell.chi.high > 1 && cell.beta.low < 0);
      continue;
    }
    ++bounded;
    for (int k = 0; k < 6; ++k) {
      const rational chi = number_between(random, cell.chi.low, cell.chi.high);
      const rational beta = number_between(random, cell.beta.low, cell.beta.high);
      EXPECT_TRUE(overlaps(range, limit_defect_to_digits(chi, beta, 30).enclosure))
          << to_text(chi) << ' ' << to_text(beta);
    }
  }
  EXPECT_GT(bounded, 0);
}

TEST(LimitBox, EndsAreAttained) {
  const auto expect_ends = [](const limit_cell& cell, const ball& lower, const ball& upper) {
    const ball range = limit_defect_range(cell.chi, cell.beta, 30);
    const rational tiny = rational(1) / pow(integer(10), 25);
    EXPECT_LE(abs(rational(lower_rational(range) - lower_rational(lower))), tiny);
    EXPECT_LE(abs(rational(upper_rational(range) - upper_rational(upper))), tiny);
  };
  const auto at = [](const rational& chi, const rational& beta) {
    return limit_defect_to_digits(chi, beta, 40).enclosure;
  };
  const rational low(1, 10);
  // Before the turning point: xi = pi sqrt(chi) < K.
  expect_ends({{low, 1}, {0, 1}}, at(1, 1), at(low, 0));
  expect_ends({{low, rational(1, 5)}, {-low, low}}, at(rational(1, 5), low), at(low, -low));
  // Beyond it: at beta = -1/2 K = 1.854, so that xi > K from chi = 0.349 on.
  const rational half(-1, 2);
  expect_ends({{rational(1, 2), 1}, {rational(-3, 5), half}}, at(rational(1, 2), half),
              at(1, rational(-3, 5)));
  // Across it: the least defect is that of the turning point, arcsin sqrt(1/2).
  expect_ends({{rational(3, 10), rational(2, 5)}, {half, half}}, scale(pi(200), -2),
              at(rational(3, 10), half));
}

TEST(LimitBox, IsUndefinedWhereAMotionHasComeBack) {
  // 2 K(1/2) = 3.708: xi is that at chi = 1.393.
  const rational half(-1, 2);
  EXPECT_TRUE(limit_defect_range({1, rational(139, 100)}, {half, half}, 10).is_bounded());
  EXPECT_FALSE(limit_defect_range({1, rational(140, 100)}, {half, half}, 10).is_bounded());
  EXPECT_FALSE(
      limit_defect_range({1, rational(139, 100)}, {rational(-51, 100), 1}, 10).is_bounded());
  EXPECT_THROW((void)limit_defect_range({0, 1}, {0, 1}, 10), input_error);
  EXPECT_THROW((void)limit_defect_range({2, 1}, {0, 1}, 10), input_error);
  EXPECT_THROW((void)limit_defect_range({1, 2}, {1, 0}, 10), input_error);
  EXPECT_THROW((void)limit_defect_range({1, 2}, {-1, 1}, 10), input_error);
}

}  // namespace body_box_test
}  // namespace polhode
