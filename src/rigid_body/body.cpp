#include "polhode/rigid_body/body.hpp"

#include <algorithm>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/inertia_tensor.hpp"

namespace polhode {
namespace {

/// "3, 2, 1".
std::string listed(const std::array<rational, 3>& x) {
  return to_text(x[0]) + ", " + to_text(x[1]) + ", " + to_text(x[2]);
}

/// For I_x >= I_y >= I_z.
body_kind kind_of(const std::array<rational, 3>& sorted) {
  const rational excess(sorted[0] - sorted[1] - sorted[2]);
  if (excess == 0) return body_kind::planar;
  return excess < 0 ? body_kind::physical : body_kind::non_physical;
}

/// Sorts order so that the greatest comes first; those that are equal keep their order.
template <class Greater>
void sort_axes(std::array<int, 3>& order, const Greater& is_greater) {
  std::stable_sort(order.begin(), order.end(), is_greater);
}

template <class T>
std::array<T, 3> in_order(const std::array<T, 3>& given, const std::array<int, 3>& order) {
  const auto at = [&given](int i) { return given[static_cast<std::size_t>(i)]; };
  return {at(order[0]), at(order[1]), at(order[2])};
}

}  // namespace

std::string to_text(body_kind kind) {
  switch (kind) {
    case body_kind::physical:
      return "physical";
    case body_kind::planar:
      return "planar";
    case body_kind::non_physical:
      return "non-physical";
    case body_kind::undecided:
      break;
  }
  return "undecided";
}

// ---------------------------------------------------------------------------------------------
// Exact moments

body::body(const exact_real& a, const exact_real& b) : a_(a), b_(b) {
  if (a.sign() == 0 || b.sign() == 0) {
    throw input_error("a = " + to_text(a) + ", b = " + to_text(b) +
                      ": two moments are equal, a symmetric top, which has no intermediate axis; a "
                      "must be positive, b between 0 and 1");
  }
  if (a < 0) {
    throw input_error("a = " + to_text(a) + ": it must be positive (I_y/I_z - 1 with I_z < I_y)");
  }
  if (b < 0 || b >= 1) {
    throw input_error("b = " + to_text(b) +
                      ": it must be between 0 and 1, ends excluded (1 - I_y/I_x with 0 < I_y < "
                      "I_x)");
  }
}

void refuse_unless_positive(const std::array<rational, 3>& moments) {
  for (const rational& moment : moments) {
    if (moment > 0) continue;
    throw input_error("moments of inertia " + listed(moments) + ": " + to_text(moment) +
                      " is not positive; all three must be");
  }
}

body body::from_moments(const std::array<rational, 3>& given) {
  refuse_unless_positive(given);
  std::array<int, 3> order{0, 1, 2};
  const auto moment = [&given](int i) { return given[static_cast<std::size_t>(i)]; };
  sort_axes(order, [&moment](int i, int j) { return moment(i) > moment(j); });
  const std::array<rational, 3> sorted = in_order(given, order);
  const auto& [x, y, z] = sorted;
  if (x == y || y == z) {
    throw input_error(
        "moments of inertia " + listed(given) +
        (x == z ? ": all are equal, a spherical top" : ": two are equal, a symmetric top") +
        ", which has no intermediate axis; three different moments are needed (as a "
        "mass distribution it is " +
        to_text(kind_of(sorted)) + ")");
  }
  body result(rational(y / z - 1), rational(1 - y / x));
  result.moments_ = sorted;
  result.order_ = order;
  return result;
}

body body::from_rotational_constants(const std::array<rational, 3>& given) {
  std::array<rational, 3> moments;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i] <= 0) {
      throw input_error("rotational constants " + listed(given) + ": " + to_text(given[i]) +
                        " is not positive; all three must be");
    }
    moments[i] = 1 / given[i];
  }
  return from_moments(moments);
}

body::body(std::shared_ptr<const inertia_tensor> irrational)
    : a_(exact_real::irrational([t = irrational](precision p) { return t->a(p); },
                                irrational->lost_bits())),
      b_(exact_real::irrational([t = irrational](precision p) { return t->b(p); },
                                irrational->lost_bits())),
      tensor_(std::move(irrational)) {}

body body::from_inertia_tensor(const std::array<rational, 6>& given) {
  return from_inertia_tensor(std::make_shared<const inertia_tensor>(given));
}

body body::from_inertia_tensor(std::shared_ptr<const inertia_tensor> given) {
  const auto& [x, y, z] = given->exact_moments();
  if (x && y && z) return from_moments({*x, *y, *z});
  return body(std::move(given));
}

body_kind body::kind() const {
  if (tensor_) return tensor_->kind();
  const exact_real sum = a_ * b_ + 2 * b_;
  if (sum == 1) return body_kind::planar;
  return sum < 1 ? body_kind::physical : body_kind::non_physical;
}

exact_real body::square_of_geometric_constant() const {
  if (tensor_) {
    if (const auto q = tensor_->exact_square_of_geometric_constant()) return *q;
  }
  const exact_real left = 1 - b_;
  return left * left / (b_ * (a_ + b_));
}
exact_real body::square_of_second_constant() const {
  if (tensor_) {
    if (const auto q = tensor_->exact_square_of_second_constant()) return *q;
  }
  const exact_real next = a_ + 1;
  return next * next / (a_ * (a_ + b_));
}

ball body::geometric_constant(precision p) const {
  return sqrt(square_of_geometric_constant().at(p));
}
std::optional<rational> body::exact_geometric_constant() const {
  const exact_real square = square_of_geometric_constant();
  return square.is_rational() ? exact_root(square.exact(), 2) : std::nullopt;
}

ball body::second_geometric_constant(precision p) const {
  const exact_real excess = (1 + 2 * a_ - a_ * b_) / (a_ * (a_ + b_));
  return excess.at(p) / (sqrt(square_of_second_constant().at(p)) + 1);
}
std::optional<rational> body::exact_second_geometric_constant() const {
  const exact_real square = square_of_second_constant();
  auto root = square.is_rational() ? exact_root(square.exact(), 2) : std::nullopt;
  if (root) *root -= 1;
  return root;
}

// ---------------------------------------------------------------------------------------------
// Moments in ranges

uncertain_body::uncertain_body(const std::array<uncertain_moment, 3>& given) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto& [value, sigma] = given[i];
    if (sigma < 0) {
      throw input_error("moment of inertia " + to_text(value) + " with sigma " + to_text(sigma) +
                        ": sigma must not be negative");
    }
    given_[i] = {rational(value - sigma), rational(value + sigma)};
    if (given_[i].low > 0) continue;
    throw input_error("moment of inertia " + to_text(value) + " with sigma " + to_text(sigma) +
                      ": value - sigma = " + to_text(given_[i].low) +
                      " is not positive; a moment must be");
  }
  sort_axes(order_, [&given](int i, int j) {
    return given[static_cast<std::size_t>(i)].value > given[static_cast<std::size_t>(j)].value;
  });
  const std::array<rational_range, 3> sorted = in_order(given_, order_);
  if (sorted[0].low > sorted[1].high && sorted[1].low > sorted[2].high) ordered_ = sorted;
}

body_kind uncertain_body::kind() const {
  bool all_physical = true;
  bool all_planar = false;
  for (std::size_t i = 0; i < given_.size(); ++i) {
    const rational_range& one = given_[i];
    const rational_range& second = given_[(i + 1) % 3];
    const rational_range& third = given_[(i + 2) % 3];
    if (one.low > second.high + third.high) return body_kind::non_physical;
    all_physical = all_physical && one.high <= second.low + third.low;
    all_planar =
        all_planar || (one.high == second.low + third.low && one.low == second.high + third.high);
  }
  if (all_planar) return body_kind::planar;
  return all_physical ? body_kind::physical : body_kind::undecided;
}

std::array<body, 2> uncertain_body::corners(bool x_up, bool y_up, bool z_up) const {
  const auto& [x, y, z] = *ordered_;
  const auto end = [](const rational_range& r, bool up) { return up ? r.high : r.low; };
  return {body::from_moments({end(x, x_up), end(y, y_up), end(z, z_up)}),
          body::from_moments({end(x, !x_up), end(y, !y_up), end(z, !z_up)})};
}

ball uncertain_body::geometric_constant(precision p) const {
  if (!ordered_) return ball::undefined(p);
  const auto [least, greatest] = corners(true, false, false);
  return hull(least.geometric_constant(p), greatest.geometric_constant(p));
}

ball uncertain_body::second_geometric_constant(precision p) const {
  if (!ordered_) return ball::undefined(p);
  const auto [least, greatest] = corners(true, true, false);
  return hull(least.second_geometric_constant(p), greatest.second_geometric_constant(p));
}

ball uncertain_body::a(precision p) const {
  if (!ordered_) return ball::undefined(p);
  const auto [least, greatest] = corners(true, false, true);
  return hull(least.a().at(p), greatest.a().at(p));
}

ball uncertain_body::b(precision p) const {
  if (!ordered_) return ball::undefined(p);
  const auto [least, greatest] = corners(false, true, false);
  return hull(least.b().at(p), greatest.b().at(p));
}

}  // namespace polhode
