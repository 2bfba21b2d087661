// Inertia tensors in any axes: rotated bodies, closed forms, decisions near their boundaries,
// refusals.

#include "polhode/rigid_body/inertia_tensor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "polhode/arithmetic/elementary.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace inertia_tensor_test {

using support::as_narrow_as;
using support::meet;
using support::power_of_ten;

/// R diag(moments) R^T for the rotation by the quaternion 1 + p i + q j + r k, in rationals.
std::array<rational, 6> rotated(const std::array<rational, 3>& moments, const rational& p,
                                const rational& q, const rational& r) {
  const rational n(1 + p * p + q * q + r * r);
  const std::array<std::array<rational, 3>, 3> rows{
      {{(1 + p * p - q * q - r * r) / n, 2 * (p * q - r) / n, 2 * (p * r + q) / n},
       {2 * (p * q + r) / n, (1 - p * p + q * q - r * r) / n, 2 * (q * r - p) / n},
       {2 * (p * r - q) / n, 2 * (q * r + p) / n, (1 - p * p - q * q + r * r) / n}}};
  const auto entry = [&](std::size_t i, std::size_t j) {
    rational sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += rows[i][k] * rows[j][k] * moments[k];
    return sum;
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

TEST(InertiaTensor, RotatedBodiesHaveTheirMoments) {
  support::random_source random(211);
  for (support::repeat trial(30); trial.again();) {
    const auto part = [&] { return rational(random.between(-50, 50), random.between(1, 9)); };
    const rational z(random.between(1, 50), 7);
    const rational y(z + rational(random.between(1, 99), 13));
    // Planar now and then.
    const rational x =
        random.one_in(4) ? rational(z + y) : rational(y + rational(random.between(1, 99), 5));
    const inertia_tensor tensor(rotated({y, x, z}, part(), part(), part()));
    const body rigid = body::from_moments({x, y, z});
    EXPECT_EQ(tensor.kind(), rigid.kind());
    EXPECT_EQ(tensor.exact_moments()[0], x);
    EXPECT_EQ(tensor.exact_moments()[1], y);
    EXPECT_EQ(tensor.exact_moments()[2], z);
    EXPECT_TRUE(contains(tensor.a(100), rigid.a().exact()));
    EXPECT_TRUE(contains(tensor.b(100), rigid.b().exact()));
    EXPECT_TRUE(meet(tensor.geometric_constant(100), rigid.geometric_constant(300)));
    EXPECT_TRUE(meet(tensor.second_geometric_constant(100), rigid.second_geometric_constant(300)));
    EXPECT_TRUE(as_narrow_as(tensor.second_geometric_constant(100), 90));
  }
}

TEST(InertiaTensor, IrrationalMomentsInClosedForm) {
  support::random_source random(212);
  for (support::repeat trial(40); trial.again();) {
    // A block [[p, r], [r, q]] with the roots (p+q)/2 +- sqrt((p-q)^2/4 + r^2), and s apart from
    // it.
    const rational p(random.between(20, 60), 3);
    const rational q(random.between(20, 60), 7);
    const rational r(random.between(1, 8), 5);
    const rational s = random.one_in(3) ? rational(p + q) : rational(random.between(1, 300), 11);
    if (p * q <= r * r) continue;
    const ball middle(rational((p + q) / 2), 400);
    const ball half = sqrt(ball(rational((p - q) * (p - q) / 4 + r * r), 400));
    std::array<ball, 3> sorted{middle + half, middle - half, ball(s, 400)};
    std::sort(sorted.begin(), sorted.end(),
              [](const ball& i, const ball& j) { return certainly_less(j, i); });
    const inertia_tensor tensor({p, s, q, 0, r, 0});
    const std::array<ball, 3> moments = tensor.moments(300);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(meet(moments[i], sorted[i]));
      EXPECT_TRUE(as_narrow_as(moments[i], 290));
    }
    const auto& [x, y, z] = sorted;
    const ball excess = y + z - x;
    const body_kind expected = certainly_positive(excess)   ? body_kind::physical
                               : certainly_negative(excess) ? body_kind::non_physical
                                                            : body_kind::planar;
    EXPECT_EQ(tensor.kind(), expected);
    EXPECT_EQ(expected == body_kind::planar, s == p + q);
    EXPECT_TRUE(meet(tensor.a(200), y / z - 1));
    EXPECT_TRUE(meet(tensor.b(200), 1 - y / x));
    EXPECT_TRUE(meet(tensor.geometric_constant(200), sqrt(y * z / ((x - y) * (x - z)))));
    EXPECT_TRUE(meet(tensor.second_geometric_constant(200), sqrt(x * y / ((y - z) * (x - z))) - 1));
    EXPECT_TRUE(as_narrow_as(tensor.geometric_constant(200), 190));
    EXPECT_TRUE(as_narrow_as(tensor.second_geometric_constant(200), 190));
  }
}

// The moments m and (p + q +- sqrt((p-q)^2 + 4))/2, one of which may have m as the next integer
// above it.
TEST(InertiaTensor, OneRationalMomentBesideIrrationalOnes) {
  const precision bits = 200;
  long beside = 0;
  for (long p = 1; p <= 6; ++p) {
    for (long q = p + 1; q <= 6; ++q) {
      for (long m = 1; m <= 9; ++m) {
        if ((m - p) * (m - q) == 1 || p * q == 1) continue;
        SCOPED_TRACE(testing::Message() << p << ' ' << q << ' ' << m);
        const ball root = sqrt(ball((p - q) * (p - q) + 4, bits));
        std::array<ball, 3> right{ball(m, bits), scale(p + q + root, -1), scale(p + q - root, -1)};
        std::sort(right.begin(), right.end(),
                  [](const ball& x, const ball& y) { return certainly_less(y, x); });
        const inertia_tensor tensor({p, q, m, 1, 0, 0});
        const std::array<ball, 3> found = tensor.moments(100);
        long rational_ones = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          EXPECT_TRUE(meet(found[i], right[i])) << i;
          EXPECT_TRUE(as_narrow_as(found[i], 90)) << i;
          if (tensor.exact_moments()[i]) {
            ++rational_ones;
            EXPECT_EQ(tensor.exact_moments()[i], rational(m));
          } else if (certainly_less(ball(m - 1, bits), right[i]) &&
                     certainly_less(right[i], ball(m, bits))) {
            ++beside;
          }
        }
        EXPECT_EQ(rational_ones, 1);
      }
    }
  }
  EXPECT_GT(beside, 10);
}

TEST(InertiaTensor, DecidesNearTheBoundaries) {
  const rational hair = power_of_ten(-200);
  // A lamina in the xz plane, and a hair more or less of the moment about its normal.
  const auto lamina = [](const rational& normal) {
    return inertia_tensor({2, normal, 3, 0, 1, 0}).kind();
  };
  EXPECT_EQ(lamina(5), body_kind::planar);
  EXPECT_EQ(lamina(5 + hair), body_kind::non_physical);
  EXPECT_EQ(lamina(5 - hair), body_kind::physical);
  // Two moments that differ by a hair; irrational.
  const inertia_tensor near({2, 2 + hair, 4, hair, 0, 0});
  EXPECT_FALSE(near.exact_moments()[1]);
  EXPECT_EQ(near.exact_moments()[0], 4);
  // y - z = hair sqrt 5
  EXPECT_TRUE(meet(near.a(100) * near.moments(2000)[2], hair * sqrt(ball(5, 300))));
  EXPECT_TRUE(as_narrow_as(near.a(100), 90));
  EXPECT_THROW(inertia_tensor({2, 2, 4, 0, 0, 0}), input_error);
  // The least moment is some 10^-10 below the rational one beside it.
  const inertia_tensor beside({2, rational(24377, 10000), 2, 0, 0, rational(63, 10'000'000)});
  EXPECT_EQ(beside.exact_moments()[1], rational(2));
  for (const precision p : {30, 64, 300, 2000}) {
    for (const ball& moment : beside.moments(p)) EXPECT_TRUE(as_narrow_as(moment, p - 10)) << p;
    EXPECT_TRUE(as_narrow_as(beside.a(p), p - 10)) << p;
  }
}

TEST(InertiaTensor, Refuses) {
  EXPECT_THROW(inertia_tensor({1, 2, 1, 3, 0, 0}), input_error);  // not definite
  EXPECT_THROW(inertia_tensor({-1, 2, 1, 0, 0, 0}), input_error);
  EXPECT_THROW(inertia_tensor({0, 2, 1, 0, 0, 0}), input_error);
  EXPECT_THROW(inertia_tensor({3, 3, 3, 0, 0, 0}), input_error);  // a sphere
  EXPECT_THROW(inertia_tensor({2, 2, 2, 1, 1, 1}), input_error);  // moments 4, 1, 1
  EXPECT_THROW(inertia_tensor({power_of_ten(-2000), 2, 1, 0, 0, 0}), input_error);
}

}  // namespace inertia_tensor_test
}  // namespace polhode
