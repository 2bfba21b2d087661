#pragma once

// The functions and constants that a formula may use: the one list from which the reader, the help of the
// program and the check of docs/expressions.md are made.

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct expression_function {
  std::string name;
  std::string arguments;    // "x", "x, n"
  std::string description;  // in some words
  std::string domain;       // where it is defined
};

struct expression_constant {
  std::string name;
  std::string description;
};

[[nodiscard]] const std::vector<expression_function>& expression_functions();
[[nodiscard]] const std::vector<expression_constant>& expression_constants();

}  // namespace polhode
