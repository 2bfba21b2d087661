#include "oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "decomposition.hpp"
#include "quadrature/ends/tail_series.hpp"

namespace polhode::detail {

namespace {

using oscillations::decomposition;
using oscillations::oscillation;
using shared_decomposition = std::shared_ptr<const decomposition>;

/// A bound of |h(t)| for |t| <= r < 1, Re t > 0, from its series there; infinite where h is not
/// known to tend to 0:
/// |t|^m |log t|^k, with |log t| <= l + pi/2 for l = -log |t| >= 0, is at most e^(-m l) (l + 2)^k,
/// which is largest at l + 2 = k/m, if ever, and so at most e^(2m) (k/m)^k for k > 0, and at most 1
/// for k = 0.
magnitude bound_of(const end_series& series) {
  if (series.is_blocked()) return magnitude::infinity();
  const end_series h = series.simplified();
  if (h.is_zero()) return {};
  const rational& m = h.exponent();
  if (m <= 0) return magnitude::infinity();
  magnitude sum;
  for (int k = 0; k <= h.log_degree(); ++k) {
    ball most(1, 64);
    if (k > 0) most = exp(ball(rational(2 * m), 64)) * pow(ball(rational(k / m), 64), k);
    sum = add_up(sum, multiply_up(h.supremum(k), most.magnitude_upper()));
  }
  return sum;
}

/// A bound of |u| + |v| for |z| >= 1/r, Re z > 0.
magnitude bound_of(const oscillation& w, double r) {
  const end_series y =
      end_series::argument(known_number(rational(0)), known_number(rational(1)), -1, r);
  magnitude sum;
  for (const std::optional<end_series>& part : w.parts(y)) {
    if (part) sum = add_up(sum, bound_of(*part));
  }
  return sum;
}

/// 2 Re of i e^(i w Y0) W(Y0 + i tau) e^(-w tau) for 0 <= tau <= T, tau = T t.
segment line_up(const shared_decomposition& f, std::size_t k, long start, long length) {
  segment result;
  const auto over_with = [=](precision p) {
    const std::shared_ptr<const oscillation> w = f->at(k, p);
    const ball angle = w->frequency() * start;
    const region phase(complex_ball(cos(angle), sin(angle)));
    const region conjugate(complex_ball(cos(angle), -sin(angle)));
    return [=](const region& t) {
      const region tau = t * length;
      const region above = (*w)(start + times_i(tau), 1) * phase;
      const region below = (*w)(start - times_i(tau), -1) * conjugate;
      return times_i(above - below) * exp(-(tau * w->frequency()));
    };
  };
  result.over = [=, in_hardware = over_with(64)](const region& t) {
    return t.is_in_hardware() ? in_hardware(t) : over_with(t.precision() + 64)(t);
  };
  result.evaluator = [=](precision p) -> std::function<ball(const ball&)> {
    const std::shared_ptr<const oscillation> w = f->at(k, p);
    const complex_ball phase(cos(w->frequency() * start), sin(w->frequency() * start));
    return [=](const ball& t) {
      const ball tau = t * length;
      const analytic_ball z(complex_ball(ball(start, t.precision()), tau));
      const complex_ball above = (*w)(z, 1).value() * phase;
      return -2 * above.im * exp(-(tau * w->frequency()));
    };
  };
  result.scale = [=](precision p) { return ball(length, p); };
  result.position = [=](const ball& t) { return start + t * length; };
  result.continued = true;
  return result;
}

/// The steady part as a function of y.
integrand steady_part(const shared_decomposition& f) {
  const auto at = [f](precision p) { return f->at(f->count(), p); };
  const auto over_series = [at](const auto& y) {
    const auto value = at(192)->parts(y).front();
    return value ? *value : y * y.constant_like(rational(0));
  };
  integrand result;
  result.over = [at](const region& y) {
    return (*at(y.is_in_hardware() ? precision{64} : y.precision() + 64))(y, 1);
  };
  result.evaluator = [at](precision p) -> std::function<ball(const ball&)> {
    return [w = at(p)](const ball& y) { return w->real_part(y); };
  };
  // Amplitudes of special functions have no series at infinity: bounds are all that is known.
  const bool has_series = !at(192)->has_bounds_only();
  result.near_end = [=](const end_series& y) {
    return has_series ? over_series(y) : end_series::blocked("a function that oscillates");
  };
  result.near_infinity = [=](const tail_series& y) { return over_series(y); };
  result.growth = [=](const growth_bound& y) { return over_series(y); };
  return result;
}

/// Y0 = 2^exponent, with Y0^theta = far rational.
struct start_of_lines {
  long exponent = 0;
  rational far;
};

/// The points that may serve as Y0, in increasing order: 2^(d e), with d the denominator of theta.
/// None where theta is not simple.
std::vector<start_of_lines> possible_starts(const rational& theta) {
  constexpr long most_bits = 30;
  if (denominator(theta) > most_bits || abs(numerator(theta)) > most_bits) return {};
  const auto d = static_cast<long>(denominator(theta));
  const auto n = static_cast<long>(numerator(theta));
  std::vector<start_of_lines> result;
  for (long e = 1; e * d <= most_bits; ++e) {
    rational far = 1;
    for (long j = 0; j < e * std::abs(n); ++j) far *= 2;
    if (n < 0) far = 1 / far;
    result.push_back({e * d, far});
  }
  return result;
}

/// Amplitudes of special functions have cheap values where their asymptotic series are good enough,
/// from about 0.35 |log2 goal| on: the least exponent of Y0 by which they are. Smaller where f
/// turns too often up to there.
long least_exponent_for_amplitudes(const decomposition& parts, double log2_goal) {
  constexpr double most_turned = 1024;  // in radians
  double turned = 0;                    // up to y = 1
  double slope = HUGE_VAL;
  for (std::size_t k = 0; k < parts.count(); ++k) {
    const std::shared_ptr<const oscillation> w = parts.at(k, 192);
    turned = std::max(turned, double_interval::from_ball(w->frequency()).upper());
    slope = std::min(slope, w->least_slope_of_amplitudes());
  }
  long e = 0;
  if (slope < HUGE_VAL) {
    while (std::ldexp(slope, static_cast<int>(e)) < -0.4 * log2_goal &&
           std::ldexp(turned, static_cast<int>(e + 1)) < most_turned) {
      ++e;
    }
  }
  return e;
}

/// Bounds of |u| + |v| for each frequency where |z| >= Y0, Re z > 0; none where one is infinite.
std::vector<magnitude> bounds_beyond(const decomposition& parts, const start_of_lines& at) {
  const double r = std::ldexp(1.0, static_cast<int>(-at.exponent));
  std::vector<magnitude> bounds;
  for (std::size_t k = 0; k < parts.count(); ++k) {
    bounds.push_back(bound_of(*parts.at(k, 192), r));
    if (bounds.back().is_infinite()) return {};
  }
  return bounds;
}

/// A whole T with 2 (B/w) e^(-w T) less than about 2^log2_goal; nothing where it is too great.
std::optional<long> length_of_line(const ball& frequency, const magnitude& bound,
                                   double log2_goal) {
  // The bound is 0 nowhere.
  const double log2_bound =
      bound.is_zero() ? log2_goal : static_cast<double>(bound.log2_floor()) + 1;
  const double log2_frequency = static_cast<double>(frequency.magnitude_lower().log2_floor());
  const double nats = std::max(log2_bound - log2_frequency + 4 - log2_goal, 8.0) * 0.6932;
  const double long_enough = nats / double_interval::from_ball(frequency).lower();
  if (!(long_enough < 0x1p60)) return std::nullopt;
  return static_cast<long>(long_enough) + 1;
}

/// 2 (B/w) e^(-w T): what is left beyond tau = T.
magnitude rest_beyond(const ball& frequency, const magnitude& bound, long length) {
  ball rest(0, 64);
  rest = rest.enlarged(multiply_up(bound, magnitude::from_integer_up(2)));
  rest = rest * exp(-(frequency * length)) / frequency;
  return rest.magnitude_upper();
}

}  // namespace

std::optional<oscillating_end> oscillations_at(const integrand& f, const end_point& p,
                                               const end_point& s, bool infinite, int sign,
                                               double log2_goal) {
  if (!f.graph) return std::nullopt;
  const auto parts = std::make_shared<const decomposition>(f, p, s, infinite, sign);
  if (!parts->is_found() || parts->count() == 0) return std::nullopt;
  const long least = least_exponent_for_amplitudes(*parts, log2_goal);
  for (const start_of_lines& at : possible_starts(parts->theta())) {
    if (at.exponent < least) continue;
    const std::vector<magnitude> bounds = bounds_beyond(*parts, at);
    if (bounds.empty()) continue;
    const long start = 1L << at.exponent;
    oscillating_end result;
    result.start = start;
    result.far = at.far;
    if (parts->has_steady_part()) result.steady = steady_part(parts);
    for (std::size_t k = 0; k < parts->count(); ++k) {
      const ball frequency = parts->at(k, 192)->frequency();
      const std::optional<long> length = length_of_line(frequency, bounds[k], log2_goal);
      if (!length) return std::nullopt;
      result.rest = add_up(result.rest, rest_beyond(frequency, bounds[k], *length));
      result.segments.push_back(line_up(parts, k, start, *length));
    }
    return result;
  }
  return std::nullopt;
}

}  // namespace polhode::detail
