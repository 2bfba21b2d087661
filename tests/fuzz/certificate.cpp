// libFuzzer's target for the reader of certificates and the checker: whatever the bytes, it answers.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "polhode/checker/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const polhode::checker::report r = polhode::checker::check(text);
  if (r.result != polhode::checker::outcome::verified && r.message.empty()) __builtin_trap();
  return 0;
}
