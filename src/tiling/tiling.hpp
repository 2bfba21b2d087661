#pragma once

// The proofs that parts make up a whole: pieces a range, boxes a box.
//
// A range is integrated, or searched for roots, piece by piece, and several rules may serve: each
// works in an interval that it is given, and reports the piece that it has done. No rule is
// believed about its pieces. Whoever puts the results together proves here, in exact arithmetic,
// that they make up the range, each part of it once.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "polhode/arithmetic/end_point.hpp"
#include "tiling/exact_interval.hpp"

namespace polhode::detail {

/// The sign of end - q: 1, 0 (only where the end is exact), -1. Returns nullopt where no enclosure
/// of up to 2^15 bits tells.
[[nodiscard]] std::optional<int> side_of(const end_point& end, const rational& q);

/// Where a piece begins or ends: at a rational number, or at an end of the range, which has a name
/// where it is not rational.
struct piece_end {
  enum class kind : std::uint8_t { exact, lower_end, upper_end };
  kind what = kind::exact;
  rational at;  // where it is exact

  piece_end(rational q)
      : at(std::move(q)) {}  // NOLINT(google-explicit-constructor): the same number
  [[nodiscard]] static piece_end lower_end() { return piece_end(kind::lower_end); }
  [[nodiscard]] static piece_end upper_end() { return piece_end(kind::upper_end); }

  bool operator==(const piece_end&) const = default;

 private:
  explicit piece_end(kind which) : what(which) {}
};

/// What was integrated over.
struct piece_done {
  piece_end from;
  piece_end to;
};

/// The pieces, sorted, run from the first place to the last one, each from where another one ends.
///
/// Theorem. Let the pieces run from p_0 to p_1, from p_1 to p_2, ... and from p_(n-1) to p_n, with
/// p_0 and p_n the ends of the range. Then the sum of the integrals over the pieces is that over
/// the range, for any function that is integrable between all of these points: integrals add up
/// along the line, whatever the order of the points on it. Where no piece ends before it begins,
/// every point of the range is in one piece, or is the common end of pieces, and no piece has a
/// point beyond the range.
[[nodiscard]] bool form_a_chain(std::vector<piece_done> pieces, const piece_end& first,
                                const piece_end& last);

/// The pieces make up the whole: they form a chain, none ends before it begins, and a point that is
/// a piece is one once.
[[nodiscard]] bool is_tiling(const exact_interval& whole,
                             const std::vector<const exact_interval*>& pieces);

/// The parts make up the box, each point of it in one part or on the common face of parts.
/// Hypothesis: all sides are bounded.
///
/// Proved by cutting: one part is all of the box where it is equal to it. More parts are where a
/// plane through the box passes through none of them and those on either side make up that side.
/// Parts that come of bisections always have such a plane; others are refused, be they a tiling or
/// not.
using exact_sides = std::vector<exact_interval>;
[[nodiscard]] bool is_tiling(const exact_sides& whole, std::vector<const exact_sides*> parts);

/// Pieces of a range with ends of any kind, which are to tile it. Points are the same only where
/// that is exact. What a rule reports of an end is not believed: that the end lies in the interval
/// that the rule was given, in which its bounds hold, is proved from the end's enclosures.
class range_tiling {
 public:
  range_tiling(const end_point& lower, const end_point& upper) : lower_(lower), upper_(upper) {}

  /// Notes a piece. Where it is not proved that both its ends lie in the interval that the rule was
  /// given, the range counts as not tiled.
  void add(const piece_done& done, const exact_interval& within);
  /// Notes a piece that is proved to be tiled itself, by smaller ones.
  void add_tiled(const piece_done& done);
  /// The pieces run from the lower end to the upper one, each from where another one ends.
  [[nodiscard]] bool is_complete() const;

 private:
  [[nodiscard]] piece_end normal(const piece_end& p) const;
  [[nodiscard]] bool is_in(const piece_end& p, const exact_interval& within) const;

  end_point lower_;
  end_point upper_;
  std::vector<piece_done> pieces_;
  bool is_refuted_ = false;
};

/// The sum of the integrals over pieces of a range. Value: ball or complex_ball.
template <class Value>
class tiled_sum {
 public:
  tiled_sum(const end_point& lower, const end_point& upper, Value zero)
      : tiling_(lower, upper), sum_(std::move(zero)) {}

  void add(const piece_done& done, const exact_interval& within, const Value& value) {
    tiling_.add(done, within);
    sum_ += value;
  }
  void add_tiled(const piece_done& done, const Value& value) {
    tiling_.add_tiled(done);
    sum_ += value;
  }
  /// The integral over the range; nullopt where the pieces are not proved to tile it.
  [[nodiscard]] std::optional<Value> total() const {
    if (!tiling_.is_complete()) return std::nullopt;
    return sum_;
  }

 private:
  range_tiling tiling_;
  Value sum_;
};

}  // namespace polhode::detail
