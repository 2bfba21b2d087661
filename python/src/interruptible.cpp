#include "interruptible.hpp"

#include <pthread.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

namespace polhode::python {
namespace {

/// A thread that waits for something to do.
struct idle_thread {
  std::mutex mutex;
  std::condition_variable is_wanted;
  std::function<void()> task;
  std::atomic<bool> has_task = false;
};

/// Those that wait. It is never destroyed: they use it until the process ends.
struct idle_threads {
  std::mutex mutex;
  std::vector<std::shared_ptr<idle_thread>> waiting;
};

idle_threads* idle = nullptr;
/// Tasks that have not ended, those among them whose callers have gone on.
std::atomic<long> tasks_under_way = 0;

/// After a fork the child has none of its parent's threads, and perhaps a mutex of theirs that is
/// locked for ever.
void forget_all() {
  idle = new idle_threads;
  tasks_under_way = 0;
}

/// Threads that still compute use constants that the end of the process would destroy.
void end_at_once(int status, void*) {
  if (tasks_under_way == 0) return;
  std::fflush(nullptr);
  _exit(status);
}

void run_tasks(const std::shared_ptr<idle_thread>& self) {
  while (true) {
    {
      watch_for_a_moment(self->has_task);
      std::unique_lock lock(self->mutex);
      self->is_wanted.wait(lock, [&] { return self->has_task.load(); });
      const std::function<void()> task = std::exchange(self->task, nullptr);
      self->has_task = false;
      lock.unlock();
      task();
      --tasks_under_way;
    }
    const std::lock_guard all(idle->mutex);
    idle->waiting.push_back(self);
  }
}

}  // namespace

void expect_the_end() { on_exit(end_at_once, nullptr); }

void watch_for_a_moment(const std::atomic<bool>& flag) {
  // Some times what it takes to wake a thread that sleeps.
  constexpr auto moment = std::chrono::microseconds(250);
  static const bool has_processors = std::thread::hardware_concurrency() > 1;
  if (!has_processors) return;
  const auto end = std::chrono::steady_clock::now() + moment;
  while (!flag.load(std::memory_order_acquire) && std::chrono::steady_clock::now() < end) {
  }
}

void run_aside(std::function<void()> task) {
  [[maybe_unused]] static const int once = [] {
    forget_all();
    return pthread_atfork(nullptr, nullptr, forget_all);
  }();
  std::shared_ptr<idle_thread> thread;
  {
    const std::lock_guard lock(idle->mutex);
    if (!idle->waiting.empty()) {
      thread = std::move(idle->waiting.back());
      idle->waiting.pop_back();
    }
  }
  ++tasks_under_way;
  const bool is_new = thread == nullptr;
  if (is_new) thread = std::make_shared<idle_thread>();
  {
    const std::lock_guard lock(thread->mutex);
    thread->task = std::move(task);
    thread->has_task = true;
  }
  if (is_new) {
    std::thread(run_tasks, thread).detach();
  } else {
    thread->is_wanted.notify_one();
  }
}

}  // namespace polhode::python
