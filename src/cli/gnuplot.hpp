#pragma once

#include <string>

namespace polhode::cli {

/// What gnuplot writes to its standard output for this program. Throws output_error where it is not installed or fails.
[[nodiscard]] std::string run_gnuplot(const std::string& program);

}  // namespace polhode::cli
