#pragma once

// The proof that the parts of a box of parameters are all of it.

#include <vector>

#include "quadrature/boxes/parametric_integrand.hpp"

namespace polhode::detail {

/// Throws std::logic_error unless the parts make up the box, each point of it in one part or on the
/// common face of parts.
///
/// Proved by cutting, in exact arithmetic: one part is all of the box where it is equal to it. More
/// parts are where a plane through the box passes through none of them and those on either side
/// make up that side. Parts that come of bisections always have such a plane; others are refused,
/// be they a tiling or not.
void expect_box_tiling(const parameter_box& whole, const std::vector<const parameter_box*>& parts);

}  // namespace polhode::detail
