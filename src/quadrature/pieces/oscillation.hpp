#pragma once

// Integrals that converge by oscillation: of sin(x)/x up to infinity, of sin(1/x) from 0.
//
// Let f near the end be, as a function of y >= Y0 with x = p + s y^theta (the end at y = infinity),
//
//   f(x) |dx/dy| = u_0(y) + sum over j of 2 Re[ (u_j + i v_j)(y) e^(i w_j y) ],
//     w_j > 0 constants,
//
// with functions u_0, u_j, v_j that are real for real y. They are found in f's formula: the
// sine or cosine of P = w y + R, R a sum of powers y^e with e <= 0, is of this form, and so are J
// and Y, Si and Ci of w y + c, c >= 0, Fresnel's integrals of a root of y (wave_amplitudes.hpp),
// and the sums, products and whole powers of what is.
//
// ROTATION. Let u_j and v_j be known as end_series in t = 1/y over the square of half-side r >=
// 1/Y0, with powers t^m, m > 0; or be sums and products of such and of amplitudes of these
// functions, which are analytic for Re z > 0 and bounded there by C |z|^-d, d > 0. Then W = u_j +
// i v_j is analytic for |z| > 1/r, Re z > 0, and W(z) -> 0 there as |z| -> infinity, uniformly.
// By Cauchy's theorem over the boundary of the quarter disc |z - Y0| < R, Re z > Y0, Im z > 0, on
// whose arc the integral of
// W(z) e^(iwz) vanishes as R -> infinity (C. Jordan's lemma; E. T. Whittaker, G. N. Watson, A
// Course of Modern Analysis, 1927, section 6.222),
//
//   integral of W e^(iwy) over y > Y0  =  i e^(iwY0) integral of W(Y0 + i tau) e^(-w tau) over tau
//   > 0:
//
// the left one converges, and the right one exponentially. With |W| <= B where |z| >= Y0, Re z > 0,
// what is left beyond tau = T is at most (B/w) e^(-wT). The W that is evaluated on the line is made
// of principal values; where the regions around the line prove it analytic it is the continuation
// of its values for real z near Y0, which are the series'.

#include <optional>
#include <vector>

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The part between the end and y = Y0, less u_0's.
struct oscillating_end {
  /// x = p + s far at y = Y0.
  rational far;
  /// u_0, as a function of y, to be integrated from Y0 to infinity; not there where it is 0.
  std::optional<integrand> steady;
  rational start;  // Y0
  /// The line up from Y0, for each frequency.
  std::vector<segment> segments;
  /// A bound of what is beyond.
  magnitude rest;
};

/// f between x = p + s and p, or infinity (p = 0, x = s y): as above with theta < 0, or > 0. The
/// integral counts with this sign. The rest is made smaller than about 2^log2_goal. Nothing where f
/// is not found to be of this form.
[[nodiscard]] std::optional<oscillating_end> oscillations_at(const integrand& f, const end_point& p,
                                                             const end_point& s, bool infinite,
                                                             int sign, double log2_goal);

}  // namespace polhode::detail
