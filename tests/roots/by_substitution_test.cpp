// Systems of which an equation says what a variable is: multiple roots, unbounded boxes, and
// places where the equations are not defined.

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/roots/systems.hpp"

namespace polhode {
namespace by_substitution_test {

struct known {
  std::vector<double> at;
  root_verdict verdict;
};

const system_side everywhere{std::nullopt, std::nullopt};

system_root_set solved(const std::vector<std::string>& formulas, const system_box& box) {
  const std::vector<std::string> all{"x", "y", "z"};
  const expression_names names{{all.begin(), all.begin() + static_cast<long>(box.size())}, {}};
  std::vector<expression> components;
  components.reserve(formulas.size());
  for (const std::string& f : formulas) components.emplace_back(f, names);
  return solve_system(real_system(components), box);
}

void expect_solutions(const std::vector<std::string>& formulas, const system_box& box,
                      const std::vector<known>& expected) {
  SCOPED_TRACE(formulas[0] + ", " + formulas[1]);
  const system_root_set s = solved(formulas, box);
  EXPECT_TRUE(s.is_resolved());
  ASSERT_EQ(s.regions.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(s.regions[i].verdict, expected[i].verdict);
    for (std::size_t k = 0; k < box.size(); ++k) {
      const ball near = ball::exactly(expected[i].at[k], 64).enlarged(magnitude::power_of_two(-30));
      EXPECT_TRUE(overlaps(s.regions[i].enclosure[k], near)) << s.regions[i].enclosure[k];
      EXPECT_TRUE(contains(s.regions[i].box[k], s.regions[i].enclosure[k].middle()) ||
                  overlaps(s.regions[i].box[k], s.regions[i].enclosure[k]));
    }
  }
}

constexpr auto unique = root_verdict::unique;
constexpr auto multiple = root_verdict::multiple;
constexpr auto isolated = root_verdict::isolated;

TEST(BySubstitution, MultipleRoots) {
  const system_box box(2, {-10, 10});
  expect_solutions({"log(x)+y-1", "x*y-1"}, box, {{{1, 1}, multiple}});
  expect_solutions({"exp(x)+y-1", "exp(y)+x-1"}, {{-5, 5}, {-5, 5}}, {{{0, 0}, multiple}});
  expect_solutions({"y-cos(x)", "y-1"}, {{-3, 3}, {-1, 1}}, {{{0, 1}, multiple}});
  expect_solutions({"-(y-cos(x))", "y-1"}, {{-3, 3}, {-1, 1}}, {{{0, 1}, multiple}});
  expect_solutions({"(y-cos(x))/3", "y-1"}, {{-3, 3}, {-1, 1}}, {{{0, 1}, multiple}});
  expect_solutions({"3-2*(y-sin(x))-3", "(y-sin(x))*exp(x)+x^2-2*x+1"}, box,
                   {{{1, 0.8414709848078965}, multiple}});
  // The near misses have none, and two.
  expect_solutions({"log(x)+y-1", "x*y-1-1e-30"}, box, {});
  const system_root_set two = solved({"log(x)+y-1", "x*y-1+1e-12"}, box);
  EXPECT_TRUE(two.is_resolved());
  EXPECT_EQ(two.regions.size(), 2U);
}

TEST(BySubstitution, BoxesWithoutEnds) {
  const system_box all(2, everywhere);
  expect_solutions({"y-exp(x)", "y-3*x"}, all,
                   {{{0.6190612867359452, 1.8571838602078353}, unique},
                    {{1.5121345516578424, 4.5364036549735274}, unique}});
  expect_solutions({"y-exp(x)", "y+1"}, all, {});
  expect_solutions({"x-y^3+3*y", "2*x-4"}, all, {{{2, -1}, multiple}, {{2, 2}, unique}});
  expect_solutions({"z-x*y", "y-x^2", "z-sin(x)"}, system_box(3, everywhere),
                   {{{-0.92862630873173442, 0.86234682126872654, -0.80079794548132226}, unique},
                    {{0, 0, 0}, unique},
                    {{0.92862630873173442, 0.86234682126872654, 0.80079794548132226}, unique}});
}

TEST(BySubstitution, WhereTheEquationsAreNotDefined) {
  const system_box box(2, {-10, 10});
  expect_solutions({"log(y/x)+3*x", "y-2*x"}, box,
                   {{{-0.23104906018664843, -0.46209812037329687}, unique}});
  expect_solutions({"y/x-2", "y-3*x"}, box, {});
  expect_solutions({"y-sqrt(x)", "x*y"}, box, {{{0, 0}, isolated}});
  // At a kink there is no multiplicity.
  expect_solutions({"y-abs(x)", "x^2*exp(x)"}, box, {{{0, 0}, isolated}});
  expect_solutions({"y-abs(x^2-2)", "(x^2-2)^2*exp(x)"}, box,
                   {{{-1.4142135623730951, 0}, isolated}, {{1.4142135623730951, 0}, isolated}});
  // (1, 0) is where g is not defined.
  expect_solutions({"y-1/(x-1)", "(x-1)*(x-2)^2"}, box, {{{2, 1}, multiple}});
  expect_solutions({"y-sqrt(x-2)", "(x-1)*(x-3)^2"}, box, {{{3, 1}, multiple}});
}

TEST(BySubstitution, FacesOfTheBox) {
  expect_solutions({"y-cos(x)", "y-1"}, {{-3, 3}, {rational(0), rational(1)}},
                   {{{0, 1}, multiple}});
  expect_solutions({"y-cos(x)", "y-1"}, {{-3, 3}, {rational(0), rational(99, 100)}}, {});
  expect_solutions({"y-x^2", "(x-1)^2*(x-3)^2*exp(x)"}, {{-5, 5}, {0, 8}}, {{{1, 1}, multiple}});
  expect_solutions({"y-x^2-1", "(x-1)^2*exp(x)"}, {{-3, 1}, {2, 5}}, {{{1, 2}, multiple}});
  expect_solutions({"y-x^2-1", "(x-1)^2*exp(x)"}, {{-3, 1}, {rational(20001, 10000), 5}}, {});
  // The value is on the face, and no rule says so: it is not claimed to be inside.
  const system_root_set s =
      solved({"y-erf(x+1)-erfc(1)", "sin(x)^2"}, {{-1, 1}, {rational(1), rational(2)}});
  EXPECT_FALSE(s.is_resolved());
}

/// What is no such equation is not taken for one: the variable stands under a function, too.
TEST(BySubstitution, OnlyLinearEquations) {
  const system_root_set s = solved({"y*abs(y)-x*abs(x)", "(x-1)^2*exp(y)"}, {{-3, 3}, {-3, 3}});
  for (const system_region& r : s.regions) EXPECT_FALSE(is_one_root(r.verdict));
  const system_root_set t = solved({"y*x-1", "(x-1)^2*exp(y)"}, {{-3, 3}, {-3, 3}});
  for (const system_region& r : t.regions) EXPECT_FALSE(is_one_root(r.verdict));
}

TEST(BySubstitution, ManyDigits) {
  const std::vector<std::string> names{"x", "y"};
  const real_system f(std::vector{expression("y-log(x)", {names, {}}),
                                  expression("(x^2-3)^2*exp(y)", {names, {}})});
  const system_root_set s = solve_system(f, {{0, 10}, everywhere});
  ASSERT_EQ(s.regions.size(), 1U);
  EXPECT_EQ(s.regions[0].verdict, multiple);
  const refined_system_root fine = refine(f, s.regions[0], 300);
  EXPECT_EQ(fine.verdict, status::certified);
  const ball root = sqrt(ball(3, 1100));
  EXPECT_TRUE(contains(fine.enclosure[0], root));
  EXPECT_TRUE(contains(fine.enclosure[1], log(root)));
  EXPECT_LE(fine.enclosure[1].radius(), magnitude::power_of_two(-990));
}

}  // namespace by_substitution_test
}  // namespace polhode
