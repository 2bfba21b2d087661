#pragma once

// What a rotation needs at every time, in the scalars of the samples; and from it a sample at a
// reduced time.

#include <optional>

#include "rigid_body/rotor_frame.hpp"
#include "rigid_body/rotor_time.hpp"

namespace polhode::detail {

[[nodiscard]] inline std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// What does not depend on time, at `bits` bits; rates with `spare` more.
template <class T>
struct prepared {
  precision bits = 0;
  regime kind = regime::equilibrium_x;
  rotor_rates rates;
  theta_series<T> series;
  /// That of rotor_tables, the first two over the power of two `across`: J may be so near to the
  /// axis z that its other components are 0 for a long double, but their ratio is needed.
  triple<T> amplitude;
  T across;
  T size;
  /// The principal ones; and the principal axes in the body axes, by rows, where they are not along
  /// them.
  triple<T> moments;
  std::optional<axis_order> along;
  matrix3<T> axes;
  /// R = base * frame * (from body axes to principal axes).
  matrix3<T> base;
  /// Phi at time 0.
  T phase_0;
  work_count work;

  template <bool WithLag>
  [[nodiscard]] theta_point<T> point(const T& cycle) const {
    if (is_equilibrium(kind)) return steady_point<T>(bits);
    return theta_values_at<WithLag>(series, cycle);
  }
  [[nodiscard]] triple<T> direction_at(const theta_point<T>& at, bool odd) const {
    return is_equilibrium(kind) ? amplitude : direction(amplitude, kind, at, odd);
  }
  [[nodiscard]] rotor_sample<T> sample(const moment<T>& at) const {
    triple<T> j = direction_at(point<false>(at.cycle), at.odd);
    j[0] = T(j[0] * across);
    j[1] = T(j[1] * across);
    rotor_sample<T> r;
    for (std::size_t i = 0; i < 3 && along; ++i) {
      const std::size_t axis = index(along->order[i]);
      r.momentum[axis] = T(size * negated_if(along->signs[i] < 0, j[i]));
      r.angular_velocity[axis] = T(r.momentum[axis] / moments[i]);
    }
    if (along) return r;
    for (T& one : j) one = T(size * one);
    r.momentum = in_body(j);
    for (std::size_t i = 0; i < 3; ++i) j[i] = T(j[i] / moments[i]);
    r.angular_velocity = in_body(j);
    return r;
  }
  [[nodiscard]] rotor_attitude<T> attitude(const moment<T>& at) const {
    const theta_point<T> p = point<true>(at.cycle);
    rotor_attitude<T> r;
    const triple<T> j = direction_at(p, at.odd);
    r.across = {j[0], j[1]};
    r.lag = {p.x, p.y};
    r.phase = T(scaled(pi_of<T>(bits_in(at.whole)), 1) * T(at.whole + at.fraction) - phase_0);
    const matrix3<T> turned = frame(j, across, of_turns(at.fraction), p.x, p.y);
    r.direction = turned[2];
    for (std::size_t row = 0; row < 3; ++row) {
      r.matrix[row] = in_body(
          {dot(base[row], turned, 0), dot(base[row], turned, 1), dot(base[row], turned, 2)});
    }
    return r;
  }
  /// From the principal axes to the body axes.
  [[nodiscard]] triple<T> in_body(const triple<T>& principal) const {
    if (!along) return {dot(principal, axes, 0), dot(principal, axes, 1), dot(principal, axes, 2)};
    triple<T> r;
    for (std::size_t i = 0; i < 3; ++i)
      r[index(along->order[i])] = negated_if(along->signs[i] < 0, principal[i]);
    return r;
  }
  /// From the body axes to the principal axes.
  [[nodiscard]] triple<T> in_principal(const triple<T>& body) const {
    triple<T> r;
    for (std::size_t i = 0; i < 3; ++i) {
      r[i] = along ? negated_if(along->signs[i] < 0, body[index(along->order[i])])
                   : dot(body, axes[i]);
    }
    return r;
  }
};

/// Whether the radius is at most 2^-p of the size, for all entries.
[[nodiscard]] bool within(const ball& x, const magnitude& size, precision p);
[[nodiscard]] bool within(const matrix3<ball>& x, precision p);

inline constexpr int most_attempts = 6;

/// With `guard` bits beside p, or with more, in most_attempts attempts, where the start is so near
/// to an axis that it needs them.
[[nodiscard]] prepared<ball> prepare_to(const initial_state& state, precision p, precision guard,
                                        precision spare);

template <class T>
prepared<T> as_scalars(const prepared<ball>& x) {
  const precision bits = x.bits;
  prepared<T> r;
  r.bits = bits;
  r.kind = x.kind;
  r.rates = x.rates;
  r.series = as_scalars<T>(x.series, bits);
  r.amplitude = as_scalars<T>(x.amplitude, bits);
  r.across = as_scalar<T>(x.across, bits);
  r.size = as_scalar<T>(x.size, bits);
  r.moments = as_scalars<T>(x.moments, bits);
  r.along = x.along;
  if (!r.along) r.axes = as_scalars<T>(x.axes, bits);
  r.base = as_scalars<T>(x.base, bits);
  r.phase_0 = as_scalar<T>(x.phase_0, bits);
  r.work = x.work;
  return r;
}

}  // namespace polhode::detail
