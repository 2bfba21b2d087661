#pragma once

// What a formula tells of its roots in a box, in hardware doubles.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "polhode/arithmetic/double_interval.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode::detail {

/// The equation f = 0 as a filter of boxes.
///
/// METHOD (HC4-revise; F. Benhamou, F. Goualard, L. Granvilliers, J.-F. Puget, Revising hull and
/// box consistency, ICLP 1999). From the variables to the result, each operation gets a set that
/// holds its values at all members of its operands' sets at which it is defined. The result's set
/// is cut down to {0}. From the result to the variables, each operation cuts from the sets of its
/// operands the members for which no member of the other operand gives a value in its own set.
///
/// PROOF. Let f be defined and 0 at a point of the box. Then each operation is defined there, and
/// its value lies in its set, by induction from the variables on. The value of f lies in {0}; and
/// where the value of an operation lies in the set that is left of its own, the values of its
/// operands are not among those that are cut away. So the point lies in the box that is left; where
/// a set becomes empty there is no such point. An operation of which no set is known has all real
/// numbers, and cuts nothing.
///
/// Ends may be infinite. Calls of one object must not run at the same time.
class contraction {
 public:
  explicit contraction(const expression& f);

  /// Cuts the box down; false where nothing is left, and the box is then of no use. One set for
  /// each variable, none of them undefined.
  [[nodiscard]] bool apply(std::vector<double_interval>& box);

  /// Whether value() can be anything but undefined.
  [[nodiscard]] bool has_values() const { return has_values_; }
  /// f over a box, where it is proved to be defined there; else undefined.
  [[nodiscard]] double_interval value(const std::vector<double_interval>& box);
  /// The partial derivatives of f over a box, by one sweep from the result to the variables (A.
  /// Griewank, A. Walther, Evaluating Derivatives, 2nd ed. 2008, section 3.2); empty unless f is
  /// proved to be defined and continuously differentiable on the whole of it.
  [[nodiscard]] std::vector<double_interval> gradient(const std::vector<double_interval>& box);
  struct value_and_slope {
    double_interval value;
    double_interval slope;
  };
  /// f and f' over x, of a function of one variable: the value as above, the slope undefined unless
  /// f is proved to be defined and continuously differentiable on the whole of x. From the variable
  /// to the result, so that they do not depend on the order of the instructions.
  [[nodiscard]] value_and_slope over(double_interval x);

 private:
  void set_inputs(const std::vector<double_interval>& box);

  std::size_t variables_;
  std::vector<double_interval> constants_;
  bool has_values_ = true;  // all constants are defined, and all functions are those of the table
  std::vector<instruction> code_;          // the operands and results are numbers of sets
  std::uint32_t result_;                   // the set of f
  std::vector<double_interval> sets_;      // of the variables, the constants and each instruction
  std::vector<double_interval> adjoints_;  // the derivatives of f by each of them, or of each by x
};

}  // namespace polhode::detail
