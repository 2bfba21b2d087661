// Bodies: the order of the axes, the kind decided exactly, both geometric constants, ranges of
// moments, refusals.

#include "polhode/rigid_body/body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/rigid_body/regime.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace body_test {

using support::agrees;
using support::as_narrow_as;
using support::meet;

std::string refusal(const std::function<void()>& f) {
  try {
    f();
  } catch (const input_error& e) {
    return e.what();
  }
  return "";
}

void expect_refused(const std::function<void()>& f, const std::vector<std::string>& words) {
  const std::string said = refusal(f);
  EXPECT_NE(said, "");
  for (const std::string& word : words) {
    EXPECT_NE(said.find(word), std::string::npos) << word << " in " << said;
  }
}

TEST(Body, OrdersMomentsInEveryOrder) {
  std::array<int, 3> to_given{0, 1, 2};
  const std::array<rational, 3> sorted{3, 2, 1};
  do {
    std::array<rational, 3> given;
    for (std::size_t i = 0; i < 3; ++i) given[static_cast<std::size_t>(to_given[i])] = sorted[i];
    const body b = body::from_moments(given);
    EXPECT_EQ(b.a().exact(), 1);
    EXPECT_EQ(b.b().exact(), rational(1, 3));
    EXPECT_EQ(*b.moments(), sorted);
    EXPECT_EQ(b.order(), to_given);
    EXPECT_EQ(b.kind(), body_kind::planar);
    EXPECT_EQ(b.exact_geometric_constant(), rational(1));
  } while (std::next_permutation(to_given.begin(), to_given.end()));
}

TEST(Body, KindIsExactAtTheBoundary) {
  const rational tiny = support::power_of_ten(-5000);
  for (const rational& b : {rational(1, 4), rational(1, 3), rational(support::power_of_ten(-40))}) {
    const rational a(1 / b - 2);
    EXPECT_EQ(body(a, b).kind(), body_kind::planar);
    EXPECT_EQ(body(a, b).exact_geometric_constant(), rational(1));
    EXPECT_EQ(body(a - tiny, b).kind(), body_kind::physical);
    EXPECT_EQ(body(a + tiny, b).kind(), body_kind::non_physical);
    // The constant agrees as soon as its enclosure tells.
    EXPECT_TRUE(certainly_greater(body(a - tiny, b).geometric_constant(20'000), 1));
    EXPECT_TRUE(certainly_less(body(a + tiny, b).geometric_constant(20'000), 1));
  }
}

TEST(Body, KindIsWhatTheMomentsSay) {
  support::random_source random(71);
  for (support::repeat trial(500); trial.again();) {
    const rational x = random.between(1, 12);
    const rational y = random.between(1, 12);
    const rational z = random.between(1, 12);
    if (x == y || y == z || z == x) continue;
    const rational greatest = std::max({x, y, z});
    const rational others(x + y + z - greatest);
    const body_kind kind = body::from_moments({x, y, z}).kind();
    EXPECT_EQ(kind, greatest < others    ? body_kind::physical
                    : greatest == others ? body_kind::planar
                                         : body_kind::non_physical);
    EXPECT_EQ((uncertain_body({{{x, 0}, {y, 0}, {z, 0}}}).kind()), kind);
  }
}

TEST(Body, GeometricConstantsOfThePaper) {
  // mathematics.md: the values of the caption with b = 0.0629, and water from its rotational
  // constants, whose reciprocals are its moments.
  struct row {
    std::string_view a, i;
  };
  for (const row& r : {row{"12.65", "1.0479"}, row{"13.89", "1.0003"}, row{"15.38", "0.9508"},
                       row{"18.27", "0.8727"}}) {
    const body b(parse_rational(r.a), parse_rational("0.0629"));
    EXPECT_TRUE(agrees(b.geometric_constant(80), r.i, 20)) << r.a;
  }
  const auto water = [](const char* c, const char* b, const char* a) {
    return body::from_moments({rational(1 / parse_rational(c)), rational(1 / parse_rational(b)),
                               rational(1 / parse_rational(a))});
  };
  EXPECT_TRUE(agrees(water("9.28", "14.52", "27.88").geometric_constant(200),
                     "0.939995686340632609491131612197346752681353788", 44));
  EXPECT_TRUE(agrees(water("9.5077", "14.5924", "27.2660").geometric_constant(200),
                     "1.00055763055547661003051568225254525576887821", 44));
}

TEST(Body, SecondConstantDoesNotCancel) {
  // J = (1 + 2a - ab)/(a (a + b) (s + 1)): for a = 1e200 it is 1/a (1 - b/2 + O(1/a)), which the
  // formula as printed would lose in 600 bits.
  const body b(support::power_of_ten(200), rational(1, 2));
  EXPECT_TRUE(as_narrow_as(b.second_geometric_constant(100), 90));
  EXPECT_TRUE(agrees(b.second_geometric_constant(100), "7.50000000000000000000000e-201", 20));
  support::random_source random(72);
  for (support::repeat trial(100); trial.again();) {
    const body any(rational(random.between(1, 5000), random.between(1, 500)),
                   rational(random.between(1, 999), 1000));
    const ball as_printed =
        (ball(rational(any.a().exact() + 1), 300)) /
            sqrt(ball(rational(any.a().exact() * (any.a().exact() + any.b().exact())), 300)) -
        1;
    EXPECT_TRUE(meet(any.second_geometric_constant(200), as_printed));
    EXPECT_TRUE(as_narrow_as(any.second_geometric_constant(200), 190));
    if (const auto exact = any.exact_second_geometric_constant()) {
      EXPECT_TRUE(contains(as_printed, *exact));
    }
  }
  // a = 1, b = 15/49: a (a + b) = 64/49 and J = 2 * 7/8 - 1.
  EXPECT_EQ(body(1, rational(15, 49)).exact_second_geometric_constant(), rational(3, 4));
  EXPECT_FALSE(body(1, rational(1, 2)).exact_second_geometric_constant());
  EXPECT_FALSE(body(1, rational(1, 2)).exact_geometric_constant());
}

TEST(Body, RefusesWhatIsNone) {
  expect_refused([] { (void)body::from_moments({3, 0, 1}); }, {"3, 0, 1", "0 is not positive"});
  expect_refused([] { (void)body::from_moments({3, -2, 1}); }, {"-2 is not positive"});
  expect_refused(
      [] {
        (void)body::from_moments({2, 1, 2});
      },
      {"2, 1, 2", "symmetric top", "three different", "it is physical"});
  expect_refused([] { (void)body::from_moments({1, 1, 2}); }, {"symmetric top", "it is planar"});
  expect_refused([] { (void)body::from_moments({1, 1, 3}); }, {"it is non-physical"});
  expect_refused([] { (void)body::from_moments({2, 2, 2}); }, {"spherical top"});
  expect_refused([] { (void)body(0, rational(1, 2)); }, {"a = 0", "symmetric top"});
  expect_refused([] { (void)body(1, 0); }, {"b = 0", "symmetric top"});
  expect_refused([] { (void)body(-1, rational(1, 2)); }, {"a = -1", "positive"});
  expect_refused([] { (void)body(1, 1); }, {"b = 1", "between 0 and 1"});
  expect_refused([] { (void)body(1, rational(-1, 3)); }, {"b = -1/3", "between 0 and 1"});
}

// ---------------------------------------------------------------------------------------------

uncertain_body within(const std::array<const char*, 3>& values, const char* sigma) {
  const rational s = parse_rational(sigma);
  return uncertain_body({{{parse_rational(values[0]), s},
                          {parse_rational(values[1]), s},
                          {parse_rational(values[2]), s}}});
}

TEST(UncertainBody, IsUndecidedWhereMembersDiffer) {
  EXPECT_EQ(within({"2.5", "2", "1"}, "0.1").kind(), body_kind::physical);
  EXPECT_EQ(within({"3.5", "2", "1"}, "0.1").kind(), body_kind::non_physical);
  EXPECT_EQ(within({"3", "2", "1"}, "0.1").kind(), body_kind::undecided);
  EXPECT_EQ(within({"3", "2", "1"}, "0").kind(), body_kind::planar);
  // The ends are members: 2.7 + 0.1 = 1.9 + 0.9 is physical, and so all are; 3.3 - 0.1 = 2.1 + 1.1
  // is not above.
  EXPECT_EQ(within({"2.7", "2", "1"}, "0.1").kind(), body_kind::physical);
  EXPECT_EQ(within({"2.7", "2", "1"}, "0.1000001").kind(), body_kind::undecided);
  EXPECT_EQ(within({"3.3", "2", "1"}, "0.1").kind(), body_kind::undecided);
  EXPECT_EQ(within({"1", "3.3", "2"}, "0.0999999").kind(), body_kind::non_physical);
  // The order need not be known.
  EXPECT_EQ(within({"2", "2", "2"}, "0.1").kind(), body_kind::physical);
  EXPECT_FALSE(within({"2", "2", "2"}, "0.1").is_ordered());
  EXPECT_TRUE(within({"2", "2", "2"}, "0.1").geometric_constant(64).is_undefined());
  EXPECT_FALSE(within({"2.2", "2", "1"}, "0.1").is_ordered());  // they touch
  EXPECT_TRUE(within({"2.2", "2", "1"}, "0.09").is_ordered());
}

TEST(UncertainBody, RangesHoldEveryMemberAndNoMore) {
  support::random_source random(73);
  for (support::repeat trial(300); trial.again();) {
    const std::array<uncertain_moment, 3> given{{{300, random.between(1, 20)},
                                                 {random.between(190, 240), random.between(1, 20)},
                                                 {random.between(80, 140), random.between(1, 20)}}};
    const uncertain_body uncertain(given);
    ASSERT_TRUE(uncertain.is_ordered());
    const auto member = [&](const std::array<long, 3>& at) {  // in eighths of sigma
      std::array<rational, 3> moments;
      for (std::size_t i = 0; i < 3; ++i)
        moments[i] = given[i].value + given[i].sigma * rational(at[i], 8);
      return body::from_moments(moments);
    };
    const body any = member({random.between(-8, 8), random.between(-8, 8), random.between(-8, 8)});
    const auto holds = [](const ball& range, const ball& value) {
      return !certainly_less(value, range) && !certainly_less(range, value);
    };
    EXPECT_TRUE(holds(uncertain.geometric_constant(100), any.geometric_constant(100)));
    EXPECT_TRUE(
        holds(uncertain.second_geometric_constant(100), any.second_geometric_constant(100)));
    EXPECT_TRUE(contains(uncertain.a(100), any.a().exact()));
    EXPECT_TRUE(contains(uncertain.b(100), any.b().exact()));
    if (uncertain.kind() != body_kind::undecided) {
      EXPECT_EQ(any.kind() == body_kind::non_physical, uncertain.kind() == body_kind::non_physical);
    }
    // The ends are values at corners.
    const auto near = [](const ball& value, const rational& end) {
      return (value - ball(end, 200)).magnitude_upper() <= magnitude::power_of_two(-80);
    };
    const ball first = uncertain.geometric_constant(100);
    const ball second = uncertain.second_geometric_constant(100);
    EXPECT_TRUE(near(member({8, -8, -8}).geometric_constant(100), lower_rational(first)));
    EXPECT_TRUE(near(member({-8, 8, 8}).geometric_constant(100), upper_rational(first)));
    EXPECT_TRUE(near(member({8, 8, -8}).second_geometric_constant(100), lower_rational(second)));
    EXPECT_TRUE(near(member({-8, -8, 8}).second_geometric_constant(100), upper_rational(second)));
  }
}

TEST(UncertainBody, RefusesImpossibleRanges) {
  expect_refused([] { (void)within({"3", "2", "1"}, "-1"); }, {"sigma -1", "not be negative"});
  expect_refused(
      [] {
        (void)within({"3", "2", "1"}, "1");
      },
      {"moment of inertia 1", "not positive"});
}

// ---------------------------------------------------------------------------------------------

TEST(Regime, IsDecidedExactly) {
  const body b(2, rational(1, 4));
  const rational tiny = support::power_of_ten(-3000);
  EXPECT_EQ(regime_of(b, rational(-1, 4)), regime::equilibrium_x);
  EXPECT_EQ(regime_of(b, rational(-1, 4) + tiny), regime::oscillating);
  EXPECT_EQ(regime_of(b, -tiny), regime::oscillating);
  EXPECT_EQ(regime_of(b, 0), regime::separatrix);
  EXPECT_EQ(regime_of(b, tiny), regime::rotating);
  EXPECT_EQ(regime_of(b, 2 - tiny), regime::rotating);
  EXPECT_EQ(regime_of(b, 2), regime::equilibrium_z);
  expect_refused([&] { (void)regime_of(b, 3); }, {"c = 3", "-b = -1/4", "a = 2"});
  expect_refused([&] { (void)regime_of(b, rational(-1, 2)); }, {"c = -1/2", "-b = -1/4"});
  EXPECT_EQ(to_text(regime::oscillating), "oscillating");
}

}  // namespace body_test
}  // namespace polhode
