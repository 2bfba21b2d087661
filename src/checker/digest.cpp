#include "digest.hpp"

#include <span>

#include "polhode/arithmetic/sha256.hpp"

namespace polhode::checker {

std::string digest_of(json certificate) {
  constexpr const char* hex = "0123456789abcdef";
  certificate.erase("digest");
  const std::string text = certificate.dump();
  std::string result = "sha256:";
  for (const std::uint8_t byte : sha256(std::as_bytes(std::span(text)))) {
    result += hex[byte / 16U];
    result += hex[byte % 16U];
  }
  return result;
}

}  // namespace polhode::checker
