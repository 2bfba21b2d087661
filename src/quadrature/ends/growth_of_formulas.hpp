#pragma once

// What growth bounds have under other names than those of a formula's functions, or by way of other
// functions. Every source that evaluates a formula over growth bounds includes this: without it the
// same template would be another function there.

#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/expression/evaluation.hpp"
#include "quadrature/ends/growth_bound.hpp"

namespace polhode::detail {

template <>
struct supplement<growth_bound> {
  static growth_bound sinpi(const growth_bound& x) { return sin(x * half_turn(x)); }
  static growth_bound cospi(const growth_bound& x) { return cos(x * half_turn(x)); }
  static growth_bound expm1(const growth_bound& x) { return exp(x) - x.constant_like(rational(1)); }
  static growth_bound log1p(const growth_bound& x) { return log(x + x.constant_like(rational(1))); }
  static growth_bound sinh(const growth_bound& x) {
    return (exp(x) - exp(-x)) * x.constant_like(rational(1, 2));
  }
  static growth_bound cosh(const growth_bound& x) {
    return (exp(x) + exp(-x)) * x.constant_like(rational(1, 2));
  }
  static growth_bound hypot(const growth_bound& x, const growth_bound& y) {
    return sqrt(x * x + y * y);
  }
  template <class F, class Range>
  static growth_bound further(const F& f, const Range& x) {
    std::vector<ball> values;
    values.reserve(x.size());
    for (const growth_bound& v : x) {
      if (v.is_blocked())
        return v.is_nowhere_defined() ? v : growth_bound::blocked(name_of_function(f));
      values.push_back(v.values());
    }
    const growth_bound& any = x.front();
    return any.bounded_like(name_of_function(f), f.value(values));
  }

 private:
  static growth_bound half_turn(const growth_bound& x) {
    return x.constant_like(known_number(pi_combination{0, 1}));
  }
};

}  // namespace polhode::detail
