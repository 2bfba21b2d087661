#pragma once

// Polynomials with integer coefficients in the coordinate of a panel; that of z^k is at [k].

#include <utility>
#include <vector>

#include "polhode/arithmetic/double_interval.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/polynomial.hpp"

namespace polhode::detail {

using integers = std::vector<integer>;

/// content * (the polynomial with coprime integer coefficients), content > 0.
struct local_polynomial {
  integers coefficients;
  rational content;
};

/// p(c + r z), where all of p's coefficients are integers.
[[nodiscard]] local_polynomial at_panel(const rational_polynomial& p, const rational& c,
                                        const rational& r);

[[nodiscard]] integers product(const integers& p, const integers& q);
[[nodiscard]] integers derivative(const integers& p);
void multiply_by(integers& p, const integer& factor);
void add_to(integers& p, const integers& q);
/// Divides by z as often as that can be done; how often.
long without_zeros(integers& p);

/// x/y, y > 0.
[[nodiscard]] double_interval quotient(const integer& x, const integer& y);

/// The range of a polynomial over [low, high].
class polynomial_range {
 public:
  explicit polynomial_range(std::vector<double_interval> c) : c_(std::move(c)) {}
  [[nodiscard]] double_interval over(const double_interval& z) const {
    double_interval value(0);
    for (std::size_t k = c_.size(); k-- > 0;) value = value * z + c_[k];
    return value;
  }

 private:
  std::vector<double_interval> c_;
};

}  // namespace polhode::detail
