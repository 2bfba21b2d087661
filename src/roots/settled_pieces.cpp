#include "settled_pieces.hpp"

#include <stdexcept>
#include <string>

#include "polhode/arithmetic/boost_bridge.hpp"

namespace polhode::detail {

void expect(bool claim, const char* what) {
  if (!claim) {
    throw std::logic_error(std::string("internal error in a search for roots, no result: ") + what);
  }
}

void expect_tiling(const exact_interval& whole, const std::vector<const exact_interval*>& pieces) {
  expect(is_tiling(whole, pieces), "the pieces do not make up the interval, each point once");
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
  std::vector<const exact_interval*> all = open;
  for (const piece& p : pieces_) {
    all.push_back(&p.x);
    expect(!p.region || *p.region < regions, "a root that is known is not in the list");
  }
  expect_tiling(whole_, all);
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
