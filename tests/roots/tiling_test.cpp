// An examination that lies about its pieces is refused: that is how a root is lost without a word.

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/interval.hpp"
#include "roots/settled_pieces.hpp"
#include "support/random.hpp"

namespace polhode {
namespace tiling_test {

using detail::exact_interval;
using detail::holds;
using detail::settled_pieces;
using support::random_source;
using support::repeat;

const rational tiny(1, integer(1) << 500);

bool is_whole(const exact_interval& whole, const std::vector<exact_interval>& pieces) {
  std::vector<const exact_interval*> pointers;
  for (const exact_interval& x : pieces) pointers.push_back(&x);
  return detail::is_tiling(whole, pointers);
}

exact_interval from(const rational& x) { return {x, std::nullopt}; }
exact_interval up_to(const rational& x) { return {std::nullopt, x}; }

TEST(Tiling, PiecesThatMakeUpTheWhole) {
  const exact_interval whole{0, 3};
  EXPECT_TRUE(is_whole(whole, {{0, 3}}));
  EXPECT_TRUE(is_whole(whole, {{2, 3}, {0, 1}, {1, 2}}));
  EXPECT_TRUE(is_whole(whole, {{0, 1}, {1, 1}, {1, 3}}));
  EXPECT_TRUE(is_whole({1, 1}, {{1, 1}}));
  EXPECT_TRUE(is_whole({std::nullopt, std::nullopt}, {from(1), up_to(-1), {-1, 1}}));
}

TEST(Tiling, LiesAreRefused) {
  const exact_interval whole{0, 3};
  EXPECT_FALSE(is_whole(whole, {}));
  EXPECT_FALSE(is_whole(whole, {{0, 1}, {1 + tiny, 3}}));           // a gap
  EXPECT_FALSE(is_whole(whole, {{0, 1}, {1 - tiny, 3}}));           // an overlap
  EXPECT_FALSE(is_whole(whole, {{0, 1}, {0, 1}, {1, 3}}));          // twice
  EXPECT_FALSE(is_whole(whole, {{0, 1}, {1, 1}, {1, 1}, {1, 3}}));  // a point twice
  EXPECT_FALSE(is_whole(whole, {{0, 3}, {1, 1}}));                  // a point of another piece
  EXPECT_FALSE(is_whole(whole, {{tiny, 3}}));                       // not from the beginning
  EXPECT_FALSE(is_whole(whole, {{0, 3 - tiny}}));                   // not to the end
  EXPECT_FALSE(is_whole(whole, {{-tiny, 3}}));                      // beyond it
  EXPECT_FALSE(is_whole(whole, {{0, 3 + tiny}}));
  EXPECT_FALSE(is_whole(whole, {{0, 3}, {3, 4}}));
  EXPECT_FALSE(is_whole(whole, {{0, 2}, {2, 1}, {1, 3}}));  // backwards
  EXPECT_FALSE(is_whole(whole, {{0, 4}, {4, 3}}));          // beyond it and back
  EXPECT_FALSE(is_whole(whole, {up_to(3)}));
  EXPECT_FALSE(is_whole(from(0), {{0, 3}}));
  EXPECT_FALSE(is_whole(from(0), {from(0), from(1)}));
  EXPECT_FALSE(is_whole({std::nullopt, std::nullopt}, {from(0), up_to(-tiny)}));
}

TEST(Tiling, RandomPiecesAndOneChange) {
  random_source random(1);
  for (repeat trial(300); trial.again();) {
    std::vector<rational> cuts;
    for (long k = random.between(2, 9); k > 0; --k) cuts.push_back(random.any_rational(40));
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    if (cuts.size() < 2) continue;
    std::vector<exact_interval> pieces;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) pieces.push_back({cuts[i], cuts[i + 1]});
    const exact_interval whole{cuts.front(), cuts.back()};
    std::swap(pieces.front(), pieces.back());
    EXPECT_TRUE(is_whole(whole, pieces));
    const auto at =
        static_cast<std::size_t>(random.between(0, static_cast<long>(pieces.size()) - 1));
    const rational by = random.one_in(2) ? tiny : rational(-tiny);
    std::vector<exact_interval> changed = pieces;
    switch (random.between(0, 3)) {
      case 0:
        *changed[at].lower += by;
        break;
      case 1:
        *changed[at].upper += by;
        break;
      case 2:
        changed.push_back(changed[at]);
        break;
      default:
        changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(at));
    }
    EXPECT_FALSE(is_whole(whole, changed));
  }
}

TEST(Tiling, WhatAProofIsAboutHoldsThePiece) {
  const ball x = from_end_points(rational(0), rational(1), 64);
  EXPECT_TRUE(holds(x, {0, 1}));
  EXPECT_FALSE(holds(x, {-tiny, 1}));
  EXPECT_FALSE(holds(x, {0, 1 + tiny}));
  EXPECT_FALSE(holds(x, from(0)));
  EXPECT_FALSE(holds(ball::undefined(64), {0, 1}));
  EXPECT_TRUE(holds(from(0).to_ball(64), from(rational(1, 3))));
  EXPECT_FALSE(holds(from(0).to_ball(64), up_to(3)));
  EXPECT_TRUE(holds(ball::entire(64), {std::nullopt, std::nullopt}));
  EXPECT_TRUE(holds(exact_interval{0, 1}, {0, 1}));
  EXPECT_TRUE(holds(from(0), {0, 1}));
  EXPECT_FALSE(holds(exact_interval{0, 1}, from(0)));
  EXPECT_FALSE(holds(exact_interval{0, 1}, {-tiny, 1}));
  random_source random(2);
  for (repeat trial(300); trial.again();) {
    rational a = random.any_rational(200);
    rational b = random.any_rational(200);
    if (b < a) std::swap(a, b);
    const precision p = random.any_precision();
    EXPECT_TRUE(holds(exact_interval{a, b}.to_ball(p), {a, b}));
    EXPECT_TRUE(holds(from(a).to_ball(p), {a, b}));
  }
}

TEST(SettledPieces, WithTheOpenOnesTheyAreTheWhole) {
  const exact_interval open{1, 2};
  const auto is_whole = [&](const settled_pieces& s, const std::vector<const exact_interval*>& rest,
                            std::size_t regions) {
    try {
      s.expect_whole(rest, regions);
      return true;
    } catch (const std::logic_error&) {
      return false;
    }
  };
  settled_pieces s({0, 4});
  EXPECT_FALSE(is_whole(s, {}, 0));
  s.add_without_root({0, rational(1, 2)});
  s.add_without_root({rational(1, 2), 1});
  s.add_known({2, 3}, 0);
  s.add_without_root({3, 4});
  EXPECT_TRUE(is_whole(s, {&open}, 1));
  EXPECT_FALSE(is_whole(s, {&open}, 0));  // there is no such region
  EXPECT_FALSE(is_whole(s, {}, 1));
  EXPECT_FALSE(is_whole(s, {&open, &open}, 1));
  settled_pieces twice = s;
  twice.add_without_root({1, 2});
  EXPECT_TRUE(is_whole(twice, {}, 1));
  EXPECT_FALSE(is_whole(twice, {&open}, 1));
  twice.add_known({3, 4}, 0);
  EXPECT_FALSE(is_whole(twice, {}, 1));
}

TEST(BoxShares, AreOneTogether) {
  const auto is_all = [](const rational& settled, const std::vector<int>& open) {
    try {
      detail::expect_all_shares(settled, open);
      return true;
    } catch (const std::logic_error&) {
      return false;
    }
  };
  EXPECT_TRUE(is_all(0, {0}));
  EXPECT_TRUE(is_all(1, {}));
  EXPECT_TRUE(is_all(rational(1, 2), {2, 3, 3}));
  EXPECT_TRUE(is_all(1 - detail::share_of(600), {600}));
  EXPECT_FALSE(is_all(1, {600}));
  EXPECT_FALSE(is_all(1 - detail::share_of(600), {}));
  EXPECT_FALSE(is_all(0, {1}));
}

TEST(BoxShares, ACutThatLeavesSomethingOutIsRefused) {
  const auto box = [](const rational& a, const rational& b, const rational& c, const rational& d) {
    return std::vector{from_end_points(a, b, 64), from_end_points(c, d, 64)};
  };
  const auto is_cut = [&](const std::vector<ball>& left, const std::vector<ball>& right) {
    try {
      detail::expect_cut(box(0, 2, 0, 2), left, right);
      return true;
    } catch (const std::logic_error&) {
      return false;
    }
  };
  const rational little(1, 1L << 40);
  EXPECT_TRUE(is_cut(box(0, 1, 0, 2), box(1, 2, 0, 2)));
  EXPECT_TRUE(is_cut(box(0, 2, 0, 1), box(0, 2, 1, 2)));
  EXPECT_TRUE(is_cut(box(0, 1 + little, 0, 2), box(1, 2, 0, 2)));  // rounded outward
  EXPECT_FALSE(is_cut(box(0, 1 - little, 0, 2), box(1, 2, 0, 2)));
  EXPECT_FALSE(is_cut(box(little, 1, 0, 2), box(1, 2, 0, 2)));
  EXPECT_FALSE(is_cut(box(0, 1, 0, 2), box(1, 2 - little, 0, 2)));
  EXPECT_FALSE(is_cut(box(0, 1, 0, 2 - little), box(1, 2, 0, 2)));
  EXPECT_FALSE(is_cut(box(0, 1, 0, 1), box(1, 2, 1, 2)));  // two corners are left out
  EXPECT_FALSE(is_cut({}, {}));
}

TEST(BoxShares, ACutOfAnInfiniteSideThatLeavesSomethingOutIsRefused) {
  using side = std::optional<rational>;
  const auto box = [](const side& a, const side& b) {
    return std::vector{exact_interval{a, b}.to_ball(64),
                       from_end_points(rational(0), rational(1), 64)};
  };
  const auto is_cut = [](const std::vector<ball>& whole, const std::vector<ball>& left,
                         const std::vector<ball>& right) {
    try {
      detail::expect_cut(whole, left, right);
      return true;
    } catch (const std::logic_error&) {
      return false;
    }
  };
  const side none;
  EXPECT_TRUE(is_cut(box(none, none), box(none, 0), box(0, none)));
  EXPECT_TRUE(is_cut(box(-5, none), box(-5, 1024), box(1024, none)));
  EXPECT_TRUE(is_cut(box(none, -5), box(none, -1024), box(-1024, -5)));
  EXPECT_FALSE(is_cut(box(none, none), box(none, 0), box(1, none)));
  EXPECT_FALSE(is_cut(box(none, none), box(-9, 0), box(0, none)));
  EXPECT_FALSE(is_cut(box(none, none), box(none, 0), box(0, 9)));
  EXPECT_FALSE(is_cut(box(-5, none), box(-4, 1024), box(1024, none)));
  EXPECT_FALSE(is_cut(box(none, none), box(0, none), box(none, 0)));
}

}  // namespace tiling_test
}  // namespace polhode
