#include "polhode/quadrature/integrate_box.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "parametric_integrand.hpp"
#include "tiling/tiling.hpp"

namespace polhode {

parameter_range::parameter_range(rational lower, rational upper)
    : lower_(std::move(lower)), upper_(std::move(upper)) {
  if (lower_ > upper_) {
    throw std::invalid_argument("a parameter's lower end is above its upper end");
  }
}

parameter_range::parameter_range(const ball& x) : lower_(0), upper_(0) {
  if (!x.is_bounded()) throw std::invalid_argument("a parameter's range is not bounded");
  lower_ = lower_rational(x);
  upper_ = upper_rational(x);
}

ball parameter_range::enclosure(precision p) const {
  return is_point() ? ball(lower_, p) : from_end_points(lower_, upper_, p);
}

namespace detail {

namespace {

/// What is known of I over one box.
struct bounds {
  parameter_box over;  // that box
  ball enclosure = ball::undefined(64);
  bool attained = false;
  std::size_t best_cut = 0;  // the side that is worth cutting most
  reason why = reason::none;
  std::string obstacle;
};

class box_integrator {
 public:
  box_integrator(const parametric_integrand& f, const end_point& a, const end_point& b,
                 const box_options& options)
      : f_(f), a_(a), b_(b), options_(options) {}

  bounds enclose(const parameter_box& box);
  [[nodiscard]] long integrals() const { return integrals_; }

 private:
  /// To the goal.
  integral at_point(const parameter_box& point);
  /// To some digits, which is more than the widths of the parameters leave.
  integral over(const integrand& f);
  void count_one();

  const parametric_integrand& f_;
  const end_point& a_;
  const end_point& b_;
  const box_options& options_;
  long integrals_ = 0;
};

void box_integrator::count_one() {
  if (options_.progress) options_.progress(integrals_);
  ++integrals_;
}

integral box_integrator::at_point(const parameter_box& point) {
  count_one();
  return integrate_function(
      f_.over_box(point), a_, b_,
      {.digits = options_.digits, .most_evaluations = options_.most_evaluations});
}

integral box_integrator::over(const integrand& f) {
  count_one();
  constexpr long few_digits = 10;
  constexpr long little_depth = 100;
  return integrate_function(f, a_, b_,
                            {.digits = few_digits,
                             .most_evaluations = options_.most_evaluations,
                             .most_depth = little_depth});
}

/// The common part; both hold the same numbers, of which there are some.
ball common(const ball& x, const ball& y) {
  if (x.is_undefined()) return y;
  ball both = intersection(x, y);
  if (both.is_undefined()) {
    throw std::logic_error("integrate_box: two enclosures of the same integrals contradict");
  }
  return both;
}

std::size_t widest(const parameter_box& box) {
  const auto narrower = [](const parameter_range& x, const parameter_range& y) {
    return x.width() < y.width();
  };
  return static_cast<std::size_t>(std::max_element(box.begin(), box.end(), narrower) - box.begin());
}

bounds box_integrator::enclose(const parameter_box& box) {
  bounds result;
  result.over = box;
  const bool is_point =
      std::all_of(box.begin(), box.end(), [](const auto& side) { return side.is_point(); });
  if (is_point) {
    const integral at = at_point(box);
    result.enclosure = at.enclosure;
    result.attained = at.verdict == status::certified;
    result.why = at.why;
    result.obstacle = at.obstacle;
    return result;
  }
  result.best_cut = widest(box);
  const integral direct = over(f_.over_box(box));
  if (!direct.enclosure.is_bounded()) {
    result.why = direct.why == reason::none ? reason::precision_limit : direct.why;
    result.obstacle = direct.obstacle;
    return result;
  }
  result.enclosure = direct.enclosure;

  parameter_box least =
      box;  // its sides with a certain slope are the ends with the least integral,
  parameter_box greatest = box;  // and with the greatest
  parameter_box middle = box;
  bool any_monotone = false;
  bool all_known = true;
  magnitude most;
  const precision bits = direct.enclosure.precision();
  ball change(0, bits);
  for (std::size_t i = 0; i < box.size(); ++i) {
    const parameter_range& side = box[i];
    if (side.is_point()) continue;
    const ball slope = over(f_.derivative(box, i)).enclosure;
    if (!slope.is_bounded()) {
      all_known = false;
      continue;
    }
    middle[i] = side.middle();
    const rational half = side.width() / 2;
    const ball part = slope * from_end_points(-half, half, bits);
    change += part;
    if (most <= part.magnitude_upper()) {
      most = part.magnitude_upper();
      result.best_cut = i;
    }
    const bool rises = lower_rational(slope) >= 0;
    if (!rises && upper_rational(slope) > 0) continue;
    any_monotone = true;
    least[i] = rises ? side.lower() : side.upper();
    greatest[i] = rises ? side.upper() : side.lower();
  }
  if (all_known) {
    const ball at_middle = at_point(middle).enclosure;
    if (at_middle.is_bounded()) result.enclosure = common(at_middle + change, result.enclosure);
  }
  if (any_monotone) {
    const bounds low = enclose(least);
    const bounds high = enclose(greatest);
    if (low.enclosure.is_bounded() && high.enclosure.is_bounded()) {
      const precision p = std::max(low.enclosure.precision(), high.enclosure.precision());
      const ball between =
          from_end_points(lower_rational(low.enclosure), upper_rational(high.enclosure), p);
      result.attained = low.attained && high.attained;
      result.enclosure = result.attained ? between : common(between, result.enclosure);
    }
  }
  return result;
}

/// The parts, which were cut off, make up the box.
bool are_all_of(const parameter_box& box, const std::vector<bounds>& parts) {
  const auto sides_of = [](const parameter_box& x) {
    exact_sides sides;
    sides.reserve(x.size());
    for (const parameter_range& side : x) sides.push_back({side.lower(), side.upper()});
    return sides;
  };
  std::vector<exact_sides> sides;
  std::vector<const exact_sides*> pointers;
  sides.reserve(parts.size());
  pointers.reserve(parts.size());
  for (const bounds& p : parts) pointers.push_back(&sides.emplace_back(sides_of(p.over)));
  return is_tiling(sides_of(box), pointers);
}

}  // namespace

box_integral integrate_function_over_box(const parametric_integrand& f, const end_point& a,
                                         const end_point& b, const parameter_box& box,
                                         const box_options& options) {
  if (options.digits < 1) throw std::invalid_argument("integrate_box: digits must be at least 1");
  if (options.most_boxes < 1) {
    throw std::invalid_argument("integrate_box: most_boxes must be at least 1");
  }
  box_integrator work(f, a, b, options);
  std::vector<bounds> parts{work.enclose(box)};
  // What is undefined is the widest of all.
  const auto width_of = [](const bounds& p) {
    if (p.attained) return magnitude();
    return p.enclosure.is_bounded() ? p.enclosure.radius() : magnitude::infinity();
  };
  while (static_cast<long>(parts.size()) < options.most_boxes) {
    const auto worst = std::max_element(
        parts.begin(), parts.end(),
        [&](const bounds& x, const bounds& y) { return width_of(x) < width_of(y); });
    const std::size_t i = worst->best_cut;
    if (worst->attained || i >= box.size() || worst->over[i].is_point()) break;
    parameter_box left = worst->over;
    parameter_box right = worst->over;
    const rational cut = left[i].middle();
    left[i] = parameter_range(left[i].lower(), cut);
    right[i] = parameter_range(cut, right[i].upper());
    *worst = work.enclose(left);
    parts.push_back(work.enclose(right));
  }
  if (!are_all_of(box, parts)) {
    throw std::logic_error("internal error in integrate_box, no result: the parts are not the box");
  }
  box_integral result;
  result.boxes = static_cast<long>(parts.size());
  result.integrals = work.integrals();
  result.attained = true;
  for (const bounds& p : parts) {
    if (!p.enclosure.is_bounded()) {
      result.enclosure = ball::undefined(64);
      result.why = p.why;
      result.obstacle = p.obstacle;
      result.attained = false;
      return result;
    }
    result.attained = result.attained && p.attained;
    result.enclosure =
        result.enclosure.is_undefined() ? p.enclosure : hull(result.enclosure, p.enclosure);
  }
  result.verdict = status::certified;
  return result;
}

}  // namespace detail
}  // namespace polhode
