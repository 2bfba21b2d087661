#pragma once

// Nodes and weights from the proved zeros of q: the nodes are their square roots, and the weights
// follow from the slopes of q there.

#include <cstdint>
#include <optional>
#include <vector>

#include "polhode/quadrature/gauss_legendre.hpp"

namespace polhode::detail::legendre {

/// The rule from these starts, computed with bits_at_work; nothing where they do not suffice.
[[nodiscard]] std::optional<gauss_legendre_rule> rule_with(
    long n, precision bits, precision bits_at_work, const std::vector<std::uint64_t>& starts);

/// x with `bits` bits and a radius of 2^-bits, or of 2^-bits times the power of two above x:
/// nothing where that is no enclosure. All that distinguishes the balls of a rule is then their
/// midpoints.
[[nodiscard]] std::optional<ball> with_radius(const ball& x, precision bits, bool relative);

}  // namespace polhode::detail::legendre
