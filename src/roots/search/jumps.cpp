#include "jumps.hpp"

#include <utility>
#include <vector>

namespace polhode::detail {
namespace jumps_impl {
namespace {

using step = expression::stepped::step;

integer value_of(step s, const rational& u) { return s == step::floor ? floor_of(u) : ceil_of(u); }

/// The examination of one set.
class examination_of_jumps {
 public:
  examination_of_jumps(const expression& f, const ball& x, precision bits)
      : f_(f), x_(x), bits_(bits) {}

  [[nodiscard]] jump_report over(const exact_box& box) && {
    const auto first = f_.with_steps({});
    if (!first || first->next == step::none) return report_;
    if (has_no_root_for_any_values({})) {
      report_.has_no_root = true;
      return report_;
    }
    const auto answer =
        first_of_simple_points(box, bits_, [&](const pi_combination& at) { return by_sides(at); });
    return answer.value_or(report_);
  }

 private:
  /// The values of a step over a set, from the first to the second: of one argument, of which no
  /// more is known than its range. Nothing where that is not bounded.
  std::optional<std::pair<integer, integer>> values_over(const expression::stepped& of,
                                                         const ball& set) {
    ++report_.evaluations;
    const ball u = real_function(of.formula).at(bits_)->value(set);
    if (u.is_undefined() || !u.is_bounded()) return std::nullopt;
    return std::pair(value_of(of.next, lower_rational(u)), value_of(of.next, upper_rational(u)));
  }

  /// Proved: with the first steps' values as they are, and whatever values the others have over x,
  /// f has no root there.
  bool has_no_root_for_any_values(std::vector<integer> values) {
    constexpr std::size_t most_steps = 4;
    const auto of = f_.with_steps(values);
    if (!of) return true;  // f is not defined where it has these values
    if (of->next == step::none) return has_no_zero_over(real_function(of->formula), x_);
    if (values.size() == most_steps) return false;
    const auto range = values_over(*of, x_);
    if (!range || range->second - range->first > 1) return false;
    for (integer n = range->first; n <= range->second; ++n) {
      values.push_back(n);
      if (!has_no_root_for_any_values(values)) return false;
      values.pop_back();
    }
    return true;
  }
  /// By the range, or the mean value theorem.
  bool has_no_zero_over(const real_function& g, const ball& set) {
    report_.evaluations += 2;
    const auto at_bits = g.at(bits_);
    const jet<ball, 1> over = at_bits->slope(set);
    if (is_certainly_not_zero(over[0])) return true;
    if (over[0].is_undefined() || over[1].is_undefined()) return false;
    const ball middle(exact_ends(set).middle(), bits_);
    return is_certainly_not_zero(at_bits->value(middle) + over[1] * (set - middle));
  }

  /// f(at) is known to be 0 or not, and f has no root in x on either side of that point.
  std::optional<jump_report> by_sides(const pi_combination& at) {
    ++report_.evaluations;
    const auto s = real_function(f_).structure(function_structure::variable_at(at, 1, bits_));
    if (!s || !s->series()) return std::nullopt;
    const known_number value = settled((*s->series())[0]);
    const bool is_zero = value.is_zero();
    if (!is_zero && !is_certainly_not_zero(value.enclosure())) return std::nullopt;
    const exact_box whole = exact_ends(x_);
    for (const rational& end : {*whole.lower, *whole.upper}) {
      if (!has_no_root_up_to(end, at)) return std::nullopt;
    }
    report_.has_no_root = !is_zero;
    if (is_zero) report_.only_root = at;
    return report_;
  }
  /// f has no root between the point and the end, which is one. On the way from the point, that
  /// excluded, each step keeps one value: its argument has a single one over all of it, or differs
  /// from the only jump within reach, by a continuous function without a zero.
  bool has_no_root_up_to(const rational& end, const pi_combination& at) {
    const ball point = at.at(bits_ + 64);
    const ball way = ball(end, bits_ + 64) - point;
    const bool rightward = certainly_positive(way);
    if (!rightward && !certainly_negative(way)) return false;
    const rational reach = rightward ? upper_rational(way) : lower_rational(way);
    const ball side = hull(point, ball(end, bits_ + 64));
    std::vector<integer> values;
    while (true) {
      const auto of = f_.with_steps(values);
      if (!of) return true;  // f is not defined there
      const real_function u(of->formula);
      if (of->next == step::none) {
        return u.has_no_root_beside(at, reach) || has_no_zero_over(u, side);
      }
      const auto range = values_over(*of, side);
      if (!range || range->second - range->first > 1) return false;
      if (range->first == range->second) {
        values.push_back(range->first);
        continue;
      }
      // floor jumps up to its value at an integer, ceil up from it.
      const integer jump = of->next == step::floor ? range->second : range->first;
      const real_function from_jump(
          expression(of->formula(symbol::variable(0)) - rational(jump), of->formula.names()));
      report_.evaluations += 2;
      const jet<ball, 1> over = from_jump.at(bits_)->slope(side);
      if (over[0].is_undefined() || over[1].is_undefined()) return false;  // is it continuous?
      if (!from_jump.has_no_root_beside(at, reach)) return false;
      const ball at_end = from_jump.at(bits_)->value(ball(end, bits_));
      if (!is_certainly_not_zero(at_end)) return false;
      values.push_back(certainly_positive(at_end) ? range->second : range->first);
    }
  }

  const expression& f_;
  const ball& x_;
  precision bits_;
  jump_report report_;
};

}  // namespace
}  // namespace jumps_impl

jump_report examine_jumps(const expression& f, const exact_box& box, const ball& x,
                          precision bits) {
  return jumps_impl::examination_of_jumps(f, x, bits).over(box);
}

}  // namespace polhode::detail
