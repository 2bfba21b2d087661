#pragma once

#include "polhode/roots/newton.hpp"

namespace polhode::proofs {

/// The root of log(tan(x/2)) + pi near x = 0.086: the same number through log and tan in place of
/// exp and arctan. Its derivative is 1/sin x.
[[nodiscard]] root_enclosure epsilon0_min_by_logarithm(precision p);

}  // namespace polhode::proofs
