// The real roots of polynomials: counted by Sturm's theorem, shown by exact changes of sign.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/polynomial.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/roots/isolate.hpp"
#include "roots/polynomial/rational_roots.hpp"
#include "roots/polynomial/real_roots.hpp"
#include "roots/polynomial/root_bracket.hpp"
#include "roots/polynomial/taylor_shift.hpp"
#include "support/random.hpp"

namespace polhode {
namespace polynomial_roots_test {

using support::random_source;
using support::repeat;

rational_polynomial polynomial(const std::string& text) { return *parse(text).polynomial(); }

root_set all_roots(const rational_polynomial& p) {
  return isolate_roots(real_function::of(p), -end_point::infinity(), end_point::infinity());
}

/// Chebyshev's T_n.
rational_polynomial chebyshev(int n) {
  rational_polynomial before({rational(1)});
  rational_polynomial now = rational_polynomial::variable();
  const rational_polynomial twice({rational(0), rational(2)});
  for (int k = 1; k < n; ++k) {
    rational_polynomial next = twice * now - before;
    before = std::move(now);
    now = std::move(next);
  }
  return now;
}

rational_polynomial power(const rational_polynomial& p, long n) {
  rational_polynomial r({rational(1)});
  for (long k = 0; k < n; ++k) r = r * p;
  return r;
}

/// What is wrong with the roots that were found in the interval; "" where nothing is.
std::string error_in(const root_set& s, const rational_polynomial& p, const rational& lower,
                     const rational& upper) {
  if (!s.is_resolved()) return "not resolved";
  const long count = count_real_roots(p, lower, upper);
  if (static_cast<long>(s.regions.size()) != count) {
    return std::to_string(s.regions.size()) + " roots, not " + std::to_string(count);
  }
  const rational_polynomial once = divide(p, gcd(p, p.derivative())).first;
  for (std::size_t i = 0; i < s.regions.size(); ++i) {
    const root_region& r = s.regions[i];
    if (i > 0 && !certainly_less(s.regions[i - 1].enclosure, r.enclosure)) return "not in order";
    const refined_root fine = refine(r, 40);
    if (fine.verdict != status::certified) return "not refined";
    if (!overlaps(fine.enclosure, r.enclosure)) return "refined to another place";
    if (fine.exact && p(*fine.exact) != 0) return "an exact root is none";
    // Rounded to fewer bits than it has, the finer one may hold a root beside it.
    const rational low = lower_rational(r.enclosure);
    const rational high = upper_rational(r.enclosure);
    if (low < high && once(low) * once(high) >= 0) return "no change of sign";
    if (count_real_roots(p, lower_rational(r.box), upper_rational(r.box)) != 1) {
      return "not the only root in its box";
    }
    // f, f', ..., f^(m-1) have the root, f^(m) has it not.
    rational_polynomial common = p;
    rational_polynomial derivative = p;
    for (long m = 1; m <= r.multiplicity; ++m) {
      if (count_real_roots(common, low, high) != 1) return "the multiplicity is less";
      derivative = derivative.derivative();
      common = gcd(common, derivative);
    }
    if (count_real_roots(common, low, high) != 0) return "the multiplicity is greater";
  }
  return "";
}

/// A factor of one of many kinds.
rational_polynomial any_factor(random_source& random) {
  const auto scale = [&] {
    const rational ten(integer(boost::multiprecision::pow(integer(10), 20)));
    switch (random.between(0, 5)) {
      case 0:
        return ten;
      case 1:
        return rational(1 / ten);
      default:
        return rational(1);
    }
  };
  const auto any = [&] {
    return rational(random.between(-30, 30), random.between(1, 12)) * scale();
  };
  const rational_polynomial x = rational_polynomial::variable();
  const auto number = [](const rational& q) { return rational_polynomial({q}); };
  switch (random.between(0, 6)) {
    case 0:  // a rational root
      return x - number(any());
    case 1: {  // two roots beside each other
      const rational at = any();
      return power(x - number(at), 2) -
             number(rational(1, integer(1) << static_cast<unsigned long>(random.between(2, 200))));
    }
    case 2:  // none or two
      return x * x + number(any()) * x + number(any());
    case 3: {  // sparse, and of x^k
      const long k = random.between(2, 5);
      return power(x, 2 * k) + number(any()) * power(x, k) + number(any());
    }
    case 4: {  // Mignotte's
      const rational_polynomial line = number(rational(random.between(2, 1000))) * x - number(1);
      return power(x, random.between(3, 12)) - number(2) * line * line;
    }
    case 5:
      return chebyshev(static_cast<int>(random.between(1, 12)));
    default: {
      std::vector<rational> c;
      for (long k = random.between(1, 9); k >= 0; --k) c.push_back(any());
      c.push_back(rational(1));
      return rational_polynomial(c);
    }
  }
}

TEST(PolynomialRoots, AreThoseThatSturmCounts) {
  random_source random(3801);
  for (repeat trial(40); trial.again();) {
    rational_polynomial p({rational(1)});
    for (long k = random.between(1, 3); k > 0; --k) {
      p = p * power(any_factor(random), random.between(0, 3) == 0 ? random.between(2, 3) : 1);
    }
    if (p.degree() < 1) continue;
    const rational bound = root_bound(p) + 1;
    EXPECT_EQ(error_in(all_roots(p), p, -bound, bound), "");
    // In a part of the line, whose ends may be roots.
    rational lower(random.between(-40, 40), random.between(1, 4));
    rational upper(random.between(-40, 40), random.between(1, 4));
    if (upper < lower) std::swap(lower, upper);
    EXPECT_EQ(error_in(isolate_roots(real_function::of(p), lower, upper), p, lower, upper), "");
  }
}

TEST(PolynomialRoots, BesideARationalRoot) {
  // The irrational roots are 2^(1/2) 2^-100 from 1, the rational one.
  for (const char* text : {"(x-1)*((x-1)^2-2/4^100)", "(x-1-1/2^80)*((x-1)^2-2/4^100)",
                           "(10^13*x-14142135623731)*(x^2-2)", "(3*x-1)*((3*x-1)^2-3/4^60)*(x^2-2)",
                           "((x-1/3)^2-2/4^100)*((x-1/3)^2-3/4^100)^2",
                           "(3*x-1)*((x-1/3)^2-2/4^100)*((x-1/3)^2-3/4^100)^2", "(x^2-3)^2-2/4^60",
                           "(x^3-3)^2-2/4^60"}) {
    const rational_polynomial p = polynomial(text);
    EXPECT_EQ(error_in(all_roots(p), p, -9, 9), "") << text;
  }
}

TEST(PolynomialRoots, OfTheBattery) {
  const auto count = [](const rational_polynomial& p) {
    const root_set s = all_roots(p);
    EXPECT_TRUE(s.is_resolved());
    return s.regions.size();
  };
  EXPECT_EQ(count(chebyshev(100)), 100U);
  EXPECT_EQ(count(chebyshev(101)), 101U);
  EXPECT_EQ(count(polynomial("x^50-2*(10^10*x-1)^2")), 4U);
  EXPECT_EQ(count(polynomial("x^100-2*(10^10*x-1)^2")), 4U);
  EXPECT_EQ(count(polynomial("(x^105-1)/1")), 1U);
  EXPECT_EQ(count(polynomial("x^2000-2")), 2U);
  EXPECT_EQ(count(polynomial("x^3-10^300")), 1U);
  EXPECT_EQ(count(polynomial("(10^100*x-1)*(10^100*x-2)*(x-10^100)")), 3U);
  EXPECT_EQ(count(polynomial("x^5+1")), 1U);
  EXPECT_EQ(count(polynomial("x^4+1")), 0U);
  EXPECT_EQ(count(polynomial("x")), 1U);
  EXPECT_EQ(count(polynomial("7")), 0U);
  rational_polynomial wilkinson({rational(1)});
  for (long k = 1; k <= 60; ++k) {
    wilkinson = wilkinson * rational_polynomial({rational(-k), rational(1)});
  }
  const root_set s = all_roots(wilkinson);
  ASSERT_EQ(s.regions.size(), 60U);
  for (long k = 1; k <= 60; ++k) {
    EXPECT_EQ(s.regions[static_cast<std::size_t>(k - 1)].exact, rational(k));
  }
}

TEST(PolynomialRoots, AtAndBesideTheEndsOfTheRange) {
  const rational_polynomial p = polynomial("(x^2-2)*(x-1)*(x+3)^2");
  const auto within = [&](const rational& lower, const rational& upper) {
    const root_set s = isolate_roots(real_function::of(p), lower, upper);
    EXPECT_TRUE(s.is_resolved());
    return s.regions.size();
  };
  EXPECT_EQ(within(1, 1), 1U);
  EXPECT_EQ(within(2, 2), 0U);
  EXPECT_EQ(within(-3, 1), 3U);
  const rational near = lower_rational(ball(parse("sqrt(2)").value(4000)));
  EXPECT_EQ(within(1, near), 1U);
  EXPECT_EQ(within(near, 2), 1U);
  EXPECT_EQ(within(rational(1) + rational(1, integer(1) << 500UL), 2), 1U);
  // An end that is the root itself, irrational: it is not decided whether the root is inside.
  const root_set s = isolate_roots(real_function::of(p), 0, end_point_of(parse("sqrt(2)", {})));
  EXPECT_EQ(s.regions.size(), 2U);
}

TEST(RationalFunctions, HaveTheRootsOfTheNumeratorThatAreNoPoles) {
  struct expected {
    const char* text;
    std::size_t roots;
    std::vector<long> poles;  // their orders, from left to right
  };
  for (const auto& [text, roots, poles] :
       std::vector<expected>{{"1/x+1/x^2-6", 2, {2}},
                             {"1/x-2", 1, {1}},
                             {"1/x", 0, {1}},
                             {"x/x", 0, {0}},
                             {"x^2/x", 0, {0}},
                             {"1/(1/x)", 0, {0}},
                             {"1/(1/x)-1", 1, {0}},
                             {"(x^2-2)/(x-1)^3", 2, {3}},
                             {"(x^2-2)^2/(x^4-4)", 0, {0, 0}},
                             {"1/(x-1)-1/(x-1-1/10^60)", 0, {1, 1}},
                             {"(x^2-2)*(x-5)/((x^2-2)^3*(x^2-3))", 1, {1, 2, 2, 1}},
                             {"(x-1)/(x^2+1)", 1, {}},
                             {"(x-1)^2/(x^2-3)-1/(x^2-3)", 2, {1, 1}},
                             {"(x^2-2)/((x^2-2)+1/10^80)", 2, {1, 1}}}) {
    const root_set s =
        isolate_roots(real_function(parse(text)), -end_point::infinity(), end_point::infinity());
    EXPECT_TRUE(s.is_resolved()) << text;
    EXPECT_EQ(s.regions.size(), roots) << text;
    std::vector<long> orders;
    for (const singular_place& place : s.singular) orders.push_back(place.pole_order);
    EXPECT_EQ(orders, poles) << text;
    for (const root_region& r : s.regions) {
      for (const singular_place& place : s.singular) {
        EXPECT_FALSE(overlaps(r.enclosure, place.place)) << text;
      }
    }
  }
}

TEST(RationalFunctions, ACashFlowOfAHundredYears) {
  // -100 now, 7 at the end of each year: the rate at which the sum is 0.
  std::string text = "-100";
  for (int k = 1; k <= 100; ++k) text += " + 7/(1+x)^" + std::to_string(k);
  const root_set s = isolate_roots(real_function(parse(text)), 0, 1);
  ASSERT_EQ(s.regions.size(), 1U);
  EXPECT_TRUE(s.is_resolved());
  // 7 (1 - (1+x)^-100) = 100 x.
  const ball x = refine(s.regions[0], 40).enclosure;
  const ball difference = 7 * (1 - pow(1 + x, -100)) - 100 * x;
  EXPECT_TRUE(contains_zero(difference));
  EXPECT_LE(difference.magnitude_upper(), magnitude::power_of_two(-120));
}

TEST(PolynomialRoots, StopWhereTheyAreAskedTo) {
  root_search search(real_function::of(chebyshev(60)), -1, 1);
  search.run({.most_boxes = 5});
  EXPECT_FALSE(search.is_finished());
  EXPECT_FALSE(search.result().is_resolved());
  search.run();
  EXPECT_TRUE(search.is_finished());
  EXPECT_EQ(search.result().regions.size(), 60U);
}

TEST(PolynomialRoots, AreRefinedToManyDigits) {
  const root_set s = all_roots(polynomial("(x^2-2)*(x^3-x-1)"));
  ASSERT_EQ(s.regions.size(), 3U);
  for (const long digits : {1L, 20L, 100L, 150L, 160L, 1000L, 5000L}) {
    const refined_root r = refine(s.regions[2], digits);
    EXPECT_EQ(r.verdict, status::certified);
    const ball known = sqrt(ball(2, bits_for_digits(digits) + 64));
    EXPECT_TRUE(overlaps(r.enclosure, known));
    EXPECT_LE(r.enclosure.radius(), scale(known.magnitude_upper(), -bits_for_digits(digits)));
    EXPECT_TRUE(contains(square(r.enclosure), rational(2)));
  }
}

TEST(RationalRoots, AreAllFound) {
  random_source random(3802);
  for (repeat trial(200); trial.again();) {
    std::vector<rational> roots;
    rational_polynomial p({rational(random.between(1, 9), 7)});
    for (long k = random.between(0, 8); k > 0; --k) {
      const rational r(random.between(-2000, 2000), random.between(1, 300));
      if (std::find(roots.begin(), roots.end(), r) != roots.end()) continue;
      roots.push_back(r);
      p = p * rational_polynomial({rational(-r), rational(1)});
    }
    std::sort(roots.begin(), roots.end());
    p = p * polynomial(random.between(0, 1) == 0 ? "x^2-2" : "x^4+x+1");
    const detail::rational_roots found = detail::rational_roots_of(p);
    EXPECT_EQ(found.roots, roots);
    EXPECT_TRUE(found.rest.size() == 3 || found.rest.size() == 5);
  }
  // Extreme ones: a x is the bound itself but for the leading coefficient.
  for (const char* text : {"x-10^60", "10^60*x-1", "x^2-10^60*x", "(x-1)*(10^40*x-10^40-1)"}) {
    const detail::rational_roots found = detail::rational_roots_of(polynomial(text));
    EXPECT_EQ(found.rest.size(), 1U) << text;
  }
}

/// Up to so many integers, some of them with up to so many bits more.
std::vector<integer> any_coefficients(random_source& random, long most, long more_bits) {
  std::vector<integer> c;
  for (long k = random.between(1, most); k > 0; --k) {
    integer n = random.between(-1000, 1000);
    n <<= static_cast<unsigned long>(random.between(0, 2) == 0 ? random.between(0, more_bits) : 0);
    c.push_back(n);
  }
  return c;
}

TEST(TaylorShift, IsTheBinomialExpansion) {
  random_source random(3803);
  for (repeat trial(200); trial.again();) {
    const std::vector<integer> c = any_coefficients(random, 40, 300);
    const std::vector<integer> shifted = detail::shifted_by_one(c);
    const rational_polynomial p(std::vector<rational>(c.begin(), c.end()));
    const rational_polynomial q(std::vector<rational>(shifted.begin(), shifted.end()));
    for (const long at : {-3L, -1L, 0L, 1L, 2L, 50L}) {
      EXPECT_EQ(q(rational(at)), p(rational(at + 1)));
    }
  }
  // Where the sum fills the limbs: (2^63 - 1)(1 + x)^63.
  const std::vector<integer> ones(64, (integer(1) << 63UL) - 1);
  const std::vector<integer> negative(64, -((integer(1) << 64UL) - 1));
  for (const auto& c : {ones, negative}) {
    const rational_polynomial p(std::vector<rational>(c.begin(), c.end()));
    const std::vector<integer> shifted = detail::shifted_by_one(c);
    const rational_polynomial q(std::vector<rational>(shifted.begin(), shifted.end()));
    EXPECT_EQ(q(rational(7)), p(rational(8)));
  }
}

TEST(PolynomialValues, HoldTheExactValue) {
  random_source random(3804);
  for (repeat trial(2000); trial.again();) {
    std::vector<integer> c = any_coefficients(random, 12, 120);
    c.push_back(integer(random.between(1, 9)));
    detail::polynomial_values values(c);
    const rational_polynomial p(std::vector<rational>(c.begin(), c.end()));
    rational x(random.between(-1'000'000, 1'000'000), random.between(1, 1'000'000));
    const long kind = random.between(0, 3);
    if (kind == 0) x = 1 / (x * x * x + 1);
    if (kind == 1) x = rational(random.between(-(1L << 30), 1L << 30), 1L << 30);  // kept exactly
    if (x == 0) continue;
    const ball value = values.at(x, random.between(1, 60));
    EXPECT_TRUE(contains(value, p(x)));
    EXPECT_EQ(values.sign_at(x), p(x) > 0 ? 1 : (p(x) < 0 ? -1 : 0));
  }
}

TEST(PolynomialValues, RadiusCountsWhatTheArgumentLost) {
  // c + x with x = 1 - 2^-200, of which 64 bits are kept: Y = 2^64 - 1, d = 1 - 2^-136.
  const rational x = 1 - rational(1, integer(1) << 200UL);
  for (const long bits : {1L, 30L, 62L, 90L}) {
    const std::vector<integer> c{integer(-1), (integer(1) << static_cast<unsigned long>(bits)) - 1};
    detail::polynomial_values values(c);
    const rational_polynomial p(std::vector<rational>(c.begin(), c.end()));
    EXPECT_TRUE(contains(values.at(x, 1), p(x))) << bits;
  }
}

TEST(RootBracket, HoldsTheRootAndIsNarrow) {
  random_source random(3805);
  for (repeat trial(100); trial.again();) {
    const rational_polynomial p = chebyshev(static_cast<int>(random.between(2, 30)));
    const auto found = detail::separate_real_roots(p, [] { return true; });
    ASSERT_TRUE(found.has_value());
    const rational_polynomial rest(std::vector<rational>(found->rest.begin(), found->rest.end()));
    detail::polynomial_values values(found->rest);
    const long bits = random.between(1, 300);
    for (const auto& bracket : found->brackets) {
      const auto x = detail::narrowed(values, bracket, bits);
      EXPECT_LT(rest(*x.lower) * rest(*x.upper), 0);
      EXPECT_LE(x.width() * rational(integer(1) << static_cast<unsigned long>(bits)),
                std::max(abs(*x.lower), abs(*x.upper)));
      EXPECT_TRUE(*bracket.lower <= *x.lower && *x.upper <= *bracket.upper);
    }
  }
}

}  // namespace polynomial_roots_test
}  // namespace polhode
