#pragma once

#include <vector>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail {

/// The number u = (re + i im) 2^-bits with |u| <= 1, but for rounding, or its reciprocal: so a
/// number of any size is kept exactly.
struct fixed_point {
  integer re;
  integer im;
  bool is_reciprocal = false;
};

/// A number in units of 2^-bits, and a bound of its error in these units.
struct fixed_value {
  integer re;
  integer im;
  magnitude error;

  [[nodiscard]] magnitude abs_upper() const;
  [[nodiscard]] magnitude abs_lower() const;
};

/// A polynomial p with integer coefficients and degree n >= 1 at complex points, in fixed-point
/// arithmetic with so many bits behind the point.
class complex_values {
 public:
  explicit complex_values(std::vector<integer> p) : p_(std::move(p)) {}

  /// p(u) and p'(u); of a reciprocal 1/u the values s(u) and s'(u) of the polynomial s with the
  /// coefficients in the reverse order: p(1/u) = u^-n s(u).
  struct values {
    fixed_value value;
    fixed_value slope;
  };
  [[nodiscard]] values at(const fixed_point& x, long bits);

  /// A bound of |p(x)| from above.
  [[nodiscard]] magnitude value_bound(const fixed_point& x, const values& v, long bits) const;

  [[nodiscard]] long degree() const { return static_cast<long>(p_.size()) - 1; }
  [[nodiscard]] const std::vector<integer>& coefficients() const { return p_; }

 private:
  std::vector<integer> p_;
  std::vector<integer> shifted_;  // times 2^shift_
  long shift_ = -1;
};

/// The point, enclosed with p bits.
[[nodiscard]] complex_ball to_ball(const fixed_point& x, long bits, precision p);

}  // namespace polhode::detail
