// polhode roots: what it prints, its verdicts and its exit statuses.

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "enclosure.hpp"
#include "program.hpp"

namespace polhode::test {
namespace roots_test {

outcome roots(const std::string& formula, const std::string& range,
              const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"roots", formula, "--in", range};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(Roots, DigitsAreTheFirstOfTheTrueValue) {
  const outcome result = roots("cos(x) - x", "0..1", {"--digits", "60"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  // The Dottie number: mpmath 1.3.0.
  EXPECT_EQ(result.out.rfind(
                "0.739085133215160641655312087673873404013411758900757464965680...  unique\n", 0),
            0U)
      << result.out;
  EXPECT_NE(result.out.find("\ncertified: 1 root, all there are"), std::string::npos);
}

TEST(Roots, TheNumberOfThreadsChangesNothing) {
  for (const auto& [formula, range] :
       std::vector<std::pair<std::string, std::string>>{{"exp(x) - 4*sin(7*x)^2 - 1", "-2..pi"},
                                                        {"sin(x^2)*(1-cos(x))", "0..12"},
                                                        {"(x^2-2)^2*(x^5-x+1)", "-inf..inf"}}) {
    const std::vector<std::string> json{"--format", "json", "--digits", "70"};
    const outcome one = roots(formula, range, json);
    for (const std::string count : {"0", "2", "3", "8"}) {
      std::vector<std::string> more = json;
      more.insert(more.end(), {"--threads", count});
      const outcome other = roots(formula, range, more);
      EXPECT_EQ(other.out, one.out) << formula << ", " << count;
      EXPECT_EQ(other.status, one.status);
    }
  }
  EXPECT_EQ(roots("x", "0..1", {"--threads", "-1"}).status, 2);
  EXPECT_EQ(roots("x", "0..1", {"--threads", "two"}).status, 2);
}

TEST(Roots, VerdictsOfEveryKind) {
  struct expected {
    std::string formula, range;
    int status;
    std::vector<std::string> words;
  };
  for (const auto& [formula, range, status, words] : std::vector<expected>{
           {"(x-1)*(x^2-2)^3*(x^3-2)^4",
            "-inf..inf",
            0,
            {"multiple 3", "1 exactly  unique", "multiple 4", "certified: 4 roots"}},
           {"exp(x)-x-1", "-1..1", 0, {"0 exactly  multiple 2"}},
           {"x^20", "-1..1", 0, {"0 exactly  multiple 20"}},
           {"1/x", "-1..1", 0, {"no root: a pole of order 1 at 0", "certified: no root"}},
           {"tan(x)", "-10..10", 0, {"certified: 7 roots", "pole of order 1 at 1.57079632679..."}},
           {"sqrt(x)-1/2",
            "-1..1",
            0,
            {"1/4 exactly  unique", "not defined everywhere in [-1, 0]"}},
           {"abs(x)", "-1..1", 0, {"0 exactly  isolated", "certified: 1 root"}},
           {"floor(x)-1/2", "0..2", 0, {"certified: no root"}},
           {"floor(x^2)-x^2", "5/4..3/2", 1, {"unresolved (the jump of floor)"}},
           {"1-cos(x)", "6..7", 0, {"6.28318530717958647692528676655...  multiple 2"}},
           {"x^2-2*x*cos(x)+cos(x)^2", "0..1", 1, {"unresolved", "2 complex roots near it"}},
           {"sin(x)", "0..inf", 0, {"infinitely many roots; these are all in 0..2*pi"}},
           {"x*tan(x)-1",
            "0..inf",
            0,
            {"towards infinity  infinitely many (proved; ",
             "certified: infinitely many roots; outside the region that holds them "}},
           {"sin(1/x)+x", "-1..1", 0, {"infinitely many (proved; ", "certified: infinitely many"}},
           {"exp(-x/10)*sin(x)/cosh(x)",
            "0..inf",
            0,
            {"infinitely many roots; these are all in 0..2*pi"}},
           {"tan(x)-1", "-inf..1", 0, {"in 1 - 2*pi..1, and they have the period 2*pi"}},
           {"sin(x)/x", "-4..4", 0, {"certified: 2 roots", "not defined everywhere in 0"}},
           {"sin(x)", "0..2*pi", 0, {"certified: 3 roots"}},
           {"sin(x)*exp(x)^2", "-pi/2-pi/2..1", 0, {"certified: 2 roots"}},
           {"exp(x)-2", "0..log(2)", 1, {"unique (at an end of the interval, inside or outside)"}},
           {"(x-1/3)^2-1e-40", "0..1", 0, {"certified: 2 roots"}},
           {"(x-1/3)^2+1e-40", "0..1", 0, {"certified: no root"}},
           {"x-x", "0..1", 0, {"0 everywhere"}},
           {"max(x,0)*(x-1/2)",
            "-inf..2",
            0,
            {"(-inf, 0]  the formula is 0\n", "1/2 exactly  unique\n",
             "certified: 1 interval of roots and 1 root, all there are"}},
           {"floor(x)", "-2..2", 0, {"[0, 1)  the formula is 0\n"}},
           {"x^2 = 2", "0..2", 0, {"1.4142135623730950488016887242", "certified: 1 root"}},
           {"exp(x) = 3*x", "0..2", 0, {"certified: 2 roots"}},
           {"1", "0..1", 0, {"certified: no root"}},
           {"x-1e300", "-inf..inf", 0, {"1e300 exactly  unique"}},
           {"exp(x)-1e-300", "-inf..inf", 0, {"-690.77552789821"}},
           {"log1p(x)*expm1(x)", "-1/2..1", 0, {"0 exactly  multiple 2"}},
           {"cbrt(x)", "-1..1", 0, {"0 exactly  isolated"}},
           {"sqrt(x^2)+x", "-1..1", 1, {"from -1 to ", "unresolved", "not certified"}},
           {"2^x-8", "-inf..inf", 0, {"unique\ncertified: 1 root, all there are"}},
           {"x^x-2", "0..2", 0, {"1.5596104694623693499703887"}},
           {"gamma(x)-2", "5/2..7/2", 0, {"3 exactly  unique"}},
           {"agm(1,x)-2", "3..4", 0, {"3.3527891347425124594365307"}},
           {"exp(2*x)-4*exp(x)+4", "0..1", 0, {"multiple 2"}}}) {
    const outcome result = roots(formula, range, {"--digits", "30"});
    EXPECT_EQ(result.status, status) << formula << '\n' << result.out << result.err;
    for (const std::string& w : words) {
      EXPECT_NE(result.out.find(w), std::string::npos) << formula << ": " << w << '\n'
                                                       << result.out;
    }
  }
}

TEST(Roots, TheInterval) {
  EXPECT_EQ(lines_of(roots("sin(x)", "-pi*3/2..3*pi/2").out).size(), 4U);
  EXPECT_EQ(lines_of(roots("sin(x)", "-h .. h", {"--let", "h=7/2"}).out).size(), 4U);
  EXPECT_EQ(roots("x-2", "1...2.5").status, 0);  // 1. to 2.5, or 1 to .2.5, which is none
  EXPECT_EQ(roots("-x+1/2", "0..1").out.rfind("1/2 exactly", 0), 0U);
  EXPECT_EQ(roots("t-1", "-5..5", {"--variable", "t"}).out.rfind("1 exactly", 0), 0U);
  EXPECT_EQ(roots("t = 1", "-5..5").out.rfind("1 exactly", 0), 0U);
  EXPECT_EQ(roots("k*t = 1", "-5..5", {"--let", "k=1"}).out.rfind("1 exactly", 0), 0U);
  EXPECT_NE(roots("k*t = 1", "-5..5").err.find("there is no \"k\""), std::string::npos);
}

TEST(Roots, BadInputIsOneLineThatSaysWhatWouldBeRight) {
  const auto expect_refusal = [](const outcome& result, const std::string& words) {
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  };
  expect_refusal(roots("x", "1..0"), "the wrong way round");
  expect_refusal(roots("x", "inf..0"), "the wrong way round");
  expect_refusal(roots("y*z", "0..1"), "column 1: there is no \"y\"");
  expect_refusal(roots("x", "0..k"), "there is no \"k\"");
  expect_refusal(roots("x", "0"), "LO..HI");
  expect_refusal(roots("x", "0.."), "--in \"0..\"");
  expect_refusal(roots("x", "..1"), "--in \"..1\"");
  expect_refusal(roots("x", "0..log(-pi)"), "not defined");
  expect_refusal(roots("x", "0..1", {"--digits", "0"}), "--digits \"0\"");
  expect_refusal(roots("x", "0..1", {"--format", "xml"}), "text, csv, json");
  expect_refusal(roots("x", "0..1", {"--digits", "1000000000"}), "memory");
  expect_refusal(run({"roots", "x"}), "--in");
}

TEST(Roots, CsvHasALineForEveryRoot) {
  const outcome result = roots("(x-1/3)*(x^2-2)^2", "-5..5", {"--format", "csv", "--digits", "20"});
  EXPECT_EQ(result.status, 0);
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "verdict,multiplicity,value,radius,lower,upper,digits,exact,remark");
  EXPECT_EQ(lines[1].rfind("multiple,2,-1.4142135623730950488,", 0), 0U) << lines[1];
  EXPECT_EQ(lines[2].rfind("unique,1,0.33333333333333333333,", 0), 0U) << lines[2];
  EXPECT_NE(lines[2].find(",20,1/3,"), std::string::npos);
}

TEST(Roots, CertifiesOnlyWhatHasTheDigitsAskedFor) {
  // Roots that cannot be told from 0 have the digits of the interval's size; without such a size
  // they have none.
  const char* const at_0 = "x-ellipticK(1/2)+pi/(2*agm(1,sqrt(1/2)))";  // no rule shows it
  for (const char* formula : {"log(1+x)-1e-30000", at_0}) {
    const outcome small = roots(formula, "-1/2..1", {"--digits", "20"});
    EXPECT_EQ(small.status, 0) << small.out;
    EXPECT_NE(small.out.find("unique (it may be 0"), std::string::npos) << small.out;
  }
  const outcome result = roots(at_0, "-1e-25000..1e-25000", {"--digits", "20"});
  EXPECT_NE(result.status, 0) << result.out;
  EXPECT_NE(result.out.find("fewer digits than asked for"), std::string::npos) << result.out;
  const outcome far = roots("(x-1e300)*(x+1e-300)", "-inf..inf", {"--digits", "20"});
  EXPECT_EQ(far.status, 0) << far.out;
  EXPECT_NE(far.out.find("-1e-300 exactly "), std::string::npos) << far.out;
  EXPECT_EQ(roots("x^2-2", "0..2", {"--digits", "300"}).status, 0);
}

TEST(Roots, ComplexRootsOfAPolynomial) {
  const outcome result =
      run({"roots", "(x^2+x+1)*(x-1/3)^2*(x^3-2)", "--complex", "--digits", "20"});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 7U) << result.out;
  EXPECT_EQ(lines[0], "-0.62996052494743658238... - 1.0911236359717214035...i  unique");
  EXPECT_EQ(lines[1], "-0.62996052494743658238... + 1.0911236359717214035...i  unique");
  EXPECT_EQ(lines[4], "1/3 exactly  multiple 2");
  EXPECT_EQ(lines[5], "1.2599210498948731647...  unique");
  EXPECT_EQ(lines[6], "certified: 6 roots, with multiplicities as many as the degree, 7");
  const outcome as_json =
      run({"roots", "x^4+1", "--complex", "--digits", "15", "--format", "json"});
  const json answer = json::parse(as_json.out);
  ASSERT_EQ(answer.at("roots").size(), 4U);
  expect_enclosure(answer.at("roots")[0].at("number").at("real"), 15);
  const outcome as_csv = run({"roots", "x^4+1", "--complex", "--digits", "15", "--format", "csv"});
  EXPECT_EQ(lines_of(as_csv.out).size(), 5U);
}

TEST(Roots, InARectangle) {
  const outcome text =
      run({"roots", "exp(z)-z", "--variable", "z", "--rectangle", "-5-5i..5+5i", "--digits", "15"});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_EQ(text.out,
            "0.318131505204764... - 1.33723570143068...i  unique\n"
            "0.318131505204764... + 1.33723570143068...i  unique\n"
            "certified: 2 roots, counted with multiplicities, and no others in -5-5i..5+5i\n");
  const outcome as_json =
      run({"roots", "x^2+2*i", "--rectangle", "-2-2i..2+2i", "--format", "json"});
  const json printed = json::parse(as_json.out);
  EXPECT_EQ(printed.at("complete"), true);
  EXPECT_EQ(printed.at("in"), "-2-2i..2+2i");
  EXPECT_EQ(printed.at("roots").size(), 2U);
  EXPECT_EQ(printed.at("roots")[0].at("inside"), true);
  const outcome poles =
      run({"roots", "1/(1+z^2)-z", "--variable", "z", "--rectangle", "-2-2i..2+2i"});
  EXPECT_EQ(poles.status, 0);
  EXPECT_NE(poles.out.find("certified: 3 roots"), std::string::npos) << poles.out;
  const outcome triple =
      run({"roots", "tan(z)-z", "--variable", "z", "--rectangle", "-2-2i..2+2i"});
  EXPECT_EQ(triple.out.rfind("0  multiple 3\n", 0), 0U) << triple.out;
  const outcome cut =
      run({"roots", "log(z)-i*pi", "--variable", "z", "--rectangle", "-2-2i..2+2i"});
  EXPECT_EQ(cut.status, 1);
  EXPECT_NE(cut.out.find("undecided: the branch cut of log near"), std::string::npos) << cut.out;
  const outcome removed =
      run({"roots", "(z-i)^2/(z-i)", "--variable", "z", "--rectangle", "-2-2i..2+2i"});
  EXPECT_NE(removed.out.find("undecided: 0/0 near"), std::string::npos) << removed.out;
  for (const auto& [command, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"roots", "x-1", "--rectangle", "0"}, "such as -5-10i..5+10i"},
           {{"roots", "x-1", "--rectangle", "0..sqrt(2)+i"}, "with rational parts"},
           {{"roots", "x-1", "--rectangle", "1+i..-1-i"}, "to the left of the second, and below"},
           {{"roots", "x-1", "--rectangle", "0..1"}, "to the left of the second, and below"},
           {{"roots", "abs(x)-1", "--rectangle", "0..1+i"}, "abs is not analytic"},
           {{"roots", "x-x", "--rectangle", "0..1+i"}, "0 everywhere"},
           {{"roots", "i-1", "--variable", "i", "--rectangle", "0..1+i"}, "the imaginary unit"},
           {{"roots", "x-1", "--rectangle", "0..1+i", "--complex"}, "leave --complex"},
           {{"roots", "x-1", "0", "1", "--rectangle", "0..1+i"}, "the interval out"}}) {
    const outcome result = run(command);
    EXPECT_EQ(result.status, 2) << result.out;
    EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
  }
}

TEST(Roots, ComplexRootsAreRefusedWhereTheyHaveNoMeaning) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"roots", "sin(x)", "--complex"},
        {"roots", "x-x", "--complex"},
        {"roots", "x^2+1", "--complex", "--in", "0..1"},
        {"roots", "x^2+1", "--complex", "--in", "0..1", "--verify"},
        {"roots", "sqrt(2)*x+1", "--complex"}}) {
    const outcome result = run(arguments);
    EXPECT_EQ(result.status, 2) << arguments[1];
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("--complex"), std::string::npos) << result.err;
  }
  EXPECT_EQ(run({"roots", "7", "--complex"}).status, 0);
}

TEST(Roots, OfASystem) {
  const outcome result =
      run({"roots", "x^2+y^2-1", "x-y^3", "--in", "x=-2..2", "--in", "y=-2..2", "--digits", "15"});
  EXPECT_EQ(result.status, 0) << result.err << result.out;
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 3U) << result.out;
  EXPECT_EQ(lines[0], "x = -0.563624162161258..., y = -0.826031357654186...  unique");
  EXPECT_EQ(lines[1], "x = 0.563624162161258..., y = 0.826031357654186...  unique");
  EXPECT_EQ(lines[2].rfind("certified: 2 roots, all there are", 0), 0U);
  const json answer = json::parse(run({"roots", "a+b-3", "a*b-1", "b-c", "--in", "a=0..3/2", "--in",
                                       "b=0..5", "--in", "c=-9..9", "--format", "json"})
                                      .out);
  ASSERT_EQ(answer.at("roots").size(), 1U);
  EXPECT_EQ(answer.at("variables"), json({"a", "b", "c"}));
  expect_enclosure(answer.at("roots")[0].at("numbers").at("b"), 50);
  const outcome none = run({"roots", "x^2+y^2+1", "x-y", "--in", "x=-2..2", "--in", "y=-2..2"});
  EXPECT_EQ(none.status, 0);
  EXPECT_EQ(none.out.rfind("certified: no root", 0), 0U) << none.out;
  // Sides without an end, and formulas that are not defined in a part of the box.
  const outcome anywhere = run({"roots", "exp(x)=y", "x^2+y^2=4", "--in", "x=-inf..inf", "--in",
                                "y=-inf..inf", "--digits", "10"});
  EXPECT_EQ(anywhere.status, 0) << anywhere.out;
  EXPECT_EQ(lines_of(anywhere.out).size(), 3U) << anywhere.out;
  const outcome polynomials =
      run({"roots", "x^2=y", "y^2=x", "--in", "x=-inf..inf", "--in", "y=-inf..inf"});
  EXPECT_EQ(polynomials.status, 0);
  EXPECT_EQ(polynomials.out.rfind("x = 0, y = 0  unique\nx = 1, y = 1  unique\ncertified: 2", 0),
            0U)
      << polynomials.out;
  const outcome far =
      run({"roots", "pi*x^2=y^3+y", "y^2=x+x^3", "--in", "x=-inf..inf", "--in", "y=-inf..inf"});
  EXPECT_EQ(far.status, 1);
  EXPECT_NE(far.out.find("to inf, y = from -inf to inf  unresolved"), std::string::npos) << far.out;
  const outcome half = run({"roots", "sqrt(x)-1", "log(y)", "--in", "x=-3..3", "--in", "y=-3..3"});
  EXPECT_EQ(half.out.rfind("x = 1, y = 1  unique", 0), 0U) << half.out;
  // On a face, which is decided where the root is known exactly.
  const outcome face = run({"roots", "x*y-1", "x-y", "--in", "x=1..2", "--in", "y=1..2"});
  EXPECT_EQ(face.status, 0) << face.out;
  // A curve of roots is left open.
  const outcome curve =
      run({"roots", "x-y", "2*x-2*y", "--in", "x=-2..2", "--in", "y=-2..2", "--time-limit", "1s"});
  EXPECT_EQ(curve.status, 1);
}

TEST(Roots, OfASystemAreCheckedAgain) {
  const scratch_directory directory;
  const std::string file = directory.path("system.json");
  const outcome result = run({"roots", "x^2+y^2-1", "x-y^3", "--in", "x=-2..2", "--in", "y=-2..2",
                              "--digits", "15", "--verify", "--certificate", file});
  EXPECT_EQ(result.status, 0) << result.err << result.out;
  EXPECT_NE(result.out.find("second opinion: the same by the independent checker"),
            std::string::npos)
      << result.out;
  EXPECT_EQ(run({"check", file}).status, 0);
  // What no certificate holds is certified, but not confirmed.
  const outcome multiple =
      run({"roots", "x^2", "y", "--in", "x=-1..1", "--in", "y=-1..1", "--verify"});
  EXPECT_EQ(multiple.status, 1);
  EXPECT_NE(multiple.out.find("there is a multiple root"), std::string::npos) << multiple.out;
}

TEST(Roots, OfASystemThatIsGivenWrongly) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"roots", "x+y", "--in", "x=0..1", "--in", "y=0..1"},
        {"roots", "x+y", "x-y", "--in", "x=0..1"},
        {"roots", "x+y", "x-y", "--in", "x=0..1", "--in", "0..1"},
        {"roots", "x+y", "x-y", "--in", "x=0..1", "--in", "x=0..1"},
        {"roots", "x+y", "x-y", "--in", "x=0..1", "--in", "y=inf..0"},
        {"roots", "x+y", "x-y", "--in", "x=0..-inf", "--in", "y=0..1"},
        {"roots", "x+y", "x-y", "--in", "x=0..1", "--in", "y=0..sqrt(2)"},
        {"roots", "x+y", "x-z", "--in", "x=0..1", "--in", "y=0..1"},
        {"roots", "x+y", "x-y", "--in", "x=0..1", "--in", "y=1..0"},
        {"roots", "x", "0", "1", "x^2"},
        {"roots", "x+y", "x-y", "--in", "x=0..1", "--in", "y=0..inf", "--certificate", "no.json"},
        {"roots", "x+y", "abs(y)", "--in", "x=0..1", "--in", "y=0..1", "--certificate", "no.json"},
        {"roots", "x+y", "x-y", "--in", "x=0..1", "--in", "y=0..1", "--certificate", "no.json"},
        {"roots", "x+y", "x-y", "--in", "x=0..1", "--in", "y=0..1", "--threads", "2"},
        {"roots", "x+y", "x-y", "--in", "x=0..1", "--in", "y=0..1", "--variable", "y"},
        {"roots", "x+y", "x-y", "--in", "x=0..1", "--in", "y=0..1", "--digits", "99999999999"},
        {"roots", "x^2+x+1", "--complex", "--digits", "99999999999"},
        {"roots", "x^2+x+1", "--complex", "--threads", "2"},
        {"roots", "x^2+x+1", "--complex", "--verify"},
        {"roots", "x", "--in", "0..1", "--in", "0..2"}}) {
    const outcome result = run(arguments);
    EXPECT_EQ(result.status, 2) << arguments[1];
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
  }
}

TEST(Roots, JsonHasTheEnclosuresAndTheVerdict) {
  const outcome result = roots("tan(x)*(x-4)^2", "2..5", {"--format", "json", "--digits", "25"});
  EXPECT_EQ(result.status, 0);
  const json answer = json::parse(result.out);
  EXPECT_EQ(answer.at("verdict"), "certified");
  EXPECT_EQ(answer.at("in"), "2..5");
  ASSERT_EQ(answer.at("roots").size(), 2U);
  EXPECT_EQ(answer.at("roots")[0].at("verdict"), "unique");
  expect_enclosure(answer.at("roots")[0].at("number"), 25);
  EXPECT_EQ(answer.at("roots")[1].at("multiplicity"), 2);
  EXPECT_EQ(answer.at("roots")[1].at("number").at("rational"), "4");
  ASSERT_EQ(answer.at("singular").size(), 1U);
  EXPECT_EQ(answer.at("singular")[0].at("pole_order"), 1);
  EXPECT_GT(answer.at("account").at("evaluations"), 3);
  const outcome periodic = roots("sin(x)", "0..inf", {"--format", "json"});
  EXPECT_EQ(json::parse(periodic.out).at("of_period").at("period"), "2*pi");
  EXPECT_EQ(json::parse(periodic.out).at("of_period").at("in"), "0..2*pi");
  const outcome open = roots("x^2-2*x*cos(x)+cos(x)^2", "0..1", {"--format", "json"});
  EXPECT_EQ(open.status, 1);
  const json left = json::parse(open.out);
  EXPECT_EQ(left.at("verdict"), "not certified");
  EXPECT_EQ(left.at("roots")[0].at("complex_roots"), 2);
}

}  // namespace roots_test
}  // namespace polhode::test
