#include "taylor_bounds.hpp"

#include "polhode/arithmetic/interval.hpp"

namespace polhode::detail {

enclosed_function taylor(const series_type& at_middle, const series_type& over, const ball& h) {
  const int n = over.order();
  enclosed_function r{over[n] * pow(h, n), n * over[n] * pow(h, n - 1)};
  for (int k = n - 1; k >= 0; --k) {
    r.value += at_middle[k] * pow(h, k);
    if (k >= 1) r.slope += k * at_middle[k] * pow(h, k - 1);
  }
  const auto cut = [](const ball& plain, const ball& formula) {
    if (formula.is_undefined()) return plain;
    const ball both = intersection(plain, formula);
    return both.is_undefined() ? plain : both;
  };
  return {cut(over[0], r.value), cut(over[1], r.slope)};
}

ball slope_over(const function_evaluator& e, const ball& x, const real_function& f) {
  ball plain = e.derivative(x);
  if (plain.is_undefined() || !contains_zero(plain)) return plain;
  const int n = f.best_order();
  const ball middle = x.middle();
  const series_type over = e.series(x, n);
  if (over[n].is_undefined()) return plain;
  return taylor(e.series(middle, n), over, x - middle).slope;
}

}  // namespace polhode::detail
