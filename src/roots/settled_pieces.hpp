#pragma once

// The account of a search for roots: what it has settled, and the proof that this and what it left
// open are the whole that it was asked for.
//
// An examination of a part of the interval returns what it has proved, and of which pieces of that
// part. Nobody trusts it about the pieces: whoever puts the results together proves that the pieces
// make up the part (tiling.hpp), and with `holds` that each proof was made over a set that has the
// piece in it. settled_pieces keeps the settled pieces, and proves at the end that they and the
// open ones make up the whole interval.
//
// A piece left out, done twice, with a wrong end or beyond its part is a fault of the library,
// never a property of the function: all of them throw std::logic_error, and there is no result. The
// same for boxes in several variables, below.

#include <cstddef>
#include <optional>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "tiling/tiling.hpp"

namespace polhode::detail {

/// Throws std::logic_error with the claim in its message where it is false.
void expect(bool claim, const char* what);

/// Throws std::logic_error unless the pieces are a tiling of the whole.
void expect_tiling(const exact_interval& whole, const std::vector<const exact_interval*>& pieces);

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
