// What happens between the ends: oscillation, kinks, poles near the range, removable singularities,
// symmetry, nested functions.

#include "integrals.hpp"

namespace polhode::differential {
namespace {

const term x = "x";

long few_digits(maker& m) { return m.one_in(3) ? m.between(2, 10) : m.between(11, 25); }

integral_case oscillation(maker& m) {
  const term k = m.near(m.scattered(1, 300));
  const std::string wave = m.one_in(2) ? "cos" : "sin";
  const auto [a, b] = m.range(0.2, 5);
  switch (m.between(0, 4)) {
    case 0:
      return {call(wave, k * x) * m.gentle(x), a, b, few_digits(m)};
    case 1:
      return {call(wave, k * power(x, 2)), a, b, few_digits(m)};
    case 2:
      return {call(wave, k / x), a, b, few_digits(m)};
    case 3:
      return {call(wave, k * x) * call(wave, m.near(m.scattered(1, 50)) * x), a, b, few_digits(m)};
    default:
      return {call(wave, k * x) / (1 + power(x, 2)), a, b, few_digits(m)};
  }
}

integral_case oscillating_tail(maker& m) {
  const term k = m.positive_rational();
  const std::string wave = m.one_in(2) ? "cos" : "sin";
  const term e = m.exponent_between(0.3, 3);
  const term f = call(wave, k * x) / (m.one_in(2) ? power(x, e) : power(1 + power(x, 2), 1));
  return {f, m.near(m.within(0.5, 4)), "inf", m.between(5, 16)};
}

/// Steps of k x times what decays exponentially, over x > 0, and some that do not converge.
integral_case steps_to_infinity(maker& m) {
  const term k = m.rational_near(m.scattered(0.5, 3));
  const term a = m.rational_near(m.scattered(0.8, 4));
  const term t = k * x;
  integral_case r{0, 0, "inf", few_digits(m)};
  switch (m.between(0, 4)) {
    case 0:
      r.integrand = call("floor", t) * call("exp", -(a * x));
      r.value = 1 / (a * call("expm1", a / k));
      break;
    case 1:
      r.integrand = call("ceil", t) * call("exp", -(a * x));
      r.value = -(1 / (a * call("expm1", -(a / k))));
      break;
    case 2:
      r.integrand = call("exp", -(a * call("floor", t)));
      r.value = -(1 / (k * call("expm1", -a)));
      break;
    case 3:
      r.integrand = call("exp", -(a * call("ceil", t)));
      r.value = 1 / (k * call("expm1", a));
      break;
    default:
      r.integrand = m.any_of({call("floor", t) / (1 + x), call("exp", a * call("floor", t)),
                              call("exp", -(a * x)) * call("exp", a * call("ceil", x)),
                              call("exp", a * (call("floor", x) - x)) * call("ceil", t)});
      r.diverges = true;
  }
  return r;
}

/// abs, min and max of rational functions over infinite ranges, which are cut at rational points. A
/// divergent twin in one case of five.
integral_case pieces_to_infinity(maker& m) {
  const bool diverges = m.one_in(5);
  const term c = m.coefficient();
  const term k = m.positive_rational();
  const term middle = m.one_in(3) ? term(0) : m.rational_near(m.within(-3, 3));
  const term distance = call("abs", x - middle);
  integral_case r{0, "-inf", "inf", few_digits(m)};
  r.diverges = diverges;
  if (diverges) {
    r.integrand = m.any_of({c / (1 + k * distance), c * call("min", 1, 1 / distance),
                            c * call("max", 1 / power(x, 2), k),
                            c * call("abs", 1 - call("max", distance, k) / k),
                            c * call("exp", -k * call("min", distance, 2))});
    return r;
  }
  switch (m.between(0, 5)) {
    case 0: {
      const term w = m.any_of({term(1), term(7), term(100), term(3000)});
      r.integrand = c * call("exp", -k * distance) * call("cos", w * x);
      r.value = c * 2 * k * call("cos", w * middle) / (power(k, 2) + power(w, 2));
      break;
    }
    case 1: {
      const term n = m.between(2, 6);
      r.integrand = c / power(1 + k * distance, n);
      r.value = 2 * c / (k * (n - 1));
      break;
    }
    case 2:
      r.integrand = c * call("max", 0, 1 - k * distance) * call("exp", x);
      r.value = c * call("exp", middle) * k * power(call("sinh", 1 / (2 * k)) * 2, 2);
      break;
    case 3: {
      const term n = m.between(2, 5);
      r.integrand = c * call("min", power(k, n), 1 / power(distance, n));
      r.value = 2 * c * n / (n - 1) * power(k, n - 1);
      break;
    }
    case 4: {
      const term q = m.positive_rational();
      const term at_q = power(q, 2) / k + 2 * q / power(k, 2) + 2 / power(k, 3);
      r.integrand = c * call("abs", power(x, 2) - power(q, 2)) * call("exp", -k * x);
      r.from = 0;
      r.value = c * (2 * call("exp", -k * q) * (at_q - power(q, 2) / k) + power(q, 2) / k -
                     2 / power(k, 3));
      break;
    }
    default: {
      const term a = m.positive_rational();
      r.integrand = c / power(call("max", x, a), 3);
      r.from = 0;
      r.value = 3 * c / (2 * power(a, 2));
      break;
    }
  }
  return r;
}

/// 0/0 at an end or between the limits.
integral_case removable(maker& m) {
  const term c = m.one_in(2) ? term(0) : m.near(m.within(-1, 1));
  const term w = c.is("0") ? x : x - c;
  term f = 0;
  switch (m.between(0, 7)) {
    case 0:
      f = call("sin", w) / w;
      break;
    case 1:
      f = call("expm1", w) / w;
      break;
    case 2:
      f = (1 - call("cos", w)) / power(w, 2);
      break;
    case 3:
      f = call("log1p", w) / w;
      break;
    case 4:
      f = w / call("sin", w);
      break;
    case 5:
      f = (w - call("sin", w)) / power(w, 3);
      break;
    case 6:
      f = call("tan", w) / w;
      break;
    default:
      f = 1 / w - 1 / call("sin", w);
  }
  const bool crosses = m.one_in(4);
  const term length = m.quotient(m.within(0.1, 1.2));
  return {f, crosses ? c - m.quotient(m.within(0.1, 0.9)) : c, c + length, few_digits(m)};
}

term kinked(maker& m, const term& t) {
  const term c = m.near(m.within(-1, 1));
  switch (m.between(0, 7)) {
    case 0:
      return call("abs", t - c);
    case 1:
      return call("min", t, c);
    case 2:
      return call("max", power(t, 2), c);
    case 3:
      return call("floor", m.positive_rational() * t);
    case 4:
      return call("ceil", t - c);
    case 5:
      return call("sqrt", power(t - c, 2));
    case 6:
      return call("abs", call("sin", m.positive_rational() * t));
    default:
      return call("min", call("sin", t), call("cos", t));
  }
}

integral_case kinks(maker& m) {
  const auto [a, b] = m.range(-3, 3);
  term f = kinked(m, x);
  switch (m.between(0, 3)) {
    case 0:
      f = f * m.gentle(x);
      break;
    case 1:
      f = m.gentle(f);
      break;
    case 2:
      f = f + kinked(m, x);
      break;
    default:
      break;
  }
  return {f, a, b, few_digits(m)};
}

/// d, which is 0 of an order above 1 at c, where it changes its sign or not, and simply at r > c.
struct high_zero {
  term d = 0;
  term a = 0;
  term c = 0;
  term r = 0;
  term b = 0;
  bool changes_at_c = false;
};

high_zero any_high_zero(maker& m) {
  high_zero k;
  const auto length = [&] { return m.quotient(m.scattered(0.01, 0.4)) + term(1) / 97; };
  k.c = m.one_in(4) ? m.near(m.within(-1, 1)) : m.one_in(3) ? term(0) : m.quotient(m.within(-1, 1));
  k.a = k.c - length();
  k.r = k.c + length();
  k.b = k.r + length();
  const term w = k.c.is("0") ? x : x - k.c;
  switch (m.between(0, 6)) {
    case 0:
      k.d = call("sin", w) - w + power(w, 3) / 6;
      k.changes_at_c = true;
      break;
    case 1:
      k.d = power(w, 3) * call("exp", x);
      k.changes_at_c = true;
      break;
    case 2:
      k.d = call("tan", w) - w;
      k.changes_at_c = true;
      break;
    case 3:
      k.d = 1 - call("cos", w);
      break;
    case 4:
      k.d = call("cosh", w) - 1 - power(w, 2) / 2;
      break;
    case 5:
      k.d = call("expm1", w) - w;
      break;
    default:
      k.d = w - call("log1p", w);
  }
  k.d = k.d * (k.r - x);
  return k;
}

/// The integral in parts, on which the branches are known.
integral_case high_kink(maker& m) {
  const high_zero k = any_high_zero(m);
  const bool is_abs = m.one_in(2);
  integral_case result{is_abs ? call("abs", k.d) : call("max", k.d, 0), k.a, k.b, few_digits(m)};
  const auto add = [&](const term& from, const term& to, bool is_positive) {
    if (is_positive || is_abs) {
      result.parts.push_back({is_positive ? k.d : -k.d, from, to, result.digits});
    }
  };
  add(k.a, k.c, !k.changes_at_c);
  add(k.c, k.r, true);
  add(k.r, k.b, false);
  return result;
}

integral_case high_kink_that_diverges(maker& m) {
  const high_zero k = any_high_zero(m);
  integral_case result{1 / call("sqrt", call("abs", k.d)), k.a, k.b, m.between(2, 12)};
  result.diverges = true;
  return result;
}

/// A pole, or a branch point, at a small distance outside of the range.
integral_case pole_outside(maker& m) {
  const term b = m.near(m.within(0.5, 3));
  const double distance = m.scattered(1e-12, 0.3);
  const term c = b + m.decimal(distance);
  const term a = b - m.quotient(m.within(0.3, 3));
  term f = 0;
  switch (m.between(0, 5)) {
    case 0:
      f = 1 / (c - x);
      break;
    case 1:
      f = power(c - x, m.exponent_between(-3, 1));
      break;
    case 2:
      f = call("log", c - x);
      break;
    case 3:
      f = 1 / call("sin", c - x);
      break;
    case 4:
      f = 1 / call("expm1", c - x);
      break;
    default:
      f = call("exp", x) / (power(c, 2) - power(x, 2) + power(x - b, 2));
  }
  if (f.is_leaf()) f = 1;
  return {f, a, b, few_digits(m)};
}

/// A pair of complex poles near the range.
integral_case pole_beside(maker& m) {
  const auto [a, b] = m.range(-2, 2);
  const term c = m.near(m.within(-2, 2));
  const term h = m.decimal(m.scattered(1e-8, 1));
  const term w = power(x - c, 2) + power(h, 2);
  switch (m.between(0, 3)) {
    case 0:
      return {m.gentle(x) / w, a, b, few_digits(m)};
    case 1:
      return {power(w, m.exponent_between(-3, 2)), a, b, few_digits(m)};
    case 2:
      return {call("atan", (x - c) / h), a, b, few_digits(m)};
    default:
      return {1 / (call("cosh", x - c) - call("cos", h)), a, b, few_digits(m)};
  }
}

integral_case nested(maker& m) {
  const auto [a, b] = m.range(-2, 2);
  term f = x;
  for (long depth = m.between(2, 4); depth > 0; --depth) {
    const term inside =
        m.one_in(2) ? m.rational_near(m.within(0.3, 2)) * f : f + m.near(m.within(-1, 1));
    f = m.gentle(inside);
    if (m.one_in(4)) f = f * m.gentle(x);
  }
  return {f, a, b, few_digits(m)};
}

/// Even, odd, about 0 or the middle: half of it, and 0.
integral_case symmetric(maker& m) {
  const term b = m.near(m.scattered(0.3, 4));
  const term even = m.gentle(power(x, 2)) * (m.one_in(2) ? call("cos", x) : term(1));
  const bool is_odd = m.one_in(3);
  integral_case c{is_odd ? even * call("sin", x) : even, -b, b, few_digits(m)};
  if (is_odd) {
    c.value = 0;
  } else {
    c.parts = {{even, 0, b, c.digits, quadrature_rule::automatic, 2}};
  }
  return c;
}

/// Over whole periods, from anywhere.
integral_case periodic(maker& m) {
  const long k = m.between(1, 3);
  const term t = k * x;
  const term a = m.one_in(3) ? term(0) : m.near(m.within(-3, 3));
  const long turns = m.between(1, 3);
  const term period = turns * (2 * term("pi"));
  term f = 0;
  switch (m.between(0, 4)) {
    case 0:
      f = 1 / (m.between(2, 5) + call("cos", t));
      break;
    case 1:
      f = call("exp", m.rational_near(m.within(0.3, 3)) * call("sin", t));
      break;
    case 2:
      f = call("sqrt", 1 + m.positive_rational() * power(call("sin", t), 2));
      break;
    case 3:
      f = call("cos", call("sin", t)) * call("exp", call("cos", t));
      break;
    default:
      f = power(call("cos", t), 2 * m.between(1, 12));
  }
  integral_case c{f, a, a + period, few_digits(m)};
  const term other = m.near(m.within(-3, 3));
  c.parts = {{f, other, other + 2 * term("pi"), c.digits, quadrature_rule::automatic, turns}};
  return c;
}

/// Of so many periods that one of them stands for all.
integral_case many_periods(maker& m) {
  const term k = m.one_in(3) ? m.positive_rational() * term("pi") : m.positive_rational();
  const term t = k * x;
  const term a = m.one_in(3) ? term(0) : m.near(m.within(-3, 3));
  const term length = m.one_in(2) ? m.near(m.within(300, 2000)) : m.decimal(m.scattered(1e3, 1e12));
  switch (m.between(0, 4)) {
    case 0:
      return {1 / (m.between(2, 5) + call("cos", t)), a, a + length, few_digits(m)};
    case 1:
      return {call("exp", call("sin", t)) * call("cos", m.between(2, 3) * t), a, a + length,
              few_digits(m)};
    case 2:
      return {call("abs", call("sin", t)), a, a + length, few_digits(m)};
    case 3: {  // its antiderivative is known
      integral_case c{1 + call("sin", t), a, a + length, few_digits(m)};
      c.antiderivative = x - call("cos", t) / k;
      return c;
    }
    default:
      return {power(call("sin", t), m.between(2, 6)), a, a + length, few_digits(m)};
  }
}

/// 1 + cos(k x + pi j), which touches 0 at multiples of pi/k, under abs, max and min; sometimes
/// with a factor that changes its sign there.
integral_case touching(maker& m) {
  const term k = m.quotient(m.within(0.4, 4));
  const term turn = k * x + term("pi") * term(m.one_in(2) ? "1" : "0");
  const term inner = 1 + call("cos", turn);
  const term a = m.rational_near(m.within(-4, 4));
  const term length = m.rational_near(m.scattered(0.5, 8));
  if (m.one_in(4)) return {call("abs", call("sin", turn) * inner), a, a + length, few_digits(m)};
  term f = inner;
  switch (m.between(0, 2)) {
    case 0:
      f = call("abs", inner);
      break;
    case 1:
      f = call("max", inner, term(0));
      break;
    default:
      f = inner + call("min", inner, term(0));
  }
  integral_case c{f, a, a + length, few_digits(m)};
  c.antiderivative = x + call("sin", turn) / k;
  return c;
}

}  // namespace

std::vector<integral_family> shape_families() {
  return {{"oscillation", 7, mostly_cheap(oscillation)},
          {"oscillating tail", 5, mostly_cheap(oscillating_tail)},
          {"removable singularity", 10, mostly_cheap(removable)},
          {"kinks and steps", 7, mostly_cheap(kinks)},
          {"pieces to infinity", 10, mostly_cheap(pieces_to_infinity)},
          {"steps to infinity", 6, steps_to_infinity},
          {"kinks of a high order", 10, mostly_cheap(high_kink)},
          {"touching 0 at multiples of pi", 6, mostly_cheap(touching)},
          {"divergent at a kink of a high order", 5, mostly_cheap(high_kink_that_diverges)},
          {"pole just outside", 10, mostly_cheap(pole_outside)},
          {"complex poles near", 7, mostly_cheap(pole_beside)},
          {"nested functions", 5, mostly_cheap(nested)},
          {"symmetric", 7, mostly_cheap(symmetric)},
          {"periodic", 7, mostly_cheap(periodic)},
          {"many periods", 5, mostly_cheap(many_periods)}};
}

}  // namespace polhode::differential
