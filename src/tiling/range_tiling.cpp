#include "tiling.hpp"

#include <algorithm>

namespace polhode::detail {
namespace {

/// The lower end comes first, then exact places in their order, then the upper end.
bool comes_before(const piece_end& p, const piece_end& q) {
  const auto rank = [](const piece_end& x) {
    return x.what == piece_end::kind::lower_end ? 0 : x.what == piece_end::kind::exact ? 1 : 2;
  };
  if (rank(p) != rank(q)) return rank(p) < rank(q);
  return p.what == piece_end::kind::exact && p.at < q.at;
}

}  // namespace

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

piece_end range_tiling::normal(const piece_end& p) const {
  if (p.what == piece_end::kind::lower_end && lower_.exact()) return *lower_.exact();
  if (p.what == piece_end::kind::upper_end && upper_.exact()) return *upper_.exact();
  return p;
}

bool range_tiling::is_in(const piece_end& p, const exact_interval& within) const {
  if (p.what == piece_end::kind::exact) return within.contains(p.at);
  const end_point& end = p.what == piece_end::kind::lower_end ? lower_ : upper_;
  // An infinite end is one of an interval without that end.
  if (end.is_infinite()) return end.infinite_sign() > 0 ? !within.upper : !within.lower;
  const auto is_beyond = [&](const std::optional<rational>& bound, int outward) {
    if (!bound) return false;
    const std::optional<int> side = side_of(end, *bound);
    return !side || *side == outward;
  };
  return !is_beyond(within.lower, -1) && !is_beyond(within.upper, 1);
}

void range_tiling::add(const piece_done& done, const exact_interval& within) {
  const piece_done piece{normal(done.from), normal(done.to)};
  if (!is_in(piece.from, within) || !is_in(piece.to, within)) is_refuted_ = true;
  pieces_.push_back(piece);
}

void range_tiling::add_tiled(const piece_done& done) {
  pieces_.push_back({normal(done.from), normal(done.to)});
}

bool range_tiling::is_complete() const {
  if (is_refuted_) return false;
  return form_a_chain(pieces_, normal(piece_end::lower_end()), normal(piece_end::upper_end()));
}

bool form_a_chain(std::vector<piece_done> pieces, const piece_end& first, const piece_end& last) {
  if (pieces.empty()) return false;
  std::sort(pieces.begin(), pieces.end(), [](const piece_done& p, const piece_done& q) {
    return p.from == q.from ? comes_before(p.to, q.to) : comes_before(p.from, q.from);
  });
  piece_end reached = first;
  for (const piece_done& p : pieces) {
    if (p.from != reached) return false;
    reached = p.to;
  }
  return reached == last;
}

bool is_tiling(const exact_interval& whole, const std::vector<const exact_interval*>& pieces) {
  const auto ends_of = [](const exact_interval& x) {
    return piece_done{x.lower ? piece_end(*x.lower) : piece_end::lower_end(),
                      x.upper ? piece_end(*x.upper) : piece_end::upper_end()};
  };
  if (pieces.size() == 1) {
    const exact_interval& x = *pieces.front();
    return x == whole && !(x.is_bounded() && *x.lower > *x.upper);
  }
  std::vector<piece_done> done;
  std::vector<rational> points;
  done.reserve(pieces.size());
  for (const exact_interval* x : pieces) {
    if (x->is_bounded() && *x->lower > *x->upper) return false;
    if (x->is_point()) points.push_back(*x->lower);
    done.push_back(ends_of(*x));
  }
  std::sort(points.begin(), points.end());
  if (std::adjacent_find(points.begin(), points.end()) != points.end()) return false;
  const piece_done all = ends_of(whole);
  return form_a_chain(std::move(done), all.from, all.to);
}

}  // namespace polhode::detail
