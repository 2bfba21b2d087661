#pragma once

// The proof that a function is analytic in an ellipse around a panel, and its bound there.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "panel_regions.hpp"

namespace polhode::detail {

/// The Bernstein ellipse with foci -1 and 1: semi-axes (rho + 1/rho)/2 and (rho - 1/rho)/2.
struct ellipse {
  explicit ellipse(double parameter) : rho(parameter) {
    const double_interval r(parameter);
    a = (r + 1 / r) / 2;
    b = (r - 1 / r) / 2;
  }
  double rho;
  double_interval a;
  double_interval b;
};

/// sqrt(1 - c^2) over [low, high], -1 <= low <= high <= 1.
inline double_interval sine_over(double low, double high) {
  const auto sine = [](double c) {
    const double_interval x(c);
    return sqrt(max(double_interval(0), (1 - x) * (1 + x)));
  };
  const double_interval ends = hull(sine(low), sine(high));
  return low < 0 && high > 0 ? hull(ends, double_interval(1)) : ends;
}

struct obstacle_report {
  obstacle why = obstacle::none;
  std::string_view where;
};

inline std::string in_words(const obstacle_report& report) {
  const std::string name(report.where);
  switch (report.why) {
    case obstacle::none:
      return "a bound too large to be of use";
    case obstacle::unknown:
      return name + " of complex arguments is not available";
    case obstacle::undefined:
      return "an undefined value" + (name.empty() ? "" : " in " + name);
    default:
      return "the " + to_text(report.why) + " of " + name;
  }
}

/// Proves F analytic inside an ellipse and bounds it there.
///
/// F is real on the panel. Where it is analytic on a neighbourhood of the closed upper half of the
/// ellipse, Schwarz's reflection F(conj z) = conj F(z) continues it to the lower half, with the
/// same bound. Tiles cover the upper half; by the maximum principle |F| inside is at most its
/// supremum on the boundary, whose upper half is covered by arcs. Where F is not real there
/// (`whole`), tiles and arcs cover the lower halves too.
class ellipse_bounds {
 public:
  ellipse_bounds(const panel_regions& f, int most_tiles, bool whole, std::optional<box> suspect)
      : f_(f), most_tiles_(whole ? 2 * most_tiles : most_tiles), whole_(whole), suspect_(suspect) {}

  /// The bound from the tiles that prove analyticity; nothing where that failed.
  /// A bound above the limit is as good as none.
  [[nodiscard]] std::optional<magnitude> inside(const ellipse& e, const magnitude& limit) {
    if (const std::optional<tile> first = tile_at_suspect(e)) {
      if (!cover({*first}, e, limit)) return std::nullopt;
    }
    std::vector<tile> all{{-1, 0, 0, 1, 0}, {0, 1, 0, 1, 0}};
    if (whole_) {
      all.push_back({-1, 0, 0, 1, 0, true});
      all.push_back({0, 1, 0, 1, 0, true});
    }
    return cover(std::move(all), e, limit);
  }
  /// The tile at which `inside` failed last, or what was given.
  [[nodiscard]] const std::optional<box>& suspect() const { return suspect_; }

  /// The bound from so many arcs of the boundary. The ellipse must have been proved analytic
  /// inside.
  [[nodiscard]] magnitude on_boundary(const ellipse& e, int arcs) const {
    magnitude supremum;
    double right = 1;
    for (int k = 1; k <= arcs; ++k) {
      const double left = k == arcs ? -1 : std::cos(3.14159265358979 * k / arcs);
      const double_interval re = e.a * double_interval(left, right);
      const double_interval im = e.b * sine_over(left, right);
      supremum = max(supremum, f_(re, im).magnitude_upper());
      if (whole_) supremum = max(supremum, f_(re, -im).magnitude_upper());
      if (supremum.is_infinite()) break;
      right = left;
    }
    return supremum;
  }

  void note(const region& value) { report_ = {value.why(), value.where()}; }
  [[nodiscard]] const obstacle_report& report() const { return report_; }

 private:
  struct tile {
    double left, right, bottom, top;  // in units of the semi-axes
    int depth;
    bool below = false;  // its mirror image is meant
  };

  /// The bound over the tiles, halved where that is needed.
  [[nodiscard]] std::optional<magnitude> cover(std::vector<tile> open, const ellipse& e,
                                               const magnitude& limit) {
    magnitude supremum;
    int tiles = 0;
    while (!open.empty()) {
      const tile t = open.back();
      open.pop_back();
      if (++tiles > most_tiles_) return failed_at(t, e);
      // The part of the tile in the ellipse.
      const double highest = sine_over(t.left, t.right).upper();
      if (t.bottom > highest) continue;
      const double_interval re = e.a * double_interval(t.left, t.right);
      const double_interval im = e.b * double_interval(t.bottom, std::min(t.top, highest));
      const region value = f_(re, t.below ? -im : im);
      if (value.is_analytic()) {
        const magnitude upper = value.magnitude_upper();
        if (upper <= limit) {
          supremum = max(supremum, upper);
          continue;
        }
        if (t.depth >= 2 || value.magnitude_lower() > limit) return failed_at(t, e);
      } else {
        note(value);
      }
      if (t.depth >= deepest) return failed_at(t, e);
      const double width = (t.right - t.left) * e.a.upper();
      const double height = (std::min(t.top, highest) - t.bottom) * e.b.upper();
      if (width >= height) {
        const double middle = (t.left + t.right) / 2;
        open.push_back({t.left, middle, t.bottom, t.top, t.depth + 1, t.below});
        open.push_back({middle, t.right, t.bottom, t.top, t.depth + 1, t.below});
      } else {
        const double middle = (t.bottom + std::min(t.top, highest)) / 2;
        open.push_back({t.left, t.right, middle, t.top, t.depth + 1, t.below});
        open.push_back({t.left, t.right, t.bottom, middle, t.depth + 1, t.below});
      }
    }
    return supremum;
  }
  std::nullopt_t failed_at(const tile& t, const ellipse& e) {
    const double a = e.a.midpoint();
    const double b = e.b.midpoint();
    suspect_ = {t.left * a, t.right * a, t.bottom * b, t.top * b, t.below};
    return std::nullopt;
  }
  /// What of the suspect is in the ellipse, with the depth of tiles of its size: all tiles around
  /// it need not be looked at to see the ellipse fail. Proves nothing.
  [[nodiscard]] std::optional<tile> tile_at_suspect(const ellipse& e) const {
    if (!suspect_) return std::nullopt;
    const double a = e.a.midpoint();
    const double b = e.b.midpoint();
    tile t{std::max(suspect_->left / a, -1.0),
           std::min(suspect_->right / a, 1.0),
           suspect_->bottom / b,
           std::min(suspect_->top / b, 1.0),
           0,
           suspect_->below};
    if (!(t.left < t.right) || !(t.bottom < t.top)) return std::nullopt;
    if (t.bottom > sine_over(t.left, t.right).upper()) return std::nullopt;
    t.depth = std::clamp(-std::ilogb((t.right - t.left) * (t.top - t.bottom)) - 1, 0, deepest);
    return t;
  }

  static constexpr int deepest = 6;
  const panel_regions& f_;
  int most_tiles_;
  bool whole_;
  std::optional<box> suspect_;
  obstacle_report report_;
};

}  // namespace polhode::detail
