#include "formula.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/output/errors.hpp"
#include "cli/output/layout.hpp"
#include "polhode/expression/functions.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"

namespace polhode::cli {

void let_option::declare(CLI::App& app) {
  add_option(app, "--let", texts,
             "Give a name a value, as in k=sqrt(2)/3; may be repeated, and\n"
             "use other names defined so")
      .type_name("NAME=VALUE")
      .one_value_each_time();
}

std::string without_margins(const std::string& text) {
  constexpr const char* blanks = " \t\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

namespace {

using definition = formula_definition;

/// Throws input_error where the text can be no name of a variable.
void expect_name(const std::string& name) { (void)parse("0", {name}); }

}  // namespace

void check_variable(const std::string& name) {
  try {
    expect_name(name);
  } catch (const input_error& error) {
    throw usage_error(fmt::format("--variable: {}", error.what()));
  }
}

std::string variable_or_only_name(const std::optional<std::string>& given,
                                  const std::string& formula, const let_option& let) {
  if (!given) return variable_of(formula, let.value());
  check_variable(*given);
  return *given;
}

std::vector<std::pair<std::string, std::string>> let_option::value() const {
  std::vector<definition> result;
  for (const std::string& text : texts) {
    const auto mark = text.find('=');
    if (mark == std::string::npos || without_margins(text.substr(0, mark)).empty()) {
      throw usage_error(
          fmt::format("--let {}: it must be NAME=VALUE, such as k=1/3", in_quotes(text)));
    }
    result.emplace_back(without_margins(text.substr(0, mark)),
                        without_margins(text.substr(mark + 1)));
    try {
      expect_name(result.back().first);
    } catch (const input_error& error) {
      throw usage_error(fmt::format("--let {}: {}", in_quotes(text), error.what()));
    }
    const bool again = std::any_of(result.begin(), result.end() - 1, [&](const definition& d) {
      return d.first == result.back().first;
    });
    if (again) {
      throw usage_error(fmt::format("--let {}: the name {} is given twice", in_quotes(text),
                                    in_quotes(result.back().first)));
    }
  }
  try {
    return in_order_of_need(std::move(result));
  } catch (const input_error& error) {
    throw usage_error(fmt::format("--let: {}", error.what()));
  }
}

namespace {

bool is_interval(const definition& one) { return one.second.starts_with('['); }

let_option those(const let_option& all, bool intervals) {
  let_option result;
  for (const definition& one : all.value()) {
    if (is_interval(one) == intervals) result.texts.push_back(one.first + '=' + one.second);
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

namespace {

expression read_by(decltype(parse)* reader, const std::string& given,
                   const std::vector<std::string>& variables, const let_option& let) {
  const std::vector<definition> definitions = let.value();
  const std::string text = given.substr(std::min(given.find_first_not_of(' '), given.size()));
  try {
    return reader(text, variables, definitions);
  } catch (const input_error& error) {
    throw usage_error(fmt::format("{}: {}", in_quotes(text), error.what()));
  }
}

}  // namespace

expression read_formula(const std::string& given, const std::vector<std::string>& variables,
                        const let_option& let) {
  return read_by(parse, given, variables, let);
}

expression read_equation(const std::string& given, const std::vector<std::string>& variables,
                         const let_option& let) {
  return read_by(parse_equation, given, variables, let);
}

std::string table_of_functions() {
  std::string result = "functions\n";
  for (const expression_function& f : expression_functions()) {
    result += fmt::format("  {:<18}{:<41} {}\n", f.name + '(' + f.arguments + ')', f.description,
                          f.domain);
  }
  const auto add = [&](const std::string& title, int width, const further_functions& functions) {
    if (functions.empty()) return;
    result += title + '\n';
    for (const further_function& f : functions) {
      result += fmt::format("  {:<23}{:<{}} {}\n", f.what.name + '(' + f.what.arguments + ')',
                            f.what.description, width, f.what.domain);
    }
  };
  add("elliptic integrals and functions, of the parameter m = k^2 (docs/elliptic.md)", 32,
      *elliptic_functions());
  add("special functions, by Arb", 38, *arb_functions());
  result += "constants\n";
  for (const expression_constant& c : expression_constants()) {
    result += fmt::format("  {:<14}{}\n", c.name, c.description);
  }
  result += "other names\n";
  for (const expression_alias& a : expression_aliases()) {
    result += fmt::format("  {:<14}the same as {}\n", a.name, a.meaning);
  }
  return result;
}

std::string names_of_functions() {
  std::string names;
  for (const expression_function& f : expression_functions()) names += f.name + ' ';
  std::string last;
  for (const further_function& f : *library_functions()) {
    if (f.what.name != last) names += f.what.name + ' ';
    last = f.what.name;
  }
  names += "and the constants";
  for (const expression_constant& c : expression_constants()) names += ' ' + c.name;
  names += "; other names of some of them are";
  for (const expression_alias& a : expression_aliases()) names += ' ' + a.name;
  std::string result;
  for (const std::string& line : wrapped(names, terminal_columns - 2)) {
    result += "  " + line + '\n';
  }
  return result;
}

}  // namespace polhode::cli
