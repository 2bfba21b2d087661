#pragma once

#include <optional>

#include "polhode/roots/isolate.hpp"

namespace polhode::detail {

/// The roots of a formula that is 0 on intervals: in pieces, between the points where abs, min,
/// max, floor and ceil pass from one function to another. Nothing where there is no such interval,
/// or where those points are not known exactly.
[[nodiscard]] std::optional<root_set> roots_beside_zeros(const real_function& f,
                                                         const end_point& lower,
                                                         const end_point& upper,
                                                         const isolate_options& options);

}  // namespace polhode::detail
