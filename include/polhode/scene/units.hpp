#pragma once

// Units of measure, as exact multiples of those of the SI.

#include <string>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode {

/// factor pi^power > 0: degrees are pi/180, and every cylinder's volume has a pi.
struct pi_scale {
  rational factor = 1;
  int power = 0;

  /// An enclosure with p bits.
  [[nodiscard]] ball at(precision p) const;
  friend pi_scale operator*(const pi_scale& x, const pi_scale& y) {
    return {x.factor * y.factor, x.power + y.power};
  }
  friend pi_scale operator/(const pi_scale& x, const pi_scale& y) {
    return {x.factor / y.factor, x.power - y.power};
  }
};

struct unit {
  std::string name;
  pi_scale size;
};

// What may stand in a scene. The names are those of the units: "mm", "g", "kg/m^3", "kg m^2",
// "deg/s", "day".
[[nodiscard]] const std::vector<unit>& length_units();
[[nodiscard]] const std::vector<unit>& mass_units();
[[nodiscard]] const std::vector<unit>& density_units();
[[nodiscard]] const std::vector<unit>& inertia_units();
[[nodiscard]] const std::vector<unit>& momentum_units();
[[nodiscard]] const std::vector<unit>& time_units();
/// Of a frequency, with the speed of light for wave numbers, 1/cm (exact in the SI, 2019).
[[nodiscard]] const std::vector<unit>& rotational_units();
/// An angle over a time, "rad/s", "deg/day", "rev/min", and "rpm" and "Hz".
[[nodiscard]] const std::vector<unit>& angular_velocity_units();
[[nodiscard]] const std::vector<unit>& angle_units();

/// Planck's constant over 8 pi^2, in kg m^2 Hz (exact in the SI, 2019): a moment of inertia times
/// its rotational constant.
[[nodiscard]] pi_scale inertia_times_rotational_constant();

}  // namespace polhode
