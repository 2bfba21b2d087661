// Intervals of doubles from numbers and balls, and back, and as text; and whether this processor
// rounds as they need.

#include "polhode/arithmetic/double_interval.hpp"

#include <cmath>
#include <ostream>

#include "polhode/arithmetic/mpfr_cell.hpp"

namespace polhode {

using detail::least_double;
using detail::least_normal_double;

bool double_interval::environment_is_sound() {
  volatile double one = 1;
  volatile double half_step = 0x1p-53;
  volatile double more = 0x1.8p-53;
  volatile double least_normal = least_normal_double;
  volatile double least = least_double;
  const bool to_nearest = one + half_step == 1 && one + more > 1 && -one - half_step == -1 &&
                          -one - more < -1 && one - 0x1p-55 == 1;
  const bool keeps_subnormals =
      least_normal * 0.5 > 0 && least + least == 2 * least_double && least > 0;
  return to_nearest && keeps_subnormals;
}

double_interval double_interval::from_integer(mpz_srcptr n) {
  detail::mpfr_cell end(53);
  mpfr_set_z(end.get(), n, MPFR_RNDD);
  const double low = mpfr_get_d(end.get(), MPFR_RNDD);
  mpfr_set_z(end.get(), n, MPFR_RNDU);
  return ends(low, mpfr_get_d(end.get(), MPFR_RNDU));
}

double_interval double_interval::from_rational(mpq_srcptr q) {
  constexpr std::size_t bits = 53;
  if (mpz_sizeinbase(mpq_numref(q), 2) <= bits && mpz_sizeinbase(mpq_denref(q), 2) <= bits) {
    const double n = mpz_get_d(mpq_numref(q));
    const double d = mpz_get_d(mpq_denref(q));
    const double nearest = n / d;
    // n - d nearest is a double (the remainder of a division), far above the least one; its sign is
    // that of n/d - nearest.
    const double rest = std::fma(-nearest, d, n);
    if (rest == 0) return double_interval(nearest);
    return rest > 0 ? ends(nearest, detail::next_up(nearest))
                    : ends(detail::next_down(nearest), nearest);
  }
  detail::mpfr_cell end(53);
  mpfr_set_q(end.get(), q, MPFR_RNDD);
  const double low = mpfr_get_d(end.get(), MPFR_RNDD);
  mpfr_set_q(end.get(), q, MPFR_RNDU);
  return ends(low, mpfr_get_d(end.get(), MPFR_RNDU));
}

double_interval double_interval::from_ball(const ball& x) {
  if (x.is_undefined()) return undefined();
  detail::mpfr_cell end(53);
  x.lower(end.get());
  const double low = mpfr_get_d(end.get(), MPFR_RNDD);
  x.upper(end.get());
  return ends(low, mpfr_get_d(end.get(), MPFR_RNDU));
}

ball to_ball(const double_interval& x, precision p) {
  if (x.is_undefined()) return ball::undefined(p);
  detail::mpfr_cell lower(53);
  detail::mpfr_cell upper(53);
  mpfr_set_d(lower.get(), x.lower(), MPFR_RNDN);
  mpfr_set_d(upper.get(), x.upper(), MPFR_RNDN);
  return ball::from_end_points(lower.get(), upper.get(), p);
}

std::ostream& operator<<(std::ostream& out, const double_interval& x) {
  if (x.is_undefined()) return out << "undefined";
  detail::mpfr_cell lower(53);
  detail::mpfr_cell upper(53);
  mpfr_set_d(lower.get(), x.lower(), MPFR_RNDN);
  mpfr_set_d(upper.get(), x.upper(), MPFR_RNDN);
  char text[80];
  mpfr_snprintf(text, sizeof text, "[%.17RDg, %.17RUg]", lower.get(), upper.get());
  return out << text;
}

}  // namespace polhode
