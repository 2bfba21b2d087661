// Values: random formulas in every arithmetic, and the identities of the elementary functions,
// gamma and erf.

#include "values.hpp"

namespace polhode::differential {
namespace {

/// A number of any form and size.
term number(maker& m) {
  if (m.one_in(12)) return m.decimal((m.one_in(2) ? 1 : -1) * m.scattered(1e-30, 1e6));
  return m.near(m.within(-6, 6));
}
term positive_number(maker& m) {
  return m.one_in(12) ? m.decimal(m.scattered(1e-30, 1e12)) : m.near(m.scattered(0.05, 30));
}
/// Between -1 and 1.
term unit_number(maker& m) {
  return m.one_in(3) ? m.decimal(m.within(-0.999, 0.999))
                     : m.quotient(m.within(-0.9, 0.9)) * m.decimal(0.99);
}

value_case random_formula(maker& m) {
  std::function<term(long)> made = [&](long depth) -> term {
    if (depth == 0) return number(m);
    const auto part = [&] { return made(depth - 1 - (m.one_in(3) ? 1 : 0) < 0 ? 0 : depth - 1); };
    switch (m.between(0, 9)) {
      case 0:
        return part() + part();
      case 1:
        return part() - part();
      case 2:
        return part() * part();
      case 3:
        return part() / part();
      case 4:
        return power(part(), m.between(-4, 4));
      case 5:
        return power(call("abs", part()), m.exponent_between(-3, 3));
      case 6:
        return call(m.any_of({"min", "max", "hypot", "atan2", "agm"}), part(), part());
      case 7:
        return call("root", part(), m.between(1, 7));
      default:
        return call(
            m.any_of({"sqrt", "cbrt",  "exp",  "expm1", "log",   "log1p", "log2",     "log10",
                      "sin",  "cos",   "tan",  "sinpi", "cospi", "asin",  "acos",     "atan",
                      "sinh", "cosh",  "tanh", "sech",  "csch",  "asinh", "acosh",    "atanh",
                      "abs",  "floor", "ceil", "erf",   "erfc",  "gamma", "log_gamma"}),
            part());
    }
  };
  const term t = made(m.between(1, 4));
  return {t, t};
}

value_case exponential(maker& m) {
  const term a = number(m);
  const term b = number(m);
  const term p = positive_number(m);
  const term q = positive_number(m);
  switch (m.between(0, 6)) {
    case 0:
      return {call("exp", a + b), call("exp", a) * call("exp", b)};
    case 1:
      return {call("log", p * q), call("log", p) + call("log", q)};
    case 2:
      return {call("expm1", a), call("exp", a) - 1};
    case 3:
      return {call("log1p", p), call("log", 1 + p)};
    case 4:
      return {call("exp", call("log", p)), p};
    case 5:
      return {call("log2", p) * call("log", 2), call("log10", p) * call("log", 10)};
    default:
      return {call("exp", -a), 1 / call("exp", a)};
  }
}

value_case powers(maker& m) {
  const term p = positive_number(m);
  const term q = positive_number(m);
  const term e = m.near(m.within(-3, 3));
  const long n = m.between(2, 9);
  switch (m.between(0, 6)) {
    case 0:
      return {power(p, e), call("exp", e * call("log", p))};
    case 1:
      return {power(call("root", p, n), n), p};
    case 2:
      return {call("sqrt", p) * call("sqrt", q), call("sqrt", p * q)};
    case 3:
      return {power(p, n) * power(p, -n), 1};
    case 4:
      return {call("cbrt", -p), -call("root", p, 3)};
    case 5:
      return {call("hypot", p, q), call("sqrt", power(p, 2) + power(q, 2))};
    default:
      return {call("agm", p, q), call("agm", (p + q) / 2, call("sqrt", p * q))};
  }
}

value_case circular(maker& m) {
  const term a = m.one_in(6) ? number(m) * power(10, m.between(1, 30)) : number(m);
  const term b = number(m);
  const auto s = [](const term& t) { return call("sin", t); };
  const auto c = [](const term& t) { return call("cos", t); };
  switch (m.between(0, 7)) {
    case 0:
      return {power(s(a), 2) + power(c(a), 2), 1};
    case 1:
      return {s(a + b), s(a) * c(b) + c(a) * s(b)};
    case 2:
      return {c(2 * a), 1 - 2 * power(s(a), 2)};
    case 3:
      return {call("tan", a), s(a) / c(a)};
    case 4:
      return {call("sinpi", b), s(term("pi") * b)};
    case 5:
      return {call("cospi", b), c(term("pi") * b)};
    case 6:
      return {s(3 * a), 3 * s(a) - 4 * power(s(a), 3)};
    default:
      return {s(a + term("pi") * m.between(1, 1000) * 2), s(a)};
  }
}

value_case hyperbolic(maker& m) {
  const term a = number(m);
  const term b = number(m);
  switch (m.between(0, 6)) {
    case 0:
      return {power(call("cosh", a), 2) - power(call("sinh", a), 2), 1};
    case 1:
      return {call("sinh", a + b),
              call("sinh", a) * call("cosh", b) + call("cosh", a) * call("sinh", b)};
    case 2:
      return {call("tanh", a), call("expm1", 2 * a) / (call("exp", 2 * a) + 1)};
    case 3:
      return {call("sech", a), 2 / (call("exp", a) + call("exp", -a))};
    case 4:
      return {call("csch", a), 1 / call("sinh", a)};
    case 5:
      return {call("asinh", a), call("log", a + call("sqrt", 1 + power(a, 2)))};
    default:
      return {call("asinh", call("sinh", a)), a};
  }
}

value_case inverse(maker& m) {
  const term u = unit_number(m);
  const term a = number(m);
  const term p = positive_number(m);
  switch (m.between(0, 8)) {
    case 0:
      return {call("asin", u) + call("acos", u), term("pi") / 2};
    case 1:
      return {call("sin", call("asin", u)), u};
    case 2:
      return {call("atan", p) + call("atan", 1 / p), term("pi") / 2};
    case 3:
      return {call("tan", call("atan", a)), a};
    case 4:
      return {2 * call("atanh", u), call("log", (1 + u) / (1 - u))};
    case 5:
      return {call("acosh", 1 + p), call("log", 1 + p + call("sqrt", p * (p + 2)))};
    case 6:
      return {call("atan2", a, p), call("atan", a / p)};
    case 7:
      return {call("atan2", p, -p), 3 * term("pi") / 4};
    default:
      return {call("asin", u), call("atan", u / call("sqrt", 1 - power(u, 2)))};
  }
}

value_case gamma_and_erf(maker& m) {
  const term a = m.near(m.within(-6, 12));
  const term p = m.near(m.scattered(0.05, 12));
  switch (m.between(0, 6)) {
    case 0:
      return {call("gamma", a + 1), a * call("gamma", a)};
    case 1:
      return {call("gamma", a) * call("gamma", 1 - a), term("pi") / call("sinpi", a)};
    case 2:
      return {call("gamma", p) * call("gamma", p + term("1/2")),
              power(2, 1 - 2 * p) * call("sqrt", "pi") * call("gamma", 2 * p)};
    case 3:
      return {call("log_gamma", p), call("log", call("gamma", p))};
    case 4:
      return {call("erf", a) + call("erfc", a), 1};
    case 5:
      return {call("erf", -a), -call("erf", a)};
    default:
      return {call("log_gamma", a), call("log", call("abs", call("gamma", a)))};
  }
}

/// Of exact numbers only: the value is a rational number, worked out here with GMP.
/// The identities above with so many bits that the functions are summed in fixed point, by tables
/// and without, and by MPFR.
value_case with_many_bits(maker& m) {
  // Beyond 70,000 bits, or 102,000 of sine and cosine, arguments are taken apart.
  const precision of_elementary_functions = m.one_in(15) ? 130'000 : 11'000;
  constexpr precision of_gamma = 1600;
  if (m.one_in(4)) {
    value_case c = gamma_and_erf(m);
    c.most_bits = of_gamma;
    return c;
  }
  value_case c = m.any_of({exponential, circular, hyperbolic, inverse})(m);
  c.most_bits = of_elementary_functions;
  return c;
}

value_case exact_arithmetic(maker& m) {
  std::function<std::pair<term, rational>(long)> made =
      [&](long depth) -> std::pair<term, rational> {
    if (depth == 0) {
      const term t = m.decimal(m.within(-9, 9));
      const bool is_negative = !t.is_leaf();
      const rational q = parse_rational(is_negative ? t.parts()[0].head() : t.head());
      return {t, is_negative ? rational(-q) : q};
    }
    const auto [a, x] = made(depth - 1);
    const auto [b, y] = made(depth - 1);
    switch (m.between(0, 4)) {
      case 0:
        return {a + b, x + y};
      case 1:
        return {a - b, x - y};
      case 2:
        return {a * b, x * y};
      case 3:
        if (y == 0) return {a, x};
        return {a / b, x / y};
      default:
        return {power(a, 3), x * x * x};
    }
  };
  const auto [t, q] = made(m.between(1, 4));
  return {t, term(to_text(q))};
}

}  // namespace

std::vector<value_family> formula_families() {
  return {{"random formulas", 6000, random_formula},
          {"exponentials and logarithms", 1000, exponential},
          {"powers and roots", 1000, powers},
          {"circular functions", 1000, circular},
          {"hyperbolic functions", 1000, hyperbolic},
          {"inverse functions", 1000, inverse},
          {"gamma and error functions", 600, gamma_and_erf},
          {"functions with many bits", 200, with_many_bits},
          {"exact arithmetic", 1000, exact_arithmetic}};
}

}  // namespace polhode::differential
