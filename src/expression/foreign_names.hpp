#pragma once

// What functions are called elsewhere: for hints.

#include <optional>
#include <string_view>

namespace polhode::detail {

/// How a function is written here that has this name in Mathematica, Maple, PARI, mpmath, SciPy, C
/// or books: "digamma(x), polygamma(n, x)" for "psi". Nothing for a name that is none of these.
[[nodiscard]] std::optional<std::string_view> written_here(std::string_view foreign_name);

}  // namespace polhode::detail
