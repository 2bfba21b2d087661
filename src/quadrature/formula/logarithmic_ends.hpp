#pragma once

// An antiderivative G in s = -log x at the ends of a range of x >= 0.

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode::detail {

/// The end is 0 or infinity, where G is a limit.
[[nodiscard]] inline bool is_limit_of_logarithm(const end_point& x) {
  return x.is_infinite() || x.exact() == rational(0);
}
/// Every number between the end and a positive one is positive.
[[nodiscard]] inline bool is_right_of_zero(const end_point& x) {
  constexpr precision few = 64;
  if (x.is_infinite()) return x.infinite_sign() > 0;
  return x.exact() == rational(0) || certainly_positive(x.at(few));
}
/// G has a value at the end, or the limit 0.
[[nodiscard]] inline bool reaches(const expression::logarithmic_antiderivative& g,
                                  const end_point& x) {
  if (!is_limit_of_logarithm(x)) return true;
  return x.is_infinite() ? g.vanishes_at_infinity : g.vanishes_at_zero;
}

}  // namespace polhode::detail
