#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cli/cli_app.hpp"

namespace polhode::cli {

/// While it lives, the program may go on for so many seconds; then it ends with status 1 and one
/// line on standard error, which says what was being done and that nothing is certified. Temporary
/// files are removed.
class time_watch {
 public:
  explicit time_watch(double seconds);
  ~time_watch();
  time_watch(const time_watch&) = delete;
  time_watch& operator=(const time_watch&) = delete;
  time_watch(time_watch&&) = delete;
  time_watch& operator=(time_watch&&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable ended_changed_;
  bool ended_ = false;
  std::thread thread_;  // last: it uses the others
};

/// --time-limit TIME: how long a request may take. What is estimated to take longer is refused
/// before work, by the same request for fewer digits (cost::estimated_seconds_of_work); what takes
/// longer is ended.
struct time_limit_option {
  /// One of several things that are done one after the other, for any number of digits.
  using work = std::function<void(long digits)>;

  std::optional<std::string> text;

  void declare(CLI::App& app, const std::string& each = "number");
  /// In seconds, for so many numbers (or of `each`): what is given, else ten minutes for each.
  /// Throws usage_error where the option cannot be read.
  [[nodiscard]] double limit(double numbers = 1) const;
  /// Seconds that all the works are estimated to take, `times` over; nothing where the digits are
  /// too few to be worth an estimate, where a few calls with fewer digits show that all is done in
  /// five seconds, or where one of them throws for fewer. Throws usage_error as
  /// limit() does, and where the estimate is above it, of `what`: "1000000 digits of the phase".
  [[nodiscard]] std::optional<double> check(const std::string& what, long digits,
                                            const std::vector<work>& works, double times = 1) const;
};

}  // namespace polhode::cli
