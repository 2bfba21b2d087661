// The roots of regions, to many digits.

#include <algorithm>

#include "base/worker_threads.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/roots/isolate.hpp"
#include "polynomial/root_bracket.hpp"
#include "search/taylor_bounds.hpp"
#include "settled_pieces.hpp"
#include "thread_count.hpp"

namespace polhode {

namespace {

/// The half of the enclosure that holds the root of f, which is simple and the only one in it: on
/// either side of it f has one sign. std::nullopt where the signs are not certain.
std::optional<ball> half_with_root(const real_function& f, const ball& enclosure, precision p) {
  const detail::exact_interval whole{lower_rational(enclosure), upper_rational(enclosure)};
  const auto sign_at = [&](const rational& x) { return sign_of(f.at(p)->value(ball(x, p))); };
  const auto is_certain = [](certain_sign s) {
    return s == certain_sign::negative || s == certain_sign::positive;
  };
  const ball middle = enclosure.middle();
  const certain_sign at_middle =
      sign_of(f.at(p)->value(middle.with_precision(std::max(p, middle.precision()))));
  const certain_sign at_upper = sign_at(*whole.upper);
  if (!is_certain(at_middle) || !is_certain(at_upper)) return std::nullopt;
  const rational cut = lower_rational(middle);
  const detail::exact_interval half = at_middle == at_upper
                                          ? detail::exact_interval{whole.lower, cut}
                                          : detail::exact_interval{cut, whole.upper};
  return half.to_ball(std::max(p, enclosure.precision()));
}

/// A narrow ball, inside the enclosure, around the point at which Newton's method with few bits
/// settles; it proves nothing. std::nullopt where it does not settle there.
std::optional<ball> place_by_search(const real_function& f, const ball& enclosure) {
  constexpr precision few_bits = 64;
  constexpr long narrow = 40;  // 2^-40 of its size
  constexpr int most_steps = 8;
  const auto at = f.at(few_bits);
  ball x = enclosure.with_precision(few_bits).middle();
  for (int k = 0; k < most_steps && x.is_bounded(); ++k) {
    const jet<ball, 1> y = at->slope(x);
    const ball step = (y[0] / y[1]).middle();
    x = (x - step).with_precision(few_bits).middle();
    if (!x.is_bounded() || !contains(enclosure, x)) return std::nullopt;
    const magnitude radius = scale(x.magnitude_lower(), -narrow);
    if (step.magnitude_upper() <= radius) {
      const ball place = x.enlarged(radius);
      return contains(enclosure, place) ? std::optional(place) : std::nullopt;
    }
  }
  return std::nullopt;
}

/// Narrows the enclosure of the root of a polynomial, which is simple and the only one in it, by
/// the signs of values: to p bits where these are few, else until Newton's method is faster.
/// Returns the bits that were lost to cancellation.
precision refine_by_signs(const rational_polynomial& given, precision p, refined_root& result) {
  constexpr precision few = 512;
  constexpr precision start_of_newton = 256;
  // The enclosure has the bits with which it was found.
  detail::polynomial_values values(primitive_coefficients(given), result.enclosure.precision());
  detail::exact_interval sharper{lower_rational(result.enclosure),
                                 upper_rational(result.enclosure)};
  precision bits = p <= few ? p : start_of_newton;
  sharper = detail::narrowed(values, sharper, bits);
  precision lost = std::max<precision>(values.last_precision() - bits, 0);
  if (bits < p && !sharper.is_point()) {
    // f' over the enclosure must have a sign for Newton's method.
    const precision work = bits + lost;
    const ball slope = real_function::of(given).at(work)->derivative(sharper.to_ball(work));
    if (slope.is_undefined() || contains_zero(slope)) {
      sharper = detail::narrowed(values, sharper, p);
    }
  }
  result.evaluations_of_f += values.evaluations();
  if (sharper.is_point()) {
    result.exact = *sharper.lower;
    result.enclosure = ball(*sharper.lower, p);
  } else {
    // Not wider than it was, where roots beside it may be.
    result.enclosure = sharper.to_ball(std::max<precision>(p + 16, result.enclosure.precision()));
  }
  return lost;
}

}  // namespace

refined_root refine(const root_region& region, long digits) {
  if (digits < 1) throw std::invalid_argument("refine: at least one digit must be asked for");
  refined_root result;
  result.enclosure = region.enclosure;
  const precision p = bits_for_digits(digits) + 8;
  if (region.exact) {
    result.enclosure = ball(*region.exact, p);
    result.exact = region.exact;
    result.verdict = status::certified;
    return result;
  }
  if (!is_one_root(region.verdict) || !region.simple || !region.function) return result;
  const real_function& f = *region.simple;
  const auto is_narrow = [&](const ball& x) {
    const magnitude size = (contains_zero(x) ? region.box : x).magnitude_upper();
    return x.radius() <= scale(size, -(static_cast<std::int64_t>(p) - 5));
  };
  // Bits beside those of x that f is evaluated with, because it cancels.
  precision more = 0;
  if (f.polynomial()) {
    more = refine_by_signs(*f.polynomial(), p, result);
    if (result.exact || is_narrow(result.enclosure)) {
      result.verdict = status::certified;
      return result;
    }
  }
  const precision most = 8 * p + (1L << 14);
  constexpr int most_halvings = 60;
  int halvings = 0;
  // Newton's steps over wide balls are dear. If a narrow place in the box is proved to hold a root,
  // it is the one that the box holds.
  constexpr long narrow = 32;
  const bool is_wide =
      result.enclosure.radius() > scale(result.enclosure.magnitude_upper(), -narrow);
  std::optional<ball> place =
      f.polynomial() || !is_wide ? std::nullopt : place_by_search(f, result.enclosure);
  if (place && !contains(region.box, *place)) place = std::nullopt;
  while (true) {
    const auto raised = [&](const ball& x) { return x.with_precision(x.precision() + more); };
    const auto value = [&](const ball& x) { return f.at(x.precision() + more)->value(raised(x)); };
    const auto slope = [&](const ball& x) {
      return detail::slope_over(*f.at(x.precision() + more), raised(x), f);
    };
    // A little room, so that a root at the end of its enclosure is inside.
    const ball known = result.enclosure;
    const magnitude before = known.radius();
    const ball room = intersection(known.enlarged(known.radius()), region.box);
    root_enclosure r;
    if (place) {
      r = refine_root(value, slope, *place, p);
      place = std::nullopt;
      if (r.verdict != root_verdict::unique) continue;  // it may lie elsewhere
    } else {
      r = refine_root(value, slope, room.is_undefined() ? known : room, p);
    }
    if (r.verdict == root_verdict::none) {
      throw std::logic_error("refine: the enclosures of f and its derivative contradict");
    }
    result.evaluations_of_f += r.evaluations_of_f;
    result.evaluations_of_derivative += r.evaluations_of_derivative;
    const ball both = intersection(r.root, known);
    result.enclosure = (both.is_undefined() ? r.root : both).with_precision(p + 16);
    if (is_narrow(result.enclosure)) break;
    // Newton's method may not contract yet on a wide enclosure.
    if (result.enclosure.radius() > scale(before, -1) && halvings < most_halvings) {
      ++halvings;
      if (const auto half = half_with_root(f, result.enclosure, p + more)) {
        result.enclosure = *half;
        continue;
      }
    }
    if (more >= most) break;
    more = std::min(std::max<precision>(2 * more, 64), most);
  }
  const ball& x = result.enclosure;
  if (is_narrow(x)) result.verdict = status::certified;
  // An enclosure of one number is the root.
  if (result.verdict == status::certified && x.is_exact()) {
    result.exact = lower_rational(x);
    return result;
  }
  // A short rational number in the enclosure, and exactly a root. It shows in few bits.
  if (result.verdict == status::certified) {
    constexpr precision few = 128;
    constexpr int few_terms = 16;
    constexpr std::size_t most_height = 48;
    const ball coarse = x.with_precision(std::min(few, x.precision()));
    const auto short_one =
        simplest_between(lower_rational(coarse), upper_rational(coarse), few_terms);
    // Rounded to p bits the enclosure may hold a root beside the box; in the box there is one only.
    const auto may_be_root = [&](const rational& q) {
      const ball value = f.at(few)->value(ball(q, few));
      return value.is_undefined() || contains_zero(value);
    };
    if (short_one && rational_polynomial({*short_one}).height() <= most_height &&
        contains(x, *short_one) && contains(region.box, *short_one) && may_be_root(*short_one)) {
      const rational& q = *short_one;
      const auto s = region.function->structure(function_structure::variable_at(q, 0, p));
      if (s && s->series() && settled((*s->series())[0]).is_zero()) {
        result.exact = q;
        result.enclosure = ball(q, p);
      }
    }
  }
  return result;
}

std::vector<refined_root> refine(const std::vector<root_region>& regions, long digits,
                                 int threads) {
  detail::require_threads("refine", threads);
  std::vector<refined_root> result(regions.size());
  const auto step = [&](long i) {
    const auto k = static_cast<std::size_t>(i);
    result[k] = refine(regions[k], digits);
  };
  const auto count = static_cast<long>(regions.size());
  if (threads == 1 || count < 2) {
    for (long i = 0; i < count; ++i) step(i);
  } else {
    detail::worker_threads(threads).for_each(count, step);
  }
  return result;
}

}  // namespace polhode
