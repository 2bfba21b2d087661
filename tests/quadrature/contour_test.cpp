// Integrals along paths in the complex plane: closed forms, Cauchy's theorem, and every refusal.

#include <gtest/gtest.h>

#include "polhode/arithmetic/analytic_ball.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/contour.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace contour_test {

using support::power_of_ten;
using support::to_rational;

complex_ball number(long re, long im, precision p) { return {re, im, p}; }
end_point multiple_of_pi(const rational& q) {
  return end_point([q](precision p) { return pi(p) * q; });
}

struct known_contour_integral {
  std::string name;
  std::function<contour_integral(const integrate_options&)> run;
  std::function<complex_ball(precision)> value;
};

template <class F>
known_contour_integral known(std::string name, F f, path along,
                             std::function<complex_ball(precision)> value) {
  return {std::move(name),
          [f, along = std::move(along)](const integrate_options& options) {
            return integrate_along(f, along, options);
          },
          std::move(value)};
}

/// The enclosure holds the value, which is given so narrowly that it must lie inside as a whole;
/// where a part of the enclosure is one number: meets it.
::testing::AssertionResult holds(const contour_integral& i, const complex_ball& value) {
  const auto part_holds = [](const ball& whole, const ball& part) {
    return whole.is_exact() ? overlaps(whole, part) : contains(whole, part);
  };
  const complex_ball& z = i.enclosure;
  if (z.is_bounded() && part_holds(z.re, value.re) && part_holds(z.im, value.im)) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << z << " for " << value << ' ' << i.obstacle;
}

/// Certified, right, and with radii of at most 10^-digits of the value's size.
::testing::AssertionResult right(const known_contour_integral& k, long digits) {
  const contour_integral i = k.run({.digits = digits});
  const auto failure = [&] {
    return ::testing::AssertionFailure() << k.name << " to " << digits << " digits: ";
  };
  if (i.verdict != status::certified || i.why != reason::none || !i.obstacle.empty()) {
    return failure() << to_text(i.verdict) << ", " << to_text(i.why) << ": " << i.obstacle;
  }
  const complex_ball value = k.value(bits_for_digits(2 * digits) + 300);
  if (const auto held = holds(i, value); !held) return failure() << held.message();
  const rational size = to_rational(value.magnitude_upper());
  for (const ball* part : {&i.enclosure.re, &i.enclosure.im}) {
    const rational radius = to_rational(part->radius());
    if (radius * power_of_ten(digits) > size * rational(1001, 1000)) return failure() << "too wide";
  }
  return ::testing::AssertionSuccess();
}

complex_ball i_times(const ball& x) { return {ball(0, x.precision()), x}; }

/// f'/f of f = z^5 + z + 1, whose zeros are exp(+-2 pi i/3) and those of z^3 - z^2 + 1.
constexpr auto logarithmic_derivative = [](const auto& z) {
  return (5 * pow(z, 4) + 1) / (pow(z, 5) + z + 1);
};

std::vector<known_contour_integral> closed_forms() {
  const path_point one(1);
  const path_point i(0, 1);
  const path_point minus_one_and_i(-1, 1);
  const path corner = path::polygon({one, path_point(1, 1), minus_one_and_i});
  const path half_turn = path::arc(0, 1, 0, multiple_of_pi(1));
  const path unit_circle = path::circle(0, 1);
  std::vector<known_contour_integral> all;
  // By residues.
  all.push_back(known(
      "e^z/z^3 around 0: 2 pi i/2!", [](const auto& z) { return exp(z) / pow(z, 3); }, unit_circle,
      [](precision p) { return i_times(pi(p)); }));
  all.push_back(known(
      "1/(z^2+1) around i: 2 pi i/(2i)", [](const auto& z) { return 1 / (z * z + 1); },
      path::circle(i, rational(1, 2)), [](precision p) { return complex_ball(pi(p)); }));
  all.push_back(known("zeros of z^5+z+1 in |z| < 2: 2 pi i 5", logarithmic_derivative,
                      path::circle(0, 2), [](precision p) { return i_times(10 * pi(p)); }));
  all.push_back(known("zeros of z^5+z+1 in |z-1| < 1: 2 pi i 2", logarithmic_derivative,
                      path::circle(1, 1), [](precision p) { return i_times(4 * pi(p)); }));
  all.push_back(known(
      "e^(1/z) around 0: 2 pi i", [](const auto& z) { return exp(1 / z); }, unit_circle,
      [](precision p) { return i_times(2 * pi(p)); }));
  all.push_back(known(
      "cot around pi, in a square: 2 pi i", [](const auto& z) { return cos(z) / sin(z); },
      path::polygon({path_point(2, -1), path_point(4, -1), path_point(4, 1), path_point(2, 1),
                     path_point(2, -1)}),
      [](precision p) { return i_times(2 * pi(p)); }));
  all.push_back(known(
      "z^-3 sin z, clockwise twice: residue 0, and z^-2 sin z: -4 pi i",
      [](const auto& z) { return sin(z) / pow(z, 3) + sin(z) / pow(z, 2); },
      -(unit_circle + unit_circle), [](precision p) { return i_times(-4 * pi(p)); }));
  // By antiderivatives.
  all.push_back(known(
      "1/z over half a circle: i pi", [](const auto& z) { return 1 / z; }, half_turn,
      [](precision p) { return i_times(pi(p)); }));
  all.push_back(known(
      "sqrt(z) from 1 over 1+i to -1+i: 2/3 z^(3/2)", [](const auto& z) { return sqrt(z); }, corner,
      [](precision p) {
        const complex_ball z = number(-1, 1, p);
        return (z * sqrt(z) - 1) * rational(2, 3);
      }));
  all.push_back(known(
      "log(z) over the same: z log z - z", [](const auto& z) { return log(z); }, corner,
      [](precision p) {
        const complex_ball z = number(-1, 1, p);
        return z * log(z) - z + 1;
      }));
  all.push_back(known(
      "z^(1/3): 3/4 z^(4/3)", [](const auto& z) { return pow(z, rational(1, 3)); }, corner,
      [](precision p) {
        const complex_ball z = number(-1, 1, p);
        return (z * pow(z, complex_ball(rational(1, 3), p)) - 1) * rational(3, 4);
      }));
  all.push_back(known(
      "z^i: z^(1+i)/(1+i)", [](const auto& z) { return pow(z, complex_ball::i(2000)); }, corner,
      [](precision p) {
        const complex_ball e = number(1, 1, p);
        return (pow(number(-1, 1, p), e) - 1) / e;
      }));
  all.push_back(known(
      "exp(iz): -i exp(iz)", [](const auto& z) { return exp(times_i(z)); }, corner,
      [](precision p) {
        const complex_ball z = times_i(number(-1, 1, p));
        return (exp(z) - exp(complex_ball::i(p))) * -complex_ball::i(p);
      }));
  all.push_back(known(
      "atan: z atan z - log(1+z^2)/2, right of the cut", [](const auto& z) { return atan(z); },
      path::line(1, path_point(2, 3)),
      [](precision p) {
        const auto at = [](const complex_ball& z) { return z * atan(z) - log(1 + z * z) / 2; };
        return at(number(2, 3, p)) - at(complex_ball(1, p));
      }));
  all.push_back(known(
      "asin: z asin z + sqrt(1-z^2)", [](const auto& z) { return asin(z); },
      path::line(path_point(-2, 1), path_point(2, 1)),
      [](precision p) {
        const auto at = [](const complex_ball& z) { return z * asin(z) + sqrt(1 - z * z); };
        return at(number(2, 1, p)) - at(number(-2, 1, p));
      }));
  all.push_back(known(
      "acosh: z acosh z - sqrt(z-1) sqrt(z+1)", [](const auto& z) { return acosh(z); },
      path::line(path_point(3, -1), path_point(2, 1)),
      [](precision p) {
        const auto at = [](const complex_ball& z) {
          return z * acosh(z) - sqrt(z - 1) * sqrt(z + 1);
        };
        return at(number(2, 1, p)) - at(number(3, -1, p));
      }));
  all.push_back(known(
      "tanh: log cosh", [](const auto& z) { return tanh(z); }, path::line(0, path_point(1, 1)),
      [](precision p) { return log(cosh(number(1, 1, p))); }));
  // Residues of Gamma at -n: (-1)^n/n!.
  all.push_back(known(
      "gamma around 0", [](const auto& z) { return gamma(z); }, path::circle(0, rational(1, 2)),
      [](precision p) { return i_times(2 * pi(p)); }));
  all.push_back(known(
      "gamma around -2", [](const auto& z) { return gamma(z); }, path::circle(-2, rational(1, 2)),
      [](precision p) { return i_times(pi(p)); }));
  // Raabe's formula: log Gamma over [z, z + 1] is z log z - z + log(2 pi)/2.
  all.push_back(known(
      "log_gamma from 1+i to 2+i", [](const auto& z) { return log_gamma(z); },
      path::line(path_point(1, 1), path_point(2, 1)),
      [](precision p) {
        const complex_ball z = number(1, 1, p);
        return z * log(z) - z + log(2 * pi(p)) / 2;
      }));
  all.push_back(known(
      "erf: z erf z + exp(-z^2)/sqrt(pi)", [](const auto& z) { return erf(z); }, corner,
      [](precision p) {
        const auto at = [&](const complex_ball& z) {
          return z * erf(z) + exp(-square(z)) / sqrt(pi(p));
        };
        return at(number(-1, 1, p)) - at(number(1, 0, p));
      }));
  all.push_back(known(
      "a constant: the ends' difference", [](const auto&) { return rational(3, 7); }, corner,
      [](precision p) { return number(-2, 1, p) * rational(3, 7); }));
  all.push_back(known(
      "1 over a circle's arc of irrational ends", [](const auto&) { return 1; },
      path::arc(path_point(rational(1, 3), 5), rational(7, 2), multiple_of_pi(rational(1, 5)), -2),
      [](precision p) {
        const auto at = [](const ball& angle) { return complex_ball(cos(angle), sin(angle)); };
        return (at(ball(-2, p)) - at(pi(p) / 5)) * rational(7, 2);
      }));
  return all;
}

TEST(Contour, ClosedFormsToFiftyDigits) {
  for (const known_contour_integral& k : closed_forms()) EXPECT_TRUE(right(k, 50));
}

TEST(Contour, ClosedFormsToFewDigitsAndOddOnes) {
  for (const known_contour_integral& k : closed_forms()) {
    for (const long digits : {1L, 7L, 19L}) EXPECT_TRUE(right(k, digits));
  }
}

TEST(Contour, ResiduesToAThousandDigits) {
  const std::vector<known_contour_integral> all = closed_forms();
  for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(right(all[k], 1000));
}

TEST(Contour, TwoPathsWithNothingBetweenThemAgree) {
  // The square's boundary and the circle around it, about the poles of 1/(z^4 + 1/16); and straight
  // against round.
  const auto f = [](const auto& z) { return exp(z) / (pow(z, 4) + rational(1, 16)); };
  const integrate_options options{.digits = 40};
  const path square = path::polygon({path_point(1, -1), path_point(1, 1), path_point(-1, 1),
                                     path_point(-1, -1), path_point(1, -1)});
  const contour_integral a = integrate_along(f, square, options);
  const contour_integral b = integrate_along(f, path::circle(0, 2), options);
  ASSERT_EQ(a.verdict, status::certified) << a.obstacle;
  ASSERT_EQ(b.verdict, status::certified) << b.obstacle;
  EXPECT_TRUE(overlaps(a.enclosure, b.enclosure));
  // Half of the poles give something else.
  const contour_integral c =
      integrate_along(f, path::circle(rational(1, 2), rational(1, 2)), options);
  ASSERT_EQ(c.verdict, status::certified) << c.obstacle;
  EXPECT_FALSE(overlaps(a.enclosure, c.enclosure));

  support::random_source random(5);
  const auto g = [](const auto& z) { return sin(z) * log(z + 9) / (z * z + 30); };
  for (support::repeat trial(10); trial.again();) {
    const auto part = [&] { return rational(random.between(-300, 300), 100); };
    const path_point p(part(), part());
    const path_point q(part(), part());
    const path_point corner(part(), part());
    const contour_integral straight = integrate_along(g, path::line(p, q), {.digits = 25});
    const contour_integral bent = integrate_along(g, path::polygon({p, corner, q}), {.digits = 25});
    ASSERT_EQ(straight.verdict, status::certified) << straight.obstacle;
    ASSERT_EQ(bent.verdict, status::certified) << bent.obstacle;
    EXPECT_TRUE(overlaps(straight.enclosure, bent.enclosure));
    // The other way round.
    const contour_integral back =
        integrate_along(g, -path::polygon({p, corner, q}), {.digits = 25});
    EXPECT_TRUE(overlaps(-back.enclosure, bent.enclosure));
    // An arc over the same chord: the centre in the middle.
    const auto middle = [&](const end_point& x, const end_point& y) {
      return rational((x.exact().value() + y.exact().value()) / 2);
    };
    const rational cx = middle(p.re(), q.re());
    const rational cy = middle(p.im(), q.im());
    const rational dx = q.re().exact().value() - cx;
    const rational dy = q.im().exact().value() - cy;
    if (dx == 0 && dy == 0) continue;
    const end_point radius(
        [=](precision bits) { return sqrt(ball(rational(dx * dx + dy * dy), bits)); });
    const auto angle = [=](precision bits) { return atan2(ball(dy, bits), ball(dx, bits)); };
    const path arc = path::arc(path_point(cx, cy), radius,
                               end_point([=](precision bits) { return angle(bits) - pi(bits); }),
                               end_point(angle));
    const contour_integral round = integrate_along(g, arc, {.digits = 25});
    ASSERT_EQ(round.verdict, status::certified) << round.obstacle;
    EXPECT_TRUE(overlaps(round.enclosure, straight.enclosure));
  }
}

TEST(Contour, OnTheRealAxisItIsTheRealIntegral) {
  const auto f = [](const auto& x) { return exp(x) / (x * x + rational(1, 10)); };
  const integral real = integrate(f, -1, 2, {.digits = 40});
  const contour_integral complex = integrate_along(f, path::line(-1, 2), {.digits = 40});
  ASSERT_EQ(complex.verdict, status::certified);
  EXPECT_TRUE(overlaps(real.enclosure, complex.enclosure.re));
  EXPECT_TRUE(contains_zero(complex.enclosure.im));
}

/// Refused as not analytic, with the words in the obstacle.
template <class F>
::testing::AssertionResult refused(const F& f, const path& along, const std::string& words) {
  const contour_integral i = integrate_along(f, along, {.digits = 20});
  if (i.verdict == status::not_certified && i.why == reason::not_analytic &&
      i.enclosure.is_undefined() && i.obstacle.find(words) != std::string::npos &&
      i.obstacle.find("near z = ") != std::string::npos) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << to_text(i.verdict) << ", " << to_text(i.why) << ": "
                                       << i.obstacle << ' ' << i.enclosure;
}

TEST(Contour, CutsThatThePathCrossesAreRefused) {
  const path across = path::line(path_point(-1, -1), path_point(-2, 3));  // the negative axis
  EXPECT_TRUE(refused([](const auto& z) { return sqrt(z); }, across, "the branch cut of sqrt"));
  EXPECT_TRUE(refused([](const auto& z) { return log(z); }, across, "the branch cut of log"));
  EXPECT_TRUE(
      refused([](const auto& z) { return pow(z, rational(1, 3)); }, across, "the branch cut of"));
  EXPECT_TRUE(refused([](const auto& z) { return asin(z); }, across, "the branch cut of asin"));
  EXPECT_TRUE(refused([](const auto& z) { return acos(z); }, across, "the branch cut of acos"));
  EXPECT_TRUE(refused([](const auto& z) { return acosh(z); }, across, "the branch cut of acosh"));
  EXPECT_TRUE(refused([](const auto& z) { return atanh(z); }, across, "the branch cut of atanh"));
  const path above = path::line(path_point(-1, 2), path_point(1, 3));  // the imaginary axis
  EXPECT_TRUE(refused([](const auto& z) { return atan(z); }, above, "the branch cut of atan"));
  EXPECT_TRUE(refused([](const auto& z) { return asinh(z); }, above, "the branch cut of asinh"));
  // Along a cut, around a branch point, and with a constant that turns the cut.
  EXPECT_TRUE(refused([](const auto& z) { return sqrt(z); }, path::line(-3, -1), "branch cut"));
  EXPECT_TRUE(refused([](const auto& z) { return log(z); }, path::circle(0, 1), "branch cut"));
  EXPECT_TRUE(refused([](const auto& z) { return sqrt(times_i(z)); },
                      path::line(path_point(-1, 2), path_point(1, 3)), "branch cut"));
}

TEST(Contour, PolesOnThePathAreRefused) {
  const auto f = [](const auto& z) { return 1 / z; };
  EXPECT_TRUE(refused(f, path::line(path_point(-1, -1), path_point(1, 1)), "the pole of /"));
  EXPECT_TRUE(refused(f, path::line(path_point(-1, -2), path_point(2, 4)), "the pole of /"));
  EXPECT_TRUE(refused(f, path::line(0, path_point(1, 1)), "the pole of /"));
  EXPECT_TRUE(refused(f, path::circle(1, 1), "the pole of /"));
  EXPECT_TRUE(refused(
      [](const auto& z) { return tan(z); },
      path::line(path_point(0, -1), path_point(end_point([](precision p) { return pi(p); }), 1)),
      "the pole of tan"));
}

// |z| and what else is not analytic do not compile, and what a region may be given, an analytic
// ball may.
template <class T>
concept has_modulus = requires(const T& z) {
  abs(z);
};
static_assert(has_modulus<complex_ball> && !has_modulus<analytic_ball>);
template <class T>
concept has_conjugate = requires(const T& z) {
  conj(z);
};
static_assert(has_conjugate<complex_ball> && !has_conjugate<analytic_ball>);
static_assert(!std::convertible_to<analytic_ball, complex_ball>);

TEST(Contour, PathsMayEndOnACutOrAtABranchPoint) {
  const auto root = [](const auto& z) { return sqrt(z); };
  const auto from_zero =
      known("sqrt(z) from 0 to 3+4i: 2/3 (2+i)^3", root, path::line(0, path_point(3, 4)),
            [](precision p) { return pow(number(2, 1, p), 3) * rational(2, 3); });
  EXPECT_TRUE(right(from_zero, 30));
  // From above, sqrt(-1) = i: the part of the square root that belongs to the piece.
  const auto to_cut =
      known("sqrt(z) from 1 over i to -1", root, path::polygon({1, path_point(0, 1), -1}),
            [](precision p) { return (-complex_ball::i(p) - 1) * rational(2, 3); });
  EXPECT_TRUE(right(to_cut, 30));
  const auto from_below =
      known("sqrt(z) from 1 over -i to -1", root, path::polygon({1, path_point(0, -1), -1}),
            [](precision p) { return (complex_ball::i(p) - 1) * rational(2, 3); });
  EXPECT_TRUE(right(from_below, 30));
  const auto through_zero = known("sqrt(z) from 1 through 0 to i", root,
                                  path::polygon({1, 0, path_point(0, 1)}), [](precision p) {
                                    const complex_ball i = complex_ball::i(p);
                                    return (i * sqrt(i) - 1) * rational(2, 3);
                                  });
  EXPECT_TRUE(right(through_zero, 30));
  // Unbounded there, though integrable: refused.
  EXPECT_TRUE(refused([](const auto& z) { return 1 / sqrt(z); }, path::line(0, path_point(1, 1)),
                      "the branch cut of sqrt"));
}

TEST(Contour, APoleNearThePathIsSeen) {
  // 1/(z - w), w = 10^-20 i above the path from -1 to 1: log((1 - w)/(-1 - w)), which turns by
  // almost -pi.
  for (const long sign : {-1L, 1L}) {
    const rational gap = sign * power_of_ten(-20);
    const auto f = [=](const auto& z) { return 1 / (z - times_i(0 * z + gap)); };
    const auto value = [=](precision p) {
      const complex_ball w(rational(0), gap, p);
      return log(1 - w) - log(-1 - w);
    };
    EXPECT_TRUE(right(known("a pole at distance 1e-20", f, path::line(-1, 1), value), 25));
  }
  // A circle that passes a pole so near, inside or outside: 2 pi i or 0.
  for (const long side : {-1L, 1L}) {
    const rational pole = 1 + side * power_of_ten(-20);
    const auto f = [=](const auto& z) { return 1 / (z - pole) + exp(z); };
    const contour_integral i = integrate_along(f, path::circle(0, 1), {.digits = 25});
    ASSERT_EQ(i.verdict, status::certified) << i.obstacle;
    EXPECT_TRUE(holds(i, i_times(side < 0 ? 2 * pi(300) : ball(0, 300))));
  }
}

TEST(Contour, ZeroIsCertifiedAgainstTheSizeOfF) {
  const contour_integral i =
      integrate_along([](const auto& z) { return exp(z); }, path::circle(1, 2), {.digits = 40});
  EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
  EXPECT_TRUE(contains(i.enclosure, rational(0), rational(0)));
  EXPECT_LE(i.enclosure.magnitude_upper(), magnitude::power_of_two(-125));
}

TEST(Contour, PiecesWithoutLengthAddNothing) {
  const auto f = [](const auto& z) { return 1 / z; };
  const contour_integral nothing = integrate_along(f, path());
  EXPECT_EQ(nothing.verdict, status::certified);
  for (const path& p :
       {path(), path::line(0, 0), path::polygon({path_point(0)}), path::circle(0, 0),
        path::polygon({path_point(0, rational(1, 3)), path_point(0, rational(1, 3))}),
        path::arc(0, 1, rational(1, 3), rational(1, 3))}) {
    const contour_integral i = integrate_along(f, p);
    EXPECT_EQ(i.verdict, status::certified);
    EXPECT_TRUE(i.enclosure.is_exact() && contains(i.enclosure, rational(0), rational(0)));
    EXPECT_EQ(i.account.evaluations + i.account.region_evaluations, 0);
  }
  const known_contour_integral beside =
      known("1/z around 0 with pieces of no length", f,
            path::line(1, 1) + path::circle(0, 1) + path::circle(1, 0),
            [](precision p) { return i_times(2 * pi(p)); });
  EXPECT_TRUE(right(beside, 30));
}

TEST(Contour, WidePointsGiveWideTrueAnswers) {
  // The end is anywhere in a box: z^2/2 over the box lies inside, and nothing is called certified.
  const auto f = [](const auto& z) { return z; };
  const complex_ball end(ball(1, 64).enlarged(magnitude::power_of_two(-10)),
                         ball(1, 64).enlarged(magnitude::power_of_two(-10)));
  const contour_integral i = integrate_along(f, path::line(0, end), {.digits = 15});
  EXPECT_EQ(i.verdict, status::not_certified);
  EXPECT_EQ(i.why, reason::precision_limit);
  for (const long a : {-1L, 0L, 1L}) {
    for (const long b : {-1L, 0L, 1L}) {
      const complex_ball z(rational(1024 + a, 1024), rational(1024 + b, 1024), 128);
      EXPECT_TRUE(contains(i.enclosure, z * z / 2));
    }
  }
  EXPECT_LE(i.enclosure.re.radius(), magnitude::power_of_two(-7));
  // A radius known to 2^-10 alone does not matter to a residue.
  const contour_integral residue = integrate_along(
      [](const auto& z) { return 1 / z; },
      path::circle(0, ball(1, 64).enlarged(magnitude::power_of_two(-10))), {.digits = 15});
  EXPECT_TRUE(holds(residue, i_times(2 * pi(128))));
}

TEST(Contour, MisuseThrowsAndLimitsAreKept) {
  const auto f = [](const auto& z) { return exp(z); };
  EXPECT_THROW((void)integrate_along(f, path::circle(0, 1), {.digits = 0}), std::invalid_argument);
  EXPECT_THROW((void)path::line(0, end_point::infinity()), std::invalid_argument);
  EXPECT_THROW((void)path::circle(0, end_point::infinity()), std::invalid_argument);
  EXPECT_THROW((void)path::arc(0, 1, 0, -end_point::infinity()), std::invalid_argument);
  const contour_integral undefined = integrate_along(f, path::line(0, ball::undefined(64)));
  EXPECT_EQ(undefined.why, reason::not_defined);
  const contour_integral few =
      integrate_along(f, path::circle(0, 50), {.digits = 15, .most_evaluations = 100});
  EXPECT_EQ(few.why, reason::evaluation_limit);
}

TEST(Contour, TheCostIsKnown) {
  const auto f = [](const auto& z) { return sqrt(z); };
  const path corner = path::polygon({1, path_point(1, 1), path_point(-1, 1)});
  const contour_integral i = integrate_along(f, corner, {.digits = 100});
  EXPECT_LE(i.account.panels, 8);
  EXPECT_LE(i.account.evaluations, 500);
  EXPECT_LE(i.account.region_evaluations, 1500);
}

}  // namespace contour_test
}  // namespace polhode
