#pragma once

// A body's exact facts and constants, from a > 0 and 0 < b < 1.

#include <memory>
#include <string>

#include "tensor.hpp"

namespace polhode::checker {

struct body {
  real a;
  real b;
  /// The tensor of which a and b are, where that is what was given.
  std::shared_ptr<const tensor> of = nullptr;

  /// I^2 = (1-b)^2/(b (a+b)), (J+1)^2 = (a+1)^2/(a (a+b)).
  [[nodiscard]] real squared_I() const {
    const auto known = of ? of->squared_I() : std::nullopt;
    return known ? real(*known) : (1 - b) * (1 - b) / (b * (a + b));
  }
  [[nodiscard]] real squared_J_plus_1() const {
    const auto known = of ? of->squared_J_plus_1() : std::nullopt;
    return known ? real(*known) : (a + 1) * (a + 1) / (a * (a + b));
  }
  [[nodiscard]] interval I(precision bits) const { return sqrt(squared_I().at(bits)); }
  [[nodiscard]] interval J(precision bits) const {
    return sqrt(squared_J_plus_1().at(bits)) - interval(rational(1), bits);
  }
  /// q > I, q > J.
  [[nodiscard]] bool is_above_I(const rational& q) const { return q > 0 && squared_I() < q * q; }
  [[nodiscard]] bool is_above_J(const rational& q) const {
    return q > -1 && squared_J_plus_1() < (q + 1) * (q + 1);
  }
  /// -1, 0, 1 where the body is not physical, planar, physical: the sign of 1 - ab - 2b.
  [[nodiscard]] int kind() const { return of ? of->kind() : (1 - a * b - 2 * b).sign(); }
  [[nodiscard]] std::string kind_in_words() const {
    return kind() > 0 ? "physical" : kind() < 0 ? "non-physical" : "planar";
  }
  /// The number of whole k >= 1 with k < 1/I, and with k < 1/I + 1/2.
  [[nodiscard]] integer crossings() const { return greatest_with_square_below(1 / squared_I()); }
  [[nodiscard]] integer intersections() const {
    return (greatest_with_square_below(4 / squared_I()) + 1) / 2;
  }
};

}  // namespace polhode::checker
