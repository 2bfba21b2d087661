#pragma once

// The witness of a bracket of beta, the root of agm(sqrt(1+x), sqrt(x)) = 1/2, as whole numbers:
// rounded steps of the arithmetic-geometric mean that multiplications and comparisons check.

#include <optional>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/certificate/certificate.hpp"

namespace polhode {

/// {"kind": "agm_bracket", "scale": S, "below": {"argument": n, "start": [A, B], "steps": [[A',
/// B'], ...]}, "above": ...}, whole numbers as decimal strings. "below" are pairs rounded upward
/// from x = n/S = lower: A^2 >= (S+n) S, B^2 >= n S, 2 A' >= A + B, B'^2 >= A B, and at the end 2A
/// < S and 2B < S, so that the mean is below 1/2 and lower < beta. "above" is the reverse, from x =
/// upper. Made in whole numbers from the two ends alone, so that it proves the bracket by itself.
/// Nothing where the steps don't decide it at 128 bits more than the ends have. Hypotheses: 0 <
/// lower < upper, dyadic numbers.
[[nodiscard]] std::optional<json> agm_bracket_witness(const rational& lower, const rational& upper);

}  // namespace polhode
