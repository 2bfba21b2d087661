#pragma once

#include "polhode/certificate/certificate.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"

namespace polhode::proofs {

/// Adds to a witness what repeats a plan of the trapezoidal rule: the rule's name and, where there
/// is a plan, "nodes", "half_width" of the strip as an exact rational, and "supremum" and
/// "truncation_error" as decimals rounded upward.
void add_periodic_plan(json& witness, const periodic_plan& plan);

}  // namespace polhode::proofs
