// g(c) = value, on a log scale.

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/roots/inverse.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace inverse_test {

using support::as_narrow_as;

const auto minus_inverse_log = [](const ball& c) { return -1 / log(c); };
const auto its_derivative = [](const ball& c) { return 1 / (c * square(log(c))); };
auto exactly(const rational& q) {
  return [q](precision p) { return ball(q, p); };
}

TEST(SolveOnLogScale, FindsRootsOfEverySize) {
  for (const long n : {2L, 100L, 3000L, 2'000'000L}) {  // the last root is 1e-868588
    const precision p = 300;
    const root_enclosure r = solve_on_log_scale(minus_inverse_log, its_derivative,
                                                exactly(rational(1, n)), -4'000'000, -1, p);
    EXPECT_EQ(r.verdict, root_verdict::unique) << n;
    EXPECT_TRUE(overlaps(r.root, exp(ball(-n, p + 100)))) << n;
    EXPECT_TRUE(as_narrow_as(r.root, p - 8)) << n;
    EXPECT_TRUE(contains(r.box, r.root));
    EXPECT_FALSE(contains_zero(r.derivative));
  }
}

TEST(SolveOnLogScale, ExactlyTheThousandthPowerOfATenth) {
  const root_enclosure r =
      solve_on_log_scale([](const ball& c) { return pow(c, rational(1, 1000)); },
                         [](const ball& c) { return pow(c, rational(-999, 1000)) / 1000; },
                         exactly(rational(1, 10)), -4000, 10, 3500);
  EXPECT_EQ(r.verdict, root_verdict::unique);
  EXPECT_TRUE(contains(r.root, parse_rational("1e-1000")));
  EXPECT_TRUE(as_narrow_as(r.root, 3490));
  // A decreasing g.
  const root_enclosure s = solve_on_log_scale([](const ball& c) { return 1 / c; },
                                              [](const ball& c) { return -1 / square(c); },
                                              exactly(parse_rational("1e1000")), -4000, 10, 200);
  EXPECT_EQ(s.verdict, root_verdict::unique);
  EXPECT_TRUE(contains(s.root, parse_rational("1e-1000")));
}

TEST(SolveOnLogScale, SaysWhatItDoesNotFind) {
  const root_enclosure none = solve_on_log_scale(minus_inverse_log, its_derivative,
                                                 exactly(rational(1, 3000)), -100, -1, 100);
  EXPECT_EQ(none.verdict, root_verdict::none);
  EXPECT_TRUE(none.root.is_undefined());
  const root_enclosure undefined = solve_on_log_scale(minus_inverse_log, its_derivative,
                                                      exactly(rational(1, 2)), -100, 1, 100, 512);
  EXPECT_NE(undefined.verdict, root_verdict::unique);  // log(1) = 0 lies in the range
  EXPECT_THROW(static_cast<void>(
                   solve_on_log_scale(minus_inverse_log, its_derivative, exactly(1), 3, -3, 100)),
               input_error);
}

}  // namespace inverse_test
}  // namespace polhode
