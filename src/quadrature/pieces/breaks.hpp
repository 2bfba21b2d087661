#pragma once

// Where a function made of analytic pieces passes from one to another.

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// A part of the range on which each abs, min, max, floor and ceil of f is proved to be one of its
/// branches, or is left as it is; and f with these branches, which is f's continuation from the
/// piece.
struct piece {
  end_point left;
  end_point right;
  integrand f;
  /// The same, which knows besides that at that end, a break, the function that changes there is
  /// exactly 0.
  integrand at_left;
  integrand at_right;
};

struct pieces_of_range {
  std::vector<piece> pieces;
  /// Holds what the pieces leave out: what lies between two breaks that cannot be told apart.
  ball remainder = ball(0, 64);
  /// There is something left out; more bits make it smaller.
  bool has_remainder = false;
};

/// Cuts the finite range from a to b, a < b as far as is known, at the breaks of the integrand, f.
/// A break is a simple zero r of some t(x) - n, where t decides between the branches: it is
/// isolated in an interval X on which t' has one sign and t - n opposite signs at the ends (so that
/// there is one zero and no more), and is a `limit`, found to any precision by the interval Newton
/// method. A rational zero of t may have any order: there the series of t has one sign on each
/// side. At a multiple of pi where all branches are the same on both sides, by such series, there
/// is no break. On each piece between breaks the branches are proved by covering all of it with
/// intervals, on each of which ranges and slopes decide them. Breaks of different t that may be
/// one, a t that touches 0 elsewhere without a change of sign, and a break that may be the end of
/// the range are cut out as an interval of width about 2^-bits of the range, whose part of the
/// integral is bounded by the ranges of f and of its neighbours over it. What cannot be resolved
/// with a limited effort is a piece in which f is left as it is.
[[nodiscard]] pieces_of_range analytic_pieces(const integrand& g, const end_point& a,
                                              const end_point& b, long bits);

/// The least n >= e, n <= e + 16, such that g is proved to have no break at sign * x for x >= 2^n;
/// e where there is none.
[[nodiscard]] unsigned long exponent_beyond_breaks(const integrand& g, unsigned long e, int sign);

}  // namespace polhode::detail
