#pragma once

// Certificates of what was computed of a formula that someone gave: an integral over a finite
// range, and all roots in one. They hold what an independent checker needs to show it again
// (docs/certificates.md), which is not how it was computed. The search for that is a heuristic:
// what it finds proves nothing until it is checked, and what it does not find it says.

#include <span>

#include "polhode/certificate/certificate.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {

/// A formula and the range of its variable; `from` and `to` have no variable.
struct formula_over_range {
  expression f;
  expression from;
  expression to;
};

/// Throws input_error where a checker would not know what a formula or an end is made of, and says
/// what that is.
void expect_checkable(const formula_over_range& what);

/// The certificate, in its JSON form, of the integral of f, which `enclosure` holds: the enclosure,
/// widened by 10^-digits/100 of its size, and pieces of the range, each with an ellipse on which f
/// is bounded and the nodes of a rule that is then exact enough. Throws input_error where no such
/// pieces are found: where f is not analytic at an end, say.
[[nodiscard]] json integral_certificate(const formula_over_range& what, const ball& enclosure,
                                        long digits);

/// The certificate, in its JSON form, of f's roots, which the enclosures hold, one each, in
/// ascending order, and no others in the range: the enclosures, widened by 10^-digits/100, and a
/// box around each on which the derivative is not 0. Throws input_error where there is no such box:
/// at a root that is multiple, or at an end of the range.
[[nodiscard]] json roots_certificate(const formula_over_range& what,
                                     std::span<const ball> enclosures, long digits);

}  // namespace polhode
