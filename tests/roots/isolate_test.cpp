// All roots of one function: none lost, none claimed twice, none called simple that is not.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/zero_free_ends.hpp"
#include "polhode/roots/isolate.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace isolate_test {

using support::agrees;
using support::random_source;
using support::repeat;

std::vector<long> multiplicities(const root_set& s) {
  std::vector<long> r;
  for (const root_region& region : s.regions) r.push_back(region.multiplicity);
  return r;
}

/// Every region is proved, in ascending order and apart from the others.
void expect_resolved(const root_set& s, std::size_t count) {
  EXPECT_TRUE(s.is_resolved());
  EXPECT_EQ(s.regions.size(), count);
  for (std::size_t i = 0; i + 1 < s.regions.size(); ++i) {
    EXPECT_TRUE(certainly_less(s.regions[i].enclosure, s.regions[i + 1].enclosure)) << i;
  }
  for (const root_region& r : s.regions) EXPECT_TRUE(contains(r.box, r.enclosure));
}

/// A polynomial as a generic function whose type tells nothing of polynomials: e^x p(x).
struct disguised {
  std::vector<rational> coefficients;
  template <class T>
  auto operator()(const T& x) const {
    T value = x * 0 + coefficients.back();
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) value = value * x + coefficients[k];
    return exp(x) * value;
  }
};

rational_polynomial with_roots(const std::vector<std::pair<rational, long>>& roots) {
  rational_polynomial p({rational(1)});
  for (const auto& [r, m] : roots) {
    for (long k = 0; k < m; ++k) p = p * rational_polynomial({rational(-r), rational(1)});
  }
  return p;
}

// ---------------------------------------------------------------------------------------------
// Sets with known roots

TEST(IsolateRoots, Wilkinson) {
  std::vector<std::pair<rational, long>> roots;
  for (long k = 1; k <= 20; ++k) roots.emplace_back(k, 1);
  const root_set s = isolate_roots(real_function::of(with_roots(roots)), -end_point::infinity(),
                                   end_point::infinity());
  expect_resolved(s, 20);
  for (long k = 1; k <= 20; ++k) {
    const refined_root r = refine(s.regions[static_cast<std::size_t>(k - 1)], 100);
    EXPECT_EQ(r.verdict, status::certified);
    ASSERT_TRUE(r.exact.has_value());
    EXPECT_EQ(*r.exact, k);
  }
  // Wilkinson's change of one coefficient by 2^-23: ten real roots are left, the others are
  // complex.
  rational_polynomial p = with_roots(roots);
  std::vector<rational> c = p.coefficients();
  c[19] -= rational(1, 1L << 23);
  const rational_polynomial changed(c);
  const root_set t = isolate_roots(real_function::of(changed), 0, 30);
  expect_resolved(t, static_cast<std::size_t>(count_real_roots(changed, 0, 30)));
  EXPECT_EQ(t.regions.size(), 10U);
  // The first digits are Wilkinson's (Rounding Errors in Algebraic Processes, 1963): 8.91725 and
  // 20.84691.
  EXPECT_EQ(to_decimal(refine(t.regions[7], 20).enclosure, 7), "8.007267...");
  EXPECT_EQ(to_decimal(refine(t.regions[8], 20).enclosure, 6), "8.91725...");
  EXPECT_EQ(to_decimal(refine(t.regions[9], 20).enclosure, 7), "20.84690...");
}

TEST(IsolateRoots, OneTwoAndThreeWithTheirMultiplicities) {
  const auto f = [](const auto& x) {
    return (x - 1) * pow(square(x) - 2, 3) * pow(pow(x, 3) - 2, 4);
  };
  const root_set s = isolate_roots(f, -3, 3);
  expect_resolved(s, 4);
  EXPECT_EQ(multiplicities(s), (std::vector<long>{3, 1, 4, 3}));
  EXPECT_TRUE(agrees(refine(s.regions[2], 60).enclosure,  // the cube root of 2; mpmath 1.3.0
                     "1.25992104989487316476721060727822835057025146470150798008198", 50));
  // The same, not a polynomial for the eye: by its factors.
  const auto g = [&](const auto& x) { return exp(x) * f(x); };
  const root_set t = isolate_roots(g, -3, 3);
  expect_resolved(t, 4);
  EXPECT_EQ(multiplicities(t), (std::vector<long>{3, 1, 4, 3}));
  const refined_root r = refine(t.regions[2], 200);
  EXPECT_EQ(r.verdict, status::certified);
  EXPECT_TRUE(contains(pow(r.enclosure, 3), 2L));
}

TEST(IsolateRoots, DoubleRootOfATranscendentalFunction) {
  const root_set s = isolate_roots([](const auto& x) { return exp(x) - x - 1; }, -1, 1);
  expect_resolved(s, 1);
  EXPECT_EQ(s.regions[0].verdict, root_verdict::multiple);
  EXPECT_EQ(s.regions[0].multiplicity, 2);
  EXPECT_EQ(s.regions[0].exact, rational(0));
  const root_set t = isolate_roots([](const auto& x) { return sin(x) - x; }, -1, 2);
  expect_resolved(t, 1);
  EXPECT_EQ(t.regions[0].multiplicity, 3);
}

TEST(IsolateRoots, UnprovableMultipleRootsAreLeftOpenAndCounted) {
  // The square of x - cos(x): nothing here can tell that it touches 0.
  const auto squared = [](const auto& x) { return x * x - 2 * x * cos(x) + square(cos(x)); };
  const root_set s = isolate_roots(squared, 0, 1);
  EXPECT_FALSE(s.is_resolved());
  EXPECT_TRUE(s.complete);
  ASSERT_EQ(s.regions.size(), 1U);
  EXPECT_EQ(s.regions[0].verdict, root_verdict::unresolved);
  EXPECT_EQ(s.regions[0].complex_roots, 2);
  const root_set simple = isolate_roots([](const auto& x) { return x - cos(x); }, 0, 1);
  ASSERT_EQ(simple.regions.size(), 1U);
  EXPECT_TRUE(overlaps(s.regions[0].enclosure, refine(simple.regions[0], 80).enclosure));
  EXPECT_TRUE(s.regions[0].enclosure.radius() < magnitude::power_of_two(-150));
  EXPECT_EQ(refine(s.regions[0], 30).verdict, status::not_certified);
  // Three times, so that the sign changes.
  const auto cubed = [](const auto& x) {
    return x * x * x - 3 * x * x * cos(x) + 3 * x * square(cos(x)) - pow(cos(x), 3);
  };
  const root_set u = isolate_roots(cubed, 0, 1);
  ASSERT_EQ(u.regions.size(), 1U);
  EXPECT_EQ(u.regions[0].verdict, root_verdict::at_least_one);
  EXPECT_EQ(u.regions[0].complex_roots, 3);
}

/// Not to be taken for polynomials in one part: (sin(x) - 2 cos(x))^2, and (u - 2)^2 (1 + 8/u) with
/// u = e^x, which would be (u + 2)^2 with 1 for 1/u.
TEST(IsolateRoots, MultipleRootsOfOtherFormulasAreLeftOpen) {
  for (const char* formula : {"sin(x)^2-4*sin(x)*cos(x)+4*cos(x)^2", "x^2-2*x*cos(x)+cos(x)^2"}) {
    const root_set s = isolate_roots(parse(formula), 0, 2);
    ASSERT_EQ(s.regions.size(), 1U) << formula;
    EXPECT_EQ(s.regions[0].complex_roots, 2) << formula;
  }
}

/// Polynomials in an exponential, or in another function, with multiple factors.
TEST(IsolateRoots, MultipleRootsOfPolynomialsInAFunction) {
  struct row {
    const char* formula;
    std::vector<std::pair<const char*, long>> roots;  // with their multiplicities, in -4..6
  };
  for (const row& r : std::vector<row>{
           {"exp(2*x)-4*exp(x)+4", {{"log(2)", 2}}},
           {"exp(2*x)+4*exp(x)-28+32*exp(-x)", {{"log(2)", 2}}},
           {"exp(3*x)-6*exp(2*x)+12*exp(x)-8", {{"log(2)", 3}}},
           {"exp(4*x/3)-6*exp(2*x/3)+9", {{"3*log(3)/2", 2}}},
           {"2*exp(-x*3)*(9-6*exp(x)+exp(2*x))", {{"log(3)", 2}}},
           {"x*(exp(2*x)-4*exp(x)+4)", {{"0", 1}, {"log(2)", 2}}},
           {"-log(x)^3+3*log(x)^2-3*log(x)+1", {{"e", 3}}},
           {"4*sin(x)^2-4*sin(x)+1", {{"-7*pi/6", 2}, {"pi/6", 2}, {"5*pi/6", 2}}},
           {"(exp(2*x)-4*exp(x)+4)*(exp(x)-2)", {{"log(2)", 3}}},
           // Of two functions, and with a power that is no polynomial.
           {"sin(x)^2-2*cos(x)+1",
            {{"-acos(sqrt(3)-1)", 1}, {"acos(sqrt(3)-1)", 1}, {"2*pi-acos(sqrt(3)-1)", 1}}},
           {"exp(2*x)-2*exp(x)+exp(-x)", {{"0", 1}, {"log((1+sqrt(5))/2)", 1}}},
           // The same but for a little: two roots, and none.
           {"exp(2*x)-4*exp(x)+4-1e-20", {{"log(2-1e-10)", 1}, {"log(2+1e-10)", 1}}},
           {"exp(2*x)-4*exp(x)+4+1e-20", {}}}) {
    const root_set s = isolate_roots(parse(r.formula), -4, 6);
    EXPECT_TRUE(s.is_resolved()) << r.formula;
    ASSERT_EQ(s.regions.size(), r.roots.size()) << r.formula;
    for (std::size_t i = 0; i < r.roots.size(); ++i) {
      EXPECT_EQ(s.regions[i].multiplicity, r.roots[i].second) << r.formula;
      EXPECT_TRUE(
          overlaps(refine(s.regions[i], 40).enclosure, parse(r.roots[i].first, {}).value(300)))
          << r.formula;
    }
  }
}

TEST(IsolateRoots, MultipleRootsAtMultiplesOfPi) {
  const auto expect_at = [](const root_set& s, long turns, long multiplicity) {
    SCOPED_TRACE(turns);
    expect_resolved(s, 1);
    EXPECT_EQ(s.regions[0].multiplicity, multiplicity);
    const refined_root r = refine(s.regions[0], 60);
    EXPECT_EQ(r.verdict, status::certified);
    EXPECT_FALSE(r.exact);
    EXPECT_TRUE(overlaps(r.enclosure, turns * pi(400)));
    EXPECT_TRUE(r.enclosure.radius() < magnitude::power_of_two(-190));
  };
  expect_at(isolate_roots([](const auto& x) { return 1 - cos(x); }, 1, 10), 2, 2);
  expect_at(isolate_roots([](const auto& x) { return 1 + cos(x); }, -4, -1), -1, 2);
  expect_at(isolate_roots([](const auto& x) { return (1 - cos(x)) * sin(x); }, 6, 7), 2, 3);
  expect_at(isolate_roots([](const auto& x) { return tan(x) - sin(x); }, 6, 7), 2, 3);
  // A kink there: isolated, to as many digits.
  const root_set kinks = isolate_roots([](const auto& x) { return abs(sin(x)); }, 1, 10);
  expect_resolved(kinks, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(kinks.regions[k].verdict, root_verdict::isolated);
    const refined_root r = refine(kinks.regions[k], 60);
    EXPECT_EQ(r.verdict, status::certified);
    EXPECT_TRUE(overlaps(r.enclosure, static_cast<long>(k + 1) * pi(400)));
  }
  // Twins: two roots beside 2 pi, and none.
  expect_resolved(
      isolate_roots([](const auto& x) { return 1 - cos(x) - rational(1, 1000000); }, 6, 7), 2);
  expect_resolved(
      isolate_roots([](const auto& x) { return 1 - cos(x) + rational(1, 1000000); }, 6, 7), 0);
  // Beside 4 pi, at a distance of 1e-20.
  const rational near(parse_rational("6.28318530717958647692"));
  expect_resolved(isolate_roots([near](const auto& x) { return 1 - cos(x - 2 * near); }, 12, 13),
                  1);
}

TEST(IsolateRoots, PolesAreNoRoots) {
  const root_set s = isolate_roots([](const auto& x) { return 1 / x; }, -1, 1);
  expect_resolved(s, 0);
  ASSERT_EQ(s.singular.size(), 1U);
  EXPECT_EQ(s.singular[0].pole_order, 1);
  EXPECT_TRUE(contains(s.singular[0].place, 0L));

  const root_set t = isolate_roots([](const auto& x) { return tan(x); }, -10, 10);
  expect_resolved(t, 7);
  EXPECT_EQ(t.singular.size(), 6U);
  for (const singular_place& p : t.singular) {
    EXPECT_EQ(p.pole_order, 1);
    EXPECT_TRUE(contains_zero(cos(p.place)));
  }
  // Defined nowhere at 0, though it could be continued there.
  for (const root_set& v : {isolate_roots([](const auto& x) { return 1 / (1 / x); }, -1, 1),
                            isolate_roots([](const auto& x) { return pow(1 / x, -2); }, -1, 1),
                            isolate_roots([](const auto& x) { return x * x / x; }, -1, 1)}) {
    expect_resolved(v, 0);
    ASSERT_EQ(v.singular.size(), 1U);
    EXPECT_EQ(v.singular[0].pole_order, 0);
    EXPECT_TRUE(contains(v.singular[0].place, 0L));
  }
  // Poles and roots side by side, and of a higher order.
  const auto f = [](const auto& x) {
    return 1 / square(x - rational(1, 3)) - rational(1, 100) / x;
  };
  const root_set u = isolate_roots(f, -1, 1);
  expect_resolved(u, 1);
  EXPECT_EQ(u.singular.size(), 2U);
}

TEST(IsolateRoots, UpToInfinityByGrowth) {
  const end_point infinity = end_point::infinity();
  struct expected {
    const char* text;
    end_point lower;
    std::size_t roots;
  };
  for (const auto& [text, lower, roots] :
       std::vector<expected>{{"x*exp(-x)-1/10", -infinity, 2},
                             {"x^2*exp(-x)-1", -infinity, 1},
                             {"1/x-exp(-x)", -infinity, 0},
                             {"sqrt(x)-log(x)-1", -infinity, 2},
                             {"x-log(x)-5", -infinity, 2},
                             {"sqrt(x^2+1)-x-1/3", -infinity, 1},
                             {"cbrt(x)-log(1+x^2)", -infinity, 3},
                             {"log(x^2+1)-sqrt(abs(x))", -infinity, 5},
                             {"atan(x)-3/2", -infinity, 1},
                             // Roots far out, beyond which only growth tells the sign.
                             {"sqrt(x)-10^20*log(x)", -infinity, 2},
                             {"x*exp(-x/10^6)-10", -infinity, 2},
                             {"(log(x)-60)*sqrt(x)+1", 1, 1},
                             {"x^pi-10^30*x^3", 1, 1}}) {
    const root_set s = isolate_roots(real_function(parse(text)), lower, infinity);
    EXPECT_TRUE(s.is_resolved()) << text;
    EXPECT_EQ(s.regions.size(), roots) << text;
  }
}

TEST(IsolateRoots, UpToInfinityByLogarithms) {
  const end_point infinity = end_point::infinity();
  struct expected {
    const char* text;
    end_point lower;
    end_point upper;
    std::size_t roots;
  };
  for (const auto& [text, lower, upper, roots] :
       std::vector<expected>{{"log(x)^2-log(x)-2", 0, infinity, 2},
                             {"log(x)^3-5*log(x)+1", 0, infinity, 3},
                             {"log(x)^2-60*log(x)+1", rational(1, 2), infinity, 2},
                             {"log(x)^2-700*log(x)+log(3)", 2, infinity, 1},
                             {"log(-x)^2-60*log(-x)+1", -infinity, -1, 2},
                             {"sqrt(log(x))-log(x)/7", 2, infinity, 1},
                             {"log(x)^2-2*log(x)+2", 0, infinity, 0}}) {
    const root_set s = isolate_roots(real_function(parse(text)), lower, upper);
    EXPECT_TRUE(s.is_resolved()) << text;
    EXPECT_EQ(s.regions.size(), roots) << text;
  }
}

TEST(IsolateRoots, TellsWhereAFunctionEndsFarOut) {
  const root_set s =
      isolate_roots(real_function(parse("sqrt(1000-x)-1")), 0, end_point::infinity());
  EXPECT_TRUE(s.is_resolved());
  ASSERT_EQ(s.regions.size(), 1U);
  ASSERT_FALSE(s.singular.empty());
  EXPECT_FALSE(s.singular.back().place.is_bounded());
}

/// On [0, 1] the slope is nearly constant, and Newton's image is beyond, where both roots are.
TEST(IsolateRoots, TwoRootsBesideABoxInWhichTheSlopeShowsOne) {
  const auto f = [](const auto& x) { return rational(21, 20) - x + exp(30 * x - 36); };
  expect_resolved(isolate_roots(f, 0, 2), 2);
  expect_resolved(isolate_roots(f, 0, 1), 0);
}

TEST(IsolateRoots, ManyRootsTowardsAPoint) {
  // 1/(k pi) for k = 1 ... 318.
  const root_set s = isolate_roots([](const auto& x) { return sin(1 / x); }, rational(1, 1000), 1);
  expect_resolved(s, 318);
  for (std::size_t i = 0; i < s.regions.size(); ++i) {
    const auto k = 318 - static_cast<long>(i);
    EXPECT_TRUE(overlaps(s.regions[i].enclosure, 1 / (k * pi(128)))) << k;
  }
}

TEST(IsolateRoots, TouchingByAHairAndMissingByOne) {
  const rational hair = parse_rational("1e-40");
  for (const rational& at : {rational(1, 3), rational(1, 2), rational(0)}) {
    for (const bool transcendental : {false, true}) {
      const auto shifted = [&](const rational& by) {
        return [=](const auto& x) {
          auto y = square(x - at) + by;
          return transcendental ? y * exp(x) + (sin(x) - sin(x)) * 0 : y;
        };
      };
      const root_set below = isolate_roots(shifted(-hair), -1, 1);
      expect_resolved(below, 2);
      for (const root_region& r : below.regions) EXPECT_EQ(r.verdict, root_verdict::unique);
      expect_resolved(isolate_roots(shifted(hair), -1, 1), 0);
      const root_set touching = isolate_roots(shifted(0), -1, 1);
      expect_resolved(touching, 1);
      EXPECT_EQ(touching.regions[0].multiplicity, 2);
    }
  }
}

TEST(IsolateRoots, PowersOfX) {
  const root_set s = isolate_roots([](const auto& x) { return pow(x, 20); }, -1, 1);
  expect_resolved(s, 1);
  EXPECT_EQ(s.regions[0].multiplicity, 20);
  const root_set t = isolate_roots([](const auto& x) { return sin(pow(x, 20)); }, -1, 1);
  expect_resolved(t, 1);
  EXPECT_EQ(t.regions[0].multiplicity, 20);
}

TEST(IsolateRoots, AtEndPoints) {
  const auto f = [](const auto& x) { return (x - rational(1, 3)) * (x - 2); };
  const auto g = [&](const auto& x) { return f(x) * exp(x); };
  for (const root_set& s :
       {isolate_roots(f, rational(1, 3), 2), isolate_roots(g, rational(1, 3), 2)}) {
    expect_resolved(s, 2);
    EXPECT_EQ(refine(s.regions[0], 30).exact, rational(1, 3));
    EXPECT_EQ(refine(s.regions[1], 30).exact, rational(2));
  }
  // Just outside.
  const rational little(1, 1L << 50);
  expect_resolved(isolate_roots(g, rational(1, 3) + little, 2 - little), 0);
  expect_resolved(isolate_roots(g, rational(1, 3) - little, 2 + little), 2);
  // A point.
  expect_resolved(isolate_roots(g, 2, 2), 1);
  expect_resolved(isolate_roots(g, 1, 1), 0);
  // An end that is no rational number, and a root there: it is not decided on which side.
  const end_point at_pi([](precision p) { return pi(p); });
  const root_set s = isolate_roots([](const auto& x) { return sin(x); }, 1, at_pi);
  ASSERT_EQ(s.regions.size(), 1U);
  EXPECT_EQ(s.regions[0].verdict, root_verdict::unique);
  EXPECT_TRUE(s.regions[0].may_lie_outside);
  EXPECT_FALSE(s.is_resolved());
}

// An end q + r pi is known exactly, and so is whether f is 0 there.
TEST(IsolateRoots, AtEndsThatAreMultiplesOfPi) {
  const auto at = [](const rational& q, const rational& r) {
    return end_point(pi_combination{q, r});
  };
  const auto sine = [](const auto& x) { return sin(x); };
  expect_resolved(isolate_roots(sine, 1, at(0, 1)), 1);
  expect_resolved(isolate_roots(sine, at(0, -2), at(0, 2)), 5);
  EXPECT_EQ(multiplicities(
                isolate_roots([](const auto& x) { return exp(x) * square(sin(x)); }, 1, at(0, 1))),
            (std::vector<long>{2}));
  expect_resolved(isolate_roots([](const auto& x) { return 1 + cos(2 * x) * exp(cos(x)); }, 1,
                                at(0, rational(1, 2))),
                  2);
  expect_resolved(isolate_roots([](const auto& x) { return tan(x - 1) * x; }, 2, at(1, 1)), 1);
  // Just beside.
  const rational little(1, integer(1) << 100);
  expect_resolved(isolate_roots(sine, 1, at(-little, 1)), 0);
  expect_resolved(isolate_roots(sine, at(little, 1), at(-little, 2)), 0);
  expect_resolved(isolate_roots(sine, at(-little, 1), at(little, 2)), 2);
  // A root beside an end that is none: further off than any enclosure that was tried may be wide.
  const rational less(1, integer(1) << 3000);
  const root_set s = isolate_roots([&](const auto& x) { return sin(x + less); }, 1, at(0, 1));
  ASSERT_EQ(s.regions.size(), 1U);
  EXPECT_TRUE(s.regions[0].may_lie_outside);
  // No root at all.
  expect_resolved(isolate_roots([](const auto& x) { return cos(x); }, at(0, 1), at(0, 1)), 0);
}

TEST(IsolateRoots, AtBisectionPointsOnce) {
  // Every dyadic number with denominator 8 in [0, 8] is a root and a point where boxes are cut.
  const auto f = [](const auto& x) { return sin(x * 8 * pi(256)); };
  const root_set s = isolate_roots(f, 0, 8);
  EXPECT_EQ(s.regions.size(), 65U);
  for (std::size_t k = 0; k < s.regions.size(); ++k) {
    EXPECT_EQ(s.regions[k].verdict, root_verdict::unique);
    EXPECT_TRUE(contains(s.regions[k].enclosure, rational(static_cast<long>(k), 8))) << k;
  }
}

TEST(IsolateRoots, TowardsInfinity) {
  const end_point infinity = end_point::infinity();
  const end_point minus_infinity = -end_point::infinity();
  expect_resolved(
      isolate_roots([](const auto& x) { return square(x) - exp(x); }, minus_infinity, infinity), 1);
  expect_resolved(
      isolate_roots([](const auto& x) { return exp(-x) * (x - 1); }, minus_infinity, infinity), 1);
  expect_resolved(
      isolate_roots([](const auto& x) { return atan(x) - 1; }, minus_infinity, infinity), 1);
  expect_resolved(isolate_roots([](const auto& x) { return log(x) - 100; }, 1, infinity), 1);
  // It has a root beyond every bound.
  const root_set s =
      isolate_roots([](const auto& x) { return sin(x * x); }, 1, infinity, {.most_boxes = 500});
  EXPECT_TRUE(s.is_resolved());
  EXPECT_EQ(s.regions.back().verdict, root_verdict::infinitely_many);
  EXPECT_FALSE(s.regions.back().box.is_bounded());
  // A limit of 0 from above is no root.
  expect_resolved(isolate_roots([](const auto& x) { return 1 / (1 + exp(x)); }, 0, infinity), 0);
  for (const char* f : {"airyAi(x)", "besselK(0,x)", "besselK(5/2,x)", "1/gamma(x)", "gamma(x)",
                        "airyAi(x)*besselK(1,x)", "besselK(0,x)-exp(-2*x)"}) {
    expect_resolved(isolate_roots(parse(f), 1, infinity), 0);
  }
}

// Towards an end with infinitely many roots the nearest ones are found, and the rest is left.
TEST(IsolateRoots, EndAfterManyRootsTowardsInfinity) {
  const end_point infinity = end_point::infinity();
  const auto expect_rest = [](const root_region& rest) {
    const bool is_proved = rest.verdict == root_verdict::infinitely_many;
    EXPECT_TRUE(is_proved || rest.verdict == root_verdict::unresolved);
    EXPECT_NE(rest.remark.find(is_proved ? "proved" : "infinitely many"), std::string::npos)
        << rest.remark;
  };
  const auto expect_nearest = [&](const root_set& s, bool rightward, std::size_t most) {
    ASSERT_GE(s.regions.size(), 41U);
    ASSERT_LE(s.regions.size(), most);
    const root_region& rest = rightward ? s.regions.back() : s.regions.front();
    EXPECT_EQ(s.complete, rest.verdict == root_verdict::infinitely_many);
    EXPECT_FALSE(rest.box.is_bounded());
    expect_rest(rest);
    for (std::size_t k = 1; k < s.regions.size(); ++k) {
      const root_region& root = s.regions[rightward ? k - 1 : k];
      EXPECT_EQ(root.verdict, root_verdict::unique);
      EXPECT_FALSE(overlaps(root.enclosure, rest.box));
    }
  };
  const isolate_options few{.most_towards_end = 40};
  for (const char* f : {"sin(x)/x", "x*sin(x)-1", "besselJ(0,x)", "sin(x^2)", "cos(exp(x))",
                        "sin(log(x))", "airyAi(-x)"}) {
    SCOPED_TRACE(f);
    expect_nearest(isolate_roots(parse(f), 2, infinity, few), true, 41);
    isolate_options threads = few;
    threads.threads = 2;
    EXPECT_EQ(isolate_roots(parse(f), 2, infinity, threads).regions.size(), 41U);
  }
  for (const char* f : {"sin(x)/x", "airyAi(x)", "besselJ(1,x)"}) {
    SCOPED_TRACE(f);
    expect_nearest(isolate_roots(parse(f), -infinity, -2, few), false, 100);
  }
  // Towards an end at which it is not defined.
  for (const auto& [f, lower, upper] :
       std::vector<std::tuple<const char*, long, long>>{{"sin(1/x)", 0, 1},
                                                        {"x*sin(1/x)", 0, 1},
                                                        {"sin(1/x)-x", 0, 1},
                                                        {"cos(1/x^2)", 0, 2},
                                                        {"sin(1/(x-1))", 0, 1},
                                                        {"besselJ(0,1/x)", 0, 1},
                                                        {"sin(1/x)", -1, 0}}) {
    SCOPED_TRACE(f);
    const root_set s = isolate_roots(parse(f), lower, upper, few);
    ASSERT_GE(s.regions.size(), 40U);
    const bool is_lower = lower == 0 && std::string(f) != "sin(1/(x-1))";
    const root_region& rest = is_lower ? s.regions.front() : s.regions.back();
    expect_rest(rest);
    EXPECT_EQ(s.complete, rest.verdict == root_verdict::infinitely_many);
    EXPECT_EQ(std::ranges::count_if(s.regions,
                                    [](const root_region& r) { return !is_one_root(r.verdict); }),
              1);
  }
  const root_set slow = isolate_roots(parse("sin(log(x))"), 0, 1, few);
  EXPECT_TRUE(slow.complete);
  EXPECT_GE(slow.regions.size(), 41U);
  // Where it is proved that there are none from some point on, all are found.
  expect_resolved(isolate_roots(parse("sin(x)-x/1000"), -infinity, infinity, few), 635);
  // Many elsewhere, and none of them more often towards the singular end.
  expect_resolved(isolate_roots(parse("besselY(0,x)*sin(50*x)"), 0, 10, few), 162);
}

TEST(IsolateRoots, OneSummandOutgrowsTheOthers) {
  const end_point infinity = end_point::infinity();
  expect_resolved(isolate_roots(parse("gamma(x)-x^2"), 1, infinity), 2);
  expect_resolved(isolate_roots(parse("gamma(x)-100*x^5-7"), 1, infinity), 1);
  expect_resolved(isolate_roots(parse("x^x-x^2-1"), 1, infinity), 1);
  expect_resolved(isolate_roots(parse("exp(x^2)-x^5-7"), 0, infinity), 1);
  expect_resolved(isolate_roots(parse("(x-200)*gamma(x)+(x-200)*x"), 1, infinity), 1);
}

TEST(IsolateRoots, ARootThatIsAllOfItsEnclosureIsExact) {
  const root_set s = isolate_roots(parse("erf(x)-x"), -1, 1);
  expect_resolved(s, 3);
  const refined_root zero = refine(s.regions[1], 20);
  ASSERT_TRUE(zero.exact);
  EXPECT_EQ(*zero.exact, rational(0));
}

TEST(IsolateRoots, TowardsASingularPointInside) {
  // The roots on both sides are found, and what is left open is a small interval around the point.
  const auto open_parts = [](const root_set& s) {
    std::vector<ball> parts;
    for (const root_region& r : s.regions) {
      if (!is_one_root(r.verdict)) parts.push_back(r.box);
    }
    return parts;
  };
  for (const auto& [f, at] :
       std::vector<std::pair<const char*, const char*>>{{"sin(1/x)", "0"},
                                                        {"tan(1/x)", "0"},
                                                        {"sin(1/x)-x", "0"},
                                                        {"sin(1/(x-1/3))", "1/3"},
                                                        {"cos(1/(x^2-2))", "sqrt(2)"},
                                                        {"sin(1/(x-e/2))", "e/2"}}) {
    SCOPED_TRACE(f);
    const ball point = parse(at).value(64);
    const root_set s = isolate_roots(parse(f), -1, 2);
    EXPECT_TRUE(s.is_resolved());
    const auto parts = open_parts(s);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_TRUE(contains(parts.front(), point));
    EXPECT_TRUE(certainly_less(parts.front() - point, ball(rational(1, 50), 64)));
    const auto on_side = [&, point = point](bool is_left) {
      return std::ranges::count_if(s.regions, [&](const root_region& r) {
        return r.verdict == root_verdict::unique && certainly_less(r.enclosure, point) == is_left;
      });
    };
    EXPECT_GT(on_side(true), 10);
    EXPECT_GT(on_side(false), 10);
    isolate_options threads;
    threads.threads = 2;
    EXPECT_EQ(isolate_roots(parse(f), -1, 2, threads).regions.size(), s.regions.size());
  }
  // Two of them, each with its own roots.
  EXPECT_EQ(open_parts(isolate_roots(parse("sin(1/x)+sin(1/(x-1))"), -2, 2)).size(), 2U);
  // Many roots beside such a point, and none of them more often towards it.
  const auto count = [](const char* f, std::size_t roots) {
    SCOPED_TRACE(f);
    expect_resolved(isolate_roots(parse(f), -1, 1), roots);
  };
  count("sin(500*x)/(x-1/3)", 319);
  count("sin(300*x)*log(abs(x-1/3))", 192);
  count("sin(500*x)/sqrt(abs(x))", 318);
  // A factor that is too small beside the point to be told from 0.
  count("exp(-1/x^2)*(x-1/10^20)", 1);
}

TEST(IsolateRoots, SumsOfExponentialsTowardsInfinity) {
  const end_point infinity = end_point::infinity();
  const auto count = [&](const char* text, std::size_t roots) {
    SCOPED_TRACE(text);
    expect_resolved(isolate_roots(parse(text), -infinity, infinity), roots);
  };
  count("exp(2*x) - exp(x) - 6", 1);
  count("exp(2*x) - exp(x) + 1/5", 2);
  count("sinh(x) - 2*cosh(x) + 3", 2);
  count("tanh(x) - 1", 0);
  count("tanh(x) + 1", 0);
  count("tanh(x) - 1 + exp(-x)", 1);
  count("erf(x) - 1", 0);
  count("erf(x) + 1", 0);
  count("erfc(x) - 2", 0);
  count("1 - erf(x) - 1/10^30", 1);
  // Roots far out, where the greatest term does not lead yet.
  count("exp(2*x) - 10^30*exp(x) + 1", 2);
  count("exp(-x)*x - 1/10^50", 2);
  count("tanh(x) - 1 + 1/10^40", 1);
  expect_resolved(isolate_roots(parse("log(x) - 1000"), 0, infinity), 1);
  expect_resolved(isolate_roots(parse("gamma(x) - 10^100"), 1, infinity), 1);
}

TEST(IsolateRoots, BesideASingularPoint) {
  const auto count = [&](const char* text, const end_point& lower, const end_point& upper,
                         std::size_t roots) {
    SCOPED_TRACE(text);
    const root_set s = isolate_roots(parse(text), lower, upper);
    expect_resolved(s, roots);
    return s;
  };
  count("5*(exp(1/x)-1)*x - exp(1/x)", 0, 1, 1);
  count("exp(1/x) - 1/x^3 - 10", 0, 10, 1);
  count("x*sinh(1/x) - 2", -10, 10, 2);
  // A zero at 0, on one side of which it is not defined, and of which no series tells.
  const root_set zero = isolate_roots(parse("hypot(x, sqrt(x))"), -1, 1);
  ASSERT_EQ(zero.regions.size(), 1U);
  EXPECT_TRUE(contains_zero(zero.regions[0].enclosure));
  // Removable: no root there, whatever the limit.
  const root_set sine = count("sin(x)/x", -4, 4, 2);
  ASSERT_EQ(sine.singular.size(), 1U);
  EXPECT_TRUE(contains(sine.singular[0].place, 0L));
  count("(1 - cos(x))/x", -4, 4, 0);
  count("sin(x)/x - 1/2", -3, 3, 2);
  count("x*log(x)", 0, 2, 1);
  count("x^x - 9/10", 0, 2, 2);
  count("(exp(x) - 1)/x - 1/1000000", -1, 1, 0);
  count("sin(x)/x - 1 + 1/10^4", -1, 1, 2);
}

TEST(IsolateRoots, OfSumsOfExponentialsAndPowersToInfinity) {
  const auto count = [&](const char* text, std::size_t roots) {
    SCOPED_TRACE(text);
    expect_resolved(isolate_roots(parse(text), 0, end_point::infinity()), roots);
  };
  count("x^pi - pi^x", 2);
  count("x^(7/2) - 2^x", 2);
  count("exp(x^2) - 100*exp(x)", 1);
  count("exp(sqrt(x)) - x^(5/2)", 2);
  count("2^x - 3^x + 5*x^(1/3)", 2);
  count("exp(x) - 2*exp(x/sqrt(2)) - 1", 1);
  count("cosh(x) - sinh(x/2) - 20*x^(3/2)", 2);
  // As many as half turns.
  const root_set half_turns =
      isolate_roots(parse("exp(x)*sin(x) - x"), 0, end_point::infinity(), {.most_boxes = 2000});
  EXPECT_EQ(half_turns.regions.back().verdict, root_verdict::infinitely_many);
}

TEST(IsolateRoots, OfSpecialFunctionsUpToZero) {
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  const auto count = [&](const char* text, const end_point& upper, std::size_t roots) {
    SCOPED_TRACE(text);
    expect_resolved(isolate_roots(parse(text), 0, upper), roots);
  };
  count("digamma(x)", 10, 1);
  count("expint(1,x) - 1/2", 10, 1);
  count("Ei(x)", 5, 1);
  count("Ei(-x) + 3", 5, 1);
  count("Ci(x)", 10, 4);
  count("besselK(0,x) - 1", 10, 1);
  count("besselK(0,x) + log(x)/2 - 1", 10, 2);
  count("besselK(1,x) - 2/x", 10, 0);
  count("besselK(1/3,x) - 5", 10, 1);
  count("besselY(0,x)", 10, 3);
  count("polylog(3,-x) + x/2", 10, 1);
  count("besselJ(1/2,x)/sqrt(x) - 1", 5, 0);
  count("besselI(-1/3,x)*x - 1", 5, 1);
}

/// Across the end of their domain, and on half-lines where they grow.
TEST(IsolateRoots, OfSpecialFunctionsOnWholeLines) {
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  const auto count = [&](const char* text, std::size_t roots, const end_point& from = -5,
                         const end_point& to = 5) {
    SCOPED_TRACE(text);
    expect_resolved(isolate_roots(parse(text), from, to), roots);
  };
  count("besselI(1/3,x) - 2", 1);
  count("besselK(1,x)*exp(x) - 1", 1);
  count("besselJ(1/2,x) - 1/2", 2);
  count("besselY(0,x) + 1", 1);
  count("lambertW(x) + 1/2", 1);
  count("expint(2,x) - 1/10", 1);
  count("dilog(x) - 1", 1);
  count("polylog(3,x) - 1", 1);
  count("gammaUpper(1/3,x) - 1", 1);
  count("gammaLower(1/3,x) - 1", 1);
  count("Ci(x)", 2);
  count("Shi(x) - Chi(x) - 1", 1);
  count("ellipticK(x) - 2", 1);
  count("ellipticE(x) - 6/5", 1);
  count("carlsonRF(x,1,2) - 1", 1);
  count("carlsonRC(x,1) - 1/2", 0);
  count("carlsonRJ(x,1,2,3) - 1/4", 1);

  const end_point infinity = end_point::infinity();
  count("zeta(x) - 3/2", 1, 1, infinity);
  count("digamma(x) - log(x) + 1/10", 1, 0, infinity);
  count("Si(x) - 2", 0, -infinity, infinity);
  count("Ei(x) + x", 1, -infinity, infinity);
  count("besselI(0,x) - 2", 2, -infinity, infinity);
  count("besselI(2,x)*exp(-x) - 1/10", 2, 0, infinity);
  count("besselK(0,x) - 1", 1, 0, infinity);
  count("x*erfi(x) - exp(x)", 2, -infinity, infinity);
  count("erfcx(x) - 2", 1, -infinity, infinity);
  count("dawson(x) - 1/10", 2, -infinity, infinity);
  count("airyBi(x) - airyAi(x)", 0, 0, infinity);
  count("dilog(x) + 1", 1, -infinity, 1);
  count("Shi(x) - 3", 1, -infinity, infinity);
  count("fresnelS(x) - 1/4", 1, -infinity, infinity);
}

/// It holds from 4 on: this one has a root between 2 and 3.
TEST(ZeroFreeEnds, TakeNoLeadingTermBeforeItHolds) {
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  const zero_free_ends f(parse("zeta(x) - 1 - 2^(-x) - 3/10"));
  EXPECT_TRUE(f.beyond(5));
  EXPECT_FALSE(f.beyond(2));
  expect_resolved(isolate_roots(parse("zeta(x) - 1 - 2^(-x) - 3/10"), 2, end_point::infinity()), 1);
}

/// e^-x I(x) sqrt(2 pi x) is 1 + 1/(8 x) + ...: less 1 + 1/(10 x) it is positive, which the leading
/// term 1 does not tell.
TEST(ZeroFreeEnds, TakeTheRestBesideALeadingTerm) {
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  EXPECT_EQ(zero_free_ends(parse("besselIx(0,x)*sqrt(2*pi*x)-1-1/(10*x)")).sign_beyond(16), 0);
  EXPECT_EQ(zero_free_ends(parse("besselIx(0,x)*sqrt(2*pi*x)-1-1/x")).sign_beyond(16), -1);
}

/// J is 0 at 0, where its formula alone knows its value.
TEST(IsolateRoots, HaveNoneAtABranchPointOnlyWhereTheValueIsNotZero) {
  expect_resolved(isolate_roots(parse("x^x + 1"), 0, 1), 0);
  expect_resolved(isolate_roots(parse("x^x - x + 1"), 0, 1), 0);
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  expect_resolved(isolate_roots(parse("besselJ(1/2,x)"), -1, 1), 1);
  expect_resolved(isolate_roots(parse("besselJ(1/2,x) + 1"), -1, 1), 0);
  EXPECT_FALSE(isolate_roots(parse("gammaLower(1/3,x)"), -1, 1).is_resolved());
}

TEST(IsolateRoots, AreIsolatedWhereARootOrAPowerBegins) {
  const auto expect_isolated = [](const char* text, const char* root) {
    SCOPED_TRACE(text);
    const root_set s = isolate_roots(parse(text), 0, 3);
    expect_resolved(s, 1);
    ASSERT_EQ(s.regions.size(), 1U);
    EXPECT_EQ(s.regions[0].verdict, root_verdict::isolated);
    EXPECT_EQ(s.regions[0].multiplicity, 0);
    EXPECT_TRUE(overlaps(refine(s.regions[0], 50).enclosure, parse(root, {}).value(300)));
  };
  expect_isolated("x^pi", "0");
  expect_isolated("x^(1/3) + x^pi", "0");
  expect_isolated("sqrt(x^2-2)", "sqrt(2)");
  expect_isolated("abs(exp(x)-3)", "log(3)");
  expect_isolated("cbrt(exp(x)-3)", "log(3)");
  expect_isolated("(exp(x)-3)^(pi/7)", "log(3)");
  expect_isolated("(x-sqrt(2))^x", "sqrt(2)");
  expect_isolated("sqrt(sqrt(x^2-2))*(x-1)", "sqrt(2)");
  expect_isolated("sqrt((x^2-2)/(x-1))*(x-5/4)", "sqrt(2)");
  expect_isolated("sqrt(x-sqrt(2))*sqrt(x-3/2)", "3/2");
  expect_isolated("(x^2-2)*abs(x^2-2)", "sqrt(2)");
}

TEST(IsolateRoots, AtABranchPointAreOnlyWhereTheWholeIsDefined) {
  const auto expect_none = [](const char* text) {
    SCOPED_TRACE(text);
    expect_resolved(isolate_roots(parse(text), 0, 3), 0);
  };
  expect_none("sqrt(x^2-2)*exp(1/(x^2-2))");
  expect_none("1/(1/sqrt(x^2-2))");
  expect_none("1/abs(x^2-2)");
  expect_none("(x^2-2)^(-pi)");
  expect_none("x^pi + 1");
  expect_none("sqrt(sqrt(2)-x)*log(x-2)");
  // Not decided, but nothing wrong is said: the first is defined at its root alone, and the others
  // have none at sqrt(2).
  const root_set touching = isolate_roots(parse("sqrt(x-sqrt(2))*sqrt(sqrt(2)-x)"), 0, 3);
  ASSERT_EQ(touching.regions.size(), 1U);
  EXPECT_EQ(touching.regions[0].verdict, root_verdict::unresolved);
  isolate_options few;
  few.most_halvings = 30;
  few.most_boxes = 300;
  for (const char* text : {"log(x^2-2)*sqrt(x^2-2)", "sqrt((x^2-2)/(x-sqrt(2)))",
                           "sqrt(x^2-2)*exp(1/(x-sqrt(2)))", "exp(1/(x-sqrt(2)))*sqrt(x^2-2)",
                           "(sqrt(x^2-2)*exp(1/(x-sqrt(2))))^2", "sqrt(x^2-2)/exp(1/(x-sqrt(2)))",
                           "sqrt((x^2-2)*exp(1/(x-sqrt(2))))", "(x-sqrt(2))^(sqrt(2)-x)"}) {
    SCOPED_TRACE(text);
    for (const root_region& r : isolate_roots(parse(text), 0, rational(8, 5), few).regions) {
      EXPECT_EQ(r.verdict, root_verdict::unresolved);
    }
  }
  const root_set poles = isolate_roots(parse("(x-1)/abs(x^2-2)"), 0, 3);
  ASSERT_EQ(poles.singular.size(), 1U);
  EXPECT_EQ(poles.singular[0].pole_order, 0);
}

TEST(IsolateRoots, OfZetaAreTheTrivialOnes) {
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  const root_set s = isolate_roots(parse("zeta(x)"), -9, rational(1, 2));
  expect_resolved(s, 4);
  for (std::size_t k = 0; k < s.regions.size(); ++k) {
    EXPECT_TRUE(contains(s.regions[k].enclosure, 2 * static_cast<long>(k) - 8));
  }
}

TEST(IsolateRoots, WhatWasDividedByVanishesNowhere) {
  const auto count = [&](const char* text, std::size_t roots, std::size_t holes) {
    SCOPED_TRACE(text);
    const root_set s = isolate_roots(parse(text), rational(1, 2), 10);
    expect_resolved(s, roots);
    EXPECT_EQ(s.singular.size(), holes);
    return s;
  };
  // 1/tan(x) is not defined where tan(x) is not, at pi/2, 3 pi/2 and 5 pi/2; it has poles at pi, 2
  // pi and 3 pi.
  count("1/tan(x)", 0, 6);
  count("(x-1)/tan(x)", 1, 6);
  count("1/(1/(x^2-2))", 0, 1);
  count("1/(1/(x^2-2)) - 1", 1, 1);
  count("(1/(x-1))^-3*(x-2)", 1, 1);
  count("cos(x)*(1/(1/(x-1)))", 3, 1);
  count("1/(1/sin(x))", 0, 3);
  // At multiples of pi.
  const root_set sine = count("sin(x)/(x-pi)", 2, 1);
  EXPECT_TRUE(overlaps(sine.singular[0].place, pi(200)));
  count("cos(x)/(2*x-pi)", 2, 1);
  count("(1-cos(x))/(x-2*pi)^2", 0, 1);
  count("(1-cos(x))/(x-2*pi)", 0, 1);
  count("sin(x)/(x-2*pi) - 1/2", 2, 1);
  // A root, and a place that is none, near each other.
  count("(1/(1/sin(x-1)))*(x - 1 - 1/10^20)", 1, 3);
  // A zero beside a pole that is another place.
  count("sin(x)/(x-3)", 3, 1);
  count("tan(x)/(x-3)", 3, 4);
}

TEST(FunctionStructure, IsDefinedNowhereAtAnExactZeroOfADivisor) {
  const auto natural = [](const char* text) {
    const auto s = real_function(parse(text))
                       .structure(function_structure::variable_at(pi_combination{0, 1}, 0, 100));
    return s->natural_range();
  };
  EXPECT_FALSE(natural("sin(x)/(x-pi)").has_value());
  EXPECT_FALSE(natural("x/sin(x) + 1").has_value());
  EXPECT_TRUE(natural("sin(x)/(x-3)").has_value());
  EXPECT_TRUE(natural("sin(x)/(x-pi-1/10^60)").has_value());
}

TEST(IsolateRoots, PowersWhereTheyAreDefined) {
  const auto count = [&](const char* text, std::size_t roots) {
    SCOPED_TRACE(text);
    expect_resolved(isolate_roots(parse(text), -3, 3), roots);
  };
  count("x^0.3 - 1", 1);
  count("(x^2-1)^0.7 - 1/2", 2);
  count("x^x - 4", 1);
  // A whole power of a negative number is one: (-2)^-2 = 1/4 and (-1)^-1 = -1.
  EXPECT_FALSE(isolate_roots(parse("x^x - 1/4"), -3, -1).is_resolved());
  EXPECT_FALSE(isolate_roots(parse("x^x + 1"), -3, 3).is_resolved());
}

TEST(IsolateRoots, OfGamma) {
  const root_set s = isolate_roots(parse("gamma(x) - 2"), 0, 5);
  expect_resolved(s, 2);
  EXPECT_EQ(refine(s.regions[1], 30).verdict, status::certified);
  EXPECT_TRUE(contains(s.regions[1].enclosure, 3L));
  const root_set poles = isolate_roots(parse("gamma(x)"), rational(-11, 2), 5);
  expect_resolved(poles, 0);
  ASSERT_EQ(poles.singular.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(poles.singular[k].pole_order, 1);
    EXPECT_TRUE(contains(poles.singular[k].place, static_cast<long>(k) - 5));
  }
  // The structure's derivative is the function's.
  for (const char* at : {"-7/2", "1/3", "4"}) {
    const ball x = parse_ball(at, 100);
    const auto structure =
        real_function(parse("gamma(x)")).structure(function_structure::variable(x, x));
    ASSERT_TRUE(structure);
    EXPECT_TRUE(overlaps(structure->over()[0], gamma(x)));
    EXPECT_TRUE(overlaps(structure->over()[1], gamma(x) * digamma(x)));
  }
  // log |Gamma| is 0 where Gamma is 1 or -1.
  expect_resolved(isolate_roots(parse("log_gamma(x)"), rational(-11, 2), 5), 9);
  for (const char* text : {"agm(1, x) - 2", "agm(x, 1/x) - 2", "agm(x, 2*x) - 5"}) {
    const root_set mean = isolate_roots(parse(text), 0, 10);
    EXPECT_TRUE(std::any_of(mean.regions.begin(), mean.regions.end(), [](const root_region& r) {
      return r.verdict == root_verdict::unique;
    })) << text;
  }
  expect_resolved(isolate_roots(parse("gamma(x)^2 - 1"), rational(-11, 2), 5), 9);
}

/// Between and beside their poles.
TEST(IsolateRoots, OfDigammaAndZeta) {
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  const root_set s = isolate_roots(parse("digamma(x)"), rational(-11, 2), 5);
  expect_resolved(s, 6);
  ASSERT_EQ(s.singular.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_LE(s.singular[k].pole_order, 1);  // 0 where bounds beside the point decide
    EXPECT_TRUE(contains(s.singular[k].place, static_cast<long>(k) - 5));
  }
  EXPECT_TRUE(overlaps(s.regions.back().enclosure, parse_ball("1.4616321449683623412", 64)));
  const root_set z = isolate_roots(parse("zeta(x) - 2"), rational(-5, 2), 5);
  expect_resolved(z, 1);
  EXPECT_TRUE(overlaps(z.regions[0].enclosure, parse_ball("1.7286472389981836181351", 70)));
  expect_resolved(isolate_roots(parse("zeta(x) + 1"), rational(-1), 5), 1);
  // The quotient is the function, and its derivative the function's.
  for (const char* text : {"digamma(x)", "zeta(x)"}) {
    for (const char* at : {"-7/2", "1/3", "4", "-0.01", "5/4"}) {
      const ball x = parse_ball(at, 100);
      const expression f = parse(text);
      const auto structure = real_function(f).structure(function_structure::variable(x, x));
      ASSERT_TRUE(structure);
      const auto value = f.evaluator<jet<ball, 1>>(100)(jet<ball, 1>::variable(x));
      EXPECT_TRUE(overlaps(structure->over()[0], value[0])) << text << at;
      EXPECT_TRUE(overlaps(structure->over()[1], value[1])) << text << at;
      // And over a set around the point, at its end.
      const ball wide = x.enlarged(magnitude::power_of_two(-7));
      const ball end = (x + ball(rational(1, 128), 100)).middle();
      const auto around = real_function(f).structure(function_structure::variable(wide, x));
      const auto there = f.evaluator<jet<ball, 1>>(100)(jet<ball, 1>::variable(end));
      EXPECT_TRUE(overlaps(around->over()[0], there[0])) << text << at;
      EXPECT_TRUE(overlaps(around->over()[1], there[1])) << text << at;
    }
  }
}

TEST(IsolateRoots, OfAPeriodicFunction) {
  const end_point infinity = end_point::infinity();
  const auto by_period = [](const char* f, const end_point& lower, const end_point& upper) {
    return isolate_roots(parse(f), lower, upper, {.most_boxes = 500, .by_period = true});
  };
  const root_set s = by_period("sin(x)", 0, infinity);
  expect_resolved(s, 3);
  ASSERT_TRUE(s.of_period);
  EXPECT_EQ(s.of_period->period, (pi_combination{0, 2}));
  EXPECT_EQ(s.of_period->upper.form(), (pi_combination{0, 2}));
  const root_set t = by_period("sin(pi*x) - 1/2", -infinity, 1);
  expect_resolved(t, 2);
  ASSERT_TRUE(t.of_period);
  EXPECT_EQ(t.of_period->lower.exact(), rational(-1));
  // Factors without zeros do not count, if they have values everywhere.
  const root_set u = by_period("exp(1-x/3)*sin(x)/cosh(x)", 0, infinity);
  EXPECT_TRUE(u.is_resolved());
  ASSERT_TRUE(u.of_period);
  EXPECT_EQ(u.of_period->period, (pi_combination{0, 2}));
  EXPECT_EQ(u.regions.size(), 3U);
  EXPECT_FALSE(real_function(parse("exp(sqrt(x))*sin(x)")).period());
  EXPECT_FALSE(real_function(parse("x*sin(x)")).period());
  // A short formula of which the tree is long.
  const real_function many([](const auto& x) {
    auto y = x;
    auto z = x;
    for (int k = 0; k < 80; ++k) {
      y = (y * sin(x)) * (y * cos(x));
      z = (z + x * x) + (z - x);
    }
    return y * exp(z);
  });
  EXPECT_FALSE(many.period());
  // Not periodic, or bounded: no.
  EXPECT_FALSE(by_period("sin(x) + x", -infinity, infinity).of_period);
  EXPECT_FALSE(by_period("sin(x)", 0, 100).of_period);
  // Who does not ask for one period is never told that its roots are all.
  for (const char* f : {"sin(x)", "1 - cos(x)", "cos(x) - sin(x)^2 + 1"}) {
    const root_set all = isolate_roots(parse(f), 1, infinity, {.most_boxes = 500});
    EXPECT_FALSE(all.of_period) << f;
    EXPECT_FALSE(is_one_root(all.regions.back().verdict)) << f;
  }
}

TEST(IsolateRoots, AnEndWhereNothingIsBoundedDoesNotHideTheRootsBesideIt) {
  const root_set s = isolate_roots(parse("gamma(1/x) - 5*gamma(1/(2*x))"), 0, 1);
  ASSERT_EQ(s.regions.size(), 2U);
  EXPECT_EQ(s.regions[0].verdict, root_verdict::unresolved);
  EXPECT_TRUE(s.regions[0].box.magnitude_upper() < magnitude::power_of_two(-8));
  EXPECT_EQ(s.regions[1].verdict, root_verdict::unique);
}

TEST(IsolateRoots, WhereTheFunctionIsNotDefined) {
  const root_set s = isolate_roots([](const auto& x) { return sqrt(x) - rational(1, 2); }, -1, 1);
  expect_resolved(s, 1);
  EXPECT_EQ(refine(s.regions[0], 20).exact, rational(1, 4));
  ASSERT_EQ(s.singular.size(), 1U);
  EXPECT_EQ(s.singular[0].pole_order, 0);
  EXPECT_TRUE(contains(s.singular[0].place, -1L));

  const auto remark_of = [](const root_set& set) {
    return set.regions.size() == 1 ? set.regions[0].remark : std::string("?");
  };
  // Told apart from roots, by what is met.
  const auto above_root = [](const auto& x) { return floor(x * x) - x * x; };
  EXPECT_EQ(remark_of(isolate_roots(above_root, rational(5, 4), rational(3, 2))),
            "the jump of floor");
  const root_set kink = isolate_roots([](const auto& x) { return abs(x); }, -1, 1);
  ASSERT_EQ(kink.regions.size(), 1U);
  EXPECT_EQ(kink.regions[0].verdict, root_verdict::isolated);
  EXPECT_EQ(kink.regions[0].exact, rational(0));
  const root_set branch = isolate_roots([](const auto& x) { return sqrt(x); }, 0, 1);
  ASSERT_EQ(branch.regions.size(), 1U);
  EXPECT_EQ(branch.regions[0].verdict, root_verdict::isolated);
  EXPECT_EQ(remark_of(isolate_roots([](const auto& x) { return sin(x) / (x - pi(300)); }, 3, 4)),
            "the pole of /");
}

TEST(IsolateRoots, Constants) {
  EXPECT_TRUE(isolate_roots([](const auto&) { return 0; }, 0, 1).identically_zero);
  EXPECT_TRUE(isolate_roots([](const auto& x) { return x - x; }, 0, 1).identically_zero);
  expect_resolved(isolate_roots([](const auto&) { return 1; }, 0, 1), 0);
  expect_resolved(isolate_roots([](const auto& x) { return exp(x * 0); }, 0, 1), 0);
  // By an antiderivative.
  const auto circle = [](const auto& x) { return square(sin(x)) + square(cos(x)) - 1; };
  EXPECT_TRUE(isolate_roots(circle, 0, 1).identically_zero);
  EXPECT_TRUE(isolate_roots([](const auto& x) { return exp(x) - cosh(x) - sinh(x); }, -1, 1)
                  .identically_zero);
  EXPECT_FALSE(
      isolate_roots([&](const auto& x) { return circle(x) * x + pow(x - rational(5, 7), 2); }, 0, 1)
          .identically_zero);
  // 0 everywhere, which neither enclosures nor the rules prove: left open, without an endless
  // search.
  const root_set s =
      isolate_roots([](const auto& x) { return atan(sin(x)) - atan(sin(2 * x) / (2 * cos(x))); }, 0,
                    1, {.most_unresolved = 50});
  EXPECT_FALSE(s.is_resolved());
  ASSERT_EQ(s.regions.size(), 1U);
  EXPECT_TRUE(contains(s.regions[0].box, rational(1, 3)));
}

TEST(IsolateRoots, BadInput) {
  const auto f = [](const auto& x) { return x; };
  EXPECT_THROW(static_cast<void>(isolate_roots(f, 1, 0)), input_error);
  EXPECT_THROW(static_cast<void>(isolate_roots(f, end_point::infinity(), 0)), input_error);
  EXPECT_THROW(static_cast<void>(isolate_roots(f, 0, -end_point::infinity())), input_error);
  EXPECT_THROW(static_cast<void>(
                   isolate_roots(f, 0, end_point([](precision p) { return log(ball(-1, p)); }))),
               input_error);
  EXPECT_THROW(static_cast<void>(refine(isolate_roots(f, -1, 1).regions[0], 0)),
               std::invalid_argument);
}

// ---------------------------------------------------------------------------------------------
// Properties

TEST(IsolateRoots, ChosenRationalRootsAreAllThereAre) {
  random_source random(20);
  for (repeat trial(25); trial.again();) {
    std::vector<std::pair<rational, long>> roots;
    const long count = random.between(1, 3);
    for (long k = 0; k < count; ++k) {
      const rational r(random.between(-40, 40), random.one_in(2) ? 8 : random.between(1, 12));
      const bool known =
          std::any_of(roots.begin(), roots.end(), [&](const auto& s) { return s.first == r; });
      if (!known) roots.emplace_back(r, random.one_in(2) ? 1 : random.between(2, 3));
    }
    std::sort(roots.begin(), roots.end());
    const rational_polynomial p =
        with_roots(roots) * rational_polynomial({rational(1), rational(1, 2), rational(1)});
    // Exactly, as a polynomial.
    const root_set s = isolate_roots(real_function::of(p), -50, 50);
    expect_resolved(s, roots.size());
    ASSERT_EQ(s.regions.size(), roots.size());
    for (std::size_t k = 0; k < roots.size(); ++k) {
      EXPECT_EQ(s.regions[k].multiplicity, roots[k].second);
      EXPECT_EQ(refine(s.regions[k], 30).exact, roots[k].first);
    }
    // As a function of which only values and derivatives are known: whatever is claimed is true.
    const root_set t = isolate_roots(disguised{p.coefficients()}, -5, 5);
    for (const auto& [r, m] : roots) {
      const rational root = r;
      const long multiplicity = m;
      if (abs(root) > 5) continue;
      const auto holding =
          std::count_if(t.regions.begin(), t.regions.end(), [&](const root_region& region) {
            if (!contains(region.enclosure, root)) return false;
            EXPECT_TRUE(region.multiplicity == 0 || region.multiplicity == multiplicity)
                << root << ": " << multiplicity;
            return true;
          });
      EXPECT_EQ(holding, 1) << root;
    }
    for (const root_region& region : t.regions) {
      if (region.multiplicity == 0) continue;
      const auto inside = std::count_if(
          roots.begin(), roots.end(), [&](const auto& r) { return contains(region.box, r.first); });
      EXPECT_EQ(inside, 1);
    }
  }
}

TEST(IsolateRoots, ASearchCanBeStoppedAndGoneOnWith) {
  const auto f = [](const auto& x) { return sin(square(x)) - rational(1, 10); };
  const root_set whole = isolate_roots(f, 0, 10);
  root_search search(f, 0, 10);
  int runs = 0;
  std::size_t before = 0;
  while (!search.is_finished() && runs < 1000) {
    const root_search kept = search;  // a value
    search.run({.most_boxes = 7});
    ++runs;
    const root_set so_far = search.result();
    const auto found = static_cast<std::size_t>(
        std::count_if(so_far.regions.begin(), so_far.regions.end(),
                      [](const root_region& r) { return r.verdict == root_verdict::unique; }));
    EXPECT_GE(found, before);
    before = found;
    EXPECT_EQ(so_far.complete, search.is_finished());
    // Nothing is lost on the way: every root of the whole lies in a region.
    for (const root_region& r : whole.regions) {
      EXPECT_TRUE(std::any_of(so_far.regions.begin(), so_far.regions.end(),
                              [&](const auto& q) { return overlaps(q.enclosure, r.enclosure); }));
    }
    EXPECT_LE(so_far.account.boxes, kept.result().account.boxes + 7);
  }
  EXPECT_GT(runs, 5);
  const root_set result = search.result();
  expect_resolved(result, whole.regions.size());
  EXPECT_EQ(result.account.boxes, whole.account.boxes);
  for (std::size_t i = 0; i < whole.regions.size(); ++i) {
    EXPECT_EQ(to_exact_text(result.regions[i].enclosure),
              to_exact_text(whole.regions[i].enclosure));
  }
}

TEST(IsolateRoots, LimitsAndProgress) {
  const auto f = [](const auto& x) { return sin(square(x)); };
  long calls = 0;
  isolate_options options;
  options.progress = [&](const isolation_progress& p) {
    EXPECT_GE(p.boxes_waiting, 0);
    return ++calls < 3;
  };
  const root_set s = isolate_roots(f, 1, 60, options);
  EXPECT_EQ(calls, 3);
  EXPECT_FALSE(s.complete);
  EXPECT_EQ(s.regions.back().remark, "a request to stop was reached");
  const root_set t = isolate_roots(f, 1, 60, {.most_time = std::chrono::milliseconds(0)});
  EXPECT_FALSE(t.complete);
}

TEST(IsolateRoots, ProgressIsAShareOfTheRange) {
  const auto f = [](const auto& x) { return sin(square(x)); };
  std::vector<double> shares;
  isolate_options options;
  options.progress = [&](const isolation_progress& p) {
    shares.push_back(p.share_done.value());
    return true;
  };
  (void)isolate_roots(f, 1, 60, options);
  ASSERT_GT(shares.size(), 3U);
  EXPECT_EQ(shares.front(), 0);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.back(), 0.5);
  EXPECT_LT(shares.back(), 1);
}

// ---------------------------------------------------------------------------------------------
// What it costs

TEST(IsolateRoots, EvaluationsAreFew) {
  const root_set s = isolate_roots([](const auto& x) { return sin(square(x)); }, 0, 60);
  expect_resolved(s, 1146);
  EXPECT_EQ(s.regions[0].multiplicity, 2);      // x^2 at 0
  EXPECT_LE(s.account.evaluations, 10 * 1146);  // 50 are allowed
  EXPECT_LE(isolate_roots([](const auto& x) { return cos(x) - x; }, 0, 1).account.evaluations, 4);
}

TEST(Refine, CostsOneEvaluationWithTheFullPrecision) {
  // The bits of every evaluation are counted by a function object of the library's own kind.
  struct counted {
    std::vector<precision>* bits;
    auto operator()(const ball& x) const {
      bits->push_back(x.precision());
      return cos(x) - x;
    }
    auto slope(const ball& x) const {
      bits->push_back(x.precision());
      return -sin(x) - 1;
    }
  };
  std::vector<precision> bits;
  const counted f{&bits};
  const real_function g =
      real_function::with_derivative(f, [f](const ball& x) { return f.slope(x); });
  const root_set s = isolate_roots(g, 0, 1);
  expect_resolved(s, 1);
  bits.clear();
  const refined_root r = refine(s.regions[0], 10'000);
  EXPECT_EQ(r.verdict, status::certified);
  // In units of an evaluation with the full precision, as if the cost grew with its first power.
  double cost = 0;
  const auto most = static_cast<double>(*std::max_element(bits.begin(), bits.end()));
  for (const precision b : bits) cost += static_cast<double>(b) / most;
  EXPECT_LE(cost, 3.1);
  EXPECT_EQ(std::count_if(bits.begin(), bits.end(),
                          [&](precision b) { return static_cast<double>(b) > 0.6 * most; }),
            1);
}

TEST(Refine, SeesThroughCancellation) {
  std::vector<std::pair<rational, long>> roots;
  for (long k = 1; k <= 20; ++k) roots.emplace_back(k, 1);
  std::vector<rational> c = with_roots(roots).coefficients();
  c[0] += rational(1, 1000);
  const rational_polynomial p(c);
  const root_set s = isolate_roots(real_function::of(p), 0, 30);
  expect_resolved(s, 20);
  for (const root_region& region : s.regions) {
    const refined_root r = refine(region, 200);
    EXPECT_EQ(r.verdict, status::certified);
    const rational low = lower_rational(r.enclosure);
    const rational high = upper_rational(r.enclosure);
    EXPECT_LE(rational(p(low) * p(high)), 0);  // decided in rationals
  }
}

TEST(Refine, HalvesWhereNewtonDoesNotContractYet) {
  // One Newton step proves the root in [-50, 50], and leaves an enclosure too wide for the next
  // one.
  const rational_polynomial p = with_roots({{rational(1, 2), 1}}) *
                                rational_polynomial({rational(1), rational(1, 2), rational(1)});
  const root_set s = isolate_roots(real_function::of(p), -50, 50);
  expect_resolved(s, 1);
  const refined_root r = refine(s.regions[0], 30);
  EXPECT_EQ(r.verdict, status::certified);
  EXPECT_EQ(r.exact, rational(1, 2));
}

TEST(RealFunction, UserSuppliedDerivativesAreChecked) {
  const auto f = [](const auto& x) { return cos(x) - x; };
  EXPECT_FALSE(refute_derivative(
                   f, [](const ball& x) { return -sin(x) - 1; }, 0, 1)
                   .has_value());
  const auto wrong = refute_derivative(
      f, [](const ball& x) { return sin(x) - 1; }, 0, 1);
  ASSERT_TRUE(wrong.has_value());
  EXPECT_NE(*wrong, 0);
}

TEST(RealFunction, WithADerivativeOnly) {
  const real_function g = real_function::with_derivative(
      [](const ball& x) { return agm(ball(1, x.precision()), x) - rational(3, 2); },
      // By the first order in x of the mean's integral, in a crude but sound form: the mean
      // increases, with a slope between 1/4 and 1 on [1, 3].
      [](const ball& x) {
        return hull(ball(rational(1, 4), x.precision()), ball(1, x.precision()));
      });
  const root_set s = isolate_roots(g, 1, 3);
  ASSERT_EQ(s.regions.size(), 1U);
  EXPECT_EQ(s.regions[0].verdict, root_verdict::unique);
}

// ---------------------------------------------------------------------------------------------
// The structure

TEST(FunctionStructure, KnowsFactorsAndPoles) {
  const ball box = hull(ball(-1, 64), ball(1, 64));
  const auto x = function_structure::variable(box, ball(0, 64));
  const auto f = square(sin(x)) * exp(x) * (x - 3) / pow(cos(x), 3);
  ASSERT_EQ(f.numerator().factors.size(), 2U);
  EXPECT_EQ(f.numerator().factors[0].power, 2);
  EXPECT_EQ(f.numerator().factors[1].power, 1);
  ASSERT_EQ(f.denominator()->factors.size(), 1U);
  EXPECT_EQ(f.denominator()->factors[0].power, 3);
  const auto s = sin(x);
  EXPECT_EQ((s * s).numerator().factors.size(), 1U);
  EXPECT_EQ((sin(x) * sin(x)).numerator().factors.size(), 2U);  // not known to be the same
  EXPECT_FALSE(sqrt(x - 2).natural_range().has_value());
  EXPECT_TRUE(contains(*sqrt(x).natural_range(), rational(1, 2)));
  EXPECT_TRUE(sqrt(x).over()[0].is_undefined());
}

TEST(FunctionStructure, SeriesAreExactWhereTheyAreEvidentlyRational) {
  const auto x = function_structure::variable_at(0, 4, 64);
  const auto f = exp(x) * cos(x) - 1 - x;
  ASSERT_TRUE(f.series().has_value());
  EXPECT_TRUE((*f.series())[0].is_exactly(0));
  EXPECT_TRUE((*f.series())[1].is_exactly(0));
  EXPECT_TRUE((*f.series())[2].is_exactly(0));
  EXPECT_EQ((*f.series())[3].exact(), rational(-1, 3));
  // Not at pi, nor of a constant that is no rational number.
  const auto y = function_structure::variable_at(rational(22, 7), 1, 64);
  EXPECT_FALSE((*sin(y).series())[0].exact().has_value());
  EXPECT_FALSE((*(y * pi(64) - pi(64) * y).series())[0].exact().has_value());
  EXPECT_TRUE((*(y * pi(64) * 0).series())[0].is_exactly(0));
}

TEST(FunctionStructure, SeriesAreExactAtMultiplesOfPi) {
  const auto known = [](const rational& q, const rational& r) {
    return known_number(pi_combination{q, r}, 64);
  };
  // sin, cos and tan at k pi/2, and enclosures at other points.
  for (long k = -9; k <= 9; ++k) {
    const auto x = known(0, rational(k, 2));
    const ball enclosed = ball(k, 64) * pi(64) / 2;
    ASSERT_TRUE(sin(x).exact() && cos(x).exact()) << k;
    EXPECT_TRUE(contains(sin(enclosed), *sin(x).exact())) << k;
    EXPECT_TRUE(contains(cos(enclosed), *cos(x).exact())) << k;
    EXPECT_EQ(*sin(x).exact() * *sin(x).exact() + *cos(x).exact() * *cos(x).exact(), 1);
    EXPECT_EQ(tan(x).is_exactly(0), k % 2 == 0);
    EXPECT_EQ(tan(x).enclosure().is_undefined(), k % 2 != 0);
  }
  for (const auto& x : {known(0, rational(1, 3)), known(rational(1, 7), 1), known(1, 0)}) {
    EXPECT_FALSE(sin(x).exact() || cos(x).exact() || tan(x).exact());
  }
  // Arithmetic of q + r pi: 0 only where both are.
  const auto x = known(rational(1, 3), 2);
  EXPECT_EQ((x - known(0, 2)).exact(), rational(1, 3));
  EXPECT_EQ((x * 3 - known(1, 6)).exact(), rational(0));
  EXPECT_EQ((x / 2 - known(0, 1)).exact(), rational(1, 6));
  EXPECT_EQ((known(3, 0) * x + known(-1, -6)).exact(), rational(0));
  EXPECT_EQ((x * known(0, 0)).exact(), rational(0));
  EXPECT_FALSE((x * x).exact() || (x / x).exact() || x.exact() || (known(1, 0) / x).exact());
  EXPECT_TRUE(overlaps((-x).enclosure(), -x.enclosure()));
  // 1 + cos has a double root at pi.
  const auto t = function_structure::variable_at(pi_combination{0, 1}, 2, 64);
  const auto f = *(1 + cos(t)).series();
  EXPECT_TRUE(f[0].is_exactly(0) && f[1].is_exactly(0));
  EXPECT_EQ(f[2].exact(), rational(1, 2));
}

}  // namespace isolate_test
}  // namespace polhode
