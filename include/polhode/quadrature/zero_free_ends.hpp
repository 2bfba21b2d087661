#pragma once

// Where a formula has no zero near a point or near infinity, proved by how fast it grows there.

#include <memory>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {

/// Of one formula in one variable. Several threads may ask at a time.
///
/// Near the point the formula is evaluated over functions v(t) that are known by c t^a <= |v(t)| <=
/// C t^b for 0 < t <= 1/4, and by their series where they have one. With c > 0 there is no zero.
class zero_free_ends {
 public:
  explicit zero_free_ends(expression f);

  /// Proved: f has no zero x with at < x <= at + width, or at + width <= x < at where width is
  /// negative; it may be undefined there.
  [[nodiscard]] bool beside(const pi_combination& at, const rational& width) const;
  /// Proved: f has no zero x >= from, or x <= from where from is negative; it may be undefined
  /// there.
  [[nodiscard]] bool beyond(const rational& from) const;
  /// Proved: the integral of f over x >= from, or x <= from where from is negative, has no limit
  /// where it is improper. By a lower bound of |f| where f has one sign; or f oscillates with an
  /// amplitude that is away from 0.
  [[nodiscard]] bool diverges_beyond(const rational& from) const;
  /// The sign, 1 or -1, that f is proved to have at all x >= from, or x <= from where from is
  /// negative, where it is then defined; 0 where none is proved.
  [[nodiscard]] int sign_beyond(const rational& from) const;
  /// 1 or -1 where f, which is defined at all x >= from > 0, is proved to tend to infinity or
  /// -infinity for x -> inf; likewise for x <= from < 0; 0 where neither is proved.
  [[nodiscard]] int infinite_limit_beyond(const rational& from) const;

 private:
  struct formula;
  std::shared_ptr<formula> formula_;
};

}  // namespace polhode
