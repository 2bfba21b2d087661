// libFuzzer's target for the reader of bodies in JSON: whatever the bytes, it reads a body or says
// what is wrong.

#include <cstddef>
#include <cstdint>
#include <string>

#include "polhode/scene/body_file.hpp"
#include "processor_time.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const polhode::fuzz::processor_time_limit limit;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    static_cast<void>(polhode::parse_body_file(text));
  } catch (const polhode::input_error& error) {
    if (error.what()[0] == '\0') __builtin_trap();  // it must say what is wrong
  }
  return 0;
}
