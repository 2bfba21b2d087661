// The two ways of making a ball: from a midpoint that MPFR rounded, with a bound of the error, and
// from two ends. Each keeps by midpoint and radius what is narrow, and by its ends what is wide.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/forms.hpp"
#include "arithmetic/ball/raw_error.hpp"

namespace polhode {

using detail::end_points;
using detail::is_wide;
using detail::mpfr_cell;
using detail::pass_to_end_points;
using detail::set_middle;
using detail::shifted_by_radius;
using form = ball_access::form;

namespace {

// Above this radius, relative to the midpoint, a ball is kept by its end points: the rounding of
// the radius to 31 bits then costs at most 2^-54 of an end.
constexpr int widest_radius_log2 = -24;

}  // namespace

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

void detail::set_middle(mpfr_ptr r, mpfr_srcptr low, mpfr_srcptr high) {
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

bool detail::is_wide(mpfr_srcptr midpoint, const magnitude& radius) {
  if (radius.is_zero()) return false;
  return mpfr_regular_p(midpoint) == 0 ||
         radius.log2_floor() >= std::int64_t{mpfr_get_exp(midpoint)} + widest_radius_log2;
}

void detail::shifted_by_radius(mpfr_ptr r, mpfr_srcptr x, const magnitude& radius, int direction) {
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

namespace {

/// A number that MPFR rounded to an infinity in round-to-nearest: it is at least as great in size
/// as the greatest number of its precision, and the members lie within `error` of it.
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
      mpfr_sgn(lower) != mpfr_sgn(upper) ||
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

}  // namespace polhode
