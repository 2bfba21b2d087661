#pragma once

// An option that is a whole number within limits.

#include <string>

#include "cli/cli_app.hpp"

namespace polhode::cli {

inline constexpr long most_threads = 1024;

class count_option {
 public:
  count_option(std::string name, long by_default, long least, long most);

  void declare(CLI::App& app, const std::string& description);

  /// Throws usage_error for anything but a whole number within the limits.
  [[nodiscard]] long value() const;

 private:
  std::string name_;
  std::string text_;
  long least_;
  long most_;
};

}  // namespace polhode::cli
