#ifdef POLHODE_WITH_ARB

// Exponential integrals.

#include <optional>
#include <vector>

#include "definition.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/special_functions.hpp"

namespace polhode::arb_functions_impl {
namespace {

/// E_n(z) is the integral of e^(-z t)/t^n over t > 1, for Re z > 0 (DLMF 8.19.3): it and its
/// derivative -E_(n-1) are largest at the least Re z.
void value_of_expint(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  arb().acb_hypgeom_expint(r, order, z, p);
}
bounds bounds_of_expint(const call& x) {
  const complex_ball z(least_of(x.z.re));
  if (!certainly_positive(z.re)) return {};
  const definition& e = named("expint");
  const ball less = *x.order - 1;
  return {value_of(e, {x.order, z}, few_bits).magnitude_upper(),
          value_of(e, {&less, z}, few_bits).magnitude_upper()};
}

/// e^z E_n(z) is the integral of e^(-z s)/(1 + s)^n over s > 0, U(1, 2 - n, z) (DLMF 13.4.4): it
/// and its derivative, that of s e^(-z s)/(1 + s)^n, are largest, in size, at the least Re z = x.
/// As s e^(-x s/2) <= 2/(e x), the second is at most 2/(e x) times the first at x/2.
void value_of_scaled_expint(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  const arb_number one(complex_ball(1, few_bits));
  const arb_number two(complex_ball(2, few_bits));
  arb_number b;
  arb().acb_sub(b.get(), two.get(), order, p);
  arb().acb_hypgeom_u(r, one.get(), b.get(), z, p);
}
bounds bounds_of_scaled_expint(const call& x) {
  const complex_ball z(least_of(x.z.re));
  if (!certainly_positive(z.re)) return {};
  const definition& e = named("expintx");
  const ball less = *x.order - 1;
  const complex_ball value = value_of(e, {x.order, z}, few_bits);
  const complex_ball half(scale(z.re, -1));
  const ball of_half = value_of(e, {x.order, half}, few_bits).re;
  const magnitude far = (2 * of_half / (exp(ball(1, few_bits)) * z.re)).magnitude_upper();
  const complex_ball near = value_of(e, {&less, z}, few_bits) - value;
  return {value.magnitude_upper(), std::min(far, near.magnitude_upper())};
}

/// The derivative in n is the integral with the factor -log(1 + s), in size at most (1 + s)^h/h for
/// any h > 0: at most the value of order n - h at the least Re z and the least n, divided by h.
magnitude over_order_of(const char* name, const call& x) {
  const complex_ball z(least_of(x.z.re));
  if (!certainly_positive(z.re)) return magnitude::infinity();
  const ball step = step_of_order(z.re);
  const ball less = least_of(*x.order - step);
  return (value_of(named(name), {&less, z}, few_bits).re / step).magnitude_upper();
}
magnitude over_order_of_expint(const call& x) { return over_order_of("expint", x); }
magnitude over_order_of_scaled_expint(const call& x) { return over_order_of("expintx", x); }

/// For n > 1 E_n, and e^x E_n, decrease from 1/(n - 1) at 0.
ball from_value_at_zero(const char* name, const ball& order, const ball& x) {
  const precision p = x.precision();
  const ball less = order - 1;
  const complex_ball upper(upper_end(x));
  if (!certainly_positive(less) || !certainly_positive(upper.re)) return ball::undefined(p);
  return hull(1 / less, value_of(named(name), {&order, upper}, p).re);
}
ball expint_from_zero(const ball* order, const ball& x) {
  return from_value_at_zero("expint", *order, x);
}
ball scaled_expint_from_zero(const ball* order, const ball& x) {
  return from_value_at_zero("expintx", *order, x);
}

/// Ei for Re z > 0; -E_1(-z) for Re z < 0, which is Ei(x) for x < 0.
void value_of_ei(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  if (arb().arb_is_positive(acb_realref(z)) != 0) return arb().acb_hypgeom_ei(r, z, p);
  const arb_number one(complex_ball(1, few_bits));
  arb_number minus_z;
  arb().arb_neg(acb_realref(minus_z.get()), acb_realref(z));
  arb().arb_neg(acb_imagref(minus_z.get()), acb_imagref(z));
  arb().acb_hypgeom_expint(r, one.get(), minus_z.get(), p);
  arb().arb_neg(acb_realref(r), acb_realref(r));
  arb().arb_neg(acb_imagref(r), acb_imagref(r));
}
obstacle around_zero(const call& x) {
  return certainly_positive(x.z.re) || certainly_negative(x.z.re) ? obstacle::none
                                                                  : obstacle::branch_cut;
}
/// |e^z/z|.
bounds bounds_of_ei(const call& x) {
  return {magnitude::infinity(),
          divide_up(exp(x.z.re.with_precision(few_bits)).magnitude_upper(), x.z.magnitude_lower())};
}

/// sin(z)/z is the integral of cos(z t) over 0 < t < 1, and so at most e^|Im z|.
void value_of_si(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) { arb().acb_hypgeom_si(r, z, p); }
ball slope_of_si(const ball*, const ball& x) {
  const ball quotient = sin(x) / x;
  return quotient.is_bounded() ? quotient : hull(ball(-1, x.precision()), ball(1, x.precision()));
}
bounds bounds_of_si(const call& x) {
  return {magnitude::infinity(), exp(greatest_size(x.z.im)).magnitude_upper()};
}
/// |cos(z)/z| <= e^|Im z|/|z|.
void value_of_ci(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) { arb().acb_hypgeom_ci(r, z, p); }
bounds bounds_of_ci(const call& x) {
  return {magnitude::infinity(),
          divide_up(exp(greatest_size(x.z.im)).magnitude_upper(), x.z.magnitude_lower())};
}

// For x > 0: E_n(x) = e^-x times the integral of e^(-x s)/(1 + s)^n over s > 0, at most e^-x/x
// where n >= 0, and e^-x gamma(1/8) x^(-1/8) where n >= 1, as 1 + s >= s^(7/8). -Ei(-x) = E_1(x).
// |Ei(x)| is at most gamma + |log x| and the integral of (e^t - 1)/t <= e^t over 0 < t < x, with
// gamma < 1, log x <= 2 sqrt(x) <= 2 e^x and -log x <= 8 x^(-1/8) - 8: at most 3 e^x + 8 x^(-1/8).
// Si rises and falls in ever smaller steps, the first and greatest up to Si(pi) <= pi, as sin(t)/t
// <= 1. -Ci(x) is the integral of cos(t)/t over t > x, which is -sin(x)/x and that of sin(t)/t^2:
// at most 2/x from 1 on, and before that at most 2 - log x.
majorant majorant_of_expint(const ball* order, int sign) {
  if (sign < 0 || !certainly_less_equal(ball(0, few_bits), *order)) return std::nullopt;
  return steady(certainly_less_equal(ball(1, few_bits), *order) ? "8*exp(-x)*x^(-1/8)"
                                                                : "exp(-x)/x");
}
majorant majorant_of_scaled_expint(const ball* order, int sign) {
  if (sign < 0 || !certainly_less_equal(ball(0, few_bits), *order)) return std::nullopt;
  return steady(certainly_less_equal(ball(1, few_bits), *order) ? "8*x^(-1/8)" : "1/x");
}
majorant majorant_of_ei(const ball*, int sign) {
  return steady(sign < 0 ? "8*exp(x)*(-x)^(-1/8)" : "11*exp(x)*(1+1/x)^(1/8)");
}

// For 0 < x <= 1/2 E_1(x) is -log x - gamma and the integral of (1 - e^-t)/t <= 1 over 0 < t < x;
// Ei(x) is gamma + log x and that of (e^t - 1)/t <= e^t, which is at most sqrt(e)/2 < 9/10; Ci(x)
// is gamma + log x less that of (1 - cos t)/t <= t/2 (DLMF 6.2.4, 6.2.7, 6.2.13); and 1/2 < gamma <
// 3/5.
leading leading_of_expint(const ball* order, int sign) {
  if (sign < 0) return not_defined();
  if (!order->is_exact() || lower_rational(*order) != 1) return std::nullopt;
  return leading_term("-log(x)", "3/5");
}
/// e^x <= 2 and e^x - 1 <= 2 x for 0 < x <= 1/2, and x |log x| <= 1/e < 2/5: 6/5 + 4/5.
leading leading_of_scaled_expint(const ball* order, int sign) {
  leading e = leading_of_expint(order, sign);
  if (e && sign > 0) e->rest = "2";
  return e;
}
leading leading_of_ei(const ball*, int sign) {
  return sign > 0 ? leading_term("log(x)", "3/2") : leading_term("log(-x)", "3/5");
}
leading leading_of_ci(const ball*, int sign) {
  return sign > 0 ? leading_term("log(x)", "3/5") : not_defined();
}

// Towards infinity. By parts x E_n(x) = e^-x - n E_(n+1)(x), with 0 <= E_(n+1)(x) <= e^-x/x for
// n >= 0 (DLMF 8.19.12): and Ei(-x) = -E_1(x).
//
// For x >= 4 Ei(x) - e^x/x has the derivative e^x/x^2 > 0, and Ei(x) - e^x/x - 2 e^x/x^2 has
// e^x/x^2 (4/x - 1) <= 0. At 4 they are Ei(4) - e^4/4 > 0 and Ei(4) - 3 e^4/8 < 0 (Ei(4) =
// 19.630..., e^4 = 54.598...).
//
// pi/2 - Si(x) is the imaginary part, and -Ci(x) the real part, of the integral of e^(i t)/t over
// t > x: that is e^(i x) times that of i e^-s/(x + i s) over s > 0, at most 1/x in size.
leading expint_at_infinity(const ball* order, int sign) {
  const bool is_known = sign > 0 && certainly_less_equal(ball(0, few_bits), *order);
  return is_known ? leading_term("exp(-x)/x", "n*exp(-x)/x^2") : std::nullopt;
}
leading scaled_expint_at_infinity(const ball* order, int sign) {
  const bool is_known = sign > 0 && certainly_less_equal(ball(0, few_bits), *order);
  return is_known ? leading_term("1/x", "n/x^2") : std::nullopt;
}
leading ei_at_infinity(const ball*, int sign) {
  return leading_term("exp(x)/x", sign > 0 ? "2*exp(x)/x^2" : "exp(x)/x^2");
}
leading si_at_infinity(const ball*, int sign) {
  return sign > 0 ? oscillating_beside("pi/2", "1/x") : oscillating_beside("-pi/2", "-1/x");
}
leading ci_at_infinity(const ball*, int sign) {
  return sign > 0 ? oscillating_beside("0", "1/x") : std::nullopt;
}

}  // namespace

std::vector<definition> exponential_integrals() {
  const auto is_not_zero = [](known_arguments x) { return !is_exactly(x[0], 0); };
  const auto zero_at_zero = [](known_arguments x) {
    return is_exactly(x[0], 0) ? formula("0") : std::nullopt;
  };
  return {{.what = {"expint", "n, x", "E_n, exponential integral", "x > 0"},
           .has_order = true,
           .value = value_of_expint,
           .in_the_way = left_half,
           .over = bounds_of_expint,
           .over_order = over_order_of_expint,
           .slope = "-expint(n-1,x)",
           .may_be_defined = last_is_positive,
           .is_nowhere_defined = not_positive,
           .where_defined = expint_from_zero,
           .bound = majorant_of_expint,
           .is_monotonic = where_positive,
           .near_zero = leading_of_expint,
           .near_infinity = expint_at_infinity},
          {.what = {"expintx", "n, x", "exp(x) expint(n, x)", "x > 0"},
           .has_order = true,
           .value = value_of_scaled_expint,
           .in_the_way = left_half,
           .over = bounds_of_scaled_expint,
           .over_order = over_order_of_scaled_expint,
           .slope = "expintx(n,x)-expintx(n-1,x)",
           .may_be_defined = last_is_positive,
           .is_nowhere_defined = not_positive,
           .where_defined = scaled_expint_from_zero,
           .bound = majorant_of_scaled_expint,
           .is_monotonic = where_positive,
           .near_zero = leading_of_scaled_expint,
           .near_infinity = scaled_expint_at_infinity},
          {.what = {"Ei", "x", "exponential integral", "x != 0"},
           .value = value_of_ei,
           .in_the_way = around_zero,
           .over = bounds_of_ei,
           .slope = "exp(x)/x",
           .may_be_defined = is_not_zero,
           .bound = majorant_of_ei,
           .is_monotonic = where_not_zero,
           .near_zero = leading_of_ei,
           .near_infinity = ei_at_infinity},
          {.what = {"Si", "x", "sine integral", "all x"},
           .value = value_of_si,
           .over = bounds_of_si,
           .slope = "sin(x)/x",
           .simpler = zero_at_zero,
           .bound = [](const ball*, int) { return oscillating("pi"); },
           .slope_over = slope_of_si,
           .near_infinity = si_at_infinity},
          {.what = {"Ci", "x", "cosine integral", "x > 0"},
           .value = value_of_ci,
           .in_the_way = left_half,
           .over = bounds_of_ci,
           .slope = "cos(x)/x",
           .may_be_defined = last_is_positive,
           .is_nowhere_defined = not_positive,
           .bound = [](const ball*,
                       int sign) { return sign > 0 ? oscillating("8*x^(-1/8)") : std::nullopt; },
           .near_zero = leading_of_ci,
           .near_infinity = ci_at_infinity}};
}

}  // namespace polhode::arb_functions_impl

#endif
