// Systems of equations: every root once, and nothing claimed that is not proved.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/roots/systems.hpp"
#include "support/random.hpp"

namespace polhode {
namespace systems_test {

using support::random_source;
using support::repeat;

using ends = system_box;

/// Every region is a unique root, and the enclosures are apart.
void expect_roots(const system_root_set& s, std::size_t count) {
  EXPECT_TRUE(s.is_resolved());
  EXPECT_EQ(s.regions.size(), count) << s.account.boxes;
  for (std::size_t i = 0; i < s.regions.size(); ++i) {
    for (std::size_t j = i + 1; j < s.regions.size(); ++j) {
      bool apart = false;
      for (std::size_t k = 0; k < s.regions[i].enclosure.size(); ++k) {
        apart = apart || !overlaps(s.regions[i].enclosure[k], s.regions[j].enclosure[k]);
      }
      EXPECT_TRUE(apart) << i << " " << j;
    }
  }
}

/// Whether one of the regions, and only one, holds the point.
bool one_holds(const system_root_set& s, const std::vector<rational>& point) {
  const auto holding =
      std::count_if(s.regions.begin(), s.regions.end(), [&](const system_region& r) {
        for (std::size_t k = 0; k < point.size(); ++k) {
          if (!contains(r.enclosure[k], point[k])) return false;
        }
        return true;
      });
  return holding == 1;
}

TEST(SolveSystem, Himmelblau) {
  const auto f = [](const auto& x) {
    return std::vector{square(x[0]) + x[1] - 11, x[0] + square(x[1]) - 7};
  };
  const system_root_set s = solve_system(f, ends(2, {-5, 5}));
  expect_roots(s, 4);
  EXPECT_TRUE(one_holds(s, {3, 2}));
  for (const system_region& r : s.regions) {
    const refined_system_root q = refine(f, r, 500);
    EXPECT_EQ(q.verdict, status::certified);
    EXPECT_LE(q.evaluations_of_f, 12);
    EXPECT_TRUE(q.enclosure[0].radius() < magnitude::power_of_two(-1650));
    // x and y between their ends: both equations change their signs' enclosures around 0.
    EXPECT_TRUE(contains_zero(square(q.enclosure[0]) + q.enclosure[1] - 11));
    EXPECT_TRUE(contains_zero(q.enclosure[0] + square(q.enclosure[1]) - 7));
  }
}

TEST(SolveSystem, HimmelblausGradient) {
  // The stationary points of his function, 9 in [-5, 5]^2, 7 of them in the lesser box (C. Floudas
  // et al., Handbook of Test Problems in Local and Global Optimization, 1999, problem 14.1.1).
  const auto f = [](const auto& x) {
    return std::vector{4 * pow(x[0], 3) + 4 * x[0] * x[1] + 2 * square(x[1]) - 42 * x[0] - 14,
                       4 * pow(x[1], 3) + 2 * square(x[0]) + 4 * x[0] * x[1] - 26 * x[1] - 22};
  };
  const system_root_set s = solve_system(f, ends(2, {-5, 5}));
  expect_roots(s, 9);
  EXPECT_TRUE(one_holds(s, {3, 2}));
  expect_roots(solve_system(f, {{-5, rational(7, 2)}, {-3, 5}}), 7);
}

TEST(SolveSystem, Hansen) {
  // The gradient of the three-hump camel: (0, 0) and four more, x = 2 y with 6 x^4 - 25.2 x^2 + 21
  // = 0.
  const auto f = [](const auto& x) {
    return std::vector{6 * pow(x[0], 5) - rational(126, 5) * pow(x[0], 3) + 24 * x[0] - 6 * x[1],
                       12 * x[1] - 6 * x[0]};
  };
  const system_root_set s = solve_system(f, ends(2, {-10, 10}));
  expect_roots(s, 5);
  EXPECT_TRUE(one_holds(s, {0, 0}));
  for (const system_region& r : s.regions) {
    const std::vector<ball> x = refine(f, r, 50).enclosure;
    EXPECT_TRUE(contains_zero(x[0] * (6 * pow(x[0], 4) - rational(126, 5) * square(x[0]) + 21)));
  }
}

TEST(SolveSystem, BroydenTridiagonal) {
  const auto f = [](const auto& x) {
    auto r = x;
    for (std::size_t k = 0; k < x.size(); ++k) {
      r[k] = (3 - 2 * x[k]) * x[k] + 1;
      if (k > 0) r[k] = r[k] - x[k - 1];
      if (k + 1 < x.size()) r[k] = r[k] - 2 * x[k + 1];
    }
    return r;
  };
  expect_roots(solve_system(f, ends(4, {-2, 2})), 2);
  const system_root_set s = solve_system(f, ends(12, {-1, 0}));
  expect_roots(s, 1);
  // J. More, B. Garbow, K. Hillstrom (1981): x_1 = -0.5707 for n = 10 and beyond.
  EXPECT_EQ(to_decimal(refine(f, s.regions[0], 20).enclosure[0], 4), "-0.5707...");
}

TEST(SolveSystem, BroydenBanded) {
  const auto f = [](const auto& x) {
    auto r = x;
    const int n = static_cast<int>(x.size());
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      r[k] = x[k] * (2 + 5 * square(x[k])) + 1;
      for (int j = std::max(0, i - 5); j <= std::min(n - 1, i + 1); ++j) {
        const auto l = static_cast<std::size_t>(j);
        if (j != i) r[k] = r[k] - x[l] * (1 + x[l]);
      }
    }
    return r;
  };
  expect_roots(solve_system(f, ends(5, {-1, 1})), 1);
}

TEST(SolveSystem, BrownsAlmostLinear) {
  const auto f = [](const auto& x) {
    const long n = static_cast<long>(x.size());
    auto r = x;
    auto product = x[0];
    auto sum = x[0];
    for (std::size_t k = 1; k < x.size(); ++k) {
      product = product * x[k];
      sum = sum + x[k];
    }
    for (std::size_t k = 0; k + 1 < x.size(); ++k) r[k] = x[k] + sum - (n + 1);
    r[x.size() - 1] = product - 1;
    return r;
  };
  // x_1 = ... = x_(n-1) = a, a^(n-1) (n + 1 - n a) = 1: two roots a in [-2, 2] for n = 3, 4, with a
  // = 1 and x_n in [-2, 2].
  for (const std::size_t n : {std::size_t{3}, std::size_t{4}}) {
    const system_root_set s = solve_system(f, ends(n, {-2, 2}));
    expect_roots(s, 2);
    EXPECT_TRUE(one_holds(s, std::vector<rational>(n, 1)));
  }
}

TEST(SolveSystem, DoubleRootsOfOtherThanPolynomialsAreNotClaimed) {
  const auto f = [](const auto& x) {
    return std::vector{square(x[0]) + square(x[1]) - 2, exp(x[0] + x[1] - 2) - 1};
  };
  const system_root_set s = solve_system(f, ends(2, {-3, 3}));
  EXPECT_FALSE(s.is_resolved());
  EXPECT_TRUE(s.complete);
  ASSERT_EQ(s.regions.size(), 1U);
  EXPECT_EQ(s.regions[0].verdict, root_verdict::at_least_one);
  EXPECT_TRUE(one_holds(s, {1, 1}));
  EXPECT_TRUE(s.regions[0].enclosure[0].radius() < magnitude::power_of_two(-20));
}

TEST(SolveSystem, NoneAndTwoThatAreClose) {
  const auto none = [](const auto& x) {
    return std::vector{square(x[0]) + square(x[1]) - 1, x[0] * x[1] - 1};
  };
  expect_roots(solve_system(none, ends(2, {-3, 3})), 0);
  const rational close = parse_rational("1e-12");
  const auto two = [&](const auto& x) {
    return std::vector{(x[0] - 1) * (x[0] - 1 - close) + x[1] - 1, x[1] - 1};
  };
  const system_root_set s = solve_system(two, ends(2, {-3, 3}));
  expect_roots(s, 2);
  EXPECT_TRUE(one_holds(s, {1, 1}));
  EXPECT_TRUE(one_holds(s, {1 + close, 1}));
  const auto missed = [&](const auto& x) {
    return std::vector{square(x[0] - 1) + close * close + x[1] - 1, x[1] - 1};
  };
  expect_roots(solve_system(missed, ends(2, {-3, 3})), 0);
}

TEST(SolveSystem, OnFacesAndCornersOnce) {
  const auto f = [](const auto& x) { return std::vector{square(x[0]) - 1, square(x[1]) - x[0]}; };
  const system_root_set s = solve_system(f, ends(2, {-1, 1}));  // (1, 1), (1, -1): corners
  EXPECT_EQ(s.regions.size(), 2U);
  for (const system_region& r : s.regions) EXPECT_EQ(r.verdict, root_verdict::unique);
  const system_root_set t = solve_system(f, ends(2, {-4, 4}));  // where boxes are cut
  expect_roots(t, 2);
  EXPECT_TRUE(one_holds(t, {1, 1}));
  EXPECT_TRUE(one_holds(t, {1, -1}));
}

TEST(SolveSystem, ShortRationalRootsAreExactAndOthersAreNot) {
  for (const char* const distance : {"1e-20", "1e-33", "1e-40", "1e-50", "1e-80"}) {
    const rational little = parse_rational(distance);
    const auto f = [&](const auto& x) {
      return std::vector{square(x[0]) - square(1 + little), x[1] - x[0]};
    };
    const system_root_set near = solve_system(f, ends(2, {0, 3}));
    expect_roots(near, 1);
    EXPECT_TRUE(one_holds(near, {1 + little, 1 + little})) << distance;
  }
  const auto g = [](const auto& x) {
    return std::vector{square(x[0]) - rational(1, 9), x[0] * x[1] - 2};
  };
  // (1/3, 6) is in a corner.
  const system_root_set exact = solve_system(g, {{rational(1, 3), 1}, {std::nullopt, 6}});
  expect_roots(exact, 1);
  EXPECT_TRUE(exact.regions[0].enclosure[1].is_exact());
  EXPECT_TRUE(one_holds(exact, {rational(1, 3), 6}));
}

TEST(SolveSystem, InBoxesWithoutEnds) {
  const system_box all{{std::nullopt, std::nullopt}, {std::nullopt, std::nullopt}};
  const auto f = [](const auto& x) { return std::vector{x[0] * x[1] - 1, x[0] - x[1]}; };
  expect_roots(solve_system(f, all), 2);
  expect_roots(solve_system(f, {{std::nullopt, 0}, {std::nullopt, std::nullopt}}), 1);
  expect_roots(solve_system(f, {{2, std::nullopt}, {std::nullopt, std::nullopt}}), 0);
  const auto polynomials = [](const auto& x) {
    return std::vector{square(x[0]) - x[1], square(x[1]) - x[0]};
  };
  expect_roots(solve_system(polynomials, all), 2);
  // With a coefficient that is not rational.
  const real_system unbounded(
      {parse("pi*x^2 - y^3 - y", {"x", "y"}), parse("y^2 - x - x^3", {"x", "y"})});
  const system_root_set s = solve_system(unbounded, all);
  EXPECT_FALSE(s.is_resolved());
  EXPECT_TRUE(one_holds(s, {0, 0}));
  EXPECT_EQ(s.regions.back().verdict, root_verdict::unresolved);
  EXPECT_NE(s.regions.back().remark.find("no proved bound"), std::string::npos);
}

TEST(SolveSystem, EndsWhereInfinitelyManyBoxesStayUnresolved) {
  const auto f = [](const auto& x) { return std::vector{x[0] - x[1], 2 * x[0] - 2 * x[1]}; };
  const system_root_set s = solve_system(f, ends(2, {-1, 1}), {.most_unresolved = 50});
  EXPECT_FALSE(s.is_resolved());
  ASSERT_FALSE(s.regions.empty());
  EXPECT_NE(s.regions[0].remark.find("infinitely many"), std::string::npos);
}

TEST(SolveSystem, ChosenRationalRootsAreAllThereAre) {
  // (x - a_1)(x - a_2) = 0, (y - b_1)(y - b_2) = 0, in skew coordinates: four roots.
  random_source random(5);
  for (repeat trial(15); trial.again();) {
    const auto any = [&] { return rational(random.between(-12, 12), random.between(1, 6)); };
    const std::vector<rational> a{any(), any()};
    const std::vector<rational> b{any(), any()};
    if (a[0] == a[1] || b[0] == b[1]) continue;
    const rational skew(random.between(-3, 3), 4);
    const auto f = [&](const auto& x) {
      const auto u = x[0] + skew * x[1];
      return std::vector{(u - a[0]) * (u - a[1]), (x[1] - b[0]) * (x[1] - b[1])};
    };
    const system_root_set s = solve_system(f, ends(2, {-30, 30}));
    expect_roots(s, 4);
    for (const rational& u : a) {
      for (const rational& y : b) EXPECT_TRUE(one_holds(s, {rational(u - skew * y), y}));
    }
  }
}

TEST(SolveSystem, CanBeStoppedAndGoneOnWith) {
  // What is left of polynomials would be solved by elimination.
  const auto f = [](const auto& x) {
    return std::vector{square(x[0]) + x[1] - 11, exp(x[0] + square(x[1]) - 7) - 1};
  };
  system_search s(f, ends(2, {-5, 5}));
  int runs = 0;
  for (; !s.is_finished() && runs < 1000; ++runs) {
    s.run({.most_boxes = 3});
    if (!s.is_finished()) {
      EXPECT_FALSE(s.result().complete);
    }
  }
  EXPECT_GT(runs, 2);
  expect_roots(s.result(), 4);
}

TEST(SolveSystem, BadInput) {
  const auto f = [](const auto& x) { return std::vector{x[0], x[0]}; };
  EXPECT_THROW(static_cast<void>(solve_system(f, ends(2, {1, 0}))), input_error);
  EXPECT_THROW(static_cast<void>(solve_system(f, ends{})), input_error);
  EXPECT_THROW(static_cast<void>(solve_system(f, ends(3, {0, 1}))), input_error);
  EXPECT_THROW(static_cast<void>(solve_system(f, ends(1, {0, 1}))), input_error);
}

// Each step makes x_0 twice as exact, while x_1 is at a double root and stays: that ends with the
// boxes that are left unresolved.
TEST(SolveSystem, TakesNoMoreBitsThanItsBoxesHave) {
  const auto f = [](const auto& x) { return std::vector{exp(x[0]) - 2, square(x[1] - x[0])}; };
  const system_root_set s = solve_system(f, {{0, 1}, {0, 1}}, {.most_boxes = 2'000});
  EXPECT_FALSE(s.is_resolved());
  EXPECT_FALSE(s.regions.empty());
  EXPECT_LT(s.account.most_bits, 400);
  for (const system_region& r : s.regions) EXPECT_EQ(r.verdict, root_verdict::unresolved);
}

TEST(Krawczyk, ProvesNothingWhereTheFunctionJumps) {
  // f' is 1 and f has no root: floor is not defined to have a derivative at 1.
  const auto f = [](const auto& x) { return std::vector{x[0] + floor(x[0]) - rational(3, 2)}; };
  const system_root_set s = solve_system(f, ends(1, {0, 2}));
  for (const system_region& r : s.regions) EXPECT_EQ(r.verdict, root_verdict::unresolved);
}

}  // namespace systems_test
}  // namespace polhode
