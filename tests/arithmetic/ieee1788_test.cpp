// The demand of IEEE 1788 at its tightest: over intervals of binary64 numbers, bounded and not
// empty, a ball of 200 bits holds the range and exceeds its tightest binary64 hull by at most one
// unit in the last place at each end.
//
// The oracles are MPFR with directed rounding at the ends and at the interior extrema, or exact
// rationals at the corners; which points are extrema is worked out here, from the functions'
// shapes, and not asked of the library.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/natural_domain.hpp"
#include "polhode/arithmetic/special_functions.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"
#include "support/real.hpp"

namespace polhode {
namespace ieee1788_test {

using support::described;
using support::kind;
using support::random_source;
using support::real;
using support::repeat;
using support::to_rational;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double greatest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr precision bits = 200;
constexpr precision oracle_bits = 600;

struct interval {
  double lower;
  double upper;
};
std::string text(interval x) {
  char buffer[100];
  std::snprintf(buffer, sizeof buffer, "[%a, %a]", x.lower, x.upper);
  return buffer;
}

real exactly(double x) {
  real r(53);
  mpfr_set_d(r, x, MPFR_RNDN);
  return r;
}
ball to_ball(interval x) { return ball::from_end_points(exactly(x.lower), exactly(x.upper), bits); }

/// A range, by lower bounds of its lower end and upper bounds of its upper one to oracle_bits:
/// rounding these again in the same direction gives what rounding the true ends would.
struct range {
  real lower{oracle_bits};
  real upper{oracle_bits};
  bool is_empty = true;

  /// The hull with one more value, f(destination, rounding).
  template <std::invocable<mpfr_ptr, mpfr_rnd_t> F>
  void add(F&& f) {
    real low(oracle_bits);
    real high(oracle_bits);
    f(low.get(), MPFR_RNDD);
    f(high.get(), MPFR_RNDU);
    ASSERT_FALSE(mpfr_nan_p(low.get()) != 0 || mpfr_nan_p(high.get()) != 0) << "a wrong oracle";
    if (is_empty || mpfr_less_p(low, lower) != 0) lower = low;
    if (is_empty || mpfr_greater_p(high, upper) != 0) upper = high;
    is_empty = false;
  }
  void add(const rational& q) {
    add([&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_set_q(r, q.backend().data(), rounding); });
  }
  void add(double x) {
    add([&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_set_d(r, x, rounding); });
  }
};

/// The demand.
void expect_tight(const ball& y, const range& truth) {
  ASSERT_FALSE(y.is_undefined());
  ASSERT_FALSE(truth.is_empty);
  real lower(oracle_bits);
  real upper(oracle_bits);
  y.lower(lower);
  y.upper(upper);
  EXPECT_TRUE(mpfr_lessequal_p(lower, truth.lower) != 0) << "does not hold the lower end";
  EXPECT_TRUE(mpfr_greaterequal_p(upper, truth.upper) != 0) << "does not hold the upper end";
  const double tightest_lower = mpfr_get_d(truth.lower, MPFR_RNDD);
  const double tightest_upper = mpfr_get_d(truth.upper, MPFR_RNDU);
  EXPECT_GE(mpfr_get_d(lower, MPFR_RNDD), std::nextafter(tightest_lower, -infinity));
  EXPECT_LE(mpfr_get_d(upper, MPFR_RNDU), std::nextafter(tightest_upper, infinity));
}

// -------------------------------------------------------------------------------------------------
// Operands.

/// Ends worth trying: 0, subnormal and least normal numbers, around 1 and the multiples of pi / 2
/// (both neighbours), where exponentials leave the range of doubles, huge ones.
const std::vector<double>& special_ends() {
  static const std::vector<double> all = [] {
    std::vector<double> positive = {least,
                                    1e-320,
                                    0x1p-1022,
                                    1e-200,
                                    0x1p-53,
                                    0.1,
                                    0.5,
                                    0x1.fffffffffffffp-1,
                                    1,
                                    0x1.0000000000001p0,
                                    1.5,
                                    0x1.921fb54442d18p0,
                                    0x1.921fb54442d19p0,
                                    2,
                                    2.5,
                                    3,
                                    0x1.921fb54442d18p1,
                                    0x1.921fb54442d19p1,
                                    0x1.2d97c7f3321d2p2,
                                    10,
                                    308.3,
                                    709.9,
                                    745.2,
                                    1024,
                                    1e10,
                                    0x1.4cccccccccccdp52,
                                    1e154,
                                    0x1.5p1000,
                                    1e308,
                                    greatest};
    std::vector<double> ends = {-0.0, 0.0};
    for (const double x : positive) {
      ends.push_back(x);
      ends.push_back(-x);
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }();
  return all;
}

double any_double(random_source& random) {
  const long e = random.one_in(3) ? random.between(-1073, 1023) : random.between(-12, 10);
  const double size =
      std::ldexp(1 + static_cast<double>(random.bits() >> 12) * 0x1p-52, static_cast<int>(e));
  return random.one_in(2) ? size : -size;
}

/// Thin, wide, touching a special number.
interval any_interval(random_source& random) {
  double a = any_double(random);
  double b = a;
  switch (random.between(0, 4)) {
    case 0:
      break;
    case 1:
      for (long steps = random.between(1, 4); steps > 0; --steps) b = std::nextafter(b, infinity);
      break;
    case 2:
      b = a * (1 + std::ldexp(1.0, -static_cast<int>(random.between(1, 50))));
      break;
    case 3:
      b = random.choose(special_ends());
      break;
    default:
      b = any_double(random);
  }
  if (std::isinf(b)) b = greatest;
  return {std::min(a, b), std::max(a, b)};
}

/// Calls f with every pair of special ends, and with random intervals.
template <class F>
void for_all_intervals(std::uint64_t seed, double trials, F&& f) {
  const std::vector<double>& ends = special_ends();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i; j < ends.size(); ++j) {
      f(interval{ends[i], ends[j]});
      if (::testing::Test::HasFailure()) return;
    }
  }
  random_source random(seed);
  for (repeat trial(trials); trial.again();) f(any_interval(random));
}

// -------------------------------------------------------------------------------------------------
// Functions of one variable.

using mpfr_function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

enum class shape { increasing, decreasing, even, circular };

struct tested_function {
  const char* name;
  ball (*plain)(const ball&);
  std::optional<ball> (*set_based)(const ball&);  // null where the function is defined everywhere
  mpfr_function f;
  shape is;
  double from = -infinity;  // the natural domain's ends
  double to = infinity;
  bool open = false;          // the finite ends do not belong to it
  int first_maximum = 0;      // of a circular function, in quarter turns
  bool half_circles = false;  // counted in half circles
};

/// floor(x / quarter turn), by pi to 3000 bits: a double is a multiple of 2^-1074 below 2^1024, so
/// that no multiple of pi / 2 but 0 is nearer to it than 2^-1200.
integer quarter_turns_below(double x, bool half_circles) {
  constexpr precision long_enough = 3000;
  real turns = exactly(x);
  if (half_circles) {
    mpfr_mul_2ui(turns, turns, 1, MPFR_RNDN);
  } else {
    real half_pi(long_enough);
    mpfr_const_pi(half_pi, MPFR_RNDN);
    mpfr_div_2ui(half_pi, half_pi, 1, MPFR_RNDN);
    real quotient(long_enough);
    mpfr_div(quotient, turns, half_pi, MPFR_RNDN);
    turns = quotient;
  }
  integer n;
  mpfr_get_z(n.backend().data(), turns, MPFR_RNDD);
  return n;
}

/// The range over x cut with the natural domain.
range true_range(const tested_function& g, interval x) {
  range result;
  if (x.upper < g.from || x.lower > g.to) return result;
  if (g.open && (x.upper == g.from || x.lower == g.to)) return result;
  const double a = std::max(x.lower, g.from);
  const double b = std::min(x.upper, g.to);
  for (const double end : {a, b}) {
    // + 0.0: the limit at the end 0 of a domain is taken from above.
    result.add([&](mpfr_ptr r, mpfr_rnd_t rounding) { g.f(r, exactly(end + 0.0), rounding); });
  }
  if (g.is == shape::even && a < 0 && b > 0) {
    result.add([&](mpfr_ptr r, mpfr_rnd_t rounding) { g.f(r, exactly(0), rounding); });
  }
  if (g.is == shape::circular) {
    integer n = quarter_turns_below(a, g.half_circles);
    const integer last = quarter_turns_below(b, g.half_circles);
    if (last - n > 4) n = last - 4;
    for (++n; n <= last; ++n) {
      const integer phase = n - g.first_maximum;
      if (phase % 4 == 0) result.add(1.0);
      if (phase % 4 == 2 || phase % 4 == -2) result.add(-1.0);
    }
  }
  return result;
}

const std::vector<tested_function>& tested_functions() {
  namespace nd = natural_domain;
  using s = shape;
  static const std::vector<tested_function> all = {
      {"exp", exp, nullptr, mpfr_exp, s::increasing},
      {"exp2", exp2, nullptr, mpfr_exp2, s::increasing},
      {"exp10", exp10, nullptr, mpfr_exp10, s::increasing},
      {"expm1", expm1, nullptr, mpfr_expm1, s::increasing},
      {"log", log, nd::log, mpfr_log, s::increasing, 0, infinity, true},
      {"log2", log2, nd::log2, mpfr_log2, s::increasing, 0, infinity, true},
      {"log10", log10, nd::log10, mpfr_log10, s::increasing, 0, infinity, true},
      {"log1p", log1p, nd::log1p, mpfr_log1p, s::increasing, -1, infinity, true},
      {"sqrt", sqrt, nd::sqrt, mpfr_sqrt, s::increasing, 0, infinity},
      {"rsqrt", rsqrt, nd::rsqrt, mpfr_rec_sqrt, s::decreasing, 0, infinity, true},
      {"square", square, nullptr, mpfr_sqr, s::even},
      {"abs", abs, nullptr,
       [](mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t d) { return mpfr_abs(r, x, d); }, s::even},
      {"sin", sin, nullptr, mpfr_sin, s::circular, -infinity, infinity, false, 1},
      {"cos", cos, nullptr, mpfr_cos, s::circular, -infinity, infinity, false, 0},
      {"sinpi", sinpi, nullptr, mpfr_sinpi, s::circular, -infinity, infinity, false, 1, true},
      {"cospi", cospi, nullptr, mpfr_cospi, s::circular, -infinity, infinity, false, 0, true},
      {"asin", asin, nd::asin, mpfr_asin, s::increasing, -1, 1},
      {"acos", acos, nd::acos, mpfr_acos, s::decreasing, -1, 1},
      {"atan", atan, nullptr, mpfr_atan, s::increasing},
      {"sinh", sinh, nullptr, mpfr_sinh, s::increasing},
      {"cosh", cosh, nullptr, mpfr_cosh, s::even},
      {"tanh", tanh, nullptr, mpfr_tanh, s::increasing},
      {"asinh", asinh, nullptr, mpfr_asinh, s::increasing},
      {"acosh", acosh, nd::acosh, mpfr_acosh, s::increasing, 1, infinity},
      {"atanh", atanh, nd::atanh, mpfr_atanh, s::increasing, -1, 1, true},
      {"floor", floor, nullptr, mpfr_rint_floor, s::increasing},
      {"ceil", ceil, nullptr, mpfr_rint_ceil, s::increasing},
      {"trunc", trunc, nullptr, mpfr_rint_trunc, s::increasing},
      {"cbrt", [](const ball& x) { return root(x, 3); }, nullptr, mpfr_cbrt, s::increasing},
  };
  return all;
}

class OneVariable : public ::testing::TestWithParam<tested_function> {};

TEST_P(OneVariable, IsTightAndSetBasedOffItsDomain) {
  const tested_function& g = GetParam();
  for_all_intervals(4000, 1500, [&](interval x) {
    SCOPED_TRACE(std::string(g.name) + " of " + text(x));
    const range truth = true_range(g, x);
    const ball y = g.plain(to_ball(x));
    const bool defined =
        g.open ? x.lower > g.from && x.upper < g.to : x.lower >= g.from && x.upper <= g.to;
    if (defined) {
      expect_tight(y, truth);
    } else {
      EXPECT_TRUE(y.is_undefined()) << y;
    }
    if (g.set_based == nullptr) return;
    const std::optional<ball> z = g.set_based(to_ball(x));
    ASSERT_EQ(z.has_value(), !truth.is_empty);
    if (z) expect_tight(*z, truth);
  });
}

INSTANTIATE_TEST_SUITE_P(Ieee1788, OneVariable, ::testing::ValuesIn(tested_functions()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Ieee1788, Tangent) {
  for_all_intervals(4001, 1500, [&](interval x) {
    SCOPED_TRACE(text(x));
    // The poles are the odd quarter turns.
    const integer first = quarter_turns_below(x.lower, false);
    const integer last = quarter_turns_below(x.upper, false);
    const bool pole = last - first >= 2 || (last != first && last % 2 != 0);
    const ball y = tan(to_ball(x));
    const std::optional<ball> z = natural_domain::tan(to_ball(x));
    ASSERT_TRUE(z.has_value());
    if (pole) {
      EXPECT_TRUE(y.is_undefined());
      EXPECT_FALSE(z->is_bounded());
      EXPECT_TRUE(contains(*z, ball::entire(bits)));
      return;
    }
    range truth;
    for (const double end : {x.lower, x.upper}) {
      truth.add([&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_tan(r, exactly(end), rounding); });
    }
    expect_tight(y, truth);
    expect_tight(*z, truth);
  });
}

TEST(Ieee1788, RoundingAndSignByHardware) {
  struct step {
    ball (*of)(const ball&);
    double (*by_hardware)(double);
  };
  const std::array<step, 6> steps = {
      step{floor, [](double x) { return std::floor(x); }},
      step{ceil, [](double x) { return std::ceil(x); }},
      step{trunc, [](double x) { return std::trunc(x); }},
      step{round_ties_to_even, [](double x) { return std::nearbyint(x); }},
      step{round_ties_to_away, [](double x) { return std::round(x); }},
      step{signum, [](double x) { return x > 0   ? 1.0
                                         : x < 0 ? -1.0
                                                 : 0.0; }}};
  const auto check = [&](interval x) {
    SCOPED_TRACE(text(x));
    for (const step& s : steps) {
      range truth;
      truth.add(s.by_hardware(x.lower));
      truth.add(s.by_hardware(x.upper));
      expect_tight(s.of(to_ball(x)), truth);
    }
  };
  for_all_intervals(4002, 1500, check);
  for (long i = -9; i <= 9; ++i) {  // halves and their neighbours
    const double half = static_cast<double>(i) / 2;
    for (const double lower :
         {half, std::nextafter(half, -infinity), std::nextafter(half, infinity)}) {
      check({lower, lower});
      check({lower, lower + 0.5});
      check({lower, 5});
    }
  }
}

// -------------------------------------------------------------------------------------------------
// Powers and roots.

TEST(Ieee1788, IntegerPowers) {
  for (const long n :
       {-1000L, -8L, -7L, -3L, -2L, -1L, 0L, 1L, 2L, 3L, 4L, 7L, 8L, 100L, 101L, 1L << 40}) {
    for_all_intervals(4003 + static_cast<std::uint64_t>(n + 1000), 300, [&](interval x) {
      SCOPED_TRACE(text(x) + " to the " + std::to_string(n));
      const bool has_zero = x.lower <= 0 && x.upper >= 0;
      range truth;
      const auto add = [&](double at) {
        truth.add([&](mpfr_ptr r, mpfr_rnd_t d) { mpfr_pow_si(r, exactly(at), n, d); });
      };
      if (n >= 0 || !has_zero) {
        add(x.lower);
        add(x.upper);
        if (has_zero) add(0);
      } else {  // 0 is left out
        if (x.lower < 0) {
          add(x.lower);
          truth.add(n % 2 == 0 ? infinity : -infinity);
        }
        if (x.upper > 0) {
          add(x.upper);
          truth.add(infinity);
        }
      }
      const ball y = pow(to_ball(x), n);
      if (n >= 0 || !has_zero) {
        expect_tight(y, truth);
      } else {
        EXPECT_TRUE(y.is_undefined());
      }
      const std::optional<ball> z = natural_domain::pow(to_ball(x), n);
      ASSERT_EQ(z.has_value(), !truth.is_empty);
      if (z) expect_tight(*z, truth);
    });
  }
}

TEST(Ieee1788, Roots) {
  for (const unsigned long n : {1UL, 2UL, 3UL, 4UL, 5UL, 12UL, 1001UL}) {
    for_all_intervals(4100 + n, 300, [&](interval x) {
      SCOPED_TRACE("root " + std::to_string(n) + " of " + text(x));
      range truth;
      const bool even = n % 2 == 0;
      if (!even || x.upper >= 0) {
        for (const double end : {even ? std::max(x.lower, 0.0) : x.lower, x.upper}) {
          truth.add([&](mpfr_ptr r, mpfr_rnd_t d) { mpfr_rootn_ui(r, exactly(end + 0.0), n, d); });
        }
      }
      const ball y = root(to_ball(x), n);
      if (even && x.lower < 0) {
        EXPECT_TRUE(y.is_undefined());
      } else {
        expect_tight(y, truth);
      }
      const std::optional<ball> z = natural_domain::root(to_ball(x), n);
      ASSERT_EQ(z.has_value(), !truth.is_empty);
      if (z) expect_tight(*z, truth);
    });
  }
}

// -------------------------------------------------------------------------------------------------
// Functions of two variables.

/// Calls f with pairs of a small table of intervals, and with random ones.
template <class F>
void for_all_pairs(std::uint64_t seed, double trials, F&& f) {
  static constexpr std::array ends = {-greatest, -1e200, -3.0,  -1.0,    -0.5, -1e-160,
                                      -least,    0.0,    least, 1e-310,  0.3,  1.0,
                                      1.75,      4.0,    1e155, greatest};
  std::vector<interval> table;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i; j < ends.size(); ++j) table.push_back({ends[i], ends[j]});
  }
  random_source random(seed);
  for (const interval& x : table) {
    for (const interval& y : table) {
      if (support::effort() <= 1 && !random.one_in(3)) continue;
      f(x, y);
      if (::testing::Test::HasFailure()) return;
    }
  }
  for (repeat trial(trials); trial.again();) f(any_interval(random), any_interval(random));
}

rational q(double x) { return to_rational(exactly(x)); }

TEST(Ieee1788, Arithmetic) {
  for_all_pairs(4200, 3000, [&](interval x, interval y) {
    SCOPED_TRACE(text(x) + ", " + text(y));
    const ball bx = to_ball(x);
    const ball by = to_ball(y);
    range sum;
    range difference;
    range product;
    range quotient;
    range minimum;
    range maximum;
    const bool by_zero = y.lower <= 0 && y.upper >= 0;
    for (const double s : {x.lower, x.upper}) {
      for (const double t : {y.lower, y.upper}) {
        sum.add(q(s) + q(t));
        difference.add(q(s) - q(t));
        product.add(q(s) * q(t));
        if (!by_zero) quotient.add(q(s) / q(t));
      }
    }
    minimum.add(std::min(x.lower, y.lower));
    minimum.add(std::min(x.upper, y.upper));
    maximum.add(std::max(x.lower, y.lower));
    maximum.add(std::max(x.upper, y.upper));
    expect_tight(bx + by, sum);
    expect_tight(bx - by, difference);
    expect_tight(bx * by, product);
    expect_tight(min(bx, by), minimum);
    expect_tight(max(bx, by), maximum);
    if (by_zero) {
      EXPECT_TRUE((bx / by).is_undefined());
      // The set of quotients by what is left of y on each side of 0: unbounded with a dividend that
      // is not 0, and 0 itself with one that is.
      for (const double t : {y.lower, y.upper}) {
        if (t == 0) continue;
        for (const double s : {x.lower, x.upper}) {
          quotient.add(q(s) / q(t));
          if (s != 0) quotient.add((s > 0) == (t > 0) ? infinity : -infinity);
        }
      }
    } else {
      expect_tight(bx / by, quotient);
    }
    const std::optional<ball> z = natural_domain::divide(bx, by);
    ASSERT_EQ(z.has_value(), !quotient.is_empty);
    if (z) expect_tight(*z, quotient);
  });
}

TEST(Ieee1788, FusedMultiplyAdd) {
  random_source random(4201);
  for (repeat trial(3000); trial.again();) {
    const interval x = any_interval(random);
    const interval y = any_interval(random);
    const interval z = any_interval(random);
    SCOPED_TRACE(text(x) + ", " + text(y) + ", " + text(z));
    range truth;
    for (const double s : {x.lower, x.upper}) {
      for (const double t : {y.lower, y.upper}) {
        truth.add(q(s) * q(t) + q(z.lower));
        truth.add(q(s) * q(t) + q(z.upper));
      }
    }
    ball r;
    fma(r, to_ball(x), to_ball(y), to_ball(z));
    expect_tight(r, truth);
  }
}

TEST(Ieee1788, Hypotenuse) {
  for_all_pairs(4202, 2000, [&](interval x, interval y) {
    SCOPED_TRACE(text(x) + ", " + text(y));
    range truth;
    const auto nearest = [](interval a) {
      return a.lower > 0 ? a.lower : a.upper < 0 ? -a.upper : 0.0;
    };
    const auto farthest = [](interval a) { return std::max(std::abs(a.lower), std::abs(a.upper)); };
    truth.add([&](mpfr_ptr r, mpfr_rnd_t d) {
      mpfr_hypot(r, exactly(nearest(x)), exactly(nearest(y)), d);
    });
    truth.add([&](mpfr_ptr r, mpfr_rnd_t d) {
      mpfr_hypot(r, exactly(farthest(x)), exactly(farthest(y)), d);
    });
    expect_tight(hypot(to_ball(x), to_ball(y)), truth);
  });
}

// The angle is monotone along a line that misses the origin, so its extremes over a rectangle are
// at corners; where a side or the rectangle passes the origin, the points on the axes are added.
// Across the negative half axis it jumps by 2 pi.
TEST(Ieee1788, Angle) {
  for_all_pairs(4203, 3000, [&](interval y, interval x) {
    SCOPED_TRACE("angle of x in " + text(x) + ", y in " + text(y));
    range truth;
    const auto add = [&](double t, double s) {
      if (t == 0 && s == 0) return;
      truth.add([&](mpfr_ptr r, mpfr_rnd_t d) { mpfr_atan2(r, exactly(t + 0.0), exactly(s), d); });
    };
    const bool x_has_zero = x.lower <= 0 && x.upper >= 0;
    const bool y_has_zero = y.lower <= 0 && y.upper >= 0;
    for (const double t : {y.lower, y.upper}) {
      for (const double s : {x.lower, x.upper}) add(t, s);
      if (x_has_zero) add(t, 0);
    }
    if (y_has_zero) {
      add(0, x.lower);
      add(0, x.upper);
    }
    if (y.lower < 0 && y.upper >= 0 && x.lower < 0) {
      truth.add([&](mpfr_ptr r, mpfr_rnd_t d) { mpfr_const_pi(r, d); });
      truth.add([&](mpfr_ptr r, mpfr_rnd_t d) {
        mpfr_const_pi(r, d == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD);
        mpfr_neg(r, r, MPFR_RNDN);
      });
    }
    const ball angle = atan2(to_ball(y), to_ball(x));
    if (x_has_zero && y_has_zero) {
      EXPECT_TRUE(angle.is_undefined());
    } else {
      expect_tight(angle, truth);
    }
    const std::optional<ball> z = natural_domain::atan2(to_ball(y), to_ball(x));
    ASSERT_EQ(z.has_value(), !truth.is_empty);
    if (z) expect_tight(*z, truth);
  });
}

TEST(Ieee1788, RealPowers) {
  for_all_pairs(4204, 3000, [&](interval x, interval y) {
    SCOPED_TRACE(text(x) + " to the " + text(y));
    range truth;
    // Corners, and where the rectangle meets x = 1 or y = 0 the value 1. Negative x are off the
    // domain, and at x = 0 there are the limits from above, for y < 0, y = 0, y > 0.
    if (x.upper > 0) {
      for (const double s : {std::max(x.lower, 0.0), x.upper}) {
        for (const double t : {y.lower, y.upper}) {
          if (s == 0) {
            truth.add(t < 0 ? infinity : t == 0 ? 1.0 : 0.0);
          } else {
            truth.add([&](mpfr_ptr r, mpfr_rnd_t d) { mpfr_pow(r, exactly(s), exactly(t), d); });
          }
        }
      }
      if ((y.lower <= 0 && y.upper >= 0) || (x.lower <= 1 && x.upper >= 1)) truth.add(1.0);
    } else if (x.upper == 0 && y.upper > 0) {
      truth.add(0.0);
    }
    const std::optional<ball> z = natural_domain::pow(to_ball(x), to_ball(y));
    ASSERT_EQ(z.has_value(), !truth.is_empty);
    if (z) expect_tight(*z, truth);
    // The plain power takes an exact integer exponent for what it is, for every x.
    if (y.lower == y.upper && std::trunc(y.lower) == y.lower) return;
    const ball w = pow(to_ball(x), to_ball(y));
    if (x.lower > 0 || (x.lower == 0 && y.lower > 0)) {
      expect_tight(w, truth);
    } else {
      EXPECT_TRUE(w.is_undefined());
    }
  });
}

// The same functions over balls of every form and precision: they hold the values at members.
TEST(Ieee1788, AnglesAndStepsHoldTheValuesAtMembers) {
  random_source random(4205);
  for (repeat trial(20000); trial.again();) {
    const ball x = random.any_ball();
    const ball y = random.any_ball();
    SCOPED_TRACE(described(y) + ", " + described(x));
    const rational s = random.member(x);
    const rational t = random.member(y);
    const real at_s = support::exact_real(s);
    real value(2000);
    mpfr_trunc(value, at_s);
    EXPECT_TRUE(contains(trunc(x), to_rational(value)));
    mpfr_roundeven(value, at_s);
    EXPECT_TRUE(contains(round_ties_to_even(x), to_rational(value)));
    mpfr_round(value, at_s);
    EXPECT_TRUE(contains(round_ties_to_away(x), to_rational(value)));
    EXPECT_TRUE(contains(signum(x), mpfr_sgn(at_s.get())));

    const ball angle = atan2(y, x);
    EXPECT_EQ(angle.precision(), std::max(x.precision(), y.precision()));
    const std::optional<ball> set_based = natural_domain::atan2(y, x);
    if (s == 0 && t == 0) {
      EXPECT_TRUE(angle.is_undefined());
      continue;
    }
    ASSERT_TRUE(set_based.has_value());
    const real at_t = support::exact_real(t);
    for (const mpfr_rnd_t rounding : {MPFR_RNDD, MPFR_RNDU}) {
      mpfr_atan2(value, at_t, at_s, rounding);
      EXPECT_TRUE(angle.is_undefined() || contains(angle, ball(value.get()))) << angle;
      EXPECT_TRUE(contains(*set_based, ball(value.get()))) << *set_based;
    }
    if (angle.is_undefined()) {
      EXPECT_TRUE(contains_zero(x) && contains_zero(y));
    }
  }
}

TEST(Ieee1788, AngleOfThinSets) {
  // The angle changes by at most |change of the point| / |point|.
  random_source random(4206);
  for (repeat trial(2000); trial.again();) {
    const precision p = random.between(64, 200);
    const ball x = random.any_ball(p, kind::thin);
    const ball y = random.any_ball(p, kind::thin);
    SCOPED_TRACE(described(y) + ", " + described(x));
    const ball angle = atan2(y, x);
    ASSERT_TRUE(angle.is_bounded());
    const magnitude distance = hypot(x, y).magnitude_lower();
    const magnitude change = add_up(x.radius(), y.radius());
    const magnitude ulp = scale(angle.magnitude_upper(), 1 - p);
    EXPECT_LE(angle.radius(), add_up(divide_up(change, distance), scale(ulp, 1)));
  }
}

// -------------------------------------------------------------------------------------------------
// Unbounded and undefined operands of the set-based forms.

TEST(NaturalDomain, Examples) {
  namespace nd = natural_domain;
  const auto over = [](double a, double b) { return to_ball({a, b}); };
  const auto is = [](const std::optional<ball>& z, double a, double b) {
    if (!z || z->is_undefined()) return ::testing::AssertionFailure() << "empty or undefined";
    range truth;
    truth.add(a);
    truth.add(b);
    expect_tight(*z, truth);
    return ::testing::AssertionSuccess();
  };
  EXPECT_TRUE(is(nd::sqrt(over(-1, 4)), 0, 2));
  EXPECT_TRUE(is(nd::sqrt(over(-infinity, infinity)), 0, infinity));
  EXPECT_FALSE(nd::sqrt(over(-2, -1)).has_value());
  EXPECT_TRUE(is(nd::log(over(0, 1)), -infinity, 0));
  EXPECT_TRUE(is(nd::log(over(-infinity, 1)), -infinity, 0));
  EXPECT_FALSE(nd::log(over(-1, 0)).has_value());
  EXPECT_TRUE(is(nd::rsqrt(over(-1, 4)), 0.5, infinity));
  EXPECT_TRUE(is(nd::rsqrt(over(-0.0, infinity)), 0, infinity));
  EXPECT_TRUE(is(nd::acosh(over(-infinity, 1)), 0, 0));
  EXPECT_FALSE(nd::atanh(over(1, infinity)).has_value());
  EXPECT_TRUE(is(nd::atanh(over(-infinity, 0)), -infinity, 0));
  EXPECT_TRUE(is(nd::acos(over(1, infinity)), 0, 0));
  EXPECT_FALSE(nd::asin(over(1.5, infinity)).has_value());
  EXPECT_TRUE(is(nd::tan(over(0, infinity)), -infinity, infinity));
  EXPECT_TRUE(is(nd::reciprocal(over(0, 1)), 1, infinity));
  EXPECT_TRUE(is(nd::reciprocal(over(-2, 0)), -infinity, -0.5));
  EXPECT_TRUE(is(nd::reciprocal(over(-1, 1)), -infinity, infinity));
  EXPECT_TRUE(is(nd::reciprocal(over(-infinity, 0)), -infinity, 0));
  EXPECT_FALSE(nd::reciprocal(over(0, 0)).has_value());
  EXPECT_TRUE(is(nd::divide(over(-infinity, -2), over(0, 4)), -infinity, -0.5));
  EXPECT_TRUE(is(nd::divide(over(2, infinity), over(-infinity, 0)), -infinity, 0));
  EXPECT_TRUE(is(nd::divide(over(0, 0), over(-1, 1)), 0, 0));
  EXPECT_TRUE(is(nd::divide(over(0, 3), over(0, 1)), 0, infinity));
  EXPECT_TRUE(is(nd::divide(over(-infinity, infinity), over(3, 4)), -infinity, infinity));
  EXPECT_TRUE(is(nd::pow(over(-2, 4), -2L), 1.0 / 16, infinity));
  EXPECT_TRUE(is(nd::pow(over(-2, 4), -3L), -infinity, infinity));
  EXPECT_TRUE(is(nd::pow(over(-2, 0), -3L), -infinity, -0.125));
  EXPECT_TRUE(is(nd::pow(over(-infinity, infinity), -4L), 0, infinity));
  EXPECT_TRUE(is(nd::pow(over(-1, 4), over(0.5, 0.5)), 0, 2));
  EXPECT_TRUE(is(nd::pow(over(-1, 0), over(-1, 1)), 0, 0));
  EXPECT_FALSE(nd::pow(over(-1, 0), over(-1, 0)).has_value());
  EXPECT_TRUE(is(nd::pow(over(0, 2), over(-1, 0)), 0.5, infinity));
  EXPECT_TRUE(is(nd::pow(over(0.5, infinity), over(-1, 0)), 0, 2));
  EXPECT_TRUE(is(nd::pow(over(4, infinity), over(0.5, infinity)), 2, infinity));
  EXPECT_TRUE(is(nd::root(over(-16, 16), 4), 0, 2));
  EXPECT_FALSE(nd::root(over(-16, -1), 4).has_value());
  EXPECT_FALSE(nd::root(over(1, 2), 0).has_value());
  EXPECT_TRUE(is(nd::atan2(over(0, 0), over(0, infinity)), 0, 0));
  EXPECT_FALSE(nd::atan2(over(0, 0), over(0, 0)).has_value());
}

TEST(NaturalDomain, UndefinedIsNotEmpty) {
  namespace nd = natural_domain;
  const ball u = ball::undefined(bits);
  const ball x = ball(1, bits);
  for (const std::optional<ball>& z :
       {nd::sqrt(u),   nd::rsqrt(u),      nd::log(u),       nd::log2(u),      nd::log10(u),
        nd::log1p(u),  nd::asin(u),       nd::acos(u),      nd::acosh(u),     nd::atanh(u),
        nd::tan(u),    nd::reciprocal(u), nd::divide(u, x), nd::divide(x, u), nd::pow(u, 2L),
        nd::pow(u, x), nd::pow(x, u),     nd::root(u, 2),   nd::atan2(u, x),  nd::atan2(x, u)}) {
    ASSERT_TRUE(z.has_value());
    EXPECT_TRUE(z->is_undefined());
    EXPECT_EQ(z->precision(), bits);
  }
}

// The set-based form holds f(t) for every member t at which f is defined, in every form of ball.
TEST(NaturalDomain, HoldsTheValuesAtMembers) {
  random_source random(4300);
  for (repeat trial(6000); trial.again();) {
    const tested_function& g = random.choose(tested_functions());
    if (g.set_based == nullptr) continue;
    ball x = random.any_ball(random.between(2, 250));
    if (random.one_in(2)) {  // near an end of the domain
      real m = exactly(std::isinf(g.to) || random.one_in(2) ? g.from : g.to);
      if (random.one_in(2)) mpfr_add_d(m, m, 0x1p-40, MPFR_RNDN);
      const long e = random.between(-300, -1);
      x = ball::from_midpoint_radius(m, random.any_magnitude(e - 31, e - 31));
    }
    SCOPED_TRACE(std::string(g.name) + " of " + described(x));
    const std::optional<ball> z = g.set_based(x);
    const rational t = random.member(x);
    const auto above = [&](double end) { return g.open ? t > q(end) : t >= q(end); };
    const auto below = [&](double end) { return g.open ? t < q(end) : t <= q(end); };
    if ((!std::isinf(g.from) && !above(g.from)) || (!std::isinf(g.to) && !below(g.to))) continue;
    ASSERT_TRUE(z.has_value());
    if (z->is_undefined()) continue;
    const real at = support::exact_real(t);
    real low(1000);
    real high(1000);
    g.f(low.get(), at, MPFR_RNDD);
    g.f(high.get(), at, MPFR_RNDU);
    EXPECT_TRUE(contains(*z, ball(low.get()))) << *z;
    EXPECT_TRUE(contains(*z, ball(high.get()))) << *z;
  }
}

}  // namespace ieee1788_test
}  // namespace polhode
