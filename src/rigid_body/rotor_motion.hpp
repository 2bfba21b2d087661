#pragma once

// The motion behind a rotor of balls or of mpfr_floats.

#include <utility>

#include "rigid_body/rotor_prepared.hpp"

namespace polhode::detail {

inline constexpr precision guard_bits = 64;
/// More bits of the rates: for times of up to so many periods that nothing is computed anew.
inline constexpr precision spare_bits = 128;

[[nodiscard]] inline bool is_accurate(const rotor_sample<ball>& x, const prepared<ball>& by,
                                      precision p) {
  const magnitude size = by.size.magnitude_lower();
  bool good = true;
  triple<magnitude> moments;
  moments.fill(by.moments[2].magnitude_upper());
  for (std::size_t i = 0; i < 3 && by.along; ++i)
    moments[index(by.along->order[i])] = by.moments[i].magnitude_upper();
  for (std::size_t i = 0; i < 3; ++i) {
    good = good && within(x.momentum[i], size, p) &&
           within(x.angular_velocity[i], divide_down(size, moments[i]), p);
  }
  return good;
}
[[nodiscard]] inline bool is_accurate(const rotor_attitude<ball>& x, const prepared<ball>&,
                                      precision p) {
  bool good = within(x.matrix, p);
  for (const ball& one : x.direction) good = good && within(one, magnitude::power_of_two(0), p);
  return good;
}
template <class Result>
[[nodiscard]] bool is_accurate(const Result&, const prepared<mpfr_float>&, precision) {
  return true;
}

template <class T>
class rotor_motion {
 public:
  rotor_motion(initial_state state, precision p)
      : state_(std::move(state)), p_(checked_precision(p)), first_(made(guard_bits)) {}

  template <class F>
  [[nodiscard]] auto evaluated(const rational& t, const F& f) const {
    const auto at = [&](const prepared<T>& by) {
      return f(by, as_scalars<T>(reduced(state_, by.rates, t, by.bits), by.bits));
    };
    auto result = at(first_);
    precision guard = guard_bits;
    for (int i = 0; i < most_attempts && !is_accurate(result, first_, p_); ++i) {
      guard *= 4;
      result = at(made(guard));
    }
    return result;
  }
  [[nodiscard]] rotor_sample<T> sample(const rational& t) const {
    return evaluated(t, [](const prepared<T>& by, const moment<T>& at) { return by.sample(at); });
  }
  [[nodiscard]] rotor_attitude<T> attitude(const rational& t) const {
    return evaluated(t, [](const prepared<T>& by, const moment<T>& at) { return by.attitude(at); });
  }
  [[nodiscard]] const initial_state& state() const { return state_; }
  [[nodiscard]] T size() const { return first_.size; }
  [[nodiscard]] const rotor_rates& rates() const { return first_.rates; }
  [[nodiscard]] T number(const ball& x) const { return as_scalar<T>(x, first_.bits); }
  [[nodiscard]] const prepared<T>& prepared_first() const { return first_; }
  [[nodiscard]] const work_count& work() const { return first_.work; }

 private:
  [[nodiscard]] prepared<T> made(precision guard) const {
    prepared<ball> result = prepare_to(state_, p_, guard, spare_bits);
    if constexpr (std::same_as<T, ball>) {
      return result;
    } else {
      return as_scalars<T>(result);
    }
  }

  initial_state state_;
  precision p_;
  prepared<T> first_;
};

}  // namespace polhode::detail
