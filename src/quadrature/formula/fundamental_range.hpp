#pragma once

// Ranges over which a function is periodic, or even about both ends.

#include <optional>

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// A part [a, b] of a range whose 2^log2_copies copies have the integral over the whole range, and
/// of which f has the symmetry that the rule needs: even about a and about b, or of period b - a.
struct fundamental_range {
  pi_combination a;
  pi_combination b;
  long log2_copies = 0;
};

/// Nothing where no symmetry was found. The limits must be known as q + r pi.
[[nodiscard]] std::optional<fundamental_range> fundamental_range_of(const integrand& f,
                                                                    const end_point& a,
                                                                    const end_point& b);

}  // namespace polhode::detail
