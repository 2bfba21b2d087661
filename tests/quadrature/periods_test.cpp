// Ranges of many periods: which are found, and what is made of them.

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/formula/periods.hpp"

namespace polhode {
namespace periods_test {

template <class F>
std::optional<detail::whole_periods> periods_of(const F& f, const end_point& a,
                                                const end_point& b) {
  return detail::whole_periods_of(integrand_of(formula_of(f)), a, b);
}

constexpr auto sine = [](const auto& x) { return sin(x); };

TEST(Periods, AreCountedAndWhatIsLeftIsExact) {
  const auto found = periods_of(sine, 0, 1000);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->count, 159);  // 1000/(2 pi) = 159.15...
  EXPECT_EQ(*found->first_end.form(), (pi_combination{0, 2}));
  ASSERT_TRUE(found->rest_end.has_value());
  EXPECT_EQ(*found->rest_end->form(), (pi_combination{1000, -318}));
}

TEST(Periods, OfAWholeNumberNothingIsLeft) {
  const auto found =
      periods_of(sine, end_point::pi(rational(1, 3)), end_point::pi(rational(601, 3)));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->count, 100);
  EXPECT_FALSE(found->rest_end.has_value());
}

TEST(Periods, OfSeveralFunctionsAreCommon) {
  const auto f = [](const auto& x) { return sin(x * 3 / 2) + cos(x * 5 / 3) * tan(x / 4); };
  const auto found = periods_of(f, 0, end_point::pi(24 * 100));
  ASSERT_TRUE(found.has_value());  // gcd(3/2, 5/3, 1/4) = 1/12
  EXPECT_EQ(found->count, 100);
  const auto with_pi = periods_of([](const auto& x) { return exp(sin(x * pi(400) / 7)); }, 0, 1400);
  // The slope is a ball that symmetries do not see through: nothing is claimed.
  EXPECT_FALSE(with_pi.has_value());
}

TEST(Periods, AreNotFoundWhereThereAreNoneOrFew) {
  EXPECT_FALSE(periods_of(sine, 0, 300).has_value());
  EXPECT_FALSE(periods_of([](const auto& x) { return sin(x * x); }, 0, 100'000).has_value());
  EXPECT_FALSE(periods_of([](const auto& x) { return sin(x) * x; }, 0, 100'000).has_value());
  EXPECT_FALSE(
      periods_of([](const auto& x) { return sin(x) + sin(x) / x; }, 1, 100'000).has_value());
  EXPECT_FALSE(periods_of([](const auto& x) { return exp(-x); }, 0, 100'000).has_value());
}

TEST(Periods, ManyOfThemCostNoMoreThanOne) {
  integer n;
  mpz_ui_pow_ui(n.backend().data(), 10, 30);
  // 1/(2 + sin) has the mean 1/sqrt(3).
  const auto f = [](const auto& x) { return 1 / (2 + sin(x)); };
  const integral found = integrate(f, 0, end_point::pi(rational(2 * n)), {.digits = 40});
  ASSERT_EQ(found.verdict, status::certified) << found.obstacle;
  EXPECT_TRUE(overlaps(found.enclosure, 2 * pi(300) / sqrt(ball(3, 300)) * n));
  EXPECT_LE(found.account.evaluations + found.account.region_evaluations, 1000);
}

TEST(Periods, WhatIsLeftIsAddedAtInexactEndsToo) {
  const end_point a([](precision p) { return sqrt(ball(2, p)); });
  const end_point b([](precision p) { return 1'000'000'000 * sqrt(ball(3, p)); });
  const integral found = integrate(sine, a, b, {.digits = 40});
  ASSERT_EQ(found.verdict, status::certified) << found.obstacle;
  EXPECT_TRUE(overlaps(found.enclosure, cos(a.at(400)) - cos(b.at(400))));
  const integral reversed = integrate(sine, b, a, {.digits = 40});
  EXPECT_TRUE(overlaps(reversed.enclosure, cos(b.at(400)) - cos(a.at(400))));
}

TEST(Periods, PolesInThemAreRefused) {
  const auto f = [](const auto& x) { return 1 / sin(x); };
  EXPECT_EQ(integrate(f, 1, 1'000'000).verdict, status::not_certified);
  // In what is left alone there is none.
  EXPECT_EQ(integrate(f, 1, 2, {.digits = 20}).verdict, status::certified);
}

}  // namespace periods_test
}  // namespace polhode
