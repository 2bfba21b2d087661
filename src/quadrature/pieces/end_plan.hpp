#pragma once

// What is known of a function near an end of its range, and how the end is dealt with.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quadrature/formula/integrand.hpp"
#include "quadrature/pieces/segments.hpp"

namespace polhode::detail::ends {

/// a + factor b.
[[nodiscard]] end_point sum_of(const end_point& a, const end_point& b, const rational& factor);
[[nodiscard]] end_point difference(const end_point& a, const end_point& b);

/// A limit moved: from it, in the direction of another point.
struct end_of_range {
  end_point at;        // p; for an infinite end, 0
  end_point distance;  // s: the argument is p + s t^q, 0 < t <= 1; at infinity s t^q with q < 0
  bool infinite = false;
  end_point end;    // t = 0: p, or an infinity
  end_point start;  // t = 1: p + s

  [[nodiscard]] static end_of_range finite(const end_point& end, const end_point& start) {
    return {end, difference(start, end), false, end, start};
  }
  /// The infinity of this sign; the start, which is not 0, has the same sign.
  [[nodiscard]] static end_of_range infinity(int sign, const end_point& start) {
    const end_point end = sign > 0 ? end_point::infinity() : -end_point::infinity();
    return {end_point(0), start, true, end, start};
  }
  /// Whether the integral runs to the end: with direction 1 it runs from a finite end, and to an
  /// infinite one.
  [[nodiscard]] bool is_reached_last(int direction) const { return (direction > 0) == infinite; }
  /// Between two points, of which the first is nearer to the end.
  [[nodiscard]] part_done part(const end_point& near, const end_point& far, int direction) const {
    return is_reached_last(direction) ? part_done{far, near} : part_done{near, far};
  }
};

/// How an end is dealt with.
enum class manner { regular, power, exponential, divergent, unknown };

struct end_plan {
  manner how = manner::unknown;
  long q = 1;
  double r = 0;           // the series holds for |Re t|, |Im t| <= r
  rational exponent = 0;  // M: F(t) = t^M (G_0 + L G_1 + ...) with the substitution's factor in it
  std::vector<magnitude> bounds;  // of |G_k|
  /// There is no series: |F(t)| <= t^M bounds[0] for 0 < t <= r, and nothing is known off the real
  /// line.
  bool has_growth_only = false;
  /// As growth_bound::has_growing_parts: a last resort.
  bool has_growing_parts = false;
  /// Panels have to follow an oscillation: a last resort.
  bool oscillates = false;
  std::string obstacle;
  /// Where look_at_end knows no other plan than a last resort, that one.
  std::shared_ptr<const end_plan> last_resort = nullptr;
  bool growth_is_known = false;  // look_at_end has asked for it
};

[[nodiscard]] known_number exactly(const end_point& x);

/// Looks at f near an end. Tries substitutions x = p + s t^q for small q.
[[nodiscard]] end_plan look_at_end(const integrand& f, const end_of_range& end);

/// What the growth of f proves at an end of which look_at_end says this, as nothing better is
/// known: that f is integrable, and how small the part beside the end is; or that it is not, as
/// |f| >= c t^a with one sign and a <= -1.
[[nodiscard]] std::optional<end_plan> last_resort(const integrand& f, const end_of_range& end,
                                                  const end_plan& seen);

/// Whether f is analytic on a neighbourhood of the end, by regions alone.
[[nodiscard]] bool is_regular(const integrand& f, const end_of_range& end);

}  // namespace polhode::detail::ends
