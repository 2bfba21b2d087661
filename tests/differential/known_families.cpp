// Integrals that are known in closed form: derivatives of random formulas, elliptic and gamma
// functions.

#include <cmath>

#include "integrals.hpp"
#include "polhode/expression/library_functions.hpp"

namespace polhode::differential {
namespace {

const term x = "x";

long few_digits(maker& m) { return m.one_in(3) ? m.between(2, 10) : m.between(11, 25); }

/// A random formula that is analytic on the line, of t.
term smooth_formula(maker& m, const term& t, long depth) {
  if (depth == 0) return m.one_in(2) ? t : m.rational_near(m.within(0.3, 2)) * t;
  const term u = smooth_formula(m, t, depth - 1);
  switch (m.between(0, 4)) {
    case 0:
      return u * m.gentle(t);
    case 1:
      return u + m.coefficient() * m.gentle(smooth_formula(m, t, depth - 1));
    case 2:
      return u / (m.between(2, 4) + call("cos", t));
    default:
      return m.gentle(u);
  }
}

integral_case derivative_of_smooth(maker& m) {
  const auto [a, b] = m.range(-2, 2);
  const term f = smooth_formula(m, x, m.between(1, 3));
  integral_case c{derivative(f), a, b, few_digits(m)};
  c.antiderivative = f;
  return c;
}

/// Steep powers whose integral is elementary.
integral_case derivative_of_steep(maker& m) {
  term base = 0;
  switch (m.between(0, 4)) {
    case 0:
      base = 1 + call("exp", x);
      break;
    case 1:
      base = 1 + power(call("sin", x), 2);
      break;
    case 2:
      base = m.positive_polynomial(true);
      break;
    case 3:
      base = m.between(2, 5) + call("cos", x);
      break;
    default:
      base = 1 + call("exp", -x);
  }
  const term f = power(base, m.exponent(2000));
  const auto [a, b] = m.one_in(2) ? m.narrow_range(-2, 2) : m.range(-2, 2);
  integral_case c{derivative(f), a, b, few_digits(m)};
  c.antiderivative = f;
  return c;
}

/// F with a square root or logarithm that ends at a limit.
integral_case derivative_at_its_end(maker& m) {
  const term c = m.near(m.within(0.5, 3));
  const term w = x - c;
  const term e = m.exponent_between(0.05, 3);
  const term f = m.one_in(3) ? w * (call("log", w) - 1) * 1 : power(w, e) * m.gentle(x);
  const term length = m.near(m.scattered(1e-3, 2));
  integral_case r{derivative(f), c, c + length, few_digits(m)};
  // F(c) = 0 in both cases.
  r.value = substituted(f, "x", r.to);
  return r;
}

integral_case gamma_integral(maker& m) {
  switch (m.between(0, 3)) {
    case 0: {
      const term s = m.exponent_between(0.05, 12);
      return {power(x, s - 1) * call("exp", -x),
              0,
              "inf",
              few_digits(m),
              std::nullopt,
              call("gamma", s)};
    }
    case 1: {
      const term p = m.exponent_between(0.05, 5);
      const term q = m.exponent_between(0.05, 5);
      return {power(x, p - 1) * power(1 - x, q - 1),
              0,
              1,
              few_digits(m),
              std::nullopt,
              call("gamma", p) * call("gamma", q) / call("gamma", p + q)};
    }
    case 2: {
      const term p = m.exponent_between(0.1, 6);
      return {power(call("sin", x), 2 * p - 1),
              0,
              term("pi") / 2,
              few_digits(m),
              std::nullopt,
              power(call("gamma", p), 2) / (2 * call("gamma", 2 * p)) * power(2, 2 * p - 1)};
    }
    default: {
      const term a = m.near(m.within(-2, 2));
      const term b = m.near(m.within(-2, 2));
      return {2 / call("sqrt", "pi") * call("exp", -power(x, 2)),
              a,
              b,
              few_digits(m),
              std::nullopt,
              call("erf", b) - call("erf", a)};
    }
  }
}

integral_case elliptic_integral(maker& m) {
  const term k = m.exponent_between(-4, 0.98);
  const term root = call("sqrt", 1 - k * power(call("sin", x), 2));
  const bool complete = m.one_in(3);
  const term phi = complete ? term("pi") / 2 : m.near(m.within(0.05, 6));
  const term n = m.exponent_between(-3, 0.9);
  const auto of = [&](const char* name) { return complete ? call(name, k) : call(name, phi, k); };
  switch (m.between(0, 4)) {
    case 0:
      return {1 / root,     0,
              phi,          few_digits(m),
              std::nullopt, complete ? call("ellipticK", k) : call("ellipticF", phi, k)};
    case 1:
      return {root, 0, phi, few_digits(m), std::nullopt, of("ellipticE")};
    case 2:
      return {
          power(call("sin", x), 2) / root, 0, phi, few_digits(m), std::nullopt, of("ellipticD")};
    case 3:
      return {1 / ((1 - n * power(call("sin", x), 2)) * root),
              0,
              phi,
              few_digits(m),
              std::nullopt,
              complete ? term("ellipticPi", {n, k}) : term("ellipticPi", {n, phi, k})};
    default: {  // t = sin x
      const term b = m.quotient(m.within(0.05, 0.98));
      return {1 / call("sqrt", (1 - power(x, 2)) * (1 - k * power(x, 2))),
              0,
              b,
              few_digits(m),
              std::nullopt,
              call("jacobiArcSN", b, k)};
    }
  }
}

integral_case carlson_integral(maker& m) {
  const term a = m.positive_rational();
  const term b = m.positive_rational();
  const term c = m.one_in(4) ? term(0) : m.positive_rational();
  const term p = m.positive_rational();
  const term root = call("sqrt", (x + a) * (x + b) * (x + c));
  if (m.one_in(2)) {
    return {1 / (2 * root), 0, "inf", few_digits(m), std::nullopt, term("carlsonRF", {a, b, c})};
  }
  return {3 / (2 * (x + p) * root),       0, "inf", few_digits(m), std::nullopt,
          term("carlsonRJ", {a, b, c, p})};
}

/// dn^2, sn cn dn and their like as integrands.
integral_case jacobi_integral(maker& m) {
  const term k = m.exponent_between(0.02, 0.97);
  const term b = m.near(m.within(0.1, 2));
  const auto of = [&](const char* name, const term& u) { return call(name, u, k); };
  switch (m.between(0, 2)) {
    case 0:
      return {of("jacobiDN", x), 0, b, few_digits(m), std::nullopt, of("jacobiAM", b)};
    case 1:
      return {power(of("jacobiDN", x), 2),
              0,
              b,
              few_digits(m),
              std::nullopt,
              call("ellipticE", of("jacobiAM", b), k)};
    default:
      return {of("jacobiCN", x) * of("jacobiDN", x),
              0,
              b,
              few_digits(m),
              std::nullopt,
              of("jacobiSN", b)};
  }
}

/// Definite integrals of the books.
integral_case book_integral(maker& m) {
  const term a = m.positive_rational();
  switch (m.between(0, 5)) {
    case 0:  // Gauss
      return {call("exp", -(a * power(x, 2))), "-inf", "inf", few_digits(m), std::nullopt,
              call("sqrt", term("pi") / a)};
    case 1:
      return {power(x, 3) / call("expm1", x),
              0,
              "inf",
              few_digits(m),
              std::nullopt,
              power("pi", 4) / 15};
    case 2: {
      const long n = m.between(3, 9);
      return {1 / (1 + power(x, n)),
              0,
              "inf",
              few_digits(m),
              std::nullopt,
              term("pi") / n / call("sin", term("pi") / n)};
    }
    case 3:
      return {
          call("log", x) / (1 + power(x, 2)), 0, 1, few_digits(m), std::nullopt, -term("catalan")};
    case 4:
      return {call("exp", -(a * x)) * call("cos", x),
              0,
              "inf",
              few_digits(m),
              std::nullopt,
              a / (1 + power(a, 2))};
    default: {
      const term c = a + 1;
      return {1 / (c + call("cos", x)),
              0,
              2 * term("pi"),
              few_digits(m),
              std::nullopt,
              2 * term("pi") / call("sqrt", power(c, 2) - 1)};
    }
  }
}

/// Sums of c x^p log(q x)^n from 0, to infinity, or between. The integral of x^p L^n, L = log(q x),
/// is x^k times the sum over j of (-1)^j n!/(n-j)! L^(n-j)/k^(j+1), k = p + 1 not 0. It diverges
/// where one of the powers does, as no two are the same.
integral_case power_and_logarithm(maker& m) {
  const long kind = m.between(0, 3);  // from 0, to infinity, between, either with any powers
  const bool is_up_to_zero = kind == 0 || (kind == 3 && m.one_in(2));
  const bool is_up_to_infinity = kind == 1 || (kind == 3 && !is_up_to_zero);
  term f = 0;
  term at = 0;  // the antiderivative
  bool diverges = false;
  for (long i = m.between(1, 3); i > 0; --i) {
    // Distinct for distinct i: k is i/7 more than a quotient of halves and thirds.
    double size = m.within(0.1, 3);
    if (is_up_to_infinity || (kind == 2 && m.one_in(2))) size = -size;
    if (kind == 3 && m.one_in(2)) size = -size;
    const term k = term(std::lround(6 * size)) / 6 + term(i) / 7 + (m.one_in(4) ? term("pi") : 0);
    const double about = approximately(k);
    diverges = diverges || (is_up_to_zero && about < 0) || (is_up_to_infinity && about > 0);
    const term c = m.coefficient();
    const long n = m.between(0, 4);
    const term logarithm = call("log", m.one_in(3) ? m.positive_rational() * x : x);
    f = f + c * power(x, k - 1) * power(logarithm, n);
    term sum = 0;
    long factor = 1;
    for (long j = 0; j <= n; ++j) {
      sum = sum + factor * power(logarithm, n - j) / power(k, j + 1);
      factor *= -(n - j);
    }
    at = at + c * power(x, k) * sum;
  }
  const auto value_at = [&](const term& end) { return substituted(at, "x", end); };
  const term low = is_up_to_zero ? term(0) : m.positive_rational();
  const term high = is_up_to_infinity ? term("inf") : low + m.positive_rational();
  integral_case c{f, low, high, few_digits(m)};
  c.diverges = diverges;
  if (!diverges) {
    const term upper = is_up_to_infinity ? term(0) : value_at(high);
    c.value = is_up_to_zero ? upper : upper - value_at(low);
  }
  return c;
}

/// sin(x)^p cos(x)^q from 0 to pi/2 is B((p+1)/2, (q+1)/2)/2 (DLMF 5.12.2), and diverges where p or
/// q is at most -1; with q = -p it is a power of the tangent. 1/(1 + tan(x)^p) is 1 - the same at
/// pi/2 - x: pi/4.
integral_case power_of_sine_and_cosine(maker& m) {
  const auto exponent = [&](double low, double high) {
    const term e = m.near(m.within(low, high));
    return std::abs(approximately(e) + 1) < 0.05 ? -(1 / call("sqrt", 2)) : e;
  };
  const bool is_shifted = m.one_in(3);
  const term shift = is_shifted ? m.rational_near(m.within(-2, 2)) : term(0);
  const term t = is_shifted ? x - shift : x;
  integral_case c{0, shift, shift + term("pi") / 2, few_digits(m)};
  const long kind = m.between(0, 3);
  if (kind == 0) {
    const term p = exponent(-3, 3);
    c.integrand = 1 / (1 + power(call(m.one_in(2) ? "tan" : "cot", t), p));
    c.value = term("pi") / 4;
    return c;
  }
  const bool of_tangent = kind == 1;
  const term p = of_tangent ? exponent(-0.9, 0.9) : exponent(-1.4, 3);
  const term q = of_tangent ? -p : exponent(-1.4, 3);
  c.integrand =
      of_tangent ? power(call("tan", t), p) : power(call("sin", t), p) * power(call("cos", t), q);
  c.diverges = approximately(p) <= -1 || approximately(q) <= -1;
  if (!c.diverges) {
    c.value = call("gamma", (p + 1) / 2) * call("gamma", (q + 1) / 2) /
              (2 * call("gamma", (p + q) / 2 + 1));
  }
  return c;
}

/// The case to infinity where its value is known, else with this antiderivative.
integral_case to_infinity_or(integral_case c, const term& f) {
  if (c.value) {
    c.to = "inf";
  } else {
    c.antiderivative = f;
  }
  return c;
}

/// Error functions, Fresnel's integrals, incomplete gamma and polygamma functions, of t = k x + h:
/// their antiderivatives, and integrals to infinity.
integral_case error_integral(maker& m) {
  const long k = m.between(1, 3);
  const term s = m.between(1, 20) / term(6);
  const auto [a, b] = m.range(0.05, 8);
  integral_case c{x, a, b, few_digits(m)};
  const term t = k * x + (m.one_in(2) ? term(0) : m.between(1, 8) / term(4));
  const auto incomplete = [&](const char* name, const term& order) { return call(name, order, t); };
  const auto to_infinity = [&](const term& f) { c.value = -substituted(f, "x", c.from); };
  const term root_pi = call("sqrt", term("pi"));
  term f = 0;
  const term half = term(1) / 2;
  // A function of u less its limit at infinity, with the antiderivative that tends to 0 there.
  const auto less_limit = [&](const char* name, const term& u, const term& limit,
                              const term& rest) {
    c.integrand = k * (call(name, u) - limit);
    f = u * (call(name, u) - limit) + rest;
    to_infinity(f);
  };
  const term whole = k * x;
  const term phase = term("pi") * whole * whole / 2;
  switch (m.between(0, 20)) {
    case 19: {  // of gamma less its pole r/x at -j, which leaves r psi(j + 1)
      const long j = m.between(0, 3);
      const term r = (j % 2 == 0 ? term(1) : term(-1)) / call("factorial", j);
      const term u = x - j;
      c.integrand = call("gamma", u) * call("digamma", u) + r / power(x, 2);
      c.from = 0;
      c.to = m.between(1, 9) / term(10);
      c.value = substituted(call("gamma", u) - r / x, "x", c.to) - r * call("digamma", j + 1);
      return c;
    }
    case 20: {  // of log_gamma(j + x)/x, which is psi(j) at 0
      const long j = m.between(1, 2);
      const term quotient = call("log_gamma", j + x) / x;
      c.integrand = (call("digamma", j + x) - quotient) / x;
      c.from = 0;
      c.to = m.between(1, 19) / term(10);
      c.value = substituted(quotient, "x", c.to) - call("digamma", j);
      return c;
    }
    case 14:
      less_limit("Si", t, term("pi") / 2, call("cos", t));
      break;
    case 15:
      less_limit("Ci", t, 0, -call("sin", t));
      break;
    case 16:
      less_limit("fresnelS", whole, half, call("cos", phase) / term("pi"));
      break;
    case 17:
      less_limit("fresnelC", whole, half, -call("sin", phase) / term("pi"));
      break;
    case 18:
      c.integrand = k * (call("digamma", t) - call("log", t) + half / t);
      f = call("log_gamma", t) - t * call("log", t) + t + call("log", t) / 2;
      c.value = call("log", 2 * term("pi")) / 2 - substituted(f, "x", c.from);
      break;
    case 0:
      c.integrand = k * call("erfi", t);
      f = t * call("erfi", t) - call("exp", t * t) / root_pi;
      break;
    case 1:
      c.integrand = k * (2 * t * call("erfcx", t) - 2 / root_pi);
      f = call("erfcx", t);
      if (m.one_in(2)) to_infinity(f);
      break;
    case 2:
      c.integrand = k * (1 - 2 * t * call("dawson", t));
      f = call("dawson", t);
      break;
    case 3:
      c.integrand = k * call("fresnelS", t);
      f = t * call("fresnelS", t) + call("cos", term("pi") * t * t / 2) / term("pi");
      break;
    case 4:
      c.integrand = k * call("fresnelC", t);
      f = t * call("fresnelC", t) - call("sin", term("pi") * t * t / 2) / term("pi");
      break;
    case 5:
      c.integrand = k * call("Shi", t);
      f = t * call("Shi", t) - call("cosh", t);
      break;
    case 6:
      c.integrand = k * call("Chi", t);
      f = t * call("Chi", t) - call("sinh", t);
      break;
    case 7:
      c.integrand = k * incomplete("gammaUpper", s);
      f = t * incomplete("gammaUpper", s) - incomplete("gammaUpper", s + 1);
      if (m.one_in(2)) to_infinity(f);
      break;
    case 8:
      c.integrand = k * incomplete("gammaLower", s);
      f = t * incomplete("gammaLower", s) - incomplete("gammaLower", s + 1);
      break;
    case 9: {
      const long n = m.between(2, 4);
      c.integrand = k * incomplete("polygamma", n);
      f = incomplete("polygamma", n - 1);
      if (m.one_in(2)) to_infinity(f);
      break;
    }
    case 10:  // DLMF 8.14.4
      c.integrand = power(x, s / 2 - 1) * call("gammaUpper", s, x);
      c.from = 0;
      c.value = call("gamma", s + s / 2) / (s / 2);
      break;
    case 12: {  // without its pole at 0
      const long n = m.between(1, 3);
      const term pole = (n % 2 == 0 ? -1 : 1) * call("factorial", n) / power(k * x, n + 1);
      c.integrand = k * (call("polygamma", n, k * x) - pole);
      c.from = 0;
      c.value = call("polygamma", n - 1, k * c.to + 1) - call("polygamma", n - 1, 1);
      return c;
    }
    case 11:  // of erfc(k x)
      c.integrand = call("exp", -(k * k * x * x)) * call("erfcx", k * x);
      c.from = 0;
      c.value = 1 / (k * root_pi);
      break;
    default:
      c.integrand = call("dawson", k * x) / x;
      c.from = 0;
      c.value = power(term("pi"), term(3) / 2) / 4;
  }
  return to_infinity_or(c, f);
}

/// Special functions with antiderivatives among them, over finite and infinite ranges, of t = k x.
integral_case special_integral(maker& m) {
  const long k = m.between(1, 3);
  const term t = k == 1 ? x : k * x;
  const long n = m.between(1, 4);
  const auto of = [&](const char* name, const term& order) { return call(name, order, t); };
  const auto [a, b] = m.range(0.05, 12);
  integral_case c{x, a, b, few_digits(m)};
  const bool to_infinity = m.one_in(2);
  term f = 0;
  switch (m.between(0, 13)) {
    case 13: {  // DLMF 25.12.10
      const term s = m.between(3, 9) / term(2);
      c.integrand = call("polylog", s, -t) / x;
      f = call("polylog", s + 1, -t);
      break;
    }
    case 12: {  // -(x^(1 - nu) J_(nu - 1)(x))' is x^(1 - nu) J_nu(x), and vanishes at infinity
      const term nu = m.between(2, 12) / term(3);
      c.integrand = power(x, 1 - nu) * of("besselJ", nu);
      c.from = 0;
      c.value = power(k, nu - 2) * power(2, 1 - nu) / call("gamma", nu);
      break;
    }
    case 0:  // DLMF 10.6.6
      c.integrand = k * of("besselJ", n - 1) * power(t, n);
      f = power(t, n) * of("besselJ", n);
      break;
    case 1:
      c.integrand = k * of("besselY", n + 1) * power(t, -n);
      f = -(power(t, -n) * of("besselY", n));
      break;
    case 2:  // DLMF 10.29.4
      c.integrand = k * of("besselK", n - 1) * power(t, n);
      f = -(power(t, n) * of("besselK", n));
      if (to_infinity) c.value = -substituted(f, "x", c.from);
      break;
    case 3:
      c.integrand = k * of("besselI", n - 1) * power(t, n);
      f = power(t, n) * of("besselI", n);
      break;
    case 4:
      c.integrand = k * t * call("airyAi", t);
      f = call("airyAiPrime", t);
      if (to_infinity) c.value = -substituted(f, "x", c.from);
      break;
    case 5:
      c.integrand = k * call("airyBiPrime", -t);
      f = -call("airyBi", -t);
      break;
    case 6:  // DLMF 8.19.13
      c.integrand = k * of("expint", n);
      f = -of("expint", n + 1);
      if (to_infinity) c.value = -substituted(f, "x", c.from);
      break;
    case 7:
      c.integrand = k * call("Ei", t) + k * call("exp", t);
      f = t * call("Ei", t);
      break;
    case 8:
      c.integrand = k * call("Si", t);
      f = t * call("Si", t) + call("cos", t);
      break;
    case 9:
      c.integrand = k * call("lambertW", t);
      f = t * (call("lambertW", t) - 1 + 1 / call("lambertW", t));
      break;
    case 10:
      c.integrand = k * (call("log", 1 + t) / t);
      f = -call("dilog", -t);
      break;
    default:
      c.integrand = k * call("digamma", t);
      f = call("log_gamma", t);
  }
  return to_infinity_or(c, f);
}

/// Scaled functions, and products of exponentials with the functions of which they are left.
integral_case scaled_integral(maker& m) {
  const term k = m.rational_near(m.within(0.3, 3));
  const term t = k * x;
  const auto of = [](const char* name, const term& order, const term& at) {
    return call(name, order, at);
  };
  const auto grown = [&](const term& u) { return call("exp", u); };
  const auto [a, b] = m.range(0.05, 12);
  integral_case c{x, a, b, few_digits(m)};
  const term pi("pi");
  const term p = m.between(1, 9) / term(10);  // of a factor x^(p - 1)
  const auto by_mellin = [&](const term& f, const term& value) {
    c.integrand = f * power(x, p - 1);
    c.from = 0;
    c.to = "inf";
    c.value = value / power(k, p);
    return c;
  };
  term f = 0;
  switch (m.between(0, 10)) {
    case 0:
      c.integrand = k * of("besselIx", 0, t);
      f = t * (of("besselIx", 0, t) + of("besselIx", 1, t));
      return to_infinity_or(c, f);
    case 1:
      c.integrand = k * of("besselKx", 0, t);
      f = t * (of("besselKx", 0, t) + of("besselKx", 1, t));
      return to_infinity_or(c, f);
    case 2:
      c.integrand = k * of("expintx", 1, t);
      f = of("expintx", 1, t) + call("log", t);
      return to_infinity_or(c, f);
    case 3: {
      const term s = k + m.rational_near(m.within(0.1, 2));
      c.integrand = grown(-(s * x)) * of("besselI", 0, t);
      c.from = 0;
      c.to = "inf";
      c.value = 1 / call("sqrt", s * s - k * k);
      return c;
    }
    case 4:  // the derivative of I_0 K_0
      c.integrand = k * (of("besselI", 1, t) * of("besselK", 0, t) -
                         of("besselI", 0, t) * of("besselK", 1, t));
      c.to = "inf";
      c.value = -substituted(of("besselI", 0, t) * of("besselK", 0, t), "x", c.from);
      return c;
    case 5:  // G. N. Watson, Q. J. Math. 10, 1939: of the simple cubic lattice
      c.integrand = grown(-3 * t) * power(of("besselI", 0, t), 3);
      c.from = 0;
      c.to = "inf";
      f = call("sqrt", 6) / (96 * power(pi, 3) * k);
      for (const long j : {1, 5, 7, 11}) f = f * call("gamma", j / term(24));
      c.value = f;
      return c;
    // With the integrals of the functions over s: x^(p - 1) exp(-x s) gives gamma(p) s^-p.
    case 6:
      return by_mellin(grown(t) * of("expint", 1, t), call("gamma", p) * pi / call("sin", pi * p));
    case 7:
      return by_mellin(grown(t) * of("gammaUpper", 0, t),
                       call("gamma", p) * pi / call("sin", pi * p));
    case 8:
      return by_mellin(
          grown(t * t) * call("erfc", t),
          call("gamma", p) * power(2, -p) * call("gamma", (1 - p) / 2) / call("sqrt", pi));
    default: {  // DLMF 10.43.22 at the end of its range, and the same of I: 0 < p < 1/2
      const term q = p / 2;
      const term nu = q / m.between(2, 4);
      c.from = 0;
      c.to = "inf";
      const bool is_k = m.one_in(2);
      c.integrand = (is_k ? grown(t) * of("besselK", nu, t) : grown(-t) * of("besselI", nu, t)) *
                    power(x, q - 1);
      const term common = call("gamma", 1 / term(2) - q) * call("gamma", q + nu) /
                          (call("sqrt", pi) * power(2 * k, q));
      c.value = common * (is_k ? call("cos", nu * pi) * call("gamma", q - nu)
                               : 1 / call("gamma", 1 + nu - q));
      return c;
    }
  }
}

/// Bessel functions to infinity, where they converge by oscillation: Hankel transforms, Weber and
/// Schafheitlin's integrals (G. N. Watson, Theory of Bessel Functions, 13.3 to 13.6; DLMF
/// 10.22(v)).
integral_case bessel_to_infinity(maker& m) {
  const term k = m.rational_near(m.within(0.3, 3));
  const term z = m.rational_near(m.within(0.3, 3));
  const term q = m.rational_near(m.within(0.1, 0.9));  // of a second frequency, q k or k/q
  const long n = m.between(1, 4);
  const term square = x * x + z * z;
  const auto of = [&](const char* name, const term& order, const term& at) {
    return call(name, order, at);
  };
  integral_case c{0, 0, "inf", few_digits(m)};
  switch (m.between(0, 10)) {
    case 10: {  // the derivative of Ai(-k x)/x, with the sign minus; or of Bi
      const char* name = m.one_in(2) ? "airyAi" : "airyBi";
      const char* prime = name[4] == 'A' ? "airyAiPrime" : "airyBiPrime";
      const term t = -(k * x);
      c.integrand = k * call(prime, t) / x + call(name, t) / power(x, 2);
      c.from = z;
      c.value = call(name, -(k * z)) / z;
      break;
    }
    case 0:  // 13.51
      c.integrand = of("besselJ", 0, k * x) * x / square;
      c.value = of("besselK", 0, k * z);
      break;
    case 1:
      c.integrand = of("besselJ", 0, k * x) / call("sqrt", square);
      c.value = of("besselI", 0, k * z / 2) * of("besselK", 0, k * z / 2);
      break;
    case 2:
      c.integrand = of("besselJ", 0, k * x) * call("cos", q * k * x);
      c.value = 1 / (k * call("sqrt", 1 - q * q));
      break;
    case 3:
      c.integrand = of("besselJ", 0, k * x) * call("sin", k / q * x);
      c.value = q / (k * call("sqrt", 1 - q * q));
      break;
    case 4:  // 13.42: of order n, at two frequencies
      c.integrand = of("besselJ", n, k * x) * of("besselJ", n, q * k * x) / x;
      c.value = power(q, n) / (2 * n);
      break;
    case 5:
      c.integrand = power(of("besselJ", n, k * x), 2) / x;
      c.value = 1 / term(2 * n);
      break;
    case 6:
      c.integrand = of("besselJ", 0, k * x) * x / power(square, term(3) / 2);
      c.value = call("exp", -(k * z)) / z;
      break;
    case 7:
      c.integrand = of("besselY", 0, k * x) / square;
      c.value = -(of("besselK", 0, k * z) / z);
      break;
    case 8:  // towards 0: 13.51 in 1/x
      c.integrand = of("besselJ", 0, k / x) / (x * (1 + z * z * x * x));
      c.value = of("besselK", 0, k * z);
      break;
    default: {  // 13.6: any order
      const term nu = term(m.between(0, 12)) / 6;
      c.integrand = of("besselJ", nu, k * x) * power(x, nu + 1) / power(square, 2);
      c.value = k * power(z, nu - 1) * of("besselK", nu - 1, k * z) / 2;
    }
  }
  return c;
}

}  // namespace

std::vector<integral_family> known_families() {
  std::vector<integral_family> all{
      {"derivative of a formula", 10, mostly_cheap(derivative_of_smooth)},
      {"derivative of a steep power", 12, mostly_cheap(derivative_of_steep)},
      {"derivative at its end", 7, mostly_cheap(derivative_at_its_end)},
      {"gamma and beta", 7, mostly_cheap(gamma_integral)},
      {"elliptic integrals", 7, mostly_cheap(elliptic_integral)},
      {"Carlson's integrals", 5, mostly_cheap(carlson_integral)},
      {"Jacobi's functions", 4, mostly_cheap(jacobi_integral)},
      {"powers and logarithms", 10, mostly_cheap(power_and_logarithm)},
      {"powers of sine and cosine", 6, mostly_cheap(power_of_sine_and_cosine)},
      {"integrals of the books", 7, mostly_cheap(book_integral)}};
  if (!arb_functions()->empty()) {
    all.push_back({"Arb's functions", 8, mostly_cheap(special_integral)});
    all.push_back({"error and incomplete gamma functions", 6, mostly_cheap(error_integral)});
    all.push_back({"Bessel functions to infinity", 6, bessel_to_infinity});
    all.push_back({"scaled functions", 6, scaled_integral});
  }
  return all;
}

}  // namespace polhode::differential
