#pragma once

#include <functional>
#include <string>

#include "cli/output/errors.hpp"
#include "cli_app.hpp"

namespace polhode::cli {

/// A subcommand.
struct command {
  std::string name;
  std::string summary;   // one line, for the list of subcommands
  std::string examples;  // the end of its help
  /// Declares its arguments and options, and returns what it does once they have been read: it
  /// checks all that was given before it starts work, and prints its output in the end or throws.
  std::function<std::function<exit_status()>(CLI::App&)> declare;
  /// Several processes that MPI started work on one run of it (ranks.hpp).
  bool runs_on_ranks = false;
};

}  // namespace polhode::cli
