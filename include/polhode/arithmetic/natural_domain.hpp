#pragma once

// Functions in the set-based sense of IEEE 1788: f over a set is the range of f over that part of
// the set where f is defined, its natural domain. sqrt of [-1, 4] is [0, 2], log of [0, 1] is
// [-inf, 0], 1 / [0, 1] is [1, inf], and what is defined nowhere on the set is empty.
//
// This is not what the functions of the same names in elementary.hpp answer: there a function that
// is not defined on the whole of its operand is *undefined*, which means "nothing is known" and is
// what a proof has to hear. Here a set is cut without a word, which is what is wanted to contract a
// box or to compute with relations, and never to show that a function is defined, continuous or
// analytic. So these forms have a namespace of their own, named after what they restrict to: no
// call can mean one and get the other, and both can be used in one line.
//
// The result is std::nullopt where it is proved empty. It is the undefined ball where an operand is
// undefined, and where the range is not bounded it has infinite ends. Functions defined everywhere
// (exp, sin, atan, floor, ...) have one meaning only and are in elementary.hpp.
//
//   here                 natural domain                    IEEE 1788
//   sqrt                 [0, inf)                          sqrt
//   rsqrt                (0, inf)                          rSqrt
//   log, log2, log10     (0, inf)                          log, log2, log10
//   log1p                (-1, inf)                         logp1
//   asin, acos           [-1, 1]                           asin, acos
//   acosh                [1, inf)                          acosh
//   atanh                (-1, 1)                           atanh
//   tan                  not pi/2 + k pi                   tan
//   reciprocal           not 0                             recip
//   divide(x, y)         y not 0                           div
//   pow(x, n)            x not 0 where n < 0               pown
//   pow(x, y)            x > 0; x = 0 where y > 0          pow
//   root(x, n)           x >= 0 where n is even            rootn
//   atan2(y, x)          not both 0                        atan2

#include <optional>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::natural_domain {

[[nodiscard]] std::optional<ball> sqrt(const ball& x);
[[nodiscard]] std::optional<ball> rsqrt(const ball& x);
[[nodiscard]] std::optional<ball> log(const ball& x);
[[nodiscard]] std::optional<ball> log2(const ball& x);
[[nodiscard]] std::optional<ball> log10(const ball& x);
[[nodiscard]] std::optional<ball> log1p(const ball& x);
[[nodiscard]] std::optional<ball> asin(const ball& x);
[[nodiscard]] std::optional<ball> acos(const ball& x);
[[nodiscard]] std::optional<ball> acosh(const ball& x);
[[nodiscard]] std::optional<ball> atanh(const ball& x);
/// Never empty: every set has members that are no pole.
[[nodiscard]] std::optional<ball> tan(const ball& x);
[[nodiscard]] std::optional<ball> reciprocal(const ball& x);
[[nodiscard]] std::optional<ball> divide(const ball& x, const ball& y);
[[nodiscard]] std::optional<ball> pow(const ball& x, long n);
/// exp(y log x), and 0 at x = 0, y > 0: negative x are left out for integers y too.
[[nodiscard]] std::optional<ball> pow(const ball& x, const ball& y);
/// Empty for n = 0.
[[nodiscard]] std::optional<ball> root(const ball& x, unsigned long n);
[[nodiscard]] std::optional<ball> atan2(const ball& y, const ball& x);

}  // namespace polhode::natural_domain
