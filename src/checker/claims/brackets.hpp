#pragma once

// Brackets of a value of a phase: the phase is above it at one end, below it at the other, and
// monotone.

#include <functional>
#include <string>

#include "answers.hpp"
#include "checker/body.hpp"
#include "checker/examination.hpp"

namespace polhode::checker {

/// G(lower) > q pi > G(upper) for 0 < lower < upper < 1.
[[nodiscard]] tri passes_half_phase(const body& rigid, const rational& q, const range& u,
                                    precision bits);
/// F(c,0) > q pi > F(c',0) for c = a lower, c' = a upper, 0 < lower < upper < 1.
[[nodiscard]] tri passes_rotating_phase(const body& rigid, const rational& q, const range& s,
                                        precision bits);
/// The bits of both ends.
[[nodiscard]] long size_of(const range& r);

/// "k = 1 ... 3 and no other k >= 1".
[[nodiscard]] std::string counted(const integer& count);
/// That G(u) = q(k) pi has one solution for each k = 1 ... count, q(k) falling: brackets of at most
/// six of them, as the witness `key` gives them; or where count is 0, that G is q(1) pi nowhere: I
/// >= q(1). `follow` checks what follows from a bracket.
void check_values_of_half_phase(examination& e, const integer& count,
                                const std::function<rational(int k)>& q, const std::string& key,
                                const std::function<void(int k, const range& u)>& follow = nullptr);

}  // namespace polhode::checker
