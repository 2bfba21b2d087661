#pragma once

#include <string>

namespace polhode::cli {

/// "40 s", "3 min", "2.5 h", "12 days", "400 years", "10^9 years": for estimates, two digits or so.
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace polhode::cli
