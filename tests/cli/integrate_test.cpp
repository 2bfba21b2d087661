// polhode integrate: what it prints, its verdicts and its exit statuses.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "enclosure.hpp"
#include "program.hpp"

namespace polhode::test {
namespace integrate_test {

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
  // sqrt(pi); pi/2 - 1 by parts; Euler's constant; Li_2(-1) = -pi^2/12; the lemniscate's arc, Gauss
  // 1799.
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

TEST(Integrate, AValueWithItsErrorWhereDigitsDoNotEnd) {
  const outcome result = integrate("-2*x*exp(-x^2)", "0", "inf", {"--digits", "30"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out.rfind("-1 ± ", 0), 0U) << result.out;
  // Odd about pi, which is seen; and about pi/2, which is not.
  const outcome zero = integrate("sin(x)*exp(cos(x))", "0", "2*pi", {"--digits", "12"});
  EXPECT_EQ(zero.out.rfind("0 exactly\n", 0), 0U) << zero.out;
  const outcome near = integrate("exp(cos(x))-exp(-cos(x))", "0", "pi", {"--digits", "12"});
  EXPECT_EQ(near.out.rfind("0 ± ", 0), 0U) << near.out;
}

TEST(Integrate, ReversedAndEqualLimits) {
  EXPECT_EQ(digits_of(integrate("exp(x)", "1", "0")).front(), '-');
  EXPECT_EQ(integrate("exp(x)", "1/3", "1/3").out.rfind("0 exactly\n", 0), 0U);
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
  for (const auto& [formula, from, to, reason, place] : std::vector<refusal>{
           {"1/x", "-1", "2", "not integrable", "x = 0"},
           {"1/(x-1/3)", "0", "1", "not integrable", "x = 0.3333"},
           {"1/(x^2-2)", "0", "3", "not integrable", "x = 1.4142"},
           {"tan(x)", "0", "2", "not integrable", "x = 1.5707"},
           {"1/x", "1", "inf", "not integrable", "infinity"},
           {"sqrt(x)", "-1", "1", "not defined", "sqrt(-12/13) is not defined: it needs x >= 0"},
           {"sqrt(sin(x))", "0", "4", "not defined", "no value at x = 22/7: sqrt needs x >= 0"},
           {"cos(x)^(2/3)", "0", "pi", "not defined", "root(x, n) is the real root of odd order"},
           {"ellipticK(x)", "0", "2", "not defined", "needs m < 1"},
           {"sqrt(1-x^2)", "-inf", "inf", "not defined", "no value at x = 1237/941"},
           // With the limits the wrong way round, and the same number by two formulas.
           {"sqrt(sin(x))", "4", "0", "not defined", "no value at x = 22/7: sqrt needs x >= 0"},
           {"sqrt(1-x^2)", "inf", "-inf", "not defined", "no value at x = 1237/941"},
           {"gamma(x)", "-1001/3", "-100", "not ", ""},
           {"gamma(x)", "-inf", "-1/2", "not ", ""},
           {"sqrt(-x)", "0", "1e-100000", "not defined", "no value at x = 3.906"},
           {"sqrt(x-3)", "sqrt(2)*sqrt(3)", "sqrt(6)", "not", ""},
           {"log_gamma(x)", "-0.9", "-0.1", "not analytic", "log_gamma of complex arguments"}}) {
    const outcome result = integrate(formula, from, to, {"--digits", "20"});
    EXPECT_EQ(result.status, 1) << formula;
    EXPECT_EQ(result.out.rfind("undefined\nnot certified: " + reason, 0), 0U) << result.out;
    EXPECT_NE(result.out.find(place), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("whole number"), std::string::npos) << result.out;
  }
}

TEST(Integrate, BadInputIsOneLineThatSaysWhatWouldBeRight) {
  const auto expect_refusal = [](const outcome& result, const std::string& words) {
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  };
  expect_refusal(integrate("y*z", "0", "1"), "column 1: there is no \"y\"");
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
       std::vector<symmetric>{{"exp(sin(x)^2)", "0", "pi/2"},
                              {"exp(cos(x) + sin(2*x))", "-pi", "pi"},
                              {"exp(cos(3*pi*x))", "1/3", "2 - 2/3"},
                              {"1/(2 + sin(x) + cos(x))", "h", "h + 2*pi"}}) {
    const outcome result = integrate(formula, from, to, {"--let", "h=3/2*pi - 1"});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.out.find("(trapezoid)"), std::string::npos) << result.out;
    const outcome panels =
        integrate(formula, from, to, {"--let", "h=3/2*pi - 1", "--rule", "gauss-legendre"});
    EXPECT_EQ(digits_of(panels), digits_of(result));
    EXPECT_NE(panels.out.find("(Gauss-Legendre)"), std::string::npos) << panels.out;
  }
  for (const std::string to : {"1.5707963267948966", "asin(1)"}) {
    const outcome result = integrate("exp(sin(x)^2)", "0", to);
    EXPECT_EQ(result.out.find("(trapezoid)"), std::string::npos) << result.out;
  }
}

TEST(Integrate, RulesThatAreInsistedOn) {
  for (const std::string rule :
       {"gauss-legendre", "clenshaw-curtis", "double-exponential", "taylor-series"}) {
    const outcome result = integrate("sqrt(x)*exp(x)", "0", "1", {"--rule", rule});
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_EQ(digits_of(result), digits_of(integrate("sqrt(x)*exp(x)", "0", "1")));
  }
  const outcome refused = integrate("sqrt(x)*exp(x)", "0", "1", {"--rule", "trapezoid"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.out.rfind("undefined\nnot certified: not applicable (the trapezoidal rule", 0),
            0U)
      << refused.out;
  const outcome no_series = integrate("log(x)", "0", "1", {"--rule", "taylor-series"});
  EXPECT_EQ(no_series.status, 1);
  EXPECT_EQ(no_series.out.rfind("undefined\nnot certified: not applicable (Taylor series need", 0),
            0U)
      << no_series.out;
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
  EXPECT_GT(answer.at("account").at("terms"), 10);
  EXPECT_EQ(answer.at("account").at("rules"), json::array({"Taylor series"}));
  const json by_nodes =
      json::parse(integrate("log(1+x)", "0", "1", {"--digits", "30", "--format", "json"}).out);
  EXPECT_GT(by_nodes.at("account").at("evaluations"), 10);
  EXPECT_EQ(by_nodes.at("account").at("terms"), 0);
  EXPECT_EQ(by_nodes.at("account").at("rules"), json::array({"Gauss-Legendre"}));
  const outcome refused = integrate("1/x", "0", "1", {"--format", "json"});
  EXPECT_EQ(refused.status, 1);
  const json reasons = json::parse(refused.out);
  EXPECT_EQ(reasons.at("verdict"), "not certified");
  EXPECT_EQ(reasons.at("reason"), "not integrable");
}

TEST(Integrate, PolynomialsBetweenRationalLimitsAreExact) {
  const std::string how = "certified: by an antiderivative or a symmetry, in rational numbers\n";
  EXPECT_EQ(integrate("x", "0", "1").out, "1/2 exactly\n0.5\n" + how);
  EXPECT_EQ(integrate("x^2", "2", "-1").out, "-3 exactly\n" + how);
  EXPECT_EQ(integrate("x^3", "-1", "1").out, "0 exactly\n" + how);
  EXPECT_EQ(integrate("(x - 1/3)^2*6/7 + 2", "0", "1/3", {"--digits", "5"}).out,
            "128/189 exactly\n0.67724...\n" + how);
  EXPECT_EQ(integrate("7", "0", "1/2").out, "7/2 exactly\n3.5\n" + how);
  const outcome result = integrate("x^2", "0", "1", {"--format", "json", "--digits", "20"});
  EXPECT_EQ(result.status, 0) << result.err;
  const json answer = json::parse(result.out);
  EXPECT_EQ(answer.at("verdict"), "certified");
  expect_enclosure(answer.at("number"), 20);
  EXPECT_EQ(answer.at("number").at("exact"), true);
  EXPECT_EQ(answer.at("number").at("rational"), "1/3");
  EXPECT_EQ(answer.at("account").at("panels"), 0);
  // A rule that is insisted on, a second opinion, and limits that are not rational keep their ways.
  for (const outcome& other : {integrate("x", "0", "1", {"--rule", "gauss-legendre"}),
                               integrate("x", "0", "1", {"--verify"}), integrate("x", "0", "pi")}) {
    EXPECT_EQ(other.status, 0) << other.err;
    EXPECT_EQ(other.out.find("exactly"), std::string::npos) << other.out;
  }
}

// Along paths in the complex plane.

outcome along(const std::string& formula, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"integrate", formula};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments);
}

TEST(IntegrateAlong, PolygonsAndCircles) {
  // (2/3) (z^(3/2) - 1), z = -1 + i: its modulus 2^(3/4) and angle 9 pi/8 give both parts.
  const outcome root = along("sqrt(x)", {"--along", "1, 1+i, -1+i", "--digits", "30"});
  EXPECT_EQ(root.status, 0) << root.err;
  const auto part = [](const std::string& formula) {
    return digits_of(run({"eval", formula, "--digits", "30"})) + "...\n";
  };
  EXPECT_EQ(root.out.rfind("real part      " + part("2/3*(2^(3/4)*cospi(9/8) - 1)") +
                               "imaginary part " + part("2/3*2^(3/4)*sinpi(9/8)") + "certified: ",
                           0),
            0U)
      << root.out;
  const outcome residue =
      along("exp(z)/z^3", {"--variable", "z", "--circle", "0, 1", "--digits", "20"});
  EXPECT_EQ(residue.status, 0);
  EXPECT_NE(residue.out.find("imaginary part 3.1415926535897932384..."), std::string::npos);
  // A corner that begins with a minus sign, commas in parentheses, names, i in the integrand.
  const outcome names =
      along("exp(i*x)*k", {"--along", "-i, hypot(0, h), -1+i", "--let", "k=2", "--let", "h=1/3"});
  EXPECT_EQ(names.status, 0) << names.err;
  EXPECT_EQ(
      along("x", {"--along", "1+i, 1+i"}).out.rfind("real part      0\nimaginary part 0\n", 0), 0U);
}

TEST(IntegrateAlong, RefusalsSayWhatIsInTheWayAndWhere) {
  const outcome cut = along("sqrt(x)", {"--along", "-1-i, -1+i"});
  EXPECT_EQ(cut.status, 1);
  EXPECT_EQ(
      cut.out.rfind("undefined\nnot certified: not analytic (the branch cut of sqrt near z = ", 0),
      0U)
      << cut.out;
  EXPECT_EQ(along("1/x", {"--along", "-1-i, 1+i"}).status, 1);
  for (const std::string formula : {"abs(x)", "x*max(x, 1)", "floor(x)"}) {
    const outcome refused = along(formula, {"--along", "0, 1+i"});
    EXPECT_EQ(refused.status, 1) << formula;
    EXPECT_NE(refused.out.find("is not analytic in the complex plane"), std::string::npos);
  }
  EXPECT_EQ(along("x + abs(1-pi)", {"--along", "0, 1+i"}).status, 0);
}

TEST(IntegrateAlong, JsonHasBothParts) {
  const outcome result = along("1/z", {"--variable", "z", "--circle", "0, 1", "--format", "json"});
  const json document = json::parse(result.out);
  EXPECT_EQ(document["verdict"], "certified");
  EXPECT_EQ(document["circle"], "0, 1");
  EXPECT_EQ(document["number"]["imaginary"]["digits"], 50);
  EXPECT_FALSE(document.contains("from"));
}

// Parameters in intervals.

TEST(IntegrateOverBox, TheRangeOfAnEllipticIntegral) {
  const outcome result =
      integrate("1/sqrt(1-m*sin(x)^2)", "0", "pi/2", {"--let", "m=[0.1, 0.2]", "--digits", "20"});
  EXPECT_EQ(result.status, 0) << result.err;
  // K(m) = pi/(2 agm(1, sqrt(1-m))); 18 digits of each.
  const auto k = [](const std::string& m) {
    return digits_of(run({"eval", "pi/2/agm(1, sqrt(1-" + m + "))", "--digits", "18"}));
  };
  EXPECT_EQ(result.out.rfind("from " + k("0.1"), 0), 0U) << result.out;
  EXPECT_NE(result.out.find("\n  to " + k("0.2")), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("both ends are attained"), std::string::npos);
  const outcome parsed = integrate("exp(p*x)*cos(q*x)", "0", "1",
                                   {"--let", "h=1/2", "--let", "p=[1, 2*h+0.1]", "--let",
                                    "q=[-0.1, 0.1]", "--boxes", "8", "--format", "json"});
  EXPECT_EQ(parsed.status, 0) << parsed.err;
  const json document = json::parse(parsed.out);
  EXPECT_EQ(document["range"]["attained"], false);
  EXPECT_EQ(document["parameters"]["q"], "[-0.1, 0.1]");
  EXPECT_LE(document["account"]["boxes"], 8);
}

TEST(IntegrateOverBox, EveryFunctionsDerivativeIsThatOfItsValues) {
  // With G(a) for the integral of g and q for (G(1.001) - G(1))/0.001: G(a) - s a must be found to
  // rise over [1, 1.001] for s a little below q, and to fall for s a little above it.
  for (const std::string g : {"expm1(a*x)",         "log1p(a*x)",     "sinpi(a*x/9)",
                              "cospi(a*x/9)",       "abs(a*x-9)",     "abs(a+x)",
                              "min(a*x, 5)",        "min(5, a*x)",    "max(a*x, -5)",
                              "max(-5, a*x)",       "hypot(a, x)",    "atan2(a, x+1)",
                              "atan2(x+1, a)",      "(a+x)^3",        "(a+x)^a",
                              "cbrt(a+x)",          "cbrt(a*x-9)",    "root(a+x, 4)",
                              "erf(a*x)",           "erfc(a*x)",      "tan(a*x/2)",
                              "asin(a*x/2)",        "acos(a*x/2)",    "atan(a*x)",
                              "asinh(a*x)",         "acosh(a+x+1)",   "atanh(a*x/2)",
                              "sinh(a*x)",          "cosh(a*x)",      "tanh(a*x)",
                              "exp(a*x)/a",         "log(a+x)",       "sqrt(a+x)",
                              "floor(a*x/3+0.1)+a", "a*ceil(x/3+0.1)"}) {
    const auto over = [&](const std::string& formula, const std::string& a,
                          const std::string& kind) {
      const outcome o =
          integrate(formula, "0", "1", {"--let", "a=" + a, "--digits", "18", "--format", "json"});
      EXPECT_EQ(o.status, 0) << formula << o.out;
      return json::parse(o.out).at(kind);
    };
    const auto end = [](const json& range, const std::string& which) {
      return std::stod(range.at(which).get<std::string>());
    };
    const double quotient =
        (end(over(g, "1.001", "number"), "lower") - end(over(g, "1", "number"), "lower")) * 1000;
    const double margin = 0.05 * std::abs(quotient) + 0.002;
    for (const int sign : {-1, 1}) {
      const std::string tilted = g + " - (" + std::to_string(quotient + sign * margin) + ")*a";
      const json range = over(tilted, "[1, 1.001]", "range");
      EXPECT_TRUE(range.at("attained").get<bool>()) << tilted;
      EXPECT_LE(end(range, "lower"), end(over(tilted, sign < 0 ? "1" : "1.001", "number"), "upper"))
          << tilted;
      EXPECT_GE(end(range, "upper"), end(over(tilted, sign < 0 ? "1.001" : "1", "number"), "lower"))
          << tilted;
    }
  }
}

TEST(IntegrateOverBox, RefusedWhereItIsSingularForSomeParameter) {
  const outcome result = integrate("1/(x+a)", "0", "1", {"--let", "a=[-1, 1]"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out.rfind("undefined\nnot certified: not analytic (the pole of /", 0), 0U)
      << result.out;
}

TEST(IntegrateAlong, BadInputIsOneLineThatSaysWhatWouldBeRight) {
  const auto expect_refusal = [](const outcome& result, const std::string& words) {
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  };
  expect_refusal(along("x", {}), "there is no range");
  expect_refusal(along("x", {"--to", "1"}), "give both limits");
  expect_refusal(along("x", {"--along", "0, 1", "--circle", "0, 1"}), "more than one range");
  expect_refusal(along("x", {"--along", "0, 1", "--from", "0"}), "more than one range");
  expect_refusal(along("x", {"--along", "1"}), "two points or more");
  expect_refusal(along("x", {"--along", "1,,2"}), "the formula ends here");
  expect_refusal(along("x", {"--along", ""}), "formula");
  expect_refusal(along("x", {"--circle", "0"}), "CENTRE, RADIUS");
  expect_refusal(along("x", {"--circle", "0, -1"}), "must not be negative");
  expect_refusal(along("x", {"--circle", "0, i"}), "there is no \"i\"");
  expect_refusal(along("x", {"--circle", "0, 1", "--let", "i=2"}), "i is the imaginary unit");
  expect_refusal(along("i", {"--circle", "0, 1", "--variable", "i"}), "i is the imaginary unit");
  expect_refusal(along("a*x", {"--circle", "0, 1", "--let", "a=[1, 2]"}), "--from and --to");
  expect_refusal(integrate("x", "0", "1+i"), "there is no \"i\"");
  expect_refusal(integrate("a*x", "0", "1", {"--let", "a=[2, 1]"}), "above the upper end");
  expect_refusal(integrate("a*x", "0", "1", {"--let", "a=[1, 2"}), "[LOWER, UPPER]");
  expect_refusal(integrate("a*x", "0", "1", {"--let", "a=[]"}), "[LOWER, UPPER]");
  expect_refusal(integrate("a*x", "0", "1", {"--let", "a=[1, pi]"}), "rational");
  expect_refusal(integrate("a*x", "0", "1", {"--let", "a=[1, 2]", "--boxes", "0"}),
                 "--boxes \"0\"");
  expect_refusal(run({"eval", "a", "--let", "a=[1, 2]"}), "in the value of a");
}

}  // namespace integrate_test
}  // namespace polhode::test
