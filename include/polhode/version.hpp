#pragma once

// The version of the library. The build reads it here.

#define POLHODE_VERSION_MAJOR 0
#define POLHODE_VERSION_MINOR 1
#define POLHODE_VERSION_PATCH 1

namespace polhode {

inline constexpr int version_major = POLHODE_VERSION_MAJOR;
inline constexpr int version_minor = POLHODE_VERSION_MINOR;
inline constexpr int version_patch = POLHODE_VERSION_PATCH;

}  // namespace polhode
