#pragma once

// Options that several subcommands share. Values are kept as they were given and read by the
// functions here, so that every error says what would be right.

#include <string>
#include <string_view>
#include <vector>

#include "cli/cli_app.hpp"

namespace polhode::cli {

inline constexpr long most_digits = 1'000'000'000;

/// --digits N
struct digits_option {
  std::string text = "50";

  void declare(CLI::App& app);
  /// From 1 to most_digits; throws usage_error for anything else.
  [[nodiscard]] long value() const;
};

/// --format, one of several words; the first is the default.
struct format_option {
  std::vector<std::string> choices;
  std::string text;

  explicit format_option(std::vector<std::string> words)
      : choices(std::move(words)), text(choices.front()) {}
  void declare(CLI::App& app);
  /// One of the choices; throws usage_error for anything else.
  [[nodiscard]] const std::string& value() const;
};

/// The names of things that have a name.
template <class Things>
[[nodiscard]] std::vector<std::string> names_of(const Things& things) {
  std::vector<std::string> names;
  names.reserve(things.size());
  for (const auto& thing : things) names.emplace_back(thing.name);
  return names;
}

/// Names given as arguments, in their order and each once. Throws usage_error at the first that is
/// not known, with the nearest one that is; `list_command` shows them all.
[[nodiscard]] std::vector<std::string> known_names(const std::vector<std::string>& given,
                                                   const std::vector<std::string>& known,
                                                   std::string_view kind,
                                                   std::string_view list_command);

}  // namespace polhode::cli
