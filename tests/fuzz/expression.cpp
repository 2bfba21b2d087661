// libFuzzer's target for the parser of formulas: whatever the bytes, it reads a formula in x or
// says what is wrong.

#include <cstddef>
#include <cstdint>
#include <string>

#include "polhode/expression/expression.hpp"
#include "processor_time.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const polhode::fuzz::processor_time_limit limit;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const polhode::expression formula(text, {{"x"}, {}, {}});
  } catch (const polhode::input_error&) {  // it says what is wrong
  }
  return 0;
}
