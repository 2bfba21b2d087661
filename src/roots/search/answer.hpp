#pragma once

#include "state.hpp"

namespace polhode::detail {

/// What is found until now, from left to right: the roots inside of the range, their enclosures
/// apart; what is open; and the places where f is not defined.
[[nodiscard]] root_set answer_of(const root_search::state& s);

}  // namespace polhode::detail
