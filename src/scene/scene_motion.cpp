#include "scene/scene_motion.hpp"

#include <algorithm>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {

scene_motion::scene_motion(const scene& what, precision p)
    : unit_(what.time_unit.size * what.state->momentum_size / what.body.size),
      p_(p),
      state_(*what.state->start) {
  // |omega| <= |J|/I_z, so that |dJ/dt| = |J x omega| <= |J| |omega|, |d omega/dt| is at most that
  // over I_z, and an entry of dR/dt = R [omega]x is at most |omega|.
  const ball size = sqrt(state_.squared_momentum().at(64));
  const ball least = what.body.moments()[2].at(64);
  const ball fastest = size / least;
  momentum_speed_ = (size * fastest).magnitude_upper();
  velocity_speed_ = square(fastest).magnitude_upper();
  attitude_speed_ = fastest.magnitude_upper();
}

rotor_time scene_motion::at(const rational& t) const {
  rotor_time result;
  if (unit_.power == 0) {
    result.t = t * unit_.factor;
  } else if (t != 0) {
    // The angle turned through, at most |t| |omega|, is to be known to 2^-p_.
    const magnitude angle = multiply_up(attitude_speed_, (t * unit_.at(64)).magnitude_upper());
    const auto whole = std::max<std::int64_t>(angle.log2_floor() + 1, 0);
    const ball product = t * unit_.at(p_ + 64 + static_cast<precision>(whole));
    const ball middle = product.middle();
    result.t = lower_rational(middle);
    result.off = product.radius();
  }
  return result;
}

}  // namespace polhode::detail
