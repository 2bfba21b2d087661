// All complex roots of polynomials: each known root is in its enclosure, and the enclosures
// multiplied out hold the coefficients.

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/roots/complex_roots.hpp"
#include "roots/polynomial/complex_values.hpp"
#include "support/random.hpp"

namespace polhode {
namespace complex_roots_test {

using support::random_source;
using support::repeat;

rational_polynomial polynomial(const std::string& text) { return *parse(text).polynomial(); }

/// What is wrong with the answer; "" where nothing is.
std::string error_in(const complex_roots_answer& a, const rational_polynomial& p, long digits) {
  if (!a.complete) return "not complete";
  long count = 0;
  std::vector<complex_ball> product{complex_ball(ball(p.leading(), 400))};  // 1, x, x^2, ...
  for (std::size_t i = 0; i < a.roots.size(); ++i) {
    const complex_root& r = a.roots[i];
    count += r.multiplicity;
    for (std::size_t j = 0; j < i; ++j) {
      const complex_ball& other = a.roots[j].enclosure;
      if (overlaps(r.enclosure.re, other.re) && overlaps(r.enclosure.im, other.im)) {
        return "two enclosures overlap";
      }
    }
    const magnitude size = r.enclosure.magnitude_upper();
    if (max(r.enclosure.re.radius(), r.enclosure.im.radius()) >
        scale(size, -bits_for_digits(digits))) {
      return "an enclosure is wide";
    }
    if (r.exact && p(*r.exact) != 0) return "an exact root is none";
    for (long k = 0; k < r.multiplicity; ++k) {
      product.insert(product.begin(), complex_ball(ball(0, 400)));
      for (std::size_t j = 0; j + 1 < product.size(); ++j) {
        product[j] -= r.enclosure * product[j + 1];
      }
    }
  }
  if (count != p.degree()) return "not as many as the degree";
  for (std::size_t k = 0; k < product.size(); ++k) {
    if (!contains(product[k].re, p.coefficients()[k]) || !contains(product[k].im, rational(0))) {
      return "the product is another polynomial";
    }
  }
  return "";
}

TEST(ComplexRoots, HoldRootsThatAreKnown) {
  random_source random(3811);
  for (repeat trial(100); trial.again();) {
    // Pairs a +- ib, b not 0, of sizes that differ.
    std::vector<std::pair<rational, rational>> known;
    rational_polynomial p({rational(random.between(1, 5), 3)});
    std::vector<long> multiplicities;
    for (long k = random.between(1, 6); k > 0; --k) {
      rational scale = 1;
      if (random.between(0, 3) == 0) {
        const integer power = integer(1) << static_cast<unsigned long>(random.between(1, 150));
        scale = random.between(0, 1) == 0 ? rational(power) : rational(1, power);
      }
      rational a = rational(random.between(-20, 20), random.between(1, 9)) * scale;
      rational b = rational(random.between(1, 20), random.between(1, 9)) * scale;
      if (!known.empty() && random.between(0, 3) == 0) {  // near the last one
        a = known.back().first + a / (integer(1) << 90UL);
        b = known.back().second + b / (integer(1) << 90UL);
      }
      const std::pair<rational, rational> root(a, b);
      if (b == 0 || std::find(known.begin(), known.end(), root) != known.end()) continue;
      known.push_back(root);
      multiplicities.push_back(random.between(0, 4) == 0 ? 2 : 1);
      for (long m = 0; m < multiplicities.back(); ++m) {
        p = p * rational_polynomial({rational(a * a + b * b), rational(-2 * a), rational(1)});
      }
    }
    if (random.between(0, 1) == 0) p = p * polynomial("x^3-2");
    // Real roots, two of them near each other, or near a pair: the middle -+ sqrt(2 or 3) delta.
    if (random.between(0, 2) == 0 && !known.empty()) {
      const rational middle = random.one_in(2) ? known.back().first : rational(1, 3);
      const rational delta(1, integer(1) << static_cast<unsigned long>(random.between(0, 400)));
      const rational square = delta * delta * random.between(2, 3);
      p = p * rational_polynomial({middle * middle - square, rational(-2 * middle), rational(1)});
    }
    const long digits = random.between(5, 60);
    const complex_roots_answer found = complex_roots(p, digits);
    EXPECT_EQ(error_in(found, p, digits), "");
    for (std::size_t i = 0; i < known.size(); ++i) {
      const auto& [a, b] = known[i];
      for (const int sign : {-1, 1}) {
        long holders = 0;
        for (const complex_root& r : found.roots) {
          if (!contains(r.enclosure.re, a) || !contains(r.enclosure.im, rational(sign * b)))
            continue;
          ++holders;
          EXPECT_EQ(r.multiplicity, multiplicities[i]);
          EXPECT_FALSE(r.is_real());
        }
        EXPECT_EQ(holders, 1);
      }
    }
  }
}

TEST(ComplexRoots, OfRandomPolynomialsMultiplyToThem) {
  random_source random(3812);
  for (repeat trial(60); trial.again();) {
    std::vector<rational> c;
    for (long k = random.between(1, 30); k >= 0; --k) {
      c.emplace_back(random.between(0, 4) == 0 ? 0 : random.between(-1000, 1000),
                     random.between(1, 50));
    }
    c.emplace_back(random.between(1, 1000));
    const rational_polynomial p(c);
    EXPECT_EQ(error_in(complex_roots(p, 50), p, 50), "");
  }
}

TEST(ComplexRoots, OfTheBattery) {
  for (const char* text :
       {"x^50-2*(10^10*x-1)^2", "x", "x-7", "x^2+1", "x^5", "x^4+1", "x^60-1", "x^40+x+1",
        "(x^2+1)^3*(x-2)^2*x", "(10^20*x^2-3)^2+10^20*x^9", "x^12-(10^5*x^2+1)^2", "x^2+10^600",
        "10^600*x^2+1", "(x^2+1)*(x^2+1+1/10^60)", "(x^2+1)*(x^2+1+1/10^60)^2", "x^20+1048576",
        "(x-1)^20+1/10^20"}) {
    const rational_polynomial p = polynomial(text);
    EXPECT_EQ(error_in(complex_roots(p, 40), p, 40), "") << text;
  }
  EXPECT_EQ(complex_roots(polynomial("3"), 10).roots.size(), 0U);
  EXPECT_THROW((void)complex_roots(rational_polynomial(), 10), input_error);
  EXPECT_THROW((void)complex_roots(polynomial("x"), 0), std::invalid_argument);
}

TEST(ComplexRoots, ToManyDigits) {
  const complex_roots_answer found = complex_roots(polynomial("x^2+x+1"), 3000);
  ASSERT_EQ(found.roots.size(), 2U);
  const ball im = sqrt(ball(3, 12'000)) / 2;
  EXPECT_TRUE(overlaps(found.roots[1].enclosure.im, im));
  EXPECT_TRUE(contains(found.roots[1].enclosure.re, rational(-1, 2)));
  EXPECT_LE(found.roots[1].enclosure.im.radius(), magnitude::power_of_two(-bits_for_digits(3000)));
}

TEST(ComplexRoots, StopWhereTheyAreAskedTo) {
  long calls = 0;
  const auto found = complex_roots(polynomial("x^30+x+1"), 30, [&](long) { return ++calls < 20; });
  EXPECT_FALSE(found.complete);
}

TEST(FixedValue, SizesAreBounds) {
  // What is cut off counts, though the leading bits are those of a power of two.
  const integer power = integer(1) << 100UL;
  for (const integer& n : {integer(power + 1), integer(-power - 1), integer(power - 1), power}) {
    const detail::fixed_value v{n, 0, {}};
    const ball size = abs(ball(n, 200));
    EXPECT_GE(v.abs_upper(), ball(size).magnitude_lower());
    EXPECT_LE(v.abs_lower(), ball(size).magnitude_upper());
  }
  EXPECT_GT((detail::fixed_value{power + 1, 0, {}}.abs_upper()), magnitude::power_of_two(100));
  EXPECT_LT((detail::fixed_value{power - 1, 0, {}}.abs_lower()), magnitude::power_of_two(100));
}

TEST(ComplexValues, HoldTheExactValues) {
  random_source random(3813);
  for (repeat trial(500); trial.again();) {
    std::vector<integer> c;
    for (long k = random.between(1, 10); k >= 0; --k) c.emplace_back(random.between(-9, 9));
    c.front() += 20;
    c.emplace_back(random.between(1, 9));
    const long bits = random.between(4, 40);
    detail::fixed_point u;
    const long most = (1L << bits) / 2;
    u.re = random.between(-most, most);
    u.im = random.between(-most, most);
    u.is_reciprocal = random.between(0, 1) == 1;
    if (random.between(0, 3) == 0) {  // on the unit circle, but for rounding, or beyond it
      u.re = (1L << bits) + random.between(-1, 1);
      u.im = random.between(0, 2) == 0 ? random.between(-most, most) : random.between(-2, 2);
    }
    if (u.re == 0 && u.im == 0) continue;
    detail::complex_values values(c);
    const detail::complex_values::values v = values.at(u, bits);
    // Exactly, in rationals.
    const integer unit = integer(1) << static_cast<unsigned long>(bits);
    const rational x(u.re, unit);
    const rational y(u.im, unit);
    std::vector<integer> in_order = c;
    if (u.is_reciprocal) std::reverse(in_order.begin(), in_order.end());
    rational re = 0;
    rational im = 0;
    rational slope_re = 0;
    rational slope_im = 0;
    for (std::size_t k = in_order.size(); k-- > 0;) {
      const rational s = slope_re * x - slope_im * y + re;
      slope_im = slope_re * y + slope_im * x + im;
      slope_re = s;
      const rational r = re * x - im * y + rational(in_order[k]);
      im = re * y + im * x;
      re = r;
    }
    const auto is_near = [&](const rational& a, const rational& b, const detail::fixed_value& w) {
      const rational dx = a * unit - rational(w.re);
      const rational dy = b * unit - rational(w.im);
      const ball distance = sqrt(ball(dx * dx + dy * dy, 100));
      return distance.magnitude_lower() <= w.error;
    };
    EXPECT_TRUE(is_near(re, im, v.value));
    EXPECT_TRUE(is_near(slope_re, slope_im, v.slope));
    // |p(x)| is at most its bound.
    complex_ball z(ball(x, 200), ball(y, 200));
    if (u.is_reciprocal) z = reciprocal(z);
    complex_ball p(ball(0, 200));
    for (std::size_t k = c.size(); k-- > 0;) p = p * z + rational(c[k]);
    EXPECT_LE(p.magnitude_lower(), values.value_bound(u, v, bits));
    EXPECT_TRUE(overlaps(detail::to_ball(u, bits, 100).re, z.re));
    EXPECT_TRUE(overlaps(detail::to_ball(u, bits, 100).im, z.im));
  }
}

}  // namespace complex_roots_test
}  // namespace polhode
