#pragma once

// A function in the arithmetics of quadrature, and the pieces that its integrals are made of.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "quadrature/ends/end_series.hpp"
#include "quadrature/ends/growth_bound.hpp"

namespace polhode {

// How the formula is looked at besides (src/quadrature).
class angle;
class symmetry;
class tail_series;

namespace detail {

class formula_graph;

/// A bound of |F| on the part of a rectangle that lies in the set where a series for F is known to
/// hold.
struct known_bound {
  magnitude bound;
  bool everywhere = false;  // the rectangle lies wholly in the set
};

/// What a segment has in place of `evaluator`, `scale` and `position` where F is not real for real
/// t: that of a path's piece.
struct complex_piece {
  std::function<std::function<complex_ball(const ball& t)>(precision p)> evaluator;
  std::function<complex_ball(precision)> scale;
  std::function<complex_ball(const ball& t)> position;
  magnitude size;  // about that of the numbers whose sums the points are
};

/// The integral of one analytic piece: scale times the integral of F(t) over 0 <= t <= 1.
struct segment {
  std::function<region(const region& t)> over;
  /// F at real points, with p bits: what is costly and does not depend on t is done once.
  std::function<std::function<ball(const ball& t)>(precision p)> evaluator;
  std::function<ball(precision)> scale;
  /// x as a function of t, for messages and to see how far apart doubles can keep two points.
  std::function<ball(const ball& t)> position;
  /// x(t), where `position` is in another variable.
  std::function<ball(const ball& t)> place = nullptr;
  /// Near t = 0, where F is known by a series: a bound of |F|, and so its analyticity, on the part
  /// of a rectangle of t where the series holds; nothing where that may be empty. The series' set
  /// is a disc around 0 or a half plane, open, whose boundary in an ellipse's upper half is
  /// connected and ends on the real axis. May be empty.
  std::function<std::optional<known_bound>(double_interval re, double_interval im)> known;
  /// Not empty where F(t + 1) = F(t) near t = 0, or F is even about t = 0 and about t = 1, if it is
  /// analytic there (see mean_trapezoid_error): given n and p, returns a factory of evaluators k ->
  /// F((k + 1/2)/n) with p bits.
  std::function<std::function<std::function<ball(long k)>()>(long n, precision p)> equidistant;
  /// Where F is not real for real t. F must then be analytic for 0 < t < 1; the lower halves of
  /// ellipses are looked at too.
  std::optional<complex_piece> along = std::nullopt;
  /// The values of F count only as its analytic continuation from t = 0 along 0 <= t <= 1: it must
  /// be proved analytic everywhere there. Its points are then none of the x.
  bool continued = false;
};

struct part;
struct turned_rays;
struct rays_of_range;
struct folded_tail;
struct substituted;

/// A function in the arithmetics that the library needs.
struct integrand {
  std::function<region(const region& x)> over;
  std::function<std::function<ball(const ball& x)>(precision p)> evaluator;
  /// The same of equidistant arguments. May be empty.
  std::function<std::function<ball(const angle& x)>(precision p)> angle_evaluator;
  std::function<end_series(const end_series& x)> near_end;
  /// Integrals whose sum is that over the range from a to b: over parts of it, of functions without
  /// the abs, min, max, floor and ceil of this one; or in other variables, in which it turns or
  /// steps at one pace. None where there are none of these, or they are not known; may be empty.
  std::function<std::vector<part>(const end_point& a, const end_point& b)> pieces;
  /// The same over an infinite range: beyond some point of limits and of what decays beside them,
  /// or of the same function by exponentials that decay, for an integrand with a tail that is not
  /// understood as it stands. May be empty.
  std::function<std::vector<part>(const end_point& a, const end_point& b)> with_limits;
  /// The same over an infinite range: over parts of it, beyond some point of the same function by
  /// scaled functions. May be empty.
  std::function<std::vector<part>(const end_point& a, const end_point& b)> scaled;
  /// Numbers at which it may be of interest to cut the range: candidates. May be empty.
  std::function<std::vector<end_point>(const end_point& a, const end_point& b)> candidates;
  /// f(x) |dx/ds| with x = end + side e^-s at a finite end, x = side e^s at an infinite one, in
  /// which what is a power of the distance or of x is an exponential. Nothing where that is not
  /// available; may be empty.
  std::function<std::optional<integrand>(const end_point& end, int side)> in_exponential;
  /// The integral from a to b by an antiderivative at the ends, by the precision. Nothing where
  /// none is known; may be empty.
  std::function<std::function<ball(precision p)>(const end_point& a, const end_point& b)>
      antiderivative;
  /// The integral from some p >= `from` to infinity (to the end of sign `side`, for |x| >= p) as a
  /// sum of others. Nothing where that is not available; may be empty.
  std::function<std::optional<turned_rays>(const rational& from, int side)> on_turned_rays;
  /// The integral over a part of [a, b], 0 not inside, as a sum of others, where f turns more often
  /// than `least_turns` in [a, b]. Nothing where that is not available; may be empty.
  std::function<std::optional<rays_of_range>(const rational& a, const rational& b,
                                             double least_turns)>
      between_turned_rays;
  /// The integral over [a, b] as that of another function, which oscillates less fast. Nothing
  /// where none is known; may be empty.
  std::function<std::optional<substituted>(const end_point& a, const end_point& b)> by_exponential;
  /// The integral beyond some |x| >= `from`, to the infinity of sign `side`, as one over a period
  /// but for a rest of about 2^-p of its size. Nothing where that is not available; may be empty.
  std::function<std::optional<folded_tail>(const rational& from, int side, precision p)>
      folded_at_infinity;
  std::function<tail_series(const tail_series& x)> near_infinity;
  /// How fast it grows at an end where it has no series. May be empty.
  std::function<growth_bound(const growth_bound& x)> growth;
  /// Proved: the integral over x >= from, or x <= from where from is negative, diverges. May be
  /// empty.
  std::function<bool(const rational& from)> diverges_beyond;
  /// May be empty: then no symmetry is known.
  std::function<symmetry(const symmetry& x)> under;
  /// Its operations, which are looked at on the first call; may be empty: then no breaks are looked
  /// for.
  std::function<std::shared_ptr<const formula_graph>()> graph;
};

/// sign times the integral of f over [lower, upper].
struct part {
  integrand f;
  end_point lower;
  end_point upper;
  int sign = 1;
};

/// The sum of the integrals of the parts over [0, infinity) is that beyond `start`.
struct turned_rays {
  rational start;
  std::vector<integrand> parts;
};

/// The sum of the integrals of `added` over [0, infinity), less those of `subtracted`, and those of
/// `steady` over [a, b] is that over [a, b]; the rest of the range, if any, is nearer to 0.
struct rays_of_range {
  rational lower;
  rational upper;
  std::vector<integrand> added;
  std::vector<integrand> subtracted;
  std::vector<integrand> steady;
};

/// The integral is that of f from `lower` to `upper`.
struct substituted {
  integrand f;
  end_point lower;
  end_point upper;
};

/// The integral beyond `start` is that of `folded` over [lower, upper], but for a number of at most
/// `rest` in size.
struct folded_tail {
  end_point start;
  integrand folded;
  end_point lower;
  end_point upper;
  magnitude rest;
};

[[nodiscard]] integral integrate_function(const integrand& f, const end_point& a,
                                          const end_point& b, const integrate_options& options);

/// x = a + (b - a) t, in the region's own arithmetic.
class affine_map {
 public:
  affine_map(const end_point& a, const end_point& b);
  [[nodiscard]] region operator()(const region& t) const;
  [[nodiscard]] ball operator()(const ball& t) const;
  [[nodiscard]] ball start(precision p) const { return a_.at(p); }
  [[nodiscard]] ball length(precision p) const {
    if (!a_.exact() || !b_.exact()) return b_.at(p) - a_.at(p);
    return {rational(*b_.exact() - *a_.exact()), p};
  }

 private:
  end_point a_;
  end_point b_;
  region a_hardware_;
  region length_hardware_;
};

}  // namespace detail

/// f in the arithmetics of quadrature. Throws input_error where f has more than one variable.
[[nodiscard]] detail::integrand integrand_of(const expression& f);

}  // namespace polhode
