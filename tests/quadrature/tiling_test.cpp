// That what was integrated makes up the range, each part of it once: rules that lie about their
// pieces are refused.

#include "tiling/tiling.hpp"

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "quadrature/pieces/segments.hpp"

namespace polhode::detail {
namespace tiling_test {

/// sqrt(2), to any precision.
end_point root_of_2() {
  return end_point([](precision p) { return sqrt(ball(2, p)); });
}
const piece_end lower = piece_end::lower_end();
const piece_end upper = piece_end::upper_end();

/// A rule for the integral of 1: it was given an interval, and says what it has done.
struct report {
  piece_done done;
  exact_interval within;
  rational length;
};

std::optional<ball> sum_of(const end_point& from, const end_point& to,
                           const std::vector<report>& reports) {
  tiled_sum<ball> sum(from, to, ball(0, 64));
  for (const report& r : reports) sum.add(r.done, r.within, ball(r.length, 64));
  return sum.total();
}

TEST(Tiling, AddsUpPiecesInAnyOrder) {
  const auto sum =
      sum_of(0, 3,
             {{{piece_end(2), piece_end(3)}, {2, rational(3)}, 1},
              {{piece_end(0), piece_end(rational(1, 3))}, {0, rational(1, 3)}, rational(1, 3)},
              {{piece_end(rational(1, 3)), piece_end(2)}, {0, rational(2)}, rational(5, 3)}});
  ASSERT_TRUE(sum);
  EXPECT_TRUE(contains(*sum, rational(3)));
}

TEST(Tiling, TakesAnExactEndByItsNameToo) {
  EXPECT_TRUE(sum_of(0, 1, {{{lower, upper}, {0, rational(1)}, 1}}));
  EXPECT_FALSE(sum_of(0, 1, {{{lower, upper}, {0, rational(9, 10)}, 1}}));
}

TEST(Tiling, RefusesAGap) {
  EXPECT_FALSE(sum_of(0, 3,
                      {{{piece_end(0), piece_end(1)}, {0, rational(1)}, 1},
                       {{piece_end(2), piece_end(3)}, {2, rational(3)}, 1}}));
  EXPECT_FALSE(sum_of(0, 3, {{{piece_end(1), piece_end(3)}, {1, rational(3)}, 2}}));
  EXPECT_FALSE(sum_of(0, 3, {{{piece_end(0), piece_end(2)}, {0, rational(2)}, 2}}));
  EXPECT_FALSE(sum_of(0, 3, {}));
}

TEST(Tiling, RefusesWhatIsDoneTwice) {
  const report left{{piece_end(0), piece_end(1)}, {0, rational(1)}, 1};
  const report right{{piece_end(1), piece_end(2)}, {1, rational(2)}, 1};
  EXPECT_TRUE(sum_of(0, 2, {left, right}));
  EXPECT_FALSE(sum_of(0, 2, {left, right, right}));
  EXPECT_FALSE(sum_of(0, 2, {left, right, {{piece_end(0), piece_end(2)}, {0, rational(2)}, 2}}));
  EXPECT_FALSE(sum_of(
      0, 2,
      {{{piece_end(0), piece_end(rational(3, 2))}, {0, rational(3, 2)}, rational(3, 2)}, right}));
}

TEST(Tiling, RefusesMoreThanTheRuleWasGiven) {
  EXPECT_FALSE(sum_of(0, 1, {{{piece_end(0), piece_end(1)}, {0, rational(1, 2)}, 1}}));
  EXPECT_FALSE(sum_of(0, 1, {{{piece_end(0), piece_end(1)}, {rational(1, 9), rational(1)}, 1}}));
}

// The fault that this is for: a rule says that it has stopped at an irrational end that is not in
// its interval.
TEST(Tiling, RefusesAnEndThatIsNotInTheInterval) {
  const rational near = parse_rational("1.41421356237309504880168872420969807856");
  const rational beyond = parse_rational("1.41421356237309504880168872420969807857");
  EXPECT_TRUE(sum_of(1, root_of_2(), {{{piece_end(1), upper}, {1, beyond}, 1}}));
  EXPECT_FALSE(sum_of(1, root_of_2(), {{{piece_end(1), upper}, {1, near}, 1}}));
  EXPECT_TRUE(sum_of(root_of_2(), 2, {{{lower, piece_end(2)}, {near, rational(2)}, 1}}));
  EXPECT_FALSE(sum_of(root_of_2(), 2, {{{lower, piece_end(2)}, {beyond, rational(2)}, 1}}));
  // With panels before it that it says were negligible.
  EXPECT_FALSE(sum_of(root_of_2(), 2,
                      {{{lower, piece_end(1)}, {0, rational(1)}, 0},
                       {{piece_end(1), piece_end(2)}, {1, rational(2)}, 1}}));
  EXPECT_FALSE(sum_of(root_of_2(), 2, {{{piece_end(1), piece_end(2)}, {1, rational(2)}, 1}}));
}

TEST(Tiling, IsNotDecidedWhereAnEndCannotBeTold) {
  // 1, which no enclosure tells from 1
  const end_point one(
      [](precision p) { return square(sin(ball(1, p))) + square(cos(ball(1, p))); });
  EXPECT_EQ(side_of(one, 1), std::nullopt);
  EXPECT_FALSE(sum_of(0, one, {{{piece_end(0), upper}, {0, rational(1)}, 1}}));
  EXPECT_TRUE(sum_of(0, one, {{{piece_end(0), upper}, {0, rational(2)}, 1}}));
}

TEST(Tiling, ReachesInfinityByAPieceWithoutAnUpperBound) {
  const report tail{{piece_end(5), upper}, {5, std::nullopt}, 0};
  EXPECT_TRUE(sum_of(0, end_point::infinity(),
                     {{{piece_end(0), piece_end(5)}, {0, rational(5)}, 5}, tail}));
  EXPECT_FALSE(sum_of(0, end_point::infinity(),
                      {{{piece_end(0), piece_end(5)}, {0, rational(5)}, 5},
                       {{piece_end(5), upper}, {5, parse_rational("1e100")}, 0}}));
}

// Pieces between points of which some are known by their enclosures only.

TEST(Tiling, KnowsALimitByItsCopies) {
  const end_point a = end_point([](precision p) { return sqrt(ball(2, p)); });
  const end_point same_value = end_point([](precision p) { return sqrt(ball(2, p)); });
  const end_point copy = a;
  EXPECT_TRUE(a.is_same_as(copy));
  EXPECT_FALSE(a.is_same_as(same_value));  // that they are equal is not known
  EXPECT_TRUE(end_point(rational(1, 2)).is_same_as(end_point(rational(2, 4))));
  EXPECT_FALSE(end_point(rational(1, 2)).is_same_as(end_point(rational(1, 3))));
  EXPECT_TRUE(end_point::pi(2).is_same_as(end_point::pi(2)));
  EXPECT_TRUE(end_point::infinity().is_same_as(end_point::infinity()));
  EXPECT_FALSE(end_point::infinity().is_same_as(-end_point::infinity()));
  EXPECT_FALSE(end_point::infinity().is_same_as(end_point(0)));
}

TEST(Tiling, OfPartsBetweenLimits) {
  const end_point a = -end_point::infinity();
  const end_point root = end_point([](precision p) { return sqrt(ball(2, p)); });
  const end_point other = end_point([](precision p) { return sqrt(ball(2, p)); });
  EXPECT_TRUE(is_tiled({{root, end_point(2)}, {a, root}}, a, 2));
  EXPECT_FALSE(is_tiled({{other, end_point(2)}, {a, root}}, a, 2));
  EXPECT_FALSE(is_tiled({{a, root}}, a, 2));
  EXPECT_FALSE(is_tiled({{root, end_point(2)}}, a, 2));
  EXPECT_FALSE(is_tiled({{root, end_point(2)}, {a, root}, {root, end_point(2)}}, a, 2));
  EXPECT_FALSE(is_tiled({{end_point(2), root}, {a, root}}, a, 2));  // run the wrong way
  EXPECT_FALSE(is_tiled({}, a, 2));
  EXPECT_FALSE(is_tiled({}, a, a));
}

}  // namespace tiling_test
}  // namespace polhode::detail
