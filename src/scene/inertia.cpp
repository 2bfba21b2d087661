#include "scene/inertia.hpp"

#include <algorithm>
#include <numeric>

#include "polhode/arithmetic/text.hpp"
#include "polhode/roots/polynomial.hpp"

namespace polhode::detail {
namespace {

rational_vector cross(const rational_vector& x, const rational_vector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
rational dot(const rational_vector& x, const rational_vector& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
rational_vector negative(const rational_vector& x) { return {-x[0], -x[1], -x[2]}; }

std::string listed(const rational_vector& x) {
  return to_text(x[0]) + ", " + to_text(x[1]) + ", " + to_text(x[2]);
}

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

struct characteristic {
  rational trace, minors, determinant;
  [[nodiscard]] rational_polynomial polynomial() const {
    return rational_polynomial(std::vector<rational>{-determinant, minors, -trace, 1});
  }
};

characteristic characteristic_of(const inertia_tensor& t) {
  const auto& [xx, yy, zz, xy, xz, yz] = t;
  return {xx + yy + zz, xx * yy + yy * zz + zz * xx - xy * xy - xz * xz - yz * yz,
          xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz)};
}

/// x/2^bits with fewer than k different roots of p in (0, (x-1)/2^bits] and at least k in (0, x/2^bits]. Hypothesis: there are k in (0, bound].
rational root_from_above(const rational_polynomial& p, long k, const rational& bound, long bits) {
  integer unit_size;
  mpz_ui_pow_ui(unit_size.backend().data(), 2, static_cast<unsigned long>(bits));
  integer low = 0;
  integer high = numerator(bound) / denominator(bound) + 1;
  high *= unit_size;
  while (high - low > 1) {
    const integer middle = (low + high) / 2;
    (count_real_roots(p, 0, rational(middle, unit_size)) >= k ? high : low) = middle;
  }
  return {high, unit_size};
}

/// An eigenvector of a simple eigenvalue: A - lambda has rank 2, and is symmetric, so that the cross product of two independent rows
/// is orthogonal to all rows.
rational_vector eigenvector(const inertia_tensor& t, const rational& value) {
  const auto& [xx, yy, zz, xy, xz, yz] = t;
  const std::array<rational_vector, 3> rows{
      {{xx - value, xy, xz}, {xy, yy - value, yz}, {xz, yz, zz - value}}};
  for (std::size_t i = 0; i < 3; ++i) {
    rational_vector v = cross(rows[i], rows[(i + 1) % 3]);
    if (dot(v, v) != 0) return v;
  }
  throw std::logic_error("an eigenvalue is not simple");
}

constexpr std::size_t most_bits = 4096;

}  // namespace

scene_body body_of_moments(const rational_vector& given) {
  for (const rational& moment : given) {
    if (moment > 0) continue;
    throw input_error("moments of inertia " + listed(given) + ": " + to_text(moment) +
                      " is not positive; all three must be");
  }
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

scene_body body_of_tensor(const inertia_tensor& given) {
  if (given[3] == 0 && given[4] == 0 && given[5] == 0)
    return body_of_moments({given[0], given[1], given[2]});
  integer common = 1;
  for (const rational& entry : given) common = lcm(common, denominator(entry));
  inertia_tensor t;
  for (std::size_t i = 0; i < 6; ++i) {
    t[i] = given[i] * common;
    if (mpz_sizeinbase(numerator(t[i]).backend().data(), 2) <= most_bits) continue;
    throw input_error("inertia tensor: with a common denominator an entry has more than " +
                      std::to_string(most_bits) + " bits; give shorter numbers, or the moments");
  }
  const characteristic ch = characteristic_of(t);
  // All roots of the characteristic polynomial are real: they are positive exactly where its signs alternate.
  if (ch.trace <= 0 || ch.minors <= 0 || ch.determinant <= 0) {
    std::string text;
    for (const rational& entry : given) text += (text.empty() ? "" : ", ") + to_text(entry);
    throw input_error(
        "inertia tensor " + text +
        " (xx, yy, zz, xy, xz, yz): a principal moment is not positive; all three must be");
  }
  const rational_polynomial p = ch.polynomial();
  const long distinct = count_real_roots(p, 0, ch.trace);
  if (distinct < 3) {
    throw input_error(
        "inertia tensor: two principal moments are equal, and the tensor is not given in principal "
        "axes; give the moments");
  }
  rational_vector moments;
  bool all_rational = true;
  for (std::size_t i = 0; i < 3; ++i) {
    // The entries are integers, and the polynomial leads with 1: rational roots are integers.
    moments[i] = root_from_above(p, 3 - static_cast<long>(i), ch.trace, 0);
    all_rational = all_rational && p(moments[i]) == 0;
  }
  if (all_rational) {
    std::array<principal_axis, 3> axes;
    for (std::size_t i = 0; i < 3; ++i) {
      axes[i].direction = eigenvector(t, moments[i]);
      axes[i].square = dot(axes[i].direction, axes[i].direction);
      moments[i] /= common;
    }
    return sorted_body(moments, axes);
  }
  constexpr long bits = 400;
  const rational width(1, integer(1) << bits);
  std::array<uncertain_moment, 3> ranges;
  for (std::size_t i = 0; i < 3; ++i) {
    const rational upper = root_from_above(p, 3 - static_cast<long>(i), ch.trace, bits);
    ranges[i] = {(upper - width / 2) / common, width / 2 / common};
  }
  scene_body result;
  result.irrational = true;
  result.ranges.emplace(ranges);
  const rational half(ch.trace / 2);
  result.kind = p(half) == 0                              ? body_kind::planar
                : count_real_roots(p, half, ch.trace) > 0 ? body_kind::non_physical
                                                          : body_kind::physical;
  return result;
}

scene_body body_of_ranges(const std::array<uncertain_moment, 3>& given) {
  scene_body result = body_of_moments({given[0].value, given[1].value, given[2].value});
  result.ranges.emplace(given);
  result.kind = result.ranges->kind();
  return result;
}

}  // namespace polhode::detail
