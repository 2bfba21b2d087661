// Integrals over rays on which oscillations decay.

#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "quadrature/integrals_by_digits.hpp"

namespace polhode::test {
namespace turned_rays_test {

TEST(TurnedRays, OfPolynomialPhases) {
  expect_known(
      {
          {"cos(x^3/3+5*x)", "0", "inf", "0.0003403740594896786849473501611968751068279"},
          {"cos(x^3/3-5*x)", "0", "inf", "1.101948209115900718316881477223515889731"},
          {"cos(x^3/3-5*x)", "-inf", "inf", "2.203896418231801436633762954447031779462"},
          {"cos(x^2+x)", "0", "inf", "0.2705135801622141442589008561578418628121"},
          {"cos(x^2-x)", "-inf", "0", "0.2705135801622141442589008561578418628121"},
          {"cos(x^2)/(1+x)", "0", "inf", "0.5334744570576480929526644193937333087885"},
          {"sin(x^3)^2/(1+x^2)", "0", "inf", "0.4967611929414768162599919959747725871912"},
          {"cos(x^4-3*x^2)", "0", "inf", "0.4516884417096685985173730228763697201092"},
          {"cos(x^2)/sqrt(x)", "0", "inf", "1.674813393538172966167205444361664522758"},
          {"sin(x)*log(x)/x", "1", "inf", "0.07512255319555633890622864852348729320916"},
          {"cos(x^2+x)*log(2+x)", "0", "inf", "0.1396339710947879179346739068042674941082"},
          // Poles beside the axis, between it and a ray from 0.
          {"cos(x^2+x)/((x-2)^2+1/4)", "0", "inf", "0.4465222376010349283199970303131920617150"},
          {"cos(x)/sqrt(1+x^2)", "0", "inf", "0.4210244382407083333356273792126090361362"},
      },
      20'000);
}

TEST(TurnedRays, OfAmplitudesThatDecaySlowly) {
  expect_known(
      {
          {"sin(x)/log(x)", "2", "inf", "-0.09643770492506484527983902009171086648725"},
          {"cos(x)*log(x)*x^(-1/e)", "1", "inf", "-0.5439047543323245102786419700047497459983"},
          {"sin(x^2)/log(x)", "2", "inf", "-0.2687921176325079990273093279124532858371"},
          {"sin(x)*x^(-1/sqrt(2))", "0", "inf", "1.362210087485961792816256011479217022295"},
          {"cos(x^2)*x^(1/pi)", "0", "inf", "0.3488921298663244937840703115257619494355"},
      },
      20'000);
  for (const char* text :
       {"sin(x)*log(x)/log(1+x)", "sin(x)*x^(1/pi)", "sin(x^2)*x*log(x)/log(x+2)",
        "sin(x)*log(x)^2/log(1+x)", "sin(x)*(x/(1+x))^sqrt(2)", "sin(x)/log(x)", "sin(x)/log(x-2)",
        "sin(x)/log(x^2-6*x+10)", "sin(x)/log(x/3)", "sin(x^2)*x^(1+1/pi)"}) {
    SCOPED_TRACE(text);
    EXPECT_NE(integrate(parse(text), 1, end_point::infinity()).verdict, status::certified);
  }
}

/// The logarithm is a divisor, and 0 at 3.
TEST(TurnedRays, StartBeyondTheZeroOfALogarithm) {
  const auto rays = parse("sin(x)/log(x/3)").on_turned_rays(1);
  ASSERT_TRUE(rays);
  EXPECT_GT(rays->start, 3);
}

/// The third is problem 1 of L. N. Trefethen's hundred-digit challenge (SIAM News 35, 2002).
TEST(TurnedRays, OfPhasesWithLogarithms) {
  expect_known(
      {
          {"cos(x*log(x))", "1", "inf", "0.2103136155664748202974779764213519841999"},
          {"cos(x*log(x))/x", "1", "inf", "0.323367431677778761399370087952170446651"},
          {"cos(log(x)/x)/x", "0", "1", "0.323367431677778761399370087952170446651"},
          {"cos(log(1/x)*x^-1)/x^2", "0", "1", "0.2103136155664748202974779764213519841999"},
          {"cos(1/x+log(x))", "0", "1", "0.1343773187020129881413761173356898790316"},
          {"sin(x+log(x))/x", "1", "inf", "0.3473114490623064158436131288873806606395"},
          {"sin(x^2*log(x))", "1", "inf", "0.432731580242724153003975123400258161494"},
          {"cos(x*log(x)-3*x)/x", "2", "inf", "1.234361377481723237854968887509109257379"},
          {"cos(x*log(2*x)-x^2)/x", "1", "inf", "0.3926139415421097293966421966222238519583"},
          {"cos(1000*x*log(x))", "1", "100", "-0.00006455905904734743756404636057907433803186"},
      },
      20'000);
}

TEST(TurnedRays, OfPhasesWithLogarithmsOnlyWhereTheyConverge) {
  for (const char* text : {"(1+log(x))*cos(x*log(x))", "x*cos(x*log(x))", "log(x)*cos(x*log(x))",
                           "cos(2*log(x))", "x*cos(x^2+x*log(x))"}) {
    SCOPED_TRACE(text);
    EXPECT_NE(integrate(parse(text), 1, end_point::infinity()).verdict, status::certified);
  }
}

TEST(TurnedRays, OfManyTurns) {
  expect_known(
      {
          {"sin(1e6*x)/(1+x)", "0", "1", "5.316240237300373372546307821947219566557e-7"},
          {"-sin(1e6*x)/(1-x)", "-1", "0", "5.316240237300373372546307821947219566557e-7"},
          {"x*cos(x^2)", "0", "1000", "-0.1749967510856464760588262433903857345307"},
          {"(1+x)*cos(x^2+2*x)", "-1", "999", "-0.06794052336516322409351731745112584593372"},
          // Ends that are not rational, either way round.
          {"sin(x)/x", "1", "exp(20)", "0.6247132545392495467764078883011293111024"},
          {"sin(x)/x", "-exp(20)", "-1", "0.6247132545392495467764078883011293111024"},
      },
      20'000);
}

/// The integral of exp(-a x) cos(b x) is a/(a^2 + b^2), of x exp(-a x) cos(b x) is
/// (a^2 - b^2)/(a^2 + b^2)^2, and of exp(-(a - i b) x^2) sqrt(pi/(a - i b))/2.
TEST(TurnedRays, WithExponentialDecay) {
  expect_known(
      {
          {"exp(-x)*cos(1e5*x)", "0", "inf", "9.999999999000000000099999999990000000001e-11"},
          {"exp(x)*cos(1e5*x)", "-inf", "0", "9.999999999000000000099999999990000000001e-11"},
          {"x*exp(-x)*cos(1e3*x)", "0", "inf", "-9.999970000049999930000089999890000129999850e-7"},
          {"exp(-x)*sin(1e4*x)^2", "0", "inf", "0.4999999987500000031249999921875000195312"},
          {"exp(-x^2)*cos(1e4*x^2)", "0", "inf", "0.006266883991610231924463992439518973485925"},
          // Both ends finite: the size may grow.
          {"exp(x)*sin(1e5*x)/(1+x)", "0", "1", "0.00002358272404237082150261313891369514997972"},
      },
      20'000);
}

TEST(TurnedRays, OfExponentialPhases) {
  expect_known(
      {
          {"sin(exp(x))", "0", "inf", "0.6247132564277136042899683778165717842862"},
          {"sin(exp(x))", "-inf", "inf", "1.570796326794896619231321691639751442099"},
          {"sin(exp(-x))", "-inf", "inf", "1.570796326794896619231321691639751442099"},
          {"sin(exp(-x))", "-inf", "0", "0.6247132564277136042899683778165717842862"},
          {"sin(exp(x))", "0", "20", "0.6247132545392495467764078883011293111024"},
          {"sin(exp(x))", "20", "0", "-0.6247132545392495467764078883011293111024"},
          {"sin(exp(x/2))", "-inf", "12", "3.140278270934534102035074995618817109741"},
          {"cos(exp(-x))", "-20", "0", "-0.3374039220751002525101746510565487373131"},
          {"sin(exp(x))", "sqrt(2)", "pi^2", "-0.1653438206952165601082484347744902452101"},
          {"cos(2^x)", "0", "inf", "-0.4867709663457088800345017075327652557826"},
          {"cos(sinh(x))", "0", "inf", "0.4210244382407083333356273792126090361362"},
          {"cos(2*cosh(x))", "-inf", "inf", "-1.603392463767388430851948737342812393115"},
          {"cos(2+expm1(x)-exp(x))*exp(-x)", "0", "inf",
           "0.5403023058681397174009366074429766037324"},
          {"exp(-x)*sin(exp(x))", "0", "inf", "0.504067061906928371989856117741148229625"},
          // One of them grows and one vanishes, in either order.
          {"exp(-x)*cos(exp(2*x))*exp(2*x)", "0", "inf",
           "-0.2778671692425219558708470456297958325562"},
          {"cos(exp(2*x))*exp(x)", "0", "inf", "-0.2778671692425219558708470456297958325562"},
      },
      20'000);
  for (const char* formula : {"exp(x)*cos(exp(x))", "exp(2*x)*sin(exp(2*x))", "sinh(x)*cos(2^x)"}) {
    EXPECT_EQ(integrate(parse(formula), 0, end_point::infinity(), {.digits = 15}).verdict,
              status::not_certified)
        << formula;
  }
}

TEST(TurnedRays, WhatDoesNotConvergeIsRefused) {
  const auto to_infinity = [](const char* formula) {
    return integrate(parse(formula), 1, end_point::infinity(), {.digits = 15}).verdict;
  };
  for (const char* formula : {"sin(x)", "x*cos(x^2)", "x^2*sin(x^3)", "x^(3/2)*cos(x^2+x)",
                              "cos(x^2+x)*x", "log(x)*sin(x)", "1/x+cos(x^2)", "exp(x)*sin(1e4*x)",
                              "exp(x/1000-x^2)*cos(1e4*x)^2+1", "exp(x-x^2)*cos(x^3)*exp(x^2)"}) {
    EXPECT_EQ(to_infinity(formula), status::not_certified) << formula;
  }
  // Poles on the line, and at the start.
  EXPECT_EQ(to_infinity("cos(x^2)/(x-3)"), status::not_certified);
  EXPECT_EQ(to_infinity("cos(x^2)/(x-1)"), status::not_certified);
  EXPECT_EQ(integrate(parse("cos(x^2)/x"), 0, end_point::infinity()).verdict,
            status::not_certified);
}

// The quarter circle around 0 counts: the ray from 0 alone would give 0.
TEST(TurnedRays, DoNotStartAtAPole) {
  expect_known({{"sin(x)/x", "0", "1e6", "1.570795390043119081462208201142128556725"}}, 20'000);
}

/// Where the rays may start follows from the divisors: a pole between the axis and the ray would be
/// left out. The other rules do not look for rays in these.
TEST(TurnedRays, LeaveOutNoPole) {
  for (const char* formula :
       {"sin(x)/(x^3+3*x^2/2+x+4)", "cos(x)/(x^3+3*x^2/2+x+4)", "sin(2*x)/((x-2)^2+1/9)",
        "cos(x)/(x^2+1)", "sin(x)/sqrt(x^2+3*x+1)", "cos(x)/sqrt(x^2+x/10+1)"}) {
    const auto by = [&](const quadrature_rule& rule) {
      return integrate(parse(formula), 0, end_point::infinity(), {.digits = 15, .rule = rule});
    };
    const integral rays = by(quadrature_rule::turned_rays);
    const integral panels = by(quadrature_rule::gauss_legendre);
    EXPECT_EQ(rays.verdict, status::certified) << formula << ": " << rays.obstacle;
    EXPECT_EQ(panels.verdict, status::certified) << formula << ": " << panels.obstacle;
    EXPECT_TRUE(overlaps(rays.enclosure, panels.enclosure)) << formula;
  }
}

TEST(TurnedRays, AreARule) {
  const auto with = [](const char* formula, const end_point& a, const end_point& b) {
    return integrate(parse(formula), a, b, {.digits = 20, .rule = quadrature_rule::turned_rays});
  };
  const integral few = with("sin(3*x)/(1+x)", 0, 1);
  ASSERT_EQ(few.verdict, status::certified) << few.obstacle;
  EXPECT_TRUE(
      overlaps(few.enclosure, integrate(parse("sin(3*x)/(1+x)"), 0, 1, {.digits = 20}).enclosure));
  EXPECT_EQ(with("exp(-x)*sin(x)/(1+x)", 0, 1).verdict, status::certified);
  EXPECT_EQ(with("exp(-x^2)*sin(x)/(1+x)", 0, 1).why, reason::not_applicable);
  EXPECT_EQ(with("1/(1+x)", 0, 1).why, reason::not_applicable);
  // On the ray it decays too, but between both it grows.
  EXPECT_EQ(with("exp(-x^4)*cos(x)", 0, end_point::infinity()).why, reason::not_applicable);
}

}  // namespace turned_rays_test
}  // namespace polhode::test
