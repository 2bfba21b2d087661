#include "hardware_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace polhode::detail {
namespace hardware_system_impl {
namespace {

using box = hardware_system::box;

/// How much of a box each round has to cut away for another to pay.
constexpr double enough = 0.75;

bool is_much_narrower(const box& x, const box& before) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double width = before[i].width();
    // An infinite side that became finite, too.
    if (x[i].width() < enough * width || (width == infinity && x[i].width() < infinity))
      return true;
  }
  return false;
}

}  // namespace
}  // namespace hardware_system_impl

hardware_system::hardware_system(const std::vector<expression>& components) {
  for (const expression& f : components) equations_.emplace_back(f);
}

hardware_system::outcome hardware_system::cut(box& x) {
  constexpr int most_rounds = 20;
  jacobian_.clear();
  outcome last = outcome::wide;
  for (int round = 0; round < most_rounds; ++round) {
    const box before = x;
    if (!contract(x)) return outcome::empty;
    last = newton(x);
    if (last == outcome::empty || !hardware_system_impl::is_much_narrower(x, before)) break;
  }
  return last;
}

bool hardware_system::contract(box& x) {
  constexpr int most_rounds = 10;
  for (int round = 0; round < most_rounds; ++round) {
    const box before = x;
    for (contraction& equation : equations_) {
      ++evaluations_;
      if (!equation.apply(x)) return false;
    }
    if (!hardware_system_impl::is_much_narrower(x, before)) break;
  }
  return true;
}

std::optional<std::size_t> hardware_system::direction(const box& x) const {
  const std::size_t n = x.size();
  if (jacobian_.size() != n) return std::nullopt;
  std::vector<double> share(n, 0);
  for (const box& row : jacobian_) {
    if (row.size() != n) return std::nullopt;
    double all = 0;
    for (std::size_t j = 0; j < n; ++j) all += row[j].magnitude() * x[j].width();
    if (!(all > 0) || !std::isfinite(all)) continue;
    for (std::size_t j = 0; j < n; ++j) share[j] += row[j].magnitude() * x[j].width() / all;
  }
  const auto most = std::ranges::max_element(share);
  if (!(*most > 0)) return std::nullopt;
  return static_cast<std::size_t>(most - share.begin());
}

/// By elimination with the largest pivot. Nothing rests on how near the inverse is.
bool hardware_system::invert() {
  const std::size_t n = equations_.size();
  std::vector<double> left(n * n);
  inverse_.assign(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    inverse_[i * n + i] = 1;
    for (std::size_t j = 0; j < n; ++j) left[i * n + j] = jacobian_[i][j].midpoint();
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(left[i * n + k]) > std::abs(left[pivot * n + k])) pivot = i;
    }
    for (std::size_t j = 0; j < n; ++j) {
      std::swap(left[k * n + j], left[pivot * n + j]);
      std::swap(inverse_[k * n + j], inverse_[pivot * n + j]);
    }
    const double scale = 1 / left[k * n + k];
    if (!std::isfinite(scale)) return false;
    for (std::size_t j = 0; j < n; ++j) {
      left[k * n + j] *= scale;
      inverse_[k * n + j] *= scale;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double factor = left[i * n + k];
      if (i == k || factor == 0) continue;
      for (std::size_t j = 0; j < n; ++j) {
        left[i * n + j] -= factor * left[k * n + j];
        inverse_[i * n + j] -= factor * inverse_[k * n + j];
      }
    }
  }
  return std::ranges::all_of(inverse_, [](double x) { return std::isfinite(x); });
}

hardware_system::outcome hardware_system::newton(box& x) {
  const std::size_t n = x.size();
  if (std::ranges::any_of(x, [](const double_interval& t) { return !t.is_bounded(); })) {
    return outcome::wide;
  }
  jacobian_.clear();
  box at_middle;
  box middle;
  for (const double_interval& t : x) middle.emplace_back(t.midpoint());
  for (contraction& equation : equations_) {
    jacobian_.push_back(equation.gradient(x));
    at_middle.push_back(equation.value(middle));
    evaluations_ += 2;
    if (!jacobian_.back().empty() && !at_middle.back().is_undefined()) continue;
    const bool is_undefined = equation.has_values() && equation.value(x).is_undefined();
    return is_undefined ? outcome::wide : outcome::regular;
  }
  box from_middle;
  for (std::size_t i = 0; i < n; ++i) from_middle.push_back(x[i] - middle[i]);
  for (std::size_t i = 0; i < n; ++i) {
    double_interval sum = at_middle[i];
    for (std::size_t j = 0; j < n; ++j) sum += jacobian_[i][j] * from_middle[j];
    if (!contains_zero(sum)) return outcome::empty;
  }
  if (!invert()) return outcome::wide;
  bool is_regular = true;
  for (std::size_t i = 0; i < n; ++i) {
    double_interval sum = 0;
    double_interval pivot = 0;
    double beside = 0;
    for (std::size_t k = 0; k < n; ++k) sum += double_interval(inverse_[i * n + k]) * at_middle[k];
    for (std::size_t j = 0; j < n; ++j) {
      double_interval entry = 0;
      for (std::size_t k = 0; k < n; ++k) {
        entry += double_interval(inverse_[i * n + k]) * jacobian_[k][j];
      }
      if (j == i) {
        pivot = entry;
      } else {
        sum += entry * from_middle[j];
      }
      beside += (entry - (j == i ? 1 : 0)).magnitude();
    }
    is_regular = is_regular && beside < 1;
    const double_interval image = middle[i] - sum / pivot;  // undefined where the pivot may be 0
    const double low = std::max(image.lower(), x[i].lower());
    const double high = std::min(image.upper(), x[i].upper());
    if (low > high) return outcome::empty;
    x[i] = double_interval(low, high);
    from_middle[i] = x[i] - middle[i];
  }
  return is_regular ? outcome::regular : outcome::wide;
}

}  // namespace polhode::detail
