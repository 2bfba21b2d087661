// libFuzzer's target for the reader of certificates and the checker: whatever the bytes, it
// answers.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "polhode/checker/check.hpp"
#include "processor_time.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const polhode::fuzz::processor_time_limit limit;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // A small budget: with sanitizers it takes a few seconds of processor time, so that what is not
  // charged is found.
  polhode::checker::limits most;
  most.work = 300'000'000;
  most.memory = 256L << 20U;
  const polhode::checker::report r = polhode::checker::check(text, most);
  if (r.is_verified() ? r.statement.empty() : r.message.empty()) __builtin_trap();
  if (r.work > most.work || r.memory > most.memory) __builtin_trap();
  return 0;
}
