#include "worker_threads.hpp"

#include <algorithm>

#include <mpfr.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace polhode::detail {

void give_constants_back_at_end() {
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

struct worker_threads::arena {
  explicit arena(int count) : threads(count) {}

  tbb::task_arena threads;
};

worker_threads::worker_threads(int threads)
    : arena_(
          std::make_unique<arena>(threads == 0 ? processors() : std::min(threads, processors()))) {}

worker_threads::~worker_threads() = default;

int worker_threads::count() const { return arena_->threads.max_concurrency(); }

int worker_threads::processors() { return tbb::info::default_concurrency(); }

void worker_threads::for_each(long count, const std::function<void(long)>& step) {
  arena_->threads.execute([&] {
    tbb::parallel_for(0L, count, [&](long i) {
      give_constants_back_at_end();
      step(i);
    });
  });
}

}  // namespace polhode::detail
