// What happens at the ends of a range: singular ends of every exponent, infinite tails, divergent
// integrals, extreme sizes.

#include "integrals.hpp"

namespace polhode::differential {
namespace {

const term x = "x";

long few_digits(maker& m) { return m.one_in(3) ? m.between(2, 10) : m.between(11, 25); }

/// Analytic and not 0 at every x >= 0, of moderate size there.
term regular(maker& m) {
  switch (m.between(0, 5)) {
    case 0:
      return call("exp", -(m.positive_rational() * x));
    case 1:
      return 1 / (1 + m.positive_rational() * x);
    case 2:
      return 2 + call("cos", m.positive_rational() * x);
    case 3:
      return call("sqrt", 1 + m.positive_rational() * power(x, 2));
    case 4:
      return call("exp", call("sin", x));
    default:
      return m.positive_coefficient();
  }
}

/// An exponent at which x^e is integrable at 0, at times only just.
term integrable_exponent(maker& m) {
  if (m.one_in(6)) return -(1 - m.decimal(m.scattered(1e-6, 0.1)));
  return m.exponent_between(-0.97, 3);
}
/// One at which it is not.
term divergent_exponent(maker& m) {
  if (m.one_in(3)) return -1;
  if (m.one_in(4)) return -(1 + m.decimal(m.scattered(1e-20, 0.1)));
  return m.exponent_between(-4, -1);
}

term logarithm_power(maker& m, const term& t) { return power(call("log", t), m.between(1, 3)); }

integral_case singular_lower_end(maker& m) {
  term f = power(x, integrable_exponent(m)) * regular(m);
  if (m.one_in(3)) f = f * logarithm_power(m, x);
  return {f, 0, m.near(m.scattered(0.1, 3)), few_digits(m)};
}

integral_case singular_both_ends(maker& m) {
  const term a = m.one_in(2) ? term(0) : m.near(m.within(-2, 1));
  const term b = m.near(m.within(1.5, 4));
  term f = power(x - a, integrable_exponent(m)) * power(b - x, integrable_exponent(m));
  if (m.one_in(2)) f = f * call("exp", -x);
  if (m.one_in(5)) f = f * call("log", b - x);
  return {f, a, b, few_digits(m)};
}

/// sqrt, log, asin, acosh, ... at the ends of their domains.
integral_case domain_end(maker& m) {
  const term c = m.near(m.within(0.5, 3));
  const term w = (x - c);
  const auto c_and = [&](const term& more) { return c + more; };
  const term length = m.quotient(m.within(0.2, 2));
  switch (m.between(0, 6)) {
    case 0:
      return {call("sqrt", w) * regular(m), c, c_and(length), few_digits(m)};
    case 1:
      return {call("log", w) * call("cos", x), c, c_and(length), few_digits(m)};
    case 2:
      return {call("acosh", x / c), c, c_and(length), few_digits(m)};
    case 3:
      return {call("asin", x / c) * regular(m), -c, c, few_digits(m)};
    case 4:
      return {1 / call("sqrt", 1 - power(x / c, 2)), m.one_in(2) ? term(0) : -c, c, few_digits(m)};
    case 5:
      return {call("atanh", x / c), 0, c, few_digits(m)};
    default:
      return {call("cbrt", w) / (1 + power(x, 2)), c - length, c_and(length), few_digits(m)};
  }
}

/// Divergent at an end, however small the coefficient.
integral_case divergent_end(maker& m) {
  const term c = m.one_in(3) ? term(0) : m.near(m.within(0.5, 3));
  const term size = m.one_in(2) ? m.decimal(m.scattered(1e-60, 1)) : term(1);
  const bool at_lower = m.one_in(2);
  const term w = at_lower ? x - c : c - x;
  term f = size * power(w, divergent_exponent(m));
  if (m.one_in(3)) f = f * (2 + call("cos", x));
  if (m.one_in(2)) f = f + 1 / (1 + call("exp", x));
  const term length = m.near(m.scattered(1e-3, 2));
  integral_case r{f, at_lower ? c : c - length, at_lower ? c + length : c, few_digits(m)};
  r.diverges = true;
  return r;
}

/// A polynomial and its one positive root, a simple and mostly irrational one.
std::pair<term, term> polynomial_with_root(maker& m) {
  const long n = m.between(2, 40);
  term base = 0;
  term root = 0;
  switch (m.between(0, 3)) {
    case 0:
      base = power(x, 2) - n;
      root = call("sqrt", n);
      break;
    case 1:
      base = power(x, 3) - n;
      root = call("cbrt", n);
      break;
    case 2:
      base = power(x, 5) - n;
      root = call("root", n, 5);
      break;
    default: {
      const long p = m.between(1, 9);
      base = power(x, 2) - p * x - n;
      root = (p + call("sqrt", p * p + 4 * n)) / 2;
    }
  }
  return m.one_in(2) ? std::pair(base, root) : std::pair(-base, root);
}

/// An absolute value that vanishes, or has poles, at irrational points: some of them are ends.
integral_case irrational_breaks(maker& m) {
  term base = 0;
  term from = 0;
  term to = 0;
  if (m.one_in(3)) {
    const auto [polynomial, root] = polynomial_with_root(m);
    const term second = m.one_in(2) ? root / 2 : root + m.near(m.scattered(1e-3, 1));
    base = polynomial * (x - second);
    from = m.one_in(2) ? root : term(0);
    to = root + m.positive_rational();
    if (m.one_in(2)) {
      from = second - 1;
      to = m.one_in(2) ? second : root;
    }
    if (approximately(to) <= approximately(from)) std::swap(from, to);
  } else {
    const long k = m.between(1, 3);
    base =
        call(m.any_of({"sin", "cos", "tan"}), k * x + m.any_of({term(0), term(1), term("pi") / 3}));
    const long first = m.between(-2, 2);
    from = first * term("pi") / (2 * k);
    to = (first + m.between(1, 5)) * term("pi") / (2 * k);
    if (m.one_in(3)) from = from - m.decimal(m.scattered(1e-3, 1));
  }
  const term size = call("abs", base);
  const term f = m.any_of({call("log", size), call("sqrt", size), power(size, -term(1) / 3),
                           size / (1 + size), call("log", size) * call("cos", x)});
  return {m.one_in(2) ? f : f * call("exp", -x / 3), from, to, few_digits(m)};
}

/// Divergent at the irrational root of a polynomial, at an end or between the limits.
integral_case divergent_root(maker& m) {
  const auto [base, root] = polynomial_with_root(m);
  const term e = m.any_of({1L, 1L, 2L, 3L});
  term f = 1 / power(base, e);
  if (m.one_in(2)) f = call("exp", -(m.positive_rational() * power(x, 2))) * f;
  if (m.one_in(2)) f = m.decimal(m.scattered(1e-60, 1)) * f;
  if (m.one_in(2)) f = f + 1 / (1 + call("exp", x));
  integral_case r{f, m.one_in(2) ? term(0) : m.rational_near(m.within(0.1, 1)), root,
                  few_digits(m)};
  switch (m.between(0, 3)) {
    case 0:
      r.from = root;
      r.to = root + m.positive_rational();
      break;
    case 1:
      r.to = root + m.decimal(m.scattered(1e-20, 1));
      break;
    default:
      break;
  }
  r.diverges = true;
  return r;
}

/// A pole of other functions between the limits, or at an end.
integral_case divergent_pole(maker& m) {
  const term c = m.near(m.within(0.5, 3));
  const term low = c - m.decimal(m.scattered(1e-10, 0.4));
  const term high = m.one_in(2) ? c : c + m.decimal(m.scattered(1e-10, 0.4));
  const term w = x - c;
  term f = 0;
  switch (m.between(0, 5)) {
    case 0:
      f = 1 / call("sin", w);
      break;
    case 1:
      f = 1 / call("expm1", w);
      break;
    case 2:
      f = (2 + call("cos", x)) / w + call("exp", x);
      break;
    case 3:
      f = 1 / (call("log", x) - call("log", c));
      break;
    case 4:
      f = 1 / (call("cosh", w) - 1);
      break;
    default:
      f = call("tan", w + term("pi") / 2);
  }
  integral_case r{f, low, high, few_digits(m)};
  r.diverges = true;
  return r;
}

integral_case divergent_tail(maker& m) {
  const term a = m.near(m.within(1.5, 4));
  term f = 0;
  switch (m.between(0, 6)) {
    case 0:
      f = power(x, m.exponent_between(-1, 2));
      break;
    case 1:
      f = 1 / x + call("exp", -x);
      break;
    case 2:
      f = 1 / (x * call("log", x));
      break;
    case 3:
      f = x / (1 + power(x, 2));
      break;
    case 4:
      f = call("atan", x) / x;
      break;
    case 5:
      f = 1 / (x + call("exp", -x)) + m.decimal(m.scattered(1e-30, 1)) / call("sqrt", x);
      break;
    default:
      f = call("tanh", x) / power(x, m.quotient(m.within(0.2, 1)));
  }
  integral_case r{f, a, "inf", few_digits(m)};
  r.diverges = true;
  return r;
}

/// What grows, or oscillates without decay, beside what grows faster or decays slower: the integral
/// is known, or it diverges, in one case of two.
integral_case growing_tail(maker& m) {
  const bool diverges = m.one_in(2);
  const term k = m.positive_rational();
  const term d = m.decimal(m.scattered(1e-6, 2));
  const term a = m.near(m.within(0.5, 4));
  const auto decay = [&](const term& e) { return call("exp", -(e * a)) / e; };
  integral_case r{0, a, "inf", few_digits(m)};
  r.diverges = diverges;
  const term faster = diverges ? (m.one_in(3) ? k : k - d) : k + d;
  switch (m.between(0, 5)) {
    case 0:
      r.integrand = call("exp", k * x) * call("exp", -(faster * x));
      r.value = decay(d);
      break;
    case 1:
      r.integrand = call("cosh", k * x) * call("exp", -(faster * x));
      r.value = (decay(d) + decay(2 * k + d)) / 2;
      break;
    case 2:
      r.integrand = call("exp", x) / power(1 + call("exp", x), diverges ? 1 : 2);
      r.value = 1 / (1 + call("exp", a));
      break;
    case 3:  // Dirichlet's integral
      r.from = 0;
      r.integrand = call("sin", k * x) / (diverges ? 1 + call("exp", -x) : x);
      r.value = term("pi") / 2;
      break;
    case 4:  // Laplace's
      r.from = 0;
      r.integrand = x * call("sin", k * x) * (diverges ? x : term(1)) / (power(d, 2) + power(x, 2));
      r.value = term("pi") / 2 * call("exp", -(k * d));
      break;
    default: {
      const term slow = m.any_of({call("log", 1 + x), power(x, "1/3"), 2 + call("sin", x)});
      r.integrand = diverges ? slow * call("exp", k / x) : slow + x * call("exp", -(k * x)) - slow;
      r.value = (a / k + 1 / power(k, 2)) * call("exp", -(k * a));
    }
  }
  if (diverges) r.value = std::nullopt;
  return r;
}

/// abs, min and max in the tail of exponentials and powers, which pass at a known point: an
/// option's value, and others. A divergent twin in one case of four.
integral_case kinks_in_tails(maker& m) {
  const term k = m.positive_rational();
  const term c = m.near(m.within(0.3, 3));
  const term d = m.decimal(m.scattered(1e-3, 2));
  const auto e = [](const term& power_of_e) { return call("exp", power_of_e); };
  integral_case r{0, 0, "inf", few_digits(m)};
  switch (m.between(0, 2)) {
    case 0: {
      r.diverges = m.one_in(4);
      const term q = r.diverges ? (m.one_in(2) ? k : k - d) : k + d;
      const term rise = e(k * x) - e(k * c);
      const term payoff = m.one_in(2) ? call("max", rise, term(0)) : -call("min", -rise, term(0));
      r.integrand = payoff * e(-(q * x));
      if (!r.diverges) r.value = e(-(d * c)) / d - e(-(d * c)) / q;
      break;
    }
    case 1: {
      const term q = k + d;
      r.integrand = call("abs", e(-(k * x)) - e(-(k * c))) * e(-(q * x));
      r.value = (1 - 2 * e(-((k + q) * c))) / (k + q) - e(-(k * c)) * (1 - 2 * e(-(q * c))) / q;
      break;
    }
    default: {
      const bool greatest = m.one_in(2);
      const term f = e(-(k * x));
      const term g = e(-(k * c)) * power((1 + c) / (1 + x), m.between(2, 4));
      const long digits = few_digits(m);
      r.integrand = call(greatest ? "max" : "min", f, g);
      r.parts = {{f / 2, 0, "inf", digits},
                 {g / 2, 0, "inf", digits},
                 {call("abs", f - g) / (greatest ? 2 : -2), 0, "inf", digits}};
    }
  }
  return r;
}

integral_case algebraic_tail(maker& m) {
  const term e = m.exponent_between(1.05, 6);
  term f = m.one_in(2) ? power(x, -e) : power(m.positive_rational() + x, -e);
  if (m.one_in(3)) f = f * call("sqrt", x / (1 + x));
  if (m.one_in(4)) f = f * call("log", x);
  if (m.one_in(4)) f = f * call("exp", 1 / x);
  return {f, m.near(m.within(0.5, 4)), "inf", few_digits(m)};
}

integral_case exponential_tail(maker& m) {
  const term k = m.one_in(3) ? m.near(m.scattered(0.2, 5)) : m.positive_rational();
  term f = call("exp", -(k * (m.one_in(2) ? x : power(x, 2))));
  if (m.one_in(2)) f = f * power(x, m.one_in(2) ? m.between(1, 5) : m.exponent_between(-0.9, 3));
  if (m.one_in(3)) f = f * call(m.one_in(2) ? "cos" : "sin", m.positive_rational() * x);
  if (m.one_in(5)) f = f / (1 + x);
  const bool both = !f.has("^") && m.one_in(2);
  return {f, both && !f.has("/") ? term(0) : (m.one_in(2) ? term(0) : m.near(m.within(0.1, 3))),
          "inf", few_digits(m)};
}

/// Of functions that are exponentially small, or near to a number, by their own bounds.
integral_case special_tail(maker& m) {
  const term k = m.positive_rational();
  term f = 0;
  switch (m.between(0, 5)) {
    case 0:
      f = power(call("erfc", k * x), m.between(1, 3));
      break;
    case 1:
      f = call("erf", m.one_in(2) ? k * x : k * x - m.positive_rational()) * call("exp", -x);
      break;
    case 2:
      f = call("log", 1 + (m.one_in(2) ? term(1) : term(-1)) / 3 * call("exp", -(k * x)));
      break;
    case 3:
      f = call("exp", -(k * call(m.one_in(2) ? "cosh" : "exp", x)));
      break;
    case 4:
      f = call("exp", -(x * (2 + call(m.one_in(2) ? "sin" : "tanh", k * x))));
      break;
    default:
      f = call("exp", x - call("exp", x));
  }
  if (m.one_in(3)) f = f * power(x, m.between(1, 3));
  return {f, m.one_in(2) ? term(0) : m.near(m.within(0.1, 3)), "inf", few_digits(m)};
}

integral_case whole_line(maker& m) {
  const term k = m.positive_rational();
  const term c = m.one_in(2) ? term(0) : m.near(m.within(-2, 2));
  const term w = x - c;
  switch (m.between(0, 3)) {
    case 0:
      return {call("exp", -(k * power(w, 2))) * m.polynomial(m.between(0, 3)), "-inf", "inf",
              few_digits(m)};
    case 1:
      return {1 / power(m.positive_rational() + power(w, 2), m.between(1, 4)), "-inf", "inf",
              few_digits(m)};
    case 2:
      return {1 / call("cosh", k * w), "-inf", "inf", few_digits(m)};
    default:
      return {call("cos", x) * call("exp", -(k * power(w, 2))), "-inf", "inf", few_digits(m)};
  }
}

/// Limits, and what the integrand changes over, of 1e-300 to 1e300.
integral_case extreme_sizes(maker& m) {
  const double exponent = m.within(-300, 300);
  const term scale = term("1e" + std::to_string(static_cast<long>(exponent)));
  const term w = x / scale;
  term f = 0;
  switch (m.between(0, 4)) {
    case 0:
      f = call("exp", -w);
      break;
    case 1:
      f = 1 / (1 + power(w, 2));
      break;
    case 2:
      f = power(x, m.exponent_between(-0.9, 2));
      break;
    case 3:
      f = call("sqrt", w) * call("cos", w);
      break;
    default:
      f = power(1 + w, m.exponent(30));
  }
  const term a = m.one_in(2) ? term(0) : scale * m.near(m.within(0.1, 1));
  return {f, a, scale * m.near(m.within(1.1, 4)), few_digits(m)};
}

/// An increasing function, analytic with a slope above 0 for 0 < x < 3, and a number there, as it
/// may be written.
struct turning_point {
  term g;
  term g_at_c;  // g at c, written in the same way or another
  term c;
};
turning_point turning_point_of(maker& m) {
  const term c = m.one_in(3) ? m.irrational() : m.near(m.within(0.3, 2.5));
  const term k = m.quotient(m.within(0.3, 1));
  term g = 0;
  switch (m.between(0, 7)) {
    case 0:
      g = -call("cos", k * x);
      break;
    case 1:
      g = call("exp", k * x);
      break;
    case 2:
      g = power(x, m.between(2, 5));
      break;
    case 3:
      g = call("log", 1 + k * x);
      break;
    case 4:
      g = call("sqrt", 1 + x);
      break;
    case 5:
      g = call("sinh", k * x);
      break;
    case 6:
      g = call("atan", k * x);
      break;
    default:
      g = k * x;
  }
  return {g, substituted(g, "x", c), c};
}

/// What stands under a root or a logarithm vanishes at an end that is no rational number as a rule;
/// a divergent twin in one case of four. Where g' is a factor the integral is known.
integral_case turning_end(maker& m) {
  const auto [g, g_at_c, c] = turning_point_of(m);
  const double end = approximately(c);
  if (!(end > 0.01 && end < 3)) return turning_end(m);
  const term w = m.one_in(4) ? -(g - g_at_c) : g_at_c - g;
  term from = m.one_in(2) ? term(0) : m.rational_near(m.within(0.05, 0.9) * end);
  if (approximately(from) > 0.97 * end) from = 0;
  const bool diverges = m.one_in(4);
  const term e = diverges ? divergent_exponent(m) : integrable_exponent(m);
  integral_case r{power(w, e), from, c, few_digits(m)};
  const bool has_logarithm = !diverges && m.one_in(5);
  if (has_logarithm) r.integrand = logarithm_power(m, w) * power(w, m.between(0, 2));
  if (diverges || has_logarithm || m.one_in(2)) {
    r.integrand = r.integrand * (m.one_in(2) ? regular(m) : term(1));
  } else {
    r.integrand = derivative(g) * r.integrand;
    r.value = power(g_at_c - substituted(g, "x", from), e + 1) / (e + 1);
  }
  r.diverges = diverges;
  return r;
}

/// An inverse function of u at the end of its domain, where u = 1 at an end that is no rational
/// number as a rule, times u': known, by the antiderivative. A divergent twin in one case of five.
integral_case inverse_at_its_end(maker& m) {
  const auto [g, g_at_c, c] = turning_point_of(m);
  const double end = approximately(c);
  if (!(end > 0.01 && end < 3)) return inverse_at_its_end(m);
  const term u = g / g_at_c;
  term from = m.one_in(2) ? term(0) : m.rational_near(m.within(0.05, 0.9) * end);
  if (approximately(from) > 0.97 * end) from = 0;
  const term start = substituted(u, "x", from);
  const double first = approximately(start);
  if (!(first > -0.99 && first != 1)) return inverse_at_its_end(m);
  integral_case r{derivative(g) / g_at_c, from, c, few_digits(m)};
  const auto root = [](const term& w) { return call("sqrt", w); };
  if (m.one_in(5)) {
    r.diverges = true;
    r.integrand = r.integrand / power(first < 1 ? call("acos", u) : call("acosh", u), 2);
  } else if (first > 1) {
    r.integrand = r.integrand * call("acosh", u);
    r.value = root(power(start, 2) - 1) - start * call("acosh", start);
  } else if (m.one_in(3)) {
    r.integrand = r.integrand * call("asin", u);
    r.value = term("pi") / 2 - start * call("asin", start) - root(1 - power(start, 2));
  } else if (m.one_in(2)) {
    r.integrand = r.integrand * call("acos", u);
    r.value = root(1 - power(start, 2)) - start * call("acos", start);
  } else {
    r.integrand = r.integrand * call("atanh", u);
    r.value =
        call("log", term(2)) - start * call("atanh", start) - call("log", 1 - power(start, 2)) / 2;
  }
  return r;
}

/// 0/0 by constants that cancel, at an end or between the limits; a divergent twin in one case of
/// four.
integral_case removable(maker& m) {
  const auto [g, g_at_c, c] = turning_point_of(m);
  const double at = approximately(c);
  if (!(at > 0.01 && at < 3)) return removable(m);
  const bool diverges = m.one_in(4);
  const term f = (g - g_at_c) / power(x - c, diverges ? 2 : 1);
  const bool is_end = m.one_in(2);
  integral_case r{f * (m.one_in(2) ? regular(m) : term(1)), m.rational_near(m.within(0, 0.9) * at),
                  is_end ? c : c + m.positive_rational(), few_digits(m)};
  if (approximately(r.from) > 0.97 * at) r.from = 0;
  if (!is_end && m.one_in(3)) {
    const term to = m.rational_near(at + m.within(0.1, 1));
    if (approximately(to) > 1.03 * at) r.to = to;
  }
  r.diverges = diverges;
  return r;
}

/// Multiples of pi that cancel: in the poles of circular functions at an end, with the logarithm
/// of the sine as an antiderivative, and between arcs at infinity (Frullani). A divergent twin in
/// one case of four.
integral_case multiples_of_pi_cancel(maker& m) {
  const bool diverges = m.one_in(4);
  const term c = m.coefficient();
  const term other = diverges ? c * m.any_of({term(2), term(1) / 2, -term(1), term("1.001")}) : c;
  const term shift = m.one_in(3) ? m.rational_near(m.within(-2, 2)) : term(0);
  const term t = m.one_in(3) ? x - shift : x;
  const term end = t.text() == "x" ? term(0) : shift;  // where t is 0
  const term a = m.rational_near(m.within(0.1, 1.4));
  integral_case r{0, end + a, end + term("pi"), few_digits(m)};
  r.diverges = diverges;
  switch (m.between(0, 4)) {
    case 0:
      r.integrand = c / call("sin", t) - other / (end + term("pi") - x);
      r.value = c * (call("log", 2) - call("log", call("tan", a / 2) * (term("pi") - a)));
      break;
    case 1:
      r.integrand = c * call("tan", t) - other / (end + term("pi") / 2 - x);
      r.to = end + term("pi") / 2;
      r.value = c * call("log", call("cos", a) / (term("pi") / 2 - a));
      break;
    case 2:
      r.integrand = c / power(call("sin", t), 2) - other / power(end + term("pi") - x, 2);
      r.value = c * (call("cot", a) + 1 / (term("pi") - a));
      break;
    case 3: {
      const term p = m.positive_rational();
      const term q = m.positive_rational();
      r.integrand = (c * call("atan", p * x) - other * call("atan", q * x)) / x;
      r.from = 0;
      r.to = "inf";
      r.value = c * term("pi") / 2 * call("log", p / q);
      break;
    }
    default: {  // atan(1/(p x)), as it may be written
      const term p = m.positive_rational();
      const term e = diverges ? m.quotient(m.within(0.4, 1)) : m.quotient(m.within(1.05, 3));
      r.integrand = c * power(term("pi") / 2 - call("atan", p * x), e);
      r.from = a;
      r.to = "inf";
      break;
    }
  }
  if (diverges) r.value = std::nullopt;
  return r;
}

/// What tends to 0 at infinity faster than all powers because limits cancel: of 1 - tanh(k x), say.
/// The same function is written without the cancellation, too. A divergent twin in one case of
/// four, by a constant that may be tiny.
integral_case limits_cancel(maker& m) {
  const bool diverges = m.one_in(4);
  const term c = m.coefficient();
  const term k = m.rational_near(m.within(0.3, 3));
  const term a = m.rational_near(m.within(0.2, 3));
  const term w = m.rational_near(m.within(0.1, 1)) * call("exp", -k * x);
  const term d = m.rational_near(m.within(0.1, 2));
  term written = 0;
  term same = 0;
  switch (m.between(0, 12)) {
    case 0:
      written = 1 - call("tanh", k * x);
      same = 2 / (call("exp", 2 * k * x) + 1);
      break;
    case 1:
      written = 1 / call("tanh", k * x) - 1;
      same = 2 / call("expm1", 2 * k * x);
      break;
    case 2: {
      const term half = m.any_of({term(1), d});
      written = call("log", 2 * half * call("cosh", k * x)) - k * x - call("log", half);
      same = call("log1p", call("exp", -2 * k * x));
      break;
    }
    case 3:
      written = k * x - call("log", call("exp", k * x) - 1);
      same = -call("log1p", -call("exp", -k * x));
      break;
    case 4:
      written = call("sqrt", 1 + w) - 1;
      same = w / (1 + call("sqrt", 1 + w));
      break;
    case 5:
      written = term("pi") / 2 - call("atan", call("exp", k * x));
      same = call("atan", call("exp", -k * x));
      break;
    case 6:
      written = call("asinh", call("exp", k * x)) - k * x - call("log", 2);
      same = call("log", (1 + call("sqrt", 1 + call("exp", -2 * k * x))) / 2);
      break;
    case 7:
      written = call("tanh", k * x + d) - call("tanh", k * x);
      same = call("sinh", d) / (call("cosh", k * x + d) * call("cosh", k * x));
      break;
    case 8:
      written = call("erf", k * x + d) - call("erf", k * x);
      same = call("erfc", k * x) - call("erfc", k * x + d);
      break;
    case 9:
      written = power(1 + w, d) - 1;
      same = call("expm1", d * call("log1p", w));
      break;
    case 10:
      written = call("exp", w) - 1;
      same = call("expm1", w);
      break;
    case 11:
      written = call("sin", d + w) - call("sin", d);
      same = 2 * call("cos", d + w / 2) * call("sin", w / 2);
      break;
    default:
      written = 1 / (1 - w / 2) - 1;
      same = w / (2 - w);
      break;
  }
  const term weight = c * (m.one_in(2) ? term(1) : power(x, m.between(1, 3)));
  integral_case r{written * weight, a, "inf", few_digits(m)};
  if (diverges) {
    const term more = m.any_of({term("0.001"), term("1e-15"), term("-1e-25"), term("1e-60")});
    r.integrand = (written + more) * weight;
    r.diverges = true;
  } else {
    r.parts.push_back({same * weight, a, "inf", r.digits});
  }
  return r;
}

/// What falls doubly exponentially, beside what grows exponentially: K_n(p) among them.
integral_case falls_doubly(maker& m) {
  const term p = m.rational_near(m.within(0.2, 5));
  const long n = m.between(1, 6);
  const char* grows = m.any_of({"cosh", "sinh"});
  const bool is_sinh = m.one_in(2);
  const term fall = p * call(is_sinh ? "sinh" : "cosh", x);
  const term a = m.one_in(2) ? term(0) : m.rational_near(m.within(0.1, 1));
  integral_case r{call("exp", -fall) * call(grows, n * x), a, "inf", few_digits(m)};
  const term half = term(1) / 2;
  r.parts.push_back(
      {call("exp", n * x - fall), a, "inf", r.digits, quadrature_rule::automatic, half});
  r.parts.push_back({call("exp", -n * x - fall), a, "inf", r.digits, quadrature_rule::automatic,
                     std::string(grows) == "cosh" ? half : -half});
  return r;
}

/// What grows at an end and does not, because constants that are neither rational nor multiples of
/// pi cancel: at logarithms, roots and exponentials, and at infinity. A divergent twin in one case
/// of four.
integral_case constants_cancel(maker& m) {
  const bool diverges = m.one_in(4);
  const term c = m.coefficient();
  const term other = diverges ? c * m.any_of({term(2), term(1) / 2, -term(1), term("1.001")}) : c;
  const term n = m.one_in(2) ? term(m.between(2, 9)) : m.rational_near(m.within(1.1, 9));
  const term d = m.rational_near(m.within(0.1, 2));
  integral_case r{0, 0, 0, few_digits(m)};
  r.diverges = diverges;
  switch (m.between(0, 5)) {
    case 0: {  // with t = x - log(n)/k: (1/(e^(k t) - 1) - 1/(k t))/n
      const term k = m.rational_near(m.within(0.3, 3));
      const term end = call("log", n) / k;
      r.integrand = c / (call("exp", k * x) - n) - other / (n * (k * x - call("log", n)));
      r.from = end;
      r.to = end + d;
      r.value = c / (n * k) * call("log", (1 - call("exp", -k * d)) / (k * d));
      break;
    }
    case 1: {  // -1/(2 s (x + s)), s = sqrt(n)
      const term s = call("sqrt", n);
      r.integrand = c / (power(x, 2) - n) - other / (2 * s * (x - s));
      r.from = s;
      r.to = s + d;
      r.value = -c / (2 * s) * call("log", 1 + d / (2 * s));
      break;
    }
    case 2: {  // F tends to 0 for x -> inf
      const bool is_acosh = m.one_in(2);
      const term a = m.rational_near(m.within(1.1, 3));
      const char* name = is_acosh ? "acosh" : "asinh";
      const term root = call("sqrt", is_acosh ? power(n * a, 2) - 1 : power(n * a, 2) + 1);
      r.integrand = c * call(name, n * x) - c * call("log", x) - other * call("log", 2 * n);
      r.from = a;
      r.to = "inf";
      r.value = c * (root / n - a * (call(name, n * a) - call("log", a) + 1 - call("log", 2 * n)));
      break;
    }
    case 3: {
      const term s = call("sqrt", n);
      r.integrand = (c * call("sqrt", n + x) - c * s - other * x / (2 * s)) / power(x, 2);
      r.to = d;
      break;
    }
    case 4: {
      const term w = m.any_of({term("sqrt(2)"), term("1/sqrt(3)"), term("log(5)"), term("e/4")});
      r.integrand = (c * power(x, w) - c - other * w * (x - 1)) / power(x - 1, 2);
      r.from = 1;
      r.to = 1 + d;
      break;
    }
    default: {
      const term q = m.rational_near(m.within(-1, 1));
      const term end = call("exp", q);
      r.integrand = c / (call("log", x) - q) - other * end / (x - end);
      r.from = end;
      r.to = end + d;
      break;
    }
  }
  if (diverges) r.value = std::nullopt;
  return r;
}

/// Irrational powers of differences of 1 and what is 1 at the end, times the slope of the
/// difference. A divergent twin in one case of five.
integral_case powers_of_differences(maker& m) {
  const bool diverges = m.one_in(5);
  const term c = m.coefficient();
  const term k = m.rational_near(m.within(0.3, 2));
  const term a = m.rational_near(m.within(0.2, 1.2));
  const term e = diverges ? m.any_of({term("-sqrt(2)"), term("-pi/3"), term("-1-1e-9")})
                          : m.any_of({term("-1/sqrt(2)"), term("-1/pi"), term("sqrt(2)"),
                                      term("log(2)"), term("-e/3"), term("-sqrt(3)/2")});
  const term y = k * x;
  integral_case r{0, 0, a, few_digits(m)};
  r.diverges = diverges;
  term base = 0;
  term factor = 1 / k;
  term slope = 0;
  switch (m.between(0, 5)) {
    case 0:
      base = 1 - call("cos", y);
      slope = call("sin", y);
      break;
    case 1:
      base = m.one_in(2) ? call("expm1", y) : call("exp", y) - 1;
      slope = call("exp", y);
      break;
    case 2:
      base = m.one_in(2) ? call("log1p", y) : call("log", 1 + y);
      slope = 1 / (1 + y);
      break;
    case 3:
      base = call("sqrt", 1 + y) - 1;
      slope = 1 / call("sqrt", 1 + y);
      factor = 2 / k;
      break;
    case 4:
      base = call("cosh", y) - 1;
      slope = call("sinh", y);
      break;
    default:
      base = 1 + call("cos", x);
      slope = call("sin", x);
      r.from = term("pi") - a;
      r.to = term("pi");
      r.integrand = c * power(base, e) * slope;
      if (!diverges) r.value = c * power(1 - call("cos", a), e + 1) / (e + 1);
      return r;
  }
  r.integrand = c * power(base, e) * slope;
  if (!diverges) r.value = c * factor * power(substituted(base, "x", a), e + 1) / (e + 1);
  return r;
}

/// Powers of logarithms, powers of the distance from any end with any exponent, exponentials of
/// powers and of powers of logarithms: what is known by a change of the variable to an exponential.
/// A divergent twin in one case of four.
integral_case by_exponential(maker& m) {
  const bool diverges = m.one_in(4);
  const term a = m.near(m.within(1.5, 4));
  const term k = m.positive_rational();
  integral_case r{0, a, "inf", few_digits(m)};
  r.diverges = diverges;
  switch (m.between(0, diverges ? 2 : 4)) {
    case 0: {  // 1/(x log(x)^p)
      const term p = diverges ? (m.one_in(2) ? term(1) : m.quotient(m.within(-1, 0.95)))
                              : (m.one_in(3) ? term("sqrt(2)") : m.quotient(m.within(1.1, 4)));
      r.integrand = 1 / (x * power(call("log", x), p));
      if (!diverges) r.value = power(call("log", a), 1 - p) / (p - 1);
      if (m.one_in(2)) {  // at 0, from 1/a on
        r.integrand = 1 / (x * power(-call("log", x), p));
        r.from = 0;
        r.to = 1 / a;
      }
      break;
    }
    case 1: {  // |x - c|^e
      const term c = m.one_in(2) ? m.irrational() : m.near(m.within(0.3, 3));
      const term e = diverges ? term(m.any_of({"-sqrt(2)", "-pi/3", "-1", "-1-1e-9", "-e/2"}))
                              : term(m.any_of({"-1/sqrt(2)", "-1+1e-9", "-log(2)", "pi/5",
                                               "sqrt(2)", "-0.999", "-pi/4"}));
      const bool is_lower = m.one_in(2);
      const term w = is_lower ? x - c : c - x;
      const term length = m.near(m.scattered(0.01, 3));
      r.integrand = power(w, e);
      r.from = is_lower ? c : c - length;
      r.to = is_lower ? c + length : c;
      if (diverges || m.one_in(2)) {
        r.integrand = r.integrand * (2 + call("cos", x));
      } else {
        r.value = power(length, e + 1) / (e + 1);
      }
      break;
    }
    case 2:  // x^(-1 -+ d) log(x)^j
      if (diverges) {
        r.integrand = power(x, m.any_of({"-1", "-1+1e-9", "-1/sqrt(2)", "0"})) *
                      power(call("log", x), m.between(0, 2)) / (2 + call("sin", 1 / x));
      } else {
        const term d = m.decimal(m.scattered(1e-9, 0.5));
        r.integrand = power(x, -1 - d);
        r.value = power(a, -d) / d;
      }
      break;
    case 3: {  // exp(-x^p), the whole half line: Gamma(1 + 1/p)
      const term p = m.one_in(2) ? m.quotient(m.within(0.2, 5))
                                 : term(m.any_of({"pi", "sqrt(2)", "1/sqrt(3)", "e/4"}));
      r.integrand = call("exp", -power(x, p));
      r.from = 0;
      r.value = call("gamma", 1 + 1 / p);
      break;
    }
    default: {  // exp(-k log(x)^2) x^j, the whole half line: sqrt(pi/k) exp((j + 1)^2/(4k))
      const term j = m.quotient(m.within(-3, 2));
      r.integrand = call("exp", -(k * power(call("log", x), 2))) * power(x, j);
      r.from = 0;
      r.value = call("sqrt", term("pi") / k) * call("exp", power(j + 1, 2) / (4 * k));
      break;
    }
  }
  return r;
}

/// An irrational exponent, at which x^e is integrable at 0.
term irrational_exponent(maker& m) {
  return m.any_of({"sqrt(2)", "pi", "sqrt(3)/2", "-1/sqrt(2)", "-1/sqrt(3)", "pi/5", "-pi/4", "e/3",
                   "-log(2)", "-sqrt(8/9)", "(sqrt(2)-1)"});
}

/// No series at the end: irrational and variable exponents, logarithms of logarithms, at 0 and at
/// infinity.
integral_case growing_end(maker& m) {
  term f = power(x, irrational_exponent(m)) * regular(m);
  term to = m.near(m.scattered(0.1, 3));
  switch (m.between(0, 6)) {
    case 0:
      f = f * logarithm_power(m, x);
      break;
    case 1:
      f = power(x, m.one_in(2) ? x : -x) * regular(m);
      break;
    case 2:
      f = call("cos", m.positive_rational() * call("log", x)) * f;
      break;
    case 3:
      f = call("log", call("log", 1 / x)) * regular(m);
      to = m.rational_near(m.within(0.05, 0.3));
      break;
    case 4:
      f = 1 / (1 + power(x, m.any_of({"pi", "sqrt(2)", "sqrt(3)", "e/2", "sqrt(11)"})));
      to = "inf";
      break;
    case 5:
      f = f + power(x, irrational_exponent(m)) / (2 + power(x, "sqrt(5)"));
      break;
    default:
      break;
  }
  return {f, 0, to, few_digits(m)};
}

/// Their twins that diverge.
integral_case divergent_growth(maker& m) {
  const term e = m.any_of({"-sqrt(2)", "-pi/3", "-sqrt(1+1e-8)", "-pi/2", "-log(3)", "-e/2"});
  term f = power(x, e) * regular(m);
  term to = m.near(m.scattered(1e-3, 2));
  term from = 0;
  switch (m.between(0, 3)) {
    case 0:
      f = f + power(x, irrational_exponent(m));
      break;
    case 1:
      to = m.rational_near(m.within(0.1, 1));
      f = power(x, e) / (2 + call("cos", call("log", x)));
      break;
    case 2:
      f = 1 / (1 + power(x, m.any_of({"pi/4", "1/sqrt(2)", "sqrt(1-1e-8)", "e/3"})));
      to = "inf";
      break;
    default:
      break;
  }
  integral_case r{f, from, to, few_digits(m)};
  r.diverges = true;
  return r;
}

/// Special functions at the ends of their domains, beside the same by other functions.
integral_case special_end(maker& m) {
  const auto lower = [&] { return power(x, m.exponent_between(-0.9, 2)); };
  const auto upper = [&] { return power(1 - x, m.exponent_between(-0.9, 2)); };
  const auto same = [&](const term& f, const term& g) {
    integral_case r{f, 0, 1, few_digits(m)};
    r.parts = {{g, 0, 1, few_digits(m)}};
    return r;
  };
  switch (m.between(0, 7)) {
    case 6: {  // log gamma(x) grows as x log x
      const term g = m.one_in(2) ? call("log_gamma", x) : call("log", call("gamma", x));
      const term faster = call("gamma", x) * call("exp", -power(x, 2));
      integral_case r{1 / m.any_of({g, call("sqrt", g), faster}), m.near(m.within(3, 9)), "inf",
                      few_digits(m)};
      r.diverges = true;
      return r;
    }
    case 7: {
      const term g = call("gamma", x + m.rational_near(m.within(0.2, 3)));
      const term f = m.any_of({term("1"), x, call("sqrt", x)});
      const term from = m.near(m.within(0.1, 4));
      const term to = m.near(m.within(200, 300));
      integral_case r{f / (m.one_in(2) ? g : -g), from, "inf", few_digits(m)};
      r.parts = {{r.integrand, from, to, few_digits(m)}, {r.integrand, to, "inf", few_digits(m)}};
      return r;
    }
    case 0: {
      const term w = lower();
      return same(w * call("log_gamma", x), w * (call("log_gamma", 1 + x) - call("log", x)));
    }
    case 1: {
      const term w = x * lower();
      return same(w * call("gamma", x), w / x * call("gamma", 1 + x));
    }
    case 2: {
      const term w = upper();
      return same(w * call("ellipticK", x),
                  substituted(w, "x", 1 - x) * term("pi") / (2 * call("agm", 1, call("sqrt", x))));
    }
    case 3: {
      const term w = m.one_in(2) ? lower() : upper();
      return same(w * call("agm", 1, x), w * call("agm", x, 1));
    }
    case 4: {
      const term w = upper();
      return same(w * call("log_gamma", 1 - x), substituted(w, "x", 1 - x) * call("log_gamma", x));
    }
    default: {
      integral_case r{m.one_in(2) ? call("gamma", x) * regular(m)
                                  : call("ellipticK", x) / power(1 - x, m.between(1, 2)),
                      0, 1, few_digits(m)};
      r.diverges = true;
      return r;
    }
  }
}

/// Of limits whose sizes have nothing in common.
integral_case many_orders(maker& m) {
  const term low = m.decimal(m.scattered(1e-200, 1e-3));
  const term high = m.decimal(m.scattered(1e-2, 1e100));
  const term f = m.one_in(2) ? power(x, m.exponent_between(-3, 1)) * call("exp", -x)
                             : 1 / (x * power(1 + x, m.between(1, 3)));
  return {f, low, high, few_digits(m)};
}

/// 1 - m, m rational or near 1, as a power of the distance times what has a value there.
struct complement {
  term parameter = 0;
  term left = 0;
};
complement any_complement(maker& m, const term& t) {
  const term c = m.positive_rational();
  const term u = c * power(t, m.between(1, 4));
  switch (m.between(0, 11)) {
    case 6:
      return {call("sqrt", 1 - u), u / (1 + call("sqrt", 1 - u))};
    case 7:
      return {1 / power(call("cosh", u), 2), power(call("tanh", u), 2)};
    case 8:
      return {2 / (3 - call("cos", u)),
              2 * power(call("sin", u / 2), 2) / (2 + 2 * power(call("sin", u / 2), 2))};
    case 9:
      return {1 - call("sin", u), call("sin", u)};
    case 10:
      return {call("log", call("exp", 1) - u), -call("log1p", -u / call("exp", 1))};
    case 11: {
      const term p = m.positive_rational();
      return {power(1 + u, -p), -call("expm1", -p * call("log1p", u))};
    }
    case 0:
      return {1 - u, u};
    case 1:
      return {1 / (1 + u), u / (1 + u)};
    case 2:
      return {(1 - u) / (1 + u), 2 * u / (1 + u)};
    case 3:
      return {power(call("cos", u), 2), power(call("sin", u), 2)};
    case 4:
      return {call("exp", -u), -call("expm1", -u)};
    default:
      return {4 * (1 + u) / power(2 + u, 2), power(u / (2 + u), 2)};
  }
}

/// K(m) where m tends to 1 at an end, between the limits or at infinity, as K and by its mean.
integral_case complete_elliptic(maker& m) {
  const bool is_infinite = m.one_in(4);
  const term e = m.one_in(3) ? term(0) : m.quotient(m.within(-2, 2));
  const bool is_below = m.one_in(2);
  const bool crosses = !is_infinite && m.one_in(4);
  const term length = m.quotient(m.within(0.1, 1)) + term(1) / 50;
  // The distance is below 1 there: so that m > 0, and 1 - m > 0, if c is small.
  const term t = is_infinite ? 1 / x : is_below ? e - x : x - e;
  const complement k = any_complement(m, crosses ? call("abs", t) : t);
  const term weight = is_infinite ? 1 / power(x, 2) : m.gentle(x);
  integral_case result{call("ellipticK", k.parameter) * weight,
                       is_infinite           ? length + 1
                       : is_below || crosses ? e - length
                                             : e,
                       is_infinite            ? term("inf")
                       : is_below && !crosses ? e
                                              : e + length,
                       few_digits(m)};
  const term mean = call("agm", 1, call("sqrt", k.left));
  result.parts.push_back({term("pi") / 2 / mean * weight, result.from, result.to, result.digits});
  return result;
}

/// Exponentials that grow in divisors, beside powers, whose sums are no sums of integrals that
/// converge, or no sums at all. By closed forms, or as derivatives; a divergent twin in one case of
/// five.
integral_case exponentials_beside_powers(maker& m) {
  const term k = m.rational_near(m.within(0.3, 3));
  const term t = k * x;
  integral_case c{0, 0, "inf", few_digits(m)};
  switch (m.between(0, 6)) {
    case 0:
      c.integrand = (1 / x - k / call("sinh", t)) / x;
      c.value = k * call("log", 2);
      break;
    case 1:
      c.integrand = 1 / power(x, 2) - power(k, 2) / power(call("sinh", t), 2);
      c.value = k;
      break;
    case 2:
      c.integrand = power(k / call("sinh", t) - 1 / x, 2);
      c.value = k * (2 * call("log", 2) - 1);
      break;
    case 3: {  // -(1/g)' = g'/g^2, g = p + cosh or exp
      const term g = m.positive_rational() * x + (m.one_in(2) ? call("cosh", t) : call("exp", t));
      c.integrand = derivative(-(1 / g));
      c.from = m.positive_rational();
      c.value = 1 / substituted(g, "x", c.from);
      break;
    }
    case 4: {  // the derivative of -1/(x + h), h = 1/sinh, x + h > 0
      const term g = x + m.positive_rational() / call("sinh", t);
      c.integrand = derivative(-(1 / g));
      c.from = m.positive_rational();
      c.value = 1 / substituted(g, "x", c.from);
      break;
    }
    case 5: {  // no closed form: by its routes
      const term g = m.one_in(2) ? call("exp", t) - m.quotient(0.5) : call("cosh", t);
      c.integrand = power(1 / x - m.coefficient() / g, m.between(2, 3));
      c.from = m.positive_rational();
      break;
    }
    default:
      c.integrand = (1 + 1 / call("sinh", t)) / x;
      c.from = m.positive_rational();
      c.diverges = true;
  }
  return c;
}

/// A product of powers, exponentials, x^x, gamma functions and W that grow and decay, times its
/// logarithmic derivative: known where the product tends to 0, as the fastest factor, or what is
/// left of two as fast, decides. A divergent twin in one case of four.
integral_case growth_beside_growth(maker& m) {
  integral_case c{0, m.rational_near(m.within(0.5, 3)), "inf", few_digits(m)};
  c.diverges = m.one_in(4);
  const term b = m.rational_near(m.within(0.2, 4));
  const term k = m.rational_near(m.within(0.4, 3));
  const term less = k * m.decimal(m.within(0.1, 0.9));
  const term s = m.rational_near(m.within(0, 2));
  // Each with its logarithmic derivative.
  struct factor {
    term f;
    term slope;
  };
  const factor exponential{call("exp", b * x), b};
  const factor square{call("exp", power(x, 2) / 4), x / 2};
  const auto self = [](const term& e) { return factor{power(x, e * x), e * (call("log", x) + 1)}; };
  const auto gamma = [&](const term& e) {
    return factor{call("gamma", e * x + s), e * call("digamma", e * x + s)};
  };
  factor greater{1, 0};
  factor lesser{1, 0};
  switch (m.between(0, 5)) {
    case 0:
      greater = m.one_in(2) ? gamma(k) : self(k);
      lesser = exponential;
      break;
    case 1:
      greater = square;
      lesser = m.one_in(2) ? gamma(k) : self(k);
      break;
    case 2:
      greater = m.one_in(2) ? gamma(k) : self(k);
      lesser = m.one_in(2) ? gamma(less) : self(less);
      break;
    case 3: {  // Gamma(x + s)/x^x is about x^(s - 1/2) e^-x
      const term rest = m.decimal(m.within(0.05, 0.9));
      greater = self(1);
      lesser = gamma(1);
      lesser = {lesser.f * call("exp", rest * x), lesser.slope + rest};
      break;
    }
    case 4: {  // Gamma(2 x)/Gamma(x)^2 is about 4^x
      greater = {call("gamma", 2 * x), 2 * call("digamma", 2 * x)};
      lesser = {power(call("gamma", x), 2), 2 * call("digamma", x)};
      break;
    }
    default:
      greater = exponential;
      lesser = {call("cosh", b * x / 2), b / 2 * call("tanh", b * x / 2)};
  }
  if (c.diverges) std::swap(greater, lesser);
  const term p = m.one_in(2) ? term(0) : m.rational_near(m.within(-2, 3));
  factor slow{power(x, p), p / x};
  if (m.one_in(4)) {
    const term w = call("lambertW", k * x);
    slow = {slow.f * w, slow.slope + 1 / (x * (1 + w))};
  }
  const term& steady = slow.f;
  const term slope = lesser.slope - greater.slope + slow.slope;
  const term f = m.any_of({steady * lesser.f / greater.f, lesser.f / (greater.f / steady),
                           steady / greater.f * lesser.f, lesser.f * (steady / greater.f)});
  c.integrand = m.one_in(2) ? f * slope : slope * f;
  if (!c.diverges) c.value = -substituted(f, "x", c.from);
  return c;
}

}  // namespace

std::vector<integral_family> end_families() {
  return {{"singular lower end", 12, mostly_cheap(singular_lower_end)},
          {"singular at both ends", 10, mostly_cheap(singular_both_ends)},
          {"end of a domain", 10, mostly_cheap(domain_end)},
          {"divergent at an end", 7, mostly_cheap(divergent_end)},
          {"divergent at a root", 7, mostly_cheap(divergent_root)},
          {"divergent at a pole", 7, mostly_cheap(divergent_pole)},
          {"divergent tail", 6, mostly_cheap(divergent_tail)},
          {"growth and waves in tails", 8, mostly_cheap(growing_tail)},
          {"kinks in tails", 8, mostly_cheap(kinks_in_tails)},
          {"algebraic tail", 7, mostly_cheap(algebraic_tail)},
          {"exponential tail", 7, mostly_cheap(exponential_tail)},
          {"special tail", 6, mostly_cheap(special_tail)},
          {"turning point at an end", 12, mostly_cheap(turning_end)},
          {"inverse functions at their ends", 8, mostly_cheap(inverse_at_its_end)},
          {"irrational breaks", 8, mostly_cheap(irrational_breaks)},
          {"removable", 10, mostly_cheap(removable)},
          {"multiples of pi cancel", 10, mostly_cheap(multiples_of_pi_cancel)},
          {"constants cancel", 10, mostly_cheap(constants_cancel)},
          {"limits cancel", 10, mostly_cheap(limits_cancel)},
          {"falls doubly", 5, mostly_cheap(falls_doubly)},
          {"by an exponential", 14, mostly_cheap(by_exponential)},
          {"powers of differences", 3, powers_of_differences},
          {"end without a series", 8, mostly_cheap(growing_end)},
          {"divergent without a series", 5, mostly_cheap(divergent_growth)},
          {"special functions at ends", 8, mostly_cheap(special_end)},
          {"complete elliptic integrals", 5, complete_elliptic},
          {"exponentials beside powers", 6, exponentials_beside_powers},
          {"growth beside growth", 4, growth_beside_growth},
          {"whole line", 7, mostly_cheap(whole_line)},
          {"extreme sizes", 7, mostly_cheap(extreme_sizes)},
          {"many orders of magnitude", 6, mostly_cheap(many_orders)}};
}

}  // namespace polhode::differential
