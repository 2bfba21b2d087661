#pragma once

// Ranges of a hyperexponential function, and the panels that they are cut into.

#include <algorithm>
#include <optional>
#include <vector>

#include "polhode/arithmetic/polynomial.hpp"
#include "tiling/tiling.hpp"

namespace polhode::detail {

/// A rational function's power, one factor of h.
struct smooth_factor {
  rational_polynomial base;
  rational exponent;  // 0: it must only be positive
};

/// P h over part of the line, with P and h as above: from lower to upper, both finite.
struct smooth_range {
  std::vector<smooth_factor> factors;
  rational_polynomial numerator;  // P
  rational_polynomial exponent;   // s
  rational_polynomial phase;      // t
  bool is_sine = false;           // the imaginary part is meant
  end_point lower = 0;
  end_point upper = 0;
  bool begins_at_0 = false;
  std::optional<rational> greatest;
  bool is_inverted = false;  // the line is that of 1/y

  /// Where it lies in the range of y that it was cut from, of which it keeps the ends that are not
  /// exact.
  [[nodiscard]] piece_done piece() const {
    const piece_end from = lower.exact() ? piece_end(*lower.exact()) : piece_end::lower_end();
    const piece_end to = upper.exact() ? piece_end(*upper.exact()) : piece_end::upper_end();
    if (!is_inverted) return {from, to};
    const auto inverse = [](const end_point& end, const piece_end& otherwise) {
      return end.exact() && *end.exact() != 0 ? piece_end(rational(1 / *end.exact())) : otherwise;
    };
    return {inverse(upper, piece_end::lower_end()), inverse(lower, piece_end::upper_end())};
  }
};

/// A panel: y = centre + radius z, -1 <= z <= 1 or, at an end, 0 <= z <= 1.
struct taylor_panel {
  rational centre;
  rational radius;  // negative where y falls as z grows
  bool at_end = false;
  bool from_lower = false;  // it is cut off at the range's lower, or upper, end, which is not exact
  bool to_upper = false;

  /// The values of y on the whole of it.
  [[nodiscard]] exact_interval interval() const {
    const rational other = at_end ? centre : rational(centre - radius);
    const rational end = centre + radius;
    return {std::min(other, end), std::max(other, end)};
  }
  /// What is to be integrated over.
  [[nodiscard]] piece_done piece() const {
    const exact_interval all = interval();
    return {from_lower ? piece_end::lower_end() : piece_end(*all.lower),
            to_upper ? piece_end::upper_end() : piece_end(*all.upper)};
  }
  [[nodiscard]] bool is_cut() const { return from_lower || to_upper; }
};

/// Those of the panels, which follow one another, that meet the range, with the ones that its ends
/// cut marked. Returns nullopt where it is not clear which those are.
[[nodiscard]] std::optional<std::vector<taylor_panel>> cut_to(
    const smooth_range& range, const std::vector<taylor_panel>& panels);

/// The two halves of a panel, in the order of y.
[[nodiscard]] std::vector<taylor_panel> halves_of(const taylor_panel& p);

}  // namespace polhode::detail
