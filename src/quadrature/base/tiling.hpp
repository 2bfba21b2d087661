#pragma once

// The proof that pieces tile a range.
//
// A range is integrated piece by piece, and several rules may serve: each works in an interval that
// it is given, and says what it has integrated over. Whoever adds the values up proves here that
// the pieces make up the range, each part of it once; no rule decides that alone.
//
// Theorem. Let the pieces, in some order, run from p_0 to p_1, from p_1 to p_2, ... and from
// p_(n-1) to p_n, with p_0 and p_n the ends of the range. Then the sum of the integrals over the
// pieces is that over the range, for any function that is integrable between all of these points:
// integrals add up along the line, whatever the order of the points on it.
//
// That points are the same is decided exactly: they are rational numbers, or they are one of the
// range's own ends, which has a name. What a rule says of an end is not believed: that the end lies
// in the interval that the rule was given, in which its bounds hold, is proved from the end's
// enclosures.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "polhode/arithmetic/end_point.hpp"

namespace polhode::detail {

/// The sign of end - q: 1, 0 (only where the end is exact), -1. Returns nullopt where no enclosure
/// of up to 2^15 bits tells.
[[nodiscard]] std::optional<int> side_of(const end_point& end, const rational& q);

/// Where a piece begins or ends: at a rational number, or at an end of the range.
struct place {
  enum class kind : std::uint8_t { exact, lower_end, upper_end };
  kind what = kind::exact;
  rational at;  // where it is exact

  place(rational q) : at(std::move(q)) {}  // NOLINT(google-explicit-constructor): the same number
  [[nodiscard]] static place lower_end() { return place(kind::lower_end); }
  [[nodiscard]] static place upper_end() { return place(kind::upper_end); }

  bool operator==(const place&) const = default;

 private:
  explicit place(kind which) : what(which) {}
};

/// What was integrated over.
struct piece_done {
  place from;
  place to;
};

/// An interval with rational ends; no upper end stands for +infinity.
struct closed_interval {
  rational lower;
  std::optional<rational> upper;
};

/// Pieces of a range, which are to tile it.
class range_tiling {
 public:
  range_tiling(const end_point& lower, const end_point& upper) : lower_(lower), upper_(upper) {}

  /// Notes a piece. Where it is not proved that both its ends lie in the interval that the rule was
  /// given, the range counts as not tiled.
  void add(const piece_done& done, const closed_interval& within);
  /// Notes a piece that is proved to be tiled itself, by smaller ones.
  void add_tiled(const piece_done& done);
  /// The pieces run from the lower end to the upper one, each from where another one ends.
  [[nodiscard]] bool is_complete() const;

 private:
  [[nodiscard]] place normal(const place& p) const;
  [[nodiscard]] bool is_in(const place& p, const closed_interval& within) const;

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

  void add(const piece_done& done, const closed_interval& within, const Value& value) {
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
