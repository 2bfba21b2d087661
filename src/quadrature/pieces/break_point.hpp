#pragma once

// A break as a number: found to any precision.

#include <memory>
#include <mutex>
#include <optional>

#include "quadrature/pieces/branches.hpp"

namespace polhode::detail::breaks {

/// The zero of decider - n in an interval in which there is exactly one, a simple one.
class break_point {
 public:
  break_point(std::shared_ptr<const formula_graph> f, crossing c, choices chosen,
              const interval& x);

  /// An enclosure to about p bits of its size; where the formula's constants do not allow that, a
  /// wider one.
  [[nodiscard]] ball at(precision p);
  /// The same as a rational number with a small denominator, where f is proved to break there.
  [[nodiscard]] std::optional<rational> as_rational();

 private:
  void refine(precision p);
  [[nodiscard]] slope_jet decider_at(const ball& x) const;

  std::shared_ptr<const formula_graph> f_;
  crossing crossing_;
  choices chosen_;
  interval x_;
  magnitude size_;
  ball enclosure_;
  std::mutex mutex_;
};

}  // namespace polhode::detail::breaks
