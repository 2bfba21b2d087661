// Integrals that analysts try first, as they type them: certified to thirty digits, right, and
// without much work.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "quadrature/integrals_by_digits.hpp"

namespace polhode::test {
namespace integrals_of_analysts_test {

TEST(IntegralsOfAnalysts, NarrowPeaksOfEntireFunctions) {
  const std::string root_of_pi = "1.772453850905516027298167483341145182798";
  expect_known(
      {
          {"exp(-x^2)", "-1000", "1000", root_of_pi},
          {"exp(-x^2)", "-1e6", "1e6", root_of_pi},
          {"exp(-x*x)", "-1e6", "1e6", root_of_pi},
          {"exp(-x^2*1e6)", "-1", "1", root_of_pi + "e-3"},
          {"exp(-x^4)", "-100", "100", "1.812804954110954155965342577933836001498"},
          {"exp(-(x-1/3)^2*1e20)", "0", "1", root_of_pi + "e-10"},
          {"exp(-(x-3/10)^2*1e8)*log(1+x)", "0", "1",
           "4.650285482734245976234031018324867390817e-5"},
          {"exp(-(x-1/3)^2*1e10)", "-inf", "inf", root_of_pi + "e-5"},
          {"exp(-1e10*(x-sqrt(2)/2)^2)", "0", "1", root_of_pi + "e-5"},
          {"exp(-(x-3/10)^2/1e-20)", "-4", "pi", root_of_pi + "e-10"},
          {"exp(-(x-3/10)^2/1e-20)*cos(x)", "-4", "4",
           "1.693289839061236025459952904730049066383e-10"},
          {"exp(-(x-1e8)^2)", "-inf", "inf", root_of_pi},
          {"exp(-(x-1e5)^2)*log(2+x^2)", "-inf", "inf",
           "40.81225815141518813402212731993949463476"},
          {"exp(-(x-1e5)^2)/(1+x^2)", "-inf", "inf",
           "1.772453850994138719839012150072364621683e-10"},
      },
      2000);
}

TEST(IntegralsOfAnalysts, TailsOfSpecialFunctions) {
  expect_known(
      {
          {"erfc(x)", "0", "inf", "0.5641895835477562869480794515607725858441"},
          {"erfc(x-5)", "0", "inf", "10.00000000000014813429336849340317996673"},
          {"erf(x)*exp(-x^2)", "0", "inf", "0.4431134627263790068245418708352862956994"},
          {"log(1-exp(-x))", "0", "inf", "-1.644934066848226436472415166646025189219"},
          {"log(1+exp(-x))", "0", "inf", "0.8224670334241132182362075833230125946095"},
          {"exp(-cosh(x))", "0", "inf", "0.4210244382407083333356273792126090361362"},
          {"exp(-exp(x))", "0", "inf", "0.2193839343955202736771637754601216490310"},
          {"exp(x-exp(x))", "-inf", "inf", "1"},
          {"x*exp(x-exp(x))", "-inf", "inf", "-0.5772156649015328606065120900824024310422"},
          {"x^3*erfc(x)", "0", "inf", "0.1875"},
      },
      1200);
}

TEST(IntegralsOfAnalysts, OverManyPeriods) {
  expect_known(
      {
          {"sin(x)", "0", "1e10", "0.1268803773231439988238086546923048038096"},
          {"cos(1e10*x)", "0", "1", "-0.00000000004875060250875106915277942943481060416764"},
          {"sin(1e30*x)", "0", "1", "1.99593119440539570239424858799704864113e-30"},
          {"1/(2+cos(x))", "0", "1e15*pi", "1813799364234217.850594078257642155732284"},
          {"sin(x)*cos(2*x)", "0", "1000", "0.1104699047929765754177604558819604788287"},
          {"abs(sin(x))", "0", "1e8*pi", "200000000"},
          {"1/(2+sin(2*pi*x))", "0", "1e6", "577350.2691896257645091487805019574556476"},
          {"sin(x)^2", "0", "1e6", "500000.1639285788908675011906524631956869"},
      },
      400);
}

/// Refused, with the point, and with at most so much work.
void expect_refused(const std::string& formula, const end_point& a, const end_point& b,
                    const std::string& obstacle) {
  SCOPED_TRACE(formula);
  const integral found = integrate(parse(formula), a, b, {.digits = 30});
  EXPECT_EQ(found.verdict, status::not_certified);
  EXPECT_EQ(found.why, reason::not_integrable);
  EXPECT_EQ(found.obstacle, obstacle);
  EXPECT_LE(found.account.evaluations + found.account.region_evaluations, 10'000);
}

// Sets in f are wider than its values long before the zero: x - sin x is x^3/6.
TEST(IntegralsOfAnalysts, CancellationThatHidesAZero) {
  expect_known(
      {
          {"sqrt(x^2-2*x+1)", "0", "2", "1"},
          {"sqrt(exp(x)+exp(-x)-2)", "-1", "1", "1.021007721651046281809801291221376100383"},
          {"(x-sin(x))/x^3", "-1", "1", "0.3278563610432192389947922428964552611672"},
          {"x^2/(exp(x)-x-1)", "-1", "1", "4.0369134595089139242163632861820281227"},
          {"x^3/(x-sin(x))", "-1", "1", "12.20318172869262821829822449047218241339"},
          {"(1-cos(x-1/2))/(x-1/2)^2", "0", "1", "0.4965450836476242427883797455608479152493"},
      },
      3000);
  expect_refused("1/sqrt(x^2-2*x+1)", 0, 2, "the integrand grows too fast at x = 1");
  expect_refused("1/(exp(x)-x-1)", -1, 1, "the integrand grows too fast at x = 0");
  expect_refused("1/(x-sin(x))", -1, 1, "the integrand grows too fast at x = 0");
  expect_refused("1/(sin(x)-x)*cos(x)", -1, 1, "the integrand grows too fast at x = 0");
}

TEST(IntegralsOfAnalysts, OscillationWithRoots) {
  expect_known(
      {
          {"sin(x)/x^(1/3)", "0", "inf", "1.17270053526350045388653789952814824566"},
          {"sin(x)/x^(4/3)", "0", "inf", "2.031176909139600625417932042231770678279"},
          {"cos(x)/x^(2/5)", "0", "inf", "0.8753252416804371183048298072455319978657"},
          {"sin(x)/sqrt(sqrt(x))", "0", "inf", "1.132137410205050899787449122496758824865"},
          {"cos(x^2)/cbrt(x)", "0", "inf", "1.160014413116984775294152416942826011387"},
      },
      1000);
  // Whole and in parts: the root of a number that is negative up to 10.
  const expression f = parse("sin(x)*cbrt(x-10)/x^2");
  const integrate_options options{.digits = 30};
  const end_point infinity = end_point::infinity();
  const ball parts = integrate(f, 1, 10, options).enclosure +
                     integrate(f, 10, 20, options).enclosure +
                     integrate(f, 20, infinity, options).enclosure;
  const integral whole = integrate(f, 1, infinity, options);
  EXPECT_EQ(whole.verdict, status::certified) << whole.obstacle;
  EXPECT_TRUE(overlaps(whole.enclosure, parts));
}

TEST(IntegralsOfAnalysts, PowersThatAreIrrationalOrVary) {
  expect_known(
      {
          {"x^x", "0", "1", "0.7834305107121344070592643865269754694077"},
          {"x^(-x)", "0", "1", "1.291285997062663540407282590595600541499"},
          {"x^(sqrt(2)-1)*exp(-x)", "0", "inf", "gamma(sqrt(2))"},
          {"x^(pi-4)", "0", "1", "1/(pi-3)"},
          {"1/(1+x^pi)", "0", "inf", "1/sin(1)"},
          {"1/(1+x^100)", "0", "inf", "pi/100/sin(pi/100)"},
          {"x^(-pi)", "1", "inf", "1/(pi-1)"},
          {"log(log(1/x))", "0", "1/3", "0.2177606727038001487404690478505903463969"},
          {"(x-1)/log(x)", "0", "1", "log(2)"},
          {"cos(log(x))", "0", "1", "1/2"},
      },
      9000);
}

}  // namespace integrals_of_analysts_test
}  // namespace polhode::test
