#pragma once

// Work on several threads.

#include <functional>
#include <memory>

namespace polhode::detail {

/// To be called by what runs on a thread that may end: MPFR keeps constants for each thread, which
/// are then given back. (A task_scheduler_observer is not told of every thread's end.)
void give_constants_back_at_end();

/// Up to this many threads, the calling one among them, and no more than the machine has
/// processors; 0 for as many as it has.
class worker_threads {
 public:
  explicit worker_threads(int threads);
  ~worker_threads();
  worker_threads(const worker_threads&) = delete;
  worker_threads& operator=(const worker_threads&) = delete;
  worker_threads(worker_threads&&) = delete;
  worker_threads& operator=(worker_threads&&) = delete;

  [[nodiscard]] int count() const;
  [[nodiscard]] static int processors();

  /// Calls step(0), ..., step(count - 1), in any order. Rethrows what a step throws.
  void for_each(long count, const std::function<void(long)>& step);

 private:
  struct arena;
  std::unique_ptr<arena> arena_;
};

}  // namespace polhode::detail
