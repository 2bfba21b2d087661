#pragma once

// Which branch of each abs, min, max, floor and ceil of a formula holds over an interval
// of x.

#include <optional>

#include "quadrature/formula/formula_graph.hpp"

namespace polhode::detail::breaks {

/// A decider goes through n strictly monotonely.
struct crossing {
  std::size_t decider = 0;
  long n = 0;
  bool ascending = true;
};

/// An interval of x, with what was found out about f on it.
struct interval {
  rational low;
  rational high;
  long level = 0;
  [[nodiscard]] rational width() const { return high - low; }
  /// About that.
  [[nodiscard]] std::int64_t log2_width() const {
    return ball(width(), 64).magnitude_upper().log2_floor();
  }
  [[nodiscard]] rational middle() const { return (low + high) / 2; }
  [[nodiscard]] ball set(precision p) const { return hull(ball(low, p), ball(high, p)); }
  /// What it takes to tell its points apart.
  [[nodiscard]] precision bits() const { return 96 + 2 * level; }
};

/// The branches over a set.
struct traced {
  choices chosen;
  bool decided = true;  // all of them
  // Of the first that is not, where its decider is strictly monotone and has one n at most to go
  // through:
  std::optional<crossing> suspect;
  ball slope;
  bool crosses = false;  // it does
};

/// The branches over a set with these ends; `side` of a given crossing (-1: before it), or 0.
[[nodiscard]] traced trace(const formula_graph& f, const ball& x, const ball& low, const ball& high,
                           const crossing* given, int side);

/// Proved: at m no decider is where its branch changes.
[[nodiscard]] bool is_away_from_changes(const formula_graph& f, const ball& m);

/// The branches on (m, m + reach], or for side = -1 on [m - reach, m), each by the sign of its
/// decider's series at m over all of it, or by its range: so also where a decider is 0 at m, of
/// whatever order. None where one is not known.
[[nodiscard]] std::optional<choices> branches_beside(const formula_graph& f, const known_number& m,
                                                     int side, const rational& reach);

}  // namespace polhode::detail::breaks
