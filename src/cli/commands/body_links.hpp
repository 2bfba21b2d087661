#pragma once

// polhode body FILE: the inertias of all links of a robot description.

#include <string>

#include "cli/command.hpp"

namespace polhode::cli {

/// Whether the name is that of a URDF, SDF or MuJoCo file.
[[nodiscard]] bool is_robot_file(const std::string& path);

/// Prints every link, as text, json or csv. Not certified where a link is refused, or is
/// non-physical and that is not allowed. Throws usage_error where the file cannot be read.
[[nodiscard]] exit_status print_links(const std::string& path, const std::string& format,
                                      long digits, bool allow_non_physical);

}  // namespace polhode::cli
