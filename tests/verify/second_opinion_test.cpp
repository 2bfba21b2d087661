// What second opinions compare, and what they do with a contradiction: called with routes that lie.

#include "polhode/verify/second_opinion.hpp"

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/formula_certificates.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/roots/isolate.hpp"
#include "polhode/verify/second_integral.hpp"
#include "polhode/verify/second_roots.hpp"
#include "polhode/verify/second_value.hpp"

namespace polhode::test {
namespace second_opinion_test {

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
    expect_overlap("the integral", finding<ball>{"one route", from("1", "1.5")},
                   finding<ball>{"another route", from("1.625", "2")});
  });
  expect_words(text,
               {"INTERNAL ERROR", "the integral", "one route", "another route", "1.5", "1.625"});
}

TEST(SecondOpinion, AGapAfterManyDigitsIsShown) {
  const ball x(rational(1, 3), 4000);
  const ball y = x + ball(parse_rational("1e-500"), 4000);
  const std::string text = said_by([&] {
    expect_overlap("it", finding<ball>{"a", x}, finding<ball>{"b", y});
  });
  // The digit after 499 threes, which the two do not share.
  EXPECT_NE(text.find(std::string(499, '3') + "33"), std::string::npos);
  EXPECT_NE(text.find(std::string(499, '3') + "4"), std::string::npos);
}

TEST(SecondOpinion, SetsWithACommonNumberDoNot) {
  const auto compare = [](const ball& x, const ball& y) {
    expect_overlap("it", finding<ball>{"a", x}, finding<ball>{"b", y});
  };
  EXPECT_NO_THROW(compare(from("1", "1.5"), from("1.5", "2")));
  EXPECT_NO_THROW(compare(ball(2, 64), from("1", "3")));
  EXPECT_NO_THROW(compare(ball(2, 64), ball::undefined(64)));
  EXPECT_NO_THROW(compare(ball(2, 64), ball::entire(64)));
}

TEST(SecondOpinion, OfAComplexNumberEachPartCounts) {
  const complex_ball z(ball(1, 64), from("2", "3"));
  const std::string text = said_by([&] {
    expect_overlap("it", finding<complex_ball>{"a", z},
                   finding<complex_ball>{"b", complex_ball(ball(1, 64), ball(4, 64))});
  });
  expect_words(text, {"imaginary part"});
  EXPECT_THROW(expect_overlap("it", finding<complex_ball>{"a", z},
                              finding<complex_ball>{"b", complex_ball(ball(2, 64), z.im)}),
               contradiction_error);
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
    const prepared_integrand f(formula(text));
    const integral right = integrate(f, 0, 1, {.digits = 20});
    ASSERT_EQ(right.verdict, status::certified) << text;
    EXPECT_TRUE(integral_again(f, 0, 1, right, 20, 1).agrees()) << text;
    EXPECT_THROW((void)integral_again(f, 0, 1, moved(right), 20, 1), contradiction_error) << text;
  }
}

TEST(SecondOpinion, ANumberForADivergentIntegralIsContradicted) {
  const prepared_integrand f(formula("exp(x)/(x-1/3)"));
  integral wrong;
  wrong.enclosure = ball(1, 64);
  wrong.verdict = status::certified;
  wrong.account.rules = {quadrature_rule::taylor_series};
  const std::string text = said_by([&] { (void)integral_again(f, 0, 1, wrong, 20, 1); });
  expect_words(text, {"Taylor series", "Gauss-Legendre", "not integrable"});
}

TEST(SecondOpinion, AnotherRuleIsTakenThanTheFirst) {
  const prepared_integrand f(formula("exp(x)"));
  for (const quadrature_rule rule :
       {quadrature_rule::taylor_series, quadrature_rule::gauss_legendre}) {
    integrate_options how{.digits = 20};
    how.rule = rule;
    const integral first = integrate(f, 0, 1, how);
    ASSERT_EQ(first.account.rules, std::vector{rule});
    const second_opinion second = integral_again(f, 0, 1, first, 20, 1);
    const std::string& route = second.routes().back().route;
    EXPECT_TRUE(second.routes().back().agrees());
    EXPECT_EQ(route.find(to_text(rule)), std::string::npos) << route;
    EXPECT_NE(route.find("cut at 0.3"), std::string::npos) << route;
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
    const auto cut = cut_between(r.a, r.b);
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
  EXPECT_FALSE(cut_between(1, 1).has_value());
  EXPECT_FALSE(
      cut_between(ball(1, 64), end_point(ball(1, 64).enlarged(magnitude::power_of_two(-9))))
          .has_value());
}

TEST(SecondOpinion, AWrongIntegralAlongAPathIsContradicted) {
  const expression f("exp(z)/z^3", {{"z", "i"}, {}, nullptr});
  const detail::complex_integrand g = complex_integrand_of(f);
  const path circle = path::circle(0, 1);
  contour_integral i = detail::integrate_path(g, circle, {.digits = 20});
  EXPECT_TRUE(integral_again(g, circle, i, 20, 1).agrees());
  i.enclosure.im = -i.enclosure.im;
  EXPECT_THROW((void)integral_again(g, circle, i, 20, 1), contradiction_error);
}

// ---------------------------------------------------------------------------------------------
// Roots

proved_root simple(const char* lower, const char* upper) {
  return {root_verdict::unique, 1, from(lower, upper), false};
}

finding<proved_roots> list(const std::string& route, std::vector<proved_root> roots) {
  return {route, {true, false, std::move(roots)}};
}

TEST(SecondOpinion, ListsOfRootsThatExcludeEachOtherContradict) {
  const auto first = list("a", {simple("1", "1.1"), simple("2", "2.1")});
  EXPECT_FALSE(compare(first, list("b", {simple("1.05", "1.2"), simple("2", "2")})));
  // A root is missing in the one list, or in the other; or the two are apart.
  const auto fewer = list("b", {simple("1", "1.1")});
  const auto apart = list("b", {simple("1", "1.1"), simple("2.2", "2.3")});
  EXPECT_THROW((void)compare(first, fewer), contradiction_error);
  EXPECT_THROW((void)compare(fewer, first), contradiction_error);
  EXPECT_THROW((void)compare(first, apart), contradiction_error);
  // As many places, but one with two roots.
  const auto more = list("b", {simple("1", "1.05"), simple("1.06", "1.1"), simple("2", "2.1")});
  EXPECT_THROW((void)compare(first, more), contradiction_error);
  // Another multiplicity.
  auto twice = first;
  twice.enclosure.roots[1].multiplicity = 2;
  expect_words(said_by([&] { (void)compare(first, twice); }),
               {"root 2", "multiplicity 1", "multiplicity 2"});
}

TEST(SecondOpinion, ListsThatEndBeforeInfinitelyManyRootsAgreeInTheOthers) {
  const auto rest = [](const char* lower) {
    return proved_root{root_verdict::infinitely_many, 0, from(lower, "9"), false};
  };
  const auto first = list("a", {simple("1", "1.1"), rest("5")});
  EXPECT_FALSE(compare(first, list("b", {simple("1", "1.1"), simple("6", "6.1"), rest("7")})));
  EXPECT_TRUE(compare(first, list("b", {simple("1", "1.1"), simple("6", "6.1")})).has_value());
  EXPECT_THROW((void)compare(first, list("b", {rest("5")})), contradiction_error);
  const auto more = list("b", {simple("1", "1.1"), simple("4", "4.1"), rest("5")});
  EXPECT_THROW((void)compare(first, more), contradiction_error);
}

TEST(SecondOpinion, WhatIsOpenConfirmsNothingAndExcludesLittle) {
  const auto first = list("a", {simple("1", "1.1"), simple("2", "2.1")});
  auto open = first;
  open.enclosure.roots[1].verdict = root_verdict::unresolved;
  open.enclosure.roots[1].multiplicity = 0;
  EXPECT_TRUE(compare(first, open).has_value());
  // No place for the second root, though the first is open.
  auto without = list("b", {open.enclosure.roots[1]});
  EXPECT_THROW((void)compare(first, without), contradiction_error);
  // An incomplete list excludes nothing.
  without.enclosure.complete = false;
  EXPECT_TRUE(compare(first, without).has_value());
  // A root that may lie outside of the interval need not be in the other list.
  auto outside = list("b", {simple("1", "1.1"), simple("2", "2.1"), simple("3", "3.1")});
  outside.enclosure.roots[2].may_lie_outside = true;
  EXPECT_TRUE(compare(first, outside).has_value());
}

TEST(SecondOpinion, ZeroEverywhereHasNoIsolatedRoots) {
  proved_roots zero;
  zero.identically_zero = true;
  EXPECT_FALSE(compare({"a", zero}, {"b", zero}));
  EXPECT_THROW((void)compare({"a", zero}, list("b", {})), contradiction_error);
  EXPECT_THROW((void)compare(list("a", {simple("1", "2")}), {"b", zero}), contradiction_error);
}

TEST(SecondOpinion, WrongRootsAreContradicted) {
  const expression f = formula("(x^2-2)*(x-3)^2");
  const root_set found = isolate_roots(real_function(f), -5, 5);
  proved_roots roots;
  for (const root_region& r : found.regions) {
    roots.roots.push_back({r.verdict, r.multiplicity, refine(r, 20).enclosure, false});
  }
  ASSERT_EQ(roots.roots.size(), 3U);
  const auto again = [&] { return roots_again(f, -5, 5, roots, "the search", 20, 1); };
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
    EXPECT_TRUE(value_again(f, value, 200, 50).agrees()) << text;
    EXPECT_THROW((void)value_again(f, value + parse_rational("1e-30"), 200, 50),
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
    const std::vector<formula_definition> let{{"k", "1/3"}};
    EXPECT_TRUE(exact_value_again(text, let, value, 30).agrees()) << text;
    EXPECT_THROW((void)exact_value_again(text, let, value + parse_rational("1e-30"), 30),
                 contradiction_error)
        << text;
  }
}

TEST(SecondOpinion, NumbersBecomeVariablesWhereTheyNeedNotBeWhole) {
  const auto unfolded = with_numbers_as_variables("2*sin(.5e-3) ^ -3 + root(x2, 3) - 4 ! ** 7");
  EXPECT_EQ(unfolded.text, "number_1*sin(number_2) ^ -3 + root(x2, 3) - 4 ! ** 7");
  EXPECT_EQ(unfolded.names, (std::vector<std::string>{"number_1", "number_2"}));
  EXPECT_EQ(unfolded.values, (std::vector<rational>{2, rational(1, 2000)}));
}

// ---------------------------------------------------------------------------------------------
// The results of the library's own calls

TEST(SecondOpinion, OfAFormulaAndOfAGenericFunction) {
  const expression f = parse("exp(-x^2)");
  const auto g = [](const auto& x) { return exp(-x * x); };
  const integral first = integrate(f, 0, 1, {.digits = 30});
  for (const second_opinion& second :
       {integral_again(f, 0, 1, first, 30), integral_again(g, 0, 1, first, 30)}) {
    ASSERT_TRUE(second.agrees());
    const auto* found = std::get_if<ball>(&second.routes().back().enclosure);
    ASSERT_NE(found, nullptr);
    EXPECT_TRUE(overlaps(*found, first.enclosure));
    EXPECT_LE(found->radius(), confirming_radius(first.enclosure, 30));
  }
  EXPECT_THROW((void)integral_again(f, 0, 1, moved(first), 30), contradiction_error);
  EXPECT_THROW((void)integral_again(g, 0, 1, moved(first), 30), contradiction_error);
}

TEST(SecondOpinion, OfAFormulaAlongAPath) {
  const expression f = parse("exp(z)/z^3", {"z"});
  const path circle = path::circle(0, 1);
  contour_integral first = integrate_along(f, circle, {.digits = 20});
  const second_opinion second = integral_again(f, circle, first, 20);
  ASSERT_TRUE(second.agrees());
  EXPECT_TRUE(std::holds_alternative<complex_ball>(second.routes().back().enclosure));
  first.enclosure.im = -first.enclosure.im;
  EXPECT_THROW((void)integral_again(f, circle, first, 20), contradiction_error);
}

TEST(SecondOpinion, OfTheAnswerOfASearch) {
  const expression f = parse("(x^2-2)*(x-3)^2");
  root_set found = isolate_roots(f, -5, 5);
  const second_opinion second = roots_again(f, -5, 5, found, 25);
  ASSERT_TRUE(second.agrees());
  const auto* roots = std::get_if<proved_roots>(&second.routes().back().enclosure);
  ASSERT_NE(roots, nullptr);
  EXPECT_EQ(roots->roots.size(), 3U);
  found.regions.erase(found.regions.begin() + 1);
  EXPECT_THROW((void)roots_again(f, -5, 5, found, 25), contradiction_error);
}

TEST(SecondOpinion, ASearchThatLeavesAPlaceOpenIsNotConfirmed) {
  const expression f = parse("x^2-2");
  root_set found = isolate_roots(f, -5, 5);
  ASSERT_EQ(found.regions.size(), 2U);
  found.regions[1].verdict = root_verdict::unresolved;
  found.regions[1].multiplicity = 0;
  const second_opinion second = roots_again(f, -5, 5, found, 25);
  EXPECT_FALSE(second.agrees());
  EXPECT_EQ(second.routes().back().obstacle, "it leaves places open");
}

TEST(SecondOpinion, OfWhatIsNotCertifiedIsRefused) {
  const expression f = parse("exp(x)");
  EXPECT_THROW((void)integral_again(f, 0, 1, integral{}, 20), std::invalid_argument);
  EXPECT_THROW((void)integral_again(f, 0, 1, integrate(f, 0, 1), 0), std::invalid_argument);
  EXPECT_THROW((void)integral_again(f, path::circle(0, 1), contour_integral{}, 20),
               std::invalid_argument);
}

}  // namespace second_opinion_test
}  // namespace polhode::test
