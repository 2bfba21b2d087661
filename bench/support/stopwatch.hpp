#pragma once

// Seconds: of calls in a loop that the compiler may not shorten, here or in a child process.

#include <chrono>
#include <stdexcept>

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

/// f(), a number, computed in a child process made for it.
template <class F>
[[nodiscard]] double in_child(F f) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe to a child process");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no child process");
  if (child == 0) {
    int exit_status = 1;
    try {
      const double value = f();
      if (write(ends[1], &value, sizeof value) == ssize_t{sizeof value}) exit_status = 0;
    } catch (...) {  // the parent throws
    }
    _exit(exit_status);
  }
  close(ends[1]);
  double value = 0;
  const bool complete = read(ends[0], &value, sizeof value) == ssize_t{sizeof value};
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!complete || status != 0) throw std::runtime_error("a child process failed");
  return value;
}

}  // namespace polhode::bench
