#include "budget.hpp"

#include <algorithm>
#include <utility>

namespace polhode::cost {

time_budget::time_budget(double seconds, std::function<double()> now)
    : now_(std::move(now)), end_(now_() + seconds) {}

time_budget time_budget::share(std::size_t parts) const {
  const double left = std::max(0.0, end_ - now_());
  return {left / static_cast<double>(std::max<std::size_t>(parts, 1)), now_};
}

bool time_budget::allows(double seconds) const {
  const double start = now_();
  return start < end_ && start + seconds <= end_;
}

measured_points measured_within(const time_budget& budget, const std::vector<long>& digits,
                                double calls, const std::function<double(long digits)>& extra,
                                const std::function<measurement(long digits)>& measured_at) {
  measured_points result;
  std::vector<measurement> whole;  // their seconds are those of the whole measurement
  for (const long n : digits) {
    const double in_all = extrapolated_seconds(whole, n).value_or(0);
    const double of_calls = calls * extrapolated_seconds(result.points, n).value_or(0);
    const bool is_first = whole.empty();
    if (!result.left_out.empty() ||
        (!is_first && !budget.allows(std::max(in_all, of_calls) + extra(n)))) {
      result.left_out.push_back(n);
      continue;
    }
    const double start = budget.now();
    result.points.push_back(measured_at(n));
    measurement all;
    all.digits = n;
    all.seconds = budget.now() - start;
    whole.push_back(all);
  }
  return result;
}

}  // namespace polhode::cost
