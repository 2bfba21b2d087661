#pragma once

// Arb, loaded when a formula first needs it: linked, it would take every run of the program two
// milliseconds. Compiled only where Arb's headers are found.

#include <acb.h>
#include <acb_dirichlet.h>
#include <acb_hypgeom.h>

namespace polhode::detail {

// clang-format off
#define POLHODE_ARB_FUNCTIONS(X) \
  X(acb_clear) X(acb_digamma) X(acb_div) X(acb_exp) X(acb_mul) X(acb_neg) X(acb_sqrt) X(acb_sub) \
  X(acb_rel_error_bits) X(acb_hypgeom_airy) X(acb_hypgeom_bessel_i) \
  X(acb_hypgeom_bessel_i_scaled) \
  X(acb_hypgeom_bessel_j) X(acb_hypgeom_bessel_k) X(acb_hypgeom_bessel_k_scaled) \
  X(acb_hypgeom_bessel_y) X(acb_hypgeom_chi) X(acb_hypgeom_ci) \
  X(acb_hypgeom_dilog) X(acb_hypgeom_ei) X(acb_hypgeom_erfc) X(acb_hypgeom_erfi) \
  X(acb_hypgeom_expint) X(acb_hypgeom_fresnel) X(acb_hypgeom_gamma_lower) \
  X(acb_hypgeom_gamma_upper) X(acb_hypgeom_m) X(acb_hypgeom_shi) X(acb_hypgeom_si) \
  X(acb_hypgeom_u) \
  X(acb_dirichlet_zeta_jet) X(acb_lambertw) X(acb_polygamma) X(acb_polylog) X(acb_zeta) \
  X(arb_const_pi) X(arb_indeterminate) X(arb_is_finite) X(arb_is_positive) X(arb_neg) \
  X(arf_get_mpfr) X(arf_set_mpfr) X(flint_cleanup) X(mag_set_ui_2exp_si)
// clang-format on

/// Its functions, by their own names.
struct arb_library {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a declarator
#define POLHODE_ARB_POINTER(f) decltype(&::f) f = nullptr;
  POLHODE_ARB_FUNCTIONS(POLHODE_ARB_POINTER)
#undef POLHODE_ARB_POINTER
};

/// Loads it at the first call. Throws std::runtime_error where it cannot be loaded.
[[nodiscard]] const arb_library& arb();

}  // namespace polhode::detail
