// Integrals of sines and cosines of polynomials, to infinity and over long ranges, and of sums of
// exponentials times powers.

#include <algorithm>

#include "integrals.hpp"

namespace polhode::differential {
namespace {

const term x = "x";

long few_digits(maker& m) { return m.one_in(3) ? m.between(2, 10) : m.between(11, 25); }

/// Of this degree, with a positive leading coefficient.
term phase(maker& m, long degree) {
  term result = m.one_in(4) ? m.near(m.scattered(0.2, 4)) * power(x, degree)
                            : m.rational_near(m.scattered(0.2, 4)) * power(x, degree);
  for (long k = degree - 1; k >= 0; --k) {
    if (m.one_in(2)) result = result + m.rational_near(m.within(-5, 5)) * power(x, k);
  }
  return result;
}

/// That tends to 0 like a power of x, without singular points beyond `from` > 0.
term decaying(maker& m) {
  const term c = m.rational_near(m.scattered(0.1, 5));
  switch (m.between(0, 10)) {
    case 0:
      return 1 / (x + c);
    case 8: {  // three poles, of which two may lie to the right of 0
      const auto positive = [&] { return m.rational_near(m.scattered(0.05, 5)); };
      return 1 / (power(x, 3) + positive() * power(x, 2) + positive() * x + c);
    }
    case 9:  // the roots of what is under the root: real, or conjugate
      return 1 / call("sqrt", power(x, 2) + m.rational_near(m.scattered(0.1, 5)) * x + c);
    case 10:
      return call("log", x + c) / (x + m.rational_near(m.scattered(0.1, 3)));
    case 7:  // poles beside the axis
      return 1 / (power(x - m.rational_near(m.within(0, 8)), 2) + c);
    case 1:
      return power(x + c, -m.between(2, 4));
    case 2:
      return x / (power(x, 2) + c);
    case 3:
      return (x - c) / (power(x, 2) + x + c);
    case 4:
      return power(x, -m.between(1, 3));
    case 5:
      return 1 / call("sqrt", x);
    default:
      return power(x, -m.quotient(m.within(0.2, 2.5)));
  }
}

term wave(maker& m, const term& phase) { return call(m.any_of({"sin", "cos"}), phase); }

/// The derivative of what tends to 0.
integral_case to_infinity(maker& m) {
  const term f = decaying(m) * wave(m, phase(m, m.between(1, 4)));
  const term from = m.near(m.scattered(0.1, 10));
  integral_case c{derivative(f), from, "inf", few_digits(m)};
  c.value = -substituted(f, "x", from);
  c.is_cheap = true;
  return c;
}

/// P(x) + Q(x) log(c x), where Q is not 0, and often of the greatest degree.
term phase_with_logarithm(maker& m) {
  const long degree = m.between(0, 2);
  const term scale = m.one_in(3) ? m.rational_near(m.scattered(0.2, 5)) : term(1);
  const term logarithm = m.one_in(4) ? -call("log", scale / x) : call("log", scale * x);
  term result = (m.one_in(3) ? m.near(m.scattered(0.2, 4)) : m.rational_near(m.scattered(0.2, 4))) *
                power(x, degree) * logarithm;
  if (degree > 0 && m.one_in(3)) result = result + m.rational_near(m.within(-3, 3)) * logarithm;
  const long other = std::max(1L, m.one_in(2) ? degree : m.between(1, 3));
  result = result + m.rational_near(m.within(-4, 4)) * power(x, other);
  if (degree == 0) result = result + m.rational_near(m.scattered(0.2, 4)) * power(x, 3);
  return m.one_in(3) ? -result : result;
}

/// The same with logarithms in the phase; or from 0 on, in 1/x.
integral_case to_infinity_with_logarithms(maker& m) {
  const term f = decaying(m) * wave(m, phase_with_logarithm(m));
  const term from = m.near(m.scattered(0.2, 8));
  integral_case c{derivative(f), from, "inf", few_digits(m)};
  c.value = -substituted(f, "x", from);
  if (m.one_in(4)) {
    const term in_reciprocal = substituted(f, "x", 1 / x);
    const term to = m.near(m.scattered(0.1, 5));
    c = {derivative(in_reciprocal), 0, to, few_digits(m)};
    c.value = substituted(in_reciprocal, "x", to);
  }
  return c;
}

/// The derivative of what does not tend to 0.
integral_case divergent_with_logarithms(maker& m) {
  const term size = m.any_of<term>({1, call("log", x + 1), x / (x + 1), call("sqrt", x)});
  integral_case c{derivative(size * wave(m, phase_with_logarithm(m))), m.near(m.scattered(0.2, 8)),
                  "inf", few_digits(m)};
  c.diverges = true;
  c.is_cheap = true;
  return c;
}

/// A logarithm of what is above 1 beyond `from` > 0.
term logarithm_above_0(maker& m) {
  const term c = m.rational_near(m.scattered(0.1, 5));
  return m.one_in(2) ? call("log", c * x + m.between(1, 3)) : call("log", power(x, 2) + c * x + 1);
}
term irrational_below_1(maker& m) { return 1 / (1 + m.irrational()); }

/// With divisors that are logarithms, or irrational powers, of an amplitude that tends to 0.
integral_case slow_oscillations(maker& m) {
  const term c = m.rational_near(m.scattered(0.1, 5));
  const term e = irrational_below_1(m);
  const long n = m.between(1, 2);
  const term amplitude =
      m.any_of<term>({power(logarithm_above_0(m), -m.between(1, 3)), power(x, -e), power(x + c, -e),
                      power(power(x, 2) + c, -e), call("log", x + 1) * power(x, -e),
                      logarithm_above_0(m) / ((x + c) * logarithm_above_0(m)),
                      x / ((x + c) * logarithm_above_0(m)), power(x, -e) / logarithm_above_0(m)});
  const term f = amplitude * wave(m, phase(m, n));
  const term from = m.near(m.scattered(0.2, 8));
  integral_case result{derivative(f), from, "inf", few_digits(m)};
  result.value = -substituted(f, "x", from);
  return result;
}
/// Of an amplitude that does not.
integral_case divergent_slow_oscillations(maker& m) {
  const term e = irrational_below_1(m);
  const term amplitude = m.any_of<term>({logarithm_above_0(m) / logarithm_above_0(m), power(x, e),
                                         power(x, e) / logarithm_above_0(m), power(x / (x + 1), e),
                                         power(logarithm_above_0(m), 2) / logarithm_above_0(m),
                                         power(x, e) * power(x + 1, -e)});
  integral_case c{derivative(amplitude * wave(m, phase(m, m.between(1, 2)))),
                  m.near(m.scattered(0.2, 8)), "inf", few_digits(m)};
  c.diverges = true;
  c.is_cheap = true;
  return c;
}

/// Squares and products: two phases, and parts that do not oscillate.
integral_case products(maker& m) {
  const term f = decaying(m) * wave(m, phase(m, m.between(1, 3))) *
                 (m.one_in(2) ? wave(m, phase(m, m.between(1, 3))) : 1 + wave(m, phase(m, 2)));
  const term from = m.near(m.scattered(0.2, 5));
  integral_case c{derivative(f), from, "inf", few_digits(m)};
  c.value = -substituted(f, "x", from);
  c.is_cheap = true;
  return c;
}

/// -c_1 x - ... - c_degree x^degree, with no c_j < 0, some of them 0; with one c_j < 0 where it
/// grows.
term size_of_decay(maker& m, long degree, bool grows) {
  term result = 0;
  const long last = m.between(1, degree);
  for (long k = 1; k <= last; ++k) {
    const term c =
        m.one_in(3) ? m.near(m.scattered(0.05, 3)) : m.rational_near(m.scattered(0.05, 3));
    if (grows && k == last) {
      result = result + c * power(x, k);
    } else if (k == last || m.one_in(2)) {
      result = result - c * power(x, k);
    }
  }
  return result;
}

/// The same with a factor that decays exponentially beside any other, and slow or fast turns.
integral_case to_infinity_with_decay(maker& m) {
  const long n = m.between(1, 3);
  const term size = call("exp", size_of_decay(m, n, false));
  const term other = m.one_in(2) ? decaying(m) : power(x, m.between(0, 4));
  term turning = phase(m, n);
  if (m.one_in(3)) turning = m.rational_near(m.scattered(100, 1e5)) * turning;
  const term f = size * other * wave(m, turning);
  const term from = m.near(m.scattered(0.1, 10));
  integral_case c{derivative(f), from, "inf", few_digits(m)};
  c.value = -substituted(f, "x", from);
  c.is_cheap = true;
  return c;
}

/// With a factor that grows exponentially.
integral_case divergent_by_growth(maker& m) {
  const long n = m.between(1, 3);
  const term f = call("exp", size_of_decay(m, n, true)) * decaying(m) * wave(m, phase(m, n));
  integral_case c{f, m.rational_near(m.scattered(0.5, 3)), "inf", few_digits(m)};
  c.diverges = true;
  c.is_cheap = true;
  return c;
}

/// Of a period, and not one that is a sum of sines and cosines; positive in the first three cases.
term periodic(maker& m, bool only_positive) {
  const term k =
      m.one_in(3) ? term("pi") * m.quotient(m.within(0.3, 3)) : m.quotient(m.within(0.3, 4));
  const term turn = wave(m, k * x + m.rational_near(m.within(-2, 2)));
  const term more = 1 + m.rational_near(m.scattered(0.05, 3));
  switch (m.between(0, only_positive ? 2 : 4)) {
    case 0:
      return 1 / (more + turn);
    case 1:
      return call("exp", m.rational_near(m.within(-2, 2)) * turn);
    case 2:
      return call("sqrt", more + turn * turn);
    case 3:
      return call("atan", m.rational_near(m.within(-3, 3)) * turn) * turn;
    default:
      return call("log", more + turn);
  }
}

/// That decays faster than 1/x, a rational function times a power.
term decaying_fast(maker& m) {
  const auto positive = [&] { return m.rational_near(m.scattered(0.05, 5)); };
  switch (m.between(0, 4)) {
    case 0:
      return power(x, -m.between(2, 6));
    case 1:
      return power(x + positive(), -m.between(2, 4));
    case 2:
      return 1 / (power(x, 2) + positive() * x + positive());
    case 3:
      return (x + positive()) / (power(x, 3) + positive());
    default:
      return power(x, -(1 + m.quotient(m.within(0.2, 3))));
  }
}

/// The derivative of a function of a period times what decays.
integral_case periodic_tails(maker& m) {
  const term f = decaying_fast(m) * periodic(m, false);
  const term from = m.near(m.scattered(0.3, 10));
  integral_case c{derivative(f), from, "inf", few_digits(m)};
  c.value = -substituted(f, "x", from);
  c.is_cheap = true;
  return c;
}

/// The same with a factor that decays like 1/x or slower.
integral_case divergent_periodic_tails(maker& m) {
  const term factor = periodic(m, true);
  const term slow = m.one_in(2) ? 1 / (x + m.rational_near(m.scattered(0.05, 5)))
                                : power(x, -m.quotient(m.within(0.1, 1)));
  integral_case c{factor * slow, m.rational_near(m.scattered(0.5, 3)), "inf", few_digits(m)};
  c.diverges = true;
  c.is_cheap = true;
  return c;
}

/// A power of a polynomial in x with periodic coefficients; the polynomial may vanish somewhere.
term moving_power(maker& m) {
  const long degree = m.between(1, 3);
  const term leading = m.one_in(3) ? periodic(m, true) : m.rational_near(m.scattered(0.5, 3));
  term base = leading * power(x, degree);
  for (long k = degree - 1; k >= (m.one_in(4) ? -1 : 0); --k) {
    if (k < degree - 1 && m.one_in(2)) continue;
    const term turn = wave(m, m.one_in(2) ? x : 2 * x);
    base =
        base + m.rational_near(m.within(-2, 2)) * (m.one_in(3) ? turn * turn : turn) * power(x, k);
  }
  const term exponent = m.one_in(2)   ? term(m.between(1, 3))
                        : m.one_in(3) ? m.quotient(m.within(0.3, 3))
                                      : term(m.between(1, 3)) / 2;
  return power(base, -exponent);
}

/// The derivative of such a power, perhaps times what has a period.
integral_case moving_periodic_tails(maker& m) {
  const term f = (m.one_in(2) ? wave(m, x) : term(1)) * moving_power(m) *
                 (m.one_in(4) ? power(x, -m.between(1, 2)) : term(1));
  const term from = m.near(m.scattered(1.5, 20));
  integral_case c{derivative(f), from, "inf", m.between(2, 18)};
  c.value = -substituted(f, "x", from);
  c.is_cheap = m.one_in(2);
  return c;
}

/// Of another mean than 0, over about x: sines squared, and what is positive.
integral_case divergent_moving_tails(maker& m) {
  const term turn = wave(m, x);
  const term above = m.one_in(2) ? turn * turn : m.rational_near(m.scattered(0.3, 2)) + turn / 4;
  const term below =
      x + m.rational_near(m.within(1, 3)) + wave(m, x) * m.rational_near(m.within(-1, 1));
  integral_case c{above / (m.one_in(3) ? power(below, m.quotient(m.within(0.2, 1))) : below),
                  m.rational_near(m.scattered(0.5, 3)), "inf", few_digits(m)};
  c.diverges = true;
  c.is_cheap = true;
  return c;
}

/// A function of a period with logarithmic poles or roots of zeros, times what decays
/// exponentially; or, for the twin, does not, or has poles that are not integrable.
term with_periodic_poles(maker& m, bool converges) {
  const term k = m.one_in(3) ? term(1) : m.quotient(m.within(0.5, 3));
  const term turn = call("abs", wave(m, k * x));
  const term factor = m.one_in(2)   ? call("log", turn)
                      : m.one_in(2) ? power(turn, m.quotient(m.within(0.2, 0.9)))
                                    : power(turn, -m.quotient(m.within(0.1, 0.5)));
  const term rate = m.rational_near(m.scattered(0.3, 3));
  const term size = m.one_in(3) ? power(x, m.between(1, 2)) : term(1);
  if (converges) return factor * size * call("exp", m.one_in(4) ? -rate * x * x : -rate * x);
  if (m.one_in(2)) return factor * size * call("exp", rate * x);
  return power(turn, -m.between(1, 2)) * call("exp", -rate * x);
}
integral_case periodic_poles(maker& m) {
  const term f = with_periodic_poles(m, true);
  const term from = m.rational_near(m.scattered(0.2, 4));
  const term cut = from + m.rational_near(m.scattered(0.5, 8));
  const long digits = m.between(2, 12);
  integral_case c{f, from, "inf", digits};
  c.parts = {{f, from, cut, digits}, {f, cut, "inf", digits}};
  return c;
}
integral_case divergent_periodic_poles(maker& m) {
  integral_case c{with_periodic_poles(m, false), m.rational_near(m.scattered(0.5, 3)), "inf",
                  few_digits(m)};
  c.diverges = true;
  c.is_cheap = true;
  return c;
}

/// A polynomial in the fractional part of k x, with the mean 0 or another one, times what decays.
integral_case sawtooths(maker& m, bool converges) {
  const term k = m.one_in(2) ? term(m.between(1, 3)) : m.quotient(m.within(0.2, 3));
  const term part = k * x - call("floor", k * x);
  const long n = m.between(1, 3);
  const term mean = term(1) / term(n + 1);
  const term off = converges ? term(0) : m.rational_near(m.scattered(1e-6, 1));
  const auto positive = [&] { return m.rational_near(m.scattered(0.05, 5)); };
  term slow = 1 / (x + positive());
  if (m.one_in(3)) slow = power(x, -m.quotient(m.within(0.2, 1)));
  if (m.one_in(3)) slow = (x + positive()) / (power(x, 2) + positive());
  const term f = (power(part, n) - mean + off) * slow;
  const term from = m.near(m.scattered(0.3, 10));
  integral_case c{f, from, "inf", few_digits(m)};
  if (!converges) {
    c.diverges = true;
    c.is_cheap = true;
    return c;
  }
  const term cut = from + m.rational_near(m.scattered(0.5, 30));
  c.parts = {{f, from, cut, c.digits}, {f, cut, "inf", c.digits}};
  return c;
}
integral_case sawtooths_of_mean_zero(maker& m) { return sawtooths(m, true); }
integral_case sawtooths_of_another_mean(maker& m) { return sawtooths(m, false); }

/// x^n floor(q/x) from 0 to q, which is q^(n+1) zeta(n+1)/(n+1), and the like; or |wave(q/x)| times
/// x^n from 0 on, or up to 0.
integral_case steps_of_reciprocals(maker& m) {
  const long n = m.between(1, 4);
  const term q = m.rational_near(m.scattered(0.1, 10));
  if (m.one_in(2)) {
    const term unit = power(q, n + 1) / (n + 1);
    const term all = q * power(q, n) / n;  // the integral of x^n q/x
    const term zeta_part = unit * call("zeta", n + 1);
    const auto of = [&](const term& step) { return power(x, n) * step; };
    integral_case c{of(call("floor", q / x)), 0, q, few_digits(m)};
    c.value = zeta_part;
    if (m.one_in(3)) {
      c.integrand = of(call("ceil", q / x));
      c.value = zeta_part + unit;
    } else if (m.one_in(2)) {
      c.integrand = of(q / x - call("floor", q / x));
      c.value = all - zeta_part;
    }
    return c;
  }
  const term turn = wave(m, (m.one_in(3) ? term("pi") * q : q) / x);
  const term f =
      power(x, n - 1) *
      (m.one_in(3) ? call("max", turn, m.rational_near(m.within(-1, 1))) : call("abs", turn));
  const term to = m.near(m.scattered(0.1, 5));
  const bool left = m.one_in(3);
  integral_case c{f, left ? -to : term(0), left ? term(0) : to, few_digits(m)};
  const term cut = left ? -to / m.between(2, 5) : to / m.between(2, 5);
  c.parts = {{f, c.from, cut, c.digits}, {f, cut, c.to, c.digits}};
  return c;
}

/// The same with too few powers of x.
integral_case divergent_steps_of_reciprocals(maker& m) {
  const term q = m.rational_near(m.scattered(0.1, 10));
  const term step = m.one_in(2) ? call("floor", q / x) : call("abs", wave(m, q / x)) / x;
  const term f = m.one_in(2) ? step : step * power(x, -m.quotient(m.within(0.1, 1)));
  integral_case c{f, 0, m.rational_near(m.scattered(0.5, 3)), few_digits(m)};
  c.diverges = true;
  c.is_cheap = true;
  return c;
}

/// cos(c tan(x)) from 0 over n quarters of its turns, which is n (pi/2) e^-c; or a wave of c tan(x)
/// times a bounded function, over a range with poles of the tangent.
integral_case waves_of_tangents(maker& m) {
  const term c = m.rational_near(m.scattered(0.1, 4));
  const term tangent = c * call("tan", x);
  const long n = m.any_of({1L, 2L, 3L, 4L, 5L});
  const auto quarters = [](long k) { return term("pi") * k / 2; };
  if (m.one_in(2)) {
    integral_case result{call("cos", tangent), 0, quarters(n), few_digits(m)};
    result.value = quarters(n) * call("exp", -c);
    return result;
  }
  const term other = m.any_of<term>(
      {call("exp", -x), x, call("sin", x), power(call("cos", x), 2), 1 / (power(x, 2) + 1)});
  const term f = wave(m, tangent) * other;
  const term from = m.one_in(2) ? quarters(-1) : m.rational_near(m.within(-1.5, 1.5));
  const term to =
      m.one_in(2) ? quarters(n) + quarters(m.between(0, 1)) : m.rational_near(m.within(1.6, 6));
  integral_case result{f, from, to, few_digits(m)};
  const term cut = m.rational_near(m.within(1.51, 1.56));
  result.parts = {{f, from, cut, result.digits}, {f, cut, to, result.digits}};
  return result;
}

/// The same with a factor that makes it an integral of cos(c u) du or worse.
integral_case divergent_waves_of_tangents(maker& m) {
  const term f = wave(m, m.rational_near(m.scattered(0.1, 4)) * call("tan", x)) *
                 power(call("cos", x), -m.between(2, 4));
  integral_case result{f, m.rational_near(m.within(-1.5, 1.5)), term("pi") / 2, few_digits(m)};
  result.diverges = true;
  result.is_cheap = true;
  return result;
}

/// x^m cos(phi) with m >= n - 1: the integral over each half turn does not tend to 0.
integral_case divergent(maker& m) {
  const long n = m.between(1, 4);
  const term e = n - 1 + (m.one_in(2) ? m.between(0, 2) : m.quotient(m.within(0, 1)));
  integral_case c{power(x, e) * wave(m, phase(m, n)), m.rational_near(m.scattered(0.5, 3)), "inf",
                  few_digits(m)};
  c.diverges = true;
  c.is_cheap = true;
  return c;
}

/// Over some thousand turns and more, with an amplitude of any growth.
integral_case many_turns(maker& m) {
  const long n = m.between(1, 3);
  const term growing = m.any_of({term(1), x, power(x, 2), call("sqrt", x), power(x, term("1/3"))});
  const term f = (m.one_in(2) ? growing : decaying(m)) * wave(m, phase(m, n));
  const double least = n == 1 ? 2e4 : (n == 2 ? 300 : 50);
  const term from = m.one_in(4) && !m.one_in(3) ? m.rational_near(m.scattered(0.01, 1))
                                                : m.rational_near(m.scattered(0.5, 20));
  integral_case c{derivative(f), from, from + m.rational_near(m.scattered(least, 10 * least)),
                  m.between(5, 20)};
  c.antiderivative = f;
  c.is_cheap = true;
  return c;
}

/// exp(k x + v), with a long or an irrational slope, or a power of a number.
term growing_exponential(maker& m) {
  if (m.one_in(5)) return power(m.any_of({term(2), term("3/2"), term("pi")}), x);
  const term k = m.one_in(4) ? m.near(m.scattered(0.3, 2)) : m.quotient(m.within(0.3, 2));
  return call("exp", m.one_in(2) ? k * x : k * x + m.rational_near(m.within(-2, 2)));
}

/// The derivative of what tends to 0 and oscillates, of an exponential; the other way round too.
integral_case in_exponentials(maker& m) {
  const term u = growing_exponential(m);
  const term outward = substituted(decaying(m) * wave(m, phase(m, m.between(1, 3))), "x", u);
  const term from = m.near(m.within(-0.5, 2));
  const term f = derivative(outward);
  integral_case c{f, from, "inf", few_digits(m)};
  c.value = -substituted(outward, "x", from);
  if (m.one_in(3)) {
    c.integrand = substituted(f, "x", -x);
    c.from = "-inf";
    c.to = -from;
  }
  c.is_cheap = true;
  return c;
}

/// x^m cos(phi) dx with m >= n - 1, in an exponential.
integral_case divergent_in_exponentials(maker& m) {
  const long n = m.between(1, 3);
  const term e = n - 1 + (m.one_in(2) ? m.between(0, 2) : m.quotient(m.within(0, 1)));
  const term f = power(x, e) * wave(m, phase(m, n)) * x;
  integral_case c{substituted(f, "x", growing_exponential(m)), m.rational_near(m.within(-1, 2)),
                  "inf", few_digits(m)};
  c.diverges = true;
  c.is_cheap = true;
  return c;
}

/// Over so long a range that the exponential turns some thousand times and more.
integral_case many_turns_in_exponentials(maker& m) {
  const long n = m.between(1, 3);
  const double k = m.within(0.5, 2);
  const term u = call("exp", m.rational_near(k) * x);
  const term growing = m.any_of({term(1), x, power(x, 2), call("sqrt", x)});
  const term f = substituted((m.one_in(2) ? growing : decaying(m)) * wave(m, phase(m, n)), "x", u);
  const double far = m.within(11, 18) / (k * static_cast<double>(n));
  integral_case c{derivative(f), m.rational_near(m.within(-0.5, 2)), m.rational_near(far),
                  m.between(5, 20)};
  c.antiderivative = f;
  c.is_cheap = true;
  return c;
}

integral_case exponential_polynomials(maker& m) {
  const auto linear = [&] {
    const term slope = m.coefficient();
    return m.one_in(3) ? slope * x + m.near(m.within(-2, 2)) : slope * x;
  };
  const auto factor = [&]() -> term {
    switch (m.between(0, 5)) {
      case 0:
        return call("exp", linear());
      case 1:
        return power(x, m.between(1, 6));
      case 2:
        return call(m.any_of({"sinh", "cosh", "expm1"}), m.rational_near(m.within(-3, 3)) * x);
      case 3:
        return call(m.any_of({"sinpi", "cospi"}), m.rational_near(m.within(-3, 3)) * x);
      default:
        return wave(m, linear());
    }
  };
  term f = factor();
  for (long k = m.between(0, 2); k > 0; --k) f = m.one_in(3) ? f + factor() : f * factor();
  if (m.one_in(5)) f = power(f, m.between(2, 3));
  const auto [a, b] = m.range(-3, 3);
  return {f, a, b, few_digits(m)};
}

/// A sum of products of exponentials, sines and cosines over a power of x that is bounded at 0; or,
/// for the twin, not, or that does not converge at infinity.
term over_power(maker& m, bool diverges) {
  const auto number = [&] {
    return m.one_in(5) ? call("sqrt", m.rational_near(m.scattered(0.3, 6)))
                       : m.rational_near(m.scattered(0.2, 5));
  };
  // 1 + O(x).
  const auto decaying_or_wave = [&](const term& at) -> term {
    switch (m.between(0, 2)) {
      case 0:
        return call("exp", -(at * x));
      case 1:
        return call("cos", at * x);
      default:
        return call("exp", -(at * x)) * call("cos", number() * x);
    }
  };
  const long extra = diverges ? m.between(1, 2) : 0;
  switch (m.between(0, 4)) {
    case 0: {  // sines over as many powers
      const long count = m.between(1, 5);
      term f = call("sin", number() * x);
      for (long k = 1; k < count; ++k) f = f * call("sin", number() * x);
      if (m.one_in(3)) f = f * decaying_or_wave(number());
      return f / power(x, count + extra);
    }
    case 1:  // Frullani; the difference is x or x^2 at least, and not 0
      return (decaying_or_wave(number()) - decaying_or_wave(number() + 6)) /
             power(x, diverges ? 3 : 1);
    case 2: {
      const term a = number();
      return (1 - call("cos", a * x)) / power(x, 2 + extra);
    }
    case 3: {
      const term a = number();
      return (call("sin", a * x) - a * x * call("cos", a * x)) / power(x, 3 + extra);
    }
    default: {  // no power, or 1/x beside one that is missed
      const term decay = call("exp", -(number() * x));
      if (diverges) return (decay + number()) / x;
      return power(x, m.between(0, 3)) * decay * wave(m, number() * x) +
             call("sin", number() * x) / x;
    }
  }
}

/// A factor that tends to 1 or -1, beside a sine or cosine; the same as that limit and the rest.
integral_case factor_with_limit(maker& m, bool converges) {
  const auto positive = [&] { return m.rational_near(m.scattered(0.3, 3)); };
  const term u = positive() * x + (m.one_in(2) ? term(0) : m.rational_near(m.within(-1, 1)));
  const term turning = call(m.one_in(2) ? "sin" : "cos", positive() * x);
  term slow = power(x, -m.quotient(m.within(0.2, 1.5)));
  if (!converges) slow = m.one_in(2) ? term(1) : power(x, m.quotient(m.within(0.2, 2)));
  const term from = m.near(m.scattered(2, 6));
  const term a = turning * slow;
  const auto [factor, rest] = [&]() -> std::pair<term, term> {
    switch (m.between(0, 3)) {
      case 0:
        return {call("tanh", u), -(2 / (call("exp", 2 * u) + 1))};
      case 1:
        return {1 / call("tanh", u), 2 / (call("exp", 2 * u) - 1)};
      case 2:
        return {call("erf", u), -call("erfc", u)};
      default:
        return {1 / (1 + call("exp", -u)), -(1 / (1 + call("exp", u)))};
    }
  }();
  const bool falls = m.one_in(3);
  integral_case c{(falls ? -factor : factor) * a, from, "inf", few_digits(m)};
  if (!converges) {
    c.diverges = true;
    c.is_cheap = true;
    return c;
  }
  const term sign = falls ? -term(1) : term(1);
  c.parts = {{sign * a, from, "inf", c.digits}, {sign * rest * a, from, "inf", c.digits}};
  return c;
}
integral_case factors_with_limits(maker& m) { return factor_with_limit(m, true); }
integral_case divergent_factors_with_limits(maker& m) { return factor_with_limit(m, false); }

integral_case over_half_line(maker& m) {
  const term f = over_power(m, false);
  integral_case c{f, 0, "inf", few_digits(m)};
  const term between = m.rational_near(m.scattered(0.3, 3));
  c.parts = {{f, 0, between, c.digits}, {f, between, "inf", c.digits}};
  c.is_cheap = true;
  return c;
}

integral_case divergent_over_half_line(maker& m) {
  integral_case c{over_power(m, true), 0, "inf", few_digits(m)};
  c.diverges = true;
  c.is_cheap = true;
  return c;
}

}  // namespace

std::vector<integral_family> oscillation_families() {
  return {
      {"oscillations to infinity", 10, to_infinity},
      {"oscillations that decay to infinity", 10, to_infinity_with_decay},
      {"oscillations with logarithms", 4, to_infinity_with_logarithms},
      {"oscillations with logarithms that do not converge", 6, divergent_with_logarithms},
      {"slow oscillations", 5, slow_oscillations},
      {"slow oscillations that do not converge", 6, divergent_slow_oscillations},
      {"oscillations that grow", 5, divergent_by_growth},
      {"products of oscillations", 6, products},
      {"periodic functions times what decays", 6, periodic_tails},
      {"periodic functions times what decays too slowly", 6, divergent_periodic_tails},
      {"powers of polynomials with periodic coefficients", 6, moving_periodic_tails},
      {"powers of such polynomials that do not converge", 6, divergent_moving_tails},
      {"periodic poles beside exponentials", 6, periodic_poles},
      {"periodic poles that do not converge", 6, divergent_periodic_poles},
      {"sawtooths of mean 0", 6, sawtooths_of_mean_zero},
      {"sawtooths of another mean", 6, sawtooths_of_another_mean},
      {"steps of reciprocals", 6, steps_of_reciprocals},
      {"steps of reciprocals that do not converge", 6, divergent_steps_of_reciprocals},
      {"waves of tangents", 6, waves_of_tangents},
      {"waves of tangents that do not converge", 6, divergent_waves_of_tangents},
      {"factors with limits", 6, factors_with_limits},
      {"factors with limits that do not converge", 6, divergent_factors_with_limits},
      {"oscillations that do not converge", 10, divergent},
      {"many turns", 8, many_turns},
      {"oscillations of exponentials", 6, in_exponentials},
      {"oscillations of exponentials that do not converge", 6, divergent_in_exponentials},
      {"many turns of exponentials", 5, many_turns_in_exponentials},
      {"exponential polynomials", 30, exponential_polynomials},
      {"half-lines in closed form", 20, over_half_line},
      {"half-lines that do not converge", 20, divergent_over_half_line},
  };
}

}  // namespace polhode::differential
