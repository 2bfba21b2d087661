#include "scene/inertia.hpp"

#include <algorithm>

namespace polhode::detail {

rational dot(const rational_vector& x, const rational_vector& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

namespace {

rational_vector cross(const rational_vector& x, const rational_vector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
rational_vector negative(const rational_vector& x) { return {-x[0], -x[1], -x[2]}; }

/// Turns z round where the frame is left-handed.
void make_right_handed(std::array<principal_axis, 3>& axes) {
  if (dot(cross(axes[0].direction, axes[1].direction), axes[2].direction) < 0) {
    axes[2].direction = negative(axes[2].direction);
  }
}

body_kind kind_by_margin(const rational& margin) {
  if (margin == 0) return body_kind::planar;
  return margin > 0 ? body_kind::physical : body_kind::non_physical;
}

/// Of moments in descending order, and the axes that belong to them.
scene_body sorted_body(const rational_vector& moments, std::array<principal_axis, 3> axes) {
  scene_body result;
  result.moments = moments;
  make_right_handed(axes);
  result.axes = std::move(axes);
  result.margin = moments[1] + moments[2] - moments[0];
  result.kind = kind_by_margin(*result.margin);
  if (moments[0] > moments[1] && moments[1] > moments[2])
    result.rigid = body::from_moments(moments);
  return result;
}

/// An eigenvector of a simple eigenvalue: A - lambda has rank 2, and is symmetric, so that the cross product of two independent rows
/// is orthogonal to all rows.
rational_vector eigenvector(const tensor_entries& t, const rational& value) {
  const auto& [xx, yy, zz, xy, xz, yz] = t;
  const std::array<rational_vector, 3> rows{
      {{xx - value, xy, xz}, {xy, yy - value, yz}, {xz, yz, zz - value}}};
  for (std::size_t i = 0; i < 3; ++i) {
    rational_vector v = cross(rows[i], rows[(i + 1) % 3]);
    if (dot(v, v) != 0) return v;
  }
  throw std::logic_error("an eigenvalue is not simple");
}

}  // namespace

scene_body body_of_moments(const rational_vector& given) {
  refuse_unless_positive(given);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return given[i] > given[j]; });
  rational_vector moments;
  std::array<principal_axis, 3> axes;
  for (std::size_t i = 0; i < 3; ++i) {
    moments[i] = given[order[i]];
    axes[i].direction = {0, 0, 0};
    axes[i].direction[order[i]] = 1;
  }
  return sorted_body(moments, axes);
}

scene_body body_of_tensor(const tensor_entries& given) {
  if (given[3] == 0 && given[4] == 0 && given[5] == 0)
    return body_of_moments({given[0], given[1], given[2]});
  const inertia_tensor whole(given);
  scene_body result;
  rational_vector moments;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<rational>& exact = whole.exact_moments()[i];
    if (!exact) {
      result.tensor = whole;
      result.kind = whole.kind();
      return result;
    }
    moments[i] = *exact;
  }
  std::array<principal_axis, 3> axes;
  for (std::size_t i = 0; i < 3; ++i) {
    axes[i].direction = eigenvector(given, moments[i]);
    axes[i].square = dot(axes[i].direction, axes[i].direction);
  }
  return sorted_body(moments, axes);
}

void set_ranges(scene_body& of, const std::array<uncertain_moment, 3>& given) {
  of.ranges.emplace(given);
  of.kind = of.ranges->kind();
  // Those of principal moments are along the axes.
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (of.axes[i].direction[k] != 0) of.uncertainties[i] = given[k];
    }
  }
}

}  // namespace polhode::detail
