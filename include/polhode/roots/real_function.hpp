#pragma once

// A real function of one variable as the search for its roots needs it.
//
//   real_function f([](const auto& x) { return cos(x) - x; });
//
// is made of a formula, or of a generic function, which is called once, with a symbol, and becomes
// one (formula_of.hpp). The formula is evaluated over balls (values), jets (derivatives), regions
// (to prove it analytic) and a function_structure (to prove multiplicities and poles).
//
// Of a function that is an integral or a mean, say, and has no generic form, with_derivative takes
// enclosures of f and f'. Then multiplicities, poles and the range towards infinity cannot be
// proved.

#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/formula_of.hpp"
#include "polhode/roots/function_structure.hpp"

namespace polhode {

/// f with its constants made for one precision. Every member obeys the inclusion principle
/// (ball.hpp), and what it does not know is undefined.
struct function_evaluator {
  std::function<ball(const ball& x)> value;
  /// f' over x.
  std::function<ball(const ball& x)> derivative;
  /// {f, f'} over x.
  std::function<jet<ball, 1>(const ball& x)> slope;
  /// {f, f', ..., f^(n)/n!} over x.
  std::function<jet<ball, dynamic_order>(const ball& x, int n)> series;
  /// What the functions refer to, where it is not in them: a copy of one of them needs it.
  std::shared_ptr<const void> state = nullptr;
};

class real_function {
 public:
  /// Of a formula of one variable, or none. Throws input_error where it has more.
  real_function(const expression& f);  // NOLINT(google-explicit-constructor): the same function
  /// Of a generic function of one argument.
  template <class F>
  requires(!std::same_as<F, real_function> && !std::same_as<F, expression>)
      real_function(const F& f)  // NOLINT(google-explicit-constructor): the same function
      : real_function(formula_of(f)) {}
  /// Of f and its derivative, function objects ball -> ball, f continuously differentiable wherever
  /// both are defined.
  template <class F, class Derivative>
  [[nodiscard]] static real_function with_derivative(F f, Derivative derivative);
  /// Of a polynomial.
  [[nodiscard]] static real_function of(const rational_polynomial& p);
  /// Of a factory of evaluators, for other kinds of functions. Taylor coefficients beyond
  /// most_order are not asked for.
  explicit real_function(std::function<function_evaluator(precision)> at, int most_order)
      : at_(std::move(at)), most_order_(most_order) {}

  [[nodiscard]] std::shared_ptr<const function_evaluator> at(precision p) const {
    return std::make_shared<const function_evaluator>(at_(p));
  }
  /// The polynomial with rational coefficients that f is; nullptr where it is none.
  [[nodiscard]] const rational_polynomial* polynomial() const {
    return quotient_ && quotient_->divisors.empty() ? &quotient_->numerator : nullptr;
  }
  /// The quotient of polynomials with rational coefficients that f is, with what it divides by;
  /// nullptr where it is none.
  [[nodiscard]] const std::shared_ptr<const rational_quotient>& quotient() const {
    return quotient_;
  }
  /// The formula of one variable that f is; nullptr where f was given otherwise.
  [[nodiscard]] const expression* formula() const { return formula_.get(); }
  /// The greatest order of a series that is worth asking for, and the one that bounds f over a box
  /// best.
  [[nodiscard]] int most_order() const { return most_order_; }
  [[nodiscard]] int best_order() const { return best_order_; }

  /// f over a set of complex numbers; obstacle::unknown where that is not available.
  [[nodiscard]] region over(const region& x) const {
    return over_ ? over_(x) : region::blocked(obstacle::unknown, "this function");
  }
  /// Proved: f has no root x with at < x <= at + width, or at + width <= x < at where width is
  /// negative.
  [[nodiscard]] bool has_no_root_beside(const pi_combination& at, const rational& width) const {
    return no_root_beside_ && no_root_beside_(at, width);
  }
  /// Proved: f has no root x >= from > 0, or x <= from < 0.
  [[nodiscard]] bool has_no_root_beyond(const rational& from) const {
    return no_root_beyond_ && no_root_beyond_(from);
  }
  /// Proved: f has infinitely many roots beyond every number, to the right for side = 1 and to the
  /// left for side = -1.
  [[nodiscard]] bool has_endless_roots(int side) const { return endless_ && endless_(side); }
  /// Proved: f has infinitely many roots between lower and upper, beside a point where it is
  /// singular.
  [[nodiscard]] bool has_endless_roots_in(const rational& lower, const rational& upper) const {
    return endless_in_ && endless_in_(lower, upper);
  }
  /// A period of f, but for factors that are 0 nowhere, and so of its roots and poles, proved;
  /// nothing where none is found.
  [[nodiscard]] std::optional<pi_combination> period() const {
    return period_ ? period_() : std::nullopt;
  }
  /// std::nullopt where it is not available.
  [[nodiscard]] std::optional<function_structure> structure(const function_structure& x) const {
    if (!structure_) return std::nullopt;
    return structure_(x);
  }

 private:
  real_function() = default;

  std::function<function_evaluator(precision)> at_;
  std::function<region(const region&)> over_;
  std::function<function_structure(const function_structure&)> structure_;
  std::function<bool(const pi_combination&, const rational&)> no_root_beside_;
  std::function<bool(const rational&)> no_root_beyond_;
  std::function<bool(int)> endless_;
  std::function<bool(const rational&, const rational&)> endless_in_;
  std::function<std::optional<pi_combination>()> period_;
  std::shared_ptr<const rational_quotient> quotient_;
  std::shared_ptr<const expression> formula_;
  int most_order_ = 64;
  int best_order_ = 2;
};

template <class F, class Derivative>
real_function real_function::with_derivative(F f, Derivative derivative) {
  return real_function(
      [f = std::move(f), derivative = std::move(derivative)](precision) {
        function_evaluator e;
        e.value = f;
        e.derivative = derivative;
        e.slope = [f, derivative](const ball& x) {
          jet<ball, 1> r;
          r[0] = f(x);
          r[1] = derivative(x);
          return r;
        };
        e.series = [slope = e.slope](const ball& x, int n) {
          const jet<ball, 1> known = slope(x);
          jet<ball, dynamic_order> r(n);
          for (int k = 0; k <= n; ++k) r[k] = k <= 1 ? known[k] : ball::undefined(x.precision());
          return r;
        };
        return e;
      },
      1);
}

}  // namespace polhode
