#pragma once

// All roots in an interval again, by a search that goes through it backwards and in other boxes, as
// `polhode roots --verify` finds them.
//
//   const second_opinion second = roots_again(f, 0, 1, isolate_roots(f, 0, 1), 30);

#include <optional>
#include <string>

#include "polhode/expression/expression.hpp"
#include "polhode/roots/isolate.hpp"
#include "polhode/verify/second_opinion.hpp"

namespace polhode {

/// Nothing where the second list confirms the first, which is resolved; else why it does not.
/// Throws contradiction_error where the lists exclude each other: a root of the one for which the
/// other has no place; two resolved lists of different length; the k-th roots of two resolved lists
/// of one length apart, or of different multiplicities.
[[nodiscard]] std::optional<std::string> compare(const finding<proved_roots>& first,
                                                 const finding<proved_roots>& second);

/// The roots of f from lower to upper again: those of f(-x) from -upper to -lower, in two searches
/// that meet at a point where f has a sign. `first` is resolved, its enclosures as narrow as the
/// digits that were asked for. Throws contradiction_error as compare does.
[[nodiscard]] second_opinion roots_again(const expression& f, const end_point& lower,
                                         const end_point& upper, const proved_roots& first,
                                         const std::string& first_route, long digits,
                                         int threads = 1);

/// The same for the answer of isolate_roots(f, lower, upper), whose roots are refined to so many
/// digits first.
[[nodiscard]] second_opinion roots_again(const expression& f, const end_point& lower,
                                         const end_point& upper, const root_set& first, long digits,
                                         int threads = 1);

}  // namespace polhode
