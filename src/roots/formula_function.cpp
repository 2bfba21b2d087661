// Formulas as functions whose roots are looked for.

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/on_first_use.hpp"
#include "endless_roots.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/gamma_quotients.hpp"
#include "polhode/expression/evaluation.hpp"
#include "polhode/expression/symbol.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/zero_free_ends.hpp"
#include "polhode/roots/real_function.hpp"

namespace polhode {

namespace detail {
namespace {

ball reciprocal_gamma(const ball& x) { return reciprocal_gamma(jet<ball, 1>::constant(x))[0]; }

}  // namespace

template <>
struct supplement<function_structure> {
  using series = function_structure::exact_series;

  // e^x - 1 and log(1 + x): exactly 0 where x is.
  static function_structure expm1(const function_structure& x) {
    return function_structure::applied(
        x, [](const auto& t) { return named<operation::expm1>::over(t); },
        [](const ball& t) { return std::optional<ball>(polhode::expm1(t)); },
        [](const series& t) { return exp(t) - 1; });
  }
  static function_structure log1p(const function_structure& x) {
    return function_structure::applied(
        x, [](const auto& t) { return named<operation::log1p>::over(t); },
        [](const ball& t) { return natural_domain::log1p(t); },
        [](const series& t) { return log(t + 1); });
  }
  static function_structure power(const function_structure& x, const function_structure& y) {
    return power_of(
        x, y, [](const auto& s, const auto& t) { return named<operation::power>::over(s, t); });
  }
  static function_structure root(const function_structure& x, long n) {
    return function_structure::applied(
               x, [n](const auto& t) { return named<operation::root>::over(t, n); },
               [n](const ball& t) {
                 return natural_domain::root(t, static_cast<unsigned long>(n));
               },
               [n](const series& t) {
                 const known_number value =
                     t[0].is_exactly(0) || t[0].is_exactly(1)
                         ? t[0]
                         : known_number(named<operation::root>::over(t[0].enclosure(), n));
                 return function_structure::value_alone(t, value);
               })
        .with_zeros_of(x);
  }
  // 1/Gamma is entire, and the poles of Gamma are its zeros, which are simple; none is positive.
  static function_structure gamma(const function_structure& x) {
    const function_structure inverse = function_structure::applied(
        x, [](const auto& t) { return reciprocal_gamma(t); },
        [](const ball& t) { return std::optional<ball>(reciprocal_gamma(t)); }, nullptr,
        certainly_positive(x.over()[0]));
    return x.constant_like(rational(1)) / inverse;
  }
  static function_structure log_gamma(const function_structure& x) {
    return function_structure::applied(
        x, [](const auto& t) { return named<operation::log_gamma>::over(t); },
        [](const ball& t) {
          std::optional<ball> r = natural_domain::log(abs(reciprocal_gamma(t)));
          return r ? std::optional(-*r) : r;
        },
        nullptr);
  }
  /// A new factor, over its natural domain, without a series; or a quotient of two.
  template <class F, class Range>
  static function_structure further(const F& f, const Range& x) {
    if constexpr (std::same_as<F, further_function>) {
      if (f.numerator) return applied_once(f.numerator, x[0]) / applied_once(f.divisor, x[0]);
    }
    return function_structure::applied_to_many(
        {x.begin(), x.end()}, [&](const std::vector<jet<ball, 1>>& t) { return on_jets(f, t); },
        [&](const std::vector<ball>& t) { return f.value(t); },
        [&](const std::vector<ball>& t) { return natural(f, t); });
  }

 private:
  template <class F>
  static std::optional<ball> natural(const F& f, const std::vector<ball>& t) {
    if constexpr (requires { f.natural_range; }) {
      if (f.natural_range) return f.natural_range(t);
    }
    return f.value(t);
  }

  static function_structure applied_once(const std::function<jet<ball, 1>(const jet<ball, 1>&)>& f,
                                         const function_structure& x) {
    const auto at = [&](const ball& t) { return f(jet<ball, 1>::constant(t))[0]; };
    return function_structure::applied(
        x,
        [&](const auto& t) {
          if constexpr (std::same_as<std::remove_cvref_t<decltype(t)>, ball>) {
            return at(t);
          } else {
            return f(t);
          }
        },
        [&](const ball& t) { return std::optional<ball>(at(t)); }, nullptr);
  }
  static jet<ball, 1> on_jets(const further_function& f, const std::vector<jet<ball, 1>>& t) {
    return value_over<jet<ball, 1>>(f, t);
  }
  template <operation what>
  static jet<ball, 1> on_jets(const named<what>&, const std::vector<jet<ball, 1>>& t) {
    return named<what>::of(std::span<const jet<ball, 1>>(t));
  }
};

}  // namespace detail

template class compiled_expression<function_structure>;

namespace formula_function_impl {
namespace {

/// Finds factors of a formula that are 0 nowhere. It looks at so many operations in all, as a short
/// formula may name one part many times.
class factors_without_zeros {
 public:
  /// f without the factors and divisors that have a value other than 0 everywhere, exponentials and
  /// hyperbolic cosines of polynomials: it has the roots and the poles of f.
  [[nodiscard]] symbol rest_of(const symbol& f) {
    const detail::symbol_node& n = f.node();
    if (--looks_ < 0) return f;
    if (n.name == "*") return rest_of(n.operands[0]) * rest_of(n.operands[1]);
    if (n.name == "/") return rest_of(n.operands[0]) / rest_of(n.operands[1]);
    const bool is_never_0 = n.name == "exp" || n.name == "cosh";
    return is_never_0 && is_polynomial(n.operands[0]) ? symbol(1) : f;
  }

 private:
  /// Whether it has a value for every value of its variable, as it is written: a polynomial.
  [[nodiscard]] bool is_polynomial(const symbol& x) {
    const detail::symbol_node& n = x.node();
    if (--looks_ < 0) return false;
    if (n.name.empty()) return true;
    if (n.name == "/") {
      return is_polynomial(n.operands[0]) && n.operands[1].node().name.empty() &&
             n.operands[1].node().number != 0;
    }
    if (n.name != "+" && n.name != "-" && n.name != "*") return false;
    return std::ranges::all_of(n.operands, [this](const symbol& y) { return is_polynomial(y); });
  }

  int looks_ = 1000;
};

/// A formula as a polynomial P in one of its parts u, with rational coefficients: in exp(q x), of
/// which other exponentials are powers, or in a function of x that is there once or many times.
class polynomial_in_a_part {
 public:
  /// f as the product of the factors of P without multiple roots, each to the power of its
  /// multiplicity, which is the same function; nothing where f is no such polynomial, or has no
  /// multiple factor.
  [[nodiscard]] std::optional<symbol> factored(const symbol& f) {
    find_slopes(f);
    const auto p = polynomial_of(f);
    if (!p || !part_ || p->degree() < 2) return std::nullopt;
    const std::vector<repeated_factor> factors = square_free_decomposition(*p);
    if (std::ranges::all_of(factors, [](const auto& g) { return g.multiplicity == 1; })) {
      return std::nullopt;
    }
    rational rest = p->leading();
    symbol product(1);
    for (const repeated_factor& g : factors) {
      symbol value(0);
      const std::vector<rational>& c = g.factor.coefficients();
      for (std::size_t k = c.size(); k-- > 0;) value = value * *part_ + symbol(c[k]);
      product = product * pow(value, symbol(g.multiplicity));
      for (long k = 0; k < g.multiplicity; ++k) rest /= g.factor.leading();
    }
    return symbol(rest) * product;
  }

 private:
  static constexpr long most_degree = 40;

  /// The q of a formula q x.
  [[nodiscard]] static std::optional<rational> multiple_of_variable(const symbol& x) {
    const detail::symbol_node& n = x.node();
    if (n.name.empty()) return n.variable == 0 ? std::optional(rational(1)) : std::nullopt;
    const auto number = [&](std::size_t i) -> std::optional<rational> {
      const detail::symbol_node& of = n.operands[i].node();
      const bool is_number =
          of.name.empty() && !of.enclosure && of.variable == detail::symbol_node::no_variable;
      return is_number ? std::optional(of.number) : std::nullopt;
    };
    if (n.name == "-" && n.operands.size() == 1) {
      const auto q = multiple_of_variable(n.operands[0]);
      return q ? std::optional(rational(-*q)) : std::nullopt;
    }
    if (n.name != "*" && n.name != "/") return std::nullopt;
    if (const auto c = number(1); c && (n.name == "*" || *c != 0)) {
      const auto q = multiple_of_variable(n.operands[0]);
      if (!q) return std::nullopt;
      return n.name == "*" ? rational(*q * *c) : rational(*q / *c);
    }
    const auto c = n.name == "*" ? number(0) : std::nullopt;
    const auto q = c ? multiple_of_variable(n.operands[1]) : std::nullopt;
    return q ? std::optional(rational(*q * *c)) : std::nullopt;
  }
  /// The q of an exponential of q x.
  [[nodiscard]] static std::optional<rational> slope_of(const detail::symbol_node& n) {
    return n.name == "exp" ? multiple_of_variable(n.operands[0]) : std::nullopt;
  }

  /// The greatest number of which the slopes of all exponentials are multiples.
  void find_slopes(const symbol& f) {
    if (--looks_ < 0) return;
    if (const auto q = slope_of(f.node()); q && *q != 0) {
      const rational size = abs(*q);
      if (!slope_) {
        slope_ = size;
      } else {
        const integer common = lcm(integer(denominator(*slope_)), integer(denominator(size)));
        slope_ = rational(gcd(integer(numerator(rational(*slope_ * common))),
                              integer(numerator(rational(size * common)))),
                          common);
      }
      return;
    }
    for (const symbol& x : f.node().operands) find_slopes(x);
  }

  [[nodiscard]] std::optional<rational_polynomial> polynomial_of(const symbol& f) {
    const detail::symbol_node& n = f.node();
    if (--looks_ < 0) return std::nullopt;
    if (n.name.empty()) {
      if (n.enclosure || n.variable != detail::symbol_node::no_variable) return std::nullopt;
      return rational_polynomial({n.number});
    }
    if (const auto q = slope_of(n); q && slope_) {
      const rational times = *q / *slope_;
      if (denominator(times) != 1 || times < 0 || times > most_degree) return std::nullopt;
      part_ = symbol::call("exp", {symbol(*slope_) * symbol::variable(0)});
      return power_of(rational_polynomial::variable(), static_cast<long>(numerator(times)));
    }
    const auto operand = [&](std::size_t i) { return polynomial_of(n.operands[i]); };
    if (n.name == "-" && n.operands.size() == 1) {
      const auto x = operand(0);
      return x ? std::optional(rational_polynomial({rational(-1)}) * *x) : std::nullopt;
    }
    if (n.name == "+" || n.name == "-" || n.name == "*" || n.name == "/") {
      const auto x = operand(0);
      const auto y = x ? operand(1) : std::nullopt;
      if (!y || x->degree() + y->degree() > most_degree) return std::nullopt;
      if (n.name == "+") return *x + *y;
      if (n.name == "-") return *x - *y;
      if (n.name == "*") return *x * *y;
      if (y->degree() != 0) return std::nullopt;
      return rational_polynomial({rational(1 / y->leading())}) * *x;
    }
    if (n.name == "pow") {
      const auto x = operand(0);
      const auto y = x ? operand(1) : std::nullopt;
      if (!y || y->degree() != 0 || denominator(y->leading()) != 1) return std::nullopt;
      const rational times = y->leading();
      if (times < 0 || times * std::max(x->degree(), 1L) > most_degree) return std::nullopt;
      return power_of(*x, static_cast<long>(numerator(times)));
    }
    if (slope_ || n.operands.empty()) return std::nullopt;  // beside an exponential, or a constant
    if (part_ && &part_->node() != &n) return std::nullopt;
    part_ = f;
    return rational_polynomial::variable();
  }

  [[nodiscard]] static rational_polynomial power_of(const rational_polynomial& p, long n) {
    rational_polynomial result({rational(1)});
    for (long k = 0; k < n; ++k) result = result * p;
    return result;
  }

  int looks_ = 2000;
  std::optional<rational> slope_;
  std::optional<symbol> part_;
};

/// The same function, with multiple factors as powers where they are found: in f, or in what it is
/// a product or quotient of; nothing where there are none. It looks at so many of these at most.
std::optional<symbol> with_factors(const symbol& f, int& looks) {
  const detail::symbol_node& n = f.node();
  if (--looks < 0) return std::nullopt;
  if (auto product = polynomial_in_a_part().factored(f)) return product;
  if (n.name != "*" && n.name != "/") return std::nullopt;
  const auto left = with_factors(n.operands[0], looks);
  const auto right = with_factors(n.operands[1], looks);
  if (!left && !right) return std::nullopt;
  const symbol x = left.value_or(n.operands[0]);
  const symbol y = right.value_or(n.operands[1]);
  return n.name == "*" ? x * y : x / y;
}
expression factored(const expression& f) {
  if (f.variables().size() != 1) return f;
  int looks = 20;
  const auto product = with_factors(f(symbol::variable(0)), looks);
  return product ? expression(*product, f.names()) : f;
}

/// f over balls, jets and series, each with its constants made with p bits when it is first called:
/// one or two of them are called as a rule.
struct formula_evaluators {
  std::shared_ptr<const expression> f;
  precision p;
  detail::on_first_use<compiled_expression<ball>> value;
  detail::on_first_use<compiled_expression<jet<ball, 1>>> slope;
  detail::on_first_use<compiled_expression<jet<ball, dynamic_order>>> series;

  [[nodiscard]] ball value_at(const ball& x) const {
    return value.made_by([this] { return f->evaluator<ball>(p); })(x);
  }
  [[nodiscard]] jet<ball, 1> slope_at(const ball& x) const {
    return slope.made_by([this] { return f->evaluator<jet<ball, 1>>(p); })(
        jet<ball, 1>::variable(x));
  }
  [[nodiscard]] jet<ball, dynamic_order> series_at(const ball& x, int n) const {
    return series.made_by([this] { return f->evaluator<jet<ball, dynamic_order>>(p); })(
        jet<ball, dynamic_order>::variable(x, n));
  }
};

}  // namespace
}  // namespace formula_function_impl

real_function::real_function(const expression& f) {
  if (f.variables().size() > 1) {
    throw input_error(
        fmt::format("the variables of the formula are {}; roots are found of a function of one",
                    fmt::join(f.variables(), ", ")));
  }
  if (f.variables().size() == 1) formula_ = std::make_shared<const expression>(f);
  // Above this degree it is a function like others: exact arithmetic would take too long.
  constexpr long most_degree = 2000;
  if (auto q = f.quotient()) {
    long below = 0;
    for (const repeated_factor& d : q->divisors) {
      below += d.factor.degree() * std::max(d.multiplicity, 1L);
    }
    if (std::max(q->numerator.degree(), below) <= most_degree) {
      quotient_ = std::make_shared<const rational_quotient>(std::move(*q));
    }
  }
  at_ = [shared = std::make_shared<const expression>(f)](precision p) {
    const auto all = std::make_shared<formula_function_impl::formula_evaluators>();
    all->f = shared;
    all->p = p;
    // The functions refer to the state by an address, so that each is kept without an allocation.
    const formula_function_impl::formula_evaluators* const at_p = all.get();
    function_evaluator e;
    e.value = [at_p](const ball& x) { return at_p->value_at(x); };
    e.slope = [at_p](const ball& x) { return at_p->slope_at(x); };
    e.derivative = [at_p](const ball& x) { return at_p->slope_at(x)[1]; };
    e.series = [at_p](const ball& x, int n) { return at_p->series_at(x, n); };
    e.state = all;
    return e;
  };
  over_ = [f, in_hardware = f.evaluator<region>(64)](const region& x) {
    return x.is_in_hardware() ? in_hardware(x) : f.evaluator<region>(x.precision())(x);
  };
  structure_ = [g = formula_function_impl::factored(f)](const function_structure& x) {
    return g.evaluator<function_structure>(x.numerator().at_point.precision())(x);
  };
  const zero_free_ends ends(f);
  no_root_beside_ = [ends](const pi_combination& at, const rational& width) {
    return ends.beside(at, width);
  };
  no_root_beyond_ = [ends](const rational& from) { return ends.beyond(from); };
  endless_ = [f](int side) {
    return f.variables().size() == 1 && detail::has_endless_roots(f, side);
  };
  endless_in_ = [f](const rational& lower, const rational& upper) {
    return f.variables().size() == 1 && detail::has_endless_roots_in(f, lower, upper);
  };
  period_ = [f]() -> std::optional<pi_combination> {
    if (f.variables().size() != 1) return period_of(f);
    const symbol rest =
        formula_function_impl::factors_without_zeros().rest_of(f(symbol::variable(0)));
    return period_of(expression(rest, f.names()));
  };
}

}  // namespace polhode
