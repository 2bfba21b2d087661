#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "polhode/arithmetic/polynomial.hpp"
#include "roots/settled_pieces.hpp"

namespace polhode::detail {

/// The real roots of a polynomial without multiple roots, told apart.
struct separated_roots {
  std::vector<rational> exact;  // the rational ones, in ascending order
  std::vector<integer> rest;    // p without its rational roots
  /// Brackets in ascending order, which may have ends in common. Each holds exactly one root of
  /// `rest`, between its ends; outside of them `rest` has no real root.
  std::vector<exact_interval> brackets;
  long steps = 0;
};

/// By continued fractions; see real_roots.cpp. std::nullopt where go_on, which is called at every
/// step, returned false. Hypothesis: p is not 0 and has no multiple root.
[[nodiscard]] std::optional<separated_roots> separate_real_roots(
    const rational_polynomial& p, const std::function<bool()>& go_on);

}  // namespace polhode::detail
