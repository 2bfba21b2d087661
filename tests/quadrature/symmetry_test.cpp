// Symmetry as a type: what it claims, held against balls; and the integrals that rest on it.

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/elliptic/complete.hpp"
#include "quadrature/formula/symmetry.hpp"
#include "quadrature/known_integrals.hpp"

namespace polhode {
namespace symmetry_test {

using support::holds;

constexpr precision bits = 160;

pi_combination turns(const rational& r) { return {0, r}; }

/// A motion of the line: as a symmetry of the argument, and as what it does to numbers.
struct motion {
  symmetry argument;
  std::function<ball(const ball&)> of;
};
motion reflection(const pi_combination& a) {
  return {symmetry::reflection(a), [a](const ball& x) { return 2 * a.at(bits) - x; }};
}
motion translation(const pi_combination& by) {
  return {symmetry::translation(by), [by](const ball& x) { return x + by.at(bits); }};
}

/// A function in both arithmetics.
struct function {
  std::string name;
  std::function<symmetry(const symmetry&)> under;
  std::function<ball(const ball&)> at;
};
template <class F>
function both(std::string name, F f) {
  return {std::move(name), [f](const symmetry& x) { return f(x); },
          [f](const ball& x) { return f(x); }};
}
#define POLHODE_BOTH(...) both(#__VA_ARGS__, [](const auto& x) { return __VA_ARGS__; })

std::vector<function> unary_functions() {
  return {POLHODE_BOTH(-x),
          POLHODE_BOTH(square(x)),
          POLHODE_BOTH(pow(x, 2)),
          POLHODE_BOTH(pow(x, 3)),
          POLHODE_BOTH(pow(x, -3)),
          POLHODE_BOTH(pow(x, -2)),
          POLHODE_BOTH(pow(x, 0)),
          POLHODE_BOTH(root(x, 3)),
          POLHODE_BOTH(root(x, 4)),
          POLHODE_BOTH(sqrt(x)),
          POLHODE_BOTH(exp(x)),
          POLHODE_BOTH(expm1(x)),
          POLHODE_BOTH(log(x)),
          POLHODE_BOTH(log1p(x)),
          POLHODE_BOTH(sin(x)),
          POLHODE_BOTH(cos(x)),
          POLHODE_BOTH(tan(x)),
          POLHODE_BOTH(sinpi(x)),
          POLHODE_BOTH(cospi(x)),
          POLHODE_BOTH(asin(x)),
          POLHODE_BOTH(acos(x)),
          POLHODE_BOTH(atan(x)),
          POLHODE_BOTH(sinh(x)),
          POLHODE_BOTH(cosh(x)),
          POLHODE_BOTH(tanh(x)),
          POLHODE_BOTH(asinh(x)),
          POLHODE_BOTH(acosh(x)),
          POLHODE_BOTH(atanh(x)),
          POLHODE_BOTH(abs(x)),
          POLHODE_BOTH(floor(x)),
          POLHODE_BOTH(ceil(x)),
          POLHODE_BOTH(gamma(x)),
          POLHODE_BOTH(log_gamma(x)),
          POLHODE_BOTH(erf(x)),
          POLHODE_BOTH(erfc(x)),
          POLHODE_BOTH(2 * x),
          POLHODE_BOTH(x * -3),
          POLHODE_BOTH(x / 2),
          POLHODE_BOTH(1 / x),
          POLHODE_BOTH(x + 1),
          POLHODE_BOTH(rational(1, 2) - x),
          POLHODE_BOTH(x - rational(2, 3))};
}

using two = std::function<function(const function&, const function&)>;
#define POLHODE_OF_TWO(...)                                                  \
  [](const function& f, const function& g) {                                 \
    return function{"(" + f.name + " and " + g.name + ": " #__VA_ARGS__ ")", \
                    [f, g](const symmetry& t) {                              \
                      const symmetry u = f.under(t), v = g.under(t);         \
                      return __VA_ARGS__;                                    \
                    },                                                       \
                    [f, g](const ball& t) -> ball {                          \
                      const ball u = f.at(t), v = g.at(t);                   \
                      return __VA_ARGS__;                                    \
                    }};                                                      \
  }
std::vector<two> binary_functions() {
  return {POLHODE_OF_TWO(u + v),       POLHODE_OF_TWO(u - v),       POLHODE_OF_TWO(u * v),
          POLHODE_OF_TWO(u / v),       POLHODE_OF_TWO(min(u, v)),   POLHODE_OF_TWO(max(u, v)),
          POLHODE_OF_TWO(hypot(u, v)), POLHODE_OF_TWO(atan2(u, v)), POLHODE_OF_TWO(agm(u, v)),
          POLHODE_OF_TWO(pow(u, v))};
}

function composed(const function& outer, const function& inner) {
  return {outer.name + " of " + inner.name,
          [outer, inner](const symmetry& t) { return outer.under(inner.under(t)); },
          [outer, inner](const ball& t) { return outer.at(inner.at(t)); }};
}

function constant(const pi_combination& c) {
  return {"constant", [c](const symmetry&) { return symmetry(c); },
          [c](const ball&) { return c.at(bits); }};
}

/// Small expressions of x.
function random_function(support::random_source& random, int depth) {
  static const std::vector<function> unary = unary_functions();
  static const std::vector<two> binary = binary_functions();
  const auto one_of = [&](const auto& list) {
    return list[static_cast<std::size_t>(random.between(0, static_cast<long>(list.size()) - 1))];
  };
  if (depth == 0 || random.one_in(8)) {
    if (random.one_in(4)) {
      return constant({rational(random.between(-3, 3), random.between(1, 2)),
                       rational(random.between(-2, 2), random.between(1, 2))});
    }
    return both("x", [](const auto& x) { return x + 0; });
  }
  if (random.one_in(2)) return composed(one_of(unary), random_function(random, depth - 1));
  // Sums and products more often than the rest.
  const two f =
      random.one_in(2) ? one_of(binary) : binary[static_cast<std::size_t>(random.between(0, 3))];
  return f(random_function(random, depth - 1), random_function(random, depth - 1));
}

motion random_motion(support::random_source& random) {
  const rational size(random.between(-4, 4), random.between(1, 2));
  const pi_combination by = random.one_in(2) ? pi_combination{size, 0} : turns(size);
  return random.one_in(3) ? translation(by) : reflection(by);
}

TEST(Symmetry, WhatItClaimsIsTrue) {
  support::random_source random(71);
  long claims = 0;
  for (support::repeat trial(25'000); trial.again();) {
    const function f = random_function(random, static_cast<int>(random.between(1, 4)));
    const motion sigma = random_motion(random);
    const symmetry claimed = f.under(sigma.argument);
    if (claimed.is_constant() || (!claimed.is_invariant() && !claimed.is_odd())) continue;
    const ball x(rational(random.between(-3000, 3000), 1000), bits);
    const ball here = f.at(x);
    const ball there = f.at(sigma.of(x));
    if (!here.is_bounded() || !there.is_bounded()) continue;
    ++claims;
    EXPECT_TRUE(overlaps(there, claimed.is_odd() ? -here : here))
        << f.name << " at " << to_decimal(x, 10) << ": " << here << " and " << there;
  }
  EXPECT_GE(static_cast<double>(claims), 1000 * support::effort());
}

TEST(Symmetry, ValuesOfConstantsAreTheirs) {
  support::random_source random(72);
  long known = 0;
  for (support::repeat trial(20'000); trial.again();) {
    const function f = random_function(random, static_cast<int>(random.between(1, 3)));
    const symmetry claimed = f.under(symmetry());
    if (!claimed.value()) continue;
    const ball value = f.at(ball(rational(random.between(-3000, 3000), 1000), bits));
    if (!value.is_bounded()) continue;
    ++known;
    EXPECT_TRUE(overlaps(value, claimed.value()->at(bits))) << f.name;
  }
  EXPECT_GE(static_cast<double>(known), 300 * support::effort());
}

// One function after another, of an odd, an even and a shifted argument: what must be found.
TEST(Symmetry, FindsTheParityOfEachFunction) {
  const symmetry odd = symmetry::reflection({});
  const symmetry even = square(odd);
  const std::vector<std::string> odd_ones{
      "-x",       "pow(x, 3)", "pow(x, -3)", "root(x, 3)", "sin(x)",  "tan(x)",
      "sinpi(x)", "asin(x)",   "atan(x)",    "sinh(x)",    "tanh(x)", "asinh(x)",
      "atanh(x)", "erf(x)",    "2 * x",      "x * -3",     "x / 2",   "1 / x"};
  const std::vector<std::string> even_ones{"square(x)", "pow(x, 2)", "pow(x, -2)", "pow(x, 0)",
                                           "cos(x)",    "cospi(x)",  "cosh(x)",    "abs(x)"};
  const auto is_in = [](const std::string& name, const std::vector<std::string>& list) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  for (const function& f : unary_functions()) {
    EXPECT_EQ(f.under(odd).is_odd(), is_in(f.name, odd_ones)) << f.name;
    EXPECT_EQ(f.under(odd).is_invariant(), is_in(f.name, even_ones)) << f.name;
    EXPECT_TRUE(f.under(even).is_invariant()) << f.name;
    EXPECT_TRUE(f.under(symmetry(2)).is_constant() || f.name == "1 / x") << f.name;
  }
}

TEST(Symmetry, KnowsTheCircularFunctionsAboutMultiplesOfPi) {
  const auto about = [](const rational& r) { return symmetry::reflection(turns(r)); };
  const rational half(1, 2);
  EXPECT_TRUE(sin(about(half)).is_invariant());
  EXPECT_TRUE(cos(about(half)).is_odd());
  EXPECT_TRUE(sin(about(1)).is_odd());
  EXPECT_TRUE(cos(about(1)).is_invariant());
  EXPECT_TRUE(sin(about(-half)).is_invariant());
  EXPECT_TRUE(cos(about(3 * half)).is_odd());
  EXPECT_TRUE(tan(about(half)).is_odd());
  EXPECT_TRUE(tan(about(1)).is_odd());
  EXPECT_TRUE(cos(2 * about(half)).is_invariant());
  EXPECT_FALSE(cos(about(rational(1, 3))).is_invariant());
  EXPECT_TRUE(cos(3 * about(rational(1, 3))).is_invariant());
  EXPECT_TRUE(cospi(symmetry::reflection({1, 0})).is_invariant());
  EXPECT_TRUE(sinpi(symmetry::reflection({rational(1, 2), 0})).is_invariant());
  EXPECT_FALSE(cospi(about(1)).is_invariant());
  EXPECT_FALSE(cos(symmetry::reflection({1, 0})).is_invariant());
  EXPECT_TRUE(
      cos(symmetry(pi_combination(turns(1))) * symmetry::reflection({1, 0})).is_invariant());
  EXPECT_TRUE(cospi(about(1) / symmetry(turns(1))).is_invariant());
  EXPECT_TRUE((acos(symmetry::reflection({})) - symmetry(turns(half))).is_odd());
  EXPECT_TRUE((erfc(symmetry::reflection({})) - 1).is_odd());
  const symmetry turn = symmetry::translation(turns(2));
  EXPECT_TRUE(sin(turn).is_invariant());
  EXPECT_TRUE(sin(turn / 2).is_odd());
  EXPECT_TRUE(tan(turn / 2).is_invariant());
  EXPECT_FALSE(sin(turn / 3).is_invariant());
  EXPECT_FALSE((turn + sin(turn)).is_invariant());
  EXPECT_TRUE(cos(turn + 5).is_invariant());
  EXPECT_TRUE(cos(turn + ball(5, 64)).is_invariant());
}

TEST(Symmetry, ForgetsNumbersThatGrow) {
  symmetry large(rational(3, 7));
  for (int i = 0; i < 40; ++i) large = square(large);  // 2^40 factors
  EXPECT_TRUE(large.is_constant());
  EXPECT_FALSE(large.value());
  EXPECT_FALSE((symmetry(1) / symmetry(0)).is_constant());
}

// ---------------------------------------------------------------------------------------------
// Integrals

constexpr precision value_bits = 500;
const end_point half_turn = end_point::pi(rational(1, 2));
const std::vector trapezoid_only{quadrature_rule::trapezoid};

struct symmetric_integral {
  std::string name;
  std::function<integral(const integrate_options&)> run;
  ball value;
  double evaluations;  // for 50 digits
};
template <class F>
symmetric_integral with(std::string name, F f, const end_point& a, const end_point& b, ball value,
                        double evaluations) {
  return {std::move(name), [=](const integrate_options& o) { return integrate(f, a, b, o); },
          std::move(value), evaluations};
}

/// I_0(1), the modified Bessel function: sum of 4^-k/k!^2.
ball bessel_i0_of_1() {
  ball term(1, value_bits);
  ball sum = term;
  for (long k = 1; k < 80; ++k) sum += term = term / (4 * k * k);
  return sum.enlarged(magnitude::power_of_two(-600));
}

TEST(SymmetricIntegral, IsTheTrapezoidalRules) {
  const ball p = pi(value_bits);
  const ball half(rational(1, 2), value_bits);
  for (const symmetric_integral& i : {
           // K(k), k^2 = 1/2.
           with(
               "K", [](const auto& x) { return 1 / sqrt(1 - square(sin(x)) / 2); }, 0, half_turn,
               p / (2 * agm(ball(1, value_bits), sqrt(half))), 40),
           // GR 3.613 1: the whole circle, which is even about pi.
           with(
               "Poisson", [](const auto& x) { return 1 / (5 - 4 * cos(x)); }, 0, end_point::pi(2),
               2 * p / 3, 97),
           with(
               "shifted circle", [](const auto& x) { return exp(cos(x)); }, 1,
               end_point(pi_combination{1, 2}), 2 * p * bessel_i0_of_1(), 43),
           with(
               "two periods", [](const auto& x) { return exp(sin(x)); }, -end_point::pi(),
               end_point::pi(3), 4 * p * bessel_i0_of_1(), 43),
           with(
               "reversed", [](const auto& x) { return exp(sin(x)); }, end_point::pi(),
               -end_point::pi(), -2 * p * bessel_i0_of_1(), 43),
       }) {
    // Of hyperexponential ones the front door makes Taylor series.
    const bool is_chosen = i.name != "K" && i.name != "Poisson";
    const integral result =
        i.run({.digits = 50,
               .rule = is_chosen ? quadrature_rule::automatic : quadrature_rule::trapezoid});
    EXPECT_EQ(result.verdict, status::certified) << i.name;
    EXPECT_TRUE(holds(result, i.value)) << i.name;
    EXPECT_EQ(result.account.rules, trapezoid_only) << i.name;
    EXPECT_NEAR(static_cast<double>(result.account.evaluations), i.evaluations, 1) << i.name;
  }
}

// Each has a symmetry that is not enough.
TEST(SymmetricIntegral, IsNotSeenWhereThereIsNone) {
  const ball p = pi(value_bits);
  const auto number = [](long n) { return ball(n, value_bits); };
  for (const symmetric_integral& i : {
           with(
               "sin x + cos 2x", [](const auto& x) { return sin(x) + cos(2 * x); }, 0, half_turn,
               number(1), 0),
           with(
               "cos(x/3)", [](const auto& x) { return cos(x / 3); }, 0, half_turn, number(3) / 2,
               0),
           with(
               "x sin x", [](const auto& x) { return x * sin(x); }, 0, end_point::pi(), p, 0),
           with(
               "e^x", [](const auto& x) { return exp(x); }, 0, end_point::pi(), exp(p) - 1, 0),
           with(
               "odd about both", [](const auto& x) { return sin(x) / (2 + cos(x)); }, 0,
               end_point::pi(), log(number(3)), 0),
           with(
               "even about one", [](const auto& x) { return square(x) * cos(x); }, 0,
               end_point::pi(), -2 * p, 0),
           with(
               "sin over half a period", [](const auto& x) { return sin(x); }, 0, end_point::pi(),
               number(2), 0),
           with(
               "nearly a period", [](const auto& x) { return 1 + cos(x * rational(1001, 1000)); },
               0, end_point::pi(2),
               2 * p + sin(2 * p * rational(1001, 1000)) * rational(1000, 1001), 0),
           with(
               "a root at an end", [](const auto& x) { return sqrt(x); }, 0, end_point::pi(),
               2 * p * sqrt(p) / 3, 0),
           with(
               "a kink between", [](const auto& x) { return abs(sin(x)); }, half_turn,
               end_point::pi(rational(3, 2)), number(2), 0),
           with(
               "a kink at even ends", [](const auto& x) { return abs(sin(x)); }, 0, end_point::pi(),
               number(2), 0),
       }) {
    const integral result = i.run({.digits = 50});
    EXPECT_EQ(result.verdict, status::certified) << i.name << ": " << result.obstacle;
    EXPECT_TRUE(holds(result, i.value)) << i.name;
    for (const quadrature_rule rule : result.account.rules) {
      EXPECT_NE(rule, quadrature_rule::trapezoid) << i.name;
    }
  }
}

TEST(SymmetricIntegral, OfWhatIsNotAnalyticIsRefusedOrOtherwiseDone) {
  // A pole between; and one beyond the reach of a strip that pays.
  const auto pole = [](const auto& x) { return 1 / (1 - 2 * cos(x)); };
  EXPECT_NE(integrate(pole, 0, end_point::pi()).verdict, status::certified);
  const rational near = rational(1) + support::power_of_ten(-12);
  const auto close = [=](const auto& x) { return 1 / (near - cos(x)); };
  const integral result = integrate(close, 0, end_point::pi(), {.digits = 30});
  EXPECT_EQ(result.verdict, status::certified);
  EXPECT_EQ(result.account.rules, std::vector{quadrature_rule::taylor_series});
  EXPECT_TRUE(holds(result, pi(value_bits) / sqrt(ball(near * near - 1, value_bits))));
  const auto of_another_kind = [=](const auto& x) { return exp(cos(x)) / (near - cos(x)); };
  const integral other = integrate(of_another_kind, 0, end_point::pi(), {.digits = 30});
  EXPECT_EQ(other.verdict, status::certified);
  EXPECT_EQ(other.account.rules, std::vector{quadrature_rule::gauss_legendre});
}

TEST(SymmetricIntegral, OfRandomTrigonometricFunctionsIsThatOverTheHalves) {
  support::random_source random(73);
  for (support::repeat trial(40); trial.again();) {
    const rational a(random.between(-5, 5), 3);
    const rational k = random.between(1, 3);
    const rational c(random.between(11, 30), 10);
    const rational s(random.between(-1, 1));
    const auto f = [=](const auto& x) {
      return (1 + s * sin(x)) * sqrt(c + cos(k * x)) + square(sin(k * x)) / (c + sin(x));
    };
    const end_point from(pi_combination{a, 0});
    const end_point middle(pi_combination{a, rational(random.between(1, 5), 3)});
    const end_point to(pi_combination{a, 2});
    const integrate_options options{.digits = random.between(3, 40)};
    const integral whole = integrate(f, from, to, options);
    EXPECT_EQ(whole.verdict, status::certified) << whole.obstacle;
    const ball sum =
        integrate(f, from, middle, options).enclosure + integrate(f, middle, to, options).enclosure;
    EXPECT_TRUE(support::meet(whole.enclosure, sum));
  }
}

// |sin| and |cos| are even about both limits, but their analytic pieces are not.
TEST(SymmetricIntegral, OfPiecesIsNotThatOfTheirContinuations) {
  const integrate_options options{.digits = 40};
  const auto is = [](const integral& i, long value) {
    EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
    EXPECT_TRUE(contains(i.enclosure, ball(value, 64))) << i.enclosure;
  };
  const auto sine = [](const auto& x) { return abs(sin(x)); };
  const auto cosine = [](const auto& x) { return abs(cos(x)); };
  const end_point half = end_point::pi(rational(1, 2));
  is(integrate(sine, 0, end_point::pi(), options), 2);
  is(integrate(sine, -end_point::pi(), end_point::pi(), options), 4);
  is(integrate(sine, half, end_point::pi(rational(3, 2)), options), 2);
  is(integrate(cosine, 0, end_point::pi(), options), 2);
  is(integrate(cosine, -half, half, options), 2);
  is(integrate([](const auto& x) { return max(sin(x), -sin(x)); }, 0, end_point::pi(2), options),
     4);
  is(integrate([](const auto& x) { return sin(x) * floor(1 + sin(x)); }, 0, end_point::pi(2),
               options),
     2);
  is(integrate([](const auto& x) { return abs(sin(x)); }, 0, end_point::pi(),
               {.digits = 20, .rule = quadrature_rule::gauss_legendre}),
     2);
}

TEST(SymmetricIntegral, BetweenEqualLimitsIsZero) {
  const auto f = [](const auto& x) { return cos(x); };
  EXPECT_TRUE(integrate(f, end_point::pi(), end_point::pi()).enclosure.is_exact());
  EXPECT_TRUE(integrate(f, end_point::pi(), -end_point::pi(-1)).enclosure.is_exact());
}

TEST(Limit, OfMultiplesOfPi) {
  EXPECT_TRUE(overlaps(end_point::pi(rational(-3, 4)).at(100), pi(100) * rational(-3, 4)));
  EXPECT_TRUE(overlaps((-end_point(pi_combination{1, 2})).at(100), -1 - 2 * pi(100)));
  EXPECT_FALSE(end_point::pi().exact());
  EXPECT_EQ(end_point(pi_combination{7, 0}).exact(), rational(7));
  EXPECT_FALSE(end_point([](precision p) { return pi(p); }).form());
}

}  // namespace symmetry_test
}  // namespace polhode
