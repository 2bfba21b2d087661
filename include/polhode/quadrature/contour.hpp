#pragma once

// Integrals along paths in the complex plane, with a proof.
//
//   const auto f = [](const auto& z) { return exp(z) / pow(z, 3); };
//   contour_integral i = integrate_along(f, path::circle(0, 1), {.digits = 50});   // pi i
//
// f is a formula or a generic function, as for `integrate`. It is evaluated over a `region`, to
// prove where it is analytic and how large it is there, and over complex balls at the nodes.
//
// What is proved: f, with the branch cuts that complex_ball.hpp and region.hpp say its functions
// have, is analytic on a neighbourhood of every piece of the path but for the piece's ends. A path
// that crosses a cut, or runs along one, or through a pole, is refused, however near to an end that
// is. At an end of a piece f need not be analytic where it is bounded (sqrt(z) at 0, or at -1);
// beside such an end one looks for cuts down to 2^-420 of the piece's length, or less for many
// digits. Nearer to it the values of f are its principal ones. And that the pieces join:
// integrate_along says how. How: integrate.hpp says; the ellipses around a panel are covered
// wholly, for f is not real on it.

#include <concepts>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/quadrature/integrate.hpp"

namespace polhode {

/// A point of the complex plane: exact, a set, or a number that can be had to any precision.
class path_point {
 public:
  /// re + im i. What is a limit is a part: an exact number, a ball, a function of the precision.
  /// Throws std::invalid_argument where a part is infinite.
  template <class N>
  requires std::convertible_to<const N&, end_point> path_point(
      const N& re)  // NOLINT(google-explicit-constructor): exact, or the same set
      : path_point(end_point(re), end_point(0)) {}
  path_point(const end_point& re, const end_point& im);
  /// The set z, whose width the result cannot fall below.
  path_point(const complex_ball& z)  // NOLINT(google-explicit-constructor): the same set
      : path_point(end_point(z.re), end_point(z.im)) {}
  /// A number that at(p) encloses with p bits.
  explicit path_point(const std::function<complex_ball(precision)>& at)
      : re_([at](precision p) { return at(p).re; }), im_([at](precision p) { return at(p).im; }) {}

  [[nodiscard]] complex_ball at(precision p) const { return {re_.at(p), im_.at(p)}; }
  [[nodiscard]] const end_point& re() const { return re_; }
  [[nodiscard]] const end_point& im() const { return im_; }

  /// Certainly the same number: each part is, as end_point::is_same_as says.
  [[nodiscard]] bool is_same_as(const path_point& other) const {
    return re_.is_same_as(other.re_) && im_.is_same_as(other.im_);
  }

 private:
  end_point re_;
  end_point im_;
};

/// The straight line between two points.
struct line_piece {
  path_point from;
  path_point to;
};
/// centre + radius e^(i angle), from one angle to the other, which may be the smaller one. A
/// negative radius is that of the opposite arc.
struct arc_piece {
  path_point centre;
  end_point radius;
  end_point from_angle;
  end_point to_angle;
};
using path_piece = std::variant<line_piece, arc_piece>;

/// Pieces one after the other. Each starts where the one before it ends; integrate_along refuses
/// others.
class path {
 public:
  /// No piece: every integral is 0.
  path() = default;
  [[nodiscard]] static path line(const path_point& from, const path_point& to);
  /// Straight lines from each point to the next; give the first one again at the end to close it.
  [[nodiscard]] static path polygon(const std::vector<path_point>& points);
  [[nodiscard]] static path arc(const path_point& centre, const end_point& radius,
                                const end_point& from_angle, const end_point& to_angle);
  /// Once around, counterclockwise, from centre + radius.
  [[nodiscard]] static path circle(const path_point& centre, const end_point& radius);

  [[nodiscard]] const std::vector<path_piece>& pieces() const { return pieces_; }
  /// The one and then the other.
  friend path operator+(path first, const path& second);
  /// The other way round: every integral changes its sign.
  friend path operator-(const path& reversed);

 private:
  std::vector<path_piece> pieces_;
};

/// An integral along a path with its proof, or how far it got.
struct contour_integral : certified_integral<complex_ball> {};

namespace detail {

/// A function of complex numbers, in the arithmetics that the library needs.
struct complex_integrand {
  std::function<region(const region& z)> over;
  std::function<std::function<complex_ball(const complex_ball& z)>(precision p)> evaluator;
};

/// The same of the real part.
[[nodiscard]] inline integral real_part(const contour_integral& i) {
  return {{{{i.verdict, i.why, i.obstacle}, i.enclosure.re}, i.account}};
}

[[nodiscard]] contour_integral integrate_path(const complex_integrand& f, const path& along,
                                              const integrate_options& options);

}  // namespace detail

/// f in the arithmetics of integrals along paths. Its first variable is the argument; where it has
/// a second one, that is the imaginary unit. Throws input_error where it has more.
[[nodiscard]] detail::complex_integrand complex_integrand_of(const expression& f);

/// The integral of f(z) dz along a path, for a formula as complex_integrand_of has it. Each part of
/// the enclosure has a radius of at most 10^-options.digits of the integral's size, or of that
/// which options says, where it is certified. Verdicts as of `integrate`; not_analytic says which
/// function is in the way, and near which z. A piece without length (points that are the same,
/// radius 0, equal angles) adds 0, and f is not asked there.
///
/// That a piece starts where the one before it ends is proved where both points are one path_point
/// or both are exact, as the corners of a polygon are. Of others, such as the ends of arcs,
/// equality cannot be proved: their enclosures to twice the digits must overlap. Throws
/// std::invalid_argument where pieces do not join, and for options.digits < 1.
[[nodiscard]] contour_integral integrate_along(const expression& f, const path& along,
                                               const integrate_options& options = {});

/// The same of a generic function of one argument, through its formula.
template <class F>
[[nodiscard]] contour_integral integrate_along(const F& f, const path& along,
                                               const integrate_options& options = {}) {
  return integrate_along(complex_formula_of(f), along, options);
}

}  // namespace polhode
