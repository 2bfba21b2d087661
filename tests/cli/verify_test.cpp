// --verify through the program: integrate, roots, eval and constants find their results again, and
// a fault is found.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "enclosure.hpp"
#include "program.hpp"
#include "refusal.hpp"

namespace polhode::test {
namespace verify_test {

using words = std::vector<std::string>;

outcome verified(words arguments) {
  arguments.emplace_back("--verify");
  return run(arguments);
}

outcome verified_integral(const std::string& formula, const std::string& from,
                          const std::string& to, const words& more = {}) {
  words arguments{"integrate", formula, "--from", from, "--to", to};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return verified(arguments);
}

void expect_confirmed(const outcome& result, const words& said = {}) {
  EXPECT_EQ(result.status, 0) << result.out << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("second opinion: the same by "), std::string::npos) << result.out;
  for (const std::string& word : said) {
    EXPECT_NE(result.out.find(word), std::string::npos) << word << " in " << result.out;
  }
}

/// What is printed is as without --verify, and an enclosure by another route is beside it that
/// holds the same digits.
json second_opinion_of(words arguments) {
  arguments.insert(arguments.end(), {"--format", "json"});
  const outcome plain = run(arguments);
  const outcome result = verified(arguments);
  EXPECT_EQ(result.status, 0) << result.out << result.err;
  json printed = json::parse(result.out);
  const json opinion = printed.at("second_opinion");
  printed.erase("second_opinion");
  EXPECT_EQ(printed, json::parse(plain.out));
  EXPECT_EQ(opinion.at("agrees"), true);
  EXPECT_FALSE(opinion.at("route").get<std::string>().empty());
  EXPECT_GE(opinion.at("cost").at("seconds").get<double>(), 0);
  return opinion;
}

void expect_overlap(const json& x, const json& y) {
  const auto end = [](const json& number, const char* which) {
    return parse_rational(number.at(which).get<std::string>());
  };
  EXPECT_LE(end(x, "lower"), end(y, "upper"));
  EXPECT_LE(end(y, "lower"), end(x, "upper"));
}

// ---------------------------------------------------------------------------------------------

TEST(Verify, IntegralsByAnotherRule) {
  // Found by an antiderivative first, by Taylor series, or by Gauss-Legendre.
  expect_confirmed(verified_integral("exp(x)*sin(x)", "0", "7"),
                   {"by turned rays, the range cut at"});
  expect_confirmed(verified_integral("x^3*exp(x)", "0", "7"),
                   {"by Taylor series, the range cut at"});
  expect_confirmed(verified_integral("1/(1+x^2)", "0", "1"), {"the independent checker"});
  expect_confirmed(verified_integral("sin(sin(x))", "0", "1"), {"the same by "});
  expect_confirmed(verified_integral("log(x)/sqrt(x)", "0", "1"));
  expect_confirmed(verified_integral("exp(-x^2)", "-inf", "inf"));
  expect_confirmed(verified_integral("1/(1+x*sqrt(x))", "0", "inf"));
  expect_confirmed(verified_integral("sin(x)/x", "0", "inf", {"--digits", "20"}));
  expect_confirmed(verified_integral("abs(x^2-2)", "1", "2"));
  expect_confirmed(verified_integral("exp(cos(x))", "0", "2*pi", {"--digits", "100"}));
  expect_confirmed(verified_integral("x", "1", "-1"));
  expect_confirmed(verified_integral("x^3*exp(-x^2)", "-2", "2"));  // 0, of parts that are not
  expect_confirmed(verified_integral("exp(x)", "1", "sqrt(2)", {"--rule", "gauss-legendre"}),
                   {"by antiderivative, the range cut at"});
}

TEST(Verify, IntegralsThatWereOnceWrong) {
  // A negligible panel hid that the range's inexact end lay in it, and the sum went on beyond the
  // end. True digits by two references.
  struct known {
    std::string formula, from, to, digits, exponent;
  };
  for (const auto& [formula, from, to, digits, exponent] :
       std::vector<known>{{"exp(x)*(1+exp(x))^400", "-1.4", "-1.3999", "4.83231007601", "e33"},
                          {"sin(x)*cos(x)*(1+sin(x)^2)^400", "0.5", "0.51", "1.96224333045", "e34"},
                          {"1/(1+exp(-x))^400", "-1.5", "-1.499", "3.21501712832", "e-299"},
                          {"sin(x)^700*cos(x)^233", "1", "1.05", "4.12247083255", "e-116"},
                          {"(1+cos(x)^2)^400", "1", "1.1", "1.11162885750", "e42"},
                          {"(4+cos(x))^(2001/2)", "2", "2.05", "1.67173057245", "e552"}}) {
    const outcome result = verified_integral(formula, from, to, {"--digits", "12"});
    expect_confirmed(result);
    EXPECT_EQ(result.out.rfind(digits + "..." + exponent + "\n", 0), 0U) << result.out;
  }
  expect_confirmed(verified_integral("1013/1000/(1+exp(7*x))+1.32e-308*x", "sqrt(2)",
                                     "sqrt(2)+4.29e-16", {"--digits", "300"}));
  for (const auto& [formula, to] : std::vector<std::pair<std::string, std::string>>{
           {"exp(-20*x^2)/(18-x^3)", "cbrt(18)"},
           {"1/(1+exp(x))+1e-40/(18-x^3)^2", "cbrt(18)"},
           {"exp(-16*x^2)/(x^2-4*x-6)", "(4+sqrt(40))/2"}}) {  // divergent
    const outcome result = verified_integral(formula, "0", to, {"--digits", "20"});
    EXPECT_EQ(result.status, 1) << formula;
    EXPECT_EQ(result.out.rfind("undefined\nnot certified: ", 0), 0U) << result.out;
  }
}

TEST(Verify, IntegralsAlongPaths) {
  expect_confirmed(verified({"integrate", "exp(z)/z^3", "--variable", "z", "--circle", "0, 1"}),
                   {"backwards"});
  expect_confirmed(verified({"integrate", "sqrt(x)", "--along", "1, 1+i, -1+i"}), {"10/27"});
}

TEST(Verify, Roots) {
  expect_confirmed(verified({"roots", "cos(x) - x", "--in", "0..1"}),
                   {"backwards", "the independent checker"});
  expect_confirmed(verified({"roots", "(x-1)*(x^2-2)^3", "--in", "-inf..inf"}));
  expect_confirmed(verified({"roots", "sin(x)", "--in", "0..pi"}));
  expect_confirmed(verified({"roots", "tan(x) - x/2", "--in", "-10..10"}));
  expect_confirmed(verified({"roots", "exp(x) + 1", "--in", "-3..3"}));  // none
  expect_confirmed(verified({"roots", "(x+1)^2-x^2-2*x-1", "--in", "0..1"}));
}

TEST(Verify, Values) {
  expect_confirmed(verified({"eval", "exp(pi*sqrt(163)) - 262537412640768744"}),
                   {"complex arithmetic"});
  expect_confirmed(verified({"eval", "zeta(3)/log(2)"}));
  expect_confirmed(verified({"eval", "gamma(1/3)"}), {" arithmetic"});
  expect_confirmed(verified({"eval", "1/3 + 1/6"}), {"1/2 exactly", "without exact numbers"});
}

TEST(Verify, Constants) {
  const outcome result = verified({"constants"});
  expect_confirmed(result, {"log(tan(x/2))", "Carlson", "the independent checker"});
  expect_confirmed(verified({"constants", "beta", "--digits", "2000"}), {"Carlson"});
}

TEST(Verify, JsonHoldsTheSecondEnclosure) {
  const auto number_of = [](words arguments) {
    arguments.insert(arguments.end(), {"--format", "json"});
    return json::parse(run(arguments).out);
  };
  const words integral{"integrate", "exp(x)*sin(x)", "--from", "0", "--to", "7"};
  expect_overlap(second_opinion_of(integral).at("enclosure"), number_of(integral).at("number"));
  const words value{"eval", "pi^exp(1)"};
  expect_overlap(second_opinion_of(value).at("enclosure"), number_of(value).at("number"));
  const words roots{"roots", "cos(x) - x", "--in", "0..1"};
  expect_overlap(second_opinion_of(roots).at("enclosure").at(0),
                 number_of(roots).at("roots").at(0).at("number"));
  const json constant =
      json::parse(verified({"constants", "beta", "--format", "json"}).out).at("beta");
  expect_overlap(constant.at("second_opinion").at("enclosure"), constant);
}

TEST(Verify, WhereThereIsNoSecondRouteTheStatusIs1) {
  const outcome power = verified({"eval", "1e1000000"});
  EXPECT_EQ(power.status, 1);
  EXPECT_EQ(power.out, "1e1000000 exactly\nnot confirmed: no second opinion was found\n");
}

TEST(Verify, WhatIsNotCertifiedNeedsNoSecondOpinion) {
  for (const words& arguments : {words{"integrate", "1/x", "--from", "0", "--to", "1"},
                                 words{"eval", "7*(gamma(1/3)*gamma(2/3)*sqrt(3)/pi - 2)"},
                                 words{"roots", "x^2-2*x*cos(x)+cos(x)^2", "--in", "0..1"}}) {
    const outcome plain = run(arguments);
    const outcome result = verified(arguments);
    EXPECT_EQ(plain.status, 1);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.out, plain.out);
  }
}

TEST(Verify, BadInputIsOneLine) {
  expect_refused({"constants", "--verify", "--format", "csv"}, {"--verify", "text or json"});
  expect_refused({"constants", "--verify", "--format", "cpp"}, {"--verify", "text or json"});
  expect_refused({"roots", "x", "--in", "0..1", "--verify", "--format", "csv"}, {"--verify"});
  expect_refused({"integrate", "x*a", "--from", "0", "--to", "1", "--let", "a=[1,2]", "--verify"},
                 {"--verify", "intervals"});
  expect_refused({"eval", "pi", "--verify=maybe"}, {"--verify"});
  expect_refused({"eval", "pi", "--verfy"}, {"--verify"});
}

TEST(Verify, TheHelpHasAnExample) {
  for (const std::string command : {"integrate", "roots", "eval", "constants"}) {
    const std::string help = run({command, "--help"}).out;
    EXPECT_NE(help.find(" --verify\n"), std::string::npos) << command;
    EXPECT_NE(help.find("3 two\nproofs contradict each other"), std::string::npos);
  }
}

// ---------------------------------------------------------------------------------------------
// A program whose first routes are wrong (tests/cli/faults)

outcome run_with_faults(words arguments) {
  arguments.insert(arguments.begin(), POLHODE_WITH_FAULTS_PATH);
  return run_command(arguments);
}

TEST(Verify, AWrongFirstRouteIsFound) {
  for (const words& arguments :
       {words{"integrate", "exp(x)*sin(x)", "--from", "0", "--to", "7"},
        words{"integrate", "log(x)", "--from", "0", "--to", "1"},
        words{"roots", "x^3-4*x+1", "--in", "-5..5"}, words{"eval", "exp(pi)"},
        words{"eval", "gamma(1/3)*sqrt(2)"}, words{"constants", "beta"},
        words{"constants", "epsilon0_min", "--digits", "30"}, words{"constants"}}) {
    // Without --verify the fault is not seen: it is a certified result.
    EXPECT_EQ(run_with_faults(arguments).status, 0) << arguments[1];
    words with_verify = arguments;
    with_verify.emplace_back("--verify");
    const outcome result = run_with_faults(with_verify);
    EXPECT_EQ(result.status, 3) << arguments[1];
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.rfind("polhode: INTERNAL ERROR: two proofs contradict each other", 0), 0U)
        << result.err;
    for (const char* word : {"first route: ", "second route: ", "There is no result"}) {
      EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
    }
  }
}

TEST(Verify, AContradictionLeavesNoCertificate) {
  const scratch_directory scratch;
  const std::string file = scratch.path("e.json");
  EXPECT_EQ(run_with_faults({"integrate", "exp(x)", "--from", "0", "--to", "1", "--certificate",
                             file, "--verify"})
                .status,
            3);
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace verify_test
}  // namespace polhode::test
