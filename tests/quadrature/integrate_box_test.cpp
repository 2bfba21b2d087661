// Integrals with parameters in boxes: they hold the integral for every parameter, and how tightly.

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/integrate_box.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"
#include "tiling/tiling.hpp"

namespace polhode {
namespace integrate_box_test {

using support::described;
using support::power_of_ten;

constexpr precision exact_bits = 300;
ball number(const rational& q) { return ball(q, exact_bits); }
end_point half_pi() {
  return end_point([](precision p) { return pi(p) / 2; });
}

constexpr auto exponential = [](const auto& x, const auto& p) { return exp(p[0] * x); };
/// (e^p - 1)/p.
ball exponential_value(const rational& p) { return p == 0 ? number(1) : expm1(number(p)) / p; }

constexpr auto elliptic = [](const auto& t, const auto& p) {
  return 1 / sqrt(1 - p[0] * square(sin(t)));
};
/// K(m) = pi/(2 agm(1, sqrt(1 - m))).
ball elliptic_value(const rational& m) {
  return pi(exact_bits) / (2 * agm(number(1), sqrt(number(1 - m))));
}

rational between(support::random_source& random, const parameter_range& range) {
  return range.lower() + range.width() * rational(random.between(0, 1000), 1000);
}

/// Each end is as far outward of the true end as 10^-digits of it at most, and not inward.
::testing::AssertionResult has_ends(const box_integral& i, const ball& least, const ball& greatest,
                                    long digits) {
  const ball low(lower_rational(i.enclosure), exact_bits);
  const ball high(upper_rational(i.enclosure), exact_bits);
  const rational slack = 3 * power_of_ten(-digits);
  if (i.verdict == status::certified && certainly_less_equal(low, least) &&
      certainly_less_equal(greatest, high) &&
      certainly_less_equal(least - low, abs(least) * slack) &&
      certainly_less_equal(high - greatest, abs(greatest) * slack)) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << described(i.enclosure) << " for " << least << " ... " << greatest << ' ' << i.obstacle;
}

TEST(IntegrateBox, MonotoneInItsParameterTheRangeIsExact) {
  for (const parameter_range& range :
       {parameter_range(1, rational(11, 10)), parameter_range(-5, 5), parameter_range(0, 20),
        parameter_range(1, 1 + power_of_ten(-30))}) {
    const box_integral i = integrate_box(exponential, 0, 1, {range}, {.digits = 30});
    EXPECT_TRUE(i.attained);
    EXPECT_TRUE(
        has_ends(i, exponential_value(range.lower()), exponential_value(range.upper()), 30));
  }
}

TEST(IntegrateBox, TheEllipticIntegralOverARangeOfModuli) {
  const box_integral i =
      integrate_box(elliptic, 0, half_pi(), {{rational(1, 10), rational(1, 5)}}, {.digits = 40});
  EXPECT_TRUE(i.attained);
  EXPECT_TRUE(has_ends(i, elliptic_value(rational(1, 10)), elliptic_value(rational(1, 5)), 40));
  EXPECT_EQ(i.integrals, 5);  // direct, of the slope, in the middle, and at both ends
  // From 4 to 0, backwards: falling.
  const box_integral back =
      integrate_box(elliptic, half_pi(), 0, {{rational(1, 10), rational(1, 5)}}, {.digits = 40});
  EXPECT_TRUE(
      has_ends(back, -elliptic_value(rational(1, 5)), -elliptic_value(rational(1, 10)), 40));
}

TEST(IntegrateBox, APointIsAnIntegral) {
  const box_integral i = integrate_box(elliptic, 0, half_pi(), {rational(1, 3)}, {.digits = 40});
  EXPECT_TRUE(i.attained);
  EXPECT_EQ(i.integrals, 1);
  EXPECT_TRUE(contains(i.enclosure, elliptic_value(rational(1, 3))));
  const box_integral none =
      integrate_box([](const auto& x, const auto&) { return exp(x); }, 0, 1, {}, {.digits = 20});
  EXPECT_TRUE(contains(none.enclosure, exponential_value(1)));
}

/// e^(px) cos(qx) from 0 to 1: the real part of (e^w - 1)/w, w = p + qi.
constexpr auto wave = [](const auto& x, const auto& p) { return exp(p[0] * x) * cos(p[1] * x); };
ball wave_value(const rational& p, const rational& q) {
  const complex_ball w(p, q, exact_bits);
  return ((exp(w) - 1) / w).re;
}

TEST(IntegrateBox, TwoParameters) {
  // It rises with p and falls with q, for q < pi/2 or so.
  const std::vector<parameter_range> box{{1, rational(6, 5)}, {rational(1, 2), 1}};
  const box_integral i = integrate_box(wave, 0, 1, box, {.digits = 25});
  EXPECT_TRUE(i.attained);
  EXPECT_TRUE(has_ends(i, wave_value(1, 1), wave_value(rational(6, 5), rational(1, 2)), 25));
  support::random_source random(3);
  for (support::repeat trial(6); trial.again();) {
    const auto range = [&](long width) {
      const rational low(random.between(-300, 300), 100);
      return parameter_range(low, low + rational(random.between(0, width), 100));
    };
    const std::vector<parameter_range> any{range(40), range(60)};
    const box_integral over = integrate_box(wave, 0, 1, any, {.digits = 10, .most_boxes = 2});
    ASSERT_EQ(over.verdict, status::certified) << over.obstacle;
    for (int k = 0; k < 12; ++k) {
      const rational p = between(random, any[0]);
      const rational q = between(random, any[1]);
      if (p == 0 && q == 0) continue;
      EXPECT_TRUE(contains(over.enclosure, wave_value(p, q))) << p << ' ' << q;
    }
    EXPECT_TRUE(contains(over.enclosure, wave_value(any[0].upper(), any[1].upper())))
        << any[0].upper();
    EXPECT_TRUE(contains(over.enclosure, wave_value(any[0].lower(), any[1].upper())));
    EXPECT_TRUE(contains(over.enclosure, wave_value(any[0].upper(), any[1].lower())));
  }
}

/// (x - p)^2 from 0 to 1: 1/3 - p + p^2, with the least value 1/12 at p = 1/2.
constexpr auto parabola = [](const auto& x, const auto& p) { return square(x - p[0]); };

TEST(IntegrateBox, WhereItIsNotMonotoneTheExcessIsOfSecondOrder) {
  for (const long e : {1L, 2L, 4L}) {
    const rational half = power_of_ten(-e);
    const box_integral i = integrate_box(
        parabola, 0, 1, {{rational(1, 2) - half, rational(1, 2) + half}}, {.digits = 30});
    EXPECT_EQ(i.verdict, status::certified);
    EXPECT_FALSE(i.attained);
    // The true range is [1/12, 1/12 + half^2]; the mean value form is 1/12 +- 2 half^2.
    EXPECT_TRUE(contains(i.enclosure, rational(1, 12)));
    EXPECT_TRUE(contains(i.enclosure, rational(rational(1, 12) + half * half)));
    EXPECT_LE(upper_rational(i.enclosure) - lower_rational(i.enclosure),
              4 * half * half * rational(101, 100));
  }
}

// The parts that a box was cut into, as they come back: a part left out, done twice or with a wrong
// end is refused.
bool is_whole(const detail::exact_sides& whole, const std::vector<detail::exact_sides>& parts) {
  std::vector<const detail::exact_sides*> pointers;
  for (const auto& part : parts) pointers.push_back(&part);
  return detail::is_tiling(whole, pointers);
}

TEST(BoxTiling, LiesAreRefused) {
  using box = detail::exact_sides;
  const auto from = [](const rational& a, const rational& b) {
    return detail::exact_interval{a, b};
  };
  const detail::exact_interval seven{7, 7};
  const rational tiny = power_of_ten(-50);
  const box whole{from(0, 2), seven, from(0, 2)};
  EXPECT_TRUE(is_whole(whole, {whole}));
  EXPECT_TRUE(is_whole(box{}, {box{}}));
  EXPECT_FALSE(is_whole(whole, {}));
  EXPECT_FALSE(is_whole(whole, {whole, whole}));
  EXPECT_FALSE(is_whole(whole, {box{from(0, 2), seven}}));
  const std::vector<box> parts{{from(1, 2), seven, from(0, 2)},
                               {from(0, 1), seven, from(0, 1)},
                               {from(0, 1), seven, from(1, 2)}};
  EXPECT_TRUE(is_whole(whole, parts));
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::vector<box> changed = parts;
    changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_FALSE(is_whole(whole, changed));
    changed.push_back(changed.front());
    EXPECT_FALSE(is_whole(whole, changed));
    for (const std::size_t i : {0U, 2U}) {
      for (const rational& by : {tiny, rational(-tiny)}) {
        changed = parts;
        changed[k][i] = from(*parts[k][i].lower + by, *parts[k][i].upper);
        EXPECT_FALSE(is_whole(whole, changed)) << k << ' ' << i;
        changed[k][i] = from(*parts[k][i].lower, *parts[k][i].upper + by);
        EXPECT_FALSE(is_whole(whole, changed)) << k << ' ' << i;
      }
    }
    changed = parts;
    changed[k][1] = {8, 8};
    EXPECT_FALSE(is_whole(whole, changed));
  }
}

TEST(BoxTiling, RandomBisections) {
  support::random_source random(8);
  for (support::repeat trial(40); trial.again();) {
    detail::exact_sides whole;
    for (long n = random.between(1, 3); n > 0; --n) {
      const rational low = random.any_rational(20);
      whole.push_back({low, rational(low + rational(random.between(1, 99), 7))});
    }
    std::vector<detail::exact_sides> parts{whole};
    const auto any = [&](const auto& list) {
      return static_cast<std::size_t>(random.between(0, static_cast<long>(list.size()) - 1));
    };
    for (long cuts = random.between(1, 40); cuts > 0; --cuts) {
      const std::size_t k = any(parts);
      const std::size_t i = any(whole);
      const detail::exact_interval side = parts[k][i];
      parts.push_back(parts[k]);
      parts[k][i] = {side.lower, side.middle()};
      parts.back()[i] = {side.middle(), side.upper};
    }
    EXPECT_TRUE(is_whole(whole, parts));
    const std::size_t k = any(parts);
    const std::size_t i = any(whole);
    std::vector<detail::exact_sides> changed = parts;
    changed[k][i] = {changed[k][i].lower, changed[k][i].middle()};
    EXPECT_FALSE(is_whole(whole, changed));
    changed = parts;
    changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_FALSE(is_whole(whole, changed));
    changed = parts;
    changed.push_back(parts[k]);
    EXPECT_FALSE(is_whole(whole, changed));
  }
}

TEST(IntegrateBox, MoreBoxesAreTighter) {
  const std::vector<parameter_range> box{{rational(2, 5), rational(7, 10)}};
  rational last = 1;
  for (const long boxes : {1L, 4L, 16L, 64L}) {
    const box_integral i = integrate_box(parabola, 0, 1, box, {.digits = 12, .most_boxes = boxes});
    EXPECT_LE(i.boxes, boxes);
    // [1/12, 37/300].
    EXPECT_TRUE(contains(i.enclosure, rational(1, 12)));
    EXPECT_TRUE(contains(i.enclosure, rational(37, 300)));
    const rational excess =
        upper_rational(i.enclosure) - lower_rational(i.enclosure) - rational(12, 300);
    EXPECT_LT(excess, last);
    last = excess;
  }
  EXPECT_LE(last, rational(4, 10'000));  // 1 % of the range
}

TEST(IntegrateBox, NarrowBoxesAreHardlyWiderThanTheRange) {
  // Not monotone by its signs: q goes through a zero of the slope while p decides the width.
  const std::vector<parameter_range> box{{1, rational(1001, 1000)},
                                         {-power_of_ten(-3), power_of_ten(-3)}};
  const box_integral i = integrate_box(wave, 0, 1, box, {.digits = 20});
  EXPECT_FALSE(i.attained);
  const ball true_width = wave_value(rational(1001, 1000), 0) - wave_value(1, power_of_ten(-3));
  const ball width(rational(upper_rational(i.enclosure) - lower_rational(i.enclosure)), exact_bits);
  EXPECT_TRUE(certainly_less_equal(true_width, width));
  EXPECT_TRUE(certainly_less_equal(width, true_width * rational(101, 100))) << width / true_width;
}

TEST(IntegrateBox, WhatIsSingularForSomeParameterIsRefused) {
  const auto pole = [](const auto& x, const auto& p) { return 1 / (x + p[0]); };
  for (const long boxes : {1L, 4L}) {
    const box_integral i = integrate_box(pole, 0, 1, {{-rational(1, 2), rational(1, 2)}},
                                         {.digits = 10, .most_boxes = boxes});
    EXPECT_EQ(i.verdict, status::not_certified);
    EXPECT_EQ(i.why, reason::not_analytic);
    EXPECT_TRUE(i.enclosure.is_undefined());
    EXPECT_NE(i.obstacle.find("the pole of /"), std::string::npos) << i.obstacle;
  }
  const box_integral beside =
      integrate_box(pole, 0, 1, {{rational(1, 10), rational(1, 2)}}, {.digits = 20});
  EXPECT_TRUE(has_ends(beside, log(number(3)), log(number(11)), 20));
  // The slope of log(p + x) is defined for negative p + x, where log is not.
  const auto logarithm = [](const auto& x, const auto& p) { return log(x + p[0]); };
  const box_integral cut = integrate_box(logarithm, 1, 2, {{-3, 1}}, {.digits = 10});
  EXPECT_EQ(cut.verdict, status::not_certified);
  const box_integral wholly = integrate_box(logarithm, 1, 2, {{-4, -3}}, {.digits = 10});
  EXPECT_EQ(wholly.verdict, status::not_certified);
  EXPECT_TRUE(wholly.enclosure.is_undefined());
}

TEST(IntegrateBox, WhereNoDerivativeIsHadTheDirectEnclosureStands) {
  // Singular ends and infinite ranges are described by series, of which there are no derivatives.
  const box_integral root = integrate_box(
      [](const auto& x, const auto& p) { return p[0] / sqrt(x); }, 0, 1, {{1, 2}}, {.digits = 10});
  EXPECT_EQ(root.verdict, status::certified) << root.obstacle;
  EXPECT_FALSE(root.attained);
  EXPECT_TRUE(contains(root.enclosure, rational(2)) && contains(root.enclosure, rational(4)));
  const box_integral decay =
      integrate_box([](const auto& x, const auto& p) { return exp(-p[0] * x); }, 0,
                    end_point::infinity(), {{1, rational(11, 10)}}, {.digits = 10});
  EXPECT_EQ(decay.verdict, status::certified) << decay.obstacle;
  EXPECT_TRUE(contains(decay.enclosure, rational(1)) &&
              contains(decay.enclosure, rational(10, 11)));
}

TEST(IntegrateBox, GivesUpSoonWhereABreakMovesWithAParameter) {
  const box_integral i =
      integrate_box([](const auto& x, const auto& p) { return sqrt(square(x - p[0])); }, 0, 1,
                    {{rational(3, 10), rational(4, 10)}}, {.digits = 10});
  EXPECT_NE(i.verdict, status::certified);
}

TEST(IntegrateBox, MisuseThrows) {
  EXPECT_THROW(parameter_range(2, 1), std::invalid_argument);
  EXPECT_THROW(parameter_range(ball::undefined(64)), std::invalid_argument);
  EXPECT_THROW((void)integrate_box(exponential, 0, 1, {{0, 1}}, {.digits = 0}),
               std::invalid_argument);
  EXPECT_THROW((void)integrate_box(exponential, 0, 1, {{0, 1}}, {.most_boxes = 0}),
               std::invalid_argument);
  const parameter_range from_ball(ball(1, 64).enlarged(magnitude::power_of_two(-3)));
  EXPECT_EQ(from_ball.lower(), rational(7, 8));
  EXPECT_EQ(from_ball.upper(), rational(9, 8));
}

}  // namespace integrate_box_test
}  // namespace polhode
