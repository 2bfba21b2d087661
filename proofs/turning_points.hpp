#pragma once

// Where the curve C of the tennis racket effect meets the curve S (c = -b sin^2 epsilon) and the
// line epsilon = pi/2: the paper's lemmas 2 and 3 and its theorem 4, sharpened. The argument:
// proofs/arguments/count.md.

#include <functional>
#include <string>

#include "proofs/half_phase.hpp"

namespace polhode::proofs {

/// "2 pi/3", "pi".
[[nodiscard]] std::string multiple_of_pi(const rational& q);

/// "k = 1 and no other k >= 1", "k = 1 ... 3 and no other k >= 1", "no k >= 1".
[[nodiscard]] std::string counted(const integer& count);

/// Adds brackets of the roots of G(u) = q(k) pi for k = 1 ... count, the first six of them, each a
/// fact, and all to witness[key]. `follow` adds what follows from one.
void add_brackets(certificate& c, const body& rigid, const integer& count,
                  const std::function<rational(int k)>& q, const std::string& key,
                  const std::function<void(int k, const root_bracket& u)>& follow = nullptr);

/// Adds the fact that I >= q, in rationals, with G(1/2) > q pi as a check by another route.
void add_absence(certificate& c, const body& rigid, const rational& q);

}  // namespace polhode::proofs
