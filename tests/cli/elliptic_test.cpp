// The elliptic functions in formulas: values, refusals that name the condition, and the page that lists them.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "program.hpp"

namespace polhode::test {
namespace {

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
  while (std::getline(list, line) && line != "constants") {
    const std::string call = line.substr(2, line.find(')') - 1);
    EXPECT_NE(page.find('`' + call + '`'), std::string::npos) << call;
    ++functions;
  }
  EXPECT_EQ(functions, 48);
}

}  // namespace
}  // namespace polhode::test
