// How the nodes and weights are found and proved.
//
// Write P_n(x) = x^e q(x^2), e = 0 for even n and 1 for odd n, where q has degree m = floor(n/2). The m zeros of
// q lie in (0, 1): they are the squares y of the positive nodes. Everything is done in y.
//   1. Search, in floating point: y_0 = Y/2^64 near each zero.
//   2. q(y_0) and q'(y_0), from the coefficients, in fixed point: y_0 is one limb, so that a step of Horner's
//      scheme is one pass over the limbs.
//   3. The Taylor coefficients of q at y_0, from Legendre's differential equation, in balls; a bound of the
//      remainder (Cauchy).
//   4. Newton's method on the Taylor polynomial, and in its last step the interval Newton operator, which
//      proves that there is one zero and encloses it.
// As the m enclosures are disjoint and q has no more than m zeros, each of them holds one, in order.
// With few limbs steps 2 to 4 are those of legendre_zeros.cpp, in integers alone; what is said here is how it is done with many, and
// where a start is so bad that they fail.

#include "polhode/quadrature/gauss_legendre.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmp.h>

#include "legendre_zeros.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode {
namespace {

static_assert(GMP_NUMB_BITS == 64, "limbs of 64 bits without nails");

using detail::legendre_shape;
using detail::legendre_values;
using detail::legendre_zero;

// ---------------------------------------------------------------------------------------------
// 1. Search.

/// An estimate of the k-th zero of P_n from the right, k = 1 ... n/2: Halley's method, from the classical guess.
/// The recurrence is written as P_(k+1) = x P_k + k/(k+1) (x P_k - P_(k-1)).
long double estimated_node(long n, long k, const std::vector<long double>& quotients) {
  const auto degree = static_cast<long double>(n);
  const long double angle =
      std::numbers::pi_v<long double> * (static_cast<long double>(k) - 0.25L) / (degree + 0.5L);
  long double x = (1 - (degree - 1) / (8 * degree * degree * degree)) * std::cos(angle);
  for (int iteration = 0; iteration < 8; ++iteration) {
    long double before = 1;
    long double value = x;
    for (std::size_t j = 1; j < static_cast<std::size_t>(n); ++j) {
      const long double product = x * value;
      const long double next = product + quotients[j] * (product - before);
      before = value;
      value = next;
    }
    const long double complement = (1 - x) * (1 + x);
    const long double slope = degree * (before - x * value) / complement;
    const long double bend = (2 * x * slope - degree * (degree + 1) * value) / complement;
    const long double step = -2 * value * slope / (2 * slope * slope - value * bend);
    x += step;
    // The next error is about the third power of the step, in units of the distance of the zeros.
    if (std::abs(step) * degree * degree < 1e-6L) break;
  }
  return x;
}

/// The squares of the positive zeros, increasing, in units of 2^-64. None is 0.
std::vector<std::uint64_t> estimated_squares(const legendre_shape& s) {
  std::vector<long double> quotients(static_cast<std::size_t>(s.n));
  for (std::size_t j = 0; j < quotients.size(); ++j) {
    quotients[j] = static_cast<long double>(j) / static_cast<long double>(j + 1);
  }
  std::vector<std::uint64_t> squares;
  squares.reserve(static_cast<std::size_t>(s.degree));
  for (long k = s.degree; k >= 1; --k) {
    const long double x = estimated_node(s.n, k, quotients);
    const long double scaled = std::ldexp(x * x, 64);
    const bool usable = scaled >= 1 && scaled < 18446744073709549568.0L;
    squares.push_back(usable ? static_cast<std::uint64_t>(scaled) : std::uint64_t{1} << 63);
  }
  return squares;
}

/// A few zeros of P_n at once, which a processor works on side by side.
struct lanes {
  static constexpr std::size_t count = 8;
  std::array<double, count> values;
  double& operator[](std::size_t i) { return values[i]; }
};

/// Estimates of 1 - x for the k-th zeros of P_n from the right, k = first, first + 1 ...: Halley's method, from the
/// classical guess. With t = 1 - x and D_k = P_k - P_(k-1) the recurrence is D_(k+1) = r D_k - (1 + r) t P_k, r = k/(k+1), which
/// is as exact near x = 1 as elsewhere.
lanes estimated_complements(long n, long first, const std::vector<double>& ratios) {
  const auto degree = static_cast<double>(n);
  const double shrinkage = (degree - 1) / (8 * degree * degree * degree);
  lanes t{};
  for (std::size_t i = 0; i < lanes::count; ++i) {
    const long k = std::min(first + static_cast<long>(i), n / 2);
    const double angle = std::numbers::pi * (static_cast<double>(k) - 0.25) / (degree + 0.5);
    const double sine = std::sin(angle / 2);
    t[i] = 2 * sine * sine + shrinkage * (1 - 2 * sine * sine);
  }
  for (int iteration = 0; iteration < 6; ++iteration) {
    lanes value{};
    lanes difference{};
    for (std::size_t i = 0; i < lanes::count; ++i) {
      value[i] = 1 - t[i];
      difference[i] = -t[i];
    }
    for (std::size_t j = 1; j < static_cast<std::size_t>(n); ++j) {
      const double r = ratios[j];
      for (std::size_t i = 0; i < lanes::count; ++i) {
        difference[i] = r * difference[i] - (1 + r) * (t[i] * value[i]);
        value[i] += difference[i];
      }
    }
    double largest = 0;
    for (std::size_t i = 0; i < lanes::count; ++i) {
      const double square = t[i] * (2 - t[i]);  // 1 - x^2
      const double slope = degree * (t[i] * value[i] - difference[i]) / square;
      const double bend = (2 * (1 - t[i]) * slope - degree * (degree + 1) * value[i]) / square;
      const double step = 2 * value[i] * slope / (2 * slope * slope - value[i] * bend);
      t[i] += step;
      largest = std::max(largest, std::abs(step) / t[i]);
    }
    // The next error is about the third power of the step, in units of the distance of the zeros.
    if (largest * degree < 1e-5) break;
  }
  return t;
}

/// The squares of the positive zeros, increasing, in units of 2^-64, to some 50 bits. None is 0.
std::vector<std::uint64_t> roughly_estimated_squares(const legendre_shape& s) {
  std::vector<double> ratios(static_cast<std::size_t>(s.n));
  for (std::size_t j = 0; j < ratios.size(); ++j) {
    ratios[j] = static_cast<double>(j) / static_cast<double>(j + 1);
  }
  std::vector<std::uint64_t> squares(static_cast<std::size_t>(s.degree));
  for (long first = 1; first <= s.degree; first += static_cast<long>(lanes::count)) {
    lanes t = estimated_complements(s.n, first, ratios);
    for (std::size_t i = 0; i < lanes::count; ++i) {
      const long k = first + static_cast<long>(i);
      if (k > s.degree) break;
      // y or 1 - y, whichever is the smaller one, to as many bits as t has.
      const bool near_1 = t[i] < 0.5;
      const double part = near_1 ? t[i] * (2 - t[i]) : (1 - t[i]) * (1 - t[i]);
      const bool usable = part > 0x1p-60 && part < 0.9;
      const auto units =
          usable ? static_cast<std::uint64_t>(std::ldexp(part, 64)) : std::uint64_t{1} << 63;
      squares[static_cast<std::size_t>(s.degree - k)] = near_1 ? 0 - units : units;
    }
  }
  return squares;
}

// ---------------------------------------------------------------------------------------------
// 2. Values at numbers of one limb.

}  // namespace

/// At `count` arguments; a number is kept with a limb below it, into which the product's lowest limb goes.
void detail::legendre_values::evaluate(const std::uint64_t* arguments, std::size_t count,
                                       std::vector<pair>& results) const {
  using limbs = std::vector<mp_limb_t>;
  const mp_size_t limbs_of_one = coefficients_.size;
  const auto size = static_cast<std::size_t>(limbs_of_one);
  const std::size_t room = size + 1;
  limbs value(count * room, 0);
  limbs slope(count * room, 0);
  limbs fresh(room);
  // number = addend + floor(number * argument / 2^64)
  const auto step = [&](mp_limb_t* number, std::uint64_t argument, const mp_limb_t* addend) {
    fresh[0] = 0;
    mpn_copyi(fresh.data() + 1, addend, limbs_of_one);
    fresh[size] += mpn_addmul_1(fresh.data(), number, limbs_of_one, argument);
    // As an unsigned number a negative one is 2^(64 size) too large.
    if ((number[size - 1] >> 63) != 0) fresh[size] -= argument;
    mpn_copyi(number, fresh.data() + 1, limbs_of_one);
  };
  for (long j = 0; j <= degree_; ++j) {
    const mp_limb_t* const coefficient =
        coefficients_.limbs.data() + static_cast<std::size_t>(j) * size;
    for (std::size_t i = 0; i < count; ++i) {
      mp_limb_t* const v = value.data() + i * room;
      if (j > 0) step(slope.data() + i * room, arguments[i], v);
      step(v, arguments[i], coefficient);
    }
  }
  const auto to_ball = [&](mp_limb_t* number, std::uint64_t error) {
    const bool is_negative = (number[size - 1] >> 63) != 0;
    if (is_negative) mpn_neg(number, number, limbs_of_one);
    mp_size_t used = limbs_of_one;
    while (used > 0 && number[used - 1] == 0) --used;
    mpz_t z;
    const precision bits = coefficients_.fraction_bits;
    const ball units(mpz_roinit_n(z, number, is_negative ? -used : used), bits);
    return scale(units, -bits).enlarged(scale(magnitude::from_integer_up(error), -bits));
  };
  const auto m = static_cast<std::uint64_t>(degree_);
  for (std::size_t i = 0; i < count; ++i) {
    results.push_back({to_ball(value.data() + i * room, 2 * (m + 1)),
                       to_ball(slope.data() + i * room, m * (m + 2))});
  }
}

std::vector<detail::legendre_values::pair> detail::legendre_values::at(
    const std::vector<std::uint64_t>& arguments) const {
  constexpr std::size_t together = 8;
  std::vector<pair> results;
  results.reserve(arguments.size());
  for (std::size_t first = 0; first < arguments.size(); first += together) {
    evaluate(arguments.data() + first, std::min(together, arguments.size() - first), results);
  }
  return results;
}

// ---------------------------------------------------------------------------------------------
// 3. Taylor polynomials.

namespace {

constexpr precision least_bits = 64;

/// p, rounded up to whole limbs: the same work.
precision whole_limbs(double p) {
  const auto limbs = static_cast<precision>(std::max(p, 0.0) / GMP_NUMB_BITS) + 1;
  return limbs * GMP_NUMB_BITS;
}

/// q near y_0 in terms of g = (y - y_0) / scale, scale = 4 y_0 (1 - y_0): q = sum of d_k g^k, k = 0 ... last, and a
/// remainder.
struct local_series {
  ball centre;  // y_0
  ball scale;
  std::vector<ball> coefficients;
  std::vector<precision> bits;  // of the coefficients: not increasing
  long last = 0;
};

/// The coefficients of q at y_0 by its differential equation. From (1 - x^2) P'' - 2x P' + n(n+1) P = 0,
///   4y(1-y) q'' + (2 + 4e - (6 + 4e) y) q' + (n(n+1) - 2e) q = 0,   e = 0 or 1 as n is even or odd.
/// For q = sum of c_k (y - y_0)^k that is
///   4 y_0 (1-y_0) (k+1)(k+2) c_(k+2) + (k+1) (4 (1 - 2 y_0) k + 2 + 4e - (6 + 4e) y_0) c_(k+1)
///     + (n(n+1) - 2e - 4k(k-1) - (6 + 4e) k) c_k = 0,
/// and d_k = c_k scale^k needs a division by (k+1)(k+2) only.
///
/// `reach` is about the greatest |y - y_0| that will be asked for: it decides how many terms there are and
/// how many bits they have (a term of order k matters only down to 2^-bits reach^-(k-1)), not what is true.
/// Nothing where reach is too great.
std::optional<local_series> make_series(const legendre_shape& s, std::uint64_t argument,
                                        const legendre_values::pair& start, double log2_reach,
                                        precision bits) {
  constexpr precision bits_of_constants = 192;  // enough to have them exactly, for all n allowed
  local_series series;
  // Bits of the k-th term, by the bound of detail::legendre_taylor_remainder; its slope's, in fact, which needs one reach less.
  const auto log2_term = [&](long k) {
    const double base = std::numbers::e * static_cast<double>(s.n) / static_cast<double>(2 * k);
    return static_cast<double>(2 * k) * std::log2(base) + static_cast<double>(k - 1) * log2_reach +
           (s.odd != 0 ? std::log2(static_cast<double>(s.n)) : 0.0);
  };
  series.bits = {bits, bits};
  const double wanted = -static_cast<double>(bits) - 4;
  for (series.last = 1; series.last < s.degree; ++series.last) {
    const double next = log2_term(series.last + 1);
    if (next < wanted) break;
    if (next > 0 && series.last > 64) return std::nullopt;
    const double needed = static_cast<double>(bits) + next + 12;
    series.bits.push_back(std::min(whole_limbs(needed), series.bits.back()));
  }

  const ball two_to_64 = scale(ball(1, bits_of_constants), 64);
  const ball units = ball(argument, bits_of_constants);
  series.centre = scale(units, -64);
  series.scale = scale(units * (two_to_64 - units), 2 - 128);
  auto& d = series.coefficients;
  d.reserve(static_cast<std::size_t>(series.last) + 1);
  d.push_back(start.value);
  d.push_back(start.slope * series.scale);
  const ball step = 4 * (1 - scale(series.centre, 1));
  ball drift = 2 + 4 * s.odd - (6 + 4 * s.odd) * series.centre;
  ball factor;
  ball next;
  ball product;
  for (long k = 0; k + 2 <= series.last; ++k) {
    const auto at = static_cast<std::size_t>(k);
    multiply(factor, drift, k + 1);
    multiply(next, factor, d[at + 1]);
    multiply(factor, series.scale,
             s.n * (s.n + 1) - 2 * s.odd - 4 * k * (k - 1) - (6 + 4 * s.odd) * k);
    multiply(product, factor, d[at]);
    add(next, next, product);
    divide(next, next, -(k + 1) * (k + 2));
    d.push_back(next.with_precision(series.bits[at + 2]));
    drift += step;
  }
  return series;
}

/// The sum of d_k g^k, or of k d_k g^(k-1), for k <= last, with about `fewer` bits less than the series has.
template <bool derivative>
ball sum_of(const local_series& series, const ball& g, precision fewer, long last) {
  const auto bits = [&](long k) {
    return std::max(least_bits, series.bits[static_cast<std::size_t>(k)] - fewer);
  };
  precision p = bits(last);
  ball short_g = g.precision() > p ? g.with_precision(p) : g;
  ball sum(0, p);
  ball term;
  for (long k = last; k >= (derivative ? 1 : 0); --k) {
    if (bits(k) != p) {
      p = bits(k);
      short_g = g.precision() > p ? g.with_precision(p) : g;
    }
    if (k < last) multiply(sum, sum, short_g);
    const ball& d = series.coefficients[static_cast<std::size_t>(k)];
    if (d.precision() > p) {
      term = d.with_precision(p);
      if constexpr (derivative) multiply(term, term, k);
      add(sum, sum, term);
    } else if constexpr (derivative) {
      multiply(term, d, k);
      add(sum, sum, term);
    } else {
      add(sum, sum, d);
    }
  }
  return sum;
}

// ---------------------------------------------------------------------------------------------
// 4. Zeros.

/// Newton's method at growing precision: a number near the zero of the series, to about half its bits. A search:
/// the midpoints of balls are taken for numbers.
ball approximate_zero(const local_series& series, precision bits) {
  const auto& d = series.coefficients;
  const auto log2_of = [](const ball& x) {
    constexpr double most = 0x1p+40;  // of 0, too
    return std::clamp(estimated_log2(x.magnitude_upper()), -most, most);
  };
  constexpr precision bits_of_start = 192;
  const ball slope = d[1].with_precision(bits_of_start);
  ball g = -(d[0].with_precision(bits_of_start) / slope);
  // The error after a step of Newton's method is 2^bend times the square of the one before.
  double bend = 0;
  long good = static_cast<long>(-2 * log2_of(g));
  if (series.last >= 2) {
    bend = std::max(log2_of(d[2]) - log2_of(d[1]), 0.0);
    // That of the start, with the second term of the inverse series, is |2 (d_2/d_1)^2 - d_3/d_1| |g|^3, and d_2 is small
    // in the middle of [0, 1].
    double third = 2 * bend + 1;
    if (series.last >= 3) third = std::max(third, log2_of(d[3]) - log2_of(d[1]));
    good = static_cast<long>(-3 * log2_of(g) - third) - 5;
    g -= d[2].with_precision(bits_of_start) * square(g) / slope;
  }
  g = g.middle();
  std::vector<double> goals;
  for (double goal = (static_cast<double>(bits) + bend) / 2 + 6;
       goal > static_cast<double>(good) && goals.size() < 64; goal = (goal + bend) / 2 + 4) {
    goals.push_back(goal);
  }
  const auto last_for = [&](precision fewer) {
    long last = series.last;
    while (last > 1 && series.bits[static_cast<std::size_t>(last)] <= fewer) --last;
    return last;
  };
  std::reverse(goals.begin(), goals.end());
  for (const double goal : goals) {
    const precision working = std::min(bits, whole_limbs(goal + 16));
    const precision fewer = bits - working;
    const precision fewer_of_slope = bits - std::min(bits, whole_limbs(goal / 2 + 16));
    g = g.with_precision(working).middle();
    const ball value = sum_of<false>(series, g, fewer, last_for(fewer)).with_precision(working);
    g = (g - value / sum_of<true>(series, g, fewer_of_slope, last_for(fewer_of_slope)))
            .with_precision(working)
            .middle();
  }
  return g;
}

/// The zero of q near the centre of the series, proved. Let f(g) = q(y_0 + scale g). If J is an interval around g, if
/// 0 is not in f'(J), and if N = g - f(g)/f'(J) is a part of J, then f has exactly one zero in J, and it is in N
/// (Moore; it follows from the mean value theorem). Nothing where that does not come out so.
std::optional<legendre_zero> proved_zero(const legendre_shape& s, const local_series& series,
                                         precision bits) {
  if (contains_zero(series.coefficients[1])) return std::nullopt;
  const ball g = approximate_zero(series, bits);
  if (!g.is_bounded()) return std::nullopt;
  const auto reach_of = [&](const ball& x) {
    return max((series.scale * x).magnitude_upper(), magnitude::power_of_two(-bits));
  };
  const bool complete = series.last >= s.degree;  // the series is all of q
  const auto remainder = [&](const ball& x) {
    return detail::legendre_taylor_remainder(s.n, series.last + 1, reach_of(x));
  };
  const auto value_of = [&](const ball& x) {
    const ball sum = sum_of<false>(series, x, 0, series.last);
    return complete ? sum : sum.enlarged(remainder(x).of_value);
  };
  const auto slope_of = [&](const ball& x, precision fewer) {
    ball sum = sum_of<true>(series, x, fewer, series.last);
    if (complete) return sum;
    return sum.enlarged(multiply_up(series.scale.magnitude_upper(), remainder(x).of_slope));
  };

  const ball value = value_of(g);
  const magnitude step =
      divide_up(value.magnitude_upper(), series.coefficients[1].magnitude_lower());
  if (step.is_infinite()) return std::nullopt;
  const ball neighbourhood =
      g.with_precision(bits).enlarged(add_up(scale(step, 2), magnitude::power_of_two(-bits)));
  const precision fewer =
      std::clamp(static_cast<precision>(-step.log2_floor()) - 32, precision{0}, bits / 2);
  // Of the value's bits only those below the step are left.
  const ball quotient = value.with_precision(bits - fewer) / slope_of(neighbourhood, fewer);
  const ball position = g.with_precision(bits) - quotient;
  if (!position.is_bounded() || !contains(neighbourhood, position)) return std::nullopt;
  return legendre_zero{series.centre + series.scale * position, slope_of(position, 0),
                       series.scale};
}

/// A better start by a step of Newton's method, in units of 2^-64; the old one where that leaves (0, 1).
std::uint64_t improved(std::uint64_t argument, const legendre_values::pair& at) {
  constexpr precision p = 128;
  const ball step = scale(at.value.with_precision(p) / at.slope.with_precision(p), 64);
  const ball target = ball(argument, p) - step.middle();
  if (!target.is_bounded()) return argument;
  detail::mpfr_cell cell(p);
  target.midpoint(cell.get());
  const bool usable =
      mpfr_fits_ulong_p(cell.get(), MPFR_RNDD) != 0 && mpfr_cmp_ui(cell.get(), 1) >= 0;
  return usable ? mpfr_get_ui(cell.get(), MPFR_RNDD) : argument;
}

}  // namespace

std::optional<legendre_zero> detail::zero_by_taylor(const legendre_shape& s, std::uint64_t start,
                                                    const legendre_values::pair& at,
                                                    double log2_reach, precision bits) {
  const auto series = make_series(s, start, at, log2_reach, bits);
  if (!series) return std::nullopt;
  return proved_zero(s, *series, bits);
}

std::optional<ball> detail::with_radius(const ball& x, precision bits, bool relative) {
  if (!x.is_bounded()) return std::nullopt;
  const ball shorter = x.with_precision(bits);
  detail::mpfr_cell cell(bits);
  shorter.midpoint(cell.get());
  if (mpfr_regular_p(cell.get()) == 0) return std::nullopt;
  const long exponent = relative ? mpfr_get_exp(cell.get()) - bits : -bits;
  const magnitude radius = magnitude::power_of_two(exponent);
  if (shorter.radius() > radius) return std::nullopt;
  return ball::from_midpoint_radius(cell.get(), radius);
}

namespace {

/// The zeros of q near the starts, or better ones.
class zero_finder {
 public:
  zero_finder(const legendre_shape& s, precision bits_at_work)
      : shape_(s), bits_at_work_(bits_at_work) {
    if (s.n >= 2 && s.n <= detail::few_limbed_zeros::greatest_n &&
        bits_at_work <= detail::few_limbed_zeros::most_bits) {
      few_limbed_.emplace(s, bits_at_work);
    }
  }
  /// For each start the zero, or nothing.
  [[nodiscard]] std::vector<std::optional<legendre_zero>> near(
      const std::vector<std::uint64_t>& starts);

 private:
  [[nodiscard]] std::optional<legendre_zero> found(std::uint64_t start,
                                                   legendre_values::pair at) const;

  legendre_shape shape_;
  precision bits_at_work_;
  std::optional<detail::few_limbed_zeros> few_limbed_;
  std::optional<legendre_values> polynomial_;
};

std::optional<legendre_zero> zero_finder::found(std::uint64_t start,
                                                legendre_values::pair at) const {
  for (int attempt = 0; attempt < 12; ++attempt) {
    if (attempt > 0) {
      start = improved(start, at);
      at = polynomial_->at({start}).front();
    }
    // A start that hits the zero tells nothing of its distance: a unit of y_0 at least.
    const double log2_reach = std::max(
        estimated_log2(divide_up(at.value.magnitude_upper(), at.slope.magnitude_lower())), -70.0);
    if (auto zero = detail::zero_by_taylor(shape_, start, at, log2_reach + 1, bits_at_work_)) {
      return zero;
    }
  }
  return std::nullopt;
}

std::vector<std::optional<legendre_zero>> zero_finder::near(
    const std::vector<std::uint64_t>& starts) {
  std::vector<std::optional<legendre_zero>> zeros(starts.size());
  std::vector<std::uint64_t> left;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (few_limbed_) zeros[i] = few_limbed_->near(starts[i]);
    if (!zeros[i]) left.push_back(starts[i]);
  }
  if (left.empty()) return zeros;
  polynomial_.emplace(shape_, bits_at_work_);
  const std::vector<legendre_values::pair> at = polynomial_->at(left);
  std::size_t next = 0;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (zeros[i]) continue;
    zeros[i] = found(starts[i], at[next++]);
    if (!zeros[i]) break;
  }
  return zeros;
}

/// The rule, or nothing where `bits_at_work` do not suffice.
///
/// The weight of a node x is 2 / ((1 - x^2) P_n'(x)^2). With y = x^2: P_n' = 2x q' for even n, and 2 x^2 q' for
/// odd n, where q = 0. So it is 2 / (4y (1-y) q'^2), and divided by y once more for odd n. At the node 0 of an
/// odd n P_n' = q(0).
std::optional<gauss_legendre_rule> rule_with(long n, precision bits, precision bits_at_work,
                                             const std::vector<std::uint64_t>& starts) {
  const legendre_shape s(n);
  gauss_legendre_rule rule{n, bits, {}, {}};
  rule.nodes.reserve(starts.size() + 1);
  rule.weights.reserve(starts.size() + 1);
  const auto append = [&](const ball& node, const ball& weight) {
    auto x = detail::with_radius(node, bits, false);
    auto w = detail::with_radius(weight, bits, true);
    if (!x || !w) return false;
    rule.nodes.push_back(std::move(*x));
    rule.weights.push_back(std::move(*w));
    return true;
  };
  if (s.odd != 0) {
    // q(0), in rationals: C(n, m) C(n + 1, n) / 2^n, m = (n-1)/2, but for its sign.
    integer a;
    mpz_bin_uiui(a.backend().data(), static_cast<unsigned long>(n),
                 static_cast<unsigned long>(s.degree));
    const ball slope = scale(ball(a, bits_at_work) * (n + 1), -n);
    auto w = detail::with_radius(2 / square(slope), bits, true);
    if (!w) return std::nullopt;
    rule.nodes.emplace_back(0, bits);
    rule.weights.push_back(std::move(*w));
  }
  for (const auto& found : zero_finder(s, bits_at_work).near(starts)) {
    if (!found) return std::nullopt;
    const ball& y = found->square;
    const ball complement = 1 - y;
    ball denominator = scale(y * complement * square(found->slope), 1);
    if (s.odd != 0) denominator *= y;
    const ball node = sqrt(y);
    if (!certainly_positive(y) || !certainly_positive(complement)) return std::nullopt;
    constexpr precision exactly = 256;  // of a product of four limbs
    const ball numerator = square(found->scale.with_precision(exactly));
    if (!append(node, numerator / denominator)) return std::nullopt;
    // The enclosures in the rule contain those of the zeros.
    const std::size_t count = rule.nodes.size();
    if (count > 1 && !certainly_positive(rule.nodes[count - 1] - rule.nodes[count - 2])) {
      return std::nullopt;
    }
  }
  return rule;
}

}  // namespace

/// For r > 0 let s = sqrt(r). If |x^2 - y_0| <= r, then x lies in the Bernstein ellipse |x - 1| + |x + 1| <=
/// 2 cosh(a), sinh(a) = s. Proof: (|x-1| + |x+1|)^2 = |x-1|^2 + |x+1|^2 + 2|x^2-1| = 2 (|y| + 1 + |y-1|), which
/// for y = x^2 is at most 2 (y_0 + r + 1 + 1 - y_0 + r) = 4 (1 + r) = 4 cosh(a)^2.
/// In that ellipse |P_n| <= e^(na): P_n(cos t) is a combination of cos((n - 2k) t) with positive coefficients
/// that add up to P_n(1) = 1 (expand the generating function ((1 - z e^(it)) (1 - z e^(-it)))^(-1/2)), and
/// |cos((n - 2k) t)| <= e^(n |Im t|), with |Im t| <= a there.
/// As a <= sinh(a) = s, |q| <= e^(ns) on the disc for even n. For odd n q = P_n / x, and on the boundary of
/// the ellipse |x| is at least the minor half axis, sinh(a) = s: by the maximum principle |q| <= e^(ns) / s.
/// Call that bound M. Cauchy: the k-th coefficient is at most M r^-k, so with t = h/r < 1 the remainders are at most
///   sum over k >= j of M t^k = M t^j / (1 - t),
///   sum over k >= j of k M t^(k-1) / r = (M/r) t^(j-1) (j - (j-1) t) / (1-t)^2 <= (M t^j / h) j / (1-t)^2.
/// With s = 2j/n, the best choice for even n: M t^j = (e n / (2j))^(2j) h^j, times n / (2j) for odd n.
///
/// How generous that is: half of it would do for all n, j, h and y_0. q(y) is a Jacobi polynomial in 2y - 1, P_m^(0, -1/2) or
/// P_m^(0, 1/2), and so are its derivatives but for a factor; they are the largest at y = 1 for even n, at y = 0 for odd n (Szegő, Orthogonal
/// Polynomials, theorem 7.32.1). With N = n/2 that gives, for all y_0 in [0, 1],
///   |c_k| <= product over i < k of (m - i)(m + 1/2 + i) / k!^2 <= e^(1/2) N^(2k) / k!^2 for even n,
///   |c_k| <= Gamma(N + k + 1) / (Gamma(N - k + 1/2) Gamma(k + 3/2) k!) <= 2 e n^(2k) sqrt(N/pi) / (2k+1)! for odd n,
/// as k <= m: the first product's factors are at most m^2 but for (1 + 1/(2m)), and Gamma(N + k + 1) / Gamma(N - k + 1/2) is at most
/// (N^2 + N)^k sqrt(N). By Stirling's formula the k-th term e^(2k) (n/(2k))^(2k), times N/k for odd n, is at least 2 pi k e^(-1/2) > 3
/// and 2 pi sqrt(k N) / e > 2.8 times that; and M t^k is not less than it for any k >= j.
detail::taylor_remainder detail::legendre_taylor_remainder(long n, long j, const magnitude& h) {
  const auto order = static_cast<std::uint64_t>(j);
  const magnitude inverse_s = divide_up(magnitude::from_integer_up(static_cast<std::uint64_t>(n)),
                                        magnitude::from_integer_down(2 * order));
  const magnitude t = multiply_up(multiply_up(inverse_s, inverse_s), h);
  const magnitude complement = subtract_down(magnitude::from_integer_down(1), t);
  // e < 2.71828183
  const magnitude e =
      divide_up(magnitude::from_integer_up(271'828'183), magnitude::from_integer_down(100'000'000));
  magnitude power = multiply_up(multiply_up(e, e), t);
  magnitude bound = n % 2 != 0 ? inverse_s : magnitude::from_integer_up(1);
  for (std::uint64_t left = order; left != 0; left /= 2) {
    if (left % 2 != 0) bound = multiply_up(bound, power);
    power = multiply_up(power, power);
  }
  // Both are infinite where t >= 1.
  return {divide_up(bound, complement),
          divide_up(divide_up(multiply_up(bound, magnitude::from_integer_up(order)), h),
                    multiply_down(complement, complement))};
}

gauss_legendre_rule make_gauss_legendre(long n, precision bits) {
  return detail::make_gauss_legendre_from(n, bits, [bits](long degree) {
    // A start of 60 bits, for less terms of the series, is worth its time where they have many limbs.
    const bool few = degree <= detail::few_limbed_zeros::greatest_n &&
                     bits < detail::few_limbed_zeros::most_bits / 2;
    const legendre_shape s(degree);
    return few ? roughly_estimated_squares(s) : estimated_squares(s);
  });
}

gauss_legendre_rule detail::make_gauss_legendre_from(
    long n, precision bits, const std::function<std::vector<std::uint64_t>(long n)>& estimates) {
  if (n < 1 || n > greatest_gauss_legendre_degree) {
    throw std::invalid_argument("a Gauss and Legendre rule of degree " + std::to_string(n) +
                                "; degrees are 1 ... " +
                                std::to_string(greatest_gauss_legendre_degree));
  }
  if (bits < 64 || bits % 64 != 0) {
    throw std::invalid_argument("a Gauss and Legendre rule of " + std::to_string(bits) +
                                " bits; they are a multiple of 64");
  }
  const std::vector<std::uint64_t> starts = estimates(n);
  if (starts.size() != static_cast<std::size_t>(n / 2)) {
    throw std::invalid_argument("estimates of " + std::to_string(starts.size()) +
                                " nodes; the rule has " + std::to_string(n / 2) + " above 0");
  }
  // Near 0 and 1 the zeros are 1/n^2 apart, and an error in y counts n and n^2 times in node and weight.
  const precision loss = 3 * static_cast<precision>(std::bit_width(static_cast<unsigned long>(n)));
  for (const precision more : {16, 80, 300, 2000}) {
    auto rule = rule_with(n, bits, bits + loss + more, starts);
    if (rule) return std::move(*rule);
  }
  throw std::runtime_error("the Gauss and Legendre rule of degree " + std::to_string(n) + " with " +
                           std::to_string(bits) + " bits was not proved at any working precision");
}

precision gauss_legendre_precision_at_least(precision p) {
  checked_precision(p);
  precision step = 64;
  while (step * 32 <= p) step *= 2;
  return (p + 2 + step - 1) / step * step;
}

long gauss_legendre_degree_at_least(long n) {
  if (n < 1 || n > greatest_gauss_legendre_degree) {
    throw std::invalid_argument("a Gauss and Legendre rule of degree at least " +
                                std::to_string(n));
  }
  if (n <= 16) return n;
  // 16 * 2^(i/6), rounded.
  constexpr std::array<long, 7> steps = {16, 18, 20, 23, 26, 29, 32};
  long octave = 1;
  while (32 * octave < n) octave *= 2;
  const auto* const found =
      std::find_if(steps.begin(), steps.end(), [&](long step) { return step * octave >= n; });
  const long degree = *found * octave;
  return std::min(degree, greatest_gauss_legendre_degree);
}

std::shared_ptr<const gauss_legendre_rule> gauss_legendre(long n, precision p, node_cache& cache) {
  return cache.get(n, gauss_legendre_precision_at_least(p));
}

}  // namespace polhode
