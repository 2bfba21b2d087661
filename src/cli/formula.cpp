#include "formula.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "elliptic_functions.hpp"
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

namespace {

bool is_interval(const std::pair<std::string, std::string>& definition) {
  const std::size_t start = definition.second.find_first_not_of(' ');
  return start != std::string::npos && definition.second[start] == '[';
}

let_option those(const let_option& all, bool intervals) {
  let_option result;
  for (const auto& definition : all.value()) {
    if (is_interval(definition) == intervals) {
      result.texts.push_back(definition.first + '=' + definition.second);
    }
  }
  return result;
}

}  // namespace

let_option let_option::intervals() const { return those(*this, true); }
let_option let_option::numbers() const { return those(*this, false); }

std::vector<std::string> parts_between_commas(const std::string& text) {
  std::vector<std::string> result(1);
  int depth = 0;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c == ',' && depth == 0) {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

expression read_formula(const std::string& given, const std::vector<std::string>& variables,
                        const let_option& let) {
  const std::string text = given.substr(std::min(given.find_first_not_of(' '), given.size()));
  try {
    return expression(text, {variables, let.value(), elliptic_functions()});
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
  result += "elliptic integrals and functions, of the parameter m = k^2 (docs/elliptic.md)\n";
  for (const further_function& f : *elliptic_functions()) {
    result += fmt::format("  {:<25}{:<31} {}\n", f.what.name + '(' + f.what.arguments + ')',
                          f.what.description, f.what.domain);
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
  std::string last;
  for (const further_function& f : *elliptic_functions()) {
    if (f.what.name != last) names += f.what.name + ' ';
    last = f.what.name;
  }
  names += "and the constants";
  for (const expression_constant& c : expression_constants()) names += ' ' + c.name;
  std::string result;
  for (const std::string& line : wrapped(names, terminal_columns - 2)) {
    result += "  " + line + '\n';
  }
  return result;
}

}  // namespace polhode::cli
