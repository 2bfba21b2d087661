// Integrals along paths in the complex plane: against antiderivatives, other paths between the same
// ends, residues, the number of zeros inside; and paths through poles and across cuts, which must
// be refused.

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cli/options/path_option.hpp"
#include "maker.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "tally.hpp"
#include "term.hpp"

namespace polhode::differential {
namespace paths_test {

const term z = "z";
const term i = "i";

struct path_case {
  term integrand = 0;
  std::string along;   // "P, Q, ..."
  std::string circle;  // or "CENTRE, RADIUS"
  long digits = 12;
};

std::string command_of(const path_case& c) {
  return fmt::format("polhode integrate \" {}\" --variable z {} \" {}\" --digits {}",
                     c.integrand.text(), c.circle.empty() ? "--along" : "--circle",
                     c.circle.empty() ? c.along : c.circle, c.digits);
}

contour_integral computed(const path_case& c, counts& tally) {
  under_way(command_of(c));
  ++tally.computed;
  const path way =
      c.circle.empty() ? cli::read_polygon(c.along, {}) : cli::read_circle(c.circle, {});
  return detail::integrate_path(complex_integrand_of(read(c.integrand, {"z", "i"})), way,
                                {.digits = c.digits + 1, .most_evaluations = 2'000});
}

complex_ball value_at(const term& f, const term& at) {
  constexpr precision p = 400;
  const complex_ball point = read(at, {"i"}).evaluator<complex_ball>(p)(complex_ball::i(p));
  const std::vector<complex_ball> arguments{point, complex_ball::i(p)};
  return read(f, {"z", "i"}).evaluator<complex_ball>(p)(std::span<const complex_ball>(arguments));
}

std::string text_of(const complex_ball& w) {
  return to_decimal(w.re, 25) + " + " + to_decimal(w.im, 25) + " i";
}

bool meet(const complex_ball& v, const complex_ball& w) {
  return overlaps(v.re, w.re) && overlaps(v.im, w.im);
}

/// Counts a check of two enclosures, and reports them where they are disjoint.
void compare(const complex_ball& v, const complex_ball& w, const std::string& first,
             const std::string& second, counts& c) {
  if (!v.is_bounded() || !w.is_bounded()) return;
  ++c.checks;
  if (meet(v, w)) return;
  ++c.wrong;
  ADD_FAILURE() << "the enclosures are disjoint\n  " << first << "\n    " << text_of(v) << "\n  "
                << second << "\n    " << text_of(w);
}

void count(const contour_integral& r, counts& c) {
  ++c.cases;
  ++(r.verdict == status::certified ? c.certified : c.refused);
}

term point(maker& m, double size) {
  const term re = m.one_in(5) ? term(0) : m.near(m.within(-size, size));
  const term im = m.one_in(5) ? term(0) : m.near(m.within(-size, size));
  return re + im * i;
}

std::string joined(const std::vector<term>& points) {
  std::string text;
  for (const term& p : points) text += (text.empty() ? "" : ", ") + p.text();
  return text;
}

/// Analytic everywhere.
term entire(maker& m, const term& t, long depth) {
  if (depth == 0) return m.one_in(2) ? t : m.rational_near(m.within(0.3, 2)) * t;
  const term u = entire(m, t, depth - 1);
  switch (m.between(0, 5)) {
    case 0:
      return call("exp", u);
    case 1:
      return call("sin", u);
    case 2:
      return u * call("cos", t);
    case 3:
      return power(u, m.between(2, 3));
    case 4:
      return u + m.coefficient() * call("sinh", t);
    default:
      return call("exp", -power(t, 2)) + u;
  }
}

long some_digits(maker& m) { return m.between(3, 20); }

TEST(paths, entire_functions_by_their_ends) {
  run_cases("paths", "entire functions", 30, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const term f = entire(m, z, m.between(1, 2));
    const std::vector<term> ends{point(m, 1.5), point(m, 1.5)};
    const path_case one{derivative(f, "z"), joined(ends), "", some_digits(m)};
    const contour_integral first = computed(one, c);
    count(first, c);
    compare(first.enclosure, value_at(f, ends[1]) - value_at(f, ends[0]), command_of(one),
            "antiderivative " + f.text(), c);
    path_case other = one;
    other.along = joined({ends[0], point(m, 1.5), ends[1]});
    compare(first.enclosure, computed(other, c).enclosure, command_of(one), command_of(other), c);
    path_case back = one;
    back.along = joined({ends[1], ends[0]});
    compare(first.enclosure, -computed(back, c).enclosure, command_of(one),
            "minus " + command_of(back), c);
  });
}

/// g(z)/(z - p)^k around a circle, p inside or outside.
TEST(paths, residues_of_poles) {
  run_cases("paths", "residues", 40, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const term g = entire(m, z, m.between(0, 1));
    const term pole = point(m, 1);
    const long order = m.between(1, 4);
    const term centre = m.one_in(2) ? pole : point(m, 1);
    const term radius =
        m.one_in(2) ? m.rational_near(m.scattered(0.1, 2)) : m.near(m.scattered(0.3, 2));
    const path_case circle{g / power(z - pole, order), "", centre.text() + ", " + radius.text(),
                           some_digits(m)};
    // Inside, outside, or not to be decided.
    const complex_ball w = value_at(z, pole) - value_at(z, centre);
    const ball r = read(radius).value(400);
    const ball distance = abs(w);
    if (!certainly_positive(r)) return;
    const contour_integral result = computed(circle, c);
    count(result, c);
    if (certainly_less(r, distance)) {
      compare(result.enclosure, complex_ball(0, 64), command_of(circle), "0", c);
    } else if (certainly_less(distance, r)) {
      term slope = g;
      long factorial = 1;
      for (long k = 1; k < order; ++k) {
        slope = derivative(slope, "z");
        factorial *= k;
      }
      const term value = 2 * term("pi") * i * slope / factorial;
      compare(result.enclosure, value_at(value, pole), command_of(circle),
              value.text() + " at " + pole.text(), c);
    }
  });
}

/// The integral of f'/f around a circle counts the zeros inside, those that are complex with them.
TEST(paths, number_of_zeros_by_the_argument_principle) {
  run_cases("paths", "argument principle", 20, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    struct zero {
      term at;
      long multiplicity;
    };
    std::vector<zero> zeros;
    term f = m.one_in(2) ? call("exp", entire(m, z, 1)) : term(1);
    for (long n = m.between(1, 4); n > 0; --n) {
      zeros.push_back({point(m, 2), m.one_in(3) ? m.between(2, 3) : 1});
      f = f * power(z - zeros.back().at, zeros.back().multiplicity);
    }
    const term centre = point(m, 1);
    const term radius = m.rational_near(m.scattered(0.3, 3));
    const path_case circle{derivative(f, "z") / f, "", centre.text() + ", " + radius.text(),
                           m.between(3, 10)};
    const ball r = read(radius).value(400);
    const contour_integral result = computed(circle, c);
    count(result, c);
    long inside = 0;
    for (const zero& one : zeros) {
      const ball distance = abs(value_at(z, one.at) - value_at(z, centre));
      if (certainly_less(distance, r)) {
        inside += one.multiplicity;
      } else if (!certainly_less(r, distance)) {
        return;
      }
    }
    const complex_ball expected(ball(0, 128), 2 * inside * pi(128));
    compare(result.enclosure, expected, command_of(circle), fmt::format("{} zeros", inside), c);
  });
}

/// A straight line through a pole: there is no integral.
TEST(paths, through_poles_are_refused) {
  run_cases("paths", "through poles", 8, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const term pole = point(m, 1);
    const term step = point(m, 1);
    if (step.is("0")) return;
    const term g = call("exp", entire(m, z, 1));
    const term first = pole - m.positive_rational() * step;
    const term last = m.one_in(3) ? pole : pole + m.positive_rational() * step;
    const path_case line{g / power(z - pole, m.between(1, 3)), joined({first, last}), "",
                         some_digits(m)};
    const contour_integral result = computed(line, c);
    count(result, c);
    ++c.checks;
    if (result.verdict != status::certified) return;
    ++c.wrong;
    ADD_FAILURE() << "certified, though there is a pole at " << pole.text() << " on the path\n  "
                  << command_of(line) << "\n  " << text_of(result.enclosure);
  });
}

/// Roots and logarithms with a cut: by their antiderivatives on paths that do not cross it; refused
/// across.
TEST(paths, cuts_are_not_crossed) {
  run_cases("paths", "cuts", 20, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const term centre = point(m, 1);
    const term w = z - centre;
    const term e = m.exponent_between(-0.9, 3);
    const bool is_log = m.one_in(3);
    const bool is_root = !is_log && m.one_in(2);
    const term f = is_log ? call("log", w) : is_root ? call("sqrt", w) : power(w, e);
    const term whole = is_log    ? w * (call("log", w) - 1)
                       : is_root ? 2 * w * call("sqrt", w) / 3
                                 : power(w, e + 1) / (e + 1);
    // Two points in one half plane; or one in each, joined on the left of the centre.
    const bool crosses = m.one_in(2);
    const term up = m.positive_rational();
    const term down = m.positive_rational();
    const term left = m.positive_rational();
    const term right = m.positive_rational();
    const term first = crosses ? centre - left + up * i : centre - left + up * i;
    const term last = crosses ? centre - right - down * i : centre + right + down * i;
    const path_case line{f, joined({first, last}), "", some_digits(m)};
    const auto exact = is_root || is_log ? std::nullopt : read(e).exact_value();
    const bool is_entire = exact && denominator(*exact) == 1;
    const contour_integral result = computed(line, c);
    count(result, c);
    if (crosses && !is_entire) {
      ++c.checks;
      if (result.verdict != status::certified) return;
      ++c.wrong;
      ADD_FAILURE() << "certified across the cut\n  " << command_of(line);
      return;
    }
    compare(result.enclosure, value_at(whole, last) - value_at(whole, first), command_of(line),
            "antiderivative " + whole.text(), c);
  });
}

}  // namespace paths_test
}  // namespace polhode::differential
