#pragma once

// Carlson's symmetric integrals of real arguments (B. C. Carlson, Numer. Algorithms 10, 1995; DLMF
// 19.16):
//
//   R_F(x,y,z)   = (1/2) int_0^oo dt / sqrt((t+x)(t+y)(t+z))
//   R_C(x,y)     = R_F(x,y,y)
//   R_J(x,y,z,p) = (3/2) int_0^oo dt / ((t+p) sqrt((t+x)(t+y)(t+z)))
//   R_D(x,y,z)   = R_J(x,y,z,z)
//   R_G(x,y,z)   = (1/4) int_0^oo t (x/(t+x) + y/(t+y) + z/(t+z)) / sqrt((t+x)(t+y)(t+z)) dt
//
//   function   domain, else undefined
//   R_F        x, y, z >= 0, at most one of them 0
//   R_C        x >= 0, y != 0; the Cauchy principal value for y < 0
//   R_J        x, y, z as for R_F, p != 0; the Cauchy principal value for p < 0
//   R_D        x, y >= 0, not both 0, z > 0
//   R_G        x, y, z >= 0
//
// Over balls the results are enclosures, close to the last place for numbers. Over wide balls they
// are the range itself but for rounding: for p > 0 (y > 0 in R_C) the integrands, and so R_F, R_C,
// R_J and R_D, decrease in every argument, and R_G increases (its partial derivative in x is R_G's
// integrand differentiated, see carlson_rg_gradient). Principal values are put together from these,
// over wide balls with some excess. mpfr_float and double give the uncertified value (NaN outside
// the domain), the first at the greatest precision among the arguments; both come from the
// templates that give the balls (src/elliptic/carlson_core.hpp, with the proofs): duplication with
// a series, and from some 60 digits on Landen's transformation, which converges quadratically.

#include <array>

#include "polhode/arithmetic/boost_bridge.hpp"

namespace polhode {

[[nodiscard]] ball carlson_rf(const ball& x, const ball& y, const ball& z);
[[nodiscard]] ball carlson_rc(const ball& x, const ball& y);
[[nodiscard]] ball carlson_rj(const ball& x, const ball& y, const ball& z, const ball& p);
[[nodiscard]] ball carlson_rd(const ball& x, const ball& y, const ball& z);
[[nodiscard]] ball carlson_rg(const ball& x, const ball& y, const ball& z);

/// R_F(x,y,z) and R_J(x,y,z,p), mostly for the price of R_J alone: the third kind needs both.
struct carlson_pair {
  ball rf, rj;
};
[[nodiscard]] carlson_pair carlson_rf_rj(const ball& x, const ball& y, const ball& z,
                                         const ball& p);

[[nodiscard]] mpfr_float carlson_rf(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z);
[[nodiscard]] mpfr_float carlson_rc(const mpfr_float& x, const mpfr_float& y);
[[nodiscard]] mpfr_float carlson_rj(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z,
                                    const mpfr_float& p);
[[nodiscard]] mpfr_float carlson_rd(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z);
[[nodiscard]] mpfr_float carlson_rg(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z);

[[nodiscard]] double carlson_rf(double x, double y, double z);
[[nodiscard]] double carlson_rc(double x, double y);
[[nodiscard]] double carlson_rj(double x, double y, double z, double p);
[[nodiscard]] double carlson_rd(double x, double y, double z);
[[nodiscard]] double carlson_rg(double x, double y, double z);

// Partial derivatives in the order of the arguments, undefined where there are none (x = 0).
/// -R_D(y,z,x)/6 and its permutations (DLMF 19.18.1, with 19.20.18).
[[nodiscard]] std::array<ball, 3> carlson_rf_gradient(const ball& x, const ball& y, const ball& z);
[[nodiscard]] std::array<ball, 2> carlson_rc_gradient(const ball& x, const ball& y);
[[nodiscard]] std::array<ball, 4> carlson_rj_gradient(const ball& x, const ball& y, const ball& z,
                                                      const ball& p);
[[nodiscard]] std::array<ball, 3> carlson_rd_gradient(const ball& x, const ball& y, const ball& z);
[[nodiscard]] std::array<ball, 3> carlson_rg_gradient(const ball& x, const ball& y, const ball& z);

}  // namespace polhode
