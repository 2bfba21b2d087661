#pragma once

// Inverse problems: the c > 0 with g(c) = value, where c may be as small as 1e-1000.

#include <utility>

#include "polhode/roots/newton.hpp"

namespace polhode {

/// The c in [2^least_exponent, 2^greatest_exponent] with g(c) = value, to a relative radius of
/// about 2^-p, found in the variable t = log c, in which all sizes of c are alike: h(t) = g(e^t) -
/// value, h'(t) = g'(e^t) e^t.
///
/// g(c), derivative(c) and value(precision) are function objects whose results are balls that obey
/// the inclusion principle. Hypothesis, which is not checked: g is continuously differentiable and
/// strictly monotone on that range. It makes a root the only one in the range, and equal signs of h
/// at its ends a proof that there is none; without it, verdict unique still says that there is
/// exactly one root in the result's box. Verdict unresolved: a sign at an end of the range, or at a
/// point where it was to be halved, was not decided by most_precision bits, or Newton's method did
/// not contract. Throws input_error where the exponents are the wrong way round.
template <class G, class Derivative, class Value>
[[nodiscard]] root_enclosure solve_on_log_scale(const G& g, const Derivative& derivative,
                                                const Value& value, long least_exponent,
                                                long greatest_exponent, precision p,
                                                precision most_precision = 1L << 14) {
  if (least_exponent >= greatest_exponent) {
    throw input_error("the range of exponents is the wrong way round, or empty");
  }
  constexpr precision guard = 24;
  // An error of t is a relative error of e^t; t has so many bits before the point.
  const auto before_point = static_cast<precision>(
      magnitude::from_integer_up(static_cast<std::uint64_t>(std::max(std::abs(least_exponent),
                                                                     std::abs(greatest_exponent))))
          .log2_floor());
  const precision goal = p + before_point + guard;
  const auto h = [&](const ball& t) { return g(exp(t)) - value(t.precision()); };
  const auto slope = [&](const ball& t) {
    const ball c = exp(t);
    return derivative(c) * c;
  };
  const auto raised = [&](const ball& t, precision bits) {
    return h(t.with_precision(std::max(bits, t.precision())));
  };
  const precision bits = before_point + 64;
  ball box = hull(least_exponent * log_2(bits), greatest_exponent * log_2(bits));
  root_enclosure result;
  result.root = ball::undefined(p);
  constexpr long halvings = 8;
  const precision most_rounds = before_point + 64;
  for (precision round = 0; round < most_rounds; round += halvings) {
    const sign_bracket bracket = bracket_by_sign(raised, box, halvings, most_precision);
    result.evaluations_of_f += bracket.evaluations;
    if (bracket.verdict != status::certified) {
      if (bracket.why == reason::refuted && round == 0) result.verdict = root_verdict::none;
      return result;
    }
    box = bracket.interval;
    // A little room: the root may be at an end.
    const ball room = box.enlarged(scale(box.radius(), -2));
    const root_enclosure in_t = refine_root(h, slope, room, goal);
    result.evaluations_of_f += in_t.evaluations_of_f;
    result.evaluations_of_derivative += in_t.evaluations_of_derivative;
    if (in_t.verdict == root_verdict::unique) {
      result.verdict = root_verdict::unique;
      result.root = exp(in_t.root).with_precision(p + guard);
      result.box = exp(in_t.box);
      result.image = exp(in_t.image);
      result.derivative = in_t.derivative / result.box;
      return result;
    }
  }
  return result;
}

}  // namespace polhode
