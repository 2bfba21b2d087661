#include "gamma_series.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include "arithmetic/ball/ball_access.hpp"
#include "bernoulli.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/double_interval.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/arithmetic/special_functions.hpp"
#include "reciprocal_gamma.hpp"
#include "rising_product.hpp"

namespace polhode::detail {

namespace gamma_series_impl {
namespace {

ball real_part(const ball& x) { return x; }
ball real_part(const complex_ball& z) { return z.re; }

/// x = x * y + z.
void multiply_and_add(ball& x, const ball& y, const ball& z) { fma(x, x, y, z); }
void multiply_and_add(complex_ball& x, const complex_ball& y, const ball& z) { x = x * y + z; }

ball reciprocal_of(const ball& x) { return 1 / x; }
complex_ball reciprocal_of(const complex_ball& z) { return reciprocal(z); }

double nearest(const ball& x) { return mpfr_get_d(midpoint(x).backend().data(), MPFR_RNDN); }
double imaginary(const ball&) { return 0; }
double imaginary(const complex_ball& z) { return nearest(z.im); }

// Where Stirling's series is summed, and how far: a choice, which decides nothing but the time.
struct plan {
  long steps = 0;         // n
  std::size_t terms = 1;  // N
  double log_size = 0;    // log2 |w|, about
};

/// About log2 |B_2k/(2k (2k - 1))|, by |B_2k| ~ 4 sqrt(pi k) (k/(pi e))^(2k) (DLMF 24.11.1).
double log_of_coefficient(std::size_t k) {
  thread_local std::vector<double> known{0};
  while (known.size() <= k) {
    const auto n = static_cast<double>(known.size());
    known.push_back(std::log2(4 * std::sqrt(std::numbers::pi * n)) +
                    2 * n * std::log2(n / (std::numbers::pi * std::numbers::e)) -
                    std::log2(2 * n * (2 * n - 1)));
  }
  return known[k];
}

plan plan_for(double re, double im, precision bits) {
  // Steps cost a product each, terms half of one: measured from 50 to 3,000 bits.
  constexpr double steps_per_bit = 0.14;
  const auto p = static_cast<double>(bits);
  const double least = steps_per_bit * p + 3;
  // |w| cos(a/2): the size that the bound of the remainder sees.
  const auto seen = [im](double x) {
    const double size = std::hypot(x, im);
    return std::sqrt(size * (size + x) / 2);
  };
  plan result;
  if (seen(re) < least) result.steps = std::max(0L, static_cast<long>(std::ceil(least - re)));
  const double x = re + static_cast<double>(result.steps);
  const double size = seen(x);
  result.log_size = std::log2(std::hypot(x, im));
  // The least term is that with N about pi |w|.
  const auto most = static_cast<std::size_t>(std::numbers::pi * std::min(size, 1e9)) + 1;
  while (result.terms < most &&
         log_of_coefficient(result.terms) -
                 static_cast<double>(2 * result.terms - 1) * std::log2(size) >
             -p) {
    ++result.terms;
  }
  return result;
}

/// At least |R_N(w)|, N = result of the plan. Hypothesis: Re w > 0.
magnitude remainder(const ball& w, std::size_t terms, const stirling_constants& constants) {
  constexpr precision few = 64;
  const ball power = pow(w.with_precision(few), 1 - 2 * static_cast<long>(terms));
  const ball left_out = constants.coefficients[terms - 1].with_precision(few) * power;
  return left_out.magnitude_upper();
}
template <class T>
magnitude remainder(const T& w, std::size_t terms, const stirling_constants& constants) {
  constexpr precision few = 64;
  const auto n = static_cast<long>(terms);
  const T narrow = w.with_precision(few);
  const ball size = abs(narrow);
  // |c_N| sec^(2N)(a/2)/|w|^(2N-1) = |c_N| (2/(|w| + Re w))^N |w|^(1-N).
  const ball bound = constants.coefficients[terms - 1].with_precision(few) *
                     pow(2 / (size + real_part(narrow)), n) * pow(size, 1 - n);
  return bound.magnitude_upper();
}

/// log Gamma(w) by the series, w with the bits that are wanted. Hypothesis: Re w > 0.
template <class T>
T log_at(const T& w, const plan& how, const stirling_constants& constants) {
  const precision bits = w.precision();
  const T inverse = reciprocal_of(w);
  const T inverse_square = square(inverse);
  constexpr precision least_bits = 48;
  constexpr precision spare = 16;
  // Each term needs the bits that it has above the last place of the sum.
  const auto bits_of_term = [&](std::size_t k) {
    const double above = log_of_coefficient(k) - static_cast<double>(2 * k - 1) * how.log_size;
    return std::min(bits, std::max(least_bits, bits + static_cast<precision>(above) + spare));
  };
  T sum(ball(0, least_bits));
  T factor = inverse_square;
  precision kept = 0;
  for (std::size_t k = how.terms - 1; k >= 1; --k) {
    const precision wanted = bits_of_term(k);
    if (wanted > kept) {
      constexpr precision at_once = 64;
      kept = std::min(bits, wanted + at_once);
      factor = inverse_square.with_precision(kept);
    }
    multiply_and_add(sum, factor, constants.coefficients[k - 1].with_precision(kept));
  }
  T result = (w - rational(1, 2)) * log(w) - w + constants.half_log_two_pi + sum * inverse;
  return result.enlarged(remainder(w, how.terms, constants));
}
template <class T>
T log_by_terms(const T& w, std::size_t terms) {
  const double size = std::hypot(nearest(real_part(w)), imaginary(w));
  return log_at(w, {.terms = terms, .log_size = std::log2(size)},
                *stirling_constants_for(terms, w.precision()));
}

/// What Stirling's series says at one point: log Gamma(z + n), and z (z + 1) ... (z + n - 1).
template <class T>
struct parts {
  T logarithm;
  T product;
  long steps = 0;
};

/// Of an exact z with Re z > 0, with errors of about 2^-p.
template <class T>
parts<T> parts_at(const T& z, precision p) {
  constexpr precision guard = 24;
  const double re = nearest(real_part(z));
  // log Gamma(w) is about w log w, of which the bits before the point are lost.
  const double size = std::hypot(re, imaginary(z)) + static_cast<double>(p);
  const double before_point = std::log2(size) + std::log2(2 + std::log2(size));
  const precision bits = p + guard + static_cast<precision>(std::min(before_point, 2000.0));
  const plan how = plan_for(re, imaginary(z), bits);
  const auto constants = stirling_constants_for(how.terms, bits);
  const T own = z.with_precision(std::max(bits, z.precision()));
  const T w = (own + how.steps).with_precision(bits);
  return {log_at(w, how, *constants), rising_product(own.with_precision(bits), how.steps),
          how.steps};
}

/// The sum of the angles of z, z + 1, ..., z + n - 1, Re z > 0.
double_interval sum_of_angles(const complex_ball& z, long n) {
  const double_interval re = double_interval::from_ball(z.re);
  const double_interval im = double_interval::from_ball(z.im);
  // Re z may be too small for a double.
  double_interval sum = double_interval::from_ball(arg(z.with_precision(64)));
  for (long k = 1; k < n; ++k) sum += atan(im / (re + double_interval(static_cast<double>(k))));
  return sum;
}

/// log Gamma at an exact z with Re z > 0: the principal branch, log Gamma(z + n) less the sum of
/// the principal log(z + k), whose imaginary part is that of the product's but for a multiple of
/// 2 pi.
complex_ball log_gamma_at(const complex_ball& z, precision p) {
  const parts<complex_ball> found = parts_at(z, p);
  if (found.steps == 0) return found.logarithm;
  const precision bits = found.logarithm.precision();
  const bool turned = nearest(found.product.re) < 0;
  complex_ball logarithm = log(turned ? -found.product : found.product);
  const ball half_turn = pi(bits);
  if (turned) logarithm.im = logarithm.im + half_turn;
  const double_interval turns =
      (sum_of_angles(z, found.steps) - double_interval::from_ball(logarithm.im)) /
      double_interval::from_ball(scale(half_turn, 1));
  const double n = std::nearbyint(turns.midpoint());
  // The number of turns is a whole one; it is known where the interval has no other.
  if (!(turns.lower() > n - 1 && turns.upper() < n + 1)) return complex_ball::undefined(bits);
  logarithm.im = logarithm.im + scale(half_turn, 1) * static_cast<long>(n);
  return found.logarithm - logarithm;
}

/// (Z - m) times a mean of the digamma function over the segment from m to each member of Z.
complex_ball change_from(const complex_ball& m, const complex_ball& set) {
  const region slope = digamma(region(set));
  if (!slope.is_analytic()) return complex_ball::undefined(set.precision());
  return (set - m) * slope.convex_hull().to_complex_ball();
}
/// An enclosure of the digamma function over a set of numbers x > 0, unbounded where doubles do not
/// reach: psi(x) = psi(x + n) - 1/x - ... - 1/(x + n - 1) (DLMF 5.5.2), and by R_1' of the header
/// log(y) - 1/(2 y) - 1/(12 y^2) <= psi(y) <= log(y) - 1/(2 y).
double_interval digamma_in_doubles(const ball& set) {
  constexpr int steps = 6;
  double_interval y = double_interval::from_ball(set);
  double_interval sum = 0;
  for (int k = 0; k < steps; ++k) {
    sum -= 1 / y;
    y += 1;
  }
  const double_interval inverse = 1 / y;
  const double_interval rest(0, (square(inverse) / 12).upper());
  return sum + log(y) - inverse / 2 - rest;
}
ball change_from(const ball& m, const ball& set) {
  const double_interval slope = digamma_in_doubles(set);
  if (!slope.is_bounded()) return change_from(complex_ball(m), complex_ball(set)).re;
  return (set - m) * to_ball(slope, set.precision());
}

/// value e^d, for an enclosure of d about 0: |e^d - 1| <= |d| + d^2 where |d| <= 1.
ball times_exponential(const ball& value, const ball& d) {
  const magnitude size = d.magnitude_upper();
  if (!(size < magnitude::power_of_two(0))) return value * exp(d);
  const magnitude change = add_up(size, multiply_up(size, size));
  return value.enlarged(multiply_up(value.magnitude_upper(), change));
}
complex_ball times_exponential(const complex_ball& value, const complex_ball& d) {
  return value * exp(d);
}

/// Gamma of an exact number with a positive real part.
template <class T>
T gamma_at(const T& m, precision p) {
  if constexpr (std::is_same_v<T, ball>) {
    if (std::optional<ball> value = gamma_by_taylor_series(m, p)) return *std::move(value);
  }
  const parts<T> found = parts_at(m, p);
  return exp(found.logarithm) / found.product;
}

/// Gamma of a set with positive real parts.
template <class T>
T gamma_right_of_zero(const T& set, precision p) {
  const T m = set.is_exact() ? set : T(set.middle());
  const T value = gamma_at(m, p);
  return set.is_exact() ? value : times_exponential(value, change_from(m, set));
}

/// sin(pi z) = (-1)^n sin(pi (z - n)), n the whole number next to Re z.
complex_ball sine_of_half_turns(const complex_ball& z) {
  const integer n = floor_of(lower_rational(z.re.middle()) + rational(1, 2));
  const complex_ball sine = sin((z - n) * pi(z.precision()));
  return n % 2 == 0 ? sine : -sine;
}

/// Bits beyond which the Bernoulli numbers cost too much.
constexpr precision most_bits = 1L << 13;

/// floor(log2 |x|) for a point that is not 0.
std::int64_t exponent_of(const ball& x) { return x.magnitude_upper().log2_floor(); }

/// Sizes and precisions for which the series are the better way: beyond them there are too many
/// bits, or steps, or bits before the point.
bool is_for_series(const ball& x) {
  constexpr std::int64_t most_exponent = 40;
  if (!x.is_bounded() || x.precision() > most_bits) return false;
  const ball m = x.middle();
  if (sign_of(m) == certain_sign::zero || exponent_of(m) > most_exponent ||
      exponent_of(m) < -2 * x.precision()) {
    return false;
  }
  if (x.is_exact()) return true;
  constexpr std::int64_t narrow = 20;
  return certainly_positive(x) &&
         (x.radius().is_zero() || x.radius().log2_floor() < exponent_of(m) - narrow);
}

bool is_integer(const ball& x) { return x.is_exact() && denominator(lower_rational(x)) == 1; }

}  // namespace
}  // namespace gamma_series_impl

ball log_gamma_by_terms(const ball& w, std::size_t terms) {
  return gamma_series_impl::log_by_terms(w, terms);
}
complex_ball log_gamma_by_terms(const complex_ball& w, std::size_t terms) {
  return gamma_series_impl::log_by_terms(w, terms);
}

std::optional<ball> gamma_by_series(const ball& x) {
  using namespace gamma_series_impl;
  // A factorial is exact, and a pole is none of theirs.
  if (!is_for_series(x) || is_integer(x)) return std::nullopt;
  const precision p = x.precision();
  if (certainly_positive(x)) return gamma_right_of_zero(x, p).with_precision(p);
  // Gamma(x) Gamma(1 - x) = pi/sin(pi x).
  constexpr precision guard = 16;
  const precision bits = p + guard;
  const ball exactly = x.with_precision(3 * p + 2 * guard + 64);
  const ball other = gamma_right_of_zero(ball((1 - exactly).with_precision(bits)), bits);
  return (pi(bits) / (sinpi(x.with_precision(bits)) * other)).with_precision(p);
}

std::optional<ball> log_gamma_by_series(const ball& x) {
  using namespace gamma_series_impl;
  if (!is_for_series(x) || !certainly_positive(x) || is_integer(x)) return std::nullopt;
  const precision p = x.precision();
  const ball m = x.middle();
  const parts<ball> found = parts_at(m, p);
  const ball value = found.logarithm - log(found.product);
  // Beside its zeros at 1 and 2 the digits are lost: another way has them.
  constexpr std::int64_t spare = 6;
  if (contains_zero(value) ||
      value.radius().log2_floor() > value.magnitude_lower().log2_floor() - p - spare) {
    return std::nullopt;
  }
  return (x.is_exact() ? value : ball(value + change_from(m, x))).with_precision(p);
}

complex_ball log_gamma_by_series(const complex_ball& z) {
  using namespace gamma_series_impl;
  const precision p = std::min(z.precision(), most_bits);
  if (!z.is_bounded() || !certainly_positive(z.re)) return complex_ball::undefined(p);
  const complex_ball m = z.middle();
  complex_ball value = log_gamma_at(m, p);
  // Beside the zeros at 1 and 2 bits are lost.
  constexpr std::int64_t small = -8;
  if (value.magnitude_lower() < magnitude::power_of_two(small)) {
    value = log_gamma_at(m, std::min(2 * p, most_bits));
  }
  return (z.is_exact() ? value : value + change_from(m, z)).with_precision(z.precision());
}

}  // namespace polhode::detail

namespace polhode {

complex_ball log_gamma(const complex_ball& z) {
  if (sign_of(z.im) == certain_sign::zero) return complex_ball(log_gamma(z.re));
  return detail::log_gamma_by_series(z);
}

complex_ball gamma(const complex_ball& z) {
  using namespace detail::gamma_series_impl;
  const precision wanted = z.precision();
  const precision p = std::min(wanted, most_bits);
  if (sign_of(z.im) == certain_sign::zero) return complex_ball(gamma(z.re));
  if (!z.is_bounded()) return complex_ball::undefined(wanted);
  if (certainly_positive(z.re)) return gamma_right_of_zero(z, p).with_precision(wanted);
  // Gamma(z) Gamma(1 - z) = pi/sin(pi z) (DLMF 5.5.3).
  constexpr precision guard = 16;
  const complex_ball own = z.with_precision(p + guard);
  const complex_ball mirrored = 1 - own;
  if (!certainly_positive(mirrored.re)) return complex_ball::undefined(wanted);
  const complex_ball divisor = sine_of_half_turns(own) * gamma_right_of_zero(mirrored, p + guard);
  return (pi(p + guard) / divisor).with_precision(wanted);
}

}  // namespace polhode
