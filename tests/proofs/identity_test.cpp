// The exact identity behind eq. (44), and what happens to a wrong one.

#include <gtest/gtest.h>

#include <string>

#include "proofs/derivative_identity.hpp"

namespace polhode::proofs {
namespace identity_test {

TEST(DerivativeIdentity, HoldsOnTheWholeGrid) {
  const identity_check check = check_derivative_identity();
  EXPECT_TRUE(check.holds);
  // One point more than the degree in each variable: a 2, b 3, u 3, y 10.
  EXPECT_EQ(check.points, 3 * 4 * 4 * 11);
  EXPECT_NE(check.statement.find(std::to_string(check.points) + " points"), std::string::npos);
  EXPECT_NE(check.degrees.find("2 in a, 3 in b, 3 in u and 10 in y"), std::string::npos);
}

TEST(DerivativeIdentity, FailsForAnyOtherNumerator) {
  using q = rational;
  const auto holds = [](const numerator_polynomial& n) {
    return check_derivative_identity(n).holds;
  };
  EXPECT_TRUE(
      holds([](const q& a, const q& b, const q& x) { return a * (1 + b * x) + 2 * b * x; }));
  EXPECT_FALSE(holds([](const q& a, const q& b, const q& x) { return a + (a + 1) * b * x; }));
  EXPECT_FALSE(holds([](const q& a, const q& b, const q& x) { return a - (a + 2) * b * x; }));
  EXPECT_FALSE(holds([](const q& a, const q& b, const q& x) { return 2 * (a + (a + 2) * b * x); }));
  EXPECT_FALSE(holds([](const q& a, const q& b, const q& x) {
    return a + (a + 2) * b * x + q(1, 1'000'000'000);
  }));
  EXPECT_FALSE(holds([](const q&, const q&, const q&) { return q(0); }));
}

TEST(DerivativeIdentity, FailsWhereOnlyOnePointDiffers) {
  // The whole grid is looked at: a numerator that is wrong at any single value of a, b or X is
  // seen.
  using q = rational;
  for (const long k : {1L, 2L, 3L, 4L}) {
    const auto except = [&](const auto& at) {
      return check_derivative_identity([&](const q& a, const q& b, const q& x) {
               return derivative_numerator(a, b, x) + (at(a, b, x) ? 1 : 0);
             })
          .holds;
    };
    if (k <= 3) {
      EXPECT_FALSE(except([&](const q& a, const q&, const q&) { return a == k; })) << k;
    }
    EXPECT_FALSE(except([&](const q&, const q& b, const q&) { return b == q(k, 5); })) << k;
    // y = 0: X = u.
    EXPECT_FALSE(except([&](const q&, const q&, const q& x) { return x == q(k, 4); })) << k;
    // y = 10/11.
    EXPECT_FALSE(except([&](const q&, const q&, const q& x) {
      return x == q(k, 4) + (1 - q(k, 4)) * q(100, 121);
    })) << k;
  }
}

TEST(Numerator, IsPositiveByItsCoefficients) {
  using q = rational;
  EXPECT_TRUE(numerator_is_positive());
  EXPECT_TRUE(numerator_is_positive([](const q& a, const q&, const q&) { return a; }));
  EXPECT_TRUE(numerator_is_positive([](const q&, const q&, const q&) { return q(1); }));
  EXPECT_FALSE(numerator_is_positive([](const q&, const q&, const q&) { return q(0); }));
  EXPECT_FALSE(numerator_is_positive([](const q& a, const q& b, const q& x) { return a - b * x; }));
  EXPECT_FALSE(numerator_is_positive(
      [](const q& a, const q& b, const q& x) { return a + (a + 2) * b * x - a * x; }));
  EXPECT_FALSE(numerator_is_positive([](const q&, const q&, const q&) { return q(-1); }));
  EXPECT_FALSE(
      numerator_is_positive([](const q& a, const q& b, const q& x) { return 1 - a * b * x; }));
}

}  // namespace identity_test
}  // namespace polhode::proofs
