// Products of numbers of few limbs, and sums with products, have algorithms of their own. Bit for
// bit they are MPFR's.

#include <array>

#include <gtest/gtest.h>

#include "polhode/arithmetic/complex_ball.hpp"
#include "support/random.hpp"
#include "support/real.hpp"

namespace polhode {
namespace short_product_test {

using support::random_source;
using support::real;
using support::repeat;

/// Significands that make ties, carries and exact products: few bits at either end, runs of ones.
real any_significand(random_source& random, precision p) {
  real x(p, 1);
  switch (random.between(0, 3)) {
    case 0:
      x = random.any_real(p, -3, 3);
      break;
    case 1:  // 1 + 2^-k
      mpfr_set_ui_2exp(x, 1, -random.between(0, p - 1), MPFR_RNDN);
      mpfr_add_ui(x, x, 1, MPFR_RNDN);
      break;
    case 2:  // 2 - 2^-k
      mpfr_set_ui_2exp(x, 1, -random.between(0, p - 1), MPFR_RNDN);
      mpfr_ui_sub(x, 2, x, MPFR_RNDN);
      break;
    default:
      mpfr_set_si(x, random.between(1, 1L << random.between(1, 62)), MPFR_RNDN);
      break;
  }
  if (random.one_in(2)) mpfr_neg(x, x, MPFR_RNDN);
  return x;
}

TEST(ShortProduct, IsThatOfMpfr) {
  random_source random(1700);
  static constexpr std::array<precision, 8> edges = {2, 63, 64, 65, 66, 127, 128, 129};
  const auto any_bits = [&] {
    return random.one_in(2) ? random.choose(edges) : precision{random.between(2, 140)};
  };
  for (repeat trial(40000); trial.again();) {
    const precision p = any_bits();
    const real a = any_significand(random, p);
    const real b = any_significand(random, random.one_in(4) ? any_bits() : p);
    const ball x(a.get());
    const ball y(b.get());
    const ball product = x * y;
    real expected(product.precision(), 0);
    real got(product.precision(), 0);
    const int ternary = mpfr_mul(expected, a, b, MPFR_RNDN);
    product.midpoint(got);
    ASSERT_TRUE(mpfr_equal_p(got, expected));
    ASSERT_EQ(product.is_exact(), ternary == 0);
    const ball power = square(x);
    real squared(p, 0);
    const int ternary_of_square = mpfr_sqr(squared, a, MPFR_RNDN);
    real got_square(p, 0);
    power.midpoint(got_square);
    ASSERT_TRUE(mpfr_equal_p(got_square, squared));
    ASSERT_EQ(power.is_exact(), ternary_of_square == 0);
  }
}

TEST(ShortProduct, FusedWithASumIsThatOfMpfr) {
  random_source random(1701);
  const auto any_bits = [&](precision p) {
    return random.one_in(4) ? precision{random.between(2, random.one_in(4) ? 1500 : 200)} : p;
  };
  for (repeat trial(20000); trial.again();) {
    const precision p = any_bits(random.between(2, 140));
    real a = any_significand(random, p);
    const real b = any_significand(random, any_bits(p));
    const real c = any_significand(random, any_bits(p));
    real d = any_significand(random, any_bits(p));
    if (random.one_in(4)) {  // the products cancel, all but for their last places
      a = c;
      d = b;
    }
    if (random.one_in(10)) mpfr_set_zero(d, 1);
    const ball x(a.get());
    const ball y(b.get());
    const ball u(c.get());
    const ball v(d.get());
    const auto check = [](const ball& got, auto&& reference) {
      real expected(got.precision(), 0);
      real midpoint(got.precision(), 0);
      const int ternary = reference(expected.get());
      got.midpoint(midpoint);
      ASSERT_TRUE(mpfr_equal_p(midpoint, expected));
      if (mpfr_regular_p(expected.get()) != 0 && got.precision() > 30) {
        ASSERT_EQ(got.is_exact(), ternary == 0);
      }
    };
    ball sum;
    fma(sum, x, y, u);
    check(sum, [&](mpfr_ptr r) { return mpfr_fma(r, a, b, c, MPFR_RNDN); });
    // Both parts of a complex ball have the precision of the greater one.
    const complex_ball z(x, y);
    const complex_ball w(u, v);
    const complex_ball product = z * w;
    check(product.re, [&](mpfr_ptr r) { return mpfr_fmms(r, a, c, b, d, MPFR_RNDN); });
    check(product.im, [&](mpfr_ptr r) { return mpfr_fmma(r, a, d, b, c, MPFR_RNDN); });
    const complex_ball power = square(z);
    check(power.re, [&](mpfr_ptr r) { return mpfr_fmms(r, a, a, b, b, MPFR_RNDN); });
    check(power.im, [&](mpfr_ptr r) { return mpfr_fmma(r, a, b, a, b, MPFR_RNDN); });
  }
}

}  // namespace short_product_test
}  // namespace polhode
