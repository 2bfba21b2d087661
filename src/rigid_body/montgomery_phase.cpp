#include "polhode/rigid_body/montgomery_phase.hpp"

#include <string>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/motion.hpp"
#include "rigid_body/phase_integral.hpp"

namespace polhode {
namespace {

void check_range(const body& rigid, const exact_real& c, const exact_real& u) {
  const regime r = regime_of(rigid, c);  // refuses c outside [-b, a]
  if (r == regime::equilibrium_x) {
    throw input_error("c = " + to_text(c) + ": it must be above -b for F(c,u)");
  }
  if (u < 0 || u >= 1) {
    throw input_error("u = " + to_text(u) + ": it must be at least 0 and below 1");
  }
  if (rigid.b() * u + c < 0) {
    throw input_error("u = " + to_text(u) + ": it must be at least -c/b, and c + b u not negative");
  }
  if (c == 0 && u == 0) {
    throw input_error("c = 0, u = 0: F(c,u) is infinite there; one of them must not be 0");
  }
}

ball geometric_phase_of(const motion& of, precision p) {
  return of.phase(p) - (1 + of.c()) * of.period(p);
}

}  // namespace

ball phase_integral(const body& rigid, const exact_real& c, const exact_real& u, precision p) {
  check_range(rigid, c, u);
  return detail::phase_integral_of(rigid.a(), rigid.b(), c, u, c + rigid.b() * u, p);
}

ball phase_integral_slope(const body& rigid, const rational& c, const rational& u, precision p) {
  check_range(rigid, c, u);
  const exact_real& a = rigid.a();
  const exact_real& b = rigid.b();
  const exact_real last = c + b * u;
  if (u == 0 || last == 0) {
    throw input_error("c = " + to_text(c) + ", u = " + to_text(u) +
                      ": dF/du is infinite there; u must be above 0 and above -c/b");
  }
  const exact_real radicand = rational(u * (1 - u)) * (a + b * u) * last;
  return (b * u - 1).at(p) / sqrt(radicand.at(p));
}

ball montgomery_phase(const body& rigid, const exact_real& c, precision p) {
  return motion(rigid, c).phase(p);
}

ball rotation_period(const body& rigid, const rational& c, precision p) {
  return motion(rigid, c).period(p);
}

ball dynamic_phase(const body& rigid, const rational& c, precision p) {
  return rational(1 + c) * rotation_period(rigid, c, p);
}

ball geometric_phase(const body& rigid, const rational& c, precision p) {
  return geometric_phase_of(motion(rigid, c), p);
}

ball montgomery_phase_limit(const body& rigid, const rational& c, precision p) {
  const regime r = regime_of(rigid, c);
  if (r == regime::separatrix) {
    throw input_error("c = 0: the separatrix belongs to neither regime; give c < 0 or c > 0");
  }
  return 2 * pi(p) *
         (is_about_x(r) ? rigid.geometric_constant(p) : rigid.second_geometric_constant(p));
}

certain_number montgomery_phase_to_digits(const body& rigid, const rational& c, long digits) {
  return montgomery_phase_to_digits(motion(rigid, c), digits);
}

certain_number montgomery_phase_to_digits(const motion& of, long digits) {
  work_count work;
  const auto phase = [&](precision p) {
    ++work.integrals;
    return of.phase(p);
  };
  certain_number result = number_to_digits(phase, digits, ample_guard(digits));
  result.work = work;
  return result;
}

certain_number montgomery_phase_limit_to_digits(const body& rigid, const rational& c, long digits) {
  return number_to_digits([&](precision p) { return montgomery_phase_limit(rigid, c, p); }, digits,
                          ample_guard(digits));
}

certain_number rotation_period_to_digits(const body& rigid, const rational& c, long digits) {
  return number_to_digits([&](precision p) { return rotation_period(rigid, c, p); }, digits,
                          ample_guard(digits));
}

certain_number dynamic_phase_to_digits(const body& rigid, const rational& c, long digits) {
  return number_to_digits([&](precision p) { return dynamic_phase(rigid, c, p); }, digits,
                          ample_guard(digits));
}

certain_number geometric_phase_to_digits(const body& rigid, const rational& c, long digits) {
  return geometric_phase_to_digits(motion(rigid, c), digits);
}

certain_number geometric_phase_to_digits(const motion& of, long digits) {
  const precision sizes = size_in_bits(of.a()) + size_in_bits(of.b()) + size_in_bits(of.c());
  work_count work;
  const auto phase = [&](precision p) {
    work.integrals += 2;
    return geometric_phase_of(of, p);
  };
  certain_number result = number_to_digits(phase, digits, 2 * sizes + ample_guard(digits));
  result.work = work;
  return result;
}

certain_number montgomery_phase_excess_to_digits(const body& rigid, const rational& c,
                                                 long digits) {
  certain_number phase = montgomery_phase_to_digits(rigid, c, 1);
  if (phase.verdict != status::certified) return phase;
  // What cancels is of the order of (b + c)/b or (a - c)/a, numbers of no more bits than a, b and c
  // together.
  const precision cancelled = size_in_bits(rigid.a()) + size_in_bits(rigid.b()) + size_in_bits(c);
  const auto excess = [&](precision p) {
    return montgomery_phase(rigid, c, p) - montgomery_phase_limit(rigid, c, p);
  };
  return number_to_digits(excess, digits, 2 * cancelled + ample_guard(digits));
}

}  // namespace polhode
