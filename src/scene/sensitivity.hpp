#pragma once

// The derivatives of the period and the Montgomery phase, of one motion and over ranges of motions.

#include <optional>
#include <vector>

#include "polhode/scene/effects.hpp"
#include "scene/motion.hpp"

namespace polhode::detail {

/// A motion; or, with balls, all motions whose numbers lie in them.
template <class Number>
struct sensitivity_point {
  struct vectors_known {
    triple<Number> moments;
    triple<Number> direction_squares;  // of J
  };
  Number a, b, c;  // c > 0 where it rotates, < 0 else
  bool rotating = false;
  std::optional<vectors_known> vectors;  // where the angular momentum is known
};

/// dT_da and the others in the order of the documentation, each with its unit: T in I_y/J, the
/// phase in rad. Undefined where an enclosure is not bounded.
template <class Number>
[[nodiscard]] std::vector<effect_number> derivatives_at(const sensitivity_point<Number>& of,
                                                        precision p);

}  // namespace polhode::detail
