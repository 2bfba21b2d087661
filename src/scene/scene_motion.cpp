#include "scene/scene_motion.hpp"

#include <algorithm>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {

matrix3<rational> frame_of(const scene_body& of) {
  matrix3<rational> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const rational& square = of.axes[k].square;
    const rational length(integer(sqrt(numerator(square))), integer(sqrt(denominator(square))));
    for (std::size_t i = 0; i < 3; ++i) result[i][k] = of.axes[k].direction[i] / length;
  }
  return result;
}

triple<rational> momentum_of(const scene& what) {
  const scene_body& of = what.body;
  triple<rational> momentum;
  for (std::size_t i = 0; i < 3; ++i) {
    const rational& square = of.axes[i].square;
    momentum[i] = (*what.state->momentum)[i] /
                  rational(integer(sqrt(numerator(square))), integer(sqrt(denominator(square))));
  }
  return momentum;
}

initial_state state_of(const scene& what) {
  return initial_state::from_momentum(*what.body.moments, momentum_of(what));
}

matrix3<ball> attitude_at_0(const scene& what, initial_state any, precision p) {
  const scene_state& state = *what.state;
  if (state.quaternion) any.set_quaternion(*state.quaternion);
  if (state.matrix) any.set_matrix(*state.matrix);
  if (state.euler) any.set_euler_angles(*state.euler, state.euler_unit);
  return any.attitude(p);
}

scene_motion::scene_motion(const scene& what, precision p)
    : unit_(what.time_unit.size * what.state->momentum_size / what.body.size),
      p_(p),
      state_(state_of(what)) {
  // |omega| <= |J|/I_z, so that |dJ/dt| = |J x omega| <= |J| |omega|, and an entry of dR/dt = R [omega]x is at most |omega|.
  const ball size = sqrt(ball(state_.squared_momentum(), 64));
  const ball fastest = size / (*what.body.moments)[2];
  momentum_speed_ = (size * fastest).magnitude_upper();
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
