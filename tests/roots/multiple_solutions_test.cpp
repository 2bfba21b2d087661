// Multiple solutions of systems of polynomials, which are proved by elimination.

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/roots/systems.hpp"
#include "roots/polynomial/common_zeros.hpp"
#include "roots/polynomial/elimination.hpp"

namespace polhode {
namespace multiple_solutions_test {

std::vector<expression> system_of(const std::vector<std::string>& texts) {
  const std::vector<std::string> names{"x", "y", "z"};
  const std::vector<std::string> variables(names.begin(),
                                           names.begin() + static_cast<long>(texts.size()));
  std::vector<expression> result;
  for (const std::string& text : texts) result.push_back(parse(text, variables));
  return result;
}
system_root_set solved(const std::vector<std::string>& texts, long half = 3) {
  return solve_system(real_system(system_of(texts)),
                      system_box(texts.size(), {rational(-half), rational(half)}));
}

struct expected_roots {
  std::vector<std::string> texts;
  std::size_t simple;
  std::size_t multiple;
};

TEST(MultipleSolutions, AreToldFromSimpleOnesAndFromNone) {
  for (const expected_roots& e : std::vector<expected_roots>{
           {{"x^2+y^2-2", "x+y-2"}, 0, 1},
           {{"x^2+y^2-2", "(x-1)^2+(y-1)^2"}, 0, 1},
           {{"x^2+y^2-1", "x*y-1/2"}, 0, 2},
           {{"x^2+y^2-3", "x^2*y^2-9/4"}, 0, 4},
           {{"x^3-2", "(x-y)^2"}, 0, 1},
           {{"x^2-2", "(y-x)^2*(y+x)"}, 2, 2},
           {{"y-x^3", "y"}, 0, 1},
           {{"(x^2-2)^2+(y^2-3)^2", "(x^2-2)*(y^2-3)"}, 0, 4},
           {{"x^2+y^2+z^2-3", "x+y+z-3", "x-y"}, 0, 1},
           {{"x^2+y^2-2", "x+y-2-1e-40"}, 0, 0},
           {{"x^2+y^2-2", "x+y-2+1e-40"}, 2, 0},
           {{"x^2+y^2-1", "x*y-1/2+1e-50"}, 4, 0},
           {{"x^2+y^2-1", "x*y-1/2-1e-50"}, 0, 0},
           {{"x^3-2", "(x-y)^2+1e-80"}, 0, 0},
           // Factors that are numbers, Powell's singular function with them.
           {{"pi*(x^2+y^2-2)", "sqrt(2)*(x+y-2)/e"}, 0, 1},
           {{"(x^2-2)*sqrt(5)", "pi*((y-x)^2*(y+x))"}, 2, 2},
           {{"x+10*y", "sqrt(5)*(x-z)", "sqrt(10)*(y-2*z)^2"}, 0, 1}}) {
    const system_root_set s = solved(e.texts);
    std::size_t simple = 0;
    std::size_t multiple = 0;
    for (const system_region& r : s.regions) {
      if (r.verdict == root_verdict::unique) ++simple;
      if (r.verdict == root_verdict::multiple) ++multiple;
      const refined_system_root fine = refine(real_system(system_of(e.texts)), r, 60);
      EXPECT_EQ(fine.verdict, status::certified) << e.texts[0];
      for (const ball& x : fine.enclosure) {
        EXPECT_TRUE(contains_zero(x) || x.radius() <= scale(x.magnitude_upper(), -195))
            << e.texts[0];
      }
    }
    EXPECT_TRUE(s.is_resolved()) << e.texts[0] << ", " << e.texts[1];
    EXPECT_EQ(simple, e.simple) << e.texts[0] << ", " << e.texts[1];
    EXPECT_EQ(multiple, e.multiple) << e.texts[0] << ", " << e.texts[1];
  }
}

TEST(MultipleSolutions, AFactorThatIsOrMayBeZeroIsKept) {
  for (const char* zero : {"0", "(sin(1)^2+cos(1)^2-1)", "(sqrt(2)*sqrt(3)-sqrt(6))"}) {
    const system_root_set s =
        solve_system(real_system(system_of({std::string(zero) + "*(x-y)", "x+y"})),
                     system_box(2, {rational(-1), rational(1)}), {.most_boxes = 300});
    EXPECT_FALSE(s.is_resolved()) << zero;
  }
}

TEST(MultipleSolutions, OnFacesAreInTheBoxOrNot) {
  const real_system circles(system_of({"x^2+y^2-1", "(x-2)^2+y^2-1"}));  // they touch at (1, 0)
  const auto count = [&](const rational& low, const rational& high) {
    const system_root_set s = solve_system(circles, {{low, high}, {rational(0), rational(2)}});
    EXPECT_TRUE(s.is_resolved());
    return s.regions.size();
  };
  EXPECT_EQ(count(0, 1), 1U);
  EXPECT_EQ(count(1, 2), 1U);
  EXPECT_EQ(count(rational(1, 2), rational(999'999, 1'000'000)), 0U);
  const rational tiny(integer(1), integer(integer(1) << 100U));
  EXPECT_EQ(count(0, rational(1 - tiny)), 0U);
  EXPECT_EQ(count(rational(1 + tiny), 2), 0U);
}

TEST(MultipleSolutions, ThatAreNearEachOtherHaveRegionsOfTheirOwn) {
  const system_root_set s = solved({"x^2+y^2-2", "x+y-2+1e-90"});
  ASSERT_EQ(s.regions.size(), 2U);
  EXPECT_TRUE(s.is_resolved());
  EXPECT_FALSE(overlaps(s.regions[0].box[0], s.regions[1].box[0]));
}

/// Where a curve of boxes would take millions.
TEST(MultipleSolutions, AreFoundWhereHalvingTakesLong) {
  const auto texts = {"x+y+z-3", "x*y+y*z+z*x-3", "x*y*z-1"};
  const system_root_set s = solved({texts.begin(), texts.end()}, 5);
  EXPECT_TRUE(s.is_resolved());
  ASSERT_EQ(s.regions.size(), 1U);
  EXPECT_EQ(s.regions[0].verdict, root_verdict::multiple);
  EXPECT_LT(s.account.boxes, 100'000);
}

TEST(MultipleSolutions, OfOtherEquationsAreNotProvedToBeAlone) {
  const system_root_set s = solved({"x^2+y^2-2", "exp(x*y-1)-1"}, 5);
  EXPECT_FALSE(s.is_resolved());
  EXPECT_TRUE(std::ranges::any_of(s.regions, [](const system_region& r) {
    return r.verdict == root_verdict::at_least_one && contains(r.box[0], rational(1));
  }));
  EXPECT_FALSE(std::ranges::any_of(s.regions,
                                   [](const system_region& r) { return is_one_root(r.verdict); }));
  // A curve of solutions has no eliminants.
  EXPECT_FALSE(solved({"x^2-y^2", "x-y"}).is_resolved());
}

/// Zeros at points whose coordinates are irrational, and values that are not 0 by very little.
TEST(MultipleSolutions, ZerosAtAlgebraicPointsAreDecided) {
  using detail::algebraic_point;
  using detail::real_algebraic;
  const auto root = [](const std::vector<integer>& p, long low, long high) {
    return real_algebraic(p, {rational(low), rational(high)});
  };
  const real_algebraic two = root({-2, 0, 1}, 1, 2);         // sqrt 2
  const real_algebraic three = root({-3, 0, 1}, 1, 2);       // sqrt 3
  const real_algebraic sum = root({1, 0, -10, 0, 1}, 3, 4);  // their sum
  const auto is_zero = [](const char* text, algebraic_point x) {
    return detail::is_zero_at(parse(text, {"x", "y", "z"}), x);
  };
  const algebraic_point at{two, three, sum};
  EXPECT_EQ(is_zero("x+y-z", at), true);
  EXPECT_EQ(is_zero("x^2*y^2-6", at), true);
  EXPECT_EQ(is_zero("z^2-5-2*x*y", at), true);
  EXPECT_EQ(is_zero("x-y", at), false);
  EXPECT_EQ(is_zero("x+y-z+1e-60", at), false);
  EXPECT_EQ(is_zero("(x+y-z)^2+1e-100", at), false);
  EXPECT_EQ(is_zero("7*(x^2-2)", at), true);
  EXPECT_EQ(is_zero("sin(x-sqrt(2))", at), std::nullopt);
  EXPECT_EQ(is_zero("x-2", {real_algebraic(rational(2)), three, sum}), true);
  EXPECT_EQ(is_zero("x-y", {real_algebraic(rational(2)), real_algebraic(rational(5, 2)), sum}),
            false);
}

/// x - q for numbers q below sqrt 2 by about 2^-k: the least size of x - q, by its eliminant, is
/// nearly attained.
TEST(MultipleSolutions, ValuesThatAreSmallAreNotZero) {
  const detail::real_algebraic two({-2, 0, 1}, {rational(1), rational(2)});
  const ball root = sqrt(ball(2, 600));
  for (unsigned k = 40; k <= 300; ++k) {
    const integer n = floor_of(lower_rational(scale(root, static_cast<long>(k))));
    const rational q(n, integer(integer(1) << k));
    detail::algebraic_point x{two};
    EXPECT_EQ(detail::is_zero_at(parse("x-" + q.str(), {"x"}), x), false) << k;
  }
}

TEST(MultipleSolutions, AlgebraicNumbersLieInIntervals) {
  detail::real_algebraic x({-2, 0, 1}, {rational(1), rational(2)});
  EXPECT_EQ(x.is_in({rational(1), rational(3, 2)}), true);
  EXPECT_EQ(x.is_in({std::nullopt, rational(141'421'356, 100'000'000)}), false);
  EXPECT_EQ(x.is_in({rational(141'421'356, 100'000'000), std::nullopt}), true);
  EXPECT_TRUE(overlaps(square(x.enclosure(300)), ball(2, 300)));
  EXPECT_LE(x.enclosure(300).radius(), magnitude::power_of_two(-298));
  detail::real_algebraic one(rational(1));
  EXPECT_EQ(one.is_in({rational(1), rational(1)}), true);
  EXPECT_EQ(one.is_in({rational(0), rational(99, 100)}), false);
}

TEST(MultipleSolutions, TheDeterminantOfTheDerivatives) {
  const auto determinant = detail::jacobian_determinant(system_of({"x^2*y-3", "x+5*y^3"}));
  ASSERT_TRUE(determinant);
  // 2 x y * 15 y^2 - x^2
  for (const auto& [x, y] : {std::pair(2, 3), std::pair(-1, 4)}) {
    const std::vector<ball> at{ball(x, 64), ball(y, 64)};
    EXPECT_TRUE(contains((*determinant).evaluator<ball>(64)(std::span<const ball>(at)),
                         rational(30 * x * y * y * y - x * x)));
  }
  const auto three = detail::jacobian_determinant(system_of({"x*y", "y*z", "z*x"}));
  ASSERT_TRUE(three);
  const std::vector<ball> at{ball(2, 64), ball(3, 64), ball(5, 64)};
  EXPECT_TRUE(contains(three->evaluator<ball>(64)(std::span<const ball>(at)), rational(60)));
  EXPECT_FALSE(detail::jacobian_determinant(system_of({"x*y", "exp(x)"})));
}

}  // namespace multiple_solutions_test
}  // namespace polhode
