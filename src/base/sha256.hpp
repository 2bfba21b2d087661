#pragma once

// SHA-256 (FIPS 180-4, 2015), to tell a file that was written whole from one that was not.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace polhode {

using sha256_digest = std::array<std::uint8_t, 32>;

/// The digest of the bytes.
[[nodiscard]] sha256_digest sha256(std::span<const std::byte> bytes);

}  // namespace polhode
