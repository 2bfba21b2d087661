#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "polhode/expression/library_functions.hpp"

#ifdef POLHODE_WITH_ARB
#include <fmt/format.h>

#include "arb_library.hpp"
#include "arb_numbers.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/expression/expression.hpp"
#endif

// Arb has the values at points. Its values over sets are wide: a hypergeometric series of sets of
// radius r about z has a radius of r e^|z|. So a set Z with the middle m has f(m) + (Z - m) f',
// f' a mean of the derivative over the segments from m to Z's points (the mean value theorem of
// complex functions: f(z) - f(m) = (z - m) times the integral of f'(m + t (z - m)) for 0 <= t <=
// 1), with the bounds of |f'| that stand beside each function. A rectangle is convex.

namespace polhode {

#ifdef POLHODE_WITH_ARB
namespace arb_functions_impl {
namespace {

using detail::arb;
using detail::arb_number;
using formula = std::optional<std::string>;
using majorant = std::optional<further_function::majorant_formula>;
using leading = std::optional<further_function::leading_formula>;

constexpr precision few_bits = 64;

/// f's order, if it has one, and its variable.
struct call {
  const ball* order;
  complex_ball z;
  [[nodiscard]] bool is_real() const { return sign_of(z.im) == certain_sign::zero; }
};

/// Upper bounds of |f| and |f'|, where there are such.
struct bounds {
  magnitude size = magnitude::infinity();
  magnitude slope = magnitude::infinity();
};

/// A function f(order, z) or f(z).
struct definition {
  expression_function what;
  bool has_order;
  /// Sets r to an enclosure of the value.
  void (*value)(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p);
  /// What keeps f from being analytic on the rectangle z; none where it is.
  obstacle (*in_the_way)(const call& x);
  /// Bounds over the rectangle z, on which f is analytic; nullptr: Arb has good values over sets.
  bounds (*over)(const call& x);
  const char* slope;  // f' as a formula in the names of its arguments
  std::function<bool(known_arguments)> may_be_defined = nullptr;
  std::function<formula(known_arguments)> simpler = nullptr;
  /// Of |f(x)| for x > 0, or for x < 0 where sign is -1; `order` is nullptr where f has none.
  majorant (*bound)(const ball* order, int sign) = nullptr;
  /// f' over real sets, where the formula does not have it; nullptr: it has.
  ball (*slope_over)(const ball* order, const ball& x) = nullptr;
  /// f over real sets, where more is known of them; nullptr: as over rectangles.
  ball (*over_reals)(const ball* order, const ball& x, precision p) = nullptr;
  /// f near 0; `order` is nullptr where f has none.
  leading (*near_zero)(const ball* order, int sign) = nullptr;
};

// ---------------------------------------------------------------------------------------------
// Values

/// With as many bits as it takes for p known ones; where the order is no single number, fewer.
complex_ball value_of(const definition& f, const call& x, precision p) {
  const arb_number z(x.z);
  std::optional<arb_number> order;
  if (x.order != nullptr) order.emplace(complex_ball(*x.order));
  arb_number r;
  const precision most = 16 * p + 4096;
  constexpr long gain = 4;  // in bits: less is none
  long before = -ARF_PREC_EXACT;
  for (precision working = p + 32; working <= most; working *= 2) {
    f.value(r.get(), order ? order->get() : nullptr, z.get(), working);
    const long known = r.accuracy();
    const bool may_gain = x.z.is_exact() && (order ? known <= 0 : true);
    if (known >= p || (!may_gain && known <= before + gain)) break;
    before = known;
  }
  complex_ball result = r.to_complex_ball(p);
  if (x.is_real()) result.im = ball(0, p);
  return result;
}

/// f on the rectangle z, on which it is analytic.
complex_ball value_over(const definition& f, const call& x, precision p) {
  if (f.over == nullptr || x.z.is_exact()) return value_of(f, x, p);
  const bounds b = f.over(x);
  if (b.slope.is_infinite() && b.size.is_infinite()) return value_of(f, x, p);
  const complex_ball middle = value_of(f, {x.order, x.z.middle()}, p);
  const magnitude error = multiply_up(add_up(x.z.re.radius(), x.z.im.radius()), b.slope);
  const bool is_far = b.size <= error || !middle.is_bounded();
  complex_ball result = is_far ? complex_ball(0, p).enlarged(b.size) : middle.enlarged(error);
  if (x.is_real()) result.im = ball(0, p);
  return result.re.is_bounded() ? result : complex_ball::undefined(p);
}

complex_ball value_or_undefined(const definition& f, const call& x, precision p) {
  if (!x.z.is_bounded() || f.in_the_way(x) != obstacle::none) return complex_ball::undefined(p);
  return value_over(f, x, p);
}

// ---------------------------------------------------------------------------------------------
// Where the functions are analytic

obstacle nothing(const call&) { return obstacle::none; }
/// Re z > 0.
obstacle left_half(const call& x) {
  if (certainly_positive(x.z.re)) return obstacle::none;
  return certainly_negative(x.z.re) ? obstacle::unknown : obstacle::branch_cut;
}
bool is_whole(const ball& order) {
  return order.is_exact() && denominator(lower_rational(order)) == 1;
}
obstacle left_half_unless_whole(const call& x) {
  return is_whole(*x.order) ? obstacle::none : left_half(x);
}

leading near_zero(std::string main, std::string rest) {
  return further_function::leading_formula{std::move(main), std::move(rest)};
}
/// Where f is not defined for x < 0: a formula that is not, either.
leading not_defined() { return near_zero("log(x)", "1"); }
majorant steady(std::string text) { return further_function::majorant_formula{std::move(text)}; }
majorant oscillating(std::string text) {
  return further_function::majorant_formula{std::move(text), true};
}

// ---------------------------------------------------------------------------------------------
// Bessel functions

ball upper_of(const magnitude& x) { return ball(0, few_bits).enlarged(x); }
/// At least the greatest |t| of a set of real numbers, and at most the least of one: single
/// numbers.
ball greatest_size(const ball& t) {
  return {upper_rational(upper_of(t.magnitude_upper())), few_bits};
}
ball least_of(const ball& t) {
  detail::mpfr_cell lower(few_bits);
  t.lower(lower.get());
  return ball(lower.get());
}

/// The greatest |order|.
rational most_of(const ball& order) {
  return std::max<rational>(abs(lower_rational(order)), abs(upper_rational(order)));
}

/// |J_n(z)| <= e^|Im z| for whole n, and <= |z/2|^|n| e^|Im z|/|n|! (DLMF 10.9.2, 10.14.4), with
/// `growth` = |Im z|, `size` = |z|. Of I_n(z) = i^-n J_n(i z) the same with |Re z|.
ball bound_of_whole(const integer& n, const ball& size, const ball& growth) {
  ball bound = exp(growth);
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
/// The first ones, and their derivatives in z, are at most pi e^|Im z|. In the others |e^(-+ order
/// t)| <= e^(m t) <= (1 + 2 s)^m with s = sinh t and m >= |order|, and dt = ds/sqrt(1 + s^2); a
/// derivative in z has a factor s more, and s/sqrt(1 + s^2) <= 1. So both are at most the integral
/// above with x = the least Re z; of Y twice that.
bounds bounds_by_schlaefli(const call& x, long tails) {
  const auto tail = integral_of_tail(*x.order, least_of(x.z.re));
  if (!tail) return {};
  const ball most = exp(greatest_size(x.z.im)) + tails * *tail / pi(few_bits);
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

const definition& named(std::string_view name);

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
/// derivative, is at most pi e^(Re z); the second is at most twice K, and its derivative twice -K'.
bounds bounds_of_i(const call& x) {
  const ball growth = greatest_size(x.z.re);
  if (is_whole(*x.order)) return bounds_of_whole(x, growth);
  const bounds k = bounds_of_k(x);
  const auto sum = [&](const magnitude& tail) {
    return (exp(growth) + 2 * upper_of(tail) / pi(few_bits)).magnitude_upper();
  };
  return lesser(bounds_near_zero(x, growth), {sum(k.size), sum(k.slope)});
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
/// By its integral K increases with |order|; and with the least n >= |order| - 1/2,
/// K_(n + 1/2)(x) = sqrt(pi/(2 x)) e^-x times the sum of (n+k)!/(k! (n-k)! (2 x)^k) over
/// 0 <= k <= n (DLMF 10.47.9, 10.49.12). With cosh t = 1 + u K_0(x) is e^-x times the integral of
/// e^(-x u)/sqrt(u (u + 2)) over u > 0, at most gamma(1/8) x^(-1/8), as u (u + 2) >= u^(7/4).
majorant majorant_of_k(const ball* order, int sign) {
  constexpr long most = 20;
  const rational size = most_of(*order);
  if (sign < 0 || !(size <= most)) return std::nullopt;
  if (size == 0) return steady("8*exp(-x)*x^(-1/8)");
  long n = 0;
  while (rational(2 * n + 1, 2) < size) ++n;
  std::string sum = "1";
  integer c = 1;  // (n+k)!/(k! (n-k)!)
  for (long k = 1; k <= n; ++k) {
    c = c * (n + k) * (n - k + 1) / k;
    sum += fmt::format("+{}/(2*x)^{}", c.str(), k);
  }
  return steady(fmt::format("sqrt(pi/(2*x))*exp(-x)*({})", sum));
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
bool is_certainly_not_whole(const ball& order) {
  const rational lower = lower_rational(order);
  const integer below = floor_of(lower);
  return lower > below && upper_rational(order) < below + 1;
}
leading leading_of_j(const ball* order, int sign) {
  if (sign < 0) return is_certainly_not_whole(*order) ? not_defined() : std::nullopt;
  if (!certainly_less(ball(-1, few_bits), *order)) return std::nullopt;
  return near_zero("(x/2)^nu/gamma(1+nu)", "(x/2)^nu*x^2/(2*gamma(2+nu))");
}
leading leading_of_k(const ball* order, int sign) {
  if (sign < 0) return not_defined();
  if (sign_of(*order) == certain_sign::zero) return near_zero("-log(x)", "1/3");
  const std::string size = certainly_negative(*order) ? "(-nu)" : "nu";
  const ball nu = abs(*order);
  const std::string main = fmt::format("gamma({0})/2*(x/2)^(-{0})", size);
  if (certainly_less(ball(1, few_bits), nu)) {  // with d = 1/2
    return near_zero(main, fmt::format("gamma({0}-1/2)/2*(x/2)^(1-{0})", size));
  }
  if (!certainly_positive(nu) || !certainly_less(nu, ball(2, few_bits))) return std::nullopt;
  return near_zero(main, fmt::format("gamma({}/2)/2", size));  // with d = nu/2
}
leading leading_of_y(const ball* order, int sign) {
  if (sign < 0) return not_defined();
  if (sign_of(*order) != certain_sign::zero) return std::nullopt;
  return near_zero("2/pi*log(x)", "2/(3*pi)");
}

bool is_number(const std::optional<pi_combination>& x) { return x && x->is_rational(); }
bool is_exactly(const std::optional<pi_combination>& x, long n) {
  return is_number(x) && x->q == n;
}

/// J and I: of a negative number where the order is whole; at 0 where it is not negative as well.
bool may_be_defined_at(known_arguments x) {
  if (!is_number(x[0]) || !is_number(x[1]) || denominator(x[0]->q) == 1) return true;
  return x[1]->q > 0 || (x[1]->q == 0 && x[0]->q > 0);
}
formula value_at_zero(known_arguments x) {
  if (!is_exactly(x[1], 0) || !is_number(x[0])) return std::nullopt;
  if (x[0]->q == 0) return "1";
  return x[0]->q > 0 || denominator(x[0]->q) == 1 ? formula("0") : std::nullopt;
}
bool last_is_positive(known_arguments x) { return !is_number(x.back()) || x.back()->q > 0; }

std::vector<definition> bessel_functions() {
  constexpr const char* domain = "x > 0; all x where nu is whole";
  return {{{"besselJ", "nu, x", "Bessel, of the first kind", domain},
           true,
           value_of_j,
           left_half_unless_whole,
           bounds_of_j,
           "(besselJ(nu-1,x)-besselJ(nu+1,x))/2",
           may_be_defined_at,
           value_at_zero,
           majorant_of_j,
           nullptr,
           nullptr,
           leading_of_j},
          {{"besselY", "nu, x", "Bessel, of the second kind", "x > 0"},
           true,
           value_of_y,
           left_half,
           bounds_of_y,
           "(besselY(nu-1,x)-besselY(nu+1,x))/2",
           last_is_positive,
           nullptr,
           majorant_of_y,
           nullptr,
           nullptr,
           leading_of_y},
          {{"besselI", "nu, x", "modified Bessel, first kind", domain},
           true,
           value_of_i,
           left_half_unless_whole,
           bounds_of_i,
           "(besselI(nu-1,x)+besselI(nu+1,x))/2",
           may_be_defined_at,
           value_at_zero,
           majorant_of_i,
           nullptr,
           nullptr,
           leading_of_j},
          {{"besselK", "nu, x", "modified Bessel, second kind", "x > 0"},
           true,
           value_of_k,
           left_half,
           bounds_of_k,
           "-(besselK(nu-1,x)+besselK(nu+1,x))/2",
           last_is_positive,
           nullptr,
           majorant_of_k,
           nullptr,
           nullptr,
           leading_of_k}};
}

// ---------------------------------------------------------------------------------------------
// Airy functions, which Arb has over sets by bounds of their derivatives. For x > 0, 2 pi i Ai(x)
// is the integral of e^(s^3/3 - x s) over s = sqrt(x) + i t, on which the exponent is -(2/3)
// x^(3/2) - sqrt(x) t^2 - i t^3/3: so |Ai(x)| is at most e^(-(2/3) x^(3/2))/(2 pi) times the
// integral of e^(-sqrt(x) t^2), which is sqrt(pi) x^(-1/4); and |Ai'(x)|, with s for a factor and
// |s| <= sqrt(x) + t^2/(2 sqrt(x)), at most x^(1/4) e^(-(2/3) x^(3/2))/(2 sqrt(pi)) times 1 +
// x^(-3/2)/4.
//
// For x = -z < 0 they are sums of two Bessel functions J of t = (2/3) z^(3/2), of orders 1/3 and
// -1/3, and of 2/3 and -2/3 for the derivatives (DLMF 9.6.6 to 9.6.9). By DLMF 10.27.8 and 10.32.8
// at w = -i t, where |1 + s/(2 w)| >= 1 for s > 0, |J| <= |H1(t)| = (2/pi) |K(w)| is at most
// sqrt(2/(pi t)) for orders up to 1/2, and for 2/3, with |1 + s/(2 w)|^(1/6) <= 1 + s/(2 t), at
// most that times 1 + 7/(12 t) = 1 + (7/8) z^(-3/2), with z^(-3/2) <= 1/z + 1/z^2.

void value_of_ai(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_airy(r, nullptr, nullptr, nullptr, z, p);
}
void value_of_ai_prime(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_airy(nullptr, r, nullptr, nullptr, z, p);
}
void value_of_bi(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_airy(nullptr, nullptr, r, nullptr, z, p);
}
void value_of_bi_prime(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_airy(nullptr, nullptr, nullptr, r, z, p);
}

std::vector<definition> airy_functions() {
  return {{{"airyAi", "x", "Airy, the one that decays", "all x"},
           false,
           value_of_ai,
           nothing,
           nullptr,
           "airyAiPrime(x)",
           nullptr,
           nullptr,
           [](const ball*, int sign) {
             return sign < 0 ? oscillating("2/(sqrt(3*pi)*(-x)^(1/4))")
                             : steady("exp(-2/3*x^(3/2))/(2*sqrt(pi)*x^(1/4))");
           }},
          {{"airyAiPrime", "x", "derivative of airyAi", "all x"},
           false,
           value_of_ai_prime,
           nothing,
           nullptr,
           "x*airyAi(x)",
           nullptr,
           nullptr,
           [](const ball*, int sign) {
             return sign < 0 ? oscillating("2*(-x)^(1/4)/sqrt(3*pi)*(1+7/8*(1/x^2-1/x))")
                             : steady("x^(1/4)*exp(-2/3*x^(3/2))/(2*sqrt(pi))*(1+x^(-3/2)/4)");
           }},
          {{"airyBi", "x", "Airy, the one that grows", "all x"},
           false,
           value_of_bi,
           nothing,
           nullptr,
           "airyBiPrime(x)",
           nullptr,
           nullptr,
           [](const ball*, int sign) {
             return sign < 0 ? oscillating("2/(sqrt(pi)*(-x)^(1/4))") : std::nullopt;
           }},
          {{"airyBiPrime", "x", "derivative of airyBi", "all x"},
           false,
           value_of_bi_prime,
           nothing,
           nullptr,
           "x*airyBi(x)",
           nullptr,
           nullptr,
           [](const ball*, int sign) {
             return sign < 0 ? oscillating("2*(-x)^(1/4)/sqrt(pi)*(1+7/8*(1/x^2-1/x))")
                             : std::nullopt;
           }}};
}

// ---------------------------------------------------------------------------------------------
// Exponential integrals

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
  return near_zero("-log(x)", "3/5");
}
leading leading_of_ei(const ball*, int sign) {
  return sign > 0 ? near_zero("log(x)", "3/2") : near_zero("log(-x)", "3/5");
}
leading leading_of_ci(const ball*, int sign) {
  return sign > 0 ? near_zero("log(x)", "3/5") : not_defined();
}

std::vector<definition> exponential_integrals() {
  const auto is_not_zero = [](known_arguments x) { return !is_exactly(x[0], 0); };
  const auto zero_at_zero = [](known_arguments x) {
    return is_exactly(x[0], 0) ? formula("0") : std::nullopt;
  };
  return {
      {{"expint", "n, x", "E_n, exponential integral", "x > 0"},
       true,
       value_of_expint,
       left_half,
       bounds_of_expint,
       "-expint(n-1,x)",
       last_is_positive,
       nullptr,
       majorant_of_expint,
       nullptr,
       nullptr,
       leading_of_expint},
      {{"Ei", "x", "exponential integral", "x != 0"},
       false,
       value_of_ei,
       around_zero,
       bounds_of_ei,
       "exp(x)/x",
       is_not_zero,
       nullptr,
       majorant_of_ei,
       nullptr,
       nullptr,
       leading_of_ei},
      {{"Si", "x", "sine integral", "all x"},
       false,
       value_of_si,
       nothing,
       bounds_of_si,
       "sin(x)/x",
       nullptr,
       zero_at_zero,
       [](const ball*, int) { return oscillating("pi"); },
       slope_of_si},
      {{"Ci", "x", "cosine integral", "x > 0"},
       false,
       value_of_ci,
       left_half,
       bounds_of_ci,
       "cos(x)/x",
       last_is_positive,
       nullptr,
       [](const ball*, int sign) { return sign > 0 ? oscillating("8*x^(-1/8)") : std::nullopt; },
       nullptr,
       nullptr,
       leading_of_ci}};
}

// ---------------------------------------------------------------------------------------------
// Others

/// psi' = polygamma(1, x) (DLMF 5.15.1).
std::vector<ball> slope_of_digamma(std::span<const ball> x) {
  const arb_number at{complex_ball(x[0])};
  const arb_number one(complex_ball(1, few_bits));
  arb_number r;
  const precision p = x[0].precision();
  arb().acb_polygamma(r.get(), one.get(), at.get(), p + 32);
  return {r.to_complex_ball(p).re};
}
bool has_digamma(known_arguments x) {
  return !is_number(x[0]) || x[0]->q > 0 || denominator(x[0]->q) != 1;
}
further_function digamma_function() {
  further_function result;
  result.what = {"digamma", "x", "(log |gamma(x)|)'", "no whole number <= 0"};
  result.value = [](std::span<const ball> x) { return digamma(x[0]); };
  result.gradient = slope_of_digamma;
  result.may_be_defined = has_digamma;
  result.over_regions = [](std::span<const region> x) { return digamma(x[0]); };
  // For x > 0 log Gamma is convex: psi(x) <= log Gamma(x + 1) - log Gamma(x) = log x <= psi(x + 1),
  // which is psi(x) + 1/x, and -log x <= 1/x.
  result.majorant = [](std::span<const ball>, int sign) -> majorant {
    if (sign < 0) return std::nullopt;
    return steady("log(1+x)+2/x");
  };
  // psi(x) = psi(1 + x) - 1/x, and psi increases from psi(1/2) > -2 to psi(3/2) < 1 (DLMF 5.4.13,
  // 5.5.2).
  result.near_zero = [](std::span<const ball>, int) { return near_zero("-1/x", "2"); };
  return result;
}

/// The branch that is real for x >= -1/e, off the cut below. For x > 0 it is at most w = log(1 +
/// x), as w e^w = (1 + x) log(1 + x) >= x.
void value_of_lambert(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  const fmpz_t branch{0};
  arb().acb_lambertw(r, z, branch, 0, p);
}
obstacle cut_of_lambert(const call& x) {
  const bool is_off = certainly_positive(x.z.im) || certainly_negative(x.z.im) ||
                      certainly_less(-exp(ball(-1, x.z.precision() + 16)), x.z.re);
  return is_off ? obstacle::none : obstacle::branch_cut;
}

/// The sum of z^k/k^2, continued off the cut from 1 on.
void value_of_dilog(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_dilog(r, z, p);
}
obstacle cut_of_dilog(const call& x) {
  const bool is_off = certainly_positive(x.z.im) || certainly_negative(x.z.im) ||
                      certainly_less(x.z.re, ball(1, 2));
  return is_off ? obstacle::none : obstacle::branch_cut;
}

/// Over real numbers up to 1 of a function that increases up to there, and is continuous at 1.
ball between_values(const definition& f, const ball* order, const ball& x, precision p) {
  detail::mpfr_cell end(p + 64);
  x.upper(end.get());
  const ball upper(end.get());
  if (!certainly_less_equal(upper, ball(1, 2)) || !x.is_bounded()) return ball::undefined(p);
  x.lower(end.get());
  return hull(value_of(f, {order, complex_ball(ball(end.get()))}, p).re,
              value_of(f, {order, complex_ball(upper)}, p).re);
}
/// Its slope is -log(1 - x)/x > 0.
ball dilog_over(const ball*, const ball& x, precision p) {
  return between_values(named("dilog"), nullptr, x, p);
}

// For s > 0 and z off [1, inf) Li_s(z)/z is the integral of t^(s-1)/(e^t - z) over t > 0, over
// gamma(s) (DLMF 25.12.11). Where Re z <= x < 1, |e^t - z| >= e^t - x: so |Li_s(z)/z| <= Li_s(x)/x,
// which increases with x, and is 1 at 0; and Li_s'(z) = Li_(s-1)(z)/z (DLMF 25.12.10).
void value_of_polylog(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) {
  arb().acb_polylog(r, order, z, p);
}
bounds bounds_of_polylog(const call& x) {
  const rational least(1, 1024);
  detail::mpfr_cell upper(few_bits);
  x.z.re.upper(upper.get());
  const ball most = ball(upper.get());
  if (!certainly_less(ball(1, few_bits), *x.order) || !certainly_less(most, ball(1, few_bits))) {
    return {};
  }
  const ball at = certainly_less(ball(least, few_bits), most) ? most : ball(least, few_bits);
  const auto quotient = [&](const ball& order) {
    return value_of(named("polylog"), {&order, complex_ball(at)}, few_bits).re / at;
  };
  return {multiply_up(x.z.magnitude_upper(), quotient(*x.order).magnitude_upper()),
          quotient(*x.order - 1).magnitude_upper()};
}
/// Li_(s-1)(x)/x, which for s > 1 increases with x < 1.
ball slope_of_polylog(const ball* order, const ball& x) {
  const precision p = x.precision();
  const ball less = *order - 1;
  const auto quotient = [&](const ball& at) {
    if (sign_of(at) == certain_sign::zero) return ball(1, p);
    return value_or_undefined(named("polylog"), {&less, complex_ball(at)}, p).re / at;
  };
  if (!certainly_positive(less) || !x.is_bounded()) return quotient(x);
  detail::mpfr_cell lower(p);
  detail::mpfr_cell upper(p);
  x.lower(lower.get());
  x.upper(upper.get());
  return hull(quotient(ball(lower.get())), quotient(ball(upper.get())));
}
/// For s >= 0 and |x| <= 1/2 the terms with k >= 2 are at most the sum of the |x|^k, 2 |x|^2.
leading leading_of_polylog(const ball* order, int) {
  const bool is_known = order == nullptr || certainly_less_equal(ball(0, few_bits), *order);
  return is_known ? near_zero("x", "2*x^2") : std::nullopt;
}
/// For s > 1 it increases up to x = 1, where it is continuous.
ball polylog_over(const ball* order, const ball& x, precision p) {
  const definition& f = named("polylog");
  if (certainly_less(x, ball(1, few_bits)) || !certainly_less(ball(1, few_bits), *order)) {
    const call at{order, complex_ball(x)};
    return value_or_undefined(f, at, p).re;
  }
  return between_values(f, order, x, p);
}

// For Re z = x > 0 zeta(z) = z/(z - 1) - z times the integral of {t} t^(-z-1) over t > 1 (DLMF
// 25.2.8), and that of t^(-x-1) log(t)^k is k!/x^(k+1): so |zeta| is at most |z/(z - 1)| + |z|/x,
// |zeta'| at most |z - 1|^-2 + 1/x + |z|/x^2, and |zeta''| at most 2 |z - 1|^-3 + 2/x^2 +
// 2 |z|/x^3.
void value_of_zeta(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) { arb().acb_zeta(r, z, p); }
obstacle pole_of_zeta(const call& x) {
  return contains_zero(x.z.re - 1) && contains_zero(x.z.im) ? obstacle::pole : obstacle::none;
}
bounds bounds_of_zeta(const call& x) {
  const ball least = least_of(x.z.re);
  if (!certainly_positive(least)) return {};
  const ball z = upper_of(x.z.magnitude_upper());
  const ball distance = abs(x.z - 1).with_precision(few_bits);
  const ball size = z / distance + z / least;
  const ball slope = 1 / square(distance) + 1 / least + z / square(least);
  if (!slope.is_bounded()) return {};
  return {size.magnitude_upper(), slope.magnitude_upper()};
}
ball derivative_of_zeta(const ball& x) {
  const arb_number at{complex_ball(x)};
  detail::arb_jet jet;
  arb().acb_dirichlet_zeta_jet(jet.get(), at.get(), 0, 2, x.precision() + 32);
  return jet.derivative(x.precision()).re;
}
/// zeta' over a set of real numbers.
ball slope_of_zeta(const ball*, const ball& x) {
  const ball least = least_of(x);
  if (x.is_exact() || !certainly_positive(least)) return derivative_of_zeta(x);
  const ball distance = abs(x - 1).with_precision(few_bits);
  const ball curvature =
      2 / pow(distance, 3) + 2 / square(least) + 2 * upper_of(x.magnitude_upper()) / pow(least, 3);
  if (!curvature.is_bounded()) return ball::undefined(x.precision());
  return derivative_of_zeta(x.middle())
      .enlarged(multiply_up(x.radius(), curvature.magnitude_upper()));
}

std::vector<definition> other_functions() {
  return {{{"lambertW", "x", "w with w e^w = x, w >= -1", "x >= -1/e"},
           false,
           value_of_lambert,
           cut_of_lambert,
           nullptr,
           "1/(exp(lambertW(x))*(1+lambertW(x)))",
           nullptr,
           [](known_arguments x) { return is_exactly(x[0], 0) ? formula("0") : std::nullopt; },
           [](const ball*, int sign) { return sign > 0 ? steady("log(1+x)") : std::nullopt; }},
          {{"dilog", "x", "dilogarithm, sum of x^k/k^2", "x <= 1"},
           false,
           value_of_dilog,
           cut_of_dilog,
           nullptr,
           "-log(1-x)/x",
           [](known_arguments x) { return !is_number(x[0]) || x[0]->q <= 1; },
           [](known_arguments x) -> formula {
             if (is_exactly(x[0], 0)) return "0";
             if (is_exactly(x[0], 1)) return "pi^2/6";
             if (is_exactly(x[0], -1)) return "-pi^2/12";
             return std::nullopt;
           },
           nullptr,
           nullptr,
           dilog_over,
           leading_of_polylog},
          {{"polylog", "s, x", "polylogarithm, sum of x^k/k^s", "x < 1; x = 1 where s > 1"},
           true,
           value_of_polylog,
           cut_of_dilog,
           bounds_of_polylog,
           "polylog(s-1,x)/x",
           [](known_arguments x) {
             return !is_number(x[1]) || x[1]->q < 1 ||
                    (x[1]->q == 1 && (!is_number(x[0]) || x[0]->q > 1));
           },
           [](known_arguments x) -> formula {
             if (is_exactly(x[1], 0)) return "0";
             if (is_exactly(x[1], 1) && is_number(x[0])) return "zeta(s)";
             if (is_exactly(x[0], 1)) return "-log(1-x)";
             return is_exactly(x[0], 2) ? formula("dilog(x)") : std::nullopt;
           },
           // |Li_s(x)/x| <= 1 for x < 0.
           [](const ball* order, int sign) -> majorant {
             const bool is_known = sign < 0 && certainly_positive(*order);
             return is_known ? steady("-x") : std::nullopt;
           },
           slope_of_polylog,
           polylog_over,
           leading_of_polylog},
          {{"zeta", "s", "Riemann's zeta function", "s != 1"},
           false,
           value_of_zeta,
           pole_of_zeta,
           bounds_of_zeta,
           "",
           [](known_arguments x) { return !is_exactly(x[0], 1); },
           nullptr,
           [](const ball*, int sign) -> majorant {
             return sign > 0 ? steady("1+x/abs(x-1)") : std::nullopt;
           },
           slope_of_zeta}};
}

const std::vector<definition>& all() {
  static const std::vector<definition> functions = [] {
    std::vector<definition> made;
    for (auto* make : {bessel_functions, airy_functions, exponential_integrals, other_functions}) {
      std::vector<definition> some = make();
      made.insert(made.end(), std::make_move_iterator(some.begin()),
                  std::make_move_iterator(some.end()));
    }
    return made;
  }();
  return functions;
}

const definition& named(std::string_view name) {
  return *std::find_if(all().begin(), all().end(),
                       [&](const definition& f) { return f.what.name == name; });
}

// ---------------------------------------------------------------------------------------------
// As functions of formulas

template <class T>
call call_of(const definition& f, std::span<const T> x, std::vector<ball>& order) {
  const auto set = [](const T& t) {
    if constexpr (std::same_as<T, region>) {
      return t.to_complex_ball();
    } else {
      return complex_ball(t);
    }
  };
  const complex_ball z = set(x.back());
  if (!f.has_order) return {nullptr, z};
  const complex_ball first = set(x.front());
  // Of a real order only.
  order.push_back(sign_of(first.im) == certain_sign::zero ? first.re
                                                          : ball::undefined(z.precision()));
  return {&order.back(), z};
}

region over_region(const definition& f, std::span<const region> x) {
  std::vector<ball> order;
  const call at = call_of(f, x, order);
  const region& z = x.back();
  if (at.order != nullptr && !at.order->is_bounded()) {
    return region::blocked(obstacle::unknown, f.what.name);
  }
  if (!at.z.is_bounded()) return region::blocked(obstacle::undefined, f.what.name);
  const obstacle why = f.in_the_way(at);
  if (why != obstacle::none) return region::blocked(why, f.what.name);
  const precision p = z.is_in_hardware() ? few_bits : z.precision();
  const complex_ball value = value_over(f, at, p);
  if (!value.is_bounded()) return region::blocked(obstacle::undefined, f.what.name);
  return z.is_in_hardware() ? region(value) : region::in_balls(value);
}

/// The gradient by the formula of the derivative, which is read once; there is none in the order.
class gradient_by_formula {
 public:
  explicit gradient_by_formula(const definition& f) : f_(f), slope_(std::make_shared<once>()) {}

  std::vector<ball> operator()(std::span<const ball> x) const {
    precision p = few_bits;
    for (const ball& t : x) p = std::max(p, t.precision());
    std::vector<ball> gradient(x.size(), ball::undefined(p));
    if (f_.slope_over != nullptr) {
      gradient.back() = f_.slope_over(f_.has_order ? &x[0] : nullptr, x.back());
      return gradient;
    }
    std::call_once(slope_->flag, [this] {
      slope_->formula.emplace(f_.slope,
                              expression_names{argument_names(f_.what), {}, library_functions()});
    });
    gradient.back() = slope_->formula->evaluator<ball>(p)(std::vector<ball>(x.begin(), x.end()));
    return gradient;
  }

 private:
  struct once {
    std::once_flag flag;
    std::optional<expression> formula;
  };
  const definition& f_;
  std::shared_ptr<once> slope_;
};

further_function function_of(const definition& f) {
  further_function result;
  result.what = f.what;
  result.arity = f.has_order ? 2 : 1;
  const auto at_sets = [&f](auto x, auto&& then) {
    std::vector<ball> order;
    const call at = call_of(f, x, order);
    precision p = at.z.precision();
    for (const auto& t : x) p = std::max(p, t.precision());
    if (at.order != nullptr && !at.order->is_bounded()) return complex_ball::undefined(p);
    return then(at, p);
  };
  result.value = [&f, at_sets](std::span<const ball> x) {
    if (f.over_reals != nullptr) {
      return f.over_reals(f.has_order ? &x[0] : nullptr, x.back(), x.back().precision());
    }
    return at_sets(x, [&](const call& at, precision p) { return value_or_undefined(f, at, p); }).re;
  };
  result.over_complex = [&f, at_sets](std::span<const complex_ball> x) {
    return at_sets(x, [&](const call& at, precision p) { return value_or_undefined(f, at, p); });
  };
  result.slope = f.slope;
  result.gradient = gradient_by_formula(f);
  result.over_regions = [&f](std::span<const region> x) { return over_region(f, x); };
  result.may_be_defined = f.may_be_defined;
  result.simpler = f.simpler;
  if (f.near_zero != nullptr) {
    result.near_zero = [&f](std::span<const ball> orders, int sign) -> leading {
      if (!f.has_order) return f.near_zero(nullptr, sign);
      if (!orders[0].is_bounded()) return std::nullopt;
      return f.near_zero(&orders[0], sign);
    };
  }
  if (f.bound != nullptr) {
    result.majorant = [&f](std::span<const ball> orders, int sign) -> majorant {
      if (!f.has_order) return f.bound(nullptr, sign);
      if (!orders[0].is_bounded()) return std::nullopt;
      return f.bound(&orders[0], sign);
    };
  }
  return result;
}

}  // namespace
}  // namespace arb_functions_impl
#endif

std::shared_ptr<const further_functions> arb_functions() {
  static const auto functions = [] {
    auto made = std::make_shared<further_functions>();
#ifdef POLHODE_WITH_ARB
    for (const auto& f : arb_functions_impl::all()) {
      made->push_back(arb_functions_impl::function_of(f));
    }
    made->push_back(arb_functions_impl::digamma_function());
#endif
    return std::shared_ptr<const further_functions>(std::move(made));
  }();
  return functions;
}

std::shared_ptr<const further_functions> library_functions() {
  static const auto functions = [] {
    auto made = std::make_shared<further_functions>(*elliptic_functions());
    made->insert(made->end(), arb_functions()->begin(), arb_functions()->end());
    return std::shared_ptr<const further_functions>(std::move(made));
  }();
  return functions;
}

}  // namespace polhode
