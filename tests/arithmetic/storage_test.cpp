// Copies, moves and reuse, at precisions on both sides of the storage inside the object.

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace storage_test {

using support::exact;
using support::exact_set;
using support::identical;
using support::kind;
using support::random_source;
using support::real;
using support::repeat;

constexpr std::array<precision, 14> sizes = {2,   64,  65,  128,  192,  255,   256,
                                             257, 320, 512, 1000, 4096, 33333, 100000};

static_assert(std::is_nothrow_move_constructible_v<ball>);
static_assert(std::is_nothrow_move_assignable_v<ball>);
static_assert(!std::is_constructible_v<ball, double, precision>);
template <class T>
concept takes_zero_alone = requires {
  T(0);
};
static_assert(!takes_zero_alone<ball>);
static_assert(!std::is_constructible_v<ball, float, precision>);
static_assert(!std::is_constructible_v<ball, bool, precision>);
static_assert(!std::is_convertible_v<double, ball>);
static_assert(!std::is_convertible_v<long, ball>);

ball sample(random_source& random, precision p) {
  switch (random.between(0, 4)) {
    case 0:
      return random.any_ball(p, kind::thin);
    case 1:
      return random.any_ball(p, kind::wide);
    case 2:
      return random.any_ball(p, kind::half_infinite);
    case 3:
      return ball::undefined(p);
    default:
      return random.any_ball(p, kind::exact);
  }
}

TEST(Storage, DefaultIsExactlyZero) {
  const ball x;
  EXPECT_EQ(x.precision(), 64);
  EXPECT_TRUE(x.is_exact());
  EXPECT_FALSE(x.is_undefined());
  EXPECT_EQ(sign_of(x), certain_sign::zero);
  EXPECT_EQ(exact(x), (exact_set{rational(0), rational(0)}));
  EXPECT_TRUE(identical(x, ball(0, 64)));
}

TEST(Storage, CopiesAndMoves) {
  random_source random(700);
  for (const precision p : sizes) {
    for (const precision q : sizes) {
      const ball x = sample(random, p);
      const ball y = sample(random, q);

      ball a = x;
      EXPECT_TRUE(identical(a, x));
      a = y;
      EXPECT_TRUE(identical(a, y));
      a = x;
      EXPECT_TRUE(identical(a, x));
      ball& alias = a;
      a = alias;
      EXPECT_TRUE(identical(a, x)) << "assigned to itself";
      a = std::move(alias);
      EXPECT_TRUE(identical(a, x)) << "moved to itself";

      ball b = std::move(a);
      EXPECT_TRUE(identical(b, x));
      a = y;  // NOLINT(bugprone-use-after-move): what was moved from can be assigned to
      EXPECT_TRUE(identical(a, y));
      EXPECT_TRUE(identical(b, x)) << "nothing is shared";
      std::swap(a, b);
      EXPECT_TRUE(identical(a, x));
      EXPECT_TRUE(identical(b, y));
      a = std::move(b);
      EXPECT_TRUE(identical(a, y));
      b = std::move(a);
      EXPECT_TRUE(identical(b, y));

      const ball copied_empty = a;  // NOLINT: a copy of what was moved from is as empty
      ball c = copied_empty;
      c = x;
      EXPECT_TRUE(identical(c, x));
      c = std::move(a);
      c = y;
      EXPECT_TRUE(identical(c, y));
    }
  }
}

TEST(Storage, WhatWasMovedFromIsUndefined) {
  random_source random(703);
  for (const precision p : sizes) {
    for (int i = 0; i < 5; ++i) {
      ball x = sample(random, p);
      const ball taken = std::move(x);
      ball y = sample(random, p);
      ball assigned = sample(random, 64);
      assigned = std::move(y);
      // NOLINTBEGIN(bugprone-use-after-move): on purpose
      for (ball* empty : {&x, &y}) {
        EXPECT_TRUE(empty->is_undefined());
        EXPECT_EQ(empty->precision(), 64);
        for (const ball& r :
             {*empty + 1L, *empty + taken, taken * *empty, -*empty, 1L / *empty, exp(*empty),
              sin(*empty), sqrt(*empty), pow(*empty, 3), abs(*empty), scale(*empty, 2),
              empty->with_precision(200), empty->middle(), hull(*empty, taken)}) {
          EXPECT_TRUE(r.is_undefined());
          EXPECT_GE(r.precision(), 64);
        }
        EXPECT_EQ(to_decimal(*empty, 10), "undefined");
        EXPECT_FALSE(certainly_less(*empty, taken));
        EXPECT_TRUE(possibly_less(*empty, taken));
        EXPECT_FALSE(contains(*empty, 0L));
        EXPECT_TRUE(empty->radius().is_infinite());
      }
      // NOLINTEND(bugprone-use-after-move)
    }
  }
}

TEST(Storage, ResultsGoIntoAnything) {
  random_source random(701);
  for (const precision p : sizes) {
    for (const precision q : sizes) {
      const ball x = random.any_ball(p, random.one_in(2) ? kind::thin : kind::wide);
      const ball y = random.any_ball(p, random.one_in(2) ? kind::thin : kind::wide);
      const auto each = [&](auto&& f) {
        ball expected;
        f(expected);
        ball r = sample(random, q);
        f(r);
        EXPECT_TRUE(identical(r, expected));
        const ball taken = std::move(r);
        f(r);  // NOLINT(bugprone-use-after-move): the result may be what was moved from
        EXPECT_TRUE(identical(r, expected));
        r = sample(random, p);
        const ball taken_again = std::move(r);
        f(r);
        EXPECT_TRUE(identical(r, expected));
      };
      each([&](ball& r) { add(r, x, y); });
      each([&](ball& r) { multiply(r, x, y); });
      each([&](ball& r) { divide(r, x, y); });
      each([&](ball& r) { add(r, x, 5L); });
      each([&](ball& r) { multiply(r, x, -5L); });
      each([&](ball& r) { subtract(r, 5L, x); });
      each([&](ball& r) { square(r, x); });
      each([&](ball& r) { sqrt(r, x); });
      each([&](ball& r) { scale(r, x, 3); });
      each([&](ball& r) { negate(r, x); });
      if (p <= 512) {
        each([&](ball& r) { exp(r, x); });
        each([&](ball& r) { sin(r, x); });
        each([&](ball& r) { tan(r, x); });
        each([&](ball& r) { atan(r, x); });
        each([&](ball& r) { agm(r, x, y); });
        each([&](ball& r) {
          ball other = sample(random, q);
          sin_cos(other, r, x);
        });
      }
    }
  }
}

TEST(Storage, InContainers) {
  random_source random(702);
  std::vector<ball> balls;
  std::vector<exact_set> sets;
  for (int i = 0; i < 300; ++i) {  // grows, and moves its elements
    balls.push_back(random.any_ball(random.choose(std::array<precision, 4>{64, 256, 257, 700})));
    sets.push_back(exact(balls.back()));
  }
  balls.erase(balls.begin(), balls.begin() + 100);
  sets.erase(sets.begin(), sets.begin() + 100);
  for (std::size_t i = 0; i < balls.size(); ++i) EXPECT_EQ(exact(balls[i]), sets[i]);
}

TEST(Storage, Cells) {
  detail::mpfr_cell a;
  EXPECT_TRUE(a.is_empty());
  detail::mpfr_cell b = a;
  EXPECT_TRUE(b.is_empty());
  for (const precision p : sizes) {
    a.reset(p);
    EXPECT_FALSE(a.is_empty());
    EXPECT_EQ(mpfr_get_prec(a.get()), p);
    EXPECT_TRUE(mpfr_zero_p(a.get()) != 0) << "a new precision starts from 0";
    mpfr_set_si(a.get(), 1, MPFR_RNDN);
    mpfr_nextabove(a.get());
    const rational value = support::to_rational(a.get());
    a.reset(p);
    EXPECT_EQ(support::to_rational(a.get()), value) << "the same precision keeps the value";
    b = a;
    detail::mpfr_cell c(70);
    c.swap(a);
    EXPECT_EQ(mpfr_get_prec(a.get()), 70);
    EXPECT_EQ(support::to_rational(c.get()), value);
    a.swap(c);
    EXPECT_EQ(support::to_rational(a.get()), value);
    EXPECT_EQ(support::to_rational(b.get()), value);
    a.swap(a);
    EXPECT_EQ(support::to_rational(a.get()), value);
  }
  for (auto p = sizes.rbegin(); p != sizes.rend(); ++p) {  // down again: the storage is kept
    a.reset(*p);
    EXPECT_EQ(mpfr_get_prec(a.get()), *p);
    mpfr_set_si(a.get(), 3, MPFR_RNDN);
    EXPECT_EQ(mpfr_get_si(a.get(), MPFR_RNDN), 3);
  }
  detail::mpfr_cell d = std::move(a);
  EXPECT_TRUE(a.is_empty());  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(mpfr_get_si(d.get(), MPFR_RNDN), 3);
  d = a;
  EXPECT_TRUE(d.is_empty());
}

}  // namespace storage_test
}  // namespace polhode
