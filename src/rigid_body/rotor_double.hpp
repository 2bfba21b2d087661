#pragma once

// The motion behind a rotor of doubles. Times are reduced by sums of three doubles; beyond 2^50
// periods, by balls.

#include <cmath>
#include <string>
#include <utility>

#include "rigid_body/rotor_motion.hpp"

namespace polhode::detail {

/// A number as the sum of three doubles, to some 159 bits.
struct three_doubles {
  double high = 0;
  double middle = 0;
  double low = 0;
};
[[nodiscard]] inline three_doubles split(const ball& x) {
  mpfr_float rest = midpoint(x);
  const auto next = [&rest] {
    const double part = mpfr_get_d(rest.backend().data(), MPFR_RNDN);
    mpfr_sub_d(rest.backend().data(), rest.backend().data(), part, MPFR_RNDN);
    return part;
  };
  three_doubles r;
  r.high = next();
  r.middle = next();
  r.low = next();
  return r;
}

/// whole + rest + error, |rest| at most about 1/2 and error small beside 1.
struct whole_and_rest {
  double whole = 0;
  double rest = 0;
  double error = 0;
};

/// a + b, exactly result + what is added to error (D. E. Knuth, The Art of Computer Programming 2,
/// 4.2.2, Theorem B).
inline double sum_with_error(double a, double b, double& error) {
  const double sum = a + b;
  const double part = sum - a;
  error += (a - (sum - part)) + (b - part);
  return sum;
}

/// n x + start for |n x| < 2^50, to some 2^-105 (1 + |n x|).
[[nodiscard]] inline whole_and_rest product(double n, const three_doubles& x,
                                            const three_doubles& start) {
  const double main = n * x.high;
  const double main_error = std::fma(n, x.high, -main);
  const double nearest = std::nearbyint(main);
  double error = n * x.low + start.low;
  double sum = main - nearest;
  sum = sum_with_error(sum, start.high, error);
  sum = sum_with_error(sum, main_error, error);
  sum = sum_with_error(sum, n * x.middle, error);
  sum = sum_with_error(sum, start.middle, error);
  const double more = std::nearbyint(sum);
  return {nearest + more, sum - more, error};
}

template <std::floating_point T>
T rest_of(const whole_and_rest& x) {
  return static_cast<T>(x.rest) + static_cast<T>(x.error);
}

[[nodiscard]] inline rotor_sample<double> rounded(const rotor_sample<long double>& x) {
  rotor_sample<double> r;
  for (std::size_t i = 0; i < 3; ++i) {
    r.momentum[i] = static_cast<double>(x.momentum[i]);
    r.angular_velocity[i] = static_cast<double>(x.angular_velocity[i]);
  }
  return r;
}
[[nodiscard]] inline rotor_attitude<double> rounded(const rotor_attitude<long double>& x) {
  rotor_attitude<double> r;
  for (std::size_t i = 0; i < 3; ++i) {
    r.direction[i] = static_cast<double>(x.direction[i]);
    for (std::size_t j = 0; j < 3; ++j) r.matrix[i][j] = static_cast<double>(x.matrix[i][j]);
  }
  r.phase = static_cast<double>(x.phase);
  r.across = {static_cast<double>(x.across[0]), static_cast<double>(x.across[1])};
  r.lag = {static_cast<double>(x.lag[0]), static_cast<double>(x.lag[1])};
  return r;
}
template <class T>
void first_only(theta_series<T>& series) {
  for (auto* terms : {&series.odd, &series.even, &series.lag_sine, &series.lag_cosine}) {
    terms->resize(1);
  }
}

template <>
class rotor_motion<double> {
 public:
  rotor_motion(initial_state state, precision) : exact_(std::move(state), exact_bits) {
    const prepared<ball>& by = exact_.prepared_first();
    fast_ = as_scalars<long double>(by);
    momentum_ = as_scalars<double>(by);
    if (!is_equilibrium(by.kind)) {
      cycles_ = split(by.rates.cycles);
      cycles_0_ = split(by.rates.cycles_0);
      slip_ = split(by.rates.slip);
      half_turns_0_ = static_cast<double>(by.rates.half_turns_0);
    }
    turns_ = split(by.rates.turns);
    // With L = log(1/p), what n = 1 adds is at most 4 r e^-v <= 4 e^(-L/2), and less further on:
    // nothing for a (long) double, whose exponents end before p does.
    constexpr long double enough = 300;
    if (fast_.series.hyperbolic && fast_.series.scale > enough) {
      first_only(fast_.series);
      first_only(momentum_.series);
    }
  }

 private:
  template <class F>
  [[nodiscard]] auto evaluated(const rational& t, const F& f) const {
    const prepared<ball>& by = exact_.prepared_first();
    const moment<ball> at = reduced(exact_.state(), by.rates, t, by.bits);
    return rounded(f(fast_, as_scalars<long double>(at, by.bits)));
  }

 public:
  [[nodiscard]] rotor_sample<double> sample(const rational& t) const {
    return evaluated(t, [](const auto& by, const auto& at) { return by.sample(at); });
  }
  [[nodiscard]] rotor_attitude<double> attitude(const rational& t) const {
    return evaluated(t, [](const auto& by, const auto& at) { return by.attitude(at); });
  }
  [[nodiscard]] rotor_sample<double> sample(double t) const {
    if (!is_near(t)) return sample(rational(t));
    return momentum_.sample(cycle_at<double>(t).first);
  }
  [[nodiscard]] rotor_attitude<double> attitude(double t) const {
    if (!is_near(t)) return attitude(rational(t));
    auto [at, whole] = cycle_at<long double>(t);
    const whole_and_rest turned = product(t, turns_, {});
    const whole_and_rest slipped = product(whole, slip_, {});
    const long double rest = rest_of<long double>(turned) - rest_of<long double>(slipped);
    const double more = std::nearbyint(static_cast<double>(rest));
    at.fraction = rest - static_cast<long double>(more);
    at.whole = static_cast<long double>((turned.whole - slipped.whole) + more);
    return rounded(fast_.attitude(at));
  }
  [[nodiscard]] const initial_state& state() const { return exact_.state(); }
  [[nodiscard]] double size() const { return number(exact_.size()); }
  [[nodiscard]] const rotor_rates& rates() const { return exact_.rates(); }
  [[nodiscard]] const work_count& work() const { return exact_.work(); }
  [[nodiscard]] static double number(const ball& x) {
    return mpfr_get_d(midpoint(x).backend().data(), MPFR_RNDN);
  }

 private:
  /// Throws input_error where t is not finite. Whether t is reduced here, and not by balls.
  [[nodiscard]] bool is_near(double t) const {
    if (!std::isfinite(t)) {
      throw input_error("time " + std::to_string(t) + ": it must be a finite number");
    }
    constexpr double most = 0x1p50;
    return std::abs(t * turns_.high) < most && std::abs(t * cycles_.high) < most;
  }
  /// The cycle, and the integer N.
  template <std::floating_point T>
  [[nodiscard]] std::pair<moment<T>, double> cycle_at(double t) const {
    moment<T> at{};
    if (is_equilibrium(fast_.kind)) return {at, 0};
    const whole_and_rest u = product(t, cycles_, cycles_0_);
    if (fast_.kind == regime::separatrix) {
      at.cycle = static_cast<T>(u.whole) + rest_of<T>(u);
      return {at, 0};
    }
    at.cycle = rest_of<T>(u);
    const double whole = u.whole + half_turns_0_;
    at.odd = (static_cast<std::int64_t>(whole) & 1) != 0;
    return {at, whole};
  }

  static constexpr precision exact_bits = 64;
  rotor_motion<ball> exact_;
  prepared<long double> fast_;
  prepared<double> momentum_;
  three_doubles cycles_, cycles_0_, turns_, slip_;
  double half_turns_0_ = 0;
};

}  // namespace polhode::detail
