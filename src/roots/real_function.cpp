#include "polhode/roots/real_function.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "polhode/arithmetic/generic_function.hpp"

namespace polhode {

real_function real_function::of(const rational_polynomial& p) {
  real_function result;
  result.quotient_ = std::make_shared<const rational_quotient>(rational_quotient{p, {}});
  result.at_ = [p](precision bits) {
    std::vector<ball> c;
    c.reserve(p.coefficients().size());
    for (const rational& q : p.coefficients()) c.emplace_back(q, bits);
    const auto coefficients = std::make_shared<const std::vector<ball>>(std::move(c));
    function_evaluator e;
    e.value = [coefficients, bits](const ball& x) {
      ball value(0, bits);
      for (std::size_t k = coefficients->size(); k-- > 0;) value = value * x + (*coefficients)[k];
      return value;
    };
    e.slope = [coefficients, bits](const ball& x) {
      jet<ball, 1> r;
      r[0] = r[1] = ball(0, bits);
      for (std::size_t k = coefficients->size(); k-- > 0;) {
        r[1] = r[1] * x + r[0];
        r[0] = r[0] * x + (*coefficients)[k];
      }
      return r;
    };
    e.derivative = [slope = e.slope](const ball& x) { return slope(x)[1]; };
    e.series = [p](const ball& x, int n) { return p.series(x, n); };
    return e;
  };
  const auto horner = [p](const auto& x) {
    auto value = detail::value_as<std::remove_cvref_t<decltype(x)>>(rational(0), x);
    for (std::size_t k = p.coefficients().size(); k-- > 0;) {
      value = value * x + p.coefficients()[k];
    }
    return value;
  };
  result.over_ = horner;
  result.structure_ = horner;
  const int degree = static_cast<int>(p.degree());
  result.most_order_ = std::max(result.most_order_, degree);
  result.best_order_ = std::max(degree, 1);  // Taylor's formula without a remainder
  return result;
}

}  // namespace polhode
