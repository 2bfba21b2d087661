#include "poles.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "quadrature/formula/formula_graph.hpp"

namespace polhode::detail {

namespace {

/// A function over a set: its values and slopes, and its values at the ends.
struct function_over {
  slope_jet over;
  ball at_low;
  ball at_high;
};

template <class F>
function_over each(const function_over& x, const function_over& y, F&& f) {
  return {f(x.over, y.over), f(x.at_low, y.at_low), f(x.at_high, y.at_high)};
}

/// base^exponent.
struct power_over {
  function_over base;
  long exponent = 1;
};

/// numerator / product of D_i^k_i, the D_i by the numbers of the nodes that brought them in.
struct quotient {
  function_over numerator;
  std::map<std::size_t, long> divisors;
  /// The numerator as a power, where it was made as one.
  std::optional<power_over> as_power = std::nullopt;

  [[nodiscard]] power_over numerator_as_power() const {
    return as_power ? *as_power : power_over{numerator, 1};
  }
};

class pole_search {
 public:
  pole_search(const formula_graph& f, const ball& x)
      : f_(f), constants_(f.constants_at(x.precision())) {
    const ball low(lower_rational(x), x.precision());
    const ball high(upper_rational(x), x.precision());
    x_ = {slope_jet::variable(x), low, high};
  }

  /// Newton's step from x's lower end l, l - D(l)/D'(x), which holds the pole that is proved.
  [[nodiscard]] std::optional<ball> found() {
    values_.resize(f_.size());
    for (std::size_t i = 0; i < f_.size(); ++i) {
      values_[i] = value_of(i);
      if (!values_[i]) return std::nullopt;
    }
    const quotient& f = *values_[f_.result()];
    if (may_vanish(f.numerator) || f.divisors.size() != 1) return std::nullopt;
    const function_over& d = divisors_.at(f.divisors.begin()->first);
    const ball& slope = d.over[1];
    const bool is_monotone =
        slope.is_bounded() && (certainly_positive(slope) || certainly_negative(slope));
    const bool changes_sign = (certainly_negative(d.at_low) && certainly_positive(d.at_high)) ||
                              (certainly_positive(d.at_low) && certainly_negative(d.at_high));
    if (!is_monotone || !changes_sign) return std::nullopt;
    return x_.at_low - d.at_low / slope;
  }

 private:
  using maybe = std::optional<quotient>;

  [[nodiscard]] function_over constant(const ball& c) const {
    return {slope_jet::constant(c), c, c};
  }
  static bool may_vanish(const function_over& x) {
    return x.over[0].is_undefined() || contains_zero(x.over[0]);
  }
  static function_over times(const function_over& x, const function_over& y) {
    return each(x, y, [](const auto& u, const auto& v) { return u * v; });
  }
  static function_over power_of(function_over x, long k) {
    const function_over base = x;
    for (long j = 1; j < k; ++j) x = times(x, base);
    return x;
  }
  /// x's numerator over the divisors of both.
  [[nodiscard]] function_over numerator_beside(const quotient& x, const quotient& y) const {
    function_over result = x.numerator;
    for (const auto& [i, k] : y.divisors) {
      const auto own = x.divisors.find(i);
      const long missing = k - (own == x.divisors.end() ? 0 : own->second);
      if (missing > 0) result = times(result, power_of(divisors_.at(i), missing));
    }
    return result;
  }
  template <class F>
  [[nodiscard]] maybe sum(const quotient& x, const quotient& y, F&& f) const {
    quotient r{each(numerator_beside(x, y), numerator_beside(y, x), f), x.divisors};
    for (const auto& [i, k] : y.divisors) r.divisors[i] = std::max(r.divisors[i], k);
    return r;
  }
  static maybe product(const quotient& x, const quotient& y) {
    quotient r{times(x.numerator, y.numerator), x.divisors};
    for (const auto& [i, k] : y.divisors) r.divisors[i] += k;
    return unless_high(std::move(r));
  }
  /// Nested powers would make exponents as high as they like.
  static maybe unless_high(quotient x) {
    constexpr long most = 1000;
    const bool is_high = x.numerator_as_power().exponent > most ||
                         std::any_of(x.divisors.begin(), x.divisors.end(),
                                     [](const auto& d) { return d.second > most; });
    return is_high ? std::nullopt : maybe(std::move(x));
  }
  /// x over a power of a function without divisors, which node i brings in.
  maybe over(std::size_t i, const quotient& x, const power_over& d) {
    quotient r{x.numerator, x.divisors};
    if (may_vanish(d.base)) {
      divisors_[i] = d.base;
      r.divisors[i] += d.exponent;
    } else {
      const function_over power = power_of(d.base, d.exponent);
      r.numerator = each(r.numerator, power, [](const auto& u, const auto& v) { return u / v; });
    }
    return unless_high(std::move(r));
  }

  maybe value_of(std::size_t i) {
    const formula_node& node = f_.node(i);
    if (node.is_argument()) return quotient{x_, {}};
    if (node.is_constant()) {
      const auto& c = (*constants_)[static_cast<std::size_t>(node.number)];
      return quotient{constant(constant_beside(x_.at_low, c)), {}};
    }
    if (node.is_piecewise()) return std::nullopt;
    const quotient& x = *values_[node.left];
    const quotient& y = *values_[node.right];
    switch (node.what) {
      case operation::add:
        return sum(x, y, [](const auto& u, const auto& v) { return u + v; });
      case operation::subtract:
        return sum(x, y, [](const auto& u, const auto& v) { return u - v; });
      case operation::negate:
        return quotient{
            each(x.numerator, x.numerator, [](const auto& u, const auto&) { return -u; }),
            x.divisors};
      case operation::multiply:
        return product(x, y);
      case operation::power_integer:
        return power(i, x, node.number);
      case operation::divide: {
        // x times y's divisors, over y's numerator.
        quotient u = x;
        for (const auto& [j, k] : y.divisors) {
          const long cancelled = std::min(u.divisors[j], k);
          u.divisors[j] -= cancelled;
          if (u.divisors[j] == 0) u.divisors.erase(j);
          if (k > cancelled) {
            u.numerator = times(u.numerator, power_of(divisors_.at(j), k - cancelled));
          }
        }
        return over(i, u, y.numerator_as_power());
      }
      case operation::tan: {
        if (!x.divisors.empty()) return std::nullopt;
        const quotient sine{
            each(x.numerator, x.numerator, [](const auto& u, const auto&) { return sin(u); }), {}};
        return over(
            i, sine,
            {each(x.numerator, x.numerator, [](const auto& u, const auto&) { return cos(u); }), 1});
      }
      default:
        break;
    }
    return function_without_poles(node);
  }
  /// Of any function of what has no pole.
  [[nodiscard]] maybe function_without_poles(const formula_node& node) const {
    bool has_poles = false;
    f_.for_each_operand(
        node, [&](std::size_t k) { has_poles = has_poles || !values_[k]->divisors.empty(); });
    if (has_poles) return std::nullopt;
    const auto with = [&](auto part) {
      using T = std::remove_cvref_t<decltype(std::declval<function_over>().*part)>;
      return value_of_node<T>(
          f_, node, [&](std::size_t k) -> const T& { return values_[k]->numerator.*part; });
    };
    return quotient{
        {with(&function_over::over), with(&function_over::at_low), with(&function_over::at_high)},
        {}};
  }
  maybe power(std::size_t i, const quotient& x, long n) {
    constexpr long most = 16;
    if (std::abs(n) > most || n == 0) return function_without_poles(f_.node(i));
    power_over base = x.numerator_as_power();
    base.exponent *= std::abs(n);
    if (n > 0) {
      quotient r{power_of(x.numerator, n), x.divisors, base};
      for (auto& [j, k] : r.divisors) k *= n;
      return unless_high(std::move(r));
    }
    if (!x.divisors.empty()) return std::nullopt;
    return over(i, {constant(ball(1, x_.at_low.precision())), {}}, base);
  }

  const formula_graph& f_;
  std::shared_ptr<const formula_graph::constants> constants_;
  function_over x_;
  std::vector<maybe> values_;
  std::map<std::size_t, function_over> divisors_;
};

}  // namespace

std::optional<ball> pole_in(const integrand& f, const ball& x) {
  if (!f.graph || !x.is_bounded()) return std::nullopt;
  const std::shared_ptr<const formula_graph> graph = f.graph();
  std::optional<ball> pole;
  ball set = x;
  constexpr int most_steps = 8;
  for (int k = 0; k < most_steps; ++k) {
    const std::optional<ball> step = pole_search(*graph, set).found();
    if (!step) break;
    pole = intersection(*step, set);
    if (pole->is_undefined() || pole->radius() > scale(set.radius(), -1)) break;
    // The pole need not lie inside of what the step gives, but does inside of this.
    set = intersection(pole->enlarged(pole->radius()), set);
  }
  return pole;
}

}  // namespace polhode::detail
