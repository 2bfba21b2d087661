#pragma once

// Processor time of one input: more than POLHODE_FUZZ_SECONDS (10) of it is a finding, however long
// the machine took for it.

#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace polhode::fuzz {

class processor_time_limit {
 public:
  processor_time_limit() {
    static const long seconds = [] {
      constexpr long by_default = 10;
      std::signal(SIGPROF, out_of_time);
      const char* given = std::getenv("POLHODE_FUZZ_SECONDS");
      const long n = given == nullptr ? 0 : std::strtol(given, nullptr, 10);
      return n > 0 ? n : by_default;
    }();
    set(seconds);
  }
  ~processor_time_limit() { set(0); }
  processor_time_limit(const processor_time_limit&) = delete;
  processor_time_limit& operator=(const processor_time_limit&) = delete;
  processor_time_limit(processor_time_limit&&) = delete;
  processor_time_limit& operator=(processor_time_limit&&) = delete;

 private:
  static void set(long seconds) {
    itimerval timer{};
    timer.it_value.tv_sec = seconds;
    setitimer(ITIMER_PROF, &timer, nullptr);  // user and system time of this process
  }
  /// libFuzzer keeps the input of a process that aborts.
  static void out_of_time(int) {
    constexpr char text[] = "polhode: this input takes too much processor time\n";
    static_cast<void>(!write(STDERR_FILENO, text, sizeof text - 1));
    std::abort();
  }
};

}  // namespace polhode::fuzz
