#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace polhode::cli {

/// --time-limit DAYS: how long a request may take by its estimate, which is made from the same request for fewer digits
/// (cost::estimated_seconds_of_work).
struct time_limit_option {
  /// One of several things that are done one after the other, for any number of digits.
  using work = std::function<void(long digits)>;

  std::optional<std::string> text;

  void declare(CLI::App& app);
  /// In seconds; throws usage_error where the option cannot be read.
  [[nodiscard]] double limit() const;
  /// Seconds that all the works are estimated to take, `times` over; nothing where the digits are too few to be worth an estimate,
  /// or where one of them throws for fewer. Throws usage_error as limit() does, and where the estimate is above it (by
  /// default 30 days), of `what`: "1000000 digits of the phase".
  [[nodiscard]] std::optional<double> check(const std::string& what, long digits,
                                            const std::vector<work>& works, double times = 1) const;
};

}  // namespace polhode::cli
