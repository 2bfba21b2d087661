#include "end_segments.hpp"

#include <cmath>
#include <memory>

#include "quadrature/formula/angle.hpp"
#include "quadrature/formula/fundamental_range.hpp"

namespace polhode::detail::ends {

namespace {

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

using bound_near_end =
    std::function<std::optional<known_bound>(double_interval re, double_interval im)>;

/// |t^M G_0| with the plan's bound of |G_0|, for |t| < r.
bound_near_end bound_of_power(const end_plan& plan) {
  const long q = plan.q;
  const double reach = plan.r;
  // t < 1: a lower power will do where the power is so high that counting it out takes long.
  const auto m = static_cast<long>(std::min(integer(numerator(plan.exponent)), integer(4096)));
  // The factor q is in the scale.
  const magnitude bound = divide_up(
      plan.bounds.front(), magnitude::from_integer_down(static_cast<std::uint64_t>(std::abs(q))));
  return [=](double_interval re, double_interval im) -> std::optional<known_bound> {
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

/// |t F(t)| with t = r0 e^(-w), w = length v: F dt = -t F(t) dw, and |t F(t)| <= |t|^(M+1) sum of
/// B_k |log t|^k, |log t| <=
/// |log r0| + |w|, for |t| < r, whatever the argument of t: the series is continued with it.
bound_near_end bound_of_exponential(const end_plan& plan, double r0, double length) {
  const long q = plan.q;
  const ball c = ball(rational(plan.exponent + 1), 64);
  const ball start = abs(log(ball::exactly(r0, 64)));
  const double reach = plan.r;
  const auto factor = magnitude::from_integer_down(static_cast<std::uint64_t>(std::abs(q)));
  return [=](double_interval re, double_interval im) -> std::optional<known_bound> {
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
}

}  // namespace

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
  if (plan.how == manner::power) result.known = bound_of_power(plan);
  return result;
}

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

segment exponential_segment(const integrand& f, const end_of_range& end, const end_plan& plan,
                            double r0, double length) {
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
  if (!plan.has_growth_only) result.known = bound_of_exponential(plan, r0, length);
  return result;
}

ball tail_beyond(const end_of_range& end, const end_plan& plan, double r0, double length) {
  const ball c = ball(rational(plan.exponent + 1), 64);
  const ball start = abs(log(ball::exactly(r0, 64)));
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
  return ball(0, 64).enlarged(tail.magnitude_upper());
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

}  // namespace polhode::detail::ends
