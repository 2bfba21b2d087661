// Paths as they are put together: that pieces join, that what is integrated over a piece is the
// piece, and that beside an end nothing is in the way; and random paths against antiderivatives and
// residues.

#include "quadrature/paths/path_pieces.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "polhode/quadrature/contour.hpp"
#include "quadrature/formula/integrand.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace path_pieces_test {

using support::power_of_ten;

constexpr auto identity = [](const auto& z) { return z; };
constexpr auto root = [](const auto& z) { return sqrt(z); };

end_point half_turns(long n) { return end_point::pi(rational(n)); }

/// A path point that is known as a function of the precision only.
path_point irrational(long square_re, long square_im) {
  return {end_point([=](precision p) { return sqrt(ball(square_re, p)); }),
          end_point([=](precision p) { return sqrt(ball(square_im, p)); })};
}

::testing::AssertionResult throws_for(const path& along, const std::string& words) {
  try {
    (void)integrate_along(identity, along, {.digits = 10});
  } catch (const std::invalid_argument& error) {
    if (std::string(error.what()).find(words) != std::string::npos) {
      return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure() << error.what();
  }
  return ::testing::AssertionFailure() << "it was integrated";
}

TEST(PathPieces, ThatDoNotJoinAreRefused) {
  EXPECT_TRUE(
      throws_for(path::line(0, 1) + path::line(2, 3), "piece 2 of the path starts at z = 2"));
  EXPECT_TRUE(throws_for(path::line(0, 1) + path::line(1, 2) + path::line(rational(2), 3) +
                             path::line(path_point(3, power_of_ten(-30)), 4),
                         "piece 4 of the path"));
  EXPECT_TRUE(throws_for(path::circle(0, 1) + path::circle(5, 1), "piece 2"));
  EXPECT_TRUE(throws_for(path::line(0, 0) + path::line(1, 2), "piece 2"));
  // An arc that ends beside the line's start by 10^-15, to be seen with ten digits.
  const path arc = path::arc(0, 1, 0, half_turns(1));
  EXPECT_TRUE(throws_for(arc + path::line(rational(-1) - power_of_ten(-15), -2), "piece 2"));
  // Backwards the order is the other one.
  EXPECT_TRUE(throws_for(-path::line(0, 1) + path::line(1, 2), "piece 2"));
}

TEST(PathPieces, ThatJoinAreIntegrated) {
  const path_point corner = irrational(2, 3);
  const path arc = path::arc(0, 1, 0, half_turns(1));
  for (const path& along :
       {path::line(0, 1) + path::line(1, 2), path::polygon({0, corner, path_point(0, 1)}),
        path::line(0, corner) + path::line(irrational(2, 3), 1),
        path::line(1, 0) + -path::line(path_point(0, 1), 0), arc + path::line(-1, -2), arc + -arc,
        path::circle(0, 1) + path::circle(0, 1) + path::line(1, 1),
        path::arc(1, -1, 0, half_turns(1)) + path::line(2, 3)}) {
    const contour_integral i = integrate_along(identity, along, {.digits = 10});
    EXPECT_TRUE(i.enclosure.is_bounded()) << i.obstacle;
  }
}

TEST(PathPieces, GapsAreSeenWithEnoughBits) {
  const path two =
      path::line(0, irrational(2, 3)) +
      path::line({end_point([](precision p) { return sqrt(ball(2, p)) + power_of_ten(-40); }),
                  end_point([](precision p) { return sqrt(ball(3, p)); })},
                 1);
  EXPECT_FALSE(detail::gap_between(two.pieces(), 64));
  EXPECT_TRUE(detail::gap_between(two.pieces(), 192));
}

/// Along a line, F(t) dz/dt = f(a + d t) d.
detail::segment line_from(const complex_ball& a, const complex_ball& d, const complex_ball& scale) {
  detail::complex_piece along;
  along.evaluator = [=](precision) -> std::function<complex_ball(const ball&)> {
    return [=](const ball& t) { return a + d * t; };
  };
  along.scale = [=](precision) { return scale; };
  along.position = [=](const ball& t) { return a + d * t; };
  detail::segment s;
  s.over = [=](const region& t) { return region::in_balls(a) + region::in_balls(d) * t; };
  s.along = along;
  return s;
}

TEST(PathPieces, ASegmentThatLiesAboutItsPieceIsFound) {
  const path_piece piece = line_piece{path_point(1, 1), path_point(2, 3)};
  const auto at = [](long re, long im) { return complex_ball(re, im, 128); };
  EXPECT_TRUE(detail::runs_over(line_from(at(1, 1), at(1, 2), at(1, 2)), piece, 128));
  // Another start, another end, beyond the end by 2^-100, the other way round, a scale that is not
  // dz/dt.
  EXPECT_FALSE(detail::runs_over(line_from(at(0, 1), at(2, 2), at(2, 2)), piece, 128));
  EXPECT_FALSE(detail::runs_over(line_from(at(1, 1), at(1, 1), at(1, 1)), piece, 128));
  const complex_ball beyond = at(1, 2) + scale(at(1, 0), -100);
  EXPECT_FALSE(detail::runs_over(line_from(at(1, 1), beyond, beyond), piece, 128));
  EXPECT_FALSE(detail::runs_over(line_from(at(2, 3), at(-1, -2), at(-1, -2)), piece, 128));
  EXPECT_FALSE(detail::runs_over(line_from(at(1, 1), at(1, 2), at(2, 2)), piece, 128));
  const path_piece arc = arc_piece{path_point(0), 1, 0, half_turns(1)};
  EXPECT_FALSE(detail::runs_over(line_from(at(1, 0), at(-1, 0), at(-1, 0)), arc, 128));
  detail::segment real;
  EXPECT_FALSE(detail::runs_over(real, piece, 128));
}

TEST(PathPieces, TheSamePointIsKnown) {
  const path_point p = irrational(2, 3);
  const path_point copy = p;
  EXPECT_TRUE(p.is_same_as(copy));
  EXPECT_FALSE(p.is_same_as(irrational(2, 3)));  // nobody proves it
  EXPECT_TRUE(path_point(rational(1, 3), 2).is_same_as(path_point(rational(2, 6), 2)));
  EXPECT_FALSE(path_point(1, 2).is_same_as(path_point(1, 3)));
  EXPECT_FALSE(path_point(1, 2).is_same_as(path_point(2, 2)));
  // A piece between them has no length: nothing is asked of 1/(z - p).
  const contour_integral i = integrate_along([](const auto& z) { return 1 / (z * z - z * z); },
                                             path::line(p, copy), {.digits = 10});
  EXPECT_EQ(i.verdict, status::certified);
}

::testing::AssertionResult refused_for_a_cut(const path& along, long digits) {
  const contour_integral i = integrate_along(root, along, {.digits = digits});
  if (i.verdict != status::certified && i.why == reason::not_analytic &&
      i.obstacle.find("the branch cut of sqrt near z = ") != std::string::npos) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << i.enclosure << " " << i.obstacle;
}

TEST(PathPieces, ACutBesideAnEndIsRefusedHoweverFewTheDigits) {
  for (const long exponent : {3L, 9L, 20L, 60L, 100L, 300L, 1000L}) {
    const path_point below(-1, -power_of_ten(-exponent));
    for (const long digits : {1L, 3L, 20L}) {
      EXPECT_TRUE(refused_for_a_cut(path::line(below, path_point(-1, 1)), digits)) << exponent;
      EXPECT_TRUE(refused_for_a_cut(path::line(path_point(-1, 1), below), digits)) << exponent;
    }
    // Along the cut for a little while, and then away.
    if (exponent > 100) continue;
    const path_point beside(rational(-1) - power_of_ten(-exponent), 0);
    EXPECT_TRUE(refused_for_a_cut(path::polygon({beside, -1, path_point(-1, 1)}), 3)) << exponent;
  }
  // An arc from below the cut.
  const path arc = path::arc(
      0, 1, end_point([](precision p) { return -pi(p) - power_of_ten(-25); }), rational(-1));
  EXPECT_TRUE(refused_for_a_cut(arc, 3));
}

TEST(PathPieces, AnEndOnACutIsNotRefused) {
  for (const path& along :
       {path::line(-1, path_point(-1, 1)), path::line(path_point(-2, -1), -1), path::line(0, 1),
        path::line(0, path_point(-1, 1)), path::arc(0, 1, 0, half_turns(1)),
        path::arc(0, 1, half_turns(-1), half_turns(1))}) {
    const contour_integral i = integrate_along(root, along, {.digits = 6});
    EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
  }
}

// ---------------------------------------------------------------------------------------------
// Random paths.

struct gaussian {
  rational re;
  rational im;
};
gaussian operator+(const gaussian& a, const gaussian& b) { return {a.re + b.re, a.im + b.im}; }
gaussian operator-(const gaussian& a, const gaussian& b) { return {a.re - b.re, a.im - b.im}; }
gaussian operator*(const gaussian& a, const gaussian& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
complex_ball to_balls(const gaussian& z, precision p) { return {z.re, z.im, p}; }

rational random_part(support::random_source& random) {
  switch (random.between(0, 3)) {
    case 0:
      return rational(random.between(-3, 3));
    case 1:
      return rational(random.between(-3, 3)) +
             random.between(-1, 1) * power_of_ten(-random.between(1, 30));
    default:
      return rational(random.between(-30, 30), random.between(1, 12));
  }
}
gaussian random_number(support::random_source& random) {
  return {random_part(random), random.one_in(4) ? rational(0) : random_part(random)};
}

/// Two to five corners; some follow on themselves, go back, or close the path.
std::vector<gaussian> random_corners(support::random_source& random) {
  std::vector<gaussian> all{random_number(random)};
  for (long n = random.between(1, 4); n > 0; --n) {
    const gaussian last = all.back();
    if (random.one_in(12)) {
      all.push_back(last);
    } else if (random.one_in(12) && all.size() > 1) {
      all.push_back(all[all.size() - 2]);
    } else {
      all.push_back(random_number(random));
    }
  }
  if (random.one_in(3)) all.push_back(all.front());
  return all;
}
path polygon_of(const std::vector<gaussian>& corners) {
  std::vector<path_point> points;
  for (const gaussian& z : corners) points.emplace_back(z.re, z.im);
  return path::polygon(points);
}

/// A number beside the path, mostly, or on it.
gaussian random_near(const std::vector<gaussian>& corners, support::random_source& random) {
  const auto k = static_cast<std::size_t>(random.between(0, static_cast<long>(corners.size()) - 2));
  const rational t(random.between(0, 8), 8);
  const gaussian d = corners[k + 1] - corners[k];
  gaussian z = corners[k] + gaussian{d.re * t, d.im * t};
  const rational off =
      random.one_in(8) ? rational(0) : random.between(-9, 9) * power_of_ten(-random.between(0, 12));
  (random.one_in(2) ? z.re : z.im) += off;
  return z;
}

bool is_on(const gaussian& z, const gaussian& a, const gaussian& b) {
  const gaussian d = b - a;
  const gaussian e = z - a;
  if (d.re * e.im != d.im * e.re) return false;
  const rational along = d.re * e.re + d.im * e.im;
  return along >= 0 && along <= d.re * d.re + d.im * d.im;
}

bool is_same_number(const gaussian& a, const gaussian& b) { return a.re == b.re && a.im == b.im; }

::testing::AssertionResult holds(const contour_integral& i, const complex_ball& value) {
  if (i.enclosure.is_undefined() || overlaps(i.enclosure, value)) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << i.enclosure << " for " << value;
}

TEST(RandomPaths, HaveTheirLogarithms) {
  // 1/(z - w) and 1/(z - w)^2: log((b - w)/(a - w)) for each line, and the difference of -1/(z -
  // w).
  support::random_source random(161);
  constexpr precision p = 400;
  long certified = 0;
  long refused = 0;
  for (support::repeat trial(25); trial.again();) {
    const std::vector<gaussian> corners = random_corners(random);
    const gaussian w = random.one_in(3) ? random_number(random) : random_near(corners, random);
    const gaussian c = random_number(random);
    complex_ball value(0, p);
    bool on_path = false;
    for (std::size_t k = 1; k < corners.size(); ++k) {
      if (is_same_number(corners[k - 1], corners[k])) continue;
      on_path = on_path || is_on(w, corners[k - 1], corners[k]);
      if (on_path) break;
      const complex_ball a = to_balls(corners[k - 1] - w, p);
      const complex_ball b = to_balls(corners[k] - w, p);
      value += log(b / a) + to_balls(c, p) * (1 / a - 1 / b);
    }
    const auto f = [&](const auto& z) {
      const auto d = z - w.re - times_i(0 * z + w.im);
      return 1 / d + (c.re + times_i(0 * z + c.im)) / (d * d);
    };
    const contour_integral i =
        integrate_along(f, polygon_of(corners), {.digits = random.between(1, 20)});
    if (on_path) {
      EXPECT_NE(i.verdict, status::certified);
      ++refused;
    } else {
      EXPECT_TRUE(holds(i, value));
      if (i.verdict == status::certified) ++certified;
    }
  }
  if (support::effort() >= 1) {  // of few, chance decides
    EXPECT_GT(certified, 5 * refused);
    EXPECT_GT(refused, 0);
  }
}

/// The line's inner points meet the cut (-inf, 0].
bool crosses_cut(const gaussian& a, const gaussian& b) {
  if (a.im == 0 && b.im == 0) return a.re != b.re && (a.re < 0 || b.re < 0);
  if (a.im * b.im >= 0) return false;
  return a.re + a.im / (a.im - b.im) * (b.re - a.re) <= 0;
}

TEST(RandomPaths, HaveRootsAndLogarithmsOrMeetTheirCuts) {
  // w = a z + b: the antiderivatives 2/3 w sqrt(w) and w log(w) - w, for an end on the cut from the
  // line's side.
  support::random_source random(162);
  constexpr precision p = 500;
  long certified = 0;
  long refused = 0;
  for (support::repeat trial(25); trial.again();) {
    const std::vector<gaussian> corners = random_corners(random);
    const gaussian a = random.one_in(2) ? gaussian{1, 0} : random_number(random);
    if (is_same_number(a, {0, 0})) continue;
    // Often so that a point of the path, or one beside it, is at the branch point or on the cut.
    gaussian b = random_number(random);
    if (!random.one_in(4)) {
      const gaussian at = a * random_near(corners, random);
      b = gaussian{rational(-random.between(0, 2)), 0} - at;
    }
    const bool is_root = random.one_in(2);
    const auto antiderivative = [&](const complex_ball& w) {
      return is_root ? w * sqrt(w) * rational(2, 3) : w * log(w) - w;
    };
    complex_ball value(0, p);
    bool meets_cut = false;
    for (std::size_t k = 1; k < corners.size() && !meets_cut; ++k) {
      if (is_same_number(corners[k - 1], corners[k])) continue;
      const gaussian from = a * corners[k - 1] + b;
      const gaussian to = a * corners[k] + b;
      meets_cut = crosses_cut(from, to);
      const auto at = [&](const gaussian& end, const gaussian& other) {
        const bool is_zero = is_same_number(end, {0, 0});
        if (is_zero) return complex_ball(0, p);
        complex_ball w = to_balls(end, p);
        // On the cut: F below it is conj F above it.
        const bool below = end.im == 0 && end.re < 0 && other.im < 0;
        return below ? conj(antiderivative(w)) : antiderivative(w);
      };
      value += at(to, from) - at(from, to);
    }
    const auto f = [&](const auto& z) {
      const auto w = (a.re + times_i(0 * z + a.im)) * z + b.re + times_i(0 * z + b.im);
      return is_root ? sqrt(w) : log(w);
    };
    const contour_integral i =
        integrate_along(f, polygon_of(corners), {.digits = random.between(1, 15)});
    if (meets_cut) {
      EXPECT_NE(i.verdict, status::certified);
      ++refused;
    } else {
      EXPECT_TRUE(holds(i, value / to_balls(a, p)));
      if (i.verdict == status::certified) ++certified;
    }
  }
  if (support::effort() >= 1) {  // of few, chance decides
    EXPECT_GT(certified, refused / 4);
    EXPECT_GT(refused, 0);
  }
}

TEST(RandomPaths, GoAroundPolesAndEssentialSingularities) {
  support::random_source random(163);
  constexpr precision p = 400;
  for (support::repeat trial(10); trial.again();) {
    const gaussian c = random_number(random);
    const rational size = power_of_ten(random.between(0, 2) * random.between(-8, 8));
    const rational r = rational(random.between(1, 30), random.between(1, 7)) * size;
    const path circle = path::circle(path_point(c.re, c.im), r);
    // 1/(z - w) for w inside or outside by 10^-k of the radius.
    const rational share = 1 + random.between(-9, 9) * power_of_ten(-random.between(1, 12));
    const rational distance = r * share;
    const gaussian w = c + gaussian{distance * rational(3, 5), distance * rational(-4, 5)};
    const contour_integral pole =
        integrate_along([&](const auto& z) { return 1 / (z - w.re - times_i(0 * z + w.im)); },
                        circle, {.digits = random.between(1, 15)});
    const ball turn = share < 1 ? 2 * pi(p) : ball(0, p);
    if (share == 1) {
      EXPECT_NE(pole.verdict, status::certified);
    } else {
      EXPECT_TRUE(holds(pole, {ball(0, p), turn}));
    }
    // (z - c)^n exp(k/(z - c)): 2 pi i k^(n+1)/(n+1)!.
    const long n = random.between(-1, 4);
    const rational k = r * rational(random.between(-9, 9), 3);
    rational residue = 1;
    for (long j = 1; j <= n + 1; ++j) residue *= k / j;
    const contour_integral essential = integrate_along(
        [&](const auto& z) {
          const auto d = z - c.re - times_i(0 * z + c.im);
          return pow(d, n) * exp(k / d);
        },
        circle, {.digits = random.between(1, 15)});
    EXPECT_TRUE(holds(essential, {ball(0, p), 2 * pi(p) * residue}));
  }
}

}  // namespace path_pieces_test
}  // namespace polhode
