#include "formula.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "errors.hpp"
#include "layout.hpp"
#include "polhode/expression/functions.hpp"

namespace polhode::cli {

void let_option::declare(CLI::App& app) {
  app.add_option("--let", texts,
                 "Give a name a value, as in k=sqrt(2)/3; may be repeated, and\n"
                 "use the names before it")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

std::vector<std::pair<std::string, std::string>> let_option::value() const {
  std::vector<std::pair<std::string, std::string>> result;
  for (const std::string& text : texts) {
    const auto mark = text.find('=');
    if (mark == std::string::npos || mark == 0) {
      throw usage_error(
          fmt::format("--let {}: it must be NAME=VALUE, such as k=1/3", in_quotes(text)));
    }
    result.emplace_back(text.substr(0, mark), text.substr(mark + 1));
  }
  return result;
}

expression read_formula(const std::string& given, const std::vector<std::string>& variables,
                        const let_option& let) {
  const std::string text = given.substr(std::min(given.find_first_not_of(' '), given.size()));
  try {
    return expression(text, {variables, let.value()});
  } catch (const input_error& error) {
    throw usage_error(fmt::format("{}: {}", in_quotes(text), error.what()));
  }
}

std::string table_of_functions() {
  std::string result = "functions\n";
  for (const expression_function& f : expression_functions()) {
    result += fmt::format("  {:<14}{:<42}{}\n", f.name + '(' + f.arguments + ')', f.description,
                          f.domain);
  }
  result += "constants\n";
  for (const expression_constant& c : expression_constants()) {
    result += fmt::format("  {:<14}{}\n", c.name, c.description);
  }
  return result;
}

std::string names_of_functions() {
  std::string names;
  for (const expression_function& f : expression_functions()) names += f.name + ' ';
  names += "and the constants";
  for (const expression_constant& c : expression_constants()) names += ' ' + c.name;
  std::string result;
  for (const std::string& line : wrapped(names, terminal_columns - 2)) {
    result += "  " + line + '\n';
  }
  return result;
}

}  // namespace polhode::cli
