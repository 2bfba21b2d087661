// Functions that are constant but for steps, or piecewise linear: rounding, sign, absolute value,
// minimum and maximum. Their values at the ends are exact.

#include <algorithm>

#include "arithmetic/functions/elementary/carrying.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode {

using namespace detail::elementary;
using detail::end_points;
using detail::mpfr_cell;

namespace {

ball step_function(const ball& x, int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t)) {
  const precision p = x.precision();
  if (x.is_undefined()) return x;
  const end_points e(x, p + guard_bits);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  f(lower.get(), e.lower(), MPFR_RNDD);
  f(upper.get(), e.upper(), MPFR_RNDU);
  ball r;
  ball_access::set_exact_ends(r, lower, upper);
  return r;
}

ball lattice_operation(const ball& x, const ball& y,
                       int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t)) {
  const precision p = std::max(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  const end_points ex(x, p + guard_bits);
  const end_points ey(y, p + guard_bits);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  f(lower.get(), ex.lower(), ey.lower(), MPFR_RNDD);
  f(upper.get(), ex.upper(), ey.upper(), MPFR_RNDU);
  ball r;
  ball_access::set_exact_ends(r, lower, upper);
  return r;
}

}  // namespace

ball floor(const ball& x) { return step_function(x, mpfr_rint_floor); }
ball ceil(const ball& x) { return step_function(x, mpfr_rint_ceil); }
ball trunc(const ball& x) { return step_function(x, mpfr_rint_trunc); }
ball round_ties_to_even(const ball& x) { return step_function(x, mpfr_rint_roundeven); }
ball round_ties_to_away(const ball& x) { return step_function(x, mpfr_rint_round); }
ball signum(const ball& x) {
  return step_function(x, [](mpfr_ptr r, mpfr_srcptr end, mpfr_rnd_t rounding) {
    return mpfr_set_si(r, (mpfr_sgn(end) > 0) - (mpfr_sgn(end) < 0), rounding);
  });
}
ball min(const ball& x, const ball& y) { return lattice_operation(x, y, mpfr_min); }
ball max(const ball& x, const ball& y) { return lattice_operation(x, y, mpfr_max); }

ball abs(const ball& x) {
  const certain_sign s = sign_of(x);
  if (x.is_undefined() || s == certain_sign::positive || s == certain_sign::zero) return x;
  if (s == certain_sign::negative) return -x;
  const precision p = x.precision();
  const end_points e(x, p + guard_bits);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_abs(upper.get(), mpfr_cmpabs(e.lower(), e.upper()) <= 0 ? e.upper() : e.lower(), MPFR_RNDU);
  ball r;
  ball_access::set_ends(r, lower, upper);
  return r;
}

}  // namespace polhode
