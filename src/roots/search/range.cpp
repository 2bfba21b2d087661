#include "range.hpp"

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/interval.hpp"

namespace polhode::detail {

namespace {

/// The rational numbers around an end, so that the interval is not cut short.
std::optional<rational> outer_end(const end_point& end, bool is_lower) {
  if (end.infinite_sign() != 0) return std::nullopt;
  if (end.exact()) return end.exact();
  const ball x = end.at(128);
  if (!x.is_bounded()) {
    throw input_error(
        "an end of the interval is not defined: it must be a real number, or an infinity");
  }
  return is_lower ? lower_rational(x) : upper_rational(x);
}

/// Ends that are not exact, and are nearer to each other than the numbers of outer_end show.
void expect_in_order(const end_point& lower, const end_point& upper) {
  if (lower.infinite_sign() != 0 || upper.infinite_sign() != 0) return;
  if (lower.exact() && upper.exact()) return;
  constexpr precision most = 1024;
  for (precision p = 128; p <= most; p *= 2) {
    const ball low = lower.at(p);
    const ball high = upper.at(p);
    if (certainly_less(high, low)) {
      throw input_error(
          "the interval is the wrong way round: its lower end is greater than its upper end");
    }
    if (certainly_less_equal(low, high)) return;
  }
}

}  // namespace

exact_interval range_around(const end_point& lower, const end_point& upper) {
  if (lower.infinite_sign() > 0 || upper.infinite_sign() < 0) {
    throw input_error(
        "the interval is the wrong way round: an infinite lower end must be -inf, an infinite "
        "upper end inf");
  }
  exact_interval range{outer_end(lower, true), outer_end(upper, false)};
  if (range.is_bounded() && *range.lower > *range.upper) {
    throw input_error(
        "the interval is the wrong way round: its lower end is greater than its upper end");
  }
  expect_in_order(lower, upper);
  return range;
}

side side_of(const root_region& given, const end_point& end, bool is_lower, const real_function& f,
             root_region& sharper) {
  if (end.infinite_sign() != 0) return side::inside;
  const bool is_proved = is_one_root(given.verdict);
  for (const long digits : {0L, 40L, 300L}) {
    if (digits > 0 && !is_proved) break;
    if (digits > 0) {
      const ball finer = intersection(refine(sharper, digits).enclosure, sharper.enclosure);
      if (!finer.is_undefined()) sharper.enclosure = finer;
    }
    const precision p = sharper.enclosure.precision() + 64;
    if (end.exact() && sharper.exact) {
      const bool in = is_lower ? *sharper.exact >= *end.exact() : *sharper.exact <= *end.exact();
      return in ? side::inside : side::outside;
    }
    const ball e = end.at(p);
    const ball& x = sharper.enclosure;
    if (is_lower ? certainly_less(x, e) : certainly_less(e, x)) return side::outside;
    if (is_lower ? certainly_less_equal(e, x) : certainly_less_equal(x, e)) return side::inside;
    // The end itself, exactly a root?
    const bool is_in_region = end.exact() ? contains(x, *end.exact()) : contains(x, e);
    if (end.form() && is_proved && is_in_region) {
      const auto s = f.structure(function_structure::variable_at(*end.form(), 0, p));
      if (s && s->series() && settled((*s->series())[0]).is_zero()) {
        sharper.exact = end.exact();
        return side::inside;
      }
    }
  }
  return side::undecided;
}

}  // namespace polhode::detail
