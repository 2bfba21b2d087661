#include "clusters.hpp"

#include <algorithm>
#include <iterator>

namespace polhode::detail {

namespace {

bool are_neighbours(const work_box& b, const work_box& c, const std::vector<found_root>& found) {
  if (!b.x.upper || !c.x.lower) return true;
  if (*c.x.lower <= *b.x.upper) return true;
  if (!b.x.is_bounded() || !c.x.is_bounded() ||
      *c.x.lower - *b.x.upper > 4 * (b.x.width() + c.x.width())) {
    return false;
  }
  const ball gap = exact_box{*b.x.upper, *c.x.lower}.to_ball(b.bits);
  return std::none_of(found.begin(), found.end(), [&](const found_root& r) {
    return r.problem == b.problem && overlaps(r.region.enclosure, gap);
  });
}

}  // namespace

std::vector<work_box> joined(std::vector<work_box> boxes, const std::vector<found_root>& found) {
  std::sort(boxes.begin(), boxes.end(), [](const work_box& x, const work_box& y) {
    return x.problem != y.problem ? x.problem < y.problem : precedes(x.x, y.x);
  });
  std::vector<work_box> result;
  for (work_box& b : boxes) {
    if (!result.empty() && result.back().problem == b.problem &&
        are_neighbours(result.back(), b, found)) {
      exact_box& x = result.back().x;
      if (x.upper && (!b.x.upper || *x.upper < *b.x.upper)) x.upper = b.x.upper;
      result.back().bits = std::max(result.back().bits, b.bits);
      result.back().is_open_end |= b.is_open_end;
      result.back().has_endless_roots |= b.has_endless_roots;
    } else {
      result.push_back(std::move(b));
    }
  }
  return result;
}

std::vector<std::vector<const exact_box*>> parts_of(const std::vector<work_box>& clusters,
                                                    const std::vector<work_box>& boxes) {
  std::vector<std::vector<const exact_box*>> parts(clusters.size());
  for (const work_box& b : boxes) {
    // The last cluster that does not begin after it.
    const auto next = std::upper_bound(
        clusters.begin(), clusters.end(), b, [](const work_box& x, const work_box& y) {
          return x.problem != y.problem ? x.problem < y.problem : precedes(x.x, y.x);
        });
    expect(next != clusters.begin(), "an open box is in no cluster");
    const work_box& cluster = *std::prev(next);
    expect(cluster.problem == b.problem && holds(cluster.x, b.x), "an open box is in no cluster");
    parts[static_cast<std::size_t>(std::prev(next) - clusters.begin())].push_back(&b.x);
  }
  return parts;
}

}  // namespace polhode::detail
