#pragma once

// The motions at which a curve over c is computed.

#include <algorithm>
#include <optional>
#include <vector>

#include "polhode/rigid_body/body.hpp"

namespace polhode {

/// The middles of `points` equal parts of a range of c, without one of [-b, min(a, b)]: neither
/// end, where there may be nothing to compute, is among them.
[[nodiscard]] inline std::vector<rational> curve_motions(
    const body& rigid, const std::optional<std::array<rational, 2>>& range, long points) {
  // Numbers of a few bits just within irrational ends.
  constexpr unsigned few_bits = 16;
  const rational low = range ? (*range)[0] : rational(-rational_below(rigid.b(), few_bits));
  const rational high =
      range ? (*range)[1]
            // Irrational a and b may be equal, which no enclosure would decide.
            : std::min(rational_below(rigid.a(), few_bits), rational_below(rigid.b(), few_bits));
  std::vector<rational> result;
  result.reserve(static_cast<std::size_t>(points));
  for (long k = 0; k < points; ++k)
    result.emplace_back(low + (high - low) * (2 * k + 1) / (2 * points));
  return result;
}

}  // namespace polhode
