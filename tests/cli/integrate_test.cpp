// polhode integrate: what it prints, its verdicts and its exit statuses.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "enclosure.hpp"
#include "program.hpp"

namespace polhode::test {
namespace {

outcome integrate(const std::string& formula, const std::string& from, const std::string& to,
                  const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"integrate", formula, "--from", from, "--to", to};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments);
}

/// The first line, up to its dots.
std::string digits_of(const outcome& o) { return o.out.substr(0, o.out.find("...")); }

TEST(Integrate, DigitsAreTheFirstOfTheTrueValue) {
  struct known {
    std::string formula, from, to, digits;
  };
  // sqrt(pi); pi/2 - 1 by parts; Euler's constant; Li_2(-1) = -pi^2/12; the lemniscate's arc, Gauss 1799.
  for (const auto& [formula, from, to, digits] : std::vector<known>{
           {"exp(-x^2)", "-inf", "inf", "1.7724538509055160272981674833411451827975494561223"},
           {"asin(x)", "0", "1", "0.57079632679489661923132169163975144209858469968755"},
           {"-exp(-x)*log(x)", "0", "inf", "0.57721566490153286060651209008240243104215933593992"},
           {"log(x)/(1+x)", "0", "1", "-0.82246703342411321823620758332301259460947495060339"},
           {"1/sqrt(1-x^4)", "0", "1", "1.3110287771460599052324197949455597068413774757158"}}) {
    const outcome result = integrate(formula, from, to, {"--digits", "50"});
    EXPECT_EQ(result.status, 0) << formula;
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(digits_of(result).rfind(digits, 0), 0U) << formula << ": " << result.out;
    EXPECT_NE(result.out.find("\ncertified: "), std::string::npos);
  }
}

TEST(Integrate, FewerDigitsAreTheBeginningOfMore) {
  const std::string long_one =
      digits_of(integrate("sqrt(x)*exp(x)", "0", "1", {"--digits", "400"}));
  for (const std::string count : {"1", "2", "15", "100"}) {
    const std::string shorter =
        digits_of(integrate("sqrt(x)*exp(x)", "0", "1", {"--digits", count}));
    EXPECT_EQ(long_one.rfind(shorter, 0), 0U) << count;
  }
}

TEST(Integrate, TwoEndsWhereDigitsDoNotEnd) {
  const outcome result = integrate("log(x)", "0", "1", {"--digits", "30"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out.rfind("from -1.00000000000000000000000000000", 0), 0U) << result.out;
  EXPECT_NE(result.out.find("\n  to -0.99999999999999999999999999999"), std::string::npos);
}

TEST(Integrate, ReversedAndEqualLimits) {
  EXPECT_EQ(digits_of(integrate("exp(x)", "1", "0")).front(), '-');
  EXPECT_EQ(integrate("exp(x)", "1/3", "1/3").out.rfind("0\n", 0), 0U);
  EXPECT_EQ(digits_of(integrate("exp(-x^2)", "inf", "-inf")).rfind("-1.77", 0), 0U);
}

TEST(Integrate, NamesAndVariables) {
  const std::string direct = digits_of(integrate("1/(x^2 + 1/9)", "0", "pi/2"));
  EXPECT_EQ(digits_of(integrate("1/(t^2 + k^2)", "0", "h",
                                {"--variable", "t", "--let", "k=1/3", "--let", "h=pi/2"})),
            direct);
}

TEST(Integrate, RootsOfNegativeNumbers) {
  // (3/4) (1.5^(4/3) - 0.5^(4/3)).
  const std::string value =
      digits_of(run({"eval", "3/4*(1.5^(4/3) - 0.5^(4/3))", "--digits", "40"}));
  EXPECT_EQ(digits_of(integrate("cbrt(x - 1/2)", "0", "2", {"--digits", "40"})), value);
}

TEST(Integrate, WhatIsNotIntegrableIsSaidSoAndWhere) {
  struct refusal {
    std::string formula, from, to, reason, place;
  };
  for (const auto& [formula, from, to, reason, place] :
       std::vector<refusal>{{"1/x", "-1", "2", "not integrable", "x = 0"},
                            {"1/(x-1/3)", "0", "1", "not integrable", "x = 0.3333"},
                            {"1/(x^2-2)", "0", "3", "not analytic", "x = 1.4142"},
                            {"tan(x)", "0", "2", "not analytic", "x = 1.5707"},
                            {"1/x", "1", "inf", "not integrable", "infinity"},
                            {"sqrt(x)", "-1", "1", "not analytic", "sqrt"},
                            {"agm(1, x)", "1", "2", "not analytic", "agm of complex arguments"}}) {
    const outcome result = integrate(formula, from, to, {"--digits", "20"});
    EXPECT_EQ(result.status, 1) << formula;
    EXPECT_EQ(result.out.rfind("undefined\nnot certified: " + reason, 0), 0U) << result.out;
    EXPECT_NE(result.out.find(place), std::string::npos) << result.out;
  }
}

TEST(Integrate, BadInputIsOneLineThatSaysWhatWouldBeRight) {
  const auto expect_refusal = [](const outcome& result, const std::string& words) {
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  };
  expect_refusal(integrate("y", "0", "1"), "column 1: there is no \"y\"");
  expect_refusal(integrate("x +", "0", "1"), "column 4");
  expect_refusal(integrate("x", "zero", "1"), "there is no \"zero\"");
  expect_refusal(integrate("x", "nan", "1"), "nan");
  expect_refusal(integrate("x", "inf", "inf"), "the same infinity");
  expect_refusal(integrate("x", "0", "1", {"--digits", "0"}), "--digits \"0\"");
  expect_refusal(integrate("x", "0", "1", {"--variable", "2"}), "2");
  expect_refusal(integrate("x", "0", "1", {"--variable", "sin"}), "sin");
  expect_refusal(run({"integrate", "x", "--from", "0"}), "--to");
  expect_refusal(integrate("x", "0", "1", {"--digits", "1000000000"}), "memory");
  expect_refusal(integrate("x", "0", "1", {"--rule", "simpson"}), "gauss-legendre");
  expect_refusal(integrate("x", "0", "1", {"--threads", "-1"}), "--threads");
  expect_refusal(integrate("x", "0", "1", {"--threads", "two"}), "--threads");
}

TEST(Integrate, RecognisesMultiplesOfPiAndChoosesTheTrapezoidalRule) {
  struct symmetric {
    std::string formula, from, to;
  };
  for (const auto& [formula, from, to] :
       std::vector<symmetric>{{"1/sqrt(1 - sin(x)^2/2)", "0", "pi/2"},
                              {"exp(cos(x) + sin(2*x))", "-pi", "pi"},
                              {"exp(cos(3*pi*x))", "1/3", "2 - 2/3"},
                              {"1/(2 + sin(x))", "h", "h + 2*pi"}}) {
    const outcome result = integrate(formula, from, to, {"--let", "h=3/2*pi - 1"});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.out.find("(trapezoid)"), std::string::npos) << result.out;
    const outcome panels =
        integrate(formula, from, to, {"--let", "h=3/2*pi - 1", "--rule", "gauss-legendre"});
    EXPECT_EQ(digits_of(panels), digits_of(result));
    EXPECT_NE(panels.out.find("(Gauss-Legendre)"), std::string::npos) << panels.out;
  }
  for (const std::string to : {"1.5707963267948966", "asin(1)"}) {
    const outcome result = integrate("1/sqrt(1 - sin(x)^2/2)", "0", to);
    EXPECT_EQ(result.out.find("(trapezoid)"), std::string::npos) << result.out;
  }
}

TEST(Integrate, RulesThatAreInsistedOn) {
  for (const std::string rule : {"gauss-legendre", "clenshaw-curtis", "double-exponential"}) {
    const outcome result = integrate("sqrt(x)*exp(x)", "0", "1", {"--rule", rule});
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_EQ(digits_of(result), digits_of(integrate("sqrt(x)*exp(x)", "0", "1")));
  }
  const outcome refused = integrate("sqrt(x)*exp(x)", "0", "1", {"--rule", "trapezoid"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.out.rfind("undefined\nnot certified: not applicable (the trapezoidal rule", 0),
            0U)
      << refused.out;
}

TEST(Integrate, ThreadsChangeNothing) {
  for (const std::string count : {"0", "2", "7"}) {
    EXPECT_EQ(integrate("sin(x + exp(x))", "0", "2", {"--digits", "200", "--threads", count}).out,
              integrate("sin(x + exp(x))", "0", "2", {"--digits", "200"}).out);
  }
}

TEST(Integrate, JsonHasTheEnclosureTheVerdictAndTheAccount) {
  const outcome result = integrate("1/(1+x^2)", "0", "1", {"--digits", "30", "--format", "json"});
  EXPECT_EQ(result.status, 0);
  const json answer = json::parse(result.out);
  EXPECT_EQ(answer.at("verdict"), "certified");
  EXPECT_EQ(answer.at("from"), "0");
  expect_enclosure(answer.at("number"), 30);
  EXPECT_EQ(
      answer.at("number").at("value").get<std::string>().rfind("0.785398163397448309615660845", 0),
      0U);
  EXPECT_GT(answer.at("account").at("evaluations"), 10);
  EXPECT_EQ(answer.at("account").at("rules"), json::array({"Gauss-Legendre"}));
  const outcome refused = integrate("1/x", "0", "1", {"--format", "json"});
  EXPECT_EQ(refused.status, 1);
  const json reasons = json::parse(refused.out);
  EXPECT_EQ(reasons.at("verdict"), "not certified");
  EXPECT_EQ(reasons.at("reason"), "not integrable");
}

}  // namespace
}  // namespace polhode::test
