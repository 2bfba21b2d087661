// What --verify compares, and what it does with a contradiction: called directly, with routes that lie.

#include "cli/second_opinion.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/second_integral.hpp"
#include "cli/second_roots.hpp"
#include "cli/second_value.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/formula_certificates.hpp"
#include "polhode/formulas/integrand.hpp"

namespace polhode::test {
namespace {

using cli::contradiction_error;
using cli::finding;

ball from(const char* lower, const char* upper) {
  return hull(ball(parse_rational(lower), 200), ball(parse_rational(upper), 200));
}

/// What the contradiction says.
template <class Contradicts>
std::string said_by(const Contradicts& contradicts) {
  try {
    contradicts();
  } catch (const contradiction_error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no contradiction";
  return "";
}

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    EXPECT_NE(text.find(word), std::string::npos) << word << " in " << text;
  }
}

// ---------------------------------------------------------------------------------------------
// Numbers

TEST(SecondOpinion, SetsWithoutACommonNumberContradict) {
  const std::string text = said_by([] {
    cli::expect_overlap("the integral", finding<ball>{"one route", from("1", "1.5")},
                        finding<ball>{"another route", from("1.625", "2")});
  });
  expect_words(text, {"INTERNAL ERROR", "the integral", "one route", "another route", "1.5",
                      "1.625", "There is no result"});
}

TEST(SecondOpinion, AGapAfterManyDigitsIsShown) {
  const ball x(rational(1, 3), 4000);
  const ball y = x + ball(parse_rational("1e-500"), 4000);
  const std::string text = said_by([&] {
    cli::expect_overlap("it", finding<ball>{"a", x}, finding<ball>{"b", y});
  });
  // The digit after 499 threes, which the two do not share.
  EXPECT_NE(text.find(std::string(499, '3') + "33"), std::string::npos);
  EXPECT_NE(text.find(std::string(499, '3') + "4"), std::string::npos);
}

TEST(SecondOpinion, SetsWithACommonNumberDoNot) {
  const auto compare = [](const ball& x, const ball& y) {
    cli::expect_overlap("it", finding<ball>{"a", x}, finding<ball>{"b", y});
  };
  EXPECT_NO_THROW(compare(from("1", "1.5"), from("1.5", "2")));
  EXPECT_NO_THROW(compare(ball(2, 64), from("1", "3")));
  EXPECT_NO_THROW(compare(ball(2, 64), ball::undefined(64)));
  EXPECT_NO_THROW(compare(ball(2, 64), ball::entire(64)));
}

TEST(SecondOpinion, OfAComplexNumberEachPartCounts) {
  const complex_ball z(ball(1, 64), from("2", "3"));
  const std::string text = said_by([&] {
    cli::expect_overlap("it", finding<complex_ball>{"a", z},
                        finding<complex_ball>{"b", complex_ball(ball(1, 64), ball(4, 64))});
  });
  expect_words(text, {"imaginary part"});
  EXPECT_THROW(cli::expect_overlap("it", finding<complex_ball>{"a", z},
                                   finding<complex_ball>{"b", complex_ball(ball(2, 64), z.im)}),
               contradiction_error);
}

TEST(SecondOpinion, AContradictionEndsTheProgramWithStatus3) {
  testing::internal::CaptureStderr();
  cli::exit_status status = cli::exit_status::all_certified;
  try {
    cli::contradict("the integral", {"a", "1"}, {"b", "2"});
  } catch (...) {
    status = cli::report_current_exception();
  }
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_EQ(static_cast<int>(status), 3);
  EXPECT_EQ(text.rfind("polhode: INTERNAL ERROR", 0), 0U) << text;
}

TEST(SecondOpinion, WithoutARouteThatAgreesNothingIsConfirmed) {
  cli::second_opinion opinion;
  EXPECT_FALSE(opinion.agrees());
  EXPECT_EQ(opinion.status(), cli::exit_status::not_certified);
  opinion.add({"a route", "not analytic", json(), "", 0});
  EXPECT_FALSE(opinion.agrees());
  expect_words(opinion.as_text(), {"not confirmed", "a route: not analytic"});
  EXPECT_EQ(opinion.as_json().at("agrees"), false);
  opinion.add({"another", "", json(1), "3 steps", 0.5});
  EXPECT_EQ(opinion.status(), cli::exit_status::all_certified);
  EXPECT_EQ(opinion.as_text(), "second opinion: the same by another (3 steps, 0.5 s)\n");
  EXPECT_EQ(opinion.as_json().at("route"), "another");
}

// ---------------------------------------------------------------------------------------------
// Integrals

expression formula(const std::string& text) { return expression(text, {{"x"}, {}, nullptr}); }

/// The integral with its enclosure moved by more than its width.
integral moved(integral i) {
  i.enclosure *= 1 + parse_rational("1e-18");
  return i;
}

TEST(SecondOpinion, AWrongIntegralIsContradicted) {
  for (const char* text : {"exp(x)", "sin(x)/x", "sqrt(x)*exp(x)", "1/(1+x^4)"}) {
    const detail::integrand f = integrand_of(formula(text));
    const integral right = detail::integrate_function(f, 0, 1, {.digits = 20});
    ASSERT_EQ(right.verdict, status::certified) << text;
    EXPECT_TRUE(cli::integral_again(f, 0, 1, right, 20, 1).agrees()) << text;
    EXPECT_THROW((void)cli::integral_again(f, 0, 1, moved(right), 20, 1), contradiction_error)
        << text;
  }
}

TEST(SecondOpinion, ANumberForADivergentIntegralIsContradicted) {
  const detail::integrand f = integrand_of(formula("exp(x)/(x-1/3)"));
  integral wrong;
  wrong.enclosure = ball(1, 64);
  wrong.verdict = status::certified;
  wrong.account.rules = {quadrature_rule::taylor_series};
  const std::string text = said_by([&] { (void)cli::integral_again(f, 0, 1, wrong, 20, 1); });
  expect_words(text, {"Taylor series", "Gauss-Legendre", "not integrable"});
}

TEST(SecondOpinion, AnotherRuleIsTakenThanTheFirst) {
  const detail::integrand f = integrand_of(formula("exp(x)"));
  for (const quadrature_rule rule :
       {quadrature_rule::taylor_series, quadrature_rule::gauss_legendre}) {
    integrate_options how{.digits = 20};
    how.rule = rule;
    const integral first = detail::integrate_function(f, 0, 1, how);
    ASSERT_EQ(first.account.rules, std::vector{rule});
    const json said = cli::integral_again(f, 0, 1, first, 20, 1).as_json();
    EXPECT_EQ(said.at("route").get<std::string>().find(to_text(rule)), std::string::npos) << said;
    EXPECT_NE(said.at("route").get<std::string>().find("cut at 0.3"), std::string::npos) << said;
  }
}

TEST(SecondOpinion, TheCutIsBetweenTheEndsAndOnNoHalf) {
  const end_point root([](precision p) { return sqrt(ball(2, p)); });
  const end_point near([](precision p) { return sqrt(ball(2, p)) + parse_rational("1e-40"); });
  const end_point infinity = end_point::infinity();
  struct range {
    end_point a, b;
  };
  for (const range& r : {range{0, 1}, range{1, 0}, range{root, near}, range{near, root},
                         range{-infinity, infinity}, range{-infinity, -7}, range{root, infinity},
                         range{infinity, -1000}, range{end_point::pi(-1), end_point::pi(3)}}) {
    const auto cut = cli::cut_between(r.a, r.b);
    ASSERT_TRUE(cut.has_value());
    EXPECT_EQ(denominator(*cut) % 3, 0);
    const ball x(*cut, 1000);
    const auto is_below = [](const ball& low, const end_point& high) {
      return high.infinite_sign() > 0 ||
             (high.infinite_sign() == 0 && certainly_less(low, high.at(1000)));
    };
    const auto is_above = [](const ball& high, const end_point& low) {
      return low.infinite_sign() < 0 ||
             (low.infinite_sign() == 0 && certainly_less(low.at(1000), high));
    };
    EXPECT_TRUE((is_below(x, r.b) && is_above(x, r.a)) || (is_below(x, r.a) && is_above(x, r.b)));
  }
  EXPECT_FALSE(cli::cut_between(1, 1).has_value());
  EXPECT_FALSE(
      cli::cut_between(ball(1, 64), end_point(ball(1, 64).enlarged(magnitude::power_of_two(-9))))
          .has_value());
}

TEST(SecondOpinion, AWrongIntegralAlongAPathIsContradicted) {
  const expression f("exp(z)/z^3", {{"z", "i"}, {}, nullptr});
  const detail::complex_integrand g = complex_integrand_of(f);
  const path circle = path::circle(0, 1);
  contour_integral i = detail::integrate_path(g, circle, {.digits = 20});
  EXPECT_TRUE(cli::integral_again(g, circle, i, 20, 1).agrees());
  i.enclosure.im = -i.enclosure.im;
  EXPECT_THROW((void)cli::integral_again(g, circle, i, 20, 1), contradiction_error);
}

TEST(SecondOpinion, WhatTheCheckerRefutesIsAContradiction) {
  const formula_over_range what{formula("4/(1+x^2)"), expression("0"), expression("1")};
  const json right = integral_certificate(what, pi(200), 30);
  EXPECT_TRUE(cli::checked_again("the integral", "a route", right).agrees());
  const json wrong = integral_certificate(what, pi(200) + parse_rational("1e-20"), 30);
  const std::string text =
      said_by([&] { (void)cli::checked_again("the integral", "a route", wrong); });
  expect_words(text, {"a route", "the independent checker", "refuted", "/numbers/integral"});
}

// ---------------------------------------------------------------------------------------------
// Roots

cli::proved_root simple(const char* lower, const char* upper) {
  return {root_verdict::unique, 1, from(lower, upper), false};
}

finding<cli::proved_roots> list(const std::string& route, std::vector<cli::proved_root> roots) {
  return {route, {true, false, std::move(roots)}};
}

TEST(SecondOpinion, ListsOfRootsThatExcludeEachOtherContradict) {
  const auto first = list("a", {simple("1", "1.1"), simple("2", "2.1")});
  EXPECT_FALSE(cli::compare(first, list("b", {simple("1.05", "1.2"), simple("2", "2")})));
  // A root is missing in the one list, or in the other; or the two are apart.
  const auto fewer = list("b", {simple("1", "1.1")});
  const auto apart = list("b", {simple("1", "1.1"), simple("2.2", "2.3")});
  EXPECT_THROW((void)cli::compare(first, fewer), contradiction_error);
  EXPECT_THROW((void)cli::compare(fewer, first), contradiction_error);
  EXPECT_THROW((void)cli::compare(first, apart), contradiction_error);
  // As many places, but one with two roots.
  const auto more = list("b", {simple("1", "1.05"), simple("1.06", "1.1"), simple("2", "2.1")});
  EXPECT_THROW((void)cli::compare(first, more), contradiction_error);
  // Another multiplicity.
  auto twice = first;
  twice.enclosure.roots[1].multiplicity = 2;
  expect_words(said_by([&] { (void)cli::compare(first, twice); }),
               {"root 2", "multiplicity 1", "multiplicity 2"});
}

TEST(SecondOpinion, WhatIsOpenConfirmsNothingAndExcludesLittle) {
  const auto first = list("a", {simple("1", "1.1"), simple("2", "2.1")});
  auto open = first;
  open.enclosure.roots[1].verdict = root_verdict::unresolved;
  open.enclosure.roots[1].multiplicity = 0;
  EXPECT_TRUE(cli::compare(first, open).has_value());
  // No place for the second root, though the first is open.
  auto without = list("b", {open.enclosure.roots[1]});
  EXPECT_THROW((void)cli::compare(first, without), contradiction_error);
  // An incomplete list excludes nothing.
  without.enclosure.complete = false;
  EXPECT_TRUE(cli::compare(first, without).has_value());
  // A root that may lie outside of the interval need not be in the other list.
  auto outside = list("b", {simple("1", "1.1"), simple("2", "2.1"), simple("3", "3.1")});
  outside.enclosure.roots[2].may_lie_outside = true;
  EXPECT_TRUE(cli::compare(first, outside).has_value());
}

TEST(SecondOpinion, ZeroEverywhereHasNoIsolatedRoots) {
  cli::proved_roots zero;
  zero.identically_zero = true;
  EXPECT_FALSE(cli::compare({"a", zero}, {"b", zero}));
  EXPECT_THROW((void)cli::compare({"a", zero}, list("b", {})), contradiction_error);
  EXPECT_THROW((void)cli::compare(list("a", {simple("1", "2")}), {"b", zero}), contradiction_error);
}

TEST(SecondOpinion, WrongRootsAreContradicted) {
  const expression f = formula("(x^2-2)*(x-3)^2");
  const root_set found = isolate_roots(real_function(f), -5, 5);
  cli::proved_roots roots;
  for (const root_region& r : found.regions) {
    roots.roots.push_back({r.verdict, r.multiplicity, refine(r, 20).enclosure, false});
  }
  ASSERT_EQ(roots.roots.size(), 3U);
  const auto again = [&] { return cli::roots_again(f, -5, 5, roots, "the search", 20, 1); };
  EXPECT_TRUE(again().agrees());
  roots.roots[2].multiplicity = 1;
  EXPECT_THROW((void)again(), contradiction_error);
  roots.roots[2].multiplicity = 2;
  roots.roots[0].enclosure -= parse_rational("1e-18");
  EXPECT_THROW((void)again(), contradiction_error);
}

// ---------------------------------------------------------------------------------------------
// Values

TEST(SecondOpinion, AWrongValueIsContradicted) {
  for (const char* text : {"exp(pi)", "cbrt(-pi)", "gamma(1/3)", "abs(log(1/3))", "root(-pi, 5)^2",
                           "floor(exp(3))+sqrt(2)", "agm(1, sqrt(2))", "pi^pi", "atan2(-1, -pi)"}) {
    const expression f(text);
    const ball value = f.value(200);
    EXPECT_TRUE(cli::value_again(f, value, 200, 50).agrees()) << text;
    EXPECT_THROW((void)cli::value_again(f, value + parse_rational("1e-30"), 200, 50),
                 contradiction_error)
        << text;
  }
}

TEST(SecondOpinion, AWrongExactValueIsContradicted) {
  struct known {
    std::string text;
    rational value;
  };
  for (const auto& [text, value] : std::vector<known>{{"1/3 + 1/6", rational(1, 2)},
                                                      {"2^10 - 1.5e2/root(27, 3) + 4!", 998},
                                                      {"sqrt(4/9)*(2 - 3)^3", rational(-2, 3)},
                                                      {"-3*k^2**1", rational(-1, 3)},
                                                      {"1/3 - 2/6", 0}}) {
    const cli::let_option let{{"k=1/3"}};
    EXPECT_TRUE(cli::exact_value_again(text, let, value, 30).agrees()) << text;
    EXPECT_THROW((void)cli::exact_value_again(text, let, value + parse_rational("1e-30"), 30),
                 contradiction_error)
        << text;
  }
}

TEST(SecondOpinion, NumbersBecomeVariablesWhereTheyNeedNotBeWhole) {
  const auto unfolded =
      cli::with_numbers_as_variables("2*sin(.5e-3) ^ -3 + root(x2, 3) - 4 ! ** 7");
  EXPECT_EQ(unfolded.text, "number_1*sin(number_2) ^ -3 + root(x2, 3) - 4 ! ** 7");
  EXPECT_EQ(unfolded.names, (std::vector<std::string>{"number_1", "number_2"}));
  EXPECT_EQ(unfolded.values, (std::vector<rational>{2, rational(1, 2000)}));
}

}  // namespace
}  // namespace polhode::test
