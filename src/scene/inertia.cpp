#include "scene/inertia.hpp"

#include <memory>

namespace polhode::detail {

scene_body body_of_tensor(const tensor_entries& given) {
  scene_body result;
  result.axes = std::make_shared<const principal_axes>(given);
  result.kind = result.axes->kind();
  return result;
}

scene_body body_of_moments(const rational_vector& given) {
  return body_of_tensor({given[0], given[1], given[2], 0, 0, 0});
}

void set_ranges(scene_body& of, const std::array<uncertain_moment, 3>& given) {
  of.ranges.emplace(given);
  of.kind = of.ranges->kind();
  const triple<int> order = of.axes->along_given_axes()->order;
  for (std::size_t i = 0; i < 3; ++i) {
    of.uncertainties[i] = given[static_cast<std::size_t>(order[i])];
  }
}

}  // namespace polhode::detail
