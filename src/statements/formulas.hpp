#pragma once

// The texts of certificates of formulas that someone gave: an integral, all roots in a range, and
// all roots of a system in a box.

#include "statements/claim_text.hpp"

namespace polhode::statements {

inline constexpr std::string_view integral_claim = "integral";
inline constexpr const char* integral_statement =
    "The integral of the integrand over the range is between the ends of the number.";
inline constexpr const char* integral_formula = "integral from {} to {} of ({}) d{}";
inline constexpr const char* integral_method =
    "Fejer's first rule on pieces of the range, its error bounded by the integrand's supremum on "
    "an ellipse around each piece; computed in ball arithmetic.";
inline constexpr stated_text error_of_fejers_rule = cited(
    "The error of Fejer's rule for a function that is analytic and bounded on an ellipse "
    "(Trefethen).");

inline constexpr std::string_view roots_claim = "roots";
inline constexpr const char* roots_statement =
    "The formula is 0 at exactly {} points of the range, ends included: at one between the ends "
    "of each number, where its derivative is not 0.";
inline constexpr const char* roots_formula = "{} = 0 for {} <= {} <= {}";
inline constexpr const char* roots_method =
    "On each box the derivative is nowhere 0, and the formula changes its sign between the ends "
    "of the number in it; it is not 0 outside the boxes. Computed in ball arithmetic.";

inline constexpr std::string_view system_claim = "system";
inline constexpr const char* system_statement =
    "The formulas are all 0 at exactly {} points of the box, faces included: at one whose "
    "coordinates are between the ends of the numbers of each root, where the determinant of their "
    "derivatives is not 0.";
inline constexpr const char* system_formula = "{} for {}";
inline constexpr const char* equation_of_system = "{} = 0";
inline constexpr const char* side_of_system = "{} <= {} <= {}";
inline constexpr const char* system_method =
    "Krawczyk's operator maps the numbers of each root into themselves; on each box the matrix of "
    "derivatives is regular; outside the boxes one of the formulas, or of their linear "
    "combinations, is not 0. Computed in ball arithmetic.";
inline constexpr stated_text krawczyks_theorem = cited(
    "The zero in a box that Krawczyk's operator maps into its interior (R. Krawczyk, 1969; R. E. "
    "Moore, 1977).");

}  // namespace polhode::statements
