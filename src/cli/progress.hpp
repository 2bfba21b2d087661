#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

namespace polhode::cli {

/// One line on standard error that says what is being done, where that is a terminal; nothing
/// elsewhere. Each text takes the place of the one before, and the line is clear again in the end.
class progress {
 public:
  progress();
  ~progress();
  progress(const progress&) = delete;
  progress& operator=(const progress&) = delete;
  progress(progress&&) = delete;
  progress& operator=(progress&&) = delete;

  void show(std::string_view doing) const;
  /// So many seconds are left for all that the line is for, by an estimate: they are shown too, and counted down.
  void expect(std::optional<double> seconds) const;
  /// Before part `done` + 1 of `count` equal parts: their numbers, and the time left by the pace since the line was made.
  void show_part(std::string_view doing, std::size_t done, std::size_t count) const;

 private:
  class countdown;

  bool on_terminal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  mutable std::chrono::steady_clock::time_point last_part_;
  std::unique_ptr<countdown> countdown_;
};

}  // namespace polhode::cli
