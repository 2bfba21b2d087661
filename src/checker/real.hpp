#pragma once

// A real number of which every digit can be had: rational, or irrational and known by its
// enclosures. Operations on rational numbers are exact.

#include <compare>
#include <concepts>
#include <functional>
#include <memory>
#include <string>

#include "interval.hpp"

namespace polhode::checker {

class real {
 public:
  real(rational q) : rational_(std::move(q)) {}  // NOLINT(google-explicit-constructor): exact
  template <std::integral N>
  real(N n) : rational_(n) {}  // NOLINT(google-explicit-constructor): exact
  /// An irrational number: enclose(bits) holds it, and is narrower the more bits are asked for. It
  /// may throw undecided where these are too few. `size` is what bit_length returns, and `work` is
  /// charged where no precision is given.
  static real irrational(std::function<interval(precision bits)> enclose, long size, budget& work);

  [[nodiscard]] bool is_rational() const { return irrational_ == nullptr; }
  /// Hypothesis: is_rational().
  [[nodiscard]] const rational& exact() const { return rational_; }
  /// What is charged where no precision is given. Hypothesis: it is not rational.
  [[nodiscard]] budget& work() const;
  /// An enclosure of a few units 2^-bits. Throws undecided where it takes too many bits.
  [[nodiscard]] interval at(precision bits) const;
  /// Of an irrational number never 0; throws undecided where it takes too many bits.
  [[nodiscard]] int sign() const;

  friend real operator+(const real& x, const real& y);
  friend real operator-(const real& x, const real& y);
  friend real operator*(const real& x, const real& y);
  /// Hypothesis: y is not 0.
  friend real operator/(const real& x, const real& y);
  friend real operator-(const real& x) { return 0 - x; }
  friend bool operator==(const real& x, const real& y) { return (x - y).sign() == 0; }
  friend std::strong_ordering operator<=>(const real& x, const real& y) {
    return (x - y).sign() <=> 0;
  }

  /// Of a rational number its bits; of another a measure of what may cancel in sums of it.
  friend long bit_length(const real& x);
  /// decimal_for_reading, of an irrational number cut off.
  friend std::string decimal_for_reading(const real& x, long digits, budget& work);

 private:
  struct number;
  template <class Operation>
  static real combined(const real& x, const real& y, const Operation& operation);
  /// At these bits, however wide.
  [[nodiscard]] interval rough(precision bits) const;

  rational rational_;
  std::shared_ptr<const number> irrational_;
};

/// The greatest whole number whose square is below x > 0.
[[nodiscard]] integer greatest_with_square_below(const real& x);

/// x and x, or for an irrational x > 0 the n/2^k < x < (n + 1)/2^k with n of 64 bits.
struct rational_neighbours {
  rational lower;
  rational upper;
};
[[nodiscard]] rational_neighbours neighbours_of(const real& x);

}  // namespace polhode::checker
