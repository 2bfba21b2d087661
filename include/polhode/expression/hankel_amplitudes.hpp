#pragma once

// Bessel functions as oscillations: with Hankel's functions H1, H2 = J +- i Y of order nu (DLMF
// 10.4.3) and the amplitudes P and Q, which do not oscillate,
//
//   H1(z) = (P - i Q) e^(i z),  H2(z) = (P + i Q) e^(-i z),
//   J(z) = P cos z + Q sin z,   Y(z) = P sin z - Q cos z.
//
// P and Q are analytic for Re z > 0, and real for real z.

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode::detail {

template <class T>
struct hankel_amplitudes {
  T p;
  T q;
};

/// To about the precision of z; undefined where Re z is not certainly positive. Hypothesis: Arb is
/// available, which has J and Y for formulas too.
[[nodiscard]] hankel_amplitudes<complex_ball> hankel_amplitudes_at(const rational& order,
                                                                   const complex_ball& z);
[[nodiscard]] hankel_amplitudes<region> hankel_amplitudes_at(const rational& order,
                                                             const region& z);
/// A bound C of |P| sqrt|z| and of |Q| sqrt|z| for Re z >= 0, |z| >= least > 0.
[[nodiscard]] magnitude bound_of_hankel_amplitudes(const rational& order, const ball& least);

}  // namespace polhode::detail
