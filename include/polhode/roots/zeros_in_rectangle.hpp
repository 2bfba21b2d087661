#pragma once

// The zeros of an analytic function in a rectangle of the complex plane, each proved.
//
//   const expression f = parse("exp(z)-z", {"z"});
//   const zeros_answer found = zeros_in_rectangle(f, {-5, 5, -10, 10}, {.digits = 30});
//   for (const complex_zero& z : found.zeros) ...
//
// THE SEARCH. The rectangle is halved. A part on which an enclosure of f does not hold 0 has no
// zero. In one on which f is analytic a zero is looked for by the secant method, which proves
// nothing, and two squares around what it finds are examined: a small one, and one as large as can
// be.
//
// The zeros are those of the numerator of f (expression::as_fraction) at which no divisor is 0.
// Where numerator and divisor may both be 0, exact rules decide at simple real numbers. Beside a
// branch cut and on it, principal values show that there is no zero.
//
// THE PROOF. Let f be analytic on a closed square and not 0 on its boundary. Cut the boundary into
// pieces on each of which f has an enclosure without 0 that is convex; then f does not leave an
// open half plane around 0 there, and the change of arg f along a piece is the principal argument
// of the quotient of its values at the ends. The sum of these is 2 pi times the number of zeros
// inside, with their multiplicities (argument principle; L. V. Ahlfors, Complex Analysis, 4.5.2),
// and an enclosure of the sum that holds one multiple of 2 pi gives the number. Where both squares
// have the same number, all zeros of the large one lie in the small one; parts inside the large one
// need no more work.

#include <functional>
#include <string>
#include <vector>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {

/// left <= Re z <= right, bottom <= Im z <= top.
struct complex_rectangle {
  rational left;
  rational right;
  rational bottom;
  rational top;
};

struct complex_zero {
  /// Holds exactly `multiplicity` zeros, with their multiplicities: one, or several that are not
  /// told apart; the imaginary part is exactly 0 where the zero is proved real. The radii are at
  /// most 10^-digits of the greater part's size, or 10^-2digits, unless the multiplicity is above
  /// 1.
  complex_ball enclosure;
  long multiplicity = 1;
  /// It is certain that they lie in the rectangle; else they lie near its boundary.
  bool is_inside = true;
  /// They are proved to be one zero of that multiplicity.
  bool is_one = true;
};

/// A part of the rectangle of which nothing is decided.
struct undecided_rectangle {
  complex_rectangle where;
  /// "the branch cut of log", "0/0"; empty where zeros may be too close to each other.
  std::string obstacle;
};

struct zeros_answer {
  /// In ascending order of the real parts' midpoints, then of the imaginary parts'.
  std::vector<complex_zero> zeros;
  std::vector<undecided_rectangle> undecided;
  /// Every zero in the rectangle is in the list.
  [[nodiscard]] bool is_complete() const { return undecided.empty(); }
};

struct zeros_options {
  long digits = 15;
  /// How often the rectangle is halved in each direction at most.
  int most_depth = 40;
  /// So many parts are looked at; the others are undecided.
  long most_parts = 200'000;
  /// Called now and then with the number of zeros found; false ends the search.
  std::function<bool(std::size_t)> go_on = {};
};

/// The zeros of f, a formula of one variable, or of two, of which the second is the imaginary unit.
/// Throws input_error for formulas of others, with a function that is not analytic (abs, min, max,
/// floor, ceil), for what is 0 everywhere, and for a rectangle without interior;
/// std::invalid_argument where digits < 1.
[[nodiscard]] zeros_answer zeros_in_rectangle(const expression& f, const complex_rectangle& where,
                                              const zeros_options& options = {});

}  // namespace polhode
