#include "digest.hpp"

#include <span>

#include "base/sha256.hpp"

namespace polhode::checker {

namespace {

/// Of what is held to write a value, and its text.
long size_of(const json& value) {
  if (value.is_string()) {
    return 64 + 3 * static_cast<long>(value.get_ref<const std::string&>().size());
  }
  if (!value.is_structured()) return 64;
  long size = 64;
  for (const auto& [key, member] : value.items()) {
    size += 64 + 2 * static_cast<long>(key.size()) + size_of(member);
  }
  return size;
}

}  // namespace

std::string digest_of(const place& certificate) {
  constexpr const char* hex = "0123456789abcdef";
  constexpr long units_of_a_byte = 20;
  const long size = size_of(certificate.value());
  const budget::memory held(certificate.work(), size);
  certificate.work().spend(units_of_a_byte * size);
  json rest = certificate.value();
  rest.erase("digest");
  const std::string text = rest.dump();
  std::string result = "sha256:";
  for (const std::uint8_t byte : sha256(std::as_bytes(std::span(text)))) {
    result += hex[byte / 16U];
    result += hex[byte % 16U];
  }
  return result;
}

}  // namespace polhode::checker
