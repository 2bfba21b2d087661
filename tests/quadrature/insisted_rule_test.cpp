// Rules that are insisted on: the same values by each, or a refusal that says why.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadrature/known_integrals.hpp"

namespace polhode {
namespace insisted_rule_test {

using support::holds;

constexpr precision value_bits = 700;

integrate_options by(quadrature_rule rule, long digits = 60) {
  integrate_options options;
  options.digits = digits;
  options.rule = rule;
  return options;
}

template <class F>
void expect_certified(const F& f, const end_point& a, const end_point& b, const ball& value,
                      quadrature_rule rule) {
  for (const long digits : {3L, 20L, 150L}) {
    const integral i = integrate(f, a, b, by(rule, digits));
    EXPECT_EQ(i.verdict, status::certified) << to_text(rule) << ": " << i.obstacle;
    EXPECT_TRUE(holds(i, value)) << to_text(rule);
    EXPECT_EQ(i.account.rules, std::vector{rule});
    EXPECT_TRUE(multiply_up(i.enclosure.radius(), pow(ball(10, 64), digits).magnitude_lower()) <=
                i.enclosure.magnitude_upper());
  }
}

TEST(InsistedRule, EachGivesTheValue) {
  const ball p = pi(value_bits);
  const auto runge = [](const auto& x) { return 1 / (1 + 25 * square(x)); };
  const ball angle = 2 * atan(ball(5, value_bits)) / 5;
  for (const quadrature_rule rule :
       {quadrature_rule::gauss_legendre, quadrature_rule::clenshaw_curtis,
        quadrature_rule::double_exponential}) {
    expect_certified(runge, -1, 1, angle, rule);
    expect_certified([](const auto& x) { return exp(x); }, 1, 0, 1 - exp(ball(1, value_bits)),
                     rule);
    // Singular at an end.
    expect_certified([](const auto& x) { return sqrt(x) * (1 + x); }, 0, 1,
                     ball(16, value_bits) / 15, rule);
    expect_certified([](const auto& x) { return -log(x); }, 0, 1, ball(1, value_bits), rule);
    // Neither has a value there; near 2 the other's nodes are not told apart from it.
    if (rule != quadrature_rule::gauss_legendre) continue;
    expect_certified([](const auto& x) { return 1 / sqrt(x * (2 - x)); }, 0, 2, p, rule);
  }
  for (const quadrature_rule rule :
       {quadrature_rule::gauss_legendre, quadrature_rule::clenshaw_curtis,
        quadrature_rule::trapezoid}) {
    expect_certified([](const auto& x) { return 1 / (5 - 4 * cos(x)); }, 0, end_point::pi(), p / 3,
                     rule);
  }
  expect_certified([](const auto& x) { return 1 / (1 + square(x)); }, 0, end_point::infinity(),
                   p / 2, quadrature_rule::gauss_legendre);
}

TEST(InsistedRule, ClenshawCurtisTakesAboutTwiceTheNodes) {
  const auto f = [](const auto& x) { return sin(x + exp(x)); };
  const integral gauss = integrate(f, 0, 2, by(quadrature_rule::gauss_legendre));
  const integral clenshaw = integrate(f, 0, 2, by(quadrature_rule::clenshaw_curtis));
  EXPECT_TRUE(support::meet(gauss.enclosure, clenshaw.enclosure));
  EXPECT_EQ(clenshaw.account.evaluations, 2 * gauss.account.evaluations + clenshaw.account.panels);
}

TEST(InsistedRule, SaysWhyItDoesNotApply) {
  const auto why = [](const integral& i) {
    EXPECT_EQ(i.verdict, status::not_certified);
    EXPECT_TRUE(i.enclosure.is_undefined());
    return to_text(i.why) + ": " + i.obstacle;
  };
  const auto starts = [](const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0 ? "" : text;
  };
  const auto e = [](const auto& x) { return exp(x); };
  const quadrature_rule trapezoid = quadrature_rule::trapezoid;
  const quadrature_rule exponential = quadrature_rule::double_exponential;
  const std::string not_periodic =
      "not applicable: the trapezoidal rule needs an integrand that is proved periodic";
  EXPECT_EQ(starts(why(integrate(e, 0, 1, by(trapezoid))), not_periodic), "");
  EXPECT_EQ(starts(why(integrate(e, 0, end_point::pi(), by(trapezoid))), not_periodic), "");
  EXPECT_EQ(starts(why(integrate([](const auto& x) { return exp(-x * x); }, 0,
                                 end_point::infinity(), by(trapezoid))),
                   not_periodic),
            "");
  // Even about both limits, with a kink between.
  EXPECT_EQ(starts(why(integrate([](const auto& x) { return abs(cos(x) - rational(1, 3)); }, 0,
                                 end_point::pi(), by(trapezoid))),
                   "not applicable: the trapezoidal rule needs"),
            "");
  EXPECT_EQ(starts(why(integrate([](const auto& x) { return 1 / sqrt(x); }, 0, 1,
                                 by(quadrature_rule::clenshaw_curtis))),
                   "not applicable: the rule Clenshaw-Curtis needs values at the ends"),
            "");
  EXPECT_EQ(starts(why(integrate(e, 0, end_point::pi(), by(exponential))),
                   "not applicable: the double exponential rule needs rational limits"),
            "");
  EXPECT_EQ(starts(why(integrate([](const auto& x) { return abs(x - rational(1, 3)); }, 0, 1,
                                 by(exponential))),
                   "not applicable: the double exponential rule needs a series"),
            "");
  EXPECT_EQ(starts(why(integrate([](const auto& x) { return 1 / x; }, 0, 1, by(exponential))),
                   "not integrable"),
            "");
}

TEST(InsistedRule, NamesAreAllDifferent) {
  EXPECT_EQ(to_text(quadrature_rule::automatic), "automatic");
  EXPECT_EQ(to_text(quadrature_rule::gauss_legendre), "Gauss-Legendre");
  EXPECT_EQ(to_text(quadrature_rule::clenshaw_curtis), "Clenshaw-Curtis");
  EXPECT_EQ(to_text(quadrature_rule::trapezoid), "trapezoid");
  EXPECT_EQ(to_text(quadrature_rule::double_exponential), "double exponential");
}

/// Every sum over panels, of which there may be several, tells of its panels in turn, by the number
/// of the plan.
TEST(InsistedRule, TellsOfItsPanels) {
  std::vector<integration_progress> told;
  integrate_options options = by(quadrature_rule::gauss_legendre);
  options.progress = [&](const integration_progress& p) { told.push_back(p); };
  const auto runge = [](const auto& x) { return 1 / (1 + 25 * square(x)); };
  const integral i = integrate(runge, -1, 1, options);
  ASSERT_EQ(i.verdict, status::certified);
  ASSERT_GT(i.account.panels, 1);
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back().panels, i.account.panels);
  EXPECT_EQ(told.back().panels_done, i.account.panels - 1);
  long most_nodes = 0;
  for (std::size_t k = 0; k < told.size(); ++k) {
    EXPECT_GT(told[k].nodes, 0);
    EXPECT_LT(told[k].panels_done, told[k].panels);
    if (k > 0 && told[k].panels_done != 0) {
      EXPECT_EQ(told[k].panels_done, told[k - 1].panels_done + 1);
      EXPECT_EQ(told[k].panels, told[k - 1].panels);
    }
    most_nodes = std::max(most_nodes, told[k].nodes);
  }
  EXPECT_EQ(most_nodes, i.account.most_nodes);
}

}  // namespace insisted_rule_test
}  // namespace polhode
