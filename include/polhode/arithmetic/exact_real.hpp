#pragma once

// A real number of which every digit can be had: rational, or irrational and known by its
// enclosures.

#include <compare>
#include <concepts>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode {

/// Sums, differences, products and quotients of rational numbers are done exactly. With an
/// irrational number among the operands the result is computed when it is asked for, and to the
/// digits asked for: what cancels is made up by more bits.
class exact_real {
 public:
  template <class Q>
  requires std::same_as<std::remove_cvref_t<Q>, rational>
  // NOLINTNEXTLINE(google-explicit-constructor,bugprone-forwarding-reference-overload): exact
  exact_real(Q&& q) : rational_(std::forward<Q>(q)) {}
  template <machine_integer N>
  exact_real(N n)  // NOLINT(google-explicit-constructor): exact
      : rational_(rational(n)) {}

  /// An irrational number by its enclosures: enclose(p) holds it, and is narrower the greater p is,
  /// as 2^-p in the end. It may be called on several threads at once. `size` is what size_in_bits
  /// returns.
  [[nodiscard]] static exact_real irrational(std::function<ball(precision)> enclose,
                                             precision size);

  /// The rational number that it is known to be.
  [[nodiscard]] const std::optional<rational>& as_rational() const { return rational_; }
  [[nodiscard]] bool is_rational() const { return rational_.has_value(); }
  /// The same; throws std::logic_error where it is not known to be one.
  [[nodiscard]] const rational& exact() const;

  /// The number to p bits: with a relative radius below 2^-p but for the last rounding. Undefined
  /// where that takes more than most_bits, as of an irrational number less an equal one that was
  /// computed otherwise.
  [[nodiscard]] ball at(precision p) const { return at(p, most_bits); }
  static constexpr precision most_bits = 1L << 20;
  /// The sign: of an irrational number never 0. Throws std::domain_error where so many bits do not
  /// decide, as of a number that is 0 and not known to be rational.
  [[nodiscard]] int sign(precision most = most_bits) const;

  friend exact_real operator+(const exact_real& x, const exact_real& y);
  friend exact_real operator-(const exact_real& x, const exact_real& y);
  friend exact_real operator*(const exact_real& x, const exact_real& y);
  /// Throws std::domain_error for y = 0.
  friend exact_real operator/(const exact_real& x, const exact_real& y);
  friend exact_real operator-(const exact_real& x) {
    return x.rational_ ? exact_real(rational(-*x.rational_)) : 0 - x;
  }

  /// Beside a ball it is taken to the ball's precision.
  friend ball operator+(const exact_real& x, const ball& y) { return x.at(y.precision()) + y; }
  friend ball operator+(const ball& x, const exact_real& y) { return x + y.at(x.precision()); }
  friend ball operator-(const exact_real& x, const ball& y) { return x.at(y.precision()) - y; }
  friend ball operator-(const ball& x, const exact_real& y) { return x - y.at(x.precision()); }
  friend ball operator*(const exact_real& x, const ball& y) { return x.at(y.precision()) * y; }
  friend ball operator*(const ball& x, const exact_real& y) { return x * y.at(x.precision()); }
  friend ball operator/(const exact_real& x, const ball& y) { return x.at(y.precision()) / y; }
  friend ball operator/(const ball& x, const exact_real& y) { return x / y.at(x.precision()); }

  /// By the sign of the difference.
  friend bool operator==(const exact_real& x, const exact_real& y);
  friend std::strong_ordering operator<=>(const exact_real& x, const exact_real& y);
  template <std::same_as<rational> Q>
  friend std::strong_ordering operator<=>(const exact_real& x, const Q& q) {
    return x.compare(q) <=> 0;
  }

  /// About how many bits the number takes: of a rational one size_in_bits, of others a measure of
  /// what may cancel in sums of it, by what it was made with.
  friend precision size_in_bits(const exact_real& x);

 private:
  struct irrational_number;
  explicit exact_real(std::shared_ptr<const irrational_number> x) : irrational_(std::move(x)) {}
  template <class Operation>
  static exact_real combined(const exact_real& x, const exact_real& y, const Operation& operation);
  /// A number with the sign of the difference from q.
  [[nodiscard]] int compare(const rational& q) const;
  [[nodiscard]] ball at(precision p, precision most) const;
  /// With what cancels.
  [[nodiscard]] ball rough(precision p) const;

  std::optional<rational> rational_;
  std::shared_ptr<const irrational_number> irrational_;
};

/// x where it is rational, and else a rational number of so many bits, at most 32, below it by less
/// than |x| 2^(2-bits).
[[nodiscard]] rational rational_below(const exact_real& x, unsigned bits);

/// A quotient, or the first twelve digits.
[[nodiscard]] std::string to_text(const exact_real& x);
std::ostream& operator<<(std::ostream& out, const exact_real& x);

}  // namespace polhode
