#pragma once

// The version of the library. The build reads it here.

#include "polhode/language.hpp"

#define POLHODE_VERSION_MAJOR 0
#define POLHODE_VERSION_MINOR 2
#define POLHODE_VERSION_PATCH 0
/// "-dev" between releases: a version that is not yet made.
#define POLHODE_VERSION_SUFFIX "-dev"

#define POLHODE_TEXT_OF(x) #x
#define POLHODE_VERSION_TEXT(major, minor, patch) \
  POLHODE_TEXT_OF(major) "." POLHODE_TEXT_OF(minor) "." POLHODE_TEXT_OF(patch)
#define POLHODE_VERSION                                                                     \
  POLHODE_VERSION_TEXT(POLHODE_VERSION_MAJOR, POLHODE_VERSION_MINOR, POLHODE_VERSION_PATCH) \
  POLHODE_VERSION_SUFFIX

namespace polhode {

inline constexpr int version_major = POLHODE_VERSION_MAJOR;
inline constexpr int version_minor = POLHODE_VERSION_MINOR;
inline constexpr int version_patch = POLHODE_VERSION_PATCH;

}  // namespace polhode
