#pragma once

// A body's exact facts and constants, from a > 0 and 0 < b < 1.

#include <string>

#include "interval.hpp"

namespace polhode::checker {

struct body {
  rational a;
  rational b;

  /// I^2 = (1-b)^2/(b (a+b)), (J+1)^2 = (a+1)^2/(a (a+b)).
  [[nodiscard]] rational squared_I() const { return (1 - b) * (1 - b) / (b * (a + b)); }
  [[nodiscard]] rational squared_J_plus_1() const { return (a + 1) * (a + 1) / (a * (a + b)); }
  [[nodiscard]] interval I(precision bits) const { return sqrt(interval(squared_I(), bits)); }
  [[nodiscard]] interval J(precision bits) const {
    return sqrt(interval(squared_J_plus_1(), bits)) - interval(rational(1), bits);
  }
  /// q > I, q > J.
  [[nodiscard]] bool is_above_I(const rational& q) const { return q > 0 && q * q > squared_I(); }
  [[nodiscard]] bool is_above_J(const rational& q) const {
    return q > -1 && (q + 1) * (q + 1) > squared_J_plus_1();
  }
  /// -1, 0, 1 where the body is not physical, planar, physical: the sign of 1 - ab - 2b.
  [[nodiscard]] int kind() const {
    const rational excess(1 - a * b - 2 * b);
    return excess > 0 ? 1 : excess < 0 ? -1 : 0;
  }
  [[nodiscard]] std::string kind_in_words() const {
    return kind() > 0 ? "physical" : kind() < 0 ? "non-physical" : "planar";
  }
  /// The number of whole k >= 1 with k < 1/I, and with k < 1/I + 1/2.
  [[nodiscard]] integer crossings() const { return greatest_below(rational(1 / squared_I())); }
  [[nodiscard]] integer intersections() const {
    return (greatest_below(rational(4 / squared_I())) + 1) / 2;
  }

 private:
  /// The greatest whole n >= 0 with n^2 < q, q > 0.
  static integer greatest_below(const rational& q) {
    return floor_root(ceiling_quotient(numerator(q), denominator(q)) - 1);
  }
};

}  // namespace polhode::checker
