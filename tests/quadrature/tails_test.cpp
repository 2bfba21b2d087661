// What is cut off at an end is far below the digits asked for, so that no integral shows it: the
// bounds of what is left out against the tails themselves, in closed form.

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/expression/parse.hpp"
#include "quadrature/ends/tail_series.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/pieces/oscillation.hpp"
#include "quadrature/pieces/segments.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace tails_test {

constexpr precision p = 200;

/// |tail| <= bound <= factor |tail|.
void expect_bound(const magnitude& bound, const ball& tail, const rational& factor,
                  const char* name) {
  EXPECT_TRUE(tail.magnitude_lower() <= bound) << name;
  EXPECT_TRUE(bound <= (abs(tail) * factor).magnitude_lower())
      << name << ": " << ball(0, 64).enlarged(bound) << " for " << tail;
}

/// f from a to b is cut off in x itself, towards `end`; tail(x) is what lies beyond x.
template <class F, class Tail>
void check_tail(const char* name, const F& f, const end_point& a, const end_point& b,
                bool towards_b, const Tail& tail, const rational& factor) {
  detail::integrand in_x = integrand_of(formula_of(f));
  in_x.in_exponential = nullptr;
  in_x.growth = nullptr;
  for (const long bits : {1L, 100L}) {
    const auto prepared = detail::prepare(in_x, a, b, {}, bits);
    ASSERT_TRUE(prepared.why == reason::none && prepared.has_tail) << name;
    ball cut = prepared.segments.front().position(ball(0, p));
    for (const detail::segment& s : prepared.segments) {
      for (const long end : {0L, 1L}) {
        const ball x = s.position(ball(end, p));
        if (towards_b ? certainly_less(cut, x) : certainly_less(x, cut)) cut = x;
      }
    }
    expect_bound(prepared.remainder.magnitude_upper(), tail(cut), factor, name);
  }
}

TEST(Tails, OfExponentialDecayAreBounded) {
  const end_point infinity = end_point::infinity();
  const rational little(101, 100);
  check_tail(
      "exp(-x)", [](const auto& x) { return exp(-x); }, end_point(1), infinity, true,
      [](const ball& x) { return exp(-x); }, little);
  check_tail(
      "x^2 exp(-x)", [](const auto& x) { return x * x * exp(-x); }, end_point(1), infinity, true,
      [](const ball& x) { return (x * x + 2 * x + 2) * exp(-x); }, little);
  check_tail(
      "x^2 exp(x)", [](const auto& x) { return x * x * exp(x); }, -infinity, end_point(-1), false,
      [](const ball& x) { return (x * x - 2 * x + 2) * exp(x); }, little);
  check_tail(
      "exp(-x/3)/7", [](const auto& x) { return exp(-x / 3) / 7; }, end_point(2), infinity, true,
      [](const ball& x) { return 3 * exp(-x / 3) / 7; }, little);
  // Between x^2 (1 - 2x) exp(-1/x) and x^2 exp(-1/x).
  check_tail(
      "exp(-1/x)", [](const auto& x) { return exp(-1 / x); }, end_point(0), end_point(1), false,
      [](const ball& x) { return x * x * exp(-1 / x) * (1 - 2 * x); }, rational(6, 5));
}

// Broken powers beside whole ones: in y with x = y^root, over x >= y^root.
TEST(Tails, InARootAreBounded) {
  const auto expect_tail = [](const char* f, long root, const ball& y, const ball& tail) {
    const auto along =
        tail_series::argument(known_number(rational(1)), 0.5, end_series::most_orders, root);
    expect_bound(integrand_of(parse(f)).near_infinity(along).integral_beyond(y, root), tail,
                 rational(11, 10), f);
  };
  const ball y(8, p);
  expect_tail("exp(-x)", 2, y, exp(-y * y));
  expect_tail("exp(-x)", 3, y, exp(-y * y * y));
  expect_tail("exp(-x)*sqrt(x)", 2, y, y * exp(-y * y) + sqrt(pi(p)) / 2 * erfc(y));
  expect_tail("exp(-sqrt(x))", 2, y, 2 * (y + 1) * exp(-y));
}

TEST(Tails, OfExponentialsOfRootsAreBounded) {
  const end_point infinity = end_point::infinity();
  const rational little(11, 10);
  const auto u_of = [](const ball& x, long n) { return pow(x, ball(rational(1, n), p)); };
  check_tail(
      "exp(-x^(1/3))", [](const auto& x) { return exp(-pow(x, rational(1, 3))); }, end_point(1),
      infinity, true,
      [&](const ball& x) {
        const ball u = u_of(x, 3);
        return 3 * (u * u + 2 * u + 2) * exp(-u);
      },
      little);
  // 1/(e^u + 1) = e^-u - e^-2u/(1 + e^-u).
  check_tail(
      "1/(exp(sqrt(x)) + 1)", [](const auto& x) { return 1 / (exp(sqrt(x)) + 1); }, end_point(1),
      infinity, true,
      [&](const ball& x) {
        const ball u = u_of(x, 2);
        return 2 * (u + 1) * exp(-u) -
               (u + rational(1, 2)) * exp(-2 * u) * hull(ball(0, p), ball(1, p));
      },
      little);
  check_tail(
      "1/(exp(x^(4/3)) + x)", [](const auto& x) { return 1 / (exp(pow(x, rational(4, 3))) + x); },
      end_point(2), infinity, true,
      [&](const ball& x) {
        // The integral of e^-v dx with x = v^(3/4), dx = (3/4) v^(-1/4) dv, falls from 1 to
        // 1 - 1/(4 v) times its first term.
        const ball v = pow(x, ball(rational(4, 3), p));
        const ball leading = rational(3, 4) * pow(v, ball(rational(-1, 4), p)) * exp(-v);
        return leading * hull(ball(rational(1, 1), p), 1 - 1 / (4 * v) - x * exp(-v));
      },
      rational(3, 2));
}

/// The bound of the integral of |f| beyond 2, from f's series for x >= 2.
template <class F>
magnitude beyond_two(const F& f) {
  const tail_series x = tail_series::argument(known_number(rational(1)), 0.5);
  return f(x).integral_beyond(ball(2, 64));
}

// A second exponential that is hardly smaller than the first.
TEST(Tails, OfSumsOfExponentialsAreBounded) {
  const magnitude bound =
      beyond_two([](const auto& x) { return exp(-x) + exp(-x * rational(51, 50)); });
  const ball tail = exp(ball(-2, p)) + rational(50, 51) * exp(ball(rational(-51, 25), p));
  expect_bound(bound, tail, rational(102, 100), "exp(-x) + exp(-1.02 x)");
}

// With w = c e^(-x) the integrals are those of f(w)/w over 0 < w < c e^-2, by their power series.
TEST(Tails, OfFunctionsNearZeroAreBounded) {
  const auto integral_of = [](const rational& c, const auto& coefficient) {
    const ball w = c * exp(ball(-2, p));
    ball sum(0, p);
    ball power = w;
    for (long k = 1; k < 60; ++k) {  // the terms fall at least as 0.9^k/k^2 from the 20th on
      sum += coefficient(k) * power / k;
      power *= w;
    }
    return sum.enlarged(magnitude::power_of_two(-12));
  };
  const auto inverse_factorial = [](long k) {
    rational q(1);
    for (long j = 2; j <= k; ++j) q /= j;
    return q;
  };
  const auto sign = [](long k) { return k % 2 == 0 ? -1 : 1; };
  const rational c(36, 10);
  const rational little(13, 10);
  expect_bound(beyond_two([&](const auto& x) { return expm1(c * exp(-x)); }),
               integral_of(c, inverse_factorial), little, "expm1(w)");
  expect_bound(beyond_two([&](const auto& x) { return log1p(-c * exp(-x)); }),
               integral_of(c, [](long k) { return rational(1, k); }), rational(3, 2), "log1p(-w)");
  expect_bound(beyond_two([&](const auto& x) {
                 const auto w = c * exp(-x);
                 return expm1(-w) + rational(13, 10) * w;
               }),
               integral_of(c,
                           [&](long k) {
                             return rational((k == 1 ? rational(13, 10) : rational(0)) -
                                             sign(k) * inverse_factorial(k));
                           }),
               rational(3, 2), "expm1(-w) + 1.3 w");
  expect_bound(beyond_two([&](const auto& x) {
                 const auto w = c * exp(-x);
                 return log1p(w) - rational(139, 100) * w;
               }),
               integral_of(c,
                           [&](long k) {
                             return rational((k == 1 ? rational(139, 100) : rational(0)) -
                                             rational(sign(k), k));
                           }),
               rational(3, 2), "log1p(w) - 1.39 w");
  // Odd functions: those that are convex for w > 0 pass w, and w passes the others.
  const auto odd = [](std::vector<rational> coefficients, bool alternating) {
    return [coefficients = std::move(coefficients), alternating](long k) {
      const auto n = static_cast<std::size_t>(k / 2);
      if (k % 2 == 0 || n >= coefficients.size()) return rational(0);
      return rational(alternating && n % 2 == 1 ? rational(-coefficients[n]) : coefficients[n]);
    };
  };
  const std::vector<rational> of_tan{1, {1, 3}, {2, 15}, {17, 315}, {62, 2835}};
  const std::vector<rational> of_atanh{1, {1, 3}, {1, 5}, {1, 7}, {1, 9}};
  const std::vector<rational> of_sinh{1, {1, 6}, {1, 120}, {1, 5040}};
  const std::vector<rational> of_asin{1, {1, 6}, {3, 40}, {15, 336}, {105, 3456}};
  const auto convex = [&](const char* name, const auto& f, const std::vector<rational>& all) {
    expect_bound(beyond_two([&](const auto& x) { return f(c * exp(-x)); }),
                 integral_of(c, odd(all, false)), little, name);
  };
  convex(
      "tan(w)", [](const auto& w) { return tan(w); }, of_tan);
  convex(
      "asin(w)", [](const auto& w) { return asin(w); }, of_asin);
  convex(
      "sinh(w)", [](const auto& w) { return sinh(w); }, of_sinh);
  convex(
      "atanh(w)", [](const auto& w) { return atanh(w); }, of_atanh);
  const auto concave = [&](const char* name, const auto& f, const std::vector<rational>& all) {
    std::vector<rational> rest = all;
    rest[0] = 0;
    const ball missing = -integral_of(c, odd(rest, true));
    const magnitude bound = beyond_two([&](const auto& x) {
      const auto w = c * exp(-x);
      return f(w) - w;
    });
    EXPECT_TRUE(missing.magnitude_lower() <= bound) << name << ' ' << missing;
  };
  concave(
      "w - sin(w)", [](const auto& w) { return sin(w); }, of_sinh);
  concave(
      "w - atan(w)", [](const auto& w) { return atan(w); }, of_atanh);
  concave(
      "w - tanh(w)", [](const auto& w) { return tanh(w); }, of_tan);
  concave(
      "w - asinh(w)", [](const auto& w) { return asinh(w); }, of_asin);
  // erf(w) = (2/sqrt(pi)) (w - w^3/3 + w^5/10 - w^7/42 + w^9/216 - ...), between 1.0409 w and
  // 1.1284 w.
  const std::vector<rational> of_erf{1, {1, 3}, {1, 10}, {1, 42}, {1, 216}};
  const ball factor = 2 / sqrt(pi(p));
  const ball of_w = c * exp(ball(-2, p));
  const ball area = factor * integral_of(c, odd(of_erf, true));
  expect_bound(beyond_two([&](const auto& x) { return erf(c * exp(-x)); }), area, little, "erf(w)");
  expect_bound(beyond_two([&](const auto& x) {
                 const auto w = c * exp(-x);
                 return erf(w) - rational(11284, 10000) * w;
               }),
               rational(11284, 10000) * of_w - area, rational(5), "1.1284 w - erf(w)");
  // x/tanh(x) and 1/atan(x) are bounded by what tanh and atan are at 2.
  expect_bound(beyond_two([](const auto& x) { return exp(-x) / tanh(x); }),
               log((1 + exp(ball(-2, p))) / (1 - exp(ball(-2, p)))) - exp(ball(-2, p)),
               rational(11, 10), "exp(-x)/tanh(x)");
  expect_bound(beyond_two([](const auto& x) { return exp(-x) / atan(x); }),
               exp(ball(-2, p)) / rational(16, 10), rational(2), "exp(-x)/atan(x)");
  // Beyond 1/2 nothing is said of expm1 w.
  const magnitude great = beyond_two([](const auto& x) { return expm1(12 * exp(-x)); });
  EXPECT_TRUE(integral_of(12, inverse_factorial).magnitude_lower() <= great);
}

// 1 + w, of which the logarithm is that of log1p w.
TEST(Tails, OfLogarithmsNearOneAreBounded) {
  const ball w = exp(ball(-2, p));
  ball sum(0, p);
  ball power = w;
  for (long k = 1; k < 60; ++k, power *= w) sum += (k % 2 == 0 ? -1 : 1) * power / (k * k);
  const ball tail = sum.enlarged(magnitude::power_of_two(-100));
  expect_bound(beyond_two([](const auto& x) { return log(1 + exp(-x)); }), tail, rational(3, 2),
               "log(1 + w)");
  expect_bound(beyond_two([](const auto& x) { return log(exp(-x) + 1); }), tail, rational(3, 2),
               "log(w + 1)");
}

TEST(Tails, OfErrorFunctionsAreBounded) {
  const ball tail = exp(ball(-4, p)) / sqrt(pi(p)) - 2 * erfc(ball(2, p));
  expect_bound(beyond_two([](const auto& x) { return erfc(x); }), tail, rational(3, 2), "erfc");
  // Of less than e^-x/200.
  const ball whole = exp(ball(-2, p));
  const magnitude bound = beyond_two([](const auto& x) { return erf(x) * exp(-x); });
  EXPECT_TRUE((whole * rational(199, 200)).magnitude_lower() <= bound);
  EXPECT_TRUE(bound <= (whole * rational(101, 100)).magnitude_upper());
  const magnitude mirrored = beyond_two([](const auto& x) { return erf(-x) * exp(-x); });
  EXPECT_TRUE((whole * rational(199, 200)).magnitude_lower() <= mirrored);
  // erfc of what may have any sign is at most 2, and is that nearly for x < -2.
  const magnitude doubled = beyond_two([](const auto& x) { return erfc(-x) * exp(-x); });
  EXPECT_TRUE((whole * rational(199, 100)).magnitude_lower() <= doubled);
}

// With z = 20 e and v = 20 e^(y/2), the integral of exp(-20 e^(y/2)) over y >= 2 is 2 E_1(z),
// between 2 e^-z/(z + 1) and 2 e^-z/z; the bound's tangent touches e^(y/2) at y = 2.
TEST(Tails, OfDoubleExponentialsAreBounded) {
  const ball z = 20 * exp(ball(1, p));
  const rational little(105, 100);
  expect_bound(beyond_two([](const auto& x) { return exp(-20 * exp(x / 2)); }),
               2 * exp(-z) / (z + 1), little, "exp(-20 exp(x/2))");
  // Of tanh it is known that it lies between -1 and 1; it is above 0.96 here, and the factors are
  // between 1 and 1.018.
  const ball more = z * rational(1018, 1000);
  const ball least = 2 * exp(-more) / (more + 1);
  const auto factor = [](const auto& x) { return rational(3, 2) - tanh(x) / 2; };
  expect_bound(beyond_two([&](const auto& x) { return exp(-20 * exp(x / 2) * factor(x)); }), least,
               4, "exp(-20 exp(x/2) U)");
  expect_bound(beyond_two([&](const auto& x) { return exp(20 * exp(x / 2) * -factor(x)); }), least,
               4, "exp(20 exp(x/2) (-U))");
  const ball slope(rational(509, 100), p);
  const ball simple = exp(-2 * slope) / slope;
  expect_bound(beyond_two([&](const auto& x) { return exp(-5 * x * factor(x)); }), simple,
               rational(3, 2), "exp(-5 x U)");
  expect_bound(beyond_two([&](const auto& x) { return exp(5 * x * -factor(x)); }), simple,
               rational(3, 2), "exp(5 x (-U))");
  // What grows has no tail.
  EXPECT_TRUE(beyond_two([&](const auto& x) { return exp(5 * x * factor(x)); }).is_infinite());
  EXPECT_TRUE(beyond_two([&](const auto& x) { return exp(exp(x) * factor(x)); }).is_infinite());
}

/// The integral of |f| beyond 2, of a formula in which nothing cancels.
ball integral_beyond_two(const char* formula) {
  const integral found =
      integrate(parse(formula), end_point(2), end_point::infinity(), {.digits = 30});
  EXPECT_EQ(found.verdict, status::certified) << formula;
  return abs(found.enclosure);
}

/// 1 + w, w = c e^-x, and functions of it, without what does not decay.
TEST(Tails, OfWhatIsLeftWhereConstantsCancelAreBounded) {
  const rational c(6, 10);
  const auto check = [](const char* formula, const rational& factor, const auto& f) {
    expect_bound(beyond_two(f), integral_beyond_two(formula), factor, formula);
  };
  const auto w = [&](const auto& x) { return c * exp(-x); };
  check("0.36*exp(-2*x)", rational(101, 100), [&](const auto& x) {
    const auto y = 1 + w(x);
    return y * y - 1 - 2 * w(x);
  });
  check("0.6*exp(-x)+0.36*exp(-2*x)", rational(21, 20),
        [&](const auto& x) { return (1 + w(x)) + (1 + w(x) * w(x)) - 2; });
  check("0.6*exp(-x)+0.36*exp(-2*x)", rational(21, 20),
        [&](const auto& x) { return (1 + w(x)) - (1 - w(x) * w(x)); });
  check("0.6*exp(-x)+0.36*exp(-2*x)", rational(21, 20),
        [&](const auto& x) { return ((1 + w(x)) + w(x) * w(x)) - 1; });
  // Where only a slope is known: its range is that over all w.
  check("0.36*exp(-2*x)/(1+0.6*exp(-x))", 16,
        [&](const auto& x) { return 1 / (1 + w(x)) - 1 + w(x); });
  check("(sqrt(1+0.6*exp(-x))-1)^2/2", 16,
        [&](const auto& x) { return sqrt(1 + w(x)) - 1 - w(x) / 2; });
  check("0.6*exp(-x)-log1p(0.6*exp(-x))", 16, [&](const auto& x) { return log(1 + w(x)) - w(x); });
  check("expm1(0.6*exp(-x))-0.6*exp(-x)", 16, [&](const auto& x) { return exp(w(x)) - 1 - w(x); });
  check("2*cos(0.5+0.3*exp(-x))*sin(0.3*exp(-x))", rational(13, 10), [&](const auto& x) {
    const auto half = x.constant_like(rational(1, 2));
    return sin(half + w(x)) - sin(half);
  });
  check("2*sin(1.5+0.3*exp(-x))*sin(0.3*exp(-x))", rational(13, 10), [&](const auto& x) {
    const auto more = x.constant_like(rational(3, 2));
    return cos(more + w(x)) - cos(more);
  });
  const auto tenth = [](const auto& x) { return x.constant_like(rational(1, 10)); };
  check("atan(0.6*exp(-x)/(1+(0.1+0.6*exp(-x))/10))", rational(13, 10),
        [&](const auto& x) { return atan(tenth(x) + w(x)) - atan(tenth(x)); });
  check("sinh(0.6*exp(-x))/(cosh(0.1)*cosh(0.1+0.6*exp(-x)))", rational(13, 10),
        [&](const auto& x) { return tanh(tenth(x) + w(x)) - tanh(tenth(x)); });
  check("2*asinh(0.3*exp(-x))-0.02*exp(-x)", rational(13, 10),
        [&](const auto& x) { return asinh(tenth(x) + w(x)) - asinh(tenth(x)); });
  check("1.1*0.6*exp(-x)", rational(13, 10),
        [&](const auto& x) { return erf(tenth(x) + w(x)) - erf(tenth(x)); });
}

/// Functions of what grows, without their limits.
TEST(Tails, OfDistancesFromALimitAreBounded) {
  const auto check = [](const char* formula, const rational& factor, const auto& f) {
    expect_bound(beyond_two(f), integral_beyond_two(formula), factor, formula);
  };
  check("2/(exp(2*x)+1)", rational(21, 20), [](const auto& x) { return 1 - tanh(x); });
  check("2/(exp(2*x)+1)", rational(21, 20), [](const auto& x) { return 1 + tanh(-x); });
  check("2/expm1(2*x)", rational(21, 20), [](const auto& x) { return 1 / tanh(x) - 1; });
  check("erfc(x)", rational(4, 3), [](const auto& x) { return 1 - erf(x); });
  check("erfc(x)", rational(4, 3), [](const auto& x) { return 2 - erfc(-x); });
  check("atan(exp(-x))", rational(11, 10), [](const auto& x) {
    return x.constant_like(known_number(pi_combination{0, rational(1, 2)})) - atan(exp(x));
  });
  check("log1p(exp(-2*x))", rational(21, 20), [](const auto& x) { return log(2 * cosh(x)) - x; });
  check("log1p(exp(-2*x))", rational(21, 20), [](const auto& x) { return log(2 * cosh(-x)) - x; });
  check("log((1+sqrt(1+exp(-2*x)))/2)", 8,
        [](const auto& x) { return asinh(exp(x)) - x - log(x.constant_like(2)); });
  check("-log((1+sqrt(1-exp(-2*x)))/2)", 8,
        [](const auto& x) { return acosh(exp(x)) - x - log(x.constant_like(2)); });
  // A constant that is left, be it small, has no tail.
  EXPECT_TRUE(beyond_two([](const auto& x) {
                return rational(1'000'001, 1'000'000) - tanh(x);
              }).is_infinite());
  EXPECT_TRUE(beyond_two([](const auto& x) {
                return log(2 * cosh(x)) - x * rational(1'000'001, 1'000'000);
              }).is_infinite());
}

/// Of what is bounded, and no series: erf is then between 0 and 1, or -1 and 0, and erfc below 2.
TEST(Tails, OfBoundedErrorFunctionsAreBounded) {
  const ball tail = exp(ball(-2, p));
  const rational factor(101, 100);
  expect_bound(beyond_two([](const auto& x) { return exp(-x) * erf(4 + sin(x)); }),
               tail * rational(999, 1000), factor, "exp(-x) erf(4 + sin(x))");
  expect_bound(beyond_two([](const auto& x) { return exp(-x) * erf(-4 - sin(x)); }),
               tail * rational(999, 1000), factor, "exp(-x) erf(-4 - sin(x))");
  expect_bound(beyond_two([](const auto& x) { return exp(-x) * erfc(-4 - sin(x)); }),
               tail * rational(1999, 1000), factor, "exp(-x) erfc(-4 - sin(x))");
}

/// cos v beside 1, and means: 1/agm(x, y) is at most 1/sqrt(x y), which is attained for x = y, and
/// grows as a logarithm where x/y does.
TEST(Tails, OfCosinesAndMeansAreBounded) {
  const auto check = [](const char* formula, const rational& factor, const auto& f) {
    expect_bound(beyond_two(f), integral_beyond_two(formula), factor, formula);
  };
  check("2*sin(exp(-x)/2)^2", rational(101, 100), [](const auto& x) { return 1 - cos(exp(-x)); });
  check("cos(3*exp(-x))-1+4.5*exp(-2*x)", 12, [](const auto& x) {
    const auto v = 3 * exp(-x);
    return cos(v) - 1 + v * v / 2;
  });
  check("exp(-x)/sqrt(3)", rational(101, 100),
        [](const auto& x) { return exp(-x) / agm(x * 0 + 3, x * 0 + 1); });
  check("exp(-x)/agm(1,exp(-x/2))", 3,
        [](const auto& x) { return exp(-x) / agm(x * 0 + 1, exp(-x / 2)); });
  check("exp(-x)/agm(3,2*exp(-2*x))", 3,
        [](const auto& x) { return exp(-x) / agm(x * 0 + 3, 2 * exp(-2 * x)); });
  check("exp(-x)/agm(exp(-9*x),1)", 3,
        [](const auto& x) { return exp(-x) / agm(exp(-9 * x), x * 0 + 1); });
  check("exp(-20*x)/agm(1,exp(-x))", rational(19, 10),
        [](const auto& x) { return exp(-20 * x) / agm(x * 0 + 1, exp(-x)); });
  check("exp(-2*x)*agm(exp(x),1)", 4,
        [](const auto& x) { return exp(-2 * x) * agm(exp(x), x * 0 + 1); });
  check("exp(-x/2)", rational(101, 100),
        [](const auto& x) { return exp(-x) / agm(exp(-x / 2), exp(-x / 2)); });
  EXPECT_TRUE(beyond_two([](const auto& x) { return agm(exp(-x), exp(-x)); }).is_infinite());
  EXPECT_TRUE(
      beyond_two([](const auto& x) { return exp(-x) / agm(exp(-x), -exp(-x)); }).is_infinite());
}

/// The bound of e^phi by phi^2 is nearly attained at phi = 2.
TEST(Tails, OfSteeperDoubleExponentialsAreBounded) {
  const ball z = 20 * exp(ball(2, p));
  expect_bound(beyond_two([](const auto& x) { return exp(-20 * exp(x)); }), exp(-z) / (z + 1),
               rational(105, 100), "exp(-20 exp(x))");
  const tail_series far = tail_series::argument(known_number(rational(1)), 0x1p-8);
  EXPECT_FALSE((exp(-cosh(2 * far)) * cosh(9 * far)).integral_beyond(ball(512, 64)).is_infinite());
}

// Beyond 2, for x >= 2: e^-floor(x) is at most e^(1 - x), and its integral e^-2 e/(e - 1).
TEST(Tails, OfStepsAreBounded) {
  const ball e = exp(ball(1, p));
  const ball steps = exp(ball(-1, p)) / (e - 1);
  expect_bound(beyond_two([](const auto& x) { return exp(-floor(x)); }), steps, 4, "exp(-floor x)");
  // The sum over k >= 2 of e^(k + 1) times the integral of e^(-2 x) from k to k + 1.
  expect_bound(beyond_two([](const auto& x) { return exp(ceil(x)) * exp(-2 * x); }),
               steps * (e - 1 / e) / 2, 4, "exp(ceil x - 2x)");
  expect_bound(beyond_two([](const auto& x) { return floor(x) * exp(-x); }),
               exp(ball(-1, p)) * (2 * e - 1) / (e * (e - 1)), 3, "floor(x) exp(-x)");
}

TEST(Tails, OfLogarithmsAndPowersAreBounded) {
  const rational little(101, 100);
  check_tail(
      "log x", [](const auto& x) { return log(x); }, end_point(0), end_point(1), false,
      [](const ball& x) { return x * (1 - log(x)); }, little);
  check_tail(
      "log(x)^2", [](const auto& x) { return log(x) * log(x); }, end_point(0), end_point(1), false,
      [](const ball& x) { return x * (square(log(x)) - 2 * log(x) + 2); }, little);
  check_tail(
      "log(x)/sqrt x", [](const auto& x) { return log(x) / sqrt(x); }, end_point(0), end_point(1),
      false, [](const ball& x) { return 2 * sqrt(x) * (2 - log(x)); }, little);
}

// sin(x - 2)/x^(1/10) from 2 on is the integral of Re (2 + it)^(-1/10) e^(-t) over t > 0.
TEST(Tails, OfOscillationsAreBounded) {
  const auto f = [](const auto& x) { return sin(x - 2) / pow(x, rational(1, 10)); };
  const auto found =
      detail::oscillations_at(integrand_of(formula_of(f)), end_point(0), end_point(1), true, 1, 0);
  ASSERT_TRUE(found && found->segments.size() == 1);
  ASSERT_EQ(found->start, 2);
  const auto along = [](const auto& t) {
    return pow(4 + t * t, rational(-1, 20)) * cos(atan(t / 2) / 10) * exp(-t);
  };
  const rational length = upper_rational(found->segments.front().scale(64));
  const integral rest = integrate(along, end_point(length), end_point::infinity(), {.digits = 10});
  ASSERT_EQ(rest.verdict, status::certified);
  expect_bound(found->rest, rest.enclosure, rational(19, 10), "sin(x - 2)/x^(1/10)");
}

// What is beyond the line's end belongs to the integral's remainder.
TEST(Tails, OfOscillationsAreAdded) {
  const auto f = [](const auto& x) { return sin(x - 2) / pow(x, rational(1, 10)); };
  const auto prepared =
      detail::prepare(integrand_of(formula_of(f)), end_point(1), end_point::infinity(), {}, 1);
  ASSERT_TRUE(prepared.why == reason::none && prepared.has_tail);
  // e^-t over the line, of a length below 200.
  EXPECT_TRUE(exp(ball(-200, p)).magnitude_upper() <= prepared.remainder.magnitude_upper());
}

// e^(x (sin x - 2)) is between e^(-3x) and e^(-x), and above e^(-2.4) from 2 to 2.1.
TEST(Tails, OfExponentialsOfWavesAreBounded) {
  const ball part = exp(ball(rational(-24, 10), p)) / 10;
  for (const magnitude& bound :
       {beyond_two([](const auto& x) { return exp(x * (sin(x) - 2)); }),
        beyond_two([](const auto& x) { return exp(-x * (2 - sin(x))); })}) {
    EXPECT_TRUE(part.magnitude_lower() <= bound);
    EXPECT_TRUE(bound <= (exp(ball(-2, p)) * rational(101, 100)).magnitude_upper());
  }
}

// With (log x)^2 the amplitude is greater far from the axis than where the line begins.
TEST(Tails, OfOscillationsWithLogarithmsAreBounded) {
  const auto f = [](const auto& x) {
    return sin(x - 3) * log(x) * log(x) / pow(x, rational(1, 10));
  };
  const auto found =
      detail::oscillations_at(integrand_of(formula_of(f)), end_point(0), end_point(1), true, 1, 0);
  ASSERT_TRUE(found && found->segments.size() == 1);
  ASSERT_EQ(found->start, 2);
  // Re e^(-i) (log z)^2 z^(-1/10) e^(-t), z = 2 + it.
  const auto along = [](const auto& t) {
    const auto a = log(4 + t * t) / 2;
    const auto b = atan(t / 2);
    const auto turn = 1 + b / 10;
    return ((a * a - b * b) * cos(turn) + 2 * a * b * sin(turn)) *
           pow(4 + t * t, rational(-1, 20)) * exp(-t);
  };
  const rational length = upper_rational(found->segments.front().scale(64));
  const integral rest = integrate(along, end_point(length), end_point::infinity(), {.digits = 10});
  ASSERT_EQ(rest.verdict, status::certified);
  EXPECT_TRUE(rest.enclosure.magnitude_lower() <= found->rest);
}

}  // namespace tails_test
}  // namespace polhode
