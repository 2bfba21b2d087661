#include "polhode/verify/second_opinion.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode {
namespace {

/// Both ends, with so many digits.
std::string ends_of(const ball& x, long digits) {
  if (!x.is_bounded()) return "undefined";
  const decimal_enclosure d = to_decimal_enclosure(x, digits);
  return d.exact ? d.value : fmt::format("[{}, {}]", d.lower, d.upper);
}

/// How many digits show that the sets have no common number: those that their size has before their
/// distance, and a few.
long digits_of_gap(const ball& x, const ball& y) {
  constexpr long few = 20;
  const magnitude gap = (x - y).magnitude_lower();
  const magnitude size = max(x.magnitude_upper(), y.magnitude_upper());
  if (gap.is_zero() || size.is_zero() || size.is_infinite()) return few;
  const std::int64_t bits = std::max<std::int64_t>(size.log2_floor() - gap.log2_floor(), 0);
  return few + static_cast<long>(bits / 3);
}

}  // namespace

void contradict(std::string_view what, const finding<std::string>& first,
                const finding<std::string>& second) {
  throw contradiction_error(
      fmt::format("INTERNAL ERROR: two proofs contradict each other, so one of them is wrong\n"
                  "  of:           {}\n"
                  "  first route:  {}\n"
                  "                {}\n"
                  "  second route: {}\n"
                  "                {}",
                  what, first.route, first.enclosure, second.route, second.enclosure));
}

void expect_overlap(std::string_view what, const finding<ball>& first,
                    const finding<ball>& second) {
  if (overlaps(first.enclosure, second.enclosure)) return;
  const long digits = digits_of_gap(first.enclosure, second.enclosure);
  contradict(what, {first.route, ends_of(first.enclosure, digits)},
             {second.route, ends_of(second.enclosure, digits)});
}

void expect_overlap(std::string_view what, const finding<complex_ball>& first,
                    const finding<complex_ball>& second) {
  const auto part = [&](const char* name, const ball& x, const ball& y) {
    expect_overlap(fmt::format("{}, its {} part", what, name), {first.route, x}, {second.route, y});
  };
  part("real", first.enclosure.re, second.enclosure.re);
  part("imaginary", first.enclosure.im, second.enclosure.im);
}

magnitude confirming_radius(const ball& first, long digits) {
  const magnitude unit =
      divide_down(first.magnitude_lower(), pow(ball(10, 64), digits).magnitude_upper());
  return max(first.radius(), unit);
}
magnitude confirming_radius(const complex_ball& first, long digits) {
  return max(confirming_radius(first.re, digits), confirming_radius(first.im, digits));
}

bool proved_roots::is_resolved() const {
  return complete && std::all_of(roots.begin(), roots.end(),
                                 [](const proved_root& r) { return r.is_resolved(); });
}

bool second_opinion::agrees() const {
  return std::any_of(routes_.begin(), routes_.end(),
                     [](const route_report& r) { return r.agrees(); });
}

}  // namespace polhode
