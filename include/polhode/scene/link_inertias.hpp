#pragma once

// The inertias of all links of a robot description: URDF, SDF or MuJoCo.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "polhode/arithmetic/exact_real.hpp"
#include "polhode/rigid_body/body.hpp"

namespace polhode {

/// The inertia of one link about its centre of mass, by what does not depend on the axes. In kg
/// m^2.
struct link_inertia {
  std::string name;
  long line = 0;  // of its <inertial>
  /// What keeps it from being a body's; then the rest has no meaning. Empty where nothing does.
  std::string problem;
  /// As it is written, in the axes of the inertia's own frame: xx, yy, zz, xy, xz, yz.
  std::array<rational, 6> tensor{};
  body_kind kind = body_kind::undecided;
  /// I_x >= I_y >= I_z.
  std::array<exact_real, 3> moments{0, 0, 0};
  /// I_y + I_z - I_x: negative where the triangle inequality is violated.
  exact_real margin = 0;
  /// Where the moments are different.
  std::optional<body> rigid;
};

/// Those of all links, in the order of the file. A frame that is turned against the link's is of no
/// matter here, and an inertia that is no body's has its problem said. Throws input_error where the
/// text is no XML, or has no inertia.
[[nodiscard]] std::vector<link_inertia> read_link_inertias(const std::string& text);
/// The names of the links (of MuJoCo, bodies) without <inertial>, in the order of the file: frames
/// without a mass, or links whose inertia a simulator finds from their shape. Throws input_error
/// where the text is no XML.
[[nodiscard]] std::vector<std::string> links_without_inertia(const std::string& text);

/// Whether a file of this name is a robot description: .urdf, .sdf, .xml or .mjcf.
[[nodiscard]] bool is_robot_file(const std::string& path);

/// The body of one link; `link` chooses where there are several. Throws input_error where it is not
/// one of them, where its inertia is no body's, and where it is a symmetric top.
[[nodiscard]] body read_link_body(const std::string& text, const std::optional<std::string>& link);

}  // namespace polhode
