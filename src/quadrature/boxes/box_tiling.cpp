#include "box_tiling.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace polhode::detail {
namespace {

using parts_of_box = std::vector<const parameter_box*>;

[[noreturn]] void refuse() {
  throw std::logic_error("internal error in integrate_box, no result: the parts are not the box");
}

bool are_equal(const parameter_box& x, const parameter_box& y) {
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](const parameter_range& s, const parameter_range& t) {
                      return s.lower() == t.lower() && s.upper() == t.upper();
                    });
}

struct cutting_plane {
  std::size_t direction = 0;
  rational at;
  std::size_t below = 0;  // so many parts
};

/// Sorts the parts by their lower ends in that direction. The plane, of those that pass through no
/// part, with the numbers of parts on its sides nearest to each other.
std::optional<cutting_plane> best_plane(parts_of_box& parts, std::size_t direction) {
  std::sort(parts.begin(), parts.end(), [&](const parameter_box* x, const parameter_box* y) {
    return (*x)[direction].lower() < (*y)[direction].lower();
  });
  std::optional<cutting_plane> best;
  const auto distance = [&](std::size_t below) {
    return std::max(below, parts.size() - below) - std::min(below, parts.size() - below);
  };
  rational most = (*parts.front())[direction].upper();  // of the parts before the k-th
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const parameter_range& side = (*parts[k])[direction];
    // A part without width in this direction could be on either side.
    const bool is_free = most <= side.lower() && side.lower() < side.upper() &&
                         (*parts[k - 1])[direction].lower() < side.lower();
    if (is_free && (!best || distance(k) < distance(best->below))) {
      best = cutting_plane{direction, side.lower(), k};
    }
    most = std::max(most, side.upper());
  }
  return best;
}

}  // namespace

void expect_box_tiling(const parameter_box& whole, const parts_of_box& parts) {
  const auto has_sides = [&](const parameter_box* x) { return x->size() == whole.size(); };
  if (parts.empty() || !std::all_of(parts.begin(), parts.end(), has_sides)) refuse();
  if (parts.size() == 1) {
    if (!are_equal(*parts.front(), whole)) refuse();
    return;
  }
  parts_of_box sorted = parts;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const auto plane = best_plane(sorted, i);
    if (!plane) continue;
    if (plane->at <= whole[i].lower() || plane->at >= whole[i].upper()) refuse();
    parameter_box below = whole;
    parameter_box above = whole;
    below[i] = parameter_range(whole[i].lower(), plane->at);
    above[i] = parameter_range(plane->at, whole[i].upper());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(plane->below);
    expect_box_tiling(below, {sorted.begin(), middle});
    expect_box_tiling(above, {middle, sorted.end()});
    return;
  }
  refuse();
}

}  // namespace polhode::detail
