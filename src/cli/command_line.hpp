#pragma once

#include "cli/output/errors.hpp"

namespace polhode::cli {

/// Reads the command line and does what it says. Throws usage_error and what the subcommands throw.
[[nodiscard]] exit_status run_command_line(int argc, const char* const* argv);

}  // namespace polhode::cli
