// Polynomials of the coordinates of the solutions of polynomial systems, and searches on unbounded
// boxes that rest on them.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/roots/systems.hpp"
#include "roots/polynomial/elimination.hpp"
#include "support/random.hpp"

namespace polhode {
namespace elimination_test {

const std::vector<std::string> names{"x", "y", "z"};

std::vector<expression> system_of(const std::vector<std::string>& texts) {
  const std::vector<std::string> variables(names.begin(),
                                           names.begin() + static_cast<long>(texts.size()));
  std::vector<expression> result;
  for (const std::string& text : texts) result.push_back(parse(text, variables));
  return result;
}
std::vector<std::optional<rational_polynomial>> eliminants_of(
    const std::vector<std::string>& texts) {
  return detail::eliminants(system_of(texts));
}
system_root_set everywhere(const std::vector<std::string>& texts) {
  return solve_system(real_system(system_of(texts)), system_box(texts.size()));
}

TEST(Elimination, KnownSolutionsAreRoots) {
  support::random_source random(71);
  const auto number = [&] {
    return rational(random.between(-9, 9), random.one_in(2) ? 1 : random.between(1, 5));
  };
  long known = 0;
  for (support::repeat trial(60); trial.again();) {
    // Each equation is a sum of products, each with a factor that is 0 at the point. The other
    // factors make the degrees fall at whole numbers.
    const std::size_t n = random.one_in(3) ? 3 : 2;
    const long most = n == 2 ? 3 : 1;
    std::vector<rational> point;
    for (std::size_t i = 0; i < n; ++i) point.push_back(number());
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < n; ++i) {
      std::string text;
      for (std::size_t j = 0; j < n; ++j) {
        const auto name = [&] {
          return names[static_cast<std::size_t>(random.between(0, static_cast<long>(n) - 1))];
        };
        text += (j == 0 ? "(" : "+(") + names[j] + "-(" + point[j].str() + "))*(" + name() + "-" +
                std::to_string(random.between(0, 3)) + ")*((" + number().str() + ")*" + name() +
                "^" + std::to_string(random.between(1, most)) + "+(" + number().str() + "))";
      }
      texts.push_back(text);
    }
    const auto found = eliminants_of(texts);
    for (std::size_t i = 0; i < n; ++i) {
      if (!found[i]) continue;
      ++known;
      EXPECT_EQ((*found[i])(point[i]), 0) << texts[0] << " , " << texts[1];
      EXPECT_LE(abs(point[i]), root_bound(*found[i]));
    }
  }
  EXPECT_GT(known, 0);
}

TEST(Elimination, HasNoOtherRootsWhereNothingFalls) {
  // x^2 - y and y^2 - x: x^4 - x. Three planes and a quadric, in triangular form.
  const auto two = eliminants_of({"x^2-y", "y^2-x"});
  ASSERT_TRUE(two[0]);
  EXPECT_EQ(two[0]->degree(), 4);
  EXPECT_EQ((*two[0])(rational(3)), 78 * two[0]->leading());
  // y = 1/(x - 1) and y = 1/(x - 2) - 3: 3 x^2 - 9 x + 5 = 0.
  for (const char* second : {"(x-2)*y-1+3*(x-2)", "(x-1)*(x-2)*y - (x-1) + 3*(x-1)*(x-2)"}) {
    const auto found = eliminants_of({"(x-1)*y-1", second});
    ASSERT_TRUE(found[0]) << second;
    const rational_polynomial rest =
        divide(*found[0], rational_polynomial({rational(5), rational(-9), rational(3)})).second;
    EXPECT_TRUE(rest.is_zero()) << second;
  }
}

TEST(Elimination, KnowsNoBoundWhereThereIsNone) {
  EXPECT_FALSE(eliminants_of({"x*y", "x*(y-1)"})[1]);  // x = 0
  EXPECT_FALSE(eliminants_of({"x-y", "2*x-2*y"})[0]);
  EXPECT_FALSE(eliminants_of({"exp(x)-y", "x-y"})[0]);
  EXPECT_FALSE(eliminants_of({"x/y-1", "x-1"})[0]);
  EXPECT_FALSE(eliminants_of({"x^80*y^80-z^80-1", "x^90*y-z^90", "x^70+y^70*z-2"})[0]);
  EXPECT_FALSE(eliminants_of({"pi*x-y", "x+y-1"})[0]);
  EXPECT_FALSE(eliminants_of({"((x^100)^100)^100-y", "(y^100)^100-x"})[0]);
  EXPECT_FALSE(eliminants_of({"(x+y+1)^100-y", "(x-y+2)^100-x"})[0]);
}

TEST(Elimination, SystemsOnTheWholePlaneAreSolved) {
  struct given {
    std::vector<std::string> texts;
    std::size_t roots;
  };
  for (const given& g : std::vector<given>{{{"x^2-2*y^2-1", "x*y+x-3"}, 2},
                                           {{"x^2-y", "y^2-x"}, 2},
                                           {{"x*y+x-3", "y-x^3+x"}, 2},
                                           {{"(x-1)*y-1", "(x-2)*y-1+3*(x-2)"}, 2},
                                           {{"x^2+y^2-1", "x^2-y^2-2"}, 0},
                                           {{"x+y+z-6", "x*y+y*z+z*x-11", "x*y*z-6"}, 6}}) {
    const system_root_set found = everywhere(g.texts);
    EXPECT_TRUE(found.is_resolved()) << g.texts[0];
    EXPECT_EQ(found.regions.size(), g.roots) << g.texts[0];
  }
  // A root far out, and infinitely many.
  const system_root_set far = everywhere({"x-10^40*y", "y-10^30"});
  EXPECT_TRUE(far.is_resolved());
  EXPECT_EQ(far.regions.size(), 1U);
  EXPECT_FALSE(everywhere({"x*y", "x*(y-1)"}).is_resolved());
}

}  // namespace elimination_test
}  // namespace polhode
