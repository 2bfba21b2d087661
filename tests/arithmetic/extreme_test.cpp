// The inclusion principle at the ends of MPFR's range of exponents, and far beyond what a rational
// can be written out for: operands from 2^(-2^30) to 2^(2^30), with radii from 2^(-2^58) to
// 2^(2^58). The oracle is Arb, whose exponents have no limit. Without Arb the named cases at the
// beginning remain.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/arithmetic/text.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"
#include "support/real.hpp"

#ifdef POLHODE_HAVE_ARB
#include <acb.h>
#include <arb_hypgeom.h>
#endif

namespace polhode {
namespace extreme_test {

using support::described;
using support::random_source;
using support::real;
using support::repeat;

std::string described(const complex_ball& z) {
  return support::described(z.re) + " + i " + support::described(z.im);
}

/// 2^n at p bits.
ball two_to(long n, precision p = 64) { return scale(ball(1, p), n); }

/// The ends are NaNs, infinities, zeros, or numbers within MPFR's range; and the ball can be
/// computed on.
::testing::AssertionResult is_sound_number(const ball& x) {
  if (x.precision() < 2) return ::testing::AssertionFailure() << "no precision";
  if (x.is_undefined()) return ::testing::AssertionSuccess();
  for (const int side : {-1, 1}) {
    real end(x.precision() + 40);
    if (side < 0) {
      x.lower(end);
    } else {
      x.upper(end);
    }
    if (mpfr_nan_p(end) != 0) return ::testing::AssertionFailure() << "an end is a NaN";
    if (mpfr_regular_p(end) != 0 &&
        (mpfr_get_exp(end) < mpfr_get_emin() || mpfr_get_exp(end) > mpfr_get_emax())) {
      return ::testing::AssertionFailure() << "an exponent out of range: " << mpfr_get_exp(end);
    }
  }
  return ::testing::AssertionSuccess();
}
::testing::AssertionResult is_sound_number(const complex_ball& z) {
  const ::testing::AssertionResult re = is_sound_number(z.re);
  return re ? is_sound_number(z.im) : re;
}

/// A number with a known size, 2^(least - 1) <= |x| < 2^most, may be a member; so may no other
/// number be the only one.
::testing::AssertionResult may_have_size(const ball& x, std::int64_t least, std::int64_t most) {
  if (!is_sound_number(x)) return is_sound_number(x);
  if (x.is_undefined()) return ::testing::AssertionSuccess();
  if (x.magnitude_upper() < magnitude::power_of_two(least - 1) ||
      x.magnitude_lower() > magnitude::power_of_two(most)) {
    return ::testing::AssertionFailure() << described(x) << " excludes the value";
  }
  return ::testing::AssertionSuccess();
}

constexpr long half_range =
    1L << 29;  // the squares of 2^half_range and its inverse leave the range

TEST(Extreme, QuotientsWhoseSquaresOverflow) {
  // |e^z| is about 2^577078016: its square is beyond 2^(2^30).
  const complex_ball z(400000000, 1, 64);
  const complex_ball w = exp(z);
  ASSERT_TRUE(w.is_bounded());
  for (const complex_ball& r : {1 / w, reciprocal(w), complex_ball(1, 64) / w, pow(w, -1)}) {
    EXPECT_FALSE(r.is_exact());
    EXPECT_FALSE(r.is_undefined());
    EXPECT_TRUE(may_have_size(r.re, -577078020, -577078010));
    EXPECT_TRUE(may_have_size(r.im, -577078020, -577078010));
    EXPECT_TRUE(overlaps(r, exp(-z)));
    EXPECT_TRUE(r.magnitude_upper() < magnitude::power_of_two(-577078010)) << "and is narrow";
  }
  EXPECT_TRUE(overlaps(w / w, complex_ball(1, 64)));
  EXPECT_TRUE((w / w).magnitude_upper() < magnitude::power_of_two(1));
}

TEST(Extreme, PowersThatLeaveTheRange) {
  // 3^400000000 is within the range, and its square is not; 3^(10^9) is beyond it.
  const complex_ball three(3, 64);
  const complex_ball inverse = pow(three, -400000000L);
  EXPECT_TRUE(overlaps(inverse.re, pow(ball(3, 64), -400000000L)));
  EXPECT_TRUE(certainly_positive(inverse.re));
  EXPECT_TRUE(contains_zero(inverse.im));
  for (const long n : {1000000000L, -1000000000L}) {
    const complex_ball r = pow(complex_ball(3, 1, 64), n);
    EXPECT_FALSE(r.is_exact()) << n;
    EXPECT_TRUE(is_sound_number(r)) << n;
    EXPECT_TRUE(may_have_size(r.re, n < 0 ? -1L << 31 : 1L << 30, n < 0 ? -(1L << 30) : 1L << 31));
  }
}

TEST(Extreme, RootsAndMeansOfGreatNumbers) {
  const complex_ball z(two_to(half_range), ball(1, 64));
  const complex_ball root = sqrt(z);
  EXPECT_FALSE(root.is_exact());
  EXPECT_TRUE(contains(root.re, two_to(half_range / 2)) || !root.re.is_exact());
  EXPECT_TRUE(may_have_size(root.re, half_range / 2, half_range / 2 + 1));
  EXPECT_TRUE(may_have_size(root.im, -half_range / 2 - 2, -half_range / 2));
  EXPECT_TRUE(root.im.magnitude_upper() < magnitude::power_of_two(-half_range / 2 + 1));
  EXPECT_TRUE(overlaps(square(root), z));
  const complex_ball mean = agm(z);
  // agm(1, 2^n) is about (pi/2) 2^n / log(4 2^n): here 2^(n - 28) within a factor of 4.
  EXPECT_FALSE(mean.is_exact());
  EXPECT_TRUE(may_have_size(mean.re, half_range - 30, half_range - 26));
  EXPECT_TRUE(overlaps(mean.re, agm(ball(1, 64), two_to(half_range))));
}

TEST(Extreme, RegionsInBalls) {
  const region z = region::in_balls(complex_ball(400000000, 1, 100));
  const region r = 1 / exp(z);
  ASSERT_TRUE(r.is_analytic());
  EXPECT_FALSE(r.magnitude_upper().is_zero());
  EXPECT_TRUE(r.magnitude_upper() >= magnitude::power_of_two(-577078018));
  EXPECT_TRUE(overlaps(r.to_complex_ball(), exp(-z).to_complex_ball()));
}

TEST(Extreme, JetsOfComplexBalls) {
  const complex_ball z = exp(complex_ball(400000000, 1, 64));
  const auto r = 1 / jet<complex_ball, 2>::variable(z);
  EXPECT_TRUE(overlaps(r[0], exp(complex_ball(-400000000, -1, 64))));
  EXPECT_FALSE(r[0].is_exact());
  // -1/z^2 and 1/z^3 are below the least number, and not 0.
  for (const int k : {1, 2}) {
    EXPECT_FALSE(r[k].is_exact()) << k;
    EXPECT_TRUE(contains_zero(r[k].re)) << k;
  }
}

TEST(Extreme, SquaresBelowTheLeastNumber) {
  // One product is 0 and the other underflows: mpfr_fmms then returns garbage.
  for (const precision p : {precision{64}, precision{128}, precision{2000}}) {
    const complex_ball z(two_to(-half_range - 5, p), ball(0, p));
    for (const complex_ball& s :
         {square(z), z * z, pow(z, 2), z * -z, square(complex_ball(z.im, z.re))}) {
      EXPECT_TRUE(is_sound_number(s)) << p;
      EXPECT_FALSE(s.re.is_exact()) << p;
      EXPECT_TRUE(contains_zero(s.re) ||
                  s.re.magnitude_lower() <= magnitude::power_of_two(-(1L << 30)));
      EXPECT_TRUE(contains(s.re + 1L, 1L)) << p;
      EXPECT_TRUE(log(s.re).is_undefined()) << "not the logarithm of garbage";
    }
    EXPECT_TRUE(is_sound_number(z / z)) << p;
    EXPECT_TRUE(contains((z / z).re, 1L)) << p;
    EXPECT_TRUE(is_sound_number(sqrt(z))) << p;
  }
}

TEST(Extreme, SumsOfProductsThatOverflow) {
  const ball great = two_to(half_range);
  ball r;
  fma(r, great, great, ball(0, 64));
  EXPECT_TRUE(is_sound_number(r));
  EXPECT_FALSE(r.is_bounded());
  EXPECT_TRUE(is_sound_number(r + 1L));
  const ball tiny = two_to(-half_range - 5);
  fma(r, tiny, tiny, ball(0, 64));
  EXPECT_TRUE(is_sound_number(r));
  EXPECT_FALSE(r.is_exact());
  fma(r, tiny, tiny, two_to(-(1L << 30) + 10));
  EXPECT_TRUE(may_have_size(r, -(1L << 30) + 10, -(1L << 30) + 11));
}

TEST(Extreme, TinyPartsTakeNoTime) {
  // mpfr_sinh_cosh would work with as many bits as there are zeros behind the point.
  for (const long n : {1000000L, 100000000L, half_range}) {
    const complex_ball z(ball(1, 64), two_to(-n));
    EXPECT_TRUE(overlaps(sin(z).im, cos(ball(1, 64)) * two_to(-n)));
    EXPECT_TRUE(overlaps(cos(z).im, -sin(ball(1, 64)) * two_to(-n)));
    EXPECT_TRUE(overlaps(tan(z).re, tan(ball(1, 64))));
    EXPECT_TRUE(sin(z).im.radius() <= magnitude::power_of_two(-n - 60));
  }
  const double_interval re(0.0001 * (1 - 1e-9), 0.0001 * (1 + 1e-9));
  const region x(re, double_interval(-1e-13, 1e-13));
  const region r = tan(exp(-1 / (x * x)));
  EXPECT_TRUE(r.is_analytic());
  EXPECT_TRUE(overlaps(r.to_complex_ball(), exp(-1 / (x * x)).to_complex_ball()));
}

TEST(Extreme, RootsBesideUnderflowAreNarrow) {
  // The radius is far below the least number.
  const long least = -(1L << 30);
  const ball x = ball::from_midpoint_radius(real::power_of_two(least + 10),
                                            magnitude::power_of_two(least - 60));
  for (const ball& y : {x, -x}) {
    const ball r = root(y, 3);
    EXPECT_TRUE(r.radius() <= scale(r.magnitude_upper(), -60)) << described(r);
    EXPECT_TRUE(overlaps(pow(r, 3), y));
    EXPECT_TRUE(root(y, 4).is_undefined() == certainly_negative(y));
    for (const ball& h : {hypot(y, ball(0, 64)), hypot(y, x)}) {
      EXPECT_TRUE(h.radius() <= scale(h.magnitude_upper(), -60)) << described(h);
    }
  }
  EXPECT_TRUE(overlaps(hypot(x, x), sqrt(ball(2, 64)) * x));
}

TEST(Extreme, PowersOfHalfLines) {
  // x^[y, inf] is as tight at y as x^y is, and at the other end a limit.
  const auto from = [](long n) {
    return ball::from_end_points(real(64, n), real::infinity(1), 64);
  };
  const ball r = pow(ball(10, 64), from(123456789));
  real low(64);
  r.lower(low);
  real expected(64);
  mpfr_ui_pow_ui(expected, 10, 123456789, MPFR_RNDD);
  EXPECT_NE(mpfr_equal_p(low, expected), 0);
  EXPECT_FALSE(r.is_bounded());
  const ball half = ball(1, 64) / 2L;
  EXPECT_EQ(support::exact(pow(half, from(3))), (support::exact_set{rational(0), rational(1, 8)}));
  EXPECT_EQ(support::exact(pow(from(2), half - 1L)).lower, rational(0));
  EXPECT_EQ(support::exact(pow(hull(half, ball(2, 64)), from(0))).lower, rational(0));
  EXPECT_FALSE(pow(hull(half, ball(2, 64)), from(0)).is_bounded());
  EXPECT_EQ(support::exact(pow(hull(half, ball(1, 64)), ball::entire(64))).lower, rational(0));
  EXPECT_TRUE(pow(hull(ball(0, 64), half), from(1)).is_undefined());
}

#ifdef POLHODE_HAVE_ARB

// ---------------------------------------------------------------------------------------------
// Random operands.

/// A set with some of its members, each exactly.
struct drawn {
  ball set;
  std::vector<real> members;
};
struct drawn_complex {
  complex_ball set;
  std::vector<std::pair<real, real>> members;
};

class extreme_source : public random_source {
 public:
  explicit extreme_source(std::uint64_t seed) : random_source(seed) {}

  precision small_precision() {
    return choose(std::array<precision, 9>{2, 24, 53, 64, 65, 128, 129, 200, 1400});
  }
  long exponent() {
    const long sign = one_in(2) ? 1 : -1;
    switch (between(0, 9)) {
      case 0:
        return sign * ((1L << between(7, 29)) + between(-3, 3));
      case 1:
        return sign * ((1L << 27) + between(-70, 70));
      case 2:
        return sign * (half_range + between(-70, 70));
      case 3:
        return sign > 0 ? mpfr_get_emax() - between(0, 3) : mpfr_get_emin() + between(0, 3);
      case 4:
        return between(26, 33);  // where e^x leaves the range
      default:
        return between(-40, 40);
    }
  }
  real number(precision p) {
    const long e = exponent();
    return any_real(p, e, e);
  }

  drawn any(precision p) {
    switch (between(0, 13)) {
      case 0:
        return point(real(p, between(-2, 2)));
      case 1:
      case 2:
      case 3:
        return point(number(p));
      case 4:
      case 5:
      case 6:
      case 7:
        return thin(number(p), p);
      case 8: {  // a radius far below everything, or above
        const real m = one_in(4) ? real(p, 0) : number(p);
        const long size = 1L << between(20, 58);
        return {ball::from_midpoint_radius(m, magnitude::power_of_two(one_in(4) ? size : -size)),
                {m}};
      }
      case 9:
        return between_two(real(p, 0), number(p), p);
      case 10: {
        const real end = one_in(3) ? real(p, between(-1, 1)) : number(p);
        return between_two(end, real::infinity(one_in(2) ? 1 : -1), p);
      }
      default:
        return between_two(number(p), number(p), p);
    }
  }
  drawn_complex any_complex(precision p) {
    const drawn re = one_in(8) ? point(real(p, 0)) : any(p);
    const drawn im = one_in(8) ? point(real(p, 0)) : any(p);
    drawn_complex r{complex_ball(re.set, im.set), {}};
    for (int i = 0; i < 2; ++i) r.members.emplace_back(choose(re.members), choose(im.members));
    return r;
  }

 private:
  static drawn point(const real& m) { return {ball(m.get()), {m}}; }
  drawn thin(const real& m, precision p) {
    const long gap = between(25, p + 60);
    const magnitude radius = any_magnitude(mpfr_get_exp(m) - gap - 31, mpfr_get_exp(m) - gap - 31);
    drawn r{ball::from_midpoint_radius(m, radius), {m}};
    if (radius.is_zero()) return r;
    real step(32);
    if (mpfr_set_ui_2exp(step, radius.fraction(), static_cast<mpfr_exp_t>(radius.exponent()),
                         MPFR_RNDN) != 0) {
      return r;
    }
    if (one_in(2)) mpfr_div_2ui(step, step, static_cast<unsigned long>(between(0, 5)), MPFR_RNDN);
    for (const int sign : {-1, 1}) {
      real member(p + gap + 80);
      mpfr_mul_si(step, step, sign, MPFR_RNDN);
      if (mpfr_add(member, m, step, MPFR_RNDN) == 0) r.members.push_back(member);
    }
    return r;
  }
  drawn between_two(const real& a, const real& b, precision p) {
    drawn r{between_ends(a, b, p), {}};
    if (mpfr_number_p(a) != 0) r.members.push_back(a);
    if (mpfr_number_p(b) != 0) r.members.push_back(b);
    real other = number(p);
    for (const int sign : {-1, 1}) {
      mpfr_setsign(other, other, sign < 0 ? 1 : 0, MPFR_RNDN);
      const bool above_a = mpfr_lessequal_p(a, other) != 0;
      const bool above_b = mpfr_lessequal_p(b, other) != 0;
      if (above_a != above_b) r.members.push_back(other);
    }
    return r;
  }
};

// ---------------------------------------------------------------------------------------------
// The oracle.

class arb {
 public:
  arb() { arb_init(value_); }
  explicit arb(mpfr_srcptr x) : arb() { arf_set_mpfr(arb_midref(value_), x); }
  arb(const arb&) = delete;
  arb& operator=(const arb&) = delete;
  ~arb() { arb_clear(value_); }
  arb_ptr get() { return value_; }

 private:
  arb_t value_;
};
class acb {
 public:
  acb() { acb_init(value_); }
  acb(mpfr_srcptr re, mpfr_srcptr im) : acb() {
    arf_set_mpfr(arb_midref(acb_realref(value_)), re);
    arf_set_mpfr(arb_midref(acb_imagref(value_)), im);
  }
  acb(const acb&) = delete;
  acb& operator=(const acb&) = delete;
  ~acb() { acb_clear(value_); }
  acb_ptr get() { return value_; }

 private:
  acb_t value_;
};

/// Whether the set is sure not to hold the number that Arb encloses in v. Any enclosure will do; a
/// narrow one tells more.
bool excludes(const ball& x, const arb_struct* v) {
  if (x.is_undefined() || arb_is_finite(v) == 0) return false;
  const precision bits = 2 * x.precision() + 300;
  real end(bits);
  x.lower(end);
  if (mpfr_number_p(end) != 0 && arb_lt(v, arb(end).get()) != 0) return true;
  x.upper(end);
  return mpfr_number_p(end) != 0 && arb_gt(v, arb(end).get()) != 0;
}

::testing::AssertionResult holds_value(const ball& x, const arb_struct* v) {
  if (!is_sound_number(x)) return is_sound_number(x);
  if (!excludes(x, v)) return ::testing::AssertionSuccess();
  char* text = arb_get_str(v, 20, 0);
  const std::string value = text;
  flint_free(text);
  return ::testing::AssertionFailure() << described(x) << " excludes " << value;
}

constexpr slong oracle_bits = 3200;

/// sin and its kin of numbers of this size take seconds, and are no affair of this test.
bool is_slow_to_reduce(mpfr_srcptr x) {
  return mpfr_regular_p(x) != 0 && mpfr_get_exp(x) > 200 && mpfr_get_exp(x) < (1L << 21) + 10000;
}
/// Beyond this Arb says nothing of e^x.
bool is_beyond_exp(mpfr_srcptr x) { return mpfr_regular_p(x) != 0 && mpfr_get_exp(x) > 36; }

enum class growth { none, exponential, circular };

/// The function of x, y and an integer, as a ball and by Arb.
struct operation {
  const char* name;
  ball (*f)(const ball& x, const ball& y, long n);
  void (*by_arb)(arb_ptr r, arb_srcptr x, arb_srcptr y, slong n, slong bits);
  growth grows = growth::none;
};

#define POLHODE_REAL(expression)                                      \
  [](const ball& x, const ball& y, long n) -> ball {                  \
    static_cast<void>(x), static_cast<void>(y), static_cast<void>(n); \
    return expression;                                                \
  }
#define POLHODE_ARB(...)                                                                       \
  [](arb_ptr r, arb_srcptr x, arb_srcptr y, slong n, slong bits) {                             \
    static_cast<void>(x), static_cast<void>(y), static_cast<void>(n), static_cast<void>(bits); \
    __VA_ARGS__;                                                                               \
  }
#define POLHODE_UNARY(f, grows) \
  { #f, POLHODE_REAL(f(x)), POLHODE_ARB(arb_##f(r, x, bits)), grows }

ball fused(const ball& x, const ball& y, long n) {
  ball r;
  fma(r, x, y, ball(n, 64));
  return r;
}

const std::vector<operation>& operations() {
  static const std::vector<operation> all = {
      {"+", POLHODE_REAL(x + y), POLHODE_ARB(arb_add(r, x, y, bits))},
      {"-", POLHODE_REAL(x - y), POLHODE_ARB(arb_sub(r, x, y, bits))},
      {"*", POLHODE_REAL(x * y), POLHODE_ARB(arb_mul(r, x, y, bits))},
      {"/", POLHODE_REAL(x / y), POLHODE_ARB(arb_div(r, x, y, bits))},
      {"fma", POLHODE_REAL(fused(x, y, n)),
       POLHODE_ARB(arb_mul(r, x, y, bits); arb_add_si(r, r, n, bits))},
      {"+ n", POLHODE_REAL(x + n), POLHODE_ARB(arb_add_si(r, x, n, bits))},
      {"n -", POLHODE_REAL(n - x), POLHODE_ARB(arb_sub_si(r, x, n, bits); arb_neg(r, r))},
      {"* n", POLHODE_REAL(x * n), POLHODE_ARB(arb_mul_si(r, x, n, bits))},
      {"/ n", POLHODE_REAL(x / n), POLHODE_ARB(arb_div_si(r, x, n, bits))},
      {"n /", POLHODE_REAL(n / x), POLHODE_ARB(arb_inv(r, x, bits); arb_mul_si(r, r, n, bits))},
      {"square", POLHODE_REAL(square(x)), POLHODE_ARB(arb_mul(r, x, x, bits))},
      {"scale", POLHODE_REAL(scale(x, n * (half_range / 4))),
       POLHODE_ARB(arb_mul_2exp_si(r, x, n * (half_range / 4)))},
      {"abs", POLHODE_REAL(abs(x)), POLHODE_ARB(arb_abs(r, x))},
      {"precision", POLHODE_REAL(x.with_precision(20)), POLHODE_ARB(arb_set(r, x))},
      {"enlarged", POLHODE_REAL(x.enlarged(magnitude::power_of_two(-n))),
       POLHODE_ARB(arb_set(r, x))},
      {"hull", POLHODE_REAL(hull(x, y)), POLHODE_ARB(arb_set(r, y))},
      {"min", POLHODE_REAL(min(x, y)), POLHODE_ARB(arb_min(r, x, y, bits))},
      {"max", POLHODE_REAL(max(x, y)), POLHODE_ARB(arb_max(r, x, y, bits))},
      {"hypot", POLHODE_REAL(hypot(x, y)), POLHODE_ARB(arb_hypot(r, x, y, bits))},
      {"pow n", POLHODE_REAL(pow(x, n)), POLHODE_ARB({
         fmpz_t e;
         fmpz_init_set_si(e, n);
         arb_pow_fmpz(r, x, e, bits);
         fmpz_clear(e);
       })},
      {"pow 2^29", POLHODE_REAL(pow(x, n * (half_range / 8) + 1)), POLHODE_ARB({
         fmpz_t e;
         fmpz_init_set_si(e, n * (half_range / 8) + 1);
         arb_pow_fmpz(r, x, e, bits);
         fmpz_clear(e);
       })},
      {"pow", POLHODE_REAL(pow(x, y)), POLHODE_ARB(arb_pow(r, x, y, bits)), growth::exponential},
      {"root", POLHODE_REAL(root(x, static_cast<unsigned long>(n < 0 ? -n : n))), POLHODE_ARB({
         if (arb_is_negative(x) != 0 && n % 2 != 0) {
           arb_neg(r, x);
           arb_root_ui(r, r, static_cast<ulong>(n < 0 ? -n : n), bits);
           arb_neg(r, r);
         } else {
           arb_root_ui(r, x, static_cast<ulong>(n < 0 ? -n : n), bits);
         }
       })},
      {"agm", POLHODE_REAL(agm(x, y)), POLHODE_ARB(arb_agm(r, x, y, bits))},
      {"atan2", POLHODE_REAL(atan2(y, x)), POLHODE_ARB(arb_atan2(r, y, x, bits))},
      POLHODE_UNARY(sqrt, growth::none),
      POLHODE_UNARY(rsqrt, growth::none),
      POLHODE_UNARY(exp, growth::exponential),
      POLHODE_UNARY(expm1, growth::exponential),
      POLHODE_UNARY(sinh, growth::exponential),
      POLHODE_UNARY(cosh, growth::exponential),
      POLHODE_UNARY(tanh, growth::exponential),
      {"exp2", POLHODE_REAL(exp2(x)),
       POLHODE_ARB(arb_const_log2(r, bits); arb_mul(r, r, x, bits); arb_exp(r, r, bits)),
       growth::exponential},
      {"exp10", POLHODE_REAL(exp10(x)),
       POLHODE_ARB(arb_const_log10(r, bits); arb_mul(r, r, x, bits); arb_exp(r, r, bits)),
       growth::exponential},
      {"log2", POLHODE_REAL(log2(x)), POLHODE_ARB({
         arb l;
         arb_const_log2(l.get(), bits);
         arb_log(r, x, bits);
         arb_div(r, r, l.get(), bits);
       })},
      {"log10", POLHODE_REAL(log10(x)), POLHODE_ARB({
         arb l;
         arb_const_log10(l.get(), bits);
         arb_log(r, x, bits);
         arb_div(r, r, l.get(), bits);
       })},
      POLHODE_UNARY(log, growth::none),
      POLHODE_UNARY(log1p, growth::none),
      POLHODE_UNARY(sin, growth::circular),
      POLHODE_UNARY(cos, growth::circular),
      POLHODE_UNARY(tan, growth::circular),
      {"sinpi", POLHODE_REAL(sinpi(x)), POLHODE_ARB(arb_sin_pi(r, x, bits)), growth::circular},
      {"cospi", POLHODE_REAL(cospi(x)), POLHODE_ARB(arb_cos_pi(r, x, bits)), growth::circular},
      POLHODE_UNARY(asin, growth::none),
      POLHODE_UNARY(acos, growth::none),
      POLHODE_UNARY(atan, growth::none),
      POLHODE_UNARY(asinh, growth::none),
      POLHODE_UNARY(acosh, growth::none),
      POLHODE_UNARY(atanh, growth::none),
      {"erf", POLHODE_REAL(erf(x)), POLHODE_ARB(arb_hypgeom_erf(r, x, bits)), growth::exponential},
  };
  return all;
}

bool can_be_judged(growth g, mpfr_srcptr x) {
  return g == growth::none || (g == growth::circular ? !is_slow_to_reduce(x) : !is_beyond_exp(x));
}

class ExtremeReal : public ::testing::TestWithParam<operation> {};

TEST_P(ExtremeReal, HoldsTheValueAtEveryMember) {
  const operation& op = GetParam();
  extreme_source random(7000 + std::string(op.name).size());
  for (repeat trial(400); trial.again();) {
    const drawn x = random.any(random.small_precision());
    const drawn y = random.one_in(8) ? x : random.any(random.small_precision());
    const long n = random.one_in(4) ? random.between(-3000, 3000) : random.between(-9, 9);
    if (op.grows == growth::circular) {
      bool slow = false;
      for (const real& m : x.members) slow = slow || is_slow_to_reduce(m);
      if (slow) continue;
    }
    SCOPED_TRACE(described(x.set) + ", " + described(y.set) + ", " + std::to_string(n));
    const ball value = op.f(x.set, y.set, n);
    EXPECT_TRUE(is_sound_number(value));
    if (value.is_undefined()) continue;
    EXPECT_TRUE(is_sound_number(value + 1L));
    EXPECT_TRUE(is_sound_number(value * value));
    for (const real& a : x.members) {
      const real& b = random.choose(y.members);
      if (!can_be_judged(op.grows, a) || !can_be_judged(op.grows, b)) continue;
      arb v;
      op.by_arb(v.get(), arb(a).get(), arb(b).get(), n, oracle_bits);
      EXPECT_TRUE(holds_value(value, v.get()))
          << support::described(ball(a.get())) << ", " << support::described(ball(b.get()));
    }
  }
}
std::string name_of(const std::string& text) {
  std::string r;
  for (const char c : text) {
    r += (std::isalnum(static_cast<unsigned char>(c)) != 0)
             ? std::string(1, c)
             : "_" + std::to_string(static_cast<int>(c));
  }
  return r;
}
INSTANTIATE_TEST_SUITE_P(Operations, ExtremeReal, ::testing::ValuesIn(operations()),
                         [](const auto& instance) { return name_of(instance.param.name); });

// ---------------------------------------------------------------------------------------------
// Complex balls, and regions kept in balls.

struct complex_operation {
  const char* name;
  complex_ball (*f)(const complex_ball& z, const complex_ball& w, long n);
  void (*by_arb)(acb_ptr r, acb_srcptr z, acb_srcptr w, slong n, slong bits);
  growth grows = growth::none;
  bool has_cut = false;  // on an axis
  region (*of_region)(const region& z, const region& w, long n) = nullptr;
};

#define POLHODE_COMPLEX(expression)                                          \
  [](const complex_ball& z, const complex_ball& w, long n) -> complex_ball { \
    static_cast<void>(z), static_cast<void>(w), static_cast<void>(n);        \
    return expression;                                                       \
  }
#define POLHODE_REGION(expression)                                    \
  [](const region& z, const region& w, long n) -> region {            \
    static_cast<void>(z), static_cast<void>(w), static_cast<void>(n); \
    return expression;                                                \
  }
#define POLHODE_ACB(...)                                                 \
  [](acb_ptr r, acb_srcptr z, acb_srcptr w, slong n, slong bits) {       \
    static_cast<void>(w), static_cast<void>(n), static_cast<void>(bits); \
    __VA_ARGS__;                                                         \
  }
#define POLHODE_COMPLEX_UNARY(f, g, cut) \
  { #f, POLHODE_COMPLEX(f(z)), POLHODE_ACB(acb_##f(r, z, bits)), g, cut, POLHODE_REGION(f(z)) }

const std::vector<complex_operation>& complex_operations() {
  static const std::vector<complex_operation> all = {
      {"+", POLHODE_COMPLEX(z + w), POLHODE_ACB(acb_add(r, z, w, bits)), growth::none, false,
       POLHODE_REGION(z + w)},
      {"-", POLHODE_COMPLEX(z - w), POLHODE_ACB(acb_sub(r, z, w, bits)), growth::none, false,
       POLHODE_REGION(z - w)},
      {"*", POLHODE_COMPLEX(z * w), POLHODE_ACB(acb_mul(r, z, w, bits)), growth::none, false,
       POLHODE_REGION(z * w)},
      {"/", POLHODE_COMPLEX(z / w), POLHODE_ACB(acb_div(r, z, w, bits)), growth::none, false,
       POLHODE_REGION(z / w)},
      {"reciprocal", POLHODE_COMPLEX(reciprocal(z)), POLHODE_ACB(acb_inv(r, z, bits)), growth::none,
       false, POLHODE_REGION(1 / z)},
      {"square", POLHODE_COMPLEX(square(z)), POLHODE_ACB(acb_mul(r, z, z, bits)), growth::none,
       false, POLHODE_REGION(square(z))},
      {"n /", POLHODE_COMPLEX(n / z), POLHODE_ACB(acb_inv(r, z, bits); acb_mul_si(r, r, n, bits)),
       growth::none, false, POLHODE_REGION(n / z)},
      {"pow n", POLHODE_COMPLEX(pow(z, n)), POLHODE_ACB(acb_pow_si(r, z, n, bits)), growth::none,
       false, POLHODE_REGION(pow(z, n))},
      {"pow 2^29", POLHODE_COMPLEX(pow(z, n * (half_range / 64) + 1)),
       POLHODE_ACB(acb_pow_si(r, z, n * (half_range / 64) + 1, bits)), growth::none, false,
       POLHODE_REGION(pow(z, n * (half_range / 64) + 1))},
      {"pow", POLHODE_COMPLEX(pow(z, w)), POLHODE_ACB(acb_pow(r, z, w, bits)), growth::exponential,
       true, nullptr},
      {"agm 1", POLHODE_COMPLEX(agm(z)), POLHODE_ACB(acb_agm1(r, z, bits)), growth::none, true},
      {"abs", POLHODE_COMPLEX(complex_ball(abs(z))),
       POLHODE_ACB(acb_abs(acb_realref(r), z, bits); arb_zero(acb_imagref(r)))},
      {"arg", POLHODE_COMPLEX(complex_ball(arg(z))),
       POLHODE_ACB(acb_arg(acb_realref(r), z, bits); arb_zero(acb_imagref(r))), growth::none, true},
      {"slope of 1/z", POLHODE_COMPLEX((1 / jet<complex_ball, 2>::variable(z))[1]),
       POLHODE_ACB(acb_pow_si(r, z, -2, bits); acb_neg(r, r))},
      {"curvature of 1/z", POLHODE_COMPLEX((1 / jet<complex_ball, 2>::variable(z))[2]),
       POLHODE_ACB(acb_pow_si(r, z, -3, bits))},
      {"slope of sqrt", POLHODE_COMPLEX(sqrt(jet<complex_ball, 2>::variable(z))[1]),
       POLHODE_ACB(acb_rsqrt(r, z, bits); acb_mul_2exp_si(r, r, -1)), growth::none, true},
      POLHODE_COMPLEX_UNARY(sqrt, growth::none, true),
      POLHODE_COMPLEX_UNARY(log, growth::none, true),
      POLHODE_COMPLEX_UNARY(exp, growth::exponential, false),
      POLHODE_COMPLEX_UNARY(sin, growth::exponential, false),
      POLHODE_COMPLEX_UNARY(cos, growth::exponential, false),
      POLHODE_COMPLEX_UNARY(tan, growth::exponential, false),
      POLHODE_COMPLEX_UNARY(sinh, growth::exponential, false),
      POLHODE_COMPLEX_UNARY(cosh, growth::exponential, false),
      POLHODE_COMPLEX_UNARY(tanh, growth::exponential, false),
      POLHODE_COMPLEX_UNARY(asin, growth::none, true),
      POLHODE_COMPLEX_UNARY(acos, growth::none, true),
      POLHODE_COMPLEX_UNARY(atan, growth::none, true),
      POLHODE_COMPLEX_UNARY(asinh, growth::none, true),
      POLHODE_COMPLEX_UNARY(acosh, growth::none, true),
      POLHODE_COMPLEX_UNARY(atanh, growth::none, true),
  };
  return all;
}

class ExtremeComplex : public ::testing::TestWithParam<complex_operation> {};

/// Operands that this function can be asked about in a reasonable time.
bool is_within_reach(const complex_operation& op, const drawn_complex& z) {
  if (op.grows == growth::none) return true;
  for (const auto& [re, im] : z.members) {
    if (is_slow_to_reduce(re) || is_slow_to_reduce(im) || is_beyond_exp(re) || is_beyond_exp(im)) {
      return false;
    }
  }
  return true;
}

void expect_value(const complex_ball& value, const acb_struct* v) {
  if (acb_is_finite(v) == 0) return;
  EXPECT_TRUE(holds_value(value.re, acb_realref(v))) << "the real part";
  EXPECT_TRUE(holds_value(value.im, acb_imagref(v))) << "the imaginary part";
}

TEST_P(ExtremeComplex, HoldsTheValueAtEveryMember) {
  const complex_operation& op = GetParam();
  extreme_source random(7100 + std::string(op.name).size());
  for (repeat trial(300); trial.again();) {
    const drawn_complex z = random.any_complex(random.small_precision());
    const drawn_complex w = random.one_in(8) ? z : random.any_complex(random.small_precision());
    const long n = random.one_in(4) ? random.between(-3000, 3000) : random.between(-9, 9);
    if (!is_within_reach(op, z) || !is_within_reach(op, w)) continue;
    SCOPED_TRACE(described(z.set) + ", " + described(w.set) + ", " + std::to_string(n));
    const complex_ball value = op.f(z.set, w.set, n);
    EXPECT_TRUE(is_sound_number(value));
    std::vector<complex_ball> of_regions;
    std::vector<region> regions;
    if (op.of_region != nullptr && !z.set.is_undefined() && !w.set.is_undefined()) {
      regions.push_back(op.of_region(region::in_balls(z.set), region::in_balls(w.set), n));
      regions.push_back(op.of_region(region(z.set), region(w.set), n));
    }
    for (std::size_t i = 0; i < z.members.size(); ++i) {
      const auto& [x, y] = z.members[i];
      const auto& [s, t] = random.choose(w.members);
      if (op.has_cut && (mpfr_zero_p(x) != 0 || mpfr_zero_p(y) != 0)) continue;
      acb v;
      op.by_arb(v.get(), acb(x, y).get(), acb(s, t).get(), n, oracle_bits);
      SCOPED_TRACE(support::described(ball(x.get())) + " + i " + support::described(ball(y.get())));
      if (!value.is_undefined()) expect_value(value, v.get());
      for (const region& r : regions) {
        if (!r.is_analytic()) continue;
        SCOPED_TRACE("as a region");
        expect_value(r.to_complex_ball(), v.get());
        if (acb_is_finite(v.get()) == 0) continue;
        arb size;
        acb_abs(size.get(), v.get(), oracle_bits);
        const auto bounded = [&](const magnitude& m, bool above) {
          if (m.is_infinite() || m.is_zero()) {
            return above ? m.is_infinite() || arb_is_positive(size.get()) == 0 : m.is_zero();
          }
          arb bound;
          arf_set_ui(arb_midref(bound.get()), m.fraction());
          arb_mul_2exp_si(bound.get(), bound.get(), m.exponent());
          return above ? arb_gt(size.get(), bound.get()) == 0
                       : arb_lt(size.get(), bound.get()) == 0;
        };
        EXPECT_TRUE(bounded(r.magnitude_upper(), true)) << "the upper bound of the modulus";
        EXPECT_TRUE(bounded(r.magnitude_lower(), false)) << "the lower bound of the modulus";
      }
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Operations, ExtremeComplex, ::testing::ValuesIn(complex_operations()),
                         [](const auto& instance) { return name_of(instance.param.name); });

#endif  // POLHODE_HAVE_ARB

}  // namespace extreme_test
}  // namespace polhode
