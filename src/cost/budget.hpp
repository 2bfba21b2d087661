#pragma once

// Which measurements fit into a time: none begins that is expected to end after it.

#include <cstddef>
#include <functional>
#include <vector>

#include "measure.hpp"

namespace polhode::cost {

/// A time that ends, by a clock that may be any function: tests have their own.
class time_budget {
 public:
  /// Ends `seconds` from now() on.
  time_budget(double seconds, std::function<double()> now);
  /// An equal share of what is left, for the next of so many parts: what it does not use is left
  /// for those after it.
  [[nodiscard]] time_budget share(std::size_t parts) const;
  /// Whether what takes so many seconds ends in time. Nothing begins after the end.
  [[nodiscard]] bool allows(double seconds) const;
  [[nodiscard]] double now() const { return now_(); }

 private:
  std::function<double()> now_;
  double end_;
};

/// What was measured by growing digits, and the digits that were left out.
struct measured_points {
  std::vector<measurement> points;
  std::vector<long> left_out;
};

/// Measures at each of the digits, which grow, until the next measurement is expected to pass the
/// end of the budget; that one and all after it are left out. A measurement is expected to take the
/// greater of two times: what the last ones took in all, and `calls` times what one of their calls
/// took, both by extrapolated_seconds; and extra(digits) more. The first, of which nothing is
/// known, is always taken.
[[nodiscard]] measured_points measured_within(
    const time_budget& budget, const std::vector<long>& digits, double calls,
    const std::function<double(long digits)>& extra,
    const std::function<measurement(long digits)>& measured_at);

}  // namespace polhode::cost
