#pragma once

// A real function of one variable as the search for its roots needs it.
//
//   real_function f([](const auto& x) { return cos(x) - x; });
//
// is made of a generic function, which is called with balls (values), jets (derivatives), regions (to prove it
// analytic) and a function_structure (to prove multiplicities and poles). It must be a function in the
// mathematician's sense: the same argument gives the same value, by the same formula for every type. A
// function object with a member template evaluator<T>(p), as a formula has, is asked for what is to be
// called with p bits, so that its constants are made once.
//
// Of a function that is an integral or a mean, say, and has no generic form, with_derivative takes enclosures
// of f and f'. Then multiplicities, poles and the range towards infinity cannot be proved.

#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "polhode/arithmetic/generic_function.hpp"
#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/roots/function_structure.hpp"

namespace polhode {

/// f with its constants made for one precision. Every member obeys the inclusion principle (ball.hpp), and
/// what it does not know is undefined.
struct function_evaluator {
  std::function<ball(const ball& x)> value;
  /// f' over x.
  std::function<ball(const ball& x)> derivative;
  /// {f, f'} over x.
  std::function<jet<ball, 1>(const ball& x)> slope;
  /// {f, f', ..., f^(n)/n!} over x.
  std::function<jet<ball, dynamic_order>(const ball& x, int n)> series;
};

class real_function {
 public:
  /// Of a generic function.
  template <class F>
  requires(!std::same_as<std::remove_cvref_t<F>, real_function>)
      real_function(F f);  // NOLINT(google-explicit-constructor): the same function
  /// Of f and its derivative, function objects ball -> ball, f continuously differentiable wherever both are
  /// defined.
  template <class F, class Derivative>
  [[nodiscard]] static real_function with_derivative(F f, Derivative derivative);
  /// Of a polynomial.
  [[nodiscard]] static real_function of(const rational_polynomial& p);
  /// Of a factory of evaluators, for other kinds of functions. Taylor coefficients beyond most_order are not
  /// asked for.
  explicit real_function(std::function<function_evaluator(precision)> at, int most_order)
      : at_(std::move(at)), most_order_(most_order) {}

  [[nodiscard]] std::shared_ptr<const function_evaluator> at(precision p) const {
    return for_all_ != nullptr ? for_all_ : std::make_shared<const function_evaluator>(at_(p));
  }
  /// The greatest order of a series that is worth asking for, and the one that bounds f over a box best.
  [[nodiscard]] int most_order() const { return most_order_; }
  [[nodiscard]] int best_order() const { return best_order_; }

  /// f over a set of complex numbers; obstacle::unknown where that is not available.
  [[nodiscard]] region over(const region& x) const {
    return over_ ? over_(x) : region::blocked(obstacle::unknown, "this function");
  }
  /// Proved: f has no root x with at < x <= at + width, or at + width <= x < at where width is negative.
  [[nodiscard]] bool has_no_root_beside(const rational& at, const rational& width) const {
    return no_root_beside_ && no_root_beside_(at, width);
  }
  /// Sets the proof that has_no_root_beside asks for.
  void prove_beside(std::function<bool(const rational& at, const rational& width)> proof) {
    no_root_beside_ = std::move(proof);
  }
  /// std::nullopt where it is not available.
  [[nodiscard]] std::optional<function_structure> structure(const function_structure& x) const {
    if (!structure_) return std::nullopt;
    return structure_(x);
  }

 private:
  real_function() = default;

  std::function<function_evaluator(precision)> at_;
  std::shared_ptr<const function_evaluator> for_all_;  // where it is the same for all precisions
  std::function<region(const region&)> over_;
  std::function<function_structure(const function_structure&)> structure_;
  std::function<bool(const rational&, const rational&)> no_root_beside_;
  int most_order_ = 64;
  int best_order_ = 2;
};

template <class F>
requires(!std::same_as<std::remove_cvref_t<F>, real_function>) real_function::real_function(F f) {
  if constexpr (detail::expect_generic<F, ball>()) {
    using detail::evaluator_of;
    using detail::value_as;
    using slope_type = jet<ball, 1>;
    using series_type = jet<ball, dynamic_order>;
    at_ = [f](precision p) {
      function_evaluator e;
      e.value = [g = evaluator_of<ball>(f, p)](const ball& x) { return value_as<ball>(g(x), x); };
      e.slope = [g = evaluator_of<slope_type>(f, p)](const ball& x) {
        const auto t = slope_type::variable(x);
        return value_as<slope_type>(g(t), t);
      };
      e.derivative = [slope = e.slope](const ball& x) { return slope(x)[1]; };
      e.series = [g = evaluator_of<series_type>(f, p)](const ball& x, int n) {
        const auto t = series_type::variable(x, n);
        return value_as<series_type>(g(t), t);
      };
      return e;
    };
    if constexpr (!requires { f.template evaluator<ball>(precision{64}); }) {
      for_all_ = std::make_shared<const function_evaluator>(at_(64));
    }
    over_ = [f](const region& x) {
      return value_as<region>(evaluator_of<region>(f, std::max<precision>(x.precision(), 64))(x),
                              x);
    };
    structure_ = [f](const function_structure& x) {
      return value_as<function_structure>(
          evaluator_of<function_structure>(f, x.numerator().at_point.precision())(x), x);
    };
  }  // else refused there, or by the compiler in the body of f
}

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
