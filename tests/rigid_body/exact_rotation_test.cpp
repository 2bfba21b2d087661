#include "polhode/rigid_body/exact_rotation.hpp"

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace {

constexpr precision p = 120;

using rational_rows = matrix3<rational>;

matrix3<ball> product(const matrix3<ball>& x, const matrix3<ball>& y) {
  matrix3<ball> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      result[i][k] = x[i][0] * y[0][k] + x[i][1] * y[1][k] + x[i][2] * y[2][k];
  }
  return result;
}

/// Every entry of one meets that of the other, and both are narrow.
void expect_same(const matrix3<ball>& x, const matrix3<ball>& y, const std::string& what) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(overlaps(x[i][k], y[i][k])) << what << " " << i << k;
      EXPECT_LE(x[i][k].radius(), magnitude::power_of_two(8 - p)) << what;
      EXPECT_LE(y[i][k].radius(), magnitude::power_of_two(8 - p)) << what;
    }
  }
}

/// Rodrigues' formula: cos 1 + (1 - cos) u u^T + sin [u]x.
matrix3<ball> by_rodrigues(const triple<rational>& axis, const ball& angle) {
  const ball length =
      sqrt(ball(rational(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]), p + 20));
  const triple<ball> u{axis[0] / length, axis[1] / length, axis[2] / length};
  const ball c = cos(angle);
  const ball s = sin(angle);
  matrix3<ball> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      result[i][k] = (1 - c) * u[i] * u[k];
      if (i == k) result[i][k] += c;
      if (k == (i + 1) % 3) result[i][k] -= s * u[3 - i - k];
      if (i == (k + 1) % 3) result[i][k] += s * u[3 - i - k];
    }
  }
  return result;
}

TEST(ExactRotation, SinesThatAreRational) {
  for (long k = -24; k <= 24; ++k) {
    const rational degrees(15 * k);
    const ball x = ball(rational(degrees / 180), p) * pi(p);
    const exact_real sine = exact_sine(degrees, angle_unit::degrees);
    const exact_real cosine = exact_cosine(degrees, angle_unit::degrees);
    EXPECT_TRUE(overlaps(sine.at(p), sin(x))) << degrees;
    EXPECT_TRUE(overlaps(cosine.at(p), cos(x))) << degrees;
    const bool is_sixth = k % 6 == 0;
    EXPECT_EQ(sine.is_rational(),
              is_sixth || k % 12 == 2 || k % 12 == -10 || k % 12 == 10 || k % 12 == -2)
        << degrees;
    EXPECT_EQ(cosine.is_rational(), is_sixth || (k % 4 == 0 && k % 6 != 0)) << degrees;
  }
  EXPECT_TRUE(exact_sine(0, angle_unit::radians).is_rational());
  EXPECT_EQ(exact_cosine(0, angle_unit::radians), 1);
  EXPECT_TRUE(overlaps(exact_sine(rational(-7, 3), angle_unit::radians).at(p),
                       sin(ball(rational(-7, 3), p))));
  // So large that its first bits alone say nothing.
  const rational large = support::power_of_ten(60) + rational(1, 7);
  EXPECT_TRUE(overlaps(exact_cosine(large, angle_unit::radians).at(p), cos(ball(large, p + 300))));
  EXPECT_TRUE(overlaps(exact_sine(large, angle_unit::degrees).at(p),
                       sin(ball(rational(large / 180), p + 300) * pi(p + 300))));
}

TEST(ExactRotation, AboutAnyAxisIsRodriguesFormula) {
  support::random_source random(4101);
  for (support::repeat trial(60); trial.again();) {
    const triple<rational> axis{
        random.between(-3, 3), random.between(-3, 3),
        rational(random.between(1, 3), random.between(1, 9)) * (random.one_in(2) ? 1 : -1)};
    const bool has_degrees = random.one_in(2);
    const rational angle = has_degrees ? rational(15 * random.between(-60, 60))
                                       : rational(random.between(-99, 99), random.between(1, 20));
    const ball x =
        has_degrees ? ball(rational(angle / 180), p + 20) * pi(p + 20) : ball(angle, p + 20);
    const auto one =
        exact_rotation::about(axis, angle, has_degrees ? angle_unit::degrees : angle_unit::radians);
    const std::string what = to_text(axis[0]) + " " + to_text(axis[1]) + " " + to_text(axis[2]) +
                             " by " + to_text(angle);
    expect_same(one.matrix(p), by_rodrigues(axis, x), what);
    expect_same(one.inverse().matrix(p), by_rodrigues(axis, -x), what);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    triple<rational> unit{0, 0, 0};
    unit[axis] = 1;
    expect_same(exact_rotation::about(axis, rational(7, 5), angle_unit::radians).matrix(p),
                by_rodrigues(unit, ball(rational(7, 5), p + 20)), "own axis");
  }
  for (const long z : {2L, -2L}) {
    expect_same(exact_rotation::about({0, 0, z}, rational(7, 5), angle_unit::radians).matrix(p),
                by_rodrigues({0, 0, z}, ball(rational(7, 5), p + 20)), "along z");
  }
  EXPECT_THROW((void)exact_rotation::about({0, 0, 0}, 1, angle_unit::radians), input_error);
}

TEST(ExactRotation, ProductsVectorsAndMatricesAgree) {
  support::random_source random(4102);
  for (support::repeat trial(40); trial.again();) {
    exact_rotation all;
    matrix3<ball> expected = all.matrix(p + 20);
    for (int i = 0; i < 3; ++i) {
      exact_rotation next;
      switch (random.between(0, 4)) {
        case 0:
          next = exact_rotation::of_quaternion(
              {random.between(1, 9), random.between(-9, 9), random.between(-9, 9), 1});
          break;
        case 1:
          next = exact_rotation::about(static_cast<std::size_t>(random.between(0, 2)),
                                       random.between(-9, 9), angle_unit::radians);
          break;
        case 2:
          next = exact_rotation::with_axes({random.between(-9, 9), 1, 2},
                                           {3, random.between(5, 9), random.between(-9, 9)});
          break;
        case 3:
          next = exact_rotation::with_third_axis(
              {random.between(-2, 2), random.between(-2, 2), random.between(1, 2)});
          break;
        default:
          next = exact_rotation::about({1, random.between(-5, 5), 2}, 45, angle_unit::degrees);
      }
      all = all * next;
      expected = product(expected, next.matrix(p + 20));
    }
    expect_same(all.matrix(p), expected, "product");
    const matrix3<ball> inverse = all.inverse().matrix(p);
    const triple<exact_real> w{3, rational(-1, 7), 2};
    const triple<exact_real> turned = all.of(w);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(overlaps(inverse[i][k], expected[k][i]));
      const ball sum = expected[i][0] * 3 - expected[i][1] / 7 + expected[i][2] * 2;
      EXPECT_TRUE(overlaps(turned[i].at(p), sum));
    }
  }
}

TEST(ExactRotation, AxesByVectors) {
  const auto rows = *exact_rotation::with_axes({3, 4, 0}, {7, 1, 0}).rational_matrix();
  EXPECT_EQ(rows, (rational_rows{{{rational(3, 5), rational(4, 5), 0},
                                  {rational(4, 5), rational(-3, 5), 0},
                                  {0, 0, -1}}}));
  EXPECT_TRUE(exact_rotation::with_axes({2, 0, 0}, {-1, 3, 0}).is_identity());
  EXPECT_EQ(
      *exact_rotation::with_third_axis({0, 3, 4}).rational_matrix(),
      (rational_rows{
          {{1, 0, 0}, {0, rational(4, 5), rational(3, 5)}, {0, rational(-3, 5), rational(4, 5)}}}));
  EXPECT_TRUE(exact_rotation::with_third_axis({0, 0, 7}).is_identity());
  EXPECT_EQ(*exact_rotation::with_third_axis({0, 0, -7}).rational_matrix(),
            (rational_rows{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}));
  // The least angle: what is orthogonal to both z axes stays.
  support::random_source random(4103);
  for (support::repeat trial(30); trial.again();) {
    const triple<rational> z{random.between(-9, 9), random.between(1, 9), random.between(-9, 9)};
    const auto one = exact_rotation::with_third_axis(z);
    const triple<exact_real> across = one.of({rational(-z[1]), z[0], 0});
    const triple<exact_real> third = one.of({0, 0, 1});
    const ball length = sqrt(ball(rational(z[0] * z[0] + z[1] * z[1] + z[2] * z[2]), p));
    const matrix3<ball> m = one.matrix(p);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(overlaps(m[i][2], z[i] / length));
      if (z[i] != 0) {
        EXPECT_TRUE(overlaps(third[i].at(p), z[i] / length));
      }
    }
    EXPECT_TRUE(overlaps(across[0].at(p), ball(rational(-z[1]), p)));
    EXPECT_EQ(across[2], 0);
  }
  EXPECT_THROW((void)exact_rotation::with_axes({1, 2, 3}, {2, 4, 6}), input_error);
  EXPECT_THROW((void)exact_rotation::with_axes({0, 0, 0}, {2, 4, 6}), input_error);
  EXPECT_THROW((void)exact_rotation::with_third_axis({0, 0, 0}), input_error);
  EXPECT_THROW((void)exact_rotation::of_quaternion({0, 0, 0, 0}), input_error);
  EXPECT_THROW((void)exact_rotation::of_matrix({{{1, 0, 0}, {0, 1, 0}, {0, 0, 2}}}), input_error);
}

TEST(ExactRotation, KnowsWhatIsRational) {
  const auto degrees = angle_unit::degrees;
  EXPECT_EQ(*exact_rotation::about(2, 90, degrees).rational_matrix(),
            (rational_rows{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}));
  EXPECT_EQ(*exact_rotation::about(0, -90, degrees).rational_matrix(),
            (rational_rows{{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}}));
  EXPECT_EQ(*exact_rotation::about({1, 2, 2}, 180, degrees).rational_matrix(),
            (rational_rows{{{rational(-7, 9), rational(4, 9), rational(4, 9)},
                            {rational(4, 9), rational(-1, 9), rational(8, 9)},
                            {rational(4, 9), rational(8, 9), rational(-1, 9)}}}));
  EXPECT_TRUE(exact_rotation::about({1, 2, 3}, 360, degrees).is_identity());
  EXPECT_TRUE(exact_rotation::about({1, 2, 3}, 0, angle_unit::radians).is_identity());
  EXPECT_FALSE(exact_rotation::about(1, 30, degrees).rational_matrix());
  EXPECT_FALSE(exact_rotation::about(1, 45, degrees).rational_matrix());
  // By 45 degrees (1, 1, 0) goes to an axis.
  const triple<exact_real> v = exact_rotation::about(2, 45, degrees).of({1, 1, 5});
  EXPECT_TRUE(v[0].is_rational());
  EXPECT_EQ(v[0], 0);
  EXPECT_TRUE(overlaps(v[1].at(p), sqrt(ball(2, p))));
  EXPECT_EQ(v[2], 5);
  for (const long odd : {-225L, -135L, -45L, 45L, 135L, 225L, 315L, 765L}) {
    expect_same(exact_rotation::about(2, odd, degrees).matrix(p),
                by_rodrigues({0, 0, 1}, ball(rational(odd, 180), p + 20) * pi(p + 20)), "odd");
  }
}

}  // namespace
}  // namespace polhode
