// What end_series and tail_series say of a function, against the function in balls.

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "quadrature/ends/tail_series.hpp"
#include "quadrature/known_integrals.hpp"

namespace polhode {
namespace end_series_test {

constexpr precision working = 600;

/// A random expression: each step is made of earlier values, of which the first is the argument.
struct step {
  long function;
  std::size_t first;
  std::size_t second;
  rational constant;
};
using program = std::vector<step>;
constexpr long functions = 26;

template <class T>
T value_of_step(const step& s, const T& x, const T& y) {
  switch (s.function) {
    case 0:
      return x + y;
    case 1:
      return x - y;
    case 2:
    case 3:
      return x * y;
    case 4:
    case 5:
      return x / y;
    case 6:
      return x + s.constant;
    case 7:
      return s.constant * x;
    case 8:
      return s.constant / x;
    case 9:
      return exp(x);
    case 10:
      return sin(x);
    case 11:
      return 1 - cos(x);
    case 12:
      return tan(x);
    case 13:
      return atan(x);
    case 14:
      return sinh(x);
    case 15:
      return tanh(x);
    case 16:
      return asinh(x);
    case 17:
      return log(x);
    case 18:
      return sqrt(x);
    case 19:
      return abs(x);
    case 20:
      return max(x, y);
    case 21:
      return acos(x);
    case 22:
      return floor(x);
    case 23:
      return erf(x);
    case 24:
      return erfc(x);
    default:
      return square(x);
  }
}
template <class T>
T value_of(const program& p, const T& x) {
  std::vector<T> values{x};
  for (const step& s : p) values.push_back(value_of_step(s, values[s.first], values[s.second]));
  return values.back();
}

program random_program(support::random_source& random) {
  program p;
  const long length = random.between(1, 7);
  for (long k = 0; k < length; ++k) {
    const auto any = [&] {
      return static_cast<std::size_t>(random.between(std::max(0L, k - 2), k));
    };
    p.push_back(
        {random.between(0, functions - 1), any(), static_cast<std::size_t>(random.between(0, k)),
         rational(random.between(1, 6) * (random.one_in(2) ? 1 : -1), random.between(1, 4))});
  }
  return p;
}

/// |h(t)| <= t^m sum of sup |G_k| |log t|^k, the sign and the range, at t.
void check_at(const end_series& h, const ball& t, const ball& value) {
  if (value.is_undefined()) return;  // too few bits beside a singularity
  ball bound(0, working);
  for (int k = 0; k <= h.log_degree(); ++k) {
    const ball side = ball(0, working).enlarged(h.supremum(k));
    bound += abs(side) * pow(abs(log(t)), k);
  }
  bound = bound * pow(t, ball(h.exponent(), working));
  EXPECT_FALSE(certainly_less(ball(0, 64).enlarged(bound.magnitude_upper()), abs(value)));
  if (h.sign() > 0) {
    EXPECT_FALSE(certainly_negative(value));
  }
  if (h.sign() < 0) {
    EXPECT_FALSE(certainly_positive(value));
  }
  const double_interval range = h.real_range();
  if (!range.is_undefined()) {
    EXPECT_TRUE(overlaps(to_ball(range, 64), value));
  }
}

// 1 + t, whose two terms have other powers of t: the bounds are those of the sum, for |t| <= 1/2.
TEST(EndSeries, BoundsOfASumAreOverTheWholeSquare) {
  const known_number one(rational(1));
  const end_series x = end_series::argument(one, one, 1, 0.5);
  EXPECT_GE(x.supremum(0), magnitude::from_bits_down(3, -1));
  EXPECT_GE(x.real_range().upper(), 1.5);
}

TEST(EndSeries, HoldsRandomExpressions) {
  support::random_source random(21);
  long open = 0;
  long singular = 0;
  for (support::repeat trial(4000); trial.again();) {
    const program p = random_program(random);
    const long q = random.one_in(4) ? -random.between(1, 3) : random.between(1, 4);
    const rational a = q < 0 || random.one_in(2) ? rational(0) : rational(random.between(-2, 2));
    const rational s(random.between(1, 8) * (random.one_in(3) ? -1 : 1), random.between(1, 8));
    const std::array<double, 3> sizes{0.25, 0x1p-4, 0x1p-8};
    const double r = random.choose(sizes);
    const end_series h =
        value_of(p, end_series::argument(known_number(a), known_number(s), q, r)).simplified();
    if (h.is_blocked()) continue;
    ++open;
    if (denominator(h.exponent()) != 1 || h.log_degree() > 0 || h.exponent() < 0) ++singular;
    for (int k = 0; k < 4; ++k) {
      ball t = ball::exactly(r, working) * rational(random.between(1, 1000), 1000);
      if (random.one_in(3)) t = scale(t, -random.between(0, 100));
      check_at(h, t, value_of(p, ball(a + s * pow(t, q))));
    }
  }
  EXPECT_GE(open, 800 * std::min(1.0, support::effort()));
  EXPECT_GE(singular, 100 * std::min(1.0, support::effort()));
}

TEST(EndSeries, KnowsExponentsAndLogarithms) {
  const end_series x = end_series::argument(known_number(), known_number(rational(1)), 1, 0.25);
  struct row {
    end_series h;
    rational exponent;
    int log_degree;
  };
  const std::vector<row> rows = {
      {1 - cos(x), 2, 0},
      {(1 - cos(x)) / square(x), 0, 0},
      {log(x) / sqrt(x), rational(-1, 2), 1},
      {square(log(x)) * x, 1, 2},
      {sin(x) - x, 3, 0},
      {sqrt(1 - cos(x)), 1, 0},
      {pow(x, rational(2, 3)) / (exp(x) - 1), rational(-1, 3), 0},
      {acos(1 - square(x)), 1, 0},
      {exp(rational(3, 2) * log(x)), rational(3, 2), 0},
  };
  for (const row& r : rows) {
    const end_series h = r.h.simplified();
    ASSERT_FALSE(h.is_blocked()) << h.where();
    EXPECT_EQ(h.exponent(), r.exponent);
    EXPECT_EQ(h.log_degree(), r.log_degree);
    EXPECT_TRUE(h.leads_surely());
  }
}

TEST(EndSeries, OfTanhOfALogarithmIsARationalFunction) {
  // tanh(-log t) = (1 - t^2)/(1 + t^2), which is 15/17 at t = 1/4.
  const end_series t =
      end_series::argument(known_number(rational(0)), known_number(rational(1)), 1, 0.25);
  for (const auto& [sign, value] : {std::pair(-1L, 15.0 / 17), std::pair(1L, -15.0 / 17)}) {
    const end_series h = tanh(log(t) * sign);
    ASSERT_FALSE(h.is_blocked());
    const double_interval range = h.real_range();
    EXPECT_TRUE(range.lower() <= value && value <= range.upper());
    const auto limit = static_cast<double>(-sign);
    EXPECT_TRUE(range.lower() <= limit && limit <= range.upper());
    // Its difference from the limit is a power.
    EXPECT_EQ((h + sign).simplified().exponent(), rational(2));
  }
}

TEST(EndSeries, KnowsWhichAreRationalNumbers) {
  const end_series t =
      end_series::argument(known_number(rational(0)), known_number(rational(1)), 1, 0.25);
  const rational third(1, 3);
  const end_series constant = t.constant_like(third);
  EXPECT_EQ(constant.rational_constant(), third);
  EXPECT_EQ((constant * constant + 2).rational_constant(), rational(19, 9));
  for (const end_series& other :
       {constant + t, constant + square(t), t, 1 / t, log(t), exp(t), constant + t * log(t),
        t.constant_like(sqrt(ball(2, 64))), end_series::blocked("this")}) {
    EXPECT_FALSE(other.rational_constant());
  }
  // 0 is added to what has other roots of t, and nothing else is.
  EXPECT_FALSE((sqrt(t) + t * 0).is_blocked());
  EXPECT_EQ((t * 0 + sqrt(t)).simplified().exponent(), rational(1, 2));
  EXPECT_TRUE((sqrt(t) + square(t)).is_blocked());
}

TEST(EndSeries, IsBlockedWhereTheFormIsAnother) {
  const end_series x = end_series::argument(known_number(), known_number(rational(1)), 1, 0.25);
  for (const end_series& h :
       {exp(1 / x), sin(1 / x), exp(x * log(x)), 1 / (x - rational(1, 8)), 1 / log(x), sqrt(-x),
        log(-x), sqrt(x) + x, abs(x - rational(1, 8)), floor(8 * x), 1 / (x - x)}) {
    EXPECT_TRUE(h.is_blocked());
    EXPECT_TRUE(h.supremum(0).is_infinite());
  }
  // The exponent 1 + t^4 of t is 1 as far as is known after eight divisions by t, and no slope is
  // known.
  const end_series y = end_series::argument(known_number(), known_number(rational(1)), 4, 0x1p-4);
  const end_series exponent = (1 / square(y)) / (1 / (square(y) + square(y) * y));
  EXPECT_FALSE(exponent.is_blocked());
  EXPECT_TRUE(exp(log(y) * exponent).is_blocked());
}

TEST(EndSeries, KeepsTheSizeOfConstantsBeyondDoubles) {
  const rational huge = support::power_of_ten(2000);
  const region z(double_interval(1.0, 2.0), double_interval(0.0, 1.0));
  EXPECT_TRUE((z * huge).magnitude_upper() <= ball(huge * 3, 64).magnitude_upper());
  EXPECT_TRUE((z / huge).magnitude_lower() > magnitude());
  const end_series x = end_series::argument(known_number(), known_number(rational(1)), 1, 0.25);
  EXPECT_TRUE((x * huge).supremum(0) <= ball(huge, 64).magnitude_upper());
}

// The ring that holds the values of e^(c t) over the square leaves out 0, and a mean of them does
// not: t/(e^(c t) - 1) has poles at 2 pi i k/c.
TEST(EndSeries, OfAQuotientKnowsThePolesInItsSquare) {
  const auto planck = [](const end_series& t, long c) { return t / (exp(t * c) - 1); };
  const auto argument = [](double r) {
    return end_series::argument(known_number(), known_number(rational(1)), 1, r);
  };
  for (const long c : {13L, 40L, 80L}) {
    EXPECT_TRUE(planck(argument(0.5), c).is_blocked()) << c;
    EXPECT_FALSE(planck(argument(0x1p-8), c).is_blocked()) << c;
  }
  EXPECT_FALSE(planck(argument(0.25), 2).is_blocked());
}

template <class F>
void bounds_the_tail(const char* name, const F& f, const rational& s, double r, const rational& y) {
  const tail_series tail = f(tail_series::argument(known_number(s), r));
  ASSERT_FALSE(tail.is_blocked()) << name << ": " << tail.where();
  const magnitude bound = tail.integral_beyond(ball(y, 64));
  EXPECT_FALSE(bound.is_infinite()) << name;
  const integral part =
      integrate(f, end_point(rational(s * y)), end_point(rational(2 * s * y)), {.digits = 10});
  ASSERT_TRUE(part.enclosure.is_bounded()) << name;
  EXPECT_TRUE((part.enclosure / s).magnitude_lower() <= bound) << name;
}

TEST(TailSeries, BoundsTails) {
  support::random_source random(22);
  for (support::repeat trial(40); trial.again();) {
    const rational s(random.between(1, 8) * (random.one_in(2) ? -1 : 1), random.between(1, 3));
    const double r = random.one_in(2) ? 0x1p-5 : 0x1p-6;
    const rational y = rational(100) + random.between(0, 100);
    const rational c(random.between(3, 9), 3);
    const long power = random.between(-3, 5);
    bounds_the_tail(
        "Gauss", [=](const auto& x) { return pow(x, power) * exp(-c * x * x); }, s, r, y);
    bounds_the_tail(
        "log", [=](const auto& x) { return pow(x, power) * log(abs(x)) * exp(-c * abs(x)); }, s, r,
        y);
    bounds_the_tail(
        "sech", [=](const auto& x) { return pow(x, power) / cosh(c * x); }, s, r, y);
    bounds_the_tail(
        "sine", [=](const auto& x) { return (2 + sin(x)) * exp(-c * abs(x)); }, s, r, y);
    bounds_the_tail(
        "sum", [=](const auto& x) { return exp(-c * x * x) + exp(-abs(x)) * x; }, s, r, y);
    bounds_the_tail(
        "Bose", [=](const auto& x) { return x * x / (exp(c * abs(x)) - 1); }, s, r, y);
    bounds_the_tail(
        "equal",
        [=](const auto& x) {
          const auto e = exp(-sqrt(x * x + c));
          return e * sin(x) + exp(-sqrt(x * x + c)) * cos(x);
        },
        s, r, y);
    bounds_the_tail(
        "tanh", [=](const auto& x) { return tanh(x) * sqrt(abs(x)) * exp(-c * abs(x)); }, s, r, y);
  }
}

TEST(TailSeries, HasNoBoundWithoutDecayOrBelowItsStart) {
  const tail_series x = tail_series::argument(known_number(rational(1)), 0.25);
  const ball far(100, 64);
  for (const tail_series& f :
       {exp(x), 1 / x, sin(x), exp(-x) * exp(x), exp(sin(x)), tan(x) * exp(-x), exp(-x) / sin(x),
        sqrt(sin(x)) * exp(-x), exp(-x) + exp(x)}) {
    EXPECT_TRUE(f.integral_beyond(far).is_infinite());
  }
  EXPECT_FALSE(exp(-x).integral_beyond(far).is_infinite());
  EXPECT_TRUE(exp(-x).integral_beyond(ball(3, 64)).is_infinite());
  // log y <= y in size for y >= 1 only.
  const tail_series near = tail_series::argument(known_number(rational(1)), 4);
  EXPECT_TRUE((exp(-near) * log(near)).integral_beyond(ball(rational(1, 2), 64)).is_infinite());
}

// Both bounds touch at Y: log y at least its value there, and at most its tangent at 64. With the
// slope g < 0 of the exponent at Y, which falls beyond, the integral of e^h over y >= Y is at least
// e^h(Y) times that of e^((g - 1)(y - Y)) over one unit, so long as the slope is above g - 1 there.
TEST(TailSeries, OfExponentsWithLogarithms) {
  constexpr precision p = 200;
  const auto x = [](double r) { return tail_series::argument(known_number(rational(1)), r); };
  const auto expect_between = [](const tail_series& f, const ball& y, const ball& value) {
    const magnitude found = f.integral_beyond(y);
    EXPECT_GE(found, value.magnitude_lower());
    EXPECT_LE(found, (value * 20).magnitude_upper());
  };
  const auto at_least = [](const ball& height, const ball& slope) {
    return exp(height) * (1 - exp(slope - 1)) / (1 - slope);
  };
  {  // h = -y log y with the slope -log y - 1
    const ball y(4, p);
    expect_between(exp(-(x(0.25) * log(x(0.25)))), y, at_least(-(y * log(y)), -log(y) - 1));
  }
  {  // h = -y log^2 y with the slope -log^2 y - 2 log y
    const ball y(8, p);
    const ball l = log(y);
    expect_between(exp(-(x(0.125) * log(x(0.125)) * log(x(0.125)))), y,
                   at_least(-(y * l * l), -(l * l) - 2 * l));
  }
  {  // h = y log y - y^2/8 with the slope log y + 1 - y/4
    const ball y(64, p);
    const tail_series s = x(0x1p-6);
    expect_between(exp(s * log(s) - s * s / 8), y,
                   at_least(y * log(y) - y * y / 8, log(y) + 1 - y / 4));
  }
  // (log y)/y is greater at e than at 2.
  const tail_series near = x(0.5);
  EXPECT_TRUE(exp(near * log(near) - near * near / 2).integral_beyond(ball(2, p)).is_infinite());
  // Terms of a sign for which nothing is known.
  EXPECT_TRUE(exp(x(0.25) * log(x(0.25))).integral_beyond(ball(8, p)).is_infinite());
}

// x^(n/2048) is bounded by the power with the next exponent in 1024ths, above for x >= 1 and below
// for x <= 1: far out this is a percent more than the tail itself, and the exponent before it less.
TEST(TailSeries, OfAPowerIsBoundedFarOut) {
  constexpr precision p = 200;
  const ball far = scale(ball(1, p), 22);
  const double r = 0x1p-22;
  for (const long n : {1L, 3L, -1L, -5L, 2047L}) {
    const rational e(n, 2048);
    const tail_series x = tail_series::argument(known_number(rational(1)), r);
    const tail_series growing = exp(-x) * pow(x, x.constant_like(e));
    // As (y/Y)^e >= e^(e (y - Y)/Y) for e < 0, the tail is at least Y^e e^-Y/(1 - e/Y) there.
    const ball tail = exp(-far) * pow(far, ball(e, p)) * (1 - 1 / far);
    EXPECT_GE(growing.integral_beyond(far), tail.magnitude_lower()) << n;
    EXPECT_LE(growing.integral_beyond(far), (tail * rational(102, 100)).magnitude_lower()) << n;

    const tail_series t = tail_series::argument(known_number(), known_number(rational(1)), r);
    const tail_series vanishing = exp(-1 / t) * pow(t, t.constant_like(e));
    const ball beyond = exp(-far) * pow(far, ball(rational(-2 - e), p)) * (1 - 4 / far);
    EXPECT_GE(vanishing.integral_before(far), beyond.magnitude_lower()) << n;
    EXPECT_LE(vanishing.integral_before(far), (beyond * rational(102, 100)).magnitude_lower()) << n;
  }
}

}  // namespace end_series_test
}  // namespace polhode
