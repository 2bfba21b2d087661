#include "polhode/real/integrate.hpp"

#include <gtest/gtest.h>

#include <cerrno>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_d.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "polhode/arithmetic/text.hpp"
#include "polhode/real/contour.hpp"
#include "polhode/real/estimate.hpp"
#include "polhode/real/roots.hpp"

// The functions are a person's, outside the library's namespace.
namespace integrate_test {

using namespace polhode;

namespace mp = boost::multiprecision;
using et_off_50 = mp::number<mp::mpfr_float_backend<50>, mp::et_off>;
using cpp_off_50 = mp::number<mp::cpp_bin_float<50>, mp::et_off>;

/// |value - truth| in units of 10^-digits of the truth.
template <class Real>
double error_in(const Real& value, const ball& truth, long digits) {
  const ball off = abs(ball_of(value) - truth) / abs(truth) * pow(ball(10, 300), digits);
  return upper_as<double>(off);
}

template <class Real>
class RealIntegrals : public testing::Test {};
using reals = testing::Types<double, long double, mp::mpfr_float_50, et_off_50, mp::mpfr_float_100,
                             mp::mpfr_float, mp::cpp_bin_float_50, cpp_off_50>;
TYPED_TEST_SUITE(RealIntegrals, reals);

template <class Real, class F>
void expect_integral(const char* what, const F& f, const range_limit<Real>& a,
                     const range_limit<Real>& b) {
  const rounded_integral<Real> i = integrate<Real>(f, a, b);
  EXPECT_EQ(i.verdict, truncation_verdict::proved) << what << ": " << i.obstacle;
  const ball truth = integrate<ball>(f, a.point(), b.point(), {.digits = 120}).enclosure;
  const long digits = detail::digits_in_bits(usual_bits<Real>()) - 1;
  EXPECT_LT(error_in(i.value, truth, digits), 100) << what << " " << i.value;
  const Real size = i.value < 0 ? Real(-i.value) : i.value;
  EXPECT_LT(i.truncation_error, size * pow(Real(10), static_cast<int>(1 - digits))) << what;
}

TYPED_TEST(RealIntegrals, HaveTheirDigits) {
  using Real = TypeParam;
  if constexpr (detail::has_variable_precision<Real>) Real::thread_default_precision(40);
  expect_integral<Real>(
      "smooth", [](auto x) { return sin(x + exp(x)); }, 0, 1);
  expect_integral<Real>(
      "exact numbers", [](auto x) { return exp("0.1"_r * x + 0.5) * sin(x * x); }, 0, 2);
  expect_integral<Real>(
      "rational", [](auto x) { return x / (1 + x * x) + rational(1, 3) * sin(exp(x)); }, -1, 2);
  expect_integral<Real>(
      "tail", [](auto x) { return exp(-x * x) * cos(x) / (1 + x * x); }, -end_point::infinity(),
      end_point::infinity());
  expect_integral<Real>(
      "logarithm at 0", [](auto x) { return log(x) * sin(1 + x); }, 0, 1);
  expect_integral<Real>(
      "singular at 1", [](auto x) { return exp(sin(x)) / sqrt(1 - x * x); }, 0, 1);
  expect_integral<Real>(
      "logarithm at 1", [](auto x) { return log(1 - x) * sin(x); }, 0, 1);
  expect_integral<Real>(
      "kink", [](auto x) { return abs(x - 0.25) * exp(sin(x)); }, -1, 1);
  expect_integral<Real>(
      "period", [](auto x) { return exp(cos(x)); }, 0, end_point::pi(2));
}

TYPED_TEST(RealIntegrals, TakeBoostsConstantsAndFunctions) {
  using Real = TypeParam;
  if constexpr (detail::has_variable_precision<Real>) Real::thread_default_precision(40);
  expect_integral<Real>(
      "elliptic",
      [](auto k) {
        using T = decltype(k);
        return T(boost::math::ellint_1(T(k / 2)) * boost::math::ellint_2(T(k / 3)) +
                 boost::math::constants::pi<T>() * sin(k));
      },
      0, 1);
  expect_integral<Real>(
      "error function",
      [](auto x) {
        using T = decltype(x);
        return T(boost::math::erf(x) * exp(T(x * boost::math::constants::half_pi<T>())));
      },
      0, 1);
}

// Bounds of f over a set must not be made of values in Real, which miss a peak between the nodes.
TYPED_TEST(RealIntegrals, OfNarrowPeaksAreSeen) {
  using Real = TypeParam;
  if constexpr (detail::has_variable_precision<Real>) Real::thread_default_precision(40);
  expect_integral<Real>(
      "peak at 1/3", [](auto x) { return exp(-1e8 * (x - "1/3"_r) * (x - "1/3"_r)); }, -4, 4);
  expect_integral<Real>(
      "wide range", [](auto x) { return exp(-x * x); }, -1000, 1000);
  expect_integral<Real>(
      "pole beside", [](auto x) { return exp(sin(x)) / (1e-8_r + (x - "2/7"_r) * (x - "2/7"_r)); },
      -1, 1);
  expect_integral<Real>(
      "two heights",
      [](auto x) { return exp(-10000 * (x - "1/7"_r) * (x - "1/7"_r)) + sin(exp(x)) / 1000000; },
      -1, 1);
}

TEST(RealIntegral, IsSummedOverThePersonsOwnFunction) {
  // Of numbers, which values are counted; of an expression template the formula is evaluated in its
  // place.
  int calls = 0;
  const auto f = [&calls](auto x) {
    if constexpr (std::same_as<decltype(x), et_off_50>) ++calls;
    return sin(x + exp(x));
  };
  const auto i = integrate<et_off_50>(f, 0, 1);
  EXPECT_GE(calls, i.account.evaluations);
  EXPECT_GT(i.account.evaluations, 10);
  static_assert(detail::returns_a_number<decltype(f), et_off_50>);
  static_assert(!detail::returns_a_number<decltype(f), mp::mpfr_float_50>);
}

TEST(RealIntegral, OfAConstantsDecimalIsThatOfTheDecimal) {
  // mpfr_float_50's pi is a number beside pi, and the integral that of the number.
  const mp::mpfr_float_50 about_pi = boost::math::constants::pi<mp::mpfr_float_50>();
  const auto f = [&](auto x) { return about_pi + 0 * x; };
  const ball i = integrate<ball>(f, 0, 1, {.digits = 80}).enclosure;
  EXPECT_TRUE(contains(i, ball_of(about_pi)));
  EXPECT_FALSE(overlaps(i, pi(400)));
  const auto g = [](auto x) { return boost::math::constants::pi<decltype(x)>() + 0 * x; };
  EXPECT_TRUE(overlaps(integrate<ball>(g, 0, 1, {.digits = 80}).enclosure, pi(400)));
}

TEST(RealIntegral, TruncationErrorAndRoundedValueHoldTheIntegral) {
  // Digits beyond those of the type: what is left is the truncation error, a bound of it, and
  // roundings of 50 digits.
  real_integrate_options few;
  few.digits = 8;
  const auto f = [](auto x) { return sin(x + exp(x)) / (2 + cos(3 * x)); };
  const auto i = integrate<mp::mpfr_float_50>(f, 0, 3, few);
  const ball truth = integrate<ball>(f, 0, 3, {.digits = 60}).enclosure;
  const ball off = abs(ball_of(i.value) - truth);
  EXPECT_TRUE(certainly_less(off, ball_of(mp::mpfr_float_50(i.truncation_error + 1e-45))));
  EXPECT_LT(i.truncation_error, 1e-7);
}

TEST(RealIntegral, WhatAFunctionThrowsBeyondItsDomainIsNoEnd) {
  // Near 1 a node rounds to 1, where Boost's K throws.
  const auto f = [](auto k) {
    using T = decltype(k);
    return T(boost::math::ellint_1(T(sqrt(1 - k * k))) * k);
  };
  const auto i = integrate<double>(f, "1/1000000"_r, 1);
  EXPECT_EQ(i.verdict, truncation_verdict::proved) << i.obstacle;
  EXPECT_NEAR(i.value, 1, 1e-9);
  // What is no such error comes through.
  struct stop {};
  const auto g = [](auto x) {
    if constexpr (std::same_as<decltype(x), double>) throw stop();
    return sin(x + exp(x));
  };
  EXPECT_THROW(static_cast<void>(integrate<double>(g, 0, 1)), stop);
}

// In double e^(800 x) e^(-800 x) is no number for x > 0.9: there the formula's own values are
// taken.
TEST(RealIntegral, WhereRealHasNoValueTheFormulaHas) {
  const auto f = [](auto x) { return exp(800 * x) * exp(-800 * x) * sin(x + exp(x)); };
  const auto i = integrate<double>(f, 0, 1);
  EXPECT_EQ(i.verdict, truncation_verdict::proved) << i.obstacle;
  EXPECT_NEAR(i.value, 0.58627280681013268546, 1e-12);
}

TEST(RealIntegral, ReportsThePriceOfCertainty) {
  real_integrate_options options;
  options.report = true;
  const auto i = integrate<double>([](auto x) { return sin(x + exp(x)); }, 0, 1, options);
  ASSERT_TRUE(i.price);
  EXPECT_GT(i.price->ratio(), 0);
  EXPECT_TRUE(i.price->enclosure.is_bounded());
  EXPECT_LT(error_in(i.value, i.price->enclosure, 15), 10);
}

TEST(RealIntegral, EndsAreWhatTheyAre) {
  const auto f = [](auto x) { return x; };
  using Real = mp::mpfr_float_50;
  EXPECT_EQ(integrate<Real>(f, 1, 0).value, Real(-0.5));
  EXPECT_EQ(integrate<Real>(f, 0, 0.5).value, Real(0.125));
  EXPECT_EQ(integrate<Real>(f, 0, Real(3)).value, Real(4.5));
  EXPECT_EQ(integrate<Real>(f, 0, Real(1) + Real(2)).value, Real(4.5));  // an expression template
  EXPECT_EQ(integrate<double>(f, 0, 3.0).value, 4.5);
  EXPECT_EQ(integrate<Real>(f, 0, "3"_r).value, Real(4.5));
  EXPECT_EQ(integrate<Real>(f, 0, sqrt(symbol(2))).value, Real(1));
  EXPECT_EQ(
      integrate<Real>([](auto x) { return exp(-x); }, 0, std::numeric_limits<Real>::infinity())
          .value,
      Real(1));
  EXPECT_THROW(static_cast<void>(integrate<Real>(f, 0, 0.1)), input_error);
  EXPECT_THROW(static_cast<void>(integrate<Real>(f, 0, std::numeric_limits<Real>::quiet_NaN())),
               input_error);
  real_integrate_options none;
  none.digits = 0;
  EXPECT_THROW(static_cast<void>(integrate<Real>(f, 0, 1, none)), input_error);
}

TEST(RealIntegral, OfVariablePrecisionHasThatOfItsEnds) {
  mp::mpfr_float::thread_default_precision(20);
  const auto f = [](auto x) { return sin(x + exp(x)); };
  const auto i = integrate<mp::mpfr_float>(f, 0, mp::mpfr_float(1, 90));
  EXPECT_GE(precision_of(i.value), 90 * 3.32);
  const ball truth = integrate<ball>(f, 0, 1, {.digits = 100}).enclosure;
  EXPECT_LT(error_in(i.value, truth, 88), 100);
  EXPECT_EQ(mp::mpfr_float::thread_default_precision(), 20U);
}

TEST(RealIntegral, NotProvedIsSaid) {
  const auto i = integrate<double>([](auto x) { return 1 / x; }, 0, 1);
  EXPECT_EQ(i.verdict, truncation_verdict::not_proved);
  EXPECT_EQ(i.why, reason::not_integrable);
  EXPECT_NE(i.obstacle, "");
  EXPECT_NE(i.value, i.value);
}

/// A double beside the variable is the number that it is, in integrate<double> and its like; a long
/// double in those of long double.
TEST(RealIntegral, NumbersOfTheTypeStandBesideTheVariable) {
  const double k = 0.3;
  const auto i = integrate<double>([k](auto x) { return k * x + 0.1 * exp(k * x); }, 0, 1);
  EXPECT_EQ(i.verdict, truncation_verdict::proved);
  EXPECT_EQ(to_text(i.verdict), "proved");
  const ball exact = integrate<ball>(
                         [k](auto x) {
                           const rational q(k);
                           return q * x + rational(0.1) * exp(q * x);
                         },
                         0, 1, {.digits = 30})
                         .enclosure;
  EXPECT_LE(std::abs(i.value - nearest_as<double>(exact)), 1e-15);
  const long double half = 0.3L;
  const auto j = integrate<long double>([half](auto x) { return half * x; }, 0, 2);
  EXPECT_LE(std::abs(j.value - 2 * half), 1e-18L);
  const auto r = find_root<double>([k](auto x) { return x - k; }, 0, 1);
  EXPECT_EQ(r.value, k);
  EXPECT_TRUE(r.exact == rational(k));
  mpfr_float::thread_default_precision(40);
  const auto m = integrate<mpfr_float>([k](auto x) { return mpfr_float(k) * x; }, 0, 2);
  EXPECT_EQ(m.verdict, truncation_verdict::proved);
  const auto p = [](auto x) { return boost::math::constants::pi<decltype(x)>() * x; };
  EXPECT_LE(std::abs(integrate<double>(p, 0, 2).value - 2 * 3.14159265358979323846), 1e-15);
}

TEST(RealIntegral, PoliciesDecide) {
  namespace policies = boost::math::policies;
  using quiet =
      policies::policy<policies::evaluation_error<policies::errno_on_error>,
                       policies::domain_error<policies::errno_on_error>, policies::digits10<8>>;
  const auto pole = [](auto x) { return 1 / x; };
  const auto smooth = [](auto x) { return sin(x + exp(x)); };
  EXPECT_THROW(static_cast<void>(integrate<double>(pole, 0, 1, {}, policies::policy<>())),
               boost::math::evaluation_error);
  EXPECT_THROW(
      static_cast<void>(integrate<double>(smooth, 0, std::nan(""), {}, policies::policy<>())),
      std::domain_error);
  errno = 0;
  const auto i = integrate<double>(pole, 0, 1, {}, quiet());
  EXPECT_EQ(errno, EDOM);
  EXPECT_NE(i.value, i.value);
  errno = 0;
  EXPECT_NE(integrate<double>(smooth, 0, std::nan(""), {}, quiet()).obstacle, "");
  EXPECT_EQ(errno, EDOM);
  errno = 0;
  const auto few = integrate<mp::mpfr_float_50>(smooth, 0, 1, {}, quiet());
  EXPECT_EQ(errno, 0);
  const auto all = integrate<mp::mpfr_float_50>(smooth, 0, 1);
  EXPECT_LT(few.account.evaluations, all.account.evaluations);
  EXPECT_LT(few.truncation_error, 1e-8);
}

TEST(RealPathIntegral, IsCertifiedWithItsRoundings) {
  using Real = mp::mpfr_float_50;
  const auto f = [](auto z) { return exp(z) / (z * z * z); };
  const auto i = integrate_along<Real>(f, path::circle(0, 1));
  EXPECT_EQ(i.verdict, status::certified);
  EXPECT_TRUE(certainly_less(abs(ball_of(i.im) - pi(400)), ball_of(i.im_error)));
  EXPECT_LT(i.im_error, 1e-49);
  EXPECT_LE(abs(i.re), i.re_error);
  EXPECT_EQ(integrate_along<ball>(f, path::circle(0, 1)).verdict, status::certified);
  EXPECT_EQ(integrate_along<Real>([](auto z) { return 1 / z; }, path::line(-1, 1)).verdict,
            status::not_certified);
}

TEST(Estimate, IsOfATypeOfItsOwn) {
  using Real = mp::mpfr_float_50;
  const auto f = [](const Real& x) { return Real(exp(-x * x)); };
  const estimated_integral<Real> i = estimate(f, Real(0), Real(1));
  EXPECT_EQ(i.method, "tanh_sinh");
  EXPECT_LT(abs(Real(i.value - Real("0.74682413281242702539946743613185300535449968681260"))),
            1e-45);
  EXPECT_EQ(estimate(f, Real(1), Real(0)).value, -i.value);
  const auto g = [](double x) { return std::exp(-x * x); };
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(estimate(g, 0.0, infinity).method, "exp_sinh");
  EXPECT_NEAR(estimate(g, -infinity, infinity).value, 1.7724538509055160, 1e-12);
  estimate_options kronrod;
  kronrod.rule = estimate_rule::gauss_kronrod;
  EXPECT_NEAR(estimate(g, 0.0, 1.0, kronrod).value, 0.74682413281242702, 1e-14);
  EXPECT_THROW(static_cast<void>(estimate(g, 0.0, std::nan(""))), input_error);
  estimate_options wrong;
  wrong.rule = estimate_rule::sinh_sinh;
  EXPECT_THROW(static_cast<void>(estimate(g, 0.0, 1.0, wrong)), input_error);
  static_assert(!std::is_convertible_v<estimated_integral<double>, rounded_integral<double>>);
}

// Boost's own values say whether its conventions are met.
TEST(BoostMath, ConventionsAreBoosts) {
  using boost::math::constants::pi;
  const auto value = [](const symbol& s) {
    return nearest_as<double>(formula_of(s, {}).value(128));
  };
  const auto s = [](long n, long d) { return symbol(n) / d; };
  EXPECT_NEAR(value(boost::math::ellint_1(s(1, 2))), boost::math::ellint_1(0.5), 1e-14);
  EXPECT_NEAR(value(boost::math::ellint_1(s(1, 2), s(1, 3))), boost::math::ellint_1(0.5, 1.0 / 3),
              1e-14);
  EXPECT_NEAR(value(boost::math::ellint_2(s(1, 2))), boost::math::ellint_2(0.5), 1e-14);
  EXPECT_NEAR(value(boost::math::ellint_2(s(1, 2), s(1, 3))), boost::math::ellint_2(0.5, 1.0 / 3),
              1e-14);
  EXPECT_NEAR(value(boost::math::ellint_3(s(1, 2), s(1, 5))), boost::math::ellint_3(0.5, 0.2),
              1e-14);
  EXPECT_NEAR(value(boost::math::ellint_3(s(1, 2), s(1, 5), s(1, 3))),
              boost::math::ellint_3(0.5, 0.2, 1.0 / 3), 1e-14);
  EXPECT_NEAR(value(boost::math::ellint_d(s(1, 2))), boost::math::ellint_d(0.5), 1e-14);
  EXPECT_NEAR(value(boost::math::ellint_d(s(1, 2), s(1, 3))), boost::math::ellint_d(0.5, 1.0 / 3),
              1e-14);
  EXPECT_NEAR(value(boost::math::ellint_rf(s(1, 2), s(1, 3), s(2, 1))),
              boost::math::ellint_rf(0.5, 1.0 / 3, 2.0), 1e-14);
  EXPECT_NEAR(value(boost::math::ellint_rd(s(1, 2), s(1, 3), s(2, 1))),
              boost::math::ellint_rd(0.5, 1.0 / 3, 2.0), 1e-14);
  EXPECT_NEAR(value(boost::math::ellint_rg(s(1, 2), s(1, 3), s(2, 1))),
              boost::math::ellint_rg(0.5, 1.0 / 3, 2.0), 1e-14);
  EXPECT_NEAR(value(boost::math::ellint_rj(s(1, 2), s(1, 3), s(2, 1), s(3, 2))),
              boost::math::ellint_rj(0.5, 1.0 / 3, 2.0, 1.5), 1e-14);
  EXPECT_NEAR(value(boost::math::ellint_rc(s(1, 2), s(1, 3))), boost::math::ellint_rc(0.5, 1.0 / 3),
              1e-14);
  EXPECT_NEAR(value(boost::math::jacobi_sn(s(1, 2), s(1, 3))), boost::math::jacobi_sn(0.5, 1.0 / 3),
              1e-14);
  EXPECT_NEAR(value(boost::math::jacobi_cn(s(1, 2), s(1, 3))), boost::math::jacobi_cn(0.5, 1.0 / 3),
              1e-14);
  EXPECT_NEAR(value(boost::math::jacobi_dn(s(1, 2), s(1, 3))), boost::math::jacobi_dn(0.5, 1.0 / 3),
              1e-14);
  EXPECT_NEAR(value(boost::math::tgamma(s(1, 3))), boost::math::tgamma(1.0 / 3), 1e-14);
  EXPECT_NEAR(value(boost::math::lgamma(s(1, 3))), boost::math::lgamma(1.0 / 3), 1e-14);
  EXPECT_NEAR(value(boost::math::sqrt1pm1(s(1, 3))), boost::math::sqrt1pm1(1.0 / 3), 1e-14);
  EXPECT_NEAR(value(boost::math::sin_pi(s(1, 5))), boost::math::sin_pi(0.2), 1e-14);
  EXPECT_NEAR(value(boost::math::cos_pi(s(1, 5))), boost::math::cos_pi(0.2), 1e-14);
  EXPECT_NEAR(value(boost::math::hypot(s(1, 2), s(1, 3))), boost::math::hypot(0.5, 1.0 / 3), 1e-14);
}

TEST(BoostMath, ConstantsAreBoosts) {
  namespace constants = boost::math::constants;
  using Real = mp::cpp_bin_float_50;
#define POLHODE_SAME(name)                                                                         \
  EXPECT_LT(                                                                                       \
      error_in(constants::name<Real>(), formula_of(constants::name<symbol>(), {}).value(300), 48), \
      10)                                                                                          \
      << #name
  POLHODE_SAME(half);
  POLHODE_SAME(third);
  POLHODE_SAME(two_thirds);
  POLHODE_SAME(sixth);
  POLHODE_SAME(three_quarters);
  POLHODE_SAME(root_two);
  POLHODE_SAME(root_three);
  POLHODE_SAME(half_root_two);
  POLHODE_SAME(one_div_root_two);
  POLHODE_SAME(ln_two);
  POLHODE_SAME(ln_ten);
  POLHODE_SAME(ln_ln_two);
  POLHODE_SAME(root_ln_four);
  POLHODE_SAME(log2_e);
  POLHODE_SAME(log10_e);
  POLHODE_SAME(one_div_log10_e);
  POLHODE_SAME(pi);
  POLHODE_SAME(half_pi);
  POLHODE_SAME(third_pi);
  POLHODE_SAME(quarter_pi);
  POLHODE_SAME(sixth_pi);
  POLHODE_SAME(two_pi);
  POLHODE_SAME(two_thirds_pi);
  POLHODE_SAME(three_quarters_pi);
  POLHODE_SAME(four_thirds_pi);
  POLHODE_SAME(pi_minus_three);
  POLHODE_SAME(four_minus_pi);
  POLHODE_SAME(one_div_pi);
  POLHODE_SAME(two_div_pi);
  POLHODE_SAME(one_div_two_pi);
  POLHODE_SAME(root_pi);
  POLHODE_SAME(root_half_pi);
  POLHODE_SAME(root_two_pi);
  POLHODE_SAME(log_root_two_pi);
  POLHODE_SAME(one_div_root_pi);
  POLHODE_SAME(root_one_div_pi);
  POLHODE_SAME(one_div_root_two_pi);
  POLHODE_SAME(two_div_root_pi);
  POLHODE_SAME(root_two_div_pi);
  POLHODE_SAME(pi_sqr);
  POLHODE_SAME(pi_sqr_div_six);
  POLHODE_SAME(pi_cubed);
  POLHODE_SAME(cbrt_pi);
  POLHODE_SAME(one_div_cbrt_pi);
  POLHODE_SAME(pi_pow_e);
  POLHODE_SAME(e);
  POLHODE_SAME(e_pow_pi);
  POLHODE_SAME(root_e);
  POLHODE_SAME(exp_minus_half);
  POLHODE_SAME(exp_minus_one);
  POLHODE_SAME(degree);
  POLHODE_SAME(radian);
  POLHODE_SAME(sin_one);
  POLHODE_SAME(cos_one);
  POLHODE_SAME(sinh_one);
  POLHODE_SAME(cosh_one);
  POLHODE_SAME(phi);
  POLHODE_SAME(ln_phi);
  POLHODE_SAME(euler);
  POLHODE_SAME(catalan);
  POLHODE_SAME(zeta_two);
  POLHODE_SAME(zeta_three);
#undef POLHODE_SAME
}

}  // namespace integrate_test
