#include <algorithm>
#include <optional>

#include "tiling.hpp"

namespace polhode::detail {
namespace {

using parts_of_box = std::vector<const exact_sides*>;

struct cutting_plane {
  std::size_t direction = 0;
  rational at;
  std::size_t below = 0;  // so many parts
};

/// Sorts the parts by their lower ends in that direction. The plane, of those that pass through no
/// part, with the numbers of parts on its sides nearest to each other.
std::optional<cutting_plane> best_plane(parts_of_box& parts, std::size_t direction) {
  std::sort(parts.begin(), parts.end(), [&](const exact_sides* x, const exact_sides* y) {
    return precedes((*x)[direction], (*y)[direction]);
  });
  std::optional<cutting_plane> best;
  const auto distance = [&](std::size_t below) {
    return std::max(below, parts.size() - below) - std::min(below, parts.size() - below);
  };
  rational most = *(*parts.front())[direction].upper;  // of the parts before the k-th
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const exact_interval& side = (*parts[k])[direction];
    // A part without width in this direction could be on either side.
    const bool is_free =
        most <= *side.lower && !side.is_point() && precedes((*parts[k - 1])[direction], side);
    if (is_free && (!best || distance(k) < distance(best->below))) {
      best = cutting_plane{direction, *side.lower, k};
    }
    most = std::max(most, *side.upper);
  }
  return best;
}

}  // namespace

bool is_tiling(const exact_sides& whole, parts_of_box parts) {
  const auto has_sides = [&](const exact_sides* x) {
    return x->size() == whole.size() &&
           std::all_of(x->begin(), x->end(), [](const auto& side) { return side.is_bounded(); });
  };
  if (parts.empty() || !has_sides(&whole) || !std::all_of(parts.begin(), parts.end(), has_sides)) {
    return false;
  }
  if (parts.size() == 1) return *parts.front() == whole;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const auto plane = best_plane(parts, i);
    if (!plane) continue;
    if (plane->at <= *whole[i].lower || plane->at >= *whole[i].upper) return false;
    exact_sides below = whole;
    exact_sides above = whole;
    below[i].upper = plane->at;
    above[i].lower = plane->at;
    const auto middle = parts.begin() + static_cast<std::ptrdiff_t>(plane->below);
    return is_tiling(below, {parts.begin(), middle}) && is_tiling(above, {middle, parts.end()});
  }
  return false;
}

}  // namespace polhode::detail
