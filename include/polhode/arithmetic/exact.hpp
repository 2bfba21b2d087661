#pragma once

// Exact integers and rationals, and reading them from text.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <boost/multiprecision/gmp.hpp>

#include "polhode/arithmetic/ball.hpp"

namespace polhode {

/// Without expression templates: `auto x = a + b` is a number, as it reads.
using integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

/// What a user gave cannot be used; what() says what was given and what would be right.
class input_error : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Limits of a number given as text: they keep a short text from asking for gigabytes.
inline constexpr std::size_t longest_number_text = 200'000;
inline constexpr long greatest_decimal_exponent = 200'000;

/// Reads a decimal ("0.0629", "-1e-300", "18.125") or a quotient of two ("1/4", "-2.5e3/7")
/// exactly. Throws input_error for anything else ("nan", "1e", "", "0x1", "1/0"), for texts longer
/// than longest_number_text and exponents beyond greatest_decimal_exponent.
[[nodiscard]] rational parse_rational(std::string_view text);

/// Reads a decimal or rational text to its enclosure with p bits.
[[nodiscard]] ball parse_ball(std::string_view text, precision p);

/// The rational as text: "629/10000", or "3" where it is an integer.
[[nodiscard]] std::string to_text(const rational& q);

/// A type that Boost converts to a rational in silence, and that is no number.
template <class N>
concept no_number_at_all = std::is_enum_v<N> || std::same_as<N, bool>;

/// An enumerator is no number: of one without a text of its own there is none.
template <no_number_at_all N>
std::string to_text(N) = delete;

/// The greatest integer that is at most q, and the least that is at least q.
[[nodiscard]] integer floor_of(const rational& q);
[[nodiscard]] integer ceil_of(const rational& q);

/// The rational number with the least denominator in [lower, upper], and the least numerator of
/// these (by continued fractions). Hypothesis: lower <= upper.
[[nodiscard]] rational simplest_between(const rational& lower, const rational& upper);
/// The same, or std::nullopt where its continued fraction has more than so many terms.
[[nodiscard]] std::optional<rational> simplest_between(const rational& lower, const rational& upper,
                                                       int most_terms);

/// The real n-th root where it is a rational number, n >= 1.
[[nodiscard]] std::optional<rational> exact_root(const rational& q, unsigned long n);

/// The end points of a bounded ball as rationals: both are dyadic numbers, so nothing is lost (but
/// that a radius below 2^-64 of the midpoint's last place counts as so much, outward).
/// Throws std::domain_error where the ball is not bounded.
[[nodiscard]] rational lower_rational(const ball& x);
[[nodiscard]] rational upper_rational(const ball& x);

}  // namespace polhode
