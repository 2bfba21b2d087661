// Systems of equations: every root once, and nothing claimed that is not proved.

#include <gtest/gtest.h>

#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/roots/systems.hpp"

namespace polhode {
namespace {

using ends = std::vector<std::pair<rational, rational>>;

/// Every region is a unique root, the enclosures are apart, and each holds a root by a sharper proof.
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

const auto himmelblau = [](const auto& x) {
  return std::vector{square(x[0]) + x[1] - 11, x[0] + square(x[1]) - 7};
};

TEST(SolveSystem, HimmelblausFour) {
  const system_root_set s = solve_system(himmelblau, ends(2, {-5, 5}));
  expect_roots(s, 4);
  // One of them is (3, 2).
  const auto& last = s.regions.back();
  EXPECT_TRUE(contains(last.enclosure[0], 3L) || contains(s.regions[2].enclosure[0], 3L));
}

TEST(SolveSystem, DEBUG) {
  for (int n : {3, 4, 5}) {
    const auto tri = [n](const auto& x) {
      auto r = x;
      for (int i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        r[k] = (3 - 2 * x[k]) * x[k] + 1;
        if (i > 0) r[k] = r[k] - x[k - 1];
        if (i + 1 < n) r[k] = r[k] - 2 * x[k + 1];
      }
      return r;
    };
    const auto s = solve_system(tri, ends(static_cast<std::size_t>(n), {-2, 2}));
    std::cout << "tri " << n << " " << s.regions.size() << " " << s.account.boxes << " " << s.is_resolved() << std::endl;
    const auto banded = [n](const auto& x) {
      auto r = x;
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
    const auto t = solve_system(banded, ends(static_cast<std::size_t>(n), {-1, 1}));
    std::cout << "band " << n << " " << t.regions.size() << " " << t.account.boxes << " " << t.is_resolved() << std::endl;
    const auto brown = [n](const auto& x) {
      auto r = x;
      auto product = x[0];
      auto sum = x[0];
      for (std::size_t k = 1; k < x.size(); ++k) { product = product * x[k]; sum = sum + x[k]; }
      for (std::size_t k = 0; k + 1 < x.size(); ++k) r[k] = x[k] + sum - (n + 1);
      r[x.size() - 1] = product - 1;
      return r;
    };
    const auto u = solve_system(brown, ends(static_cast<std::size_t>(n), {-2, 2}));
    std::cout << "brown " << n << " " << u.regions.size() << " " << u.account.boxes << " " << u.is_resolved() << std::endl;
  }
  const auto hg = [](const auto& x) { return std::vector{4 * pow(x[0], 3) + 4 * x[0] * x[1] + 2 * square(x[1]) - 42 * x[0] - 14, 4 * pow(x[1], 3) + 2 * square(x[0]) + 4 * x[0] * x[1] - 26 * x[1] - 22}; };
  auto s = solve_system(hg, ends(2, {-5, 5}));
  std::cout << "himmelblau grad " << s.regions.size() << " " << s.account.boxes << " " << s.is_resolved() << std::endl;
  const auto hansen = [](const auto& x) { return std::vector{6 * pow(x[0], 5) - rational(126,5) * pow(x[0], 3) + 24 * x[0] - 6 * x[1], 12 * x[1] - 6 * x[0]}; };
  s = solve_system(hansen, ends(2, {-10, 10}));
  std::cout << "hansen " << s.regions.size() << " " << s.account.boxes << " " << s.is_resolved() << std::endl;
  const auto dbl = [](const auto& x) { return std::vector{square(x[0]) + square(x[1]) - 2, x[0] + x[1] - 2}; };
  s = solve_system(dbl, ends(2, {-3, 3}));
  std::cout << "double " << s.regions.size() << " " << s.account.boxes << " " << s.is_resolved() << std::endl;
  const auto close = [](const auto& x) { return std::vector{(x[0] - 1) * (x[0] - 1 - rational(1, 1000000000000)) + x[1] - 1, x[1] - 1}; };
  s = solve_system(close, ends(2, {-3, 3}));
  std::cout << "close " << s.regions.size() << " " << s.account.boxes << " " << s.is_resolved() << std::endl;
  const auto none = [](const auto& x) { return std::vector{square(x[0]) + square(x[1]) - 1, x[0] * x[1] - 1}; };
  s = solve_system(none, ends(2, {-3, 3}));
  std::cout << "none " << s.regions.size() << " " << s.account.boxes << " " << s.is_resolved() << std::endl;
}

}  // namespace
}  // namespace polhode
