// Exponentials, by e^(m+h) - e^m = e^m (e^h - 1).

#include "arithmetic/functions/elementary/carrying.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode {

using namespace detail::elementary;

void exp(ball& result, const ball& x) {
  const magnitude radius = ball_access::radius(x);
  // |e^(m+h) - e^m| <= e^m (e^r - 1), and e^r - 1 <= r + r^2 for r <= 1.
  monotone(
      result, x, mpfr_exp, true,
      [&](mpfr_srcptr value) { return multiply_up(true_value_up(value), plus_square_up(radius)); },
      detail::near_exp);
}

void exp2(ball& result, const ball& x) {
  // 2^x = e^(x log 2): as exp, with the radius r log 2, and log 2 < 61/88 = 0.69318...
  const magnitude radius = times_ratio_up(ball_access::radius(x), 61, 88);
  monotone(result, x, mpfr_exp2, true, [&](mpfr_srcptr value) {
    return multiply_up(true_value_up(value), plus_square_up(radius));
  });
}

void exp10(ball& result, const ball& x) {
  // As exp, with the radius r log 10 <= 1, and log 10 < 175/76 = 2.30263...
  const magnitude radius = times_ratio_up(ball_access::radius(x), 175, 76);
  monotone(result, x, mpfr_exp10, true, [&](mpfr_srcptr value) {
    return multiply_up(true_value_up(value), plus_square_up(radius));
  });
}

void expm1(ball& result, const ball& x) {
  const magnitude radius = ball_access::radius(x);
  // |e^(m+h) - e^m| <= e^m (r + r^2), and e^m = 1 + v.
  monotone(result, x, mpfr_expm1, true, [&](mpfr_srcptr value) {
    const magnitude exp_m =
        mpfr_sgn(value) < 0 ? one_minus_abs_up(value) : add_up(one, true_value_up(value));
    return multiply_up(exp_m, plus_square_up(radius));
  });
}

}  // namespace polhode
