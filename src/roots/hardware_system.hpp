#pragma once

// A system of equations in hardware doubles: cuts boxes down in a few microseconds.

#include <cstddef>
#include <optional>
#include <vector>

#include "contraction.hpp"
#include "polhode/arithmetic/double_interval.hpp"

namespace polhode::detail {

class hardware_system {
 public:
  using box = std::vector<double_interval>;

  explicit hardware_system(const std::vector<expression>& components);

  enum class outcome {
    empty,    // no root lies in the box
    regular,  // the Jacobians over the box, times a matrix, are near the identity, or nothing is
              // known of them: steps with more bits may prove a root
    wide      // they are not: the box is to be cut in two
  };
  /// Cuts the box down: by each equation, as long as that helps, then by Newton's method with all
  /// of them. Every root of the system in it, a point at which all components are defined and 0, is
  /// in what is left.
  ///
  /// By Newton: let m lie in the box X and J hold the Jacobians on X. For a root x in X, row by row
  /// by the mean value theorem, 0 = f(m) + A (x - m) with an A in J; so that row has an enclosure
  /// with 0 in it, and, for any matrix Y, 0 = Y f(m) + Y A (x - m), each row of which is solved for
  /// its component of x with the others in X (E. Hansen, S. Sengupta, Bounding solutions of systems
  /// of equations using interval analysis, BIT 21 (1981)).
  [[nodiscard]] outcome cut(box& x);

  /// The variable in whose direction to cut a box that cut() found wide: the one with the greatest
  /// share of the equations' change over the box, by their derivatives, in sum over the equations.
  /// None where the derivatives are not known.
  [[nodiscard]] std::optional<std::size_t> direction(const box& x) const;

  [[nodiscard]] long evaluations() const { return evaluations_; }

 private:
  [[nodiscard]] bool contract(box& x);
  [[nodiscard]] outcome newton(box& x);
  [[nodiscard]] bool invert();

  std::vector<contraction> equations_;
  std::vector<box> jacobian_;
  std::vector<double> inverse_;  // near that of the Jacobian's midpoints, row by row
  long evaluations_ = 0;
};

}  // namespace polhode::detail
