#pragma once

// Random bodies with random motions, the hard ones among them.

#include "polhode/rigid_body/rotor.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode::support {

inline rational any_small(random_source& random, long most_power) {
  return rational(random.between(1, 9)) * power_of_ten(-random.between(1, most_power));
}

/// An approximation from below to 2^-bits of the square root of q > 0, relatively.
inline rational root_near(const rational& q, unsigned bits) {
  const integer shift = integer(1) << (2 * bits);
  const integer radicand = integer(numerator(q)) * denominator(q) * shift;
  return rational(sqrt(radicand)) / rational(denominator(q) * (integer(1) << bits));
}

struct any_state {
  initial_state state;
  const char* kind;
};

/// most_power: how near to a special case, as a power of ten.
inline any_state random_state(random_source& random, long most_power) {
  const auto size = [&] { return rational(random.between(1, 999), random.between(1, 99)); };
  const auto sense = [&] { return random.one_in(2) ? 1 : -1; };
  triple<rational> moments{size(), size(), size()};
  if (random.one_in(4)) {  // nearly symmetric
    moments[1] = moments[0] * (1 + sense() * any_small(random, most_power));
  } else if (random.one_in(8)) {
    moments[1] = moments[0];
  } else if (random.one_in(16)) {  // nearly spherical
    moments[1] = moments[0] * (1 + any_small(random, most_power));
    moments[2] = moments[0] * (1 - any_small(random, most_power));
  }
  std::swap(moments[static_cast<std::size_t>(random.between(0, 2))],
            moments[static_cast<std::size_t>(random.between(0, 2))]);
  triple<rational> j{sense() * size(), sense() * size(), sense() * size()};
  const char* kind = "usual";
  if (random.one_in(3)) {  // near an axis
    kind = "near an axis";
    const auto axis = static_cast<std::size_t>(random.between(0, 2));
    for (std::size_t i = 0; i < 3; ++i) {
      if (i != axis) j[i] *= any_small(random, most_power);
    }
  } else if (random.one_in(2)) {  // near the separatrix: a J_z^2 = b J_x^2
    kind = "near the separatrix";
    const initial_state s = initial_state::from_momentum(moments, j);
    if (s.a() != 0 && s.b() != 0) {
      const auto x = static_cast<std::size_t>(s.order()[0]);
      const auto z = static_cast<std::size_t>(s.order()[2]);
      j[z] = sense() * j[x] * root_near(rational(s.b() / s.a()), 4200) *
             (1 + sense() * any_small(random, most_power));
    }
  }
  any_state result{initial_state::from_momentum(moments, j), kind};
  if (random.one_in(2)) {
    result.state.set_quaternion({random.between(-9, 9), random.between(-9, 9),
                                 random.between(-9, 9), rational(random.between(1, 9))});
  }
  return result;
}

}  // namespace polhode::support
