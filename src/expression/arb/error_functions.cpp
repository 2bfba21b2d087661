#ifdef POLHODE_WITH_ARB

// Error functions, Fresnel's integrals, incomplete gamma functions and polygamma functions.

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "definition.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/special_functions.hpp"

namespace polhode::arb_functions_impl {
namespace {

formula zero_at_zero(known_arguments x) {
  return is_exactly(x[0], 0) ? formula("0") : std::nullopt;
}

// ---------------------------------------------------------------------------------------------
// Error functions. With z = x + i y:
//
// erfi(z) is 2/sqrt(pi) times the integral of e^(t^2) from 0 to z, and |e^(z^2)| = e^(x^2 - y^2).
//
// erfcx(z) = e^(z^2) erfc(z) is 2/sqrt(pi) times the integral of e^(-t^2 - 2 z t) over t > 0 (DLMF
// 7.2.2, with z + t for t): so it and its derivative are largest, in size, at the least x.
//
// dawson(z) is the integral of e^(-t^2) sin(2 z t) over t > 0 (DLMF 7.7.3), at most that of
// e^(-t^2 + 2 |y| t), which is at most sqrt(pi) e^(y^2). Its derivative is that of
// 2 t e^(-t^2) cos(2 z t), at most that of 2 t e^(-t^2) cosh(2 y t) = 1 + sqrt(pi) |y| e^(y^2)
// erf(|y|). dawson(z) is also z times the integral of e^(-z^2 (1 - s^2)) over 0 < s < 1 (DLMF
// 7.2.5), where 1 - s^2 >= 1 - s: at most |z|/Re(z^2) where w = Re(z^2) > 0. As 1 - e^-z^2 is 2 z^2
// times the integral of s e^(-z^2 (1 - s^2)), the derivative 1 - 2 z dawson(z) is e^-z^2 less 2 z^2
// times that of (1 - s) e^(-z^2 (1 - s^2)): at most e^-w + 2 |z|^2/w^2.

void value_of_erfi(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_erfi(r, z, p);
}
bounds bounds_of_erfi(const call& x) {
  const ball slope = 2 * exp(square(greatest_size(x.z.re)) - square(x.z.im)) / sqrt(pi(few_bits));
  return {magnitude::infinity(), slope.magnitude_upper()};
}

/// r = sqrt(pi) of p bits; r is real.
void root_of_pi(acb_ptr r, slong p) {
  arb().arb_const_pi(acb_realref(r), p);
  arb().acb_sqrt(r, r, p);
}

/// Where Re z > 0, U(1/2, 1/2, z^2)/sqrt(pi) (DLMF 7.7.1 and 13.4.4, continued from |ph z| <=
/// pi/4), which is not the product of a large number and a small one.
void value_of_erfcx(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb_number square;
  arb().acb_mul(square.get(), z, z, p);
  arb_number factor;
  if (arb().arb_is_positive(acb_realref(z)) != 0) {
    const arb_number half(complex_ball(ball(rational(1, 2), few_bits)));
    root_of_pi(factor.get(), p);
    arb().acb_hypgeom_u(r, half.get(), half.get(), square.get(), p);
    return arb().acb_div(r, r, factor.get(), p);
  }
  arb().acb_exp(factor.get(), square.get(), p);
  arb().acb_hypgeom_erfc(r, z, p);
  arb().acb_mul(r, r, factor.get(), p);
}
/// The derivative is 2 x erfcx(x) - 2/sqrt(pi), for x > 0 of size at most 1/(sqrt(pi) x^2) as well
/// (erfcx_at_infinity).
bounds bounds_of_erfcx(const call& x) {
  const ball least = least_of(x.z.re);
  const ball value = value_of(named("erfcx"), {nullptr, complex_ball(least)}, 2 * few_bits).re;
  const ball root = sqrt(pi(2 * few_bits));
  magnitude slope = (2 * least * value - 2 / root).magnitude_upper();
  if (certainly_positive(least)) {
    slope = std::min(slope, (1 / (root * square(least))).magnitude_upper());
  }
  return {value.magnitude_upper(), slope};
}

/// By its integral erfcx decreases, and its derivative increases.
ball slope_of_erfcx(const ball*, const ball& x) {
  const precision p = x.precision() + 64;
  const auto slope = [&](const ball& t) {
    const ball value = value_of(named("erfcx"), {nullptr, complex_ball(t)}, p).re;
    return 2 * t * value - 2 / sqrt(pi(p));
  };
  return at_ends(slope, x, p).with_precision(x.precision());
}

/// z M(1, 3/2, -z^2) (DLMF 13.6.7 in i z, 7.5.1).
void value_of_dawson(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  const arb_number one(complex_ball(1, few_bits));
  const arb_number three_halves(complex_ball(ball(rational(3, 2), few_bits)));
  arb_number square;
  arb().acb_mul(square.get(), z, z, p);
  arb().acb_neg(square.get(), square.get());
  arb().acb_hypgeom_m(square.get(), one.get(), three_halves.get(), square.get(), 0, p);
  arb().acb_mul(r, z, square.get(), p);
}
bounds bounds_of_dawson(const call& x) {
  const ball y = greatest_size(x.z.im);
  const ball size = sqrt(pi(few_bits)) * exp(square(y));
  const ball square_part = square(x.z.re) - square(x.z.im);
  const magnitude slope = (1 + size * y * erf(y)).magnitude_upper();
  if (!certainly_positive(square_part)) return {size.magnitude_upper(), slope};
  const ball other = abs(x.z).with_precision(few_bits) / square_part;
  const magnitude far = (exp(-square_part) + 2 * square(other)).magnitude_upper();
  return {std::min(size.magnitude_upper(), other.magnitude_upper()), std::min(slope, far)};
}

// Bounds for x > 0:
//   dawson is the integral of e^(t^2 - x^2) from 0 to x, at most x, and at most 1/x, as
//   t^2 - x^2 <= x (t - x); the lesser is at most 2 x/(1 + x^2). erfi is 2/sqrt(pi) e^(x^2) times
//   that.
//   erfcx is at most 1, and by its integral 1/(sqrt(pi) x): at most 2/(1 + x). For x < 0 it is at
//   most 2 e^(x^2).
majorant majorant_of_erfi(const ball*, int sign) {
  return steady(sign > 0 ? "4/sqrt(pi)*exp(x^2)*x/(1+x^2)" : "-4/sqrt(pi)*exp(x^2)*x/(1+x^2)");
}
majorant majorant_of_erfcx(const ball*, int sign) {
  return steady(sign > 0 ? "2/(1+x)" : "2*exp(x^2)");
}
majorant majorant_of_dawson(const ball*, int sign) {
  return steady(sign > 0 ? "2*x/(1+x^2)" : "-2*x/(1+x^2)");
}

// For |x| <= 1/2:
//   erfi(x) - 2/sqrt(pi) x is 2/sqrt(pi) times the integral of e^(t^2) - 1 <= e^(1/4) t^2, at most
//   2/sqrt(pi) e^(1/4)/3 |x|^3 <= |x|^3/2;
//   dawson' - 1 = -2 x dawson(x) is at most 2 x^2: dawson(x) - x is at most 2/3 |x|^3;
//   with w = pi/2 t^2, |sin w - w| <= w^3/6 and |cos w - 1| <= w^2/2: S(x) - pi/6 x^3 is at most
//   (pi/2)^3/42 |x|^7 <= |x|^7/10, and C(x) - x at most pi^2/40 |x|^5 <= |x|^5/4;
//   Shi(x) - x is the integral of sinh(t)/t - 1 <= cosh(1/2)/6 t^2, at most |x|^3/15;
//   Chi(x) - log x is gamma < 3/5 and the integral of (cosh(t) - 1)/t <= cosh(1/2)/2 t, at most
//   1/14 (DLMF 6.2.16).
leading leading_of_erfi(const ball*, int) { return leading_term("2/sqrt(pi)*x", "x^2/4"); }
leading leading_of_dawson(const ball*, int) { return leading_term("x", "x^2/3"); }
leading leading_of_s(const ball*, int) { return leading_term("pi/6*x^3", "x^6/20"); }
leading leading_of_c(const ball*, int) { return leading_term("x", "x^4/8"); }
leading leading_of_shi(const ball*, int) { return leading_term("x", "x^2/30"); }
leading leading_of_chi(const ball*, int sign) {
  return sign > 0 ? leading_term("log(x)", "7/10") : not_defined();
}

// For x >= 4:
//   erfcx(x) is 1/(sqrt(pi) x) times the integral of e^-s e^(-s^2/(4 x^2)) over s > 0 (s = 2 x t),
//   where 1 - w <= e^-w <= 1: less than that by at most 1/(2 sqrt(pi) x^3). erfcx(-x) is 2 e^(x^2)
//   less erfcx(x).
//   dawson D: with y = 1/(2 x), (D - y)' + 2 x (D - y) = 1/(2 x^2) > 0; with y = 1/(2 x) +
//   1/(2 x^3), it is 3/(2 x^4) - 1/(2 x^2) < 0. So D - y keeps its sign where it has that one at 4,
//   as D(4) = 0.12934... lies between 0.125 and 0.1328125. erfi is 2/sqrt(pi) e^(x^2) D(x).
//   Shi and Chi are (Ei(x) +- E_1(x))/2: their distance from e^x/(2 x) is at most e^x/x^2 +
//   e^-x/(2 x), and e^-x/(2 x) <= e^x/x^2, as x/2 <= e^(2 x).
leading erfi_at_infinity(const ball*, int sign) {
  return leading_term("exp(x^2)/(sqrt(pi)*x)",
                      sign > 0 ? "exp(x^2)/(sqrt(pi)*x^3)" : "-exp(x^2)/(sqrt(pi)*x^3)");
}
leading erfcx_at_infinity(const ball*, int sign) {
  return sign > 0 ? leading_term("1/(sqrt(pi)*x)", "1/(2*sqrt(pi)*x^3)")
                  : leading_term("2*exp(x^2)", "-1/(sqrt(pi)*x)");
}
leading dawson_at_infinity(const ball*, int sign) {
  return leading_term("1/(2*x)", sign > 0 ? "1/(2*x^3)" : "-1/(2*x^3)");
}
leading shi_at_infinity(const ball*, int sign) {
  return sign > 0 ? leading_term("exp(x)/(2*x)", "2*exp(x)/x^2")
                  : leading_term("exp(-x)/(2*x)", "2*exp(-x)/x^2");
}
leading chi_at_infinity(const ball*, int sign) {
  return sign > 0 ? leading_term("exp(x)/(2*x)", "2*exp(x)/x^2") : std::nullopt;
}

// ---------------------------------------------------------------------------------------------
// Fresnel's integrals, of sin(pi t^2/2) and cos(pi t^2/2) from 0 to z: these are at most e^(pi |x
// y|). For x > 0 S rises and falls in ever smaller steps, the first up to S(sqrt(2)) <= 3/2. C
// rises up to C(1) <= 1, falls by at most sqrt(3) - 1, and goes on in ever smaller steps.

void value_of_s(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_fresnel(r, nullptr, z, 1, p);
}
void value_of_c(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_fresnel(nullptr, r, z, 1, p);
}
/// The integral of e^(i pi t^2/2) over t > x is, by parts, i e^(i pi x^2/2)/(pi x) and that of
/// e^(i pi t^2/2)/(i pi t^2): at most 2/(pi x) in size.
leading fresnel_at_infinity(const ball*, int sign) {
  return sign > 0 ? oscillating_beside("1/2", "2/(pi*x)") : oscillating_beside("-1/2", "-2/(pi*x)");
}
bounds bounds_of_fresnel(const call& x) {
  const ball growth = pi(few_bits) * greatest_size(x.z.re) * greatest_size(x.z.im);
  return {magnitude::infinity(), exp(growth).magnitude_upper()};
}

// ---------------------------------------------------------------------------------------------
// Hyperbolic sine and cosine integrals. sinh(z)/z is the integral of cosh(z t) over 0 < t < 1, at
// most e^|x|; it is at least 1 and at most cosh(x) for real x. |cosh(z)/z| <= e^|x|/|z|.

void value_of_shi(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) { arb().acb_hypgeom_shi(r, z, p); }
void value_of_chi(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) { arb().acb_hypgeom_chi(r, z, p); }
bounds bounds_of_shi(const call& x) {
  return {magnitude::infinity(), exp(greatest_size(x.z.re)).magnitude_upper()};
}
bounds bounds_of_chi(const call& x) {
  return {magnitude::infinity(),
          divide_up(exp(greatest_size(x.z.re)).magnitude_upper(), x.z.magnitude_lower())};
}
ball slope_of_shi(const ball*, const ball& x) {
  const ball quotient = sinh(x) / x;
  if (!x.is_bounded()) return ball::undefined(x.precision());
  return quotient.is_bounded() ? quotient : hull(ball(1, x.precision()), cosh(greatest_size(x)));
}
/// As that of Ei: (cosh(t) - 1)/t and sinh(t)/t are at most e^t for t > 0.
majorant majorant_of_chi(const ball*, int sign) {
  return sign > 0 ? steady("11*exp(x)*(1+1/x)^(1/8)") : std::nullopt;
}

// ---------------------------------------------------------------------------------------------
// Incomplete gamma functions, for Re z > 0: their derivatives are -+z^(s-1) e^-z, of size
// |z|^(s-1) e^-x for real s. For s > 0 they go on to x = 0, where they are gamma(s) and 0, and are
// monotonic for x >= 0.

void value_of_upper(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  arb().acb_hypgeom_gamma_upper(r, order, z, 0, p);
}
void value_of_lower(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  arb().acb_hypgeom_gamma_lower(r, order, z, 0, p);
}
bounds bounds_of_incomplete(const call& x) {
  const ball size = abs(x.z).with_precision(few_bits);
  const ball slope = pow(size, *x.order - 1) * exp(-least_of(x.z.re));
  return {magnitude::infinity(),
          slope.is_bounded() ? slope.magnitude_upper() : magnitude::infinity()};
}
/// Over x >= 0 from its value at 0, where s > 0 and x is not certainly positive.
ball from_zero(std::string_view name, const ball& s, const ball& x,
               ball (*at_zero)(const ball& s, precision p), precision p) {
  const definition& f = named(name);
  if (certainly_positive(x)) return value_or_undefined(f, {&s, complex_ball(x)}, p).re;
  if (!x.is_bounded() || !certainly_positive(s) || certainly_negative(x) || lower_rational(x) < 0) {
    return ball::undefined(p);
  }
  ball first = at_zero(s, p);
  if (sign_of(x) == certain_sign::zero) return first;
  const complex_ball upper(ball(upper_rational(x), p + 64));
  return hull(first, value_or_undefined(f, {&s, upper}, p).re);
}
ball upper_over(const ball* s, const ball& x, precision p) {
  const auto at_zero = [](const ball& order, precision bits) {
    return gamma(order.with_precision(bits));
  };
  return from_zero("gammaUpper", *s, x, at_zero, p);
}
ball lower_over(const ball* s, const ball& x, precision p) {
  return from_zero(
      "gammaLower", *s, x, [](const ball&, precision bits) { return ball(0, bits); }, p);
}
// Where x goes on below 0, and they are not defined there.
ball upper_from_zero(const ball* s, const ball& x) {
  const precision p = x.precision();
  const complex_ball upper(upper_end(x));
  if (!holds_no_integer(*s) || !certainly_positive(*s) || !certainly_positive(upper.re)) {
    return ball::undefined(p);
  }
  return hull(gamma(s->with_precision(p)), value_of(named("gammaUpper"), {s, upper}, p).re);
}
ball lower_from_zero(const ball* s, const ball& x) {
  const ball rest = upper_from_zero(s, x);
  return rest.is_bounded() ? gamma(s->with_precision(x.precision())) - rest : rest;
}
bool is_whole_from(const std::optional<pi_combination>& x, long least) {
  return is_number(x) && denominator(x->q) == 1 && x->q >= least;
}
bool may_be_incomplete(known_arguments x) {
  if (!is_number(x[1]) || x[1]->q > 0 || is_whole_from(x[0], 1)) return true;
  return x[1]->q == 0 && (!is_number(x[0]) || x[0]->q > 0);
}
bool may_be_lower(known_arguments x) {
  const bool is_pole = is_number(x[0]) && denominator(x[0]->q) == 1 && x[0]->q <= 0;
  return !is_pole && may_be_incomplete(x);
}
/// (n - 1)! times the sum of x^k/k! over k < n: gamma(n, x) is e^-x times that, by parts.
std::string polynomial_of_upper(long n) {
  std::string sum;
  integer c = 1;  // (n - 1)!/k!
  for (long k = n - 1; k >= 0; --k) {
    sum += fmt::format("{}{}*x^{}", sum.empty() ? "" : "+", c.str(), k);
    c *= k;
  }
  return sum;
}
constexpr long greatest_polynomial = 50;
formula simpler_upper(known_arguments x) {
  if (is_exactly(x[1], 0) && is_number(x[0])) return "gamma(s)";
  if (is_exactly(x[0], 0)) return "expint(1,x)";
  if (is_number(x[0]) && x[0]->q == rational(1, 2)) return "sqrt(pi)*erfc(sqrt(x))";
  if (!is_whole_from(x[0], 1) || x[0]->q > greatest_polynomial) return std::nullopt;
  const long n = mpz_get_si(numerator(x[0]->q).backend().data());
  return "exp(-x)*(" + polynomial_of_upper(n) + ")";
}
formula simpler_lower(known_arguments x) {
  if (is_exactly(x[1], 0) && is_number(x[0])) return "0";
  if (is_exactly(x[0], 1)) return "-expm1(-x)";
  return is_number(x[0]) && x[0]->q == rational(1, 2) ? formula("sqrt(pi)*erf(sqrt(x))")
                                                      : std::nullopt;
}
/// For x > 0 and t >= x, t^(s-1) <= x^(s-n) t^(n-1) where s <= n: so gamma(s, x) is at most x^(s-n)
/// gamma(n, x).
majorant majorant_of_upper(const ball* s, int sign) {
  if (sign < 0) return std::nullopt;
  const integer n = ceil_of(upper_rational(*s));
  if (n <= 1) return steady("x^(s-1)*exp(-x)");
  if (n > greatest_polynomial) return std::nullopt;
  const auto k = static_cast<long>(n);
  return steady(fmt::format("x^(s-{})*exp(-x)*({})", k, polynomial_of_upper(k)));
}
majorant majorant_of_lower(const ball* s, int sign) {
  return sign > 0 && certainly_positive(*s) ? steady("gamma(s)") : std::nullopt;
}
// The lower one is the integral of t^(s-1) e^-t from 0 to x, where 1 - t <= e^-t <= 1.
leading leading_of_upper(const ball* s, int sign) {
  return sign > 0 && certainly_positive(*s) ? leading_term("gamma(s)", "x^s/s") : std::nullopt;
}
leading leading_of_lower(const ball* s, int sign) {
  return sign > 0 && certainly_positive(*s) ? leading_term("x^s/s", "x^(s+1)/(s+1)") : std::nullopt;
}
// By parts gamma(s, x) = x^(s-1) e^-x + (s - 1) gamma(s - 1, x), of which the last is at most
// x^(s-2) e^-x for s <= 2; and at most x/(x - s + 2) <= 2 times that for 2 <= s <= 4 <= x, as then
// it is x^(s-2) e^-x plus (s - 2) gamma(s - 2, x) <= (s - 2)/x gamma(s - 1, x).
leading upper_at_infinity(const ball* s, int sign) {
  if (sign < 0 || !certainly_less_equal(*s, ball(4, few_bits))) return std::nullopt;
  return leading_term("x^(s-1)*exp(-x)", "2*abs(s-1)*x^(s-2)*exp(-x)");
}
leading lower_at_infinity(const ball* s, int sign) {
  const majorant rest = majorant_of_upper(s, sign);
  return rest && certainly_positive(*s) ? leading_term("gamma(s)", rest->text) : std::nullopt;
}

// ---------------------------------------------------------------------------------------------
// Polygamma functions. Of order n >= 1 it is (-1)^(n+1) n! times the sum of (z + k)^-(n+1) over
// k >= 0 (the derivatives of DLMF 5.15.1): for Re z > 0 it and its derivative are largest, in size,
// at the least Re z. There the sum is at most its first term and the integral of (x + t)^-(n+1)
// over t > 0: n! x^-(n+1) + (n-1)! x^-n. Without its first term it is that at x + 1, largest, for
// |x| <= 1/2, at x = -1/2, and so at most n! 2^(n+1) + (n-1)! 2^n.

void value_of_polygamma(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  arb().acb_polygamma(r, order, z, p);
}
bool is_order_of_polygamma(const ball& n) {
  constexpr long most = 1000;
  return is_whole(n) && lower_rational(n) >= 1 && lower_rational(n) <= most;
}
obstacle poles_of_polygamma(const call& x) {
  if (!is_order_of_polygamma(*x.order)) return obstacle::unknown;
  if (certainly_positive(x.z.re)) return obstacle::none;
  // Far on the left Arb takes as many terms as |z|: of sets that costs more than it gives.
  constexpr long far = -16;
  if (!x.is_real() && !x.z.is_exact() && lower_rational(x.z.re) < far) return obstacle::unknown;
  return poles_of_gamma(x);
}
/// n! x^-(n+1) + (n-1)! x^-n.
magnitude bound_of_polygamma(long n, const ball& x) {
  const auto factorial = [](long k) {
    integer product;
    mpz_fac_ui(product.backend().data(), static_cast<unsigned long>(k));
    return ball(product, few_bits);
  };
  return (factorial(n) / pow(x, n + 1) + factorial(n - 1) / pow(x, n)).magnitude_upper();
}
bounds bounds_of_polygamma(const call& x) {
  const ball least = least_of(x.z.re);
  if (!certainly_positive(least)) return {};
  const auto n = static_cast<long>(lower_rational(*x.order));
  return {bound_of_polygamma(n, least), bound_of_polygamma(n + 1, least)};
}
bool may_be_polygamma(known_arguments x) {
  if (is_number(x[0]) && !is_whole_from(x[0], 0)) return false;
  return !is_number(x[1]) || x[1]->q > 0 || denominator(x[1]->q) != 1;
}
std::string factorial_text(long n) { return fmt::format("({}!)", n); }
majorant majorant_of_polygamma(const ball* order, int sign) {
  if (sign < 0 || !is_order_of_polygamma(*order)) return std::nullopt;
  const auto n = static_cast<long>(lower_rational(*order));
  return steady(fmt::format("{}/x^{}+{}/x^{}", factorial_text(n), n + 1, factorial_text(n - 1), n));
}
leading leading_of_polygamma(const ball* order, int) {
  if (!is_order_of_polygamma(*order)) return std::nullopt;
  const auto n = static_cast<long>(lower_rational(*order));
  return leading_term(
      fmt::format("{}{}/x^{}", n % 2 == 0 ? "-" : "", factorial_text(n), n + 1),
      fmt::format("{}*2^{}+{}*2^{}", factorial_text(n), n + 1, factorial_text(n - 1), n));
}

/// For x > 0 it is (-1)^(n+1) times the integral of t^n e^(-x t)/(1 - e^-t) over t > 0 (the n-th
/// derivative of DLMF 5.9.12); and 1/(1 - e^-t) = 1/2 + coth(t/2)/2 = 1/t + 1/2 + r with
/// 0 <= r <= t/12, as w coth w lies between 1 and 1 + w^2/3.
leading polygamma_at_infinity(const ball* order, int sign) {
  if (sign < 0 || !is_order_of_polygamma(*order)) return std::nullopt;
  const auto n = static_cast<long>(lower_rational(*order));
  return leading_term(fmt::format("{}({}/x^{}+{}/(2*x^{}))", n % 2 == 0 ? "-" : "",
                                  factorial_text(n - 1), n, factorial_text(n), n + 1),
                      fmt::format("{}/(12*x^{})", factorial_text(n + 1), n + 2));
}

formula polygamma_at_pole(const ball* order, long k) {
  if (!is_order_of_polygamma(*order)) return std::nullopt;
  const auto n = static_cast<long>(lower_rational(*order));
  std::string text = fmt::format("polygamma(n,x+{})", k + 1);
  for (long j = 0; j <= k; ++j) {
    text += fmt::format("{}{}/(x+{})^{}", n % 2 == 0 ? "-" : "+", factorial_text(n), j, n + 1);
  }
  return text;
}

/// At whole numbers by the value at 1, (-1)^(n+1) n! zeta(n + 1), and the difference (-1)^n
/// n!/x^(n+1) of the values at x + 1 and at x (DLMF 5.15.2, 5.15.5).
formula simpler_polygamma(known_arguments x) {
  if (is_exactly(x[0], 0)) return "digamma(x)";
  constexpr long most = 20;
  for (const auto& t : x) {
    if (!is_number(t) || denominator(t->q) != 1 || t->q <= 0 || t->q > most) return std::nullopt;
  }
  const auto n = static_cast<long>(numerator(x[0]->q));
  rational sum = 0;
  for (long k = 1; k < x[1]->q; ++k) {
    sum += rational(1, integer(pow(integer(k), static_cast<unsigned>(n + 1))));
  }
  return fmt::format("{}{}*(zeta({})-{})", n % 2 == 0 ? "-" : "", factorial_text(n), n + 1,
                     sum.str());
}

}  // namespace

std::vector<definition> error_functions() {
  return {
      {.what = {"erfi", "x", "-i erf(i x)", "all x"},
       .value = value_of_erfi,
       .over = bounds_of_erfi,
       .slope = "2/sqrt(pi)*exp(x^2)",
       .simpler = zero_at_zero,
       .bound = majorant_of_erfi,
       .is_monotonic = always,
       .near_zero = leading_of_erfi,
       .near_infinity = erfi_at_infinity},
      {.what = {"erfcx", "x", "exp(x^2) erfc(x)", "all x"},
       .value = value_of_erfcx,
       .over = bounds_of_erfcx,
       .slope = "2*x*erfcx(x)-2/sqrt(pi)",
       .simpler =
           [](known_arguments x) { return is_exactly(x[0], 0) ? formula("1") : std::nullopt; },
       .bound = majorant_of_erfcx,
       .slope_over = slope_of_erfcx,
       .is_monotonic = always,
       .near_infinity = erfcx_at_infinity},
      {.what = {"dawson", "x", "exp(-x^2) times integral of exp(t^2)", "all x"},
       .value = value_of_dawson,
       .over = bounds_of_dawson,
       .slope = "1-2*x*dawson(x)",
       .simpler = zero_at_zero,
       .bound = majorant_of_dawson,
       .near_zero = leading_of_dawson,
       .near_infinity = dawson_at_infinity},
      {.what = {"fresnelS", "x", "integral of sin(pi t^2/2) from 0 to x", "all x"},
       .value = value_of_s,
       .over = bounds_of_fresnel,
       .slope = "sin(pi*x^2/2)",
       .simpler = zero_at_zero,
       .bound = [](const ball*, int) { return oscillating("3/2"); },
       .near_zero = leading_of_s,
       .near_infinity = fresnel_at_infinity},
      {.what = {"fresnelC", "x", "integral of cos(pi t^2/2) from 0 to x", "all x"},
       .value = value_of_c,
       .over = bounds_of_fresnel,
       .slope = "cos(pi*x^2/2)",
       .simpler = zero_at_zero,
       .bound = [](const ball*, int) { return oscillating("1"); },
       .near_zero = leading_of_c,
       .near_infinity = fresnel_at_infinity},
      {.what = {"Shi", "x", "hyperbolic sine integral", "all x"},
       .value = value_of_shi,
       .over = bounds_of_shi,
       .slope = "sinh(x)/x",
       .simpler = zero_at_zero,
       .bound = [](const ball*, int sign) { return steady(sign > 0 ? "exp(x)" : "exp(-x)"); },
       .slope_over = slope_of_shi,
       .is_monotonic = always,
       .near_zero = leading_of_shi,
       .near_infinity = shi_at_infinity},
      {.what = {"Chi", "x", "hyperbolic cosine integral", "x > 0"},
       .value = value_of_chi,
       .in_the_way = left_half,
       .over = bounds_of_chi,
       .slope = "cosh(x)/x",
       .may_be_defined = last_is_positive,
       .is_nowhere_defined = not_positive,
       .bound = majorant_of_chi,
       .is_monotonic = where_positive,
       .near_zero = leading_of_chi,
       .near_infinity = chi_at_infinity},
      {.what = {"gammaUpper", "s, x", "integral of t^(s-1) exp(-t) for t > x", "x > 0; x = 0 < s"},
       .has_order = true,
       .value = value_of_upper,
       .in_the_way = left_half,
       .over = bounds_of_incomplete,
       .slope = "-x^(s-1)*exp(-x)",
       .may_be_defined = may_be_incomplete,
       .is_nowhere_defined = negative_with_broken_order,
       .where_defined = upper_from_zero,
       .simpler = simpler_upper,
       .bound = majorant_of_upper,
       .is_monotonic = where_positive,
       .over_reals = upper_over,
       .near_zero = leading_of_upper,
       .near_infinity = upper_at_infinity},
      {.what = {"gammaLower", "s, x", "the same for 0 < t < x",
                "s not 0, -1, ...; x > 0; x = 0 < s"},
       .has_order = true,
       .value = value_of_lower,
       .in_the_way = left_half,
       .over = bounds_of_incomplete,
       .slope = "x^(s-1)*exp(-x)",
       .may_be_defined = may_be_lower,
       .is_nowhere_defined = negative_with_broken_order,
       .where_defined = lower_from_zero,
       .simpler = simpler_lower,
       .bound = majorant_of_lower,
       .is_monotonic = where_positive,
       .over_reals = lower_over,
       .near_zero = leading_of_lower,
       .near_infinity = lower_at_infinity},
      {.what = {"polygamma", "n, x", "n-th derivative of digamma",
                "n = 0, 1, ...; x not 0, -1, ..."},
       .has_order = true,
       .value = value_of_polygamma,
       .in_the_way = poles_of_polygamma,
       .over = bounds_of_polygamma,
       .slope = "polygamma(n+1,x)",
       .may_be_defined = may_be_polygamma,
       .simpler = simpler_polygamma,
       .bound = majorant_of_polygamma,
       .is_monotonic = where_positive,
       .near_zero = leading_of_polygamma,
       .near_infinity = polygamma_at_infinity,
       .at_pole = polygamma_at_pole}};
}

}  // namespace polhode::arb_functions_impl

#endif
