// Sums, products and quotients of balls, and of a ball and an integer. Narrow balls by midpoint and
// radius: the midpoints' result, rounded once, and a bound of the error in 64-bit integers. Others
// by their ends.

#include <algorithm>
#include <cstdint>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/exact_product.hpp"
#include "arithmetic/ball/forms.hpp"
#include "arithmetic/ball/raw_error.hpp"
#include "arithmetic/ball/short_product.hpp"
#include "polhode/arithmetic/ball.hpp"

namespace polhode {

using detail::both_by_midpoint;
using detail::common_precision;
using detail::end_points;
using detail::leading_bits;
using detail::mpfr_cell;
using detail::multiply_to_nearest;
using detail::product_error;
using detail::raw;
using detail::raw_error;
using detail::raw_product;
using detail::raw_sum;
using detail::set_midpoint;
using detail::set_regular;
using form = ball_access::form;

namespace {

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

}  // namespace polhode
