#ifdef POLHODE_WITH_ARB

// Bessel functions.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "definition.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/special_functions.hpp"

namespace polhode::arb_functions_impl {
namespace {

obstacle left_half_unless_whole(const call& x) {
  return is_whole(*x.order) ? obstacle::none : left_half(x);
}

/// The greatest |order|.
rational most_of(const ball& order) {
  return std::max<rational>(abs(lower_rational(order)), abs(upper_rational(order)));
}

/// An upper bound of I_0(y), y >= 0. e^-y I_0(y) is 1/pi times the integral of e^(-y (1 - cos t))
/// over 0 < t < pi, where 1 - cos t >= 2 t^2/pi^2: at most 1, and at most sqrt(pi/(8 y)).
ball bound_of_i0(const ball& y) {
  const ball most = exp(y);
  return certainly_less(ball(1, few_bits), y) ? most * sqrt(pi(few_bits) / (8 * y)) : most;
}

/// |J_n(z)| <= I_0(|Im z|) for whole n, by the integral of e^(i z cos t) cos(n t) over 0 < t < pi,
/// and <= |z/2|^|n| e^|Im z|/|n|! (DLMF 10.9.2, 10.14.4), with `growth` = |Im z|, `size` = |z|. Of
/// I_n(z) = i^-n J_n(i z) the same with |Re z|.
ball bound_of_whole(const integer& n, const ball& size, const ball& growth) {
  ball bound = bound_of_i0(growth);
  constexpr long most = 1000;
  const integer order = abs(n);
  if (order > 0 && order < most) {
    const auto k = static_cast<long>(order);
    integer factorial;
    mpz_fac_ui(factorial.backend().data(), static_cast<unsigned long>(k));
    const ball other = exp(growth) * pow(size / 2, k) / ball(factorial, few_bits);
    if (certainly_less(other, bound)) bound = other;
  }
  return bound;
}
/// The same of the function and of its derivative, (f_(n-1) -+ f_(n+1))/2.
bounds bounds_of_whole(const call& x, const ball& growth) {
  const integer n = numerator(lower_rational(*x.order));
  const ball size = upper_of(x.z.magnitude_upper());
  const ball z = greatest_size(size);
  const ball slope = (bound_of_whole(n - 1, z, growth) + bound_of_whole(n + 1, z, growth)) / 2;
  return {bound_of_whole(n, z, growth).magnitude_upper(), slope.magnitude_upper()};
}

/// The integral of (1 + 2 s)^m e^(-x s) over s > 0, m >= |order|: 1/x for m = 0, and by parts (1 +
/// 2 m times that of m - 1)/x. None where m is large.
std::optional<ball> integral_of_tail(const ball& order, const ball& x) {
  constexpr long most = 200;
  const rational m = most_of(order);
  if (m > most || !certainly_positive(x)) return std::nullopt;
  ball result = 1 / x;
  for (long k = 1; k < m + 1; ++k) result = (1 + 2 * k * result) / x;
  return result;
}

/// Schlaefli's integrals for Re z > 0 (DLMF 10.9.6, 10.9.7):
///   pi J = integral of cos(order t - z sin t) over 0 < t < pi
///          - sin(pi order) times that of e^(-z sinh t - order t) over t > 0,
///   pi Y = integral of sin(z sin t - order t) over 0 < t < pi
///          - that of (e^(order t) + e^(-order t) cos(pi order)) e^(-z sinh t) over t > 0.
/// The first ones, and their derivatives in z, are at most the integral of cosh(|Im z| sin t),
/// which is pi I_0(|Im z|). In the others |e^(-+ order t)| <= e^(m t) <= (1 + 2 s)^m with
/// s = sinh t and m >= |order|, and dt = ds/sqrt(1 + s^2); a derivative in z has a factor s more,
/// and s/sqrt(1 + s^2) <= 1. So both are at most the integral
/// above with x = the least Re z; of Y twice that.
bounds bounds_by_schlaefli(const call& x, long tails) {
  const auto tail = integral_of_tail(*x.order, least_of(x.z.re));
  if (!tail) return {};
  const ball most = bound_of_i0(greatest_size(x.z.im)) + tails * *tail / pi(few_bits);
  return {most.magnitude_upper(), most.magnitude_upper()};
}

/// For nu >= -1/2 |J_nu(z)| is at most |z/2|^nu e^|Im z|/gamma(nu + 1) (DLMF 10.14.4), and J_nu' =
/// (nu/z) J_nu - J_(nu+1) (DLMF 10.6.2); of I_nu the same with `growth` = |Re z| in the place of
/// |Im z|, as I_nu(z) = e^(-+i pi nu/2) J_nu(+-i z) (DLMF 10.27.6).
bounds bounds_near_zero(const call& x, const ball& growth) {
  constexpr long most = 200;
  const ball nu = x.order->with_precision(few_bits);
  if (!(most_of(nu) <= most) || !certainly_less_equal(ball(-1, few_bits), 2 * nu)) return {};
  const ball size = abs(x.z).with_precision(few_bits);
  const auto bound = [&](const ball& order) {
    return pow(size / 2, order) * exp(growth) / gamma(order + 1);
  };
  const ball slope = abs(nu) / size * bound(nu) + bound(nu + 1);
  if (!slope.is_bounded()) return {};
  return {bound(nu).magnitude_upper(), slope.magnitude_upper()};
}
bounds lesser(const bounds& x, const bounds& y) {
  return {std::min(x.size, y.size), std::min(x.slope, y.slope)};
}
bounds bounds_of_j(const call& x) {
  if (is_whole(*x.order)) return bounds_of_whole(x, greatest_size(x.z.im));
  return lesser(bounds_near_zero(x, greatest_size(x.z.im)), bounds_by_schlaefli(x, 1));
}
bounds bounds_of_y(const call& x) { return bounds_by_schlaefli(x, 2); }

void value_of_j(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  arb().acb_hypgeom_bessel_j(r, order, z, p);
}
void value_of_y(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  arb().acb_hypgeom_bessel_y(r, order, z, p);
}
void value_of_i(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  arb().acb_hypgeom_bessel_i(r, order, z, p);
}
void value_of_k(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  arb().acb_hypgeom_bessel_k(r, order, z, p);
}

void value_of_scaled_i(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  arb().acb_hypgeom_bessel_i_scaled(r, order, z, p);
}
void value_of_scaled_k(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  arb().acb_hypgeom_bessel_k_scaled(r, order, z, p);
}

/// K is the integral of e^(-z cosh t) cosh(order t) over t > 0, for Re z > 0 (DLMF 10.32.9): it and
/// its derivative are largest at the least Re z = x, where they are K and -K'.
bounds bounds_of_k(const call& x) {
  const complex_ball z(least_of(x.z.re));
  if (!certainly_positive(z.re)) return {};
  const definition& k = named("besselK");
  const ball less = *x.order - 1;
  const ball more = *x.order + 1;
  const magnitude sum =
      (value_of(k, {&less, z}, few_bits) + value_of(k, {&more, z}, few_bits)).magnitude_upper();
  return {value_of(k, {x.order, z}, few_bits).magnitude_upper(), scale(sum, -1)};
}
/// For Re z > 0 (DLMF 10.32.4) pi I = integral of e^(z cos t) cos(order t) over 0 < t < pi
/// - sin(pi order) times that of e^(-z cosh t - order t) over t > 0, of which the first, and its
/// derivative, is at most pi I_0(Re z); the second is at most twice K, and its derivative at most
/// twice -K'.
bounds bounds_of_i(const call& x) {
  const ball growth = greatest_size(x.z.re);
  if (is_whole(*x.order)) return bounds_of_whole(x, growth);
  const bounds k = bounds_of_k(x);
  const auto sum = [&](const magnitude& tail) {
    return (bound_of_i0(growth) + 2 * upper_of(tail) / pi(few_bits)).magnitude_upper();
  };
  return lesser(bounds_near_zero(x, growth), {sum(k.size), sum(k.slope)});
}

/// e^z K is the integral of e^(-z u) cosh(order t), u = cosh t - 1: it and its derivative, that of
/// u e^(-z u) cosh(order t), are largest, in size, at the least Re z = x. As u e^(-x u/2) is at
/// most 2/(e x), the second is at most 2/(e x) times the first at x/2.
bounds bounds_of_scaled_k(const call& x) {
  const complex_ball z(least_of(x.z.re));
  if (!certainly_positive(z.re)) return {};
  const definition& k = named("besselKx");
  const ball less = *x.order - 1;
  const ball more = *x.order + 1;
  const complex_ball value = value_of(k, {x.order, z}, few_bits);
  const complex_ball half(scale(z.re, -1));
  const ball of_half = value_of(k, {x.order, half}, few_bits).re;
  const magnitude far = (2 * of_half / (exp(ball(1, few_bits)) * z.re)).magnitude_upper();
  const complex_ball sum = value_of(k, {&less, z}, few_bits) + value_of(k, {&more, z}, few_bits);
  return {value.magnitude_upper(), std::min(far, (sum / 2 - value).magnitude_upper())};
}
/// By the integrals of bounds_of_i, with u = 1 - cos t and x the least Re z: e^-z I is at most
/// 1/pi times the integral of e^(-x u) over 0 < t < pi, and its derivative that of u e^(-x u). For
/// x > 0 the first is e^-x I_0(x), at most 1 and sqrt(pi/(8 x)) (bound_of_i0); the second is at
/// most 2/(e x) times the first at x/2, as u e^(-x u/2) <= 2/(e x). For x <= 0 they are at most
/// e^(-2 x) and 2 e^(-2 x). Of an order that is not whole, the second integral of e^-z I is at most
/// 2 K(x)/(pi e^x), its derivative 2 (K(x) - K'(x))/(pi e^x).
bounds bounds_of_scaled_i(const call& x) {
  const ball least = least_of(x.z.re);
  const bool is_right = certainly_positive(least);
  const auto of_cosine = [](const ball& y) {
    return min(ball(1, few_bits), sqrt(pi(few_bits) / (8 * y)));
  };
  const ball size = is_right ? of_cosine(least) : exp(-2 * least);
  ball slope = 2 * size;
  if (is_right) {
    slope = min(slope, 2 * of_cosine(least / 2) / (exp(ball(1, few_bits)) * least));
  }
  const bounds of_whole{size.magnitude_upper(), slope.magnitude_upper()};
  if (is_whole(*x.order)) return of_whole;
  const bounds k = bounds_of_k(x);
  const ball factor = 2 * exp(-least) / pi(few_bits);
  const ball tail = upper_of(k.size) * factor;
  const bounds of_integrals{(size + tail).magnitude_upper(),
                            (slope + tail + upper_of(k.slope) * factor).magnitude_upper()};
  // |e^-z| = e^-Re z takes the growth from bounds_near_zero; the derivative is e^-z (I' - I).
  bounds near = is_right ? bounds_near_zero(x, ball(0, few_bits)) : bounds();
  near.slope = add_up(near.slope, near.size);
  return lesser(near, of_integrals);
}

/// K is convex in nu and even, and so is e^z K, by their integrals: for |nu| <= N, x = Re z and any
/// h > 0 the derivative in nu is at most the value of order N + h at x, less that of order N,
/// divided by h.
magnitude over_order_of(const char* name, const call& x) {
  const complex_ball z(least_of(x.z.re));
  if (!certainly_positive(z.re)) return magnitude::infinity();
  const ball step = step_of_order(z.re);
  const ball more = upper_end(abs(*x.order) + step);
  return (value_of(named(name), {&more, z}, few_bits).re / step).magnitude_upper();
}
magnitude over_order_of_k(const call& x) { return over_order_of("besselK", x); }
magnitude over_order_of_scaled_k(const call& x) { return over_order_of("besselKx", x); }

/// For nu >= 0 its series has positive terms; of a whole order it is even, or odd,
/// and even in nu.
bool is_i_monotonic(const ball* order, const ball& x) {
  return (is_whole(*order) || certainly_less_equal(ball(0, few_bits), *order)) &&
         where_not_zero(order, x);
}

/// integral_of_tail as a formula in x.
formula formula_of_tail(const ball& order) {
  constexpr long most = 20;
  const rational m = most_of(order);
  if (!(m <= most)) return std::nullopt;
  std::string sum = "1/x";
  for (long k = 1; k < m + 1; ++k) sum = fmt::format("(1+{}*({}))/x", 2 * k, sum);
  return sum;
}
/// |J_n(x)| <= 1 for whole n; else, for x > 0, Schlaefli's integrals.
majorant majorant_of_j(const ball* order, int sign) {
  if (is_whole(*order)) return oscillating("1");
  const formula tail = sign > 0 ? formula_of_tail(*order) : std::nullopt;
  return tail ? oscillating("1+(" + *tail + ")/pi") : std::nullopt;
}
/// Of order 0 the second integral is at most twice that of e^(-x s) s^(-7/8), which is gamma(1/8)
/// x^(-1/8) <= 8 x^(-1/8), as sqrt(1 + s^2) >= s^(7/8) and gamma(9/8) <= 1; 16/pi < 6.
majorant majorant_of_y(const ball* order, int sign) {
  if (sign < 0) return std::nullopt;
  if (sign_of(*order) == certain_sign::zero) return oscillating("7*(1+1/x)^(1/8)");
  const formula tail = formula_of_tail(*order);
  return tail ? oscillating("1+2*(" + *tail + ")/pi") : std::nullopt;
}
/// e^|x| for a whole order, by the integral over 0 < t < pi.
majorant majorant_of_i(const ball* order, int sign) {
  if (!is_whole(*order)) return std::nullopt;
  return steady(sign > 0 ? "exp(x)" : "exp(-x)");
}
majorant majorant_of_scaled_i(const ball* order, int sign) {
  if (!is_whole(*order)) return std::nullopt;
  return steady(sign > 0 ? "1" : "exp(-2*x)");
}
/// By its integral K increases with |order|; and with the least n >= |order| - 1/2,
/// K_(n + 1/2)(x) = sqrt(pi/(2 x)) e^-x times the sum of (n+k)!/(k! (n-k)! (2 x)^k) over
/// 0 <= k <= n (DLMF 10.47.9, 10.49.12). With cosh t = 1 + u K_0(x) is e^-x times the integral of
/// e^(-x u)/sqrt(u (u + 2)) over u > 0, at most gamma(1/8) x^(-1/8), as u (u + 2) >= u^(7/4).
/// The same of e^x K without the factor e^-x.
majorant majorant_with_factor(const ball* order, int sign, std::string_view factor) {
  constexpr long most = 20;
  const rational size = most_of(*order);
  if (sign < 0 || !(size <= most)) return std::nullopt;
  if (size == 0) return steady(fmt::format("8*{}*x^(-1/8)", factor));
  long n = 0;
  while (rational(2 * n + 1, 2) < size) ++n;
  std::string sum = "1";
  integer c = 1;  // (n+k)!/(k! (n-k)!)
  for (long k = 1; k <= n; ++k) {
    c = c * (n + k) * (n - k + 1) / k;
    sum += fmt::format("+{}/(2*x)^{}", c.str(), k);
  }
  return steady(fmt::format("sqrt(pi/(2*x))*{}*({})", factor, sum));
}
majorant majorant_of_k(const ball* order, int sign) {
  return majorant_with_factor(order, sign, "exp(-x)");
}
majorant majorant_of_scaled_k(const ball* order, int sign) {
  return majorant_with_factor(order, sign, "1");
}

// Near 0, for 0 < x <= 1/2.
//
// For nu > -1 J_nu(x), and I_nu(x), is (x/2)^nu/gamma(nu + 1) times the sum of the (-+x^2/4)^k/(k!
// (nu + 1) ... (nu + k)) (DLMF 10.2.2, 10.25.2): of that the terms with k >= 1 are at most
// (x^2/4)/(nu + 1) times the sum of the 16^-k/k! over k >= 0, which is at most 2.
//
// For nu > 0 K_nu(x) is half of the integral of t^(nu-1) e^(-x t/2) e^(-x/(2 t)) over t > 0 (DLMF
// 10.32.9, at e^t). With 1 in the place of the last factor it is gamma(nu) (x/2)^-nu/2; and
// 1 - e^-w is at most min(1, w) <= w^d for w = x/(2 t) and 0 <= d <= 1, so that the rest is at most
// half of (x/2)^d gamma(nu - d) (x/2)^(d-nu) for d < nu.
//
// K_0(x) + (log(x/2) + gamma) I_0(x) and (pi/2) Y_0(x) - (log(x/2) + gamma) J_0(x) are the sums of
// +-(1 + 1/2 + ... + 1/k) (x^2/4)^k/k!^2 over k >= 1 (DLMF 10.31.2, 10.8.2), in size at most
// x^2/3 <= 1/12. J_0 and I_0 are 1 but for at most x^2/2, and x^2 |log x| <= x/e < 1/5 and
// |gamma - log 2| < 1/8: K_0(x) + log x, and (pi/2) Y_0(x) - log x, are at most
// 1/8 + (1/5 + 1/32)/2 + 1/12 < 1/3 in size.
leading leading_of_j(const ball* order, int sign) {
  if (sign < 0) return holds_no_integer(*order) ? not_defined() : std::nullopt;
  if (!certainly_less(ball(-1, few_bits), *order)) return std::nullopt;
  return leading_term("(x/2)^nu/gamma(1+nu)", "(x/2)^nu*x^2/(2*gamma(2+nu))");
}
leading leading_of_k(const ball* order, int sign) {
  if (sign < 0) return not_defined();
  if (sign_of(*order) == certain_sign::zero) return leading_term("-log(x)", "1/3");
  const std::string size = certainly_negative(*order) ? "(-nu)" : "nu";
  const ball nu = abs(*order);
  const std::string main = fmt::format("gamma({0})/2*(x/2)^(-{0})", size);
  if (certainly_less(ball(1, few_bits), nu)) {  // with d = 1/2
    return leading_term(main, fmt::format("gamma({0}-1/2)/2*(x/2)^(1-{0})", size));
  }
  if (!certainly_positive(nu) || !certainly_less(nu, ball(2, few_bits))) return std::nullopt;
  return leading_term(main, fmt::format("gamma({}/2)/2", size));  // with d = nu/2
}
/// 1 - e^-x <= x and e^x - 1 <= 2 x, e^x <= 2 for 0 < x <= 1/2.
leading leading_of_scaled_i(const ball* order, int sign) {
  leading i = leading_of_j(order, sign);
  if (i && sign > 0) i->rest = fmt::format("({})+x*({})", i->rest, i->main);
  return i;
}
leading leading_of_scaled_k(const ball* order, int sign) {
  leading k = leading_of_k(order, sign);
  if (k && sign > 0) k->rest = fmt::format("2*({})+2*x*({})", k->rest, k->main);
  return k;
}
leading leading_of_y(const ball* order, int sign) {
  if (sign < 0) return not_defined();
  if (sign_of(*order) != certain_sign::zero) return std::nullopt;
  return leading_term("2/pi*log(x)", "2/(3*pi)");
}

// Towards infinity, for nu >= 0 and x >= 4. With u = 1 - cos t the first integral of bounds_of_i
// says that e^-x I(x) is 1/pi times the integral of e^(-x u) cos(nu t)/sqrt(u (2 - u)) over
// 0 < u < 2, but for at most e^-x K_0(x)/pi <= e^(-2 x)/sqrt(2 pi x). Let m = 1/sqrt(2 pi x).
//   With 1 in the place of the cosine it is at least m less the part of u > 2 in m = 1/(pi sqrt(2))
// times the integral of e^(-x u)/sqrt(u), at most e^(-2 x)/(2 pi x); and at most m (1 + 1/(4 x))
// and e^-x/2, as 1/sqrt(2 - u) <= (1 + u/2)/sqrt(2) for u < 1 (it is convex, and 1 <= 3/(2
// sqrt(2)) at 1), and the integral of 1/sqrt(u (2 - u)) over 1 < u < 2 is pi/2.
//   |cos(nu t) - 1| <= nu^2 t^2/2 <= nu^2 (pi^2/4) u, as u >= 2 t^2/pi^2: that adds nu^2 pi/4 times
// the integral of u e^(-x u)/sqrt(u (2 - u)), at most sqrt(pi)/2 x^(-3/2) for u < 1 and, by u <= 2,
// pi e^-x beyond.
//   As e^-x x sqrt(2 pi x), which falls from x = 3/2 on, is less than 3/8 at 4, and sqrt(pi)/2
// sqrt(2 pi) < 9/4, all this is at most m/x (1/4 + 3/16 + 1/16 + nu^2 (pi/4) (9/4 + 6/5)) <=
// m/x (1/2 + 3 nu^2).
leading i_with_factor(const ball* order, int sign, std::string_view right, std::string_view left) {
  if (!certainly_less_equal(ball(0, few_bits), *order)) return std::nullopt;
  const std::string_view share = "(1/2+3*nu^2)";
  if (sign > 0) {
    const std::string main = fmt::format("{}/sqrt(2*pi*x)", right);
    return leading_term(main, fmt::format("{}*{}/x", main, share));
  }
  // I(-x) = (-1)^nu I(x) of a whole order.
  if (!is_whole(*order)) return std::nullopt;
  const std::string size = fmt::format("{}/sqrt(-2*pi*x)", left);
  const bool is_even = numerator(lower_rational(*order)) % 2 == 0;
  return leading_term(is_even ? size : "-" + size, fmt::format("{}*{}/(-x)", size, share));
}
leading i_at_infinity(const ball* order, int sign) {
  return i_with_factor(order, sign, "exp(x)", "exp(-x)");
}
leading scaled_i_at_infinity(const ball* order, int sign) {
  return i_with_factor(order, sign, "1", "exp(-2*x)");
}

// With cosh t = 1 + u, e^x K(x) is the integral of e^(-x u) cosh(nu t)/sqrt(u (u + 2)) over u > 0.
// With m = sqrt(pi/(2 x)), that of e^(-x u)/sqrt(2 u):
//   1/sqrt(2) - 1/sqrt(2 + u) lies between 0 and u/(4 sqrt(2)), as 1/sqrt(2 + u) is convex: that is
// at most 1/(4 sqrt(2)) times the integral of sqrt(u) e^(-x u), sqrt(pi)/2 x^(-3/2): m/(8 x).
//   t^2 <= 2 u, and 0 <= cosh(nu t) - 1 <= nu^2 t^2/2 cosh(nu t) <= nu^2 u e^|nu t|, of which
// |nu t| <= |nu| sqrt(2 u) <= nu^2/4 + 2 u. That adds at most nu^2 e^(nu^2/4)/sqrt(2) times the
// integral of sqrt(u) e^(-(x - 2) u), sqrt(pi)/2 (x - 2)^(-3/2) <= sqrt(2 pi) x^(-3/2) for x >= 4:
// at most sqrt(2) nu^2 e^(nu^2/4) m/x.
leading k_with_factor(const ball* order, int sign, std::string_view factor) {
  constexpr long most = 20;
  if (sign < 0 || !(most_of(*order) <= most)) return std::nullopt;
  const std::string main = fmt::format("{}*sqrt(pi/(2*x))", factor);
  return leading_term(main, main + "*(1/8+3/2*nu^2*exp(nu^2/4))/x");
}
leading k_at_infinity(const ball* order, int sign) { return k_with_factor(order, sign, "exp(-x)"); }
leading scaled_k_at_infinity(const ball* order, int sign) {
  return k_with_factor(order, sign, "1");
}

/// J and I: of a negative number where the order is whole; at 0 where it is not negative as well.
bool may_be_defined_at(known_arguments x) {
  if (!is_number(x[0]) || !is_number(x[1]) || denominator(x[0]->q) == 1) return true;
  return x[1]->q > 0 || (x[1]->q == 0 && x[0]->q > 0);
}
/// |J(x)|, and e^-x I(x), are at most (x/2)^nu/gamma(nu + 1) for nu >= 0 (DLMF 10.14.4), and I
/// increases from 0 for nu > 0.
ball j_from_zero(const ball* order, const ball& x) {
  const precision p = x.precision();
  const ball upper = upper_end(x);
  const bool is_known = certainly_positive(*order) && holds_no_integer(*order);
  if (!is_known || !certainly_positive(upper)) return ball::undefined(p);
  const ball size = pow(scale(upper, -1), *order) / gamma(*order + 1);
  return size.is_bounded() ? ball(0, p).enlarged(size.magnitude_upper()) : ball::undefined(p);
}
ball i_from_zero(const ball* order, const ball& x) {
  const precision p = x.precision();
  const complex_ball upper(upper_end(x));
  const bool is_known = certainly_positive(*order) && holds_no_integer(*order);
  if (!is_known || !certainly_positive(upper.re)) return ball::undefined(p);
  return hull(ball(0, p), value_of(named("besselI"), {order, upper}, p).re);
}
formula value_at_zero(known_arguments x) {
  if (!is_exactly(x[1], 0) || !is_number(x[0])) return std::nullopt;
  if (x[0]->q == 0) return "1";
  return x[0]->q > 0 || denominator(x[0]->q) == 1 ? formula("0") : std::nullopt;
}

// With w = x - nu pi/2 - pi/4 and x > 0, J + i Y = sqrt(2/(pi x)) e^(i w) times the sum of
// i^k a_k/x^k over k < l and a rest of at most |a_l|/x^l, a_0 = 1 and a_k = a_(k-1) (4 nu^2 -
// (2 k - 1)^2)/(8 k), for nu > -1/2 and l >= max(nu - 1/2, 1) (DLMF 10.17.1, 10.17.5, 10.17(iii)).
// J_-nu + i Y_-nu is e^(i nu pi) (J_nu + i Y_nu) (10.4.6): the sum is the same for -nu. For x >= 4
// all but the first term is at most share_of_wave/x, the sum of |a_k| 4^(1-k) over 1 <= k <= l.
std::optional<rational> share_of_wave(const ball& order) {
  constexpr long most = 20;
  const rational nu = most_of(order);
  if (!(nu <= most)) return std::nullopt;
  const rational least = contains_zero(order) ? rational(0)
                                              : std::min<rational>(abs(lower_rational(order)),
                                                                   abs(upper_rational(order)));
  const auto factor = [&](const rational& n, long k) {
    const long odd = 2 * k - 1;
    return abs(rational(4 * n * n - odd * odd));
  };
  rational term = 4;
  rational sum = 0;
  for (long k = 1; k == 1 || 2 * k < 2 * nu + 1; ++k) {
    term = term * std::max<rational>(factor(least, k), factor(nu, k)) / (32 * k);
    sum = sum + term;
  }
  constexpr long parts = 1L << 20;  // the least of these that is not less, a short number
  return rational(-floor_of(-sum * parts), parts);
}
leading wave_at_infinity(const ball& order, int sign, std::string_view wave) {
  const auto share = share_of_wave(order);
  if (!share || (sign < 0 && !is_whole(order))) return std::nullopt;
  // J(-x) = (-1)^nu J(x) of a whole order.
  const std::string x = sign > 0 ? "x" : "(-x)";
  const bool is_negative = sign < 0 && numerator(lower_rational(order)) % 2 != 0;
  const std::string size = fmt::format("sqrt(2/(pi*{}))", x);
  return oscillating_beside(
      fmt::format("{}{}*{}({}-(nu/2+1/4)*pi)", is_negative ? "-" : "", size, wave, x),
      fmt::format("{}*{}/{}", share->str(), size, x));
}
leading j_at_infinity(const ball* order, int sign) { return wave_at_infinity(*order, sign, "cos"); }
leading y_at_infinity(const ball* order, int sign) {
  return sign > 0 ? wave_at_infinity(*order, sign, "sin") : std::nullopt;
}

}  // namespace

std::vector<definition> bessel_functions() {
  constexpr const char* domain = "x > 0; all x where nu is whole";
  return {{.what = {"besselJ", "nu, x", "Bessel, of the first kind", domain},
           .has_order = true,
           .value = value_of_j,
           .in_the_way = left_half_unless_whole,
           .over = bounds_of_j,
           .slope = "(besselJ(nu-1,x)-besselJ(nu+1,x))/2",
           .may_be_defined = may_be_defined_at,
           .is_nowhere_defined = negative_with_broken_order,
           .where_defined = j_from_zero,
           .simpler = value_at_zero,
           .bound = majorant_of_j,
           .near_zero = leading_of_j,
           .near_infinity = j_at_infinity},
          {.what = {"besselY", "nu, x", "Bessel, of the second kind", "x > 0"},
           .has_order = true,
           .value = value_of_y,
           .in_the_way = left_half,
           .over = bounds_of_y,
           .slope = "(besselY(nu-1,x)-besselY(nu+1,x))/2",
           .may_be_defined = last_is_positive,
           .is_nowhere_defined = not_positive,
           .bound = majorant_of_y,
           .near_zero = leading_of_y,
           .near_infinity = y_at_infinity},
          {.what = {"besselI", "nu, x", "modified Bessel, first kind", domain},
           .has_order = true,
           .value = value_of_i,
           .in_the_way = left_half_unless_whole,
           .over = bounds_of_i,
           .slope = "(besselI(nu-1,x)+besselI(nu+1,x))/2",
           .may_be_defined = may_be_defined_at,
           .is_nowhere_defined = negative_with_broken_order,
           .where_defined = i_from_zero,
           .simpler = value_at_zero,
           .bound = majorant_of_i,
           .is_monotonic = is_i_monotonic,
           .near_zero = leading_of_j,
           .near_infinity = i_at_infinity},
          {.what = {"besselK", "nu, x", "modified Bessel, second kind", "x > 0"},
           .has_order = true,
           .value = value_of_k,
           .in_the_way = left_half,
           .over = bounds_of_k,
           .over_order = over_order_of_k,
           .slope = "-(besselK(nu-1,x)+besselK(nu+1,x))/2",
           .may_be_defined = last_is_positive,
           .is_nowhere_defined = not_positive,
           .bound = majorant_of_k,
           .is_monotonic = where_positive,
           .near_zero = leading_of_k,
           .near_infinity = k_at_infinity},
          {.what = {"besselIx", "nu, x", "exp(-x) besselI(nu, x)", domain},
           .has_order = true,
           .value = value_of_scaled_i,
           .in_the_way = left_half_unless_whole,
           .over = bounds_of_scaled_i,
           .slope = "(besselIx(nu-1,x)+besselIx(nu+1,x))/2-besselIx(nu,x)",
           .may_be_defined = may_be_defined_at,
           .is_nowhere_defined = negative_with_broken_order,
           .where_defined = j_from_zero,
           .simpler = value_at_zero,
           .bound = majorant_of_scaled_i,
           .near_zero = leading_of_scaled_i,
           .near_infinity = scaled_i_at_infinity},
          {.what = {"besselKx", "nu, x", "exp(x) besselK(nu, x)", "x > 0"},
           .has_order = true,
           .value = value_of_scaled_k,
           .in_the_way = left_half,
           .over = bounds_of_scaled_k,
           .over_order = over_order_of_scaled_k,
           .slope = "besselKx(nu,x)-(besselKx(nu-1,x)+besselKx(nu+1,x))/2",
           .may_be_defined = last_is_positive,
           .is_nowhere_defined = not_positive,
           .bound = majorant_of_scaled_k,
           .is_monotonic = where_positive,
           .near_zero = leading_of_scaled_k,
           .near_infinity = scaled_k_at_infinity}};
}

}  // namespace polhode::arb_functions_impl

#endif
