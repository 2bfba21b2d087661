#pragma once

// Roots of one real function: certified bracketing by sign, and the interval Newton method with
// existence and uniqueness as its verdict and precision doubling as its economy.

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <vector>

#include "polhode/arithmetic/scalar.hpp"
#include "polhode/arithmetic/verdict.hpp"

namespace polhode {

/// What is proved about the roots of f in a box.
enum class root_verdict {
  unique,           // there is exactly one, it is simple, and the enclosure holds it
  multiple,         // there is exactly one, and its multiplicity is proved to be 2 or more
  isolated,         // there is exactly one, where f has no multiplicity: at a kink or branch point
  at_least_one,     // there is one; that it is the only one is not proved
  infinitely_many,  // there are infinitely many
  none,             // there is none
  unresolved        // nothing is proved: none, one or more
};

[[nodiscard]] std::string to_text(root_verdict v);
/// There is exactly one root.
[[nodiscard]] constexpr bool is_one_root(root_verdict v) {
  return v == root_verdict::unique || v == root_verdict::multiple || v == root_verdict::isolated;
}

/// A root and the parts of its proof.
struct root_enclosure {
  ball root;  // holds every root of f in `box`
  root_verdict verdict = root_verdict::unresolved;
  ball box;         // where existence and uniqueness were decided
  ball derivative;  // f' over that box
  ball image;       // the Newton image of that box
  int evaluations_of_f = 0;
  int evaluations_of_derivative = 0;
};

/// One step of the interval Newton method: N(X) = m - f(m)/F'(X) for m = X.middle().
///
/// Theorem (R. E. Moore, 1966; A. Neumaier, Interval Methods for Systems of Equations, 1990, Thm
/// 5.1.7): let f be continuously differentiable on X and F'(X) hold f'(x) for all x in X, without
/// 0. Then
/// (1) every root of f in X lies in N(X); (2) if N(X) and X are disjoint, f has no root in X;
/// (3) if N(X) lies in X, f has exactly one root in X, and it is simple.
/// Proof. (1) For a root x, -f(m) = f(x) - f(m) = f'(t)(x - m) for some t in X, so x = m -
/// f(m)/f'(t). (2) follows. (3) Two roots would make f' vanish between them (Rolle). Suppose there
/// is none: f keeps one sign on X, and so does f'. Let f' > 0 > f (the other cases are mirror
/// images) and let h be the upper end of X. Then f(m) < f(h) < 0 or m = h, and h - m = (f(h) -
/// f(m))/f'(t) < -f(m)/f'(t), so that m - f(m)/f'(t) is an element of N(X) beyond h: a
/// contradiction.
struct newton_step {
  ball derivative;
  ball image;  // undefined where F'(X) holds 0 or f or F' is undefined
};
template <class F, class Derivative>
[[nodiscard]] newton_step interval_newton_step(const F& f, const Derivative& derivative,
                                               const ball& box, precision p) {
  newton_step step;
  step.derivative = derivative(box);
  const ball middle = box.middle().with_precision(std::max(p, box.precision()));
  step.image = middle - f(middle) / step.derivative;
  return step;
}

/// Refines a simple root of f that is believed to lie in `box` to a radius of about 2^-(p-4) of its
/// size (of the box's size where the root is so near 0 that the enclosure holds 0), and proves on
/// the way that it exists and is the only one there.
///
/// f(x) and derivative(x) are function objects ball -> ball that obey the inclusion principle,
/// derivative(x) an enclosure of f' over the whole of x; f must be continuously differentiable on
/// every x on which f(x) and derivative(x) are both defined. That they are is checked on the whole
/// box: where f has a jump, its derivative alone may have a continuation (2x + arctan(1/x) at 0),
/// and the theorem says nothing. Cost: the precision doubles from step to step along a chain that
/// ends at p, so that f is called once with p bits and once with each of about p/2, p/4, ... bits,
/// and the derivative with half of those; and once with the box itself. Verdict unique: root holds
/// the only root in the given box. Verdict none: the box holds no root. Verdict unresolved: the
/// first steps did not contract (the box is too wide, the root is multiple, or f is not defined on
/// it); root is then what is left of the box.
template <class F, class Derivative>
[[nodiscard]] root_enclosure refine_root(const F& f, const Derivative& derivative, const ball& box,
                                         precision p) {
  constexpr precision guard = 16;
  constexpr int most_stalls = 4;
  root_enclosure result;
  result.root = box;
  const std::int64_t goal = -(static_cast<std::int64_t>(p) - 4);
  ball domain = ball::undefined(p);  // where f is known to be defined
  int stalls = 0;
  while (true) {
    const magnitude radius = result.root.radius();
    const magnitude size = (contains_zero(result.root) ? box : result.root).magnitude_upper();
    const bool narrow_enough = radius.is_zero() || radius <= scale(size, goal);
    if (!result.root.is_bounded()) break;
    if (narrow_enough && result.verdict == root_verdict::unique) break;
    // The bits the box has now; a step about doubles them. The next precision is the link of the
    // chain p, p/2, p/4, ... that these can reach.
    const std::int64_t bits =
        radius.is_zero() ? p : std::max<std::int64_t>(size.log2_floor() - radius.log2_floor(), 1);
    // A proof needs more bits than the box has, be they more than p.
    const bool proved = result.verdict == root_verdict::unique;
    precision next = (proved ? p : std::max<precision>(p, bits)) + guard;
    while (next > 64 && next > 2 * bits + 2 * guard) next = next / 2 + guard;
    // The derivative is needed to the bits that the step gains only; the box is not made wider for
    // it.
    const ball rounded = result.root.with_precision(
        std::max<precision>(std::max(next / 2 + guard, std::min(next, bits + 4)), 53));
    // By midpoint and radius, as f' over a narrow ball is cheapest.
    constexpr std::int64_t narrow = 12;
    const ball current = bits > narrow ? rounded.middle().enlarged(rounded.radius()) : rounded;
    if (!contains(domain, current)) {
      ++result.evaluations_of_f;
      if (f(current).is_undefined()) break;
      domain = current;
    }
    const newton_step step = interval_newton_step(f, derivative, current, next);
    ++result.evaluations_of_f;
    ++result.evaluations_of_derivative;
    if (step.image.is_undefined()) break;
    // Every root in the box lies in root, hence in current, hence in the image.
    if (!overlaps(step.image, result.root)) {
      if (result.verdict == root_verdict::unique) {
        throw std::logic_error("refine_root: the enclosures of f and its derivative contradict");
      }
      result.verdict = root_verdict::none;
      break;
    }
    if (result.verdict == root_verdict::unresolved && contains(current, step.image) &&
        contains(box, step.image)) {
      result.verdict = root_verdict::unique;
      result.box = current;
      result.derivative = step.derivative;
      result.image = step.image;
    }
    result.root = intersection(step.image, result.root.with_precision(next));
    // A few steps may pass without halving the box, or below the goal without a proof.
    const bool stalled = radius.is_zero() || result.root.radius() > scale(radius, -1);
    if (stalled && narrow_enough) break;
    if ((stalled || narrow_enough) && ++stalls >= most_stalls) break;
  }
  return result;
}

/// The uncertified counterpart from the same iteration: Newton's method over mpfr_float from a
/// start x0 that is right to about start_bits bits, with precision doubling to p bits. It certifies
/// nothing.
template <class F, class Derivative>
[[nodiscard]] mpfr_float newton(const F& f, const Derivative& derivative, const mpfr_float& x0,
                                long start_bits, precision p) {
  constexpr precision guard = 16;
  std::vector<precision> schedule;
  for (precision bits = p; bits > start_bits; bits = bits / 2 + 4) {
    schedule.insert(schedule.begin(), bits + guard);
    if (bits <= 16) break;
  }
  mpfr_float x = x0;
  for (const precision next : schedule) {
    mpfr_float argument = zero_of_precision(next);
    mpfr_set(argument.backend().data(), x.backend().data(), MPFR_RNDN);
    mpfr_float slope_argument = zero_of_precision(next / 2 + guard);
    mpfr_set(slope_argument.backend().data(), x.backend().data(), MPFR_RNDN);
    const mpfr_float slope = derivative(slope_argument);
    const mpfr_float value = f(argument);
    const mpfr_float correction = value / slope;
    mpfr_sub(argument.backend().data(), argument.backend().data(), correction.backend().data(),
             MPFR_RNDN);
    x = argument;
  }
  return x;
}

/// An interval with a certified change of sign of f at its ends, by bisection of [lower, upper]
/// until its width is at most 2^-bits of the interval it started with, or until f's sign at a
/// middle is not decided at any precision up to most_precision (the bracket reached is returned).
/// Verdict certified: f(lower) and f(upper) have certainly opposite signs, so that a continuous f
/// has a root between them; or the interval is a single point, at which f is exactly 0. Not
/// certified, not_defined or refuted: the signs at the given ends are unknown, or equal and not 0.
struct sign_bracket {
  ball interval;
  status verdict = status::not_certified;
  reason why = reason::none;
  int evaluations = 0;
};
[[nodiscard]] sign_bracket bracket_by_sign(const std::function<ball(const ball& x, precision p)>& f,
                                           const ball& interval, long bits,
                                           precision most_precision = 4096);

}  // namespace polhode
