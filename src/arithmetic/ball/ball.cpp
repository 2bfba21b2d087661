#include "polhode/arithmetic/ball.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "ball_access.hpp"
#include "exact_product.hpp"
#include "raw_error.hpp"
#include "short_product.hpp"

namespace polhode {

using detail::end_points;
using detail::finish_regular;
using detail::is_wide;
using detail::leading_bits;
using detail::mpfr_cell;
using detail::multiply_to_nearest;
using detail::pass_to_end_points;
using detail::product_error;
using detail::raw;
using detail::raw_error;
using detail::raw_product;
using detail::raw_sum;
using detail::set_midpoint;
using detail::set_regular;
using form = ball_access::form;

namespace {

// Above this radius, relative to the midpoint, a ball is kept by its end points: the rounding of the
// radius to 31 bits then costs at most 2^-54 of an end.
constexpr int widest_radius_log2 = -24;

precision common_precision(const ball& x, const ball& y) {
  return std::max(x.precision(), y.precision());
}

bool both_by_midpoint(const ball& x, const ball& y) {
  return ball_access::is_midpoint_radius(x) && ball_access::is_midpoint_radius(y);
}

int sign_of_number(mpfr_srcptr x) { return mpfr_sgn(x); }

/// A product with the convention of interval arithmetic, 0 * infinity = 0: an infinite end is a
/// bound that is not attained.
void end_product(mpfr_ptr r, mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t rounding) {
  if (mpfr_zero_p(x) != 0 || mpfr_zero_p(y) != 0) {
    mpfr_set_zero(r, 1);
  } else {
    mpfr_mul(r, x, y, rounding);
  }
}

/// The product of two sets with known ends, by the signs of the ends.
void multiply_ends(ball& result, const end_points& x, const end_points& y, precision p) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  const auto low = [&](mpfr_srcptr s, mpfr_srcptr t) { end_product(lower.get(), s, t, MPFR_RNDD); };
  const auto high = [&](mpfr_srcptr s, mpfr_srcptr t) {
    end_product(upper.get(), s, t, MPFR_RNDU);
  };
  const mpfr_srcptr a = x.lower();
  const mpfr_srcptr b = x.upper();
  const mpfr_srcptr c = y.lower();
  const mpfr_srcptr d = y.upper();
  const bool x_above = sign_of_number(a) >= 0;
  const bool x_below = sign_of_number(b) <= 0;
  const bool y_above = sign_of_number(c) >= 0;
  const bool y_below = sign_of_number(d) <= 0;
  if (x_above) {
    low(y_above ? a : b, c);
    high(y_below ? a : b, d);
  } else if (x_below) {
    low(y_below ? b : a, d);
    high(y_above ? b : a, c);
  } else if (y_above) {
    low(a, d);
    high(b, d);
  } else if (y_below) {
    low(b, c);
    high(a, c);
  } else {  // 0 is inside both: two candidates for each end
    mpfr_cell other(p);
    low(a, d);
    end_product(other.get(), b, c, MPFR_RNDD);
    if (mpfr_less_p(other.get(), lower.get()) != 0) lower.swap(other);
    other.reset(p);
    high(a, c);
    end_product(other.get(), b, d, MPFR_RNDU);
    if (mpfr_greater_p(other.get(), upper.get()) != 0) upper.swap(other);
  }
  ball_access::set_ends(result, lower, upper);
}

/// The quotient, for a divisor with all its members of one sign. An infinite end of the divisor
/// never meets an infinite end of the dividend here: see which end each case takes.
void divide_ends(ball& result, const end_points& x, const end_points& y, precision p) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  const mpfr_srcptr a = x.lower();
  const mpfr_srcptr b = x.upper();
  const mpfr_srcptr c = y.lower();
  const mpfr_srcptr d = y.upper();
  if (sign_of_number(c) > 0) {
    mpfr_div(lower.get(), a, sign_of_number(a) >= 0 ? d : c, MPFR_RNDD);
    mpfr_div(upper.get(), b, sign_of_number(b) >= 0 ? c : d, MPFR_RNDU);
  } else {
    mpfr_div(lower.get(), b, sign_of_number(b) >= 0 ? d : c, MPFR_RNDD);
    mpfr_div(upper.get(), a, sign_of_number(a) >= 0 ? c : d, MPFR_RNDU);
  }
  ball_access::set_ends(result, lower, upper);
}

/// The error of x / y for balls by midpoint with |my| > ry, bounded through
/// |x/y - mx/my| = |my dx - mx dy| / |my (my + dy)| <= (rx + |mx/my| ry) / (|my| - ry),
/// where ry < 2^-23 |my|: |my| - ry > |my| - 2^7 units of its 30 leading bits.
raw_error quotient_error(const ball& x, const ball& y) {
  const magnitude& rx = ball_access::radius(x);
  const magnitude& ry = ball_access::radius(y);
  if (rx.is_zero() && ry.is_zero()) return {};
  const leading_bits my(ball_access::first(y));
  const std::uint64_t divisor = my.bits - 129;
  raw_error numerator = raw(rx);  // below 2^61
  if (!ry.is_zero() && mpfr_regular_p(ball_access::first(x)) != 0) {
    const leading_bits mx(ball_access::first(x));
    const std::uint64_t ratio =
        ((mx.bits + 1) << 30) / my.bits + 1;  // |mx/my| 2^30, at most 2^31 + 1
    numerator = raw_sum(numerator, raw_product(ratio, mx.exponent - my.exponent - 30, ry));
  }
  if (numerator.bits == 0) return {};  // x is exactly 0
  // At most 2^62 / 2^28, and one for the rounding; 28 bits are kept at least.
  const std::uint64_t quotient = numerator.bits / divisor + 1;
  return {quotient << 24, numerator.exponent - my.exponent - 24};
}

}  // namespace

// ---------------------------------------------------------------------------------------------
// The two ways of making a ball.

magnitude detail::rounding_error(mpfr_srcptr x) {
  const mpfr_prec_t p = mpfr_get_prec(x);
  if (mpfr_regular_p(x) != 0) {
    const magnitude half_ulp = magnitude::power_of_two(std::int64_t{mpfr_get_exp(x)} - p - 1);
    const auto* significand = static_cast<const mp_limb_t*>(mpfr_custom_get_significand(x));
    const mp_limb_t top = significand[(p - 1) / GMP_NUMB_BITS];
    // A result that underflowed to the least positive number has a bare top bit.
    if (top != mp_limb_t{1} << (GMP_NUMB_BITS - 1) || mpfr_get_exp(x) > mpfr_get_emin()) {
      return half_ulp;
    }
    return max(half_ulp, magnitude::power_of_two(std::int64_t{mpfr_get_emin()} - 1));
  }
  if (mpfr_zero_p(x) != 0) return magnitude::power_of_two(std::int64_t{mpfr_get_emin()} - 1);
  return magnitude::infinity();
}

/// Passes a ball by midpoint and radius to the form of end points.
void detail::pass_to_end_points(ball& r) {
  const precision p = r.precision();
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  r.lower(lower.get());
  r.upper(upper.get());
  ball_access::first(r).swap(lower);
  ball_access::second(r).swap(upper);
  ball_access::set_form(r, form::end_points);
}

namespace {
/// The middle of two finite numbers, low <= high; between them where r has no fewer bits than they.
void set_middle(mpfr_ptr r, mpfr_srcptr low, mpfr_srcptr high) {
  mpfr_add(r, low, high, MPFR_RNDN);
  if (mpfr_inf_p(r) == 0) {
    mpfr_div_2ui(r, r, 1, MPFR_RNDN);
    return;
  }
  mpfr_cell half(mpfr_get_prec(low));  // the sum overflowed: the sum of the halves does not
  mpfr_div_2ui(half.get(), low, 1, MPFR_RNDN);
  mpfr_div_2ui(r, high, 1, MPFR_RNDN);
  mpfr_add(r, half.get(), r, MPFR_RNDN);
}

}  // namespace

bool detail::is_wide(mpfr_srcptr midpoint, const magnitude& radius) {
  if (radius.is_zero()) return false;
  return mpfr_regular_p(midpoint) == 0 ||
         radius.log2_floor() >= std::int64_t{mpfr_get_exp(midpoint)} + widest_radius_log2;
}

namespace {
/// r = x + direction * radius, rounded in that direction.
void shifted_by_radius(mpfr_ptr r, mpfr_srcptr x, const magnitude& radius, int direction) {
  const mpfr_rnd_t rounding = direction < 0 ? MPFR_RNDD : MPFR_RNDU;
  if (radius.is_zero()) {
    mpfr_set(r, x, rounding);
    return;
  }
  mpfr_cell offset(32);
  // 31 bits are exact in 32; an underflow goes away from zero, which is the safe side.
  mpfr_set_ui_2exp(offset.get(), radius.fraction(), static_cast<mpfr_exp_t>(radius.exponent()),
                   MPFR_RNDU);
  if (direction < 0) {
    mpfr_sub(r, x, offset.get(), rounding);
  } else {
    mpfr_add(r, x, offset.get(), rounding);
  }
}

/// A number that MPFR rounded to an infinity in round-to-nearest: it is at least as great in size as
/// the greatest number of its precision, and the members lie within `error` of it.
void set_overflowed(ball& r, const magnitude& error) {
  const precision p = r.precision();
  const bool positive = mpfr_sgn(ball_access::first(std::as_const(r))) > 0;
  mpfr_cell greatest(p);
  mpfr_set_inf(greatest.get(), positive ? 1 : -1);
  if (positive) {
    mpfr_nextbelow(greatest.get());
  } else {
    mpfr_nextabove(greatest.get());
  }
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_set_inf(lower.get(), -1);
  mpfr_set_inf(upper.get(), 1);
  shifted_by_radius((positive ? lower : upper).get(), greatest.get(), error, positive ? -1 : 1);
  ball_access::set_ends(r, lower, upper);
}
}  // namespace

void ball_access::finish(ball& r, int ternary, const magnitude& error) {
  const mpfr_srcptr midpoint = first(std::as_const(r));
  if (mpfr_nan_p(midpoint) != 0) {
    r.form_ = form::undefined;
    return;
  }
  r.radius_ = ternary == 0 ? error : add_up(error, detail::rounding_error(midpoint));
  r.form_ = form::midpoint_radius;
  if (mpfr_inf_p(midpoint) != 0 && ternary != 0 && !error.is_infinite()) {
    set_overflowed(r, error);
  } else if (mpfr_inf_p(midpoint) != 0 || r.radius_.is_infinite()) {
    r = ball::entire(r.precision());
  } else if (is_wide(midpoint, r.radius_)) {
    pass_to_end_points(r);
  }
}

namespace {
/// Ends of one sign that agree to half the precision.
bool are_close(mpfr_srcptr lower, mpfr_srcptr upper, mpfr_ptr width) {
  if (mpfr_regular_p(lower) == 0 || mpfr_regular_p(upper) == 0 ||
      sign_of_number(lower) != sign_of_number(upper) ||
      std::abs(mpfr_get_exp(lower) - mpfr_get_exp(upper)) > 1) {
    return false;
  }
  mpfr_sub(width, upper, lower, MPFR_RNDU);
  return mpfr_get_exp(width) <=
         mpfr_get_exp(lower) - std::max<precision>(mpfr_get_prec(lower) / 2, 32);
}
}  // namespace

void ball_access::set_ends(ball& r, mpfr_cell& lower, mpfr_cell& upper, bool exactly) {
  const precision p = mpfr_get_prec(lower.get());
  if (mpfr_nan_p(lower.get()) != 0 || mpfr_nan_p(upper.get()) != 0) {
    set_undefined(r, p);
    return;
  }
  if (mpfr_equal_p(lower.get(), upper.get()) != 0 && mpfr_number_p(lower.get()) != 0) {
    r.first_ = std::move(lower);
    r.radius_ = {};
    r.form_ = form::midpoint_radius;
    return;
  }
  mpfr_cell width(64);
  if (are_close(lower.get(), upper.get(), width.get())) {
    mpfr_cell middle(p);
    set_middle(middle.get(), lower.get(), upper.get());
    bool is_same = mpfr_sub(width.get(), upper.get(), middle.get(), MPFR_RNDU) == 0;
    const magnitude above = magnitude::abs_up(width.get());
    is_same = magnitude::abs_down(width.get()) == above && is_same;
    is_same = mpfr_sub(width.get(), middle.get(), lower.get(), MPFR_RNDU) == 0 && is_same;
    const magnitude below = magnitude::abs_up(width.get());
    is_same = magnitude::abs_down(width.get()) == above && below == above && is_same;
    if (is_same || !exactly) {
      r.first_ = std::move(middle);
      r.radius_ = max(above, below);
      r.form_ = form::midpoint_radius;
      return;
    }
  }
  r.first_ = std::move(lower);
  r.second_ = std::move(upper);
  r.form_ = form::end_points;
}

void ball_access::set_ends(ball& r, mpfr_cell& lower, mpfr_cell& upper) {
  set_ends(r, lower, upper, false);
}
void ball_access::set_exact_ends(ball& r, mpfr_cell& lower, mpfr_cell& upper) {
  set_ends(r, lower, upper, true);
}

detail::end_points::end_points(const ball& x, precision p) {
  if (ball_access::form_of(x) == form::end_points) {
    lower_ = ball_access::first(x);
    upper_ = ball_access::second(x);
    return;
  }
  if (x.is_exact()) {
    lower_ = upper_ = ball_access::first(x);
    return;
  }
  computed_lower_.reset(p);
  computed_upper_.reset(p);
  x.lower(computed_lower_.get());
  x.upper(computed_upper_.get());
  lower_ = computed_lower_.get();
  upper_ = computed_upper_.get();
}

// ---------------------------------------------------------------------------------------------
// Construction.

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

// ---------------------------------------------------------------------------------------------
// Queries.

bool ball::is_bounded() const {
  switch (form_) {
    case form::midpoint_radius:
      return true;
    case form::end_points:
      return mpfr_inf_p(first_.get()) == 0 && mpfr_inf_p(second_.get()) == 0;
    case form::undefined:
      return false;
  }
  return false;
}

bool ball::is_exact() const { return form_ == form::midpoint_radius && radius_.is_zero(); }

void ball::lower(mpfr_ptr r) const {
  switch (form_) {
    case form::midpoint_radius:
      shifted_by_radius(r, first_.get(), radius_, -1);
      break;
    case form::end_points:
      mpfr_set(r, first_.get(), MPFR_RNDD);
      break;
    case form::undefined:
      mpfr_set_nan(r);
      break;
  }
}

void ball::upper(mpfr_ptr r) const {
  switch (form_) {
    case form::midpoint_radius:
      shifted_by_radius(r, first_.get(), radius_, 1);
      break;
    case form::end_points:
      mpfr_set(r, second_.get(), MPFR_RNDU);
      break;
    case form::undefined:
      mpfr_set_nan(r);
      break;
  }
}

void ball::midpoint(mpfr_ptr r) const {
  switch (form_) {
    case form::midpoint_radius:
      mpfr_set(r, first_.get(), MPFR_RNDN);
      break;
    case form::end_points:
      if (!is_bounded()) {
        const bool lower_infinite = mpfr_inf_p(first_.get()) != 0;
        const bool upper_infinite = mpfr_inf_p(second_.get()) != 0;
        if (lower_infinite && upper_infinite) {
          mpfr_set_zero(r, 1);
        } else {
          mpfr_set(r, lower_infinite ? second_.get() : first_.get(), MPFR_RNDN);
        }
      } else {
        set_middle(r, first_.get(), second_.get());
      }
      break;
    case form::undefined:
      mpfr_set_nan(r);
      break;
  }
}

magnitude ball::radius() const {
  switch (form_) {
    case form::midpoint_radius:
      return radius_;
    case form::end_points: {
      if (!is_bounded()) return magnitude::infinity();
      // The midpoint is rounded: the greater of the two distances to it is the radius.
      mpfr_cell middle(precision());
      midpoint(middle.get());
      mpfr_cell distance(64);
      mpfr_sub(distance.get(), second_.get(), middle.get(), MPFR_RNDU);
      const magnitude above = magnitude::abs_up(distance.get());
      mpfr_sub(distance.get(), middle.get(), first_.get(), MPFR_RNDU);
      return max(above, magnitude::abs_up(distance.get()));
    }
    case form::undefined:
      break;
  }
  return magnitude::infinity();
}

magnitude ball::magnitude_upper() const {
  switch (form_) {
    case form::midpoint_radius:
      return add_up(magnitude::abs_up(first_.get()), radius_);
    case form::end_points:
      return max(magnitude::abs_up(first_.get()), magnitude::abs_up(second_.get()));
    case form::undefined:
      break;
  }
  return magnitude::infinity();
}

magnitude ball::magnitude_lower() const {
  switch (form_) {
    case form::midpoint_radius:
      return subtract_down(magnitude::abs_down(first_.get()), radius_);
    case form::end_points:
      if (mpfr_sgn(first_.get()) > 0) return magnitude::abs_down(first_.get());
      if (mpfr_sgn(second_.get()) < 0) return magnitude::abs_down(second_.get());
      return {};
    case form::undefined:
      break;
  }
  return {};
}

ball ball::with_precision(polhode::precision p) const {
  checked_precision(p);
  ball r;
  switch (form_) {
    case form::midpoint_radius: {
      r.first_.reset(p);
      const int ternary = mpfr_set(r.first_.get(), first_.get(), MPFR_RNDN);
      ball_access::finish(r, ternary, radius_);
      break;
    }
    case form::end_points: {
      mpfr_cell low(p);
      mpfr_cell high(p);
      mpfr_set(low.get(), first_.get(), MPFR_RNDD);
      mpfr_set(high.get(), second_.get(), MPFR_RNDU);
      ball_access::set_exact_ends(r, low, high);
      break;
    }
    case form::undefined:
      return undefined(p);
  }
  return r;
}

ball ball::middle() const {
  if (!is_bounded()) return undefined(precision());
  ball r;
  r.first_.reset(precision());
  midpoint(r.first_.get());
  return r;
}

ball ball::enlarged(const magnitude& error) const {
  ball r = *this;
  if (error.is_zero()) return r;
  if (form_ == form::midpoint_radius) {
    ball_access::finish(r, 0, add_up(radius_, error));
  } else if (form_ == form::end_points) {
    if (error.is_infinite()) return entire(precision());
    mpfr_cell low(precision());
    mpfr_cell high(precision());
    shifted_by_radius(low.get(), first_.get(), error, -1);
    shifted_by_radius(high.get(), second_.get(), error, 1);
    ball_access::set_ends(r, low, high);
  }
  return r;
}

// ---------------------------------------------------------------------------------------------
// Arithmetic.

void add(ball& result, const ball& x, const ball& y) {
  const precision p = common_precision(x, y);
  if (both_by_midpoint(x, y)) {
    set_regular(result, p, raw_sum(raw(x.radius_), raw(y.radius_)),
                [&](mpfr_ptr r) { return mpfr_add(r, x.first_.get(), y.first_.get(), MPFR_RNDN); });
    return;
  }
  if (x.is_undefined() || y.is_undefined()) return ball_access::set_undefined(result, p);
  const end_points ex(x, p);
  const end_points ey(y, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_add(lower.get(), ex.lower(), ey.lower(), MPFR_RNDD);
  mpfr_add(upper.get(), ex.upper(), ey.upper(), MPFR_RNDU);
  ball_access::set_ends(result, lower, upper);
}

void subtract(ball& result, const ball& x, const ball& y) {
  const precision p = common_precision(x, y);
  if (both_by_midpoint(x, y)) {
    set_regular(result, p, raw_sum(raw(x.radius_), raw(y.radius_)),
                [&](mpfr_ptr r) { return mpfr_sub(r, x.first_.get(), y.first_.get(), MPFR_RNDN); });
    return;
  }
  if (x.is_undefined() || y.is_undefined()) return ball_access::set_undefined(result, p);
  const end_points ex(x, p);
  const end_points ey(y, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_sub(lower.get(), ex.lower(), ey.upper(), MPFR_RNDD);
  mpfr_sub(upper.get(), ex.upper(), ey.lower(), MPFR_RNDU);
  ball_access::set_ends(result, lower, upper);
}

void multiply(ball& result, const ball& x, const ball& y) {
  const precision p = common_precision(x, y);
  if (both_by_midpoint(x, y)) {
    set_regular(result, p, product_error(x, y),
                [&](mpfr_ptr r) { return multiply_to_nearest(r, x.first_.get(), y.first_.get()); });
    return;
  }
  if (x.is_undefined() || y.is_undefined()) return ball_access::set_undefined(result, p);
  multiply_ends(result, end_points(x, p), end_points(y, p), p);
}

void divide(ball& result, const ball& x, const ball& y) {
  const precision p = common_precision(x, y);
  if (x.is_undefined() || y.is_undefined() || contains_zero(y)) {
    return ball_access::set_undefined(result, p);
  }
  if (both_by_midpoint(x, y)) {
    set_regular(result, p, quotient_error(x, y),
                [&](mpfr_ptr r) { return mpfr_div(r, x.first_.get(), y.first_.get(), MPFR_RNDN); });
    return;
  }
  const end_points ey(y, p);
  // A radius below the least positive number is rounded up to it: an end may come to 0 only here.
  if (mpfr_zero_p(ey.lower()) != 0 || mpfr_zero_p(ey.upper()) != 0) {
    return ball_access::set_undefined(result, p);
  }
  divide_ends(result, end_points(x, p), ey, p);
}

void fma(ball& result, const ball& x, const ball& y, const ball& z) {
  const precision p = std::max(common_precision(x, y), z.precision());
  if (both_by_midpoint(x, y) && ball_access::is_midpoint_radius(z)) {
    set_regular(result, p, raw_sum(product_error(x, y), raw(z.radius_)), [&](mpfr_ptr r) {
      return detail::product_and_sum(r, x.first_.get(), y.first_.get(), z.first_.get());
    });
    return;
  }
  const ball addend = z;  // z may be the result
  multiply(result, x, y);
  add(result, result, addend);
}

namespace {
/// f(result, x, the integer y), with x's precision: an integer has none of its own.
template <class F>
void with_exact_integer(ball& result, const ball& x, long y, F&& f) {
  const precision p = x.precision();  // x may be the result
  f(result, x, ball(y, 64));
  if (result.precision() != p) result = result.with_precision(p);
}
}  // namespace

void add(ball& result, const ball& x, long y) {
  if (ball_access::is_midpoint_radius(x)) {
    set_midpoint(result, x.precision(), x.radius_,
                 [&](mpfr_ptr r) { return mpfr_add_si(r, x.first_.get(), y, MPFR_RNDN); });
    return;
  }
  with_exact_integer(result, x, y, [](ball& r, const ball& a, const ball& n) { add(r, a, n); });
}

void subtract(ball& result, long x, const ball& y) {
  if (ball_access::is_midpoint_radius(y)) {
    set_midpoint(result, y.precision(), y.radius_,
                 [&](mpfr_ptr r) { return mpfr_si_sub(r, x, y.first_.get(), MPFR_RNDN); });
    return;
  }
  with_exact_integer(result, y, x,
                     [](ball& r, const ball& a, const ball& n) { subtract(r, n, a); });
}

void multiply(ball& result, const ball& x, long y) {
  if (ball_access::is_midpoint_radius(x)) {
    const std::uint64_t size =
        y < 0 ? 0 - static_cast<std::uint64_t>(y) : static_cast<std::uint64_t>(y);
    const magnitude error = x.radius_.is_zero()
                                ? magnitude{}
                                : multiply_up(x.radius_, magnitude::from_integer_up(size));
    set_midpoint(result, x.precision(), error,
                 [&](mpfr_ptr r) { return mpfr_mul_si(r, x.first_.get(), y, MPFR_RNDN); });
    return;
  }
  with_exact_integer(result, x, y,
                     [](ball& r, const ball& a, const ball& n) { multiply(r, a, n); });
}

void divide(ball& result, const ball& x, long y) {
  if (y != 0 && ball_access::is_midpoint_radius(x)) {
    const std::uint64_t size =
        y < 0 ? 0 - static_cast<std::uint64_t>(y) : static_cast<std::uint64_t>(y);
    const magnitude error = x.radius_.is_zero()
                                ? magnitude{}
                                : divide_up(x.radius_, magnitude::from_integer_down(size));
    set_midpoint(result, x.precision(), error,
                 [&](mpfr_ptr r) { return mpfr_div_si(r, x.first_.get(), y, MPFR_RNDN); });
    return;
  }
  with_exact_integer(result, x, y, [](ball& r, const ball& a, const ball& n) { divide(r, a, n); });
}

void square(ball& result, const ball& x) {
  const precision p = x.precision();
  if (ball_access::is_midpoint_radius(x)) {
    // |x^2 - m^2| <= (2|m| + r) r, and r is below 64 units of m's 30 leading bits.
    raw_error error;
    if (!x.radius_.is_zero()) {
      const leading_bits m(x.first_.get());
      error = raw_product(m.bits + 33, m.exponent + 1, x.radius_);
    }
    set_regular(result, p, error, [&](mpfr_ptr r) {
      // At two limbs, where mpfr_sqr has no short way of its own.
      return p > 64 && p <= 128 ? multiply_to_nearest(r, x.first_.get(), x.first_.get())
                                : mpfr_sqr(r, x.first_.get(), MPFR_RNDN);
    });
    return;
  }
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  const mpfr_srcptr a = x.first_.get();
  const mpfr_srcptr b = x.second_.get();
  if (mpfr_cmpabs(a, b) <= 0) {
    mpfr_sqr(upper.get(), b, MPFR_RNDU);
  } else {
    mpfr_sqr(upper.get(), a, MPFR_RNDU);
  }
  if (mpfr_sgn(a) > 0) {
    mpfr_sqr(lower.get(), a, MPFR_RNDD);
  } else if (mpfr_sgn(b) < 0) {
    mpfr_sqr(lower.get(), b, MPFR_RNDD);
  }
  ball_access::set_ends(result, lower, upper);
}

void sqrt(ball& result, const ball& x) {
  const precision p = x.precision();
  if (x.is_undefined() || sign_of(x) == sign::negative) {
    return ball_access::set_undefined(result, p);
  }
  if (ball_access::is_midpoint_radius(x)) {  // m > r, or exactly 0
    const magnitude radius = x.radius_;
    mpfr_cell fresh;
    mpfr_cell& own = result.first_;
    const bool in_place = mpfr_get_prec(own.get()) == p && &result != &x;
    if (!in_place) fresh.reset(p);
    mpfr_cell& target = in_place ? own : fresh;
    const int ternary = mpfr_sqrt(target.get(), x.first_.get(), MPFR_RNDN);
    // |sqrt(m + d) - sqrt(m)| = |d| / (sqrt(m + d) + sqrt(m)) <= r / (2 sqrt(m - r)), and for p >= 32
    // sqrt(m - r) > s - 129 units of the 30 leading bits of s = sqrt(m) rounded: half a unit of the last
    // place is less than one of these, and sqrt(m) - sqrt(m - r) < 2^-23 sqrt(m).
    raw_error error;
    if (!radius.is_zero()) {
      const leading_bits s(target.get());
      if (p >= 32) {
        error = {(raw(radius).bits / (s.bits - 129) + 1) << 24,
                 radius.exponent() - s.exponent - 55};
      } else {
        const magnitude m = magnitude::abs_down(x.first_.get());
        error = raw(divide_up(scale(radius, -1), sqrt_down(subtract_down(m, radius))));
      }
    }
    if (!in_place) own = std::move(fresh);
    finish_regular(result, own.get(), ternary, error);
    return;
  }
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_sqrt(lower.get(), x.first_.get(), MPFR_RNDD);  // a NaN where the lower end is negative
  mpfr_sqrt(upper.get(), x.second_.get(), MPFR_RNDU);
  ball_access::set_ends(result, lower, upper);
}

void scale(ball& result, const ball& x, long n) {
  const precision p = x.precision();
  if (ball_access::is_midpoint_radius(x)) {
    set_midpoint(result, p, scale(x.radius_, std::int64_t{n}),
                 [&](mpfr_ptr r) { return mpfr_mul_2si(r, x.first_.get(), n, MPFR_RNDN); });
    return;
  }
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_mul_2si(lower.get(), x.first_.get(), n, MPFR_RNDD);
  mpfr_mul_2si(upper.get(), x.second_.get(), n, MPFR_RNDU);
  ball_access::set_exact_ends(result, lower, upper);
}

void negate(ball& result, const ball& x) {
  if (&result != &x) result = x;
  mpfr_neg(result.first_.get(), result.first_.get(), MPFR_RNDN);
  if (result.form_ == form::end_points) {
    mpfr_neg(result.second_.get(), result.second_.get(), MPFR_RNDN);
    result.first_.swap(result.second_);
  }
}

// ---------------------------------------------------------------------------------------------
// Comparisons. Ends are compared exactly: an MPFR sum has no rounding where its sign is asked.

namespace {
/// The sign of (upper end of x) - (lower end of y), rounded up: never too small.
class ends_pair {
 public:
  ends_pair(const ball& x, const ball& y) : p_(common_precision(x, y) + 32), x_(x, p_), y_(y, p_) {}
  [[nodiscard]] const end_points& x() const { return x_; }
  [[nodiscard]] const end_points& y() const { return y_; }

 private:
  precision p_;
  end_points x_;
  end_points y_;
};
}  // namespace

bool certainly_less(const ball& x, const ball& y) {
  if (x.is_undefined() || y.is_undefined()) return false;
  const ends_pair e(x, y);
  // Equal infinite ends are not attained, and not less either.
  return mpfr_less_p(e.x().upper(), e.y().lower()) != 0;
}

bool certainly_less_equal(const ball& x, const ball& y) {
  if (x.is_undefined() || y.is_undefined()) return false;
  const ends_pair e(x, y);
  return mpfr_lessequal_p(e.x().upper(), e.y().lower()) != 0;
}

bool possibly_less(const ball& x, const ball& y) { return !certainly_less_equal(y, x); }

bool certainly_less(const ball& x, long y) { return certainly_less(x, ball(y, 64)); }
bool certainly_greater(const ball& x, long y) { return certainly_less(ball(y, 64), x); }

bool overlaps(const ball& x, const ball& y) {
  return !certainly_less(x, y) && !certainly_less(y, x);
}

bool contains(const ball& x, const ball& y) {
  if (x.is_undefined() || y.is_undefined()) return false;
  // Inner bounds of x against outer bounds of y.
  const precision p = common_precision(x, y) + 64;
  const end_points ey(y, p);
  if (ball_access::form_of(x) == form::end_points) {
    return mpfr_lessequal_p(ball_access::first(x), ey.lower()) != 0 &&
           mpfr_lessequal_p(ey.upper(), ball_access::second(x)) != 0;
  }
  mpfr_cell distance(64);
  mpfr_cell radius(32);
  const magnitude& r = ball_access::radius(x);
  if (!r.is_zero()) {  // an underflow goes towards zero here: the inner side
    mpfr_set_ui_2exp(radius.get(), r.fraction(), static_cast<mpfr_exp_t>(r.exponent()), MPFR_RNDD);
  }
  mpfr_sub(distance.get(), ball_access::first(x), ey.lower(), MPFR_RNDU);
  if (mpfr_greater_p(distance.get(), radius.get()) != 0) return false;
  mpfr_sub(distance.get(), ey.upper(), ball_access::first(x), MPFR_RNDU);
  return mpfr_lessequal_p(distance.get(), radius.get()) != 0;
}

bool contains(const ball& x, mpq_srcptr y) {
  if (x.is_undefined()) return false;
  if (ball_access::form_of(x) == form::end_points) {
    return mpfr_cmp_q(ball_access::first(x), y) <= 0 && mpfr_cmp_q(ball_access::second(x), y) >= 0;
  }
  // |y - m| <= r, decided in rationals.
  mpq_t difference;
  mpq_t radius;
  mpq_init(difference);
  mpq_init(radius);
  mpfr_get_q(difference, ball_access::first(x));
  mpq_sub(difference, y, difference);
  mpq_abs(difference, difference);
  const magnitude& r = ball_access::radius(x);
  bool inside = mpq_sgn(difference) == 0;
  if (!inside && !r.is_zero()) {
    // 2^(bits - 1) < |y - m| < 2^(bits + 1): where that decides, no power of two is written out.
    const auto bits = static_cast<std::int64_t>(mpz_sizeinbase(mpq_numref(difference), 2)) -
                      static_cast<std::int64_t>(mpz_sizeinbase(mpq_denref(difference), 2));
    if (r.log2_floor() >= bits + 1) {
      inside = true;
    } else if (r.log2_floor() + 1 > bits - 1) {
      mpq_set_ui(radius, r.fraction(), 1);
      if (r.exponent() >= 0) {
        mpq_mul_2exp(radius, radius, static_cast<mp_bitcnt_t>(r.exponent()));
      } else {
        mpq_div_2exp(radius, radius, static_cast<mp_bitcnt_t>(-r.exponent()));
      }
      inside = mpq_cmp(difference, radius) <= 0;
    }
  }
  mpq_clear(radius);
  mpq_clear(difference);
  return inside;
}

bool contains(const ball& x, long y) { return contains(x, ball(y, 64)); }

bool contains_zero(const ball& x) {
  if (ball_access::is_midpoint_radius(x)) {
    const mpfr_srcptr m = ball_access::first(x);
    const magnitude& r = ball_access::radius(x);
    return mpfr_zero_p(m) != 0 || magnitude::abs_down(m) <= r;  // is_wide keeps r far below |m|
  }
  if (x.is_undefined()) return false;
  return mpfr_sgn(ball_access::first(x)) <= 0 && mpfr_sgn(ball_access::second(x)) >= 0;
}

sign sign_of(const ball& x) {
  if (ball_access::is_midpoint_radius(x)) {
    const mpfr_srcptr m = ball_access::first(x);
    if (mpfr_zero_p(m) != 0) return x.is_exact() ? sign::zero : sign::unknown;
    if (contains_zero(x)) return sign::unknown;
    return mpfr_sgn(m) < 0 ? sign::negative : sign::positive;
  }
  if (x.is_undefined()) return sign::unknown;
  if (mpfr_sgn(ball_access::first(x)) > 0) return sign::positive;
  if (mpfr_sgn(ball_access::second(x)) < 0) return sign::negative;
  return sign::unknown;
}

// ---------------------------------------------------------------------------------------------
// Sets.

ball hull(const ball& x, const ball& y) {
  const precision p = common_precision(x, y);
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  const end_points ex(x, p);
  const end_points ey(y, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_min(lower.get(), ex.lower(), ey.lower(), MPFR_RNDD);
  mpfr_max(upper.get(), ex.upper(), ey.upper(), MPFR_RNDU);
  ball r;
  ball_access::set_exact_ends(r, lower, upper);
  return r;
}

ball intersection(const ball& x, const ball& y) {
  const precision p = common_precision(x, y);
  if (x.is_undefined() || y.is_undefined() || !overlaps(x, y)) return ball::undefined(p);
  const end_points ex(x, p);
  const end_points ey(y, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_max(lower.get(), ex.lower(), ey.lower(), MPFR_RNDD);
  mpfr_min(upper.get(), ex.upper(), ey.upper(), MPFR_RNDU);
  ball r;
  ball_access::set_exact_ends(r, lower, upper);
  return r;
}

}  // namespace polhode
