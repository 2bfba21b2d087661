// Balls from numbers, and from midpoints, radii and ends.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "arithmetic/ball/ball_access.hpp"
#include "polhode/arithmetic/ball.hpp"

namespace polhode {

using detail::end_points;
using detail::mpfr_cell;
using form = ball_access::form;

void ball::set_integer(long n, polhode::precision p) {
  first_.reset(checked_precision(p));
  const int ternary = mpfr_set_si(first_.get(), n, MPFR_RNDN);
  ball_access::finish(*this, ternary, {});
}
void ball::set_integer(unsigned long n, polhode::precision p) {
  first_.reset(checked_precision(p));
  const int ternary = mpfr_set_ui(first_.get(), n, MPFR_RNDN);
  ball_access::finish(*this, ternary, {});
}
ball::ball(mpz_srcptr n, polhode::precision p) : first_(checked_precision(p)) {
  const int ternary = mpfr_set_z(first_.get(), n, MPFR_RNDN);
  ball_access::finish(*this, ternary, {});
}
ball::ball(mpq_srcptr q, polhode::precision p) : first_(checked_precision(p)) {
  mpz_srcptr numerator = mpq_numref(q);
  mpz_srcptr denominator = mpq_denref(q);
  int ternary = 0;
  if (p >= 64 && mpz_fits_slong_p(numerator) != 0 && mpz_fits_ulong_p(denominator) != 0) {
    // The numerator is exact; and this takes a third of mpfr_set_q's time.
    mpfr_set_si(first_.get(), mpz_get_si(numerator), MPFR_RNDN);
    ternary = mpfr_div_ui(first_.get(), first_.get(), mpz_get_ui(denominator), MPFR_RNDN);
  } else {
    ternary = mpfr_set_q(first_.get(), q, MPFR_RNDN);
  }
  ball_access::finish(*this, ternary, {});
}
ball::ball(mpfr_srcptr x) : first_(std::max(mpfr_get_prec(x), least_precision)) {
  mpfr_set(first_.get(), x, MPFR_RNDN);
  if (mpfr_number_p(x) == 0) form_ = form::undefined;
}

ball ball::exactly(double x, polhode::precision p) {
  ball r;
  r.first_.reset(std::max<polhode::precision>(checked_precision(p), 53));
  // Inexact only where the caller has narrowed MPFR's range of exponents.
  const int ternary = mpfr_set_d(r.first_.get(), x, MPFR_RNDN);
  if (std::isfinite(x)) {
    ball_access::finish(r, ternary, {});
  } else {
    r.form_ = form::undefined;
  }
  return r;
}

ball ball::from_midpoint_radius(mpfr_srcptr midpoint, const magnitude& radius) {
  ball r(midpoint);
  if (!r.is_undefined()) ball_access::finish(r, 0, radius);
  return r;
}

namespace {
[[noreturn]] void bad_end_points(mpfr_srcptr lower, mpfr_srcptr upper, const char* accepted) {
  char text[100];
  mpfr_snprintf(text, sizeof text, "[%.9Rg, %.9Rg]", lower, upper);
  throw std::invalid_argument(std::string("end points of a ball ") + text + ": " + accepted);
}
}  // namespace

ball ball::from_end_points(mpfr_srcptr lower, mpfr_srcptr upper, polhode::precision p) {
  checked_precision(p);
  if (mpfr_nan_p(lower) != 0 || mpfr_nan_p(upper) != 0) {
    bad_end_points(lower, upper, "each must be a number or an infinity, and a NaN is neither");
  }
  if ((mpfr_inf_p(lower) != 0 && mpfr_sgn(lower) > 0) ||
      (mpfr_inf_p(upper) != 0 && mpfr_sgn(upper) < 0)) {
    bad_end_points(lower, upper,
                   "the lower one may be -inf and the upper one inf, not the reverse");
  }
  if (mpfr_greater_p(lower, upper) != 0) {
    bad_end_points(lower, upper, "the lower one must not exceed the upper one");
  }
  mpfr_cell low(p);
  mpfr_cell high(p);
  mpfr_set(low.get(), lower, MPFR_RNDD);
  mpfr_set(high.get(), upper, MPFR_RNDU);
  ball r;
  ball_access::set_exact_ends(r, low, high);
  return r;
}

ball ball::undefined(polhode::precision p) {
  ball r;
  ball_access::set_undefined(r, checked_precision(p));
  return r;
}

ball ball::entire(polhode::precision p) {
  ball r;
  r.first_.reset(checked_precision(p));
  r.second_.reset(p);
  mpfr_set_inf(r.first_.get(), -1);
  mpfr_set_inf(r.second_.get(), 1);
  r.form_ = form::end_points;
  return r;
}

}  // namespace polhode
