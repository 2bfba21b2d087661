#pragma once

// Bodies from their inertia, in any axes.

#include "polhode/scene/scene.hpp"

namespace polhode::detail {

/// xx, yy, zz, xy, xz, yz.
using inertia_tensor = std::array<rational, 6>;

/// The body with this tensor, in `size` kg m^2 or relative: its moments, principal axes, kind. Where the principal moments are not
/// all rational, ranges that hold them, and the kind all the same exactly:
///
/// With p the characteristic polynomial and s = trace/2, I_x <= I_y + I_z is I_x <= s. Only I_x can be s or above it, since I_y >= s
/// would be I_y >= I_x + I_z > I_x. So the body is planar exactly where p(s) = 0, and non-physical exactly where p has a root above s.
///
/// Throws input_error where it is not positive definite.
[[nodiscard]] scene_body body_of_tensor(const inertia_tensor& given);

/// The same of principal moments about the given axes.
[[nodiscard]] scene_body body_of_moments(const rational_vector& given);

/// The same with uncertainties.
[[nodiscard]] scene_body body_of_ranges(const std::array<uncertain_moment, 3>& given);

/// The inertia about its centre of mass of a body composed of solids; the tables [[body.solid]].
struct composed {
  inertia_tensor tensor;
  pi_scale size;  // in kg m^2
};
[[nodiscard]] composed read_solids(section& body);

/// A body from a URDF, SDF or MuJoCo file; `link` chooses where there are several. Throws input_error.
struct imported_inertia {
  std::string name;
  inertia_tensor tensor;
};
[[nodiscard]] imported_inertia import_inertia(const std::string& path,
                                              const std::optional<std::string>& link);

/// [body]
[[nodiscard]] scene_body read_body(section body, const std::filesystem::path& directory,
                                   std::vector<std::string>& remarks);
/// [state]
[[nodiscard]] scene_state read_state(section from, const scene_body& of, scene& whole);

/// The unit under this key, one of those; input_error with the nearest one.
[[nodiscard]] std::optional<unit> read_unit(section& from, const std::string& key,
                                            const std::vector<unit>& units);

}  // namespace polhode::detail
