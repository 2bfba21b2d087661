// The monotonicity of inclusion: x in y gives f(x) in f(y). Two results are rounded on their own,
// and a thin ball goes through a bound of first order where a wide one goes through its ends, so
// what is tested is: f(x) lies in f(y) after each end of f(y) is moved outward by two units in the
// last place of f(x)'s greatest member, plus 2^-8 of f(x)'s radius (3/8 of it for sin and cos: see
// tightness_test.cpp; all of it for the agm). Where f(x) is undefined, so is f(y).

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/exact_set.hpp"
#include "support/functions.hpp"
#include "support/random.hpp"

namespace polhode {
namespace monotonicity_test {

using support::described;
using support::exact;
using support::exact_set;
using support::random_source;
using support::repeat;

::testing::AssertionResult in(const ball& small, const ball& large,
                              const rational& part = support::power_of_two(-8)) {
  if (large.is_undefined()) return ::testing::AssertionSuccess();
  if (small.is_undefined()) return ::testing::AssertionFailure() << "the smaller is undefined";
  exact_set outer = exact(large);
  const exact_set inner = exact(small);
  if (inner.is_bounded()) {
    const rational slack = 2 * support::ulp(inner.greatest_size(), small.precision()) +
                           support::to_rational(small.radius()) * part;
    if (outer.lower) outer.lower = *outer.lower - slack;
    if (outer.upper) outer.upper = *outer.upper + slack;
  }
  if (outer.holds(inner)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << described(small) << " is not in " << described(large);
}

/// exp of huge numbers has rationals of gigabytes.
bool is_moderate(const ball& x) {
  return !x.magnitude_upper().is_infinite() && x.magnitude_upper() < magnitude::power_of_two(12);
}

TEST(Monotonicity, OfElementaryFunctions) {
  random_source random(600);
  for (repeat trial(2500); trial.again();) {
    const ball y = random.any_ball();
    const ball x = random.inside(y);
    SCOPED_TRACE(described(x) + " in " + described(y));
    for (const support::elementary_function& f : support::elementary_functions()) {
      const std::string name = f.name;
      if (f.grows && !is_moderate(y)) continue;
      const bool circular = support::is_circular(name);
      EXPECT_TRUE(in(f.of(x), f.of(y), circular ? rational(3, 8) : support::power_of_two(-8)))
          << name;
    }
    const long n = random.between(-6, 6);
    EXPECT_TRUE(in(pow(x, n), pow(y, n))) << n;
    EXPECT_TRUE(in(square(x), square(y)));
    EXPECT_TRUE(in(abs(x), abs(y)));
    EXPECT_TRUE(in(-x, -y));
    EXPECT_TRUE(in(scale(x, n), scale(y, n)));
    EXPECT_TRUE(in(x + n, y + n));
    EXPECT_TRUE(in(x * n, y * n));
    EXPECT_TRUE(in(x / 3, y / 3));
  }
}

TEST(Monotonicity, OfOperationsOnTwoSets) {
  random_source random(601);
  for (repeat trial(4000); trial.again();) {
    const ball y = random.any_ball();
    const ball v = random.any_ball();
    const ball x = random.inside(y);
    const ball u = random.inside(v);
    SCOPED_TRACE(described(x) + " in " + described(y) + ", " + described(u) + " in " +
                 described(v));
    EXPECT_TRUE(in(x + u, y + v));
    EXPECT_TRUE(in(x - u, y - v));
    EXPECT_TRUE(in(x * u, y * v));
    EXPECT_TRUE(in(x / u, y / v));
    EXPECT_TRUE(in(hypot(x, u), hypot(y, v)));
    // The radius of a thin mean is that of its worse operand, relatively: more than it could be.
    EXPECT_TRUE(in(agm(x, u), agm(y, v), 1));
    EXPECT_TRUE(in(hull(x, u), hull(y, v)));
  }
}

}  // namespace monotonicity_test
}  // namespace polhode
