#include "polhode/quadrature/integrate.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "breaks.hpp"
#include "insisted_double_exponential.hpp"
#include "parallel.hpp"
#include "periodic.hpp"
#include "poles.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/clenshaw_curtis.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/error_bounds.hpp"
#include "polhode/quadrature/gauss_legendre.hpp"
#include "segments.hpp"
#include "taylor_series.hpp"
#include "tiling.hpp"

namespace polhode {

std::string to_text(quadrature_rule rule) {
  switch (rule) {
    case quadrature_rule::automatic:
      return "automatic";
    case quadrature_rule::gauss_legendre:
      return "Gauss-Legendre";
    case quadrature_rule::clenshaw_curtis:
      return "Clenshaw-Curtis";
    case quadrature_rule::trapezoid:
      return "trapezoid";
    case quadrature_rule::double_exponential:
      return "double exponential";
    case quadrature_rule::taylor_series:
      return "Taylor series";
  }
  return "unknown";
}

}  // namespace polhode

namespace polhode::detail {

namespace {

using clock = std::chrono::steady_clock;

double seconds_since(clock::time_point start) {
  return std::chrono::duration<double>(clock::now() - start).count();
}

/// About log2 of x, to search with; -1e18 for 0 and 1e18 for infinity.
double approximate_log2(const magnitude& x) {
  if (x.is_zero()) return -1e18;
  if (x.is_infinite()) return 1e18;
  return std::log2(static_cast<double>(x.fraction())) + static_cast<double>(x.exponent());
}

/// The greater of the radii of both parts.
magnitude radius_of(const complex_ball& z) { return max(z.re.radius(), z.im.radius()); }

// A segment's functions in complex numbers, whether F is real for real t or not.

std::function<complex_ball(const ball& t)> evaluator_of(const segment& s, precision p) {
  if (s.along) return s.along->evaluator(p);
  return [f = s.evaluator(p)](const ball& t) { return complex_ball(f(t)); };
}
complex_ball scale_of(const segment& s, precision p) {
  return s.along ? s.along->scale(p) : complex_ball(s.scale(p));
}
complex_ball position_of(const segment& s, const ball& t) {
  return s.along ? s.along->position(t) : complex_ball(s.position(t));
}
/// z with what F's values may be off by.
complex_ball enlarged(const segment& s, const complex_ball& z, const magnitude& error) {
  return {z.re.enlarged(error), s.along ? z.im.enlarged(error) : z.im};
}
complex_ball at_most(const segment& s, const magnitude& bound) {
  return enlarged(s, complex_ball(0, 64), bound);
}

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
  double rho = 0;      // else: F is analytic inside the Bernstein ellipse with this parameter ...
  magnitude supremum;  // ... and this is a bound of |F| there
  double log2_typical = 0;  // about log2 |F| at its middle, to search with
  long nodes = 0;
  quadrature_rule rule = quadrature_rule::gauss_legendre;
  double half_width = 0;  // of the trapezoidal rule's strip, which stands for an ellipse
  std::optional<box>
      suspect;  // where no ellipse was found, what was in the way last: to look there first

  [[nodiscard]] rational half_length() const {
    integer one = 1;
    return {integer(1), one << static_cast<unsigned>(level + 1)};
  }
  /// The values of t on it.
  [[nodiscard]] closed_interval interval() const {
    const rational half = half_length();
    return {centre - half, rational(centre + half)};
  }
  [[nodiscard]] piece_done piece() const {
    const closed_interval all = interval();
    return {place(all.lower), place(*all.upper)};
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

/// The regions that tile the Bernstein ellipses of one panel. Coordinates are those in which the panel
/// is [-1, 1].
class panel_regions {
 public:
  panel_regions(const segment& s, const panel& p, long& evaluations)
      : segment_(s), panel_(p), evaluations_(evaluations) {
    // Where doubles would not keep its points well apart, balls with enough bits do.
    const rational half = p.half_length();
    const precision wide = 96 + 2 * p.level;
    const complex_ball left = position_of(s, ball(rational(p.centre - half), wide));
    const complex_ball right = position_of(s, ball(rational(p.centre + half), wide));
    const magnitude distance = (right - left).magnitude_upper();
    magnitude size = max(left.magnitude_upper(), right.magnitude_upper());
    for (const long end : {0L, 1L}) {  // the numbers whose sums the points are
      const complex_ball x = position_of(s, ball(end, 64));
      if (x.is_bounded()) size = max(size, x.magnitude_upper());
    }
    if (s.along) size = max(size, s.along->size);
    const auto gap_of = [](const magnitude& whole, const magnitude& part) {
      const bool finite = !whole.is_zero() && !whole.is_infinite() && !part.is_zero();
      return finite ? whole.log2_floor() - part.log2_floor() : 0;
    };
    const magnitude t = ball(p.centre, 64).magnitude_upper();
    const auto gap = static_cast<long>(
        std::max(gap_of(size, distance), gap_of(t, magnitude::power_of_two(-p.level - 1))));
    in_hardware_ = gap < 24 && p.level < 900;
    if (p.level < 900) {
      hardware_centre_ = double_interval(p.centre);
      hardware_half_ = double_interval(std::ldexp(1.0, static_cast<int>(-p.level - 1)));
    }
    if (!in_hardware_) {
      bits_ = 80 + std::max(gap, 0L) + p.level;
      ball_centre_ = ball(p.centre, bits_);
    }
  }

  /// F over the rectangle's part in an ellipse. Where a series for F is known, it holds on a set K; what lies
  /// outside of K is evaluated directly. Both are one analytic function: the direct one is analytic on a
  /// neighbourhood of the half ellipse less K, and agrees with the series along K's boundary in it, which is
  /// connected and begins at a real t > 0, where both are the real function. Inside K the direct one need not be F
  /// (a root may have another sign there): of a rectangle that lies partly in K, that part has the series' bound.
  ///
  /// Connected: for a half plane the boundary is a line's part in a convex set that is symmetric to the real axis.
  /// For a disc around 0 it is an arc. The ellipse has its centre c and its foci c +- h on t >= 0, c >= h, and
  /// semi-axes A >= h, B, A^2 - B^2 = h^2. On its boundary t = c + A cos u + i B sin u, 0 <= u <= pi, d|t|^2/du =
  /// -2 sin u (c A + h^2 cos u) <= 0: |t| falls from right to left, so that the points of the half ellipse with
  /// |t| = R have arguments from 0 up to some angle, without a gap.
  [[nodiscard]] region operator()(double_interval re, double_interval im) const {
    ++evaluations_;
    if (panel_.level < 900) {
      const double_interval t_re = hardware_centre_ + hardware_half_ * re;
      const double_interval t_im = hardware_half_ * im;
      if (segment_.known) {
        if (const std::optional<known_bound> known = segment_.known(t_re, t_im)) {
          const ball side = ball(0, 64).enlarged(known->bound);
          const complex_ball square(side, side);
          if (known->everywhere) return region(square);
          region direct = in_hardware_ ? segment_.over(region(t_re, t_im)) : over_balls(re, im);
          if (!direct.is_analytic()) return direct;
          return region(hull(square, direct.to_complex_ball()));
        }
      }
      if (in_hardware_) return segment_.over(region(t_re, t_im));
    }
    return over_balls(re, im);
  }

 private:
  [[nodiscard]] region over_balls(double_interval re, double_interval im) const {
    ball x = to_ball(re, bits_);
    ball y = to_ball(im, bits_);
    scale(x, x, -panel_.level - 1);
    scale(y, y, -panel_.level - 1);
    return segment_.over(region::in_balls({ball_centre_ + x, y}));
  }

  const segment& segment_;
  const panel& panel_;
  long& evaluations_;
  bool in_hardware_ = true;
  double_interval hardware_centre_;
  double_interval hardware_half_;
  precision bits_ = 0;
  ball ball_centre_;
};

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
double_interval sine_over(double low, double high) {
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

std::string in_words(const obstacle_report& report) {
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
/// ellipse, Schwarz's reflection F(conj z) = conj F(z) continues it to the lower half, with the same
/// bound. Tiles cover the upper half; by the maximum principle |F| inside is at most its supremum on the
/// boundary, whose upper half is covered by arcs. Where F is not real there (`whole`), tiles and arcs cover the lower
/// halves too.
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

  /// The bound from so many arcs of the boundary. The ellipse must have been proved analytic inside.
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
  /// What of the suspect is in the ellipse, with the depth of tiles of its size: all tiles around it need not be
  /// looked at to see the ellipse fail. Proves nothing.
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

/// About how many nodes the goal needs, to search with.
double nodes_needed(double rho, double log2_supremum, double log2_goal) {
  const double excess = log2_supremum + 2.1 - std::log2(1 - 1 / (rho * rho)) - log2_goal;
  return std::max(1.0, std::ceil(excess / (2 * std::log2(rho))));
}

/// How many nodes a panel's rule takes for an error of about 2^log2_goal of the mean of F.
long nodes_of_panel(const panel& p, double log2_goal) {
  if (p.rule != quadrature_rule::trapezoid) {
    const long n = gauss_legendre_degree_at_least(
        static_cast<long>(nodes_needed(p.rho, approximate_log2(p.supremum), log2_goal)));
    // Clenshaw and Curtis's rule with the 2n + 1 nodes of its degree 2n is about as exact.
    return p.rule == quadrature_rule::clenshaw_curtis ? 2 * n + 1 : n;
  }
  return static_cast<long>(std::min(nodes_in_strip(p.half_width, p.supremum, log2_goal), 1e17));
}

void note(quadrature_rule rule, std::vector<quadrature_rule>& rules) {
  if (std::find(rules.begin(), rules.end(), rule) == rules.end()) rules.push_back(rule);
}

class integrator {
 public:
  /// `known` are points that were tried as cuts, or are ends of segments: they are of no interest again.
  /// pole_in(x): what holds a pole in the set x, for which the integral is proved to diverge; may be empty.
  integrator(const preparation& prepared, const integrate_options& options,
             const std::vector<rational>& known,
             std::function<std::optional<ball>(const ball& x)> pole_in = {})
      : segments_(prepared.segments),
        remainder_(prepared.remainder),
        options_(options),
        known_points_(known),
        pole_in_(std::move(pole_in)) {}

  contour_integral run();
  /// Where not empty, points at which f seems not to be analytic: run() has given up, and cutting the range
  /// there may help.
  [[nodiscard]] const std::vector<rational>& points_of_interest() const { return points_; }

 private:
  enum class outcome {
    done,
    too_many_evaluations,
    obstructed,
    cut_needed,
    divergent,
    precision_exhausted,
    not_applicable
  };

  /// The panels for an error of about 2^log2_goal in all.
  outcome plan(double log2_goal);
  outcome plan_segment(std::size_t index, double log2_goal);
  outcome plan_panel(panel p, double log2_goal);
  outcome plan_tried_panel(panel p, double own_nodes, double log2_goal);
  double try_panel(panel& p, double log2_goal);
  [[nodiscard]] double find_ellipse(panel& p, double goal, ellipse_bounds& bounds) const;
  [[nodiscard]] double mean_goal(const panel& p, double log2_goal) const;
  [[nodiscard]] double nodes_accepted(const panel& p, double log2_goal) const;
  outcome sum(double log2_goal);
  [[nodiscard]] panel_sum part_of_panel(panel& p, double share, precision most_precision,
                                        bool& exhausted);
  [[nodiscard]] bool has_room_for(const panel& p, precision working);
  [[nodiscard]] magnitude truncation_error(const panel& p) const;
  [[nodiscard]] panel_sum sum_of_panel(const panel& p, precision& working);
  [[nodiscard]] ball clenshaw_curtis_part(const panel& p, precision working);
  [[nodiscard]] ball gauss_legendre_part(const panel& p, const gauss_legendre_rule& rule) const;
  [[nodiscard]] ball trapezoid_part(const panel& p, precision working) const;
  [[nodiscard]] double log2_of_typical(const panel& p, double log2_goal) const;
  [[nodiscard]] ball range_of(const panel& p) const;
  [[nodiscard]] std::optional<rational> point_in(const panel& p) const;
  [[nodiscard]] bool is_hopeless_beyond(const panel& p) const;
  outcome obstructed_at(const panel& p);
  [[nodiscard]] double log2_of_planned_size() const;
  outcome estimate_size();
  [[nodiscard]] magnitude least_size() const;
  [[nodiscard]] bool reached(long digits, const magnitude& size) const;

  const std::vector<segment>& segments_;
  const ball& remainder_;
  const integrate_options& options_;
  const std::vector<rational>& known_points_;
  std::function<std::optional<ball>(const ball& x)> pole_in_;
  std::vector<rational> points_;
  bool hopeless_ = false;  // a function is not available over regions
  // Beside a singular point there are few panels of one length of which the range is all that is known. Where they do
  // not end, F is known on the real line alone.
  static constexpr long most_ranges_in_a_row = 64;
  long ranges_in_a_row_ = 0;
  std::vector<panel> panels_;
  double planned_nodes_ = 0;
  std::vector<double> log2_scales_;
  std::map<long, double> bytes_of_rules_;  // by their numbers of nodes
  bool memory_exhausted_ = false;
  std::map<std::pair<long, precision>, std::shared_ptr<const chebyshev_points_rule<ball>>>
      clenshaw_curtis_rules_;
  long deepest_ = 0;
  double log2_size_ = 0;        // about log2 of the integral of |f|
  precision result_bits_ = 64;  // of sums of panels
  contour_integral result_;
};

double integrator::log2_of_typical(const panel& p, double log2_goal) const {
  // The middle and two points beside it, so that a zero of F does not mislead; with more bits where F
  // cannot tell them from a singularity nearby.
  double largest = -1e18;
  const auto most = static_cast<precision>(8 * std::max(log2_size_ - log2_goal, 48.0));
  for (precision wide = 96 + 2 * p.level; wide == 96 + 2 * p.level || wide < most; wide *= 4) {
    const auto f = evaluator_of(segments_[p.segment], wide);
    const ball centre(p.centre, wide);
    bool defined = false;
    for (const long offset : {-5, 0, 3}) {
      const complex_ball value = f(centre + scale(ball(offset, wide), -p.level - 4));  // exact
      if (!value.is_bounded()) continue;
      defined = true;
      largest = std::max(largest, approximate_log2(value.magnitude_upper()));
    }
    if (defined) break;
  }
  return largest;
}

/// log2 of the goal for the mean of F over the panel.
double integrator::mean_goal(const panel& p, double log2_goal) const {
  return log2_goal - log2_scales_[p.segment] + static_cast<double>(p.level);
}

/// A panel that needs no more nodes is not worth halving.
double integrator::nodes_accepted(const panel& p, double log2_goal) const {
  return 0.42 * std::max(p.log2_typical - mean_goal(p, log2_goal), 8.0) + 10;
}

/// The best ellipse found around the panel, in p. The number of nodes it needs for a mean of F to 2^goal; huge where
/// none was found.
double integrator::find_ellipse(panel& p, double goal, ellipse_bounds& bounds) const {
  // The price of a region's evaluation in those of f at a node.
  const double bits = std::max(p.log2_typical - goal, 8.0);
  const int halves = segments_[p.segment].along ? 2 : 1;
  const double region_price = halves / (0.3 + std::pow(bits / 300, 1.5));
  const double most_nodes = std::min(2 * bits, bits + 32) + 16;
  double best_nodes = 1e18;
  const auto consider = [&](double rho) {
    const ellipse e(rho);
    const double log2_limit =
        std::clamp(goal + 2 * std::log2(rho) * std::min(most_nodes, best_nodes), -1e18, 1e18);
    const std::optional<magnitude> inside =
        bounds.inside(e, magnitude::power_of_two(static_cast<long>(log2_limit)));
    if (!inside) return false;
    magnitude supremum = *inside;
    double nodes = nodes_needed(rho, approximate_log2(supremum), goal);
    for (int arcs = 6; arcs * region_price < 0.5 * nodes && arcs <= 1024; arcs *= 2) {
      supremum = min(supremum, bounds.on_boundary(e, arcs));
      const double fewer = nodes_needed(rho, approximate_log2(supremum), goal);
      const bool worthwhile = nodes - fewer > arcs * region_price;
      nodes = fewer;
      if (!worthwhile) break;
    }
    if (nodes < best_nodes) {
      best_nodes = nodes;
      p.rho = rho;
      p.supremum = supremum;
    }
    return nodes <= best_nodes;
  };
  constexpr double first = 3;
  constexpr double step = 1.5;
  if (consider(first)) {
    double rho = first;
    while (rho < 1e4 && consider(rho * step)) rho *= step;
  } else {
    consider(2.2);
  }
  // Between the steps, while what may be saved is more than the price of some tiles and arcs.
  constexpr double regions_of_step = 12;
  for (double finer = std::sqrt(step); finer > 1.02; finer = std::sqrt(finer)) {
    const double saved = best_nodes * (1 - std::log2(p.rho) / std::log2(p.rho * finer));
    if (best_nodes > 1e17 || saved < regions_of_step * region_price) break;
    consider(p.rho * finer);
  }
  return best_nodes;
}

/// How the panel's integral is to be had, in p. The number of nodes that takes; huge where no way was found.
double integrator::try_panel(panel& p, double log2_goal) {
  const segment& s = segments_[p.segment];
  p.log2_typical = log2_of_typical(p, log2_goal);
  const panel_regions f(s, p, result_.account.region_evaluations);
  const double goal = mean_goal(p, log2_goal);
  // So small that the bound is enough.
  const region over_panel = f(double_interval(-1.0, 1.0), double_interval(0));
  const double most = approximate_log2(over_panel.magnitude_upper());
  if (most <= goal) {
    p.closed_by = at_most(s, over_panel.magnitude_upper());
    return 0;
  }
  // Where points of the panel are too close to an end for the samples, the bound stands for them.
  if (p.log2_typical < -1e17) p.log2_typical = most < 1e17 ? most : goal + 64;
  constexpr long short_level = 8;  // of such a panel smaller tiles tell little more than the whole
  ellipse_bounds bounds(f, 24, s.along.has_value(), p.suspect);
  if (over_panel.is_analytic() || p.level < short_level) {
    const double nodes = find_ellipse(p, goal, bounds);
    if (nodes < 1e17) return nodes;
    p.suspect = bounds.suspect();
  } else {
    bounds.note(over_panel);
  }
  hopeless_ = bounds.report().why == obstacle::unknown;
  result_.obstacle = in_words(bounds.report());
  // So short that the range of F over it is enough. It says nothing of F being analytic, which it must be along a
  // path, but for the ends, and where it is continued.
  const bool need_not_be_analytic = !s.continued && (!s.along || p.is_at_end());
  const bool may_be_range = over_panel.is_analytic() || need_not_be_analytic;
  if (p.level >= short_level && may_be_range) {
    const rational half = p.half_length();
    const precision wide = 96 + p.level;
    const ball t =
        hull(ball(rational(p.centre - half), wide), ball(rational(p.centre + half), wide));
    const complex_ball range = evaluator_of(s, wide)(t);
    if (range.is_bounded() && approximate_log2(radius_of(range)) <= goal - 4) {
      p.closed_by = range;
      p.by_range_only = true;
      return 0;
    }
  }
  return 1e18;
}

integrator::outcome integrator::plan(double log2_goal) {
  panels_.clear();
  planned_nodes_ = 0;
  ranges_in_a_row_ = 0;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const outcome o = plan_segment(i, log2_goal - 6);
    if (o != outcome::done) return o;
  }
  return points_.empty() ? outcome::done : outcome::cut_needed;
}

/// By the trapezoidal rule where that applies and does not need more nodes.
integrator::outcome integrator::plan_segment(std::size_t index, double log2_goal) {
  panel whole;
  whole.segment = index;
  whole.centre = rational(1, 2);
  const bool insisted = options_.rule == quadrature_rule::trapezoid;
  const bool is_possible = insisted || options_.rule == quadrature_rule::automatic;
  if (options_.rule == quadrature_rule::clenshaw_curtis) {
    whole.rule = options_.rule;
    const auto f = segments_[index].evaluator(64);
    if (!f(ball(0, 64)).is_bounded() || !f(ball(1, 64)).is_bounded()) {
      result_.obstacle =
          "Clenshaw and Curtis's rule needs values at the ends of the range, where the integrand "
          "has none";
      return outcome::not_applicable;
    }
  }
  if (!segments_[index].equidistant || !is_possible) {
    if (!insisted) return plan_panel(std::move(whole), log2_goal);
    result_.obstacle =
        "the trapezoidal rule needs an integrand that is proved periodic over the range, "
        "or even about both limits";
    return outcome::not_applicable;
  }
  panel on_circle = whole;
  on_circle.log2_typical = log2_of_typical(whole, log2_goal);
  const double accepted = nodes_accepted(on_circle, log2_goal);
  const auto most_evaluations = static_cast<double>(options_.most_evaluations);
  const double most_nodes = insisted ? most_evaluations : std::min(20 * accepted, most_evaluations);
  const std::optional<periodic_strip> found =
      find_strip(segments_[index], mean_goal(whole, log2_goal), most_nodes,
                 result_.account.region_evaluations);
  const double nodes = found ? found->nodes : 0;
  if (found) {
    on_circle.rule = quadrature_rule::trapezoid;
    on_circle.half_width = found->half_width;
    on_circle.supremum = found->supremum;
  }
  const std::size_t panels_before = panels_.size();
  const double nodes_before = planned_nodes_;
  if (insisted && !found) {
    result_.obstacle =
        "no strip was found in which the integrand is proved analytic, so wide that the "
        "trapezoidal rule takes few enough nodes";
    return outcome::not_applicable;
  }
  if (!insisted && (!found || nodes > accepted)) {
    const outcome o = plan_panel(std::move(whole), log2_goal);
    const bool fewer = o == outcome::done && planned_nodes_ - nodes_before < nodes;
    if (!found || fewer || !points_.empty()) return o;
  }
  panels_.resize(panels_before);
  planned_nodes_ = nodes_before + nodes;
  panels_.push_back(std::move(on_circle));
  const auto regions = static_cast<double>(result_.account.region_evaluations);
  return planned_nodes_ + regions > most_evaluations ? outcome::too_many_evaluations
                                                     : outcome::done;
}

/// From one end to the other.
ball integrator::range_of(const panel& p) const {
  const segment& s = segments_[p.segment];
  const rational half = p.half_length();
  return hull(s.position(ball(rational(p.centre - half), 192)),
              s.position(ball(rational(p.centre + half), 192)));
}

/// A rational number of small denominator in the panel that is not known yet; at most one of a few
/// neighbouring panels has the same.
std::optional<rational> integrator::point_in(const panel& p) const {
  const ball both = range_of(p);
  if (!both.is_bounded()) return std::nullopt;
  const rational q = simplest_rational(lower_rational(both), upper_rational(both));
  constexpr long greatest_denominator = 10'000;
  if (denominator(q) > greatest_denominator) return std::nullopt;
  const bool known =
      std::find(known_points_.begin(), known_points_.end(), q) != known_points_.end();
  return known ? std::nullopt : std::optional(q);
}

/// Ranges over panels as short as p would take too many of them up to the segment's end: each costs hundreds of evaluations,
/// with what is tried before.
bool integrator::is_hopeless_beyond(const panel& p) const {
  constexpr double evaluations_of_panel = 200;
  const auto left = static_cast<double>(1 - p.centre);
  return std::ldexp(left, static_cast<int>(std::min(p.level, 1000L))) * evaluations_of_panel >
         static_cast<double>(options_.most_evaluations);
}

/// Says in the result where no way on was found.
integrator::outcome integrator::obstructed_at(const panel& p) {
  const segment& own = segments_[p.segment];
  const complex_ball x = position_of(own, ball(p.centre, 64 + p.level));
  if (own.continued) {
    result_.obstacle += " on the line that the path is turned to";
  } else {
    const bool is_real = !own.along;
    result_.obstacle +=
        is_real ? " near x = " + to_decimal(x.re, 20) : " near z = " + to_decimal(x, 20);
  }
  return outcome::obstructed;
}

/// Appends to panels_ what covers p: itself, or what covers its halves.
integrator::outcome integrator::plan_panel(panel p, double log2_goal) {
  const double own_nodes = try_panel(p, log2_goal);
  return plan_tried_panel(std::move(p), own_nodes, log2_goal);
}

/// The same of a panel that takes so many nodes, of which `try_panel` has told.
integrator::outcome integrator::plan_tried_panel(panel p, double own_nodes, double log2_goal) {
  constexpr double most_nodes_of_a_rule = 28'000;  // of greatest_gauss_legendre_degree
  const bool accepted = own_nodes <= std::min(nodes_accepted(p, log2_goal), most_nodes_of_a_rule);
  const double evaluations = planned_nodes_ + (accepted ? own_nodes : 0) +
                             static_cast<double>(result_.account.region_evaluations);
  if (evaluations > static_cast<double>(options_.most_evaluations)) {
    return outcome::too_many_evaluations;
  }
  if (accepted) {
    const bool as_short = !panels_.empty() && panels_.back().level == p.level;
    ranges_in_a_row_ = p.by_range_only ? (as_short ? ranges_in_a_row_ + 1 : 1) : 0;
    if (ranges_in_a_row_ > most_ranges_in_a_row && is_hopeless_beyond(p)) return obstructed_at(p);
    planned_nodes_ += own_nodes;
    panels_.push_back(std::move(p));
    return outcome::done;
  }
  const double bits = std::max(log2_size_ - log2_goal, 16.0);
  constexpr long suspicious_level = 40;
  const segment& own = segments_[p.segment];
  const bool is_real = !own.along && !own.continued;
  if (is_real && p.level == suspicious_level && own_nodes > 1e17) {
    if (const std::optional<rational> point = point_in(p)) {
      constexpr std::size_t most_points = 200;
      points_.push_back(*point);
      return points_.size() < most_points ? outcome::done : outcome::cut_needed;  // for now
    }
    if (const auto pole = pole_in_ ? pole_in_(range_of(p)) : std::nullopt) {
      result_.obstacle = "the integrand has a pole near x = " + to_decimal(pole->middle(), 20);
      return outcome::divergent;
    }
  }
  if (p.level >= deepest_ || hopeless_) return obstructed_at(p);
  const std::size_t before = panels_.size();
  const double nodes_before = planned_nodes_;
  const double most_own_nodes = std::min(bits + 32, most_nodes_of_a_rule);
  const auto keep_whole = [&] {
    panels_.resize(before);
    planned_nodes_ = nodes_before + own_nodes;
    panels_.push_back(std::move(p));
    return outcome::done;
  };
  std::array<panel, 2> halves{p.half(-1), p.half(1)};
  std::array<double, 2> nodes_of_halves{1e18, 1e18};
  // Where the halves take no fewer nodes theirs mostly do not: with so few bits, at which regions cost more than
  // nodes, they are not looked at.
  constexpr double few_bits = 600;
  if (bits < few_bits && own_nodes <= most_own_nodes) {
    for (std::size_t k = 0; k < 2; ++k) nodes_of_halves[k] = try_panel(halves[k], log2_goal);
    if (own_nodes <= nodes_of_halves[0] + nodes_of_halves[1]) return keep_whole();
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const bool is_tried = nodes_of_halves[k] < 1e17;
    const outcome o = is_tried
                          ? plan_tried_panel(std::move(halves[k]), nodes_of_halves[k], log2_goal)
                          : plan_panel(std::move(halves[k]), log2_goal);
    if (o != outcome::done) return o;
  }
  if (own_nodes <= std::min(planned_nodes_ - nodes_before, most_own_nodes)) return keep_whole();
  return outcome::done;
}

/// Half-length times the sum of w_k F(centre + half-length x_k), for a complex F.
complex_ball gauss_legendre_along(const std::function<complex_ball(const ball& t)>& f,
                                  const panel& p, const gauss_legendre_rule& rule) {
  const ball centre(p.centre, rule.bits);
  complex_ball sum(0, rule.bits);
  ball offset;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    scale(offset, rule.nodes[k], -p.level - 1);
    complex_ball value = f(centre + offset);
    if (k > 0 || p.nodes % 2 == 0) {  // the middle node counts once
      value += f(centre - offset);
    }
    fma(sum.re, rule.weights[k], value.re, sum.re);
    fma(sum.im, rule.weights[k], value.im, sum.im);
  }
  return scale(sum, -p.level - 1);
}

/// What the rule leaves out of the panel's integral of F.
magnitude integrator::truncation_error(const panel& p) const {
  if (p.rule == quadrature_rule::trapezoid) {
    const ball supremum = ball(0, 64).enlarged(p.supremum);
    return mean_trapezoid_error({ball::exactly(p.half_width, 64), supremum}, p.nodes);
  }
  const ball rho = ball::exactly(p.rho, 64);
  const magnitude error = p.rule == quadrature_rule::clenshaw_curtis
                              ? clenshaw_curtis_error(p.nodes - 1, rho, p.supremum)
                              : gauss_legendre_error(p.nodes, rho, p.supremum);
  return scale(error, -p.level - 1);
}

/// The rule on one panel, with at least `working` bits, which become those that were used.
panel_sum integrator::sum_of_panel(const panel& p, precision& working) {
  if (p.rule == quadrature_rule::trapezoid) {  // which is for a whole segment
    return {complex_ball(trapezoid_part(p, working)), {place(0), place(1)}};
  }
  if (p.rule == quadrature_rule::clenshaw_curtis) {
    return {complex_ball(clenshaw_curtis_part(p, working)), p.piece()};
  }
  const auto rule = gauss_legendre(p.nodes, working);
  working = rule->bits;
  const std::optional<complex_piece>& along = segments_[p.segment].along;
  if (along) return {gauss_legendre_along(along->evaluator(working), p, *rule), p.piece()};
  return {complex_ball(gauss_legendre_part(p, *rule)), p.piece()};
}

/// Half-length times the sum of w_k F(centre + half-length x_k).
ball integrator::gauss_legendre_part(const panel& p, const gauss_legendre_rule& rule) const {
  const precision working = rule.bits;
  const ball centre(p.centre, working);
  const auto adder = [&]() -> add_terms {
    return [&, f = segments_[p.segment].evaluator(working)](long first, long last, ball& sum) {
      ball offset;
      for (long k = first; k < last; ++k) {
        const auto i = static_cast<std::size_t>(k);
        scale(offset, rule.nodes[i], -p.level - 1);
        ball value = f(centre + offset);
        if (k > 0 || p.nodes % 2 == 0) {  // the middle node counts once
          value += f(centre - offset);
        }
        fma(sum, rule.weights[i], value, sum);
      }
    };
  };
  ball sum = sum_in_chunks(static_cast<long>(rule.nodes.size()), working, options_.threads, adder);
  scale(sum, sum, -p.level - 1);
  return sum;
}

/// Half-length times the sum of w_k F(centre + half-length x_k).
ball integrator::clenshaw_curtis_part(const panel& p, precision working) {
  std::shared_ptr<const chebyshev_points_rule<ball>>& rule =
      clenshaw_curtis_rules_[{p.nodes, working}];
  if (!rule) {
    rule = std::make_shared<const chebyshev_points_rule<ball>>(
        clenshaw_curtis_rule<ball>(p.nodes - 1, working));
  }
  const ball centre(p.centre, working);
  const auto adder = [&]() -> add_terms {
    return [&, f = segments_[p.segment].evaluator(working)](long first, long last, ball& sum) {
      for (long k = first; k < last; ++k) {
        const auto i = static_cast<std::size_t>(k);
        fma(sum, rule->weights[i], f(centre + scale(rule->nodes[i], -p.level - 1)), sum);
      }
    };
  };
  return scale(sum_in_chunks(p.nodes, working, options_.threads, adder), -p.level - 1);
}

/// The mean of F((k + 1/2)/n).
ball integrator::trapezoid_part(const panel& p, precision working) const {
  const auto functions = segments_[p.segment].equidistant(p.nodes, working);
  const auto adder = [&]() -> add_terms {
    return [f = functions()](long first, long last, ball& sum) {
      for (long k = first; k < last; ++k) sum += f(k);
    };
  };
  return sum_in_chunks(p.nodes, working, options_.threads, adder) / p.nodes;
}

/// Its part of the integral, to a radius of about 2^share; whatever it is, the enclosure holds. `exhausted` where
/// the precision that this would take is not allowed, or does not help.
panel_sum integrator::part_of_panel(panel& p, double share, precision most_precision,
                                    bool& exhausted) {
  const segment& s = segments_[p.segment];
  if (p.closed_by) {
    return {scale(*p.closed_by, -p.level) * scale_of(s, result_bits_), p.piece()};
  }
  const auto bound_alone = [&]() -> panel_sum {
    return {at_most(s, scale(p.supremum, -p.level)) * scale_of(s, 64), p.piece()};
  };
  const auto allowed = static_cast<double>(most_precision);
  const double goal = share - log2_scales_[p.segment] + static_cast<double>(p.level);
  p.nodes = nodes_of_panel(p, goal);
  result_.account.most_nodes = std::max(result_.account.most_nodes, p.nodes);
  note(p.rule, result_.account.rules);
  const magnitude truncation = truncation_error(p);
  double needed =
      std::max(p.log2_typical - goal, 16.0) + 12 + std::log2(static_cast<double>(p.nodes));
  if (needed > allowed) {
    exhausted = true;
    return bound_alone();
  }
  double last_radius = 1e18;
  while (true) {
    auto working = static_cast<precision>(std::max(needed, 53.0));
    if (!has_room_for(p, working)) {
      memory_exhausted_ = true;
      exhausted = true;
      return bound_alone();
    }
    const panel_sum sum = sum_of_panel(p, working);
    result_.account.evaluations += p.nodes;
    result_.account.precision = std::max(result_.account.precision, working);
    const panel_sum part{enlarged(s, sum.value, truncation) * scale_of(s, working), sum.done};
    const double radius = approximate_log2(radius_of(part.value));
    if (radius <= share + 1) return part;
    // More bits, until they do not help any more; to tell a short panel's nodes from what is beside it, they
    // may have to be many before they do.
    const bool helps = radius <= last_radius - 4 || last_radius > 1e17;
    const bool stuck = !helps && working >= 128 + 2 * p.level;
    if (stuck || working >= most_precision) {
      exhausted = true;
      return part;
    }
    last_radius = radius;
    const auto bits_used = static_cast<double>(working);
    needed =
        std::min(bits_used + (helps && radius < 1e17 ? radius - share + 4 : bits_used), allowed);
  }
}

/// The nodes and weights of the panel's rule, beside those of the others, keep to the limit.
bool integrator::has_room_for(const panel& p, precision working) {
  if (!options_.most_memory || p.rule == quadrature_rule::trapezoid) return true;
  // A number takes its bits, and some more for its place on the heap and its radius; of nodes that lie
  // symmetrically one half is kept.
  const double bytes_of_number = static_cast<double>(working) / 8 + 96;
  double& bytes = bytes_of_rules_[p.nodes];
  bytes = std::max(bytes, static_cast<double>(p.nodes) * bytes_of_number);
  double sum = 0;
  for (const auto& [nodes, size] : bytes_of_rules_) sum += size;
  return sum <= *options_.most_memory;
}

integrator::outcome integrator::sum(double log2_goal) {
  // Half of the goal for truncation and half for rounding, in equal shares.
  const double share = log2_goal - std::log2(static_cast<double>(panels_.size())) - 1.5;
  const double bits = std::max(log2_size_ - log2_goal, 16.0);
  result_bits_ = static_cast<precision>(bits) + 64;
  const auto most_precision =
      options_.most_precision.value_or(static_cast<precision>(64 * (bits + 64)));
  bool exhausted = false;
  // Of each segment, 0 <= t <= 1.
  const complex_ball zero(0, result_bits_);
  std::vector<tiled_sum<complex_ball>> of_segments(
      segments_.size(), tiled_sum<complex_ball>(exact_end(0), exact_end(1), zero));
  for (panel& p : panels_) {
    const panel_sum part = part_of_panel(p, share, most_precision, exhausted);
    of_segments[p.segment].add(part.done, p.interval(), part.value);
  }
  complex_ball total(remainder_.with_precision(result_bits_));
  for (const tiled_sum<complex_ball>& sum : of_segments) {
    const std::optional<complex_ball> value = sum.total();
    if (!value) {
      throw std::logic_error("integrate: internal error: the panels of a range do not tile it");
    }
    total += *value;
  }
  result_.account.panels = static_cast<long>(panels_.size());
  const bool better =
      result_.enclosure.is_undefined() || radius_of(total) < radius_of(result_.enclosure);
  if (better) result_.enclosure = total;
  return exhausted ? outcome::precision_exhausted : outcome::done;
}

/// The radius is at most 10^-digits of the size.
bool integrator::reached(long digits, const magnitude& size) const {
  const magnitude radius = radius_of(result_.enclosure);
  if (radius.is_infinite()) return false;
  return multiply_up(radius, pow(ball(10, 64), digits).magnitude_upper()) <= size;
}

/// A lower bound of the integral of |f|: from the ranges of F over pieces of the panels.
magnitude integrator::least_size() const {
  constexpr long log2_pieces = 4;
  magnitude size;
  for (const panel& p : panels_) {
    const segment& s = segments_[p.segment];
    const precision wide = 96 + p.level;
    const auto f = evaluator_of(s, wide);
    const ball piece = hull(ball(-1, wide), ball(1, wide));
    magnitude sum;
    for (long k = 1 - (1L << log2_pieces); k < 1L << log2_pieces; k += 2) {
      const ball t = p.centre + scale(piece + k, -p.level - 1 - log2_pieces);
      sum = add_down(sum, f(t).magnitude_lower());
    }
    const magnitude mean = multiply_down(sum, scale_of(s, wide).magnitude_lower());
    size = add_down(size, scale(mean, -p.level - log2_pieces));
  }
  return size;
}

/// log2 of the largest contribution that a panel of the plan makes.
double integrator::log2_of_planned_size() const {
  double size = -1e18;
  for (const panel& p : panels_) {
    size = std::max(size, p.log2_typical + log2_scales_[p.segment] - static_cast<double>(p.level));
  }
  return size;
}

/// An estimate of log2 of the integral of |f|, by samples; and by a coarse plan, where the bounds of |f|
/// say that the samples may have missed the most of it.
integrator::outcome integrator::estimate_size() {
  double samples = -1e18;
  double bound = -1e18;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto f = evaluator_of(segments_[i], 64);
    for (long k = 1; k < 16; k += 2) {
      const complex_ball value = f(ball(rational(k, 16), 64));
      if (value.is_bounded()) {
        samples =
            std::max(samples, approximate_log2(value.magnitude_upper()) + log2_scales_[i] - 2);
      }
    }
    for (long k = 5; k < 14 && !segments_[i].along; ++k) {
      // A piece of the real line may have the most of its size near t = 0.
      ball t(1, 64);
      scale(t, t, -k);
      const complex_ball value = f(t);
      if (value.is_bounded()) {
        samples = std::max(samples, approximate_log2(value.magnitude_upper()) + log2_scales_[i] -
                                        static_cast<double>(k));
      }
    }
    ++result_.account.region_evaluations;
    const region all = segments_[i].over(region(double_interval(0.0, 1.0)));
    bound = std::max(bound, approximate_log2(all.magnitude_upper()) + log2_scales_[i]);
  }
  log2_size_ = samples > -1e17 ? samples : 0;
  if (bound <= samples + 16 || bound > 1e17) return outcome::done;
  // The bound is never too small: lower it until a plan finds something of about its size.
  log2_size_ = bound;
  for (double step = 64; log2_size_ > samples; step *= 2) {
    const double goal = log2_size_ - 8;
    const outcome o = plan(goal);
    if (o != outcome::done) return o;
    const double size = log2_of_planned_size();
    if (size >= goal - 8) {
      log2_size_ = size;
      break;
    }
    log2_size_ = std::max(samples, log2_size_ - step);
  }
  return outcome::done;
}

contour_integral integrator::run() {
  const double log2_digits = static_cast<double>(options_.digits) * std::log2(10.0);
  for (const segment& s : segments_) {
    // With as many bits as tell a short range's ends apart.
    precision p = 64;
    while (p < 40'000 && scale_of(s, p).magnitude_lower().is_zero()) p *= 2;
    log2_scales_.push_back(approximate_log2(scale_of(s, p).magnitude_upper()));
  }
  // Along a path nothing is gained by coming nearer to a cut or a pole that is met.
  const double least_depth = !segments_.empty() && segments_.front().along ? 160 : 420;
  deepest_ = options_.most_depth.value_or(static_cast<long>(least_depth + 1.1 * log2_digits));
  auto start = clock::now();
  outcome o = estimate_size();
  double log2_goal = log2_size_ - log2_digits;
  if (options_.absolute_exponent) {
    log2_goal = std::max(log2_goal, static_cast<double>(*options_.absolute_exponent));
  }
  double lowest_goal = log2_goal - log2_digits;  // where a value counts as 0
  bool lowest_is_proved = false;
  for (int attempts = 0; attempts < 6; ++attempts) {
    if (o == outcome::done) o = plan(log2_goal);
    result_.account.seconds_for_bounds += seconds_since(start);
    start = clock::now();
    if (o == outcome::done) o = sum(log2_goal - 1);
    result_.account.seconds_for_sums += seconds_since(start);
    start = clock::now();
    if (o == outcome::too_many_evaluations) {
      result_.why = reason::evaluation_limit;
      result_.obstacle = "more evaluations needed than allowed";
      return result_;
    }
    if (o == outcome::not_applicable) {
      result_.why = reason::not_applicable;
      return result_;
    }
    if (o == outcome::divergent) {
      result_.why = reason::not_integrable;
      return result_;
    }
    if (o == outcome::obstructed || o == outcome::cut_needed) {
      result_.why = reason::not_analytic;
      return result_;
    }
    result_.obstacle.clear();
    const magnitude radius = radius_of(result_.enclosure);
    if (reached(options_.digits, result_.enclosure.magnitude_lower()) ||
        (options_.absolute_exponent &&
         radius <= magnitude::power_of_two(*options_.absolute_exponent))) {
      result_.verdict = status::certified;
      return result_;
    }
    if (o == outcome::precision_exhausted && memory_exhausted_) {
      result_.why = reason::evaluation_limit;
      result_.obstacle = "more memory needed than allowed";
      return result_;
    }
    if (o == outcome::precision_exhausted) {
      result_.why = reason::precision_limit;
      return result_;
    }
    // The value is smaller than its integrand led to expect.
    const double value = approximate_log2(result_.enclosure.magnitude_upper());
    if (log2_goal <= lowest_goal + 2) {
      // 10^-digits of the integral of |f| stands for the value.
      const magnitude size = least_size();
      if (reached(2 * options_.digits, size)) {
        result_.verdict = status::certified;
        return result_;
      }
      if (lowest_is_proved || size.is_zero()) break;
      lowest_is_proved = true;
      lowest_goal = approximate_log2(size) - 2 * log2_digits - 3;
    }
    log2_goal = std::max(std::min(value - log2_digits, log2_goal) - 3, lowest_goal);
  }
  result_.why = reason::precision_limit;
  return result_;
}

}  // namespace

affine_map::affine_map(limit a, limit b)
    : a_(std::move(a)), b_(std::move(b)), a_hardware_(a_.at(64)), length_hardware_(length(128)) {}

region affine_map::operator()(const region& t) const {
  if (t.is_in_hardware()) return a_hardware_ + length_hardware_ * t;
  const precision p = t.precision();
  return a_.at(p) + length(p) * t;
}

ball affine_map::operator()(const ball& t) const {
  const precision p = t.precision();
  return a_.at(p) + length(p) * t;
}

contour_integral integrate_segments(const preparation& prepared, const integrate_options& options) {
  return integrator(prepared, options, {}).run();
}

integral integrate_function(const integrand& f, const limit& a, const limit& b,
                            const integrate_options& options) {
  if (options.digits < 1) throw std::invalid_argument("integrate: digits must be at least 1");
  if (options.threads < 0) {
    throw std::invalid_argument("integrate: threads must be at least 0 (0: all processors)");
  }
  integral result;
  if (a.form() && b.form() && *a.form() == *b.form()) {
    result.enclosure = ball(0, 64);
    result.verdict = status::certified;
    return result;
  }
  const bool same_infinity = a.infinite_sign() != 0 && a.infinite_sign() == b.infinite_sign();
  if (same_infinity) {
    throw std::invalid_argument("integrate: both limits are the same infinity");
  }
  for (const limit& end : {a, b}) {
    if (end.infinite_sign() == 0 && !end.at(64).is_bounded()) {
      result.why = reason::not_defined;
      result.obstacle = "a limit is not a number";
      return result;
    }
  }
  const bool infinite = a.infinite_sign() != 0 || b.infinite_sign() != 0;
  if (a.infinite_sign() > 0 || b.infinite_sign() < 0 ||
      (!infinite && certainly_less(b.at(128), a.at(128)))) {
    result = integrate_function(f, b, a, options);
    result.enclosure = -result.enclosure;
    return result;
  }
  if (options.rule == quadrature_rule::double_exponential) {
    return integrate_by_double_exponential(f, a, b, options);
  }
  const bool insists_on_series = options.rule == quadrature_rule::taylor_series;
  if (insists_on_series || options.rule == quadrature_rule::automatic) {
    if (std::optional<integral> found = integrate_by_taylor_series(f, a, b, options)) return *found;
    if (insists_on_series) {
      result.why = reason::not_applicable;
      result.obstacle =
          "Taylor series need a sum of hyperexponential functions of x, e^(k x) or sin^2 (k x)";
      return result;
    }
  }
  long bits = bits_for_digits(options.digits);
  std::vector<rational> cuts;   // where the range is cut, in order
  std::vector<rational> known;  // these, the limits, and points where cutting does not help
  for (const limit& end : {a, b}) {
    if (end.is_exact()) known.push_back(end.exact_value());
  }
  // In the set, or, for a pole at the set's end, in a larger one; but in the range.
  const auto is_in_range = [&](const ball& x) {
    return is_inside(lower_rational(x), a, b) && is_inside(upper_rational(x), a, b);
  };
  const auto pole_in_range = [&](const ball& x) -> std::optional<ball> {
    if (!x.is_bounded()) return std::nullopt;
    const ball more = x.enlarged(scale(x.radius(), 3));
    if (is_in_range(more)) return pole_in(f, more);
    return is_in_range(x) ? pole_in(f, x) : std::nullopt;
  };
  constexpr std::size_t most_points = 2000;
  for (int attempts = 0; attempts < 3;) {
    const preparation prepared = prepare(f, a, b, cuts, bits);
    if (prepared.why != reason::none) {
      result.why = prepared.why;
      result.obstacle = prepared.obstacle;
      return result;
    }
    integrator work(prepared, options, known, pole_in_range);
    const contour_integral found = work.run();
    result = {found.enclosure.re, found.verdict, found.why, found.obstacle, found.account};
    if (!work.points_of_interest().empty() && known.size() < most_points) {
      for (const rational& q : work.points_of_interest()) {
        if (std::find(known.begin(), known.end(), q) != known.end()) continue;
        known.push_back(q);
        if (is_inside(q, a, b) && can_cut_at(f, q)) cuts.push_back(q);
      }
      std::sort(cuts.begin(), cuts.end());
      continue;
    }
    const bool tail_too_large = prepared.has_tail && result.why == reason::precision_limit;
    if (result.verdict == status::certified || !tail_too_large) break;
    bits *= 2;
    ++attempts;
  }
  return result;
}

}  // namespace polhode::detail
