#include "segments.hpp"

#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "breaks.hpp"
#include "oscillation.hpp"
#include "polhode/arithmetic/text.hpp"
#include "quadrature/approximate.hpp"
#include "quadrature/formula/periods.hpp"
#include "quadrature/formula/recorded_formula.hpp"
#include "quadrature/rules/periodic.hpp"

namespace polhode::detail {

namespace {

end_point sum_of(const end_point& a, const end_point& b, const rational& factor) {
  if (a.form() && b.form()) return end_point(*a.form() + *b.form() * factor);
  return end_point([=](precision p) { return a.at(p) + b.at(p) * factor; });
}
end_point difference(const end_point& a, const end_point& b) { return sum_of(a, -b, 1); }

/// A limit moved: from it, in the direction of another point.
struct end_of_range {
  end_point at;        // p; for an infinite end, 0
  end_point distance;  // s: the argument is p + s t^q, 0 < t <= 1; at infinity s t^q with q < 0
  bool infinite = false;
  end_point end;    // t = 0: p, or an infinity
  end_point start;  // t = 1: p + s

  [[nodiscard]] static end_of_range finite(const end_point& end, const end_point& start) {
    return {end, difference(start, end), false, end, start};
  }
  /// The infinity of this sign; the start, which is not 0, has the same sign.
  [[nodiscard]] static end_of_range infinity(int sign, const end_point& start) {
    const end_point end = sign > 0 ? end_point::infinity() : -end_point::infinity();
    return {end_point(0), start, true, end, start};
  }
  /// Whether the integral runs to the end: with direction 1 it runs from a finite end, and to an infinite one.
  [[nodiscard]] bool is_reached_last(int direction) const { return (direction > 0) == infinite; }
  /// Between two points, of which the first is nearer to the end.
  [[nodiscard]] part_done part(const end_point& near, const end_point& far, int direction) const {
    return is_reached_last(direction) ? part_done{far, near} : part_done{near, far};
  }
};

/// How an end is dealt with.
enum class manner { regular, power, exponential, divergent, unknown };

struct end_plan {
  manner how = manner::unknown;
  long q = 1;
  double r = 0;           // the series holds for |Re t|, |Im t| <= r
  rational exponent = 0;  // M: F(t) = t^M (G_0 + L G_1 + ...) with the substitution's factor in it
  std::vector<magnitude> bounds;  // of |G_k|
  std::string obstacle;
};

/// |q| t^(q-1) f(p + s t^q): the exponent and the bounds from the series of f.
end_plan plan_from_series(const end_series& series, long q, double r) {
  const end_series h = series.simplified();
  end_plan plan;
  plan.q = q;
  plan.r = r;
  plan.exponent = h.exponent() + (q - 1);
  const auto factor = magnitude::from_integer_up(static_cast<std::uint64_t>(std::abs(q)));
  for (int k = 0; k <= h.log_degree(); ++k) {
    plan.bounds.push_back(multiply_up(h.supremum(k), factor));
  }
  const bool integrable = plan.exponent > -1;
  const bool is_power = h.log_degree() == 0 && denominator(plan.exponent) == 1;
  if (!integrable) {
    plan.how = h.leads_surely() ? manner::divergent : manner::unknown;
    plan.obstacle = "a coefficient that may be 0";
  } else {
    plan.how = is_power ? manner::power : manner::exponential;
  }
  return plan;
}

known_number exactly(const end_point& x) {
  return x.form() ? known_number(*x.form()) : known_number(x.at(192));
}

/// f near an end, with the substitution x = p + s t^q, over the largest of some squares on which its series is
/// known; with few orders first, which cost less and mostly suffice.
end_series series_at_end(const integrand& f, const end_of_range& end, long q, double& r) {
  constexpr std::array<double, 6> sizes{0.5, 0.25, 0x1p-4, 0x1p-8, 0x1p-16, 0x1p-32};
  using remedy = end_series::remedy;
  const known_number p = exactly(end.at);
  const known_number s = exactly(end.distance);
  end_series first;
  double found_r = 0;
  std::optional<end_series> found;  // on a larger square, with a poor bound
  int orders = 2;
  for (std::size_t k = 0; k < sizes.size();) {
    r = sizes.at(k);
    end_series h = f.near_end(end_series::argument(p, s, q, r, orders));
    const bool few_orders = orders < end_series::most_orders;
    const remedy help = h.what_may_help();
    if (h.is_blocked()) {
      if (found) break;
      if (k == 0) first = h;
      if (help == remedy::none || help == remedy::other_root) return h;
      if (help == remedy::smaller_square || !few_orders) ++k;
    } else if (!few_orders || h.simplified().leads_surely()) {
      // On a small square the bound is not far from the value at its centre.
      constexpr long poor = 10;
      const end_series g = h.simplified();
      if (found && multiply_up(g.supremum(g.log_degree()), magnitude::power_of_two(poor)) >
                       found->simplified().supremum(g.log_degree())) {
        break;
      }
      found = h;
      found_r = r;
      if (g.supremum(g.log_degree()) <= multiply_up(g.size_at_0(), magnitude::power_of_two(poor)))
        break;
      ++k;
      continue;
    }
    if (help != remedy::smaller_square) orders = end_series::most_orders;
  }
  if (!found) return first;
  r = found_r;
  return *found;
}

/// Looks at f near an end. Tries substitutions x = p + s t^q for small q.
end_plan look_at_end(const integrand& f, const end_of_range& end) {
  using remedy = end_series::remedy;
  constexpr long most_root = 6;
  end_plan best;
  for (long root = 1; root <= most_root;) {
    const long q = end.infinite ? -root : root;
    double r = 0;
    const end_series h = series_at_end(f, end, q, r);
    if (h.is_blocked()) {
      if (best.obstacle.empty()) best.obstacle = std::string(h.where());
      const remedy help = h.what_may_help();
      if (help == remedy::none || help == remedy::smaller_square) break;
      ++root;
      continue;
    }
    end_plan plan = plan_from_series(h, q, r);
    if (plan.how == manner::power) return plan;
    if (best.how == manner::unknown) best = plan;
    // Where there is no logarithm, the exponent times this root is whole.
    const integer whole = denominator(plan.exponent) * root;
    const bool helps = plan.how == manner::exponential && plan.bounds.size() == 1;
    if (!helps || whole <= root || whole > most_root) break;
    root = static_cast<long>(whole);
  }
  return best;
}

/// Whether f is analytic on a neighbourhood of the end, by regions alone.
bool is_regular(const integrand& f, const end_of_range& end) {
  const precision p = 192;
  const ball start = end.at.at(p);
  const ball distance = end.distance.at(p);
  const double_interval in_doubles(-0x1p-10, 0x1p-10);
  if (f.over(region(start) + region(distance) * region(in_doubles, in_doubles)).is_analytic()) {
    return true;
  }
  for (const double size : {0x1p-10, 0x1p-20, 0x1p-40}) {
    const ball side = to_ball(double_interval(-size, size), p);
    const region x = start + distance * region::in_balls({side, side});
    if (f.over(x).is_analytic()) return true;
  }
  return false;
}

/// p + s t^q for t^q in the region's own arithmetic.
class moved_from_end {
 public:
  explicit moved_from_end(const end_of_range& end)
      : end_(end), p_hardware_(end.at.at(64)), s_hardware_(end.distance.at(64)) {}
  region operator()(const region& power) const {
    if (power.is_in_hardware()) return p_hardware_ + s_hardware_ * power;
    const precision bits = power.precision() + 11;
    return end_.at.at(bits) + end_.distance.at(bits) * power;
  }

 private:
  end_of_range end_;
  region p_hardware_;
  region s_hardware_;
};

/// x = p + s t^q for 0 < t <= 1, with the series' bound near t = 0.
segment power_segment(const integrand& f, const end_of_range& end, const end_plan& plan) {
  segment result;
  const long q = plan.q;
  result.over = [=, x = moved_from_end(end)](const region& t) {
    if (q == 1) return f.over(x(t));
    return f.over(x(pow(t, q))) * pow(t, q - 1);
  };
  result.evaluator = [=](precision bits) -> std::function<ball(const ball&)> {
    return
        [p = end.at.at(bits), s = end.distance.at(bits), q, g = f.evaluator(bits)](const ball& t) {
          const ball power = pow(t, q - 1);
          return g(p + s * (power * t)) * power;
        };
  };
  // dx = s q t^(q-1) dt, and for q < 0 t runs from infinity's side.
  result.scale = [=](precision bits) { return end.distance.at(bits) * std::abs(q); };
  result.position = [=](const ball& t) {
    const precision bits = t.precision();
    return end.at.at(bits) + end.distance.at(bits) * pow(t, q);
  };
  if (plan.how == manner::power) {
    const double reach = plan.r;
    // t < 1: a lower power will do where the power is so high that counting it out takes long.
    const auto m = static_cast<long>(std::min(integer(numerator(plan.exponent)), integer(4096)));
    // The factor q is in the scale.
    const magnitude bound = divide_up(
        plan.bounds.front(), magnitude::from_integer_down(static_cast<std::uint64_t>(std::abs(q))));
    result.known = [=](double_interval re, double_interval im) -> std::optional<known_bound> {
      const double_interval distance = hypot(re, im);
      if (distance.lower() >= reach) return std::nullopt;
      const bool everywhere = distance.upper() < reach;
      const double most = everywhere ? distance.upper() : reach;
      const magnitude t = to_ball(double_interval(most), 64).magnitude_upper();
      magnitude result_bound = bound;
      for (long k = 0; k < m; ++k) result_bound = multiply_up(result_bound, t);
      return known_bound{result_bound, everywhere};
    };
  }
  return result;
}

/// x = p + s t^q for r0 <= t <= 1: t = r0 + (1 - r0) v.
segment segment_beyond(double r0, const integrand& f, const end_of_range& end, end_plan plan) {
  plan.how = manner::regular;
  const segment whole = power_segment(f, end, plan);
  const ball start = ball::exactly(r0, 64);
  const ball width = 1 - start;  // exact: r0 is a power of two
  const auto t_of = [=](const auto& v) { return start + width * v; };
  segment result;
  result.over = [=](const region& v) { return whole.over(t_of(v)); };
  result.evaluator = [=](precision p) -> std::function<ball(const ball&)> {
    return [=, g = whole.evaluator(p)](const ball& v) { return g(t_of(v)); };
  };
  result.scale = [=](precision p) { return whole.scale(p) * width; };
  result.position = [=](const ball& v) { return whole.position(t_of(v)); };
  return result;
}

/// x = p + s t^q with t = r0 e^(-w), 0 <= w <= W, w = W v: what lies within t <= r0 of the end, for
/// functions with logarithms or odd powers there. Beyond W, the remainder.
///
/// F dt = -t F(t) dw, and |t F(t)| <= |t|^(M+1) sum of B_k |log t|^k, |log t| <= |log r0| + |w|, for
/// |t| < r, whatever the argument of t: the series is continued with it.
segment exponential_segment(const integrand& f, const end_of_range& end, const end_plan& plan,
                            double r0, double length, ball& remainder) {
  segment result;
  const long q = plan.q;
  const ball minus_length = ball::exactly(-length);
  const ball first = ball::exactly(r0);
  result.over = [=, x = moved_from_end(end)](const region& v) {
    const region power = pow(exp(v * minus_length) * first, q);
    return f.over(x(power)) * power;
  };
  result.evaluator = [=](precision bits) -> std::function<ball(const ball&)> {
    return
        [=, p = end.at.at(bits), s = end.distance.at(bits), g = f.evaluator(bits)](const ball& v) {
          const ball power = pow(exp(v * minus_length) * first, q);
          return g(p + s * power) * power;
        };
  };
  result.scale = [=](precision bits) {
    return end.distance.at(bits) * std::abs(q) * ball::exactly(length).with_precision(bits);
  };
  result.position = [=](const ball& v) {
    const precision bits = v.precision();
    return end.at.at(bits) + end.distance.at(bits) * pow(exp(v * minus_length) * first, q);
  };
  const ball c = ball(rational(plan.exponent + 1), 64);
  const ball start = abs(log(ball::exactly(r0, 64)));
  const double reach = plan.r;
  const auto factor = magnitude::from_integer_down(static_cast<std::uint64_t>(std::abs(q)));
  result.known = [=](double_interval re, double_interval im) -> std::optional<known_bound> {
    const double_interval w_re = re * double_interval(length);
    const double_interval w_im = im * double_interval(length);
    const double_interval t = exp(-w_re) * double_interval(r0);
    if (t.lower() >= reach) return std::nullopt;
    const bool everywhere = t.upper() < reach;
    const ball log_t = start + to_ball(hypot(w_re, w_im), 64);
    ball sum(0, 64);
    for (std::size_t k = 0; k < plan.bounds.size(); ++k) {
      ball bound(0, 64);
      bound = bound.enlarged(divide_up(plan.bounds[k], factor));
      sum += bound * pow(log_t, static_cast<long>(k));
    }
    // |t|^(M+1) = exp((M+1) (log r0 - Re w)), and |t| < reach.
    const ball size = everywhere ? exp(c * (log(ball::exactly(r0, 64)) - to_ball(w_re, 64)))
                                 : exp(c * log(ball::exactly(reach, 64)));
    return known_bound{(sum * size).magnitude_upper(), everywhere};
  };
  // The integral over w > W of e^(-c w) (a + w)^k dw, c = M + 1, a = |log r0|, by parts:
  // e^(-c W) sum over j <= k of k!/(k-j)! (a + W)^(k-j) / c^(j+1).
  const ball w = ball::exactly(length, 64);
  ball tail(0, 64);
  for (std::size_t k = 0; k < plan.bounds.size(); ++k) {
    ball sum(0, 64);
    ball falling(1, 64);
    for (std::size_t j = 0; j <= k; ++j) {
      sum += falling * pow(start + w, static_cast<long>(k - j)) / pow(c, static_cast<long>(j + 1));
      falling *= static_cast<long>(k - j);
    }
    ball bound(0, 64);
    tail += bound.enlarged(plan.bounds[k]) * sum;
  }
  tail *= exp(c * (log(ball::exactly(r0, 64)) - w)) * end.distance.at(64);
  remainder = remainder + ball(0, 64).enlarged(tail.magnitude_upper());
  return result;
}

segment affine_segment(const integrand& f, const end_point& a, const end_point& b) {
  segment whole;
  // The functions below are copied often, and limits take long to copy.
  const auto x = std::make_shared<const affine_map>(a, b);
  whole.over = [x, over = f.over](const region& t) { return over((*x)(t)); };
  whole.evaluator = [x, at = f.evaluator](precision p) -> std::function<ball(const ball&)> {
    return [a = x->start(p), length = x->length(p), g = at(p)](const ball& t) {
      ball argument;
      fma(argument, length, t, a);
      return g(argument);
    };
  };
  whole.scale = [x](precision p) { return x->length(p); };
  whole.position = [x](const ball& t) { return (*x)(t); };
  return whole;
}

/// From a to b, where f is regular at both; a symmetry of f is used.
segment regular_segment(const integrand& f, const end_point& a, const end_point& b) {
  const std::optional<fundamental_range> range = fundamental_range_of(f, a, b);
  if (!range || !is_regular(f, end_of_range::finite(end_point(range->b), end_point(range->a)))) {
    return affine_segment(f, a, b);
  }
  segment result = affine_segment(f, end_point(range->a), end_point(range->b));
  result.scale = [length = result.scale, copies = range->log2_copies](precision p) {
    return scale(length(p), copies);
  };
  result.equidistant = [f, a = range->a, b = range->b](long n, precision p) {
    const auto points =
        std::make_shared<const equidistant_angles>(a.at(p), (b - a).at(p) / (2 * n), n, p);
    return [f, points, p]() -> std::function<ball(long)> {
      if (f.angle_evaluator) {
        return [points, g = f.angle_evaluator(p)](long k) { return g(angle(*points, k)); };
      }
      return [points, g = f.evaluator(p)](long k) { return g(points->value(k)); };
    };
  };
  return result;
}

/// About log2 of the largest |f| at a few points p + s t; 0 where f is undefined or 0 at all of them.
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

/// The least Y = 1/t >= 1/r, to about a tenth, at which what is left is at most `goal`; 0 where there is none.
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

/// A function that decays exponentially: at infinity, from x = s on, or at a finite end p, as exp(-1/x) at 0.
/// It is cut off where the rest is less than about 2^-bits of the largest value seen.
bool add_decaying_part(preparation& result, const integrand& f, const end_of_range& end,
                       int direction, long bits) {
  const ball s = end.distance.at(192);
  const ball p = end.at.at(192);
  const double size =
      end.infinite
          ? log2_of_samples(f, p.with_precision(64), s.with_precision(64), {8, 9, 12, 20, 40})
          : log2_of_samples(f, p.with_precision(64), s.with_precision(64), {1, 2, 4, 7, 8});
  // Numbers have exponents down to about -2^30; where the samples lie far from a peak they tell nothing of it.
  constexpr double least_goal = -0x1p29;
  const double log2_goal = std::max(size - 1.05 * static_cast<double>(bits) - 48, least_goal);
  const magnitude goal = magnitude::power_of_two(static_cast<long>(log2_goal));
  for (const double r : {0.5, 0x1p-2, 0x1p-4, 0x1p-6, 0x1p-8, 0x1p-12, 0x1p-16, 0x1p-24, 0x1p-32,
                         0x1p-48, 0x1p-64}) {
    const auto with_orders = [&](int orders) {
      return f.near_infinity(
          end.infinite ? tail_series::argument(exactly(end.distance), r, orders)
                       : tail_series::argument(exactly(end.at), exactly(end.distance), r, orders));
    };
    // Few orders cost less and mostly suffice.
    tail_series tail = with_orders(2);
    if (tail.is_blocked()) tail = with_orders(end_series::most_orders);
    if (tail.is_blocked()) continue;
    const auto left = [&](const ball& y) {
      return end.infinite ? tail.integral_beyond(y) : tail.integral_before(y);
    };
    const double y = cut_for(left, r, goal);
    if (y == 0) continue;
    const magnitude rest = multiply_up(left(ball::exactly(y, 64)), s.magnitude_upper());
    result.remainder = result.remainder.enlarged(rest);
    result.has_tail = true;
    const rational exact_y = lower_rational(ball::exactly(y, 64));
    const end_point far =
        sum_of(end.at, end.distance, end.infinite ? exact_y : rational(1 / exact_y));
    result.parts.push_back(end.part(end.end, far, direction));
    const part_done rest_of_it = end.part(far, end.start, direction);
    add_analytic_pieces(result, f, rest_of_it.from, rest_of_it.to, bits);
    return true;
  }
  return false;
}

void require_tiled(const std::vector<part_done>& parts, const end_point& a, const end_point& b) {
  if (!is_tiled(parts, a, b)) {
    throw std::logic_error("integrate: internal error: the pieces of a range do not tile it");
  }
}

void add_part(preparation& result, const integrand& f, const end_of_range& end, int direction,
              long bits);

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
    result.why = steady.why;
    result.obstacle = steady.obstacle;
    if (result.why == reason::not_integrable)
      result.obstacle = "the integrand grows too fast at " + place;
    if (result.why != reason::none) return true;
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

/// The part from `end` (t = 0), where f is not regular, to t = 1. direction: 1 where x runs away from the end
/// as the integral does.
void add_part(preparation& result, const integrand& f, const end_of_range& end, int direction,
              long bits) {
  const auto add = [&](segment s, const end_point& near, const end_point& far) {
    if (direction < 0) {
      s.scale = [scale = s.scale](precision p) { return -scale(p); };
    }
    result.segments.push_back(std::move(s));
    result.parts.push_back(end.part(near, far, direction));
  };
  const end_plan plan = look_at_end(f, end);
  const std::string place =
      end.infinite ? std::string("infinity") : "x = " + to_decimal(end.at.at(96), 20);
  switch (plan.how) {
    case manner::power:
      add(power_segment(f, end, plan), end.end, end.start);
      return;
    case manner::exponential: {
      // From t = 1 to r0 without, and from there with the exponential.
      const double r0 = plan.r / 8;
      const double c = static_cast<double>(numerator(plan.exponent) + denominator(plan.exponent)) /
                       static_cast<double>(denominator(plan.exponent));
      const double length = std::ceil((1.05 * static_cast<double>(bits) + 48) * 0.6931 / c);
      ball remainder(0, 64);
      segment near = exponential_segment(f, end, plan, r0, length, remainder);
      const end_point at_1 =
          end_point([at = near.position](precision p) { return at(ball(1, p)); });
      const end_point at_0 =
          end_point([at = near.position](precision p) { return at(ball(0, p)); });
      result.parts.push_back(end.part(end.end, at_1, direction));
      result.remainder += direction < 0 ? -remainder : remainder;
      result.has_tail = true;
      add(std::move(near), at_1, at_0);
      add(segment_beyond(r0, f, end, plan), at_0, end.start);
      return;
    }
    case manner::divergent:
      result.why = reason::not_integrable;
      result.obstacle = "the integrand grows too fast at " + place;
      return;
    default:
      break;
  }
  if (add_decaying_part(result, f, end, direction, bits)) return;
  if (add_oscillating_part(result, f, end, direction, place, bits)) return;
  if (end.infinite) {
    result.why = reason::not_analytic;
    result.obstacle = "no proof of decay at infinity (" + plan.obstacle + ")";
    return;
  }
  add(affine_segment(f, end.at, end.start), end.end, end.start);
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
bool is_inside(const rational& q, const end_point& a, const end_point& b) {
  const precision p = 192;
  const ball x(q, p);
  return (a.infinite_sign() < 0 || certainly_less(a.at(p), x)) &&
         (b.infinite_sign() > 0 || certainly_less(x, b.at(p)));
}

bool can_cut_at(const integrand& f, const rational& q) {
  for (const long side : {-1L, 1L}) {
    if (look_at_end(f, end_of_range::finite(end_point(q), end_point(q + side))).how !=
        manner::unknown)
      continue;
    const tail_series near = f.near_infinity(
        tail_series::argument(known_number(q), known_number(rational(side)), 0x1p-8));
    if (near.is_blocked() || near.integral_before(ball(1L << 20, 64)).is_infinite()) return false;
  }
  return true;
}

namespace {

/// That of one period, times their count, and that of the rest.
preparation prepare_periods(const integrand& f, const end_point& a, const whole_periods& periods,
                            const std::vector<rational>& cuts, long bits) {
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
                    const std::vector<rational>& cuts, long bits) {
  if (f.record && !a.is_infinite() && !b.is_infinite()) {
    if (const auto periods = whole_periods_of(f, formula(f.record), a, b)) {
      preparation result = prepare_periods(f, a, *periods, cuts, bits);
      result.parts = {{a, b}};
      return result;
    }
  }
  preparation result;
  // f as it is known at the two ends.
  const auto finite = [&](const end_point& left, const integrand& at_left, const end_point& right,
                          const integrand& at_right) {
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
  };
  const auto finite_with_cuts = [&](const end_point& left, const end_point& right) {
    const pieces_of_range parts = analytic_pieces(f, left, right, bits);
    result.remainder += parts.remainder;
    result.has_tail = result.has_tail || parts.has_remainder;
    for (const piece& p : parts.pieces) {
      end_point start = p.left;
      const integrand* at_start = &p.at_left;
      for (const rational& q : cuts) {
        if (!is_inside(q, p.left, p.right)) continue;
        const end_point cut(q);
        finite(start, *at_start, cut, p.f);
        start = cut;
        at_start = &p.f;
      }
      finite(start, *at_start, p.right, p.at_right);
    }
  };
  const auto to_infinity = [&](const end_point& start, int sign) {
    // The part from sign * infinity to sign * 2^e, beyond the start, every cut and, if that can be, every break: f is asked for nothing
    // on the other side of the start.
    magnitude reach = start.at(64).magnitude_upper();
    for (const rational& q : cuts) reach = max(reach, ball(q, 64).magnitude_upper());
    const auto e = exponent_beyond_breaks(
        f,
        static_cast<unsigned long>(
            reach.is_zero() ? 0 : std::max(reach.log2_floor() + 1, std::int64_t{0})),
        sign);
    integer c;
    mpz_ui_pow_ui(c.backend().data(), 2, e);
    end_point point(rational(sign * c));
    add_part(result, f, end_of_range::infinity(sign, point), sign, bits);
    return point;
  };
  const bool both = a.infinite_sign() != 0 && b.infinite_sign() != 0;
  const end_point left = a.infinite_sign() != 0 ? to_infinity(both ? end_point(0) : b, -1) : a;
  const end_point right = b.infinite_sign() != 0 ? to_infinity(both ? end_point(0) : a, 1) : b;
  finite_with_cuts(left, right);
  if (result.why == reason::none) require_tiled(result.parts, a, b);
  return result;
}

}  // namespace polhode::detail
