#pragma once

#include <optional>
#include <string>

#include "cli/cli_app.hpp"

namespace polhode::cli {

/// Of a number: log2(10)/8.
inline constexpr double bytes_per_digit = 0.4153;

/// What a request is estimated to need.
struct memory_estimate {
  std::string what;  // "1000000000 digits of beta"
  double bytes = 0;
};

/// --memory-limit GIB: how much memory a request may need by its estimate.
struct memory_limit_option {
  std::optional<std::string> text;

  void declare(CLI::App& app);
  /// Throws usage_error where the option cannot be read, or where the estimate is above it (by
  /// default the lesser of 4 GiB and 3/4 of the physical memory).
  void check(const memory_estimate& estimate) const;
};

}  // namespace polhode::cli
