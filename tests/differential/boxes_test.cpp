// Integrals with parameters in boxes: the integral at every point of the box must lie in the
// enclosure.

#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "integrals.hpp"
#include "polhode/arithmetic/text.hpp"
#include "quadrature/boxes/parametric_integrand.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode::differential {
namespace boxes_test {

const term x = "x";
const term a = "a";
const term b = "b";

struct box_case {
  term integrand = 0;
  term from = 0;
  term to = 0;
  std::array<std::pair<term, term>, 2> sides;  // of a and b
  long boxes = 1;
};

std::string command_of(const box_case& c) {
  return fmt::format(
      "polhode integrate \" {}\" --from \" {}\" --to \" {}\" --let \"a=[{}, {}]\" --let \"b=[{}, "
      "{}]\" "
      "--boxes {}",
      c.integrand.text(), c.from.text(), c.to.text(), c.sides[0].first.text(),
      c.sides[0].second.text(), c.sides[1].first.text(), c.sides[1].second.text(), c.boxes);
}

/// A side between low and high: narrow or wide, or a point.
std::pair<term, term> side(maker& m, double low, double high) {
  const double start = m.within(low, high);
  const term lower = m.decimal(start);
  if (m.one_in(10)) return {lower, lower};
  return {lower, lower + m.decimal(m.scattered(1e-9, high - start + 1e-8))};
}

box_case random_box(maker& m) {
  box_case c;
  c.sides = {side(m, 0.2, 2), side(m, 0.2, 2)};
  c.boxes = m.one_in(3) ? m.between(2, 4) : 1;
  c.to = m.near(m.within(0.3, 3));
  switch (m.between(0, 9)) {
    case 0:
      c.integrand = call("exp", -(a * x)) * call("cos", b * x);
      break;
    case 1:
      c.integrand = 1 / (a + b * power(x, 2));
      break;
    case 2:
      c.integrand = call("sqrt", 1 - a / 3 * power(call("sin", b * x), 2));
      break;
    case 3:
      c.integrand = power(a + x, 5) / (1 + b * x);
      break;
    case 4:
      c.integrand = call("log", a + b * x);
      break;
    case 5:
      c.integrand = call("sin", a * x + b) * m.gentle(x);
      break;
    case 6:
      c.integrand = call("exp", -(a * power(x, 2))) * b;
      c.to = "inf";
      break;
    case 7:
      c.integrand = call("sqrt", x) * call("exp", a * x - b);
      break;
    case 8:
      c.integrand = power(1 + a * call("exp", b * x), m.between(2, 60));
      break;
    default:
      c.integrand = call("atan", a * x / b) + (a - b) * x;
  }
  return c;
}

box_integral computed(const box_case& c) {
  detail::parameter_box box;
  for (const auto& [lower, upper] : c.sides) {
    box.emplace_back(*read(lower).exact_value(), *read(upper).exact_value());
  }
  const end_point to = c.to.is("inf") ? end_point::infinity() : end_point_of(read(c.to));
  return detail::integrate_function_over_box(
      parametric_integrand_of(read(c.integrand, {"x", "a", "b"})), end_point_of(read(c.from)), to,
      box, {.digits = 12, .most_boxes = c.boxes, .most_evaluations = 500});
}

TEST(boxes, hold_the_integral_at_their_points) {
  run_cases("boxes", "parameters in boxes", 20, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const box_case given = random_box(m);
    under_way(command_of(given));
    ++c.cases;
    const box_integral whole = computed(given);
    c.computed += whole.integrals;
    ++(whole.verdict == status::certified ? c.certified : c.refused);
    if (!whole.enclosure.is_bounded()) return;
    for (int k = 0; k < 3; ++k) {
      std::array<term, 2> at{0, 0};
      for (std::size_t j = 0; j < 2; ++j) {
        const auto& [lower, upper] = given.sides[j];
        const long eighths = m.one_in(2) ? m.any_of({0L, 8L}) : m.between(0, 8);
        at[j] = lower + (upper - lower) * (term(eighths) / 8);
      }
      piece p{substituted(substituted(given.integrand, "a", at[0]), "b", at[1]), given.from,
              given.to, 14};
      const integral i = computed(p);
      ++c.computed;
      if (!i.enclosure.is_bounded()) continue;
      ++c.checks;
      if (overlaps(i.enclosure, whole.enclosure)) continue;
      ++c.wrong;
      ADD_FAILURE() << command_of(given) << "\n  " << to_decimal(whole.enclosure, 20)
                    << "\ndoes not hold that of a point of the box\n"
                    << command_of(p) << "\n  " << to_decimal(i.enclosure, 20);
      return;
    }
  });
}

}  // namespace boxes_test
}  // namespace polhode::differential
