#include "polhode/rigid_body/tennis_racket.hpp"

#include <optional>
#include <stdexcept>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/half_phase.hpp"
#include "polhode/roots/inverse.hpp"
#include "rigid_body/has_digits.hpp"

namespace polhode {
namespace {

/// The greatest integer below q > 0.
integer greatest_below(const rational& q) { return ceil_of(q) - 1; }

/// The greatest m with m < 2/I, that is m^2 < q = 4/I^2.
integer greatest_root_below(const exact_real& q) {
  // m^2 is an integer: below q exactly where it is at most the greatest integer below q.
  if (q.is_rational()) return sqrt(greatest_below(q.exact()));
  // q is no integer: the squares below it are those below the lower end of an enclosure in which
  // none is.
  for (precision p = 64; p <= exact_real::most_bits; p *= 2) {
    const ball x = q.at(p);
    if (!x.is_bounded()) break;
    integer low = sqrt(greatest_below(lower_rational(x)));
    if (low == sqrt(greatest_below(upper_rational(x)))) return low;
  }
  throw std::domain_error("the number of meeting points is not decided");
}

/// Whether m J < 2: m (J + 1) < m + 2.
bool rotates_beyond(const body& rigid, long m) {
  return rigid.square_of_second_constant() < rational((m + 2) * (m + 2), m * m);
}

certain_number refuted() {
  certain_number result;
  result.why = reason::refuted;
  return result;
}

certain_number out_of_exponents() {
  certain_number result;
  result.why = reason::precision_limit;
  return result;
}

/// A lower bound, to 1, of the exponents e with 2^e <= x; nothing below the exponents that MPFR has
/// unless they are changed.
std::optional<long> exponent_below(const ball& log_2_of_x) {
  constexpr long least = -(1L << 30);
  if (!log_2_of_x.is_bounded()) return std::nullopt;
  const integer below = numerator(lower_rational(floor(log_2_of_x)));
  if (below < least) return std::nullopt;
  return static_cast<long>(below) - 1;
}

/// x < 2^exponent.
long exponent_above(const exact_real& x) {
  return static_cast<long>(x.at(64).magnitude_upper().log2_floor()) + 1;
}

/// t such that a root of F(c,0) = 2 pi/m has c >= 2b 2^t, and one of G(u) = 2 pi/m has u >= 2^t/2:
/// t = -(2 pi/m) s/log 2 with s = 1/I, and also with s = 2 sqrt(b (a+b)). Proof. F(c,0) and G(u)
/// are the integrals of (1 - b x)/sqrt(x (1-x) (a + b x)) times 1/sqrt(c + b x) over (0, 1),
/// 1/sqrt(b (x-u)) over (u, 1). With 1 - b x >= 1 - b, a + b x <= a + b, 1 - x <= 1 they are at
/// least (1-b)/sqrt(a+b) times
///   (2/sqrt b) arsinh sqrt(b/c) >= (1/sqrt b) log(4b/c),
///     (2/sqrt b) arcosh(1/sqrt u) >= (1/sqrt b) log(1/u);
/// over x < 1/2 alone, where 1 - b x >= 1/2, at least (1/2)/sqrt(a+b) times
///   (2/sqrt b) arsinh sqrt(b/(2c)) >= (1/sqrt b) log(2b/c),
///     (2/sqrt b) arcosh(1/sqrt(2u)) >= (1/sqrt b) log(1/(2u)) for u < 1/2.
/// The first is I log(4b/c) or I log(1/u), the second the logarithm over 2 sqrt(b (a+b)).
ball least_log2(const body& rigid, const integer& m) {
  constexpr precision p = 192;
  const exact_real& b = rigid.b();
  const bool first = b < rational(1, 2);
  const ball inverse =
      first ? 1 / rigid.geometric_constant(p) : 2 * sqrt((b * (rigid.a() + b)).at(p));
  return -2 * pi(p) * inverse / (m * log_2(p));
}

// ---------------------------------------------------------------------------------------------
// Rotating: F(c,0) = 2 pi/m

certain_number rotating_root(const body& rigid, long m, long digits) {
  if (!rotates_beyond(rigid, m)) return refuted();
  const ball scale_of_b = log2((2 * rigid.b()).at(192));
  const auto least = exponent_below(least_log2(rigid, integer(m)) + scale_of_b);
  if (!least) return out_of_exponents();
  // F(c,0) goes on decreasing for c > a.
  const long greatest = exponent_above(rigid.a()) + 1;
  const auto phase = [&](const ball& c) { return rotating_half_phase(rigid, c); };
  const auto slope = [&](const ball& c) { return rotating_half_phase_slope(rigid, c); };
  const auto value = [&](precision p) { return 2 * pi(p) / m; };
  work_count work;
  const auto root = [&](precision p) {
    const root_enclosure found = solve_on_log_scale(phase, slope, value, *least, greatest, p);
    work.integrals += found.evaluations_of_f;
    work.newton_steps += found.evaluations_of_derivative;
    return found.verdict == root_verdict::unique ? found.root : ball::undefined(p);
  };
  certain_number result = number_to_digits(root, digits, ample_guard(digits));
  result.work = work;
  return result;
}

// ---------------------------------------------------------------------------------------------
// Oscillating: G(u) = 2 pi/m

/// Which of u and 1 - u is solved for, in what range; the bits that the equation loses.
struct equation_range {
  bool from_one = false;
  long least = 0;
  long greatest = 0;
  precision lost = 0;
};

turning_point share_of(const ball& x, bool from_one) {
  return from_one ? turning_point{1 - x, x} : turning_point{x, 1 - x};
}

/// 1 - u for a root u > 1/2, to about p bits or to a relative width of about 1 - u, whichever is
/// wider: by the mean value theorem G(u) - pi I = |G'| (1 - u) with G' at some point between u and
/// 1, and |G'| falls with u. The gap 2/m - I is formed from the squares, as an exact_real: it does
/// not cancel.
ball share_from_one(const body& rigid, const integer& m, precision p) {
  const rational two_over_m(2, m);
  const exact_real squares =
      rational(two_over_m * two_over_m) - rigid.square_of_geometric_constant();
  const ball gap = pi(p) * squares.at(p) / (rigid.geometric_constant(p) + two_over_m);
  const ball half(rational(1, 2), p);
  ball x = hull(ball(0, p), half);
  constexpr int most_steps = 8;
  for (int i = 0; i < most_steps; ++i) {
    const ball between = hull(ball(0, p), x);  // 1 less the point of the theorem
    const ball slope = -oscillating_half_phase_slope(rigid, {1 - between, between});
    const ball narrower = intersection(gap / slope, x);
    const bool narrowed = narrower.radius() <= scale(x.radius(), -1);
    x = narrower;
    if (!narrowed) break;
  }
  return x;
}

std::optional<equation_range> range_of(const body& rigid, const integer& m) {
  constexpr precision p = 192;
  const turning_point middle = share_of(ball(rational(1, 2), p), false);
  equation_range result;
  const ball excess = oscillating_half_phase(rigid, middle) - 2 * pi(p) / m;
  if (!certainly_positive(excess)) {
    const auto least = exponent_below(least_log2(rigid, m) - 1);
    if (!least) return std::nullopt;
    result.least = *least;
    // Undecided: the root may be on either side of 1/2.
    result.greatest = certainly_negative(excess) ? -1 : 0;
    return result;
  }
  result.from_one = true;
  const ball x = share_from_one(rigid, m, p);
  const auto least = exponent_below(log2(x));
  if (!least) return std::nullopt;
  result.least = *least;
  result.greatest = -1;
  result.lost = -*least;
  return result;
}

/// To about p bits of the smaller of u and 1 - u; undefined where it was not found.
ball oscillating_root(const body& rigid, const integer& m, const equation_range& range, precision p,
                      work_count& work) {
  // What is near 1 is computed with the bits that the difference from the limit loses.
  const auto raised = [&](const ball& x) { return x.with_precision(x.precision() + range.lost); };
  const auto phase = [&](const ball& x) {
    return oscillating_half_phase(rigid, share_of(raised(x), range.from_one));
  };
  const auto slope = [&](const ball& x) {
    const ball result = oscillating_half_phase_slope(rigid, share_of(x, range.from_one));
    return range.from_one ? -result : result;
  };
  const auto value = [&](precision q) { return 2 * pi(q + range.lost) / m; };
  const precision most = (1L << 14) + 4 * range.lost;
  const root_enclosure found =
      solve_on_log_scale(phase, slope, value, range.least, range.greatest, p, most);
  work.integrals += found.evaluations_of_f;
  work.newton_steps += found.evaluations_of_derivative;
  return found.verdict == root_verdict::unique ? found.root : ball::undefined(p);
}

}  // namespace

// ---------------------------------------------------------------------------------------------
// What exists

integer meeting_count(const body& rigid) {
  return greatest_root_below(4 / rigid.square_of_geometric_constant());
}
integer intersection_count(const body& rigid) { return (meeting_count(rigid) + 1) / 2; }
integer crossing_count(const body& rigid) { return meeting_count(rigid) / 2; }

bool has_perfect_twist(const body& rigid) { return rotates_beyond(rigid, 1); }
bool has_full_turn(const body& rigid) { return rotates_beyond(rigid, 2); }
bool is_injective(const body& rigid) { return rigid.kind() != body_kind::non_physical; }

// ---------------------------------------------------------------------------------------------
// Where it is

certain_number separatrix_defect_to_digits(const body& rigid, long digits) {
  return defect_to_digits(rigid, 0, digits);
}

certain_number perfect_twist_to_digits(const body& rigid, long digits) {
  return rotating_root(rigid, 1, digits);
}
certain_number full_turn_to_digits(const body& rigid, long digits) {
  return rotating_root(rigid, 2, digits);
}

meeting meeting_to_digits(const body& rigid, const integer& m, long digits) {
  if (m < 1) throw input_error("m = " + m.str() + ": it must be a whole number from 1 on");
  meeting result;
  result.why = reason::precision_limit;
  result.m = m;
  result.u = result.one_minus_u = result.c = result.epsilon = ball::undefined(64);
  if (m > meeting_count(rigid)) {
    result.why = reason::refuted;
    return result;
  }
  const auto range = range_of(rigid, m);
  if (!range) return result;
  const bool intersection = m % 2 != 0;
  const bool beyond = m % 4 == 3;  // k even
  const precision needed = bits_for_digits(digits);
  const precision most_guard = ample_guard(digits);
  for (precision guard = 32; guard <= most_guard; guard *= 2) {
    const ball x = oscillating_root(rigid, m, *range, needed + guard, result.work);
    if (!x.is_bounded()) continue;
    // Near 1, u = 1 - x is resolved by as many bits as x is small.
    const turning_point s =
        share_of(x.with_precision(x.precision() + range->lost), range->from_one);
    const ball c = -rigid.b().at(s.u.precision()) * s.u;
    const ball sine = sqrt(s.u);
    const ball cosine = sqrt(s.left);
    const ball epsilon =
        intersection ? atan2(sine, beyond ? -cosine : cosine) : ball::undefined(64);
    if (!detail::has_digits(s.u, digits) || !detail::has_digits(c, digits) ||
        (intersection && !detail::has_digits(epsilon, digits))) {
      continue;
    }
    result.verdict = status::certified;
    result.why = reason::none;
    result.u = s.u;
    result.one_minus_u = s.left;
    result.c = c;
    result.epsilon = epsilon;
    return result;
  }
  return result;
}

}  // namespace polhode
