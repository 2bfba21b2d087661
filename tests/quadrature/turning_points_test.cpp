// Integrals up to a point where what stands under a root, a logarithm or a divisor vanishes, and
// 0/0 by constants that cancel: where the point, or a value there, is no rational number.

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/pieces/end_plan.hpp"
#include "support/integrals_as_text.hpp"

namespace polhode {
namespace turning_points_test {

using support::expect_values;
using support::number;
using known = support::integral_as_text;

TEST(TurningPoints, HaveTheKnownValues) {
  const std::vector<known> all{
      {"1/sqrt(cos(x)-cos(1))", "0", "1", "sqrt(2)*ellipticK(sin(1/2)^2)"},
      {"sqrt(cos(x)-cos(1))", "0", "1",
       "2*sqrt(2)*(ellipticE(sin(1/2)^2) - cos(1/2)^2*ellipticK(sin(1/2)^2))"},
      {"sqrt(2-x^2)", "0", "sqrt(2)", "pi/2"},
      {"sqrt(2-x^2)", "-sqrt(2)", "sqrt(2)", "pi"},
      {"1/sqrt(2-x^2)", "-sqrt(2)", "1", "3*pi/4"},
      {"1/sqrt(pi-x)", "0", "pi", "2*sqrt(pi)"},
      {"1/sqrt(e-exp(x))", "0", "1", "2/sqrt(e)*atanh(sqrt(1-1/e))"},
      {"log(2-x^2)", "0", "sqrt(2)", "2*sqrt(2)*(log(2*sqrt(2))-1)"},
      {"(log(2)-log(x))^(1/3)/x", "1", "2", "3/4*log(2)^(4/3)"},
      {"cos(x)/sqrt(sin(2)-sin(x))", "0", "pi-2", "2*sqrt(sin(2))"},
      {"exp(x)*(exp(sqrt(3))-exp(x))^(-3/4)", "0", "sqrt(3)", "4*(exp(sqrt(3))-1)^(1/4)"},
      {"1/(sqrt(1-x^2)*sqrt(acos(x)-acos(1/3)))", "0", "1/3", "2*sqrt(pi/2-acos(1/3))"},
      // Double zeros of polynomials that are not written as squares.
      {"sqrt(x^2-2*sqrt(2)*x+2)", "0", "3", "1+(3-sqrt(2))^2/2"},
      {"log(x^2-2*sqrt(2)*x+2)", "0", "3",
       "2*(sqrt(2)*(log(sqrt(2))-1)+(3-sqrt(2))*(log(3-sqrt(2))-1))"},
      {"sqrt(x^4-4*x^2+4)", "0", "3", "3+8*sqrt(2)/3"},
      {"sqrt(pi*x^2-2*pi^2*x+pi^3)", "0", "5", "sqrt(pi)*(pi^2+(5-pi)^2)/2"},
      // Inverse functions at the ends of their domains.
      {"asin(x/sqrt(3))", "0", "sqrt(3)", "sqrt(3)*(pi/2-1)"},
      {"acos(x^2/2)*x", "0", "sqrt(2)", "1"},
      {"acosh(x/sqrt(3))", "sqrt(3)", "2", "2*acosh(2/sqrt(3))-1"},
      {"atanh(exp(x)/3)*exp(x)/3", "0", "log(3)", "log(2)-atanh(1/3)/3-log(8/9)/2"},
      {"asin(sqrt(x/pi))/sqrt(x)", "0", "pi", "sqrt(pi)*(pi-2)"},
      // Absolute values that vanish, or have poles, at the limits and between them.
      {"log(abs(sin(x)))", "0", "2*pi", "-2*pi*log(2)"},
      {"log(abs(cos(x)))", "0", "pi", "-pi*log(2)"},
      {"log(abs(sin(x)/cos(x)))", "pi/4", "3*pi/4", "2*catalan"},
      {"sqrt(abs(tan(x)))", "0", "2*pi", "2*pi*sqrt(2)"},
      {"log(abs((x-sqrt(2))*(x-2*sqrt(2))))", "0", "2*sqrt(2)",
       "2*sqrt(2)*log(2*sqrt(2))+2*sqrt(2)*log(sqrt(2))-4*sqrt(2)"},
      {"abs((x-sqrt(3))*(x-sqrt(2)))^(-1/2)", "sqrt(2)", "sqrt(3)", "pi"},
      // 0/0, at an end and between the limits.
      {"tan(x)*cos(x)", "1", "2", "cos(1)-cos(2)"},
      {"(x^2-2)/(x-sqrt(2))", "0", "2", "2+2*sqrt(2)"},
      {"(x^3-5)/(x-cbrt(5))", "1", "cbrt(5)",
       "(5-1)/3+cbrt(5)/2*(cbrt(5)^2-1)+cbrt(5)^2*(cbrt(5)-1)"},
      {"(x-log(3))/(exp(x)-3)*exp(x)*(exp(x)-3)/(x-log(3))", "0", "2", "exp(2)-1"},
      {"sin(x-pi/3)/(x-pi/3)*(x-pi/3)", "0", "pi", "cos(pi/3)-cos(2*pi/3)"},
  };
  expect_values(all);
}

// A second zero close to the one at the end.
TEST(TurningPoints, HaveBreaksBesideThem) {
  for (const char* from : {"0", "1", "6/5"}) {
    const auto over = [&](const char* f) { return support::integral_of(f, from, "sqrt(2)"); };
    const integral both = over("log(abs((x-sqrt(2))*(x*exp(x)-4)))");
    EXPECT_EQ(both.verdict, status::certified) << from;
    EXPECT_TRUE(overlaps(both.enclosure,
                         over("log(sqrt(2)-x)").enclosure + over("log(abs(x*exp(x)-4))").enclosure))
        << from;
  }
}

// Special functions at points where they are regular, and at the ends that have a majorant alone.
TEST(TurningPoints, OfSpecialFunctions) {
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  expect_values({
      {"(besselJ(0,x)-2*besselJ(1,x)/x)/x", "0", "2", "besselJ(1,2)/2-1/2"},
      {"(1-besselJ(0,x)-x*besselJ(1,x))/x^2", "0", "2", "(besselJ(0,2)-1)/2"},
      {"(Si(x)-sin(x))/x^2", "0", "3", "1-Si(3)/3"},
      {"(lambertW(x)-x/(1+lambertW(x))/exp(lambertW(x)))/x^2", "0", "1", "1-lambertW(1)"},
      {"(dilog(x)+log(1-x))/x^2", "0", "1/2", "1-2*dilog(1/2)"},
      {"besselK(0,x)", "0", "inf", "pi/2"},
      {"besselK(0,x)*cos(x)", "0", "inf", "pi/(2*sqrt(2))"},
      {"x*besselK(1,x)", "0", "inf", "pi/2"},
      {"expint(1,x)", "0", "inf", "1"},
      {"expint(1,x)/sqrt(x)", "0", "inf", "2*sqrt(pi)"},
      {"Ei(-x)*exp(-x)", "0", "inf", "-log(2)"},
      {"Ci(x)*exp(-x)", "0", "inf", "-log(2)/2"},
      {"besselY(0,x)*exp(-x)", "0", "inf", "-2/(pi*sqrt(2))*asinh(1)"},
      {"besselJ(0,x)*exp(-x/2)", "0", "inf", "2/sqrt(5)"},
      {"airyAi(x)", "0", "inf", "1/3"},
      {"dilog(x)", "0", "1", "pi^2/6-1"},
      {"dilog(1-x)", "0", "2", "pi^2/6-1+dilog(-1)+2*log(2)-1"},
      {"besselJ(1/2,x)*sqrt(x)", "0", "pi", "2*sqrt(2/pi)"},
      {"besselJ(-1/2,x)*sqrt(x)/(1+x^2)", "0", "inf", "sqrt(pi/2)/e"},
      {"polylog(2,x)/x", "0", "1", "zeta(3)"},
      {"x^2*polylog(3,exp(-x))", "0", "inf", "2*zeta(6)"},
      {"polylog(5/2,-exp(-x))", "0", "inf", "polylog(7/2,-1)"},
      {"dawson(x)/x", "0", "inf", "pi^(3/2)/4"},
      {"erfcx(x)*exp(-x^2)", "0", "inf", "1/sqrt(pi)"},
      {"gammaUpper(3/2,x)/sqrt(x)", "0", "inf", "2"},
      {"gammaLower(3/2,x)/x^2", "0", "inf", "sqrt(pi)"},
      {"polygamma(2,x)", "1", "inf", "-pi^2/6"},
      // Where what cancels their poles, or is 0 there, stands beside them.
      {"digamma(x)+1/x", "0", "1/2", "log(sqrt(pi)/2)"},
      {"gamma(x)*digamma(x)+1/x^2", "0", "1", "euler_gamma"},
      {"gamma(x)*digamma(x)-1/(x+1)^2", "-1", "-1/2", "3-2*sqrt(pi)-euler_gamma"},
      {"(digamma(1+x)-log_gamma(1+x)/x)/x", "0", "1", "euler_gamma"},
      {"(digamma(1-x)+log_gamma(1-x)/x)/x", "0", "1/2", "euler_gamma-log(pi)"},
      {"gamma(x)*((digamma(x)+1/x)*x-1)/x+1/x^2", "0", "1", "euler_gamma"},
      {"polygamma(1,x)-1/x^2", "0", "1", "1"},
      {"polygamma(3,sin(x))*cos(x)-6*cos(x)/sin(x)^4", "0", "pi/2",
       "polygamma(2,2)-polygamma(2,1)"},
      {"2*(x+1)*digamma(x)+(x+1)^2*polygamma(1,x)", "-1", "-1/2", "digamma(-1/2)/4"},
      // By Weber's integral.
      {"besselJ(0,x)", "0", "inf", "1"},
      {"besselJ(1,3*x)/x", "0", "inf", "1"},
      {"besselJ(0,2*x)/sqrt(x)", "0", "inf", "gamma(1/4)/(2*gamma(3/4))"},
      {"3*besselJ(2,x)/x^2-pi*besselJ(0,x)", "0", "inf", "1-pi"},
      {"x^(1/4)*besselJ(1/2,x/5)", "0", "inf", "10^(1/4)*5*gamma(7/8)/gamma(5/8)"},
      {"besselJ(0,x)", "-inf", "inf", "2"},
      {"besselJ(1,x)/x", "-inf", "inf", "2"},
      {"besselJ(3,x)", "-inf", "0", "-1"},
  });
}

TEST(TurningPoints, WebersIntegralConverges) {
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  for (const char* f : {"sqrt(x)*besselJ(0,x)", "x*besselJ(1,x)", "besselJ(0,x)/x",
                        "besselJ(2,x)/x^3", "besselJ(0,0*x)", "besselJ(0,x)*x^(-5/4)"}) {
    EXPECT_EQ(support::integral_of(f, "0", "inf").verdict, status::not_certified) << f;
  }
}

/// Coefficients cancel, of a function of x + x^2 as well: with y = x + x^2 the two are the same.
TEST(TurningPoints, CoefficientsOfSpecialFunctionsAreExact) {
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  const std::string of_x = "(besselJ(0,x)-1+x^2/4)/x^4";
  const std::string of_y = "(besselJ(0,x+x^2)-1+(x+x^2)^2/4)/(x+x^2)^4*(1+2*x)";
  const integral one = support::integral_of(of_x, "0", "2");
  const integral other = support::integral_of(of_y, "0", "1");
  EXPECT_EQ(one.verdict, status::certified) << one.obstacle;
  EXPECT_EQ(other.verdict, status::certified) << other.obstacle;
  EXPECT_TRUE(overlaps(one.enclosure, other.enclosure));
}

// sqrt(x) c is c t^(1/2): with x = tau^2 the integrand is 2 c tau^2, and with a cube root 3 c
// tau^3.
TEST(TurningPoints, ARootOfASeriesHasItsBounds) {
  const auto plan_of = [](const char* f) {
    return detail::ends::look_at_end(
        integrand_of(parse(f)), detail::ends::end_of_range::finite(end_point(0), end_point(1)));
  };
  for (const long d : {2L, 3L}) {
    const detail::ends::end_plan plan = plan_of(d == 2 ? "5*sqrt(x)" : "5*x^(1/3)");
    EXPECT_EQ(plan.how, detail::ends::manner::power);
    EXPECT_EQ(plan.q, d);
    EXPECT_EQ(plan.exponent, d);
    ASSERT_EQ(plan.bounds.size(), 1U);
    EXPECT_GE(plan.bounds[0], magnitude::from_integer_down(static_cast<std::uint64_t>(5 * d)));
    EXPECT_LE(pow(double_interval(plan.r), d).upper(), 0.5);
  }
}

// What no series in powers of the distance, or of 1/x, describes: by a change of the variable to an
// exponential.
TEST(ByAnExponential, HaveTheKnownValues) {
  const std::vector<known> all{
      {"exp(-x)*cosh(sqrt(x))", "0", "inf", "1+sqrt(pi)/2*exp(1/4)*erf(1/2)"},
      {"airyAi(x)*exp(x)", "-inf", "inf", "exp(1/3)"},
      {"(1-x)^(-1/sqrt(2))", "0", "1", "1/(1-1/sqrt(2))"},
      {"sin(x)^pi", "0", "pi", "sqrt(pi)*gamma((pi+1)/2)/gamma(pi/2+1)"},
      {"x^(1/sqrt(2)-1)*(1-x)^(1/sqrt(3)-1)", "0", "1",
       "gamma(1/sqrt(2))*gamma(1/sqrt(3))/gamma(1/sqrt(2)+1/sqrt(3))"},
      {"x^(-1+1e-8)", "0", "1", "1e8"},
      {"x^(-99999999/100000000)", "0", "1", "1e8"},
      {"(1-x)^(-1+1e-8)", "0", "1", "1e8"},
      {"1/(x*log(x)^2)", "2", "inf", "1/log(2)"},
      {"1/(x*log(x)^2)", "0", "1/2", "1/log(2)"},
      {"1/(x*log(x)*log(log(x))^2)", "3", "inf", "1/log(log(3))"},
      {"1/((2-x)*log(2-x)^2)", "3/2", "2", "1/log(2)"},
      {"x^(-1-1e-8)", "1", "inf", "1e8"},
      {"exp(-log(x)^2)", "0", "inf", "sqrt(pi)*exp(1/4)"},
      {"exp(-log(x)^2/2)/x", "0", "inf", "sqrt(2*pi)"},
      {"exp(-sqrt(log(x)))/x", "1", "inf", "2"},
      {"exp(-x^(1/3))", "0", "inf", "6"},
      {"exp(-x^pi)", "0", "inf", "gamma(1+1/pi)"},
      {"x*exp(-x)/tanh(x)", "0", "inf", "pi^2/4-1"},
      {"(exp(-x)-1/(1+x))/x", "0", "inf", "-euler_gamma"},
      {"exp(-(-x)^pi)", "-inf", "0", "gamma(1+1/pi)"},
      {"1/(x*(1+log(x)^2))", "0", "inf", "pi"},
  };
  for (const known& k : all) {
    const auto end = [](const std::string& text) {
      return text == "inf"    ? end_point::infinity()
             : text == "-inf" ? -end_point::infinity()
                              : number(text);
    };
    const integral i = integrate(parse(k.f), end(k.from), end(k.to), {.digits = 25});
    EXPECT_EQ(i.verdict, status::certified) << k.f << ": " << i.obstacle;
    EXPECT_TRUE(overlaps(i.enclosure, parse(k.value, {}).value(300))) << k.f;
  }
}

// Of functions of which no arithmetic of ends knows anything: refused, or certified, and no crash.
// Irrational powers of 1 - cos(x) and its like: without a difference of numbers near 1.
TEST(ByAnExponential, DifferencesFromOneKeepTheirSize) {
  const std::vector<known> all{
      {"(1-cos(x))^(-1/sqrt(7))*sin(x)", "0", "1", "(1-cos(1))^(1-1/sqrt(7))/(1-1/sqrt(7))"},
      {"-(cos(x^2)-1)^1*(1-cos(x^2))^(-1/pi)*x*sin(x^2)", "0", "1",
       "(1-cos(1))^(3-1/pi-1)/(2*(2-1/pi))"},
      {"(1+cos(x))^(-1/pi)*sin(x)", "2", "pi", "(1+cos(2))^(1-1/pi)/(1-1/pi)"},
      {"(cosh(x)-1)^(-1/pi)*sinh(x)", "0", "1", "(cosh(1)-1)^(1-1/pi)/(1-1/pi)"},
      {"(exp(x)-1)^(-1/sqrt(2))*exp(x)", "0", "1", "(e-1)^(1-1/sqrt(2))/(1-1/sqrt(2))"},
      {"(1-exp(-x))^(-1/sqrt(2))*exp(-x)", "0", "1", "(1-1/e)^(1-1/sqrt(2))/(1-1/sqrt(2))"},
      {"expm1(x)^(-1/sqrt(2))*exp(x)", "0", "1", "(e-1)^(1-1/sqrt(2))/(1-1/sqrt(2))"},
      {"log1p(x)^(sqrt(2)-2)/(1+x)", "0", "1", "log(2)^(sqrt(2)-1)/(sqrt(2)-1)"},
      {"log(1+x^2)^(sqrt(2)-2)*2*x/(1+x^2)", "0", "1", "log(2)^(sqrt(2)-1)/(sqrt(2)-1)"},
      {"(-log(1-x))^(sqrt(2)-2)/(1-x)", "0", "1/2", "log(2)^(sqrt(2)-1)/(sqrt(2)-1)"},
      {"(sqrt(1+x)-1)^(sqrt(2)-2)/sqrt(1+x)", "0", "1", "2*(sqrt(2)-1)^(sqrt(2)-1)/(sqrt(2)-1)"},
      {"(1-sqrt(1-x))^(sqrt(2)-2)/sqrt(1-x)", "0", "1/2",
       "2*(1-sqrt(1/2))^(sqrt(2)-1)/(sqrt(2)-1)"},
  };
  expect_values(all);
}

TEST(ByAnExponential, UnknownFunctionsAreRefused) {
  for (const char* f : {"log1p(sin(gamma(x)))*exp(-x)", "expm1(-gamma(x))",
                        "sinpi(log_gamma(x))/x^2", "cospi(agm(x,2))/x^pi"}) {
    const integral i = integrate(parse(f), 1, end_point::infinity(), {.digits = 10});
    EXPECT_EQ(i.verdict, status::not_certified) << f;
  }
}

TEST(ByAnExponential, DivergentTwinsAreNotCertified) {
  for (const known& k : std::vector<known>{{"1/(x*log(x))", "2", "inf", ""},
                                           {"1/(x*log(x)*log(log(x)))", "3", "inf", ""},
                                           {"1/(x*abs(log(x)))", "0", "1/2", ""},
                                           {"x^(-1+1e-8)/log(x)^2", "2", "inf", ""},
                                           {"exp(sqrt(log(x)))/x", "1", "inf", ""},
                                           {"(2-x)^(-sqrt(2))", "0", "2", ""},
                                           {"exp(-1/x^pi)", "1", "inf", ""},
                                           {"sin(x)^(-pi/3)", "0", "1", ""}}) {
    const integral i =
        integrate(parse(k.f), number(k.from), k.to == "inf" ? end_point::infinity() : number(k.to),
                  {.digits = 10});
    EXPECT_EQ(i.verdict, status::not_certified) << k.f;
  }
}

TEST(TurningPoints, AgreeWithTheSameWithoutCancellation) {
  struct pair {
    std::string f;
    std::string same;
    std::string from;
    std::string to;
  };
  for (const pair& p :
       std::vector<pair>{{"(exp(1-x)-exp(1))/x", "exp(1)*expm1(-x)/x", "0", "1"},
                         {"(cos(1+x)-cos(1))/x", "-2*sin(1+x/2)*sin(x/2)/x", "0", "1"},
                         {"(exp(x)-exp(1))/(x-1)", "exp(1)*expm1(x-1)/(x-1)", "0", "2"},
                         {"sin(pi*x)/(x-1)", "-sin(pi*(x-1))/(x-1)", "0", "2"},
                         {"(1-erfc(x))/x", "erf(x)/x", "0", "1"}}) {
    const integral i = support::integral_of(p.f, p.from, p.to);
    const integral j = support::integral_of(p.same, p.from, p.to);
    EXPECT_EQ(i.verdict, status::certified) << p.f << ": " << i.obstacle;
    EXPECT_EQ(j.verdict, status::certified) << p.same << ": " << j.obstacle;
    EXPECT_TRUE(overlaps(i.enclosure, j.enclosure)) << p.f;
  }
  // 2/sqrt(pi) times the sum of (-1)^n / (n! (2n + 1)^2).
  ball sum(0, 200);
  rational factorial = 1;
  for (long n = 0; n < 40; ++n) {
    if (n > 0) factorial *= n;
    sum += rational(n % 2 == 0 ? 1 : -1) / (factorial * ((2 * n + 1) * (2 * n + 1)));
  }
  // The rest of an alternating series is less than its first term.
  sum = sum.enlarged(magnitude::power_of_two(-140));
  EXPECT_TRUE(
      overlaps(support::integral_of("erf(x)/x", "0", "1").enclosure, 2 / sqrt(pi(200)) * sum));
}

TEST(TurningPoints, DivergentTwinsAreNotCertified) {
  for (const known& k : std::vector<known>{{"1/(2-x^2)", "0", "sqrt(2)", ""},
                                           {"1/(cos(x)-cos(1))", "0", "1", ""},
                                           {"(2-x^2)^(-3/2)", "1", "sqrt(2)", ""},
                                           {"(exp(x)-exp(1))/(x-1)^2", "0", "2", ""},
                                           {"(exp(x)-exp(1))/(x-1)^2", "0", "1", ""},
                                           {"(x^2-2)/(x-sqrt(2))^2", "0", "2", ""},
                                           {"1/((pi-x)*sqrt(pi-x))", "0", "pi", ""},
                                           {"sin(x)/(x-pi)^2", "0", "pi", ""},
                                           {"(exp(1-x)-exp(1))/x^2", "0", "1", ""}}) {
    const integral i = support::integral_of(k.f, k.from, k.to, 10);
    EXPECT_EQ(i.verdict, status::not_certified) << k.f;
    EXPECT_EQ(i.why, reason::not_integrable) << k.f << ": " << i.obstacle;
  }
}

// Multiples of pi that cancel, in values at infinity and beside ends that are multiples of pi.
TEST(TurningPoints, MultiplesOfPiCancel) {
  const std::vector<known> all{
      {"(atan(2*x)-atan(x))/x", "0", "inf", "pi/2*log(2)"},
      {"(pi/2-atan(x))/x", "1", "inf", "catalan"},
      {"(pi/2+atan(x))/x", "-inf", "-1", "-catalan"},
      {"(pi/2-atan(x))/sqrt(x)", "0", "inf", "sqrt(2)*pi"},
      {"(acos(x)-pi/2)/x", "0", "1", "-pi/2*log(2)"},
      {"(asin(x)-pi/2)/(x-1)", "0", "1", "pi/2*log(2)+2*catalan"},
      {"(asin(x)+pi/2)/(x+1)", "-1", "0", "pi/2*log(2)+2*catalan"},
      {"(pi-acos(x))/(x+1)", "-1", "0", "pi/2*log(2)+2*catalan"},
      {"tan(x)-1/(pi/2-x)", "0", "pi/2", "-log(pi/2)"},
      {"1/sin(x)-1/(pi-x)", "1", "pi", "log(2)-log(tan(1/2))-log(pi-1)"},
      {"1/sin(x)-1/x-1/(pi-x)", "0", "pi", "2*log(2/pi)"},
      {"1/sin(x)^2-1/(pi-x)^2", "1", "pi", "cot(1)+1/(pi-1)"},
      {"1/tan(x-1)+1/(1+pi-x)", "3", "1+pi", "-log(sin(2)/(pi-2))"},
  };
  expect_values(all);
  for (const auto& [f, from, to] :
       std::vector<std::array<const char*, 3>>{{"atan(2*x)-atan(3*x)", "0", "inf"},
                                               {"(atan(2*x)-2*atan(x))/x", "1", "inf"},
                                               {"pi/2-atan(x)", "0", "inf"},
                                               {"(pi/2+atan(x))/x", "1", "inf"},
                                               {"(asin(x)+pi/2)/(x-1)", "0", "1"},
                                               {"tan(x)-2/(pi/2-x)", "0", "pi/2"},
                                               {"1/sin(x)^2-1/(pi-x)^2-1/(pi-x)", "1", "pi"}}) {
    const integral i = support::integral_of(f, from, to);
    EXPECT_EQ(i.why, reason::not_integrable) << f;
  }
}

// A step at the end: the value of floor there is not its limit, so what is made of it is not known.
TEST(TurningPoints, ConstantsOfAnyKindCancel) {
  const std::vector<known> all{
      {"1/(exp(x)-2)-1/(2*(x-log(2)))", "log(2)", "1", "log((1-2/e)/(1-log(2)))/2"},
      {"1/(exp(x)-2)-1/(2*(x-log(2)))", "0", "1", "log((1-2/e)/(1-log(2)))/2-log((2-1)/log(2))/2"},
      {"1/(x^2-2)-1/(2*sqrt(2)*(x-sqrt(2)))", "1", "2",
       "-log((2+sqrt(2))/(1+sqrt(2)))/(2*sqrt(2))"},
      {"acosh(x)-log(2*x)", "1", "inf", "log(2)-1"},
      {"asinh(x)-log(x)-log(2)", "1", "inf", "sqrt(2)-asinh(1)-1+log(2)"},
      {"x*(sqrt(2*x^2+1)-sqrt(2)*x)-1/(2*sqrt(2))", "0", "inf", "-1/6"},
      {"1/tan(x-sqrt(2))-1/(x-sqrt(2))", "1", "2",
       "log(sin(2-sqrt(2))/(2-sqrt(2)))-log(sin(sqrt(2)-1)/(sqrt(2)-1))"},
      {"(erf(1+x)-erf(1))/x*x", "0", "1",
       "2*erf(2)-erf(1)+exp(-4)/sqrt(pi)-exp(-1)/sqrt(pi)-erf(1)"},
      // The coefficients after the first one cancel as well.
      {"(exp(1+x)-e-e*x-e*x^2/2)/x^(7/2)*x^(5/2)*x", "0", "1", "e^2-e-e-e/2-e/6"},
  };
  expect_values(all);
  // Constants that differ by less than what enclosures tell apart do not.
  const std::vector<known> others{
      {"1/(exp(x)-2)-(1+1e-60)/(2*(x-log(2)))", "log(2)", "1", ""},
      {"1/(x^2-2)-1/(2*sqrt(2)*(x-sqrt(2)))+1e-50/(x-sqrt(2))", "sqrt(2)", "2", ""},
      {"1/(x^2-2)-1/(2*sqrt(2+1e-70)*(x-sqrt(2)))", "1", "2", ""},
      {"asinh(x)-log(x)-log(2)+1e-45", "1", "inf", ""},
      {"1/tan(x-sqrt(2))-1/(x-sqrt(2)-1e-40)", "1", "2", ""},
  };
  for (const known& k : others) {
    EXPECT_NE(support::integral_of(k.f, k.from, k.to).verdict, status::certified) << k.f;
  }
}

TEST(TurningPoints, StepsHaveNoKnownValuesAtAnEnd) {
  // On (0, 1) floor(x) = 0: 1/sqrt(1 - x).
  const integral i = support::integral_of("1/sqrt(1-x-sin(pi*floor(x))+floor(x)*0)", "0", "1", 15);
  if (i.verdict == status::certified) {
    EXPECT_TRUE(contains(i.enclosure, rational(2)));
  }
  // (1 - floor(x)) x is x there, not 0: 1/x from 1/2 to 1 has no singularity at 1.
  const integral j = support::integral_of("1/((1-floor(x))*x)", "1/2", "1", 15);
  if (j.enclosure.is_bounded()) {
    EXPECT_TRUE(overlaps(j.enclosure, log(ball(2, 128))));
  }
  EXPECT_NE(j.why, reason::not_integrable);
}

TEST(TurningPoints, OfTheLeastExponentIsRefused) {
  for (const char* text :
       {"abs(x)*x^(-9223372036854775808)", "abs(1/x)*x^(-9223372036854775808)"}) {
    const integral i = integrate(expression(text, {{"x"}, {}}), 0, 1, {.digits = 10});
    EXPECT_EQ(i.verdict, status::not_certified) << text;
  }
}

}  // namespace turning_points_test
}  // namespace polhode
