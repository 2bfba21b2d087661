#pragma once

// From where to where: EXPR A B, EXPR LO..HI, --from A --to B or --in LO..HI.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/cli_app.hpp"
#include "formula.hpp"

namespace polhode::cli {

/// The sign of the infinity that an end of a range is, by one of its names (is_infinity) and a sign
/// or none; 0 for other texts.
[[nodiscard]] int infinite_sign_of(const std::string& text);

struct range_option {
  std::optional<std::string> first;  // A and B, behind the formula; or LO..HI alone
  std::optional<std::string> second;
  std::optional<std::string> from;
  std::optional<std::string> to;
  std::vector<std::string> in;  // one, or one of each variable of a system: "x=LO..HI"

  /// LO..HI as two texts, as `ends` has them; errors begin with how it was given.
  [[nodiscard]] static std::pair<std::string, std::string> ends_of(const std::string& option,
                                                                   const std::string& text,
                                                                   const let_option& let);
  /// After the formula, whose place is before that of A and B.
  void declare(CLI::App& app);
  /// In how many of the ways a range is given, or a part of one.
  [[nodiscard]] int ways() const;
  /// Both ends, as texts without margins; an infinite one is "inf" or "-inf", another can be read
  /// with these names. Throws usage_error where an end is missing or cannot be read. Hypothesis:
  /// ways() is 1.
  [[nodiscard]] std::pair<std::string, std::string> ends(const let_option& let) const;
};

}  // namespace polhode::cli
