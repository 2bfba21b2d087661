#pragma once

// The numbers q + r pi with rational q and r. As pi is irrational (J. H. Lambert, 1761), such a
// number is 0 only where q and r are, and two of them are equal only where both parts are.

#include <optional>
#include <string>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode {

struct pi_combination {
  rational q = 0;
  rational r = 0;

  [[nodiscard]] bool is_zero() const { return q == 0 && r == 0; }
  [[nodiscard]] bool is_rational() const { return r == 0; }
  /// An enclosure with p bits.
  [[nodiscard]] ball at(precision p) const;

  friend pi_combination operator-(const pi_combination& x) { return {-x.q, -x.r}; }
  friend pi_combination operator+(const pi_combination& x, const pi_combination& y) {
    return {x.q + y.q, x.r + y.r};
  }
  friend pi_combination operator-(const pi_combination& x, const pi_combination& y) {
    return {x.q - y.q, x.r - y.r};
  }
  friend pi_combination operator*(const pi_combination& x, const rational& k) {
    return {x.q * k, x.r * k};
  }
  friend bool operator==(const pi_combination& x, const pi_combination& y) {
    return x.q == y.q && x.r == y.r;
  }
};

/// The least positive number that is a whole multiple of both periods. None where there is no such
/// number, or one of them is neither rational nor a rational multiple of pi. Hypothesis: both are
/// positive.
[[nodiscard]] std::optional<pi_combination> common_period(const pi_combination& x,
                                                          const pi_combination& y);

/// "1/2 + 2*pi", "-pi", "2/3*pi", "3".
[[nodiscard]] std::string to_text(const pi_combination& x);

}  // namespace polhode
