#include "path_pieces.hpp"

#include <algorithm>

#include "polhode/arithmetic/text.hpp"

namespace polhode::detail {
namespace {

complex_ball on_circle(const arc_piece& arc, const end_point& angle, precision p) {
  const auto [sine, cosine] = sin_cos(angle.at(p));
  return arc.centre.at(p) + complex_ball(cosine, sine) * arc.radius.at(p);
}
complex_ball start_of(const line_piece& line, precision p) { return line.from.at(p); }
complex_ball end_of(const line_piece& line, precision p) { return line.to.at(p); }
complex_ball start_of(const arc_piece& arc, precision p) {
  return on_circle(arc, arc.from_angle, p);
}
complex_ball end_of(const arc_piece& arc, precision p) { return on_circle(arc, arc.to_angle, p); }

complex_ball start_of(const path_piece& piece, precision p) {
  return std::visit([p](const auto& x) { return start_of(x, p); }, piece);
}
complex_ball end_of(const path_piece& piece, precision p) {
  return std::visit([p](const auto& x) { return end_of(x, p); }, piece);
}

bool are_joined(const path_piece& first, const path_piece& second, precision p) {
  const auto* const a = std::get_if<line_piece>(&first);
  const auto* const b = std::get_if<line_piece>(&second);
  if (a != nullptr && b != nullptr && a->to.is_same_as(b->from)) return true;
  return overlaps(end_of(first, p), start_of(second, p));
}

/// F over intervals of u, u = t or 1 - t, near an end of a segment.
class neighbourhood_of_end {
 public:
  neighbourhood_of_end(const segment& s, bool at_start, long deepest, long& evaluations)
      : segment_(s), at_start_(at_start), deepest_(deepest), evaluations_(evaluations) {
    const complex_ball start = s.along->position(ball(0, 128));
    const complex_ball end = s.along->position(ball(1, 128));
    const magnitude size = max(max(start.magnitude_upper(), end.magnitude_upper()), s.along->size);
    const magnitude length = (end - start).magnitude_upper();
    const bool finite = !size.is_zero() && !size.is_infinite() && !length.is_zero();
    if (finite) gap_ = std::max<long>(size.log2_floor() - length.log2_floor(), 0);
  }

  [[nodiscard]] std::optional<obstacle_near_end> search() {
    constexpr long first_level = 8;  // a panel from which the range may be taken is as short
    if (is_analytic_in_hardware(first_level)) return std::nullopt;
    rational far(1, 1L << first_level);
    for (long level = first_level; level < deepest_; ++level) {
      if (over(0, far, level).is_analytic()) return std::nullopt;
      const rational near = far / 2;
      if (auto found = search_between(near, far, level + 1)) return found;
      far = near;
    }
    // Where F is analytic at the end itself, what is in the way is beside it.
    constexpr long far_deeper = 4000;
    if (!over(0, 0, deepest_ + far_deeper).is_analytic()) return std::nullopt;
    return found_at(over(0, far, deepest_), far);
  }

 private:
  [[nodiscard]] bool is_analytic_in_hardware(long level) {
    if (gap_ >= 24) return false;
    ++evaluations_;
    const double size = std::ldexp(1.0, static_cast<int>(-level));
    const double_interval t = at_start_ ? double_interval(0, size) : double_interval(1 - size, 1);
    return segment_.over(region(t, double_interval(0))).is_analytic();
  }
  /// With so many bits that intervals of that level are told from each other.
  [[nodiscard]] region over(const rational& near, const rational& far, long level) {
    ++evaluations_;
    ++done_;
    const precision p = 128 + gap_ + 2 * level;
    ball u = hull(ball(near, p), ball(far, p));
    if (!at_start_) u = 1 - u;
    return segment_.over(region::in_balls({u, ball(0, p)}));
  }
  [[nodiscard]] obstacle_near_end found_at(const region& value, const rational& u) const {
    const ball t(at_start_ ? u : rational(1 - u), 128 + gap_ + 2 * deepest_);
    return {value.why(), std::string(value.where()), segment_.along->position(t)};
  }
  /// What is in the way between two points beside the end; nothing where F is proved analytic, or
  /// that takes too long.
  [[nodiscard]] std::optional<obstacle_near_end> search_between(const rational& near,
                                                                const rational& far, long level) {
    constexpr long most_evaluations = 20'000;
    if (done_ > most_evaluations) return std::nullopt;
    const region value = over(near, far, level);
    if (value.is_analytic()) return std::nullopt;
    const rational middle = (near + far) / 2;
    if (level >= deepest_) return found_at(value, middle);
    if (auto found = search_between(near, middle, level + 1)) return found;
    return search_between(middle, far, level + 1);
  }

  const segment& segment_;
  bool at_start_;
  long deepest_;
  long& evaluations_;
  long gap_ = 0;   // log2 of how much larger the points are than the distance of the ends
  long done_ = 0;  // evaluations
};

}  // namespace

std::optional<std::string> gap_between(const std::vector<path_piece>& pieces, precision p) {
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    if (are_joined(pieces[k - 1], pieces[k], p)) continue;
    return "piece " + std::to_string(k + 1) +
           " of the path starts at z = " + to_decimal(start_of(pieces[k], p), 20) +
           ", and the one before it ends at z = " + to_decimal(end_of(pieces[k - 1], p), 20);
  }
  return std::nullopt;
}

bool runs_over(const segment& s, const path_piece& piece, precision p) {
  if (!s.along) return false;
  const complex_ball start = s.along->position(ball(0, p));
  const complex_ball end = s.along->position(ball(1, p));
  if (!overlaps(start, start_of(piece, p)) || !overlaps(end, end_of(piece, p))) return false;
  return !std::holds_alternative<line_piece>(piece) || overlaps(s.along->scale(p), end - start);
}

std::optional<obstacle_near_end> obstacle_near_ends(const segment& s, long deepest,
                                                    long& evaluations) {
  for (const bool at_start : {true, false}) {
    if (auto found = neighbourhood_of_end(s, at_start, deepest, evaluations).search()) return found;
  }
  return std::nullopt;
}

}  // namespace polhode::detail
