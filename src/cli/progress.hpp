#pragma once

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

 private:
  bool on_terminal_;
};

}  // namespace polhode::cli
