// Formulas with parameters as what is integrated over a box.

#include "parametric_integrand.hpp"

#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "polhode/expression/expression.hpp"
#include "polhode/quadrature/integrate_box.hpp"
#include "quadrature/formula/arithmetics.hpp"

namespace polhode {

namespace {

using detail::parameter_box;

/// P's sides as T, of the kind and precision of x.
template <class T>
[[nodiscard]] std::vector<T> parameters_like(const parameter_box& box, const T& x) {
  std::vector<T> result;
  for (const parameter_range& side : box) {
    if constexpr (std::same_as<T, ball> || std::same_as<T, angle>) {
      result.push_back(T(side.enclosure(x.precision())));
    } else if constexpr (std::same_as<T, symmetry>) {
      result.push_back(side.is_point() ? symmetry(side.lower()) : symmetry::some_constant());
    } else if constexpr (std::same_as<T, region>) {
      const precision p = x.is_in_hardware() ? 64 : x.precision();
      result.push_back(side.is_point() ? detail::constant_region(side.lower(), x)
                                       : detail::constant_region(side.enclosure(p), x));
    } else {
      result.push_back(side.is_point() ? x.constant_like(side.lower())
                                       : x.constant_like(side.enclosure(192)));
    }
  }
  return result;
}

/// {x, P} as jets by p_i.
template <class T>
struct jets_by_parameter {
  using series = jet<T, 1>;
  jets_by_parameter(const T& x, const std::vector<T>& box, std::size_t i)
      : argument(series::constant(x)) {
    for (std::size_t k = 0; k < box.size(); ++k) {
      parameters.push_back(k == i ? series::variable(box[k]) : series::constant(box[k]));
    }
  }
  series argument;
  std::vector<series> parameters;
};

/// The derivative in a jet, where the function is proved differentiable.
[[nodiscard]] region slope_of(const jet<region, 1>& y) { return y[0].is_analytic() ? y[1] : y[0]; }
[[nodiscard]] ball slope_of(const jet<ball, 1>& y) {
  return y[0].is_bounded() ? y[1] : ball::undefined(y[0].precision());
}

/// An integrand that is known at balls and over regions only: g(x) for either.
template <class G>
[[nodiscard]] detail::integrand integrand_without_series(const G& g) {
  static constexpr std::string_view name = "a derivative by a parameter";
  detail::integrand result;
  result.over = g;
  result.evaluator = [g](precision) -> std::function<ball(const ball&)> { return g; };
  result.near_end = [](const end_series&) { return end_series::blocked(name); };
  result.near_infinity = [](const tail_series& x) { return x.blocked(name); };
  return result;
}

/// The argument and the parameters.
template <class T>
std::vector<T> with_argument(const T& x, std::vector<T> parameters) {
  parameters.insert(parameters.begin(), x);
  return parameters;
}

/// f at jets by the i-th parameter.
template <class T>
jet<T, 1> jet_of(const expression& f, const T& x, const parameter_box& box, std::size_t i) {
  const jets_by_parameter<T> jets(x, parameters_like(box, x), i);
  const std::vector<jet<T, 1>> values = with_argument(jets.argument, jets.parameters);
  return f.evaluator<jet<T, 1>>(x.precision() + 64)(std::span<const jet<T, 1>>(values));
}

}  // namespace

detail::parametric_integrand parametric_integrand_of(const expression& f) {
  constexpr precision series_bits = 192;
  detail::parametric_integrand result;
  result.over_box = [f](const parameter_box& box) {
    const auto at = [f, box](precision p) {
      return
          [g = f.evaluator<ball>(p), parameters = parameters_like(box, ball(0, p))](const ball& x) {
            const std::vector<ball> values = with_argument(x, parameters);
            return g(std::span<const ball>(values));
          };
    };
    const auto with = [box](const auto& g) {
      return [g, box](const auto& x) {
        using T = std::remove_cvref_t<decltype(x)>;
        const std::vector<T> values = with_argument(x, parameters_like(box, x));
        return g(std::span<const T>(values));
      };
    };
    detail::integrand of_box;
    of_box.over = [f, with, in_hardware = with(f.evaluator<region>(64))](const region& x) {
      return x.is_in_hardware() ? in_hardware(x) : with(f.evaluator<region>(x.precision()))(x);
    };
    of_box.evaluator = [at](precision p) -> std::function<ball(const ball&)> { return at(p); };
    of_box.near_end = with(f.evaluator<end_series>(series_bits));
    of_box.near_infinity = with(f.evaluator<tail_series>(series_bits));
    return of_box;
  };
  result.derivative = [f](const parameter_box& box, std::size_t i) {
    return integrand_without_series(
        [f, box, i](const auto& x) { return slope_of(jet_of(f, x, box, i)); });
  };
  return result;
}

box_integral integrate_box(const expression& f, const end_point& a, const end_point& b,
                           const std::vector<parameter_range>& box, const box_options& options) {
  if (f.variables().size() != box.size() + 1) {
    throw input_error(
        fmt::format("the formula has {} variables and the box {} sides; it must have a side for "
                    "each variable behind the first",
                    f.variables().size(), box.size()));
  }
  return detail::integrate_function_over_box(parametric_integrand_of(f), a, b, box, options);
}

}  // namespace polhode
