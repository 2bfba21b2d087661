#include "proofs/slope_sweep.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode::proofs {
namespace {

constexpr precision bits = 64;
constexpr long cells = 64;

/// cos^2 over the k-th cell [k, k+1] pi / (2 cells), where it decreases.
const std::vector<ball>& squared_cosines() {
  static const std::vector<ball> table = [] {
    std::vector<ball> values;
    const auto at = [](long k) { return square(cos(pi(bits) * k / (2 * cells))); };
    for (long k = 0; k < cells; ++k) values.push_back(hull(at(k), at(k + 1)));
    return values;
  }();
  return table;
}

ball sigma_over(const sweep_point& box, const ball& squared_cosine) {
  return box.u + box.p * (1 - box.u) * squared_cosine;
}

/// cos^2 t (sigma^(-1/2) + r u sigma^(-3/2)).
ball integrand(const ball& squared_cosine, const ball& sigma, const ball& r, const ball& u) {
  const ball root = sqrt(sigma);
  return squared_cosine / root * (1 + r * u / sigma);
}

ball upper_end(const ball& x) { return ball(upper(x)); }
ball lower_end(const ball& x) { return ball(lower(x)); }

ball cell_width() { return pi(bits) / (2 * cells); }

/// A box of parameters with rational ends of the form k / 2^n: bisection is exact.
struct work_item {
  std::array<rational, 3> low;
  std::array<rational, 3> high;
  int depth = 0;

  [[nodiscard]] sweep_point point() const {
    const auto side = [&](std::size_t i) { return hull(ball(low[i], bits), ball(high[i], bits)); };
    return {side(0), side(1), side(2)};
  }
  [[nodiscard]] std::size_t widest() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (high[i] - low[i] > high[best] - low[best]) best = i;
    }
    return best;
  }
};

}  // namespace

ball slope_lower_bound(const sweep_point& box) {
  ball sum(0, bits);
  const ball r = lower_end(box.r);
  const ball u = lower_end(box.u);
  for (const ball& c : squared_cosines()) {
    sum += integrand(lower_end(c), upper_end(sigma_over(box, c)), r, u);
  }
  return lower_end(sum * cell_width());
}

ball slope_enclosure(const sweep_point& box) {
  ball sum(0, bits);
  for (const ball& c : squared_cosines()) {
    sum += integrand(c, sigma_over(box, c), box.r, box.u);
  }
  return sum * cell_width();
}

sweep_point point_of(const oscillating_motion& motion, precision p) {
  const exact_real total = motion.a + motion.b;
  return {(motion.a / total).at(p), (motion.b * (1 + motion.a) / total).at(p), ball(motion.u, p)};
}

sweep_result sweep_slope(long most_evaluations, const rational& wanted) {
  sweep_result result;
  result.bound = wanted;
  const ball bound(wanted, bits);
  ball least = ball::undefined(bits);
  std::vector<work_item> work{{{0, 0, 0}, {1, 1, 1}, 0}};
  while (!work.empty()) {
    if (result.evaluations == most_evaluations) return result;
    const work_item item = work.back();
    work.pop_back();
    ++result.evaluations;
    result.deepest = std::max(result.deepest, item.depth);
    const ball lower_bound = slope_lower_bound(item.point());
    if (certainly_less(bound, lower_bound)) {
      ++result.boxes;
      result.covering.push_back({item.low, item.high});
      if (least.is_undefined() || certainly_less(lower_bound, least)) least = lower_bound;
      continue;
    }
    const std::size_t side = item.widest();
    const rational middle = (item.low[side] + item.high[side]) / 2;
    work_item left = item;
    work_item right = item;
    left.high[side] = middle;
    right.low[side] = middle;
    ++left.depth;
    ++right.depth;
    work.push_back(right);
    work.push_back(left);
  }
  result.holds = true;
  result.least = lower_rational(least);
  return result;
}

}  // namespace polhode::proofs
