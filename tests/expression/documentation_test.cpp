// docs/expressions.md has the tables of the functions and constants that there are.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "polhode/expression/expression.hpp"
#include "polhode/expression/functions.hpp"
#include "polhode/expression/library_functions.hpp"

namespace polhode {
namespace documentation_test {

/// As it may stand in a cell of a table: a bar is a letter there.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string documentation() {
  const auto root = std::filesystem::path(POLHODE_SCENES_DIR).parent_path();
  std::ifstream file(root / "docs" / "expressions.md");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(Documentation, HasTheTableOfFunctionsAndConstants) {
  std::string functions = "| function | what it is | defined for |\n|---|---|---|\n";
  for (const expression_function& f : expression_functions()) {
    functions += "| `" + f.name + "(" + f.arguments + ")` | " + cell(f.description) + " | " +
                 cell(f.domain) + " |\n";
  }
  std::string constants = "| constant | what it is |\n|---|---|\n";
  for (const expression_constant& c : expression_constants()) {
    constants += "| `" + c.name + "` | " + cell(c.description) + " |\n";
  }
  const std::string text = documentation();
  EXPECT_NE(text.find("## Functions"), std::string::npos);
  EXPECT_NE(text.find('\n' + functions + "\n## Constants\n\n" + constants), std::string::npos)
      << "docs/expressions.md should have\n"
      << functions << "\n## Constants\n\n"
      << constants;
  std::string aliases = "| name | what it means |\n|---|---|\n";
  for (const expression_alias& a : expression_aliases()) {
    aliases += "| `" + a.name + "` | `" + a.meaning + "` |\n";
  }
  EXPECT_NE(text.find("\n## Other names\n\n" + aliases), std::string::npos)
      << "docs/expressions.md should have\n"
      << aliases;
  for (const further_function& f : *arb_functions()) {
    const std::string row = "\n| `" + f.what.name + "(" + f.what.arguments + ")` | " +
                            cell(f.what.description) + " | " + cell(f.what.domain) + " |\n";
    EXPECT_NE(text.find(row), std::string::npos) << "docs/expressions.md should have" << row;
  }
}

TEST(Documentation, EveryFunctionCanBeCalledAsItsTableSays) {
  for (const expression_function& f : expression_functions()) {
    const bool whole = f.domain.find("whole number from") != std::string::npos ||
                       f.description.find("whole number from") != std::string::npos;
    const bool two = f.arguments.find(',') != std::string::npos;
    const std::string call = f.name + (f.arguments == "n"               ? "(3)"
                                       : f.arguments.starts_with("n, ") ? "(3, x)"
                                       : two ? (whole ? "(x, 3)" : "(x, 5/4)")
                                             : "(x)");
    const expression g(call, {{"x"}, {}});
    // 3/2 lies in every domain but those within [-1, 1].
    const bool bounded_domain = f.domain.starts_with("-1 <") || f.domain == "0 < x <= 1";
    const ball value = g(bounded_domain ? ball(1, 64) / 3 : ball(3, 64) / 2);
    EXPECT_TRUE(value.is_bounded()) << call;
  }
}

}  // namespace documentation_test
}  // namespace polhode
