// Complex balls: the inclusion principle against an oracle that shares no formula with the code
// (Arb, and real MPFR functions on the cuts) and, without oracles, through identities whose
// members are exact; tightness, monotonicity of inclusion, sides of the cuts, and analyticity
// decided by exact geometry.

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"
#include "support/real.hpp"

#ifdef POLHODE_HAVE_ARB
#include <acb.h>
#endif

namespace polhode {
namespace complex_ball_test {

using support::exact;
using support::exact_real;
using support::exact_set;
using support::kind;
using support::power_of_two;
using support::random_source;
using support::real;
using support::repeat;

/// An exact complex number.
struct point {
  rational re;
  rational im;
};

std::string described(const complex_ball& z) {
  return support::described(z.re) + " + i " + support::described(z.im);
}
std::string described(const point& z) {
  return support::described(z.re) + " + i " + support::described(z.im);
}

/// The dyadic number q as a ball, exactly, with at least p bits.
ball known_number(const rational& q, precision p) {
  return ball(exact_real(q).get()).with_precision(std::max(p, mpfr_get_prec(exact_real(q).get())));
}
complex_ball known_number(const point& z, precision p) {
  return {known_number(z.re, p), known_number(z.im, p)};
}

::testing::AssertionResult holds(const complex_ball& z, const point& w) {
  if (z.is_undefined()) return ::testing::AssertionFailure() << "the ball is undefined";
  if (contains(z, w.re, w.im)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << described(w) << " is not in " << described(z);
}

/// small lies in large, both being enclosures of the same number and small the far narrower one:
/// its radius is allowed for.
::testing::AssertionResult agrees(const complex_ball& large, const complex_ball& small) {
  if (large.is_undefined() || small.is_undefined()) {
    return ::testing::AssertionFailure() << "undefined";
  }
  const auto in = [](const ball& x, const ball& y) {
    exact_set outer = exact(x);
    const exact_set inner = exact(y);
    if (outer.lower) outer.lower = *outer.lower - inner.width();
    if (outer.upper) outer.upper = *outer.upper + inner.width();
    return outer.holds(inner);
  };
  if (in(large.re, small.re) && in(large.im, small.im)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << described(small) << " is not in " << described(large);
}

using complex_function = complex_ball (*)(const complex_ball&);

enum class cut { none, negative, beyond_one, below_one, beyond_i, poles };

struct entry {
  const char* name;
  complex_function f;
  complex_function derivative;
  cut where;
  bool grows;     // like exp: for operands of moderate size only
  bool is_range;  // each part of the result is its range, to rounding
  bool (*possibly_singular)(const rectangle<ball>&);
#ifdef POLHODE_HAVE_ARB
  void (*by_arb)(acb_t, const acb_t, slong);
#endif
};

#ifdef POLHODE_HAVE_ARB
#define POLHODE_ARB(f) , acb_##f
void acb_unchanged(acb_t r, const acb_t z, slong) { acb_set(r, z); }
#else
#define POLHODE_ARB(f)
#endif
#define POLHODE_OF(expression) [](const complex_ball& z) -> complex_ball { return expression; }
#define POLHODE_ENTIRE [](const rectangle<ball>& z) { return is_undefined(z); }
#define POLHODE_SINGULAR(f) [](const rectangle<ball>& z) { return possibly_singular::f(z); }

const std::vector<entry>& functions() {
  static const std::vector<entry> all = {
      {"sqrt", POLHODE_OF(sqrt(z)), POLHODE_OF(1 / (2 * sqrt(z))), cut::negative, false, true,
       POLHODE_SINGULAR(sqrt) POLHODE_ARB(sqrt)},
      {"log", POLHODE_OF(log(z)), POLHODE_OF(1 / z), cut::negative, false, true,
       POLHODE_SINGULAR(log) POLHODE_ARB(log)},
      {"reciprocal", POLHODE_OF(reciprocal(z)), POLHODE_OF(-1 / (z * z)), cut::none, false, true,
       POLHODE_SINGULAR(reciprocal) POLHODE_ARB(inv)},
      {"square", POLHODE_OF(square(z)), POLHODE_OF(2 * z), cut::none, false, true,
       POLHODE_ENTIRE POLHODE_ARB(sqr)},
      {"exp", POLHODE_OF(exp(z)), POLHODE_OF(exp(z)), cut::none, true, true,
       POLHODE_ENTIRE POLHODE_ARB(exp)},
      {"sin", POLHODE_OF(sin(z)), POLHODE_OF(cos(z)), cut::none, true, true,
       POLHODE_ENTIRE POLHODE_ARB(sin)},
      {"cos", POLHODE_OF(cos(z)), POLHODE_OF(-sin(z)), cut::none, true, true,
       POLHODE_ENTIRE POLHODE_ARB(cos)},
      {"tan", POLHODE_OF(tan(z)), POLHODE_OF(1 / square(cos(z))), cut::poles, true, true,
       POLHODE_SINGULAR(tan) POLHODE_ARB(tan)},
      {"sinh", POLHODE_OF(sinh(z)), POLHODE_OF(cosh(z)), cut::none, true, true,
       POLHODE_ENTIRE POLHODE_ARB(sinh)},
      {"cosh", POLHODE_OF(cosh(z)), POLHODE_OF(sinh(z)), cut::none, true, true,
       POLHODE_ENTIRE POLHODE_ARB(cosh)},
      {"tanh", POLHODE_OF(tanh(z)), POLHODE_OF(1 / square(cosh(z))), cut::poles, true, true,
       POLHODE_SINGULAR(tanh) POLHODE_ARB(tanh)},
      {"asin", POLHODE_OF(asin(z)), POLHODE_OF(1 / sqrt((1 - z) * (1 + z))), cut::beyond_one, false,
       true, POLHODE_SINGULAR(asin) POLHODE_ARB(asin)},
      {"acos", POLHODE_OF(acos(z)), POLHODE_OF(-1 / sqrt((1 - z) * (1 + z))), cut::beyond_one,
       false, true, POLHODE_SINGULAR(acos) POLHODE_ARB(acos)},
      {"acosh", POLHODE_OF(acosh(z)), POLHODE_OF(1 / sqrt(z - 1) / sqrt(z + 1)), cut::below_one,
       false, true, POLHODE_SINGULAR(acosh) POLHODE_ARB(acosh)},
      {"atanh", POLHODE_OF(atanh(z)), POLHODE_OF(1 / ((1 - z) * (1 + z))), cut::beyond_one, false,
       true, POLHODE_SINGULAR(atanh) POLHODE_ARB(atanh)},
      {"atan", POLHODE_OF(atan(z)), POLHODE_OF(1 / (1 + z * z)), cut::beyond_i, false, true,
       POLHODE_SINGULAR(atan) POLHODE_ARB(atan)},
      {"asinh", POLHODE_OF(asinh(z)), POLHODE_OF(1 / sqrt(1 + z * z)), cut::beyond_i, false, true,
       POLHODE_SINGULAR(asinh) POLHODE_ARB(asinh)},
      {"identity", POLHODE_OF(+z), POLHODE_OF(complex_ball(1, z.precision())), cut::none, false,
       true, POLHODE_ENTIRE POLHODE_ARB(unchanged)},
  };
  return all;
}

/// The number lies on the function's cut, its ends included.
bool is_on_cut(cut where, const point& z) {
  switch (where) {
    case cut::negative:
      return z.im == 0 && z.re <= 0;
    case cut::beyond_one:
      return z.im == 0 && abs(z.re) >= 1;
    case cut::below_one:
      return z.im == 0 && z.re <= 1;
    case cut::beyond_i:
      return z.re == 0 && abs(z.im) >= 1;
    case cut::none:
    case cut::poles:
      break;
  }
  return false;
}
/// A set of a kind that touches what matters: rectangles near the axes, the cuts and the special
/// points.
class complex_source : public random_source {
 public:
  explicit complex_source(std::uint64_t seed) : random_source(seed) {}

  ball small_part(precision p) {
    static constexpr std::array kinds = {kind::exact,       kind::thin,          kind::thin,
                                         kind::narrow,      kind::wide,          kind::wide,
                                         kind::across_zero, kind::touching_zero, kind::special,
                                         kind::special,     kind::half_turns};
    return any_ball(p, choose(kinds));
  }
  complex_ball any_complex(precision p) {
    switch (between(0, 9)) {
      case 0: {
        const ball x = any_ball(p, one_in(2) ? kind::huge : kind::tiny);
        return one_in(2) ? complex_ball(x, small_part(p)) : complex_ball(small_part(p), x);
      }
      case 1:
        return {small_part(p), ball(0, p)};
      case 2:
        return {ball(0, p), small_part(p)};
      case 3: {  // at a distance of a power of two from a special point
        const long n = -between(1, 3 * static_cast<long>(p));
        const complex_ball offset = scale(complex_ball(small_part(p), small_part(p)), n);
        const precision q = 4 * p + 100;
        const std::array<complex_ball, 5> centres = {complex_ball(0, p), complex_ball(1, p),
                                                     complex_ball(-1, p), complex_ball(0, 1, p),
                                                     complex_ball(0, -1, p)};
        const complex_ball z = choose(centres) + offset.with_precision(q);
        return one_in(2) ? z : z.with_precision(p);
      }
      case 4:
        return {any_ball(p), any_ball(p)};  // also unbounded
      default:
        return {small_part(p), small_part(p)};
    }
  }
  /// Small enough for exp.
  complex_ball moderate(precision p) {
    while (true) {
      const complex_ball z = any_complex(p);
      const magnitude size = z.magnitude_upper();
      if (!size.is_infinite() && size < magnitude::power_of_two(9)) return z;
    }
  }
  point member_of(const complex_ball& z) { return {member(z.re), member(z.im)}; }
  complex_ball inside_of(const complex_ball& z) { return {inside(z.re), inside(z.im)}; }
};

/// f on its cut, by real functions: the limit from above, or from the right.
complex_ball value_on_cut(const std::string& name, const point& z, precision p) {
  const ball zero(0, p);
  const ball half_pi = scale(pi(p), -1);
  const ball x = known_number(z.re, p);
  const ball y = known_number(z.im, p);
  const bool left = z.re < 0;
  if (name == "sqrt") return {zero, sqrt(-x)};
  if (name == "log") return {log(-x), pi(p)};
  if (name == "asin") return {left ? -half_pi : half_pi, acosh(abs(x))};
  if (name == "acos") return {left ? pi(p) : zero, -acosh(abs(x))};
  if (name == "acosh") {
    return abs(z.re) <= 1 ? complex_ball(zero, acos(x)) : complex_ball(acosh(-x), pi(p));
  }
  if (name == "atanh") return {atanh(1 / x), half_pi};
  if (name == "atan") return {half_pi, atanh(1 / y)};
  const ball size = acosh(abs(y));
  return {size, z.im < 0 ? -half_pi : half_pi};  // asinh
}

#ifdef POLHODE_HAVE_ARB
class arb_complex {
 public:
  arb_complex() { acb_init(value_); }
  explicit arb_complex(const point& z) : arb_complex() {
    arf_set_mpfr(arb_midref(acb_realref(value_)), exact_real(z.re));
    arf_set_mpfr(arb_midref(acb_imagref(value_)), exact_real(z.im));
  }
  arb_complex(const arb_complex&) = delete;
  arb_complex& operator=(const arb_complex&) = delete;
  ~arb_complex() { acb_clear(value_); }
  acb_ptr get() { return value_; }
  [[nodiscard]] complex_ball as_ball(precision p) const {
    return {part(acb_realref(value_), p), part(acb_imagref(value_), p)};
  }

 private:
  static ball part(const arb_struct* x, precision p) {
    real low(p);
    real high(p);
    arf_t end;
    arf_init(end);
    arb_get_lbound_arf(end, x, p);
    arf_get_mpfr(low, end, MPFR_RNDD);
    arb_get_ubound_arf(end, x, p);
    arf_get_mpfr(high, end, MPFR_RNDU);
    arf_clear(end);
    if (!low.is_finite() || !high.is_finite()) return ball::entire(p);
    return ball::from_end_points(low, high, p);
  }
  acb_t value_;
};

/// The function has no value there.
bool is_pole(const entry& e, const point& z) {
  const std::string name = e.name;
  if (name == "log" || name == "reciprocal") return z.re == 0 && z.im == 0;
  if (name == "atanh") return z.im == 0 && abs(z.re) == 1;
  if (name == "atan") return z.re == 0 && abs(z.im) == 1;
  return false;
}

/// An enclosure by Arb of which each part is known to `bits` bits, or at all events to 2^-bits of
/// the whole; unbounded where that is not reached.
template <class F>
complex_ball by_arb(precision bits, F&& f) {
  for (precision p = 2 * bits + 128; p < 20000; p *= 2) {
    arb_complex r;
    f(r.get(), static_cast<slong>(p));
    complex_ball value = r.as_ball(p);
    const auto known = [&](const ball& x) {
      return x.is_exact() ||
             (x.is_bounded() &&
              x.radius() <= scale(max(x.magnitude_lower(),
                                      scale(value.magnitude_lower(), -4 * std::int64_t{bits})),
                                  -std::int64_t{bits}));
    };
    if (known(value.re) && known(value.im)) return value;
  }
  return {ball::entire(64), ball::entire(64)};
}

class ComplexOracle : public ::testing::TestWithParam<entry> {};

TEST_P(ComplexOracle, HoldsTheValueAtEveryMember) {
  const entry& e = GetParam();
  complex_source random(2000 + std::string(e.name).size());
  long judged = 0;
  long trials = 0;
  for (repeat trial(700); trial.again();) {
    const precision p = random.any_precision();
    const complex_ball z = e.grows ? random.moderate(p) : random.any_complex(p);
    SCOPED_TRACE(described(z));
    const complex_ball value = e.f(z);
    EXPECT_EQ(value.re.precision(), z.precision());
    EXPECT_EQ(value.im.precision(), z.precision());
    if (value.is_undefined()) continue;
    for (int i = 0; i < 3; ++i) {
      const point w = random.member_of(z);
      SCOPED_TRACE(described(w));
      ASSERT_FALSE(is_pole(e, w));
      ++trials;
      const bool on_cut = is_on_cut(e.where, w);
      if (on_cut) {
        EXPECT_TRUE(agrees(value, value_on_cut(e.name, w, z.precision() + 400)));
        ++judged;
        continue;
      }
      arb_complex operand(w);
      const complex_ball truth =
          by_arb(p + 64, [&](acb_ptr r, slong bits) { e.by_arb(r, operand.get(), bits); });
      if (!truth.is_bounded()) continue;
      ++judged;
      EXPECT_TRUE(agrees(value, truth));
    }
  }
  EXPECT_GT(judged, trials * 9 / 10);
}
INSTANTIATE_TEST_SUITE_P(Functions, ComplexOracle, ::testing::ValuesIn(functions()),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(ComplexOracle, Powers) {
  complex_source random(2100);
  for (repeat trial(700); trial.again();) {
    const precision p = random.any_precision();
    const complex_ball z = random.moderate(p);
    const complex_ball w = random.moderate(p);
    const long n = random.between(-20, 20);
    SCOPED_TRACE(described(z) + " to the " + described(w) + " or " + std::to_string(n));
    const complex_ball whole = pow(z, n);
    const complex_ball general = pow(z, w);
    for (int i = 0; i < 2; ++i) {
      const point s = random.member_of(z);
      const point t = random.member_of(w);
      SCOPED_TRACE(described(s) + " to the " + described(t));
      arb_complex base(s);
      arb_complex exponent(t);
      if (!whole.is_undefined()) {
        const complex_ball truth =
            by_arb(p + 64, [&](acb_ptr r, slong bits) { acb_pow_si(r, base.get(), n, bits); });
        if (truth.is_bounded()) {
          EXPECT_TRUE(agrees(whole, truth));
        }
      }
      if (!general.is_undefined() && !(s.re == 0 && s.im == 0)) {
        const complex_ball truth = by_arb(
            p + 64, [&](acb_ptr r, slong bits) { acb_pow(r, base.get(), exponent.get(), bits); });
        if (truth.is_bounded()) {
          EXPECT_TRUE(agrees(general, truth));
        }
      }
    }
  }
}

TEST(ComplexOracle, ProductsAndQuotients) {
  complex_source random(2101);
  for (repeat trial(2000); trial.again();) {
    const precision p = random.any_precision();
    const complex_ball z = random.any_complex(p);
    const complex_ball w = random.any_complex(random.one_in(3) ? random.any_precision() : p);
    SCOPED_TRACE(described(z) + " and " + described(w));
    const point s = random.member_of(z);
    const point t = random.member_of(w);
    SCOPED_TRACE(described(s) + " and " + described(t));
    EXPECT_TRUE(holds(z + w, {s.re + t.re, s.im + t.im}));
    EXPECT_TRUE(holds(z - w, {s.re - t.re, s.im - t.im}));
    EXPECT_TRUE(holds(z * w, {s.re * t.re - s.im * t.im, s.re * t.im + s.im * t.re}));
    EXPECT_TRUE(holds(square(z), {s.re * s.re - s.im * s.im, 2 * s.re * s.im}));
    const complex_ball quotient = z / w;
    EXPECT_EQ(quotient.precision(), std::max(z.precision(), w.precision()));
    EXPECT_EQ(quotient.is_undefined(), contains_zero(w));
    const rational norm = t.re * t.re + t.im * t.im;
    if (norm == 0) continue;
    const point q{(s.re * t.re + s.im * t.im) / norm, (s.im * t.re - s.re * t.im) / norm};
    if (!quotient.is_undefined()) {
      EXPECT_TRUE(holds(quotient, q));
    }
    // Mixed with a ball, an integer, a rational.
    const rational n = random.any_rational(60);
    EXPECT_TRUE(holds(z + w.re, {s.re + t.re, s.im}));
    EXPECT_TRUE(holds(w.re - z, {t.re - s.re, -s.im}));
    EXPECT_TRUE(holds(z * w.re, {s.re * t.re, s.im * t.re}));
    EXPECT_TRUE(holds(z * n, {s.re * n, s.im * n}));
    EXPECT_TRUE(holds(n - z, {n - s.re, -s.im}));
    EXPECT_TRUE(holds(z / 3, {s.re / 3, s.im / 3}));
    EXPECT_TRUE(holds(5 + z, {s.re + 5, s.im}));
    if (!contains_zero(w)) {
      EXPECT_TRUE(holds(n / w, {n * t.re / norm, -n * t.im / norm}));
    }
  }
}

TEST(ComplexOracle, ArithmeticGeometricMean) {
  complex_source random(2102);
  for (repeat trial(500); trial.again();) {
    const precision p = random.any_precision();
    const complex_ball z = random.moderate(p);
    SCOPED_TRACE(described(z));
    const complex_ball mean = agm(z);
    for (int i = 0; i < 2; ++i) {
      const point w = random.member_of(z);
      if (w.im == 0 && w.re < 0) continue;
      SCOPED_TRACE(described(w));
      arb_complex operand(w);
      const complex_ball truth =
          by_arb(p + 64, [&](acb_ptr r, slong bits) { acb_agm1(r, operand.get(), bits); });
      if (truth.is_bounded()) {
        EXPECT_TRUE(agrees(mean, truth));
      }
    }
  }
}
#endif  // POLHODE_HAVE_ARB

// ---------------------------------------------------------------------------------------------
// Identities. An exact member of z must be in what the identity gives back.

TEST(ComplexIdentities, InversesGiveTheMemberBack) {
  complex_source random(2200);
  for (repeat trial(1200); trial.again();) {
    const precision p = random.any_precision();
    const complex_ball z = random.moderate(p);
    const point w = random.member_of(z);
    SCOPED_TRACE(described(z) + ", member " + described(w));
    const auto given_back = [&](const complex_ball& r) { return r.is_undefined() || holds(r, w); };
    EXPECT_TRUE(given_back(square(sqrt(z))));
    EXPECT_TRUE(given_back(exp(log(z))));
    EXPECT_TRUE(given_back(sin(asin(z))));
    EXPECT_TRUE(given_back(cos(acos(z))));
    EXPECT_TRUE(given_back(tan(atan(z))));
    EXPECT_TRUE(given_back(sinh(asinh(z))));
    EXPECT_TRUE(given_back(cosh(acosh(z))));
    EXPECT_TRUE(given_back(tanh(atanh(z))));
    EXPECT_TRUE(given_back(reciprocal(reciprocal(z))));
    EXPECT_TRUE(given_back(pow(sqrt(z), 2)));
    EXPECT_TRUE(given_back(times_i(times_i(-z))));
    const ball modulus = abs(z);
    EXPECT_TRUE(contains(square(modulus), w.re * w.re + w.im * w.im));
  }
}

TEST(ComplexIdentities, BetweenFunctions) {
  complex_source random(2201);
  for (repeat trial(1000); trial.again();) {
    const precision p = random.any_precision();
    const complex_ball z = random.moderate(p);
    SCOPED_TRACE(described(z));
    const auto one = [&](const complex_ball& r) {
      return r.is_undefined() || contains(r, rational(1), rational(0));
    };
    const auto both = [&](const complex_ball& r, const complex_ball& s) {
      return r.is_undefined() || s.is_undefined() || overlaps(r, s);
    };
    EXPECT_TRUE(one(square(sin(z)) + square(cos(z))));
    EXPECT_TRUE(one(square(cosh(z)) - square(sinh(z))));
    EXPECT_TRUE(one(exp(z) * exp(-z)));
    EXPECT_TRUE(one(z / z));
    EXPECT_TRUE(both(exp(times_i(z)), cos(z) + times_i(sin(z))));
    EXPECT_TRUE(both(tan(z), sin(z) / cos(z)));
    EXPECT_TRUE(both(asin(z) + acos(z), complex_ball(scale(pi(p), -1))));
    EXPECT_TRUE(both(pow(z, 3), z * z * z));
    EXPECT_TRUE(both(pow(z, -2), 1 / square(z)));
    EXPECT_TRUE(both(pow(z, complex_ball(5, p)), pow(z, 5)));
    const complex_ball w = random.moderate(p);
    EXPECT_TRUE(both(pow(z, w), exp(w * log(z))));
    EXPECT_TRUE(both((z * w) / w, z));
    // Mirror images, off the cuts.
    for (const entry& e : functions()) {
      if (e.possibly_singular(z)) continue;
      const complex_ball mirrored = e.f(conj(z));
      EXPECT_TRUE(both(mirrored, conj(e.f(z)))) << e.name;
    }
  }
}

// ---------------------------------------------------------------------------------------------
// Values at special points and on both sides of the cuts.

/// [low, high] + i [bottom, top], with doubles that are meant.
complex_ball box(double low, double high, double bottom, double top, precision p = 100) {
  const auto part = [&](double a, double b) {
    return hull(ball::exactly(a, p), ball::exactly(b, p));
  };
  return {part(low, high), part(bottom, top)};
}

TEST(ComplexValues, ExactOnesStayExact) {
  const precision p = 100;
  const auto is = [&](const complex_ball& z, long x, long y) {
    return z.is_exact() && contains(z.re, x) && contains(z.im, y);
  };
  EXPECT_TRUE(is(sqrt(complex_ball(-4, p)), 0, 2));
  EXPECT_TRUE(is(sqrt(complex_ball(0, 2, p)), 1, 1));
  EXPECT_TRUE(is(sqrt(complex_ball(0, -2, p)), 1, -1));
  EXPECT_TRUE(is(sqrt(complex_ball(-5, 12, p)), 2, 3));
  EXPECT_TRUE(is(sqrt(complex_ball(-5, -12, p)), 2, -3));
  EXPECT_TRUE(is(sqrt(complex_ball(0, p)), 0, 0));
  EXPECT_TRUE(is(log(complex_ball(1, p)), 0, 0));
  EXPECT_TRUE(is(exp(complex_ball(0, p)), 1, 0));
  EXPECT_TRUE(is(pow(complex_ball(1, 1, p), 8), 16, 0));
  EXPECT_TRUE(is(pow(complex_ball(1, 1, p), 0), 1, 0));
  EXPECT_TRUE(is(complex_ball(6, 8, p) / complex_ball(3, 4, p), 2, 0));
  EXPECT_TRUE(is(1 / complex_ball(0, 1, p), 0, -1));
  EXPECT_TRUE(is(complex_ball::i(p) * complex_ball::i(p), -1, 0));
  EXPECT_TRUE(is(asin(complex_ball(0, p)), 0, 0));
  EXPECT_TRUE(is(acos(complex_ball(1, p)), 0, 0));
  EXPECT_TRUE(is(acosh(complex_ball(1, p)), 0, 0));
  EXPECT_TRUE(is(agm(complex_ball(0, p)), 0, 0));
  EXPECT_TRUE(is(agm(complex_ball(-1, p)), 0, 0));
  EXPECT_TRUE(is(agm(complex_ball(1, p)), 1, 0));
  EXPECT_TRUE(is(pow(complex_ball(0, p), complex_ball(1, 3, p)), 0, 0));
}

TEST(ComplexValues, UndefinedAtPolesAndWhatIsUndefinedSpreads) {
  const precision p = 100;
  EXPECT_TRUE(log(box(-1, 1, -1, 1)).is_undefined());
  EXPECT_TRUE(log(complex_ball(0, p)).is_undefined());
  EXPECT_TRUE(arg(box(-1, 0, 0, 1)).is_undefined());
  EXPECT_TRUE(reciprocal(box(0, 1, -1, 0)).is_undefined());
  EXPECT_TRUE((complex_ball(1, p) / box(-1, 1, 0, 0)).is_undefined());
  EXPECT_TRUE(atanh(box(0, 1, 0, 1)).is_undefined());
  EXPECT_TRUE(atanh(box(-2, -0.5, -1, 1)).is_undefined());
  EXPECT_TRUE(atanh(box(-1, 0, 0, 0.5)).is_undefined());
  EXPECT_TRUE(atanh(complex_ball(-1, p)).is_undefined());
  EXPECT_TRUE(atan(box(-1, 1, -2, -0.5)).is_undefined());
  EXPECT_TRUE(atan(box(-1, 1, 0.5, 2)).is_undefined());
  EXPECT_TRUE(tan(box(1, 2, -1, 1)).is_undefined());
  EXPECT_FALSE(tan(box(1, 2, 0.125, 1)).is_undefined());
  EXPECT_TRUE(tanh(box(0, 0, 1, 2)).is_undefined());
  EXPECT_TRUE(pow(box(-1, 1, -1, 1), -1).is_undefined());
  EXPECT_TRUE(pow(box(-1, 1, -1, 1), box(0.5, 0.5, 0, 0)).is_undefined());
  const complex_ball half(ball(1, p), ball::undefined(p));
  EXPECT_TRUE(half.is_undefined());
  EXPECT_TRUE(half.re.is_undefined());
  for (const entry& e : functions()) {
    EXPECT_TRUE(e.f(complex_ball::undefined(p)).is_undefined()) << e.name;
    EXPECT_TRUE(e.possibly_singular(complex_ball::undefined(p))) << e.name;
  }
  EXPECT_TRUE(agm(complex_ball::undefined(p)).is_undefined());
  EXPECT_TRUE((complex_ball::undefined(p) * complex_ball(0, p)).is_undefined());
}

/// f(0 + offset) for each side, compared with the value on the cut.
TEST(ComplexValues, OnTheCutsTheSideIsAboveOrRight) {
  const precision p = 120;
  for (const entry& e : functions()) {
    const bool imaginary_axis = e.where == cut::beyond_i;
    if (e.where == cut::none || e.where == cut::poles) continue;
    for (const double place : {-3.0, -1.5, -0.25, 1.5, 40.0}) {
      const point on = imaginary_axis ? point{0, rational(place)} : point{rational(place), 0};
      if (!is_on_cut(e.where, on)) continue;
      SCOPED_TRACE(std::string(e.name) + " at " + described(on));
      const complex_ball z = known_number(on, p);
      const complex_ball value = e.f(z);
      EXPECT_TRUE(agrees(value, value_on_cut(e.name, on, 500)));
      const auto shifted = [&](double low, double high) {
        const ball offset = hull(ball::exactly(low, p), ball::exactly(high, p));
        return imaginary_axis ? complex_ball(offset, z.im) : complex_ball(z.re, offset);
      };
      const double tiny = std::ldexp(1.0, -100);
      const complex_ball upper = e.f(shifted(0, tiny));
      const complex_ball above = e.f(shifted(tiny, tiny));
      const complex_ball lower = e.f(shifted(-tiny, -tiny));
      const complex_ball below = e.f(shifted(-2 * tiny, -tiny));
      const complex_ball across = e.f(shifted(-tiny, tiny));
      const complex_ball touching_from_below = e.f(shifted(-tiny, 0));
      EXPECT_TRUE(overlaps(upper, value));
      EXPECT_TRUE(overlaps(upper, above));
      // The sides differ by more than the width of each: one side alone does not hold the other.
      EXPECT_FALSE(overlaps(upper, lower));
      EXPECT_FALSE(overlaps(below, value));
      EXPECT_TRUE(contains(across, lower.middle()));
      EXPECT_TRUE(contains(across, upper.middle()));
      EXPECT_TRUE(overlaps(touching_from_below, lower));
      EXPECT_TRUE(overlaps(touching_from_below, value));
      EXPECT_TRUE(upper.re.radius() < magnitude::power_of_two(-40));
      EXPECT_TRUE(upper.im.radius() < magnitude::power_of_two(-40));
      EXPECT_TRUE(below.re.radius() < magnitude::power_of_two(-40));
      EXPECT_TRUE(below.im.radius() < magnitude::power_of_two(-40));
    }
  }
}

// ---------------------------------------------------------------------------------------------
// Tightness.

/// x does not exceed [low, high] by more than `part` of that width and four units of x's last
/// place.
::testing::AssertionResult tight(const ball& x, const ball& low, const ball& high,
                                 const rational& part) {
  const exact_set set = exact(x);
  if (!set.is_bounded()) return ::testing::AssertionFailure() << "unbounded";
  const rational a = *exact(low).lower;
  const rational b = *exact(high).upper;
  const rational slack = (b - a) * part + 4 * support::ulp(set.greatest_size(), x.precision());
  if (*set.lower >= a - slack && *set.upper <= b + slack) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << support::described(x) << " is wider than [" << support::described(a) << ", "
         << support::described(b) << "]";
}

/// The extremes of a part of f along an edge of the rectangle, by sampling and then closing in
/// from every sample that is better than its neighbours. Parts of analytic functions have their
/// extremes on the edges.
class edge_search {
 public:
  edge_search(complex_function f, const point& from, const point& to)
      : f_(f), from_(from), to_(to) {}
  ball extreme(bool imaginary, bool greatest) const {
    constexpr std::size_t count = 17;
    std::vector<ball> samples;
    for (std::size_t i = 0; i < count; ++i) samples.push_back(at(place(i), imaginary));
    ball result = samples[0];
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0 && better(samples[i - 1], samples[i], greatest)) continue;
      if (i + 1 < count && better(samples[i + 1], samples[i], greatest)) continue;
      const ball value = closing_in(place(i), samples[i], imaginary, greatest);
      if (better(value, result, greatest)) result = value;
    }
    return result;
  }

 private:
  static rational place(std::size_t i) { return rational(i) / 16; }
  ball closing_in(rational centre, ball value, bool imaginary, bool greatest) const {
    rational step = rational(1) / 32;
    for (int i = 0; i < 20; ++i, step /= 2) {
      for (const rational& t : {rational(centre - step), rational(centre + step)}) {
        if (t < 0 || t > 1) continue;
        const ball v = at(t, imaginary);
        if (better(v, value, greatest)) {
          value = v;
          centre = t;
        }
      }
    }
    return value;
  }
  static bool better(const ball& v, const ball& than, bool greatest) {
    return greatest ? certainly_less(than, v) : certainly_less(v, than);
  }
  ball at(const rational& t, bool imaginary) const {
    const complex_ball z(ball(rational(from_.re + (to_.re - from_.re) * t), 90).middle(),
                         ball(rational(from_.im + (to_.im - from_.im) * t), 90).middle());
    const complex_ball v = f_(z);
    return imaginary ? v.im : v.re;
  }
  complex_function f_;
  point from_;
  point to_;
};

TEST(ComplexTightness, RangesAreThoseOfTheEdges) {
  complex_source random(2300);
  // Where the search above ends a share 2^-20 of the edge from an extreme of the second order or
  // at a kink of a first one, it is this close.
  const rational share = power_of_two(-12);
  for (repeat trial(14); trial.again();) {
    const auto end = [&] { return rational(random.between(-48, 48)) / 16; };
    rational x0 = end();
    rational x1 = end();
    rational y0 = random.one_in(3) ? rational(0) : end();
    rational y1 = end();
    if (x1 < x0) std::swap(x0, x1);
    if (y1 < y0) std::swap(y0, y1);
    if (x0 == x1 || y0 == y1) continue;
    const complex_ball z(hull(ball(x0, 80), ball(x1, 80)), hull(ball(y0, 80), ball(y1, 80)));
    SCOPED_TRACE(described(z));
    const std::array<point, 5> corners = {point{x0, y0}, point{x1, y0}, point{x1, y1},
                                          point{x0, y1}, point{x0, y0}};
    for (const entry& e : functions()) {
      const complex_ball value = e.f(z);
      if (value.is_undefined()) continue;
      if (e.possibly_singular(z)) {
        // On the edge of one side only: im >= 0, or re >= 0 for cuts on the imaginary axis.
        if (e.where == cut::beyond_i ? x0 < 0 : y0 < 0) continue;
      }
      if (!e.is_range) continue;
      SCOPED_TRACE(e.name);
      for (const bool imaginary : {false, true}) {
        ball low;
        ball high;
        for (std::size_t i = 0; i < 4; ++i) {
          const edge_search edge(e.f, corners[i], corners[i + 1]);
          const ball a = edge.extreme(imaginary, false);
          const ball b = edge.extreme(imaginary, true);
          low = i == 0 || certainly_less(a, low) ? a : low;
          high = i == 0 || certainly_less(high, b) ? b : high;
        }
        EXPECT_TRUE(tight(imaginary ? value.im : value.re, low, high, share))
            << (imaginary ? "im" : "re");
      }
    }
  }
}

TEST(ComplexTightness, TangentFarFromTheRealAxis) {
  // Far from the real axis tan is near i, whatever overflows on the way.
  for (const double y : {1e3, 1e9, 1e300}) {
    const complex_ball far = tan(box(-3, 100, y, 2 * y));
    EXPECT_TRUE(contains(far.im, 1L));
    EXPECT_TRUE(far.im.radius() < magnitude::power_of_two(-98));
    EXPECT_TRUE(far.re.radius() < magnitude::power_of_two(-98));
    const complex_ball below = tan(box(-3, 100, -2 * y, -y));
    EXPECT_TRUE(contains(below.im, -1L));
  }
}

/// A rectangle across its cut is the hull of its two sides.
TEST(ComplexTightness, AcrossTheCut) {
  complex_source random(2302);
  for (repeat trial(150); trial.again();) {
    const precision p = 100;
    const ball along = random.any_ball(p, kind::wide);
    const ball over = random.any_ball(p, kind::across_zero);
    const ball upper = intersection(over, hull(ball(0, p), abs(over)));
    const ball lower = -intersection(-over, hull(ball(0, p), abs(over)));
    for (const entry& e : functions()) {
      if (e.where == cut::none || e.where == cut::poles) continue;
      const bool imaginary_axis = e.where == cut::beyond_i;
      const auto over_part = [&](const ball& part) {
        return imaginary_axis ? complex_ball(part, along) : complex_ball(along, part);
      };
      // The closed lower side's values are those of its mirror image, except for what is on the
      // cut.
      const auto mirrored = [&](const complex_ball& z) {
        return imaginary_axis ? -conj(z) : conj(z);
      };
      const complex_ball z = over_part(over);
      if (!e.possibly_singular(z)) continue;
      SCOPED_TRACE(std::string(e.name) + " of " + described(z));
      const complex_ball value = e.f(z);
      if (value.is_undefined()) continue;
      complex_ball sides = hull(e.f(over_part(upper)), mirrored(e.f(mirrored(over_part(lower)))));
      if (std::string(e.name) == "acos") continue;  // -conj and a shift: by acosh
      for (const auto& [whole, part] :
           {std::pair{value.re, sides.re}, std::pair{value.im, sides.im}}) {
        EXPECT_TRUE(tight(whole, part, part, rational(0)));
      }
    }
  }
}

/// For an exact operand the error is below one unit of each part's own last place.
TEST(ComplexTightness, OfAnExactNumberIsWithinAUnitOfEachPart) {
  complex_source random(2303);
  for (repeat trial(1500); trial.again();) {
    const precision p = random.between(30, 300);
    const auto part = [&] {
      switch (random.between(0, 4)) {
        case 0:
          return ball(random.any_real(p, -400, 400).get());
        case 1:
          return ball(random.any_real(p, -3 * static_cast<long>(p), 0).get());
        case 2: {  // near 1 or -1
          const ball near = ball(random.any_real(p, -p, 0).get()) + (random.one_in(2) ? 1 : -1);
          return near.middle();
        }
        case 3:
          return ball(0, p);
        default:
          return ball(random.any_real(p, -3, 3).get());
      }
    };
    const complex_ball z(part(), part());
    ASSERT_TRUE(z.is_exact());
    SCOPED_TRACE(described(z));
    const magnitude unit = magnitude::power_of_two(1 - std::int64_t{p});
    const auto is_accurate = [&](const ball& x) {
      return x.is_exact() || x.radius() <= multiply_up(x.magnitude_upper(), unit);
    };
    const bool moderate = z.magnitude_upper() < magnitude::power_of_two(9);
    for (const entry& e : functions()) {
      if (e.grows && !moderate) continue;
      const complex_ball value = e.f(z);
      if (value.is_undefined()) continue;  // a pole, or so near to one that it may be one
      EXPECT_TRUE(is_accurate(value.re)) << e.name << ": " << described(value);
      EXPECT_TRUE(is_accurate(value.im)) << e.name << ": " << described(value);
    }
    const complex_ball w(part(), part());
    EXPECT_TRUE(is_accurate((z * w).re) && is_accurate((z * w).im));
    if (!contains_zero(w)) {
      EXPECT_TRUE(is_accurate((z / w).re) && is_accurate((z / w).im)) << described(z / w);
    }
  }
}

/// The same for powers, normwise, also for results with a great exponent.
TEST(ComplexTightness, PowersOfExactNumbers) {
  complex_source random(2305);
  for (repeat trial(400); trial.again();) {
    const precision p = random.between(30, 300);
    const auto number = [&](long least, long most) {
      return complex_ball(ball(random.any_real(p, least, most).get()),
                          ball(random.any_real(p, least, most).get()));
    };
    const complex_ball z = number(-8, 8);
    const complex_ball w = number(4, 14);
    const long n = random.between(-100000, 100000);
    SCOPED_TRACE(described(z) + " to the " + described(w) + " or " + std::to_string(n));
    for (const complex_ball& value : {pow(z, w), pow(z, n)}) {
      const magnitude unit = scale(value.magnitude_upper(), 1 - std::int64_t{p});
      EXPECT_TRUE(max(value.re.radius(), value.im.radius()) <= unit) << described(value);
    }
  }
}

/// For a thin operand the radius of a part is the propagated one, by the part's own derivatives,
/// but for a quarter of it, 2^-20 of what |f'| would give, and two units in the last place of |f|.
TEST(ComplexTightness, OfAThinNumberIsThePropagatedRadius) {
  complex_source random(2304);
  for (repeat trial(600); trial.again();) {
    const precision p = random.between(60, 300);
    const auto part = [&] {
      const real m = random.any_real(p, -6, 3);
      return ball::from_midpoint_radius(m, random.thin_radius(mpfr_get_exp(m.get()) - 10, p));
    };
    const complex_ball z(part(), part());
    SCOPED_TRACE(described(z));
    for (const entry& e : functions()) {
      const complex_ball value = e.f(z);
      const complex_ball slope = e.derivative(z.middle());
      if (value.is_undefined() || slope.is_undefined()) continue;
      const auto check = [&](const ball& x, const ball& s, const ball& t) {
        const magnitude spread = add_up(multiply_up(s.magnitude_upper(), z.re.radius()),
                                        multiply_up(t.magnitude_upper(), z.im.radius()));
        const magnitude whole =
            multiply_up(slope.magnitude_upper(), add_up(z.re.radius(), z.im.radius()));
        const magnitude limit = add_up(add_up(scale(whole, -20), add_up(spread, scale(spread, -2))),
                                       scale(value.magnitude_upper(), 2 - std::int64_t{p}));
        return x.radius() <= limit;
      };
      EXPECT_TRUE(check(value.re, slope.re, slope.im)) << e.name << " " << described(value);
      EXPECT_TRUE(check(value.im, slope.im, slope.re)) << e.name << " " << described(value);
    }
  }
}

// ---------------------------------------------------------------------------------------------
// Monotonicity of inclusion (see monotonicity_test.cpp): f(x) lies in f(y) after each end of f(y)
// is moved outward by three units in the last place, a quarter of the part's radius, and, as the
// mean value theorem bounds the change of the greater part of f' and not of each, a sixteenth of
// the other part's.

bool in(const ball& small, const ball& large, const magnitude& other_radius = {}) {
  exact_set outer = exact(large);
  const exact_set inner = exact(small);
  if (inner.is_bounded()) {
    const rational slack = 3 * support::ulp(inner.greatest_size(), small.precision()) +
                           support::to_rational(small.radius()) / 4 +
                           support::to_rational(other_radius) / 16;
    if (outer.lower) outer.lower = *outer.lower - slack;
    if (outer.upper) outer.upper = *outer.upper + slack;
  }
  return outer.holds(inner);
}
::testing::AssertionResult in(const complex_ball& small, const complex_ball& large) {
  if (large.is_undefined()) return ::testing::AssertionSuccess();
  if (small.is_undefined()) return ::testing::AssertionFailure() << "the smaller is undefined";
  const magnitude re = small.re.radius();
  const magnitude im = small.im.radius();
  const bool is_in = in(small.re, large.re, im.is_infinite() ? magnitude{} : im) &&
                     in(small.im, large.im, re.is_infinite() ? magnitude{} : re);
  if (is_in) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << described(small) << " is not in " << described(large);
}

TEST(ComplexMonotonicity, OfFunctions) {
  complex_source random(2400);
  for (repeat trial(1000); trial.again();) {
    const precision p = random.between(40, 300);
    const complex_ball z = random.moderate(p);
    const complex_ball inner = random.inside_of(z);
    SCOPED_TRACE(described(inner) + " in " + described(z));
    for (const entry& e : functions()) {
      EXPECT_TRUE(in(e.f(inner), e.f(z))) << e.name;
    }
    if (!contains_zero(z)) {
      EXPECT_TRUE(in(arg(inner), arg(z)));
    }
    EXPECT_TRUE(in(abs(inner), abs(z)));
    const complex_ball w = random.moderate(p);
    const complex_ball v = random.inside_of(w);
    EXPECT_TRUE(in(inner + v, z + w));
    EXPECT_TRUE(in(inner * v, z * w));
    EXPECT_TRUE(in(inner / v, z / w));
  }
}

// ---------------------------------------------------------------------------------------------
// Analyticity.

TEST(ComplexAnalyticity, TouchingExactlyIsTouching) {
  const double next = std::nextafter(1.0, 2.0);
  const double before = std::nextafter(1.0, 0.0);
  const double least = std::ldexp(1.0, -1000);
  const auto at = [](double a, double b, double c, double d) -> rectangle<ball> {
    return box(a, b, c, d);
  };
  EXPECT_TRUE(possibly_singular::sqrt(at(0, 1, 0, 0)));
  EXPECT_TRUE(possibly_singular::sqrt(at(0, 1, -1, 1)));
  EXPECT_FALSE(possibly_singular::sqrt(at(least, 1, -1, 1)));
  EXPECT_TRUE(possibly_singular::sqrt(at(-2, -1, 0, 1)));
  EXPECT_TRUE(possibly_singular::sqrt(at(-2, -1, -1, 0)));
  EXPECT_FALSE(possibly_singular::sqrt(at(-2, -1, least, 1)));
  EXPECT_FALSE(possibly_singular::log(at(-2, -1, -1, -least)));
  EXPECT_TRUE(possibly_singular::agm(at(-2, 0, 0, 0)));
  for (const double sign : {1.0, -1.0}) {
    const double a = std::min(sign * 0.5, sign);
    const double b = std::max(sign * 0.5, sign);
    EXPECT_TRUE(possibly_singular::asin(at(a, b, 0, 1)));
    EXPECT_TRUE(possibly_singular::atanh(at(a, b, -1, 0)));
    EXPECT_FALSE(possibly_singular::acos(at(a, b, least, 1)));
    EXPECT_FALSE(possibly_singular::asinh(at(a, b, 0, 1)));
    EXPECT_TRUE(possibly_singular::asinh(at(0, 1, a, b)));
    EXPECT_TRUE(possibly_singular::atan(at(-1, 0, a, b)));
    EXPECT_FALSE(possibly_singular::atan(at(least, 1, a, b)));
  }
  EXPECT_FALSE(possibly_singular::asin(at(-before, before, -1, 1)));
  EXPECT_FALSE(possibly_singular::atan(at(-1, 1, -before, before)));
  EXPECT_TRUE(possibly_singular::acosh(at(1, 2, 0, 1)));
  EXPECT_FALSE(possibly_singular::acosh(at(next, 2, -1, 1)));
  EXPECT_TRUE(possibly_singular::acosh(at(-0.5, 0.5, -1, 1)));
  EXPECT_TRUE(possibly_singular::reciprocal(at(0, 1, 0, 1)));
  EXPECT_FALSE(possibly_singular::reciprocal(at(least, 1, 0, 1)));
  EXPECT_TRUE(possibly_singular::division(at(1, 1, 0, 0), at(-1, 0, -1, 0)));
  EXPECT_TRUE(possibly_singular::tan(at(1, 2, 0, 1)));
  EXPECT_FALSE(possibly_singular::tan(at(1, 2, least, 1)));
  EXPECT_FALSE(possibly_singular::tan(at(-1.5, 1.5, -1, 1)));
  EXPECT_FALSE(possibly_singular::tan(at(1.625, 4.625, -1, 1)));
  EXPECT_TRUE(possibly_singular::tanh(at(0, 1, 1, 2)));
  EXPECT_FALSE(possibly_singular::tanh(at(least, 1, 1, 2)));
  EXPECT_FALSE(possibly_singular::pow(at(-1, 1, -1, 1), 3));
  EXPECT_TRUE(possibly_singular::pow(at(-1, 1, -1, 1), -3));
  EXPECT_TRUE(possibly_singular::pow(at(-1, 1, 0, 1), at(0.5, 0.5, 0, 0)));
  EXPECT_FALSE(possibly_singular::pow(at(0.5, 1, -1, 1), at(0.5, 0.5, 0, 0)));
}

/// The predicates against geometry in rationals: the set of z meets the set of the cut.
TEST(ComplexAnalyticity, AgreesWithExactGeometry) {
  complex_source random(2500);
  for (repeat trial(4000); trial.again();) {
    const precision p = random.any_precision();
    const complex_ball z = random.any_complex(p);
    SCOPED_TRACE(described(z));
    const exact_set x = exact(z.re);
    const exact_set y = exact(z.im);
    const auto reaches_up = [](const exact_set& s, const rational& q) {
      return !s.upper || *s.upper >= q;
    };
    const auto reaches_down = [](const exact_set& s, const rational& q) {
      return !s.lower || *s.lower <= q;
    };
    for (const entry& e : functions()) {
      bool meets = false;
      switch (e.where) {
        case cut::negative:
          meets = y.holds(rational(0)) && reaches_down(x, 0);
          break;
        case cut::beyond_one:
          meets = y.holds(rational(0)) && (reaches_down(x, -1) || reaches_up(x, 1));
          break;
        case cut::below_one:
          meets = y.holds(rational(0)) && reaches_down(x, 1);
          break;
        case cut::beyond_i:
          meets = x.holds(rational(0)) && (reaches_down(y, -1) || reaches_up(y, 1));
          break;
        case cut::none:
          meets = std::string(e.name) == "reciprocal" && contains(z, rational(0), rational(0));
          break;
        case cut::poles:
          continue;
      }
      // 1 is subtracted with a rounding, outward: a hair's breadth from the cut may count as on it.
      if (meets) {
        EXPECT_TRUE(e.possibly_singular(z)) << e.name;
      } else if (p >= 24 && (e.where == cut::negative || e.where == cut::none)) {
        EXPECT_FALSE(e.possibly_singular(z)) << e.name;
      }
    }
  }
}

// ---------------------------------------------------------------------------------------------
// The arithmetic-geometric mean.

TEST(ComplexAgm, OfRealNumbersIsTheRealOne) {
  complex_source random(2600);
  for (repeat trial(500); trial.again();) {
    const precision p = random.any_precision();
    const rational x = abs(random.any_rational(40)) + power_of_two(-40);
    const rational y = abs(random.any_rational(40)) + power_of_two(-40);
    const ball mean = agm(ball(x, p + 100), ball(y, p + 100));
    const complex_ball value = agm(complex_ball(ball(x, p)), complex_ball(ball(y, p)));
    EXPECT_TRUE(overlaps(value.re, mean) && contains(value.im, 0L));
    // With an imaginary part that the iteration has to carry.
    const complex_ball thick =
        agm(complex_ball(ball(x, p), ball(0, p).enlarged(magnitude::power_of_two(-90))));
    EXPECT_TRUE(overlaps(thick.re, agm(ball(1, p + 100), ball(x, p + 100))));
    EXPECT_TRUE(contains(thick.im, 0L));
  }
}

TEST(ComplexAgm, SymmetryHomogeneityAndOneStep) {
  complex_source random(2601);
  for (repeat trial(400); trial.again();) {
    const precision p = random.between(30, 250);
    const auto number = [&] {
      return complex_ball(ball(random.any_real(p, -6, 6).get()),
                          ball(random.any_real(p, -6, 6).get()));
    };
    const complex_ball z = number();
    const complex_ball w = number();
    const complex_ball c = number();
    SCOPED_TRACE(described(z) + ", " + described(w));
    if (possibly_singular::agm(w / z)) continue;  // there the two orders are two sides of the cut
    const complex_ball mean = agm(z, w);
    EXPECT_TRUE(overlaps(mean, agm(w, z)));
    EXPECT_TRUE(overlaps(c * mean, agm(c * z, c * w)));
    EXPECT_TRUE(overlaps(conj(mean), agm(conj(z), conj(w))));
    // The right choice of the root is the one nearer to the arithmetic mean.
    const complex_ball a = scale(z + w, -1);
    const complex_ball root = sqrt(z) * sqrt(w);
    const complex_ball g = certainly_less(abs(a - root), abs(a + root)) ? root : -root;
    EXPECT_TRUE(overlaps(mean, agm(a, g)));
    EXPECT_TRUE(certainly_less_equal(abs(mean), max(abs(z), abs(w)) * 2));
    // Of exact operands: known to almost the whole precision.
    const magnitude size = mean.magnitude_lower();
    EXPECT_TRUE(max(mean.re.radius(), mean.im.radius()) <=
                scale(max(size, scale(z.magnitude_upper(), -20)), 4 - std::int64_t{p}))
        << described(mean);
  }
}

TEST(ComplexAgm, OnTheCutItIsTheLimitFromAbove) {
  const precision p = 200;
  for (const char* text : {"-4", "-1.5", "-0.75", "-1/1024"}) {
    const complex_ball z(parse_ball(text, p), ball(0, p));
    const complex_ball value = agm(z);
    const complex_ball above(z.re, scale(ball(1, p), -150));
    const complex_ball limit = agm(above);
    // |M'| is below 2^20 near these points: 2^-130 is far above the change, and far below the jump.
    EXPECT_TRUE(overlaps(value, limit.enlarged(magnitude::power_of_two(-130)))) << text;
    EXPECT_FALSE(overlaps(value, agm(conj(above)).enlarged(magnitude::power_of_two(-130)))) << text;
    EXPECT_TRUE(value.re.radius() < magnitude::power_of_two(-190)) << described(value);
    const complex_ball across =
        agm(complex_ball(z.re, ball(0, p).enlarged(magnitude::power_of_two(-150))));
    EXPECT_TRUE(contains(across, value.middle()));
    EXPECT_TRUE(contains(across, conj(value.middle())));
  }
  // Wide sets about 0 and -1 have a bounded answer.
  for (const complex_ball& z : {box(-1, 1, -1, 1), box(-2, -0.5, 0, 1), box(0, 0.5, 0, 0.5)}) {
    const complex_ball value = agm(z);
    EXPECT_TRUE(value.is_bounded());
    EXPECT_TRUE(value.magnitude_upper() < magnitude::power_of_two(3));
  }
}

// ---------------------------------------------------------------------------------------------
// The class.

TEST(ComplexBall, PrecisionIsThatOfTheBetterPart) {
  const complex_ball z(ball(1, 50), ball(2, 200));
  EXPECT_EQ(z.re.precision(), 200);
  EXPECT_EQ(z.precision(), 200);
  const complex_ball w(3, 60);
  for (const complex_ball& r : {z + w, w - z, z * w, w / z, z / w, pow(w, z), agm(w, z)}) {
    EXPECT_EQ(r.re.precision(), 200);
    EXPECT_EQ(r.im.precision(), 200);
  }
  EXPECT_EQ((w + ball(1, 90)).im.precision(), 90);
  EXPECT_EQ((w + 1).precision(), 60);
  EXPECT_EQ((w * rational(1, 3)).precision(), 60);
  EXPECT_EQ(complex_ball().precision(), 64);
  EXPECT_TRUE(complex_ball().is_exact());
}

TEST(ComplexBall, CompoundAssignmentAndAliasing) {
  const precision p = 100;
  complex_ball z(1, 2, p);
  z *= z;
  EXPECT_TRUE(holds(z, {-3, 4}));
  z += 4;
  z -= complex_ball::i(p);
  EXPECT_TRUE(holds(z, {1, 3}));
  const complex_ball& same = z;
  z /= same;
  EXPECT_TRUE(holds(z, {1, 0}));
  z *= ball(7, p);
  z /= 2;
  EXPECT_TRUE(holds(z, {rational(7, 2), 0}));
}

TEST(ComplexBall, Sets) {
  const complex_ball z = box(0, 2, -1, 1);
  EXPECT_TRUE(contains(z, box(0.5, 2, 0, 1)));
  EXPECT_FALSE(contains(z, box(0.5, 2, 0, 1.5)));
  EXPECT_TRUE(overlaps(z, box(2, 3, 1, 2)));
  EXPECT_FALSE(overlaps(z, box(2, 3, 1.5, 2)));
  EXPECT_TRUE(contains(hull(z, box(5, 6, 7, 8)), box(0, 6, -1, 8)));
  EXPECT_TRUE(intersection(z, box(3, 4, 0, 0)).is_undefined());
  EXPECT_TRUE(contains_zero(z));
  const complex_ball w = box(3, 4, 4, 5);
  EXPECT_TRUE(contains(abs(w), 5L));
  EXPECT_TRUE(magnitude::from_integer_up(5) >= w.magnitude_lower());
  EXPECT_TRUE(magnitude::from_integer_down(6) <= w.magnitude_upper());
  EXPECT_TRUE(contains(w.enlarged(magnitude::power_of_two(0)), box(2, 5, 3, 6)));
}

TEST(ComplexBall, Text) {
  EXPECT_EQ(to_decimal(complex_ball(2, -3, 64), 10), "2 - 3*I");
  EXPECT_EQ(to_decimal(sqrt(complex_ball(0, 1, 64)), 5), "0.70710... + 0.70710...*I");
  EXPECT_EQ(to_decimal(complex_ball(ball(1, 64), sqrt(ball(2, 64)) * -1), 4), "1 - 1.414...*I");
  EXPECT_EQ(to_decimal(complex_ball::undefined(64), 5), "undefined");
  EXPECT_EQ(to_decimal(box(0, 1, -1, 1), 3), "[0, 1] + [-1, 1]*I");
  std::ostringstream out;
  out.precision(4);
  out << exp(complex_ball(0, 1, 128));
  EXPECT_EQ(out.str(), "0.5403... + 0.8414...*I");
}

}  // namespace complex_ball_test
}  // namespace polhode
