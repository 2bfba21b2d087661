#pragma once

// The proof that a search for roots has examined the whole of its interval.
//
// An examination of a part of the interval returns what it has proved, and of which pieces of that
// part. Nobody trusts it about the pieces: whoever puts the results together proves with
// `interval_tiling`, in exact arithmetic, that the pieces make up the part, and with `holds` that
// each proof was made over a set that has the piece in it. settled_pieces keeps the settled pieces,
// and proves at the end that they and the open ones make up the whole interval.
//
// A piece left out, done twice, with a wrong end or beyond its part is a fault of the library,
// never a property of the function: all of them throw std::logic_error, and there is no result. The
// same for boxes in several variables, below.

#include <cstddef>
#include <optional>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail {

/// A closed interval whose ends are exact, or infinite where there is none.
struct exact_interval {
  std::optional<rational> lower;
  std::optional<rational> upper;

  [[nodiscard]] bool is_bounded() const { return lower && upper; }
  [[nodiscard]] bool is_point() const { return is_bounded() && *lower == *upper; }
  /// Hypothesis of these two: it is bounded.
  [[nodiscard]] rational width() const { return *upper - *lower; }
  [[nodiscard]] rational middle() const { return (*lower + *upper) / 2; }
  /// The interval, its ends rounded outward.
  [[nodiscard]] ball to_ball(precision p) const;
};

/// Whether x is the left one: its lower end is less.
[[nodiscard]] bool precedes(const exact_interval& x, const exact_interval& y);
/// Every member of y is one of x. Exact; false where x is undefined.
[[nodiscard]] bool holds(const exact_interval& x, const exact_interval& y);
[[nodiscard]] bool holds(const ball& x, const exact_interval& y);

/// Throws std::logic_error with the claim in its message where it is false.
void expect(bool claim, const char* what);

/// The pieces that make up an interval.
class interval_tiling {
 public:
  /// Both are kept by their address.
  explicit interval_tiling(const exact_interval& whole) : whole_(&whole) {}
  void add(const exact_interval& piece) { pieces_.push_back(&piece); }

  /// Throws std::logic_error unless the pieces, from left to right, begin where the whole begins,
  /// go on each where the one before it ends, and end where the whole ends: then every point of the
  /// whole is in one piece, or is the common end of pieces, and no piece has a point beyond the
  /// whole. A point may be a piece, once.
  void expect_complete();

 private:
  const exact_interval* whole_;
  std::vector<const exact_interval*> pieces_;
};

/// The settled pieces of an interval.
class settled_pieces {
 public:
  explicit settled_pieces(exact_interval whole) : whole_(std::move(whole)) {}

  [[nodiscard]] const exact_interval& whole() const { return whole_; }
  void add_without_root(const exact_interval& x);
  /// All roots in x are known: those of the region with that number.
  void add_known(const exact_interval& x, std::size_t region);
  /// Throws std::logic_error unless the settled and the open pieces are a tiling of the whole, and
  /// the regions are among the first so many.
  void expect_whole(const std::vector<const exact_interval*>& open, std::size_t regions) const;

 private:
  struct piece {
    exact_interval x;
    std::optional<std::size_t> region;  // none where there is no root
  };
  exact_interval whole_;
  std::vector<piece> pieces_;
};

// Boxes in several variables, which are bisected. Their ends are rounded outward, so that they
// overlap; they are accounted for by their shares: a box that is cut leaves half of its share to
// either part, and the shares of all boxes, settled and open, are 1 together exactly where none was
// lost and none was counted twice.

/// 2^-halvings.
[[nodiscard]] rational share_of(int halvings);
/// Throws std::logic_error unless the settled share and those of the open boxes, by their halvings,
/// are 1 together.
void expect_all_shares(const rational& settled, const std::vector<int>& open);
/// Throws std::logic_error unless every point of the box is in one of the two parts, which differ
/// in one direction.
void expect_cut(const std::vector<ball>& box, const std::vector<ball>& left,
                const std::vector<ball>& right);

}  // namespace polhode::detail
