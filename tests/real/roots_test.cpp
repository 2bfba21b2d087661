#include "polhode/real/roots.hpp"

#include <limits>

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "polhode/real/systems.hpp"

// The functions are a person's, outside the library's namespace.
namespace roots_test {

using namespace polhode;

namespace mp = boost::multiprecision;
using et_off_50 = mp::number<mp::mpfr_float_backend<50>, mp::et_off>;

template <class Real>
class RealRoots : public testing::Test {};
using reals = testing::Types<double, long double, mp::mpfr_float_50, et_off_50, mp::mpfr_float,
                             mp::cpp_bin_float_50>;
TYPED_TEST_SUITE(RealRoots, reals);

constexpr auto dottie = [](auto x) { return cos(x) - x; };

TYPED_TEST(RealRoots, AreBracketed) {
  using Real = TypeParam;
  if constexpr (detail::has_variable_precision<Real>) Real::thread_default_precision(40);
  const ball truth = find_root<ball>(dottie, 0, 1, {.digits = 120}).value;
  for (const root_engine engine :
       {root_engine::isolation, root_engine::toms748, root_engine::newton, root_engine::halley,
        root_engine::schroeder}) {
    real_root_options options;
    options.engine = engine;
    const certified_root<Real> r = find_root<Real>(dottie, 0, 1, options);
    EXPECT_EQ(r.verdict, root_verdict::unique) << r.remark;
    EXPECT_TRUE(r.reached);
    EXPECT_EQ(r.multiplicity, 1);
    EXPECT_TRUE(certainly_less_equal(ball_of(r.lower), truth));
    EXPECT_TRUE(certainly_less_equal(truth, ball_of(r.upper)));
    EXPECT_LE(r.lower, r.value);
    EXPECT_LE(r.value, r.upper);
    EXPECT_LE(r.lowest, r.lower);
    EXPECT_GE(r.greatest, r.upper);
    const Real width = r.upper - r.lower;
    EXPECT_LE(width, pow(Real(2), static_cast<int>(3 - usual_bits<Real>())));
    EXPECT_EQ(r.iterations > 0, engine != root_engine::isolation);
  }
}

TYPED_TEST(RealRoots, AllOfThem) {
  using Real = TypeParam;
  const certified_roots<Real> s =
      isolate_roots<Real>([](auto x) { return (x * x - 2) * (x - 1) * (x - 1); }, -2, 2);
  EXPECT_TRUE(s.resolved);
  ASSERT_EQ(s.roots.size(), 3U);
  EXPECT_EQ(s.roots[1].verdict, root_verdict::multiple);
  EXPECT_EQ(s.roots[1].multiplicity, 2);
  EXPECT_EQ(s.roots[1].exact, rational(1));
  EXPECT_EQ(s.roots[1].value, Real(1));
  EXPECT_LE(s.roots[2].lower * s.roots[2].lower, Real(2));
  EXPECT_GE(s.roots[2].upper * s.roots[2].upper, Real(2));
}

TEST(RealRoot, OfAPeriodicFunctionIsNotTheOnlyOneOnAHalfLine) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const bool by_period : {false, true}) {
    real_root_options options;
    options.isolation = {.most_boxes = 300, .by_period = by_period};
    const auto touching = [](auto x) { return 1 - cos(x); };  // at 2 pi, 4 pi, ...
    const auto r = find_root<double>(touching, 1.0, infinity, options);
    EXPECT_FALSE(is_one_root(r.verdict));
    EXPECT_FALSE(isolate_roots<double>(touching, 1.0, infinity, options).resolved);
    const auto s = find_root<double>([](auto x) { return sin(x) + 1; }, 0.0, infinity, options);
    EXPECT_FALSE(is_one_root(s.verdict));
  }
}

TEST(RealRoot, WhatIsNotProvedIsSaid) {
  const certified_root<double> none = find_root<double>([](auto x) { return x * x + 1; }, -2, 2);
  EXPECT_EQ(none.verdict, root_verdict::none);
  EXPECT_NE(none.value, none.value);
  const certified_root<double> several = find_root<double>([](auto x) { return sin(x); }, -4, 4);
  EXPECT_EQ(several.verdict, root_verdict::at_least_one);
  EXPECT_NE(several.remark, "");
  const certified_root<double> zero = find_root<double>([](auto x) { return x - x; }, -4, 4);
  EXPECT_EQ(zero.verdict, root_verdict::unresolved);
  // A double root, and an iteration that finds it: the proof near it fails, and says so.
  real_root_options newton;
  newton.engine = root_engine::newton;
  const certified_root<double> touching =
      find_root<double>([](auto x) { return (x - "1/3"_r) * (x - "1/3"_r); }, 0, 1, newton);
  EXPECT_EQ(touching.verdict, root_verdict::unresolved);
  EXPECT_NE(touching.remark, "");
  // Without a change of sign TOMS 748 gives up.
  real_root_options toms;
  toms.engine = root_engine::toms748;
  EXPECT_EQ(find_root<double>([](auto x) { return x * x + 1; }, -2, 2, toms).verdict,
            root_verdict::unresolved);
  EXPECT_THROW(static_cast<void>(find_root<double>(dottie, 0, end_point::infinity(), toms)),
               input_error);
  EXPECT_THROW(static_cast<void>(find_root<double>(dottie, 1, 0)), input_error);
  real_root_options no_digits;
  no_digits.digits = 0;
  EXPECT_THROW(static_cast<void>(find_root<double>(dottie, 0, 1, no_digits)), input_error);
}

TEST(RealRoot, PoliciesDecide) {
  namespace policies = boost::math::policies;
  const auto f = [](auto x) { return x * x + 1; };
  EXPECT_THROW(static_cast<void>(find_root<double>(f, -2, 2, {}, policies::policy<>())),
               boost::math::evaluation_error);
  using quiet = policies::policy<policies::evaluation_error<policies::errno_on_error>>;
  errno = 0;
  EXPECT_EQ(find_root<double>(f, -2, 2, {}, quiet()).verdict, root_verdict::none);
  EXPECT_EQ(errno, EDOM);
}

TEST(RealRoot, BoxesOfIterationsAreInside) {
  // What is unique in [lowest, greatest] has its root there, and the ends are inside the interval.
  real_root_options newton;
  newton.engine = root_engine::newton;
  const auto r = find_root<mp::mpfr_float_50>([](auto x) { return x * x * x - 28; }, 1, 28, newton);
  EXPECT_EQ(r.verdict, root_verdict::unique);
  EXPECT_GE(r.lowest, 1);
  EXPECT_LE(r.greatest, 28);
  EXPECT_LT(r.lowest, r.lower);
  EXPECT_LT(r.upper, r.greatest);
}

TEST(RealRoot, EndsOfBoxesAreRoundedInward) {
  const ball box = hull(ball(rational(1, 3), 200), ball(rational(2, 3), 200));
  double lowest = 0;
  double greatest = 0;
  detail::set_box(lowest, greatest, box, 53);
  EXPECT_TRUE(contains(box, ball_of(lowest)));
  EXPECT_TRUE(contains(box, ball_of(greatest)));
  EXPECT_NEAR(lowest, 1.0 / 3, 1e-16);
  EXPECT_NEAR(greatest, 2.0 / 3, 2e-16);
  ball least;
  ball most;
  detail::set_box(least, most, ball(1, 64).enlarged(magnitude::from_bits_up(1UL << 62, -500)), 53);
  EXPECT_TRUE(contains(ball(1, 64).enlarged(magnitude::from_bits_up(1UL << 62, -500)), least));
  detail::set_box(lowest, greatest, hull(ball(0, 64), ball(1, 64)), 53);
  EXPECT_EQ(lowest, 0);
  EXPECT_EQ(greatest, 1);
}

TEST(RealSystem, SolutionsAreProved) {
  const auto f = [](const auto& x) {
    return std::vector{x[0] * x[0] + x[1] - 11, x[0] + x[1] * x[1] - 7};
  };
  using Real = mp::mpfr_float_50;
  const auto s = solve_system<Real>(f, {{-5, 5}, {-5, 5}});
  EXPECT_TRUE(s.resolved);
  ASSERT_EQ(s.solutions.size(), 4U);
  for (const auto& solution : s.solutions) {
    EXPECT_EQ(solution.verdict, root_verdict::unique);
    EXPECT_TRUE(solution.reached);
    const Real& x = solution.value[0];
    const Real& y = solution.value[1];
    EXPECT_LT(abs(Real(x * x + y - 11)), 1e-46);
    EXPECT_LE(solution.lower[0], x);
    EXPECT_LE(x, solution.upper[0]);
    EXPECT_LT(Real(solution.upper[1] - solution.lower[1]), 1e-47);
  }
  EXPECT_EQ(solve_system<ball>(f, {{-5, 5}, {-5, 5}}).solutions.size(), 4U);
  EXPECT_EQ(solve_system<double>(f, {{-5.0, 5.0}, {-5.0, 5.0}}).solutions.size(), 4U);
  EXPECT_THROW(static_cast<void>(solve_system<Real>(f, {{0, end_point::infinity()}, {0, 1}})),
               input_error);
  EXPECT_THROW(static_cast<void>(solve_system<Real>(f, {{0, 1}, {0, 1}, {0, 1}})), input_error);
}

}  // namespace roots_test
