#include "polhode/roots/systems.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "boxes.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/symbol.hpp"

namespace polhode {
namespace {

using namespace boxes;

/// K(X) for y = Y f(m) and a = Y J(X).
vector krawczyk_image(const vector& m, const vector& y, const matrix& a, const vector& difference) {
  vector r;
  for (std::size_t i = 0; i < m.size(); ++i) {
    ball sum = m[i] - y[i];
    for (std::size_t j = 0; j < m.size(); ++j) {
      const ball entry = i == j ? 1 - a[i][j] : -a[i][j];
      sum += entry * difference[j];
    }
    r.push_back(std::move(sum));
  }
  return r;
}

/// The components' evaluators over T, made once for each precision.
template <class T>
class evaluators {
 public:
  explicit evaluators(std::vector<expression> components) : components_(std::move(components)) {}
  [[nodiscard]] std::vector<T> operator()(const std::vector<T>& x, precision p) {
    const std::shared_ptr<const list> all = at(p);
    std::vector<T> result;
    result.reserve(all->size());
    for (const auto& f : *all) result.push_back(f(std::span<const T>(x)));
    return result;
  }

 private:
  using list = std::vector<compiled_expression<T>>;
  std::shared_ptr<const list> at(precision p) {
    const std::scoped_lock lock(mutex_);
    std::shared_ptr<const list>& known = by_precision_[p];
    if (known == nullptr) {
      list made;
      for (const expression& f : components_) made.push_back(f.evaluator<T>(p));
      known = std::make_shared<const list>(std::move(made));
    }
    return known;
  }
  std::vector<expression> components_;
  std::mutex mutex_;
  std::map<precision, std::shared_ptr<const list>> by_precision_;
};

/// Drops factors that are numbers: f and what is left of it have the same roots, with the same
/// multiplicities. It looks at so many operations in all.
class constant_factors {
 public:
  [[nodiscard]] symbol left_out_of(const symbol& f) {
    const detail::symbol_node& n = f.node();
    if (n.name == "*") {
      for (const bool first : {true, false}) {
        if (is_number_but_0(n.operands[first ? 0 : 1]))
          return left_out_of(n.operands[first ? 1 : 0]);
      }
    }
    if (n.name == "/" && is_number_but_0(n.operands[1])) return left_out_of(n.operands[0]);
    return f;
  }

 private:
  [[nodiscard]] bool is_number(const symbol& x) {
    const detail::symbol_node& n = x.node();
    if (--looks_ < 0 || n.variable != detail::symbol_node::no_variable) return false;
    return std::ranges::all_of(n.operands, [this](const symbol& y) { return is_number(y); });
  }
  [[nodiscard]] bool is_number_but_0(const symbol& x) {
    if (!is_number(x)) return false;
    const ball value = expression(x, {}).value(128);
    return value.is_bounded() && !contains_zero(value);
  }

  int looks_ = 1000;
};

expression without_constant_factors(const expression& f) {
  std::vector<symbol> x;
  for (std::size_t i = 0; i < f.variables().size(); ++i) x.push_back(symbol::variable(i));
  try {
    const symbol whole = f.evaluate(std::span<const symbol>(x));
    return expression(constant_factors().left_out_of(whole), f.names());
  } catch (const input_error&) {
    return f;  // it has no value anywhere
  }
}

precision precision_in(const std::vector<ball>& x) {
  precision p = least_precision;
  for (const ball& b : x) p = std::max(p, b.precision());
  return p;
}
precision precision_in(const std::vector<jet<ball, 1>>& x) {
  precision p = least_precision;
  for (const jet<ball, 1>& b : x) p = std::max(p, b[0].precision());
  return p;
}

}  // namespace

real_system::real_system(const std::vector<expression>& given) {
  for (const expression& f : given) components_.push_back(without_constant_factors(f));
  const std::vector<expression>& components = components_;
  for (const expression& f : components) {
    if (f.variables().size() != components.size()) {
      throw input_error(
          fmt::format("the system has {} equations and {} variables; it must have as "
                      "many of one as of the other",
                      components.size(), f.variables().size()));
    }
  }
  value_ = [at = std::make_shared<evaluators<ball>>(components)](const std::vector<ball>& x) {
    return (*at)(x, precision_in(x));
  };
  using slope = jet<ball, 1>;
  slope_ = [at = std::make_shared<evaluators<slope>>(components)](const std::vector<slope>& x) {
    return (*at)(x, precision_in(x));
  };
}

real_system::linearised real_system::linearise(const std::vector<ball>& x) const {
  const std::size_t n = x.size();
  linearised r;
  r.jacobian.assign(n, {});
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<jet<ball, 1>> t;
    t.reserve(n);
    for (std::size_t k = 0; k < n; ++k) {
      t.push_back(j == k ? jet<ball, 1>::variable(x[k]) : jet<ball, 1>::constant(x[k]));
    }
    const auto f = slope_(t);
    for (std::size_t i = 0; i < n; ++i) r.jacobian[i].push_back(f[i][1]);
    if (j == 0) {
      for (const auto& f_i : f) r.value.push_back(f_i[0]);
    }
  }
  return r;
}

krawczyk_step krawczyk(const real_system& f, const std::vector<ball>& x, precision p) {
  krawczyk_step r;
  const auto over = f.linearise(x);
  r.jacobian = over.jacobian;
  const vector m = with_precision(middle_of(x), std::max(p, x.front().precision()));
  r.value_at_middle = f(m);
  r.preconditioner =
      approximate_inverse(r.jacobian, std::max<precision>(x.front().precision(), 53));
  // Where f has a jump its derivative alone may be defined: f itself must be, over the whole box.
  if (r.preconditioner.empty() || is_undefined(over.value)) {
    r.image.assign(x.size(), ball::undefined(p));
    return r;
  }
  r.image = krawczyk_image(m, product(r.preconditioner, r.value_at_middle),
                           product(r.preconditioner, r.jacobian), difference_of(x, m));
  return r;
}

refined_system_root refine(const real_system& f, const system_region& region, long digits) {
  if (digits < 1) throw std::invalid_argument("refine: at least one digit must be asked for");
  refined_system_root r;
  r.enclosure = region.enclosure;
  const precision goal = bits_for_digits(digits) + 8;
  const auto bits_of = [&](const vector& x) {  // how narrow the widest component is beside its size
    std::int64_t least = goal;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const magnitude radius = x[i].radius();
      if (radius.is_zero()) continue;
      const magnitude size = (contains_zero(x[i]) ? region.box[i] : x[i]).magnitude_upper();
      least = std::min(least, size.log2_floor() - radius.log2_floor());
    }
    return least;
  };
  if (region.enclose) {
    r.enclosure = region.enclose(goal);
    if (bits_of(r.enclosure) >= goal - 4) r.verdict = status::certified;
    return r;
  }
  if (region.verdict != root_verdict::unique) return r;
  constexpr precision guard = 32;
  precision more = guard;  // for what cancels
  while (true) {
    const std::int64_t bits = bits_of(r.enclosure);
    if (bits >= goal) {
      r.verdict = status::certified;
      return r;
    }
    const precision next = std::min<precision>(goal, 2 * std::max<precision>(bits, 16)) + more;
    const vector x = with_precision(
        r.enclosure, std::max<precision>(next / 2 + more, static_cast<precision>(bits) + more));
    const krawczyk_step step = krawczyk(f, x, next);
    ++r.evaluations_of_f;
    ++r.evaluations_of_jacobian;
    const vector narrower = is_undefined(step.image)
                                ? r.enclosure
                                : common(step.image, with_precision(r.enclosure, next));
    if (is_undefined(narrower)) {
      throw std::logic_error("refine: the enclosures of f and its Jacobian contradict");
    }
    r.enclosure = narrower;
    if (bits_of(r.enclosure) <= bits) {
      more *= 2;
      if (more > 4 * goal + (1L << 12)) return r;
    }
  }
}

}  // namespace polhode
