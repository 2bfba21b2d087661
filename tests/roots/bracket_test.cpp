// Bracketing by sign: a change of sign is proved, or nothing is.

#include <gtest/gtest.h>

#include "polhode/roots/newton.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace bracket_test {

ball box_of(const rational& low, const rational& high) {
  return hull(ball(low, 64), ball(high, 64));
}

/// x as a function of the precision: the library's calling convention with an exact x.
ball with(const ball& x, precision p) { return x.with_precision(std::max(p, x.precision())); }

TEST(BracketBySign, HalvesTheInterval) {
  const auto f = [](const ball& x, precision p) { return square(with(x, p)) - 2; };
  for (const long bits : {0L, 1L, 10L, 60L, 300L}) {
    const sign_bracket result = bracket_by_sign(f, box_of(1, 2), bits);
    EXPECT_EQ(result.verdict, status::certified);
    EXPECT_EQ(result.why, reason::none);
    const support::exact_set set = support::exact(result.interval);
    EXPECT_TRUE(*set.lower * *set.lower < 2 && *set.upper * *set.upper > 2) << bits;
    EXPECT_LE(set.width(), support::power_of_two(-bits) + support::power_of_two(-bits - 8)) << bits;
    EXPECT_EQ(result.evaluations, bits + 2);
  }
}

TEST(BracketBySign, FollowsTheSignOfADecreasingFunction) {
  const auto f = [](const ball& x, precision p) { return cos(with(x, p)); };
  const sign_bracket result = bracket_by_sign(f, box_of(1, 2), 200);
  EXPECT_EQ(result.verdict, status::certified);
  EXPECT_TRUE(support::meet(result.interval, scale(pi(400), -1)));
  EXPECT_TRUE(result.interval.radius() <= magnitude::power_of_two(-200));
}

TEST(BracketBySign, StopsAtAnExactZero) {
  const auto f = [](const ball& x, precision p) { return with(x, p) - rational(3, 8); };
  const sign_bracket middle = bracket_by_sign(f, box_of(0, 1), 100);
  EXPECT_EQ(middle.verdict, status::certified);
  EXPECT_TRUE(middle.interval.is_exact());
  EXPECT_TRUE(support::holds(middle.interval, rational(3, 8)));
  for (const auto& [low, high] :
       {std::pair{rational(3, 8), rational(1)}, std::pair{rational(0), rational(3, 8)},
        std::pair{rational(3, 8), rational(3, 8)}}) {
    const sign_bracket end = bracket_by_sign(f, box_of(low, high), 100);
    EXPECT_EQ(end.verdict, status::certified);
    EXPECT_TRUE(end.interval.is_exact());
    EXPECT_TRUE(support::holds(end.interval, rational(3, 8)));
  }
}

TEST(BracketBySign, RefusesEqualSigns) {
  const auto f = [](const ball& x, precision p) { return square(with(x, p)) - 2; };
  for (const auto& box : {box_of(2, 3), box_of(-1, 1), box_of(-2, 2)}) {
    const sign_bracket result = bracket_by_sign(f, box, 100);
    EXPECT_EQ(result.verdict, status::not_certified);
    EXPECT_EQ(result.why, reason::refuted);
    EXPECT_TRUE(support::identical(result.interval, box));
  }
}

TEST(BracketBySign, RefusesUnknownSigns) {
  const auto logarithm = [](const ball& x, precision p) { return log(with(x, p)); };
  EXPECT_EQ(bracket_by_sign(logarithm, box_of(-1, 3), 100).why, reason::not_defined);
  EXPECT_EQ(bracket_by_sign(logarithm, box_of(-1, 3), 100).verdict, status::not_certified);
  EXPECT_EQ(bracket_by_sign(logarithm, box_of(rational(1, 2), 3), 10).verdict, status::certified);
  EXPECT_EQ(bracket_by_sign(logarithm, ball::entire(64), 10).why, reason::not_defined);
  EXPECT_EQ(bracket_by_sign(logarithm, ball::undefined(64), 10).why, reason::not_defined);
  // sin(pi x) is 0 at 1, but no precision shows it.
  const auto sine = [](const ball& x, precision p) { return sin(pi(p) * with(x, p)); };
  const sign_bracket unknown = bracket_by_sign(sine, box_of(rational(1, 2), 1), 10, 1024);
  EXPECT_EQ(unknown.verdict, status::not_certified);
  EXPECT_EQ(unknown.why, reason::not_defined);
  EXPECT_LE(unknown.evaluations, 8);
  // At a middle it only stops the bisection.
  const sign_bracket stopped =
      bracket_by_sign(sine, box_of(rational(1, 2), rational(3, 2)), 10, 1024);
  EXPECT_EQ(stopped.verdict, status::certified);
  EXPECT_TRUE(support::holds(stopped.interval, rational(1, 2)));
  EXPECT_TRUE(support::holds(stopped.interval, rational(3, 2)));
}

TEST(BracketBySign, RaisesThePrecisionWhereASignAsksForIt) {
  // The root is 2^-500 above 1: at 64 bits f(1) is not told from 0.
  const rational root = 1 + support::power_of_two(-500);
  const auto f = [&](const ball& x, precision p) {
    return ball(root, p) - with(x, p) + scale(pi(p) - pi(p), -300);
  };
  const sign_bracket result = bracket_by_sign(f, box_of(1, 2), 20);
  EXPECT_EQ(result.verdict, status::certified);
  EXPECT_TRUE(support::holds(result.interval, root));
  EXPECT_EQ(bracket_by_sign(f, box_of(1, 2), 20, 256).why, reason::not_defined);
}

TEST(BracketBySign, BracketsRandomRationalRoots) {
  support::random_source random(4);
  for (support::repeat trial(300); trial.again();) {
    const rational r(random.between(-1000, 1000), random.between(1, 1000));
    const long slope = random.one_in(2) ? 3 : -3;
    const auto f = [&](const ball& x, precision p) { return slope * (with(x, p) - r); };
    const rational low = r - rational(random.between(1, 1000), 997);
    const rational high = r + rational(random.between(1, 1000), 991);
    const long bits = random.between(0, 150);
    const sign_bracket result = bracket_by_sign(f, box_of(low, high), bits);
    EXPECT_EQ(result.verdict, status::certified);
    EXPECT_TRUE(support::holds(result.interval, r));
    EXPECT_LE(support::exact(result.interval).width(),
              (high - low) * support::power_of_two(-bits) * rational(17, 16) +
                  support::power_of_two(-60));
  }
}

TEST(RootVerdict, HasAName) {
  EXPECT_EQ(to_text(root_verdict::unique), "unique");
  EXPECT_EQ(to_text(root_verdict::none), "none");
  EXPECT_EQ(to_text(root_verdict::unresolved), "unresolved");
}

}  // namespace bracket_test
}  // namespace polhode
