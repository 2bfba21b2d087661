#pragma once

// The checker's exact numbers: integers and rationals of GMP, and their decimals. The checker
// shares no mathematics with the prover (docs/certificates.md), so these are types of its own.

#include <string>
#include <string_view>

#include <boost/multiprecision/gmp.hpp>

#include "budget.hpp"

namespace polhode::checker {

using integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

[[nodiscard]] integer floor_quotient(const integer& n, const integer& d);    // d > 0
[[nodiscard]] integer ceiling_quotient(const integer& n, const integer& d);  // d > 0
/// floor(n / 2^k), ceil(n / 2^k); k >= 0.
[[nodiscard]] integer floor_shift(const integer& n, long k);
[[nodiscard]] integer ceiling_shift(const integer& n, long k);
/// The greatest whole number whose square is at most n; n >= 0.
[[nodiscard]] integer floor_root(const integer& n);
[[nodiscard]] long bit_length(const integer& n);   // of |n|; 0 for 0
[[nodiscard]] long bit_length(const rational& q);  // of numerator and denominator together
[[nodiscard]] long words(const integer& n);        // of 64 bits
/// q = 2^k, k of any sign.
[[nodiscard]] rational power_of_two(long k);
[[nodiscard]] rational power_of_ten(long k);
/// The root of q where that is rational and q >= 0.
[[nodiscard]] bool exact_root(const rational& q, rational& root);

/// Reads "-12", digits with no leading zero; false for anything else.
[[nodiscard]] bool read_integer(std::string_view text, integer& value);
/// Reads "3" or "-253/20" in lowest terms with a positive denominator; false for anything else.
[[nodiscard]] bool read_rational(std::string_view text, rational& value);
/// Reads "-0.028", "1.5e-20"; false for anything else, and for an exponent of more than 6 digits.
[[nodiscard]] bool read_decimal(std::string_view text, rational& value);
/// At least the bits that such a decimal's value and the powers of ten in it have.
[[nodiscard]] long bits_of_decimal(std::string_view text);

enum class rounding { down, up, to_zero };

/// q to so many significant digits: positional where that is short, otherwise "1.5e-20". Rounded
/// down and up it drops zeros at the end, cut off it keeps them: they are digits.
[[nodiscard]] std::string decimal(const rational& q, long digits, rounding way, budget& work);
/// "1.414...": cut off, with dots where q has more digits.
[[nodiscard]] std::string decimal_for_reading(const rational& q, long digits, budget& work);

}  // namespace polhode::checker
