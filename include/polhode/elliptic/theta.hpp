#pragma once

// Jacobi's theta functions of a real argument z and nome 0 <= q < 1 (DLMF 20.2(i)):
//
//   theta_1 = 2 sum over n >= 0 of (-1)^n q^((n+1/2)^2) sin((2n+1)z),
//     theta_3 = 1 + 2 sum over n >= 1 of q^(n^2) cos(2nz),
//   theta_2 = 2 sum over n >= 0 of q^((n+1/2)^2) cos((2n+1)z),
//     theta_4 = the same with the factors (-1)^n,
//
// and their derivatives in z. For q < 1/20 (e^(-pi) is 0.043) by these series; for greater q by
// Poisson's summation (C. G. J. Jacobi's imaginary transformation, DLMF 20.7(viii)): with L = -log
// q
//   theta_3(z) = sqrt(pi/L) sum over all n of exp(-(z + n pi)^2/L),
//     theta_4(z) = theta_3(z + pi/2),
//   theta_2(z) = sqrt(pi/L) sum over all n of (-1)^n exp(-(z + n pi)^2/L),
//     theta_1(z) = theta_2(z - pi/2).
// So some sqrt(p) terms at most are added for p bits. Undefined for q outside [0, 1). Over balls:
// enclosures by ball arithmetic, with the excess of that over wide ones. elliptic_nome (jacobi.hpp)
// gives q from the parameter.

#include "polhode/arithmetic/ball.hpp"

namespace polhode {

/// theta_j and its derivative in z, for j = 1, 2, 3, 4; throws std::invalid_argument for another j.
struct theta_values {
  ball value, derivative;
};
[[nodiscard]] theta_values theta(int j, const ball& z, const ball& q);

[[nodiscard]] inline ball theta_1(const ball& z, const ball& q) { return theta(1, z, q).value; }
[[nodiscard]] inline ball theta_2(const ball& z, const ball& q) { return theta(2, z, q).value; }
[[nodiscard]] inline ball theta_3(const ball& z, const ball& q) { return theta(3, z, q).value; }
[[nodiscard]] inline ball theta_4(const ball& z, const ball& q) { return theta(4, z, q).value; }

}  // namespace polhode
