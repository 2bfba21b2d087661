// The hardware interval against MPFR: the constants and the proved bounds of its approximations,
// the inclusion principle, and how far the ends are from the range.

#include "polhode/arithmetic/double_interval.hpp"

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/real.hpp"

namespace polhode {
namespace double_interval_test {

namespace point = detail::approximation;
using detail::infinity;
using detail::largest_double;
using detail::least_double;
using detail::least_normal_double;
using support::random_source;
using support::real;
using support::repeat;

constexpr mpfr_prec_t oracle_bits = 200;

// No double becomes an interval unasked, and integers do.
static_assert(!std::is_convertible_v<double, double_interval>);
static_assert(!std::is_convertible_v<float, double_interval>);
static_assert(!std::is_constructible_v<double_interval, long double>);
static_assert(!std::is_constructible_v<double_interval, bool>);
static_assert(std::is_convertible_v<int, double_interval>);
static_assert(std::is_convertible_v<unsigned long, double_interval>);
static_assert(std::is_convertible_v<rational, double_interval>);
static_assert(std::is_trivially_copyable_v<double_interval>);
static_assert(sizeof(double_interval) == 2 * sizeof(double));

// ---------------------------------------------------------------------------------------------
// Random doubles.

/// Doubles in their order as integers: neighbours differ by 1.
std::int64_t rank(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
}
double of_rank(std::int64_t r) {
  return std::bit_cast<double>(r >= 0 ? r : std::numeric_limits<std::int64_t>::min() - r);
}
double moved(double x, long steps) {
  const std::int64_t limit = rank(largest_double);
  return of_rank(std::clamp(rank(x) + steps, -limit, limit));
}

/// Where the approximations change their ways, or the functions do.
double landmark(random_source& random) {
  static constexpr std::array fixed = {
      0.0,      1.0,    0.5,     0.25,      2.0,       0.75,     0.0625,  40.0,
      22.0,     0x1p28, 0x1p20,  0x1p-54,   0x1p-27,   0x1p27,   -0.2928, 0.4142,
      0.70710,  1.4142, 708.396, 709.7827,  745.13,    710.4758, 0x1p500, 0x1p-500,
      0x1p-511, 36.7,   18.7,    0x1p-1022, 0x1p-1074,
  };
  const double sign = random.one_in(2) ? 1 : -1;
  switch (random.between(0, 3)) {
    case 0:  // multiples of pi/4
      return sign * static_cast<double>(random.between(0, random.one_in(2) ? 30 : 1335000)) *
             0x1.921fb54442d18p-1;
    case 1:  // multiples of log(2)/2
      return sign * static_cast<double>(random.between(0, random.one_in(2) ? 10 : 2100)) *
             0x1.62e42fefa39efp-2;
    case 2:  // sixteenths, and their reciprocals
      return sign * (random.one_in(2) ? static_cast<double>(random.between(0, 48)) / 16
                                      : 16 / static_cast<double>(random.between(1, 48)));
    default:
      return sign * random.choose(fixed);
  }
}

struct domain {
  double lower = -largest_double;
  double upper = largest_double;
  [[nodiscard]] bool holds(double x) const { return lower <= x && x <= upper; }
};

/// Of any size, uniform, near a landmark, or near an end.
double any_double(random_source& random, domain in = {}) {
  while (true) {
    double x = 0;
    switch (random.between(0, 5)) {
      case 0:
      case 1:
        x = of_rank(random.between(rank(in.lower), rank(in.upper)));
        break;
      case 2: {
        const domain near{std::max(in.lower, -8.0), std::min(in.upper, 8.0)};
        x = near.lower +
            (near.upper - near.lower) * static_cast<double>(random.bits() >> 11) * 0x1p-53;
        break;
      }
      case 3: {
        const domain near{std::max(in.lower, -800.0), std::min(in.upper, 800.0)};
        x = near.lower +
            (near.upper - near.lower) * static_cast<double>(random.bits() >> 11) * 0x1p-53;
        break;
      }
      case 4:
        x = moved(landmark(random), random.between(-3, 3));
        if (random.one_in(3)) x += x * std::ldexp(1.0, static_cast<int>(random.between(-52, -3)));
        break;
      default: {
        const std::int64_t low = rank(in.lower);
        const std::int64_t high = rank(in.upper);
        const auto apart = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
        const auto away =
            static_cast<std::int64_t>(std::min(random.bits() >> random.between(8, 63), apart / 2));
        x = of_rank(random.one_in(2) ? low + away : high - away);
      }
    }
    if (in.holds(x)) return x;
  }
}

double_interval any_interval(random_source& random, domain in = {}) {
  double a = any_double(random, in);
  double b = 0;
  switch (random.between(0, 3)) {
    case 0:
      b = a;
      break;
    case 1:
      b = moved(a, random.between(1, 20));
      break;
    case 2:
      b = a + std::abs(a) * std::ldexp(1.0, static_cast<int>(random.between(-50, 2)));
      break;
    default:
      b = any_double(random, in);
  }
  b = std::clamp(b, in.lower, in.upper);
  return {std::min(a, b), std::max(a, b)};
}
/// Also unbounded ones.
double_interval any_set(random_source& random) {
  const double_interval x = any_interval(random);
  switch (random.between(0, 20)) {
    case 0:
      return {-infinity, x.upper()};
    case 1:
      return {x.lower(), infinity};
    case 2:
      return double_interval::entire();
    default:
      return x;
  }
}

/// A double in the set: an end, or one next to it, or any.
double member(random_source& random, double_interval x) {
  const double low = std::max(x.lower(), -largest_double);
  const double high = std::min(x.upper(), largest_double);
  switch (random.between(0, 4)) {
    case 0:
      return low;
    case 1:
      return high;
    case 2:
      return random.one_in(2) ? std::min(moved(low, random.between(1, 3)), high)
                              : std::max(moved(high, -random.between(1, 3)), low);
    case 3:
      return std::clamp(low / 2 + high / 2, low, high);
    default:
      return any_double(random, {low, high});
  }
}
double_interval inside(random_source& random, double_interval x) {
  double a = random.one_in(3) ? x.lower() : member(random, x);
  double b = random.one_in(3) ? x.upper() : member(random, x);
  if (b < a) std::swap(a, b);
  return {a, b};
}

real exactly(double x) {
  real r(53);
  mpfr_set_d(r, x, MPFR_RNDN);
  return r;
}

std::string described(double_interval x) {
  char text[100];
  std::snprintf(text, sizeof text, "[%a, %a]", x.lower(), x.upper());
  return x.is_undefined() ? "undefined" : text;
}
bool identical(double_interval x, double_interval y) {
  return x.is_undefined() == y.is_undefined() &&
         std::bit_cast<std::uint64_t>(x.lower()) == std::bit_cast<std::uint64_t>(y.lower()) &&
         std::bit_cast<std::uint64_t>(x.upper()) == std::bit_cast<std::uint64_t>(y.upper());
}
#define EXPECT_IDENTICAL(x, y) \
  EXPECT_TRUE(identical(x, y)) << described(x) << " and " << described(y)

/// f(r, rounding) computes a number; the set holds it.
template <class F>
::testing::AssertionResult holds(double_interval set, F&& f) {
  real low(oracle_bits);
  real high(oracle_bits);
  f(low.get(), MPFR_RNDD);
  f(high.get(), MPFR_RNDU);
  if (mpfr_nan_p(low) != 0) return ::testing::AssertionFailure() << "the oracle has no value";
  if (!set.is_undefined() && mpfr_cmp_d(low, set.lower()) >= 0 &&
      mpfr_cmp_d(high, set.upper()) <= 0) {
    return ::testing::AssertionSuccess();
  }
  char text[100];
  mpfr_snprintf(text, sizeof text, "%.25Rg (%.6Ra)", low.get(), low.get());
  return ::testing::AssertionFailure() << text << " is not in " << described(set);
}

/// |end - f| <= relative |f| + 8 * 2^-1074, or end is where an overflow puts it.
template <class F>
::testing::AssertionResult is_near(double end, double relative, F&& f) {
  real value(oracle_bits);
  f(value.get(), MPFR_RNDN);
  if (std::abs(end) >= largest_double) {
    real size(oracle_bits);
    mpfr_abs(size, value, MPFR_RNDN);
    mpfr_mul_d(size, size, 1 + 0x1p-46, MPFR_RNDU);
    if (mpfr_cmp_d(size, largest_double) >= 0) return ::testing::AssertionSuccess();
  }
  real distance(oracle_bits);
  mpfr_sub_d(distance, value, end, MPFR_RNDN);
  mpfr_abs(distance, distance, MPFR_RNDN);
  real allowed(oracle_bits);
  mpfr_abs(allowed, value, MPFR_RNDN);
  mpfr_mul_d(allowed, allowed, relative, MPFR_RNDN);
  mpfr_add_d(allowed, allowed, 8 * least_double, MPFR_RNDN);
  if (mpfr_lessequal_p(distance, allowed) != 0) return ::testing::AssertionSuccess();
  char text[200];
  mpfr_snprintf(text, sizeof text, "the end %a is %.5Rg away from %.25Rg, allowed are %.5Rg", end,
                distance.get(), value.get(), allowed.get());
  return ::testing::AssertionFailure() << text;
}

// ---------------------------------------------------------------------------------------------

TEST(DoubleIntervalEnvironment, IsAsAssumed) {
  EXPECT_TRUE(double_interval::environment_is_sound());
}

TEST(DoubleIntervalEnvironment, IsNotSoundWithAnotherRoundingMode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const bool sound = double_interval::environment_is_sound();
    std::fesetround(FE_TONEAREST);
    EXPECT_FALSE(sound) << mode;
  }
#ifdef __SSE2__
  const unsigned before = _mm_getcsr();
  for (const unsigned flags : {0x8000U, 0x0040U}) {  // results, or operands, flushed to zero
    _mm_setcsr(before | flags);
    const bool sound = double_interval::environment_is_sound();
    _mm_setcsr(before);
    EXPECT_FALSE(sound) << flags;
  }
#endif
}

TEST(DoubleIntervalConstants, AgreeWithMpfr) {
  real pi(400);
  mpfr_const_pi(pi, MPFR_RNDN);
  real half(400);
  mpfr_div_2ui(half, pi, 1, MPFR_RNDN);
  real t(400);
  EXPECT_EQ(mpfr_get_d(half, MPFR_RNDN), point::half_pi);
  EXPECT_GT(mpfr_cmp_d(half, point::half_pi), 0);
  EXPECT_LT(mpfr_cmp_d(half, detail::next_up(point::half_pi)), 0);
  // The errors that the proofs use, in units of 2^-53.
  mpfr_sub_d(t, half, point::half_pi, MPFR_RNDN);
  EXPECT_LT(mpfr_cmp_d(t, 0.56 * 0x1p-53), 0);

  mpfr_ui_div(t, 1, half, MPFR_RNDN);
  EXPECT_EQ(mpfr_get_d(t, MPFR_RNDN), point::two_over_pi);

  const auto is_multiple_of = [](double x, double unit) {
    return std::floor(x / unit) == x / unit;
  };
  EXPECT_TRUE(is_multiple_of(point::half_pi_1, 0x1p-31));
  EXPECT_TRUE(is_multiple_of(point::half_pi_2, 0x1p-63));
  EXPECT_LT(std::abs(point::half_pi_2), 0x1p-32);
  EXPECT_LT(std::abs(point::half_pi_3), 0x1p-64);
  mpfr_sub_d(t, half, point::half_pi_1, MPFR_RNDN);
  mpfr_sub_d(t, t, point::half_pi_2, MPFR_RNDN);
  mpfr_sub_d(t, t, point::half_pi_3, MPFR_RNDN);
  EXPECT_LT(std::abs(mpfr_get_d(t, MPFR_RNDA)), 0x1p-118);

  real log_2(400);
  mpfr_const_log2(log_2, MPFR_RNDN);
  mpfr_ui_div(t, 1, log_2, MPFR_RNDN);
  EXPECT_EQ(mpfr_get_d(t, MPFR_RNDN), point::log2_e);
  EXPECT_TRUE(is_multiple_of(point::log_2_high, 0x1p-42));
  EXPECT_LT(std::abs(point::log_2_low), 0x1p-43);
  mpfr_sub_d(t, log_2, point::log_2_high, MPFR_RNDN);
  mpfr_sub_d(t, t, point::log_2_low, MPFR_RNDN);
  EXPECT_LT(std::abs(mpfr_get_d(t, MPFR_RNDA)), 0x1p-96);

  for (long j = 0; j <= 8; ++j) {
    mpfr_set_si_2exp(t, j, -3, MPFR_RNDN);
    mpfr_atan(t, t, MPFR_RNDN);
    EXPECT_EQ(mpfr_get_d(t, MPFR_RNDN), point::atan_of_eighths[j]) << j;
  }
}

TEST(DoubleIntervalSteps, AreThoseOfTheStandardLibrary) {
  random_source random(1);
  const auto check = [](double x) {
    EXPECT_EQ(detail::next_up(x), std::nextafter(x, infinity)) << x;
    EXPECT_EQ(detail::next_down(x), std::nextafter(x, -infinity)) << x;
  };
  for (const double x :
       {0.0, -0.0, least_double, -least_double, least_normal_double, -least_normal_double, 1.0,
        -1.0, largest_double, -largest_double, infinity, -infinity}) {
    check(x);
  }
  for (repeat trial(10000); trial.again();) check(any_double(random));
  EXPECT_TRUE(std::isnan(detail::next_up(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(detail::next_down(-std::numeric_limits<double>::quiet_NaN())));
}

// ---------------------------------------------------------------------------------------------
// The proved bounds.

using mpfr_function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

struct approximation {
  const char* name;
  double (*value)(double);
  mpfr_function exact;
  double bound;
  domain in;
  double absolute = 0;  // beside the bound, for |x| > pi/4
};

double value_of_exp(double x) {
  const point::scaled e = point::exp(x);
  return e.fraction * std::ldexp(1.0, static_cast<int>(e.exponent));
}

const std::vector<approximation>& approximations() {
  static const double below_one = std::nextafter(1.0, 0.0);
  static const std::vector<approximation> all = {
      {"exp", value_of_exp, mpfr_exp, point::exp_bound, {-708, 709}},
      {"expm1", point::expm1, mpfr_expm1, point::expm1_bound, {-40, 40}},
      {"log",
       [](double x) { return point::log(x); },
       mpfr_log,
       point::log_bound,
       {least_double, largest_double}},
      {"log1p", point::log1p, mpfr_log1p, point::log1p_bound, {-below_one, largest_double}},
      {"sin",
       [](double x) { return point::sin_cos(x).sine; },
       mpfr_sin,
       point::circular_bound,
       {-0x1p20, 0x1p20},
       point::circular_absolute},
      {"cos",
       [](double x) { return point::sin_cos(x).cosine; },
       mpfr_cos,
       point::circular_bound,
       {-0x1p20, 0x1p20},
       point::circular_absolute},
      {"atan",
       [](double x) { return point::angle(x, 1); },
       mpfr_atan,
       point::angle_bound,
       {0, largest_double}},
      {"asin", point::asin, mpfr_asin, point::asin_bound, {-1, 1}},
      {"acos", point::acos, mpfr_acos, point::asin_bound, {-1, 1}},
      {"sinh", point::sinh, mpfr_sinh, point::sinh_bound, {0, 40}},
      {"cosh", point::cosh, mpfr_cosh, point::cosh_bound, {0, 40}},
      {"tanh", point::tanh, mpfr_tanh, point::sinh_bound, {0, largest_double}},
      {"asinh", point::asinh, mpfr_asinh, point::sinh_bound, {0, largest_double}},
      {"acosh", point::acosh, mpfr_acosh, point::sinh_bound, {1, largest_double}},
      {"atanh", point::atanh, mpfr_atanh, point::sinh_bound, {0, below_one}},
  };
  return all;
}

/// |value - exact| / |value| in units of 2^-53, less the absolute error allowed.
double error_in_units(double value, mpfr_srcptr exact, double absolute) {
  real error(oracle_bits);
  mpfr_sub_d(error, exact, value, MPFR_RNDN);
  mpfr_abs(error, error, MPFR_RNDN);
  mpfr_sub_d(error, error, absolute, MPFR_RNDN);
  if (mpfr_sgn(error.get()) <= 0) return 0;
  if (value == 0) return infinity;
  mpfr_div_d(error, error, std::abs(value), MPFR_RNDU);
  return std::max(0.0, mpfr_get_d(error, MPFR_RNDU) * 0x1p53);
}

TEST(DoubleIntervalApproximations, StayWithinTheirProvedBounds) {
  random_source random(2);
  for (const approximation& f : approximations()) {
    double worst = 0;
    double at = 0;
    for (repeat trial(15000); trial.again();) {
      const double x = any_double(random, f.in);
      const double value = f.value(x);
      real exact(120);
      f.exact(exact, exactly(x), MPFR_RNDN);
      const double absolute = (std::abs(x) > 0.78 ? f.absolute : 0) +
                              (std::abs(value) < least_normal_double ? 0.51 * least_double : 0);
      const double error = error_in_units(value, exact, absolute);
      if (error > worst) {
        worst = error;
        at = x;
      }
    }
    std::printf("  %-6s at most %5.2f u of %2.0f u, u = 2^-53, at %a\n", f.name, worst,
                f.bound * 0x1p53, at);
    RecordProperty(f.name, std::to_string(worst));
    EXPECT_LE(worst, f.bound * 0x1p53) << f.name << " at " << at;
  }
}

TEST(DoubleIntervalApproximations, OfAnglesStayWithinTheirProvedBound) {
  random_source random(3);
  double worst = 0;
  for (repeat trial(60000); trial.again();) {
    const double y = any_double(random, {0, largest_double});
    const double x = random.one_in(2)
                         ? any_double(random)
                         : std::clamp(y * (static_cast<double>(random.between(-80, 80)) / 16 +
                                           static_cast<double>(random.bits() >> 11) * 0x1p-57),
                                      -largest_double, largest_double);
    if (x == 0 && y == 0) continue;
    const double value = point::angle(y, x);
    real exact(120);
    mpfr_atan2(exact, exactly(y), exactly(x), MPFR_RNDN);
    if (value < 2 * least_normal_double) {
      EXPECT_TRUE(is_near(value, point::angle_bound,
                          [&](mpfr_ptr r, mpfr_rnd_t) { mpfr_set(r, exact, MPFR_RNDN); }));
    } else {
      worst = std::max(worst, error_in_units(value, exact, 0));
    }
  }
  std::printf("  angle  at most %5.2f u of %2.0f u\n", worst, point::angle_bound * 0x1p53);
  EXPECT_LE(worst, point::angle_bound * 0x1p53);
}

/// The doubles nearest to multiples of pi/2, where a reduction that is not careful has no digit
/// left.
TEST(DoubleIntervalApproximations, NearMultiplesOfHalfPi) {
  random_source random(4);
  real half_pi(300);
  mpfr_const_pi(half_pi, MPFR_RNDN);
  mpfr_div_2ui(half_pi, half_pi, 1, MPFR_RNDN);
  real t(300);
  for (repeat trial(15000); trial.again();) {
    mpfr_mul_si(t, half_pi, random.between(-667543, 667543), MPFR_RNDN);
    const double x = moved(mpfr_get_d(t, MPFR_RNDN), random.between(-1, 1));
    if (std::abs(x) > 0x1p20) continue;
    const point::circular value = point::sin_cos(x);
    EXPECT_LE(value.absolute, point::circular_absolute_at_multiples);
    mpfr_sin(t, exactly(x), MPFR_RNDN);
    EXPECT_LE(error_in_units(value.sine, t, value.absolute), point::circular_bound * 0x1p53);
    mpfr_cos(t, exactly(x), MPFR_RNDN);
    EXPECT_LE(error_in_units(value.cosine, t, value.absolute), point::circular_bound * 0x1p53);
    // Both functions keep their digits there, and so does tan.
    for (const double_interval& y :
         {sin(double_interval(x)), cos(double_interval(x)), tan(double_interval(x))}) {
      if (x == 0 || y.is_undefined()) continue;
      EXPECT_LE(y.width(), 0x1p-46 * y.mignitude()) << x;
    }
  }
}

/// Between the careful reduction beside the multiples and the plain one.
TEST(DoubleIntervalApproximations, NotFarFromMultiplesOfHalfPi) {
  random_source random(41);
  real half_pi(300);
  mpfr_const_pi(half_pi, MPFR_RNDN);
  mpfr_div_2ui(half_pi, half_pi, 1, MPFR_RNDN);
  real t(300);
  for (repeat trial(15000); trial.again();) {
    mpfr_mul_si(t, half_pi, random.between(-667543, 667543), MPFR_RNDN);
    const double step =
        std::ldexp(random.one_in(2) ? 1.0 : 1.5, static_cast<int>(-random.between(25, 40)));
    const double x = mpfr_get_d(t, MPFR_RNDN) + (random.one_in(2) ? step : -step);
    if (std::abs(x) > 0x1p20) continue;
    const point::circular value = point::sin_cos(x);
    mpfr_sin(t, exactly(x), MPFR_RNDN);
    EXPECT_LE(error_in_units(value.sine, t, value.absolute), point::circular_bound * 0x1p53) << x;
    mpfr_cos(t, exactly(x), MPFR_RNDN);
    EXPECT_LE(error_in_units(value.cosine, t, value.absolute), point::circular_bound * 0x1p53) << x;
  }
}

// ---------------------------------------------------------------------------------------------
// Functions of intervals.

using of_interval = double_interval (*)(double_interval);

struct function {
  const char* name;
  double_interval (*of)(double_interval);
  mpfr_function exact;
  double bound;
  domain in;
  bool is_monotone = true;
  double absolute = 0;
};

double_interval sine_of_both(double_interval x) { return sin_cos(x).first; }
double_interval cosine_of_both(double_interval x) { return sin_cos(x).second; }

const std::vector<function>& functions() {
  static const double below_one = std::nextafter(1.0, 0.0);
  static const std::vector<function> all = {
      {"sqrt", [](double_interval x) { return sqrt(x); }, mpfr_sqrt, 0x1p-52, {0, largest_double}},
      {"square", [](double_interval x) { return square(x); }, mpfr_sqr, 0x1p-52, {}, false},
      {"abs", [](double_interval x) { return abs(x); }, mpfr_abs, 0, {}, false},
      {"exp", exp, mpfr_exp, point::exp_bound, {}},
      {"expm1", expm1, mpfr_expm1, point::expm1_bound, {}},
      {"log", log, mpfr_log, point::log_bound, {least_double, largest_double}},
      {"log1p", log1p, mpfr_log1p, point::log1p_bound, {-below_one, largest_double}},
      {"sin",
       sin,
       mpfr_sin,
       point::circular_bound,
       {-0x1p20, 0x1p20},
       false,
       point::circular_absolute},
      {"cos",
       cos,
       mpfr_cos,
       point::circular_bound,
       {-0x1p20, 0x1p20},
       false,
       point::circular_absolute},
      {"sin of both",
       sine_of_both,
       mpfr_sin,
       point::circular_bound,
       {-0x1p20, 0x1p20},
       false,
       point::circular_absolute},
      {"cos of both",
       cosine_of_both,
       mpfr_cos,
       point::circular_bound,
       {-0x1p20, 0x1p20},
       false,
       point::circular_absolute},
      {"tan", tan, mpfr_tan, 0x1p-48, {-1.57, 1.57}, true, point::circular_absolute},
      {"asin", asin, mpfr_asin, point::asin_bound, {-1, 1}},
      {"acos", acos, mpfr_acos, point::asin_bound, {-1, 1}},
      {"atan", atan, mpfr_atan, point::angle_bound, {}},
      {"sinh", sinh, mpfr_sinh, point::sinh_bound, {}},
      {"cosh", cosh, mpfr_cosh, point::cosh_bound, {}, false},
      {"tanh", tanh, mpfr_tanh, point::sinh_bound, {}},
      {"asinh", asinh, mpfr_asinh, point::sinh_bound, {}},
      {"acosh", acosh, mpfr_acosh, point::sinh_bound, {1, largest_double}},
      {"atanh", atanh, mpfr_atanh, point::sinh_bound, {-below_one, below_one}},
  };
  return all;
}

// Beyond 750, exp and its kin have nothing to be computed by MPFR but a huge exponent.
domain reasonable(const function& f) {
  const std::string name = f.name;
  if (name == "exp" || name == "expm1" || name == "sinh" || name == "cosh") return {-1e6, 1e6};
  return f.in;
}

TEST(DoubleIntervalFunctions, HoldTheValuesOfMembers) {
  random_source random(5);
  for (const function& f : functions()) {
    SCOPED_TRACE(f.name);
    for (repeat trial(3000); trial.again();) {
      const double_interval x = any_interval(random, reasonable(f));
      const double_interval y = f.of(x);
      for (int i = 0; i < 3; ++i) {
        const real m = exactly(member(random, x));
        EXPECT_TRUE(holds(y, [&](mpfr_ptr r, mpfr_rnd_t rounding) { f.exact(r, m, rounding); }))
            << "f of " << described(x) << " at " << mpfr_get_d(m, MPFR_RNDN);
      }
    }
  }
}

TEST(DoubleIntervalFunctions, AreTight) {
  random_source random(6);
  for (const function& f : functions()) {
    SCOPED_TRACE(f.name);
    const double allowed = f.bound == 0 ? 0 : 2 * f.bound + 0x1p-51;
    for (repeat trial(3000); trial.again();) {
      const double_interval x = f.is_monotone ? any_interval(random, reasonable(f))
                                              : double_interval(any_double(random, reasonable(f)));
      const double_interval y = f.of(x);
      const bool falls = std::string(f.name) == "acos";
      const auto is_tight = [&](double end, double at) {
        // Where an absolute error is granted, at a value that is not tiny it is nothing.
        real value(oracle_bits);
        f.exact(value, exactly(at), MPFR_RNDN);
        if (f.absolute > 0 && std::abs(mpfr_get_d(value, MPFR_RNDN)) < 0x1p-30 &&
            std::abs(at) > 0.78)
          return;
        EXPECT_TRUE(
            is_near(end, allowed,
                    [&](mpfr_ptr r, mpfr_rnd_t rounding) { f.exact(r, exactly(at), rounding); }))
            << described(x) << " to " << described(y);
      };
      is_tight(y.lower(), falls ? x.upper() : x.lower());
      is_tight(y.upper(), falls ? x.lower() : x.upper());
    }
  }
}

double_interval enlarged(double_interval x, double relative) {
  if (x.is_undefined()) return x;
  const auto by = [relative](double end) {
    return std::abs(end) < infinity ? relative * std::abs(end) + 8 * least_double : 0;
  };
  return {std::max(x.lower() - by(x.lower()), -infinity), x.upper() + by(x.upper())};
}

TEST(DoubleIntervalFunctions, AreMonotoneInTheirOperand) {
  random_source random(7);
  for (const function& f : functions()) {
    SCOPED_TRACE(f.name);
    for (repeat trial(4000); trial.again();) {
      const double_interval x = any_interval(random, f.in);
      const double_interval part = inside(random, x);
      const double_interval y = f.of(x);
      const double_interval of_part = f.of(part);
      const double noise = f.bound > 0x1p-52 ? 2 * f.bound + 0x1p-51 : 0;
      EXPECT_TRUE(contains(
          f.absolute == 0 ? (noise == 0 ? y : enlarged(y, noise))
                          : enlarged(y, noise) + double_interval(-4 * f.absolute, 4 * f.absolute),
          of_part))
          << described(part) << " to " << described(of_part) << "\n"
          << described(x) << " to " << described(y);
      // With an end in common, an end of the result is at least as far out.
      const bool falls = std::string(f.name) == "acos";
      if (f.is_monotone && part.lower() == x.lower()) {
        EXPECT_EQ(falls ? y.upper() : y.lower(), falls ? of_part.upper() : of_part.lower());
      }
    }
  }
}

TEST(DoubleIntervalFunctions, OfUnboundedSets) {
  constexpr double inf = infinity;
  const auto all = double_interval::entire();
  const double_interval positive(0, inf);
  EXPECT_IDENTICAL(exp(all), positive);
  EXPECT_IDENTICAL(exp(positive), double_interval(1, inf));
  EXPECT_IDENTICAL(expm1(all), double_interval(-1, inf));
  EXPECT_IDENTICAL(log(double_interval(1, inf)), positive);
  EXPECT_IDENTICAL(log1p(positive), positive);
  EXPECT_IDENTICAL(sqrt(positive), positive);
  EXPECT_IDENTICAL(square(all), positive);
  EXPECT_IDENTICAL(abs(all), positive);
  EXPECT_IDENTICAL(sin(all), double_interval(-1, 1));
  EXPECT_IDENTICAL(cos(positive), double_interval(-1, 1));
  EXPECT_TRUE(tan(all).is_undefined());
  const double up = std::nextafter(point::half_pi, 2.0);
  EXPECT_IDENTICAL(atan(all), double_interval(-up, up));
  EXPECT_IDENTICAL(sinh(all), all);
  EXPECT_IDENTICAL(cosh(all), double_interval(1, inf));
  EXPECT_IDENTICAL(tanh(all), double_interval(-1, 1));
  EXPECT_IDENTICAL(asinh(all), all);
  EXPECT_IDENTICAL(acosh(double_interval(1, inf)), positive);
  EXPECT_IDENTICAL(pow(all, 3), all);
  EXPECT_IDENTICAL(pow(all, 2), positive);
  EXPECT_IDENTICAL(hypot(all, all), positive);
}

TEST(DoubleIntervalFunctions, AreExactWhereTheyCanBe) {
  const double_interval zero = 0;
  const double_interval one = 1;
  for (const of_interval f : std::initializer_list<of_interval>{expm1, log1p, sin, tan, asin, atan,
                                                                sinh, tanh, asinh, atanh})
    EXPECT_IDENTICAL(f(zero), zero);
  for (const of_interval f : std::initializer_list<of_interval>{exp, cos, cosh})
    EXPECT_IDENTICAL(f(zero), one);
  for (const of_interval f : std::initializer_list<of_interval>{log, acosh, acos})
    EXPECT_IDENTICAL(f(one), zero);
  for (int n = 0; n < 1000; ++n) EXPECT_IDENTICAL(sqrt(double_interval(n * n)), double_interval(n));
  EXPECT_IDENTICAL(sqrt(double_interval(4, 9)), double_interval(2, 3));
  // Next to a square, the root rounds to an integer that is not the root.
  for (int n = 1; n < 1000; ++n) {
    for (const long step : {-1L, 1L}) {
      const real x = exactly(moved(static_cast<double>(n) * n, step));
      EXPECT_TRUE(holds(sqrt(double_interval(mpfr_get_d(x, MPFR_RNDN))), [&](mpfr_ptr r,
                                                                             mpfr_rnd_t rounding) {
        mpfr_sqrt(r, x, rounding);
      })) << n;
    }
  }
  EXPECT_IDENTICAL(hypot(double_interval(-3), zero), double_interval(3));
}

TEST(DoubleIntervalFunctions, NeverLeaveTheirRanges) {
  random_source random(8);
  for (repeat trial(20000); trial.again();) {
    const double_interval x = any_set(random);
    EXPECT_TRUE(contains(double_interval(-1, 1), sin(x))) << described(x);
    EXPECT_TRUE(contains(double_interval(-1, 1), cos(x))) << described(x);
    EXPECT_TRUE(contains(double_interval(-1, 1), tanh(x))) << described(x);
    EXPECT_GE(cosh(x).lower(), 1);
    EXPECT_GE(exp(x).lower(), 0);
    EXPECT_GE(expm1(x).lower(), -1);
    EXPECT_GE(square(x).lower(), 0);
    EXPECT_LE(atan(x).magnitude(), std::nextafter(point::half_pi, 2.0));
  }
}

TEST(DoubleIntervalFunctions, AreUndefinedOutsideTheirDomains) {
  const double above_one = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(sqrt(double_interval(-least_double, 1)).is_undefined());
  EXPECT_TRUE(log(double_interval(0, 1)).is_undefined());
  EXPECT_TRUE(log(double_interval(-1, 1)).is_undefined());
  EXPECT_TRUE(log1p(double_interval(-1, 1)).is_undefined());
  EXPECT_TRUE(asin(double_interval(0, above_one)).is_undefined());
  EXPECT_TRUE(asin(double_interval(-above_one, 0)).is_undefined());
  EXPECT_TRUE(acos(double_interval(0, above_one)).is_undefined());
  EXPECT_TRUE(acosh(double_interval(std::nextafter(1.0, 0.0), 2)).is_undefined());
  EXPECT_TRUE(atanh(double_interval(0, 1)).is_undefined());
  EXPECT_TRUE(atanh(double_interval(-1, 0)).is_undefined());
  EXPECT_TRUE(tan(double_interval(1, 2)).is_undefined());
  EXPECT_TRUE(tan(double_interval(point::half_pi, detail::next_up(point::half_pi))).is_undefined());
  EXPECT_FALSE(tan(double_interval(point::half_pi)).is_undefined());
  EXPECT_TRUE(tan(double_interval(0, 3.5)).is_undefined());
  EXPECT_FALSE(tan(double_interval(2, 4)).is_undefined());
  EXPECT_TRUE(pow(double_interval(-1, 1), -1).is_undefined());
}

TEST(DoubleIntervalFunctions, PassTheExtremaOfTheCircle) {
  random_source random(9);
  for (repeat trial(20000); trial.again();) {
    const double a = any_double(random, {-1000, 1000});
    const double b = a + static_cast<double>(random.bits() >> 11) * 0x1p-50;  // up to 8 further
    const double_interval x(a, b);
    const double_interval s = sin(x);
    const double_interval c = cos(x);
    // Which extrema are inside, by the number of half circles; decided at 200 bits.
    const auto passes = [&](double offset) {  // some offset pi/2 + 2 pi j in [a, b]
      const auto turns = [&](double end, mpfr_rnd_t rounding) {
        real t(oracle_bits);
        real whole(oracle_bits);
        mpfr_const_pi(t, MPFR_RNDN);
        mpfr_mul_d(whole, t, offset / 2, MPFR_RNDN);
        mpfr_d_sub(whole, end, whole, MPFR_RNDN);
        mpfr_div(whole, whole, t, MPFR_RNDN);
        mpfr_div_2ui(whole, whole, 1, MPFR_RNDN);
        return mpfr_get_si(whole, rounding);
      };
      return turns(a, MPFR_RNDU) <= turns(b, MPFR_RNDD);
    };
    if (passes(1)) {
      EXPECT_EQ(s.upper(), 1) << described(x);
    }
    if (passes(3)) {
      EXPECT_EQ(s.lower(), -1) << described(x);
    }
    if (passes(0)) {
      EXPECT_EQ(c.upper(), 1) << described(x);
    }
    if (passes(2)) {
      EXPECT_EQ(c.lower(), -1) << described(x);
    }
    const auto [both_s, both_c] = sin_cos(x);
    EXPECT_IDENTICAL(both_s, s);
    EXPECT_IDENTICAL(both_c, c);
    // Where an extremum is not inside, the end is a value at an end.
    const auto at = [&](mpfr_function f, double end) {
      real r(oracle_bits);
      f(r, exactly(end), MPFR_RNDN);
      return mpfr_get_d(r, MPFR_RNDN);
    };
    constexpr double room = 0x1p-48;
    if (!passes(1)) {
      EXPECT_LE(s.upper(), std::max(at(mpfr_sin, a), at(mpfr_sin, b)) + room) << described(x);
    }
    if (!passes(3)) {
      EXPECT_GE(s.lower(), std::min(at(mpfr_sin, a), at(mpfr_sin, b)) - room) << described(x);
    }
    if (!passes(0)) {
      EXPECT_LE(c.upper(), std::max(at(mpfr_cos, a), at(mpfr_cos, b)) + room) << described(x);
    }
    if (!passes(2)) {
      EXPECT_GE(c.lower(), std::min(at(mpfr_cos, a), at(mpfr_cos, b)) - room) << described(x);
    }
    // tan: undefined exactly where a pole is inside.
    EXPECT_EQ(tan(x).is_undefined(), passes(1) || passes(3)) << described(x);
    if (!tan(x).is_undefined()) {
      const real m = exactly(member(random, x));
      EXPECT_TRUE(
          holds(tan(x), [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_tan(r, m, rounding); }));
    }
  }
}

TEST(DoubleIntervalFunctions, SayWhenAnArgumentIsTooLarge) {
  const double_interval large(0x1p21, 0x1p21 + 1);
  EXPECT_TRUE(needs_wider_range(large));
  EXPECT_TRUE(needs_wider_range(-large));
  EXPECT_IDENTICAL(sin(large), double_interval(-1, 1));
  EXPECT_IDENTICAL(cos(-large), double_interval(-1, 1));
  EXPECT_TRUE(tan(large).is_undefined());
  EXPECT_FALSE(needs_wider_range(double_interval(0x1p20)));
  EXPECT_FALSE(needs_wider_range(double_interval(-1, 0x1p30)));  // [-1, 1] is the range
  EXPECT_FALSE(needs_wider_range(double_interval::entire()));
  EXPECT_FALSE(needs_wider_range(double_interval::undefined()));
}

TEST(DoubleIntervalFunctions, OverflowAndUnderflowSoundly) {
  EXPECT_IDENTICAL(exp(double_interval(1000)), double_interval(largest_double, infinity));
  EXPECT_IDENTICAL(exp(double_interval(-1000)), double_interval(0, least_double));
  EXPECT_TRUE(exp(double_interval(1000)).is_out_of_range());
  EXPECT_TRUE(exp(double_interval(-1000)).is_out_of_range());
  EXPECT_TRUE(exp(double_interval(-740)).is_out_of_range());
  EXPECT_FALSE(exp(double_interval(-700)).is_out_of_range());
  EXPECT_FALSE(double_interval(0, 1).is_out_of_range());
  EXPECT_FALSE(double_interval(0).is_out_of_range());
  EXPECT_TRUE(double_interval(-1, infinity).is_out_of_range());
  EXPECT_TRUE(double_interval(-infinity, 1).is_out_of_range());
  EXPECT_TRUE(double_interval(-1, least_double).is_out_of_range());
  EXPECT_FALSE(double_interval::undefined().is_out_of_range());
  EXPECT_IDENTICAL(sinh(double_interval(-1000)), double_interval(-infinity, -largest_double));
  EXPECT_IDENTICAL(cosh(double_interval(-1000)), double_interval(largest_double, infinity));
  EXPECT_TRUE(cosh(double_interval(710.3)).is_bounded());
  const double_interval huge(largest_double);
  EXPECT_IDENTICAL(huge + huge, double_interval(largest_double, infinity));
  EXPECT_IDENTICAL(huge * huge, double_interval(largest_double, infinity));
  EXPECT_IDENTICAL(-huge * huge, double_interval(-infinity, -largest_double));
  EXPECT_EQ(pow(huge, -5).lower(), 0);
  EXPECT_LE(pow(huge, -5).upper(), 0x1p-1023);
  EXPECT_GT(pow(huge, -5).upper(), 0);
  EXPECT_IDENTICAL(pow(-huge, 5), double_interval(-infinity, -largest_double));
  EXPECT_IDENTICAL(pow(double_interval(-1e-200), -2), double_interval(largest_double, infinity));
  EXPECT_IDENTICAL(pow(double_interval(-1e-200), -3), double_interval(-infinity, -largest_double));
  EXPECT_IDENTICAL(scale(huge, 1), double_interval(largest_double, infinity));
  EXPECT_IDENTICAL(scale(huge, std::numeric_limits<long>::min()), double_interval(0, least_double));
  EXPECT_IDENTICAL(hypot(huge, double_interval(0)), huge);
}

TEST(DoubleIntervalFunctions, OfRectangles) {
  random_source random(10);
  for (repeat trial(30000); trial.again();) {
    const double_interval x = any_interval(random);
    const double_interval y = any_interval(random);
    const double_interval angle = atan2(y, x);
    const bool meets_cut = contains_zero(y) && x.lower() <= 0;
    EXPECT_EQ(angle.is_undefined(), meets_cut) << described(y) << described(x);
    if (!meets_cut) {
      const real s = exactly(member(random, x));
      const real t = exactly(member(random, y));
      EXPECT_TRUE(
          holds(angle, [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_atan2(r, t, s, rounding); }))
          << described(y) << described(x);
      const double_interval part = atan2(inside(random, y), inside(random, x));
      EXPECT_TRUE(contains(enlarged(angle, 0x1p-48), part)) << described(y) << described(x);
      if (x.is_exact() && y.is_exact()) {
        const auto exact = [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_atan2(r, t, s, rounding); };
        EXPECT_TRUE(is_near(angle.lower(), 0x1p-49 + 0x1p-51, exact));
        EXPECT_TRUE(is_near(angle.upper(), 0x1p-49 + 0x1p-51, exact));
      }
    }
  }
  const auto all = double_interval::entire();
  const double up = std::nextafter(point::half_pi, 2.0);
  EXPECT_IDENTICAL(atan2(all, double_interval(1, infinity)), double_interval(-up, up));
  EXPECT_IDENTICAL(atan2(double_interval(1, infinity), all), double_interval(0, 2 * up));
  EXPECT_IDENTICAL(atan2(double_interval(-infinity, -1), all), double_interval(-2 * up, 0));
  EXPECT_IDENTICAL(atan2(double_interval(0), double_interval(1, 2)), double_interval(0));
  EXPECT_TRUE(atan2(double_interval(0), double_interval(0, 1)).is_undefined());
  EXPECT_TRUE(atan2(double_interval(-1, 0), double_interval(-2, -1)).is_undefined());
  EXPECT_TRUE(atan2(double_interval(0, 1), double_interval(-2, -1)).is_undefined());
}

/// Each corner's angle is at an end of the range, within the bound: the range is not only held.
TEST(DoubleIntervalFunctions, OfRectanglesAreTight) {
  random_source random(11);
  for (repeat trial(5000); trial.again();) {
    const double_interval x = any_interval(random, {-10, 10});
    const double_interval y = any_interval(random, {-10, 10});
    const double_interval angle = atan2(y, x);
    if (angle.is_undefined()) continue;
    double low = infinity;
    double high = -infinity;
    for (const double s : {x.lower(), x.upper()}) {
      for (const double t : {y.lower(), y.upper()}) {
        real corner(oracle_bits);
        mpfr_atan2(corner, exactly(t), exactly(s), MPFR_RNDN);
        low = std::min(low, mpfr_get_d(corner, MPFR_RNDN));
        high = std::max(high, mpfr_get_d(corner, MPFR_RNDN));
      }
    }
    EXPECT_LE(std::abs(angle.lower() - low), 0x1p-48 * std::abs(low) + 8 * least_double);
    EXPECT_LE(std::abs(angle.upper() - high), 0x1p-48 * std::abs(high) + 8 * least_double);
  }
}

TEST(DoubleIntervalFunctions, Powers) {
  random_source random(12);
  for (repeat trial(10000); trial.again();) {
    const long n = random.one_in(3) ? random.between(-4, 4) : random.between(-300, 300);
    const double_interval x = any_interval(random, random.one_in(2) ? domain{-4, 4} : domain{});
    const double_interval y = pow(x, n);
    if (n < 0 && contains_zero(x)) {
      EXPECT_TRUE(y.is_undefined());
      continue;
    }
    const real m = exactly(member(random, x));
    EXPECT_TRUE(holds(y, [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_pow_si(r, m, n, rounding); }))
        << described(x) << "^" << n;
    EXPECT_TRUE(contains(y, pow(inside(random, x), n))) << described(x) << "^" << n;
    if (x.is_exact() && n != 0) {
      const double allowed = static_cast<double>(std::abs(n) + 1) * 0x1p-51;
      const double power = std::pow(std::abs(x.lower()), static_cast<double>(n));
      if (power < 1e-290 || power > 1e290) continue;
      EXPECT_TRUE(is_near(y.lower(), allowed, [&](mpfr_ptr r, mpfr_rnd_t rounding) {
        mpfr_pow_si(r, m, n, rounding);
      }));
      EXPECT_TRUE(is_near(y.upper(), allowed, [&](mpfr_ptr r, mpfr_rnd_t rounding) {
        mpfr_pow_si(r, m, n, rounding);
      }));
    }
  }
  EXPECT_IDENTICAL(pow(double_interval(-2, 3), 0), double_interval(1));
  EXPECT_IDENTICAL(pow(double_interval(-2, 3), 1), double_interval(-2, 3));
  EXPECT_TRUE(pow(double_interval::undefined(), 0).is_undefined());
  EXPECT_TRUE(contains(pow(double_interval(1), std::numeric_limits<long>::min()), 1.0));
}

TEST(DoubleIntervalFunctions, HypotAndScale) {
  random_source random(13);
  for (repeat trial(20000); trial.again();) {
    const double_interval x = any_interval(random);
    const double_interval y =
        random.one_in(2) ? any_interval(random) : any_interval(random, {x.lower(), x.upper()});
    const real s = exactly(member(random, x));
    const real t = exactly(member(random, y));
    const double_interval length = hypot(x, y);
    const auto exact = [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_hypot(r, s, t, rounding); };
    EXPECT_TRUE(holds(length, exact)) << described(x) << described(y);
    EXPECT_TRUE(contains(length, hypot(inside(random, x), inside(random, y))))
        << described(x) << described(y);
    if (x.is_exact() && y.is_exact()) {
      EXPECT_TRUE(is_near(length.lower(), 0x1p-50 + 0x1p-51, exact));
      EXPECT_TRUE(is_near(length.upper(), 0x1p-50 + 0x1p-51, exact));
    }
    const long n = random.one_in(2) ? random.between(-40, 40) : random.between(-2300, 2300);
    const double_interval scaled = scale(x, n);
    EXPECT_TRUE(
        holds(scaled, [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_mul_2si(r, s, n, rounding); }))
        << described(x) << n;
    // The tightest ends; an infinite end is a limit.
    const real low = exactly(x.lower());
    const real high = exactly(x.upper());
    real end(53);
    mpfr_mul_2si(end, low, n, MPFR_RNDN);
    EXPECT_EQ(scaled.lower(), mpfr_get_d(end, MPFR_RNDD)) << described(x) << n;
    mpfr_mul_2si(end, high, n, MPFR_RNDN);
    EXPECT_EQ(scaled.upper(), mpfr_get_d(end, MPFR_RNDU)) << described(x) << n;
  }
}

TEST(DoubleIntervalFunctions, ScaledToTheLeastNormalNumber) {
  // The product lies below 2^-1022 and is rounded up to it.
  const double_interval x(0x1.fffffffffffffp-1);
  EXPECT_IDENTICAL(scale(x, -1022), double_interval(0x1.ffffffffffffep-1023, 0x1p-1022));
  EXPECT_IDENTICAL(scale(-x, -1022), double_interval(-0x1p-1022, -0x1.ffffffffffffep-1023));
  EXPECT_IDENTICAL(scale(double_interval(1), -1022), double_interval(0x1p-1022));
  EXPECT_IDENTICAL(scale(double_interval(1), -1074), double_interval(least_double));
  EXPECT_IDENTICAL(scale(double_interval(least_double), 1074), double_interval(1));
}

// ---------------------------------------------------------------------------------------------
// Arithmetic.

struct operation {
  const char* name;
  double_interval (*of)(double_interval, double_interval);
  int (*exact)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
  double steps;  // of the size of a unit in the last place, that an end may be off
};
const std::array<operation, 6> operations = {{
    {"+", [](double_interval x, double_interval y) { return x + y; }, mpfr_add, 1},
    {"-", [](double_interval x, double_interval y) { return x - y; }, mpfr_sub, 1},
    {"*", [](double_interval x, double_interval y) { return x * y; }, mpfr_mul, 2},
    {"/", [](double_interval x, double_interval y) { return x / y; }, mpfr_div, 2},
    {"min", [](double_interval x, double_interval y) { return min(x, y); }, mpfr_min, 0},
    {"max", [](double_interval x, double_interval y) { return max(x, y); }, mpfr_max, 0},
}};

TEST(DoubleIntervalArithmetic, HoldsTheValuesOfMembers) {
  random_source random(14);
  for (const operation& op : operations) {
    SCOPED_TRACE(op.name);
    for (repeat trial(20000); trial.again();) {
      const double_interval x = any_set(random);
      const double_interval y = any_set(random);
      const double_interval z = op.of(x, y);
      if (op.exact == mpfr_div && contains_zero(y)) {
        EXPECT_TRUE(z.is_undefined());
        continue;
      }
      const real s = exactly(member(random, x));
      const real t = exactly(member(random, y));
      const auto exact = [&](mpfr_ptr r, mpfr_rnd_t rounding) { op.exact(r, s, t, rounding); };
      EXPECT_TRUE(holds(z, exact)) << described(x) << described(y);
      const double_interval part = op.of(inside(random, x), inside(random, y));
      EXPECT_TRUE(contains(z, part)) << described(x) << described(y) << described(part);
      EXPECT_FALSE(std::signbit(z.lower()) && z.lower() == 0);
      EXPECT_FALSE(std::signbit(z.upper()) && z.upper() == 0);
      if (x.is_exact() && y.is_exact()) {
        EXPECT_TRUE(is_near(z.lower(), op.steps * 0x1p-52, exact));
        EXPECT_TRUE(is_near(z.upper(), op.steps * 0x1p-52, exact));
      }
    }
  }
}

/// Sums have the tightest ends there are.
TEST(DoubleIntervalArithmetic, SumsAreTight) {
  random_source random(15);
  for (repeat trial(20000); trial.again();) {
    const double a = any_double(random);
    const double b =
        random.one_in(2) ? any_double(random) : any_double(random, {-std::abs(a), std::abs(a)});
    const double_interval z = double_interval(a) + double_interval(b);
    real sum(2200);
    mpfr_add(sum, exactly(a), exactly(b), MPFR_RNDN);
    EXPECT_EQ(z.lower(), mpfr_get_d(sum, MPFR_RNDD)) << a << " " << b;
    EXPECT_EQ(z.upper(), mpfr_get_d(sum, MPFR_RNDU)) << a << " " << b;
  }
}

/// The range of a product and of a quotient, by the four corners.
TEST(DoubleIntervalArithmetic, ProductsAndQuotientsAreTight) {
  random_source random(16);
  for (repeat trial(20000); trial.again();) {
    const domain in{-100, 100};
    const double_interval x = any_interval(random, in);
    const double_interval y = any_interval(random, in);
    for (const operation& op : {operations[2], operations[3]}) {
      const double_interval z = op.of(x, y);
      if (z.is_undefined()) continue;
      double low = infinity;
      double high = -infinity;
      for (const double s : {x.lower(), x.upper()}) {
        for (const double t : {y.lower(), y.upper()}) {
          real corner(oracle_bits);
          op.exact(corner, exactly(s), exactly(t), MPFR_RNDN);
          low = std::min(low, mpfr_get_d(corner, MPFR_RNDD));
          high = std::max(high, mpfr_get_d(corner, MPFR_RNDU));
        }
      }
      EXPECT_LE(z.lower(), low);
      EXPECT_GE(z.lower(), std::nextafter(low, -infinity))
          << described(x) << op.name << described(y);
      EXPECT_GE(z.upper(), high);
      EXPECT_LE(z.upper(), std::nextafter(high, infinity))
          << described(x) << op.name << described(y);
    }
  }
}

TEST(DoubleIntervalArithmetic, KeepsZero) {
  const double_interval zero = 0;
  const double_interval x(0, 3);
  EXPECT_IDENTICAL(zero * double_interval(-5, 7), zero);
  EXPECT_IDENTICAL(zero * double_interval::entire(), zero);
  EXPECT_IDENTICAL(zero / double_interval(-5, -4), zero);
  EXPECT_EQ((x * x).lower(), 0);
  EXPECT_EQ((-x * x).upper(), 0);
  EXPECT_EQ((double_interval(1e-200, 1) * double_interval(1e-200, 1)).lower(), 0);
  EXPECT_EQ((double_interval(-1, -1e-200) * double_interval(1e-200, 1)).upper(), 0);
  EXPECT_LT((double_interval(-1e-200, 1) * double_interval(0, 1e-200)).lower(), 0);
  EXPECT_IDENTICAL(1 - double_interval(1), zero);
  EXPECT_EQ((double_interval(least_double) / double_interval(4)).lower(), 0);
  EXPECT_LT((double_interval(-least_double) / double_interval(4)).lower(), 0);
  EXPECT_IDENTICAL(2 * double_interval::entire(), double_interval::entire());
}

TEST(DoubleIntervalArithmetic, UndefinedSpreads) {
  const auto u = double_interval::undefined();
  const double_interval x(1, 2);
  for (const operation& op : operations) {
    EXPECT_TRUE(op.of(u, x).is_undefined()) << op.name;
    EXPECT_TRUE(op.of(x, u).is_undefined()) << op.name;
    EXPECT_TRUE(op.of(u, u).is_undefined()) << op.name;
    EXPECT_TRUE(op.of(double_interval::entire(), u).is_undefined()) << op.name;
    EXPECT_TRUE(op.of(double_interval(0), u).is_undefined()) << op.name;
  }
  for (const function& f : functions()) EXPECT_TRUE(f.of(u).is_undefined()) << f.name;
  using of_two = double_interval (*)(double_interval, double_interval);
  for (const of_two f : std::initializer_list<of_two>{hypot, atan2}) {
    EXPECT_TRUE(f(u, x).is_undefined());
    EXPECT_TRUE(f(x, u).is_undefined());
  }
  for (const long n : {-3L, -2L, -1L, 0L, 1L, 2L, 3L}) {
    EXPECT_TRUE(pow(u, n).is_undefined());
    EXPECT_TRUE(scale(u, n).is_undefined());
  }
  EXPECT_TRUE((-u).is_undefined());
  EXPECT_TRUE(hull(u, x).is_undefined());
  EXPECT_TRUE(hull(x, u).is_undefined());
  EXPECT_TRUE(intersection(x, u).is_undefined());
  EXPECT_TRUE(u.split().first.is_undefined());
  EXPECT_FALSE(certainly_less(u, x) || certainly_less(x, u) || certainly_less_equal(u, x) ||
               certainly_greater(u, x));
  EXPECT_FALSE(certainly_positive(u) || certainly_negative(u) || contains(u, x) || contains(x, u) ||
               contains(u, 1.0));
  EXPECT_TRUE(possibly_less(u, x) && possibly_less(x, u) && overlaps(u, x) && contains_zero(u));
  EXPECT_FALSE(u.is_bounded() || u.is_exact());
  EXPECT_EQ(u.lower(), -infinity);
  EXPECT_EQ(u.upper(), infinity);
  EXPECT_EQ(u.magnitude(), infinity);
  EXPECT_EQ(u.mignitude(), 0);
  EXPECT_EQ(u.width(), infinity);
  EXPECT_EQ(u.midpoint(), 0);
  // However many steps it has made.
  double_interval v = u;
  for (int i = 0; i < 100; ++i) v = -(v + 1) * 3 - v / 2;
  EXPECT_TRUE(v.is_undefined());
  EXPECT_TRUE((double_interval(-1, 1) / double_interval(0, 1)).is_undefined());
}

// ---------------------------------------------------------------------------------------------
// Sets, comparisons, conversions.

TEST(DoubleIntervalSets, Construction) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(double_interval(2, 1), std::invalid_argument);
  EXPECT_THROW(double_interval(nan, 1), std::invalid_argument);
  EXPECT_THROW(double_interval(1, nan), std::invalid_argument);
  EXPECT_THROW(double_interval(infinity, infinity), std::invalid_argument);
  EXPECT_THROW(double_interval(-infinity, -infinity), std::invalid_argument);
  EXPECT_NO_THROW(double_interval(-infinity, infinity));
  EXPECT_TRUE(double_interval(nan).is_undefined());
  EXPECT_TRUE(double_interval(infinity).is_undefined());
  EXPECT_TRUE(double_interval(-infinity).is_undefined());
  EXPECT_IDENTICAL(double_interval(), double_interval(0));
  EXPECT_IDENTICAL(double_interval(-0.0), double_interval(0.0));
  EXPECT_IDENTICAL(double_interval(0.1F), double_interval(static_cast<double>(0.1F)));

  random_source random(17);
  for (repeat trial(5000); trial.again();) {
    const auto bits = random.bits() >> random.between(0, 40);
    const double_interval x = bits;
    EXPECT_TRUE(holds(x, [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_set_ui(r, bits, rounding); }));
    const auto n = static_cast<long>(bits);
    EXPECT_TRUE(holds(double_interval(-n),
                      [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_set_si(r, -n, rounding); }));
    const rational q = random.any_rational(300);
    EXPECT_TRUE(holds(double_interval(q), [&](mpfr_ptr r, mpfr_rnd_t rounding) {
      mpfr_set_q(r, q.backend().data(), rounding);
    }));
    const integer k = random.any_integer(1200);
    const double_interval y = k;
    EXPECT_TRUE(holds(
        y, [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_set_z(r, k.backend().data(), rounding); }));
  }
  EXPECT_TRUE(double_interval(1L << 53).is_exact());
  EXPECT_TRUE(contains(double_interval(rational(1) / 3) * 3, 1.0));
  EXPECT_TRUE(double_interval(rational(5) / 8).is_exact());
}

TEST(DoubleIntervalSets, Measures) {
  const double_interval x(-3, 5);
  EXPECT_EQ(x.magnitude(), 5);
  EXPECT_EQ(x.mignitude(), 0);
  EXPECT_EQ(x.width(), 8);
  EXPECT_EQ(x.midpoint(), 1);
  EXPECT_EQ(double_interval(-5, -3).mignitude(), 3);
  EXPECT_EQ(double_interval(-5, -3).magnitude(), 5);
  EXPECT_EQ(double_interval(-5, infinity).midpoint(), largest_double);
  EXPECT_EQ(double_interval(-infinity, 5).midpoint(), -largest_double);
  EXPECT_EQ(double_interval::entire().midpoint(), 0);
  EXPECT_EQ(double_interval(-largest_double, largest_double).width(), infinity);
  random_source random(18);
  for (repeat trial(20000); trial.again();) {
    const double_interval y = any_set(random);
    EXPECT_TRUE(contains(y, y.midpoint())) << described(y);
    const auto [left, right] = y.split();
    EXPECT_IDENTICAL(hull(left, right), y);
    EXPECT_TRUE(overlaps(left, right));
    if (y.is_bounded()) {
      real width(2200);
      mpfr_sub(width, exactly(y.upper()), exactly(y.lower()), MPFR_RNDN);
      EXPECT_EQ(y.width(), mpfr_get_d(width, MPFR_RNDU));
      EXPECT_TRUE(contains(y, double_interval(y.midpoint())));
    }
  }
}

TEST(DoubleIntervalSets, HullAndIntersection) {
  const double_interval x(0, 2);
  const double_interval y(1, 3);
  const double_interval far(5, 6);
  EXPECT_IDENTICAL(hull(x, far), double_interval(0, 6));
  EXPECT_IDENTICAL(hull(far, x), double_interval(0, 6));
  EXPECT_IDENTICAL(intersection(x, y), double_interval(1, 2));
  EXPECT_IDENTICAL(intersection(x, double_interval(2, 3)), double_interval(2));
  EXPECT_TRUE(intersection(x, far).is_undefined());
  EXPECT_IDENTICAL(min(x, y), x);
  EXPECT_IDENTICAL(max(x, y), y);
  EXPECT_IDENTICAL(max(x, double_interval(1)), double_interval(1, 2));
  EXPECT_IDENTICAL(abs(double_interval(-3, 2)), double_interval(0, 3));
  EXPECT_IDENTICAL(abs(double_interval(-3, -2)), double_interval(2, 3));
}

TEST(DoubleIntervalSets, Comparisons) {
  const double_interval x(0, 1);
  const double_interval y(1, 2);
  const double_interval z(3, 4);
  EXPECT_TRUE(certainly_less(x, z) && certainly_less(y, 3) && certainly_greater(z, y));
  EXPECT_FALSE(certainly_less(x, y) || certainly_less(z, x) || certainly_less(x, x));
  EXPECT_TRUE(certainly_less_equal(x, y));
  EXPECT_FALSE(certainly_less_equal(y, x));
  EXPECT_TRUE(possibly_less(x, y) && possibly_less(x, x));
  EXPECT_FALSE(possibly_less(z, y) || possibly_less(y, x));
  EXPECT_TRUE(overlaps(x, y) && !overlaps(x, z) && !overlaps(z, x));
  EXPECT_TRUE(contains(double_interval(0, 4), z) && !contains(z, double_interval(0, 4)) &&
              contains(x, x));
  EXPECT_TRUE(contains(x, 0.0) && contains(x, 1.0) && !contains(x, 1.5) && contains(x, 1));
  EXPECT_FALSE(contains(double_interval::entire(), infinity));
  EXPECT_TRUE(contains_zero(x) && !contains_zero(y) && !contains_zero(-y));
  EXPECT_TRUE(certainly_positive(y) && !certainly_positive(x) && certainly_negative(-y) &&
              !certainly_negative(-x));
}

TEST(DoubleIntervalConversions, ToAndFromBalls) {
  random_source random(19);
  for (repeat trial(10000); trial.again();) {
    const double_interval x = any_set(random);
    for (const precision p : {2, 24, 53, 100}) {
      const ball b = to_ball(x, p);
      EXPECT_EQ(b.precision(), p);
      EXPECT_TRUE(contains(double_interval::from_ball(b), x)) << described(x);
      if (p >= 53 && x.is_exact()) {
        EXPECT_IDENTICAL(double_interval::from_ball(b), x);
      }
      real low(53);
      real high(53);
      b.lower(low);
      b.upper(high);
      EXPECT_LE(mpfr_cmp_d(low, x.lower()), 0);
      EXPECT_GE(mpfr_cmp_d(high, x.upper()), 0);
    }
    const ball b = random.any_ball();
    const double_interval y = double_interval::from_ball(b);
    EXPECT_EQ(y.is_undefined(), b.is_undefined());
    if (!b.is_undefined()) {
      const precision bits = b.precision() + 200;
      real low(bits);
      real high(bits);
      b.lower(low);
      b.upper(high);
      EXPECT_GE(mpfr_cmp_d(low, y.lower()), 0);
      EXPECT_LE(mpfr_cmp_d(high, y.upper()), 0);
    }
  }
  EXPECT_TRUE(to_ball(double_interval::undefined(), 77).is_undefined());
  EXPECT_IDENTICAL(double_interval::from_ball(scale(ball(1, 53), 5000)),
                   double_interval(largest_double, infinity));
  EXPECT_IDENTICAL(double_interval::from_ball(scale(ball(-1, 53), -5000)),
                   double_interval(-least_double, 0));
  EXPECT_IDENTICAL(double_interval::from_ball(ball::entire(53)), double_interval::entire());
}

TEST(DoubleIntervalConversions, PrintsAnEnclosure) {
  const auto text = [](double_interval x) {
    std::ostringstream out;
    out << x;
    return out.str();
  };
  EXPECT_EQ(text(double_interval(1, 2)), "[1, 2]");
  EXPECT_EQ(text(double_interval(0.1)), "[0.1, 0.10000000000000001]");
  EXPECT_EQ(text(double_interval(-infinity, 0)), "[-inf, 0]");
  EXPECT_EQ(text(double_interval::undefined()), "undefined");
}

}  // namespace double_interval_test
}  // namespace polhode
