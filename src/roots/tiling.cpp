#include "tiling.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "polhode/arithmetic/boost_bridge.hpp"

namespace polhode::detail {

ball exact_interval::to_ball(precision p) const {
  mpfr_float low = zero_of_precision(p);
  mpfr_float high = zero_of_precision(p);
  if (lower) {
    mpfr_set_q(low.backend().data(), lower->backend().data(), MPFR_RNDD);
  } else {
    mpfr_set_inf(low.backend().data(), -1);
  }
  if (upper) {
    mpfr_set_q(high.backend().data(), upper->backend().data(), MPFR_RNDU);
  } else {
    mpfr_set_inf(high.backend().data(), 1);
  }
  return ball::from_end_points(low.backend().data(), high.backend().data(), p);
}

bool precedes(const exact_interval& x, const exact_interval& y) {
  if (!x.lower || !y.lower) return !x.lower && y.lower;
  return *x.lower < *y.lower;
}

namespace {

/// x ends before y, as upper ends.
bool ends_before(const exact_interval& x, const exact_interval& y) {
  if (!x.upper || !y.upper) return x.upper && !y.upper;
  return *x.upper < *y.upper;
}

/// In the order of the lower ends, a point before what begins at it.
bool comes_before(const exact_interval& x, const exact_interval& y) {
  if (precedes(x, y)) return true;
  return !precedes(y, x) && ends_before(x, y);
}

}  // namespace

bool holds(const exact_interval& x, const exact_interval& y) {
  return !precedes(y, x) && !ends_before(x, y);
}

bool holds(const ball& x, const exact_interval& y) {
  if (x.is_undefined()) return false;
  const auto is_infinite = [](const mpfr_float& end) {
    return mpfr_inf_p(end.backend().data()) != 0;
  };
  return (y.lower ? contains(x, *y.lower) : is_infinite(lower(x))) &&
         (y.upper ? contains(x, *y.upper) : is_infinite(upper(x)));
}

void expect(bool claim, const char* what) {
  if (!claim) {
    throw std::logic_error(std::string("internal error in a search for roots, no result: ") + what);
  }
}

void interval_tiling::expect_complete() {
  const auto before = [](const exact_interval* x, const exact_interval* y) {
    return comes_before(*x, *y);
  };
  if (pieces_.size() > 1) std::sort(pieces_.begin(), pieces_.end(), before);
  expect(!pieces_.empty() && pieces_.front()->lower == whole_->lower,
         "the pieces do not begin where the interval does");
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const exact_interval& x = *pieces_[i];
    expect(!x.is_bounded() || *x.lower <= *x.upper, "a piece ends before it begins");
    if (i == 0) continue;
    const exact_interval& last = *pieces_[i - 1];
    expect(last.upper && x.lower && *last.upper == *x.lower, "the pieces do not join");
    expect(!x.is_point() || !last.is_point(), "a point is examined twice");
  }
  expect(pieces_.back()->upper == whole_->upper, "the pieces do not end where the interval does");
}

void settled_pieces::add_without_root(const exact_interval& x) {
  if (!pieces_.empty() && !pieces_.back().region) {  // a search goes from left to right
    exact_interval& last = pieces_.back().x;
    if (last.upper && x.lower && *last.upper == *x.lower && !x.is_point()) {
      last.upper = x.upper;
      return;
    }
  }
  pieces_.push_back({x, std::nullopt});
}

void settled_pieces::add_known(const exact_interval& x, std::size_t region) {
  pieces_.push_back({x, region});
}

void settled_pieces::expect_whole(const std::vector<const exact_interval*>& open,
                                  std::size_t regions) const {
  interval_tiling all(whole_);
  for (const piece& p : pieces_) {
    all.add(p.x);
    expect(!p.region || *p.region < regions, "a root that is known is not in the list");
  }
  for (const exact_interval* x : open) all.add(*x);
  all.expect_complete();
}

rational share_of(int halvings) {
  return rational(1) / rational(integer(1) << static_cast<unsigned>(halvings));
}

void expect_all_shares(const rational& settled, const std::vector<int>& open) {
  rational sum = settled;
  for (const int halvings : open) sum += share_of(halvings);
  expect(sum == 1, "the boxes are not all of the box, each once");
}

void expect_cut(const std::vector<ball>& box, const std::vector<ball>& left,
                const std::vector<ball>& right) {
  expect(left.size() == box.size() && right.size() == box.size(), "a part of another dimension");
  const auto ends = [](const ball& x) {
    return exact_interval{lower_rational(x), upper_rational(x)};
  };
  int directions = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (contains(left[i], box[i]) && contains(right[i], box[i])) continue;
    ++directions;
    if (!box[i].is_bounded()) {
      // Up to the place of the cut, and from there on.
      const mpfr_float end = upper(left[i]);
      expect(mpfr_number_p(end.backend().data()) != 0, "the cut bounds no part");
      const rational cut = lower_rational(ball(end));
      const precision p = precision_of(end) + 64;
      const ball below = exact_interval{std::nullopt, cut}.to_ball(p);
      const ball above = exact_interval{cut, std::nullopt}.to_ball(p);
      expect(contains(left[i], intersection(box[i], below)) &&
                 contains(right[i], intersection(box[i], above)),
             "the parts of a box leave a gap");
      continue;
    }
    expect(left[i].is_bounded() && right[i].is_bounded(), "a part is not bounded");
    const exact_interval whole = ends(box[i]);
    const exact_interval low = ends(left[i]);
    const exact_interval high = ends(right[i]);
    expect(*low.lower <= *whole.lower && *high.lower <= *low.upper && *whole.upper <= *high.upper,
           "the parts of a box leave a gap");
  }
  expect(directions <= 1, "the parts of a box leave a corner");
}

}  // namespace polhode::detail
