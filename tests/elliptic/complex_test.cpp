// The elliptic functions of complex arguments: published values, the real functions, identities
// between them, containment over sets, what bounds over regions hold, and refusals.

#include "polhode/elliptic/complex.hpp"

#include <gtest/gtest.h>

#include <random>

#include "polhode/elliptic/carlson.hpp"
#include "polhode/elliptic/jacobi.hpp"
#include "polhode/elliptic/legendre.hpp"
#include "polhode/elliptic/theta.hpp"
#include "support/reference.hpp"

#ifdef POLHODE_HAVE_ARB
#include <acb_elliptic.h>
#endif

namespace polhode {
namespace complex_test {

using support::agrees;
using support::meet;

constexpr precision precisions[] = {53, 128, 500};

complex_ball at(const rational& re, const rational& im, precision p) {
  return {ball(re, p), ball(im, p)};
}
::testing::AssertionResult meet(const complex_ball& z, const complex_ball& w) {
  const auto real = support::meet(z.re, w.re);
  return real ? support::meet(z.im, w.im) : real;
}
/// The parts are right to so many bits of the greater one.
bool has_bits(const complex_ball& z, long bits) {
  const magnitude error = max(z.re.radius(), z.im.radius());
  return z.is_bounded() && scale(error, bits) <= z.magnitude_lower();
}

TEST(ComplexElliptic, HasThePublishedValues) {
  // B. C. Carlson, Numer. Algorithms 10 (1995), section 3: the complex ones, with all digits
  // printed there.
  for (const precision p : precisions) {
    const complex_ball zero = at(0, 0, p);
    const complex_ball one = at(1, 0, p);
    const complex_ball i = at(0, 1, p);
    const auto expect = [&](const complex_ball& z, const char* re, const char* im, long digits) {
      EXPECT_TRUE(agrees(z.re, re, digits)) << p;
      EXPECT_TRUE(agrees(z.im, im, digits)) << p;
    };
    expect(carlson_rf(i - 1, i, zero), "0.79612586584234", "-1.2138566698365", 13);
    expect(carlson_rf(i - 1, i, one - i), "0.93912050218619", "-0.53296252018635", 13);
    expect(carlson_rf(zero, i, i), "1.1107207345396", "-1.1107207345396", 13);  // R_C(0, i)
    const complex_ball half = at(rational(1, 2), 0, p);
    EXPECT_TRUE(meet(carlson_rf(half, one, zero).re, elliptic_k(ball(rational(1, 2), p))));
  }
}

struct sampler {
  std::mt19937 random{20240601};
  rational number(long low, long high) {
    std::uniform_int_distribution<long> any(low * 64, high * 64);
    return rational(any(random), 64);
  }
};

TEST(ComplexElliptic, IsTheRealFunctionOnTheRealLine) {
  sampler s;
  for (int trial = 0; trial < 24; ++trial) {
    const precision p = precisions[trial % 3];
    const ball x(s.number(0, 4) + rational(1, 64), p);
    const ball y(s.number(0, 4) + rational(1, 64), p);
    const ball z(s.number(0, 400) + rational(1, 64), p);
    const ball r(s.number(0, 9) + rational(1, 64), p);
    const ball m(s.number(-9, 0) + rational(61, 64), p);
    const ball unit((s.number(0, 1) * 60 + 2) / 64, p);
    const ball n(s.number(-5, 0) + rational(63, 64), p);
    const ball phi(s.number(-6, 6) + rational(1, 128), p);
    const auto c = [](const ball& t) { return complex_ball(t); };
    const auto agree = [&](const complex_ball& value, const ball& expected, const char* name) {
      EXPECT_TRUE(meet(value.re, expected)) << name << ' ' << trial;
      EXPECT_TRUE(contains_zero(value.im)) << name;
      EXPECT_TRUE(has_bits(value, p - 20)) << name << ' ' << trial << ' ' << value.re;
    };
    agree(carlson_rf(c(x), c(y), c(z)), carlson_rf(x, y, z), "R_F");
    agree(carlson_rc(c(x), c(y)), carlson_rc(x, y), "R_C");
    agree(carlson_rj(c(x), c(y), c(z), c(r)), carlson_rj(x, y, z, r), "R_J");
    agree(carlson_rj(c(ball(0, p)), c(y), c(z), c(r)), carlson_rj(ball(0, p), y, z, r), "R_J(0)");
    agree(carlson_rd(c(x), c(y), c(z)), carlson_rd(x, y, z), "R_D");
    agree(carlson_rg(c(x), c(y), c(r)), carlson_rg(x, y, r), "R_G");
    agree(elliptic_k(c(m)), elliptic_k(m), "K");
    agree(elliptic_e(c(m)), elliptic_e(elliptic_parameter<ball>(m)), "E");
    agree(elliptic_d(c(m)), elliptic_d(elliptic_parameter<ball>(m)), "D");
    agree(elliptic_pi(c(n), c(m)), elliptic_pi(n, elliptic_parameter<ball>(m)), "Pi");
    agree(elliptic_f(c(phi), c(m)), elliptic_f(phi, m), "F");
    agree(elliptic_e(c(phi), c(m)), elliptic_e(phi, m), "E(phi)");
    agree(elliptic_d(c(phi), c(m)), elliptic_d(phi, m), "D(phi)");
    agree(elliptic_pi(c(n), c(phi), c(m)), elliptic_pi(n, phi, m), "Pi(phi)");
    agree(elliptic_nome(c(unit)), elliptic_nome(unit), "nome");
    agree(jacobi_am(c(phi), c(unit)), jacobi_am(phi, unit), "am");
    for (int j = 1; j <= 4; ++j) {
      const ball q = unit / 2;
      const theta_values expected = theta(j, phi, q);
      EXPECT_TRUE(meet(theta_value(j, c(phi), c(q)).re, expected.value)) << j;
      EXPECT_TRUE(meet(theta_derivative(j, c(phi), c(q)).re, expected.derivative)) << j;
    }
    const std::array<ball, 3> parameters{unit, -r, 1 + r};
    for (const ball& k : parameters) {
      const auto w = jacobi_elliptic(phi, elliptic_parameter<ball>(k));
      EXPECT_TRUE(meet(jacobi_quotient('s', 'n', c(phi), c(k)).re, w.sn)) << trial;
      EXPECT_TRUE(meet(jacobi_quotient('c', 'n', c(phi), c(k)).re, w.cn)) << trial;
      EXPECT_TRUE(meet(jacobi_quotient('d', 'n', c(phi), c(k)).re, w.dn)) << trial;
      EXPECT_TRUE(meet(jacobi_quotient('c', 'd', c(phi), c(k)).re, w.cn / w.dn)) << trial;
    }
  }
}

TEST(ComplexElliptic, InvertsItself) {
  for (const precision p : precisions) {
    const complex_ball m = at(rational(2, 5), rational(1, 7), p);
    const complex_ball u = at(rational(3, 4), rational(1, 3), p);
    for (const char q : {'s', 'c', 'd', 'n'}) {
      for (const char r : {'s', 'c', 'd', 'n'}) {
        if (q == r) continue;
        const complex_ball value = jacobi_quotient(q, r, u, m);
        EXPECT_TRUE(has_bits(value, p - 20));
        EXPECT_TRUE(meet(jacobi_inverse(q, r, value, m), u)) << q << r;
      }
    }
    // Beyond the middle of [0, 2K].
    const complex_ball far = at(rational(5, 2), rational(1, 3), p);
    for (const char r : {'s', 'd', 'n'}) {
      EXPECT_TRUE(meet(jacobi_inverse('c', r, jacobi_quotient('c', r, far, m), m), far)) << r;
    }
    // F(am u) = u, and am over several periods.
    for (const complex_ball& v : {u, far, -far, 4 * far}) {
      const complex_ball phi = jacobi_am(v, at(rational(2, 5), 0, p));
      EXPECT_TRUE(meet(elliptic_f(phi, at(rational(2, 5), 0, p)), v));
      EXPECT_TRUE(meet(sin(phi), jacobi_quotient('s', 'n', v, at(rational(2, 5), 0, p))));
    }
  }
}

// For x and m anywhere: a value of the inverse function is one of that very x, not of -x.
TEST(ComplexElliptic, InvertsWhatItAnswers) {
  constexpr precision p = 128;
  sampler s;
  int answers = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const complex_ball m = at(s.number(-2, 2), s.number(-2, 2), p);
    const complex_ball x = at(s.number(-2, 2), s.number(-2, 2), p);
    for (const char q : {'s', 'c', 'd', 'n'}) {
      for (const char r : {'s', 'c', 'd', 'n'}) {
        if (q == r) continue;
        const complex_ball u = jacobi_inverse(q, r, x, m);
        if (u.is_undefined()) continue;
        const complex_ball again = jacobi_quotient(q, r, u, m);
        if (again.is_undefined()) continue;
        EXPECT_TRUE(has_bits(again, 40) && meet(again, x)) << q << r << ' ' << x << ' ' << m;
        ++answers;
      }
    }
  }
  EXPECT_GT(answers, 100);
}

TEST(ComplexElliptic, SatisfiesItsIdentities) {
  sampler s;
  for (int trial = 0; trial < 21; ++trial) {
    const precision p = precisions[trial % 3];
    const complex_ball m = at(s.number(-3, 2), s.number(0, 2) + rational(1, 64), p);
    const complex_ball k = elliptic_k(m);
    const complex_ball e = elliptic_e(m);
    EXPECT_TRUE(has_bits(k, p - 16)) << trial;
    EXPECT_TRUE(meet(k - m * elliptic_d(m), e));
    // A. Legendre: E K' + E' K - K K' = pi/2.
    const complex_ball other_k = elliptic_k(1 - m);
    const complex_ball other_e = elliptic_e(1 - m);
    EXPECT_TRUE(meet(e * other_k + other_e * k - k * other_k, complex_ball(pi(p) / 2)));
    // By the other algorithm.
    EXPECT_TRUE(meet(k, carlson_rf(at(0, 0, p), 1 - m, at(1, 0, p))));
    // x R_D(y,z,x) + y R_D(z,x,y) + z R_D(x,y,z) = 3 R_F, and of the third kind at p = x.
    const complex_ball x = at(s.number(0, 3) + rational(1, 64), s.number(-3, 3), p);
    const complex_ball y = at(s.number(0, 3) + rational(1, 64), s.number(-3, 3), p);
    const complex_ball z = at(s.number(0, 3) + rational(1, 64), s.number(-3, 3), p);
    const complex_ball rf = carlson_rf(x, y, z);
    EXPECT_TRUE(has_bits(rf, p - 20)) << trial;
    EXPECT_TRUE(
        meet(x * carlson_rd(y, z, x) + y * carlson_rd(z, x, y) + z * carlson_rd(x, y, z), 3 * rf))
        << trial;
    EXPECT_TRUE(meet(carlson_rj(x, y, z, y), carlson_rd(x, z, y))) << trial;
    EXPECT_TRUE(meet(carlson_rg(x, y, z), carlson_rg(y, z, x))) << trial;
    // R_J(x,y,y,p) = 3 (R_C(x,y) - R_C(x,p))/(p-y) (DLMF 19.20.8).
    EXPECT_TRUE(meet(carlson_rj(x, y, y, z) * (z - y), 3 * (carlson_rc(x, y) - carlson_rc(x, z))))
        << trial;
    // R_C(x,y) cos = sqrt(x/y): sqrt(y) cos(sqrt(y-x) R_C) = sqrt(x), up to the branch of the arc.
    EXPECT_TRUE(meet(square(cos(sqrt(y - x) * carlson_rc(x, y))) * y, x)) << trial;
    // E and F by addition of periods.
    const complex_ball phi = at(s.number(-1, 1), s.number(-1, 1) / 2, p);
    const complex_ball small = at(s.number(-1, 1) / 3, s.number(-1, 1) / 3, p);
    const complex_ball turn = phi + complex_ball(2 * pi(p));
    EXPECT_TRUE(meet(elliptic_f(turn, small), elliptic_f(phi, small) + 4 * elliptic_k(small)));
    EXPECT_TRUE(meet(elliptic_e(turn, small), elliptic_e(phi, small) + 4 * elliptic_e(small)));
    // Where two forms of the incomplete integrals meet: one step to the side changes little.
    const complex_ball below = at(rational(1099, 1000), rational(1, 9), p);
    const complex_ball above = at(rational(1101, 1000), rational(1, 9), p);
    const complex_ball slope =
        1 / sqrt(1 - small * square(sin(at(rational(11, 10), rational(1, 9), p))));
    const complex_ball step = elliptic_f(above, small) - elliptic_f(below, small) - slope / 500;
    EXPECT_TRUE(step.magnitude_upper() <= magnitude::power_of_two(-24));
    const complex_ball n = at(rational(1, 3), rational(1, 4), p);
    const complex_ball third =
        elliptic_pi(n, above, small) - elliptic_pi(n, below, small) -
        slope / (500 * (1 - n * square(sin(at(rational(11, 10), rational(1, 9), p)))));
    EXPECT_TRUE(third.magnitude_upper() <= magnitude::power_of_two(-24));
  }
}

/// The value over a region holds those at points of it.
TEST(ComplexElliptic, HoldsEveryMemberOfARegion) {
  sampler s;
  int available = 0;
  for (int trial = 0; trial < 32; ++trial) {
    const rational width = rational(1, 1L << (trial % 8));
    const auto box = [&](const rational& re, const rational& im) {
      return region(double_interval(hull(double_interval(re), double_interval(re + width))),
                    double_interval(hull(double_interval(im), double_interval(im + width / 2))));
    };
    struct argument {
      rational re, im;
    };
    const auto any = [&](long low, long high) {
      return argument{s.number(low, high), s.number(-1, 1)};
    };
    const auto check = [&](const char* name, const std::vector<argument>& a, const auto& f) {
      std::vector<region> sets;
      for (const argument& x : a) sets.push_back(box(x.re, x.im));
      const region bound = f(sets);
      if (!bound.is_analytic()) return;
      ++available;
      for (int corner = 0; corner < 5; ++corner) {
        std::vector<complex_ball> point;
        for (const argument& x : a) {
          point.push_back(at(x.re + width * rational(corner, 4),
                             x.im + width / 2 * rational((3 * corner) % 5, 4), 100));
        }
        const complex_ball value = f(point);
        ASSERT_FALSE(value.is_undefined()) << name;
        EXPECT_TRUE(meet(bound.to_complex_ball(), value)) << name << ' ' << trial << ' ' << corner;
      }
    };
    check("R_F", {any(0, 3), any(0, 3), any(0, 3)},
          [](const auto& x) { return carlson_rf(x[0], x[1], x[2]); });
    check("R_J", {any(0, 3), any(0, 3), any(0, 3), any(0, 3)},
          [](const auto& x) { return carlson_rj(x[0], x[1], x[2], x[3]); });
    check("R_G", {any(0, 3), any(0, 3), any(0, 3)},
          [](const auto& x) { return carlson_rg(x[0], x[1], x[2]); });
    check("K", {any(-2, 2)}, [](const auto& x) { return elliptic_k(x[0]); });
    check("E", {any(-2, 2)}, [](const auto& x) { return elliptic_e(x[0]); });
    check("F", {any(-4, 4), any(-2, 1)}, [](const auto& x) { return elliptic_f(x[0], x[1]); });
    check("D", {any(-4, 4), any(-2, 1)}, [](const auto& x) { return elliptic_d(x[0], x[1]); });
    check("Pi", {any(-2, 1), any(-4, 4), any(-2, 1)},
          [](const auto& x) { return elliptic_pi(x[0], x[1], x[2]); });
    check("nome", {any(0, 1)}, [](const auto& x) { return elliptic_nome(x[0]); });
    check("am", {any(-4, 4), any(0, 1)}, [](const auto& x) { return jacobi_am(x[0], x[1]); });
    check("sn", {any(-4, 4), any(-1, 2)},
          [](const auto& x) { return jacobi_quotient('s', 'n', x[0], x[1]); });
    check("cd", {any(-4, 4), any(-1, 2)},
          [](const auto& x) { return jacobi_quotient('c', 'd', x[0], x[1]); });
    check("arcsn", {any(-1, 1), any(-1, 1)},
          [](const auto& x) { return jacobi_inverse('s', 'n', x[0], x[1]); });
    check("theta", {any(-4, 4), any(0, 1)},
          [](const auto& x) { return theta_derivative(2, x[0], x[1] / 2); });
  }
  EXPECT_GT(available, 130);
}

// Over regions the series end at some 30 bits: at numbers, which doubles hold exactly, what they
// leave out is far greater than the rounding errors.
TEST(ComplexElliptic, OverPointsTheSeriesHoldWhatTheyLeaveOut) {
  sampler s;
  int available = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const bool is_real = trial % 2 == 0;
    struct argument {
      rational re, im;
    };
    const auto any = [&](long low, long high) {
      return argument{s.number(low, high), is_real ? rational(0) : s.number(-1, 1)};
    };
    const auto check = [&](const char* name, const std::vector<argument>& a, const auto& f) {
      std::vector<region> sets;
      std::vector<complex_ball> numbers;
      for (const argument& x : a) {
        sets.emplace_back(double_interval(x.re), double_interval(x.im));
        numbers.push_back(at(x.re, x.im, 150));
      }
      const region value = f(sets);
      const complex_ball exact = f(numbers);
      if (!value.is_analytic() || exact.is_undefined()) return;
      ++available;
      EXPECT_TRUE(meet(value.to_complex_ball(), exact)) << name << ' ' << trial;
    };
    check("R_F", {any(0, 9), any(0, 3), any(0, 3)},
          [](const auto& x) { return carlson_rf(x[0], x[1], x[2]); });
    check("R_C", {any(1, 3), any(1, 3)}, [](const auto& x) { return carlson_rc(x[0], x[1]); });
    check("R_J", {any(0, 3), any(0, 3), any(0, 3), any(0, 9)},
          [](const auto& x) { return carlson_rj(x[0], x[1], x[2], x[3]); });
    check("K", {any(-2, 1)}, [](const auto& x) { return elliptic_k(x[0]); });
    check("D", {any(-2, 1)}, [](const auto& x) { return elliptic_d(x[0]); });
    check("am", {any(-4, 4), any(0, 1)}, [](const auto& x) { return jacobi_am(x[0], x[1]); });
    // With a nome so small that all of its series is left out.
    check("am", {argument{rational(50 + trial, 64), 0}, argument{rational(1, 1L << 28), 0}},
          [](const auto& x) { return jacobi_am(x[0], x[1]); });
    for (const int j : {1, 2, 3, 4}) {
      const argument z = trial % 3 == 0 ? argument{0, 0} : any(-4, 4);
      const argument q = any(0, 1);
      check("theta", {z, q}, [j](const auto& x) { return theta_value(j, x[0], x[1] / 2); });
      check("theta'", {z, q}, [j](const auto& x) { return theta_derivative(j, x[0], x[1] / 2); });
    }
  }
  EXPECT_GT(available, 400);
}

// The first or the last argument decides how many bits are wanted: where it has few and the others
// many, what the series leave out is far greater than the rounding errors.
TEST(ComplexElliptic, OfFewBitsTheSeriesHoldWhatTheyLeaveOut) {
  sampler s;
  constexpr precision many = 300;
  const auto short_number = [&](precision p) {
    return complex_ball(s.number(1, 4).convert_to<long>() + 1, p);
  };
  for (int trial = 0; trial < 200; ++trial) {
    const complex_ball x = at(s.number(1, 9), s.number(-2, 2), many);
    const complex_ball y = at(s.number(1, 9), trial % 2 == 0 ? 0 : s.number(-2, 2), many);
    const complex_ball z = at(s.number(1, 9), 0, many);
    const precision few = 4 + trial % 20;
    const complex_ball p = short_number(few);
    const complex_ball same = p.with_precision(many);
    EXPECT_TRUE(meet(carlson_rf(p, y, z), carlson_rf(same, y, z))) << few;
    EXPECT_TRUE(meet(carlson_rj(x, y, z, p), carlson_rj(x, y, z, same))) << few;
    EXPECT_TRUE(meet(carlson_rj(p, y, z, p), carlson_rj(same, y, z, same))) << few;
    EXPECT_TRUE(carlson_rj(x, y, z, p).is_bounded());
  }
}

#ifdef POLHODE_HAVE_ARB
TEST(ComplexElliptic, AgreesWithArb) {
  sampler s;
  constexpr precision p = 120;
  for (int trial = 0; trial < 50; ++trial) {
    std::array<rational, 8> q;
    for (rational& x : q) x = s.number(-2, 2);
    std::array<acb_struct, 5> a{};
    for (acb_struct& x : a) acb_init(&x);
    const auto set = [&](std::size_t i, const rational& re, const rational& im) {
      acb_set_d_d(&a[i], re.convert_to<double>(), im.convert_to<double>());
    };
    const auto as_ball = [&](const acb_struct& z) {
      const auto part = [](const arb_struct* x) {
        ball result(0, p);
        mpfr_float low = zero_of_precision(p + 30);
        mpfr_float high = zero_of_precision(p + 30);
        arb_get_interval_mpfr(low.backend().data(), high.backend().data(), x);
        return hull(ball(low), ball(high));
      };
      return complex_ball(part(acb_realref(&z)), part(acb_imagref(&z)));
    };
    const complex_ball x = at(abs(q[0]) + rational(1, 64), q[1], p);
    const complex_ball y = at(abs(q[2]) + rational(1, 64), q[3], p);
    const complex_ball z = at(abs(q[4]) + rational(1, 64), q[5], p);
    const complex_ball r = at(abs(q[6]) + rational(1, 64), q[7], p);
    set(0, abs(q[0]) + rational(1, 64), q[1]);
    set(1, abs(q[2]) + rational(1, 64), q[3]);
    set(2, abs(q[4]) + rational(1, 64), q[5]);
    set(3, abs(q[6]) + rational(1, 64), q[7]);
    acb_elliptic_rf(&a[4], &a[0], &a[1], &a[2], 0, p + 20);
    EXPECT_TRUE(meet(carlson_rf(x, y, z), as_ball(a[4])));
    acb_elliptic_rj(&a[4], &a[0], &a[1], &a[2], &a[3], 0, p + 20);
    EXPECT_TRUE(meet(carlson_rj(x, y, z, r), as_ball(a[4])));
    acb_elliptic_rg(&a[4], &a[0], &a[1], &a[2], 0, p + 20);
    EXPECT_TRUE(meet(carlson_rg(x, y, z), as_ball(a[4])));
    if (q[1] != 0) {
      set(0, q[0], q[1]);
      acb_elliptic_k(&a[4], &a[0], p + 20);
      EXPECT_TRUE(meet(elliptic_k(at(q[0], q[1], p)), as_ball(a[4])));
      acb_elliptic_e(&a[4], &a[0], p + 20);
      EXPECT_TRUE(meet(elliptic_e(at(q[0], q[1], p)), as_ball(a[4])));
    }
    for (acb_struct& v : a) acb_clear(&v);
  }
}
#endif

TEST(ComplexElliptic, RefusesCutsAndWhatItHasNot) {
  const region one(double_interval(1));
  const auto box = [](double a, double b, double c, double d) {
    return region(double_interval(a, b), double_interval(c, d));
  };
  EXPECT_EQ(elliptic_k(box(0.5, 1.5, -0.25, 0.25)).why(), obstacle::branch_cut);
  EXPECT_EQ(elliptic_k(box(0.5, 1.5, -0.25, 0.25)).where(), "ellipticK");
  EXPECT_EQ(elliptic_e(box(2, 3, 0, 1)).why(), obstacle::branch_cut);
  EXPECT_TRUE(elliptic_k(box(2, 2.25, 0.5, 0.75)).is_analytic());
  EXPECT_EQ(carlson_rf(box(-2, -1, -1, 1), one, one).why(), obstacle::branch_cut);
  EXPECT_EQ(carlson_rf(one * 0, one * 0, one).why(), obstacle::unknown);
  EXPECT_EQ(carlson_rj(one, one, one, -one).why(), obstacle::unknown);
  // A pole of nc, where cn(K) = 0.
  EXPECT_FALSE(
      jacobi_quotient('n', 'c', box(1.75, 2, -0.125, 0.125), box(0.5, 0.5, 0, 0)).is_analytic());
  EXPECT_TRUE(
      jacobi_quotient('n', 's', box(1.75, 2, -0.125, 0.125), box(0.5, 0.5, 0, 0)).is_analytic());
  EXPECT_THROW(static_cast<void>(jacobi_quotient('s', 's', one, one)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(jacobi_inverse('a', 'm', one, one)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(theta_value(5, one, one / 2)), std::invalid_argument);
  const complex_ball z(1, 90);
  EXPECT_TRUE(elliptic_k(z).is_undefined());
  EXPECT_TRUE(elliptic_k(2 * z).is_undefined());
  EXPECT_TRUE(carlson_rf(-z, z, z).is_undefined());
  EXPECT_TRUE(theta_value(3, z, z).is_undefined());
  EXPECT_TRUE(elliptic_k(complex_ball::undefined(90)).is_undefined());
}

}  // namespace complex_test
}  // namespace polhode
