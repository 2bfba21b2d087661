// Legendre's integrals: values from elsewhere, the integrals that define them, identities and
// limits.

#include "polhode/elliptic/legendre.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_d.hpp>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/scalar.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

#ifdef POLHODE_HAVE_ARB
#include <acb_elliptic.h>
#endif

namespace polhode {
namespace legendre_test {

using support::agrees;
using support::as_narrow_as;
using support::meet;
using support::power_of_ten;
using support::power_of_two;
using parameter = elliptic_parameter<ball>;

constexpr precision precisions[] = {53, 128, 230, 400, 900, 2200};

parameter by_complement(const rational& m1, precision p) {
  return parameter::with_complement(ball(m1, p));
}

struct reference {
  std::string_view n, phi, m, f, e, pi;
};
// mpmath 1.3.0 at 60 digits: ellipf, ellipe, ellippi.
constexpr reference references[] = {
    {"0.5", "1.0", "0.25", "1.03735612000217729162882159569979407853096379",
     "0.96487645426862748545887862567850219157220219",
     "1.22801441431622064261129894629386548780702533"},
    {"-3.0", "1.25", "0.5", "1.40769884155563328783170440367790260995106066",
     "1.1200505129716239227465808413496485827256639",
     "0.761500459350040664932379000227287465080963596"},
    {"0.875", "1.5", "0.9375", "2.52145094877293155541687801616371454880978949",
     "1.05438451810383832359222658631602488521073105",
     "8.80167935976165377861903729264149258485949923"},
    {"0.25", "10.0", "0.75", "13.5392090006228737484624811206409552329969182",
     "7.81846813407906008218999107903391615822177015",
     "15.9271730764310713317471417339189323715039606"},
    {"0.5", "-2.5", "-3.0", "-1.59909045962801274990795586308484954181944243",
     "-4.09589793554308169458528152514575157300022244",
     "-2.2869562498425396626322588082965880716126001"},
    {"-1000.0", "0.5", "0.875", "0.519155370117719333409100421688149695548607179",
     "0.482087204598712437688660581994355222312043256",
     "0.0480319017990069786864332269362954148522137326"},
    {"0.5", "0.25", "4.0", "0.261624740315344006741305951385065472239865542",
     "0.239295761817418877261528487436957772591223388",
     "0.26446931022259504982989789604953270930068879"},
};

TEST(Legendre, HasTheValuesOfMpmath) {
  for (const reference& r : references) {
    for (const precision p : precisions) {
      const ball n = parse_ball(r.n, p);
      const ball phi = parse_ball(r.phi, p);
      const ball m = parse_ball(r.m, p);
      const long digits = std::min(42L, (p - 5) * 3 / 10);
      EXPECT_TRUE(agrees(elliptic_f(phi, m), r.f, digits)) << r.phi << " " << r.m << " " << p;
      EXPECT_TRUE(agrees(elliptic_e(phi, m), r.e, digits)) << r.phi << " " << r.m << " " << p;
      EXPECT_TRUE(agrees(elliptic_pi(n, phi, m), r.pi, digits))
          << r.n << " " << r.phi << " " << r.m << " " << p;
      // The same numbers by their complements.
      const parameter other = by_complement(rational(1 - parse_rational(r.m)), p);
      EXPECT_TRUE(agrees(elliptic_pi(n, phi, other), r.pi, digits));
    }
  }
}

TEST(Legendre, IsTheIntegralOfItsDefinition) {
  support::random_source random(21);
  for (support::repeat trial(8); trial.again();) {
    const rational m(random.between(-300, 99), 100);
    const rational n(random.between(-900, 99), 100);
    const rational phi(random.between(-500, 500), 100);
    const auto over = [&](const auto& f) {
      const integral i = integrate(f, 0, phi, {.digits = 30});
      EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
      return i.enclosure;
    };
    const ball f = over([&](const auto& t) { return 1 / sqrt(1 - m * square(sin(t))); });
    const ball e = over([&](const auto& t) { return sqrt(1 - m * square(sin(t))); });
    const ball third = over([&](const auto& t) {
      return 1 / ((1 - n * square(sin(t))) * sqrt(1 - m * square(sin(t))));
    });
    for (const precision p : {110L, 420L}) {
      const ball a(phi, p);
      const ball k(m, p);
      EXPECT_TRUE(meet(elliptic_f(a, k), f)) << phi << " " << m;
      EXPECT_TRUE(meet(elliptic_e(a, k), e)) << phi << " " << m;
      EXPECT_TRUE(meet(elliptic_pi(ball(n, p), a, k), third)) << n << " " << phi << " " << m;
      EXPECT_TRUE(as_narrow_as(elliptic_pi(ball(n, p), a, k), p - 12))
          << n << " " << phi << " " << m;
      EXPECT_TRUE(meet(k * elliptic_d(a, k), f - e));
    }
  }
}

TEST(Legendre, SatisfiesItsIdentities) {
  support::random_source random(22);
  for (support::repeat trial(30); trial.again();) {
    const precision p = random.choose(precisions);
    rational m(random.between(1, 999), 1000);
    if (random.one_in(4)) m = power_of_two(-random.between(1, 90));
    const parameter k(ball(m, p));
    const parameter other = by_complement(m, p);
    const ball K = elliptic_k(k);
    const ball E = elliptic_e(k);
    // A. M. Legendre's relation.
    EXPECT_TRUE(
        meet(E * elliptic_k(other) + elliptic_e(other) * K - K * elliptic_k(other), pi(p) / 2))
        << m;
    EXPECT_TRUE(meet(K - E, k.m() * elliptic_d(k)));
    EXPECT_TRUE(as_narrow_as(K, p - 4));
    EXPECT_TRUE(as_narrow_as(E, p - 4));
    // Periods.
    const rational phi(random.between(1, 150), 100);
    const ball a(phi, p);
    const ball beyond = ball(phi, p + 40) + 3 * pi(p + 40);
    EXPECT_TRUE(meet(elliptic_f(beyond, k), elliptic_f(a, k) + 6 * K));
    EXPECT_TRUE(meet(elliptic_e(beyond, k), elliptic_e(a, k) + 6 * E));
    EXPECT_TRUE(meet(elliptic_f(-a, k), -elliptic_f(a, k)));
    // n = m (DLMF 19.6.13), n = 0, and Pi(n) against cel (19.2(iii)).
    const ball s = sin(a);
    const ball delta = sqrt(1 - k.m() * square(s));
    EXPECT_TRUE(
        meet(elliptic_pi(k.m(), a, k), (elliptic_e(a, k) - k.m() * s * cos(a) / delta) / k.m1()))
        << phi << " " << m << " " << p;
    EXPECT_TRUE(meet(elliptic_pi(ball(0, p), a, k), elliptic_f(a, k)));
    const ball n(rational(random.between(-4000, 990), 1000), p);
    const ball kc = sqrt(k.m1());
    EXPECT_TRUE(meet(elliptic_pi(n, k), bulirsch_cel(kc, 1 - n, ball(1, p), ball(1, p))));
    EXPECT_TRUE(meet(E, bulirsch_cel(kc, ball(1, p), ball(1, p), k.m1())));
    EXPECT_TRUE(meet(elliptic_d(k), bulirsch_cel(kc, ball(1, p), ball(0, p), ball(1, p))));
    // The complete integral of the third kind and its other one (DLMF 19.7.8-9): n n' = m.
    const ball q = k.m() / n;
    if (certainly_negative(n)) {
      EXPECT_TRUE(
          meet(elliptic_pi(n, k) + elliptic_pi(q, k), K + pi(p) / 2 / sqrt((1 - n) * (1 - q))))
          << n << m;
    }
    // n > 1: the principal value, Pi(n) + Pi(m/n) = K (19.7.9).
    const ball above(rational(random.between(1001, 9000), 1000), p);
    EXPECT_TRUE(meet(elliptic_pi(above, k) + elliptic_pi(k.m() / above, k), K)) << above << m;
    // Addition of F (DLMF 19.11.1): tan(theta/2)-free form with sin theta.
    const ball b(rational(random.between(1, 40), 100), p);
    const ball c(rational(random.between(1, 60), 100), p);
    const ball sb = sin(b);
    const ball sc = sin(c);
    const ball db = sqrt(1 - k.m() * square(sb));
    const ball dc = sqrt(1 - k.m() * square(sc));
    const ball sum = (sb * cos(c) * dc + sc * cos(b) * db) / (1 - k.m() * square(sb) * square(sc));
    EXPECT_TRUE(meet(elliptic_f(b, k) + elliptic_f(c, k), elliptic_f(asin(sum), k)));
  }
}

TEST(Legendre, LosesNothingAtTheEnds) {
  for (const precision p : {64L, 333L}) {
    const rational m1 = power_of_ten(-300);
    const parameter near_one = by_complement(m1, p);
    // mpmath at 700 digits, as in complete_test.cpp.
    EXPECT_TRUE(agrees(elliptic_k(near_one),
                       "346.774058310226743221533182445570984276316223563036456913241",
                       std::min(56L, p * 3 / 10 - 1)));
    EXPECT_TRUE(as_narrow_as(elliptic_e(near_one), p - 4));
    EXPECT_TRUE(as_narrow_as(elliptic_pi(ball(-2, p), near_one), p - 4));
    // phi near pi/2: F(pi/2 - h | m) = K - F(psi | m), tan psi = tan h / sqrt m1 (DLMF 19.11.8 with
    // K).
    const ball h(power_of_ten(-20), p + 80);
    const parameter m(ball(rational(3, 4), p + 80));
    const ball near_quarter = pi(p + 80) / 2 - h;
    const ball psi = atan(tan(h) / sqrt(m.m1()));
    EXPECT_TRUE(meet(elliptic_f(near_quarter, m), elliptic_k(m) - elliptic_f(psi, m)));
    EXPECT_TRUE(meet(elliptic_f(pi(p + 80) / 2 + h, m), elliptic_k(m) + elliptic_f(psi, m)));
    // An amplitude that holds pi/2 inside.
    const ball around = pi(p) / 2;
    EXPECT_TRUE(meet(elliptic_f(around, m), elliptic_k(m)));
    EXPECT_TRUE(as_narrow_as(elliptic_f(around, m), p - 6));
    EXPECT_TRUE(meet(elliptic_pi(ball(rational(9, 10), p), around, m),
                     elliptic_pi(ball(rational(9, 10), p), m)));
    // m = 1: F = artanh(sin phi), E = sin phi; the whole of it is not defined.
    const parameter one(ball(1, p));
    const ball a(rational(5, 4), p);
    EXPECT_TRUE(meet(elliptic_f(a, one), atanh(sin(a))));
    EXPECT_TRUE(meet(elliptic_e(a, one), sin(a)));
    EXPECT_TRUE(meet(elliptic_e(one), ball(1, p)));
    EXPECT_TRUE(elliptic_k(one).is_undefined());
    EXPECT_TRUE(elliptic_f(ball(2, p), one).is_undefined());
    // m = 0.
    const parameter zero(ball(0, p));
    EXPECT_TRUE(meet(elliptic_f(ball(7, p), zero), ball(7, p)));
    EXPECT_TRUE(meet(elliptic_k(zero), pi(p) / 2));
    EXPECT_TRUE(meet(elliptic_pi(ball(rational(1, 2), p), zero), pi(p) / 2 * sqrt(ball(2, p))));
    // n -> 1 from both sides, and n -> -oo.
    EXPECT_TRUE(as_narrow_as(elliptic_pi(ball(rational(1 - m1), p + 1100), ball(1, p),
                                         parameter(ball(rational(1, 2), p))),
                             p - 4));
    EXPECT_TRUE(as_narrow_as(
        elliptic_pi(ball(rational(-1 / m1), p), a, parameter(ball(rational(1, 2), p))), p - 6));
    EXPECT_TRUE(as_narrow_as(
        elliptic_pi(ball(rational(-1 / m1), p), parameter(ball(rational(1, 2), p))), p - 6));
    // Far amplitudes, reduced exactly: (F(phi) - F(phi - 2 k pi))/(4 K) is the whole number k.
    const rational far = power_of_ten(30);
    const ball turns = floor((ball(far, p + 200) / (2 * pi(p + 200))).middle());
    const ball rest = ball(far, p + 200) - 2 * turns * pi(p + 200);
    EXPECT_TRUE(
        meet(elliptic_f(ball(far, p + 200), m), 4 * turns * elliptic_k(m) + elliptic_f(rest, m)));
    EXPECT_TRUE(
        as_narrow_as(elliptic_f(ball(far, p + 200), parameter(ball(rational(3, 4), p))), p));
    EXPECT_TRUE(elliptic_f(ball(0, p), m).is_exact() ||
                elliptic_f(ball(0, p), m).radius().is_zero());
  }
}

TEST(Legendre, HoldsEveryMemberOfABox) {
  support::random_source random(23);
  const precision p = 90;
  for (support::repeat trial(40); trial.again();) {
    std::array<rational, 3> low{rational(random.between(-200, 60), 100),
                                rational(random.between(-300, 300), 100),
                                rational(random.between(-200, 60), 100)};
    std::array<ball, 3> box;
    std::array<ball, 3> member;
    for (std::size_t i = 0; i < 3; ++i) {
      const rational width = rational(3, 10) * power_of_two(-random.between(0, 80));
      box[i] = hull(ball(low[i], p), ball(rational(low[i] + width), p));
      member[i] = ball(rational(low[i] + width * rational(random.between(0, 8), 8)), 200);
    }
    EXPECT_TRUE(
        meet(elliptic_pi(box[0], box[1], box[2]), elliptic_pi(member[0], member[1], member[2])));
    EXPECT_TRUE(meet(elliptic_f(box[1], box[2]), elliptic_f(member[1], member[2])));
    EXPECT_TRUE(meet(elliptic_e(box[1], box[2]), elliptic_e(member[1], member[2])));
    EXPECT_TRUE(meet(elliptic_d(box[1], box[2]), elliptic_d(member[1], member[2])));
    EXPECT_TRUE(meet(elliptic_pi(box[0], box[2]), elliptic_pi(member[0], member[2])));
    EXPECT_TRUE(meet(elliptic_k(box[2]), elliptic_k(member[2])));
    EXPECT_TRUE(meet(elliptic_e(box[2]), elliptic_e(member[2])));
    const parameter turned = parameter::with_complement(1 - box[2]);
    EXPECT_TRUE(meet(elliptic_f(box[1], turned), elliptic_f(member[1], member[2])));
    EXPECT_TRUE(meet(elliptic_pi(box[0] + 4, box[2]), elliptic_pi(member[0] + 4, member[2])));
  }
}

// By one value and a bound of the slope, which is nearly attained at both ends.
TEST(Legendre, NarrowRangesOfKHoldTheirEndsAndLittleMore) {
  support::random_source random(27);
  for (support::repeat trial(300); trial.again();) {
    const rational middle(random.between(1, 983), 1000);
    const long bits = random.between(18, 90);
    const rational radius = power_of_two(-bits);
    const bool by_m1 = random.one_in(2);
    const precision p = 128;
    const ball given = ball(by_m1 ? rational(1 - middle) : middle, 2 * p)
                           .with_precision(p)
                           .enlarged(magnitude::power_of_two(-bits));
    const ball k = elliptic_k(by_m1 ? parameter::with_complement(given) : parameter(given));
    const ball low = elliptic_k(ball(rational(middle - radius), 4 * p));
    const ball high = elliptic_k(ball(rational(middle + radius), 4 * p));
    EXPECT_TRUE(contains(k, low) && contains(k, high)) << middle << ' ' << bits;
    const ball width = ball(upper(k)) - ball(lower(k));
    EXPECT_TRUE(certainly_less(width, (high - low) * ball(rational(113, 100), p) + scale(k, 4 - p)))
        << middle << ' ' << bits;
  }
}

TEST(Legendre, HasItsDerivatives) {
  support::random_source random(24);
  const precision p = 300;
  const rational h = power_of_two(-40);
  const ball step(h, p);
  for (support::repeat trial(15); trial.again();) {
    const rational n(random.between(-300, 95), 101);
    const rational phi(random.between(-450, 450), 103);
    const rational m(random.between(-300, 95), 99);
    const auto check = [&](const ball& first, const ball& last, const ball& slope,
                           const char* name) {
      EXPECT_TRUE(meet((last - first) / step, slope)) << name << " " << n << " " << phi << " " << m;
      EXPECT_TRUE(as_narrow_as(slope, 10)) << name << " " << n << " " << phi << " " << m;
    };
    const auto number = [&](const rational& x) { return ball(x, p); };
    const auto later = [&](const rational& x) { return ball(rational(x + h), p); };
    const auto over = [&](const rational& x) { return hull(number(x), later(x)); };
    check(elliptic_k(number(m)), elliptic_k(later(m)), elliptic_k_derivative(over(m)), "K");
    check(elliptic_e(number(m)), elliptic_e(later(m)), elliptic_e_derivative(over(m)), "E");
    check(elliptic_f(number(phi), number(m)), elliptic_f(later(phi), number(m)),
          elliptic_f_gradient(over(phi), number(m))[0], "F, phi");
    check(elliptic_f(number(phi), number(m)), elliptic_f(number(phi), later(m)),
          elliptic_f_gradient(number(phi), over(m))[1], "F, m");
    check(elliptic_e(number(phi), number(m)), elliptic_e(later(phi), number(m)),
          elliptic_e_gradient(over(phi), number(m))[0], "E, phi");
    check(elliptic_e(number(phi), number(m)), elliptic_e(number(phi), later(m)),
          elliptic_e_gradient(number(phi), over(m))[1], "E, m");
    check(elliptic_pi(number(n), number(m)), elliptic_pi(later(n), number(m)),
          elliptic_pi_gradient(over(n), number(m))[0], "Pi, n");
    check(elliptic_pi(number(n), number(m)), elliptic_pi(number(n), later(m)),
          elliptic_pi_gradient(number(n), over(m))[1], "Pi, m");
    const auto third = [](const ball& a, const ball& b, const ball& c) {
      return elliptic_pi(a, b, c);
    };
    const auto slopes = [](const ball& a, const ball& b, const ball& c) {
      return elliptic_pi_gradient(a, b, c);
    };
    const ball value = third(number(n), number(phi), number(m));
    check(value, third(later(n), number(phi), number(m)),
          slopes(over(n), number(phi), number(m))[0], "Pi(phi), n");
    check(value, third(number(n), later(phi), number(m)),
          slopes(number(n), over(phi), number(m))[1], "Pi(phi), phi");
    check(value, third(number(n), number(phi), later(m)),
          slopes(number(n), number(phi), over(m))[2], "Pi(phi), m");
  }
}

TEST(Legendre, AgreesWithBoostInDouble) {
  support::random_source random(25);
  for (support::repeat trial(200); trial.again();) {
    const double m = std::ldexp(static_cast<double>(random.between(1, (1 << 20) - 1)), -20);
    const double k = std::sqrt(m);
    const double phi = std::ldexp(static_cast<double>(random.between(-(1L << 24), 1L << 24)), -22);
    const double n =
        std::ldexp(static_cast<double>(random.between(-(1L << 22), (1L << 20) - 1)), -20);
    const auto exactly = [](double x) { return ball::exactly(x, 100); };
    const auto check = [&](double ours, double boosts, const ball& certified, const char* name) {
      const double near = mpfr_get_d(midpoint(certified).backend().data(), MPFR_RNDN);
      EXPECT_LE(std::abs(ours - near), 2 * std::abs(std::nextafter(near, HUGE_VAL) - near))
          << name << " " << n << " " << phi << " " << m;
      EXPECT_LE(std::abs(ours - boosts), 1e-10 * (1 + std::abs(near)))
          << name << " " << n << " " << phi << " " << m;
    };
    check(elliptic_k(m), boost::math::ellint_1(k), elliptic_k(exactly(m)), "K");
    check(elliptic_e(m), boost::math::ellint_2(k), elliptic_e(exactly(m)), "E");
    check(elliptic_d(m), boost::math::ellint_d(k), elliptic_d(exactly(m)), "D");
    check(elliptic_pi(n, m), boost::math::ellint_3(k, n), elliptic_pi(exactly(n), exactly(m)),
          "Pi");
    check(elliptic_f(phi, m), boost::math::ellint_1(k, phi), elliptic_f(exactly(phi), exactly(m)),
          "F");
    check(elliptic_e(phi, m), boost::math::ellint_2(k, phi), elliptic_e(exactly(phi), exactly(m)),
          "E(phi)");
    check(elliptic_pi(n, phi, m), boost::math::ellint_3(k, n, phi),
          elliptic_pi(exactly(n), exactly(phi), exactly(m)), "Pi(phi)");
  }
  // Far amplitudes too.
  const double far = 1e30;
  const ball certified = elliptic_f(ball::exactly(far, 100), parameter(ball(rational(1, 2), 100)));
  EXPECT_TRUE(overlaps(
      ball::exactly(elliptic_f(far, 0.5), 100).enlarged(scale(certified.magnitude_upper(), -52)),
      certified));
}

TEST(Legendre, HasUncertifiedValuesFromTheSameTemplates) {
  for (const precision p : precisions) {
    const auto number = [p](const rational& x) { return scalar_from<mpfr_float>(x, p); };
    const rational half(1, 2);
    const auto near = [p](const mpfr_float& x, const ball& certified) {
      EXPECT_TRUE(overlaps(ball(x).enlarged(scale(certified.magnitude_upper(), 4 - p)), certified))
          << p;
    };
    near(elliptic_k(number(half)), elliptic_k(ball(half, p)));
    near(elliptic_e(number(half)), elliptic_e(ball(half, p)));
    near(elliptic_f(number(10), number(half)), elliptic_f(ball(10, p), ball(half, p)));
    near(elliptic_pi(number(-3), number(1), number(half)),
         elliptic_pi(ball(-3, p), ball(1, p), ball(half, p)));
    near(elliptic_pi(number(half), number(5), number(half)),
         elliptic_pi(ball(half, p), ball(5, p), ball(half, p)));
  }
}

#ifdef POLHODE_HAVE_ARB
TEST(Legendre, AgreesWithArb) {
  support::random_source random(26);
  for (support::repeat trial(30); trial.again();) {
    const precision p = random.choose(precisions);
    const long m = random.between(-300, 250);
    const long n = random.between(-900, 250);
    const long phi = random.between(-1500, 1500);
    acb_t x[3];
    acb_t value;
    acb_init(value);
    for (auto& number : x) acb_init(number);
    const auto set = [](acb_t z, long numerator) {
      acb_set_si(z, numerator);
      acb_mul_2exp_si(z, z, -8);
    };
    set(x[0], n);
    set(x[1], phi);
    set(x[2], m);
    const auto theirs = [&] {
      detail::mpfr_cell low(p);
      detail::mpfr_cell high(p);
      arb_get_interval_mpfr(low.get(), high.get(), acb_realref(value));
      return ball::from_end_points(low.get(), high.get(), p);
    };
    const auto ours = [p](long numerator) { return scale(ball(numerator, p), -8); };
    acb_elliptic_f(value, x[1], x[2], 0, p);
    EXPECT_TRUE(meet(theirs(), elliptic_f(ours(phi), ours(m))));
    acb_elliptic_e_inc(value, x[1], x[2], 0, p);
    EXPECT_TRUE(meet(theirs(), elliptic_e(ours(phi), ours(m))));
    acb_elliptic_pi_inc(value, x[0], x[1], x[2], 0, p);
    EXPECT_TRUE(meet(theirs(), elliptic_pi(ours(n), ours(phi), ours(m))));
    acb_elliptic_pi(value, x[0], x[2], p);
    EXPECT_TRUE(meet(theirs(), elliptic_pi(ours(n), ours(m))));
    for (auto& number : x) acb_clear(number);
    acb_clear(value);
  }
}
#endif

TEST(Legendre, IsUndefinedOutsideItsDomain) {
  const ball two(2, 64);
  const ball one(1, 64);
  const ball half(rational(1, 2), 64);
  EXPECT_TRUE(elliptic_k(two).is_undefined());
  EXPECT_TRUE(elliptic_e(two).is_undefined());
  EXPECT_TRUE(elliptic_k(ball::undefined(64)).is_undefined());
  EXPECT_TRUE(elliptic_f(one, two).is_undefined());
  EXPECT_TRUE(elliptic_pi(one, half).is_undefined());
  EXPECT_TRUE(elliptic_pi(hull(half, two), half).is_undefined());
  EXPECT_TRUE(elliptic_pi(one / square(sin(half)), half, half).is_undefined());
  EXPECT_TRUE(bulirsch_cel(ball(0, 64), one, one, one).is_undefined());
  EXPECT_TRUE(bulirsch_cel(one, ball(0, 64), one, one).is_undefined());
  EXPECT_TRUE(std::isnan(elliptic_k(2.0)));
  EXPECT_TRUE(std::isnan(elliptic_f(1.0, 2.0)));
  EXPECT_TRUE(std::isnan(elliptic_f(std::nan(""), 0.5)));
  EXPECT_TRUE(std::isnan(elliptic_f(HUGE_VAL, 0.5)));
}

}  // namespace legendre_test
}  // namespace polhode
