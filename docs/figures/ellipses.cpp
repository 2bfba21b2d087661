// What integrate() does for the integral of 1/(1 + 25 (x - 1/3)^2) over [-1, 1], for the picture in
// docs/quadrature.md.
//
// The integrand notes what it is asked: regions while bounds are looked for, numbers at the nodes.
// Nothing is computed here that integrate() did not ask for. Printed for gnuplot, as blocks two
// empty lines apart: the ends of the panels; the ellipses (those of the panels that were summed up,
// the last one proved of each); the tiles that proved them, left, bottom, right, top; the nodes.

#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/quadrature/integrate.hpp"

namespace {

using namespace polhode;

struct rectangle_asked {
  double left, right, bottom, top;
  bool analytic;
};

struct notes {
  std::vector<rectangle_asked> regions;
  std::vector<double> nodes;  // since the last region
};

class noting_integrand {
 public:
  explicit noting_integrand(std::shared_ptr<notes> to) : to_(std::move(to)) {}

  [[nodiscard]] region operator()(const region& x) const {
    const region y = value(x);
    if (x.is_in_hardware()) {
      to_->regions.push_back(
          {x.re().lower(), x.re().upper(), x.im().lower(), x.im().upper(), y.is_analytic()});
      to_->nodes.clear();
    }
    return y;
  }
  [[nodiscard]] ball operator()(const ball& x) const {
    to_->nodes.push_back(double_interval::from_ball(x).midpoint());
    return value(x);
  }
  template <class T>
  [[nodiscard]] T operator()(const T& x) const {
    return value(x);
  }

 private:
  template <class T>
  static T value(const T& x) {
    return 1 / (1 + 25 * square(x - rational(1, 3)));
  }
  std::shared_ptr<notes> to_;
};

constexpr double close_to = 1e-9;
bool is(double x, double y) { return std::abs(x - y) < close_to; }

/// An ellipse with foci at a panel's ends, tried: its semi-axes, and the tiles asked for.
struct attempt {
  double a, b;
  std::vector<rectangle_asked> tiles;
  bool bounded = false;  // its arcs were asked for, which is done where the tiles prove it
};

struct panel_notes {
  double centre, half;
  std::vector<attempt> attempts;
};

/// A panel begins with its real range; an ellipse with the tile over its upper right quarter, whose
/// sides are the semi-axes, a^2 - b^2 = 1; arcs with the one that ends at the right vertex and is
/// lower than a quarter.
std::vector<panel_notes> panels_of(const std::vector<rectangle_asked>& regions) {
  std::vector<panel_notes> result;
  bool arcs = false;
  for (const rectangle_asked& r : regions) {
    if (r.bottom == 0 && r.top == 0) {
      result.push_back({(r.left + r.right) / 2, (r.right - r.left) / 2, {}});
      continue;
    }
    if (result.empty()) continue;
    panel_notes& p = result.back();
    const double width = (r.right - r.left) / p.half;
    const double height = r.top / p.half;
    if (is(r.left, p.centre) && r.bottom == 0 && is(width * width - height * height, 1)) {
      p.attempts.push_back({width, height, {}});
      arcs = false;
    }
    if (p.attempts.empty()) continue;
    attempt& e = p.attempts.back();
    const double first_arc = p.centre + e.a * p.half * std::cos(std::acos(-1.0) / 6);
    if (is(r.right, p.centre + e.a * p.half) && is(r.left, first_arc)) {
      arcs = true;
      e.bounded = true;
    }
    if (!arcs) e.tiles.push_back(r);
  }
  return result;
}

/// Nodes come in pairs about the middle of their panel.
bool was_summed(const panel_notes& p, const std::vector<double>& nodes) {
  int pairs = 0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const bool inside = std::abs(nodes[i] - p.centre) < p.half;
    if (inside && is(nodes[i] + nodes[i + 1], 2 * p.centre)) ++pairs;
  }
  return pairs > 4;
}

/// A tile that was halved is not one of the proof.
bool was_halved(const rectangle_asked& r, const std::vector<rectangle_asked>& tiles) {
  for (const rectangle_asked& t : tiles) {
    const bool within = t.left > r.left - close_to && t.right < r.right + close_to &&
                        t.bottom > r.bottom - close_to && t.top < r.top + close_to;
    const bool smaller = (t.right - t.left) * (t.top - t.bottom) <
                         (r.right - r.left) * (r.top - r.bottom) * (1 - 1e-6);
    if (within && smaller) return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  const auto seen = std::make_shared<notes>();
  integrate_options options;
  options.digits = argc > 1 ? std::stol(argv[1]) : 30;
  options.rule = quadrature_rule::gauss_legendre;
  const integral i = integrate(noting_integrand(seen), -1, 1, options);
  if (i.verdict != status::certified) return 1;

  struct drawn {
    panel_notes of;
    attempt best;
  };
  std::vector<drawn> picture;
  for (const panel_notes& p : panels_of(seen->regions)) {
    if (!was_summed(p, seen->nodes)) continue;
    std::optional<attempt> best;
    for (const attempt& e : p.attempts) {
      if (e.bounded) best = e;
    }
    if (best) picture.push_back({p, *best});
  }
  std::printf("# panels: %ld, drawn: %zu\n", i.account.panels, picture.size());
  for (const drawn& d : picture) {
    std::printf("%.9g 0\n%.9g 0\n", d.of.centre - d.of.half, d.of.centre + d.of.half);
  }
  std::printf("\n\n# ellipses\n");
  for (const drawn& d : picture) {
    constexpr int points = 90;
    for (int k = 0; k <= points; ++k) {
      const double angle = 2 * std::acos(-1.0) * k / points;
      std::printf("%.9g %.9g\n", d.of.centre + d.of.half * d.best.a * std::cos(angle),
                  d.of.half * d.best.b * std::sin(angle));
    }
    std::printf("\n");
  }
  std::printf("\n# tiles\n");
  for (const drawn& d : picture) {
    for (const rectangle_asked& r : d.best.tiles) {
      if (r.analytic && !was_halved(r, d.best.tiles)) {
        std::printf("%.9g %.9g %.9g %.9g\n", r.left, r.bottom, r.right, r.top);
      }
    }
  }
  std::printf("\n\n# nodes\n");
  for (const double x : seen->nodes) std::printf("%.9g 0\n", x);
  return 0;
}
