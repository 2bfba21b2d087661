#pragma once

// Work on several threads.

#include <algorithm>

#include <mpfr.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace polhode::detail {

/// To be called by what runs on a thread that may end: MPFR keeps constants for each thread, which are then given
/// back. (A task_scheduler_observer is not told of every thread's end.)
inline void give_constants_back_at_end() {
  struct constants {
    constants() = default;
    ~constants() { mpfr_free_cache(); }
    constants(const constants&) = delete;
    constants& operator=(const constants&) = delete;
    constants(constants&&) = delete;
    constants& operator=(constants&&) = delete;
  };
  thread_local const constants kept;
  (void)kept;
}

/// So many threads, this one among them, and no more than the machine has processors; 0 for as many.
class worker_threads {
 public:
  explicit worker_threads(int threads)
      : arena_(threads == 0 ? processors() : std::min(threads, processors())) {}

  [[nodiscard]] int count() const { return arena_.max_concurrency(); }
  [[nodiscard]] static int processors() { return tbb::info::default_concurrency(); }

  /// step(0), ..., step(count - 1) in any order. What one throws is thrown.
  template <class Step>
  void for_each(long count, const Step& step) {
    arena_.execute([&] {
      tbb::parallel_for(0L, count, [&](long i) {
        give_constants_back_at_end();
        step(i);
      });
    });
  }

 private:
  tbb::task_arena arena_;
};

}  // namespace polhode::detail
