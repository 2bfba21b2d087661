#pragma once

// The subcommands, each defined in a file of its own name.

#include <vector>

#include "command.hpp"

namespace polhode::cli {

[[nodiscard]] command body_command();
[[nodiscard]] command certify_command();
[[nodiscard]] command check_command();
[[nodiscard]] command constants_command();
[[nodiscard]] command eval_command();
[[nodiscard]] command integrate_command();
[[nodiscard]] command phase_command();
[[nodiscard]] command racket_command();
[[nodiscard]] command roots_command();
[[nodiscard]] command scene_command();
[[nodiscard]] command table_command();
[[nodiscard]] command map_command();
[[nodiscard]] command merge_command();
[[nodiscard]] command cost_command();
[[nodiscard]] command curve_command();
[[nodiscard]] command figures_command();

/// In the order of the help.
[[nodiscard]] inline std::vector<command> all_commands() {
  return {certify_command(),   check_command(), constants_command(), eval_command(),
          integrate_command(), roots_command(), body_command(),      phase_command(),
          racket_command(),    curve_command(), table_command(),     map_command(),
          merge_command(),     scene_command(), figures_command(),   cost_command()};
}

}  // namespace polhode::cli
