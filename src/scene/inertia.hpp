#pragma once

// Bodies from their inertia, in any axes.

#include "polhode/scene/scene.hpp"

namespace polhode::detail {

/// xx, yy, zz, xy, xz, yz.
using tensor_entries = std::array<rational, 6>;

/// The body with this tensor, in `size` kg m^2 or relative. Throws input_error as principal_axes
/// does.
[[nodiscard]] scene_body body_of_tensor(const tensor_entries& given);

/// The same of principal moments about the given axes.
[[nodiscard]] scene_body body_of_moments(const rational_vector& given);

/// Gives a body of principal moments their ranges, in the order in which they were given.
void set_ranges(scene_body& of, const std::array<uncertain_moment, 3>& given);

/// The inertia about its centre of mass of a body composed of solids; the tables [[body.solid]].
struct composed {
  tensor_entries tensor;
  pi_scale size;  // in kg m^2
  std::vector<body_solid> solids;
};
[[nodiscard]] composed read_solids(section& body);

/// A body from the text of a URDF, SDF or MuJoCo file; `link` chooses where there are several.
/// Throws input_error.
struct imported_inertia {
  std::string name;
  /// About the link's axes; where the file turns the inertia's frame by a rotation that is not
  /// rational, about those of that frame, with the turn to the link's.
  tensor_entries tensor;
  exact_rotation turn;
};
[[nodiscard]] imported_inertia import_inertia(const std::string& text,
                                              const std::optional<std::string>& link);

/// [body]
[[nodiscard]] scene_body read_body(section body, const std::filesystem::path& directory,
                                   text_files& files, std::vector<std::string>& remarks);
/// [state]
[[nodiscard]] scene_state read_state(section from, const scene_body& of, scene& whole);

/// For a message: as it is where it is short, else about.
[[nodiscard]] std::string shown(const exact_real& x);

/// The unit under this key, one of those; input_error with the nearest one.
[[nodiscard]] std::optional<unit> read_unit(section& from, const std::string& key,
                                            const std::vector<unit>& units);

}  // namespace polhode::detail
