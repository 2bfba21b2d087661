#pragma once

// A scene's start and times as a rotor takes them: in the units of the moments and the momentum
// given.

#include "polhode/rigid_body/rotor.hpp"
#include "polhode/scene/scene.hpp"

namespace polhode::detail {

/// A time as the rotor has it, in moment/momentum: an exact number, and how far from it the true
/// time may be, which has pi in it where angles are in degrees.
struct rotor_time {
  rational t;
  magnitude off = magnitude::from_integer_up(0);
};

/// The motion of a scene's body, in the units of the rotor, and the times of the scene in them.
class scene_motion {
 public:
  scene_motion(const scene& what, precision p);

  [[nodiscard]] const initial_state& state() const { return state_; }
  [[nodiscard]] const pi_scale& unit() const { return unit_; }
  /// A bound of |omega|, in the rotor's units.
  [[nodiscard]] const magnitude& attitude_speed() const { return attitude_speed_; }
  [[nodiscard]] rotor_time at(const rational& t) const;
  /// The enclosure of a component of J, of omega, or of an entry of R, at the true time, from that
  /// at the rotor's; a double stays as it is.
  [[nodiscard]] ball momentum(const ball& x, const rotor_time& at) const {
    return x.enlarged(multiply_up(momentum_speed_, at.off));
  }
  [[nodiscard]] ball velocity(const ball& x, const rotor_time& at) const {
    return x.enlarged(multiply_up(velocity_speed_, at.off));
  }
  [[nodiscard]] ball attitude(const ball& x, const rotor_time& at) const {
    return x.enlarged(multiply_up(attitude_speed_, at.off));
  }
  static double momentum(double x, const rotor_time&) { return x; }
  static double velocity(double x, const rotor_time&) { return x; }
  static double attitude(double x, const rotor_time&) { return x; }

 private:
  pi_scale unit_;
  precision p_;
  initial_state state_;
  magnitude momentum_speed_;
  magnitude velocity_speed_;
  magnitude attitude_speed_;
};

}  // namespace polhode::detail
