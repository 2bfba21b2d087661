// The edges: exact results, domains, cancellation, huge arguments, and the range of exponents.

#include <algorithm>
#include <array>
#include <climits>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "support/exact_set.hpp"
#include "support/functions.hpp"
#include "support/random.hpp"

namespace polhode {
namespace corners_test {

using support::described;
using support::exact;
using support::exact_set;
using support::holds;
using support::identical;
using support::kind;
using support::random_source;
using support::real;
using support::repeat;

ball interval(long low, long high, precision p = 64) {
  return ball::from_end_points(real(64, low), real(64, high), p);
}
exact_set set_of(long low, long high) { return {rational(low), rational(high)}; }

TEST(Corners, ExactResultsStayExact) {
  const ball two(2, 64);
  const ball zero(0, 64);
  const ball third = ball(rational(1, 3), 64);
  EXPECT_TRUE(identical(two + two, ball(4, 64)));
  EXPECT_TRUE(identical(two - two, zero));
  EXPECT_TRUE(identical(two * two, ball(4, 64)));
  EXPECT_TRUE(identical(two / two, ball(1, 64)));
  EXPECT_TRUE(identical(sqrt(ball(4, 64)), two));
  EXPECT_TRUE(identical(sqrt(zero), zero));
  EXPECT_TRUE(identical(square(ball(-3, 64)), ball(9, 64)));
  EXPECT_TRUE(identical(pow(two, 10), ball(1024, 64)));
  EXPECT_TRUE(identical(pow(two, -2), ball(rational(1, 4), 64)));
  EXPECT_TRUE(identical(pow(third, 0), ball(1, 64)));
  EXPECT_TRUE(identical(pow(zero, 0), ball(1, 64)));
  EXPECT_TRUE(identical(pow(interval(-1, 1), 0), ball(1, 64)));
  EXPECT_TRUE(identical(hypot(ball(3, 64), ball(-4, 64)), ball(5, 64)));
  EXPECT_TRUE(identical(hypot(zero, zero), zero));
  EXPECT_TRUE(identical(exp(zero), ball(1, 64)));
  EXPECT_TRUE(identical(cos(zero), ball(1, 64)));
  EXPECT_TRUE(identical(cosh(zero), ball(1, 64)));
  EXPECT_TRUE(identical(log(ball(1, 64)), zero));
  EXPECT_TRUE(identical(acos(ball(1, 64)), zero));
  EXPECT_TRUE(identical(acosh(ball(1, 64)), zero));
  EXPECT_TRUE(identical(agm(two, two), two));
  for (const ball& r : {sin(zero), tan(zero), asin(zero), atan(zero), sinh(zero), tanh(zero),
                        asinh(zero), atanh(zero), sin_cos(zero).first}) {
    EXPECT_TRUE(identical(r, zero));
  }
  for (const ball& x : {third, pi(64), interval(-3, 5), ball::entire(64), two}) {
    EXPECT_TRUE(identical(x * 0, zero));
    EXPECT_TRUE(identical(0 * x, zero));
    EXPECT_TRUE(identical(x * zero, zero));
    EXPECT_TRUE(identical(zero * x, zero));
    EXPECT_TRUE(identical(x * 1, x));
    EXPECT_TRUE(identical(x + 0, x));
    EXPECT_TRUE(identical(x - 0, x));
    EXPECT_TRUE(identical(x / 1, x));
  }
  EXPECT_TRUE(identical(zero / third, zero));
}

TEST(Corners, DomainsEnd) {
  const ball across = interval(-1, 1);
  EXPECT_TRUE(sqrt(across).is_undefined());
  EXPECT_TRUE(sqrt(ball(-1, 64)).is_undefined());
  EXPECT_EQ(exact(sqrt(interval(0, 4))), set_of(0, 2));
  EXPECT_TRUE(log(across).is_undefined());
  EXPECT_TRUE(log(interval(0, 1)).is_undefined());
  EXPECT_TRUE(log(ball(0, 64)).is_undefined());
  EXPECT_TRUE(log(ball(-1, 64)).is_undefined());
  EXPECT_TRUE(asin(interval(0, 2)).is_undefined());
  EXPECT_TRUE(asin(interval(-2, 0)).is_undefined());
  EXPECT_TRUE(asin(ball(2, 64)).is_undefined());
  EXPECT_TRUE(acos(ball(-2, 64)).is_undefined());
  EXPECT_TRUE(asin(ball::entire(64)).is_undefined());
  EXPECT_FALSE(asin(across).is_undefined());
  EXPECT_FALSE(acos(ball(-1, 64)).is_undefined());
  EXPECT_TRUE(acosh(interval(0, 2)).is_undefined());
  EXPECT_TRUE(acosh(ball(0, 64)).is_undefined());
  EXPECT_FALSE(acosh(interval(1, 2)).is_undefined());
  EXPECT_TRUE(atanh(across).is_undefined());
  EXPECT_TRUE(atanh(ball(1, 64)).is_undefined());
  EXPECT_TRUE(atanh(ball(-1, 64)).is_undefined());
  EXPECT_TRUE(atanh(interval(0, 1)).is_undefined());
  EXPECT_TRUE(atanh(ball(2, 64)).is_undefined());
  EXPECT_TRUE(pow(across, -1).is_undefined());
  EXPECT_TRUE(pow(ball(0, 64), -3).is_undefined());
  EXPECT_TRUE(agm(across, ball(1, 64)).is_undefined());
  EXPECT_TRUE(agm(ball(1, 64), interval(-1, 0)).is_undefined());
  EXPECT_TRUE(agm(interval(0, 8), interval(-1, 0)).is_undefined());
  for (const ball& divisor :
       {across, interval(0, 1), interval(-1, 0), ball(0, 64), ball::entire(64)}) {
    EXPECT_TRUE((ball(1, 64) / divisor).is_undefined());
    EXPECT_TRUE((1 / divisor).is_undefined());
  }
  EXPECT_TRUE((ball(1, 64) / 0).is_undefined());
  EXPECT_TRUE((across / 0).is_undefined());
  EXPECT_TRUE((ball(1, 64) / integer(0)).is_undefined());
}

TEST(Corners, HalfLines) {
  const ball up = ball::from_end_points(real(64, 1), real::infinity(1), 64);
  const ball below = ball::from_end_points(real::infinity(-1), real(64, -1), 64);
  const auto is = [](const ball& x, std::optional<rational> low, std::optional<rational> high) {
    return exact(x) == exact_set{std::move(low), std::move(high)};
  };
  EXPECT_TRUE(is(up + 1, 2, std::nullopt));
  EXPECT_TRUE(is(up + below, std::nullopt, std::nullopt));
  EXPECT_TRUE(is(up - up, std::nullopt, std::nullopt));
  EXPECT_TRUE(is(up * up, 1, std::nullopt));
  EXPECT_TRUE(is(up * below, std::nullopt, -1));
  EXPECT_TRUE(is(below * below, 1, std::nullopt));
  EXPECT_TRUE(is(1 / up, 0, 1));
  EXPECT_TRUE(is(1 / below, -1, 0));
  EXPECT_TRUE(is(up / up, 0, std::nullopt));
  EXPECT_TRUE(is(up / below, std::nullopt, 0));
  EXPECT_TRUE(is(square(below), 1, std::nullopt));
  EXPECT_TRUE(is(sqrt(up), 1, std::nullopt));
  EXPECT_TRUE(is(abs(below), 1, std::nullopt));
  EXPECT_TRUE(is(-up, std::nullopt, -1));
  EXPECT_TRUE(is(scale(up, 4), 16, std::nullopt));
  EXPECT_TRUE(is(pow(up, 3), 1, std::nullopt));
  EXPECT_TRUE(is(pow(below, 3), std::nullopt, -1));
  EXPECT_TRUE(is(pow(below, -1), -1, 0));
  EXPECT_TRUE(is(pow(below, -2), 0, 1));
  EXPECT_TRUE(is(log(up), 0, std::nullopt));
  EXPECT_TRUE(is(acosh(up), 0, std::nullopt));
  EXPECT_TRUE(is(hull(up, below), std::nullopt, std::nullopt));
  EXPECT_TRUE(is(agm(up, up), 1, std::nullopt));
  EXPECT_TRUE(is(sin(up), -1, 1));
  EXPECT_TRUE(is(cos(below), -1, 1));
  EXPECT_TRUE(tan(up).is_undefined());
  EXPECT_TRUE(exact(exp(below)).lower == rational(0));
  EXPECT_FALSE(exact(exp(up)).upper);
  EXPECT_TRUE(exact(atan(ball::entire(64))).is_bounded());
  EXPECT_TRUE(exact(tanh(ball::entire(64))) == set_of(-1, 1));
  EXPECT_TRUE(is(cosh(ball::entire(64)), 1, std::nullopt));
  EXPECT_TRUE(is(hypot(ball::entire(64), up), 1, std::nullopt));
}

TEST(Corners, Cancellation) {
  const ball x = ball(1, 64) + ball(rational(1, 3), 64);
  const ball difference = x - 1;
  EXPECT_TRUE(holds(difference, rational(1, 3)));
  EXPECT_TRUE(identical(x - x, x - ball(x)));
  EXPECT_TRUE(contains_zero(x - x));
  // Down to nothing but the radius.
  ball y(rational(1, 3), 128);
  rational q(1, 3);
  for (int i = 0; i < 100; ++i) {
    y = 10 * y - 3;
    q = 10 * q - 3;
    EXPECT_TRUE(holds(y, q));
  }
  EXPECT_GT(support::to_rational(y.radius()), 1000);
}

// -------------------------------------------------------------------------------------------------
// Circular functions of great numbers, and across poles.

TEST(Corners, SineOfAGreatNumber) {
  const real great = real::power_of_two(1000);
  const ball x((mpfr_srcptr(great)));
  const ball s = sin(x);
  const support::enclosure truth = support::enclose(
      [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_sin(r, great, rounding); }, 1400);
  EXPECT_TRUE(holds(s, support::to_rational(truth.lower)));
  EXPECT_TRUE(s.radius() < magnitude::power_of_two(-60));
  EXPECT_FALSE(tan(x).is_undefined());

  // Two great numbers a quarter turn apart.
  real next(1100);
  mpfr_add_d(next, great, 1.5, MPFR_RNDN);
  const ball wide = ball::from_end_points(great, next, 1100);
  EXPECT_TRUE(exact(sin(wide)).holds(support::to_rational(truth.lower)));
  EXPECT_FALSE(exact(sin(wide)) == set_of(-1, 1));
}

TEST(Corners, BeyondReductionTheUnitIntervalIsTheAnswer) {
  for (const long exponent : {2'000'000L, 1L << 29}) {
    const real great = real::power_of_two(exponent);
    const ball x((mpfr_srcptr(great)));
    const ball thin = ball::from_midpoint_radius(great, magnitude::power_of_two(-70));
    const ball wide = ball::from_end_points(real(64, 1), great, 64);
    for (const ball& y : {x, -x, thin, wide, -wide}) {
      EXPECT_EQ(exact(sin(y)), set_of(-1, 1));
      EXPECT_EQ(exact(cos(y)), set_of(-1, 1));
      EXPECT_EQ(exact(sin_cos(y).first), set_of(-1, 1));
      EXPECT_EQ(exact(sin_cos(y).second), set_of(-1, 1));
      EXPECT_TRUE(tan(y).is_undefined());
    }
  }
}

TEST(Corners, ExtremaInsideAreTaken) {
  EXPECT_EQ(exact(sin(interval(0, 7))), set_of(-1, 1));
  EXPECT_EQ(*exact(sin(interval(1, 2))).upper, 1);
  EXPECT_EQ(*exact(sin(interval(4, 5))).lower, -1);
  EXPECT_EQ(*exact(cos(interval(-1, 1))).upper, 1);
  EXPECT_EQ(*exact(cos(interval(3, 4))).lower, -1);
  EXPECT_EQ(*exact(cos(interval(0, 1))).upper, 1);
  EXPECT_EQ(*exact(cos(interval(-1, 0))).upper, 1);
  EXPECT_EQ(*exact(sin(interval(0, 1))).lower, 0);
  EXPECT_EQ(*exact(sin(interval(-1, 0))).upper, 0);
  EXPECT_LT(*exact(sin(interval(2, 4))).upper, 1);
  EXPECT_GT(*exact(sin(interval(2, 4))).lower, -1);
  // Between a whole turn and the 7 from which on nothing is computed.
  const ball x = ball::from_end_points(real(64, 0), real(64, rational(13, 2), MPFR_RNDN), 64);
  EXPECT_EQ(exact(sin(x)), set_of(-1, 1));
  EXPECT_EQ(exact(cos(x)), set_of(-1, 1));
}

TEST(Corners, TangentAcrossItsPoles) {
  EXPECT_TRUE(tan(interval(1, 2)).is_undefined());
  EXPECT_TRUE(tan(interval(-2, -1)).is_undefined());
  EXPECT_TRUE(tan(interval(0, 4)).is_undefined());
  EXPECT_TRUE(tan(interval(-100, 100)).is_undefined());
  EXPECT_FALSE(tan(interval(-1, 1)).is_undefined());
  EXPECT_FALSE(tan(interval(2, 4)).is_undefined());
  for (const precision p : {precision{64}, precision{128}, precision{333}}) {
    // The enclosure of pi/2 holds the pole; its middle does not.
    EXPECT_TRUE(tan(scale(pi(p), -1)).is_undefined());
    EXPECT_TRUE(tan(scale(pi(p), -1) * 3).is_undefined());
    EXPECT_TRUE(tan(-scale(pi(p), -1)).is_undefined());
    EXPECT_FALSE(tan(scale(pi(p), -1).middle()).is_undefined());
    EXPECT_TRUE(
        certainly_less(tan(scale(pi(p + 50), -1) - ball(support::power_of_two(-p), p)), 0L) ||
        certainly_greater(tan(scale(pi(p + 50), -1) - ball(support::power_of_two(-p), p)), 0L));
  }
  // Beside a pole, at any distance against the radius.
  random_source random(800);
  for (repeat trial(2000); trial.again();) {
    const precision p = random.between(40, 200);
    const ball half_pi = scale(pi(p), -1).middle();
    real m(p);
    half_pi.midpoint(m);
    for (long i = random.between(0, 20); i > 0; --i) mpfr_nextbelow(m);
    const ball x = ball::from_midpoint_radius(m, random.any_magnitude(-p - 40 - 31, -p + 8 - 31));
    SCOPED_TRACE(described(x));
    const ball t = tan(x);
    real pole(p + 300);
    mpfr_const_pi(pole, MPFR_RNDN);
    mpfr_div_2ui(pole, pole, 1, MPFR_RNDN);
    const bool across = exact(x).holds(support::to_rational(pole));
    if (across) {
      EXPECT_TRUE(t.is_undefined());
    } else if (!t.is_undefined()) {
      for (const rational& q : {random.member(x), *exact(x).lower, *exact(x).upper}) {
        const real at = support::exact_real(q);
        const support::enclosure v = support::enclose(
            [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_tan(r, at, rounding); }, p + 300);
        EXPECT_TRUE(holds(t, support::to_rational(v.lower)));
      }
    }
  }
}

// -------------------------------------------------------------------------------------------------
// The range of exponents. MPFR's own is 2^+-(2^30 - 1): too far for rationals, so questions are put
// to balls, or the range is narrowed to where rationals follow.

TEST(Corners, OverflowIsNoNumberPassedOn) {
  const ball billion(1'000'000'000L, 64);
  const ball great = exp(billion);
  EXPECT_FALSE(great.is_undefined());
  EXPECT_FALSE(great.is_bounded());
  EXPECT_TRUE(certainly_positive(great));
  EXPECT_TRUE(certainly_greater(great, LONG_MAX));
  const ball small = exp(-billion);
  EXPECT_TRUE(small.is_bounded());
  EXPECT_TRUE(certainly_less(small, ball(support::power_of_two(-1'000'000), 64)));
  EXPECT_FALSE(certainly_negative(small));
  EXPECT_FALSE(certainly_less(cosh(billion), LONG_MAX));
  EXPECT_FALSE(certainly_less(sinh(billion), LONG_MAX));
  EXPECT_TRUE(certainly_less(sinh(-billion), LONG_MIN));
  EXPECT_TRUE(contains(tanh(billion), 1L) || certainly_less(tanh(billion), 1L));

  const real huge = real::power_of_two(1L << 29);
  const real tiny = real::power_of_two(-(1L << 29));
  const ball h((mpfr_srcptr(huge)));
  const ball t((mpfr_srcptr(tiny)));
  EXPECT_TRUE(identical(h * t, ball(1, 64)));
  EXPECT_TRUE(identical(t / t, ball(1, 64)));
  for (const ball& overflown : {h * h * h, square(h * h), h / t / t, pow(h, 3), pow(t, -3)}) {
    EXPECT_FALSE(overflown.is_undefined());
    EXPECT_FALSE(overflown.is_bounded());
    EXPECT_TRUE(possibly_less(h, overflown));
  }
  for (const ball& underflown : {t * t * t, square(t * t), t / h / h, pow(t, 3), pow(h, -3)}) {
    EXPECT_TRUE(underflown.is_bounded());
    EXPECT_FALSE(underflown.is_exact());
    EXPECT_TRUE(contains_zero(underflown));
    EXPECT_TRUE(certainly_less(underflown, t));
    EXPECT_TRUE((1 / underflown).is_undefined());
  }
  EXPECT_TRUE(identical(hypot(h, ball(0, 64)), h));
  EXPECT_TRUE(identical(sqrt(h * h), h) || !(h * h).is_bounded());
}

TEST(Corners, ScalingAsFarAsALongGoes) {
  for (const ball& x : {ball(1, 64), ball(-3, 64), pi(64), interval(1, 3), interval(-1, 3)}) {
    for (const long n : {LONG_MAX, LONG_MAX - 100, 1L << 61, 1L << 40}) {
      const ball up = scale(x, n);
      EXPECT_FALSE(up.is_bounded());
      EXPECT_FALSE(up.is_undefined());
      EXPECT_TRUE(possibly_less(ball(5, 64), up) || possibly_less(up, ball(-5, 64)));
    }
    for (const long n : {LONG_MIN, LONG_MIN + 100, -(1L << 61), -(1L << 40)}) {
      const ball down = scale(x, n);
      EXPECT_TRUE(contains_zero(down));
      EXPECT_TRUE(certainly_less(down, ball(support::power_of_two(-1'000'000), 64)));
      EXPECT_FALSE(down.is_exact());
    }
  }
  EXPECT_TRUE(identical(scale(ball(0, 64), LONG_MAX), ball(0, 64)));
  EXPECT_TRUE(identical(scale(ball(0, 64), LONG_MIN), ball(0, 64)));
}

TEST(Corners, PowersAsFarAsALongGoes) {
  EXPECT_TRUE(identical(pow(ball(1, 64), LONG_MIN), ball(1, 64)));
  EXPECT_TRUE(identical(pow(ball(-1, 64), LONG_MIN), ball(1, 64)));
  EXPECT_TRUE(identical(pow(ball(-1, 64), LONG_MAX), ball(-1, 64)));
  EXPECT_FALSE(pow(ball(2, 64), LONG_MAX).is_bounded());
  EXPECT_TRUE(contains_zero(pow(ball(2, 64), LONG_MIN)));
  EXPECT_TRUE(contains(pow(interval(-1, 1), LONG_MAX), interval(-1, 1)));
  EXPECT_EQ(exact(pow(interval(-1, 1), LONG_MAX - 1)), set_of(0, 1));
  const ball around_one = ball::from_midpoint_radius(real(64, 1), magnitude::power_of_two(-62));
  EXPECT_TRUE(contains(pow(around_one, LONG_MAX), 1L));
  EXPECT_TRUE(certainly_positive(pow(around_one, LONG_MIN)));
}

/// MPFR's range of exponents, narrowed while this lives.
class narrow_exponents {
 public:
  narrow_exponents(mpfr_exp_t least, mpfr_exp_t most)
      : least_(mpfr_get_emin()), most_(mpfr_get_emax()) {
    mpfr_set_emin(least);
    mpfr_set_emax(most);
  }
  narrow_exponents(const narrow_exponents&) = delete;
  narrow_exponents& operator=(const narrow_exponents&) = delete;
  ~narrow_exponents() {
    mpfr_set_emin(least_);
    mpfr_set_emax(most_);
  }

 private:
  mpfr_exp_t least_;
  mpfr_exp_t most_;
};

/// Numbers of p bits all over a narrow range, its ends above all.
real any_in_range(random_source& random, precision p, long least, long most) {
  const std::array<long, 6> edges = {least, least + 1, least + 2, most, most - 1, most - 2};
  const long e = random.one_in(2) ? random.choose(edges) : random.between(least, most);
  real x = random.any_real(p, e, e);
  if (random.one_in(8)) {
    mpfr_set_ui_2exp(x, 1, least - 1, MPFR_RNDN);
  } else if (random.one_in(8)) {
    mpfr_set_inf(x, 1);
    mpfr_nextbelow(x);
  }
  if (random.one_in(2)) mpfr_neg(x, x, MPFR_RNDN);
  return x;
}

ball any_ball_in_range(random_source& random, precision p, long least, long most) {
  const real m = any_in_range(random, p, least, most);
  switch (random.between(0, 3)) {
    case 0:
      return ball(m.get());
    case 1: {
      const long e = mpfr_get_exp(m) - random.between(25, p + 20) - 31;
      return ball::from_midpoint_radius(m, random.any_magnitude(e, e));
    }
    case 2: {
      real near = m;
      for (long i = random.between(1, 3); i > 0; --i) mpfr_nextabove(near);
      return random.between_ends(m, near, p);
    }
    default:
      return random.between_ends(m, any_in_range(random, p, least, most), p);
  }
}

/// A result and what it must hold, given members a of x and b of y.
struct expectation {
  const char* name;
  ball result;
  rational (*value)(const rational& a, const rational& b);
};

std::vector<expectation> operations(const ball& x, const ball& y) {
  using q = const rational&;
  return {{"+", x + y, [](q a, q b) { return a + b; }},
          {"-", x - y, [](q a, q b) { return a - b; }},
          {"*", x * y, [](q a, q b) { return a * b; }},
          {"/", x / y, [](q a, q b) { return b == 0 ? b : a / b; }},
          {"square", square(x), [](q a, q) { return a * a; }},
          {"cube", pow(x, 3), [](q a, q) { return a * a * a; }},
          {"inverse", pow(x, -1), [](q a, q) { return a == 0 ? a : rational(1 / a); }},
          {"inverse square", pow(x, -2), [](q a, q) { return a == 0 ? a : rational(1 / (a * a)); }},
          {"scale up", scale(x, 50), [](q a, q) { return a * support::power_of_two(50); }},
          {"scale down", scale(x, -50), [](q a, q) { return a * support::power_of_two(-50); }},
          {"* 3", x * 3L, [](q a, q) { return a * 3; }},
          {"/ 3", x / 3L, [](q a, q) { return a / 3; }},
          {"+ 3", x + 3L, [](q a, q) { return a + 3; }},
          {"abs", abs(x), [](q a, q) { return rational(abs(a)); }},
          {"hull", hull(x, y), [](q, q b) { return b; }},
          {"precision", x.with_precision(30), [](q a, q) { return a; }}};
}

bool is_next_to_zero(const exact_set& x, long least) {
  const rational two = support::power_of_two(least);
  return std::min(abs(*x.lower), abs(*x.upper)) <= two;
}

TEST(Corners, ContainmentInANarrowRangeOfExponents) {
  constexpr long least = -80;
  constexpr long most = 80;
  random_source random(801);
  for (repeat trial(6000); trial.again();) {
    const precision p = random.choose(std::array<precision, 5>{24, 53, 64, 100, 130});
    ball x;
    ball y;
    ball middle;
    std::vector<expectation> results;
    {
      const narrow_exponents narrow(least, most);
      x = any_ball_in_range(random, p, least, most);
      y = any_ball_in_range(random, p, least, most);
      results = operations(x, y);
      middle = x.middle();
    }
    const exact_set sx = exact(x);
    const exact_set sy = exact(y);
    if (!sx.is_bounded() || !sy.is_bounded()) continue;
    SCOPED_TRACE(described(x) + ", " + described(y));
    const rational a = random.member(sx);
    const rational b = random.member(sy);
    for (const expectation& e : results) {
      const std::string name = e.name;
      if ((name == "/" && sy.holds(0)) || (name.starts_with("inverse") && sx.holds(0))) {
        EXPECT_TRUE(e.result.is_undefined()) << name;
      } else if (e.result.is_undefined()) {
        // An end came to 0 where the radius is below the least number that there is.
        EXPECT_TRUE(name == "/" ? is_next_to_zero(sy, least) : is_next_to_zero(sx, least)) << name;
      } else {
        EXPECT_TRUE(holds(e.result, e.value(a, b))) << name;
      }
    }
    ASSERT_TRUE(middle.is_exact());
    EXPECT_TRUE(sx.holds(*exact(middle).lower)) << "the middle is a member";
  }
}

// A complex function rounds intermediate numbers itself: none of them may be taken for more than it
// is after an underflow.
TEST(Corners, ComplexContainmentInANarrowRangeOfExponents) {
  constexpr long least = -80;
  constexpr long most = 80;
  struct number {
    rational re;
    rational im;
    number operator*(const number& w) const {
      return {re * w.re - im * w.im, re * w.im + im * w.re};
    }
    [[nodiscard]] number inverse() const {
      const rational norm = re * re + im * im;
      return {re / norm, -im / norm};
    }
  };
  random_source random(803);
  for (repeat trial(6000); trial.again();) {
    const precision p = random.choose(std::array<precision, 5>{24, 53, 64, 100, 130});
    complex_ball z;
    complex_ball w;
    std::array<complex_ball, 6> results;
    {
      const narrow_exponents narrow(least, most);
      // Exponents around an eighth of the range, where the functions change their way, are of
      // interest too.
      const long from = random.one_in(2) ? least : -11;
      const long to = random.one_in(2) ? most : 11;
      const auto part = [&] {
        return random.one_in(6) ? ball(0, p) : any_ball_in_range(random, p, from, to);
      };
      z = complex_ball(part(), part());
      w = complex_ball(part(), part());
      if (random.one_in(3)) {
        // Nearly i z, and exact: a part of the quotient is the difference of two products that
        // agree in all p bits.
        const real x = any_in_range(random, p, -8, 8);
        const real y = any_in_range(random, p, -8, 8);
        real beside = y;
        mpfr_nextbelow(beside);
        if (mpfr_number_p(beside) == 0) continue;
        z = complex_ball(ball(x.get()), ball(y.get()));
        w = complex_ball(-ball(beside.get()), ball(x.get()));
        if (random.one_in(2)) w = complex_ball(ball(x.get()), ball(beside.get()));
      }
      results = {z * w, square(z), z / w, reciprocal(z), pow(z, 3), square(sqrt(z))};
    }
    const std::array parts = {exact(z.re), exact(z.im), exact(w.re), exact(w.im)};
    if (!std::ranges::all_of(parts, [](const exact_set& x) { return x.is_bounded(); })) continue;
    SCOPED_TRACE(described(z.re) + ", " + described(z.im) + "; " + described(w.re) + ", " +
                 described(w.im));
    const number a{random.member(parts[0]), random.member(parts[1])};
    const number b{random.member(parts[2]), random.member(parts[3])};
    const auto check = [&](const complex_ball& r, auto&& value, const char* name) {
      if (r.is_undefined()) return;
      const number v = value();
      EXPECT_TRUE(holds(r.re, v.re)) << name;
      EXPECT_TRUE(holds(r.im, v.im)) << name;
    };
    check(
        results[0], [&] { return a * b; }, "*");
    check(
        results[1], [&] { return a * a; }, "square");
    check(
        results[2], [&] { return a * b.inverse(); }, "/");
    check(
        results[3], [&] { return a.inverse(); }, "reciprocal");
    check(
        results[4], [&] { return a * a * a; }, "cube");
    check(
        results[5], [&] { return a; }, "square of the root");
  }
}

TEST(Corners, FunctionsInANarrowRangeOfExponents) {
  constexpr long least = -60;
  constexpr long most = 60;
  random_source random(802);
  for (repeat trial(1500); trial.again();) {
    const precision p = random.choose(std::array<precision, 3>{24, 64, 100});
    for (const support::elementary_function& f : support::elementary_functions()) {
      ball x;
      ball y;
      {
        const narrow_exponents narrow(least, most);
        x = any_ball_in_range(random, p, least, random.one_in(2) ? 7 : 1);
        y = f.of(x);
      }
      const exact_set s = exact(x);
      if (y.is_undefined() || !s.is_bounded()) continue;
      SCOPED_TRACE(std::string(f.name) + " of " + described(x));
      EXPECT_TRUE(f.defined_on(s));
      const rational a = random.member(s);
      if (f.grows && abs(a) > support::power_of_two(12)) continue;
      const support::enclosure v = support::value_at(f, a, p + 200);
      if (!v.lower.is_finite() || !v.upper.is_finite()) continue;
      EXPECT_TRUE(holds(y, support::to_rational(v.lower)));
      EXPECT_TRUE(holds(y, support::to_rational(v.upper)));
    }
  }
}

TEST(Corners, ConstructionInANarrowRangeOfExponents) {
  ball small;
  ball great;
  ball tenth;
  {
    const narrow_exponents narrow(-20, 20);
    small = ball::exactly(1e-300);
    great = ball(rational(1) / support::power_of_two(-100), 64);
    tenth = ball(rational(1, 10), 64);
  }
  EXPECT_TRUE(holds(small, rational(1e-300)));
  EXPECT_FALSE(great.is_bounded());
  EXPECT_TRUE(holds(great, support::power_of_two(100)));
  EXPECT_TRUE(holds(tenth, rational(1, 10)));
}

TEST(Corners, EndsAtTheGreatestExponent) {
  // Two neighbours just below overflow, and a ball whose radius passes it.
  const narrow_exponents narrow(-1000, 1000);
  for (const precision p : {precision{64}, precision{256}, precision{300}}) {
    real top(p);
    mpfr_set_inf(top, 1);
    mpfr_nextbelow(top);
    real below = top;
    mpfr_nextbelow(below);
    mpfr_nextbelow(below);
    const ball x = ball::from_end_points(below, top, p);
    EXPECT_TRUE(x.is_bounded());
    EXPECT_FALSE(x.radius().is_infinite());
    EXPECT_TRUE(contains(x, support::to_rational(top)));
    EXPECT_TRUE(contains(x, support::to_rational(below)));
    EXPECT_FALSE(contains(x, rational(1)));
    EXPECT_TRUE(certainly_positive(x));
    EXPECT_FALSE(x.middle().is_undefined());

    const ball past = ball::from_midpoint_radius(top, magnitude::power_of_two(960));
    EXPECT_TRUE(contains(past, support::to_rational(top)));
    if (past.is_bounded()) {
      EXPECT_GE(upper_rational(past), support::to_rational(top) + support::power_of_two(960));
      EXPECT_LE(lower_rational(-past), -support::to_rational(top) - support::power_of_two(960));
    }
    const std::string text = to_decimal(past, 5);
    EXPECT_EQ(text.find('@'), std::string::npos) << text;
    EXPECT_NE(to_decimal(-past, 5).find("-inf"), std::string::npos) << to_decimal(-past, 5);
    EXPECT_EQ(ball::from_end_points(below, top, 24).is_bounded(), false) << "24 bits round it up";
  }
}

TEST(Corners, QuadrantsOfTheLeastNumbers) {
  const narrow_exponents narrow(-100, 100);
  real least(64, 0);
  mpfr_nextabove(least);
  real minus(64);
  mpfr_neg(minus, least, MPFR_RNDN);
  EXPECT_EQ(*exact(cos(ball::from_end_points(minus, real(64, 1), 64))).upper, 1);
  EXPECT_EQ(*exact(cos(ball::from_end_points(real(64, -1), minus, 64))).upper, 1);
  EXPECT_FALSE(tan(ball::from_end_points(minus, real(64, 1), 64)).is_undefined());
  EXPECT_TRUE(tan(ball::from_end_points(minus, real(64, 2), 64)).is_undefined());
  EXPECT_FALSE(sin(ball::from_end_points(minus, least, 64)).is_undefined());
}

TEST(Corners, RadiiSaturate) {
  const real one(64, 1);
  const ball most = ball::from_midpoint_radius(one, magnitude::power_of_two(1L << 60));
  EXPECT_FALSE(most.is_bounded());
  EXPECT_TRUE(contains(most, rational(-1000)));
  const ball least = ball::from_midpoint_radius(one, magnitude::power_of_two(LONG_MIN));
  EXPECT_FALSE(least.is_exact());
  for (const ball& r : {least * least, least / least, square(least), sqrt(least), pow(least, 5),
                        least.enlarged({}), least.with_precision(128), agm(least, least)}) {
    EXPECT_FALSE(r.is_exact());
    EXPECT_TRUE(contains(r, rational(1)));
  }
  EXPECT_FALSE(exp(least).is_exact());
  EXPECT_FALSE(ball(0, 64).enlarged(magnitude::power_of_two(LONG_MIN)).is_exact());
  EXPECT_FALSE(ball(0, 64).enlarged(magnitude::infinity()).is_bounded());
  ball x = ball::from_midpoint_radius(one, magnitude::power_of_two(-30));
  for (int i = 0; i < 80; ++i) {  // the radius grows by squaring until it has no bound
    x = square(x);
    EXPECT_FALSE(x.is_undefined());
    EXPECT_TRUE(contains(x, 1L));
  }
  EXPECT_FALSE(x.is_bounded());
}

}  // namespace corners_test
}  // namespace polhode
