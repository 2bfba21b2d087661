#pragma once

// polhode body FILE: the inertias of all links of a robot description.

#include <array>
#include <string>

#include "cli/command.hpp"
#include "cli/output/json_document.hpp"
#include "polhode/rigid_body/principal_axes.hpp"

namespace polhode::cli {

/// What is wanted of all links.
struct links_wanted {
  std::string format;  // text, json or csv
  long digits;
  bool allow_non_physical;
  /// The nearest physical tensor of each non-physical link.
  bool nearest;
};

/// Prints every link. Not certified where a link is refused, or is non-physical and that is not
/// allowed. Throws usage_error where the file cannot be read.
[[nodiscard]] exit_status print_links(const std::string& path, const links_wanted& wanted);

inline constexpr std::array tensor_entry_names{"xx", "yy", "zz", "xy", "xz", "yz"};

/// {"distance": …, "tensor": {"xx": …}, "moments": {"x": …}}
[[nodiscard]] json nearest_json(const nearest_physical_tensor& x, long digits,
                                const std::string& unit = "");
/// "nearest physical tensor: at the distance …", and a line for the entries.
[[nodiscard]] std::string nearest_text(const nearest_physical_tensor& x, long digits,
                                       const std::string& unit = "");

}  // namespace polhode::cli
