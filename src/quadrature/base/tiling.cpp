#include "tiling.hpp"

#include <algorithm>

namespace polhode::detail {

std::optional<int> side_of(const end_point& end, const rational& q) {
  if (end.is_infinite()) return end.infinite_sign();
  if (end.exact()) return *end.exact() < q ? -1 : *end.exact() > q ? 1 : 0;
  constexpr precision most = 1L << 15;
  for (precision p = 64; p <= most; p *= 2) {
    const ball x = end.at(p);
    const ball other(q, p);
    if (certainly_less(x, other)) return -1;
    if (certainly_less(other, x)) return 1;
  }
  return std::nullopt;
}

place range_tiling::normal(const place& p) const {
  if (p.what == place::kind::lower_end && lower_.exact()) return *lower_.exact();
  if (p.what == place::kind::upper_end && upper_.exact()) return *upper_.exact();
  return p;
}

bool range_tiling::is_in(const place& p, const closed_interval& within) const {
  if (p.what == place::kind::exact) {
    return within.lower <= p.at && (!within.upper || p.at <= *within.upper);
  }
  const end_point& end = p.what == place::kind::lower_end ? lower_ : upper_;
  if (end.is_infinite()) return end.infinite_sign() > 0 && !within.upper;
  const std::optional<int> above = side_of(end, within.lower);
  if (!above || *above < 0) return false;
  if (!within.upper) return true;
  const std::optional<int> below = side_of(end, *within.upper);
  return below && *below <= 0;
}

void range_tiling::add(const piece_done& done, const closed_interval& within) {
  const piece_done piece{normal(done.from), normal(done.to)};
  if (!is_in(piece.from, within) || !is_in(piece.to, within)) is_refuted_ = true;
  pieces_.push_back(piece);
}

void range_tiling::add_tiled(const piece_done& done) {
  pieces_.push_back({normal(done.from), normal(done.to)});
}

bool range_tiling::is_complete() const {
  if (is_refuted_ || pieces_.empty()) return false;
  // The lower end comes first, then exact places in their order, then the upper end.
  const auto rank = [](const place& p) {
    return p.what == place::kind::lower_end ? 0 : p.what == place::kind::exact ? 1 : 2;
  };
  std::vector<piece_done> pieces = pieces_;
  std::sort(pieces.begin(), pieces.end(), [&](const piece_done& p, const piece_done& q) {
    if (rank(p.from) != rank(q.from)) return rank(p.from) < rank(q.from);
    return rank(p.from) == 1 && p.from.at < q.from.at;
  });
  place reached = normal(place::lower_end());
  for (const piece_done& p : pieces) {
    if (p.from != reached) return false;
    reached = p.to;
  }
  return reached == normal(place::upper_end());
}

}  // namespace polhode::detail
