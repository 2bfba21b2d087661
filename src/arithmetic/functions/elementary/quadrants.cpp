#include "arithmetic/functions/elementary/quadrants.hpp"

#include <algorithm>

#include <gmp.h>

namespace polhode::detail::elementary {
namespace {

/// floor(2 x / pi) for a number x. 2 x / pi is irrational for x != 0, so raising the precision
/// of pi always decides it in the end.
void quadrant(mpz_ptr result, mpfr_srcptr x) {
  if (mpfr_zero_p(x) != 0 || mpfr_get_exp(x) <= 0) {  // |x| < 1: also where x / pi underflows
    mpz_set_si(result, mpfr_sgn(x) < 0 ? -1 : 0);
    return;
  }
  mpz_t other;
  mpz_init(other);
  precision p = std::max<precision>(mpfr_get_exp(x), 0) + 64;
  while (true) {
    mpfr_cell ratio(p);
    mpfr_cell half_pi(p);
    const bool positive = mpfr_sgn(x) > 0;
    // A lower bound of x / (pi / 2), then an upper bound.
    mpfr_const_pi(half_pi.get(), positive ? MPFR_RNDU : MPFR_RNDD);
    mpfr_div_2ui(half_pi.get(), half_pi.get(), 1, MPFR_RNDN);
    mpfr_div(ratio.get(), x, half_pi.get(), MPFR_RNDD);
    mpfr_get_z(result, ratio.get(), MPFR_RNDD);
    mpfr_const_pi(half_pi.get(), positive ? MPFR_RNDD : MPFR_RNDU);
    mpfr_div_2ui(half_pi.get(), half_pi.get(), 1, MPFR_RNDN);
    mpfr_div(ratio.get(), x, half_pi.get(), MPFR_RNDU);
    mpfr_get_z(other, ratio.get(), MPFR_RNDD);
    if (mpz_cmp(result, other) == 0) break;
    p *= 2;
  }
  mpz_clear(other);
}

/// For a set no wider than `widest`, given what sets an integer to the number of quarter turns up
/// to a point; points that are too large to say so may be anywhere on the circle.
template <class TooLarge, class Quadrant>
quarter_turns turns_between(const end_points& x, unsigned long widest, TooLarge&& too_large,
                            Quadrant&& set_quadrant) {
  quarter_turns result;
  mpfr_cell width(32);
  mpfr_sub(width.get(), x.upper(), x.lower(), MPFR_RNDU);
  if (mpfr_cmp_ui(width.get(), widest) >= 0 || too_large(x.lower()) || too_large(x.upper())) {
    result.whole_circle = true;
    return result;
  }
  mpz_t first;
  mpz_t last;
  mpz_init(first);
  mpz_init(last);
  set_quadrant(first, x.lower());
  set_quadrant(last, x.upper());
  const auto start = mpz_fdiv_ui(first, 4);
  mpz_sub(last, last, first);  // small, since the width is
  const auto count = mpz_get_ui(last);
  for (unsigned long j = 1; j <= count; ++j) result.passed[(start + j) % 4] = true;
  mpz_clear(last);
  mpz_clear(first);
  return result;
}

}  // namespace

bool too_large_to_reduce(mpfr_srcptr x, precision p) {
  return mpfr_regular_p(x) != 0 &&
         mpfr_get_exp(x) > static_cast<mpfr_exp_t>(std::max<precision>(precision{1} << 20, 4 * p));
}

quarter_turns turns_inside(const end_points& x, precision p) {
  return turns_between(
      x, 7, [p](mpfr_srcptr end) { return too_large_to_reduce(end, p); }, quadrant);
}

quarter_turns turns_of_half_circles(const end_points& x) {
  const auto too_large = [](mpfr_srcptr end) {
    return mpfr_regular_p(end) != 0 && mpfr_get_exp(end) > (mpfr_exp_t{1} << 24);
  };
  const auto floor_of_double = [](mpz_ptr r, mpfr_srcptr end) {
    mpfr_cell twice(mpfr_get_prec(end));
    mpfr_mul_2ui(twice.get(), end, 1, MPFR_RNDN);
    mpfr_get_z(r, twice.get(), MPFR_RNDD);
  };
  return turns_between(x, 2, too_large, floor_of_double);
}

}  // namespace polhode::detail::elementary
