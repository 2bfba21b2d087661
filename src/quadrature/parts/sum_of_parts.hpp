#pragma once

// An integral as a sum of others.

#include <functional>
#include <optional>
#include <vector>

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The sum of the parts and of a number of at most `rest` in size, first to few digits for its
/// size, then to what it needs. Returns nullopt where a part has no enclosure, or the goal is not
/// met with twice the digits.
[[nodiscard]] std::optional<integral> sum_to_goal(const std::vector<part>& parts,
                                                  const integrate_options& options,
                                                  const magnitude& rest = {});

/// The integral beyond `start`: that of the parts, but for a number of at most `rest` in size.
struct known_tail {
  end_point start;
  std::vector<part> parts;
  magnitude rest = {};
};
/// The tail of f to the infinity of sign `side`, from a start with side * start >= from. None where
/// it is not known.
using tail_finder = std::function<std::optional<known_tail>(const rational& from, int side)>;

/// The integral over [a, b], a < b, by `tail` at its infinite ends, and by `integrate_function`
/// between them. Returns nullopt where a tail is not known, or the sum is not found to the goal.
[[nodiscard]] std::optional<integral> integrate_with_tails(const integrand& f, const end_point& a,
                                                           const end_point& b,
                                                           const tail_finder& tail,
                                                           const integrate_options& options);

}  // namespace polhode::detail
