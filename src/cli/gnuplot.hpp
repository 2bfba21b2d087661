#pragma once

#include <string>

namespace polhode::cli {

/// What gnuplot writes to its standard output for this program. Throws output_error where it is not installed or fails,
/// which names the option that does without it.
[[nodiscard]] std::string run_gnuplot(const std::string& program,
                                      const std::string& option_without = "--format csv");

}  // namespace polhode::cli
