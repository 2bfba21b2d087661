#pragma once

// A panel: a part of a segment on which one rule serves, and how its integral is to be had.

#include <optional>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/quadrature/rule.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/rules/periodic.hpp"
#include "tiling/tiling.hpp"

namespace polhode::detail {

/// A rectangle in the coordinates in which a panel is [-1, 1].
struct box {
  double left, right, bottom, top;
  bool below = false;  // its mirror image is meant
};

/// A part of a segment, |t - centre| <= 2^-(level+1), and how its integral is to be had.
struct panel {
  std::size_t segment = 0;
  rational centre;
  long level = 0;

  std::optional<complex_ball> closed_by;  // the range of F over it, where that is enough
  bool by_range_only = false;             // that it is, though nothing else is known of F there
  bool is_analytic = false;               // F is, on the panel itself
  double rho = 0;      // else: F is analytic inside the Bernstein ellipse with this parameter ...
  magnitude supremum;  // ... and this is a bound of |F| there
  double log2_typical = 0;  // about log2 |F| at its middle, to search with
  long nodes = 0;
  const panel_rule* rule = nullptr;
  /// Of the trapezoidal rule, which stands for the rule and the ellipse: the panel is a whole
  /// segment.
  std::optional<periodic_strip> strip;
  std::optional<box>
      suspect;  // where no ellipse was found, what was in the way last: to look there first

  [[nodiscard]] rational half_length() const {
    integer one = 1;
    return {integer(1), one << static_cast<unsigned>(level + 1)};
  }
  /// The values of t on it.
  [[nodiscard]] exact_interval interval() const {
    const rational half = half_length();
    return {centre - half, rational(centre + half)};
  }
  [[nodiscard]] piece_done piece() const {
    const exact_interval all = interval();
    return {piece_end(*all.lower), piece_end(*all.upper)};
  }
  /// It reaches to t = 0 or to t = 1.
  [[nodiscard]] bool is_at_end() const {
    const rational half = half_length();
    return centre == half || centre == 1 - half;
  }
  [[nodiscard]] panel half(int side) const {
    panel p;
    p.segment = segment;
    p.level = level + 1;
    p.rule = rule;
    p.centre = centre + side * p.half_length();
    if (suspect) {
      const box& b = *suspect;
      p.suspect = {2 * b.left - side, 2 * b.right - side, 2 * b.bottom, 2 * b.top, b.below};
    }
    return p;
  }
};

/// What a rule gives for a panel: an integral of F, and what it is over.
struct panel_sum {
  complex_ball value;
  piece_done done;
};

}  // namespace polhode::detail
