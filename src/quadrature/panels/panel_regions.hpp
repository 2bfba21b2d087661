#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "panel.hpp"
#include "polhode/arithmetic/region.hpp"
#include "segment_values.hpp"

namespace polhode::detail {

/// The regions that tile the Bernstein ellipses of one panel. Coordinates are those in which the
/// panel is [-1, 1].
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
    const magnitude centre = ball(p.centre, 64).magnitude_upper();
    const auto gap = static_cast<long>(
        std::max(gap_of(size, distance), gap_of(centre, magnitude::power_of_two(-p.level - 1))));
    in_hardware_ = gap < 24 && p.level < 900;
    if (p.level < 900) {
      hardware_centre_ = double_interval(p.centre);
      hardware_half_ = double_interval(std::ldexp(1.0, static_cast<int>(-p.level - 1)));
      const exact_interval t = p.interval();
      hardware_whole_ = hull(double_interval(*t.lower), double_interval(*t.upper));
    }
    if (!in_hardware_) {
      bits_ = 80 + std::max(gap, 0L) + p.level;
      ball_centre_ = ball(p.centre, bits_);
    }
  }

  /// F over the rectangle's part in an ellipse. Where a series for F is known, it holds on a set K;
  /// what lies outside of K is evaluated directly. Both are one analytic function: the direct one
  /// is analytic on a neighbourhood of the half ellipse less K, and agrees with the series along
  /// K's boundary in it, which is connected and begins at a real t > 0, where both are the real
  /// function. Inside K the direct one need not be F (a root may have another sign there): of a
  /// rectangle that lies partly in K, that part has the series' bound.
  ///
  /// Connected: for a half plane the boundary is a line's part in a convex set that is symmetric to
  /// the real axis. For a disc around 0 it is an arc. The ellipse has its centre c and its foci c
  /// +- h on t >= 0, c >= h, and semi-axes A >= h, B, A^2 - B^2 = h^2. On its boundary t = c + A
  /// cos u + i B sin u, 0 <= u <= pi, d|t|^2/du = -2 sin u (c A + h^2 cos u) <= 0: |t| falls from
  /// right to left, so that the points of the half ellipse with
  /// |t| = R have arguments from 0 up to some angle, without a gap.
  [[nodiscard]] region operator()(double_interval re, double_interval im) const {
    ++evaluations_;
    if (panel_.level < 900) {
      // Products round outward, also where they are exact; the panel itself is not to reach beyond
      // t = 0.
      const bool is_whole = re.lower() == -1 && re.upper() == 1;
      const double_interval t_re =
          is_whole ? hardware_whole_ : hardware_centre_ + hardware_half_ * re;
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
  double_interval hardware_whole_;
  precision bits_ = 0;
  ball ball_centre_;
};

}  // namespace polhode::detail
