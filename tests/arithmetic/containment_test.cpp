// x in X and y in Y give x op y in X op Y, for the operations that exact rationals can follow.

#include <climits>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace containment_test {

using support::described;
using support::exact;
using support::exact_set;
using support::holds;
using support::identical;
using support::random_source;
using support::repeat;

struct binary_operation {
  std::string name;
  void (*in_place)(ball&, const ball&, const ball&);
  std::function<ball(const ball&, const ball&)> expression;
  std::function<void(ball&, const ball&)> compound;
  std::function<rational(const rational&, const rational&)> exactly;
  bool divides = false;
};

const std::vector<binary_operation>& binary_operations() {
  static const std::vector<binary_operation> all = {
      {"+", [](ball& r, const ball& x, const ball& y) { add(r, x, y); },
       [](const ball& x, const ball& y) { return x + y; }, [](ball& x, const ball& y) { x += y; },
       [](const rational& x, const rational& y) { return x + y; }},
      {"-", [](ball& r, const ball& x, const ball& y) { subtract(r, x, y); },
       [](const ball& x, const ball& y) { return x - y; }, [](ball& x, const ball& y) { x -= y; },
       [](const rational& x, const rational& y) { return x - y; }},
      {"*", [](ball& r, const ball& x, const ball& y) { multiply(r, x, y); },
       [](const ball& x, const ball& y) { return x * y; }, [](ball& x, const ball& y) { x *= y; },
       [](const rational& x, const rational& y) { return x * y; }},
      {"/", [](ball& r, const ball& x, const ball& y) { divide(r, x, y); },
       [](const ball& x, const ball& y) { return x / y; }, [](ball& x, const ball& y) { x /= y; },
       [](const rational& x, const rational& y) { return x / y; }, true},
  };
  return all;
}

TEST(Containment, FieldOperationsWithEveryAliasing) {
  random_source random(1);
  for (repeat trial(1500); trial.again();) {
    const ball x = random.any_ball();
    const ball y = random.any_ball();
    const precision p = std::max(x.precision(), y.precision());
    for (const binary_operation& op : binary_operations()) {
      SCOPED_TRACE(described(x) + ' ' + op.name + ' ' + described(y));
      const ball expected = op.expression(x, y);
      EXPECT_EQ(expected.precision(), p);

      if (op.divides && exact(y).holds(0)) {
        EXPECT_TRUE(expected.is_undefined());
      } else {
        for (int i = 0; i < 4; ++i) {
          const rational a = random.member(x);
          const rational b = random.member(y);
          EXPECT_TRUE(holds(expected, op.exactly(a, b))) << described(a) << ", " << described(b);
        }
      }

      ball r = random.used_ball();
      op.in_place(r, x, y);
      EXPECT_TRUE(identical(r, expected)) << "three addresses";
      r = x;
      op.in_place(r, r, y);
      EXPECT_TRUE(identical(r, expected)) << "the result is x";
      r = y;
      op.in_place(r, x, r);
      EXPECT_TRUE(identical(r, expected)) << "the result is y";
      r = x;
      op.compound(r, y);
      EXPECT_TRUE(identical(r, expected)) << "compound assignment";

      const ball twice = op.expression(x, ball(x));
      r = random.used_ball();
      op.in_place(r, x, x);
      EXPECT_TRUE(identical(r, twice)) << "x is y";
      r = x;
      op.in_place(r, r, r);
      EXPECT_TRUE(identical(r, twice)) << "all the same";
      if (!(op.divides && exact(x).holds(0))) {
        const rational a = random.member(x);
        EXPECT_TRUE(holds(twice, op.exactly(a, a)));
      }
    }
  }
}

// N with each operator on each side; `exactly` is N's value.
template <class N>
void check_mixed(random_source& random, const ball& x, const N& n, const rational& exactly) {
  SCOPED_TRACE(described(x) + " and " + described(exactly));
  const rational a = random.member(x);
  const auto agrees = [&](const ball& result, const rational& value) {
    EXPECT_EQ(result.precision(), x.precision());
    EXPECT_TRUE(holds(result, value));
  };
  agrees(x + n, a + exactly);
  agrees(n + x, a + exactly);
  agrees(x - n, a - exactly);
  agrees(n - x, exactly - a);
  agrees(x * n, a * exactly);
  agrees(n * x, a * exactly);
  ball r = x;
  agrees(r += n, a + exactly);
  r = x;
  agrees(r -= n, a - exactly);
  r = x;
  agrees(r *= n, a * exactly);
  if (exactly == 0) {
    EXPECT_TRUE((x / n).is_undefined());
    EXPECT_EQ((x / n).precision(), x.precision());
  } else {
    agrees(x / n, a / exactly);
    r = x;
    agrees(r /= n, a / exactly);
  }
  if (exact(x).holds(0)) {
    EXPECT_TRUE((n / x).is_undefined());
  } else {
    agrees(n / x, exactly / a);
  }
}

TEST(Containment, MachineIntegers) {
  random_source random(2);
  const std::vector<long> corners = {0, 1, -1, 2, 3, -7, LONG_MAX, LONG_MIN, LONG_MIN + 1};
  const std::vector<unsigned long> unsigned_corners = {0, 1, ULONG_MAX, ULONG_MAX - 1,
                                                       static_cast<unsigned long>(LONG_MAX) + 1};
  for (repeat trial(1000); trial.again();) {
    const ball x = random.any_ball();
    const long n = random.one_in(2) ? random.choose(corners) : random.between(LONG_MIN, LONG_MAX);
    const unsigned long u = random.one_in(2) ? random.choose(unsigned_corners)
                                             : static_cast<unsigned long>(random.bits());
    check_mixed(random, x, n, rational(n));
    check_mixed(random, x, u, rational(u));
    const int i = static_cast<int>(n);
    const auto s = static_cast<unsigned short>(u);
    check_mixed(random, x, i, rational(i));
    check_mixed(random, x, s, rational(s));
  }
}

TEST(Containment, MachineIntegersInThreeAddresses) {
  random_source random(3);
  for (repeat trial(1000); trial.again();) {
    const ball x = random.any_ball();
    const long n = random.one_in(2) ? LONG_MIN : random.between(-9, 9);
    SCOPED_TRACE(described(x) + " and " + std::to_string(n));
    const auto every_aliasing = [&](auto&& f, const ball& expected) {
      ball r = random.used_ball();
      f(r, x);
      EXPECT_TRUE(identical(r, expected));
      r = x;
      f(r, r);
      EXPECT_TRUE(identical(r, expected));
    };
    every_aliasing([&](ball& r, const ball& s) { add(r, s, n); }, x + n);
    every_aliasing([&](ball& r, const ball& s) { subtract(r, n, s); }, n - x);
    every_aliasing([&](ball& r, const ball& s) { multiply(r, s, n); }, x * n);
    every_aliasing([&](ball& r, const ball& s) { divide(r, s, n); }, x / n);
  }
}

TEST(Containment, BoostIntegersAndRationals) {
  random_source random(4);
  for (repeat trial(1000); trial.again();) {
    const ball x = random.any_ball();
    const integer n = random.one_in(10) ? integer(0) : random.any_integer(400);
    const rational q = random.one_in(10) ? rational(0) : random.any_rational(200);
    check_mixed(random, x, n, rational(n));
    check_mixed(random, x, q, q);
  }
}

TEST(Containment, ConstructionFromExactNumbers) {
  random_source random(5);
  for (repeat trial(3000); trial.again();) {
    const precision p = random.any_precision();
    const long n = random.between(LONG_MIN, LONG_MAX);
    const auto u = static_cast<unsigned long>(random.bits());
    const integer i = random.any_integer(500);
    const rational q = random.any_rational(300);
    const auto check = [&](const ball& x, const rational& value) {
      EXPECT_EQ(x.precision(), p);
      EXPECT_TRUE(holds(x, value));
      // Exact where p bits suffice, and else within half a unit in the last place (twice that
      // where the midpoint is a power of two above the value).
      EXPECT_EQ(x.is_exact(), support::to_rational(support::real(p, value, MPFR_RNDN)) == value);
      if (p >= 32) {
        EXPECT_LE(exact(x).width(), 2 * support::ulp(value, p));
      }
    };
    check(ball(n, p), rational(n));
    check(ball(u, p), rational(u));
    check(ball(i, p), rational(i));
    check(ball(q, p), q);
    check(ball(i.backend().data(), p), rational(i));
    check(ball(q.backend().data(), p), q);
  }
  EXPECT_TRUE(ball(LONG_MIN, 64).is_exact());
  EXPECT_TRUE(holds(ball(LONG_MIN, 2), rational(LONG_MIN)));
  EXPECT_TRUE(holds(ball(ULONG_MAX, 2), rational(ULONG_MAX)));
}

// -------------------------------------------------------------------------------------------------
// One operand.

void check_unary(const ball& x, const ball& expected,
                 const std::function<void(ball&, const ball&)>& f, random_source& random) {
  ball r = random.used_ball();
  f(r, x);
  EXPECT_TRUE(identical(r, expected)) << "two addresses";
  r = x;
  f(r, r);
  EXPECT_TRUE(identical(r, expected)) << "one address";
}

TEST(Containment, NegateScaleAbsSquare) {
  random_source random(6);
  for (repeat trial(3000); trial.again();) {
    const ball x = random.any_ball();
    SCOPED_TRACE(described(x));
    const long n = random.one_in(4) ? 0 : random.between(-400, 400);
    check_unary(
        x, -x, [](ball& r, const ball& s) { negate(r, s); }, random);
    check_unary(
        x, scale(x, n), [n](ball& r, const ball& s) { scale(r, s, n); }, random);
    check_unary(
        x, square(x), [](ball& r, const ball& s) { square(r, s); }, random);
    EXPECT_TRUE(identical(+x, x));
    for (int i = 0; i < 4; ++i) {
      const rational a = random.member(x);
      EXPECT_TRUE(holds(-x, -a));
      EXPECT_TRUE(holds(scale(x, n), a * support::power_of_two(n)));
      EXPECT_TRUE(holds(abs(x), abs(a)));
      EXPECT_TRUE(holds(square(x), a * a));
    }
    for (const ball& r : {-x, scale(x, n), abs(x), square(x)}) {
      EXPECT_EQ(r.precision(), x.precision());
    }
    // These lose nothing at all.
    const exact_set s = exact(x);
    const exact_set negated = exact(-x);
    EXPECT_EQ(negated.lower.has_value(), s.upper.has_value());
    if (s.is_bounded()) {
      EXPECT_EQ(*negated.lower, -*s.upper);
      EXPECT_EQ(*negated.upper, -*s.lower);
      EXPECT_EQ(exact(scale(x, n)).width(), s.width() * support::power_of_two(n));
    }
    const exact_set size = exact(abs(x));
    EXPECT_GE(size.lower.value(), 0);
    EXPECT_GE(exact(square(x)).lower.value(), 0);
    if (s.is_bounded()) {
      EXPECT_EQ(*size.upper, s.greatest_size());
      EXPECT_EQ(*size.lower, s.holds(0) ? rational(0) : std::min(abs(*s.lower), abs(*s.upper)));
    }
  }
}

/// n-th power of q, also for n < 0.
rational power(const rational& q, long n) {
  rational result = 1;
  for (long i = 0; i < std::abs(n); ++i) result *= q;
  return n < 0 ? rational(1 / result) : result;
}

TEST(Containment, IntegerPowers) {
  random_source random(7);
  for (repeat trial(3000); trial.again();) {
    const ball x = random.any_ball();
    const long n = random.between(-12, 12);
    SCOPED_TRACE(described(x) + " to the " + std::to_string(n));
    const ball r = pow(x, n);
    EXPECT_EQ(r.precision(), x.precision());
    if (n < 0 && exact(x).holds(0)) {
      EXPECT_TRUE(r.is_undefined());
      continue;
    }
    for (int i = 0; i < 4; ++i) {
      const rational a = random.member(x);
      EXPECT_TRUE(holds(r, power(a, n))) << described(a);
    }
    if (n == 0) {
      EXPECT_TRUE(identical(r, ball(1, x.precision())));
    }
    if (n > 0 && n % 2 == 0) {
      EXPECT_GE(exact(r).lower.value_or(-1), 0) << "an even power is not negative";
    }
  }
}

TEST(Containment, GreatIntegerPowers) {
  random_source random(8);
  for (repeat trial(60); trial.again();) {
    // Around 1 with a radius that n magnifies to anything from nothing to a wide set.
    const precision p = random.any_precision();
    support::real m(p);
    mpfr_set_ui_2exp(m, 1, -random.between(8, 30), MPFR_RNDN);
    mpfr_add_ui(m, m, 1, MPFR_RNDN);
    const ball x = ball::from_midpoint_radius(m, random.any_magnitude(-100, -56));
    const long n = random.between(-3000, 3000);
    SCOPED_TRACE(described(x) + " to the " + std::to_string(n));
    const rational a = *exact(x).lower;
    const rational b = *exact(x).upper;
    const auto to_the_n = [n](const rational& q) {
      integer above;
      integer below;
      const auto k = static_cast<unsigned long>(std::abs(n));
      mpz_pow_ui(above.backend().data(), numerator(q).backend().data(), k);
      mpz_pow_ui(below.backend().data(), denominator(q).backend().data(), k);
      return n < 0 ? rational(below) / rational(above) : rational(above) / rational(below);
    };
    EXPECT_TRUE(holds(pow(x, n), to_the_n(a)));
    EXPECT_TRUE(holds(pow(x, n), to_the_n(b)));
    EXPECT_TRUE(holds(pow(-x, n), (n % 2 == 0 ? 1 : -1) * to_the_n(a)));
    if (p >= 64) {  // and no more than that, however wide x^n has become
      const exact_set r = exact(pow(x, n));
      EXPECT_LE(r.width(), abs(to_the_n(a) - to_the_n(b)) * (1 + support::power_of_two(-8)) +
                               4 * support::ulp(r.greatest_size(), p));
    }
  }
}

/// r^2 is at least (at most) the square of the set's ends: sqrt decided without a root.
TEST(Containment, SquareRootAndHypotThroughSquares) {
  random_source random(9);
  const auto root_inside = [](const ball& r, const rational& squared) {
    const exact_set set = exact(r);
    return (!set.lower || *set.lower <= 0 || *set.lower * *set.lower <= squared) &&
           (!set.upper || (*set.upper >= 0 && *set.upper * *set.upper >= squared));
  };
  for (repeat trial(3000); trial.again();) {
    const ball x = random.any_ball();
    const ball y = random.any_ball();
    SCOPED_TRACE(described(x) + ", " + described(y));
    check_unary(
        x, sqrt(x), [](ball& r, const ball& s) { sqrt(r, s); }, random);
    EXPECT_EQ(sqrt(x).precision(), x.precision());
    const exact_set s = exact(x);
    if (!s.lower || *s.lower < 0) {
      EXPECT_TRUE(sqrt(x).is_undefined());
    } else {
      EXPECT_GE(exact(sqrt(x)).lower.value(), 0);
      for (int i = 0; i < 4; ++i) EXPECT_TRUE(root_inside(sqrt(x), random.member(x)));
    }
    const ball h = hypot(x, y);
    EXPECT_EQ(h.precision(), std::max(x.precision(), y.precision()));
    EXPECT_TRUE(identical(h, hypot(y, x)));
    EXPECT_GE(exact(h).lower.value(), 0);
    for (int i = 0; i < 4; ++i) {
      const rational a = random.member(x);
      const rational b = random.member(y);
      EXPECT_TRUE(root_inside(h, a * a + b * b));
    }
  }
}

}  // namespace containment_test
}  // namespace polhode
