#pragma once

#include "polhode/roots/newton.hpp"

namespace polhode::proofs {

/// The root of f(x) = agm(sqrt(1+x), sqrt(x)) - 1/2, which is the paper's beta, to a radius of
/// about 2^-p: interval Newton from an approximate root found in hardware arithmetic. Verdict
/// unique: exactly one root in its box. (f increases on x > 0, as the mean increases in both
/// arguments, so it is the only one.)
[[nodiscard]] root_enclosure enclose_beta(precision p);

}  // namespace polhode::proofs
