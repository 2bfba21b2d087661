#ifdef POLHODE_WITH_ARB

#include <optional>
#include <vector>

#include <fmt/format.h>

#include "definition.hpp"

namespace polhode::arb_functions_impl {
namespace {

// Airy functions, which Arb has over sets by bounds of their derivatives. For x > 0, 2 pi i Ai(x)
// is the integral of e^(s^3/3 - x s) over s = sqrt(x) + i t, on which the exponent is -(2/3)
// x^(3/2) - sqrt(x) t^2 - i t^3/3: so |Ai(x)| is at most e^(-(2/3) x^(3/2))/(2 pi) times the
// integral of e^(-sqrt(x) t^2), which is sqrt(pi) x^(-1/4); and |Ai'(x)|, with s for a factor and
// |s| <= sqrt(x) + t^2/(2 sqrt(x)), at most x^(1/4) e^(-(2/3) x^(3/2))/(2 sqrt(pi)) times 1 +
// x^(-3/2)/4.
//
// For x = -z < 0 they are sums of two Bessel functions J of t = (2/3) z^(3/2), of orders 1/3 and
// -1/3, and of 2/3 and -2/3 for the derivatives (DLMF 9.6.6 to 9.6.9). By DLMF 10.27.8 and 10.32.8
// at w = -i t, where |1 + s/(2 w)| >= 1 for s > 0, |J| <= |H1(t)| = (2/pi) |K(w)| is at most
// sqrt(2/(pi t)) for orders up to 1/2, and for 2/3, with |1 + s/(2 w)|^(1/6) <= 1 + s/(2 t), at
// most that times 1 + 7/(12 t) = 1 + (7/8) z^(-3/2), with z^(-3/2) <= 1/z + 1/z^2.

void value_of_ai(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_airy(r, nullptr, nullptr, nullptr, z, p);
}
void value_of_ai_prime(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_airy(nullptr, r, nullptr, nullptr, z, p);
}
void value_of_bi(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_airy(nullptr, nullptr, r, nullptr, z, p);
}
void value_of_bi_prime(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_airy(nullptr, nullptr, nullptr, r, z, p);
}

// With y = (2/3) x^(3/2) and x > 0 (DLMF 9.6.6 to 9.6.9)
//   Ai(-x) = sqrt(x)/3 (J_(1/3)(y) + J_(-1/3)(y)),   Bi(-x) = sqrt(x/3) (J_(-1/3)(y) - J_(1/3)(y)),
//   Ai'(-x) = x/3 (J_(2/3)(y) - J_(-2/3)(y)),   Bi'(-x) = x/sqrt(3) (J_(-2/3)(y) + J_(2/3)(y)),
// where each J(y) is sqrt(3/pi) x^(-3/4) cos(y - nu pi/2 - pi/4) but for |4 nu^2 - 1|/(8 y) times
// that root (j_at_infinity): 5/48 x^(-3/2) and 7/48 x^(-3/2) times it. The cosines add up to waves
// with cos(pi/6), sin(pi/6), sin(pi/3) and cos(pi/3); the rests are at most 5/(24 sqrt(3)) < 1/8,
// 5/24 < 1/4, 7/(24 sqrt(3)) < 1/5 and 7/24 < 3/10, each divided by sqrt(pi).
leading wave_at_infinity(std::string_view wave, std::string_view exponent, std::string_view share,
                         std::string_view exponent_of_rest) {
  return oscillating_beside(
      fmt::format("{}(2/3*(-x)^(3/2)-pi/4)*(-x)^({})/sqrt(pi)", wave, exponent),
      fmt::format("{}*(-x)^({})/sqrt(pi)", share, exponent_of_rest));
}

// With y = (2/3) x^(3/2), Ai(x) = sqrt(x/3) K_(1/3)(y)/pi and -Ai'(x) = x/sqrt(3) K_(2/3)(y)/pi
// (DLMF 9.6.2, 9.6.3). For x >= 4, where y > 5, k_at_infinity has these but for a share of (1/8 +
// 1/6 e^(1/36))/y < (9/20) x^(-3/2), and of (1/8 + 2/3 e^(1/9))/y < (4/3) x^(-3/2).
leading ai_at_infinity(const ball*, int sign) {
  if (sign < 0) return wave_at_infinity("cos", "-1/4", "1/8", "-7/4");
  return leading_term("exp(-2/3*x^(3/2))/(2*sqrt(pi)*x^(1/4))",
                      "9/40*exp(-2/3*x^(3/2))/(sqrt(pi)*x^(7/4))");
}
leading ai_prime_at_infinity(const ball*, int sign) {
  if (sign < 0) return wave_at_infinity("sin", "1/4", "1/5", "-5/4");
  return leading_term("-x^(1/4)*exp(-2/3*x^(3/2))/(2*sqrt(pi))",
                      "2/3*exp(-2/3*x^(3/2))/(sqrt(pi)*x^(5/4))");
}

// With y = (2/3) x^(3/2), Bi(x) = sqrt(x/3) (I_(-1/3)(y) + I_(1/3)(y)) and Bi'(x) = x/sqrt(3)
// (I_(-2/3)(y) + I_(2/3)(y)) (DLMF 9.6.4, 9.6.5), and I_(-nu) - I_nu = (2/pi) sin(nu pi) K_nu
// (10.27.2), at most (2/pi) sqrt(pi/(2 y)) e^-y (1 + 1/y): for x >= 4, where y > 5, less than
// e^y/sqrt(2 pi y) times 1/(10 y). So by i_at_infinity the sums are 2 e^y/sqrt(2 pi y) but for a
// share of (1/2 + 1/3 + 1/20)/y < 2 x^(-3/2), and of (1/2 + 4/3 + 1/20)/y < 3 x^(-3/2).
leading bi_at_infinity(const ball*, int sign) {
  if (sign < 0) return wave_at_infinity("-sin", "-1/4", "1/4", "-7/4");
  return leading_term("exp(2/3*x^(3/2))/(sqrt(pi)*x^(1/4))",
                      "2*exp(2/3*x^(3/2))/(sqrt(pi)*x^(7/4))");
}
leading bi_prime_at_infinity(const ball*, int sign) {
  if (sign < 0) return wave_at_infinity("cos", "1/4", "3/10", "-5/4");
  return leading_term("x^(1/4)*exp(2/3*x^(3/2))/sqrt(pi)", "3*exp(2/3*x^(3/2))/(sqrt(pi)*x^(5/4))");
}

}  // namespace

std::vector<definition> airy_functions() {
  return {{.what = {"airyAi", "x", "Airy, the one that decays", "all x"},
           .value = value_of_ai,
           .slope = "airyAiPrime(x)",
           .bound =
               [](const ball*, int sign) {
                 return sign < 0 ? oscillating("2/(sqrt(3*pi)*(-x)^(1/4))")
                                 : steady("exp(-2/3*x^(3/2))/(2*sqrt(pi)*x^(1/4))");
               },
           // Ai' has no zero x >= -1 (DLMF 9.9, table 9.9.1).
           .is_monotonic = where_positive,
           .near_infinity = ai_at_infinity},
          {.what = {"airyAiPrime", "x", "derivative of airyAi", "all x"},
           .value = value_of_ai_prime,
           .slope = "x*airyAi(x)",
           .bound =
               [](const ball*, int sign) {
                 return sign < 0 ? oscillating("2*(-x)^(1/4)/sqrt(3*pi)*(1+7/8*(1/x^2-1/x))")
                                 : steady("x^(1/4)*exp(-2/3*x^(3/2))/(2*sqrt(pi))*(1+x^(-3/2)/4)");
               },
           // Ai'' = x Ai.
           .is_monotonic = where_positive,
           .near_infinity = ai_prime_at_infinity},
          {.what = {"airyBi", "x", "Airy, the one that grows", "all x"},
           .value = value_of_bi,
           .slope = "airyBiPrime(x)",
           .bound =
               [](const ball*, int sign) {
                 return sign < 0 ? oscillating("2/(sqrt(pi)*(-x)^(1/4))") : std::nullopt;
               },
           .near_infinity = bi_at_infinity},
          {.what = {"airyBiPrime", "x", "derivative of airyBi", "all x"},
           .value = value_of_bi_prime,
           .slope = "x*airyBi(x)",
           .bound =
               [](const ball*, int sign) {
                 return sign < 0 ? oscillating("2*(-x)^(1/4)/sqrt(pi)*(1+7/8*(1/x^2-1/x))")
                                 : std::nullopt;
               },
           .near_infinity = bi_prime_at_infinity}};
}

}  // namespace polhode::arb_functions_impl

#endif
