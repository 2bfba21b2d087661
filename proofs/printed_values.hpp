#pragma once

// The numbers that the paper prints, and the true ones.

#include <string>
#include <vector>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/certificate/certificate.hpp"
#include "polhode/rigid_body/body.hpp"

namespace polhode::proofs {

/// A decimal as printed, what the paper says it is, and the number itself.
struct printed_number {
  std::string where;    // "figure 6"
  std::string what;     // "I for a = 39.95, b = 0.0629"
  std::string printed;  // "0.59"
  int places = 0;       // decimals that it claims: 2
  enclosing_function value;
};

/// The printed numbers that are right, in the order of the paper.
[[nodiscard]] const std::vector<printed_number>& right_numbers();
/// Those that are not.
[[nodiscard]] const std::vector<printed_number>& wrong_numbers();

/// Whether the number printed is the true one rounded to its decimals: |printed - value| is at most
/// half a unit of the last place.
enum class rounding { right, wrong, undecided };
[[nodiscard]] rounding check_rounding(const std::string& printed, int places, const ball& value);

/// The number printed, and beside it how it is read where it has fewer places than it claims: "1
/// (read as 1.000, ...)".
[[nodiscard]] std::string as_read(const std::string& printed, int places);

/// Adds each of them as a number with `digits` digits, and the fact that it is right, or wrong, as
/// expected.
void add_printed_numbers(certificate& c, const std::vector<printed_number>& numbers,
                         rounding expected, long digits);

/// The body with these a and b, as decimals or quotients.
[[nodiscard]] body with_ab(const std::string& a, const std::string& b);
/// The water molecule by the equilibrium rotational constants of section 8.
[[nodiscard]] body water_at_equilibrium();

}  // namespace polhode::proofs
