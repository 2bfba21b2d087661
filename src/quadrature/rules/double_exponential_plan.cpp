#include "quadrature/rules/double_exponential_plan.hpp"

#include <cmath>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {

std::optional<end_growth> growth_from_series(const end_series& series, double reach) {
  const end_series h = series.simplified();
  if (h.is_blocked()) return std::nullopt;
  if (h.exponent() <= -1 && !h.leads_surely()) return std::nullopt;
  end_growth growth;
  growth.exponent = h.exponent();
  growth.log_degree = h.log_degree();
  growth.reach = reach;
  for (int k = 0; k <= h.log_degree(); ++k) {
    growth.factor = add_up(growth.factor, h.supremum(k));
  }
  if (growth.factor.is_infinite()) return std::nullopt;
  return growth;
}

namespace {

constexpr precision bits = 64;

ball length_of(const double_exponential_problem& problem) {
  return {rational(problem.b - problem.a), bits};
}

ball upper_ball(const magnitude& m) { return ball(0, bits).enlarged(m); }

/// A bound of the integrand in t, f dx/dt, for from <= |Re t| <= to and |Im t| <= height < pi/2,
/// from > 0, on the side of the end that grows so; infinite where the end's distance may exceed its
/// reach.
///
/// With v = e^(+-pi sinh t) such that |v| < 1 and Re sinh t = sinh(Re t) cos(Im t): |v| <= W =
/// e^(-pi sinh(from) cos(height)). The distance s from the end is L v/(1 + v), at most L W/(1 - W)
/// in size; the other distance is L/(1 + v), at most L/(1 - W); |cosh t| <= cosh(Re t), and so
/// |dx/dt| <= pi cosh(to) |s|/(1 - W). Continued from real t, log s = log L -+ pi sinh t - log(1 +
/// v), |sinh t| <= cosh(Re t): |log s| <= |log L| + pi cosh(to)
/// - log(1 - W). f and the factor |s| make |s|^(exponent + 1), which grows with |s|.
magnitude bound_towards_end(const end_growth& growth, const ball& length, double from, double to,
                            double height) {
  const ball angle = ball::exactly(height, bits);
  const ball decay = pi(bits) * sinh(ball::exactly(from, bits)) * cos(angle);
  if (!certainly_less(angle, pi(bits) / 2) || !certainly_positive(decay)) {
    return magnitude::infinity();
  }
  const ball w = exp(-decay);
  const ball rest = 1 - w;
  const ball distance = length * w / rest;
  if (!certainly_less(distance, ball::exactly(growth.reach, bits))) return magnitude::infinity();
  const ball swing = pi(bits) * cosh(ball::exactly(to, bits));
  const ball logarithm = 1 + abs(log(length)) + swing - log(rest);
  const ball size = upper_ball(growth.factor) * swing / rest *
                    pow(distance, ball(rational(growth.exponent + 1), bits)) *
                    pow(logarithm, growth.log_degree);
  return size.magnitude_upper();
}

/// The least |Re t|, about, beyond which the distances are within reach for |Im t| <= d. A search:
/// whether it is so bound_towards_end finds out.
double start_of_ends(const double_exponential_problem& problem, double d) {
  const double length = double_interval(rational(problem.b - problem.a)).midpoint();
  const double reach = std::min(problem.left.reach, problem.right.reach);
  const double needed = std::log1p(length / reach);
  return std::asinh(1.001 * needed / (3.14159265358979 * std::cos(d))) + 1e-9;
}

}  // namespace

/// The x at t > T are within s <= D of the end, D = L/(1 + e^(pi sinh T)) at t = T; with s = e^(-v)
/// the integral of s^alpha (1 + |log s|)^k over 0 < s <= D < 1 is that of e^(-c v) (1 + v)^k over v
/// >= V = -log D, c = alpha + 1: e^(-c V) times the sum of k!/(k-j)! (1 + V)^(k-j)/c^(j+1) over 0
/// <= j <= k, by parts.
magnitude double_exponential_problem::beyond(double range) const {
  const ball t = ball::exactly(range, bits);
  const ball distance = length_of(*this) / (1 + exp(pi(bits) * sinh(t)));
  magnitude sum;
  for (const end_growth* growth : {&left, &right}) {
    const bool within = range > 0 && certainly_less(distance, ball(1, bits)) &&
                        certainly_less(distance, ball::exactly(growth->reach, bits));
    if (!within) return magnitude::infinity();
    const ball c(rational(growth->exponent + 1), bits);
    const ball v = -log(distance);
    ball terms(0, bits);
    ball falling(1, bits);
    for (long j = 0; j <= growth->log_degree; ++j) {
      terms += falling * pow(1 + v, growth->log_degree - j) / pow(c, j + 1);
      falling *= growth->log_degree - j;
    }
    const ball tail = upper_ball(growth->factor) * pow(distance, c) * terms;
    sum = add_up(sum, tail.magnitude_upper());
  }
  return sum;
}

std::optional<rectangle_bound> double_exponential_problem::rectangle(double range, double d,
                                                                     long& evaluations) const {
  constexpr double highest = 1.57;  // < pi/2
  if (!(d > 0 && d <= highest)) return std::nullopt;
  const double start = start_of_ends(*this, d);
  if (!(start < range)) return std::nullopt;
  const ball length = length_of(*this);
  const region length_region(length);
  const region_function inner = [&](const region& t) {
    const region sine = pi(bits) * sinh(t);
    const region from_a = length_region / (1 + exp(-sine));
    const region from_b = length_region / (1 + exp(sine));
    return over(from_a, from_b) * (pi(bits) * cosh(t) * from_a * from_b / length);
  };
  if (!is_analytic_on(inner, -start, start, d, evaluations)) return std::nullopt;
  rectangle_bound bound;
  bound.half_height = d;
  bound.horizontal = integral_along(inner, -start, start, d, evaluations);
  constexpr int tiles = 96;
  constexpr int pieces = 32;
  for (const end_growth* growth : {&left, &right}) {
    double from = start;
    for (int k = 1; k <= tiles; ++k) {
      const double to = k == tiles ? range : std::min(range, start + (range - start) * k / tiles);
      const ball width = ball::exactly(to, bits) - ball::exactly(from, bits);
      bound.horizontal = add_up(
          bound.horizontal,
          multiply_up(bound_towards_end(*growth, length, from, to, d), width.magnitude_upper()));
      from = to;
    }
    std::vector<side_piece>& side = growth == &left ? bound.left : bound.right;
    double y = 0;
    for (int k = 1; k <= pieces; ++k) {
      const double next = k == pieces ? d : d * k / pieces;
      side.push_back({y, next, bound_towards_end(*growth, length, range, range, next)});
      y = next;
    }
  }
  bound.horizontal = scale(bound.horizontal, 1);  // the lower side, by reflection
  return bound;
}

double range_for(const double_exponential_problem& problem, long goal_bits) {
  const magnitude goal = magnitude::power_of_two(-goal_bits);
  constexpr double longest = 64;
  for (double range = 0.125; range <= longest; range += 0.0625) {
    // The sides add about as much times the slope, cosh T.
    const magnitude slope = scale(cosh(ball::exactly(range, bits)).magnitude_upper(), 3);
    if (multiply_up(problem.beyond(range), slope) <= goal) return range;
  }
  return 0;
}

}  // namespace polhode::detail
