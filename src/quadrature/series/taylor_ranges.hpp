#pragma once

// The finite ranges that a hyperexponential function is summed over by Taylor series, and bounds of
// what is left out.

#include <optional>
#include <vector>

#include "hyperexponential.hpp"
#include "taylor_panel.hpp"

namespace polhode::detail {

/// A part of a range, and a ball that holds its integral.
struct bounded_part {
  ball value;
  piece_done done;
  exact_interval within;
};
/// The finite ranges that a range is made up of, and what is left out.
struct finite_ranges {
  std::vector<smooth_range> ranges;
  std::vector<bounded_part> rests;
};

/// The ranges of an integral, for so many bits; without the function's constant.
[[nodiscard]] std::optional<finite_ranges> ranges_of(const hyperexponential_integral& part,
                                                     double bits);

}  // namespace polhode::detail
