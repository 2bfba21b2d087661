// Complete elliptic integrals: values from elsewhere, identities, and the integrals that define
// them.

#include <gtest/gtest.h>

#include <array>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/complete.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace complete_test {

using support::agrees;
using support::as_narrow_as;
using support::meet;

complete_integrals complete(const rational& m, precision p) {
  return complete_legendre(ball(m, p), ball(rational(1 - m), p));
}

struct reference {
  std::string_view m, k, e, d, b;
};

// mpmath 1.3.0: ellipk and ellipe of the parameter m at 80 to 700 digits, D = (K - E)/m, B = K - D.
constexpr reference references[] = {
    {"0", "1.57079632679489661923132169163975144209858469968755291048747",
     "1.57079632679489661923132169163975144209858469968755291048747",
     "0.785398163397448309615660845819875721049292349843776455243736",
     "0.785398163397448309615660845819875721049292349843776455243736"},
    {"0.5", "1.85407467730137191843385034719526004621759882352176690558593",
     "1.35064388104767550252017473533872584134952236692435454532325",
     "1.00686159250739283182735122371306840973615291319482472052535",
     "0.847213084793979086606499123482191636481445910326942185060579"},
    {"0.25", "1.68575035481259604287120365779907698950080089414108904411995",
     "1.46746220933942715545979526699091613602536175232723196050079",
     "0.873152581892675549645633563232643413901756567255428334476631",
     "0.812597772919920493225570094566433575599044326885660709643318"},
    {"0.9", "2.57809211334817318820257077181650623511355737425765401514387",
     "1.10477473270407332609039886714747264597692122625621652407276",
     "1.63701931182677762456907989407670398792959572000159721230123",
     "0.941072801521395563633490877739802247183961654256056802842642"},
    {"0.99", "3.69563736298987467780995419526255098480067200581918261569947",
     "1.01599354502522393563944827529541409478282630336260148508515",
     "2.70671092723702095168737971713852211112913707318846578849932",
     "0.988926435752853726122574478124028873671534932630716827200155"},
    {"1e-10", "1.57079632683416652740340303945524320583917284053226593795250",
     "1.57079632675562671106071296538075261240156684097605094213405",
     "0.785398163426900740744905934376059995562149958184482981276891",
     "0.785398163407265786658497105079183210277022882347782956675608"},
    {"1e-300", "1.57079632679489661923132169163975144209858469968755291048747",
     "1.57079632679489661923132169163975144209858469968755291048747",
     "0.785398163397448309615660845819875721049292349843776455243736",
     "0.785398163397448309615660845819875721049292349843776455243736"},
};

TEST(CompleteLegendre, HasTheValuesOfMpmath) {
  for (const reference& r : references) {
    for (const precision p : {24L, 53L, 64L, 190L, 260L}) {
      const complete_integrals c = complete(parse_rational(r.m), p);
      const long digits = std::min(57L, (p - 10) * 3 / 10);
      EXPECT_TRUE(agrees(c.k, r.k, digits)) << r.m << " " << p;
      EXPECT_TRUE(agrees(c.e, r.e, digits)) << r.m << " " << p;
      EXPECT_TRUE(agrees(c.d, r.d, digits)) << r.m << " " << p;
      EXPECT_TRUE(agrees(c.b, r.b, digits)) << r.m << " " << p;
    }
  }
}

TEST(CompleteLegendre, AtTheEndsOfItsRange) {
  // m1 = 1e-300, m = 1 - m1 given as what it is: mpmath at 700 digits.
  const rational m1 = parse_rational("1e-300");
  const complete_integrals c = complete_legendre(ball(rational(1 - m1), 200), ball(m1, 200));
  EXPECT_TRUE(agrees(c.k, "346.774058310226743221533182445570984276316223563036456913241", 56));
  EXPECT_TRUE(agrees(c.e, "1.00000000000000000000000000000000000000000000000000000000000", 54));
  EXPECT_TRUE(agrees(c.d, "345.774058310226743221533182445570984276316223563036456913241", 56));
  EXPECT_TRUE(agrees(c.b, "1.00000000000000000000000000000000000000000000000000000000000", 54));
  // m = 0 exactly: pi/2, pi/2, pi/4, pi/4 in one step.
  const complete_integrals zero = complete(0, 100);
  EXPECT_TRUE(meet(zero.k, scale(pi(200), -1)));
  EXPECT_TRUE(as_narrow_as(zero.d, 95));
  // Still further: K = log 4 - (log m1)/2 to the order of m1.
  const rational least = support::power_of_ten(-10'000);
  const complete_integrals far = complete_legendre(
      ball(1, 200).enlarged(magnitude::abs_up(midpoint(ball(least, 64)).backend().data())),
      ball(least, 200));
  EXPECT_TRUE(meet(far.k, log(ball(4, 200)) - scale(log(ball(least, 200)), -1)));
  EXPECT_TRUE(as_narrow_as(far.k, 180));
}

TEST(CompleteLegendre, SatisfiesItsIdentities) {
  support::random_source random(5);
  for (support::repeat trial(150); trial.again();) {
    const precision p = random.between(53, 700);
    rational m(random.between(1, 9999), 10000);
    if (random.one_in(4)) m = support::power_of_two(-random.between(1, 300));
    if (random.one_in(4)) m = 1 - support::power_of_two(-random.between(1, 300));
    const complete_integrals c = complete(m, p);
    const complete_integrals other = complete(rational(1 - m), p);
    // Legendre's relation.
    const ball relation = c.e * other.k + other.e * c.k - c.k * other.k;
    EXPECT_TRUE(meet(relation, scale(pi(p + 64), -1))) << m << " " << p;
    EXPECT_TRUE(relation.radius() <= scale((c.k * other.k).magnitude_upper(), 24 - p)) << m;
    // The four are two.
    EXPECT_TRUE(meet(c.k, c.d + c.b));
    EXPECT_TRUE(meet(c.e, c.k - m * c.d));
    EXPECT_TRUE(meet(c.k, scale(pi(p), -1) / agm(ball(1, p), sqrt(ball(rational(1 - m), p)))));
    // m/2 + the sum of 2^(n-1) c_n^2 is 1 - E/K.
    const agm_sums sums = agm_with_sum(ball(1, p), sqrt(ball(rational(1 - m), p)));
    EXPECT_TRUE(meet(1 - c.e / c.k, sums.sum + ball(rational(m / 2), p))) << m << " " << p;
  }
}

TEST(CompleteLegendre, HasItsDerivatives) {
  // (K(m+h) - K(m))/h is a value of K' = B/(2 m1) between, and so for E' = -D/2.
  support::random_source random(6);
  for (support::repeat trial(100); trial.again();) {
    const precision p = 300;
    const rational m(random.between(1, 9990), 10000);
    const rational h = (1 - m) * support::power_of_two(-random.between(4, 60));
    const complete_integrals low = complete(m, p);
    const complete_integrals high = complete(rational(m + h), p);
    const ball m1 = hull(ball(rational(1 - m), p), ball(rational(1 - m - h), p));
    const complete_integrals over =
        complete_legendre(hull(ball(m, p), ball(rational(m + h), p)), m1);
    EXPECT_TRUE(meet((high.k - low.k) / h, over.b / (2 * m1))) << m << " " << h;
    EXPECT_TRUE(meet((high.e - low.e) / h, -scale(over.d, -1))) << m << " " << h;
  }
}

/// 2 cos^2, 2 sin^2 or 2 times Delta^-1, or 2 Delta, at t = 2 theta: their integrals over (0, pi)
/// in t are four times the complete ones' half: integral over (0, pi/2) of f(theta) = (1/2) that of
/// f(t/2) over (0, pi).
class defining_integrand {
 public:
  enum class which { k, e, d, b };
  defining_integrand(which w, rational m) : which_(w), m_(std::move(m)) {}

  template <scalar T>
  [[nodiscard]] auto evaluator(precision p) const {
    const T half_m = scalar_from<T>(rational(m_ / 2), p);
    return [half_m, w = which_](const T& cosine) -> T {
      const T delta = sqrt(T(1 - half_m * T(1 - cosine)));
      switch (w) {
        case which::k:
          return 1 / (2 * delta);
        case which::e:
          return delta / 2;
        case which::d:
          return (1 - cosine) / (4 * delta);
        case which::b:
          return (1 + cosine) / (4 * delta);
      }
      return delta;
    };
  }

  /// Re Delta^2 >= 1 - (m/2)(1 + cosh H), |Delta|^2 <= 1 + (m/2)(1 + cosh H).
  [[nodiscard]] std::optional<strip_bound> bound_on_strip(const ball& half_width) const {
    const ball c = 1 + cosh(half_width);
    const ball least = 1 - rational(m_ / 2) * c;
    if (!certainly_positive(least)) return std::nullopt;
    const ball most = which_ == which::e ? sqrt(1 + rational(m_ / 2) * c) : c / sqrt(least);
    return strip_bound{half_width, most};
  }

 private:
  which which_;
  rational m_;
};

TEST(CompleteLegendre, IsItsDefinition) {
  using which = defining_integrand::which;
  for (const rational& m : {rational(1, 10), rational(1, 2), rational(9, 10), rational(97, 100)}) {
    for (const long bits : {60L, 400L}) {
      const complete_integrals c = complete(m, bits + 40);
      const auto check = [&](which w, const ball& value) {
        const periodic_integral q = integrate_periodic(defining_integrand(w, m), bits);
        EXPECT_EQ(q.verdict, status::certified);
        EXPECT_TRUE(meet(q.enclosure, value)) << m << " " << bits << " " << static_cast<int>(w);
      };
      check(which::k, c.k);
      check(which::e, c.e);
      check(which::d, c.d);
      check(which::b, c.b);
    }
  }
}

TEST(CompleteLegendre, AgreesWithBoostInDouble) {
  // m1 = j/64 is exact in double. Boost's R_F and R_D are right to a few units in the last place:
  // 64 here.
  for (long j = 1; j <= 64; ++j) {
    const double m1 = static_cast<double>(j) / 64;
    const complete_integrals c = complete(rational(64 - j, 64), 80);
    const ball k = ball::exactly(boost::math::ellint_rf(0.0, m1, 1.0), 80);
    const ball d = ball::exactly(boost::math::ellint_rd(0.0, m1, 1.0), 80) / 3;
    EXPECT_TRUE(overlaps(k.enlarged(scale(k.magnitude_upper(), -46)), c.k)) << j;
    EXPECT_TRUE(overlaps(d.enlarged(scale(d.magnitude_upper(), -46)), c.d)) << j;
  }
}

TEST(CompleteLegendre, ContainsTheMembersOfWideParameters) {
  support::random_source random(7);
  for (support::repeat trial(300); trial.again();) {
    const rational low(random.between(0, 998), 1000);
    const rational high = low + (1 - low) * rational(random.between(1, 900), 1000);
    const precision p = random.between(30, 120);
    const complete_integrals wide =
        complete_legendre(hull(ball(low, p), ball(high, p)),
                          hull(ball(rational(1 - low), p), ball(rational(1 - high), p)));
    const rational m = low + (high - low) * rational(random.between(0, 64), 64);
    const complete_integrals member = complete(m, 300);
    EXPECT_TRUE(meet(wide.k, member.k)) << low << " " << high << " " << m;
    EXPECT_TRUE(meet(wide.e, member.e)) << low << " " << high << " " << m;
    EXPECT_TRUE(meet(wide.d, member.d)) << low << " " << high << " " << m;
    EXPECT_TRUE(meet(wide.b, member.b)) << low << " " << high << " " << m;
  }
}

TEST(CompleteLegendre, IsUndefinedOutsideItsHypotheses) {
  const precision p = 64;
  const auto refused = [](const ball& m, const ball& m1) {
    const complete_integrals c = complete_legendre(m, m1);
    EXPECT_TRUE(c.k.is_undefined() && c.e.is_undefined() && c.d.is_undefined() &&
                c.b.is_undefined())
        << m << " " << m1;
  };
  refused(ball(1, p), ball(0, p));
  refused(ball(2, p), ball(-1, p));
  refused(ball(-1, p), ball(2, p));
  refused(hull(ball(rational(1, 2), p), ball(1, p)), hull(ball(0, p), ball(rational(1, 2), p)));
  refused(ball::undefined(p), ball(1, p));
  refused(ball(0, p), ball::undefined(p));
  refused(ball(rational(1, 2), p), ball::entire(p));
  // m1 is not 1 - m.
  refused(ball(rational(1, 2), p), ball(rational(51, 100), p));
  refused(ball(0, p), ball(rational(99, 100), p));
}

TEST(AgmWithSum, IsTheMeanAndTheSum) {
  support::random_source random(8);
  for (support::repeat trial(200); trial.again();) {
    const rational a = support::power_of_two(random.between(-40, 40)) * random.between(1, 1000);
    const rational b = support::power_of_two(random.between(-40, 40)) * random.between(1, 1000);
    const precision p = random.between(4, 300);
    const agm_sums sums = agm_with_sum(ball(a, p), ball(b, p));
    EXPECT_TRUE(meet(sums.mean, agm(ball(a, 400), ball(b, 400)))) << a << " " << b << " " << p;
    // The definition, with 600 bits and no error bounds.
    support::real x(600, a, MPFR_RNDN);
    support::real y(600, b, MPFR_RNDN);
    support::real half(600);
    support::real sum(600, 0);
    for (long n = 1; n <= 30; ++n) {
      mpfr_sub(half, x, y, MPFR_RNDN);  // c_n
      mpfr_div_2ui(half, half, 1, MPFR_RNDN);
      support::real mean(600);
      mpfr_add(mean, x, y, MPFR_RNDN);
      mpfr_div_2ui(mean, mean, 1, MPFR_RNDN);
      mpfr_mul(y, x, y, MPFR_RNDN);
      mpfr_sqrt(y, y, MPFR_RNDN);
      mpfr_set(x, mean, MPFR_RNDN);
      mpfr_sqr(half, half, MPFR_RNDN);
      mpfr_mul_2si(half, half, n - 1, MPFR_RNDN);
      mpfr_add(sum, sum, half, MPFR_RNDN);
    }
    const ball expected = ball(sum.get()).enlarged(scale(magnitude::abs_up(sum.get()), -400));
    EXPECT_TRUE(meet(sums.sum, expected)) << a << " " << b << " " << p;
    if (p > 60) {
      EXPECT_TRUE(as_narrow_as(sums.mean, p - 14));
      if (a != b) {
        EXPECT_TRUE(as_narrow_as(sums.sum, p - 16));
      }
    }
  }
}

TEST(AgmWithSum, AtItsEdges) {
  const agm_sums equal = agm_with_sum(ball(3, 64), ball(3, 64));
  EXPECT_TRUE(meet(equal.mean, ball(3, 64)));
  EXPECT_TRUE(contains(equal.sum, 0L));
  EXPECT_TRUE(as_narrow_as(equal.mean, 60));
  EXPECT_EQ(equal.steps, 1);
  // The steps grow with the logarithm of the digits and of the ratio's logarithm: pinned.
  EXPECT_EQ(agm_with_sum(ball(1, 64), ball(rational(1, 2), 64)).steps, 5);
  EXPECT_EQ(agm_with_sum(ball(1, 4096), ball(rational(1, 2), 4096)).steps, 11);
  const rational tiny = support::power_of_ten(-10'000);
  const agm_sums far = agm_with_sum(ball(1, 64), ball(tiny, 64));
  EXPECT_TRUE(meet(far.mean, agm(ball(1, 200), ball(tiny, 200))));
  EXPECT_LE(far.steps, 22);
  for (const auto& [x, y] :
       {std::pair{ball(0, 64), ball(1, 64)}, std::pair{ball(1, 64), ball(0, 64)},
        std::pair{ball(-1, 64), ball(1, 64)}, std::pair{ball(1, 64), ball::undefined(64)},
        std::pair{hull(ball(0, 64), ball(1, 64)), ball(1, 64)},
        std::pair{ball(1, 64), ball::entire(64)}}) {
    EXPECT_TRUE(agm_with_sum(x, y).mean.is_undefined());
    EXPECT_TRUE(agm_with_sum(x, y).sum.is_undefined());
  }
}

TEST(AgmWithSum, AccountsForTheStepsThatItLeavesOut) {
  // 1 and 1 - 2^-34 are done after one step, all of it exact in 64 bits: the mean's error and the
  // sum's tail are all that holds the true values.
  const rational near_one = 1 - support::power_of_two(-34);
  const agm_sums sums = agm_with_sum(ball(1, 64), ball(near_one, 64));
  EXPECT_EQ(sums.steps, 1);
  EXPECT_TRUE(meet(sums.mean, agm(ball(1, 400), ball(near_one, 400))));
  EXPECT_TRUE(meet(sums.sum, agm_with_sum(ball(1, 400), ball(near_one, 400)).sum));
}

TEST(AgmWithSum, ContainsTheMembersOfWideOperands) {
  support::random_source random(9);
  for (support::repeat trial(300); trial.again();) {
    const rational a(random.between(1, 1000), 100);
    const rational b(random.between(1, 1000), 100);
    const bool by_factors = random.one_in(4);
    const auto stretched = [&](const rational& q) {
      return q * rational(random.between(100, by_factors ? 1000 : 105), 100);
    };
    const rational a_end = stretched(a);
    const rational b_end = stretched(b);
    const agm_sums wide =
        agm_with_sum(hull(ball(a, 64), ball(a_end, 64)), hull(ball(b, 64), ball(b_end, 64)));
    EXPECT_EQ(wide.mean.is_undefined(), wide.sum.is_undefined());
    if (by_factors && wide.mean.is_undefined()) continue;
    const rational x = a + (a_end - a) * rational(random.between(0, 16), 16);
    const rational y = b + (b_end - b) * rational(random.between(0, 16), 16);
    const agm_sums member = agm_with_sum(ball(x, 200), ball(y, 200));
    EXPECT_TRUE(meet(wide.mean, member.mean)) << x << " " << y;
    EXPECT_TRUE(meet(wide.sum, member.sum)) << x << " " << y;
  }
}

ball rd(const rational& y, const rational& z, precision p) {
  const rational one_minus_ratio = y < z ? rational(1 - y / z) : rational(1 - z / y);
  return complete_rd(ball(y, p), ball(z, p), ball(one_minus_ratio, p));
}

TEST(CompleteRd, HasTheValuesOfMpmath) {
  // mpmath 1.3.0: elliprd(0, y, z) with 80 digits.
  struct row {
    std::string_view y, z, value;
  };
  for (const row& r :
       {row{"1", "2", "1.06793798966739570226868782320809665159165671616197870341486"},
        row{"2", "1", "1.79721035210338831115988373842048581734081899482347733739551"},
        row{"1", "1", "2.35619449019234492884698253745962716314787704953132936573121"},
        row{"0.001", "7", "0.779731061654887025272311455281778398962890716307268680735734"},
        row{"7", "0.001", "1133.54403133445136089484289103672327838359624393903890243829"},
        row{"1e-40", "1", "139.313988663002412897582880009810911864529463673037635267691"},
        row{"1", "1e-40", "29999999999999999999999999999999999999931.0930056684987935512"}}) {
    for (const precision p : {64L, 256L}) {
      EXPECT_TRUE(
          agrees(rd(parse_rational(r.y), parse_rational(r.z), p), r.value, p == 64 ? 15 : 58))
          << r.y << " " << r.z;
    }
  }
}

TEST(CompleteRd, IsHomogeneousAndContiguous) {
  support::random_source random(10);
  for (support::repeat trial(100); trial.again();) {
    const precision p = random.between(60, 300);
    const rational y(random.between(1, 10'000), random.between(1, 1000));
    const rational z =
        random.one_in(5) ? y : rational(random.between(1, 10'000), random.between(1, 1000));
    const rational factor(random.between(1, 1000), random.between(1, 1000));
    const ball value = rd(y, z, p);
    EXPECT_TRUE(as_narrow_as(value, p - 24)) << y << " " << z << " " << p;
    // R_D(0, s y, s z) = s^(-3/2) R_D(0, y, z).
    const ball s(factor, p);
    EXPECT_TRUE(meet(rd(rational(factor * y), rational(factor * z), p) * s * sqrt(s), value));
    // y R_D(0, z, y) + z R_D(0, y, z) = 3 R_F(0, y, z) = (3 pi/2)/M(sqrt y, sqrt z).
    EXPECT_TRUE(meet(y * rd(z, y, p) + z * value,
                     3 * scale(pi(p), -1) / agm(sqrt(ball(y, p)), sqrt(ball(z, p)))));
    EXPECT_TRUE(overlaps(
        ball::exactly(boost::math::ellint_rd(0.0, static_cast<double>(y), static_cast<double>(z)))
            .enlarged(scale(value.magnitude_upper(), -44)),
        value));
  }
}

TEST(CompleteRd, OfBallsWhoseOrderIsOpen) {
  // 1/3 twice is not one number in binary; and y, z that cross.
  const ball third(rational(1, 3), 64);
  const ball equal = complete_rd(third, third, ball(0, 64));
  EXPECT_TRUE(meet(equal, rational(3, 4) * pi(100) * sqrt(ball(27, 100))));
  EXPECT_TRUE(as_narrow_as(equal, 50));
  support::random_source random(11);
  for (support::repeat trial(200); trial.again();) {
    const rational y(random.between(900, 1100), 1000);
    const rational z(random.between(900, 1100), 1000);
    const ball wide_y = hull(ball(rational(9, 10), 64), ball(rational(11, 10), 64));
    const ball ratio = hull(ball(0, 64), ball(rational(2, 11), 64));
    EXPECT_TRUE(meet(complete_rd(wide_y, wide_y, ratio), rd(y, z, 200))) << y << " " << z;
  }
}

TEST(CompleteRd, HoldsBothOrdersOfBallsWhoseOrderIsOpen) {
  // Nearly all members have y > z, where the formula for y <= z alone would be wrong; and the other
  // way round.
  const ball one = hull(ball(1, 64), ball(rational(10'001, 10'000), 64));
  const ball more = hull(ball(1, 64), ball(rational(3, 2), 64));
  const ball ratio = hull(ball(0, 64), ball(rational(1, 3), 64));
  EXPECT_TRUE(meet(complete_rd(more, one, ratio), rd(rational(3, 2), 1, 200)));
  EXPECT_TRUE(meet(complete_rd(one, more, ratio), rd(1, rational(3, 2), 200)));
}

TEST(CompleteRd, IsUndefinedOutsideItsHypotheses) {
  const ball one(1, 64);
  const ball zero(0, 64);
  EXPECT_TRUE(complete_rd(zero, one, one).is_undefined());
  EXPECT_TRUE(complete_rd(one, zero, one).is_undefined());
  EXPECT_TRUE(complete_rd(ball(-1, 64), one, zero).is_undefined());
  EXPECT_TRUE(complete_rd(one, ball::undefined(64), zero).is_undefined());
  EXPECT_TRUE(complete_rd(one, one, ball::undefined(64)).is_undefined());
  EXPECT_TRUE(complete_rd(ball(2, 64), one, ball(rational(1, 3), 64)).is_undefined());
}

// ---------------------------------------------------------------------------------------------
// The slope of the arithmetic-geometric mean

TEST(AgmSlope, IsAHalfWhereBothNumbersAreEqual) {
  for (const rational& x : {rational(1), rational(3, 7), rational(1, integer(1) << 400U)}) {
    const ball slope = agm_slope(ball(x, 100), ball(x, 100));
    EXPECT_TRUE(contains(slope, rational(1, 2))) << x;
    EXPECT_TRUE(as_narrow_as(slope, 90)) << x;
  }
}

// As the mean is concave, its slope between y and y + h lies between the slopes at both, which it
// is as near to as h is small.
TEST(AgmSlope, IsTheLimitOfTheMeansQuotients) {
  support::random_source random(88);
  constexpr precision p = 400;
  for (support::repeat trial(300); trial.again();) {
    const rational x(random.between(1, 1000), random.between(1, 1000));
    const rational y = random.one_in(4) ? x : rational(random.between(1, 1000), 7);
    const rational h = y / (integer(1) << static_cast<unsigned>(random.between(2, 100)));
    const ball quotient =
        (agm(ball(x, p), ball(y + h, p)) - agm(ball(x, p), ball(y, p))) / ball(h, p);
    const ball at_y = agm_slope(ball(x, p), ball(y, p));
    const ball beyond = agm_slope(ball(x, p), ball(rational(y + h), p));
    EXPECT_TRUE(certainly_less(beyond, quotient)) << x << " " << y << " " << h;
    EXPECT_TRUE(certainly_less(quotient, at_y)) << x << " " << y << " " << h;
    // M = x M_x + y M_y: it is homogeneous.
    const ball mean = x * agm_slope(ball(y, p), ball(x, p)) + y * at_y;
    EXPECT_TRUE(overlaps(mean, agm(ball(x, p), ball(y, p)))) << x << " " << y;
    EXPECT_TRUE(as_narrow_as(at_y, p - 30)) << x << " " << y;
  }
}

TEST(AgmSlope, OfSetsHoldsTheSlopesOfTheirMembersAndEndsThere) {
  support::random_source random(89);
  constexpr precision p = 120;
  for (support::repeat trial(200); trial.again();) {
    const auto any = [&] { return rational(random.between(1, 1000), random.between(1, 30)); };
    std::array<rational, 4> e = {any(), any(), any(), any()};
    if (e[1] < e[0]) std::swap(e[0], e[1]);
    if (e[3] < e[2]) std::swap(e[2], e[3]);
    const auto at = [&](const rational& x, const rational& y) {
      return agm_slope(ball(x, p), ball(y, p));
    };
    const ball over =
        agm_slope(hull(ball(e[0], p), ball(e[1], p)), hull(ball(e[2], p), ball(e[3], p)));
    const rational share(random.between(0, 64), 64);
    EXPECT_TRUE(contains(over, at(e[0] + share * (e[1] - e[0]), e[2] + share * (e[3] - e[2]))));
    EXPECT_TRUE(contains(over, at(e[0] + share * (e[1] - e[0]), e[3] - share * (e[3] - e[2]))));
    const magnitude rounding = magnitude::power_of_two(-100);
    EXPECT_TRUE(overlaps(ball(lower(over)), at(e[0], e[3]).enlarged(rounding)));
    EXPECT_TRUE(overlaps(ball(upper(over)), at(e[1], e[2]).enlarged(rounding)));
  }
}

TEST(AgmSlope, IsUndefinedWhereANumberMayNotBePositive) {
  const ball one(1, 64);
  EXPECT_TRUE(agm_slope(ball(0, 64), one).is_undefined());
  EXPECT_TRUE(agm_slope(one, hull(ball(0, 64), one)).is_undefined());
  EXPECT_TRUE(agm_slope(one, ball(-1, 64)).is_undefined());
  EXPECT_TRUE(agm_slope(ball::undefined(64), one).is_undefined());
}

}  // namespace complete_test
}  // namespace polhode
