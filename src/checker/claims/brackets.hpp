#pragma once

// Brackets of a value of a phase: the phase is above it at one end, below it at the other, and monotone.

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
/// Brackets of G(u) = q(k) pi for k = 1 ... count, at most six of them, as the witness `key` gives them.
void check_brackets(examination& e, const integer& count, const std::function<rational(int k)>& q,
                    const std::string& key);
/// That G is q pi nowhere: I >= q.
void check_absence(examination& e, const rational& q);

}  // namespace polhode::checker
