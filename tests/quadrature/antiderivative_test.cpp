// Integrals by antiderivatives: rational numbers, and differences of entire functions.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "quadrature/integrals_by_digits.hpp"

namespace polhode::test {
namespace antiderivative_test {

std::string exactly(const std::string& formula, const std::string& lower,
                    const std::string& upper) {
  const auto found = exact_integral(parse(formula), limit_of(lower), limit_of(upper));
  return found ? to_text(*found) : "none";
}

TEST(ExactIntegral, OfRationalFunctions) {
  EXPECT_EQ(exactly("x^3 - x/7", "0", "1"), "5/28");
  EXPECT_EQ(exactly("1/x^2", "1", "2"), "1/2");
  EXPECT_EQ(exactly("1/x^2", "2", "1"), "-1/2");
  EXPECT_EQ(exactly("1/x^2", "1", "inf"), "1");
  EXPECT_EQ(exactly("1/x^2", "-inf", "-2"), "1/2");
  EXPECT_EQ(exactly("2*x/(1+x^2)^2", "0", "1"), "1/2");
  EXPECT_EQ(exactly("(1-x^2)/(1+x^2)^2", "0", "2"), "2/5");
  EXPECT_EQ(exactly("x + 1/x^3", "1", "2"), "15/8");
  EXPECT_EQ(exactly("1/x - 1/x", "-1", "1"), "0");
  EXPECT_EQ(exactly("(x^2-1)/(x-1)", "0", "2"), "4");
  EXPECT_EQ(exactly("x^2", "3", "3"), "0");
}

TEST(ExactIntegral, IsNotFoundWhereThereIsNone) {
  // Divergent.
  EXPECT_EQ(exactly("1/x^2", "-1", "1"), "none");
  EXPECT_EQ(exactly("1/x^2", "0", "1"), "none");
  EXPECT_EQ(exactly("1/x^2", "-1", "0"), "none");
  EXPECT_EQ(exactly("1/x^2", "-inf", "inf"), "none");
  EXPECT_EQ(exactly("x", "0", "inf"), "none");
  EXPECT_EQ(exactly("1/sqrt(x)^3", "0", "1"), "none");
  EXPECT_EQ(exactly("1/sqrt(x)", "1", "inf"), "none");
  // With logarithms and arcs, irrational breaks, and roots of what is negative.
  EXPECT_EQ(exactly("1/x", "1", "2"), "none");
  EXPECT_EQ(exactly("1/x + 1/x^2", "1", "2"), "none");
  EXPECT_EQ(exactly("1/(1+x^2)", "0", "1"), "none");
  EXPECT_EQ(exactly("abs(x^2-2)", "0", "2"), "none");
  EXPECT_EQ(exactly("sqrt(x)", "0", "2"), "none");
  EXPECT_EQ(exactly("sqrt(x)", "-1", "1"), "none");
  EXPECT_EQ(exactly("root(x, 3)", "-1", "2"), "none");
  EXPECT_EQ(exactly("floor(x^2)", "0", "2"), "none");
  EXPECT_EQ(exactly("floor(1/x)", "1", "2"), "none");
  EXPECT_EQ(exactly("exp(-x^2)", "0", "1"), "none");
}

TEST(ExactIntegral, OfRootsOfLinearForms) {
  EXPECT_EQ(exactly("sqrt(x)", "0", "4"), "16/3");
  EXPECT_EQ(exactly("sqrt(1-x)", "-3", "1"), "16/3");
  EXPECT_EQ(exactly("1/sqrt(x)", "0", "4"), "4");
  EXPECT_EQ(exactly("x*sqrt(1+x)", "0", "3"), "116/15");
  EXPECT_EQ(exactly("x^(2/3)", "0", "8"), "96/5");
  EXPECT_EQ(exactly("root(2*x+1, 3)/sqrt(2*x+1)", "0", "63/2"), "93/5");
  EXPECT_EQ(exactly("1/(1+sqrt(x))^3", "0", "inf"), "1");
  EXPECT_EQ(exactly("x^(-3/2)", "4", "inf"), "1");
  EXPECT_EQ(exactly("(-x)^(-3/2)", "-inf", "-4"), "1");
}

TEST(ExactIntegral, OfKinksAndSteps) {
  EXPECT_EQ(exactly("abs(x)", "-1", "2"), "5/2");
  EXPECT_EQ(exactly("abs(abs(x)-1)", "-3", "3"), "5");
  EXPECT_EQ(exactly("max(x, 1-x)", "0", "1"), "3/4");
  EXPECT_EQ(exactly("min(x, x^2)", "0", "2"), "11/6");
  EXPECT_EQ(exactly("sqrt(abs(x))", "-4", "4"), "32/3");
  EXPECT_EQ(exactly("abs(x^3-x)/(1+abs(x))", "-1", "1"), "1/3");
  EXPECT_EQ(exactly("max(0, (x-1)/(x-3))", "-1", "2"), "none");  // a logarithm
  EXPECT_EQ(exactly("floor(x)", "0", "7/2"), "9/2");
  EXPECT_EQ(exactly("ceil(x)", "-5/2", "1/2"), "-3/2");
  EXPECT_EQ(exactly("floor(1-2*x)", "0", "1"), "-1/2");
}

/// The search for rational roots is bounded: it took half a minute.
TEST(ExactIntegral, IsNotLookedForLong) {
  EXPECT_EQ(exactly("abs(x^50-1e-300*x-1/3)", "0", "2"), "none");
}

TEST(ExactIntegral, OfManySteps) {
  EXPECT_EQ(exactly("floor(x)", "0", "1e6"), "499999500000");
  EXPECT_EQ(exactly("x-floor(x)", "0", "1e6"), "500000");
  EXPECT_EQ(exactly("x-floor(x)", "1/3", "1e30+1/2"),
            to_text(*parse("(1e30)/2 + 1/8 - 1/18", {}).rational_value()));
  EXPECT_EQ(exactly("floor(x)^3", "0", "1e9"), "249999999500000000250000000000000000");
  // As many pieces as are cut, and one period more.
  EXPECT_EQ(exactly("floor(2*x)*ceil(x/3)", "0", "100"), "452761/2");
  EXPECT_EQ(exactly("ceil(x/3)*floor(2*x)", "0", "100"), "452761/2");
  const auto whole = exact_integral(parse("floor(2*x)*ceil(x/3)*x"), 0, rational(6001, 7));
  const auto part = exact_integral(parse("floor(2*x)*ceil(x/3)*x"), 0, 3);
  const auto rest = exact_integral(parse("floor(2*x)*ceil(x/3)*x"), 3, rational(6001, 7));
  ASSERT_TRUE(whole && part && rest);
  EXPECT_EQ(*whole, *part + *rest);
}

TEST(ExactIntegral, ByTheEntireAntiderivative) {
  EXPECT_EQ(exactly("sin(x)", "0", "pi"), "2");
  EXPECT_EQ(exactly("cos(3*x)*cos(5*x)", "0", "pi"), "0");
  EXPECT_EQ(exactly("exp(x)", "0", "log(3)"), "2");
  EXPECT_EQ(exactly("x*sin(x)", "0", "pi"), "none");
}

TEST(ExactIntegral, ByTheAntiderivativeInTheLogarithm) {
  EXPECT_EQ(exactly("log(x)", "0", "1"), "-1");
  EXPECT_EQ(exactly("sqrt(x)*log(x)", "0", "1"), "-4/9");
  EXPECT_EQ(exactly("sqrt(x)*log(x)", "1", "0"), "4/9");
  EXPECT_EQ(exactly("log(x)/x^2", "1", "inf"), "1");
  EXPECT_EQ(exactly("log(x)^2/x", "1", "e"), "1/3");
  EXPECT_EQ(exactly("log(x)/x^1.0000001", "1", "inf"), "100000000000000");
  EXPECT_EQ(exactly("log(x)^3*(1+1/sqrt(x))", "0", "1"), "-102");
  EXPECT_EQ(exactly("log(x)", "0", "2"), "none");
  EXPECT_EQ(exactly("log(x)/x", "0", "1"), "none");
  EXPECT_EQ(exactly("log(x)/x", "1", "inf"), "none");
  EXPECT_EQ(exactly("log(x)+1/x^2", "0", "1"), "none");
  EXPECT_EQ(exactly("log(x)", "-1", "0"), "none");
  // Where logarithms or roots have no value nothing is known.
  EXPECT_EQ(exactly("log(x)+log(-x)", "0", "1"), "none");
  EXPECT_EQ(exactly("sqrt(log(x))^2", "0", "1"), "none");
  EXPECT_EQ(exactly("sqrt(-x)^2*log(x)", "0", "1"), "none");
}

TEST(Antiderivative, OfSumsOfExponentials) {
  expect_known(
      {
          {"x*sin(x)", "0", "1e6", "-936752.4775266469582314846527274055564796"},
          {"sin(x)+sin(pi*x)", "0", "1e6", "0.06324787246685521306146746492508122429190"},
          {"x^20*exp(-x)", "0", "1", "0.01835046769725620632614475423173787510136"},
          {"exp(x)*cos(3*x)", "0", "1", "-0.2540266753196400782083790878279597005138"},
          {"x^3*sinpi(x)^2*cosh(x)", "0", "2", "4.562950911276741597263404974916156326693"},
      },
      0);
}

TEST(Antiderivative, OfPowersAndLogarithms) {
  expect_known(
      {
          {"x^(pi-2)*log(x)^2", "0", "1", "0.2036195111538343583225312201991242783713"},
          {"sqrt(x)*log(x)", "2", "9", "27.50011025620330378910068287477256803987"},
          {"log(3*x)^2/x^2", "1/2", "inf", "5.950664340218988387217324894863442774417"},
          {"(x^(1/3)+x^(-2/3))*log(x^2)^3", "0", "2", "-3901.654196653753893673868033172559146819"},
          {"(log(x)/x)^3*x", "sqrt(2)", "e", "0.1111910304317927457841626138640116879112"},
          {"(log(x)/x)^3*x", "e", "sqrt(2)", "-0.1111910304317927457841626138640116879112"},
      },
      0);
  const auto with = [](const char* formula, const end_point& a, const end_point& b) {
    return integrate(parse(formula), a, b, {.digits = 20, .rule = quadrature_rule::antiderivative});
  };
  EXPECT_EQ(with("sqrt(x)*log(x)", 0, 2).verdict, status::certified);
  // Not up to the ends, not to the left of 0, and of nothing that is undefined somewhere.
  for (const char* refused : {"log(x)/x", "x^(-3/2)*log(x)", "sqrt(log(x))^2", "log(x-1)",
                              "log(2-x)*sqrt(x)", "log(x)*abs(x)", "log(log(x)^2)", "1/log(x)"}) {
    EXPECT_EQ(with(refused, 0, 2).why, reason::not_applicable) << refused;
  }
  EXPECT_EQ(with("log(x)", 1, end_point::infinity()).why, reason::not_applicable);
  EXPECT_EQ(with("log(x^2)", -1, 1).why, reason::not_applicable);
  EXPECT_EQ(with("log(x)*x^(sqrt(2)+sqrt(3)-sqrt(5+2*sqrt(6))-1)", 0, 1).why,
            reason::not_applicable);
}

TEST(Antiderivative, OfWhatIsZeroAlmostEverywhereIsZeroBetweenLimits) {
  const expression f = parse("1/(x-sqrt(2))-1/(x-sqrt(2))");
  const auto to = [](const char* text) { return end_point_of(parse(text, {})); };
  EXPECT_EQ(exact_integral(f, 0, 2), rational(0));
  EXPECT_EQ(exact_integral(f, to("sqrt(2)"), end_point::infinity()), rational(0));
  EXPECT_EQ(exact_integral(f, end_point::infinity(), end_point::infinity()), std::nullopt);
  for (const expression& zero : {f, parse("x-x")}) {
    EXPECT_EQ(exact_integral(zero, 0, to("1/(sqrt(2)*sqrt(3)-sqrt(6))")), std::nullopt);
  }
}

TEST(ExactIntegral, OfWhatIsOddAboutTheMiddle) {
  const auto between = [](const char* formula, const char* a, const char* b) {
    return exact_integral(parse(formula), limit_of(a), limit_of(b));
  };
  EXPECT_EQ(between("sin(x)*abs(x)^(1/3)", "-1", "1"), rational(0));
  EXPECT_EQ(between("sin(x)*abs(x)^(1/3)", "1", "-1"), rational(0));
  EXPECT_EQ(between("x/agm(1,abs(x))", "-1", "1"), rational(0));
  EXPECT_EQ(between("erfc(x)", "-1", "1"), rational(2));
  EXPECT_EQ(between("erfc(x)", "1", "-1"), rational(-2));
  EXPECT_EQ(between("tanh(x-1)/3+1/7", "-2", "4"), rational(6, 7));
  EXPECT_EQ(between("sinh(x)/cosh(x^2)", "-sqrt(2)", "sqrt(2)"), rational(0));
  EXPECT_EQ(between("cbrt(cos(x))", "0", "pi"), rational(0));
  EXPECT_EQ(between("x*sin(x^2+x^4)", "-inf", "inf"), rational(0));
  EXPECT_EQ(between("x*exp(-x^2)*cos(x)", "inf", "-inf"), rational(0));
  EXPECT_EQ(between("x*exp(-x^2)*cos(x)", "inf", "inf"), std::nullopt);
  // Not odd, about another point, with an irrational constant, and without an integral.
  EXPECT_EQ(between("sin(x)*exp(x)", "-1", "1"), std::nullopt);
  EXPECT_EQ(between("sin(x)/(1+x^2)", "-1", "1+1e-30"), std::nullopt);
  EXPECT_EQ(between("sin(x)/(1+x^2)+1e-30*x^2", "-1", "1"), std::nullopt);
  EXPECT_EQ(between("acos(x)", "-1", "1"), std::nullopt);
  EXPECT_EQ(between("erfc(x)", "-inf", "inf"), std::nullopt);
  for (const char* f : {"1/x", "1/sinh(x)", "x^(-3)*cos(x)", "cos(x)/x+sin(x)"}) {
    EXPECT_EQ(between(f, "-1", "1"), std::nullopt) << f;
  }
  for (const char* f : {"x", "tanh(x)", "sin(x)", "x/(1+x^2)", "1/x", "x+sin(x^3)"}) {
    EXPECT_EQ(between(f, "-inf", "inf"), std::nullopt) << f;
  }
}

/// By the closed form, or "none", to 25 digits.
std::string over_half_line(const std::string& formula) {
  const auto found = parse(formula).integral_over_half_line();
  return found ? to_decimal(found->value(160), 25) : "none";
}

TEST(HalfLine, IntegralsAreThoseOfTextbooks) {
  const auto value = [](const std::string& formula) {
    return to_decimal(parse(formula).value(160), 25);
  };
  EXPECT_EQ(over_half_line("sin(x)/x"), value("pi/2"));
  EXPECT_EQ(over_half_line("sin(-3*x)/x"), value("-pi/2"));
  EXPECT_EQ(over_half_line("sin(x)*cos(x)/x"), value("pi/4"));
  EXPECT_EQ(over_half_line("sin(x)^3/x^3"), value("3*pi/8"));
  EXPECT_EQ(over_half_line("(1-cos(x))/x^2"), value("pi/2"));
  EXPECT_EQ(over_half_line("(x-sin(x))/x^3"), value("pi/4"));
  EXPECT_EQ(over_half_line("(exp(-2*x)-exp(-3*x))/x"), value("log(3/2)"));
  EXPECT_EQ(over_half_line("(cos(x)-exp(-x))/x"), "0");
  EXPECT_EQ(over_half_line("(1-exp(-x))^2/x^2"), value("2*log(2)"));
  EXPECT_EQ(over_half_line("exp(-x)*sin(2*x)/x"), value("atan(2)"));
  EXPECT_EQ(over_half_line("exp(-x)*(1-cos(3*x))/x"), value("log(10)/2"));
  EXPECT_EQ(over_half_line("(exp(-x)-1+x*exp(-x))/x^2"), "-1");
  EXPECT_EQ(over_half_line("(sin(x)-x*cos(x))/x^2"), "1");
  EXPECT_EQ(over_half_line("x^3*exp(-2*x)"), value("3/8"));
  EXPECT_EQ(over_half_line("x*exp(-x)*cos(x)"), "0");
  EXPECT_EQ(over_half_line("sin(pi*x)^2/x^2"), value("pi^2/2"));
  EXPECT_EQ(over_half_line("sinpi(x)/x"), value("pi/2"));
  // D. Borwein and J. M. Borwein 2001: pi/2 up to sin(x/13)/(x/13), and less with one more.
  std::string product = "sin(x)/x";
  for (long k = 3; k <= 13; k += 2) {
    product += "*sin(x/" + std::to_string(k) + ")/(x/" + std::to_string(k) + ")";
    EXPECT_EQ(over_half_line(product), value("pi/2"));
  }
  EXPECT_EQ(over_half_line(product + "*sin(x/15)/(x/15)"),
            value("467807924713440738696537864469*pi/935615849440640907310521750000"));
}

TEST(HalfLine, IntegralsThatDoNotConvergeHaveNoClosedForm) {
  for (const char* const formula :
       {"cos(x)/x", "sin(x)/x^2", "sin(x)^2/x", "(x-sin(x))/x^2", "sin(x)", "x*sin(x)/x",
        "(exp(-x)-2*exp(-3*x))/x", "(exp(x)-exp(-x))/x", "exp(x)*sin(x)/x", "1/x^2",
        "1/x - exp(-x)/x", "exp(-x)/x", "(1-cos(x))/x^3", "cos(x)*cos(x)/x^0", "(1-exp(-x))/x"}) {
    EXPECT_EQ(over_half_line(formula), "none") << formula;
  }
  // Divided by 0, and by what may be.
  EXPECT_EQ(over_half_line("sin(x)/(x*(sqrt(2)*sqrt(3)-sqrt(6)))"), "none");
  EXPECT_EQ(over_half_line("sin(x)/(x*log(1))"), "none");
  // Of another kind.
  EXPECT_EQ(over_half_line("sin(x^2)/x"), "none");
  EXPECT_EQ(over_half_line("sin(x)/sqrt(x)"), "none");
  EXPECT_EQ(over_half_line("sin(x)/(x+1)"), "none");
}

TEST(HalfLine, IsChosenForRangesWithoutAnEnd) {
  const auto rule_of = [](const std::string& formula, const std::string& lower,
                          const std::string& upper) {
    const integral found = integrate(parse(formula), limit_of(lower), limit_of(upper));
    return std::pair(found.account.rules == std::vector{quadrature_rule::antiderivative},
                     to_decimal(found.enclosure, 10));
  };
  EXPECT_EQ(rule_of("sin(x)/x", "0", "inf"), std::pair(true, std::string("1.570796326...")));
  EXPECT_EQ(rule_of("sin(x)/x", "-inf", "0"), std::pair(true, std::string("1.570796326...")));
  EXPECT_EQ(rule_of("sin(x)/x", "-inf", "inf"), std::pair(true, std::string("3.141592653...")));
  EXPECT_EQ(rule_of("sin(x)/x", "inf", "0"), std::pair(true, std::string("-1.570796326...")));
  EXPECT_FALSE(rule_of("sin(x)/x", "1", "inf").first);
  EXPECT_FALSE(rule_of("(exp(-x)-exp(-2*x))/x", "-inf", "inf").first);
}

// One end had no integral; what was found at the other made that forgotten.
TEST(HalfLine, TwoSingularEndsAreBothReported) {
  const integral found = integrate(parse("x*(1-cos(1/x))"), limit_of("0"), limit_of("inf"));
  EXPECT_EQ(found.verdict, status::not_certified);
  EXPECT_EQ(found.why, reason::not_integrable);
}

TEST(Antiderivative, IsChosenAndNamed) {
  const auto with = [](const char* formula, const quadrature_rule& rule) {
    return integrate(parse(formula), 0, 1, {.digits = 20, .rule = rule});
  };
  const integral found = with("x*exp(-x)", quadrature_rule::antiderivative);
  ASSERT_EQ(found.verdict, status::certified);
  EXPECT_EQ(found.account.rules, std::vector{quadrature_rule::antiderivative});
  EXPECT_EQ(with("x*exp(-x^2)", quadrature_rule::antiderivative).why, reason::not_applicable);
  EXPECT_EQ(with("exp(x-x^2)", quadrature_rule::antiderivative).why, reason::not_applicable);
  // An exponent that is 0 and not seen to be.
  const integral hidden =
      with("exp((sqrt(5+2*sqrt(6))-sqrt(2)-sqrt(3))*x)", quadrature_rule::antiderivative);
  EXPECT_EQ(hidden.verdict, status::not_certified);
}

}  // namespace antiderivative_test
}  // namespace polhode::test
