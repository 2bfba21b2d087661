#pragma once

// How long something took, for accounts and measurements. No answer depends on a clock.

#include <chrono>
#include <ctime>

namespace polhode::detail {

using clock = std::chrono::steady_clock;

/// The seconds that have passed since then.
[[nodiscard]] inline double seconds_since(clock::time_point start) {
  return std::chrono::duration<double>(clock::now() - start).count();
}

/// The seconds of processor time that this process has used, on all of its threads.
[[nodiscard]] inline double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace polhode::detail
