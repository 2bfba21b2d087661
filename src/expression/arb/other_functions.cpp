#ifdef POLHODE_WITH_ARB

// The digamma function, Lambert's W, polylogarithms and the zeta function.

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "definition.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/gamma_quotients.hpp"
#include "polhode/arithmetic/special_functions.hpp"

namespace polhode::arb_functions_impl {
namespace {

/// psi' = polygamma(1, x) (DLMF 5.15.1).
ball trigamma(const ball& x) {
  const arb_number at{complex_ball(x)};
  const arb_number one(complex_ball(1, few_bits));
  arb_number r;
  arb().acb_polygamma(r.get(), one.get(), at.get(), x.precision() + 32);
  return r.to_complex_ball(x.precision()).re;
}
bool has_digamma(known_arguments x) {
  return !is_number(x[0]) || x[0]->q > 0 || denominator(x[0]->q) != 1;
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

bool below_lambert(const ball*, const ball& x) {
  return certainly_less(x, -exp(ball(-1, x.precision() + 16)));
}

/// It increases from -1 at -1/e.
ball lambert_from_branch(const ball*, const ball& x) {
  const precision p = x.precision();
  const complex_ball upper(upper_end(x));
  const call at{nullptr, upper};
  if (cut_of_lambert(at) != obstacle::none) return ball::undefined(p);
  return hull(ball(-1, p), value_of(named("lambertW"), at, p).re);
}

/// log x - log log x <= W(x) <= log x - log log x + e/(e - 1) log log x/log x for x >= e (A.
/// Hoorfar, M. Hassani, Inequalities on the Lambert W function and hyperpower function, J. Inequal.
/// Pure Appl. Math. 9, 2008, theorem 2.7). Below -1/e it is not defined.
leading lambert_at_infinity(const ball*, int sign) {
  if (sign < 0) return not_defined();
  return leading_term("log(x)-log(log(x))", "8/5*log(log(x))/log(x)");
}

bool above_1(const ball*, const ball& x) { return certainly_less(ball(1, few_bits), x); }

/// The sum of z^k/k^2, continued off the cut from 1 on.
void value_of_dilog(acb_ptr r, acb_srcptr, acb_srcptr z, slong p) {
  arb().acb_hypgeom_dilog(r, z, p);
}
obstacle cut_of_dilog(const call& x) {
  const bool is_off = certainly_positive(x.z.im) || certainly_negative(x.z.im) ||
                      certainly_less(x.z.re, ball(1, 2));
  return is_off ? obstacle::none : obstacle::branch_cut;
}

/// Li_2(x) + Li_2(1/x) = -pi^2/6 - log(-x)^2/2 for x < 0 (DLMF 25.12.4), with |Li_2(u)| <= -u for
/// u < 0.
leading dilog_at_infinity(const ball*, int sign) {
  return sign < 0 ? leading_term("-pi^2/6-log(-x)^2/2", "-1/x") : std::nullopt;
}

/// Over real numbers up to 1 of a function that increases up to there, and is continuous at 1.
ball between_values(const definition& f, const ball* order, const ball& x, precision p) {
  if (!x.is_bounded() || upper_rational(x) > 1) return ball::undefined(p);
  return at_ends([&](const ball& t) { return value_of(f, {order, complex_ball(t)}, p).re; }, x, p);
}
/// The same where x goes on beyond 1.
ball up_to_1(const definition& f, const ball* order, const ball& x) {
  const precision p = x.precision();
  const auto at = [&](const ball& t) { return value_of(f, {order, complex_ball(t)}, p).re; };
  detail::mpfr_cell lower(p + 64);
  x.lower(lower.get());
  return hull(at(ball(lower.get())), at(ball(1, p)));
}
/// Its slope is -log(1 - x)/x > 0.
ball dilog_over(const ball*, const ball& x, precision p) {
  return between_values(named("dilog"), nullptr, x, p);
}

ball dilog_up_to_1(const ball*, const ball& x) { return up_to_1(named("dilog"), nullptr, x); }

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
  return is_known ? leading_term("x", "2*x^2") : std::nullopt;
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
/// For s >= 4 the terms from n = 3 on are at most 3^-s and the integral of t^-s over t > 3, which
/// is 3^(1-s)/(s - 1) <= 3^-s.
leading zeta_at_infinity(const ball*, int sign) {
  return sign > 0 ? leading_term("1+2^(-s)", "2*3^(-s)") : std::nullopt;
}
/// zeta and its derivative at z; or zeta - 1/(z - 1) and its derivative, which are analytic at 1.
jet<complex_ball, 1> zeta_and_slope(const complex_ball& z, precision p, bool without_pole) {
  const arb_number at{z};
  detail::arb_jet jet;
  arb().acb_dirichlet_zeta_jet(jet.get(), at.get(), without_pole ? 1 : 0, 2, p + 32);
  polhode::jet<complex_ball, 1> result;
  result[0] = jet.value(p);
  result[1] = jet.derivative(p);
  return result;
}
jet<ball, 1> zeta_and_slope(const ball& x, bool without_pole) {
  const auto complex = zeta_and_slope(complex_ball(x), x.precision(), without_pole);
  polhode::jet<ball, 1> result;
  result[0] = complex[0].re;
  result[1] = complex[1].re;
  return result;
}

/// A bound of |zeta''| where Re s >= least, |s| <= size, |s - 1| >= distance; undefined where none
/// is known. For Re s = x > -1 (DLMF 25.2.8, integrated by parts, with |B_2({t})| <= 1/6) zeta(s)
/// is the sum of the n^-s over n <= N and R(s), where
///   |R| <= N^(1-x)/|s - 1| + N^-x/2 + |s| N^(-x-1)/12 + |s| |s + 1| N^(-x-1)/(12 (x + 1)).
/// The terms have the second derivatives log(n)^2 n^-s, and |R''| <= 2 sup |R|/rho^2 over the disc
/// of radius rho around s.
ball curvature_of_zeta(const ball& least, const ball& size, const ball& distance) {
  constexpr long most_terms = 64;
  const ball one(1, few_bits);
  const ball rho = min(one, distance) / 2;
  const ball x = least - rho;
  ball none = ball::undefined(few_bits);
  if (!certainly_less(-one, x) || !certainly_positive(rho) || !size.is_bounded()) return none;
  if (!certainly_less(size, ball(1L << 40, few_bits))) return none;
  const auto terms = static_cast<long>(ceil_of(upper_rational(size))) + 1;
  const ball n(terms, few_bits);
  ball sum(0, few_bits);
  if (terms <= most_terms) {
    for (long k = 2; k <= terms; ++k) {
      const ball logarithm = log(ball(k, few_bits));
      sum += square(logarithm) * exp(-(least * logarithm));
    }
  } else {  // n^-x <= 1 for x >= 0, and <= N^-x else
    sum = n * square(log(n)) * max(one, exp(-(least * log(n))));
  }
  const ball far = size + rho;
  const ball power = exp(-(x * log(n)));
  const ball rest = n * power / (distance - rho) + power / 2 + far * power / (12 * n) +
                    far * (far + 1) * power / (12 * n * (x + 1));
  return sum + 2 * rest / square(rho);
}

bounds bounds_of_zeta(const call& x) {
  const ball least = least_of(x.z.re);
  const ball z = upper_of(x.z.magnitude_upper());
  const ball distance = least_of(abs(x.z - 1));
  bounds result;
  const ball size = z / distance + z / least;
  if (certainly_positive(least) && size.is_bounded()) {
    const ball most = 1 / square(distance) + 1 / least + z / square(least);
    result = {size.magnitude_upper(), most.magnitude_upper()};
  }
  const ball curvature = curvature_of_zeta(least, z, distance);
  if (!curvature.is_bounded()) return result;
  const complex_ball slope = zeta_and_slope(x.z.middle(), few_bits, false)[1];
  const magnitude change =
      multiply_up(add_up(x.z.re.radius(), x.z.im.radius()), curvature.magnitude_upper());
  if (slope.is_bounded()) {
    result.slope = std::min(result.slope, add_up(slope.magnitude_upper(), change));
  }
  return result;
}
/// zeta' over a set of real numbers.
ball slope_of_zeta(const ball*, const ball& x) {
  const ball least = least_of(x);
  if (x.is_exact() || !certainly_positive(least)) return zeta_and_slope(x, false)[1];
  const ball distance = abs(x - 1).with_precision(few_bits);
  const ball curvature =
      2 / pow(distance, 3) + 2 / square(least) + 2 * upper_of(x.magnitude_upper()) / pow(least, 3);
  if (!curvature.is_bounded()) return ball::undefined(x.precision());
  return zeta_and_slope(x.middle(), false)[1].enlarged(
      multiply_up(x.radius(), curvature.magnitude_upper()));
}

jet<ball, 1> divisor_of_zeta(const jet<ball, 1>& x) { return x - 1; }
/// (x - 1) zeta(x) = 1 + (x - 1) (zeta(x) - 1/(x - 1)). For x > 0 the last factor's derivatives
/// are bounded as above, but for the terms of 1/(x - 1): z/(z - 1) is 1 + 1/(z - 1).
jet<ball, 1> numerator_of_zeta(const jet<ball, 1>& x) {
  const ball& at = x[0];
  const ball least = least_of(at);
  const bool is_wide = !at.is_exact() && certainly_positive(least);
  jet<ball, 1> rest = zeta_and_slope(is_wide ? at.middle() : at, true);
  if (is_wide) {
    const ball most = upper_of(at.magnitude_upper());
    const ball slope = 1 / least + most / square(least);
    const ball curvature = 2 / square(least) + 2 * most / pow(least, 3);
    rest[0] = rest[0].enlarged(multiply_up(at.radius(), slope.magnitude_upper()));
    rest[1] = rest[1].enlarged(multiply_up(at.radius(), curvature.magnitude_upper()));
  }
  rest[1] *= x[1];
  return (x - 1) * rest + 1;
}

ball polylog_up_to_1(const ball* order, const ball& x) {
  if (!certainly_less(ball(1, few_bits), *order)) return ball::undefined(x.precision());
  return up_to_1(named("polylog"), order, x);
}

}  // namespace

std::vector<definition> other_functions() {
  return {
      {.what = {"lambertW", "x", "w with w e^w = x, w >= -1", "x >= -1/e"},
       .value = value_of_lambert,
       .in_the_way = cut_of_lambert,
       .slope = "1/(exp(lambertW(x))*(1+lambertW(x)))",
       .is_nowhere_defined = below_lambert,
       .where_defined = lambert_from_branch,
       .simpler =
           [](known_arguments x) { return is_exactly(x[0], 0) ? formula("0") : std::nullopt; },
       .bound = [](const ball*, int sign) { return sign > 0 ? steady("log(1+x)") : std::nullopt; },
       .is_monotonic = always,
       .near_infinity = lambert_at_infinity},
      {.what = {"dilog", "x", "dilogarithm, sum of x^k/k^2", "x <= 1"},
       .value = value_of_dilog,
       .in_the_way = cut_of_dilog,
       .slope = "-log(1-x)/x",
       .may_be_defined = [](known_arguments x) { return !is_number(x[0]) || x[0]->q <= 1; },
       .is_nowhere_defined = above_1,
       .where_defined = dilog_up_to_1,
       .simpler = [](known_arguments x) -> formula {
         if (is_exactly(x[0], 0)) return "0";
         if (is_exactly(x[0], 1)) return "pi^2/6";
         if (is_exactly(x[0], -1)) return "-pi^2/12";
         return std::nullopt;
       },
       .over_reals = dilog_over,
       .near_zero = leading_of_polylog,
       .near_infinity = dilog_at_infinity},
      {.what = {"polylog", "s, x", "polylogarithm, sum of x^k/k^s", "x < 1; x = 1 where s > 1"},
       .has_order = true,
       .value = value_of_polylog,
       .in_the_way = cut_of_dilog,
       .over = bounds_of_polylog,
       .slope = "polylog(s-1,x)/x",
       .may_be_defined =
           [](known_arguments x) {
             return !is_number(x[1]) || x[1]->q < 1 ||
                    (x[1]->q == 1 && (!is_number(x[0]) || x[0]->q > 1));
           },
       .is_nowhere_defined = above_1,
       .where_defined = polylog_up_to_1,
       .simpler = [](known_arguments x) -> formula {
         if (is_exactly(x[1], 0)) return "0";
         if (is_exactly(x[1], 1) && is_number(x[0])) return "zeta(s)";
         if (is_exactly(x[0], 1)) return "-log(1-x)";
         return is_exactly(x[0], 2) ? formula("dilog(x)") : std::nullopt;
       },
       // |Li_s(x)/x| <= 1 for x < 0.
       .bound = [](const ball* order, int sign) -> majorant {
         const bool is_known = sign < 0 && certainly_positive(*order);
         return is_known ? steady("-x") : std::nullopt;
       },
       .slope_over = slope_of_polylog,
       .over_reals = polylog_over,
       .near_zero = leading_of_polylog},
      {.what = {"zeta", "s", "Riemann's zeta function", "s != 1"},
       .value = value_of_zeta,
       .in_the_way = pole_of_zeta,
       .over = bounds_of_zeta,
       .may_be_defined = [](known_arguments x) { return !is_exactly(x[0], 1); },
       .bound = [](const ball*, int sign) -> majorant {
         return sign > 0 ? steady("1+s/abs(s-1)") : std::nullopt;
       },
       .slope_over = slope_of_zeta,
       .is_monotonic = [](const ball*, const ball& x) { return certainly_less(ball(1, 2), x); },
       .near_infinity = zeta_at_infinity,
       .numerator = numerator_of_zeta,
       .divisor = divisor_of_zeta}};
}

further_function digamma_function() {
  further_function result;
  result.what = {"digamma", "x", "(log |gamma(x)|)'", "no whole number <= 0"};
  result.value = [](std::span<const ball> x) { return digamma(x[0]); };
  result.gradient = [](std::span<const ball> x) { return std::vector{trigamma(x[0])}; };
  result.slope = "polygamma(1,x)";
  result.may_be_defined = has_digamma;
  // At half-integers by the values at 1 and 1/2 and psi(x + 1) = psi(x) + 1/x (DLMF 5.4.12, 5.4.13,
  // 5.5.2).
  result.simpler = [](known_arguments x) -> formula {
    constexpr long most = 50;
    if (!is_number(x[0]) || x[0]->q <= 0 || x[0]->q > most) return std::nullopt;
    const rational q = x[0]->q;
    if (denominator(q) > 2) return std::nullopt;
    const bool is_whole = denominator(q) == 1;
    rational sum = 0;
    for (rational k = is_whole ? rational(1) : rational(1, 2); k < q; k += 1) sum += 1 / k;
    return fmt::format("{}-euler_gamma{}", sum.str(), is_whole ? "" : "-2*log(2)");
  };
  result.over_regions = [](std::span<const region> x) { return digamma(x[0]); };
  static const definition of_complex{
      .what = result.what,
      .value = [](acb_ptr r, acb_srcptr, acb_srcptr z, slong p) { arb().acb_digamma(r, z, p); },
      .in_the_way = poles_of_gamma};
  result.over_complex = [](std::span<const complex_ball> x) {
    return value_or_undefined(of_complex, {nullptr, x[0]}, x[0].precision());
  };
  // For x > 0 log Gamma is convex: psi(x) <= log Gamma(x + 1) - log Gamma(x) = log x <= psi(x + 1),
  // which is psi(x) + 1/x, and -log x <= 1/x.
  result.majorant = [](std::span<const ball>, int sign) -> majorant {
    if (sign < 0) return std::nullopt;
    return steady("log(1+x)+2/x");
  };
  // psi(x) = psi(1 + x) - 1/x, and psi increases from psi(1/2) > -2 to psi(3/2) < 1 (DLMF 5.4.13,
  // 5.5.2).
  result.near_zero = [](std::span<const ball>, int) { return leading_term("-1/x", "2"); };
  // For x > 0 psi(x) - log x + 1/(2 x) lies between -1/(12 x^2) and 0: it is -2 times the integral
  // of t/((t^2 + x^2) (e^(2 pi t) - 1)) over t > 0 (DLMF 5.9.15), and that of t/(e^(2 pi t) - 1) is
  // 1/24.
  result.near_infinity = [](std::span<const ball>, int sign) {
    return sign > 0 ? leading_term("log(x)-1/(2*x)", "1/(12*x^2)") : std::nullopt;
  };
  result.at_pole = [](std::span<const ball>, long k) {
    std::string text = fmt::format("digamma(x+{})", k + 1);
    for (long j = 0; j <= k; ++j) text += fmt::format("-1/(x+{})", j);
    return formula(text);
  };
  result.numerator = [](const jet<ball, 1>& x) { return digamma_over_gamma(x, trigamma); };
  result.divisor = reciprocal_gamma;
  return result;
}

}  // namespace polhode::arb_functions_impl

#endif
