#include "parallel.hpp"

#include <algorithm>
#include <vector>

#include <tbb/enumerable_thread_specific.h>

#include "base/worker_threads.hpp"

namespace polhode::detail {

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
    tbb::enumerable_thread_specific<add_terms> adders(make);
    worker_threads(threads).for_each(chunks, [&](long chunk) { add_chunk(adders.local(), chunk); });
  }
  ball sum(0, p);
  for (const ball& part : sums) sum += part;
  return sum;
}

}  // namespace polhode::detail
