// polhode eval: digits against known ones, exact values, verdicts, and refusals with their columns.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "enclosure.hpp"
#include "polhode/expression/functions.hpp"
#include "program.hpp"

namespace polhode::test {
namespace eval_test {

outcome eval(const std::string& formula, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"eval"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  arguments.insert(arguments.end(), {"--", formula});
  return run(arguments);
}

/// The whole output, certified.
std::string certified(const std::string& formula, const std::vector<std::string>& more = {}) {
  const outcome result = eval(formula, more);
  EXPECT_EQ(result.status, 0) << formula;
  EXPECT_EQ(result.err, "") << formula;
  return result.out;
}

void expect_not_certified(const std::string& formula, const std::vector<std::string>& words,
                          const std::vector<std::string>& more = {}) {
  SCOPED_TRACE(formula);
  const outcome result = eval(formula, more);
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "");
  for (const std::string& word : words) {
    EXPECT_NE(result.out.find(word), std::string::npos) << word << " in " << result.out;
  }
}

void expect_refused(const std::vector<std::string>& arguments,
                    const std::vector<std::string>& words) {
  const outcome result = run(arguments);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("polhode: ", 0), 0U) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  for (const std::string& word : words) {
    EXPECT_NE(result.err.find(word), std::string::npos) << word << " in " << result.err;
  }
}

TEST(Eval, KnownDigits) {
  const std::pair<const char*, const char*> known[] = {
      {"pi", "3.1415926535897932384626433832795028841971693993751..."},
      {"sqrt(2)", "1.4142135623730950488016887242096980785696718753769..."},
      {"exp(pi*sqrt(163)) - 262537412640768744",
       "-7.4992740280181431112064614366266300913729246258962...e-13"},
      {"sin(1e30)", "-0.090116901912138058030386428952987330274396332993043..."},
      {"2^0.5", "1.4142135623730950488016887242096980785696718753769..."},
      {"zeta(3)", "1.2020569031595942853997381615114499907649862923404..."},
      {"gamma(1/2)", "1.7724538509055160272981674833411451827975494561223..."},
      {"floor(pi)", "3 exactly"},
  };
  for (const auto& [formula, digits] : known) {
    EXPECT_EQ(certified(formula), std::string(digits) + '\n') << formula;
  }
  EXPECT_EQ(certified("-pi", {"--digits", "3"}), "-3.14...\n");
  EXPECT_EQ(certified("pi", {"--digits", "1"}), "3...\n");
  EXPECT_EQ(run({"eval", "-2^2"}).out, "-4 exactly\n");
}

TEST(Eval, SeesThroughCancellation) {
  // sin(10^1000) needs pi to more than 1000 digits; in the difference 20,000 digits cancel.
  EXPECT_EQ(certified("sin(10^1000)", {"--digits", "20"}), "0.65335979821036985694...\n");
  EXPECT_EQ(certified("(exp(10^-20000) - 1)*10^20000", {"--digits", "5"}), "1 ± 1e-7\n");
}

TEST(Eval, FewerDigitsAreTheBeginningOfMore) {
  const std::string all = certified("exp(sin(1/3)) + log(7)*pi", {"--digits", "900"});
  for (const char* digits : {"1", "2", "17", "50", "333"}) {
    const std::string some = certified("exp(sin(1/3)) + log(7)*pi", {"--digits", digits});
    EXPECT_EQ(all.rfind(some.substr(0, some.size() - 4), 0), 0U) << digits;
  }
}

TEST(Eval, ExactValuesAreSaidToBe) {
  const std::pair<const char*, const char*> known[] = {
      {"1/3", "1/3 exactly\n0.33333333333333333333333333333333333333333333333333...\n"},
      {"-1/3", "-1/3 exactly\n-0.33333333333333333333333333333333333333333333333333...\n"},
      {"2^100", "1267650600228229401496703205376 exactly\n"},
      {"(1 + 1e-50) - 1", "1/100000000000000000000000000000000000000000000000000 exactly\n1e-50\n"},
      {"0.1 + 0.2", "3/10 exactly\n0.3\n"},
      {"0^0", "1 exactly\n"},
      {"1 - 1", "0 exactly\n"},
      {"-2^2", "-4 exactly\n"},
      {"1e1000000^2", "1e2000000 exactly\n"},
      {"0.001^-1000000", "1e3000000 exactly\n"},
      {"20000/3", "20000/3 exactly\n6666.6666666666666666666666666666666666666666666666...\n"},
      {"exp(0)*sqrt(4/9)",
       "2/3 exactly\n0.66666666666666666666666666666666666666666666666666...\n"},
      {"10^300", "1e300\nan integer, exactly known\n"},
      {"2^1000",
       "1.0715086071862673209484250490600018105614048117055...e301\nan integer, exactly known\n"},
      {"1e-300", "1e-300\na rational number, exactly known\n"},
  };
  for (const auto& [formula, text] : known) {
    EXPECT_EQ(certified(formula), text) << formula;
  }
  EXPECT_EQ(certified("1/7", {"--digits", "4"}), "1/7 exactly\n0.1428...\n");
  EXPECT_EQ(certified("1999/2", {"--digits", "2"}), "1999/2 exactly\n9.9...e2\n");
  EXPECT_EQ(certified("123456789", {"--digits", "2"}), "123456789 exactly\n");
}

TEST(Eval, ExactRulesDecideWhatPrecisionDoesNot) {
  const std::pair<const char*, const char*> known[] = {
      {"cos(pi)", "-1 exactly\n"},
      {"sin(pi)", "0 exactly\n"},
      {"sin(pi/6)", "1/2 exactly\n0.5\n"},
      {"tan(pi/4)", "1 exactly\n"},
      {"cos(pi/5)-1/4-sqrt(5)/4", "0 exactly\n"},
      {"acos(1/2)/pi", "1/3 exactly\n0.33333333333333333333333333333333333333333333333333...\n"},
      {"atan(1)*4/pi", "1 exactly\n"},
      {"sqrt(2)^2", "2 exactly\n"},
      {"sqrt(3+2*sqrt(2))-1-sqrt(2)", "0 exactly\n"},
      {"log(8)/log(2)", "3 exactly\n"},
      {"log(2)+log(3)-log(6)", "0 exactly\n"},
      {"exp(log(3))", "3 exactly\n"},
      {"cosh(log(2))", "5/4 exactly\n1.25\n"},
      {"gamma(1/2)^2 - pi", "0 exactly\n"},
      {"3/2 + sin(pi)", "3/2 exactly\n1.5\n"},
  };
  for (const auto& [formula, text] : known) EXPECT_EQ(certified(formula), text) << formula;
  const outcome third = eval("acos(1/2)/pi", {"--format", "json", "--digits", "30", "--verify"});
  EXPECT_EQ(third.status, 0) << third.err;
  const json number = json::parse(third.out).at("number");
  expect_enclosure(number, 30);
  EXPECT_EQ(number.at("exact"), true);
  EXPECT_EQ(number.at("rational"), "1/3");
}

TEST(Eval, WhatPrecisionDoesNotDecideIsNotCertified) {
  const std::string zero = "gamma(1/3)*gamma(2/3)*sqrt(3)/pi - 2";
  // A sum has its digits beside its terms, whatever their size; a product has none.
  for (const std::string& sum :
       {zero, "1e-300*(pi - (" + zero + "))-pi*1e-300", "-(" + zero + ")"}) {
    const std::string out = certified(sum);
    EXPECT_NE(out.find("certified (relative to the size of its terms): "), std::string::npos)
        << out;
    EXPECT_NE(out.find("it may be exactly 0"), std::string::npos) << out;
  }
  expect_not_certified("7*(" + zero + ")", {"not certified: precision limit", "may be exactly 0"});
  expect_not_certified("abs(" + zero + ")", {"not certified: precision limit"});
  // What is about a short decimal, and not 0, is that with its error.
  EXPECT_EQ(certified("3/2 + " + zero), "1.5 ± 1e-52\n");
  expect_not_certified("tan(pi/2)", {"undefined\n", "not certified: not defined"});
  expect_not_certified("log(-pi)", {"undefined\n", "not certified: not defined"});
  expect_not_certified("1/sin(pi)", {"undefined\n"});
  expect_not_certified("2^(10^12)", {"beyond the greatest exponent"});
  expect_not_certified("erfc(1e10)", {"below the least exponent"});
}

TEST(Eval, JsonHasTheEnclosureAndTheVerdict) {
  const auto in_json = [](const std::string& formula, int status) {
    const outcome result = eval(formula, {"--format", "json", "--digits", "30"});
    EXPECT_EQ(result.status, status) << formula;
    return json::parse(result.out);
  };
  const json number = in_json("pi/4 + 1", 0);
  EXPECT_EQ(number.at("expression"), "pi/4 + 1");
  EXPECT_EQ(number.at("verdict"), "certified");
  expect_enclosure(number.at("number"), 30);
  EXPECT_FALSE(number.at("number").contains("exact"));

  const json third = in_json("-1/3", 0);
  expect_enclosure(third.at("number"), 30);
  EXPECT_EQ(third.at("number").at("exact"), true);
  EXPECT_EQ(third.at("number").at("rational"), "-1/3");
  const json tenth = in_json("0.1", 0);
  EXPECT_EQ(tenth.at("number").at("value"), "0.1");
  EXPECT_EQ(tenth.at("number").at("lower"), "0.1");
  EXPECT_EQ(tenth.at("number").at("upper"), "0.1");
  EXPECT_EQ(in_json("1e1000000", 0).at("number").at("value"), "1e1000000");

  const json sum = in_json("gamma(1/3)*gamma(2/3)*sqrt(3)/pi - 2", 0);
  EXPECT_EQ(sum.at("verdict"), "certified");
  EXPECT_EQ(sum.at("relative_to"), "the size of its terms");
  EXPECT_EQ(number.find("relative_to"), number.end());
  const json zero = in_json("7*(gamma(1/3)*gamma(2/3)*sqrt(3)/pi - 2)", 1);
  EXPECT_EQ(zero.at("verdict"), "not certified");
  EXPECT_EQ(zero.at("reason"), "precision limit");
  const rational radius = parse_rational(zero.at("number").at("radius").get<std::string>());
  EXPECT_LE(abs(parse_rational(zero.at("number").at("value").get<std::string>())), radius);
  EXPECT_EQ(zero.at("number").at("digits"), 0);
  EXPECT_LT(parse_rational(zero.at("number").at("lower").get<std::string>()), 0);
  const json undefined = in_json("log(-pi)", 1);
  EXPECT_EQ(undefined.at("reason"), "not defined");
  EXPECT_TRUE(undefined.at("number").at("lower").is_null());
}

// Values of mpmath 1.3.
TEST(Eval, ComplexValues) {
  const auto is = [](const std::string& formula, const std::string& re, const std::string& im) {
    EXPECT_EQ(certified(formula, {"--digits", "15"}),
              "real part      " + re + "\nimaginary part " + im + '\n')
        << formula;
  };
  is("gamma(1/4+i)", "0.0991497587634533...", "-0.516617743792885...");
  is("lambertW(1+i)", "0.656966069230436...", "0.325450339413415...");
  is("besselJ(1/3,2+3i)", "1.69009520279896...", "-3.94540478670958...");
  is("ellipticK(1/2+i)", "1.49610681459271...", "0.431362233021048...");
  is("agm(1,1+i)", "1.04916052873278...", "0.478155746088161...");
  is("asin(2+i)", "1.06344002357775...", "1.46935174436818...");
  is("expint(1,1+i)", "0.000281624451981418...", "-0.179324535039358...");
  is("i^i", "0.207879576350761...", "0");
  is("(1+i)^10", "0", "32");
  is("sqrt(-1+0*i)", "0", "1");
  EXPECT_EQ(run({"eval", "abs(2)*(k+i)", "--let", "k=2"}).out,
            "real part      4\nimaginary part 2\n");
}

TEST(Eval, APartOfAComplexValueThatMayBeZeroHasItsDigitsBesideTheOther) {
  const std::string turn = certified("e^(i*pi)", {"--digits", "20"});
  EXPECT_EQ(turn.rfind("real part      -1 ± 1e-22\nimaginary part 0 ± ", 0), 0U) << turn;
  EXPECT_NE(turn.find("\ncertified (relative to the absolute value): "), std::string::npos);
  expect_not_certified("1/(sin(i)^2+cos(i)^2-1)", {"undefined", "not defined"});
  expect_not_certified("sin(i)^2+cos(i)^2-1", {"precision limit"});
  expect_refused({"eval", "abs(3+4*i)"}, {"abs", "real numbers"});
  expect_refused({"eval", "floor(2*i)"}, {"floor", "real numbers"});
  expect_refused({"eval", "exp(i)", "--verify"}, {"--verify", "no second route"});
  expect_refused({"eval", "foo(i)"}, {"foo"});
  EXPECT_EQ(run({"eval", "i", "--let", "i=3"}).out.substr(0, 9), "3 exactly");
  const json number = json::parse(eval("exp(i)", {"--format", "json"}).out).at("number");
  expect_enclosure(number.at("real"), 50);
  expect_enclosure(number.at("imaginary"), 50);
}

TEST(Eval, LetDefinesNames) {
  EXPECT_EQ(run({"eval", "a*b", "--let", "a=1/3", "--let", "b=a + 1"}).out.substr(0, 11),
            "4/9 exactly");
  EXPECT_EQ(run({"eval", "--let", "k=sqrt(2)", "k*k*pi", "--digits", "3"}).out, "6.28...\n");
  expect_refused({"eval", "k", "--let", "k"}, {"--let \"k\"", "NAME=VALUE"});
  expect_refused({"eval", "k", "--let", "=1"}, {"NAME=VALUE"});
  expect_refused({"eval", "k", "--let", "k="}, {"in the value of k", "column 1"});
  expect_refused({"eval", "k", "--let", "k=(1"}, {"in the value of k", "column 3", "\")\""});
  expect_refused({"eval", "k", "--let", "k=j"}, {"in the value of k", "\"j\""});
  expect_refused({"eval", "1", "--let", "sin=1"}, {"\"sin\"", "function"});
  expect_refused({"eval", "1", "--let", "k=1", "--let", "k=2"}, {"\"k\"", "twice"});
}

TEST(Eval, BadFormulasAreRefusedWithTheColumn) {
  expect_refused({"eval"}, {"there is no formula"});
  expect_refused({"eval", ""}, {"column 1", "ends here"});
  expect_refused({"eval", "pi pi"}, {"\"pi pi\"", "column 4", "pi*pi"});
  expect_refused({"eval", "1 +"}, {"column 4", "ends here"});
  expect_refused({"eval", "sine(1)"}, {"column 1", "nearest is sin"});
  expect_refused({"eval", "x"}, {"column 1", "\"x\""});
  expect_refused({"eval", "1/0"}, {"column 2", "division by zero"});
  expect_refused({"eval", "1 + sqrt(-1)"}, {"column 5", "sqrt(-1)", "x >= 0"});
  expect_refused({"eval", "log(0)"}, {"column 1", "x > 0"});
  expect_refused({"eval", "(-8)^(1/3)"}, {"column 5", "root(x, n)"});
  expect_refused({"eval", "1e1000000000"}, {"column 1", "exponent of ten"});
  expect_refused({"eval", std::string(100'001, '1')}, {"100001 characters"});
  expect_refused({"eval", std::string(90'000, '(')}, {"column 201", "parentheses"});
  expect_refused({"eval", "1", "2"}, {"\"2\""});
  expect_refused({"eval", "-y"}, {"\"-y\": column 2"});  // not an option, but a formula
  expect_refused({"eval", "1", "--digits", "0"}, {"--digits"});
  expect_refused({"eval", "1", "--format", "xml"}, {"text, json"});
  expect_refused({"eval", "pi", "--digits", "1000000000"},
                 {"1000000000 digits of this formula need about", "GiB"});
  expect_refused({"eval", "pi", "--digits", "100000", "--memory-limit", "1/1000000"}, {"GiB"});
}

TEST(Eval, ListsItsFunctions) {
  const outcome list = run({"eval", "--functions"});
  EXPECT_EQ(list.status, 0);
  const std::string help = run({"eval", "--help"}).out;
  for (const expression_function& f : expression_functions()) {
    EXPECT_NE(list.out.find("  " + f.name + "(" + f.arguments + ")"), std::string::npos) << f.name;
    EXPECT_NE(list.out.find(f.description), std::string::npos) << f.name;
    EXPECT_NE(help.find(" " + f.name), std::string::npos) << f.name;
  }
  for (const expression_constant& c : expression_constants()) {
    EXPECT_NE(list.out.find("  " + c.name + " "), std::string::npos) << c.name;
    EXPECT_NE(help.find(" " + c.name), std::string::npos) << c.name;
  }
  for (const std::string& line : lines_of(list.out + help)) EXPECT_LE(line.size(), 100U) << line;
}

}  // namespace eval_test
}  // namespace polhode::test
