#pragma once

namespace polhode::detail {

/// While one exists, the thread's exp, sinh, cosh, log, sin, cos and atan of balls are MPFR's: a
/// second opinion on values of Polhode's own algorithms.
class only_mpfr_functions {
 public:
  only_mpfr_functions() noexcept;
  only_mpfr_functions(const only_mpfr_functions&) = delete;
  only_mpfr_functions(only_mpfr_functions&&) = delete;
  only_mpfr_functions& operator=(const only_mpfr_functions&) = delete;
  only_mpfr_functions& operator=(only_mpfr_functions&&) = delete;
  ~only_mpfr_functions();

  /// Whether one exists in this thread.
  [[nodiscard]] static bool are_wanted() noexcept;
};

}  // namespace polhode::detail
