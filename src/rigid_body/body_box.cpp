#include "polhode/rigid_body/body_box.hpp"

#include <algorithm>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/legendre.hpp"
#include "polhode/rigid_body/half_phase.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "polhode/rigid_body/twist_curve.hpp"

namespace polhode {
namespace {

void expect_not_empty(const char* name, const rational_range& range) {
  if (range.low <= range.high) return;
  throw input_error(std::string("the range of ") + name + " from " + to_text(range.low) + " to " +
                    to_text(range.high) + " is empty: give the lower end first");
}

body corner(const rational_range& a, const rational_range& b, bool high) {
  expect_not_empty("a", a);
  expect_not_empty("b", b);
  return high ? body(a.high, b.high) : body(a.low, b.low);
}

template <class T>
std::optional<T> if_equal(const T& x, const T& y) {
  return x == y ? std::optional(x) : std::nullopt;
}

/// From both ends of a range that were certified.
ball between(const certain_number& x, const certain_number& y) {
  if (x.verdict != status::certified || y.verdict != status::certified) {
    return ball::undefined(64);
  }
  return hull(x.enclosure, y.enclosure);
}

// Of a motion c, or of a number c < 0 below -b, where the formulas go on.

ball period_of(const body& rigid, const rational& c, precision p) {
  const rational& a = rigid.a().exact();
  const rational& b = rigid.b().exact();
  const auto mean = [p](const rational& x, const rational& y) {
    return agm(sqrt(ball(x, p)), sqrt(ball(y, p)));
  };
  return 2 * pi(p) / (c > 0 ? mean(a * (b + c), c * (a + b)) : mean(b * (a - c), -c * (a + b)));
}

ball phase_of(const body& rigid, const rational& c, precision p) {
  if (c > 0) return 2 * rotating_half_phase(rigid, ball(c, p));
  const rational u = -c / rigid.b().exact();
  return 2 * oscillating_half_phase(rigid, {ball(u, p), ball(rational(1 - u), p)});
}

}  // namespace

body_box::body_box(const rational_range& a, const rational_range& b)
    : least_(corner(a, b, false)), greatest_(corner(a, b, true)) {}

body_box body_box::of_moments(const std::array<rational_range, 3>& moments) {
  const auto& [x, y, z] = moments;
  return {{y.low / z.high - 1, y.high / z.low - 1}, {1 - y.high / x.low, 1 - y.low / x.high}};
}

body_kind body_box::kind() const {
  if (greatest_.kind() != body_kind::non_physical) {
    return a().low == a().high && b().low == b().high ? greatest_.kind() : body_kind::physical;
  }
  return least_.kind() == body_kind::non_physical ? body_kind::non_physical : body_kind::undecided;
}

std::optional<integer> body_box::meeting_count() const {
  return if_equal(polhode::meeting_count(least_), polhode::meeting_count(greatest_));
}

std::optional<integer> body_box::intersection_count() const {
  return if_equal(polhode::intersection_count(least_), polhode::intersection_count(greatest_));
}

std::optional<bool> body_box::is_injective() const {
  return if_equal(polhode::is_injective(least_), polhode::is_injective(greatest_));
}

std::optional<bool> body_box::has_perfect_twist() const {
  return if_equal(polhode::has_perfect_twist(least_), polhode::has_perfect_twist(greatest_));
}

std::optional<bool> body_box::has_full_turn() const {
  return if_equal(polhode::has_full_turn(least_), polhode::has_full_turn(greatest_));
}

ball body_box::geometric_constant(precision p) const {
  return hull(least_.geometric_constant(p), greatest_.geometric_constant(p));
}

ball body_box::second_geometric_constant(precision p) const {
  return hull(least_.second_geometric_constant(p), greatest_.second_geometric_constant(p));
}

ball body_box::separatrix_defect(long digits) const {
  return between(separatrix_defect_to_digits(least_, digits),
                 separatrix_defect_to_digits(greatest_, digits));
}

ball body_box::perfect_twist(long digits) const {
  if (has_perfect_twist() != true) return ball::undefined(64);
  return between(perfect_twist_to_digits(least_, digits),
                 perfect_twist_to_digits(greatest_, digits));
}

ball body_box::full_turn(long digits) const {
  if (has_full_turn() != true) return ball::undefined(64);
  return between(full_turn_to_digits(least_, digits), full_turn_to_digits(greatest_, digits));
}

body_box::meeting_range body_box::meeting(const integer& m, long digits) const {
  const polhode::meeting first = meeting_to_digits(least_, m, digits);
  const polhode::meeting last = meeting_to_digits(greatest_, m, digits);
  if (first.verdict != status::certified || last.verdict != status::certified) {
    return {ball::undefined(64), ball::undefined(64)};
  }
  return {hull(first.c, last.c), hull(first.epsilon, last.epsilon)};
}

template <class Value>
ball body_box::of_motions(const rational_range& c, const Value& value) const {
  if (c.low > 0) {
    const rational high = std::min(c.high, a().high);
    return c.low > high ? ball::undefined(64) : hull(value(least_, c.low), value(greatest_, high));
  }
  const rational low = std::max(c.low, rational(-b().high));
  if (c.high >= 0 || low > c.high) return ball::undefined(64);
  return hull(value(greatest_, low), value(least_, c.high));
}

ball body_box::period(const rational_range& c, precision p) const {
  return of_motions(c,
                    [p](const body& rigid, const rational& at) { return period_of(rigid, at, p); });
}

ball body_box::montgomery_phase(const rational_range& c, precision p) const {
  return of_motions(c,
                    [p](const body& rigid, const rational& at) { return phase_of(rigid, at, p); });
}

ball body_box::mean_rate(const rational_range& c, precision p) const {
  return of_motions(c, [p](const body& rigid, const rational& at) {
    return phase_of(rigid, at, p) / period_of(rigid, at, p);
  });
}

ball body_box::twist(const rational_range& c, long digits) const {
  if (c.low > c.high || c.low <= -b().low || c.low >= a().low || c.high >= a().high) {
    return ball::undefined(64);
  }
  if (c.low < 0) {
    const precision p = 128;
    const ball least_phase = phase_of(greatest_, c.low, p);
    if (!certainly_less(4 * pi(p), least_phase)) return ball::undefined(64);
  }
  return between(defect_to_digits(least_, c.low, digits),
                 defect_to_digits(greatest_, c.high, digits));
}

ball limit_defect_range(const rational_range& chi, const rational_range& beta, long digits) {
  expect_not_empty("chi", chi);
  expect_not_empty("beta", beta);
  constexpr precision p = 128;
  const auto xi = [](const rational& at) { return pi(p) * sqrt(ball(at, p)); };
  const auto turning_point = [](const rational& at) {
    return elliptic_k(elliptic_parameter<ball>::with_complement(ball(rational(-at), p)));
  };
  const auto defect = [digits](const rational& at_chi, const rational& at_beta) {
    return limit_defect_to_digits(at_chi, at_beta, digits);
  };
  const ball least_psi = between(defect(chi.low, beta.low), defect(chi.high, beta.low));
  if (beta.low < 0 && !certainly_less(xi(chi.high), 2 * turning_point(beta.low))) {
    return ball::undefined(64);
  }
  if (beta.high >= 0 || certainly_less(xi(chi.high), turning_point(beta.high))) {
    return hull(least_psi, between(defect(chi.high, beta.high), defect(chi.high, beta.high)));
  }
  if (certainly_less(turning_point(beta.high), xi(chi.low))) {
    return hull(least_psi, between(defect(chi.low, beta.high), defect(chi.low, beta.high)));
  }
  // cos psi = sqrt(-beta) at the turning point.
  return hull(least_psi, asin(sqrt(ball(rational(-beta.high), bits_for_digits(digits) + 64))));
}

}  // namespace polhode
