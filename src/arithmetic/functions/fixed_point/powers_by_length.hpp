#pragma once

#include <map>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail::fixed_point {

/// Powers of a whole number, each made once: a sum in halves has few lengths of parts, two for each
/// level.
class powers_by_length {
 public:
  explicit powers_by_length(const integer& base) { known_.emplace(1, base); }

  /// Makes and returns base^n, n >= 1, and that of both halves of n.
  const integer& make(long n) {
    if (const auto found = known_.find(n); found != known_.end()) return found->second;
    const integer& left = make(n / 2);
    const integer& right = make(n - n / 2);
    return known_.emplace(n, left * right).first->second;
  }
  /// base^n, which was made.
  [[nodiscard]] const integer& of(long n) const { return known_.at(n); }

 private:
  std::map<long, integer> known_;
};

}  // namespace polhode::detail::fixed_point
