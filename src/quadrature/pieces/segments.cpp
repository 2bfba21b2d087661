#include "segments.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "breaks.hpp"
#include "end_segments.hpp"
#include "oscillation.hpp"
#include "polhode/arithmetic/text.hpp"
#include "quadrature/base/approximate.hpp"
#include "quadrature/ends/tail_series.hpp"
#include "quadrature/formula/formula_graph.hpp"
#include "quadrature/formula/periods.hpp"

namespace polhode::detail {

using namespace ends;  // NOLINT(google-build-using-namespace)

namespace {

/// About log2 of the largest |f| at a few points p + s t; 0 where f is undefined or 0 at all of
/// them.
double log2_of_samples(const integrand& f, const ball& p, const ball& s,
                       std::initializer_list<long> eighths) {
  const auto at = f.evaluator(64);
  double size = -infinite;
  for (const long k : eighths) {
    const ball value = at(p + s * k / 8);
    if (value.is_bounded() && !value.magnitude_upper().is_zero()) {
      size = std::max(size, static_cast<double>(value.magnitude_upper().log2_floor()));
    }
  }
  return std::isfinite(size) ? size : 0;
}

double approximate_log2_of(const ball& x) {
  return x.magnitude_upper().is_zero() ? 0 : static_cast<double>(x.magnitude_upper().log2_floor());
}

/// The least Y = 1/t >= 1/r, to about a tenth, at which what is left is at most `goal`; 0 where
/// there is none.
double cut_for(const std::function<magnitude(const ball& y)>& left, double r,
               const magnitude& goal) {
  const auto enough = [&](double y) { return left(ball::exactly(y, 64)) <= goal; };
  double high = 1 / r;
  while (high < 0x1p40 / r && !enough(high)) high *= 2;
  if (!enough(high)) return 0;
  double low = high / 2;
  for (int k = 0; k < 6 && low >= 1 / r; ++k) {
    const double middle = (low + high) / 2;
    (enough(middle) ? high : low) = middle;
  }
  return high;
}

/// The range in affine segments, cut at the breaks of f.
void add_analytic_pieces(preparation& result, const integrand& f, const end_point& a,
                         const end_point& b, long bits) {
  const pieces_of_range parts = analytic_pieces(f, a, b, bits);
  result.remainder += parts.remainder;
  result.has_tail = result.has_tail || parts.has_remainder;
  for (const piece& p : parts.pieces) {
    result.segments.push_back(affine_segment(p.f, p.left, p.right));
    result.parts.push_back({p.left, p.right});
  }
}

/// A function that decays exponentially: at infinity, from x = s on, or at a finite end p, as
/// exp(-1/x) at 0. It is cut off where the rest is less than about 2^-bits of the largest value
/// seen. At infinity x is s y^root.
bool add_decaying_part(preparation& result, const integrand& f, const end_of_range& end,
                       int direction, long bits, long root) {
  const ball s = end.distance.at(192);
  const ball p = end.at.at(192);
  const double size =
      end.infinite
          ? log2_of_samples(f, p.with_precision(64), s.with_precision(64), {8, 9, 12, 20, 40})
          : log2_of_samples(f, p.with_precision(64), s.with_precision(64), {1, 2, 4, 7, 8});
  // Numbers have exponents down to about -2^30; where the samples lie far from a peak they tell
  // nothing of it.
  constexpr double least_goal = -0x1p29;
  const double log2_goal = std::max(size - 1.05 * static_cast<double>(bits) - 48, least_goal);
  const magnitude goal = magnitude::power_of_two(static_cast<long>(log2_goal));
  const auto tail_within = [&](double r) {
    const auto with_orders = [&](int orders) {
      return f.near_infinity(
          end.infinite ? tail_series::argument(exactly(end.distance), r, orders, root)
                       : tail_series::argument(exactly(end.at), exactly(end.distance), r, orders));
    };
    // Few orders cost less and mostly suffice.
    tail_series tail = with_orders(2);
    return tail.is_blocked() ? with_orders(end_series::most_orders) : tail;
  };
  // What is not known so near to the end is hardly known farther away.
  constexpr double least_r = 0x1p-64;
  if (tail_within(least_r).is_blocked()) return false;
  for (const double r : {0.5, 0x1p-2, 0x1p-4, 0x1p-6, 0x1p-8, 0x1p-12, 0x1p-16, 0x1p-24, 0x1p-32,
                         0x1p-48, least_r}) {
    const tail_series tail = tail_within(r);
    if (tail.is_blocked()) continue;
    const auto left = [&](const ball& y) {
      return end.infinite ? tail.integral_beyond(y, root) : tail.integral_before(y);
    };
    const double y = cut_for(left, r, goal);
    if (y == 0) continue;
    const magnitude rest = multiply_up(left(ball::exactly(y, 64)), s.magnitude_upper());
    result.remainder = result.remainder.enlarged(rest);
    result.has_tail = true;
    const rational exact_y = lower_rational(ball::exactly(y, 64));
    rational factor = end.infinite ? rational(1) : rational(1 / exact_y);
    for (long k = 0; end.infinite && k < root; ++k) factor *= exact_y;
    const end_point far = sum_of(end.at, end.distance, factor);
    result.parts.push_back(end.part(end.end, far, direction));
    const part_done rest_of_it = end.part(far, end.start, direction);
    add_analytic_pieces(result, f, rest_of_it.from, rest_of_it.to, bits);
    return true;
  }
  return false;
}
/// The same with the roots that make whole powers of most broken ones.
bool add_decaying_part(preparation& result, const integrand& f, const end_of_range& end,
                       int direction, long bits) {
  for (const long root : {1L, 2L, 3L, 6L}) {
    if (add_decaying_part(result, f, end, direction, bits, root)) return true;
    if (!end.infinite) break;
  }
  return false;
}

void require_tiled(const std::vector<part_done>& parts, const end_point& a, const end_point& b) {
  if (!is_tiled(parts, a, b)) {
    throw std::logic_error("integrate: internal error: the pieces of a range do not tile it");
  }
}

/// is_outermost: no change of the variable led here. One may then come before what would do as
/// well, and a divergence is proved.
void add_part(preparation& result, const integrand& f, const end_of_range& end, int direction,
              long bits, bool is_outermost = true);

/// A function that oscillates ever faster towards a finite end, or without an end up to infinity.
bool add_oscillating_part(preparation& result, const integrand& f, const end_of_range& end,
                          int direction, const std::string& place, long bits) {
  const ball s = end.distance.at(64);
  const ball p = end.at.at(64);
  const double size = end.infinite
                          ? log2_of_samples(f, p, s, {8, 9, 12, 20, 40}) + approximate_log2_of(s)
                          : log2_of_samples(f, p, s, {1, 2, 4, 7, 8}) + approximate_log2_of(s);
  const std::optional<oscillating_end> found =
      oscillations_at(f, end.at, end.distance, end.infinite, direction,
                      size - 1.05 * static_cast<double>(bits) - 48);
  if (!found) return false;
  if (found->steady) {
    // In y, from Y0 to infinity.
    preparation steady;
    const end_point start(found->start);
    add_part(steady, *found->steady, end_of_range::infinity(1, start), 1, bits);
    if (steady.why == reason::none) require_tiled(steady.parts, start, end_point::infinity());
    result.segments.insert(result.segments.end(), steady.segments.begin(), steady.segments.end());
    result.remainder += steady.remainder;
    if (steady.why != reason::none) {
      // The other end may have failed before; then that stays so.
      result.why = steady.why;
      result.obstacle = steady.why == reason::not_integrable
                            ? "the integrand grows too fast at " + place
                            : steady.obstacle;
      return true;
    }
  }
  for (const segment& line : found->segments) result.segments.push_back(line);
  result.remainder = result.remainder.enlarged(found->rest);
  result.has_tail = true;
  const end_point far = sum_of(end.at, end.distance, found->far);
  result.parts.push_back(end.part(end.end, far, direction));
  const part_done rest_of_it = end.part(far, end.start, direction);
  add_analytic_pieces(result, f, rest_of_it.from, rest_of_it.to, bits);
  return true;
}

/// The change of the variable to x = p + sigma e^-s, at infinity x = sigma e^s, in which the end is
/// at s = infinity: over s >= start the integral of f is that of g(s) = f(x) |dx/ds|. dx/ds has one
/// sign, so that both converge or neither does.
struct exponential_change {
  integrand g;
  int sigma = 1;
  end_point start = end_point(1);
};
std::optional<exponential_change> exponential_change_for(const integrand& f,
                                                         const end_of_range& end) {
  if (!f.in_exponential) return std::nullopt;
  const ball distance = end.distance.at(64);
  if (!certainly_positive(distance) && !certainly_negative(distance)) return std::nullopt;
  const int side = certainly_positive(distance) ? 1 : -1;
  if (f.growth) {
    // The oscillations of a power of the distance would be followed as far as the exponential takes
    // them.
    const growth_bound seen = f.growth(growth_bound::argument(
        exactly(end.at), exactly(end.distance), end.infinite ? -1 : 1, 0x1p-8));
    if (seen.oscillates()) return std::nullopt;
  }
  std::optional<integrand> g = f.in_exponential(end.end, side);
  if (!g) return std::nullopt;
  // e^-s0 below the distance, or e^s0 above the start.
  const ball logarithm = log(abs(distance));
  constexpr double most = 1e15;
  const double least = double_interval::from_ball(end.infinite ? logarithm : -logarithm).upper();
  if (!(least < most)) return std::nullopt;
  const long s0 = std::max(1L, static_cast<long>(std::floor(least)) + 2);
  return exponential_change{std::move(*g), side, end_point(s0)};
}

/// The integral of f by that of g over s.
bool add_in_exponential(preparation& result, const integrand& f, const end_of_range& end,
                        int direction, const std::string& place, long bits) {
  const auto change = exponential_change_for(f, end);
  if (!change) return false;
  const int side = change->sigma;
  const end_point& start = change->start;
  preparation near;
  // A second change only where nothing else will do: its range would be far greater.
  add_part(near, change->g, end_of_range::infinity(1, start), 1, bits, false);
  if (near.why == reason::not_integrable) {
    result.why = near.why;
    result.obstacle = "the integrand grows too fast at " + place;
    return true;
  }
  if (near.why != reason::none) return false;
  require_tiled(near.parts, start, end_point::infinity());
  const bool to_infinity = end.infinite;
  const auto place_of = [at = end.at, side, to_infinity](const ball& s) {
    const ball step = exp(to_infinity ? s : -s) * side;
    return to_infinity ? step : at.at(s.precision()) + step;
  };
  for (segment& part : near.segments) {
    part.place = [inner = part.place ? part.place : part.position, place_of](const ball& t) {
      return place_of(inner(t));
    };
  }
  result.segments.insert(result.segments.end(), near.segments.begin(), near.segments.end());
  result.remainder += near.remainder;
  result.has_tail = result.has_tail || near.has_tail;
  const end_point far([start, place_of](precision p) { return place_of(start.at(p)); });
  result.parts.push_back(end.part(end.end, far, direction));
  const part_done rest_of_it = end.part(far, end.start, direction);
  add_analytic_pieces(result, f, rest_of_it.from, rest_of_it.to, bits);
  return true;
}

/// A segment that stands for what lies between two points, of which the first is nearer to the end.
void add_segment(preparation& result, segment s, const end_of_range& end, const end_point& near,
                 const end_point& far, int direction) {
  if (direction < 0) {
    s.scale = [scale = s.scale](precision p) { return -scale(p); };
  }
  result.segments.push_back(std::move(s));
  result.parts.push_back(end.part(near, far, direction));
}

/// The exponential begins at t = r0, and w goes so far that the rest is small.
double start_of_exponential(const end_plan& plan) { return plan.r / 8; }
double length_of_exponential(const end_plan& plan, long bits) {
  const double c = static_cast<double>(numerator(plan.exponent) + denominator(plan.exponent)) /
                   static_cast<double>(denominator(plan.exponent));
  return std::ceil((1.05 * static_cast<double>(bits) + 48) * 0.6931 / c);
}

/// Whether regions of x tell f apart as near to the end as the exponential goes: where they do not,
/// panels would be halved for long, and in vain.
bool is_followed_to_end(const integrand& f, const end_of_range& end, const end_plan& plan,
                        long bits) {
  const precision p = bits + 128;
  const double depth = length_of_exponential(plan, bits) / 0.6931;
  constexpr double deepest = 1e6;
  if (!(depth < deepest)) return false;
  const ball size =
      scale(ball::exactly(start_of_exponential(plan)) * ball(1, p), -static_cast<long>(depth));
  const ball side = size * scale(hull(ball(-1, p), ball(1, p)), plan.has_growing_parts ? -16 : -3);
  const complex_ball around{size + side, side};
  const region t = plan.has_growing_parts ? region(around) : region::in_balls(around);
  const region values = f.over(end.at.at(p) + end.distance.at(p) * pow(t, plan.q));
  if (!values.is_analytic() || !plan.has_growing_parts) return values.is_analytic();
  // Where parts are huge, values over regions are of the size of f in narrow regions alone.
  constexpr long slack = 64;
  const ball bound =
      ball(0, 64).enlarged(plan.bounds.front()) * pow(size, ball(plan.exponent - plan.q + 1, 64));
  return values.magnitude_upper() <= scale(bound, slack).magnitude_upper();
}

/// An end that is singular, but integrable: from t = 1 to r0 without the exponential, and from
/// there with it.
void add_exponential_part(preparation& result, const integrand& f, const end_of_range& end,
                          const end_plan& plan, int direction, long bits) {
  const double r0 = start_of_exponential(plan);
  const double length = length_of_exponential(plan, bits);
  const ball remainder = tail_beyond(end, plan, r0, length);
  segment near = exponential_segment(f, end, plan, r0, length);
  const end_point at_1 = end_point([at = near.position](precision p) { return at(ball(1, p)); });
  const end_point at_0 = end_point([at = near.position](precision p) { return at(ball(0, p)); });
  result.parts.push_back(end.part(end.end, at_1, direction));
  result.remainder += direction < 0 ? -remainder : remainder;
  result.has_tail = true;
  add_segment(result, std::move(near), end, at_1, at_0, direction);
  add_segment(result, segment_beyond(r0, f, end, plan), end, at_0, end.start, direction);
}

/// Whether f has a tail in x with an exponential.
bool decays_exponentially(const integrand& f, const end_of_range& end) {
  for (const double r : {0x1p-8, 0x1p-20, 0x1p-40}) {
    const tail_series tail = f.near_infinity(
        end.infinite ? tail_series::argument(exactly(end.distance), r)
                     : tail_series::argument(exactly(end.at), exactly(end.distance), r));
    const ball y = ball::exactly(2 / r, 64);
    const magnitude rest = end.infinite ? tail.integral_beyond(y) : tail.integral_before(y);
    if (!rest.is_infinite()) return true;
  }
  return false;
}

/// The same finite end with a rational distance, somewhat less; nothing where it is rational, or
/// not known to have a sign.
std::optional<end_of_range> with_rational_distance(const end_of_range& end) {
  const ball s = end.distance.at(64);
  if (end.infinite || end.distance.exact()) return std::nullopt;
  if (!certainly_positive(s) && !certainly_negative(s)) return std::nullopt;
  const rational a = lower_rational(s) * rational(certainly_positive(s) ? 7 : 15, 16);
  const rational b = upper_rational(s) * rational(certainly_positive(s) ? 15 : 7, 16);
  const end_point nearer(simplest_between(std::min(a, b), std::max(a, b)));
  return end_of_range{end.at, nearer, false, end.end, sum_of(end.at, nearer, 1)};
}

/// The integral of f up to the end diverges: towards infinity from its start on or from some point
/// beyond it, or after a change of the variable.
bool is_divergent(const integrand& f, const end_of_range& end) {
  if (end.infinite && f.diverges_beyond && end.start.exact()) {
    constexpr unsigned tries = 5;
    for (unsigned k = 0; k < tries; ++k) {
      if (f.diverges_beyond(*end.start.exact() * rational(integer(1) << (4 * k)))) return true;
    }
  }
  const auto change = exponential_change_for(f, end);
  return change && is_divergent(change->g, end_of_range::infinity(1, change->start));
}

/// The part from `end` (t = 0), where f is not regular, to t = 1. direction: 1 where x runs away
/// from the end as the integral does.
void add_part(preparation& result, const integrand& f, const end_of_range& end, int direction,
              long bits, bool is_outermost) {
  const end_plan plan = look_at_end(f, end);
  const std::string place =
      end.infinite ? std::string("infinity") : "x = " + to_decimal(end.at.at(96), 20);
  switch (plan.how) {
    case manner::power:
      add_segment(result, power_segment(f, end, plan), end, end.end, end.start, direction);
      return;
    case manner::exponential:
      // A decay as e^(-c s) with a small c reaches so far that x itself tells points apart by very
      // many bits only. And where only the growth is known, as of x^x, the formula in s has its
      // powers worked out, and larger panels; but what decays as exp(-x^2) does has narrow peaks in
      // s.
      if (is_outermost &&
          (plan.exponent < rational(-63, 64) ||
           (plan.has_growth_only && !decays_exponentially(f, end))) &&
          add_in_exponential(result, f, end, direction, place, bits)) {
        return;
      }
      add_exponential_part(result, f, end, plan, direction, bits);
      return;
    case manner::divergent:
      result.why = reason::not_integrable;
      result.obstacle = "the integrand grows too fast at " + place;
      return;
    default:
      break;
  }
  // The scale of t is in each coefficient: with a rational one more of them cancel exactly.
  const auto nearer = with_rational_distance(end);
  if (nearer && look_at_end(f, *nearer).how != manner::unknown) {
    const auto [left, right] =
        direction > 0 ? std::pair(nearer->start, end.start) : std::pair(end.start, nearer->start);
    result.segments.push_back(regular_segment(f, left, right));
    result.parts.push_back({left, right});
    return add_part(result, f, *nearer, direction, bits, is_outermost);
  }
  if (add_decaying_part(result, f, end, direction, bits)) return;
  if (add_oscillating_part(result, f, end, direction, place, bits)) return;
  if (add_in_exponential(result, f, end, direction, place, bits)) return;
  const auto by_growth = last_resort(f, end, plan);
  if (by_growth) {
    if (by_growth->how == manner::divergent) {
      result.why = reason::not_integrable;
      result.obstacle = "the integrand grows too fast at " + place;
      return;
    }
    if (is_followed_to_end(f, end, *by_growth, bits)) {
      add_exponential_part(result, f, end, *by_growth, direction, bits);
      return;
    }
  }
  // The proof is dear: where a change of the variable led here, the other ways come first.
  if (is_outermost && is_divergent(f, end)) {
    result.why = reason::not_integrable;
    result.obstacle = end.infinite ? "the integral diverges at infinity"
                                   : "the integrand grows too fast at " + place;
    return;
  }
  if (end.infinite) {
    result.why = reason::not_analytic;
    result.obstacle = by_growth ? "parts of the integrand overflow before its tail is small"
                                : "no proof of decay at infinity (" + plan.obstacle + ")";
    return;
  }
  add_segment(result, affine_segment(f, end.at, end.start), end, end.end, end.start, direction);
}

/// f between two points, as it is known at each of them.
void add_between(preparation& result, const end_point& left, const integrand& at_left,
                 const end_point& right, const integrand& at_right, long bits) {
  const end_of_range at_left_end = end_of_range::finite(left, right);
  const end_of_range at_right_end = end_of_range::finite(right, left);
  const bool left_regular = is_regular(at_left, at_left_end);
  const bool right_regular = is_regular(at_right, at_right_end);
  if (left_regular && right_regular) {
    result.segments.push_back(regular_segment(at_left, left, right));
    result.parts.push_back({left, right});
  } else if (right_regular) {
    add_part(result, at_left, at_left_end, 1, bits);
  } else if (left_regular) {
    add_part(result, at_right, at_right_end, -1, bits);
  } else {
    const end_point middle = sum_of(left, difference(right, left), rational(1, 2));
    add_part(result, at_left, end_of_range::finite(left, middle), 1, bits);
    add_part(result, at_right, end_of_range::finite(right, middle), -1, bits);
  }
}

/// The finite range, cut at the given points, and between these at the breaks of f.
void add_finite_range(preparation& result, const integrand& f, const end_point& left,
                      const end_point& right, const std::vector<end_point>& cuts, long bits) {
  std::vector<end_point> ends{left};
  std::copy_if(cuts.begin(), cuts.end(), std::back_inserter(ends),
               [&](const end_point& cut) { return is_inside(cut, left, right); });
  ends.push_back(right);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const pieces_of_range parts = analytic_pieces(f, ends[i], ends[i + 1], bits);
    result.remainder += parts.remainder;
    result.has_tail = result.has_tail || parts.has_remainder;
    for (const piece& p : parts.pieces) {
      add_between(result, p.left, p.at_left, p.right, p.at_right, bits);
    }
  }
}

/// The part from sign * infinity to sign * 2^e, beyond the start, every cut and, if that can be,
/// every break: f is asked for nothing on the other side of the start. Returns that point.
end_point add_infinite_part(preparation& result, const integrand& f, const end_point& start,
                            int sign, const std::vector<end_point>& cuts, long bits) {
  magnitude reach = start.at(64).magnitude_upper();
  for (const end_point& q : cuts) reach = max(reach, q.at(64).magnitude_upper());
  const auto least = static_cast<unsigned long>(
      reach.is_zero() ? 0 : std::max(reach.log2_floor() + 1, std::int64_t{0}));
  integer c;
  mpz_ui_pow_ui(c.backend().data(), 2, exponent_beyond_breaks(f, least, sign));
  end_point point(rational(sign * c));
  add_part(result, f, end_of_range::infinity(sign, point), sign, bits);
  return point;
}

}  // namespace

bool is_tiled(const std::vector<part_done>& parts, const end_point& a, const end_point& b) {
  std::vector<bool> is_used(parts.size(), false);
  end_point reached = a;
  for (std::size_t count = 0; count < parts.size(); ++count) {
    std::size_t next = 0;
    while (next < parts.size() && (is_used[next] || !parts[next].from.is_same_as(reached))) ++next;
    if (next == parts.size()) return false;
    is_used[next] = true;
    reached = parts[next].to;
  }
  return !parts.empty() && reached.is_same_as(b);
}

/// a < q < b, certainly: what is proved of f at q is said of the integral.
bool is_inside(const end_point& q, const end_point& a, const end_point& b) {
  const precision p = 192;
  const ball x = q.at(p);
  return (a.infinite_sign() < 0 || certainly_less(a.at(p), x)) &&
         (b.infinite_sign() > 0 || certainly_less(x, b.at(p)));
}

bool can_cut_at(const integrand& f, const end_point& q) {
  const auto is_understood = [&](int side) {
    // The distance is the number that it is: coefficients cancel exactly then.
    const end_of_range end{q, end_point(side), false, q, sum_of(q, end_point(side), 1)};
    if (look_at_end(f, end).how != manner::unknown) return true;
    const tail_series near =
        f.near_infinity(tail_series::argument(exactly(q), known_number(rational(side)), 0x1p-8));
    if (!near.is_blocked() && !near.integral_before(ball(1L << 20, 64)).is_infinite()) return true;
    constexpr long few_bits = 64;
    preparation tried;
    return add_in_exponential(tried, f, end, side, "", few_bits) || is_divergent(f, end);
  };
  return is_understood(-1) && is_understood(1);
}

namespace {

/// That of one period, times their count, and that of the rest.
preparation prepare_periods(const integrand& f, const end_point& a, const whole_periods& periods,
                            const std::vector<end_point>& cuts, long bits) {
  preparation result = prepare(f, a, periods.first_end, cuts, bits);
  for (segment& s : result.segments) {
    s.scale = [scale = s.scale, count = periods.count](precision p) { return scale(p) * count; };
  }
  result.remainder = result.remainder * periods.count;
  result.log2_periods = static_cast<long>(mpz_sizeinbase(periods.count.backend().data(), 2));
  if (result.why != reason::none || !periods.rest_end) return result;
  preparation rest = prepare(f, a, *periods.rest_end, cuts, bits);
  std::move(rest.segments.begin(), rest.segments.end(), std::back_inserter(result.segments));
  result.remainder += rest.remainder;
  result.has_tail = result.has_tail || rest.has_tail;
  result.why = rest.why;
  result.obstacle = rest.obstacle;
  return result;
}

}  // namespace

preparation prepare(const integrand& f, const end_point& a, const end_point& b,
                    const std::vector<end_point>& cuts, long bits) {
  if (!a.is_infinite() && !b.is_infinite()) {
    if (const auto periods = whole_periods_of(f, a, b)) {
      preparation result = prepare_periods(f, a, *periods, cuts, bits);
      result.parts = {{a, b}};
      return result;
    }
  }
  preparation result;
  const bool both = a.infinite_sign() != 0 && b.infinite_sign() != 0;
  const end_point zero(0);
  const end_point left =
      a.infinite_sign() != 0 ? add_infinite_part(result, f, both ? zero : b, -1, cuts, bits) : a;
  const end_point right =
      b.infinite_sign() != 0 ? add_infinite_part(result, f, both ? zero : a, 1, cuts, bits) : b;
  add_finite_range(result, f, left, right, cuts, bits);
  if (result.why == reason::none) require_tiled(result.parts, a, b);
  return result;
}

}  // namespace polhode::detail
