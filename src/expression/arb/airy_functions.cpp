#ifdef POLHODE_WITH_ARB

#include <optional>
#include <vector>

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

}  // namespace

std::vector<definition> airy_functions() {
  return {{.what = {"airyAi", "x", "Airy, the one that decays", "all x"},
           .value = value_of_ai,
           .slope = "airyAiPrime(x)",
           .bound =
               [](const ball*, int sign) {
                 return sign < 0 ? oscillating("2/(sqrt(3*pi)*(-x)^(1/4))")
                                 : steady("exp(-2/3*x^(3/2))/(2*sqrt(pi)*x^(1/4))");
               }},
          {.what = {"airyAiPrime", "x", "derivative of airyAi", "all x"},
           .value = value_of_ai_prime,
           .slope = "x*airyAi(x)",
           .bound =
               [](const ball*, int sign) {
                 return sign < 0 ? oscillating("2*(-x)^(1/4)/sqrt(3*pi)*(1+7/8*(1/x^2-1/x))")
                                 : steady("x^(1/4)*exp(-2/3*x^(3/2))/(2*sqrt(pi))*(1+x^(-3/2)/4)");
               }},
          {.what = {"airyBi", "x", "Airy, the one that grows", "all x"},
           .value = value_of_bi,
           .slope = "airyBiPrime(x)",
           .bound =
               [](const ball*, int sign) {
                 return sign < 0 ? oscillating("2/(sqrt(pi)*(-x)^(1/4))") : std::nullopt;
               }},
          {.what = {"airyBiPrime", "x", "derivative of airyBi", "all x"},
           .value = value_of_bi_prime,
           .slope = "x*airyBi(x)",
           .bound = [](const ball*, int sign) {
             return sign < 0 ? oscillating("2*(-x)^(1/4)/sqrt(pi)*(1+7/8*(1/x^2-1/x))")
                             : std::nullopt;
           }}};
}

}  // namespace polhode::arb_functions_impl

#endif
