#pragma once

// The certificate of a map of counts and kinds: all its cells, for `polhode check`.

#include "map_grid.hpp"
#include "polhode/certificate/certificate.hpp"

namespace polhode::cli {

/// Throws usage_error unless the map is of cells of a and b, without motions, and of quantities
/// that rationals decide.
void expect_certifiable(const map_grid& g);
/// After expect_certifiable.
[[nodiscard]] json map_certificate(const map_grid& g);

}  // namespace polhode::cli
