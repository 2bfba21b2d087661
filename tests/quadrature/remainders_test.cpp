// The parts of a range that the segments leave out, with few bits: the enclosures hold the exact
// integrals, and the remainder of a whole is not smaller than those of its parts.

#include <gtest/gtest.h>

#include "polhode/expression/formula_of.hpp"
#include "polhode/expression/parse.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/pieces/end_plan.hpp"
#include "quadrature/pieces/segments.hpp"
#include "support/random.hpp"

namespace polhode {
namespace remainders_test {

constexpr precision p = 400;
constexpr long few_bits = 1;

/// Half the width.
rational radius_of(const ball& x) { return (upper_rational(x) - lower_rational(x)) / 2; }

/// All of x lies in the set.
bool holds(const ball& set, const ball& x) {
  return lower_rational(set) <= lower_rational(x) && upper_rational(x) <= upper_rational(set);
}

ball value_of(const detail::preparation& prepared) {
  const integrate_options options{.digits = 60};
  return detail::integrate_segments(prepared, options).enclosure.re;
}

detail::preparation prepared(const std::string& f, const end_point& a, const end_point& b) {
  return detail::prepare(integrand_of(parse(f)), a, b, {}, few_bits);
}

/// floor(3 sin x) and floor(6 sin x) jump at the same irrational points, which no number of bits
/// tells apart: each time a piece is left out. floor(-y) = -floor(y) - 1 for almost all y, so that
/// the integral of floor(m sin x) over a period is -pi.
const std::string two_jumps = "floor(3*sin(x))+floor(6*sin(x))";

TEST(Remainders, OfPeriodsAreCountedAsOftenAsThePeriods) {
  for (const long count : {64L, 1000L, 10'000'000L}) {
    const auto periods = prepared(two_jumps, 0, end_point::pi(2 * count));
    ASSERT_EQ(periods.why, reason::none);
    EXPECT_TRUE(holds(value_of(periods), -2 * pi(p) * count)) << count;
    const auto one = prepared(two_jumps, 0, end_point::pi(2));
    EXPECT_GT(radius_of(one.remainder), 0);
    EXPECT_GE(radius_of(periods.remainder), count * radius_of(one.remainder)) << count;
  }
}

TEST(Remainders, OfWhatIsLeftBesidePeriodsAreAdded) {
  const auto rest = prepared(two_jumps, 0, end_point::pi(1));
  const auto one = prepared(two_jumps, 0, end_point::pi(2));
  const auto all = prepared(two_jumps, 0, end_point::pi(2 * 64 + 1));
  ASSERT_EQ(all.why, reason::none);
  EXPECT_GT(radius_of(rest.remainder), 0);
  EXPECT_GE(radius_of(all.remainder), 64 * radius_of(one.remainder) + radius_of(rest.remainder));
}

/// -1 between q and q + d, 1 elsewhere. Where the two jumps are in one piece that is left out, the
/// integral of 1 over it is too great by 2 d.
std::string pulse(const rational& q, const rational& d) {
  const auto sign_at = [](const rational& at) { return "(1+2*floor(x-(" + to_text(at) + ")))"; };
  return sign_at(q) + "*" + sign_at(rational(q + d));
}

TEST(Remainders, OfBreaksThatCannotBeToldApartHoldThePulse) {
  support::random_source random(71);
  int left_out = 0;
  for (support::repeat trial(400); trial.again();) {
    const rational q = random.between(1, 1'000'000) / rational(1'000'003);
    const rational d = rational(random.between(1, 1 << 20), 1 << 20) /
                       rational(integer(1) << static_cast<unsigned>(random.between(60, 200)));
    const auto parts = prepared(pulse(q, d), 0, 1);
    ASSERT_EQ(parts.why, reason::none);
    if (radius_of(parts.remainder) > 0) ++left_out;
    EXPECT_TRUE(holds(value_of(parts), ball(rational(1 - 2 * d), p)))
        << "q = " << q << ", d = " << d << ", remainder " << parts.remainder;
  }
  EXPECT_GT(left_out, 0);
}

// Two jumps somewhere in [q - r, q + r], which is left out: the function may be -1 on all of it and
// 1 elsewhere, or 1 everywhere. It then differs by 2 from what stands for it, wherever it is left
// out.
TEST(Remainders, OfBreaksInABallHoldAllThatMayBe) {
  support::random_source random(72);
  for (long exponent = 55; exponent <= 70; ++exponent) {
    const rational q = random.between(1, 1'000'000) / rational(1'000'003);
    const rational r = rational(1) / rational(integer(1) << static_cast<unsigned>(exponent));
    const ball at = ball(q, p).enlarged(magnitude::power_of_two(-exponent));
    const auto parts = detail::prepare(integrand_of(formula_of([&](const auto& x) {
                                         return (1 + 2 * floor(x - at)) * (1 + 2 * floor(x - at));
                                       })),
                                       0, 1, {}, few_bits);
    ASSERT_EQ(parts.why, reason::none);
    const ball value = value_of(parts);
    EXPECT_TRUE(holds(value, ball(1, p))) << exponent;
    EXPECT_TRUE(holds(value, ball(rational(1 - 4 * r), p))) << exponent;
    EXPECT_GE(radius_of(parts.remainder), 4 * r) << exponent;
  }
}

/// f is at least `least` on what is left out at the end 0.
void expect_growth_to_hold(const std::string& f, const rational& least) {
  detail::integrand g = integrand_of(parse(f));
  g.in_exponential = nullptr;  // which would be preferred
  const detail::ends::end_plan plan = detail::ends::look_at_end(
      g, detail::ends::end_of_range::finite(end_point(0), end_point(rational(1, 2))));
  ASSERT_TRUE(plan.has_growth_only) << f;
  const auto parts = detail::prepare(g, 0, end_point(rational(1, 2)), {}, few_bits);
  ASSERT_EQ(parts.why, reason::none) << f;
  ASSERT_FALSE(parts.parts.empty());
  const ball cut = parts.parts.front().to.at(p);
  ASSERT_TRUE(certainly_less(ball(0, p), cut)) << f;
  EXPECT_GE(upper_rational(parts.remainder), least * lower_rational(cut)) << f;
}

TEST(Remainders, OfAnEndThatOnlyItsGrowthDescribesHoldTheFunction) {
  expect_growth_to_hold("x^x", rational(99, 100));
  expect_growth_to_hold("7*x^x", rational(99 * 7, 100));
  // The bound is attained to 2 percent.
  expect_growth_to_hold("x^(x^4)", rational(99, 100));
  expect_growth_to_hold("3*x^(x^4)", rational(3 * 99, 100));
}

}  // namespace remainders_test
}  // namespace polhode
