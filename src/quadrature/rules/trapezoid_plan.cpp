#include "quadrature/rules/trapezoid_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {
namespace {

constexpr precision bound_precision = 64;

magnitude error_with(const rectangle_bound& bound, const rational& length, long nodes) {
  return trapezoid_error(ball(rational(length / nodes), bound_precision), bound);
}

/// About how many nodes the bound asks for.
double estimated_nodes(const rectangle_bound& bound, const rational& length, double log2_length,
                       long bits, double most) {
  constexpr double log_2 = 0.69314718055994531;
  const double excess = estimated_log2(bound.horizontal) + static_cast<double>(bits);
  // H e^(-2 pi d n/length) <= 2^-bits.
  const double needed = std::max(excess, 1.0) * log_2 / (2 * 3.14159265358979 * bound.half_height) *
                        std::exp2(log2_length);
  if (!(needed < most)) return needed;
  // The sides' share falls at least as 1/n.
  rectangle_bound sides = bound;
  sides.horizontal = magnitude();
  const auto n = static_cast<long>(needed) + 1;
  const double share = estimated_log2(error_with(sides, length, n)) + static_cast<double>(bits) + 1;
  return share > 0 ? needed * std::exp2(std::min(share, 1000.0)) : needed;
}

}  // namespace

line_plan plan_trapezoid(const bound_on_rectangle& bound, const rational& length, double highest,
                         long bits, long most_nodes) {
  line_plan plan;
  const double log2_length = estimated_log2(ball(length, bound_precision).magnitude_upper());
  struct candidate {
    double nodes = std::numeric_limits<double>::infinity();
    rectangle_bound rectangle;
  };
  const auto evaluate = [&](double d) {
    candidate c;
    if (d > highest) return c;
    if (std::optional<rectangle_bound> proved = bound(d)) {
      if (!proved->horizontal.is_infinite()) {
        c.rectangle = std::move(*proved);
        c.nodes = estimated_nodes(c.rectangle, length, log2_length, bits,
                                  static_cast<double>(most_nodes));
      }
    }
    return c;
  };
  // From high to low until a rectangle is proved that will do, and while it gets better; then
  // between the neighbours.
  constexpr int patience = 3;
  candidate best;
  int worse = 0;
  for (double d = highest; d > highest * 0x1p-50 && worse < patience; d /= 2) {
    candidate c = evaluate(d);
    if (c.nodes < best.nodes) {
      best = std::move(c);
      worse = 0;
    } else if (best.nodes < static_cast<double>(most_nodes)) {
      ++worse;
    }
  }
  if (!std::isfinite(best.nodes)) {
    plan.why = reason::not_analytic;
    return plan;
  }
  for (const double factor : {1.4, 1.18, 1.09, 1.04, 1.02, 1.01}) {
    const double d = best.rectangle.half_height;
    for (const double other : {d * factor, d / factor}) {
      candidate c = evaluate(other);
      if (c.nodes < best.nodes) {
        best = std::move(c);
        break;
      }
    }
  }
  // Proof.
  const magnitude goal = magnitude::power_of_two(-bits);
  if (best.nodes < static_cast<double>(most_nodes)) {
    auto nodes = static_cast<long>(best.nodes) + 1;
    while (nodes <= most_nodes) {
      const magnitude error = error_with(best.rectangle, length, nodes);
      if (error <= goal) {
        plan.nodes = nodes;
        plan.rectangle = std::move(best.rectangle);
        plan.truncation_error = error;
        return plan;
      }
      nodes += nodes / 64 + 1;
    }
  }
  plan.why = reason::evaluation_limit;
  return plan;
}

bool is_analytic_on(const region_function& f, double left, double right, double d,
                    long& evaluations) {
  struct tile {
    double left, right, bottom, top;
  };
  constexpr int most_tiles = 4000;
  const double least = d / 512;
  std::vector<tile> open{{left, right, 0, d}};
  for (int tiles = 0; !open.empty(); ++tiles) {
    if (tiles == most_tiles) return false;
    const tile t = open.back();
    open.pop_back();
    ++evaluations;
    const region value =
        f(region(double_interval(t.left, t.right), double_interval(t.bottom, t.top)));
    if (value.is_analytic()) continue;
    const double width = t.right - t.left;
    const double height = t.top - t.bottom;
    if (std::max(width, height) < least) return false;
    if (width >= height) {
      const double middle = t.left + width / 2;
      if (!(t.left < middle && middle < t.right)) return false;
      open.push_back({t.left, middle, t.bottom, t.top});
      open.push_back({middle, t.right, t.bottom, t.top});
    } else {
      const double middle = t.bottom + height / 2;
      if (!(t.bottom < middle && middle < t.top)) return false;
      open.push_back({t.left, t.right, t.bottom, middle});
      open.push_back({t.left, t.right, middle, t.top});
    }
  }
  return true;
}

magnitude integral_along(const region_function& f, double left, double right, double d,
                         long& evaluations) {
  struct tile {
    double left, right;
    magnitude share;
  };
  const auto measured = [&](double from, double to) {
    ++evaluations;
    const magnitude supremum =
        f(region(double_interval(from, to), double_interval(d))).magnitude_upper();
    const ball width = ball::exactly(to, bound_precision) - ball::exactly(from, bound_precision);
    return tile{from, to, multiply_up(supremum, width.magnitude_upper())};
  };
  const auto less = [](const tile& x, const tile& y) { return x.share < y.share; };
  std::priority_queue<tile, std::vector<tile>, decltype(less)> tiles(less);
  constexpr int first_tiles = 16;
  constexpr int rounds = 8;
  constexpr int splits = 48;
  double from = left;
  for (int k = 1; k <= first_tiles; ++k) {
    const double to =
        k == first_tiles ? right : std::min(right, left + (right - left) * k / first_tiles);
    tiles.push(measured(from, to));
    from = to;
  }
  const auto total = [](auto all) {
    magnitude sum;
    for (; !all.empty(); all.pop()) sum = add_up(sum, all.top().share);
    return sum;
  };
  // The greatest share is worth halving, until that does not help.
  magnitude sum = total(tiles);
  for (int round = 0; round < rounds; ++round) {
    for (int k = 0; k < splits; ++k) {
      const tile t = tiles.top();
      const double middle = t.left + (t.right - t.left) / 2;
      if (!(t.left < middle && middle < t.right)) break;
      tiles.pop();
      tiles.push(measured(t.left, middle));
      tiles.push(measured(middle, t.right));
    }
    const magnitude before = sum;
    sum = total(tiles);
    if (!sum.is_infinite() && !(sum < multiply_up(before, magnitude::from_bits_up(7, -3)))) break;
  }
  return sum;
}

line_integral carry_out(line_plan plan, const std::function<ball(long n, precision p)>& sum,
                        long bits, const magnitude& beyond, const trapezoid_options& options) {
  line_integral result;
  result.plan = std::move(plan);
  const long n = result.plan.nodes;
  if (n == 0) {
    result.why = result.plan.why;
    return result;
  }
  static_cast<trapezoid_integral&>(result) =
      sum_to_bits([&](precision p) { return sum(n, p); }, n,
                  add_up(result.plan.truncation_error, beyond), bits, options.most_precision);
  return result;
}

}  // namespace polhode::detail
