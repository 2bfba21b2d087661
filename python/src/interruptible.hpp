#pragma once

// Long work without the interpreter's lock, which Ctrl-C and a time limit end.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "conversions.hpp"
#include "polhode/arithmetic/scalar.hpp"

namespace polhode::python {

/// Ctrl-C was pressed: what a thread leaves its work with.
struct stopped {};

using stop_flag = std::shared_ptr<std::atomic<bool>>;

/// Runs the task, which must not throw, on another thread: one that has ended its last task, with
/// the constants that it keeps, or a new one.
void run_aside(std::function<void()> task);

/// The process ends soon: where a task is under way then, it ends without destroying what the task
/// uses. To be called as late as possible, as what is registered last is done first.
void expect_the_end();

/// Returns when the flag is set, or soon: most work takes less time than a thread to fall asleep
/// and wake up.
void watch_for_a_moment(const std::atomic<bool>& flag);

/// The result of work(flag), on another thread, while this one listens to signals. On Ctrl-C,
/// and with TimeoutError after so many seconds, the caller goes on at once; the thread ends where
/// the work looks at the flag, and its result is dropped. `meanwhile` is called, with the lock, a
/// few times a second; what it throws ends the work too.
template <class Work>
auto interruptible(std::optional<double> time_limit, Work work,
                   const std::function<void()>& meanwhile = nullptr) {
  if (time_limit && !(*time_limit > 0))
    throw input_error("time_limit must be positive, in seconds");
  using result_type = decltype(work(stop_flag()));
  struct shared_state {
    std::mutex mutex;
    std::condition_variable is_done;
    std::atomic<bool> done = false;
    std::optional<result_type> result;
    std::exception_ptr error;
  };
  const auto state = std::make_shared<shared_state>();
  const auto flag = std::make_shared<std::atomic<bool>>(false);
  run_aside([state, flag, work = std::move(work)] {
    std::optional<result_type> result;
    std::exception_ptr error;
    try {
      result.emplace(work(flag));
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard lock(state->mutex);
    state->result = std::move(result);
    state->error = error;
    state->done = true;
    state->is_done.notify_all();
  });
  constexpr auto between_signals = std::chrono::milliseconds(50);
  const auto start = std::chrono::steady_clock::now();
  bool is_first = true;
  while (true) {
    bool done = false;
    {
      const py::gil_scoped_release without_lock;
      if (is_first) watch_for_a_moment(state->done);
      is_first = false;
      std::unique_lock lock(state->mutex);
      done = state->is_done.wait_for(lock, between_signals, [&] { return state->done.load(); });
    }
    if (done) break;
    if (meanwhile) {
      try {
        meanwhile();
      } catch (...) {
        *flag = true;
        throw;
      }
    }
    if (PyErr_CheckSignals() != 0) {
      *flag = true;
      throw py::error_already_set();
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (time_limit && elapsed.count() > *time_limit) {
      *flag = true;
      PyErr_Format(PyExc_TimeoutError, "not finished within time_limit=%s seconds",
                   fmt::format("{}", *time_limit).c_str());
      throw py::error_already_set();
    }
  }
  if (state->error) std::rethrow_exception(state->error);
  return std::move(*state->result);
}

inline void expect_going_on(const stop_flag& flag) {
  if (*flag) throw stopped();
}

}  // namespace polhode::python
