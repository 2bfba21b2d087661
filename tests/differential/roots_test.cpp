// Roots: products of factors whose roots are known, of which all and only those must be found, each
// with its multiplicity; and functions whose roots are not known, searched whole, in parts,
// mirrored and moved.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "maker.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/roots/complex_roots.hpp"
#include "polhode/roots/isolate.hpp"
#include "tally.hpp"
#include "term.hpp"

namespace polhode::differential {
namespace roots_test {

const term x = "x";

struct root_case {
  term f = 0;
  term from = 0;
  term to = 0;
};

std::string command_of(const root_case& c) {
  const std::string text = c.f.text();
  return fmt::format("polhode roots \"{}{}\" --in \" {}..{}\"", text.front() == '-' ? " " : "",
                     text, c.from.text(), c.to.text());
}

end_point end_of(const term& t) {
  if (t.is("inf")) return end_point::infinity();
  if (t.is("-inf")) return -end_point::infinity();
  const expression f = read(t);
  if (const auto form = end_point_of(f).form()) return end_point(*form);
  return end_point([f](precision p) { return f.value(p); });
}

root_set roots_of(const root_case& c) {
  isolate_options options;
  options.most_boxes = 3'000;
  options.most_unresolved = 100;
  options.most_precision = 1L << 11;
  return isolate_roots(read(c.f, {"x"}), end_of(c.from), end_of(c.to), options);
}

/// A root that a function is known to have.
struct known_root {
  term at;
  long multiplicity;
};

/// A function with these roots and no others between -10 and 10, times a positive one.
struct known_case {
  root_case c;
  std::vector<known_root> roots;
};

std::string listed(const root_set& s) {
  std::string text;
  for (const root_region& r : s.regions) {
    text += fmt::format("  {}{} at {}\n", to_text(r.verdict),
                        r.multiplicity > 1 ? fmt::format(" ({} times)", r.multiplicity) : "",
                        to_decimal(r.enclosure, 25));
  }
  for (const singular_place& p : s.singular) {
    text += fmt::format("  not defined at {}\n", to_decimal(p.place, 20));
  }
  return text + (s.complete ? "" : "  not complete\n");
}

/// What is wrong in the answer, in words.
std::optional<std::string> error_in(const known_case& k, const root_set& s) {
  constexpr precision p = 600;
  if (s.identically_zero) return "said to be 0 everywhere";
  const auto value = [](const term& t) { return read(t).value(p); };
  std::vector<long> claimed(s.regions.size());
  std::vector<long> possible(s.regions.size());  // also those that are an end of the region
  for (const known_root& r : k.roots) {
    const ball at = value(r.at);
    const auto beyond = [&](const term& end, bool lower) {
      if (end.is("inf") || end.is("-inf")) return false;
      return lower ? certainly_less(at, value(end)) : certainly_less(value(end), at);
    };
    if (beyond(k.c.from, true) || beyond(k.c.to, false)) continue;
    bool is_covered = false;
    for (std::size_t i = 0; i < s.regions.size(); ++i) {
      const root_region& region = s.regions[i];
      if (!overlaps(region.enclosure, at)) continue;
      is_covered = true;
      possible[i] += r.multiplicity;
      if (contains(region.enclosure, at)) claimed[i] += r.multiplicity;
    }
    // An end that is written as the root is the root; of one that is only near it nothing is known.
    const auto may_be = [&](const term& end) {
      return !end.is("inf") && !end.is("-inf") && end.text() != r.at.text() &&
             overlaps(at, value(end));
    };
    if (!is_covered && s.complete && !may_be(k.c.from) && !may_be(k.c.to)) {
      return "the root " + r.at.text() + " is missing";
    }
  }
  for (std::size_t i = 0; i < s.regions.size(); ++i) {
    const root_region& region = s.regions[i];
    if (region.verdict == root_verdict::infinitely_many) return "said to have no last root";
    if (region.verdict == root_verdict::isolated && (claimed[i] > 1 || possible[i] < 1)) {
      return fmt::format("there are {} roots in {}, not 1", claimed[i],
                         to_decimal(region.enclosure, 20));
    }
    if (region.multiplicity == 0) continue;
    if (claimed[i] > region.multiplicity) {
      return fmt::format("there are {} roots in {}, not {}", claimed[i],
                         to_decimal(region.enclosure, 20), region.multiplicity);
    }
    const refined_root fine = refine(region, 40);
    const bool is_known = std::any_of(k.roots.begin(), k.roots.end(), [&](const known_root& r) {
      return overlaps(value(r.at), fine.enclosure) && r.multiplicity == region.multiplicity;
    });
    if (!is_known) {
      return fmt::format("there is no root of multiplicity {} at {}", region.multiplicity,
                         to_decimal(fine.enclosure, 40));
    }
  }
  return std::nullopt;
}

/// A place for a root; rarely one very near the last.
term place(maker& m, const std::vector<known_root>& before, bool rational_ones) {
  if (!before.empty() && m.one_in(5)) {
    return before.back().at + m.decimal(m.scattered(1e-18, 1e-2));
  }
  const double t = m.within(-4, 4);
  return rational_ones || m.one_in(2) ? m.rational_near(t) : m.near(t);
}

/// With one real root, a simple one, at r.
term factor_with_root(maker& m, const term& r) {
  const term w = x - r;
  switch (m.between(0, 8)) {
    case 8:
      return call("agm", 1, call("exp", x)) - call("agm", 1, call("exp", r));
    case 0:
      return call("expm1", w);
    case 1:
      return call("atan", w);
    case 2:
      return call("sinh", w);
    case 3:
      return call("exp", x) - call("exp", r);
    case 4:
      return power(x, 3) - power(r, 3);
    case 5:
      return call("tanh", m.positive_rational() * w);
    default:
      return w;
  }
}

term positive_factor(maker& m) {
  switch (m.between(0, 5)) {
    case 0:
      return call("exp", m.rational_near(m.within(-1, 1)) * x);
    case 1:
      return 1 + power(x, 2);
    case 2:
      return 2 + call("cos", x);
    case 3:
      return call("cosh", x);
    case 4:
      return power(x - m.near(m.within(-3, 3)), 2) + m.decimal(m.scattered(1e-9, 1));
    default:
      return 1;
  }
}

std::pair<term, term> searched(maker& m, const std::vector<known_root>& roots) {
  if (m.one_in(8)) return {"-inf", "inf"};
  term a = m.near(m.within(-6, -2));
  term b = m.near(m.within(2, 6));
  if (!roots.empty() && m.one_in(4)) (m.one_in(2) ? a : b) = roots.front().at;
  if (!(approximately(a) < approximately(b))) return {-7, 7};
  return {a, b};
}

bool all_differ(const std::vector<known_root>& roots) {
  for (std::size_t i = 0; i < roots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (overlaps(read(roots[i].at).value(400), read(roots[j].at).value(400))) return false;
    }
  }
  return true;
}

known_case product_of_factors(maker& m) {
  for (;;) {
    known_case k;
    term f = positive_factor(m);
    for (long n = m.between(1, 4); n > 0; --n) {
      const term r = place(m, k.roots, false);
      const long multiplicity = m.one_in(3) ? m.between(2, 4) : 1;
      f = f * power(factor_with_root(m, r), multiplicity);
      k.roots.push_back({r, multiplicity});
    }
    if (!all_differ(k.roots)) continue;
    const auto [a, b] = searched(m, k.roots);
    k.c = {m.one_in(6) ? -f : f, a, b};
    return k;
  }
}

std::vector<rational> product_of(const std::vector<rational>& p, const std::vector<rational>& q) {
  std::vector<rational> product(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) product[i + j] += p[i] * q[j];
  }
  return product;
}

/// Multiplied out: nothing of the factors is left in the formula.
known_case expanded_polynomial(maker& m) {
  for (;;) {
    known_case k;
    std::vector<rational> p{1};
    const auto times = [&](const std::vector<rational>& q) { p = product_of(p, q); };
    for (long n = m.between(1, 4); n > 0; --n) {
      const long multiplicity = m.one_in(3) ? m.between(2, 3) : 1;
      if (m.one_in(4)) {  // x^2 - n
        const long square = m.between(2, 12);
        for (long i = 0; i < multiplicity; ++i) times({rational(-square), 0, 1});
        k.roots.push_back({call("sqrt", square), multiplicity});
        k.roots.push_back({-call("sqrt", square), multiplicity});
        continue;
      }
      term r = place(m, k.roots, true);
      if (!read(r).exact_value())
        r = m.rational_near(m.within(-4, 4));  // beside an irrational root
      const auto exact = read(r).exact_value();
      for (long i = 0; i < multiplicity; ++i) times({rational(-*exact), 1});
      k.roots.push_back({r, multiplicity});
    }
    if (m.one_in(2)) times({rational(1), rational(m.between(-1, 1)), 1});  // x^2 + bx + 1
    if (!all_differ(k.roots)) continue;
    term f = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p[i] == 0) continue;
      f = f + term(to_text(p[i])) * power(x, static_cast<long>(i));
    }
    const auto [a, b] = searched(m, k.roots);
    k.c = {f, a, b};
    return k;
  }
}

/// A polynomial in an exponential, or in another increasing function, multiplied out.
known_case expanded_in_a_function(maker& m) {
  for (;;) {
    known_case k;
    const term a = m.one_in(2) ? term(1) : m.positive_rational();
    const bool is_exponential = m.one_in(2);
    const term c = m.one_in(2) ? term(0) : m.rational_near(m.within(-2, 2));
    const bool is_sinh = m.one_in(2);
    const term of = c.is("0") ? x : x - c;
    const term part = is_sinh ? call("sinh", of) : call("atan", of);
    std::vector<rational> p{1};
    for (long n = m.between(1, 3); n > 0; --n) {
      const long multiplicity = m.one_in(2) ? m.between(2, 3) : 1;
      const term u =
          m.rational_near(m.within(is_exponential ? 0.1 : -1.4, is_exponential ? 8 : 1.4));
      const rational value = *read(u).exact_value();
      for (long i = 0; i < multiplicity; ++i) p = product_of(p, {rational(-value), 1});
      if (is_exponential) {
        if (value > 0) k.roots.push_back({call("log", u) / a, multiplicity});
      } else {
        k.roots.push_back({c + call(is_sinh ? "asinh" : "tan", u), multiplicity});
      }
    }
    if (!all_differ(k.roots)) continue;
    term f = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p[i] == 0) continue;
      const auto n = static_cast<long>(i);
      const term factor = !is_exponential ? power(part, n) : call("exp", term(n) * a * x);
      f = f + term(to_text(p[i])) * factor;
    }
    k.c = {m.one_in(4) ? f * positive_factor(m) : f, -30, 30};
    return k;
  }
}

/// Divided by powers of x - p: p is no root, whatever the numerator is there.
known_case quotient_of_polynomials(maker& m) {
  known_case k = expanded_polynomial(m);
  for (long n = m.between(1, 2); n > 0; --n) {
    const bool at_root = !k.roots.empty() && m.one_in(3);
    term p = at_root ? k.roots.front().at : m.rational_near(m.within(-5, 5));
    if (!read(p).exact_value()) p = m.rational_near(m.within(-5, 5));
    const ball at = read(p).value(400);
    std::erase_if(k.roots,
                  [&](const known_root& r) { return overlaps(read(r.at).value(400), at); });
    k.c.f = k.c.f / power(x - p, m.between(1, 3));
  }
  return k;
}

/// sin(k (x - c)) and its kin: roots at equal distances.
known_case many_roots(maker& m) {
  known_case k;
  const long n = m.between(1, 6);
  const term c = m.one_in(2) ? term(0) : m.near(m.within(-1, 1));
  const long multiplicity = m.one_in(3) ? m.between(2, 3) : 1;
  const bool in_halves = m.one_in(2);
  const term f = in_halves ? call("sinpi", n * (x - c)) : call("sin", n * (x - c));
  const term step = in_halves ? term(1) / n : term("pi") / n;
  const double c_about = approximately(c);
  const auto steps = static_cast<long>(8.0 / approximately(step)) + 2;
  for (long j = -steps; j <= steps; ++j) {
    const double at = c_about + static_cast<double>(j) * approximately(step);
    if (std::abs(at) < 5) k.roots.push_back({j < 0 ? c - (-j) * step : c + j * step, multiplicity});
  }
  k.c = {power(f, multiplicity) * positive_factor(m), m.near(m.within(-3, -1)),
         m.near(m.within(1, 3))};
  if (std::abs(approximately(k.c.from)) > 4 || std::abs(approximately(k.c.to)) > 4 ||
      !(approximately(k.c.from) < approximately(k.c.to))) {
    k.c.from = -3;
    k.c.to = 3;
  }
  return k;
}

/// floor, ceil or sign of a linear form beside a line, of x or of exp(x); often with a root at a
/// jump, or very near one. On each step it is a line, whose root counts where the step has it.
known_case beside_jumps(maker& m) {
  const auto fraction = [&](long most) {
    return rational(m.between(-most, most), m.between(1, 6));
  };
  const auto nonzero = [&](long most) {
    const rational q = fraction(most);
    return q == 0 ? rational(1) : q;
  };
  const auto number = [](const rational& q) {
    return q < 0 ? -term(to_text(rational(-q))) : term(to_text(q));
  };
  enum kind { floors, ceils, signs };
  const kind k = m.any_of({floors, ceils, signs});
  const bool of_exponential = m.one_in(4);
  const rational a = nonzero(8);
  const rational b = fraction(8);
  const rational p = nonzero(8);
  const rational q = m.one_in(6) ? rational(0) : nonzero(8);
  const auto step = [&](const rational& t) {
    const rational u = a * t + b;
    if (k == signs) return rational(u > 0 ? 1 : u < 0 ? -1 : 0);
    return rational(k == floors ? floor_of(u) : ceil_of(u));
  };
  rational r = fraction(20);
  if (!m.one_in(3)) {  // the value at a jump, or the limit on one of its sides, is 0, or nearly so
    const rational jump = (rational(k == signs ? 0 : m.between(-4, 4)) - b) / a;
    r = -(p * (step(jump) + m.between(-1, 1)) + q * jump);
    if (m.one_in(3)) r += rational(m.one_in(2) ? 1 : -1, integer(10) * pow(integer(10), 20U));
  }
  known_case result;
  const term t = of_exponential ? call("exp", x) : x;
  const term u = number(a) * t + number(b);
  const term stepped = call(k == floors ? "floor" : k == ceils ? "ceil" : "sign", u);
  result.c = {number(p) * stepped + number(q) * t + number(r), of_exponential ? -3 : -6,
              of_exponential ? 2 : 6};
  const long most = 64;  // |a t + b| is less
  bool is_constant_root = false;
  for (long n = k == signs ? -1 : -most; n <= (k == signs ? 1 : most); ++n) {
    if (q == 0) {
      is_constant_root = is_constant_root || p * n + r == 0;
      continue;
    }
    const rational at = -(p * n + r) / q;
    if (step(at) != n || (of_exponential && at <= 0)) continue;
    result.roots.push_back({of_exponential ? call("log", number(at)) : number(at), 1});
  }
  if (is_constant_root) result.c.f = power(result.c.f, 2) + 1;  // a step of zeros is no root
  return result;
}

/// A root at a kink or branch point, and others beside it at any scale. A root at a kink counts
/// once.
known_case kinks_at_all_scales(maker& m) {
  known_case k;
  const auto scale = [&](long least, long most) {
    return term(fmt::format("1e{}", m.between(least, most)));
  };
  const term c = m.one_in(3) ? term(0) : m.rational_near(m.within(-4, 4));
  const term t = c.is("0") ? x : x - c;
  term f = 0;
  if (m.one_in(2)) {
    const std::vector<term> kinks{call("sqrt", t),
                                  call("abs", t),
                                  call("cbrt", t),
                                  t * call("abs", t),
                                  call("sqrt", call("abs", t)),
                                  call("abs", t) * call("exp", t),
                                  call("abs", call("sin", t)) + power(t, 2)};
    const auto kind = static_cast<std::size_t>(m.between(0, static_cast<long>(kinks.size()) - 1));
    f = kinks[kind];
    const bool on_the_right = kind == 0;
    if (kind != 5 && kind != 6) {  // else it is wanted alone
      for (long n = m.between(1, 2); n > 0; --n) {
        const term r = scale(-100, 100);
        const bool left = !on_the_right && m.one_in(2);
        f = f * (left ? t + r : t - r);
        k.roots.push_back({left ? c - r : c + r, 1});
      }
    }
  } else {  // of two terms of different powers
    const long e = m.between(-50, 50);
    const term slope = term(fmt::format("1e{}", e));
    if (m.one_in(2)) {
      f = call("sqrt", t) - slope * t;
      k.roots.push_back({c + term(fmt::format("1e{}", -2 * e)), 1});
    } else {
      const long even = e - e % 2;
      f = call("cbrt", t) - term(fmt::format("1e{}", even)) * t;
      const term r = term(fmt::format("1e{}", -3 * even / 2));
      k.roots.push_back({c + r, 1});
      k.roots.push_back({c - r, 1});
    }
  }
  if (!all_differ(k.roots)) return kinks_at_all_scales(m);
  k.roots.push_back({c, 1});
  const term reach = scale(101, 300);
  k.c = {f, -reach, reach};
  return k;
}

/// (e^(a x) - u)(e^(a x) - v) multiplied out, over the whole line, or in 1/x beside 0: what is
/// greatest at an end grows, and cancels with what grows less.
known_case sums_of_exponentials(maker& m) {
  known_case k;
  const bool beside_zero = m.one_in(3);
  const term w = beside_zero ? 1 / x : x;
  const term a = m.one_in(2) ? term(1) : m.positive_rational();
  const auto base = [&] {
    return m.one_in(3) ? term(fmt::format("10^{}", m.between(-12, 12))) : m.positive_rational();
  };
  const auto add_root = [&](const term& u) {  // e^(a w) = u
    const term at = call("log", u) / a;
    if (beside_zero && read(at).value(200).is_bounded() && contains_zero(read(at).value(200)))
      return;
    k.roots.push_back({beside_zero ? 1 / at : at, 1});
  };
  const term u = base();
  switch (m.between(0, 3)) {
    case 0: {
      const term v = base();
      k.c.f = call("exp", 2 * a * w) - (u + v) * call("exp", a * w) + u * v;
      add_root(v);
      add_root(u);
      break;
    }
    case 1:  // multiplied by e^(-a w)
      k.c.f = call("exp", a * w) + u * term(2) * call("exp", -a * w) - (u + 2);
      add_root(2);
      add_root(u);
      break;
    case 2:  // tanh(y) = 1 - 2/(e^2y + 1), and e^2y = u where tanh(y) = 1 - 2/(u + 1)
      k.c.f = call("tanh", a * w / 2) - 1 + 2 / (u + 1);
      add_root(u);
      break;
    default:  // 2 cosh(y) - 2 sinh(y) = 2 e^-y
      k.c.f = call("cosh", a * w) - call("sinh", a * w) - 1 / u;
      add_root(u);
      break;
  }
  if (!all_differ(k.roots)) return sums_of_exponentials(m);
  k.c.from = beside_zero ? term(-30) : term("-inf");
  k.c.to = beside_zero ? term(30) : term("inf");
  return k;
}

/// Divided by what vanishes with a factor: the place is no root, the others are as before.
known_case removable_points(maker& m) {
  known_case k = product_of_factors(m);
  const term c = m.one_in(3)   ? term(0)
                 : m.one_in(2) ? m.rational_near(m.within(-3, 3))
                               : m.between(-2, 2) * term("pi") / m.between(1, 3);
  const ball at = read(c).value(400);
  std::erase_if(k.roots, [&](const known_root& r) { return overlaps(read(r.at).value(400), at); });
  const term t = c.is("0") ? x : x - c;
  switch (m.between(0, 6)) {
    case 0:
      k.c.f = k.c.f * (call("sin", t) / t);
      for (const long n : {-3, -2, -1, 1, 2, 3}) {
        k.roots.push_back({n < 0 ? c - (-n) * term("pi") : c + n * term("pi"), 1});
      }
      break;
    case 1:
      k.c.f = k.c.f * ((call("exp", t) - 1) / t);
      break;
    case 2:
      k.c.f = k.c.f * ((call("cosh", t) - 1) / power(t, m.between(1, 3)));
      break;
    case 3:  // t, but not at 0
      k.c.f = k.c.f * (1 / (1 / t));
      break;
    case 4:  // cos(t), but not where it is 0
      k.c.f = k.c.f * (call("sin", t) / call("tan", t));
      for (long n = -12; n <= 12; ++n) {
        const ball hole = read(c + (2 * n + 1) * term("pi") / 2).value(400);
        const ball pole = read(c + n * term("pi")).value(400);
        std::erase_if(k.roots, [&](const known_root& r) {
          const ball root = read(r.at).value(400);
          return overlaps(root, hole) || overlaps(root, pole);
        });
      }
      break;
    case 5: {  // t^2, but not at 0
      const term s = call("sin", t) / t;
      k.c.f = k.c.f * (power(t, 2) / power(s, -1) / s);
      for (const long n : {-3, -2, -1, 1, 2, 3}) {
        const ball hole = read(n < 0 ? c - (-n) * term("pi") : c + n * term("pi")).value(400);
        std::erase_if(k.roots,
                      [&](const known_root& r) { return overlaps(read(r.at).value(400), hole); });
      }
      break;
    }
    default:
      k.c.f = k.c.f * (call("log", 1 + power(t, 2)) / t);
      break;
  }
  if (!all_differ(k.roots)) return removable_points(m);
  return k;
}

/// 1 - cos(n (x - c)) and its kin: double roots at equal distances, multiples of pi for c = 0.
known_case touching_at_multiples_of_pi(maker& m) {
  known_case k;
  const long n = m.between(1, 3);
  const bool is_moved = m.one_in(4);
  const term c = is_moved ? m.rational_near(m.within(-1, 1)) : term(0);
  const term w = n * (is_moved ? x - c : x);
  const long kind = m.between(0, 2);
  const bool is_odd = kind == 1;  // at odd multiples of pi/n
  term f = kind == 0   ? 1 - call("cos", w)
           : kind == 1 ? 1 + call("cos", w)
                       : call("abs", call("sin", w)) * call("exp", x);
  for (long j = -12; j <= 12; ++j) {
    if (kind != 2 && (j % 2 != 0) != is_odd) continue;
    const term step = (j < 0 ? -j : j) * term("pi") / n;
    k.roots.push_back({j < 0 ? c - step : c + step, kind == 2 ? 1 : 2});
  }
  if (kind != 2) f = f * positive_factor(m);
  k.c = {f, m.near(m.within(-6, -2)), m.near(m.within(2, 6))};
  return k;
}

/// A convex function less its tangent at an irrational number, which is no root of a derivative
/// that is a polynomial: a double root there, or none where a little is added.
known_case touching_at_irrational_numbers(maker& m) {
  known_case k;
  const long n = m.between(2, 9);
  const term number = n;
  term at = call("log", number);
  term f = 0;
  switch (m.between(0, 4)) {
    case 0:
      at = m.any_of<term>({call("sqrt", number), call("exp", 1 / number), call("log", number),
                           call("sqrt", 2) * (number / 7), call("sqrt", number) + 1});
      f = m.one_in(2) ? power(x, 2) - 2 * at * x + power(at, 2)
                      : power(x, 2) / 2 - at * x + power(at, 2) / 2;
      break;
    case 1:
      f = call("exp", x) - number - number * (x - at);
      break;
    case 2: {
      const term q = m.quotient(m.within(-2, 2));
      at = call("exp", q);
      f = x * call("exp", -q) - 1 + q - call("log", x);
      break;
    }
    case 3:
      at = call("exp", -1);
      f = x * call("log", x) + at;
      break;
    default:
      f = call("cosh", x) - (number * number + 1) / (2 * number) -
          (number * number - 1) / (2 * number) * (x - at);
  }
  if (m.one_in(4)) {
    f = f + power(10, -m.between(10, 60));
  } else {
    k.roots = {{at, 2}};
  }
  f = f * positive_factor(m);
  k.c = {f, m.decimal(m.within(0.02, 0.1)), m.decimal(m.within(8, 12))};
  return k;
}

/// To infinity, with one summand that outgrows all powers: a function that increases from 2 on less
/// its value at r, or a factor with the root r of every summand.
known_case outgrown_sum(maker& m) {
  known_case k;
  const term r = m.one_in(2) ? m.rational_near(m.within(2.5, 9)) : m.near(m.within(2.5, 9));
  const auto greatest = [](long which, const term& at) {
    return which == 0   ? call("gamma", at)
           : which == 1 ? power(at, at)
           : which == 2 ? call("exp", power(at, 2))
                        : call("exp", at);
  };
  const long which = m.between(0, 3);
  const term c = m.rational_near(m.scattered(1, 1e4));
  const long n = m.between(1, 4);
  const auto others = [&](const term& at) { return c * power(at, n) + call("log", at); };
  if (m.one_in(2)) {
    k.c.f = (x - r) * greatest(which, x) + c * (x - r) * power(x, n);
  } else {
    k.c.f = greatest(which, x) + others(x) - (greatest(which, r) + others(r));
  }
  k.roots = {{r, 1}};
  k.c = {m.one_in(3) ? -k.c.f : k.c.f, 2, "inf"};
  return k;
}

/// A root, another power or the absolute value of a function with known zeros, which is often not
/// defined on one side of them, times a factor whose root is one only where the power is defined.
known_case powers_of_known_functions(maker& m) {
  for (;;) {
    known_case k;
    std::vector<known_root> places;
    term u = m.one_in(2) ? positive_factor(m) : term(1);
    for (long n = m.between(1, 3); n > 0; --n) {
      const term r = place(m, places, false);
      u = u * factor_with_root(m, r);
      places.push_back({r, 1});
    }
    k.roots = places;
    if (m.one_in(3)) {  // a pole, where the sign changes as well
      const term d = place(m, places, false);
      u = u / factor_with_root(m, d);
      places.push_back({d, 1});
    }
    bool is_negated = m.one_in(4);
    if (is_negated) u = -u;
    const long kind = m.between(0, 5);
    const bool is_defined_everywhere = kind < 2;
    term f = kind == 0   ? call("abs", u)
             : kind == 1 ? call("cbrt", u)
             : kind == 2 ? call("sqrt", u)
             : kind == 3 ? power(u, term("pi") / m.between(1, 9))
             : kind == 4 ? power(u, term(m.between(1, 5)) / 7)
                         : power(u, call("sqrt", m.between(2, 3)));
    if (m.one_in(2)) {
      const term r = place(m, places, false);
      for (const known_root& p : places) {
        if (approximately(r) < approximately(p.at)) is_negated = !is_negated;
      }
      f = f * factor_with_root(m, r);
      places.push_back({r, 1});
      if (is_defined_everywhere || !is_negated) k.roots.push_back({r, 1});
    }
    if (!all_differ(places)) continue;
    const auto [a, b] = searched(m, k.roots);
    k.c = {m.one_in(6) ? -f : f, a, b};
    return k;
  }
}

/// Factors with known roots, times a function without zeros that is not defined at s, or
/// oscillates without end there.
known_case singular_point_inside(maker& m) {
  for (;;) {
    known_case k;
    const term s = m.one_in(2) ? m.rational_near(m.within(-3, 3)) : m.near(m.within(-3, 3));
    term f = 1;
    for (long n = m.between(1, 3); n > 0; --n) {
      const term r = place(m, k.roots, false);
      f = f * factor_with_root(m, r);
      k.roots.push_back({r, 1});
    }
    k.roots.push_back({s, 1});
    if (!all_differ(k.roots)) continue;
    k.roots.pop_back();
    switch (m.between(0, 3)) {
      case 0:
        f = f * call("exp", -1 / power(x - s, 2));
        break;
      case 1:
        f = f * (2 + call("sin", 1 / (x - s)));
        break;
      case 2:
        f = f / call("sqrt", call("abs", x - s));
        break;
      default:
        f = f * (3 + call("atan", 1 / (x - s)));
    }
    k.c = {f, m.near(m.within(-6, -4)), m.near(m.within(4, 6))};
    return k;
  }
}

struct known_family {
  std::string name;
  long at_effort_one;
  known_case (*make)(maker&);
};

class known_roots : public ::testing::TestWithParam<known_family> {};

bool is_wrong(const known_case& k) {
  try {
    return error_in(k, roots_of(k.c)).has_value();
  } catch (const input_error&) {
    return false;
  }
}

/// With fewer roots, as long as the answer is wrong.
known_case shrunk(known_case k) {
  for (bool is_smaller = true; is_smaller;) {
    is_smaller = false;
    const auto try_ends = [&](const term& a, const term& b) {
      known_case less = k;
      less.c.from = a;
      less.c.to = b;
      if (a.size() + b.size() >= k.c.from.size() + k.c.to.size() || !is_wrong(less)) return;
      k = less;
      is_smaller = true;
    };
    for (const term& a : smaller(k.c.from)) try_ends(a, k.c.to);
    for (const term& b : smaller(k.c.to)) try_ends(k.c.from, b);
  }
  return k;
}

TEST_P(known_roots, are_all_found_and_no_others) {
  const known_family& family = GetParam();
  run_cases("roots", family.name, family.at_effort_one, [&](std::uint64_t seed, counts& c) {
    maker m(seed);
    const known_case k = family.make(m);
    under_way(command_of(k.c));
    ++c.cases;
    try {
      const root_set s = roots_of(k.c);
      ++c.computed;
      ++(s.is_resolved() && s.complete ? c.certified : c.refused);
      c.checks += static_cast<long>(k.roots.size() + s.regions.size());
      if (const auto error = error_in(k, s)) {
        ++c.wrong;
        const known_case less = shrunk(k);
        ADD_FAILURE() << *error << '\n'
                      << command_of(k.c) << '\n'
                      << listed(s) << "shrunk:\n"
                      << command_of(less.c) << '\n'
                      << listed(roots_of(less.c));
      }
    } catch (const input_error&) {  // the limits are the wrong way round
      ++c.refused;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(
    family, known_roots,
    ::testing::Values(
        known_family{"products of known factors", 250, product_of_factors},
        known_family{"polynomials multiplied out", 250, expanded_polynomial},
        known_family{"polynomials in a function multiplied out", 60, expanded_in_a_function},
        known_family{"quotients of polynomials", 150, quotient_of_polynomials},
        known_family{"roots at equal distances", 150, many_roots},
        known_family{"kinks at all scales", 150, kinks_at_all_scales},
        known_family{"jumps", 150, beside_jumps},
        known_family{"sums of exponentials", 60, sums_of_exponentials},
        known_family{"one summand outgrows the others", 60, outgrown_sum},
        known_family{"powers of known functions", 80, powers_of_known_functions},
        known_family{"singular points inside", 60, singular_point_inside},
        known_family{"removable points", 50, removable_points},
        known_family{"touching at multiples of pi", 50, touching_at_multiples_of_pi},
        known_family{"touching at irrational numbers", 50, touching_at_irrational_numbers}),
    [](const auto& drawn) {
      std::string name = drawn.param.name;
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    });

// ---------------------------------------------------------------------------------------------
// Infinitely many roots

/// A function that oscillates towards an end or a point.
struct oscillation {
  root_case c;
  bool is_endless = false;  // it has infinitely many roots there
};

/// With sines, cosines and tangents of w(u), u -> infinity; each amplitude outgrows the other part,
/// or is outgrown.
oscillation oscillation_of(maker& m) {
  const term u = "u";
  const term n = m.between(1, 9);
  const term k = m.one_in(3) ? m.irrational() : m.rational_near(m.scattered(0.2, 5));
  const term w = m.any_of<term>({k * u, k * u + m.between(-5, 5), power(u, m.between(2, 3)) + n * u,
                                 call("sqrt", u), u + 1 / u, call("log", u), k * u * call("log", u),
                                 call("exp", u / 3), u + call("sin", u) / 2});
  const term at_rest = m.any_of<term>({1 / u, call("atan", u), 2 + call("exp", -u), u / (u + 1)});
  const term wave =
      m.any_of<term>({call("sin", w), call("cos", w), call("sin", w) - call("cos", 2 * w),
                      power(call("sin", w), 3), call("sin", w) + call("sin", "pi" * w) / 3});
  const term amplitude =
      m.any_of<term>({u, call("sqrt", u), call("log", u + 2), power(u, m.between(2, 4)),
                      term(4) + call("exp", -u), call("exp", u / 4)});
  const term less =
      m.any_of<term>({n / u, call("exp", -u), -1 / call("sqrt", u), call("atan", 1 / u)});
  const term size = call("abs", wave) + 1;  // positive
  switch (m.between(0, 11)) {
    case 0:
    case 1:
      return {{amplitude * wave + less}, true};
    case 2:
      return {{amplitude * (wave + less)}, true};
    case 3:
      return {{call("tan", w) - (m.one_in(2) ? amplitude : less)}, true};
    case 4:
      return {{amplitude * (1 + call("sin", w))}, true};
    case 5:
      return {{1 / call("sin", w) - amplitude * 4}, true};
    case 6:  // outgrown
      return {{amplitude * (wave + 4) + less}, false};
    case 7:
      return {{amplitude * wave / call("sqrt", u) / 9 + amplitude}, false};
    case 8:  // a zero of the divisor
      return {{amplitude * wave / (wave * size)}, false};
    case 9:
      return {{amplitude * call("sin", 2 * w) / (call("sin", w) * call("cos", w)) + less}, false};
    case 10:  // jumps
      return {{amplitude * (call("floor", wave) + term(1) / 2)}, false};
    default:  // the angle comes to rest
      return {{(amplitude + 9) * (call("sin", at_rest) + 2) + less}, false};
  }
}

oscillation oscillation_towards_an_end(maker& m) {
  oscillation o = oscillation_of(m);
  const long where = m.between(0, 3);
  const term p = m.one_in(2) ? m.rational_near(m.within(-3, 3)) : m.near(m.within(-3, 3));
  const term u = where == 0 ? x : where == 1 ? -x : where == 2 ? 1 / (x - p) : 1 / (p - x);
  o.c.f = substituted(o.c.f, "u", u);
  o.c.from = where == 1 ? term("-inf") : where == 0 ? term(3) : where == 2 ? p : p - term(1) / 3;
  o.c.to = where == 1 ? term(-3) : where == 0 ? term("inf") : where == 2 ? p + term(1) / 3 : p;
  return o;
}

TEST(endless_roots, are_claimed_where_there_are_such) {
  run_cases("roots", "oscillations towards an end", 60, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const oscillation o = oscillation_towards_an_end(m);
    under_way(command_of(o.c));
    ++c.cases;
    try {
      isolate_options options;
      options.most_boxes = 1'000;
      options.most_unresolved = 50;
      options.most_towards_end = 8;
      const root_set s =
          isolate_roots(read(o.c.f, {"x"}), end_of(o.c.from), end_of(o.c.to), options);
      ++c.computed;
      ++c.checks;
      const bool is_said = std::ranges::any_of(s.regions, [](const root_region& r) {
        return r.verdict == root_verdict::infinitely_many;
      });
      ++(is_said ? c.certified : c.refused);
      const bool is_all_said = s.complete && s.is_resolved();
      if (is_said ? !o.is_endless : is_all_said && o.is_endless) {
        ++c.wrong;
        ADD_FAILURE() << command_of(o.c) << '\n' << listed(s);
      }
    } catch (const input_error&) {  // the limits are the wrong way round
      ++c.refused;
    }
  });
}

/// What is wrong in the complex roots of the polynomial whose real roots are known, but for pairs.
std::optional<std::string> error_in_plane(const known_case& k, const rational_polynomial& p,
                                          const complex_roots_answer& a) {
  if (!a.complete) return "not complete";
  long count = 0;
  for (const complex_root& r : a.roots) {
    count += r.multiplicity;
  }
  if (count != p.degree()) return fmt::format("{} roots, not {}", count, p.degree());
  for (const known_root& known : k.roots) {
    const ball at = read(known.at).value(600);
    const auto holders = std::count_if(a.roots.begin(), a.roots.end(), [&](const complex_root& r) {
      return r.is_real() && contains(r.enclosure.re, at) && r.multiplicity == known.multiplicity;
    });
    if (holders != 1) return "the root " + known.at.text() + " is not in one enclosure";
  }
  const auto real = std::count_if(a.roots.begin(), a.roots.end(),
                                  [](const complex_root& r) { return r.is_real(); });
  if (real != static_cast<std::ptrdiff_t>(k.roots.size())) {
    return fmt::format("{} real roots, not {}", real, k.roots.size());
  }
  return std::nullopt;
}

TEST(complex_roots_of_polynomials, are_all_found) {
  run_cases("roots", "complex roots of polynomials", 250, [&](std::uint64_t seed, counts& c) {
    maker m(seed);
    const known_case k = expanded_polynomial(m);
    const auto p = read(k.c.f, {"x"}).polynomial();
    ++c.cases;
    if (!p) return;
    under_way(fmt::format("polhode roots \"{}\" --complex", k.c.f.text()));
    const complex_roots_answer a = complex_roots(*p, m.between(1, 60));
    ++c.computed;
    ++(a.complete ? c.certified : c.refused);
    c.checks += static_cast<long>(a.roots.size());
    if (const auto error = error_in_plane(k, *p, a)) {
      ++c.wrong;
      ADD_FAILURE() << *error << "\npolhode roots \"" << k.c.f.text() << "\" --complex";
    }
  });
}

// ---------------------------------------------------------------------------------------------
// Roots that are not known

/// The certain roots of a search that is resolved: nothing where it is not.
std::optional<long> number_of_roots(const root_case& c, std::vector<ball>& enclosures) {
  try {
    const root_set s = roots_of(c);
    if (!s.complete || !s.is_resolved() || s.identically_zero) return std::nullopt;
    for (const root_region& r : s.regions) enclosures.push_back(r.enclosure);
    return static_cast<long>(s.regions.size());
  } catch (const input_error&) {
    return std::nullopt;
  }
}

term wavy(maker& m, long depth) {
  if (depth == 0) return m.one_in(2) ? x : m.positive_rational() * x;
  const term u = wavy(m, depth - 1);
  switch (m.between(0, 4)) {
    case 0:
      return m.gentle(u) - m.rational_near(m.within(-1, 1));
    case 1:
      return call("sin", m.positive_rational() * u) - m.rational_near(m.within(-1, 1)) * u;
    case 2:
      return call("exp", m.rational_near(m.within(-1, 1)) * x) * m.gentle(u) -
             m.positive_rational();
    default:
      return m.gentle(u) * (x - m.near(m.within(-2, 2)));
  }
}

TEST(unknown_roots, are_the_same_in_parts_mirrored_and_moved) {
  run_cases("roots", "unknown roots", 250, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const term f = wavy(m, m.between(1, 3));
    const auto [a, b] = m.range(-4, 4);
    const root_case whole{f, a, b};
    under_way(command_of(whole));
    ++c.cases;
    std::vector<ball> roots;
    const auto n = number_of_roots(whole, roots);
    ++c.computed;
    ++(n ? c.certified : c.refused);
    const auto compare = [&](const std::vector<root_case>& parts, const char* how) {
      long sum = 0;
      std::vector<ball> others;
      std::string commands;
      for (const root_case& part : parts) {
        const auto k = number_of_roots(part, others);
        ++c.computed;
        if (!k) return;
        sum += *k;
        commands += command_of(part) + '\n';
      }
      if (!n) return;
      ++c.checks;
      if (sum == *n) return;
      ++c.wrong;
      ADD_FAILURE() << *n << " roots by\n"
                    << command_of(whole) << "\nand " << sum << " " << how << '\n'
                    << commands;
    };
    // At a cut that is no root: then no root is in both parts.
    const term cut = m.rational_near(m.within(approximately(a), approximately(b)));
    const bool is_inside =
        approximately(a) < approximately(cut) && approximately(cut) < approximately(b);
    const bool is_root = std::any_of(roots.begin(), roots.end(), [&](const ball& r) {
      return overlaps(r, read(cut).value(64));
    });
    if (is_inside && !is_root) compare({{f, a, cut}, {f, cut, b}}, "in two parts");
    compare({{substituted(f, "x", -x), -b, -a}}, "with -x for x");
    const term alpha = m.positive_rational();
    compare({{substituted(f, "x", alpha * x), a / alpha, b / alpha}}, "with alpha*x for x");
    compare({{substituted(f, "x", power(x, 3)), call("cbrt", a), call("cbrt", b)}},
            "with x^3 for x");
  });
}

/// digamma increases from -inf to inf between two poles, and beyond the last (DLMF 5.15.1); zeta
/// decreases from inf to 1 beyond its pole, and is below -1/2 between 0 and it.
TEST(roots, of_digamma_and_zeta_are_one_in_each_gap) {
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  run_cases("roots", "digamma and zeta beside their poles", 40, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    ++c.cases;
    const bool is_digamma = m.one_in(2);
    const long poles = m.between(0, 8);
    const rational level(
        is_digamma ? m.between(-90, 30) : m.between(-30, -6) * (m.one_in(2) ? -1 : 1),
        is_digamma ? 10 : 5);
    const std::string text =
        fmt::format("{}(x)-({})", is_digamma ? "digamma" : "zeta", level.str());
    under_way(text);
    const root_set s = isolate_roots(parse(text, {"x"}), is_digamma ? -poles : 0, 40);
    ++c.computed;
    const bool is_resolved =
        s.complete && std::all_of(s.regions.begin(), s.regions.end(), [](const root_region& r) {
          return r.verdict == root_verdict::unique;
        });
    ++(is_resolved ? c.certified : c.refused);
    const auto expected = static_cast<std::size_t>(is_digamma ? poles + 1 : 1);
    const auto fail = [&](const std::string& why) {
      ++c.wrong;
      ADD_FAILURE() << text << " from " << -poles << ": " << why;
    };
    ++c.checks;
    if (s.regions.size() < expected) fail("a root is lost");
    if (is_resolved && s.regions.size() != expected) fail("there are other roots");
    for (std::size_t k = 0; is_resolved && k < s.regions.size(); ++k) {
      ++c.checks;
      const ball at = refine(s.regions[k], 30).enclosure;
      if (!contains_zero(parse(text, {"x"})(at))) fail("no root");
      const rational gap = is_digamma ? rational(static_cast<long>(k) - poles) : rational(0);
      if (!certainly_less(ball(gap, 64), at)) fail("a root in another gap");
    }
  });
}

}  // namespace roots_test
}  // namespace polhode::differential
