// Roots at kinks and branch points, and the roots beside them at any scale.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/interval.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/real/roots.hpp"
#include "polhode/roots/isolate.hpp"

// The functions are a person's, outside the library's namespace.
namespace roots_at_kinks_test {

using namespace polhode;

struct known_search {
  std::string f;
  std::string from;
  std::string to;
  std::vector<std::string> roots;
};

TEST(RootsAtKinks, AreAllFound) {
  for (const known_search& s : std::vector<known_search>{
           {"sqrt(x)-x", "-1e100", "1e100", {"0", "1"}},
           {"abs(x)*(x-1e-80)", "-1", "1", {"0", "1e-80"}},
           {"sqrt(x)*(x-1e-70)", "-1", "1", {"0", "1e-70"}},
           {"cbrt(x)-x", "-1e100", "1e100", {"-1", "0", "1"}},
           {"exp(x)-1-x*abs(x)", "-1e90", "1e3", {"-0.714556384743", "0"}},
           {"abs(x-1/3)*(x-1/3-1e-90)", "-1e50", "1e300", {"1/3", "1/3+1e-90"}},
           {"(x-2)*abs(x-2)", "-10", "10", {"2"}},
           {"abs(x)*((x+3/10)^2-1e-4)", "-1", "1", {"-31/100", "-29/100", "0"}},
           {"abs(x)*((x-3/10)^2-1e-4)", "-1", "1", {"0", "29/100", "31/100"}},
           {"abs(x)^(3/2)", "-1e300", "1e300", {"0"}},
           {"sqrt(x-1)*log(x)", "1/2", "3", {"1"}},
           {"abs(x)-x^2", "-1e200", "1e200", {"-1", "0", "1"}}}) {
    SCOPED_TRACE(s.f);
    const root_set found =
        isolate_roots(parse(s.f), end_point_of(parse(s.from, {})), end_point_of(parse(s.to, {})));
    EXPECT_TRUE(found.is_resolved() && found.complete);
    ASSERT_EQ(found.regions.size(), s.roots.size());
    for (std::size_t i = 0; i < s.roots.size(); ++i) {
      const ball root = parse(s.roots[i], {}).value(400);
      const ball enclosure = refine(found.regions[i], 10).enclosure;
      EXPECT_TRUE(overlaps(enclosure, root.enlarged(scale(root.magnitude_upper(), -30))))
          << s.roots[i];
    }
  }
}

/// Where the growth beside the zero says nothing, the whole region is shown, and never a point for
/// it.
TEST(RootsAtKinks, ThatAreNotAloneForCertainAreRegions) {
  const root_set found =
      isolate_roots(parse("x*abs(sin(1/x))*sqrt(abs(x))"), -1, 1, {.most_boxes = 20'000});
  EXPECT_EQ(std::ranges::count_if(
                found.regions,
                [](const root_region& r) { return r.verdict == root_verdict::infinitely_many; }),
            1);
  const auto s = isolate_roots<double>([](auto x) { return sqrt(x * x) * sin(1 / x) * x; }, -1, 1,
                                       {.isolation = {.most_boxes = 300}});
  EXPECT_FALSE(s.resolved);
  for (const certified_root<double>& r : s.roots) {
    if (is_one_root(r.verdict)) continue;
    EXPECT_FALSE(r.lowest <= r.greatest);
    EXPECT_LT(r.lower, r.upper);
    EXPECT_FALSE(r.reached);
  }
}

TEST(RootsAtKinks, InDoubles) {
  const auto s = isolate_roots<double>([](auto x) { return sqrt(x) - x; }, -1e100, 1e100);
  ASSERT_TRUE(s.resolved);
  ASSERT_EQ(s.roots.size(), 2U);
  EXPECT_EQ(s.roots[0].verdict, root_verdict::isolated);
  EXPECT_EQ(s.roots[0].value, 0);
  EXPECT_LT(s.roots[0].greatest, 1);
  EXPECT_EQ(s.roots[1].value, 1);
  const auto r = find_root<double>(
      [](auto x) {
        using std::abs;
        return sqrt(abs(x - "1/3"_r)) * (x - 0.5);
      },
      0, 1);
  EXPECT_FALSE(r.lowest > r.greatest);
}

}  // namespace roots_at_kinks_test
