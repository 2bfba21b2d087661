// Zeros of analytic functions in rectangles.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/roots/complex_roots.hpp"
#include "polhode/roots/zeros_in_rectangle.hpp"
#include "support/random.hpp"

namespace polhode {
namespace zeros_in_rectangle_test {

zeros_answer zeros_of(const std::string& formula, const complex_rectangle& where, long digits) {
  return zeros_in_rectangle(parse(formula, {"z"}), where, {.digits = digits});
}

bool hold(const complex_ball& enclosure, const complex_ball& number) {
  return overlaps(enclosure.re, number.re) && overlaps(enclosure.im, number.im);
}

/// One zero of the list has the number, and is simple.
void expect_simple(const zeros_answer& found, const complex_ball& number, long digits) {
  long count = 0;
  for (const complex_zero& z : found.zeros) {
    if (!hold(z.enclosure, number)) continue;
    ++count;
    EXPECT_EQ(z.multiplicity, 1);
    EXPECT_TRUE(z.is_inside);
    const magnitude size = max(number.magnitude_upper(), magnitude::power_of_two(-400));
    const magnitude most = multiply_up(size, pow(ball(10, 64), -digits).magnitude_upper());
    EXPECT_LE(z.enclosure.re.radius(), most);
    EXPECT_LE(z.enclosure.im.radius(), most);
  }
  EXPECT_EQ(count, 1) << to_decimal(number, 10);
}

TEST(ZerosInRectangle, OfTheLogarithmsLattice) {
  // exp(z) = 3 at log 3 + 2 pi i k.
  const zeros_answer found = zeros_of("exp(z)-3", {-2, 3, -20, 20}, 40);
  EXPECT_TRUE(found.is_complete());
  ASSERT_EQ(found.zeros.size(), 7U);
  constexpr precision p = 300;
  for (long k = -3; k <= 3; ++k) {
    expect_simple(found, {log(ball(3, p)), 2 * k * pi(p)}, 40);
  }
}

TEST(ZerosInRectangle, AreRealWhereTheyAreTheirOwnConjugates) {
  const zeros_answer found = zeros_of("z*exp(z)-1", {-1, 1, -1, 1}, 30);
  EXPECT_TRUE(found.is_complete());
  ASSERT_EQ(found.zeros.size(), 1U);
  EXPECT_TRUE(found.zeros[0].enclosure.im.is_exact());
  EXPECT_TRUE(contains_zero(found.zeros[0].enclosure.im));
  EXPECT_TRUE(
      overlaps(found.zeros[0].enclosure.re, parse("0.567143290409783872999968662210355550", {})
                                                .value(120)
                                                .enlarged(magnitude::power_of_two(-115))));
}

TEST(ZerosInRectangle, CountMultiplicities) {
  const zeros_answer found = zeros_of("(1-cos(z))*(z^2+1)^3", {-7, 7, -2, 2}, 12);
  EXPECT_TRUE(found.is_complete());
  ASSERT_EQ(found.zeros.size(), 5U);
  std::vector<long> counts;
  for (const complex_zero& z : found.zeros) counts.push_back(z.multiplicity);
  EXPECT_EQ(counts, (std::vector<long>{2, 3, 2, 3, 2}));
}

TEST(ZerosInRectangle, OfTheImaginaryUnit) {
  const zeros_answer found =
      zeros_in_rectangle(parse("z^2+2*i", {"z", "i"}), {-2, 2, -2, 2}, {.digits = 20});
  EXPECT_TRUE(found.is_complete());
  ASSERT_EQ(found.zeros.size(), 2U);
  expect_simple(found, {ball(1, 200), ball(-1, 200)}, 20);
  expect_simple(found, {ball(-1, 200), ball(1, 200)}, 20);
}

TEST(ZerosInRectangle, OnTheBoundaryAreFound) {
  const zeros_answer found = zeros_of("exp(z)-1", {0, 1, 0, 7}, 10);
  EXPECT_TRUE(found.is_complete());
  ASSERT_EQ(found.zeros.size(), 2U);
  EXPECT_TRUE(found.zeros[0].is_inside);  // exactly 0
  EXPECT_FALSE(found.zeros[1].is_inside);
}

TEST(ZerosInRectangle, BesidePolesAndCuts) {
  const zeros_answer poles = zeros_of("1/(1+z^2)-z", {-2, 2, -2, 2}, 10);
  EXPECT_TRUE(poles.is_complete());
  EXPECT_EQ(poles.zeros.size(), 3U);
  for (const char* const none : {"sqrt(z)+2", "log(z)-4", "1/(1/z)", "z/z", "sin(z)/z^3", "1/z",
                                 "(z^2+1)/(z^4-1)", "z^2/z"}) {
    const zeros_answer answer = zeros_of(none, {-1, 3, -1, 1}, 10);
    EXPECT_TRUE(answer.is_complete()) << none;
    EXPECT_TRUE(answer.zeros.empty()) << none;
  }
  EXPECT_TRUE(zeros_of("exp(1/z)", {rational(1, 2), 5, -1, 1}, 10).is_complete());
  // A zero so near a pole that the two are not told apart.
  EXPECT_FALSE(zeros_of("(sin(z)-1e-40)/z", {-1, 1, -1, 1}, 10).is_complete());
  const zeros_answer fixed = zeros_of("tan(z)-z", {-5, 5, -2, 2}, 20);
  EXPECT_TRUE(fixed.is_complete());
  ASSERT_EQ(fixed.zeros.size(), 3U);
  EXPECT_EQ(fixed.zeros[1].multiplicity, 3);
  EXPECT_TRUE(fixed.zeros[1].is_one);
  EXPECT_TRUE(fixed.zeros[1].enclosure.is_exact());
}

// Zeros on a cut are not told from none: they are left open.
TEST(ZerosInRectangle, OnCutsStayUndecided) {
  struct zero_on_cut {
    const char* formula;
    std::vector<std::string> variables;
    long re;
    long im;
  };
  const std::vector<zero_on_cut> cases{{"log(z^2)+pi*z", {"z"}, 0, -1},
                                       {"log(z)+i*pi*z", {"z", "i"}, -1, 0},
                                       {"sqrt(z)-i", {"z", "i"}, -1, 0}};
  for (const zero_on_cut& c : cases) {
    for (const complex_rectangle& where :
         {complex_rectangle{-2, 2, -2, 2}, complex_rectangle{-2, 0, -2, 2},
          complex_rectangle{-2, 0, -2, 0}, complex_rectangle{0, 2, -2, 0},
          complex_rectangle{-2, 2, -2, 0}, complex_rectangle{-2, 2, 0, 2}}) {
      const bool has_zero =
          where.left <= c.re && c.re <= where.right && where.bottom <= c.im && c.im <= where.top;
      const zeros_answer found =
          zeros_in_rectangle(parse(c.formula, c.variables), where, {.digits = 10});
      if (has_zero) {
        EXPECT_FALSE(found.is_complete()) << c.formula;
      }
    }
  }
  // The logarithm is that of -2 everywhere: 0 at -log(2) - pi i, and not at the conjugate.
  EXPECT_FALSE(zeros_of("log(z/3+z/3+z/3-z-2)+z", {-2, 1, -4, -1}, 10).is_complete());
}

// A number close to a zero is not taken for it.
TEST(ZerosInRectangle, AreExactOnlyWhereTheyAre) {
  const zeros_answer near = zeros_of("z-1-1e-40", {-2, 2, -2, 2}, 10);
  ASSERT_EQ(near.zeros.size(), 1U);
  EXPECT_TRUE(contains(near.zeros[0].enclosure.re, 1 + parse_rational("1e-40")));
  const zeros_answer two = zeros_of("sin(z)*(z-1e-30)", {-2, 2, -2, 2}, 10);
  ASSERT_EQ(two.zeros.size(), 1U);
  EXPECT_EQ(two.zeros[0].multiplicity, 2);
  EXPECT_FALSE(two.zeros[0].is_one);
  const zeros_answer one = zeros_of("sin(z)*z", {-2, 2, -2, 2}, 10);
  ASSERT_EQ(one.zeros.size(), 1U);
  EXPECT_TRUE(one.zeros[0].is_one);
  // At -1 the divisor has its cut.
  const zeros_answer cut = zeros_of("(z+1)/sqrt(z)", {-3, 3, -3, 3}, 10);
  ASSERT_EQ(cut.undecided.size(), 1U);
  EXPECT_EQ(cut.undecided[0].obstacle, "the branch cut of sqrt");
  EXPECT_FALSE(zeros_of("z*exp(1/z)", {-3, 3, -3, 3}, 10).is_complete());
}

// The zeros of erf in the first quadrant (DLMF 7.13(i), table 7.13.1), and roots of gamma.
TEST(ZerosInRectangle, OfSpecialFunctions) {
  constexpr precision p = 200;
  const auto near = [](const char* re, const char* im) {
    const magnitude error = pow(ball(10, 64), -8).magnitude_upper();
    return complex_ball(parse_ball(re, p), parse_ball(im, p)).enlarged(error);
  };
  const zeros_answer of_erf = zeros_of("erf(z)", {-3, 3, -3, 3}, 30);
  EXPECT_TRUE(of_erf.is_complete());
  ASSERT_EQ(of_erf.zeros.size(), 9U);
  for (const complex_ball& number :
       {near("1.450616163", "1.880943000"), near("2.244659274", "2.616575141")}) {
    long count = 0;
    for (const complex_zero& z : of_erf.zeros) {
      EXPECT_TRUE(contains_zero(erf(z.enclosure).re));
      count += hold(z.enclosure, number) ? 1 : 0;
    }
    EXPECT_EQ(count, 1);
  }
  if (!arb_functions()->empty()) {
    const complex_rectangle strip{rational(2, 5), rational(3, 5), 14, rational(43, 2)};
    const zeros_answer of_zeta = zeros_of("zeta(z)", strip, 20);
    EXPECT_TRUE(of_zeta.is_complete());
    ASSERT_EQ(of_zeta.zeros.size(), 2U);
    EXPECT_TRUE(hold(of_zeta.zeros[0].enclosure, near("0.5", "14.13472514")));
    EXPECT_TRUE(hold(of_zeta.zeros[1].enclosure, near("0.5", "21.02203964")));
  }
  const zeros_answer of_gamma = zeros_of("gamma(z)-6", {rational(1, 8), 5, -3, 3}, 40);
  EXPECT_TRUE(of_gamma.is_complete());
  ASSERT_EQ(of_gamma.zeros.size(), 2U);
  expect_simple(of_gamma, complex_ball(ball(4, p)), 40);
  const zeros_answer of_logarithm = zeros_of("log_gamma(z)", {rational(1, 8), 5, -3, 3}, 30);
  EXPECT_TRUE(of_logarithm.is_complete());
  ASSERT_EQ(of_logarithm.zeros.size(), 2U);
  expect_simple(of_logarithm, complex_ball(ball(1, p)), 30);
  expect_simple(of_logarithm, complex_ball(ball(2, p)), 30);
}

// 1/gamma is 0 at the poles of gamma in the limit, where the formula has no value.
TEST(ZerosInRectangle, AtPolesOfDivisorsStayUndecided) {
  for (const char* formula :
       {"1/gamma(z)", "exp(z)/gamma(z)^2", "sin(z)/gamma(z)", "(z-1/3)/gamma(z)",
        "sqrt(z+5)/(gamma(z)*log(z))", "sqrt(z)/gamma(z)", "log(z-9)/gamma(z)"}) {
    const zeros_answer found = zeros_of(formula, {rational(-3, 2), 1, -1, 1}, 10);
    EXPECT_FALSE(found.is_complete()) << formula;
    for (const long pole : {0L, -1L}) {
      EXPECT_TRUE(std::ranges::any_of(found.undecided,
                                      [&](const undecided_rectangle& u) {
                                        return u.where.left <= pole && pole <= u.where.right &&
                                               u.where.bottom <= 0 && 0 <= u.where.top;
                                      }))
          << formula << ' ' << pole;
    }
  }
  const zeros_answer right = zeros_of("(z-1/3)/gamma(z)", {rational(1, 8), 1, -1, 1}, 10);
  EXPECT_TRUE(right.is_complete());
  ASSERT_EQ(right.zeros.size(), 1U);
}

TEST(ZerosInRectangle, RefuseWhatIsNotAnalytic) {
  EXPECT_THROW((void)zeros_of("abs(z)-1", {-2, 2, -2, 2}, 10), input_error);
  EXPECT_THROW((void)zeros_of("z-z", {-2, 2, -2, 2}, 10), input_error);
  EXPECT_THROW((void)zeros_of("z", {2, 2, -2, 2}, 10), input_error);
  EXPECT_THROW((void)zeros_of("z", {-2, 2, -2, 2}, 0), std::invalid_argument);
}

TEST(ZerosInRectangle, EndWhenTheyAreAskedTo) {
  zeros_options how{.digits = 10};
  how.most_parts = 10;
  const zeros_answer few = zeros_in_rectangle(parse("sin(z^2)", {"z"}), {-5, 5, -5, 5}, how);
  EXPECT_FALSE(few.is_complete());
}

/// Random polynomials, beside the roots by discs (complex_roots.hpp): a number of them in the
/// rectangle.
TEST(ZerosInRectangle, AreThoseOfPolynomials) {
  support::random_source random(20261126);
  for (support::repeat trial(12); trial.again();) {
    std::vector<rational> c;
    const long degree = random.between(1, 9);
    for (long n = 0; n <= degree; ++n) {
      c.emplace_back(random.between(-9, 9), random.between(1, 4));
    }
    if (c.back() == 0) c.back() = 1;
    const rational_polynomial p(c);
    std::string formula;
    for (std::size_t n = 0; n < c.size(); ++n) {
      formula += "+(" + to_text(c[n]) + ")*z^" + std::to_string(n);
    }
    const complex_rectangle where{
        rational(random.between(-20, -1), 7), rational(random.between(1, 20), 7),
        rational(random.between(-20, -1), 7), rational(random.between(1, 20), 7)};
    SCOPED_TRACE(formula);
    const zeros_answer found = zeros_of(formula, where, 15);
    EXPECT_TRUE(found.is_complete());
    long inside = 0;
    for (const complex_root& r : complex_roots(p, 20).roots) {
      const bool is_in = lower_rational(r.enclosure.re) > where.left &&
                         upper_rational(r.enclosure.re) < where.right &&
                         lower_rational(r.enclosure.im) > where.bottom &&
                         upper_rational(r.enclosure.im) < where.top;
      if (!is_in) continue;
      inside += r.multiplicity;
      long count = 0;
      for (const complex_zero& z : found.zeros) count += hold(z.enclosure, r.enclosure) ? 1 : 0;
      EXPECT_EQ(count, 1) << to_decimal(r.enclosure, 10);
    }
    long counted = 0;
    for (const complex_zero& z : found.zeros) counted += z.is_inside ? z.multiplicity : 0;
    EXPECT_EQ(counted, inside);
  }
}

}  // namespace zeros_in_rectangle_test
}  // namespace polhode
