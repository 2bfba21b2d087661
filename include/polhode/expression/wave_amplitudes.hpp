#pragma once

// Special functions as oscillations, with amplitudes P and Q that do not oscillate:
//
//   P cos z + Q sin z  and  P sin z - Q cos z,   so that  (P -+ i Q) e^(+-i z)
//
// decay where Im z -> +-infinity. These are Bessel's functions J and Y of order nu, where they are
// Hankel's functions H1, H2 = J +- i Y (DLMF 10.4.3); and the integrals of t^(a-1) sin t and of
// -t^(a-1) cos t over t > z, where they are those of -i t^(a-1) e^(i t) and its mirror image. P and
// Q are analytic for Re z > 0, and real for real z.

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode::detail {

/// Which they are.
struct wave_function {
  enum class family { bessel, integral_of_power };
  family of = family::bessel;
  rational order;  // nu, or a < 1
};

template <class T>
struct wave_amplitudes {
  T p;
  T q;
};

/// To about the precision of z; undefined where Re z is not certainly positive. Hypothesis: Arb is
/// available, which has the functions for formulas too.
[[nodiscard]] wave_amplitudes<complex_ball> wave_amplitudes_at(const wave_function& f,
                                                               const complex_ball& z);
[[nodiscard]] wave_amplitudes<region> wave_amplitudes_at(const wave_function& f, const region& z);

/// factor |z|^-exponent.
struct amplitude_bound {
  magnitude factor;
  rational exponent;

  /// For |z| >= least.
  [[nodiscard]] ball beyond(const ball& least) const;
};
/// Bounds of |P| and |Q| for Re z >= 0, |z| >= least > 0.
[[nodiscard]] wave_amplitudes<amplitude_bound> bounds_of_wave_amplitudes(const wave_function& f,
                                                                         const ball& least);

}  // namespace polhode::detail
