// Carlson's integrals: published values, identities, the integrals that define them, and other
// libraries.

#include "polhode/elliptic/carlson.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_rc.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rg.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/scalar.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

#ifdef POLHODE_HAVE_ARB
#include <acb_elliptic.h>
#endif

namespace polhode {
namespace carlson_test {

using support::agrees;
using support::as_narrow_as;
using support::meet;
using support::power_of_ten;
using support::power_of_two;

ball at(std::string_view text, precision p) { return parse_ball(text, p); }
ball rf(const rational& x, const rational& y, const rational& z, precision p) {
  return carlson_rf(ball(x, p), ball(y, p), ball(z, p));
}
ball rj(const rational& x, const rational& y, const rational& z, const rational& r, precision p) {
  return carlson_rj(ball(x, p), ball(y, p), ball(z, p), ball(r, p));
}
ball rd(const rational& x, const rational& y, const rational& z, precision p) {
  return carlson_rd(ball(x, p), ball(y, p), ball(z, p));
}

/// Precisions on both sides of the change of method.
constexpr precision precisions[] = {53, 128, 230, 400, 900, 2200};

TEST(Carlson, HasThePublishedValues) {
  // B. C. Carlson, Numer. Algorithms 10 (1995), section 3: the real ones, with all digits printed
  // there.
  for (const precision p : precisions) {
    EXPECT_TRUE(agrees(carlson_rf(at("1", p), at("2", p), at("0", p)), "1.3110287771461", 14));
    EXPECT_TRUE(agrees(carlson_rf(at("0.5", p), at("1", p), at("0", p)), "1.8540746773014", 14));
    EXPECT_TRUE(agrees(carlson_rf(at("2", p), at("3", p), at("4", p)), "0.58408284167715", 14));
    EXPECT_TRUE(agrees(carlson_rc(at("0", p), at("0.25", p)), "3.1415926535898", 14));
    EXPECT_TRUE(agrees(carlson_rc(at("2.25", p), at("2", p)), "0.69314718055995", 14));
    EXPECT_TRUE(agrees(carlson_rc(at("0.25", p), at("-2", p)), "0.23104906018665", 14));
    EXPECT_TRUE(agrees(rj(0, 1, 2, 3, p), "0.77688623778582", 14));
    EXPECT_TRUE(agrees(rj(2, 3, 4, 5, p), "0.14297579667157", 14));
    EXPECT_TRUE(agrees(rj(2, 3, 4, rational(-1, 2), p), "0.24723819703052", 13));
    EXPECT_TRUE(agrees(rj(2, 3, 4, -5, p), "-0.12711230042964", 13));
    EXPECT_TRUE(agrees(rd(0, 2, 1, p), "1.7972103521034", 14));
    EXPECT_TRUE(agrees(rd(2, 3, 4, p), "0.16510527294261", 14));
    EXPECT_TRUE(agrees(carlson_rg(at("0", p), at("16", p), at("16", p)), "3.1415926535898", 14));
    EXPECT_TRUE(agrees(carlson_rg(at("2", p), at("3", p), at("4", p)), "1.7255030280692", 14));
    EXPECT_TRUE(agrees(carlson_rg(at("0", p), at("0.0796", p), at("4", p)), "1.0284758090288", 14));
  }
}

/// (1/2) int_0^oo dt/(sqrt((t+x)(t+y)(t+z)) (t+r)), or without the last factor, by quadrature: on t
/// = v^2 for v <= 1, on t = 1/v^2 beyond.
ball by_quadrature(const rational& x, const rational& y, const rational& z, const rational* r) {
  const auto inner = [&](const auto& v) {
    const auto t = v * v;
    const auto value = v / (sqrt(t + x) * sqrt(t + y) * sqrt(t + z));
    if (r != nullptr) return value / (t + *r);
    return value / (t * 0 + 1);
  };
  const auto outer = [&](const auto& v) {
    const auto t = v * v;
    const auto value = 1 / (sqrt(1 + t * x) * sqrt(1 + t * y) * sqrt(1 + t * z));
    if (r != nullptr) return value * t / (1 + t * *r);
    return value / (t * 0 + 1);
  };
  const integral first = integrate(inner, 0, 1, {.digits = 40});
  const integral second = integrate(outer, 0, 1, {.digits = 40});
  EXPECT_EQ(first.verdict, status::certified) << first.obstacle;
  EXPECT_EQ(second.verdict, status::certified) << second.obstacle;
  return first.enclosure + second.enclosure;
}

TEST(Carlson, IsTheIntegralOfItsDefinition) {
  support::random_source random(11);
  const auto any = [&] { return rational(random.between(1, 400), random.between(30, 90)); };
  for (support::repeat trial(6); trial.again();) {
    const rational x = any();
    const rational y = any();
    const rational z = any();
    const rational r = any();
    for (const precision p : {120L, 420L}) {
      EXPECT_TRUE(meet(rf(x, y, z, p), by_quadrature(x, y, z, nullptr)))
          << x << " " << y << " " << z;
      EXPECT_TRUE(meet(rj(x, y, z, r, p), 3 * by_quadrature(x, y, z, &r)))
          << x << " " << y << " " << z << " " << r;
      EXPECT_TRUE(meet(rd(x, y, z, p), 3 * by_quadrature(x, y, z, &z)));
    }
  }
}

rational any_argument(support::random_source& random) {
  rational x(random.between(1, 9999), random.between(1, 999));
  if (random.one_in(3)) x = x * power_of_two(random.between(-60, 60));
  if (random.one_in(6)) x = rational(random.between(1, 5));
  return x;
}

TEST(Carlson, IsSymmetricHomogeneousAndDuplicates) {
  support::random_source random(12);
  for (support::repeat trial(60); trial.again();) {
    const precision p = random.choose(precisions);
    const rational x = random.one_in(5) ? rational(0) : any_argument(random);
    const rational y = any_argument(random);
    const rational z = any_argument(random);
    const rational r = random.one_in(5) ? y : any_argument(random);
    const ball f = rf(x, y, z, p);
    const ball j = rj(x, y, z, r, p);
    // Close to the last place, for arguments that are balls of rational numbers.
    EXPECT_TRUE(as_narrow_as(f, p - 4)) << x << " " << y << " " << z;
    EXPECT_TRUE(as_narrow_as(j, p - 4)) << x << " " << y << " " << z << " " << r;
    EXPECT_TRUE(meet(f, rf(z, x, y, p)));
    EXPECT_TRUE(meet(j, rj(z, y, x, r, p)));
    const rational s(random.between(1, 99), 7);
    EXPECT_TRUE(meet(sqrt(ball(s, p)) * rf(s * x, s * y, s * z, p), f));
    EXPECT_TRUE(meet(s * sqrt(ball(s, p)) * rj(s * x, s * y, s * z, s * r, p), j));
    // Duplication, DLMF 19.26.18 and 19.26.20, at another precision: maybe by another method.
    const precision q = random.choose(precisions);
    const ball a(x, q);
    const ball b(y, q);
    const ball c(z, q);
    const ball d(r, q);
    const ball lambda = sqrt(a * b) + sqrt(b * c) + sqrt(c * a);
    EXPECT_TRUE(meet(2 * carlson_rf(a + lambda, b + lambda, c + lambda), f));
    const ball alpha = d * (sqrt(a) + sqrt(b) + sqrt(c)) + sqrt(a * b * c);
    const ball beta = sqrt(d) * (d + lambda);
    EXPECT_TRUE(meet(2 * carlson_rj(a + lambda, b + lambda, c + lambda, d + lambda) +
                         3 * carlson_rc(square(alpha), square(beta)),
                     j))
        << x << " " << y << " " << z << " " << r << " " << p << " " << q;
    // R_D in all three places (DLMF 19.21.9) and R_G (19.21.11).
    if (x > 0) {
      const ball sum =
          ball(x, p) * rd(y, z, x, p) + ball(y, p) * rd(z, x, y, p) + ball(z, p) * rd(x, y, z, p);
      EXPECT_TRUE(meet(sum, 3 * f)) << x << " " << y << " " << z;
      const ball g = ball(rational(x * (y + z)), p) * rd(y, z, x, p) +
                     ball(rational(y * (z + x)), p) * rd(z, x, y, p) +
                     ball(rational(z * (x + y)), p) * rd(x, y, z, p);
      EXPECT_TRUE(meet(g / 6, carlson_rg(ball(x, q), ball(y, q), ball(z, q))));
    }
  }
}

TEST(Carlson, HasItsDegenerateLimits) {
  for (const precision p : precisions) {
    const rational x(7, 3);
    const ball b(x, p);
    EXPECT_TRUE(meet(rf(x, x, x, p), 1 / sqrt(b)));
    EXPECT_TRUE(meet(rd(x, x, x, p), 1 / (b * sqrt(b))));
    EXPECT_TRUE(meet(rj(x, x, x, x, p), 1 / (b * sqrt(b))));
    EXPECT_TRUE(meet(carlson_rg(b, b, b), sqrt(b)));
    EXPECT_TRUE(meet(rf(0, x, x, p), pi(p) / (2 * sqrt(b))));
    EXPECT_TRUE(meet(rd(0, x, x, p), 3 * pi(p) / (4 * b * sqrt(b))));
    EXPECT_TRUE(meet(carlson_rg(ball(0, p), ball(0, p), b), sqrt(b) / 2));
    EXPECT_TRUE(meet(carlson_rg(ball(0, p), b, b), pi(p) * sqrt(b) / 4));
    EXPECT_TRUE(meet(rf(x, 5, 5, p), carlson_rc(b, ball(5, p))));
    EXPECT_TRUE(meet(rf(x, x, 5, p), carlson_rc(ball(5, p), b)));
    EXPECT_TRUE(meet(carlson_rc(b, b), 1 / sqrt(b)));
    EXPECT_TRUE(meet(carlson_rc(ball(0, p), b), pi(p) / (2 * sqrt(b))));
    EXPECT_TRUE(meet(rj(x, x, x, 2, p), 3 * (carlson_rc(b, ball(2, p)) - 1 / sqrt(b)) / (b - 2)));
    EXPECT_TRUE(meet(rj(x, x, 4, 4, p), rd(x, x, 4, p)));
    EXPECT_TRUE(meet(rj(1, x, 4, 1, p), rd(x, 4, 1, p)));
    EXPECT_TRUE(meet(rj(1, x, 4, x, p), rd(1, 4, x, p)));
    // Through a coincidence: the values on both sides bound it.
    for (const rational& r : {rational(1), x, rational(4)}) {
      const rational h = power_of_two(-200);
      const ball around = hull(rj(1, x, 4, rational(r - h), p), rj(1, x, 4, rational(r + h), p));
      EXPECT_TRUE(meet(around, rj(1, x, 4, r, p))) << r << " " << p;
      EXPECT_TRUE(as_narrow_as(rj(1, x, 4, rational(r + h), p), p - 4)) << r << " " << p;
    }
    for (const rational& y : {rational(1), rational(4)}) {
      const rational h = power_of_two(-300);
      EXPECT_TRUE(meet(hull(rj(1, rational(y - h), 4, 3, p), rj(1, rational(y + h), 4, 3, p)),
                       rj(1, y, 4, 3, p)));
    }
  }
}

TEST(Carlson, ReachesFarArguments) {
  for (const precision p : {64L, 333L}) {
    const rational tiny = power_of_ten(-1000);
    const rational huge = power_of_ten(1000);
    EXPECT_TRUE(as_narrow_as(rf(tiny, 1, huge, p), p - 4));
    EXPECT_TRUE(as_narrow_as(rj(tiny, 1, huge, 3, p), p - 4));
    EXPECT_TRUE(as_narrow_as(rj(1, 2, 3, huge, p), p - 4));
    EXPECT_TRUE(as_narrow_as(rj(1, 2, 3, tiny, p), p - 4));
    EXPECT_TRUE(as_narrow_as(rd(tiny, huge, 1, p), p - 4));
    const ball root_huge = sqrt(ball(huge, p));
    EXPECT_TRUE(meet(root_huge * rf(huge, 2 * huge, 3 * huge, p), rf(1, 2, 3, p)));
    EXPECT_TRUE(
        meet(rj(tiny, 2 * tiny, 3 * tiny, 4 * tiny, p), huge * root_huge * rj(1, 2, 3, 4, p)));
    // For p -> oo R_J = 3 R_F/p - 3 pi/(2 p^(3/2)) (1 + o(1)) (DLMF 19.27.11): here to 500 digits 3
    // R_F/p.
    EXPECT_TRUE(meet(rj(1, 2, 3, huge, p), 3 * rf(1, 2, 3, p) / ball(huge, p)));
    // Between those of equal arguments, by monotonicity.
    EXPECT_TRUE(meet(hull(rj(1, 1, 1, tiny, p), rj(3, 3, 3, tiny, p)), rj(1, 2, 3, tiny, p)));
  }
}

TEST(Carlson, OfAThirdKindFarAboveTheRest) {
  // p R_J/3 = R_F - (1/2) int_0^oo t/((t+p) s(t)) dt, s^2 = (t+x)(t+y)(t+z). With t^(-1/2) above
  // t/s above t (t+c)^(-3/2), c the greatest of x, y, z, and t+p >= p in the difference of the
  // first and the last, which is 4 sqrt c on the whole, the integral lies between pi/(2 sqrt p) - 2
  // sqrt(c)/p and pi/(2 sqrt p).
  for (const precision p : precisions) {
    for (const long exponent : {30L, 200L, 1000L, 60'000L, 1'000'000L}) {
      const ball far = scale(ball(3, p), exponent);
      for (const std::array<long, 3>& a :
           {std::array<long, 3>{1, 2, 3}, {0, 1, 2}, {5, 5, 7}, {2, 4, 4}, {3, 3, 3}, {0, 6, 6}}) {
        const ball x(a[0], p);
        const ball y(a[1], p);
        const ball z(a[2], p);
        const ball rest = 2 * sqrt(z) / far;
        const ball expected =
            3 * (carlson_rf(x, y, z) - pi(p) / (2 * sqrt(far)) + hull(ball(0, p), rest)) / far;
        const ball value = carlson_rj(x, y, z, far);
        EXPECT_TRUE(meet(value, expected)) << p << ' ' << exponent << ' ' << value;
        EXPECT_TRUE(as_narrow_as(value, p - 3)) << p << ' ' << exponent;
        const auto both = carlson_rf_rj(x, y, z, far);
        EXPECT_TRUE(meet(both.rj, value));
        EXPECT_TRUE(meet(both.rf, carlson_rf(x, y, z)));
      }
    }
  }
  // Squares of squares of such numbers leave the range of exponents.
  const ball tiny = scale(ball(1, 300), -400'000);
  const ball huge = scale(ball(1, 300), 400'000);
  const ball value = carlson_rf(tiny, ball(1, 300), huge);
  // R_F(x, y, z) sqrt z is log(16 z/(sqrt x + sqrt y)^2)/2 but for a part of the order of y/z (DLMF
  // 19.27.1).
  const ball leading = log(16 * huge / square(1 + sqrt(tiny))) / 2;
  EXPECT_TRUE(as_narrow_as(value, 290));
  EXPECT_TRUE(meet(value * sqrt(huge), leading.enlarged(magnitude::power_of_two(-1000))));
}

TEST(Carlson, HoldsEveryMemberOfABox) {
  support::random_source random(13);
  for (support::repeat trial(60); trial.again();) {
    const precision p = 80;
    std::array<ball, 4> box;
    std::array<rational, 4> member;
    for (std::size_t i = 0; i < 4; ++i) {
      const rational low = any_argument(random);
      const rational high = low * (1 + power_of_two(-random.between(0, 79)));
      box[i] = hull(ball(low, p), ball(high, p));
      member[i] = low + (high - low) * rational(random.between(0, 16), 16);
    }
    const auto& [x, y, z, r] = box;
    const auto& [a, b, c, d] = member;
    EXPECT_TRUE(meet(carlson_rf(x, y, z), rf(a, b, c, 200)));
    EXPECT_TRUE(meet(carlson_rj(x, y, z, r), rj(a, b, c, d, 200)));
    EXPECT_TRUE(meet(carlson_rd(x, y, z), rd(a, b, c, 200)));
    EXPECT_TRUE(meet(carlson_rg(x, y, z), carlson_rg(ball(a, 200), ball(b, 200), ball(c, 200))));
    EXPECT_TRUE(meet(carlson_rc(x, y), carlson_rc(ball(a, 200), ball(b, 200))));
    EXPECT_TRUE(meet(carlson_rj(x, y, z, -r), rj(a, b, c, -d, 200)));
    EXPECT_TRUE(meet(carlson_rc(x, -y), carlson_rc(ball(a, 200), -ball(b, 200))));
  }
  // The range itself: R_F(1, 1, [1, 4]) = [R_F(1, 1, 4), 1].
  const ball range = carlson_rf(ball(1, 60), ball(1, 60), hull(ball(1, 60), ball(4, 60)));
  EXPECT_TRUE(contains(range, 1));
  EXPECT_TRUE(range.radius() <= (1 - rf(1, 1, 4, 60)).magnitude_upper());
  // From 0 on.
  EXPECT_TRUE(carlson_rf(hull(ball(0, 60), ball(1, 60)), ball(1, 60), ball(2, 60)).is_bounded());
}

// All arguments times 1 +- r: the widest sets for which one value serves, with 12 bits, where r^2
// is seen beside the rounding.
TEST(Carlson, HoldsBothEndsOfAWidelyScaledBox) {
  for (const precision p : {12L, 13L, 60L}) {
    // 2^(10 - p) is allowed at most, and 1/4.
    const magnitude r = magnitude::power_of_two(10 - p);
    const auto around = [&](long m) {
      return ball(m, p).enlarged(
          multiply_up(r, magnitude::from_integer_up(static_cast<std::uint64_t>(m))));
    };
    const rational width = power_of_two(10 - p);
    for (const rational& factor : {rational(1 - width), rational(1 + width)}) {
      const ball x(factor, 200);
      const ball y(rational(2 * factor), 200);
      const ball z(rational(4 * factor), 200);
      const auto [rf, rj] = carlson_rf_rj(around(1), around(2), around(4), around(2));
      EXPECT_TRUE(contains(carlson_rf(around(1), around(2), around(4)), carlson_rf(x, y, z))) << p;
      EXPECT_TRUE(
          contains(carlson_rj(around(1), around(2), around(4), around(2)), carlson_rj(x, y, z, y)))
          << p;
      EXPECT_TRUE(contains(carlson_rd(around(1), around(2), around(4)), carlson_rd(x, y, z))) << p;
      EXPECT_TRUE(contains(carlson_rg(around(1), around(2), around(4)), carlson_rg(x, y, z))) << p;
      EXPECT_TRUE(contains(rf, carlson_rf(x, y, z))) << p;
      EXPECT_TRUE(contains(rj, carlson_rj(x, y, z, y))) << p;
    }
  }
}

TEST(Carlson, HasItsDerivatives) {
  // A difference quotient is a value of the derivative between.
  const precision p = 300;
  support::random_source random(14);
  for (support::repeat trial(12); trial.again();) {
    std::array<rational, 4> a;
    for (rational& x : a) x = rational(random.between(1, 900), random.between(101, 190));
    const rational h = power_of_two(-40);
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<ball, 4> low;
      std::array<ball, 4> over;
      std::array<ball, 4> high;
      for (std::size_t j = 0; j < 4; ++j) {
        low[j] = ball(a[j], p);
        high[j] = ball(j == i ? rational(a[j] + h) : a[j], p);
        over[j] = hull(low[j], high[j]);
      }
      const ball step(h, p);
      const auto check = [&](const ball& first, const ball& last, const ball& slope,
                             const char* name) {
        EXPECT_TRUE(meet((last - first) / step, slope)) << name << " " << i;
        EXPECT_TRUE(as_narrow_as(slope, 10)) << name << " " << i;
      };
      check(carlson_rj(low[0], low[1], low[2], low[3]),
            carlson_rj(high[0], high[1], high[2], high[3]),
            carlson_rj_gradient(over[0], over[1], over[2], over[3])[i], "RJ");
      if (i == 3) continue;
      check(carlson_rf(low[0], low[1], low[2]), carlson_rf(high[0], high[1], high[2]),
            carlson_rf_gradient(over[0], over[1], over[2])[i], "RF");
      check(carlson_rd(low[0], low[1], low[2]), carlson_rd(high[0], high[1], high[2]),
            carlson_rd_gradient(over[0], over[1], over[2])[i], "RD");
      check(carlson_rg(low[0], low[1], low[2]), carlson_rg(high[0], high[1], high[2]),
            carlson_rg_gradient(over[0], over[1], over[2])[i], "RG");
      if (i == 2) continue;
      check(carlson_rc(low[0], low[1]), carlson_rc(high[0], high[1]),
            carlson_rc_gradient(over[0], over[1])[i], "RC");
      const ball before = i == 1 ? -high[1] : -low[1];
      const ball after = i == 1 ? -low[1] : -high[1];
      check(carlson_rc(low[0], before), carlson_rc(high[0], after),
            carlson_rc_gradient(over[0], -over[1])[i], "RC, principal value");
    }
  }
}

TEST(Carlson, AgreesWithBoostInDouble) {
  support::random_source random(15);
  for (support::repeat trial(300); trial.again();) {
    std::array<double, 4> a{};
    for (double& x : a)
      x = std::ldexp(static_cast<double>(random.between(1, 1 << 30)),
                     static_cast<int>(random.between(-50, -10)));
    if (random.one_in(8)) a[0] = 0;
    const auto exactly = [&](std::size_t i) { return ball::exactly(a[i], 100); };
    // Boost's is near; ours is within 2 units of the last place of the certified one.
    const auto check = [&](double ours, double boosts, const ball& certified, const char* name) {
      const double near = mpfr_get_d(midpoint(certified).backend().data(), MPFR_RNDN);
      EXPECT_LE(std::abs(ours - near), 2 * std::abs(std::nextafter(near, HUGE_VAL) - near)) << name;
      EXPECT_LE(std::abs(ours - boosts), 100 * std::abs(near) * 0x1p-53) << name;
    };
    check(carlson_rf(a[0], a[1], a[2]), boost::math::ellint_rf(a[0], a[1], a[2]),
          carlson_rf(exactly(0), exactly(1), exactly(2)), "RF");
    check(carlson_rd(a[0], a[1], a[2]), boost::math::ellint_rd(a[0], a[1], a[2]),
          carlson_rd(exactly(0), exactly(1), exactly(2)), "RD");
    check(carlson_rj(a[0], a[1], a[2], a[3]), boost::math::ellint_rj(a[0], a[1], a[2], a[3]),
          carlson_rj(exactly(0), exactly(1), exactly(2), exactly(3)), "RJ");
    check(carlson_rc(a[0], a[1]), boost::math::ellint_rc(a[0], a[1]),
          carlson_rc(exactly(0), exactly(1)), "RC");
    check(carlson_rg(a[0], a[1], a[2]), boost::math::ellint_rg(a[0], a[1], a[2]),
          carlson_rg(exactly(0), exactly(1), exactly(2)), "RG");
  }
}

TEST(Carlson, HasUncertifiedValuesFromTheSameTemplates) {
  for (const precision p : precisions) {
    const auto number = [p](long n) { return scalar_from<mpfr_float>(n, p); };
    const auto near = [p](const mpfr_float& x, const ball& certified) {
      EXPECT_EQ(precision_of(x), p);
      EXPECT_TRUE(overlaps(ball(x).enlarged(scale(certified.magnitude_upper(), 4 - p)), certified))
          << p;
    };
    near(carlson_rf(number(2), number(3), number(4)), rf(2, 3, 4, p));
    near(carlson_rj(number(2), number(3), number(4), number(5)), rj(2, 3, 4, 5, p));
    near(carlson_rj(number(2), number(3), number(4), number(-5)), rj(2, 3, 4, -5, p));
    near(carlson_rj(number(2), number(3), number(4), number(1)), rj(2, 3, 4, 1, p));
    near(carlson_rj(number(0), number(3), number(4), number(1)), rj(0, 3, 4, 1, p));
    near(carlson_rd(number(2), number(3), number(4)), rd(2, 3, 4, p));
    near(carlson_rc(number(2), number(-3)), carlson_rc(ball(2, p), ball(-3, p)));
    near(carlson_rg(number(2), number(3), number(4)),
         carlson_rg(ball(2, p), ball(3, p), ball(4, p)));
    EXPECT_TRUE(isnan(carlson_rj(number(2), number(3), number(4), number(0))));
  }
}

#ifdef POLHODE_HAVE_ARB
TEST(Carlson, AgreesWithArb) {
  support::random_source random(16);
  for (support::repeat trial(40); trial.again();) {
    const precision p = random.choose(precisions);
    acb_t x[4];
    acb_t value;
    acb_init(value);
    std::array<rational, 4> a;
    for (std::size_t i = 0; i < 4; ++i) {
      a[i] = rational(random.between(1, 1 << 20), 1 << random.between(0, 30));
      acb_init(x[i]);
      fmpq_t q;
      fmpq_init(q);
      fmpq_set_mpq(q, a[i].backend().data());
      arb_set_fmpq(acb_realref(x[i]), q, p);
      fmpq_clear(q);
    }
    const auto theirs = [&] {
      detail::mpfr_cell low(p);
      detail::mpfr_cell high(p);
      arb_get_interval_mpfr(low.get(), high.get(), acb_realref(value));
      return ball::from_end_points(low.get(), high.get(), p);
    };
    acb_elliptic_rf(value, x[0], x[1], x[2], 0, p);
    EXPECT_TRUE(meet(theirs(), rf(a[0], a[1], a[2], p)));
    acb_elliptic_rj(value, x[0], x[1], x[2], x[3], 0, p);
    EXPECT_TRUE(meet(theirs(), rj(a[0], a[1], a[2], a[3], p)));
    acb_elliptic_rg(value, x[0], x[1], x[2], 0, p);
    EXPECT_TRUE(meet(theirs(), carlson_rg(ball(a[0], p), ball(a[1], p), ball(a[2], p))));
    for (auto& number : x) acb_clear(number);
    acb_clear(value);
  }
}
#endif

TEST(Carlson, IsUndefinedOutsideItsDomain) {
  const ball one(1, 64);
  const ball zero(0, 64);
  const ball around = hull(ball(-1, 64), ball(1, 64));
  EXPECT_TRUE(carlson_rf(zero, zero, one).is_undefined());
  EXPECT_TRUE(carlson_rf(-one, one, one).is_undefined());
  EXPECT_TRUE(carlson_rf(one, around, one).is_undefined());
  EXPECT_TRUE(carlson_rf(one, ball::undefined(64), one).is_undefined());
  EXPECT_TRUE(carlson_rc(one, zero).is_undefined());
  EXPECT_TRUE(carlson_rc(-one, one).is_undefined());
  EXPECT_TRUE(carlson_rc(one, around).is_undefined());
  EXPECT_TRUE(carlson_rj(one, one, one, zero).is_undefined());
  EXPECT_TRUE(carlson_rj(one, one, one, around).is_undefined());
  EXPECT_TRUE(carlson_rj(zero, zero, one, one).is_undefined());
  EXPECT_TRUE(carlson_rd(one, one, zero).is_undefined());
  EXPECT_TRUE(carlson_rd(zero, zero, one).is_undefined());
  EXPECT_TRUE(carlson_rg(-one, one, one).is_undefined());
  EXPECT_TRUE(std::isnan(carlson_rf(0.0, 0.0, 1.0)));
  EXPECT_TRUE(std::isnan(carlson_rf(-1.0, 1.0, 1.0)));
  EXPECT_TRUE(std::isnan(carlson_rf(std::nan(""), 1.0, 1.0)));
  EXPECT_TRUE(std::isnan(carlson_rj(1.0, 1.0, 1.0, 0.0)));
  EXPECT_TRUE(std::isnan(carlson_rd(1.0, 1.0, 0.0)));
}

}  // namespace carlson_test
}  // namespace polhode
