#pragma once

// What a certificate of a formula may hold, so that a checker knows it, and its numbers
// (docs/certificates.md).

#include <optional>
#include <string>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode::detail {

inline constexpr std::size_t most_roots = 1000;
inline constexpr long most_digits_of_roots = 15'000;

/// Throws input_error where a checker does not know what the formula is made of, or it is too long;
/// `what` names it.
void expect_known(const expression& f, const char* what);
/// The checker refuses a variable that a reader takes for a constant, a function or a number: "Pi",
/// "e", "l".
void expect_plain_variable(const std::string& name);
void expect_at_most(long most, long digits, const char* what);

[[nodiscard]] rational power_of_two(long k);
/// About log2 of the greatest |x|; nothing for {0}.
[[nodiscard]] std::optional<double> log2_of(const ball& x);
/// k with 2^k about 10^-(digits+2) of the size of x (of `size`, as a power of two, where x may be
/// 0), and not below x's radius.
[[nodiscard]] long widening(const ball& x, double size, long digits);
/// x with 2^k more on both sides.
[[nodiscard]] ball widened(const ball& x, long k, long digits);
/// A rational number with a short denominator between two that are not equal.
[[nodiscard]] rational short_between(const rational& lower, const rational& upper);

}  // namespace polhode::detail
