// polhode constants: its formats, and that every digit is a digit of the true expansion.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "enclosure.hpp"
#include "program.hpp"
#include "proofs/claim.hpp"

namespace polhode::test {
namespace constants_test {

/// Leading digits known from elsewhere.
struct known_constant {
  std::string name;
  std::string digits;
};
const std::vector<known_constant>& known_constants() {
  static const std::vector<known_constant> known{
      {"epsilon0_min", "0.0863740970495642522702"},
      {"delta_psi_max", "2.968844459490664733"},
      {"beta", "0.0289732280378394600896939267034134383359332858"}};
  return known;
}

/// The decimals of "name = decimals...", without the dots.
std::string decimals_of(const std::string& name, const std::string& digits) {
  const outcome result = run({"constants", name, "--digits", digits});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  const std::string begin = name + " = ";
  const std::string end = "...\n";
  EXPECT_EQ(result.out.rfind(begin, 0), 0U);
  EXPECT_EQ(result.out.substr(result.out.size() - end.size()), end);
  return result.out.substr(begin.size(), result.out.size() - begin.size() - end.size());
}

std::size_t significant_digits(const std::string& decimal) {
  const auto first = decimal.find_first_of("123456789");
  const auto point = decimal.find('.');
  return decimal.size() - first - (point != std::string::npos && point > first ? 1 : 0);
}

TEST(Constants, KnownDigits) {
  for (const auto& [name, digits] : known_constants()) {
    EXPECT_EQ(decimals_of(name, "50").rfind(digits, 0), 0U) << name;
  }
}

TEST(Constants, FewerDigitsAreTheBeginningOfMore) {
  for (const auto& c : proofs::all_constants()) {
    const std::string long_one = decimals_of(c.name, "1100");
    EXPECT_EQ(significant_digits(long_one), 1100U);
    for (const std::string count : {"1", "2", "7", "50", "99", "1000"}) {
      const std::string shorter = decimals_of(c.name, count);
      EXPECT_EQ(long_one.rfind(shorter, 0), 0U) << c.name << " to " << count;
      EXPECT_EQ(std::to_string(significant_digits(shorter)), count);
    }
  }
}

TEST(Constants, TextIsOneLineEach) {
  const outcome result = run({"constants", "--digits", "3000"});
  EXPECT_EQ(lines_of(result.out).size(), proofs::all_constants().size());
  const outcome two = run({"constants", "beta", "delta_psi_max", "beta", "--digits", "3"});
  EXPECT_EQ(two.out, "beta = 0.0289...\ndelta_psi_max = 2.96...\n");
}

TEST(Constants, JsonHasConsistentEnclosures) {
  const outcome result = run({"constants", "--format", "json", "--digits", "200"});
  const json constants = json::parse(result.out);
  EXPECT_EQ(constants.at("format"), "polhode constants");
  EXPECT_EQ(constants.at("version"), 2);
  EXPECT_EQ(constants.size(), proofs::all_constants().size() + 2);
  for (const auto& [name, number] : constants.items()) {
    if (!number.is_object()) continue;
    expect_enclosure(number, 200);
    EXPECT_EQ(number.at("value"), decimals_of(name, "200"));
  }
}

TEST(Constants, CsvHasOneRowEach) {
  const auto lines = lines_of(run({"constants", "--format", "csv", "--digits", "40"}).out);
  ASSERT_EQ(lines.size(), proofs::all_constants().size() + 1);
  EXPECT_EQ(lines.front(), "name,value,radius,lower,upper,digits");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::vector<std::string> cells{""};
    for (const char c : lines[i]) {
      if (c == ',') {
        cells.emplace_back();
      } else {
        cells.back() += c;
      }
    }
    ASSERT_EQ(cells.size(), 6U);
    EXPECT_EQ(cells[0], proofs::all_constants()[i - 1].name);
    expect_enclosure(
        json{{"value", cells[1]}, {"lower", cells[3]}, {"upper", cells[4]}, {"digits", 40}}, 40);
    EXPECT_EQ(cells[5], "40");
  }
}

/// A program that the header must let compile.
constexpr const char* user_of_header = R"(#include "constants.hpp"
namespace c = polhode_constants;
constexpr bool near(long double x, long double y) { return x - y < 1e-17L && y - x < 1e-17L; }
static_assert(near(c::beta, 0.0289732280378394600896939267034134383359332858L));
static_assert(c::beta == 0.0289732280378394600896939267034134383359332858);
static_assert(c::beta_long_double == 0.0289732280378394600896939267034134383359332858L);
static_assert(near(c::epsilon0_min_long_double, 0.0863740970495642522702L));
static_assert(c::epsilon0_min == 0.0863740970495642522702);
static_assert(c::delta_psi_max_decimal == EXPECTED);
int main() {}
)";

TEST(Constants, TheCppHeaderCompiles) {
  if (run_script("command -v c++ > /dev/null").status != 0) GTEST_SKIP() << "there is no c++";
  const scratch_directory scratch;
  for (const auto& [digits, expected] :
       {std::pair{"3", "2.96"}, std::pair{"20", "2.9688444594906647339"}}) {
    const outcome result = run({"constants", "--format", "cpp", "--digits", digits});
    EXPECT_EQ(result.status, 0);
    std::ofstream(scratch.path("constants.hpp")) << result.out;
    std::ofstream(scratch.path("user.cpp")) << user_of_header;
    const outcome compiled = run_script(
        "c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror "
        "-fsyntax-only -DEXPECTED='\"" +
            std::string(expected) + "\"' user.cpp",
        scratch.path());
    EXPECT_EQ(compiled.status, 0) << compiled.err << result.out;
  }
}

TEST(Constants, PrintingDoesNotDependOnTheLocale) {
  const outcome other = run_script(
      "LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8 exec polhode constants --digits 2000 --format "
      "json");
  EXPECT_EQ(other.out, run({"constants", "--digits", "2000", "--format", "json"}).out);
}

}  // namespace constants_test
}  // namespace polhode::test
