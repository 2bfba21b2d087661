#pragma once

// A scene: a body, its state, a time, and the effects asked for, read from a TOML file
// (docs/scenes.md). All numbers are exact.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "polhode/rigid_body/rotor.hpp"
#include "polhode/scene/body_file.hpp"
#include "polhode/scene/document.hpp"
#include "polhode/scene/units.hpp"

namespace polhode {

using rational_vector = std::array<rational, 3>;

/// A homogeneous solid of which a body is composed: a "box", "cylinder" or "ellipsoid".
struct body_solid {
  std::string shape;
  std::size_t axis = 2;  // along which a cylinder is
  /// Half its sides, or its semi-axes, and its centre as seen from the body's centre of mass, in
  /// one unit of length.
  rational_vector half;
  rational_vector position;
};

struct scene_body {
  std::string name;
  std::string source;
  /// The tensor about the axes in which it is written, in `size` kg m^2 where has_unit, else
  /// relative, with its principal moments and axes.
  std::shared_ptr<const principal_axes> axes;
  /// From the axes of the tensor to those in which the body was given; not the identity only where
  /// it is irrational.
  exact_rotation turn;
  pi_scale size;
  bool has_unit = false;
  /// Where uncertainties were given; and the moments' own, in the order of `moments`: each in value
  /// - sigma .. value + sigma.
  std::optional<uncertain_body> ranges;
  std::array<uncertain_moment, 3> uncertainties;
  /// Where it was given by solids.
  std::vector<body_solid> solids;
  /// Of the file from which it was imported.
  std::optional<std::string> file;
  /// Of all members of the ranges.
  body_kind kind = body_kind::undecided;

  /// I_x >= I_y >= I_z.
  [[nodiscard]] const std::array<exact_real, 3>& moments() const { return axes->moments(); }
  /// The unit vector along the i-th principal axis, in the axes in which the body was given.
  [[nodiscard]] triple<ball> principal_axis(std::size_t i, precision p) const;
};

/// The state at time 0.
struct scene_state {
  /// With c = 2 I_y H/J^2 - 1 in [-b, a]. Where the body has three different moments.
  std::optional<polhode::motion> motion;
  /// The angular momentum in the axes in which the body was given, in units of momentum_size,
  /// absolute where the time is, the angular velocity in momentum_size over the body's size, and
  /// the rotor's start, with the attitude, from that frame to that of space. Missing where the
  /// motion was given by c alone.
  std::optional<triple<exact_real>> momentum;
  std::optional<triple<exact_real>> omega;
  /// Whether the angular velocity was given: then that is the same for all bodies within the
  /// uncertainties, and else the momentum.
  bool by_omega = false;
  std::optional<initial_state> start;
  pi_scale momentum_size;
  /// The attitude, as a quaternion w, x, y, z that is not normalised: from the frame in which the
  /// body was given to that of space.
  std::optional<std::array<rational, 4>> quaternion;
  /// Or as its matrix, by rows.
  std::optional<matrix3<rational>> matrix;
  /// Or by angles about axes of the body, each turned with it (initial_state::set_euler_angles).
  std::optional<rational_vector> euler;
  angle_unit euler_unit = angle_unit::radians;
  triple<int> euler_axes{2, 0, 2};
  long line = 0;
};

struct scene_time {
  rational from = 0;
  rational to = 0;
  long samples = 0;
};

struct scene {
  std::string title;
  std::string source;
  scene_body body;
  std::optional<scene_state> state;
  std::optional<scene_time> time;
  /// The unit in which times are given and reported; its size is 1 where nothing in the scene has
  /// units.
  unit time_unit{"I_y/J", {1, 0}};
  /// Whether that is a time of the SI, the given units' own, or I_y/J.
  enum class time_scale { si, as_given, natural } time_kind = time_scale::natural;

  std::vector<std::string> want;
  long digits = 30;
  bool in_double = false;
  long points = 41;                                // of the curves
  long listed = 20;                                // of the meetings and of the flips
  std::optional<std::array<rational, 2>> c_range;  // of the curves

  struct sweep_axis {
    std::string key;
    std::vector<rational> values;
  };
  std::vector<sweep_axis> sweep;
  std::vector<std::string> remarks;
};

/// Reads a scene. Paths in it are taken from `directory`. `replaced` stands in for numbers of the
/// file (a point of its sweep). Throws input_error, "line 12: body.moments[0]: ...", for whatever
/// cannot be used.
[[nodiscard]] scene read_scene(const std::string& text, const std::filesystem::path& directory,
                               const std::map<std::string, rational>& replaced = {});
/// The same. A file that the scene names is taken from `files`, and `settings` stand in for values
/// of the file (with_settings).
[[nodiscard]] scene read_scene(const std::string& text, const std::filesystem::path& directory,
                               const std::map<std::string, rational>& replaced, text_files& files,
                               const std::vector<std::string>& settings = {});

}  // namespace polhode
