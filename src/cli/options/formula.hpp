#pragma once

// Formulas given on the command line, with the names that --let defines.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/cli_app.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode::cli {

/// --let NAME=VALUE, as often as wanted; a value is a formula in numbers, constants and other names
/// defined so.
struct let_option {
  std::vector<std::string> texts;

  void declare(CLI::App& app);
  /// Names with their values, each behind those that its value has. Throws usage_error for what is
  /// not NAME=VALUE, for a name that cannot be one, or is given twice, and for values that need
  /// each other.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> value() const;
  /// Those whose value is an interval, "a=[1, 1.1]"; the others.
  [[nodiscard]] let_option intervals() const;
  [[nodiscard]] let_option numbers() const;
};

[[nodiscard]] std::string without_margins(const std::string& text);

/// Throws usage_error where the text cannot be the name of a variable, or is the name of a function
/// or a constant.
void check_variable(const std::string& name);

/// The name given with --variable, or the one that the formula has (variable_of). Throws
/// usage_error as check_variable does.
[[nodiscard]] std::string variable_or_only_name(const std::optional<std::string>& given,
                                                const std::string& formula, const let_option& let);

/// The texts between the commas that are in no parentheses.
[[nodiscard]] std::vector<std::string> parts_between_commas(const std::string& text);

/// The formula; throws usage_error, with the text in quotes, for what cannot be read.
[[nodiscard]] expression read_formula(const std::string& given,
                                      const std::vector<std::string>& variables,
                                      const let_option& let);

/// The same; of an equation "f = g" the formula f - g.
[[nodiscard]] expression read_equation(const std::string& given,
                                       const std::vector<std::string>& variables,
                                       const let_option& let);

/// The functions and constants of formulas, as a table and as a list of names in lines.
[[nodiscard]] std::string table_of_functions();
[[nodiscard]] std::string names_of_functions();

}  // namespace polhode::cli
