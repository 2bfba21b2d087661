// Comparisons, containment and signs. Ends are compared exactly: an MPFR sum has no rounding where
// its sign is asked.

#include <cstdint>

#include <gmp.h>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/forms.hpp"
#include "polhode/arithmetic/ball.hpp"

namespace polhode {

using detail::common_precision;
using detail::end_points;
using detail::mpfr_cell;
using form = ball_access::form;

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

magnitude detail::distance_of_midpoints(const ball& x, const ball& y) {
  if (!both_by_midpoint(x, y)) return magnitude::infinity();
  mpfr_cell distance(64);
  mpfr_sub(distance.get(), ball_access::first(x), ball_access::first(y), MPFR_RNDA);
  return magnitude::abs_up(distance.get());
}

bool detail::contains_by_midpoints(const ball& x, const ball& y) {
  const magnitude away = distance_of_midpoints(x, y);
  return !away.is_infinite() && add_up(away, ball_access::radius(y)) <= ball_access::radius(x);
}

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
  // A midpoint lies in the other ball.
  const magnitude distance = detail::distance_of_midpoints(x, y);
  if (!distance.is_infinite() && distance <= max(ball_access::radius(x), ball_access::radius(y))) {
    return true;
  }
  return !certainly_less(x, y) && !certainly_less(y, x);
}

bool contains(const ball& x, const ball& y) {
  if (x.is_undefined() || y.is_undefined()) return false;
  if (detail::contains_by_midpoints(x, y)) return true;
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

certain_sign sign_of(const ball& x) {
  if (ball_access::is_midpoint_radius(x)) {
    const mpfr_srcptr m = ball_access::first(x);
    if (mpfr_zero_p(m) != 0) return x.is_exact() ? certain_sign::zero : certain_sign::unknown;
    if (contains_zero(x)) return certain_sign::unknown;
    return mpfr_sgn(m) < 0 ? certain_sign::negative : certain_sign::positive;
  }
  if (x.is_undefined()) return certain_sign::unknown;
  if (mpfr_sgn(ball_access::first(x)) > 0) return certain_sign::positive;
  if (mpfr_sgn(ball_access::second(x)) < 0) return certain_sign::negative;
  return certain_sign::unknown;
}

}  // namespace polhode
