#include "polhode/rigid_body/principal_axes.hpp"

#include <algorithm>
#include <stdexcept>

#include "polhode/arithmetic/elementary.hpp"
#include "rigid_body/vectors.hpp"

namespace polhode {
namespace {

using vector = principal_axes::vector;

using detail::cross;
using detail::dot;
using exact_vector = principal_axes::exact_vector;

template <class T = rational>
std::array<T, 3> unit_vector(std::size_t k) {
  std::array<T, 3> result{0, 0, 0};
  result[k] = 1;
  return result;
}
exact_vector exact_unit_vector(std::size_t k) { return unit_vector<exact_real>(k); }

rational trace_of(const std::array<rational, 6>& t) { return rational(t[0] + t[1] + t[2]); }

std::array<vector, 3> rows_of(const std::array<rational, 6>& t) {
  const auto& [xx, yy, zz, xy, xz, yz] = t;
  return {{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
}

rational determinant_of(const std::array<rational, 6>& t) {
  const auto rows = rows_of(t);
  return dot(rows[0], cross(rows[1], rows[2]));
}

/// v or -v: the first component that is not 0 is positive.
vector with_leading_sign(vector v) {
  const auto first = std::find_if(v.begin(), v.end(), [](const rational& x) { return x != 0; });
  if (*first < 0) {
    for (rational& x : v) x = -x;
  }
  return v;
}

/// An eigenvector of a simple eigenvalue: T - lambda has rank 2 and is symmetric, so that the cross
/// product of two independent rows is orthogonal to all rows.
vector eigenvector(const std::array<rational, 6>& tensor, const rational& value) {
  auto rows = rows_of(tensor);
  for (std::size_t i = 0; i < 3; ++i) rows[i][i] -= value;
  for (std::size_t i = 0; i < 3; ++i) {
    const vector v = cross(rows[i], rows[(i + 1) % 3]);
    if (dot(v, v) != 0) return with_leading_sign(v);
  }
  throw std::logic_error("principal axes: an eigenvalue is not simple");
}

}  // namespace

principal_axes::principal_axes(const std::array<rational, 6>& tensor) : tensor_(tensor) {
  if (tensor[3] == 0 && tensor[4] == 0 && tensor[5] == 0) {
    set_along_given_axes();
  } else if (const auto equal = equal_principal_moments(tensor)) {
    set_symmetric(*equal);
  } else {
    set_different();
  }
}

void principal_axes::set_along_given_axes() {
  const vector given{tensor_[0], tensor_[1], tensor_[2]};
  refuse_unless_positive(given);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return given[i] > given[j]; });
  for (std::size_t i = 0; i < 3; ++i) {
    moments_[i] = given[order[i]];
    axes_[i].direction = unit_vector(order[i]);
  }
  if (moments_[0] > moments_[1] && moments_[1] > moments_[2]) rigid_ = body::from_moments(given);
}

/// Two moments are equal, and all three are rational: the axis of the third is an eigenvector, the
/// others are any two at right angles to it. All three are not equal, as the tensor is not
/// diagonal.
void principal_axes::set_symmetric(const vector& moments) {
  refuse_unless_positive(moments);
  for (std::size_t i = 0; i < 3; ++i) moments_[i] = moments[i];
  const std::size_t single = moments[0] == moments[1] ? 2 : 0;
  const vector along = eigenvector(tensor_, moments[single]);
  // Of the vectors e_k at most one is along the axis.
  vector across = cross(along, unit_vector(0));
  if (dot(across, across) == 0) across = cross(along, unit_vector(1));
  axes_[single].direction = along;
  axes_[(single + 1) % 3].direction = with_leading_sign(across);
  axes_[(single + 2) % 3].direction = with_leading_sign(cross(along, across));
}

void principal_axes::set_different() {
  const auto whole = std::make_shared<const inertia_tensor>(tensor_);
  if (!whole->is_rational()) irrational_ = whole;
  for (std::size_t i = 0; i < 3; ++i) {
    if (const std::optional<rational>& exact = whole->exact_moments()[i]) {
      moments_[i] = *exact;
      axes_[i].direction = eigenvector(tensor_, *exact);
    } else {
      moments_[i] = exact_real::irrational([whole, i](precision p) { return whole->moments(p)[i]; },
                                           whole->lost_bits());
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (axes_[i].direction) continue;
    std::size_t& k = axes_[i].leading;
    while (square_along(i, exact_unit_vector(k)).is_rational()) ++k;  // it is 0
  }
  rigid_ = body::from_inertia_tensor(whole);
}

std::optional<vector> principal_axes::rational_moments() const {
  if (irrational_) return std::nullopt;
  return vector{moments_[0].exact(), moments_[1].exact(), moments_[2].exact()};
}

body_kind principal_axes::kind() const {
  if (irrational_) return irrational_->kind();
  const int sign = margin().sign();
  if (sign == 0) return body_kind::planar;
  return sign > 0 ? body_kind::physical : body_kind::non_physical;
}

exact_real principal_axes::margin() const {
  if (irrational_ && irrational_->kind() == body_kind::planar) return 0;
  return trace_of(tensor_) - 2 * moments_[0];
}

/// u P w, where P is the projector onto the i-th axis: (u v_i)(v_i w). Of an irrational axis, with
/// the i-th moment m and the others m', m'', Lagrange's interpolation gives
///   P = (T - m')(T - m'')/((m - m')(m - m''))
///     = (T^2 - (tr T - m) T + (det T/m))/((m - m')(m - m'')),
/// as m' + m'' = tr T - m and m' m'' = det T/m. So u P w is N/(m (m - m')(m - m'')) with
///   N = gamma + alpha m + beta m^2,
///   alpha = (T u)(T w) - tr T (u T w), beta = u T w, gamma = det T (u w).
/// N = 0 is decided in rationals. Where no moment is rational, the characteristic polynomial has no
/// rational root and, being of degree 3, is irreducible: m is of degree 3, and N is 0 only where
/// alpha, beta and gamma are. Where one other moment r is rational, m is a root of X^2 - S X + Q
/// with S = tr T - r, Q = det T/r, and is irrational: N = (gamma - beta Q) + (alpha + beta S) m is
/// 0 only where both of these are.
exact_real principal_axes::projected(std::size_t i, const exact_vector& u,
                                     const exact_vector& w) const {
  if (axes_[i].direction) {
    const vector& d = *axes_[i].direction;
    return dot(d, u) * dot(d, w) / dot(d, d);
  }
  const rational trace = trace_of(tensor_);
  const rational determinant = determinant_of(tensor_);
  const exact_vector tu = times(u);
  const exact_vector tw = times(w);
  exact_real beta = dot(u, tw);
  exact_real alpha = dot(tu, tw) - trace * beta;
  exact_real gamma = determinant * dot(u, w);
  const auto known = std::find_if(moments_.begin(), moments_.end(),
                                  [](const exact_real& x) { return x.is_rational(); });
  if (known != moments_.end()) {
    gamma = gamma - beta * rational(determinant / known->exact());
    alpha = alpha + beta * rational(trace - known->exact());
    beta = 0;
  }
  const auto is_zero = [](const exact_real& x) { return x.is_rational() && x.exact() == 0; };
  if (is_zero(alpha) && is_zero(beta) && is_zero(gamma)) return 0;
  const exact_real& m = moments_[i];
  const exact_real others = (m - moments_[(i + 1) % 3]) * (m - moments_[(i + 2) % 3]);
  return (gamma / m + alpha + beta * m) / others;
}

exact_real principal_axes::square_along(std::size_t i, const exact_vector& w) const {
  return projected(i, w, w);
}

std::array<exact_real, 6> principal_axes::projector(std::size_t i) const {
  const auto entry = [&](std::size_t k, std::size_t l) {
    return projected(i, exact_unit_vector(k), exact_unit_vector(l));
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

int principal_axes::sense_along(std::size_t i, const exact_vector& w) const {
  const axis_data& axis = axes_[i];
  const bool is_rational =
      std::all_of(w.begin(), w.end(), [](const exact_real& x) { return x.is_rational(); });
  // v_k (v_i w), where v_k > 0 is the leading component.
  const exact_real along =
      axis.direction ? dot(*axis.direction, w) : projected(i, exact_unit_vector(axis.leading), w);
  const int sense = along.sign(is_rational ? exact_real::most_bits : most_bits_of_sense);
  return sense == 0 || i < 2 ? sense : sense * orientation();
}

std::array<ball, 3> principal_axes::unoriented(std::size_t i, precision p) const {
  const axis_data& axis = axes_[i];
  std::array<ball, 3> result;
  if (axis.direction) {
    const vector& d = *axis.direction;
    const rational square = dot(d, d);
    for (std::size_t k = 0; k < 3; ++k) {
      result[k] = sqrt(ball(rational(d[k] * d[k] / square), p)) * d[k].sign();
    }
    return result;
  }
  const exact_vector leading = exact_unit_vector(axis.leading);
  const ball length = sqrt(square_along(i, leading).at(p));
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = projected(i, exact_unit_vector(k), leading).at(p) / length;
  }
  return result;
}

int principal_axes::orientation() const {
  for (precision p = 64; p <= exact_real::most_bits; p *= 2) {
    const std::array<ball, 3> z = cross(unoriented(0, p), unoriented(1, p));
    const std::array<ball, 3> other = unoriented(2, p);
    const ball sign = z[0] * other[0] + z[1] * other[1] + z[2] * other[2];  // 1 or -1
    if (certainly_positive(sign)) return 1;
    if (certainly_negative(sign)) return -1;
  }
  throw std::domain_error("principal axes: the orientation is not decided");
}

std::array<ball, 3> principal_axes::axis(std::size_t i, precision p) const {
  std::array<ball, 3> result = unoriented(i, p);
  if (i == 2 && orientation() < 0) {
    for (ball& one : result) one = -one;
  }
  return result;
}

std::optional<axis_order> principal_axes::along_given_axes() const {
  axis_order result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& direction = axes_[i].direction;
    if (!direction) return std::nullopt;
    const auto is_zero = [](const rational& x) { return x == 0; };
    if (std::count_if(direction->begin(), direction->end(), is_zero) != 2) return std::nullopt;
    result.order[i] = static_cast<int>(
        std::find_if_not(direction->begin(), direction->end(), is_zero) - direction->begin());
  }
  result.signs[2] = orientation();
  return result;
}

exact_vector principal_axes::times(const exact_vector& w) const {
  const auto rows = rows_of(tensor_);
  return {dot(rows[0], w), dot(rows[1], w), dot(rows[2], w)};
}

/// By the cross products of the rows, which are the columns of the inverse times the determinant.
exact_vector principal_axes::solved(const exact_vector& w) const {
  const auto rows = rows_of(tensor_);
  const rational determinant = determinant_of(tensor_);
  exact_vector result{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const vector column = cross(rows[(i + 1) % 3], rows[(i + 2) % 3]);
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = result[k] + rational(column[k] / determinant) * w[i];
  }
  return result;
}

ball nearest_physical_tensor::distance(precision p) const {
  return excess.at(p + 8) / sqrt(ball(3, p + 8));
}

std::optional<nearest_physical_tensor> nearest_physical(const principal_axes& of) {
  if (of.kind() != body_kind::non_physical) return std::nullopt;
  nearest_physical_tensor result;
  result.excess = -of.margin();
  const exact_real third = result.excess / 3;
  const std::array<exact_real, 6> projector = of.projector(0);
  for (std::size_t i = 0; i < 6; ++i) {
    result.tensor[i] = of.tensor()[i] - 2 * third * projector[i];
    if (i < 3) result.tensor[i] = result.tensor[i] + third;
  }
  const auto& [x, y, z] = of.moments();
  result.moments = {x - third, y + third, z + third};
  return result;
}

}  // namespace polhode
