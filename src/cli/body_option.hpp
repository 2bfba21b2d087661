#pragma once

// BODY: which rigid body a subcommand is about.

#include <array>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "polhode/rigid_body/body.hpp"

namespace polhode::cli {

/// --ab A,B or --moments IX,IY,IZ
struct body_option {
  std::optional<std::string> ab;
  std::optional<std::string> moments;

  void declare(CLI::App& app);
  /// Throws usage_error where not exactly one was given, or where it cannot be read or is not a body.
  [[nodiscard]] body value() const;
};

/// Three numbers between commas, the value of the option so named; throws usage_error.
[[nodiscard]] std::array<rational, 3> read_triple(const std::string& option,
                                                  const std::string& text);

/// The number that is an option's value, exactly; throws usage_error.
[[nodiscard]] rational read_number(const std::string& option, const std::string& text);

/// "non-physical (ab + 2b > 1)"
[[nodiscard]] std::string described(body_kind kind);

}  // namespace polhode::cli
