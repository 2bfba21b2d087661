#include "branches.hpp"

#include <cmath>

#include "polhode/arithmetic/interval.hpp"
#include "quadrature/formula/formula_graph.hpp"

namespace polhode::detail::breaks {

namespace {

bool not_negative(const ball& x) { return certainly_less_equal(ball(0, 64), x); }
bool not_positive(const ball& x) { return certainly_less_equal(x, ball(0, 64)); }

/// The greatest integer that is at most x's lower end; nothing where that is not a moderate number.
std::optional<long> integer_below(const ball& x) {
  constexpr long most = 1L << 40;
  if (!x.is_bounded() || magnitude::power_of_two(40) <= x.magnitude_upper()) return std::nullopt;
  const integer n = floor_of(lower_rational(x));
  if (abs(n) >= most) return std::nullopt;
  return static_cast<long>(n);
}

/// The branch for the whole range of the decider; `strictly`: it is strictly monotone, so that of
/// the range's ends each is reached at one point at most, which does not matter to an integral.
std::optional<long> branch_over(operation what, const ball& range, bool strictly) {
  if (range.is_undefined()) return std::nullopt;
  if (what == operation::ceil) {
    const std::optional<long> below = branch_over(operation::floor, -range, strictly);
    return below ? std::optional(-*below) : std::nullopt;
  }
  if (what == operation::floor) {
    const std::optional<long> n = integer_below(range);
    if (!n) return std::nullopt;
    const ball next(*n + 1, 64);
    const bool same = strictly ? certainly_less_equal(range, next) : certainly_less(range, next);
    return same ? n : std::nullopt;
  }
  if (not_negative(range)) return 1;
  return not_positive(range) ? std::optional(-1L) : std::nullopt;
}

/// The branch for a decider between n and the next integer in the direction of the sign; for other
/// kinds than floor and ceil n is 0.
long branch_beside(operation what, long n, int side) {
  if (what == operation::floor) return side > 0 ? n : n - 1;
  if (what == operation::ceil) return side > 0 ? n + 1 : n;
  return side;
}

/// The integer at which alone the branch may change where the decider has values in this range;
/// nothing where there may be more.
std::optional<long> only_change(operation what, const ball& range) {
  if (what != operation::floor && what != operation::ceil) return 0;
  const std::optional<long> below = integer_below(range);
  if (!below) return std::nullopt;
  // Or *below itself, where the range starts at it.
  const bool at_start = !certainly_greater(range, *below);
  const long n = at_start && certainly_less(range, *below + 1) ? *below : *below + 1;
  if (n == *below + 1 && !certainly_less_equal(range, ball(n + 1, 64))) return std::nullopt;
  return n;
}

}  // namespace

traced trace(const formula_graph& f, const ball& x, const ball& low, const ball& high,
             const crossing* given, int side) {
  const precision p = x.precision();
  evaluation<slope_jet> over(f, p, slope_jet::variable(x));
  evaluation<slope_jet> at_low(f, p, slope_jet::variable(low));
  evaluation<slope_jet> at_high(f, p, slope_jet::variable(high));
  traced result;
  result.chosen.resize(f.size());
  for (std::size_t i = 0; i < f.size(); ++i) {
    const formula_node& node = f.node(i);
    std::optional<long>& branch = result.chosen[i];
    if (node.is_piecewise()) {
      const std::size_t d = node.decider;
      const auto& [range, slope] = std::pair(over[d][0], over[d][1]);
      const bool ascending = certainly_positive(slope);
      const bool monotone = !range.is_undefined() && (ascending || certainly_negative(slope));
      const ball& start = (ascending ? at_low : at_high)[d][0];
      const ball& end = (ascending ? at_high : at_low)[d][0];
      const ball between = monotone ? intersection(range, hull(start, end)) : range;
      const ball& values = between.is_undefined() ? range : between;
      branch = branch_over(node.what, values, monotone);
      std::optional<crossing> suspect;
      if (monotone && !branch) {
        if (const auto n = only_change(node.what, values)) suspect = crossing{d, *n, ascending};
      }
      const bool crosses =
          suspect && certainly_less(start, suspect->n) && certainly_greater(end, suspect->n);
      if (crosses && given != nullptr && given->decider == d && given->n == suspect->n) {
        branch = branch_beside(node.what, given->n, ascending ? side : -side);
      }
      if (!branch && result.decided) {
        result.decided = false;
        result.suspect = suspect;
        result.slope = slope;
        result.crosses = crosses;
      }
    }
    over.step(i, branch);
    at_low.step(i, branch);
    at_high.step(i, branch);
  }
  return result;
}

bool is_away_from_changes(const formula_graph& f, const ball& m) {
  evaluation<slope_jet> at(f, m.precision(), slope_jet::variable(m));
  for (std::size_t i = 0; i < f.size(); ++i) {
    const formula_node& node = f.node(i);
    std::optional<long> branch;
    if (node.is_piecewise()) {
      const ball& value = at[node.decider][0];
      branch = branch_over(node.what, value, false);
      const std::optional<long> n = only_change(node.what, value);
      if (!branch || !n || contains_zero(value - *n)) return false;
    }
    at.step(i, branch);
  }
  return true;
}

std::optional<choices> branches_beside(const formula_graph& f, const known_number& m, int side,
                                       const rational& reach) {
  constexpr double most = 1e6;
  auto r = static_cast<double>(reach);
  while (rational(r) < reach) r = std::nextafter(r, most);
  if (!(r > 0 && r < most)) return std::nullopt;
  constexpr precision series_bits = 192;
  evaluation<end_series> values(f, series_bits,
                                end_series::argument(m, known_number(rational(side)), 1, r));
  choices chosen(f.size());
  for (std::size_t i = 0; i <= f.result(); ++i) {
    const formula_node& node = f.node(i);
    if (node.is_piecewise()) {
      const end_series& decider = values[node.decider];
      if (node.what == operation::floor || node.what == operation::ceil) {
        const ball range = to_ball(decider.real_range(), series_bits);
        if (!range.is_bounded()) return std::nullopt;
        chosen[i] = branch_over(node.what, range, false);
      } else if (const int sign = decider.sign(); sign != 0) {
        chosen[i] = sign;
      }
      if (!chosen[i]) return std::nullopt;
    }
    values.step(i, chosen[i]);
  }
  return chosen;
}

}  // namespace polhode::detail::breaks
