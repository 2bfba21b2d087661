#include "parallel.hpp"

#include <algorithm>
#include <vector>

#include <mpfr.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

namespace polhode::detail {

namespace {

/// MPFR keeps constants for each thread, which a thread that ends has to give back.
class cache_keeper : public tbb::task_scheduler_observer {
 public:
  explicit cache_keeper(tbb::task_arena& arena) : tbb::task_scheduler_observer(arena) {
    observe(true);
  }
  ~cache_keeper() override { observe(false); }
  cache_keeper(const cache_keeper&) = delete;
  cache_keeper& operator=(const cache_keeper&) = delete;
  void on_scheduler_exit(bool is_worker) override {
    if (is_worker) mpfr_free_cache();
  }
};

}  // namespace

ball sum_in_chunks(long count, precision p, int threads, const std::function<add_terms()>& make) {
  constexpr long most_chunks = 256;
  const long length = std::max((count + most_chunks - 1) / most_chunks, 4L);
  const long chunks = (count + length - 1) / length;
  std::vector<ball> sums(static_cast<std::size_t>(chunks), ball(0, p));
  const auto add_chunk = [&](const add_terms& add, long chunk) {
    add(chunk * length, std::min((chunk + 1) * length, count),
        sums[static_cast<std::size_t>(chunk)]);
  };
  // A term of 500 bits takes some microseconds, and so does waking a thread.
  constexpr long least_work = 10'000;  // bits
  if (threads == 1 || count * p < least_work) {
    const add_terms add = make();
    for (long chunk = 0; chunk < chunks; ++chunk) add_chunk(add, chunk);
  } else {
    const int processors = tbb::info::default_concurrency();
    tbb::task_arena arena(threads == 0 ? processors : std::min(threads, processors));
    const cache_keeper keeper(arena);
    arena.execute([&] {
      tbb::enumerable_thread_specific<add_terms> adders(make);
      tbb::parallel_for(0L, chunks, [&](long chunk) { add_chunk(adders.local(), chunk); });
    });
  }
  ball sum(0, p);
  for (const ball& part : sums) sum += part;
  return sum;
}

}  // namespace polhode::detail
