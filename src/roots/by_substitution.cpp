#include "by_substitution.hpp"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>

#include "place_of.hpp"
#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/expression/program.hpp"
#include "polhode/expression/symbol.hpp"

namespace polhode::detail {
namespace {

/// c where f is c v and what does not depend on the variable v, by sums, differences and products
/// with rational numbers alone; 0 where it does not depend on v, nullopt where it does otherwise.
/// So f is defined, for any v, exactly where it is for v = 0.
std::optional<rational> linear_coefficient(const expression& f, std::uint32_t variable) {
  using coefficient = std::optional<rational>;
  const program& all = f.instructions();
  const tape& body = all.body;
  std::vector<coefficient> of(body.inputs + body.slots, rational(0));
  of[variable] = 1;
  /// The rational number that an input is.
  const auto number = [&](std::uint32_t operand) -> const rational* {
    if (operand < all.variables || operand >= body.inputs) return nullptr;
    const std::uint32_t from = all.constants.outputs[operand - all.variables];
    return from < all.constants.inputs ? &all.numbers[from] : nullptr;
  };
  const auto is_without = [&](std::uint32_t operand) { return of[operand] == rational(0); };
  for (const instruction& i : body.code) {
    coefficient result;
    const int operands = i.what == operation::further ? 0 : operands_of(i.what);
    if (i.what == operation::further) {
      const auto& call = body.calls[static_cast<std::size_t>(i.number)];
      if (std::all_of(call.operands.begin(), call.operands.end(), is_without)) result = 0;
    } else if ((operands < 1 || is_without(i.left)) && (operands < 2 || is_without(i.right))) {
      result = 0;
    } else if (i.what == operation::negate) {
      if (of[i.left]) result = -*of[i.left];
    } else if (i.what == operation::add || i.what == operation::subtract) {
      if (of[i.left] && of[i.right]) {
        result = i.what == operation::add ? *of[i.left] + *of[i.right] : *of[i.left] - *of[i.right];
      }
    } else if (i.what == operation::multiply) {
      if (const rational* q = number(i.left); q && of[i.right]) result = *q * *of[i.right];
      if (const rational* q = number(i.right); q && of[i.left]) result = *q * *of[i.left];
    } else if (i.what == operation::divide) {
      const rational* q = number(i.right);
      if (q && *q != 0 && of[i.left]) result = *of[i.left] / *q;
    }
    of[body.inputs + i.result] = result;
  }
  return of[body.outputs.front()];
}

/// A root of the other equations, with all its digits.
struct reduced_root {
  root_verdict verdict = root_verdict::unresolved;
  std::vector<ball> box;
  bool may_lie_outside = false;
  std::string remark;
  std::function<std::vector<ball>(precision)> enclose;  // where there is exactly one
};

struct reduced_roots {
  std::vector<reduced_root> all;
  bool complete = true;
  isolation_account account;
};

/// Enough for p bits: log10(2) is less than 0.302.
long digits_of(precision p) { return p / 1000 * 302 + p % 1000 * 302 / 1000 + 2; }

/// Of one equation in one variable; nullopt where there are infinitely many.
std::optional<reduced_roots> roots_of_one(const expression& h, const system_side& side,
                                          const system_options& options) {
  const auto end = [](const std::optional<rational>& q, int sign) {
    if (q) return end_point(*q);
    return sign > 0 ? end_point::infinity() : -end_point::infinity();
  };
  isolate_options o;
  o.progress = options.progress;
  o.most_boxes = options.most_boxes;
  const root_set found = isolate_roots(h, end(side.first, -1), end(side.second, 1), o);
  if (found.identically_zero || !found.zero_intervals.empty() || found.of_period) {
    return std::nullopt;
  }
  reduced_roots result{{}, found.complete, found.account};
  for (const root_region& r : found.regions) {
    reduced_root one{r.verdict, {r.box}, r.may_lie_outside, r.remark, {}};
    if (is_one_root(r.verdict)) {
      one.enclose = [r](precision p) {
        if (r.exact) return std::vector{ball(*r.exact, p)};
        return std::vector{refine(r, digits_of(p)).enclosure};
      };
    }
    result.all.push_back(std::move(one));
  }
  return result;
}

std::optional<reduced_roots> roots_of_several(const std::vector<expression>& components,
                                              const system_box& box,
                                              const system_options& options) {
  const real_system f(components);
  const system_root_set found = solve_system(f, box, options);
  reduced_roots result{{}, found.complete, found.account};
  for (const system_region& r : found.regions) {
    reduced_root one{r.verdict, r.box, r.may_lie_outside, r.remark, {}};
    if (is_one_root(r.verdict)) {
      one.enclose = [f, r](precision p) { return refine(f, r, digits_of(p)).enclosure; };
    }
    result.all.push_back(std::move(one));
  }
  return result;
}

/// One equation and the variable that it is solved for.
class substitution {
 public:
  substitution(const real_system& f, std::size_t equation, std::size_t variable, const rational& c)
      : f_(f), variable_(variable) {
    const std::size_t n = f.components().size();
    names_ = f.components()[equation].names();
    names_.variables.erase(names_.variables.begin() + static_cast<std::ptrdiff_t>(variable));
    std::vector<symbol> point;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t place = k < variable ? k : k - 1;
      point.push_back(k == variable ? symbol(0) : symbol::variable(place));
    }
    // f_i = c v + (f_i at v = 0).
    g_ = f.components()[equation].evaluate(std::span<const symbol>(point)) / symbol(rational(-c));
    point[variable] = *g_;
    for (std::size_t k = 0; k < n; ++k) {
      if (k == equation) continue;
      others_.emplace_back(f.components()[k].evaluate(std::span<const symbol>(point)), names_);
    }
    value_.emplace(*g_, names_);
  }

  /// nullopt where not every root is proved, with its place.
  [[nodiscard]] std::optional<system_root_set> roots(const system_box& box,
                                                     const system_options& options) const {
    system_box others = box;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(variable_));
    const auto found = others.size() == 1 ? roots_of_one(others_.front(), others.front(), options)
                                          : roots_of_several(others_, others, options);
    if (!found || !found->complete) return std::nullopt;
    system_root_set result;
    result.account = found->account;
    for (const reduced_root& one : found->all) {
      if (!is_one_root(one.verdict) || one.may_lie_outside) return std::nullopt;
      if (is_undefined_at(one)) continue;
      auto region = region_of(one);
      if (!region) return std::nullopt;
      const place where = place_of(*region, box[variable_]);
      if (where == place::undecided) return std::nullopt;
      if (where == place::inside) result.regions.push_back(std::move(*region));
    }
    return result;
  }

 private:
  [[nodiscard]] std::vector<ball> with_value(std::vector<ball> x) const {
    ball v = value_->evaluate(std::span<const ball>(x));
    x.insert(x.begin() + static_cast<std::ptrdiff_t>(variable_), std::move(v));
    return x;
  }
  /// nullopt where the equations are not shown to be defined there.
  [[nodiscard]] std::optional<system_region> region_of(const reduced_root& one) const {
    constexpr precision few = 128;
    system_region result;
    result.verdict = one.verdict;
    result.enclosure = with_value(one.enclose(few));
    const auto is_bounded = [](const ball& x) { return x.is_bounded(); };
    if (!std::all_of(result.enclosure.begin(), result.enclosure.end(), is_bounded)) {
      return std::nullopt;
    }
    const real_system::linearised over = f_.linearise(result.enclosure);
    for (std::size_t k = 0; k < over.value.size(); ++k) {
      if (!over.value[k].is_bounded()) return std::nullopt;
      const auto& row = over.jacobian[k];
      // Where f is not differentiable the jets have no derivative, and there is no multiplicity.
      if (!std::all_of(row.begin(), row.end(), is_bounded)) result.verdict = root_verdict::isolated;
    }
    result.box = with_value(one.box);
    if (!result.box[variable_].is_bounded()) {
      result.box[variable_] = result.enclosure[variable_];
    }
    result.enclose = [whole = *this, one](precision p) {
      std::vector<ball> x;
      for (precision bits = p + 32; bits <= 16 * p + 4096; bits *= 2) {
        x = whole.with_value(one.enclose(bits));
        const ball& v = x[whole.variable_];
        if (v.is_bounded() && v.radius() <= scale(v.magnitude_lower(), -p)) break;
      }
      return x;
    };
    return result;
  }
  [[nodiscard]] place place_of(const system_region& r, const system_side& side) const {
    if (const auto exact = exact_value(r)) return detail::place_of(*exact, side);
    constexpr precision most = 1024;
    for (precision p = 64; p <= most; p *= 4) {
      const place where = detail::place_of(r.enclose(p)[variable_], side);
      if (where != place::undecided) return where;
    }
    return place::undecided;
  }
  /// g at a point of rational numbers; throws input_error where it is certainly not defined there.
  [[nodiscard]] expression value_at(const std::vector<ball>& x) const {
    std::vector<symbol> point;
    point.reserve(x.size());
    for (const ball& one : x) point.emplace_back(lower_rational(one));
    return expression(value_->evaluate(std::span<const symbol>(point)), {{}, {}, names_.further});
  }
  /// By exact rules at a point of rational numbers; what balls give a value is never undefined.
  [[nodiscard]] bool is_undefined_at(const reduced_root& one) const {
    const std::vector<ball> x = one.enclose(64);
    if (!std::ranges::all_of(x, [](const ball& at) { return at.is_exact(); })) return false;
    if (value_->evaluate(std::span<const ball>(x)).is_bounded()) return false;
    try {
      (void)value_at(x);
      return false;
    } catch (const input_error&) {
      return true;
    }
  }
  /// v where the other coordinates are rational numbers, and v is found to be one by exact rules.
  [[nodiscard]] std::optional<rational> exact_value(const system_region& r) const {
    std::vector<ball> x = r.enclosure;
    x.erase(x.begin() + static_cast<std::ptrdiff_t>(variable_));
    if (!std::ranges::all_of(x, [](const ball& at) { return at.is_exact(); })) return std::nullopt;
    return value_at(x).rational_value();
  }

  real_system f_;
  std::size_t variable_;
  expression_names names_;
  std::optional<symbol> g_;
  std::optional<expression> value_;  // g
  std::vector<expression> others_;
};

struct explicit_equation {
  std::size_t equation;
  std::uint32_t variable;
  rational coefficient;
};

/// At most so many.
std::vector<explicit_equation> explicit_equations_of(const real_system& f, std::size_t most) {
  std::vector<explicit_equation> result;
  const auto& components = f.components();
  for (std::size_t i = 0; i < components.size(); ++i) {
    for (std::uint32_t v = 0; v < components.size() && result.size() < most; ++v) {
      const auto c = linear_coefficient(components[i], v);
      if (c && *c != 0) result.push_back({i, v, *c});
    }
  }
  return result;
}

}  // namespace

bool has_explicit_equation(const real_system& f) {
  return f.components().size() > 1 && !explicit_equations_of(f, 1).empty();
}

std::optional<system_root_set> solved_by_substitution(const real_system& f, const system_box& box,
                                                      const system_options& options) {
  if (box.size() < 2) return std::nullopt;
  constexpr long most_boxes = 20'000;
  constexpr std::size_t most_tried = 4;
  system_options limited = options;
  limited.most_boxes = std::min(options.most_boxes, most_boxes);
  for (const auto& [equation, variable, c] : explicit_equations_of(f, most_tried)) {
    try {
      if (auto found = substitution(f, equation, variable, c).roots(box, limited)) return found;
    } catch (const input_error&) {  // the others are defined nowhere with g in them
      continue;
    }
  }
  return std::nullopt;
}

}  // namespace polhode::detail
