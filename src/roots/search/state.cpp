#include "state.hpp"

#include "polhode/arithmetic/interval.hpp"

namespace polhode::detail {

void expect_whole(const exact_box& box, const outcome& o) {
  std::vector<const exact_box*> pieces;
  for (const work_box& b : o.rest) pieces.push_back(&b.x);
  for (const work_box& b : o.stuck) pieces.push_back(&b.x);
  for (const auto& e : o.excluded) {
    pieces.push_back(&e.x);
    expect(holds(e.over, e.x), "a piece without a root is not in the set that has none");
  }
  if (o.known) {
    pieces.push_back(&box);
    expect(holds(o.known->done, box), "a box is not in the part where the roots are known");
    expect(holds(o.known->over, o.known->done), "a part is not in the set that the proof is about");
    if (const auto& r = o.known->region) {
      expect(contains(r->box, r->enclosure), "an enclosure is not in the box of its region");
    }
  }
  expect_tiling(box, pieces);
}

void expect_whole(const root_search::state& s) {
  constexpr precision p = 192;  // other than that which the ends were made with
  for (std::size_t i = 0; i < s.problems.size(); ++i) {
    const exact_box& whole = s.settled[i].whole();
    const auto is_outside = [&](const std::optional<rational>& end, const end_point& asked,
                                bool is_lower) {
      if (asked.infinite_sign() != 0) return !end;
      if (asked.exact()) return end == asked.exact();
      if (!end) return false;
      const ball e = asked.at(p);
      const ball b(*end, p);
      return is_lower ? !certainly_less(e, b) : !certainly_less(b, e);
    };
    expect(is_outside(whole.lower, s.lower, true) && is_outside(whole.upper, s.upper, false),
           "the interval is not the one that was asked for");
    std::vector<const exact_box*> open;
    for (const auto* boxes : {&s.pending, &s.stuck}) {
      for (const work_box& b : *boxes) {
        if (b.problem == i) open.push_back(&b.x);
      }
    }
    s.settled[i].expect_whole(open, s.found.size());
  }
}

}  // namespace polhode::detail
