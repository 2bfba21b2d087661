// The truncation bounds of src/elliptic/carlson_core.hpp, where they are nearly attained: a short
// series, or few steps, in numbers of many bits, so that no rounding error hides what is left out.

#include <gtest/gtest.h>

#include "elliptic/carlson_core.hpp"
#include "elliptic/theta_series.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace truncation_test {

using support::meet;

TEST(Truncation, IsBoundedInBothMethods) {
  support::random_source random(41);
  constexpr precision many = 700;
  const auto number = [&] {
    return ball(rational(random.between(1, 900), random.between(11, 290)), many).middle();
  };
  for (support::repeat trial(60); trial.again();) {
    ball x = number();
    ball y = number();
    ball z = number();
    const ball p = number();
    if (certainly_less(y, x)) std::swap(x, y);
    if (certainly_less(z, y)) std::swap(y, z);
    if (certainly_less(y, x)) std::swap(x, y);
    if (!certainly_less(x, y) || !certainly_less(y, z)) continue;
    const ball rf = detail::rf_by_duplication(x, y, z, many);
    const ball rj = detail::rj_by_duplication(x, y, z, p, false, many);
    const ball rd = detail::rj_by_duplication(x, y, z, z, true, many);
    for (const precision few : {12L, 20L, 33L, 60L}) {
      const auto check = [&](const ball& value, const ball& exact, const char* name) {
        EXPECT_TRUE(meet(value, exact)) << name << " " << few;
        EXPECT_TRUE(value.radius() <= scale(exact.magnitude_upper(), 14 - few))
            << name << " " << few;
      };
      check(detail::rf_by_duplication(x, y, z, few), rf, "R_F by duplication");
      check(detail::rj_by_duplication(x, y, z, p, false, few), rj, "R_J by duplication");
      check(detail::rj_by_duplication(x, y, z, z, true, few), rd, "R_D by duplication");
      const auto first = detail::by_landen(x, y, z, z, detail::third_kind::absent, few);
      if (first) {
        EXPECT_TRUE(meet(first->rf, rf)) << few;
      }
      const auto second = detail::by_landen(x, y, z, z, detail::third_kind::equals_y_or_z, few);
      if (second) {
        EXPECT_TRUE(meet(second->rj, rd)) << few;
      }
      if (certainly_less(x, p)) {
        const auto third = detail::by_landen(x, y, z, p, detail::third_kind::general, few);
        if (third && third->rj.is_bounded()) {
          EXPECT_TRUE(meet(third->rj, rj)) << few;
        }
      }
      const auto complete = detail::complete_by_landen(y, z, p, few);
      ASSERT_TRUE(complete);
      const ball zero(0, many);
      EXPECT_TRUE(meet(complete->rf, detail::rf_by_duplication(zero, y, z, many))) << few;
      EXPECT_TRUE(meet(complete->rj, detail::rj_by_duplication(zero, y, z, p, false, many))) << few;
    }
  }
}

// Where all waves of the value, or of the derivative, are at their crests the terms left out add
// up: to little more than the first of them.
TEST(Truncation, IsBoundedInBothSeriesOfThetaFunctions) {
  constexpr precision many = 500;
  const auto check = [](const theta_values& few, const theta_values& exact, int j,
                        const rational& q, precision p) {
    EXPECT_TRUE(meet(few.value, exact.value)) << j << " " << q << " " << p;
    EXPECT_TRUE(meet(few.derivative, exact.derivative)) << j << " " << q << " " << p;
    EXPECT_FALSE(few.value.is_undefined() || magnitude::power_of_two(4 - p) < few.value.radius());
  };
  const ball turn = pi(many);
  for (int j = 1; j <= 4; ++j) {
    for (const long parts : {1L, 2L, 3L, 4L, 5L, 6L, 7L, 8L, 10L, 12L, 14L}) {
      for (const long of : {0L, 1L, 2L}) {
        const ball z = turn * rational(of, parts);
        for (const precision few : {4L, 9L, 20L, 45L}) {
          for (const rational& q : {rational(1, 20), rational(1, 24)}) {
            const ball nome(q, many);
            check(detail::theta_by_definition(j, z, nome, few),
                  detail::theta_by_definition(j, z, nome, 400), j, q, few);
          }
          for (const rational& q : {rational(2, 49), rational(1, 20), rational(1, 3)}) {
            const ball nome(q, many);
            check(detail::theta_by_poisson(j, z, nome, few),
                  detail::theta_by_poisson(j, z, nome, 400), j, q, few);
          }
        }
      }
    }
  }
}

}  // namespace truncation_test
}  // namespace polhode
