#pragma once

// Work on several threads.

#include <algorithm>

#include <mpfr.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

namespace polhode::detail {

/// So many threads, this one among them, and no more than the machine has processors; 0 for as many.
class worker_threads {
 public:
  explicit worker_threads(int threads)
      : arena_(threads == 0 ? processors() : std::min(threads, processors())), keeper_(arena_) {}

  [[nodiscard]] static int processors() { return tbb::info::default_concurrency(); }

  /// work(), whose parallel loops run on these threads.
  template <class Work>
  void execute(const Work& work) {
    arena_.execute(work);
  }
  /// step(0), ..., step(count - 1) in any order. What one throws is thrown.
  template <class Step>
  void for_each(long count, const Step& step) {
    execute([&] { tbb::parallel_for(0L, count, step); });
  }

 private:
  /// MPFR keeps constants for each thread, which a thread that ends has to give back. A worker may
  /// leave the arena after the observer has gone, and so the thread itself sees to it.
  struct mpfr_constants {
    mpfr_constants() = default;
    ~mpfr_constants() { mpfr_free_cache(); }
    mpfr_constants(const mpfr_constants&) = delete;
    mpfr_constants& operator=(const mpfr_constants&) = delete;
  };
  class cache_keeper : public tbb::task_scheduler_observer {
   public:
    explicit cache_keeper(tbb::task_arena& arena) : tbb::task_scheduler_observer(arena) {
      observe(true);
    }
    ~cache_keeper() override { observe(false); }
    cache_keeper(const cache_keeper&) = delete;
    cache_keeper& operator=(const cache_keeper&) = delete;
    void on_scheduler_entry(bool is_worker) override {
      if (is_worker) thread_local const mpfr_constants kept;
    }
  };

  tbb::task_arena arena_;
  cache_keeper keeper_;
};

}  // namespace polhode::detail
