// Functions whose logarithmic derivative is rational, in x, in e^(kx) or in sin and cos of kx, and
// high powers of them.

#include "integrals.hpp"

namespace polhode::differential {
namespace {

const term x = "x";

long usual_digits(maker& m) {
  if (m.one_in(12)) return m.between(60, 200);
  return m.one_in(3) ? m.between(2, 12) : m.between(13, 30);
}

integral_case over(maker& m, const term& f, const std::pair<term, term>& range) {
  return {f, range.first, range.second, usual_digits(m)};
}

/// A range inside [low, high]: of any length, often a very short one.
std::pair<term, term> some_range(maker& m, double low, double high) {
  return m.one_in(4) ? m.narrow_range(low + 0.01 * (high - low), high - 0.01 * (high - low))
                     : m.range(low, high);
}

/// A product of powers that is positive for x > 0, times e^(a polynomial).
term hyperexponential(maker& m, long most_exponent) {
  term f = m.one_in(2) ? m.coefficient() : term(1);
  if (m.one_in(2)) f = f * power(x, m.broken_exponent(6));
  for (long k = m.between(1, 2); k > 0; --k) {
    f = f * power(m.positive_polynomial(false), m.broken_exponent(most_exponent));
  }
  if (m.one_in(2)) f = f * call("exp", m.polynomial(m.between(1, 3)));
  return f;
}

integral_case hyperexponential_case(maker& m) {
  return over(m, hyperexponential(m, 12), some_range(m, 0.01, 6));
}

integral_case sum_case(maker& m) {
  const term f = hyperexponential(m, 8);
  const term g = hyperexponential(m, 8);
  integral_case c = over(m, f + g, some_range(m, 0.01, 5));
  c.parts = {{f, c.from, c.to, c.digits + 3}, {g, c.from, c.to, c.digits + 3}};
  return c;
}

integral_case steep_case(maker& m) {
  const term base = m.one_in(2) ? m.positive_polynomial(true)
                                : m.positive_polynomial(false) * m.positive_polynomial(true);
  term f = power(base, m.one_in(2) ? m.exponent(2000) : m.broken_exponent(2000));
  if (m.one_in(2)) f = f * hyperexponential(m, 3);
  return over(m, f, some_range(m, 0.05, 4));
}

/// (a + b e^(kx))^n e^(mx) and its kin.
term in_exponentials(maker& m, long most_exponent) {
  const term k = m.one_in(2) ? term(1) : m.quotient(m.within(0.5, 4));
  const term arguments = m.one_in(2) ? k * x : -(k * x);
  const term y = call("exp", arguments);
  term f = power(m.one_in(2) ? 1 + y : m.positive_rational() + m.positive_rational() * y,
                 m.exponent(most_exponent));
  if (m.one_in(2)) f = f * y;
  if (m.one_in(3)) f = f * power(1 + power(y, 2), m.broken_exponent(std::min(most_exponent, 40L)));
  if (m.one_in(4)) f = f * m.coefficient();
  return f;
}

integral_case exponential_case(maker& m) {
  return over(m, in_exponentials(m, 6), some_range(m, -3, 3));
}
integral_case steep_exponential_case(maker& m) {
  return over(m, in_exponentials(m, 2000), some_range(m, -2, 2));
}

/// Products and powers of sines and cosines.
term in_sines(maker& m, long most_exponent) {
  const term t = m.one_in(3) ? m.quotient(m.within(0.5, 4)) * x : x;
  const term s = call("sin", t);
  const term c = call("cos", t);
  const auto up_to = [&](long most) {
    return term(static_cast<long>(std::round(m.scattered(1, static_cast<double>(most)))));
  };
  switch (m.between(0, 5)) {
    case 0:
      return power(s, up_to(most_exponent)) * power(c, up_to(most_exponent));
    case 1:
      return s * c *
             power(m.positive_rational() + power(m.one_in(2) ? s : c, 2),
                   m.exponent(most_exponent));
    case 2:
      return power(1 + power(c, 2), m.broken_exponent(most_exponent));
    case 3:
      return power(m.between(2, 6) + (m.one_in(2) ? c : s), m.broken_exponent(most_exponent));
    case 4:
      return power(1 + m.positive_rational() * power(s, 2), m.broken_exponent(most_exponent)) *
             power(c, m.between(0, 4));
    default:
      return power(s, up_to(most_exponent)) / (m.positive_rational() + power(c, 2));
  }
}

integral_case sine_case(maker& m) { return over(m, in_sines(m, 8), some_range(m, 0.05, 6)); }
integral_case steep_sine_case(maker& m) {
  return over(m, in_sines(m, 1500), some_range(m, 0.05, 3));
}

/// With a cosine or sine of a polynomial as a factor.
integral_case with_cosine_case(maker& m) {
  const term f =
      hyperexponential(m, 4) * call(m.one_in(2) ? "cos" : "sin", m.polynomial(m.between(1, 2)));
  return over(m, f, some_range(m, 0.05, 5));
}

/// Ends at, or very near, a root of what is in the denominator or under the root. What diverges is
/// a family of its own.
integral_case irrational_root_case(maker& m) {
  const long n = m.between(2, 40);
  const bool cubic = m.one_in(2);
  const term base = n - power(x, cubic ? 3 : 2);
  const term root = call(cubic ? "cbrt" : "sqrt", n);
  const term near_root = m.one_in(2) ? root : root - m.decimal(m.scattered(1e-40, 0.5));
  const bool at_root = near_root.is_leaf() || near_root.head() != "-";
  const term e = at_root ? m.exponent_between(-0.95, 4) : m.exponent_between(-4, 4);
  term f = power(base, e);
  if (m.one_in(2)) f = f * call("exp", -(m.positive_rational() * power(x, m.between(1, 2))));
  if (m.one_in(4)) f = f + m.positive_rational() / (1 + call("exp", x));
  return {f, m.one_in(2) ? term(0) : m.near(m.within(0.1, 1.2)), near_root, usual_digits(m)};
}

/// Narrow to the last, with a smooth part and one of very different size.
integral_case very_narrow_case(maker& m) {
  const term a = m.near(m.scattered(0.1, 10));
  const double size = m.one_in(2) ? m.scattered(1e-18, 1e-12) : m.scattered(1e-60, 1e-2);
  term f = m.one_in(2) ? in_exponentials(m, 4) : hyperexponential(m, 4);
  if (m.one_in(2)) f = f + m.decimal(m.scattered(1e-300, 1e-3)) * x;
  return {f, a, a + m.decimal(size), m.one_in(3) ? m.between(60, 300) : usual_digits(m)};
}

}  // namespace

std::vector<integral_family> steep_families() {
  return {{"hyperexponential", 120, hyperexponential_case},
          {"sums of hyperexponential", 60, sum_case},
          {"steep powers", 120, steep_case},
          {"rational in exp", 100, exponential_case},
          {"steep in exp", 120, steep_exponential_case},
          {"sines and cosines", 100, sine_case},
          {"steep in sines", 120, steep_sine_case},
          {"times a cosine", 60, with_cosine_case},
          {"ends at irrational roots", 24, irrational_root_case},
          {"very narrow ranges", 80, very_narrow_case}};
}

}  // namespace polhode::differential
