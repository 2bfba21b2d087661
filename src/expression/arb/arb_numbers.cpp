#ifdef POLHODE_WITH_ARB

#include "arb_numbers.hpp"

namespace polhode::detail {

namespace {

/// Arb keeps constants and tables of each thread, which end with it.
struct caches_of_thread {
  caches_of_thread() = default;
  caches_of_thread(const caches_of_thread&) = delete;
  caches_of_thread& operator=(const caches_of_thread&) = delete;
  ~caches_of_thread() { arb().flint_cleanup(); }
};

/// An upper bound: Arb's numbers of this kind have 30 bits.
void set_radius(mag_t r, const magnitude& radius) {
  arb().mag_set_ui_2exp_si(r, radius.fraction(), radius.is_zero() ? 0 : radius.exponent());
}

void set(arb_t r, const ball& x) {
  if (!x.is_bounded()) return arb().arb_indeterminate(r);
  mpfr_cell middle(x.precision());
  x.midpoint(middle.get());
  arb().arf_set_mpfr(arb_midref(r), middle.get());
  // Of the midpoint with these bits.
  set_radius(arb_radref(r), x.radius());
}

/// An exponent of Arb's, which may be long; those beyond +-2^61 as these.
long exponent_of(const fmpz* x) {
  constexpr long most = 1L << 61;
  if (COEFF_IS_MPZ(*x)) return mpz_sgn(COEFF_TO_PTR(*x)) > 0 ? most : -most;
  return *x;
}

/// An upper bound: the number is fraction 2^(exponent - 30).
magnitude upper_bound(const mag_t radius) {
  if (mag_is_zero(radius)) return {};
  if (mag_is_inf(radius)) return magnitude::infinity();
  return magnitude::from_bits_up(MAG_MAN(radius), exponent_of(MAG_EXPREF(radius)) - MAG_BITS);
}

ball to_ball(const arb_t x, precision p) {
  if (arb().arb_is_finite(x) == 0) return ball::undefined(p);
  magnitude radius = upper_bound(arb_radref(x));
  mpfr_cell middle(p);
  const bool is_zero = arf_is_zero(arb_midref(x)) != 0;
  const long exponent = is_zero ? 0 : exponent_of(ARF_EXPREF(arb_midref(x)));
  // Exponents beyond MPFR's: it has no such number, or none but 0 next to it.
  if (exponent > mpfr_get_emax()) return ball::undefined(p);
  if (exponent < mpfr_get_emin()) {
    mpfr_set_zero(middle.get(), 1);
    radius = add_up(radius, magnitude::power_of_two(mpfr_get_emin()));
  } else if (arb().arf_get_mpfr(middle.get(), arb_midref(x), MPFR_RNDN) != 0) {
    // Half a unit in the last place, or less.
    radius = add_up(radius, magnitude::power_of_two(mpfr_get_exp(middle.get()) - p));
  }
  if (radius.is_infinite() || mpfr_number_p(middle.get()) == 0) return ball::undefined(p);
  return ball::from_midpoint_radius(middle.get(), radius);
}

}  // namespace

arb_number::arb_number(const complex_ball& z) : arb_number() {
  static thread_local const caches_of_thread caches;
  set(acb_realref(z_), z.re);
  set(acb_imagref(z_), z.im);
}

complex_ball to_complex_ball(acb_srcptr z, precision p) {
  return {to_ball(acb_realref(z), p), to_ball(acb_imagref(z), p)};
}

}  // namespace polhode::detail

#endif
