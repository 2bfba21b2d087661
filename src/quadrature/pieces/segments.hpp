#pragma once

// From a function and its limits to analytic pieces: what happens at the ends.

#include "polhode/quadrature/contour.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The part of a range from one point to another, in the direction of the integral.
struct part_done {
  end_point from;
  end_point to;
};

/// The segments whose integrals make up an integral, and what they leave out.
struct preparation {
  std::vector<segment> segments;
  /// Holds the sum of what the segments do not cover: tails beyond where they are cut off.
  ball remainder = ball(0, 64);
  /// A tail was cut off for the given number of bits; more bits make it smaller.
  bool has_tail = false;
  /// About log2 of how many periods the segments stand for: a value counts as 0 beside the integral
  /// of |f| over one.
  long log2_periods = 0;
  reason why = reason::none;  // where it cannot be done
  std::string obstacle;
  /// What the segments and the remainder stand for: each that is added says it here.
  std::vector<part_done> parts;
};

/// The parts run from a to b, each from where another one ends: their integrals add up to that from
/// a to b. Points are the same where end_point::is_same_as says so.
[[nodiscard]] bool is_tiled(const std::vector<part_done>& parts, const end_point& a,
                            const end_point& b);

/// The range from a to b, cut at points between them, in increasing order. a < b as far as is
/// known, or neither is infinite. The tails, where there are any, are made smaller than about
/// 2^-bits of the rest. Throws std::logic_error where the parts do not tile the range, whatever
/// they say.
[[nodiscard]] preparation prepare(const integrand& f, const end_point& a, const end_point& b,
                                  const std::vector<end_point>& cuts, long bits);

/// a < q < b, certainly: what is proved of f at q is said of the integral.
[[nodiscard]] bool is_inside(const end_point& q, const end_point& a, const end_point& b);

/// On both sides of q, f is known by a series, or is known to grow too fast there.
[[nodiscard]] bool can_cut_at(const integrand& f, const end_point& q);

/// The sum of the integrals of the segments, and the remainder.
[[nodiscard]] contour_integral integrate_segments(const preparation& prepared,
                                                  const integrate_options& options);

}  // namespace polhode::detail
