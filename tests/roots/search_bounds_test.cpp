// What a Taylor polynomial leaves out in the search for roots, and in counting zeros, where it is
// most of a bound.

#include <gtest/gtest.h>

#include "polhode/roots/real_function.hpp"
#include "roots/count_zeros.hpp"
#include "roots/search/taylor_bounds.hpp"

namespace polhode {
namespace search_bounds_test {

// Of x^4 the polynomial about 1 of degree 2, and what is left out with it: at 3/2 that is most of
// f'.
TEST(TaylorBounds, HoldTheSlopesOfTheEnds) {
  const real_function f([](const auto& x) { return square(square(x)); });
  const auto at = f.at(80);
  const ball x = hull(ball(rational(1, 2), 80), ball(rational(3, 2), 80));
  const detail::enclosed_function found =
      detail::taylor(at->series(ball(1, 80), 3), at->series(x, 3), x - 1);
  for (const rational& end : {rational(1, 2), rational(3, 2)}) {
    EXPECT_TRUE(contains(found.value, rational(end * end * end * end)));
    EXPECT_TRUE(contains(found.slope, rational(4 * end * end * end)));
  }
}

// 1 - (x/3)^40 has its first coefficient but one beyond all that are looked at.
TEST(CountZeros, CountsWhatItsCoefficientsDoNotShow) {
  const real_function f([](const auto& x) { return 1 - pow(x / 3, 40); });
  for (const rational& radius : {rational(1), rational(2), rational(5), rational(1, 100)}) {
    const auto found = count_zeros(f, 0, radius, 80);
    if (!found) continue;
    EXPECT_EQ(found->count, found->radius > 3 ? 40 : 0) << radius << " " << found->radius;
  }
  EXPECT_TRUE(count_zeros(f, 0, rational(1, 100), 80));
}

}  // namespace search_bounds_test
}  // namespace polhode
