// Powers and roots: with integer exponents, with balls as exponents, and the length of a vector.

#include <algorithm>
#include <cstdint>
#include <utility>

#include "arithmetic/functions/elementary/carrying.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode {

using namespace detail::elementary;
using detail::end_points;
using detail::mpfr_cell;

void rsqrt(ball& result, const ball& x) {
  if (sign_of(x) != certain_sign::positive)
    return ball_access::set_undefined(result, x.precision());
  if (!ball_access::is_midpoint_radius(x)) {
    const precision p = x.precision();
    return at_ends(result, end_points(x, p + guard_bits), p, mpfr_rec_sqrt, false);
  }
  // |(m+h)^(-1/2) - m^(-1/2)| <= m^(-1/2) ((1 - q)^(-1/2) - 1) with q = r / m < 2^-22. In the power
  // series of (1 - q)^(-1/2) the coefficients from q^2 on are at most 3/8, so it is at most 1 + q/2
  // + (3/8) q^2 / (1 - q) <= 1 + (q + q^2) / 2 for q <= 1/4.
  const magnitude q = divide_up(ball_access::radius(x), magnitude::abs_down(ball_access::first(x)));
  at_midpoint(result, x, mpfr_rec_sqrt, [&](mpfr_srcptr value) {
    return multiply_up(true_value_up(value), scale(plus_square_up(q), -1));
  });
}

ball hypot(const ball& x, const ball& y) {
  const precision p = std::max(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  if (ball_access::is_midpoint_radius(x) && ball_access::is_midpoint_radius(y)) {
    // The derivatives are x / |(x, y)| and y / |(x, y)|: at most 1 in size, and at most the
    // greatest |x|, or |y|, over the least |(x, y)|.
    const magnitude least_x = x.magnitude_lower();
    const magnitude least_y = y.magnitude_lower();
    const magnitude least =
        sqrt_down(add_down(multiply_down(least_x, least_x), multiply_down(least_y, least_y)));
    const auto change = [&](const ball& s) {
      const magnitude& radius = ball_access::radius(s);
      if (radius.is_zero()) return magnitude{};
      return multiply_up(radius, min(one, divide_up(s.magnitude_upper(), least)));
    };
    ball r;
    detail::set_midpoint(r, p, add_up(change(x), change(y)), [&](mpfr_ptr value) {
      return mpfr_hypot(value, ball_access::first(x), ball_access::first(y), MPFR_RNDN);
    });
    return r;
  }
  const ball ax = abs(x);
  const ball ay = abs(y);
  const end_points ex(ax, p + guard_bits);
  const end_points ey(ay, p + guard_bits);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_hypot(lower.get(), ex.lower(), ey.lower(), MPFR_RNDD);
  mpfr_hypot(upper.get(), ex.upper(), ey.upper(), MPFR_RNDU);
  ball r;
  ball_access::set_ends(r, lower, upper);
  return r;
}

ball pow(const ball& x, long n) {
  const precision p = x.precision();
  if (n == 0 && !x.is_undefined()) return {1, p};
  if (n == 1) return x;
  if (n == 2) return square(x);
  if (x.is_undefined() || (n < 0 && contains_zero(x))) return ball::undefined(p);
  ball r;
  if (ball_access::is_midpoint_radius(x)) {
    const auto k = n < 0 ? 0 - static_cast<std::uint64_t>(n) : static_cast<std::uint64_t>(n);
    const magnitude kq = x.is_exact()
                             ? magnitude{}
                             : multiply_up(magnitude::from_integer_up(k),
                                           divide_up(ball_access::radius(x),
                                                     magnitude::abs_down(ball_access::first(x))));
    if (kq <= small_radius) {
      // With q = r/|m| and k = |n|: (1 + q)^k - 1 <= kq / (1 - kq) and (1 - q)^(-k) - 1 <=
      // kq / (1 - kq), both by Bernoulli's (1 - q)^k >= 1 - kq and (1 + q)^k (1 - q)^k <= 1.
      mpfr_cell value(p);
      const int ternary = mpfr_pow_si(value.get(), ball_access::first(x), n, MPFR_RNDN);
      if (mpfr_number_p(value.get()) != 0) {  // else it overflowed: the ends keep its sign
        const magnitude size =
            add_up(magnitude::abs_up(value.get()),
                   ternary == 0 ? magnitude{} : detail::rounding_error(value.get()));
        const magnitude error = multiply_up(size, divide_up(kq, subtract_down(one, kq)));
        ball_access::first(r) = std::move(value);
        ball_access::finish(r, ternary, error);
        return r;
      }
    }
  }
  // An even power is a power of |x|; x^n is then monotone on each side of 0, decreasing for n < 0.
  const ball base = n % 2 == 0 ? abs(x) : x;
  const end_points e(base, p + guard_bits);
  // A radius below the least positive number is rounded up to it: an end may come to 0 only here.
  if (n < 0 && (mpfr_zero_p(e.lower()) != 0 || mpfr_zero_p(e.upper()) != 0)) {
    return ball::undefined(p);
  }
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_pow_si(lower.get(), n > 0 ? e.lower() : e.upper(), n, MPFR_RNDD);
  mpfr_pow_si(upper.get(), n > 0 ? e.upper() : e.lower(), n, MPFR_RNDU);
  ball_access::set_ends(r, lower, upper);
  return r;
}

ball root(const ball& x, unsigned long n) {
  const precision p = x.precision();
  if (n == 0) return ball::undefined(p);
  if (n == 1) return x;
  if (n == 2) return sqrt(x);
  if (x.is_undefined()) return x;
  if (ball_access::is_midpoint_radius(x) && (n % 2 != 0 || sign_of(x) == certain_sign::positive)) {
    // |(m+h)^(1/n) - m^(1/n)| <= |m|^(1/n) (1 - (1 - q)^(1/n)) for q = r/|m| < 2^-22: the root is
    // concave. By the mean value theorem that is at most (q/n) (1 - q)^(1/n - 1) <= (q/n) / (1 - q)
    // <= (q + 2 q^2) / n.
    const mpfr_srcptr m = ball_access::first(x);
    const magnitude q =
        x.is_exact() ? magnitude{} : divide_up(ball_access::radius(x), magnitude::abs_down(m));
    mpfr_cell value(p);
    const int ternary = mpfr_rootn_ui(value.get(), m, n, MPFR_RNDN);
    const magnitude relative =
        divide_up(multiply_up(q, add_up(one, scale(q, 1))), magnitude::from_integer_down(n));
    const magnitude error =
        q.is_zero() ? magnitude{} : multiply_up(true_value_up(value.get()), relative);
    ball r;
    ball_access::first(r) = std::move(value);
    ball_access::finish(r, ternary, error);
    return r;
  }
  const end_points e(
      x, p + guard_bits);  // increasing; MPFR answers a NaN for even roots of negative numbers
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_rootn_ui(lower.get(), e.lower(), n, MPFR_RNDD);
  mpfr_rootn_ui(upper.get(), e.upper(), n, MPFR_RNDU);
  ball r;
  ball_access::set_ends(r, lower, upper);
  return r;
}

namespace {

/// The integer that an exact ball is, where it is one that fits.
bool is_machine_integer(const ball& y, long& n) {
  if (!y.is_exact()) return false;
  const mpfr_srcptr m = ball_access::first(y);
  if (mpfr_integer_p(m) == 0 || mpfr_fits_slong_p(m, MPFR_RNDN) == 0) return false;
  n = mpfr_get_si(m, MPFR_RNDN);
  return true;
}

/// x^y over a rectangle with x >= 0. d/dx has the sign of y and d/dy that of log x, constant along
/// each side, so the extremes lie at the corners and, where the rectangle crosses x = 1 or y = 0,
/// the values there are 1, which lies between corner values on both sides.
ball power_at_corners(const end_points& x, const end_points& y, precision p) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_cell other(p);
  bool first = true;
  for (const mpfr_srcptr base : {x.lower(), x.upper()}) {
    for (const mpfr_srcptr exponent : {y.lower(), y.upper()}) {
      mpfr_pow(other.get(), base, exponent, MPFR_RNDD);
      if (first || mpfr_less_p(other.get(), lower.get()) != 0) {
        mpfr_set(lower.get(), other.get(), MPFR_RNDD);
      }
      mpfr_pow(other.get(), base, exponent, MPFR_RNDU);
      if (first || mpfr_greater_p(other.get(), upper.get()) != 0) {
        mpfr_set(upper.get(), other.get(), MPFR_RNDU);
      }
      first = false;
    }
  }
  ball r;
  ball_access::set_ends(r, lower, upper);
  return r;
}

}  // namespace

ball pow(const ball& x, const ball& y) {
  const precision p = std::max(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  long n = 0;
  if (is_machine_integer(y, n)) return pow(x.with_precision(p), n);
  const end_points ex(x, p + guard_bits);
  const end_points ey(y, p + guard_bits);
  const bool zero_base = mpfr_zero_p(ex.lower()) != 0;
  if (mpfr_sgn(ex.lower()) < 0 || (zero_base && mpfr_sgn(ey.lower()) <= 0)) {
    return ball::undefined(p);
  }
  // An infinite end is a limit, and MPFR gives that of the power at each corner.
  if (zero_base && !(x.is_bounded() && y.is_bounded())) return ball::undefined(p);
  if (ball_access::is_midpoint_radius(x) && ball_access::is_midpoint_radius(y) && !zero_base) {
    // The exponent y log x changes by at most d = |y| (q + q^2) + ry |log x|, q = rx / mx, and the
    // power by a factor within e^(+-d): |change| <= value (d + d^2) for d <= 1.
    const mpfr_srcptr mx = ball_access::first(x);
    const mpfr_srcptr my = ball_access::first(y);
    const magnitude q = divide_up(ball_access::radius(x), magnitude::abs_down(mx));
    const magnitude drift = plus_square_up(q);
    magnitude change = multiply_up(magnitude::abs_up(my), drift);
    if (!ball_access::radius(y).is_zero()) {
      mpfr_cell logarithm(32);
      mpfr_log(logarithm.get(), mx, MPFR_RNDA);
      change = add_up(change, multiply_up(ball_access::radius(y),
                                          add_up(magnitude::abs_up(logarithm.get()), drift)));
    }
    if (change <= small_radius) {
      mpfr_cell value(p);
      const int ternary = mpfr_pow(value.get(), mx, my, MPFR_RNDN);
      if (mpfr_regular_p(value.get()) != 0) {
        const magnitude error =
            change.is_zero() ? magnitude{}
                             : multiply_up(true_value_up(value.get()), plus_square_up(change));
        ball r;
        ball_access::first(r) = std::move(value);
        ball_access::finish(r, ternary, error);
        return r;
      }
    }
  }
  return power_at_corners(ex, ey, p);
}

}  // namespace polhode
