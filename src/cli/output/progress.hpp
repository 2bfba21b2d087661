#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace polhode::cli {

/// What the last progress::show said.
[[nodiscard]] std::string current_activity();

/// One line on standard error that says what is being done, where that is a terminal: each text
/// takes the place of the one before, and the line is clear again in the end. Elsewhere, as in a
/// log, a line of its own every minute, or as often as the environment's POLHODE_PROGRESS_SECONDS
/// says: what is being done then, for how long, and how long it may still take.
class progress {
 public:
  progress();
  ~progress();
  progress(const progress&) = delete;
  progress& operator=(const progress&) = delete;
  progress(progress&&) = delete;
  progress& operator=(progress&&) = delete;

  void show(std::string_view doing) const;
  /// What has been done so far of what is shown, asked for whenever a line is written, from another
  /// thread; empty for nothing.
  void count(std::function<std::string()> counts) const;
  /// So many seconds are left for all that the line is for, by an estimate: they are shown too, and
  /// counted down.
  void expect(std::optional<double> seconds) const;
  /// Before part `done` + 1 of `count` equal parts: their numbers, and the time left by the pace
  /// since the line was made.
  void show_part(std::string_view doing, std::size_t done, std::size_t count) const;

 private:
  class countdown;

  bool on_terminal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  mutable std::chrono::steady_clock::time_point last_part_;
  std::unique_ptr<countdown> countdown_;
};

}  // namespace polhode::cli
