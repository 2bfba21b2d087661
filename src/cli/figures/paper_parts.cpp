// What the figures of the paper have in common.

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cli/options/motion_option.hpp"
#include "paper_figures.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "proofs/printed_values.hpp"

namespace polhode::cli::paper {

std::string solid(const char* colour) { return fmt::format("lines lw 2 lc rgb '{}'", colour); }
std::string dashed(const char* colour) {
  return fmt::format("lines lw 2 dt (8,5) lc rgb '{}'", colour);
}
std::string thin(const char* colour) { return fmt::format("lines lw 1 lc rgb '{}'", colour); }
std::string discs(const char* colour) {
  return fmt::format("points pt 7 ps 0.6 lc rgb '{}'", colour);
}
std::string circles(const char* colour) {
  return fmt::format("points pt 6 ps 0.8 lw 2 lc rgb '{}'", colour);
}

ball enclosed(const enclosing_function& f, const std::string& what, long digits) {
  return certain(number_to_digits(f, digits, ample_guard(digits)), what, digits);
}

coordinate negated(const coordinate& x) {
  return std::visit([](const auto& value) { return coordinate(-value); }, x);
}

coordinate multiple_of_pi(const rational& factor, long digits) {
  if (factor == 0) return rational(0);
  return enclosed([&](precision p) { return factor * pi(p); }, "a multiple of pi", digits);
}

coordinate shifted_by_pi(const coordinate& x, long digits) {
  return enclosed(
      [&](precision p) {
        return std::holds_alternative<rational>(x) ? ball(std::get<rational>(x), p) + pi(p)
                                                   : std::get<ball>(x) + pi(p);
      },
      "an angle", digits);
}

std::vector<rational> equally_spaced(const rational& low, const rational& high, long n) {
  std::vector<rational> result;
  result.reserve(static_cast<std::size_t>(n) + 1);
  for (long k = 0; k <= n; ++k) result.emplace_back(low + (high - low) * k / n);
  return result;
}

std::vector<rational> dense_near_zero(const rational& end, long n) {
  std::vector<rational> result;
  result.reserve(static_cast<std::size_t>(n) - 1);
  for (long k = 1; k < n; ++k) result.emplace_back(end * k * k / (n * n));
  return result;
}

std::vector<rational> approaching(const rational& start, int side, long smallest,
                                  const rational& low, const rational& high) {
  std::vector<rational> result;
  rational power(side);
  for (long k = 1; k <= smallest; ++k) {
    power /= 10;
    for (const int leading : {1, 2, 5}) {
      const rational x(start + leading * power);
      if (low <= x && x <= high) result.push_back(x);
    }
  }
  return result;
}

std::vector<rational> merged(std::vector<std::vector<rational>> sets) {
  std::vector<rational> result;
  for (std::vector<rational>& set : sets) {
    std::move(set.begin(), set.end(), std::back_inserter(result));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// ---------------------------------------------------------------------------------------------
// Curves that several figures have

figure_curve straight(const std::string& name, const std::string& style, const figure_point& from,
                      const figure_point& to, const std::string& title) {
  return {name, {{style, title}}, {{from, to}}};
}

figure_curve turning_curve(const rational& b, bool with_mirror, const std::string& title,
                           long digits) {
  constexpr long steps =
      61;  // prime: sin^2 (k pi/122) is never rational (Niven), so that its digits can be certain
  figure_curve result{"S", {{dashed(red), title}}, {{{rational(0), rational(0)}}}};
  std::vector<figure_point>& points = result.parts.front();
  for (long k = 1; k < steps; ++k) {
    const rational turn(k, 2 * steps);
    const ball c =
        enclosed([&](precision p) { return -b * square(sin(turn * pi(p))); }, "S", digits);
    points.push_back({c, multiple_of_pi(turn, digits)});
  }
  points.push_back({rational(-b), multiple_of_pi(rational(1, 2), digits)});
  for (long k = steps - 1; with_mirror && k >= 0; --k) {
    const coordinate c = points[static_cast<std::size_t>(k)].x;
    points.push_back({c, multiple_of_pi(rational(2 * steps - k, 2 * steps), digits)});
  }
  return result;
}

std::vector<figure_point> twists(const body& rigid, const std::vector<rational>& motions,
                                 long digits) {
  std::vector<figure_point> result;
  result.reserve(motions.size());
  for (const rational& c : motions) {
    result.push_back(
        {c, certain(defect_to_digits(rigid, c, digits), "epsilon at c = " + to_text(c), digits)});
  }
  return result;
}

std::vector<figure_point> phases(const body& rigid, const std::vector<rational>& motions,
                                 long digits) {
  std::vector<figure_point> result;
  result.reserve(motions.size());
  for (const rational& c : motions) {
    result.push_back({c, certain(montgomery_phase_to_digits(rigid, c, digits),
                                 "the phase at c = " + to_text(c), digits)});
  }
  return result;
}

ball phase_limit(const body& rigid, const rational& c, long digits) {
  return certain(montgomery_phase_limit_to_digits(rigid, c, digits), "the limit of the phase",
                 digits);
}

std::string geometric_constant_of(const body& rigid) {
  constexpr long shown = 5;
  if (const auto exact = rigid.exact_geometric_constant()) return to_text(*exact);
  return to_decimal(enclosed([&](precision p) { return rigid.geometric_constant(p); }, "I", shown),
                    shown);
}
std::string second_geometric_constant_of(const body& rigid) {
  constexpr long shown = 5;
  if (const auto exact = rigid.exact_second_geometric_constant()) return to_text(*exact);
  return to_decimal(
      enclosed([&](precision p) { return rigid.second_geometric_constant(p); }, "J", shown), shown);
}

std::string with_constant(const std::string& a, const body& rigid) {
  return fmt::format("a = {} ({}): I = {}", a, to_text(rigid.kind()), geometric_constant_of(rigid));
}

body schematic_body() { return proofs::with_ab("0.5", "0.25"); }

}  // namespace polhode::cli::paper
