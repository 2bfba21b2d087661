#pragma once

#include <stdexcept>
#include <string>

namespace polhode::detail {

inline void require_threads(const std::string& function, int threads) {
  if (threads >= 0) return;
  throw std::invalid_argument(function + ": threads must be at least 0 (0: all processors)");
}

}  // namespace polhode::detail
