// Certified roots: what is proved, what must never be, and what it costs.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "polhode/arithmetic/text.hpp"
#include "polhode/roots/newton.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace newton_test {

using support::agrees;
using support::as_narrow_as;

ball box_of(const rational& low, const rational& high, precision p = 64) {
  return hull(ball(low, p), ball(high, p));
}

const auto square_minus_two = [](const ball& x) { return square(x) - 2; };
const auto twice = [](const ball& x) { return 2 * x; };

TEST(RefineRoot, OfSimpleRoots) {
  for (const precision p : {20L, 53L, 64L, 192L}) {
    const auto root = [p](const auto& f, const auto& derivative, const ball& box) {
      const root_enclosure result = refine_root(f, derivative, box, p);
      EXPECT_EQ(result.verdict, root_verdict::unique) << p;
      EXPECT_TRUE(contains(box, result.root)) << p;
      EXPECT_TRUE(as_narrow_as(result.root, p - 4)) << p;
      EXPECT_FALSE(contains_zero(result.derivative));
      EXPECT_TRUE(contains(result.box, result.image));
      return result.root;
    };
    // mpmath 1.3.0: sqrt(2), findroot of cos x - x, log(2).
    EXPECT_TRUE(agrees(root(square_minus_two, twice, box_of(1, 2)),
                       "1.41421356237309504880168872420969807856967187537694807317668",
                       (p - 8) / 4));
    EXPECT_TRUE(agrees(root([](const ball& x) { return cos(x) - x; },
                            [](const ball& x) { return -sin(x) - 1; }, box_of(0, 1)),
                       "0.739085133215160641655312087673873404013411758900757464965681",
                       (p - 8) / 4));
    EXPECT_TRUE(agrees(root([](const ball& x) { return exp(x) - 2; },
                            [](const ball& x) { return exp(x); }, box_of(0, 1)),
                       "0.693147180559945309417232121458176568075500134360255254120680",
                       (p - 8) / 4));
    // A decreasing f, a negative root.
    EXPECT_TRUE(agrees(root(square_minus_two, twice, box_of(-2, -1)),
                       "-1.41421356237309504880168872420969807856967187537694807317668",
                       (p - 8) / 4));
  }
}

TEST(RefineRoot, EnclosesRationalRootsExactly) {
  // x^3 - x - x_0^3 + x_0 and its like: the root x_0 is in the enclosure, decided in rationals.
  for (const rational& r : {rational(1, 3), rational(5, 4), rational(-7, 5), rational(1),
                            rational(0), rational(1, 1000000), rational(-3, 1 << 20)}) {
    const auto f = [&](const ball& x) { return (x - r) * (square(x) + 1); };
    const auto derivative = [&](const ball& x) { return square(x) + 1 + 2 * x * (x - r); };
    for (const precision p : {30L, 64L, 500L}) {
      const ball box = box_of(r - rational(1, 3), r + rational(1, 4));
      const root_enclosure result = refine_root(f, derivative, box, p);
      EXPECT_EQ(result.verdict, root_verdict::unique) << r << " " << p;
      EXPECT_TRUE(support::holds(result.root, r)) << p;
      EXPECT_TRUE(result.root.radius() <= magnitude::power_of_two(1 - (p - 4))) << r << " " << p;
    }
  }
}

TEST(RefineRoot, StopsAtTheRootZero) {
  // No enclosure of 0 is narrow beside its own size: the goal is the box's.
  for (const auto& [low, high] :
       {std::pair{rational(-1, 2), rational(1, 4)}, std::pair{rational(-1, 3), rational(1, 3)},
        std::pair{rational(-1, 1000), rational(1, 2)}}) {
    const root_enclosure result =
        refine_root([](const ball& x) { return sin(x) + x * x; },
                    [](const ball& x) { return cos(x) + 2 * x; }, box_of(low / 2, high / 2), 256);
    EXPECT_EQ(result.verdict, root_verdict::unique);
    EXPECT_TRUE(contains(result.root, 0L));
    EXPECT_TRUE(result.root.radius() <= magnitude::power_of_two(-252));
    EXPECT_LE(result.evaluations_of_f, 16);
  }
  // At the end of its box a root cannot be proved so, at 0 as elsewhere; the work is limited.
  const root_enclosure at_end =
      refine_root([](const ball& x) { return sin(x); }, [](const ball& x) { return cos(x); },
                  box_of(0, rational(1, 2)), 256);
  EXPECT_EQ(at_end.verdict, root_verdict::unresolved);
  EXPECT_TRUE(contains(at_end.root, 0L));
  EXPECT_LE(at_end.evaluations_of_f, 20);
}

TEST(RefineRoot, AtDyadicPointsAndEndPoints) {
  const auto f = [](const ball& x) { return square(x) - 1; };
  // The middle of the box is the root: f is exactly 0 there.
  const root_enclosure middle = refine_root(f, twice, box_of(rational(1, 2), rational(3, 2)), 100);
  EXPECT_EQ(middle.verdict, root_verdict::unique);
  EXPECT_TRUE(contains(middle.root, 1L));
  EXPECT_TRUE(middle.root.is_exact());
  // The end of the box is: the Newton image reaches beyond it, so nothing is proved; nothing is
  // lost.
  for (const auto& [low, high] : {std::pair{1L, 2L}, std::pair{-2L, -1L}}) {
    const root_enclosure end = refine_root(f, twice, box_of(low, high), 100);
    EXPECT_NE(end.verdict, root_verdict::none);
    EXPECT_TRUE(contains(end.root, low == 1 ? 1L : -1L));
  }
  // A box that is one point: the root itself, beside it, and a point where f is only about 0.
  EXPECT_EQ(refine_root(f, twice, ball(1, 64), 100).verdict, root_verdict::unique);
  EXPECT_EQ(refine_root(f, twice, ball(rational(3, 2), 64), 100).verdict, root_verdict::none);
  const auto sine = [](const ball& x) { return sin(pi(x.precision()) * x); };
  const auto cosine = [](const ball& x) { return pi(x.precision()) * cos(pi(x.precision()) * x); };
  const root_enclosure about = refine_root(sine, cosine, ball(1, 64), 100);
  EXPECT_EQ(about.verdict, root_verdict::unresolved);
  EXPECT_TRUE(contains(about.root, 1L));
}

TEST(RefineRoot, ProvesARootInABoxThatIsNarrowerThanItsGoal) {
  for (const long bits : {30L, 54L, 100L, 500L}) {
    const ball box = sqrt(ball(2, bits + 8)).enlarged(magnitude::power_of_two(-bits));
    for (const precision p : {10L, 20L, 64L}) {
      const root_enclosure result = refine_root(square_minus_two, twice, box, p);
      EXPECT_EQ(result.verdict, root_verdict::unique) << bits << " " << p;
      EXPECT_LE(result.evaluations_of_f, 4) << bits << " " << p;
    }
  }
}

TEST(RefineRoot, ProvesThatThereIsNone) {
  EXPECT_EQ(refine_root(square_minus_two, twice, box_of(2, 3), 100).verdict, root_verdict::none);
  EXPECT_EQ(
      refine_root(square_minus_two, twice, box_of(rational(1), rational(141, 100)), 100).verdict,
      root_verdict::none);
  EXPECT_EQ(refine_root([](const ball& x) { return exp(x); }, [](const ball& x) { return exp(x); },
                        box_of(-3, 1), 100)
                .verdict,
            root_verdict::none);
  // Below 64 bits nothing tells the root's neighbour from it; the precision asked for decides.
  const ball beside = ball::from_midpoint_radius(
      midpoint(sqrt(ball(2, 300)) + scale(ball(1, 300), -200)).backend().data(),
      magnitude::power_of_two(-210));
  EXPECT_EQ(refine_root(square_minus_two, twice, beside, 300).verdict, root_verdict::none);
}

TEST(RefineRoot, ProvesNothingOfWhatItCannot) {
  const auto unresolved = [](const auto& f, const auto& derivative, const ball& box) {
    const root_enclosure result = refine_root(f, derivative, box, 100);
    EXPECT_EQ(result.verdict, root_verdict::unresolved);
    EXPECT_LE(result.evaluations_of_f, 20);
  };
  // A double root, inside and at an end; a triple one.
  const auto double_root = [](const ball& x) { return square(x - rational(1, 3)); };
  const auto double_slope = [](const ball& x) { return 2 * (x - rational(1, 3)); };
  unresolved(double_root, double_slope, box_of(0, 1));
  unresolved(double_root, double_slope, box_of(rational(1, 3), 1));
  unresolved([](const ball& x) { return pow(x, 3); }, [](const ball& x) { return 3 * square(x); },
             box_of(rational(-1, 2), 1));
  // A derivative that vanishes in the box, with one root, two roots or none.
  unresolved(square_minus_two, twice, box_of(-1, 2));
  unresolved(square_minus_two, twice, box_of(-2, 2));
  unresolved([](const ball& x) { return square(x) + 1; }, twice, box_of(-1, 2));
  // f or its derivative is not defined on the box, or the box is no bounded set.
  unresolved([](const ball& x) { return log(x); }, [](const ball& x) { return 1 / x; },
             box_of(-2, -1));
  unresolved([](const ball& x) { return log(x); }, [](const ball& x) { return 1 / x; },
             box_of(-1, 3));
  unresolved(square_minus_two, twice, ball::entire(64));
  unresolved(square_minus_two, twice, ball::undefined(64));
  unresolved([](const ball& x) { return ball::undefined(x.precision()); }, twice, box_of(1, 2));
  unresolved(
      square_minus_two, [](const ball& x) { return ball::undefined(x.precision()); }, box_of(1, 2));
  unresolved([](const ball& x) { return ball::entire(x.precision()); }, twice, box_of(1, 2));
}

TEST(RefineRoot, DoesNotTakeAJumpForARoot) {
  // 2x + arctan(1/x) jumps from below 0 to above 0 at x = 0 and has no root; 2 - 1/(1 + x^2)
  // continues its derivative across 0, and Newton's image of the box lies inside it.
  const auto f = [](const ball& x) { return 2 * x + atan(1 / x); };
  const auto derivative = [](const ball& x) { return 2 - 1 / (1 + square(x)); };
  for (const auto& [low, high] : {std::pair{-2L, 3L}, std::pair{-3L, 2L}, std::pair{-3L, 5L}}) {
    const ball box = box_of(low, high);
    const newton_step step = interval_newton_step(f, derivative, box, 64);
    ASSERT_TRUE(contains(box, step.image));
    EXPECT_EQ(refine_root(f, derivative, box, 100).verdict, root_verdict::unresolved);
  }
}

TEST(RefineRoot, DoesNotTakeANeighbourForARoot) {
  // The box begins 2^-330 above sqrt(2): nothing at 316 bits tells its end from the root. It is of
  // 400 bits, and is rounded outward for the derivative, so that its rounded form holds the root
  // and the Newton image.
  const ball above =
      ball(upper_rational(sqrt(ball(2, 329)).enlarged(magnitude::power_of_two(-331))), 400);
  for (const long width : {-200L, -150L, -100L}) {
    const ball box = hull(above, above + scale(ball(1, 400), width));
    EXPECT_NE(refine_root(square_minus_two, twice, box, 300).verdict, root_verdict::unique)
        << width;
  }
}

TEST(RefineRoot, IsRightAboutRandomPolynomials) {
  // (x - r)(x - s) and (x - r)^2 (x - s) with rational roots, in random boxes: the verdicts are
  // decided in rationals.
  support::random_source random(3);
  long proved = 0;
  long excluded = 0;
  for (support::repeat trial(3000); trial.again();) {
    const auto any = [&] { return rational(random.between(-40, 40), random.between(1, 16)); };
    const rational r = any();
    const rational s = random.one_in(8) ? r : any();
    const bool cubic = random.one_in(3);
    rational low = any();
    rational high = random.one_in(3) ? r : any();
    if (random.one_in(3)) {  // around a root
      const rational& near = random.one_in(2) ? r : s;
      low = near - rational(random.between(0, 9), random.between(1, 60));
      high = near + rational(random.between(0, 9), random.between(1, 60));
    }
    if (high < low) std::swap(low, high);
    const ball box = box_of(low, high, random.between(24, 100));
    const auto f = [&](const ball& x) {
      return cubic ? square(x - r) * (x - s) : (x - r) * (x - s);
    };
    const auto derivative = [&](const ball& x) {
      return cubic ? (x - r) * (3 * x - (r + 2 * s)) : 2 * x - (r + s);
    };
    const root_enclosure result = refine_root(f, derivative, box, random.between(8, 200));
    const support::exact_set whole = support::exact(box);
    const bool has_r = whole.holds(r);
    const bool has_s = whole.holds(s);
    if (result.verdict == root_verdict::unique) {
      ++proved;
      const bool one_simple_root = r != s && (cubic ? has_s && !has_r : has_r != has_s);
      EXPECT_TRUE(one_simple_root) << r << " " << s << " in " << support::described(box);
      EXPECT_TRUE(support::holds(result.root, has_s ? s : r));
    } else if (result.verdict == root_verdict::none) {
      ++excluded;
      EXPECT_FALSE(has_r || has_s) << r << " " << s << " in " << support::described(box);
    } else {
      if (has_r) {
        EXPECT_TRUE(support::holds(result.root, r));
      }
      if (has_s) {
        EXPECT_TRUE(support::holds(result.root, s));
      }
    }
    EXPECT_LE(result.evaluations_of_f, 40);
  }
  EXPECT_GT(proved, 300 * support::effort() / 2);
  EXPECT_GT(excluded, 300 * support::effort() / 2);
}

TEST(RefineRoot, DoublesThePrecision) {
  // One evaluation with all bits, one with half of them, and so on: the counts are pinned.
  const precision p = bits_for_digits(10'000) + 16;
  std::vector<precision> at_points;
  std::vector<precision> over_boxes;
  std::vector<precision> of_derivative;
  const auto f = [&](const ball& x) {
    (x.is_exact() ? at_points : over_boxes).push_back(x.precision());
    return square(x) - 2;
  };
  const auto derivative = [&](const ball& x) {
    of_derivative.push_back(x.precision());
    return 2 * x;
  };
  const root_enclosure result = refine_root(f, derivative, box_of(1, 2), p);
  ASSERT_EQ(result.verdict, root_verdict::unique);
  EXPECT_TRUE(as_narrow_as(result.root, p - 4));
  const rational low = support::exact(result.root).lower.value();
  const rational high = support::exact(result.root).upper.value();
  EXPECT_TRUE(low * low < 2 && high * high > 2);
  EXPECT_EQ(to_decimal_enclosure(result.root, 10'000).digits, 10'000);

  EXPECT_EQ(std::count_if(at_points.begin(), at_points.end(),
                          [&](precision q) { return q > p / 2 + 100; }),
            1);
  EXPECT_EQ(std::count_if(at_points.begin(), at_points.end(),
                          [&](precision q) { return q > p / 4 + 100; }),
            2);
  EXPECT_EQ(at_points.back(), p + 16);
  EXPECT_LE(at_points.size(), 15U);
  EXPECT_EQ(over_boxes.size(), 1U);
  EXPECT_LE(over_boxes.front(), 64);
  EXPECT_EQ(of_derivative.size(), at_points.size());
  EXPECT_LE(of_derivative.back(), p / 2 + 64);
  EXPECT_EQ(static_cast<std::size_t>(result.evaluations_of_f),
            at_points.size() + over_boxes.size());
  EXPECT_EQ(static_cast<std::size_t>(result.evaluations_of_derivative), of_derivative.size());
  precision sum = 0;
  for (const precision q : at_points) sum += q;
  EXPECT_LE(sum, 2 * p + 2000);
}

TEST(RefineRoot, SaysWhenItsHypothesesContradictEachOther) {
  // A derivative that is wrong after uniqueness was "proved" is no verdict but a fault.
  int calls = 0;
  const auto lying = [&](const ball& x) { return ++calls > 3 ? ball(1000, x.precision()) : 2 * x; };
  const auto f = [](const ball& x) { return square(x) - 2; };
  const root_enclosure honest = refine_root(f, twice, box_of(1, 2), 2000);
  ASSERT_EQ(honest.verdict, root_verdict::unique);
  try {
    const root_enclosure result = refine_root(f, lying, box_of(1, 2), 2000);
    EXPECT_TRUE(overlaps(result.root, honest.root));
  } catch (const std::logic_error&) {
    SUCCEED();
  }
}

TEST(IntervalNewtonStep, IsTheFormula) {
  // N([1, 2]) for x^2 - 2: 3/2 - (1/4)/[2, 4] = [11/8, 23/16].
  const newton_step step = interval_newton_step(square_minus_two, twice, box_of(1, 2), 64);
  EXPECT_TRUE(support::holds(step.image, rational(11, 8)));
  EXPECT_TRUE(support::holds(step.image, rational(23, 16)));
  EXPECT_TRUE(contains(
      box_of(rational(11, 8) - rational(1, 1L << 40), rational(23, 16) + rational(1, 1L << 40)),
      step.image));
  EXPECT_TRUE(
      interval_newton_step(square_minus_two, twice, box_of(-1, 2), 64).image.is_undefined());
}

TEST(Newton, UncertifiedAgreesWithCertified) {
  const auto f = [](const mpfr_float& x) -> mpfr_float { return x * x - 2; };
  const auto derivative = [](const mpfr_float& x) -> mpfr_float { return 2 * x; };
  const mpfr_float start = midpoint(ball::exactly(1.4142135623730951));
  for (const precision p : {60L, 100L, 1000L, 33'240L}) {
    const mpfr_float x = newton(f, derivative, start, 50, p);
    EXPECT_GE(precision_of(x), p);
    const root_enclosure certified = refine_root(square_minus_two, twice, box_of(1, 2), p + 64);
    ASSERT_EQ(certified.verdict, root_verdict::unique);
    EXPECT_TRUE((ball(x) - certified.root).magnitude_upper() <= magnitude::power_of_two(2 - p))
        << p;
  }
  // A start that is good enough is the answer.
  EXPECT_EQ(newton(f, derivative, start, 100, 60), start);
}

}  // namespace newton_test
}  // namespace polhode
