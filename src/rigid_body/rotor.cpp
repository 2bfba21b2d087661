#include "polhode/rigid_body/rotor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "rigid_body/rotor_tables.hpp"

namespace polhode {
namespace detail {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// ---------------------------------------------------------------------------------------------
// From balls to the scalars

template <class T>
T as_scalar(const ball& x, precision bits);
template <>
ball as_scalar<ball>(const ball& x, precision bits) {
  return x.with_precision(bits);
}
template <>
mpfr_float as_scalar<mpfr_float>(const ball& x, precision bits) {
  return midpoint(x.with_precision(bits));
}
template <>
long double as_scalar<long double>(const ball& x, precision) {
  return mpfr_get_ld(midpoint(x).backend().data(), MPFR_RNDN);
}

template <>
double as_scalar<double>(const ball& x, precision) {
  return mpfr_get_d(midpoint(x).backend().data(), MPFR_RNDN);
}

template <class T>
triple<T> as_scalars(const triple<ball>& x, precision bits) {
  return {as_scalar<T>(x[0], bits), as_scalar<T>(x[1], bits), as_scalar<T>(x[2], bits)};
}
template <class T>
matrix3<T> as_scalars(const matrix3<ball>& x, precision bits) {
  return {as_scalars<T>(x[0], bits), as_scalars<T>(x[1], bits), as_scalars<T>(x[2], bits)};
}
template <class T>
std::vector<T> as_scalars(const std::vector<ball>& x, precision bits) {
  std::vector<T> result;
  result.reserve(x.size());
  for (const ball& one : x) result.push_back(as_scalar<T>(one, bits));
  return result;
}
template <class T>
theta_series<T> as_scalars(const theta_series<ball>& x, precision bits) {
  theta_series<T> r;
  r.hyperbolic = x.hyperbolic;
  r.scale = as_scalar<T>(x.scale, bits);
  r.nome = as_scalar<T>(x.nome, bits);
  r.odd = as_scalars<T>(x.odd, bits);
  r.even = as_scalars<T>(x.even, bits);
  r.lag_sine = as_scalars<T>(x.lag_sine, bits);
  r.lag_cosine = as_scalars<T>(x.lag_cosine, bits);
  r.odd_tail = x.odd_tail;
  r.even_tail = x.even_tail;
  r.lag_sine_tail = x.lag_sine_tail;
  r.lag_cosine_tail = x.lag_cosine_tail;
  return r;
}

// ---------------------------------------------------------------------------------------------
// Time reduced

/// The moment t: u = 2K(N + cycle), on the separatrix u = cycle; turns t - slip N = whole + fraction with |fraction| <= 1/2.
template <class T>
struct moment {
  T cycle;
  bool odd = false;  // N
  T whole;
  T fraction;
};

/// x - n, n the integer nearest to the middle of x.
std::pair<ball, integer> without_whole(const ball& x) {
  integer n;
  mpfr_get_z(n.backend().data(), midpoint(x).backend().data(), MPFR_RNDN);
  return {x - n, n};
}

/// Hypothesis: the rates have so many bits more than `bits` as |cycles t|, |turns t| have before the point.
moment<ball> reduced(const rotor_rates& rates, regime kind, const rational& t, precision bits) {
  const precision all = rates.turns.precision();
  const ball time(t, all);
  moment<ball> r;
  integer n = 0;
  if (is_equilibrium(kind)) {
    r.cycle = ball(0, bits);
  } else {
    ball cycles = rates.cycles * time + rates.cycles_0;
    if (kind != regime::separatrix) std::tie(cycles, n) = without_whole(cycles);
    n += rates.half_turns_0;
    r.cycle = cycles.with_precision(bits);
  }
  r.odd = mpz_odd_p(n.backend().data()) != 0;
  const auto [fraction, whole] = without_whole(rates.turns * time - rates.slip * n);
  r.whole = ball(whole, all);
  r.fraction = fraction.with_precision(bits);
  return r;
}

constexpr std::int64_t most_bits_before_point = std::int64_t{1} << 24;

/// About how many bits x has before the point.
std::int64_t bits_of(const ball& x) { return std::max<std::int64_t>(exponent_of(x) + 1, 0); }

// ---------------------------------------------------------------------------------------------
// The frame

template <class T>
T negated_if(bool negative, const T& x) {
  return negative ? T(-x) : x;
}

/// J/|J| in the principal axes, x and y over `across` of prepared.
template <class T>
triple<T> direction(const triple<T>& amplitude, regime kind, const theta_point<T>& at, bool odd) {
  const bool oscillating = kind == regime::oscillating;
  const T cn = negated_if(odd, at.cn);
  const T sn = negated_if(odd, at.sn);
  return {T(amplitude[0] * (oscillating ? at.dn : cn)), T(amplitude[1] * sn),
          T(amplitude[2] * (oscillating ? cn : at.dn))};
}

[[nodiscard]] bool is_zero_number(const ball& x) { return x.is_exact() && contains_zero(x); }
[[nodiscard]] bool is_zero_number(const mpfr_float& x) { return sign_in(x) == 0; }
[[nodiscard]] bool is_zero_number(long double x) { return sign_in(x) == 0; }

/// {x, y} over their length, and {0, 1} where both are 0: there a long double has nothing left of them.
template <class T>
std::array<T, 2> unit_vector(T x, T y) {
  if constexpr (std::floating_point<T>) {
    // Squares must not be lost.
    constexpr T tiny = std::numeric_limits<T>::min() /
                       (std::numeric_limits<T>::epsilon() * std::numeric_limits<T>::epsilon());
    if (square_of(x) + square_of(y) < tiny) {
      const T greatest = std::max(std::abs(x), std::abs(y));
      if (!(greatest > 0)) return {0, 1};
      x /= greatest;
      y /= greatest;
    }
  }
  const T length = T(1 / root_of(T(square_of(x) + square_of(y))));
  return {T(x * length), T(y * length)};
}

/// R_z(Phi) R_y(theta) R_z(psi), which takes principal axes to axes of which the third is along J; Phi = angle - atan2(x, y).
/// J/|J| is (across j_0, across j_1, j_2).
template <class T>
matrix3<T> frame(const triple<T>& j, const T& across, const std::pair<T, T>& angle, const T& x,
                 const T& y) {
  const auto [sx, cx] = unit_vector(x, y);
  const auto& [s, c] = angle;
  const T cos_phi = T(c * cx + s * sx);
  const T sin_phi = T(s * cx - c * sx);
  T cos_psi = whole<T>(1, bits_in(x));
  T sin_psi = whole<T>(0, bits_in(x));
  T sin_theta = sin_psi;
  if (!is_zero_number(j[0]) || !is_zero_number(j[1])) {
    sin_theta = T(across * root_of(T(square_of(j[0]) + square_of(j[1]))));
    const auto [sine, cosine] = unit_vector(j[1], T(-j[0]));
    sin_psi = sine;
    cos_psi = cosine;
  }
  const T first = T(j[2] * cos_psi);
  const T second = T(-j[2] * sin_psi);
  return {{{T(cos_phi * first - sin_phi * sin_psi), T(cos_phi * second - sin_phi * cos_psi),
            T(cos_phi * sin_theta)},
           {T(sin_phi * first + cos_phi * sin_psi), T(sin_phi * second + cos_phi * cos_psi),
            T(sin_phi * sin_theta)},
           {T(across * j[0]), T(across * j[1]), j[2]}}};
}

template <class T>
T dot(const triple<T>& x, const triple<T>& y) {
  return T(x[0] * y[0] + x[1] * y[1] + x[2] * y[2]);
}
template <class T>
T dot(const triple<T>& x, const matrix3<T>& m, std::size_t column) {
  return T(x[0] * m[0][column] + x[1] * m[1][column] + x[2] * m[2][column]);
}

/// sin and cos of 2 pi times the fraction.
template <class T>
std::pair<T, T> of_turns(const T& fraction) {
  return sine_cosine(T(scaled(pi_of<T>(bits_in(fraction)), 1) * fraction));
}

template <class T>
theta_point<T> steady_point(precision bits) {
  const T zero = constant<T>(0, bits);
  return {zero, zero, zero, zero, constant<T>(1, bits)};
}

/// What does not depend on time, at `bits` bits; rates with `spare` more.
template <class T>
struct prepared {
  precision bits = 0;
  regime kind = regime::equilibrium_x;
  rotor_rates rates;
  theta_series<T> series;
  /// That of rotor_tables, the first two over the power of two `across`: J may be so near to the axis z that its other
  /// components are 0 for a long double, but their ratio is needed.
  triple<T> amplitude;
  T across;
  T size;
  triple<T> moments;
  triple<int> order;
  triple<int> signs;
  /// R = base * frame * (principal axes from body axes).
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
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t axis = index(order[i]);
      r.momentum[axis] = T(size * negated_if(signs[i] < 0, j[i]));
      r.angular_velocity[axis] = T(r.momentum[axis] / moments[axis]);
    }
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
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t row = 0; row < 3; ++row) {
        r.matrix[row][index(order[i])] = negated_if(signs[i] < 0, dot(base[row], turned, i));
      }
    }
    return r;
  }
};

prepared<ball> prepare(const initial_state& state, precision bits, precision spare) {
  prepared<ball> r;
  r.bits = bits;
  r.kind = state.regime();
  r.order = state.order();
  r.signs = state.signs();
  rotor_tables tables(state, bits + spare);
  r.rates = std::move(tables.rates);
  rotor_tables working(state, bits);
  r.work = tables.work;
  r.work += working.work;
  r.series = std::move(working.series);
  r.amplitude = std::move(working.amplitude);
  r.across = ball(1, bits);
  if (!is_equilibrium(r.kind)) {
    const auto power =
        static_cast<long>(std::max(exponent_of(r.amplitude[0]), exponent_of(r.amplitude[1])));
    r.across = scale(r.across, power);
    r.amplitude[0] = scale(r.amplitude[0], -power);
    r.amplitude[1] = scale(r.amplitude[1], -power);
  }
  r.size = std::move(working.size);
  for (std::size_t i = 0; i < 3; ++i) r.moments[i] = ball(state.moments()[i], bits);

  const moment<ball> start = reduced(r.rates, r.kind, 0, bits);
  const theta_point<ball> at = r.point<true>(start.cycle);
  r.phase_0 = scale(pi(bits), 1) * (start.whole + start.fraction) - angle_of(at.x, at.y);
  const matrix3<ball> turned =
      frame(r.direction_at(at, start.odd), r.across, of_turns(start.fraction), at.x, at.y);
  const matrix3<ball> given = state.attitude(bits);
  for (std::size_t row = 0; row < 3; ++row) {
    triple<ball> principal;
    for (std::size_t i = 0; i < 3; ++i) {
      principal[i] = given[row][index(r.order[i])] * r.signs[i];
    }
    for (std::size_t i = 0; i < 3; ++i) r.base[row][i] = dot(principal, turned[i]);
  }
  return r;
}

/// Whether every radius is at most 2^-p of the size.
bool within(const ball& x, const magnitude& size, precision p) {
  return x.is_bounded() && x.radius() <= scale(size, -p);
}
bool within(const matrix3<ball>& x, precision p) {
  bool good = true;
  for (const auto& row : x) {
    for (const ball& entry : row) good = good && within(entry, magnitude::power_of_two(0), p);
  }
  return good;
}

constexpr int most_attempts = 6;

/// With so many bits beside p, or with more where the start is so near to an axis that it needs them.
prepared<ball> prepare_to(const initial_state& state, precision p, precision guard,
                          precision spare) {
  prepared<ball> result = prepare(state, p + guard, spare);
  for (int i = 0; i < most_attempts && !within(result.base, p + 16); ++i) {
    guard *= 4;
    const work_count before = result.work;
    result = prepare(state, p + guard, spare);
    result.work += before;
  }
  return result;
}

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
  r.order = x.order;
  r.signs = x.signs;
  r.base = as_scalars<T>(x.base, bits);
  r.phase_0 = as_scalar<T>(x.phase_0, bits);
  r.work = x.work;
  return r;
}

// ---------------------------------------------------------------------------------------------
// Balls and mpfr_float

constexpr precision guard_bits = 64;
/// More bits of the rates: for times of up to so many periods that nothing is computed anew.
constexpr precision spare_bits = 128;

bool is_accurate(const rotor_sample<ball>& x, const prepared<ball>& by, precision p) {
  const magnitude size = by.size.magnitude_lower();
  bool good = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const magnitude moment = by.moments[i].magnitude_upper();
    good = good && within(x.momentum[i], size, p) &&
           within(x.angular_velocity[i], divide_down(size, moment), p);
  }
  return good;
}
bool is_accurate(const rotor_attitude<ball>& x, const prepared<ball>&, precision p) {
  bool good = within(x.matrix, p);
  for (const ball& one : x.direction) good = good && within(one, magnitude::power_of_two(0), p);
  return good;
}
template <class Result>
bool is_accurate(const Result&, const prepared<mpfr_float>&, precision) {
  return true;
}

moment<ball> reduced(const initial_state& state, const rotor_rates& rates, const rational& t,
                     precision bits) {
  const ball time(t, 64);
  const std::int64_t needed =
      std::max(bits_of(rates.cycles * time), bits_of(rates.turns * time)) + 8;
  // Where a time has more bits than these before the point, the result is as wide as it is.
  if (bits + needed <= rates.turns.precision() || needed > most_bits_before_point) {
    return reduced(rates, state.regime(), t, bits);
  }
  const rotor_tables more(state, bits + static_cast<precision>(needed) + 8);
  return reduced(more.rates, state.regime(), t, bits);
}

template <class T>
moment<T> as_scalars(const moment<ball>& x, precision bits) {
  return {as_scalar<T>(x.cycle, bits), x.odd, as_scalar<T>(x.whole, x.whole.precision()),
          as_scalar<T>(x.fraction, bits)};
}

}  // namespace

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

// ---------------------------------------------------------------------------------------------
// double

namespace {

/// A number as the sum of three doubles, to some 159 bits.
struct three_doubles {
  double high = 0;
  double middle = 0;
  double low = 0;
};
three_doubles split(const ball& x) {
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

/// a + b, exactly result + what is added to error (D. E. Knuth, The Art of Computer Programming 2, 4.2.2, Theorem B).
double sum_with_error(double a, double b, double& error) {
  const double sum = a + b;
  const double part = sum - a;
  error += (a - (sum - part)) + (b - part);
  return sum;
}

/// n x + start for |n x| < 2^50, to some 2^-105 (1 + |n x|).
whole_and_rest product(double n, const three_doubles& x, const three_doubles& start) {
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

rotor_sample<double> rounded(const rotor_sample<long double>& x) {
  rotor_sample<double> r;
  for (std::size_t i = 0; i < 3; ++i) {
    r.momentum[i] = static_cast<double>(x.momentum[i]);
    r.angular_velocity[i] = static_cast<double>(x.angular_velocity[i]);
  }
  return r;
}
rotor_attitude<double> rounded(const rotor_attitude<long double>& x) {
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

}  // namespace

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
    // With L = log(1/p), what n = 1 adds is at most 4 r e^-v <= 4 e^(-L/2), and less further on: nothing for a (long) double, whose exponents
    // end before p does.
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

}  // namespace detail

// ---------------------------------------------------------------------------------------------
// Forms of an attitude

namespace {

double square_root(double x) { return std::sqrt(x); }
template <class T>
T square_root(const T& x) {
  return detail::root_of(x);
}
double arc(double y, double x) { return std::atan2(y, x); }
mpfr_float arc(const mpfr_float& y, const mpfr_float& x) { return detail::angle_of(y, x); }
ball arc(const ball& y, const ball& x) {
  const ball angle = detail::angle_of(y, x);
  const ball half = pi(angle.precision());
  return certainly_less(half, angle) ? angle - 2 * half : angle;
}
bool is_origin(double x, double y) {
  return x == 0 && y == 0;
}  // NOLINT: the numbers that they are
template <class T>
bool is_origin(const T& x, const T& y) {
  return detail::is_zero_number(x) && detail::is_zero_number(y);
}
mpfr_float middle_of(const ball& x) { return midpoint(x); }
template <class T>
const T& middle_of(const T& x) {
  return x;
}

}  // namespace

template <class T>
std::array<T, 4> rotor_attitude<T>::quaternion() const {
  const auto& m = matrix;
  // Four times the squares of w, x, y, z, of which the greatest is at least 1 (S. W. Shepperd, J. Guidance and Control 1, 1978).
  const std::array<T, 4> squares{
      T(1 + m[0][0] + m[1][1] + m[2][2]), T(1 + m[0][0] - m[1][1] - m[2][2]),
      T(1 - m[0][0] + m[1][1] - m[2][2]), T(1 - m[0][0] - m[1][1] + m[2][2])};
  std::size_t k = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (middle_of(squares[k]) < middle_of(squares[i])) k = i;
  }
  const T root = square_root(squares[k]);  // twice the greatest
  const T factor = T(1 / (2 * root));
  const auto sum = [&](std::size_t i, std::size_t j) { return T((m[i][j] + m[j][i]) * factor); };
  const auto difference = [&](std::size_t i, std::size_t j) {
    return T((m[i][j] - m[j][i]) * factor);
  };
  const T itself = T(root / 2);
  switch (k) {
    case 0:
      return {itself, difference(2, 1), difference(0, 2), difference(1, 0)};
    case 1:
      return {difference(2, 1), itself, sum(0, 1), sum(0, 2)};
    case 2:
      return {difference(0, 2), sum(0, 1), itself, sum(1, 2)};
    default:
      return {difference(1, 0), sum(0, 2), sum(1, 2), itself};
  }
}

template <class T>
rotor_angles<T> rotor_attitude<T>::angles() const {
  const auto& [x, y, z] = direction;
  T psi = T(x - x);
  T sine = psi;
  if (!is_origin(across[0], across[1])) {
    sine = square_root(T(x * x + y * y));
    psi = arc(across[1], T(-across[0]));
  }
  return {T(phase - arc(lag[0], lag[1])), arc(sine, z), std::move(psi)};
}

// ---------------------------------------------------------------------------------------------
// The front

template <class T>
rotor<T>::rotor(const initial_state& state, precision p)
    : motion_(std::make_shared<const detail::rotor_motion<T>>(state, p)) {}

template <class T>
rotor_sample<T> rotor<T>::sample(const rational& t) const {
  return motion_->sample(t);
}
template <class T>
rotor_attitude<T> rotor<T>::attitude(const rational& t) const {
  return motion_->attitude(t);
}
template <class T>
rotor_sample<T> rotor<T>::sample(double t) const requires std::same_as<T, double> {
  return motion_->sample(t);
}
template <class T>
rotor_attitude<T> rotor<T>::attitude(double t) const requires std::same_as<T, double> {
  return motion_->attitude(t);
}
template <class T>
const initial_state& rotor<T>::state() const {
  return motion_->state();
}
template <class T>
const work_count& rotor<T>::work() const {
  return motion_->work();
}
template <class T>
T rotor<T>::momentum_size() const {
  return motion_->size();
}

namespace {

/// turns T - 2 slip, T = 2/cycles, times 2 pi.
ball phase_of(const detail::rotor_rates& rates) {
  const ball turns = scale(rates.turns / rates.cycles - rates.slip, 1);
  return 2 * pi(turns.precision()) * turns;
}

}  // namespace

template <class T>
std::optional<T> rotor<T>::period() const {
  if (!is_periodic(state().regime())) return std::nullopt;
  return motion_->number(2 / motion_->rates().cycles);
}
template <class T>
std::optional<T> rotor<T>::phase_per_period() const {
  if (!is_periodic(state().regime())) return std::nullopt;
  return motion_->number(phase_of(motion_->rates()));
}
template <class T>
T rotor<T>::mean_precession() const {
  const detail::rotor_rates& rates = motion_->rates();
  if (is_periodic(state().regime())) return motion_->number(phase_of(rates) * rates.cycles / 2);
  if (is_equilibrium(state().regime())) {
    return motion_->number(2 * pi(rates.turns.precision()) * rates.turns);
  }
  const auto middle = static_cast<std::size_t>(state().order()[1]);
  const rational square(state().squared_momentum() /
                        (state().moments()[middle] * state().moments()[middle]));
  return motion_->number(sqrt(ball(square, rates.turns.precision())));
}

template struct rotor_attitude<ball>;
template struct rotor_attitude<mpfr_float>;
template struct rotor_attitude<double>;
template class rotor<ball>;
template class rotor<mpfr_float>;
template class rotor<double>;

}  // namespace polhode
