// The elliptic functions in formulas: values, refusals that name the condition, and the page that
// lists them.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "program.hpp"

namespace polhode::test {
namespace elliptic_test {

std::string value(const std::string& formula) {
  const outcome result = run({"eval", "--digits", "12", "--", formula});
  EXPECT_EQ(result.status, 0) << formula << ": " << result.err;
  return result.out;
}

TEST(Elliptic, HasKnownValues) {
  EXPECT_EQ(value("ellipticK(1/2)"), "1.85407467730...\n");
  EXPECT_EQ(value("ellipticE(1/2)"), "1.35064388104...\n");
  EXPECT_EQ(value("ellipticE(1, 1/4)"), "0.964876454268...\n");
  EXPECT_EQ(value("ellipticF(10, 3/4)"), "13.5392090006...\n");
  EXPECT_EQ(value("ellipticPi(-3, 1.25, 0.5)"), "0.761500459350...\n");
  EXPECT_EQ(value("carlsonRJ(2, 3, 4, 5)"), "0.142975796671...\n");
  EXPECT_EQ(value("carlsonRJ(2, 3, 4, -5)"), "-0.127112300429...\n");
  EXPECT_EQ(value("jacobiSN(1/2, 1/4)"), "0.475082936028...\n");
  EXPECT_EQ(value("jacobiTheta1(3/4, 0.01953125)"), "0.509421926233...\n");
  EXPECT_EQ(value("ellipticK(1 - 1e-300)"), "346.774058310...\n");
}

TEST(Elliptic, KnowsValuesThatAreExact) {
  const auto exactly = [](const std::string& formula, const std::string& expected) {
    EXPECT_EQ(value(formula).substr(0, expected.size() + 8), expected + " exactly") << formula;
  };
  exactly("ellipticE(pi/2, 1)", "1");
  exactly("ellipticE(-7*pi/2, 1)", "-7");
  exactly("ellipticE(1)", "1");
  exactly("ellipticF(1/3, 0)", "1/3");
  exactly("ellipticPi(2, 0)", "0");
  exactly("jacobiTheta1(0, 1/2)", "0");
  exactly("jacobiTheta1(-3*pi, 1/2)", "0");
  exactly("jacobiTheta2(pi/2, 1/2)", "0");
  exactly("jacobiTheta2Prime(pi, 1/2)", "0");
  exactly("jacobiTheta1Prime(pi/2, 1/2)", "0");
  exactly("jacobiTheta4Prime(pi/2, 1/2)", "0");
  exactly("jacobiAM(-2/7, 0)", "-2/7");
  exactly("jacobiSN(5*pi/2, 0)", "1");
  exactly("jacobiCN(3*pi, 0)", "-1");
  exactly("jacobiSC(pi, 0)", "0");
  exactly("jacobiArcCN(1, 1/2)", "0");
  exactly("carlsonRF(1/9, 1/9, 1/9)", "3");
  exactly("carlsonRJ(4, 4, 4, 4)", "1/8");
  exactly("carlsonRG(0, 9, 0)", "3/2");
  exactly("carlsonRC(0, -2)", "0");
  EXPECT_EQ(value("bulirschCel(1, 4, 1, -2)"), "0 exactly\n");
  // Nearly those arguments: other values.
  EXPECT_EQ(value("jacobiTheta1(pi, 1/2) + jacobiTheta2(0, 1/2)"), value("jacobiTheta2(0, 1/2)"));
  EXPECT_EQ(value("jacobiTheta2(pi, 1/2)"), "-" + value("jacobiTheta2(0, 1/2)"));
  EXPECT_EQ(value("jacobiTheta1(pi/2, 1/2)"), value("jacobiTheta2(0, 1/2)"));
  EXPECT_EQ(value("ellipticE(pi/2, 1/2)"), value("ellipticE(1/2)"));
  EXPECT_EQ(value("ellipticPi(-3, 0)"), value("pi/4"));
  EXPECT_EQ(value("bulirschCel(1, 4, 1, 3)"), value("5*pi/12"));
  EXPECT_EQ(value("jacobiArcSD(-5/3, 16/25)"), "-" + value("ellipticK(16/25)"));
  EXPECT_EQ(value("jacobiArcDN(3/5, 16/25)"), value("ellipticK(16/25)"));
  EXPECT_EQ(value("jacobiSC(1, 0)"), value("tan(1)"));
}

TEST(Elliptic, AgreesAtTheParameterOneWithItsNeighbours) {
  for (const char* letters :
       {"AM", "SN", "CN", "DN", "NS", "NC", "ND", "SC", "SD", "CS", "CD", "DS", "DC"}) {
    const std::string name = std::string("jacobi") + letters;
    const std::string gap = name + "(7/10, 1) - " + name + "(7/10, 1 - 1e-40)";
    EXPECT_EQ(value("floor(abs(" + gap + ")*1e39)"), "0 exactly\n") << name;
  }
  EXPECT_EQ(value("jacobiAM(-2, 1)"), value("-asin(tanh(2))"));
  EXPECT_EQ(value("carlsonRC(3, -1)"), value("atanh(sqrt(3/4))/2"));
}

// Real functions that are not continued around the whole of the range: said at once, and not after
// many small steps.
TEST(Elliptic, SaysSoonWhereItIsNotContinued) {
  for (const auto& [formula, to] : std::vector<std::pair<std::string, std::string>>{
           {"ellipticE(x, 1)", "3"}, {"ellipticF(x, 6/5)", "1.15"}, {"jacobiAM(x, -1)", "1"}}) {
    const outcome result = run({"integrate", formula, "--from", "0", "--to", to, "--digits", "10"});
    EXPECT_EQ(result.status, 1) << result.out;
    EXPECT_NE(result.out.find("not analytic"), std::string::npos) << result.out;
  }
  EXPECT_EQ(
      run({"integrate", "carlsonRC(x, -1)", "--from", "1", "--to", "2", "--digits", "10"}).status,
      0);
}

// What a simpler value leaves out has to be defined, and in the domain.
TEST(Elliptic, SaysNothingExactOfWhatIsNotDefined) {
  for (const char* formula :
       {"jacobiTheta1(0, sqrt(2))", "jacobiTheta3Prime(0, pi)", "ellipticF(0, log(1-exp(1)))",
        "jacobiCN(0, log(1-exp(1)))", "jacobiArcSN(0, sqrt(2))", "jacobiAM(0, exp(2))",
        "bulirschCel(sin(1)-sin(1), 1, 0, 0)", "ellipticPi(sqrt(2), 0, exp(2))"}) {
    EXPECT_EQ(run({"eval", "--digits", "12", "--", formula}).out.find("exactly"), std::string::npos)
        << formula;
  }
}

// On this path the forms of F left and right of Re x = 1.1 are two branches; and arccd's is that of
// -x.
TEST(Elliptic, IsNotTakenFromAnotherBranch) {
  for (const auto& [formula, path] : std::vector<std::pair<std::string, std::string>>{
           {"ellipticF(x, 2-3/10*i)", "1+3/10*i, 12/10+3/10*i"},
           {"jacobiArcCD(x, 637/1000+436/1000*i)", "587/1000-1639/1000*i, 687/1000-1639/1000*i"}}) {
    const outcome result = run({"integrate", formula, "--along", path, "--digits", "10"});
    EXPECT_EQ(result.status, 1) << result.out;
    EXPECT_EQ(result.out.rfind("undefined", 0), 0U) << result.out;
  }
}

TEST(Elliptic, AnswersFarArguments) {
  EXPECT_EQ(value("carlsonRJ(1, 2, 3, 1e100000)"), "2.18083780640...e-100000\n");
  EXPECT_EQ(value("carlsonRF(1e-100000, 1, 1e100000)"), "1.15130640944...e-49995\n");
  EXPECT_EQ(value("jacobiSN(1, 1e30)"), "8.58272793170...e-16\n");
  EXPECT_EQ(value("jacobiSN(1, -1e1000)"), "-1.49587478792...e-490\n");
  EXPECT_EQ(value("jacobiTheta3(1e1000, 1/2)"), "1.02494916924...\n");
  EXPECT_EQ(value("ellipticK(1 - 1e-10000)"), "11514.3117593...\n");
}

TEST(Elliptic, NamesTheConditionThatIsNotProved) {
  const outcome result = run({"eval", "ellipticE(asin(1/sqrt(2)), 2) + 1"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.out.find("ellipticE(phi, m) is not defined, or is not proved to be, where it is "
                            "taken; it needs m sin^2 <= 1 up to phi"),
            std::string::npos)
      << result.out;
  const outcome plain = run({"eval", "1 + log(-pi)"});
  EXPECT_NE(plain.out.find("log(x) is not defined, or is not proved to be"), std::string::npos)
      << plain.out;
}

TEST(Elliptic, RefusesWhatIsNotDefinedAndSaysWhatIsNeeded) {
  const auto expect_refused = [](const std::string& formula, const std::string& word) {
    const outcome result = run({"eval", "--", formula});
    EXPECT_EQ(result.status, 2) << formula;
    EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
  };
  expect_refused("carlsonRJ(1, 2, 3, 0)", "it needs x, y, z >= 0, at most one 0, p != 0");
  expect_refused("carlsonRF(0, 0, 1)", "at most one 0");
  expect_refused("carlsonRD(1, 2, 0)", "z > 0");
  expect_refused("carlsonRC(1, 0)", "y != 0");
  expect_refused("ellipticK(2)", "it needs m < 1");
  expect_refused("ellipticPi(1, 1/2)", "n != 1");
  expect_refused("ellipticNome(-1)", "0 <= m <= 1");
  expect_refused("jacobiTheta3(0, 1)", "0 <= q < 1");
  expect_refused("ellipticF(pi/2, 1)",
                 "ellipticF(1/2*pi, 1) is not defined: it needs m sin^2 <= 1 up to phi; m=1: "
                 "|phi| < pi/2");
  expect_refused("ellipticF(pi/2 + 1e-1000, 1)", "m=1: |phi| < pi/2");
  expect_refused("ellipticE(1, 2)", "m sin^2 <= 1");
  expect_refused("ellipticE(3*pi/4, 3/2)", "m sin^2 <= 1");
  expect_refused("ellipticPi(1, -pi/2, 1/2)", "n sin(phi)^2 != 1");
  expect_refused("jacobiNS(0, pi)", "sn != 0");
  expect_refused("jacobiDC(pi/2, 0)", "cn != 0");
  expect_refused("jacobiAM(1, 2)", "m <= 1");
  expect_refused("jacobiArcSN(1, 1)", "|x| < 1 if m = 1");
  expect_refused("jacobiArcCN(0, 1)", "x > 0 if m = 1");
  expect_refused("jacobiArcDN(0.7, 1/2)", "sqrt(1-m) <= x <= 1");
  expect_refused("jacobiArcDN(1, 0)", "0 < m");
  expect_refused("jacobiArcND(2, 0.7)", "x <= 1/sqrt(1-m)");
  expect_refused("jacobiArcSD(-2, 0.7)", "|x| <= 1/sqrt(1-m)");
  expect_refused("jacobiArcDS(0, 1)", "x > 0");
  expect_refused("jacobiArcCD(1, 1)", "m < 1");
  expect_refused("ellipticPi(1/2)", "ellipticPi(n, m) or ellipticPi(n, phi, m)");
  expect_refused("ellipticK", "write ellipticK(m)");
  expect_refused("elipticK(1/2)", "the nearest is ellipticK");
  const outcome named = run({"eval", "ellipticK", "--let", "ellipticK=1"});
  EXPECT_EQ(named.status, 2);
  // Not certainly undefined as it stands, but undefined on evaluation.
  EXPECT_EQ(run({"eval", "ellipticK(pi)", "--digits", "5"}).status, 1);
}

TEST(Elliptic, IsListedWithItsDomainsInTheManual) {
  const auto root = std::filesystem::path(POLHODE_SCENES_DIR).parent_path();
  std::ifstream file(root / "docs" / "elliptic.md");
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::istringstream list(run({"eval", "--functions"}).out);
  std::string line;
  while (std::getline(list, line) && line.rfind("elliptic", 0) != 0) {
  }
  int functions = 0;
  while (std::getline(list, line) && line.starts_with("  ")) {
    const std::string call = line.substr(2, line.find(')') - 1);
    EXPECT_NE(page.find('`' + call + '`'), std::string::npos) << call;
    ++functions;
  }
  EXPECT_EQ(functions, 48);
}

}  // namespace elliptic_test
}  // namespace polhode::test
