#pragma once

// Nodes and weights from the proved zeros of q: the nodes are their square roots, and the weights follow from the slopes
// of q there.

#include <cstdint>
#include <optional>
#include <vector>

#include "polhode/quadrature/gauss_legendre.hpp"

namespace polhode::detail::legendre {

/// The rule from these starts, computed with bits_at_work; nothing where they do not suffice.
[[nodiscard]] std::optional<gauss_legendre_rule> rule_with(
    long n, precision bits, precision bits_at_work, const std::vector<std::uint64_t>& starts);

}  // namespace polhode::detail::legendre
