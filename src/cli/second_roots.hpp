#pragma once

// polhode roots --verify: all roots in an interval again, by a search that goes through it backwards and in other boxes.

#include <optional>
#include <string>
#include <vector>

#include "polhode/expression/expression.hpp"
#include "polhode/roots/isolate.hpp"
#include "second_opinion.hpp"

namespace polhode::cli {

/// What is proved of a root, as root_region has it.
struct proved_root {
  root_verdict verdict = root_verdict::unresolved;
  long multiplicity = 0;
  ball enclosure;
  bool may_lie_outside = false;

  /// One root of that multiplicity is in the enclosure and in the interval.
  [[nodiscard]] bool is_resolved() const { return multiplicity > 0 && !may_lie_outside; }
};

/// Every root in the interval lies in one of the enclosures, which ascend.
struct proved_roots {
  bool complete = true;  // else roots may be missing
  bool identically_zero = false;
  std::vector<proved_root> roots;

  [[nodiscard]] bool is_resolved() const;
};

/// Nothing where the second list confirms the first, which is resolved; else why it does not. Throws contradiction_error where the lists exclude each
/// other: a root of the one for which the other has no place; two resolved lists of different length; the k-th roots of two resolved lists of one
/// length apart, or of different multiplicities.
[[nodiscard]] std::optional<std::string> compare(const finding<proved_roots>& first,
                                                 const finding<proved_roots>& second);

/// The roots of f from lower to upper again: those of f(-x) from -upper to -lower, in two searches that meet at a point where f has a sign.
/// `first` is resolved, its enclosures as narrow as the digits that were asked for. Throws contradiction_error as compare does.
[[nodiscard]] second_opinion roots_again(const expression& f, const end_point& lower,
                                         const end_point& upper, const proved_roots& first,
                                         const std::string& first_route, long digits, int threads);

}  // namespace polhode::cli
