// libFuzzer's target for the reader of URDF, SDF and MuJoCo files: whatever the bytes, it reads an
// inertia and the body with it, or says what is wrong.

#include <cstddef>
#include <cstdint>
#include <string>

#include "processor_time.hpp"
#include "scene/inertia.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const polhode::fuzz::processor_time_limit limit;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const auto found = polhode::detail::import_inertia(text, std::nullopt);
    static_cast<void>(polhode::detail::body_of_tensor(found.tensor));
  } catch (const polhode::input_error& error) {
    if (error.what()[0] == '\0') __builtin_trap();  // it must say what is wrong
  }
  return 0;
}
