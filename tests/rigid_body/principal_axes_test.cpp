#include "polhode/rigid_body/principal_axes.hpp"

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "rigid_body/rotor_states.hpp"

namespace polhode {
namespace principal_axes_test {
namespace {

ball dot(const triple<ball>& x, const triple<ball>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

triple<ball> product(const std::array<rational, 6>& t, const triple<ball>& v) {
  return {v[0] * t[0] + v[1] * t[3] + v[2] * t[4], v[0] * t[3] + v[1] * t[1] + v[2] * t[5],
          v[0] * t[4] + v[1] * t[5] + v[2] * t[2]};
}

/// det(T - x).
ball characteristic(const std::array<rational, 6>& t, const ball& x) {
  const ball xx = t[0] - x;
  const ball yy = t[1] - x;
  const ball zz = t[2] - x;
  return xx * (yy * zz - t[5] * t[5]) - t[3] * (t[3] * zz - t[5] * t[4]) +
         t[4] * (t[3] * t[5] - yy * t[4]);
}

constexpr precision bits = 400;

void expect_axes_of(const std::array<rational, 6>& t) {
  const principal_axes axes(t);
  matrix3<ball> v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = axes.axis(i, bits);
  for (std::size_t i = 0; i < 3; ++i) {
    const ball moment = axes.moments()[i].at(bits);
    EXPECT_TRUE(contains_zero(characteristic(t, moment)));
    if (i > 0) {
      EXPECT_GE(axes.moments()[i - 1], axes.moments()[i]);
    }
    const triple<ball> turned = product(t, v[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(overlaps(turned[k], moment * v[i][k]));
      EXPECT_LE(v[i][k].radius(), magnitude::power_of_two(8 - bits));
      EXPECT_TRUE(contains(dot(v[i], v[k]), i == k ? 1L : 0L));
    }
    if (i == 2) continue;
    std::size_t first = 0;
    while (v[i][first].is_exact() && contains_zero(v[i][first])) ++first;
    EXPECT_TRUE(certainly_positive(v[i][first]));
  }
  const ball determinant = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) -
                           v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
                           v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
  EXPECT_TRUE(contains(determinant, 1L));
  // The components of vectors: of all kinds of w, also of the axes themselves where they are
  // rational.
  for (const triple<exact_real>& w : {triple<exact_real>{1, 0, 0},
                                      {0, 1, 0},
                                      {0, 0, 1},
                                      {1, 2, 2},
                                      {-3, rational(1, 7), 5},
                                      {2, -1, 0}}) {
    ball sum(0, bits);
    for (std::size_t i = 0; i < 3; ++i) {
      const ball along = v[i][0] * w[0] + v[i][1] * w[1] + v[i][2] * w[2];
      const exact_real squared = axes.square_along(i, w);
      EXPECT_TRUE(overlaps(square(along), squared.at(bits)));
      const int sense = axes.sense_along(i, w);
      EXPECT_EQ(sense == 0, squared.is_rational() && squared.exact() == 0);
      EXPECT_EQ(sense == 0, contains_zero(along));
      if (sense != 0) {
        EXPECT_TRUE(certainly_positive(along * sense));
      }
      sum += squared.at(bits);
    }
    EXPECT_TRUE(contains(sum, (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]).exact()));
    EXPECT_EQ(axes.times(axes.solved(w)), w);
  }
}

TEST(PrincipalAxes, AreEigenvectorsOfAnyTensor) {
  support::random_source random(3901);
  for (support::repeat trial(150); trial.again();) {
    const std::array<rational, 6> t = support::random_tensor(random, 20);
    SCOPED_TRACE(to_text(t[0]) + " " + to_text(t[1]) + " " + to_text(t[2]) + " " + to_text(t[3]) +
                 " " + to_text(t[4]) + " " + to_text(t[5]));
    expect_axes_of(t);
  }
}

TEST(PrincipalAxes, OfSpecialTensors) {
  expect_axes_of({1, 1, 1, 0, 0, 0});
  expect_axes_of({1, 3, 2, 0, 0, 0});
  expect_axes_of({2, 2, 2, 1, 1, 1});     // 4, 1, 1
  expect_axes_of({3, 3, 3, -1, -1, -1});  // 4, 4, 1
  expect_axes_of({2, 3, 4, 1, 0, 0});     // 4 and (5 +- sqrt 5)/2
  expect_axes_of({4, 2, 3, 0, 0, 1});
  expect_axes_of({3, 4, 2, 0, 1, 0});
  expect_axes_of({2, 2, 5, 1, 0, 0});  // a box turned by 45 degrees: 5, 3, 1
  expect_axes_of({2, 3, 4, rational(1, 1'000'000'000'000'000), 0, 0});
  expect_axes_of({26, 38, 35, 4, -10, -14});
}

TEST(PrincipalAxes, AlongTheGivenOnes) {
  const axis_order order = *principal_axes({1, 3, 2, 0, 0, 0}).along_given_axes();
  EXPECT_EQ(order.order, (std::array<int, 3>{1, 2, 0}));
  EXPECT_EQ(order.signs, (std::array<int, 3>{1, 1, 1}));
  EXPECT_EQ(principal_axes({2, 3, 1, 0, 0, 0}).along_given_axes()->signs,
            (std::array<int, 3>{1, 1, -1}));
  EXPECT_FALSE(principal_axes({2, 3, 4, 1, 0, 0}).along_given_axes());
}

TEST(PrincipalAxes, TellTheKindAndTheMargin) {
  const principal_axes planar({2, 3, 5, 1, 0, 0});
  EXPECT_EQ(planar.kind(), body_kind::planar);
  EXPECT_EQ(planar.margin().exact(), 0);
  const principal_axes physical({2, 3, 4, 1, 0, 0});
  EXPECT_EQ(physical.kind(), body_kind::physical);
  EXPECT_EQ(physical.margin().exact(), 1);
  EXPECT_FALSE(physical.rational_moments());
  EXPECT_EQ(principal_axes({2, 3, 6, 1, 0, 0}).kind(), body_kind::non_physical);
  EXPECT_THROW(principal_axes({1, 1, 1, 2, 0, 0}), input_error);
  EXPECT_THROW(principal_axes({1, -1, 1, 0, 0, 0}), input_error);
  EXPECT_THROW(principal_axes({1, 1, 1, 1, 1, 1}), input_error);  // 3, 0, 0
}

// About an axis with a rational moment, beside two that are (5 +- sqrt 5)/2; and c = 0 exactly,
// where 2 H I_y = J^2, for I_y = 5/2 and J = (2 v, v, w) or (0, v, w).
TEST(InitialState, RegimesOfIrrationalBodiesAreDecided) {
  const auto regime_of_state = [](const rational& zz, const triple<rational>& j) {
    return initial_state::from_tensor(
               std::make_shared<const principal_axes>(std::array<rational, 6>{2, 3, zz, 1, 0, 0}),
               j)
        .regime();
  };
  EXPECT_EQ(regime_of_state(4, {0, 0, 1}), regime::equilibrium_x);
  EXPECT_EQ(regime_of_state(3, {0, 0, -7}), regime::equilibrium_y);
  EXPECT_EQ(regime_of_state(1, {0, 0, 1}), regime::equilibrium_z);
  const rational tiny = support::power_of_ten(-60);
  EXPECT_EQ(regime_of_state(4, {tiny, 0, 1}), regime::oscillating);
  EXPECT_EQ(regime_of_state(1, {tiny, 0, 1}), regime::rotating);
  const rational middle(5, 2);
  EXPECT_EQ(regime_of_state(middle, {2, 1, 3}), regime::separatrix);
  EXPECT_EQ(regime_of_state(middle, {0, -1, 5}), regime::separatrix);
  EXPECT_EQ(regime_of_state(middle, {2, 1 + tiny, 3}), regime::oscillating);
  EXPECT_EQ(regime_of_state(middle, {2, 1 - tiny, 3}), regime::rotating);
  // The separatrix of an irrational body in time: energy and momentum stay.
  const rotor<ball> turning(
      initial_state::from_tensor(
          std::make_shared<const principal_axes>(std::array<rational, 6>{2, 3, middle, 1, 0, 0}),
          {2, 1, 3}),
      100);
  const auto [j, omega] = turning.sample(rational(7, 3));
  EXPECT_TRUE(contains(dot(j, j), 14L));
  EXPECT_TRUE(contains(dot(j, omega), rational(28, 5)));
}

ball distance_between(const std::array<rational, 6>& x, const std::array<exact_real, 6>& y) {
  ball sum(0, bits);
  for (std::size_t i = 0; i < 6; ++i) {
    const ball one = square(x[i] - y[i].at(bits));
    sum += i < 3 ? one : 2 * one;
  }
  return sqrt(sum);
}

TEST(NearestPhysicalTensor, IsPlanarAndNoOtherIsNearer) {
  support::random_source random(3902);
  int seen = 0;
  for (support::repeat trial(60); trial.again();) {
    const std::array<rational, 6> t = support::random_tensor(random, 20);
    const principal_axes axes(t);
    const auto nearest = nearest_physical(axes);
    EXPECT_EQ(nearest.has_value(), axes.kind() == body_kind::non_physical);
    if (!nearest) continue;
    ++seen;
    const ball distance = nearest->distance(bits);
    EXPECT_TRUE(overlaps(distance, distance_between(t, nearest->tensor)));
    const auto& [x, y, z] = nearest->moments;
    EXPECT_TRUE(overlaps(x.at(bits), (y + z).at(bits)));
    // The moments are those of the tensor: the sums of their first and second powers agree.
    const auto& n = nearest->tensor;
    EXPECT_TRUE(overlaps((x + y + z).at(bits), (n[0] + n[1] + n[2]).at(bits)));
    EXPECT_TRUE(
        overlaps((x * x + y * y + z * z).at(bits),
                 square(n[0].at(bits)) + square(n[1].at(bits)) + square(n[2].at(bits)) +
                     2 * (square(n[3].at(bits)) + square(n[4].at(bits)) + square(n[5].at(bits)))));
    // Physical tensors beside it are farther away.
    for (int other = 0; other < 5; ++other) {
      std::array<exact_real, 6> beside = nearest->tensor;
      std::array<rational, 6> rounded{};
      for (std::size_t i = 0; i < 6; ++i) {
        rounded[i] = lower_rational(beside[i].at(100).middle()) +
                     lower_rational(distance.with_precision(60).middle()) *
                         rational(random.between(-9, 9), 90);
        beside[i] = rounded[i];
      }
      try {
        if (principal_axes(rounded).kind() == body_kind::non_physical) continue;
      } catch (const input_error&) {
        continue;
      }
      EXPECT_FALSE(certainly_less(distance_between(t, beside), distance));
    }
  }
  EXPECT_GT(seen, 0);
}

}  // namespace
}  // namespace principal_axes_test
}  // namespace polhode
