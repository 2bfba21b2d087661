#include "polhode/arithmetic/natural_domain.hpp"

#include <algorithm>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/functions/atan2.hpp"

namespace polhode::natural_domain {

using detail::end_points;
using detail::mpfr_cell;

namespace {

constexpr precision natural_guard_bits = 64;

using mpfr_function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using ball_function = ball (*)(const ball&);

/// An end of a natural domain: an integer, or none on this side.
struct bound {
  bool exists = false;
  long value = 0;
  bool belongs = false;  // to the domain
};
constexpr bound none{};
constexpr bound closed(long n) { return {true, n, true}; }
constexpr bound open(long n) { return {true, n, false}; }

struct monotone_function {
  ball_function defined;  // the plain function
  mpfr_function f;        // with its limit at an end that does not belong to the domain
  bool increasing;
  bound from;
  bound to;
};

/// A ball of the two ends; set_ends empties the cells.
ball between(mpfr_cell& lower, mpfr_cell& upper) {
  ball r;
  ball_access::set_ends(r, lower, upper);
  return r;
}

/// The range of a monotone function over x cut with its domain. The ends that are tested are
/// rounded outward: what they show to lie off the domain does.
std::optional<ball> range(const monotone_function& g, const ball& x) {
  if (x.is_undefined()) return x;
  if (ball whole = g.defined(x); !whole.is_undefined()) return whole;
  const precision p = x.precision();
  const end_points e(x, p + natural_guard_bits);
  mpfr_cell low(mpfr_get_prec(e.lower()));
  mpfr_cell high(mpfr_get_prec(e.upper()));
  mpfr_set(low.get(), e.lower(), MPFR_RNDD);
  mpfr_set(high.get(), e.upper(), MPFR_RNDU);
  if (g.from.exists) {
    const int order = mpfr_cmp_si(high.get(), g.from.value);
    if (order < 0 || (order == 0 && !g.from.belongs)) return std::nullopt;
    if (mpfr_cmp_si(low.get(), g.from.value) < 0) mpfr_set_si(low.get(), g.from.value, MPFR_RNDN);
  }
  if (g.to.exists) {
    const int order = mpfr_cmp_si(low.get(), g.to.value);
    if (order > 0 || (order == 0 && !g.to.belongs)) return std::nullopt;
    if (mpfr_cmp_si(high.get(), g.to.value) > 0) mpfr_set_si(high.get(), g.to.value, MPFR_RNDN);
  }
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  g.f(lower.get(), (g.increasing ? low : high).get(), MPFR_RNDD);
  g.f(upper.get(), (g.increasing ? high : low).get(), MPFR_RNDU);
  return between(lower, upper);
}

}  // namespace

std::optional<ball> sqrt(const ball& x) {
  return range({polhode::sqrt, mpfr_sqrt, true, closed(0), none}, x);
}
std::optional<ball> rsqrt(const ball& x) {
  return range({polhode::rsqrt, mpfr_rec_sqrt, false, open(0), none}, x);
}
std::optional<ball> log(const ball& x) {
  return range({polhode::log, mpfr_log, true, open(0), none}, x);
}
std::optional<ball> log2(const ball& x) {
  return range({polhode::log2, mpfr_log2, true, open(0), none}, x);
}
std::optional<ball> log10(const ball& x) {
  return range({polhode::log10, mpfr_log10, true, open(0), none}, x);
}
std::optional<ball> log1p(const ball& x) {
  return range({polhode::log1p, mpfr_log1p, true, open(-1), none}, x);
}
std::optional<ball> asin(const ball& x) {
  return range({polhode::asin, mpfr_asin, true, closed(-1), closed(1)}, x);
}
std::optional<ball> acos(const ball& x) {
  return range({polhode::acos, mpfr_acos, false, closed(-1), closed(1)}, x);
}
std::optional<ball> acosh(const ball& x) {
  return range({polhode::acosh, mpfr_acosh, true, closed(1), none}, x);
}
std::optional<ball> atanh(const ball& x) {
  return range({polhode::atanh, mpfr_atanh, true, open(-1), open(1)}, x);
}

std::optional<ball> tan(const ball& x) {
  if (x.is_undefined()) return x;
  ball r = polhode::tan(x);
  // A set with a pole inside has members on both sides of it, where tan goes to -inf and to inf.
  return r.is_undefined() ? ball::entire(x.precision()) : r;
}

std::optional<ball> reciprocal(const ball& x) { return divide(ball(1, x.precision()), x); }

std::optional<ball> divide(const ball& x, const ball& y) {
  const precision p = std::max(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  if (ball whole = x / y; !whole.is_undefined()) return whole;
  const end_points ex(x, p + natural_guard_bits);
  const end_points ey(y, p + natural_guard_bits);
  const bool from_zero = mpfr_zero_p(ey.lower()) != 0;
  const bool to_zero = mpfr_zero_p(ey.upper()) != 0;
  if (from_zero && to_zero) return std::nullopt;
  const mpfr_srcptr a = ex.lower();
  const mpfr_srcptr b = ex.upper();
  if (mpfr_zero_p(a) != 0 && mpfr_zero_p(b) != 0) return ball(0, p);
  const bool x_above = mpfr_sgn(a) >= 0;
  const bool x_below = mpfr_sgn(b) <= 0;
  if ((!from_zero && !to_zero) || (!x_above && !x_below)) return ball::entire(p);
  // One sign for the dividend and one for the divisor, which comes as near to 0 as one likes: the
  // quotient's size goes from the least dividend over the greatest divisor to infinity.
  const mpfr_srcptr least = x_above ? a : b;
  const mpfr_srcptr greatest = from_zero ? ey.upper() : ey.lower();
  const bool positive = x_above == from_zero;
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_set_inf(lower.get(), -1);
  mpfr_set_inf(upper.get(), 1);
  // Neither is 0 / 0 or infinity / infinity: greatest is not 0, and least is a finite end.
  mpfr_div((positive ? lower : upper).get(), least, greatest, positive ? MPFR_RNDD : MPFR_RNDU);
  return between(lower, upper);
}

std::optional<ball> pow(const ball& x, long n) {
  if (x.is_undefined()) return x;
  if (ball whole = polhode::pow(x, n); !whole.is_undefined()) return whole;
  // n < 0, and 0 is in x. For even n a power of |x|.
  const precision p = x.precision();
  const ball base = n % 2 == 0 ? polhode::abs(x) : x;
  const end_points e(base, p + natural_guard_bits);
  const bool below = mpfr_sgn(e.lower()) < 0;
  const bool above = mpfr_sgn(e.upper()) > 0;
  if (!below && !above) return std::nullopt;
  if (below && above) return ball::entire(p);  // n is odd
  // x^n = 1/x^|n| has the sign of x, and it is least in size at the end that is not 0.
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  if (above) {
    mpfr_pow_si(lower.get(), e.upper(), n, MPFR_RNDD);
    mpfr_set_inf(upper.get(), 1);
  } else {
    mpfr_set_inf(lower.get(), -1);
    mpfr_pow_si(upper.get(), e.lower(), n, MPFR_RNDU);
  }
  return between(lower, upper);
}

std::optional<ball> pow(const ball& x, const ball& y) {
  const precision p = std::max(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  if (certainly_positive(x)) {
    if (ball whole = polhode::pow(x, y); !whole.is_undefined()) return whole;
  }
  const end_points ex(x, p + natural_guard_bits);
  const end_points ey(y, p + natural_guard_bits);
  const int sign_of_greatest = mpfr_sgn(ex.upper());
  if (sign_of_greatest < 0) return std::nullopt;
  if (sign_of_greatest == 0) {  // only x = 0
    if (mpfr_sgn(ey.upper()) <= 0) return std::nullopt;
    return ball(0, p);
  }
  mpfr_cell zero(2);
  const mpfr_srcptr low = mpfr_sgn(ex.lower()) <= 0 ? zero.get() : ex.lower();
  // Over [a, b] x [c, d] with 0 < a: x^y is monotone in x for each y, and in y for each x, so its
  // least and its greatest value lie at corners (where the rectangle meets x = 1 or y = 0, the
  // value 1 is between those at the corners). As a goes to 0 and b, -c, d to infinity each corner
  // value converges, to what MPFR gives there: 0^c is +inf, 1 or 0 for c < 0, c = 0, c > 0, and b^d
  // likewise at infinity. The hull of the union of the ranges is that of the limits, and x = 0 with
  // y > 0 adds 0, which is the limit already.
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_cell other(p);
  mpfr_set_inf(lower.get(), 1);
  mpfr_set_inf(upper.get(), -1);
  for (const mpfr_srcptr base : {low, ex.upper()}) {
    for (const mpfr_srcptr exponent : {ey.lower(), ey.upper()}) {
      mpfr_pow(other.get(), base, exponent, MPFR_RNDD);
      mpfr_min(lower.get(), lower.get(), other.get(), MPFR_RNDD);
      mpfr_pow(other.get(), base, exponent, MPFR_RNDU);
      mpfr_max(upper.get(), upper.get(), other.get(), MPFR_RNDU);
    }
  }
  return between(lower, upper);
}

std::optional<ball> root(const ball& x, unsigned long n) {
  if (x.is_undefined()) return x;
  if (n == 0) return std::nullopt;
  if (ball whole = polhode::root(x, n); !whole.is_undefined()) return whole;
  // n is even.
  const precision p = x.precision();
  const end_points e(x, p + natural_guard_bits);
  if (mpfr_sgn(e.upper()) < 0) return std::nullopt;
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_rootn_ui(upper.get(), e.upper(), n, MPFR_RNDU);
  return between(lower, upper);
}

std::optional<ball> atan2(const ball& y, const ball& x) {
  const precision p = std::max(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  if (ball whole = polhode::atan2(y, x); !whole.is_undefined()) return whole;
  const end_points ex(x, p + natural_guard_bits);
  const end_points ey(y, p + natural_guard_bits);
  const auto is_zero = [](const end_points& e) {
    return mpfr_zero_p(e.lower()) != 0 && mpfr_zero_p(e.upper()) != 0;
  };
  if (is_zero(ex) && is_zero(ey)) return std::nullopt;
  ball r;
  detail::angles(r, ey, ex, p);
  return r;
}

}  // namespace polhode::natural_domain
