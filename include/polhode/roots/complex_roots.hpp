#pragma once

// All complex roots of a polynomial with rational coefficients.
//
//   for (const complex_root& r : complex_roots(*parse("x^3-1").polynomial(), 30).roots) ...
//
// The factors without multiple roots, their rational and their real roots are found exactly
// (isolate.hpp). The others are pairs of conjugate numbers. They are approximated by the method of
// O. Aberth (Iteration methods for finding all zeros of a polynomial simultaneously, 1973), and
// proved by discs:
//
// Theorem (B. T. Smith, Error bounds for zeros of a polynomial based upon Gerschgorin's theorems,
// 1970). Let p = a x^n + ..., let z_1, ..., z_n be different numbers, and
//   r_i = n |p(z_i)| / (|a| product over j != i of |z_i - z_j|).
// Then every root lies in a disc |x - z_i| <= r_i, and a disc that meets no other holds exactly
// one. Proof. Lagrange's interpolation of p - a (x - z_1)...(x - z_n), which has a degree below n,
// gives
//   p(x) = a (x - z_1)...(x - z_n) (1 + sum of w_i / (x - z_i)),   |w_i| = r_i / n.
// Outside of all discs the sum is below 1 in size, so p(x) is not 0. The same is true with t w_i, 0
// <= t <= 1, so that the number of roots in a disc that meets no other is constant in t; for t = 0
// it is 1.
//
// A root x is narrowed by Newton's method. As p'/p is the sum of 1/(x - root) over the n roots,
// some root lies within n |p(x)/p'(x)| of x; it is the one of the disc where that neighbourhood
// lies in it.

#include <functional>
#include <optional>
#include <vector>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/polynomial.hpp"

namespace polhode {

struct complex_root {
  /// Holds the root; where the answer is complete, it is the only one in it. The imaginary part is
  /// exactly 0 where the root is real. The radius is at most 10^-digits of the root's size.
  complex_ball enclosure;
  long multiplicity = 1;
  /// The root, where it is rational.
  std::optional<rational> exact;

  [[nodiscard]] bool is_real() const {
    return enclosure.im.is_exact() && contains_zero(enclosure.im);
  }
};

struct complex_roots_answer {
  /// In ascending order of the real parts' midpoints, then of the imaginary parts'; with their
  /// multiplicities they are as many as the degree.
  std::vector<complex_root> roots;
  /// Every root is in the list, with the digits asked for.
  bool complete = true;
};

/// All roots of p to so many digits. go_on is called now and then with the number of roots found
/// until then; false ends the work, and the answer is not complete. Throws input_error where p is
/// 0, and std::invalid_argument where digits < 1.
[[nodiscard]] complex_roots_answer complex_roots(const rational_polynomial& p, long digits,
                                                 const std::function<bool(long)>& go_on = {});

}  // namespace polhode
