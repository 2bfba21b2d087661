// Jacobi's functions, their inverses, the nome and the theta functions.

#include "polhode/elliptic/jacobi.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include "elliptic/jacobi_points.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/scalar.hpp"
#include "polhode/elliptic/legendre.hpp"
#include "polhode/elliptic/theta.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace jacobi_test {

using support::agrees;
using support::as_narrow_as;
using support::meet;
using support::power_of_ten;
using support::power_of_two;
using parameter = elliptic_parameter<ball>;

constexpr precision precisions[] = {53, 128, 400, 900};

struct reference {
  std::string_view u, m, sn, cn, dn;
};
// mpmath 1.3.0 at 60 digits: ellipfun.
constexpr reference references[] = {
    {"0.5", "0.25", "0.475082936028536510082218324703870258745078172",
     "0.879941022963758342138211939938800035594045354",
     "0.971377398838178842823315157470233933307542434"},
    {"3.25", "0.9375", "0.99330802167577482967175746735374769644674165",
     "-0.115495342220188434478658255870173278999561",
     "0.273871275775497380959542717999558911623465679"},
    {"-10.5", "0.5", "-0.56942643719970463805991636391801718931264779",
     "-0.822042293691784954473069975643203633277799337",
     "0.915356087164457226114551463032743401811392842"},
    {"1.5", "-3.0", "0.711427865252540734176405795967508747622619856",
     "-0.702759128394795555113055628390952387652368901",
     "1.5869432322466238008362559439394285375965529"},
    {"0.75", "4.0", "0.493526143655620833324294582282404718623984781",
     "0.869730961578585811062916636451994607212327467",
     "0.160398822045693443904088066531322240399361874"},
    {"40.0", "0.75", "-0.855900108329504282963155166640723975695068269",
     "-0.517141184360270066029374942157980880423540687",
     "0.671249769773634354321930113559385485521169554"},
};

// With few bits the means are still far apart where the steps end.
TEST(Jacobi, HasAMeanBetweenTheLastOnes) {
  for (const precision p : {20L, 30L, 41L, 60L}) {
    for (long k = 1; k < 200; ++k) {
      const rational m1(k, 200);
      const auto ladder = detail::ladder_of(ball(m1, p), p);
      ASSERT_TRUE(ladder) << m1;
      EXPECT_TRUE(contains(ladder->mean, agm(ball(1, 200), sqrt(ball(m1, 200))))) << m1 << " " << p;
    }
  }
}

TEST(Jacobi, HasTheValuesOfMpmath) {
  for (const reference& r : references) {
    for (const precision p : precisions) {
      const ball u = parse_ball(r.u, p);
      const ball m = parse_ball(r.m, p);
      const long digits = std::min(42L, (p - 6) * 3 / 10);
      EXPECT_TRUE(agrees(jacobi_sn(u, m), r.sn, digits)) << r.u << " " << r.m << " " << p;
      EXPECT_TRUE(agrees(jacobi_cn(u, m), r.cn, digits)) << r.u << " " << r.m << " " << p;
      EXPECT_TRUE(agrees(jacobi_dn(u, m), r.dn, digits)) << r.u << " " << r.m << " " << p;
    }
  }
}

TEST(Jacobi, InvertsTheIntegral) {
  support::random_source random(31);
  for (support::repeat trial(40); trial.again();) {
    const precision p = random.choose(precisions);
    const rational m(random.between(-300, 99), 100);
    const rational phi(random.between(-900, 900), 100);
    const ball u = elliptic_f(ball(phi, p), ball(m, p));
    EXPECT_TRUE(meet(jacobi_am(u, ball(m, p)), ball(phi, p))) << phi << " " << m << " " << p;
    EXPECT_TRUE(as_narrow_as(jacobi_am(u, ball(m, p)), p - 14)) << phi << " " << m << " " << p;
    EXPECT_TRUE(meet(jacobi_sn(u, ball(m, p)), sin(ball(phi, p))));
    EXPECT_TRUE(meet(jacobi_cn(u, parameter::with_complement(ball(rational(1 - m), p))),
                     cos(ball(phi, p))));
  }
}

TEST(Jacobi, SatisfiesItsIdentities) {
  support::random_source random(32);
  for (support::repeat trial(40); trial.again();) {
    const precision p = random.choose(precisions);
    const rational m(random.between(1, 999), 1000);
    const ball k(m, p);
    const ball u(rational(random.between(-(1 << 20), 1 << 20), 1 << 16), p);
    const ball v(rational(random.between(-(1 << 20), 1 << 20), 1 << 16), p);
    const auto a = jacobi_elliptic(u, k);
    const auto b = jacobi_elliptic(v, k);
    EXPECT_TRUE(meet(square(a.sn) + square(a.cn), ball(1, p)));
    EXPECT_TRUE(meet(square(a.dn) + k * square(a.sn), ball(1, p)));
    // Addition (DLMF 22.8.1-3), u + v exact.
    const auto sum = jacobi_elliptic(u + v, k);
    const ball below = 1 - k * square(a.sn) * square(b.sn);
    EXPECT_TRUE(meet(sum.sn * below, a.sn * b.cn * b.dn + b.sn * a.cn * a.dn)) << m;
    EXPECT_TRUE(meet(sum.cn * below, a.cn * b.cn - a.sn * a.dn * b.sn * b.dn)) << m;
    EXPECT_TRUE(meet(sum.dn * below, a.dn * b.dn - k * a.sn * a.cn * b.sn * b.cn)) << m;
    // Quotients.
    EXPECT_TRUE(meet(jacobi_sc(u, k), jacobi_sn(u, k) * jacobi_nc(u, k)));
    EXPECT_TRUE(meet(jacobi_sd(u, k), jacobi_sn(u, k) / jacobi_dn(u, k)));
    EXPECT_TRUE(meet(jacobi_cd(u, k) * jacobi_dc(u, k), ball(1, p)));
    EXPECT_TRUE(meet(jacobi_cs(u, k) * jacobi_sc(u, k), ball(1, p)));
    EXPECT_TRUE(meet(jacobi_ds(u, k) * jacobi_sd(u, k), ball(1, p)));
    EXPECT_TRUE(meet(jacobi_ns(u, k) * jacobi_nd(u, k) * jacobi_sn(u, k), jacobi_nd(u, k)));
    // Through theta functions (DLMF 22.2.4-6).
    const ball q = elliptic_nome(k);
    const ball z = pi(p) * u / (2 * elliptic_k(k));
    const ball zero(0, p);
    EXPECT_TRUE(meet(a.sn * theta_2(zero, q) * theta_4(z, q), theta_3(zero, q) * theta_1(z, q)))
        << m << u;
    EXPECT_TRUE(meet(a.cn * theta_2(zero, q) * theta_4(z, q), theta_4(zero, q) * theta_2(z, q)))
        << m << u;
    EXPECT_TRUE(meet(a.dn * theta_3(zero, q) * theta_4(z, q), theta_4(zero, q) * theta_3(z, q)))
        << m << u;
    EXPECT_TRUE(meet(square(theta_3(zero, q)), 2 * elliptic_k(k) / pi(p)));
  }
}

TEST(Jacobi, HasItsLimitsAndItsEnds) {
  for (const precision p : {64L, 333L}) {
    const ball u(rational(7, 4), p);
    EXPECT_TRUE(meet(jacobi_sn(u, ball(0, p)), sin(u)));
    EXPECT_TRUE(meet(jacobi_dn(u, ball(0, p)), ball(1, p)));
    EXPECT_TRUE(meet(jacobi_sn(u, ball(1, p)), tanh(u)));
    EXPECT_TRUE(meet(jacobi_cn(u, ball(1, p)), 1 / cosh(u)));
    EXPECT_TRUE(meet(jacobi_am(u, ball(1, p)), atan(sinh(u))));
    EXPECT_TRUE(meet(jacobi_am(u, ball(0, p)), u));
    EXPECT_TRUE(meet(jacobi_sn(ball(0, p), ball(rational(1, 2), p)), ball(0, p)));
    // m1 = 1e-300: near tanh for moderate u, to 1e-290.
    const parameter near_one = parameter::with_complement(ball(power_of_ten(-300), p));
    const magnitude off = magnitude::power_of_two(-900);
    EXPECT_TRUE(meet(jacobi_sn(u, near_one).enlarged(off), tanh(u)));
    EXPECT_TRUE(as_narrow_as(jacobi_cn(u, near_one), p - 8));
    // At K/2 and K: sn(K/2) = (1 + k')^(-1/2) (DLMF 22.5, table 22.5.2).
    const ball K = elliptic_k(near_one);
    EXPECT_TRUE(meet(jacobi_dn(K, near_one), sqrt(near_one.m1())));
    EXPECT_TRUE(meet(jacobi_sn(K, near_one), ball(1, p)));
    const parameter half(ball(rational(1, 2), p));
    const ball quarter = elliptic_k(half);
    EXPECT_TRUE(meet(jacobi_sn(quarter / 2, half), 1 / sqrt(1 + sqrt(half.m1()))));
    EXPECT_TRUE(meet(jacobi_am(2 * quarter, half), pi(p)));
    // Far arguments are reduced exactly: sn has the period 4K, at a precision that sees it.
    const rational far = power_of_ten(30);
    const precision more = p + 220;
    const ball period = 4 * elliptic_k(ball(rational(1, 2), more));
    const ball turns = floor((ball(far, more) / period).middle());
    const ball rest = ball(far, more) - turns * period;
    EXPECT_TRUE(meet(jacobi_sn(ball(far, p), half), jacobi_sn(rest, ball(rational(1, 2), more))));
    EXPECT_TRUE(as_narrow_as(jacobi_sn(ball(far, 110), parameter(ball(rational(1, 2), 110))), 100));
    EXPECT_TRUE(as_narrow_as(
        jacobi_sn(ball(power_of_ten(1000), 3400), parameter(ball(rational(1, 2), 64))), 3000));
    EXPECT_TRUE(meet(jacobi_am(ball(far, more), half),
                     turns * 2 * pi(more) + jacobi_am(rest, ball(rational(1, 2), more))));
    // m far below 0, where a small u is many periods.
    const ball deep(-1'000'000, p);
    EXPECT_TRUE(meet(jacobi_am(20 * elliptic_k(deep), deep), 10 * pi(p)));
    EXPECT_TRUE(
        meet(elliptic_f(jacobi_am(ball(rational(1, 5), p), deep), deep), ball(rational(1, 5), p)));
    // Small ones.
    EXPECT_TRUE(as_narrow_as(jacobi_sn(ball(power_of_ten(-1000), p), half), p - 6));
  }
}

TEST(Jacobi, OfGreatParameters) {
  const precision p = 200;
  const auto power = [](long n) {
    return ball(support::power_of_two(n), precision(std::abs(n) + 8));
  };
  for (const long n : {3L, 40L, 100L, 3000L}) {
    const ball m = power(n).with_precision(p);
    const ball u = ball(rational(7, 4), p);
    // Jacobi's real transformation: k sn(u | m) = sn(k u | 1/m), cn and dn in each other's place.
    const auto w = jacobi_elliptic(u, parameter(m));
    const ball k = sqrt(power(n).with_precision(p + n));
    const auto v = jacobi_elliptic(k * u, parameter(power(-n).with_precision(p + n)));
    EXPECT_TRUE(as_narrow_as(w.sn, p - 3)) << n;
    EXPECT_TRUE(meet(k * w.sn, v.sn)) << n;
    EXPECT_TRUE(meet(w.cn, v.dn)) << n;
    EXPECT_TRUE(meet(w.dn, v.cn)) << n;
    // sn(u | -m) = sd(u sqrt(1+m) | m/(1+m))/sqrt(1+m).
    const auto below = jacobi_elliptic(u, parameter(-m));
    const ball one_more = 1 + m.with_precision(p + 2 * n);
    const ball root = sqrt(one_more);
    const auto of = parameter::with_complement(1 / one_more);
    EXPECT_TRUE(as_narrow_as(below.sn, p - 3)) << n;
    EXPECT_TRUE(meet(below.sn * root, jacobi_sd(u * root, of))) << n;
    EXPECT_TRUE(meet(below.dn, jacobi_nd(u * root, of))) << n;
  }
}

TEST(Jacobi, HoldsEveryMemberOfABox) {
  support::random_source random(33);
  const precision p = 90;
  for (support::repeat trial(60); trial.again();) {
    const rational u(random.between(-600, 600), 100);
    const rational m(random.between(-300, 60), 100);
    const rational w = rational(3, 10) * power_of_two(-random.between(0, 70));
    const ball over_u = hull(ball(u, p), ball(rational(u + w), p));
    const ball over_m = hull(ball(m, p), ball(rational(m + w), p));
    const ball in_u(rational(u + w * rational(random.between(0, 8), 8)), 200);
    const ball in_m(rational(m + w * rational(random.between(0, 8), 8)), 200);
    const auto box = jacobi_elliptic(over_u, over_m);
    const auto member = jacobi_elliptic(in_u, in_m);
    EXPECT_TRUE(meet(box.sn, member.sn)) << u << m;
    EXPECT_TRUE(meet(box.cn, member.cn)) << u << m;
    EXPECT_TRUE(meet(box.dn, member.dn)) << u << m;
    EXPECT_TRUE(meet(jacobi_am(over_u, over_m), jacobi_am(in_u, in_m))) << u << m;
    EXPECT_TRUE(meet(jacobi_sn(over_u, parameter::with_complement(1 - over_m)), member.sn));
    EXPECT_TRUE(meet(jacobi_dn(over_u, over_m + 5), jacobi_dn(in_u, in_m + 5)));
    const ball q = hull(ball(rational(1, 3), p), ball(rational(rational(1, 3) + w), p));
    EXPECT_TRUE(
        meet(theta_1(over_u, q), theta_1(in_u, ball(rational(rational(1, 3) + w / 2), 200))));
    EXPECT_TRUE(meet(theta_4(over_u, q / 20),
                     theta_4(in_u, ball(rational((rational(1, 3) + w / 2) / 20), 200))));
  }
}

TEST(Jacobi, HasItsDerivatives) {
  support::random_source random(34);
  const precision p = 300;
  const rational h = power_of_two(-40);
  const ball step(h, p);
  for (support::repeat trial(15); trial.again();) {
    const rational u(random.between(-450, 450), 103);
    const rational m(random.between(-300, 95), 99);
    const ball u0(u, p);
    const ball u1(rational(u + h), p);
    const ball m0(m, p);
    const ball m1(rational(m + h), p);
    const auto in_u = jacobi_gradient(hull(u0, u1), m0);
    const auto in_m = jacobi_gradient(u0, hull(m0, m1));
    const auto check = [&](const auto& f, const ball& slope_u, const ball& slope_m,
                           const char* name) {
      EXPECT_TRUE(meet((f(u1, m0) - f(u0, m0)) / step, slope_u)) << name << ", u " << u << " " << m;
      EXPECT_TRUE(meet((f(u0, m1) - f(u0, m0)) / step, slope_m)) << name << ", m " << u << " " << m;
    };
    check([](const ball& a, const ball& b) { return jacobi_am(a, b); }, in_u.am[0], in_m.am[1],
          "am");
    check([](const ball& a, const ball& b) { return jacobi_sn(a, b); }, in_u.sn[0], in_m.sn[1],
          "sn");
    check([](const ball& a, const ball& b) { return jacobi_cn(a, b); }, in_u.cn[0], in_m.cn[1],
          "cn");
    check([](const ball& a, const ball& b) { return jacobi_dn(a, b); }, in_u.dn[0], in_m.dn[1],
          "dn");
    for (const int j : {1, 2, 3, 4}) {
      const ball q(rational(random.between(1, 95), 100), p);
      EXPECT_TRUE(meet((theta(j, u1, q).value - theta(j, u0, q).value) / step,
                       theta(j, hull(u0, u1), q).derivative))
          << j;
    }
  }
}

TEST(Jacobi, HasItsInverses) {
  support::random_source random(35);
  for (support::repeat trial(20); trial.again();) {
    const precision p = random.choose(precisions);
    const parameter m(ball(rational(random.between(1, 999), 1000), p));
    const ball K = elliptic_k(m);
    const ball u = K * ball(rational(random.between(1, 999), 1000), p);  // in (0, K)
    EXPECT_TRUE(meet(jacobi_arcsn(jacobi_sn(u, m), m), u));
    EXPECT_TRUE(meet(jacobi_arcsn(-jacobi_sn(u, m), m), -u));
    EXPECT_TRUE(meet(jacobi_arccn(jacobi_cn(u, m), m), u));
    EXPECT_TRUE(meet(jacobi_arccn(-jacobi_cn(u, m), m), 2 * K - u));
    EXPECT_TRUE(meet(jacobi_arcdn(jacobi_dn(u, m), m), u));
    EXPECT_TRUE(meet(jacobi_arcns(jacobi_ns(u, m), m), u));
    EXPECT_TRUE(meet(jacobi_arcnc(jacobi_nc(u, m), m), u));
    EXPECT_TRUE(meet(jacobi_arcnd(jacobi_nd(u, m), m), u));
    EXPECT_TRUE(meet(jacobi_arcsc(jacobi_sc(u, m), m), u));
    EXPECT_TRUE(meet(jacobi_arcsd(jacobi_sd(u, m), m), u));
    EXPECT_TRUE(meet(jacobi_arccs(jacobi_cs(u, m), m), u));
    EXPECT_TRUE(meet(jacobi_arccs(-jacobi_cs(u, m), m), 2 * K - u));
    EXPECT_TRUE(meet(jacobi_arccd(jacobi_cd(u, m), m), u));
    EXPECT_TRUE(meet(jacobi_arccd(-jacobi_cd(u, m), m), 2 * K - u));
    EXPECT_TRUE(meet(jacobi_arcds(jacobi_ds(u, m), m), u));
    EXPECT_TRUE(meet(jacobi_arcdc(jacobi_dc(u, m), m), u));
  }
  EXPECT_TRUE(jacobi_arcsn(ball(2, 64), ball(rational(1, 2), 64)).is_undefined());
  EXPECT_TRUE(jacobi_arcdn(ball(rational(1, 2), 64), ball(rational(1, 2), 64)).is_undefined());
  EXPECT_TRUE(jacobi_arcdn(ball(rational(-9, 10), 64), ball(rational(1, 2), 64)).is_undefined());
  EXPECT_TRUE(jacobi_arcns(ball(-2, 64), ball(rational(1, 2), 64)).is_undefined());
  EXPECT_TRUE(jacobi_arccn(ball(rational(1, 2), 64), ball(2, 64)).is_undefined());
}

struct theta_reference {
  std::string_view z, q;
  std::array<std::string_view, 8> values;
};
// mpmath 1.3.0 at 60 digits: jtheta(j, z, q) for j = 1 ... 4, and the derivatives.
constexpr theta_reference theta_references[] = {
    {"0.75",
     "0.01953125",
     {"0.509421926233357484180080201469082754070994678",
      "0.54688586448663790123177336172916715839501256",
      "1.00276288381440672558030107633204790030888546",
      "0.997236539934117784462058237703784981369477605",
      "0.547602522874835610988418481709188316630415028",
      "-0.510309599178223229933737423158375280728474073",
      "-0.0779294601137484459443286093395762085869696197",
      "0.0779291315431253557627774364228643221566364652"}},
    {"-2.5",
     "0.25",
     {"-0.763436338330131294292700393586970465407583013",
      "-1.10200511823732447223287883359937366425691758",
      "1.13527005064192530459364714431732948502485318",
      "0.851619457096311162302379836346715455105615354",
      "-1.22318133093952393200995220772837337011689687",
      "1.09497715753163460044793347746587305969693074",
      "-0.975895163162498942554586508006811214949059907",
      "0.941893850533885500331769017093594346013098236"}},
    {"10.25",
     "0.9375",
     {"-0.0012676951121242226781515067340241335343091429",
      "-0.000182439269415942012434590670903061117211014297",
      "0.000182439269415942012434590670903072044884151866",
      "0.0012676951121242226781515067340241335668806776",
      "-0.0292898214403151631925000418854829749363790096",
      "0.00466552078633000041399334738675855484402263178",
      "-0.00466552078633000041399334738675777042750694404",
      "0.0292898214403151631925000418854829725179165483"}},
};

TEST(Theta, HasTheValuesOfMpmath) {
  for (const theta_reference& r : theta_references) {
    for (const precision p : precisions) {
      const ball z = parse_ball(r.z, p);
      const ball q = parse_ball(r.q, p);
      const long digits = std::min(42L, (p - 6) * 3 / 10);
      for (int j = 1; j <= 4; ++j) {
        const theta_values w = theta(j, z, q);
        const auto i = static_cast<std::size_t>(j) - 1;
        EXPECT_TRUE(agrees(w.value, r.values[i], digits)) << j << " " << r.z << " " << r.q;
        EXPECT_TRUE(agrees(w.derivative, r.values[i + 4], digits)) << j << " " << r.z << " " << r.q;
      }
    }
  }
}

TEST(Theta, OfSetsLongerThanThePeriodIsItsRange) {
  const precision p = 90;
  const ball q(rational(1, 2), p);
  for (const long half_length : {1L, 3L, 5L, 9L, 1L << 40, 1L << 60}) {
    const ball z = ball(3, p).enlarged(magnitude::power_of_two(0)) * half_length;
    for (int j = 1; j <= 4; ++j) {
      const theta_values range = theta(j, z, q);
      EXPECT_TRUE(range.value.is_bounded() && range.derivative.is_bounded());
      for (const rational& part :
           {rational(-1), rational(-1, 3), rational(0), rational(1, 2), rational(1)}) {
        const theta_values w = theta(j, ball(rational((3 + part) * half_length), p + 70), q);
        EXPECT_TRUE(meet(range.value, w.value)) << j << ' ' << half_length;
        EXPECT_TRUE(meet(range.derivative, w.derivative)) << j << ' ' << half_length;
      }
    }
  }
}

TEST(Theta, IsOneFunctionOnBothSidesOfTheChangeOfSeries) {
  // 1/24 and 1/21 are between the limits of the two: sets around them take either.
  for (const precision p : precisions) {
    const ball z(rational(31, 10), p);
    for (int j = 1; j <= 4; ++j) {
      const ball below = theta(j, z, ball(rational(1, 20) - power_of_two(-60), p)).value;
      const ball above = theta(j, z, ball(rational(1, 20) + power_of_two(-60), p)).value;
      EXPECT_TRUE(meet(below.enlarged(magnitude::power_of_two(-55)), above)) << j;
      EXPECT_TRUE(as_narrow_as(below, p - 6));
    }
    // theta_1'(0) = theta_2 theta_3 theta_4 (DLMF 20.4.6).
    for (const rational& q :
         {rational(1, 1000), rational(1, 22), rational(2, 3), rational(999, 1000)}) {
      const ball zero(0, p);
      const ball nome(q, p);
      EXPECT_TRUE(meet(theta(1, zero, nome).derivative,
                       theta_2(zero, nome) * theta_3(zero, nome) * theta_4(zero, nome)));
    }
  }
  EXPECT_TRUE(meet(theta_3(ball(1, 64), ball(0, 64)), ball(1, 64)));
  EXPECT_TRUE(theta_3(ball(1, 64), ball(1, 64)).is_undefined());
  EXPECT_TRUE(theta_3(ball(1, 64), ball(-1, 64)).is_undefined());
  EXPECT_TRUE(theta_3(ball(1, 64), hull(ball(rational(1, 100), 64), ball(rational(1, 2), 64)))
                  .is_undefined());
  EXPECT_THROW(static_cast<void>(theta(5, ball(1, 64), ball(0, 64))), std::invalid_argument);
}

TEST(Jacobi, AgreesWithBoostInDouble) {
  support::random_source random(36);
  for (support::repeat trial(200); trial.again();) {
    const double m = std::ldexp(static_cast<double>(random.between(1, (1 << 20) - 1)), -20);
    const double u = std::ldexp(static_cast<double>(random.between(-(1L << 24), 1L << 24)), -21);
    double cn = 0;
    double dn = 0;
    const double sn = boost::math::jacobi_elliptic(std::sqrt(m), u, &cn, &dn);
    const auto ours = jacobi_elliptic(u, elliptic_parameter<double>(m));
    const auto certified = jacobi_elliptic(ball::exactly(u, 100), parameter(ball::exactly(m, 100)));
    const auto check = [&](double x, double theirs, const ball& y, const char* name) {
      const double near = mpfr_get_d(midpoint(y).backend().data(), MPFR_RNDN);
      EXPECT_LE(std::abs(x - near), 2 * std::abs(std::nextafter(near, HUGE_VAL) - near))
          << name << " " << u << " " << m;
      EXPECT_LE(std::abs(x - theirs), 1e-12) << name;
    };
    check(ours.sn, sn, certified.sn, "sn");
    check(ours.cn, cn, certified.cn, "cn");
    check(ours.dn, dn, certified.dn, "dn");
    EXPECT_NEAR(
        jacobi_am(u, elliptic_parameter<double>(m)),
        mpfr_get_d(midpoint(jacobi_am(ball::exactly(u, 100), parameter(ball::exactly(m, 100))))
                       .backend()
                       .data(),
                   MPFR_RNDN),
        1e-14);
  }
  EXPECT_NEAR(
      jacobi_sn(1e30, elliptic_parameter<double>(0.5)),
      mpfr_get_d(
          midpoint(jacobi_sn(ball::exactly(1e30, 100), ball(rational(1, 2), 100))).backend().data(),
          MPFR_RNDN),
      1e-15);
  EXPECT_TRUE(std::isnan(jacobi_sn(HUGE_VAL, elliptic_parameter<double>(0.5))));
  EXPECT_TRUE(std::isnan(jacobi_sn(1.0, elliptic_parameter<double>(std::nan("")))));
}

TEST(Jacobi, HasUncertifiedValuesFromTheSameTemplates) {
  for (const precision p : precisions) {
    const mpfr_float u = scalar_from<mpfr_float>(rational(7, 2), p);
    const elliptic_parameter<mpfr_float> m(scalar_from<mpfr_float>(rational(3, 4), p));
    const ball sn = jacobi_sn(ball(rational(7, 2), p), ball(rational(3, 4), p));
    EXPECT_TRUE(overlaps(ball(jacobi_sn(u, m)).enlarged(scale(sn.magnitude_upper(), 4 - p)), sn));
    const ball am = jacobi_am(ball(rational(7, 2), p), ball(rational(3, 4), p));
    EXPECT_TRUE(overlaps(ball(jacobi_am(u, m)).enlarged(scale(am.magnitude_upper(), 4 - p)), am));
  }
}

TEST(Jacobi, IsUndefinedOutsideItsDomain) {
  const ball half(rational(1, 2), 64);
  EXPECT_TRUE(jacobi_ns(ball(0, 64), half).is_undefined());
  EXPECT_TRUE(jacobi_sn(ball::undefined(64), half).is_undefined());
  EXPECT_TRUE(jacobi_sn(ball::entire(64), half).is_undefined());
  EXPECT_TRUE(jacobi_am(half, ball(2, 64)).is_undefined());
  EXPECT_TRUE(jacobi_sn(half, hull(half, ball(2, 64))).is_undefined());
  // A member is outside, if not one of the corners that bound the rest.
  const auto set = [](const rational& low, const rational& high) {
    return hull(ball(low, 64), ball(high, 64));
  };
  const ball across = set(rational(-1, 10), 5);
  const ball beyond = set(rational(999, 1000), rational(3, 2));
  EXPECT_TRUE(jacobi_am(across, beyond).is_undefined());
  EXPECT_TRUE(jacobi_sn(across, beyond).is_undefined());
  EXPECT_TRUE(
      jacobi_cn(across, elliptic_parameter<ball>::with_complement(1 - beyond)).is_undefined());
  EXPECT_TRUE(jacobi_arcsn(half, set(rational(78, 100), rational(123, 100))).is_undefined());
  EXPECT_TRUE(jacobi_arccd(half, set(rational(-1, 100), rational(1, 100))).is_undefined());
  EXPECT_TRUE(
      elliptic_e(set(rational(36, 100), rational(64, 100)), set(rational(96, 100), rational(9, 2)))
          .is_undefined());
  EXPECT_FALSE(elliptic_e(set(rational(36, 100), rational(64, 100)), set(rational(96, 100), 2))
                   .is_undefined());
  EXPECT_TRUE(elliptic_nome(ball(2, 64)).is_undefined());
  EXPECT_TRUE(elliptic_nome(ball(-1, 64)).is_undefined());
}

}  // namespace jacobi_test
}  // namespace polhode
