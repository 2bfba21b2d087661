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
  /// In the body axes.
  triple<rational> momentum;
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
    const rational& a = s.motion().a().exact();
    const rational& b = s.motion().b().exact();
    if (a != 0 && b != 0) {
      const triple<int> order = s.along_body_axes()->order;
      const auto x = static_cast<std::size_t>(order[0]);
      const auto z = static_cast<std::size_t>(order[2]);
      j[z] = sense() * j[x] * root_near(rational(b / a), 4200) *
             (1 + sense() * any_small(random, most_power));
    }
  }
  any_state result{initial_state::from_momentum(moments, j), kind, j};
  if (random.one_in(2)) {
    result.state.set_quaternion({random.between(-9, 9), random.between(-9, 9),
                                 random.between(-9, 9), rational(random.between(1, 9))});
  }
  return result;
}

/// A positive definite tensor, xx, yy, zz, xy, xz, yz: principal moments that are three irrational
/// numbers, or one rational one and two irrational ones, nearly equal or very different, or all
/// three rational about turned axes, two of them equal now and then.
inline std::array<rational, 6> random_tensor(random_source& random, long most_power) {
  using matrix = std::array<std::array<rational, 3>, 3>;
  const auto entry = [&] { return rational(random.between(-9, 9), random.between(1, 9)); };
  // A^T A and a little more.
  matrix a{};
  for (auto& row : a) {
    for (rational& one : row) one = entry();
  }
  const long kind = random.between(0, 4);
  if (kind == 1) {  // one axis is that of z
    a[0][2] = a[1][2] = a[2][0] = a[2][1] = 0;
  } else if (kind == 2) {  // one axis is along (1, 2, 2)
    for (auto& row : a) row[0] = -2 * (row[1] + row[2]);
  }
  matrix t{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < 3; ++l) t[i][k] += a[l][i] * a[l][k];
    }
  }
  if (kind == 3) {  // symmetric, or nearly so
    const triple<rational> n{entry(), entry(), rational(random.between(1, 9))};
    const rational disturbed = random.one_in(2) ? rational(0) : any_small(random, most_power);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) t[i][k] = n[i] * n[k] + disturbed * t[i][k];
    }
  } else if (kind == 4) {  // nearly diagonal
    const rational disturbed = any_small(random, most_power);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        t[i][k] = disturbed * t[i][k] + (i == k ? rational(random.between(1, 5)) : rational(0));
      }
    }
  }
  const rational more(random.between(1, 99), random.between(1, 99));
  const rational size = random.one_in(4) ? power_of_ten(random.between(-300, 300)) : rational(1);
  return {rational((t[0][0] + more) * size), rational((t[1][1] + more) * size),
          rational((t[2][2] + more) * size), rational(t[0][1] * size),
          rational(t[0][2] * size),          rational(t[1][2] * size)};
}

/// A body by such a tensor, its momentum along no axis, near one, or exactly along a rational one.
inline any_state random_tensor_state(random_source& random, long most_power) {
  const auto tensor =
      std::make_shared<const principal_axes>(random_tensor(random, std::min(most_power, 20L)));
  triple<rational> j{random.between(-9, 9), random.between(-9, 9), random.between(1, 9)};
  const char* kind = "tensor";
  if (random.one_in(2)) {
    kind = "tensor, near an axis";
    const auto axis = static_cast<std::size_t>(random.between(0, 2));
    const triple<ball> v = tensor->axis(axis, 64 + 4 * most_power);
    const rational off = any_small(random, most_power);
    for (std::size_t i = 0; i < 3; ++i) j[i] = lower_rational(v[i].middle()) + j[i] * off;
  } else if (random.one_in(8)) {
    kind = "tensor, along z or (1, 2, 2)";
    j = random.one_in(2) ? triple<rational>{0, 0, 1} : triple<rational>{1, 2, 2};
  }
  any_state result{initial_state::from_tensor(tensor, j), kind, j};
  if (random.one_in(2)) {
    result.state.set_quaternion({random.between(-9, 9), random.between(-9, 9),
                                 random.between(-9, 9), rational(random.between(1, 9))});
  }
  return result;
}

inline any_state random_motion(random_source& random, long most_power) {
  return random.one_in(2) ? random_state(random, most_power)
                          : random_tensor_state(random, most_power);
}

}  // namespace polhode::support
