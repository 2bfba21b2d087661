#include "polhode/roots/real_function.hpp"

#include <algorithm>

#include "polhode/arithmetic/generic_function.hpp"

namespace polhode {

real_function real_function::of(const rational_polynomial& p) {
  real_function result;
  result.at_ = [p](precision) {
    function_evaluator e;
    e.value = [p](const ball& x) { return p(x); };
    e.slope = [p](const ball& x) {
      const auto s = p.series(x, 1);
      jet<ball, 1> r;
      r[0] = s[0];
      r[1] = s[1];
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
