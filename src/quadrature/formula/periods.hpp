#pragma once

// A range that holds many periods of a function.

#include <optional>

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The integral of f over the range is `count` times that from its lower end to first_end, plus
/// that from the lower end to rest_end: f has the period first_end - (lower end) > 0 (proved by f's
/// symmetry, see symmetry.hpp), and rest_end is the upper end less count periods. Not less than the
/// lower end, and nullopt where it is that for certain.
struct whole_periods {
  integer count;
  end_point first_end;
  std::optional<end_point> rest_end;
};

/// Nothing where the range from a to b holds fewer than 64 periods, or none was found.
[[nodiscard]] std::optional<whole_periods> whole_periods_of(const integrand& f, const end_point& a,
                                                            const end_point& b);

}  // namespace polhode::detail
