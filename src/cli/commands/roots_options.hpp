#pragma once

// What polhode roots was asked for, and the kinds of searches that are not those of one function in
// an interval.

#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/options/certificate_option.hpp"
#include "cli/options/count_option.hpp"
#include "cli/options/formula.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/options.hpp"
#include "cli/options/range_option.hpp"
#include "cli/options/second_opinion.hpp"
#include "cli/options/time_limit.hpp"

namespace polhode::cli {

struct roots_options {
  std::string formula;
  std::vector<std::string> more_formulas;  // of a system, behind the places of the two limits
  range_option range;
  std::string interval;  // as LO..HI
  std::optional<std::string> given_variable;
  std::string variable;  // that of the formula
  let_option let;
  digits_option digits;
  count_option threads{"--threads", 1, 0, most_threads};
  format_option format{{"text", "csv", "json"}};
  memory_limit_option memory_limit;
  certificate_option certificate;
  verify_option verify;
  time_limit_option time_limit;
  bool complex = false;
  std::optional<std::string> rectangle;

  /// One --in NAME=LO..HI or more: the formulas are a system.
  [[nodiscard]] bool is_system() const;
};

/// Throws usage_error for --verify, --certificate and --threads, which only the search in an
/// interval takes; `kind` names what is looked for.
void refuse_options_of_interval(const roots_options& options, const std::string& kind);
/// Throws usage_error for --threads.
void refuse_threads(const roots_options& options, const std::string& kind);

/// Throws usage_error where so many numbers, to the digits asked for, need too much memory.
void check_memory(const roots_options& options, double numbers);

/// All complex roots of a polynomial.
[[nodiscard]] exit_status run_complex_roots(const roots_options& options);

/// All complex roots of an analytic function in a rectangle.
[[nodiscard]] exit_status run_roots_in_rectangle(const roots_options& options);

/// All roots of a system of equations in a box.
[[nodiscard]] exit_status run_system(roots_options& options);

/// "1 root", "2 roots".
[[nodiscard]] std::string counted(std::size_t n, const std::string& what);

}  // namespace polhode::cli
