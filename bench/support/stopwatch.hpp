#pragma once

// Seconds: of calls in a loop that the compiler may not shorten, here or in a child process.

#include <chrono>
#include <ctime>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <type_traits>

#include <benchmark/benchmark.h>
#include <sys/wait.h>
#include <unistd.h>

namespace polhode::bench {

/// The seconds that `calls` calls of f take. Everything that f writes is taken to be read.
template <class F>
[[nodiscard]] double seconds_of(F& f, long calls) {
  const auto start = std::chrono::steady_clock::now();
  for (long i = 0; i < calls; ++i) {
    f();
    benchmark::ClobberMemory();
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return taken.count();
}

/// The same by the processor's time for this process and what it does in the system.
template <class F>
[[nodiscard]] double processor_seconds_of(F& f, long calls) {
  const auto now = [] {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double start = now();
  for (long i = 0; i < calls; ++i) {
    f();
    benchmark::ClobberMemory();
  }
  return now() - start;
}

/// f(), a number or a few, computed in a child process made for it. What f throws is said on the
/// error stream.
template <class F>
[[nodiscard]] auto in_child(F f) {
  using result = decltype(f());
  static_assert(std::is_trivially_copyable_v<result>);
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe to a child process");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no child process");
  if (child == 0) {
    int exit_status = 1;
    try {
      const result value = f();
      if (write(ends[1], &value, sizeof value) == ssize_t{sizeof value}) exit_status = 0;
    } catch (const std::exception& e) {  // the parent throws
      std::cerr << e.what() << std::endl;
    }
    _exit(exit_status);
  }
  close(ends[1]);
  result value{};
  const bool complete = read(ends[0], &value, sizeof value) == ssize_t{sizeof value};
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!complete || status != 0) throw std::runtime_error("a child process failed");
  return value;
}

}  // namespace polhode::bench
