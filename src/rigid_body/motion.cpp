#include "polhode/rigid_body/motion.hpp"

#include <compare>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "polhode/elliptic/complete.hpp"
#include "rigid_body/phase_integral.hpp"

namespace polhode {
namespace {

regime regime_by(const exact_real& a, const exact_real& b, const exact_real& c) {
  const std::strong_ordering least = -b <=> c;
  const std::strong_ordering greatest = a <=> c;
  if (std::is_gt(least) || std::is_lt(greatest)) {
    throw input_error("c = " + to_text(c) + ": it must be from -b = " + to_text(-b) +
                      " to a = " + to_text(a));
  }
  if (std::is_eq(least)) return regime::equilibrium_x;
  if (std::is_eq(greatest)) return regime::equilibrium_z;
  const int sign = c.sign();
  if (sign == 0) return regime::separatrix;
  return sign < 0 ? regime::oscillating : regime::rotating;
}

}  // namespace

// ---------------------------------------------------------------------------------------------
// Regimes

regime regime_of(const body& rigid, const exact_real& c) {
  return regime_by(rigid.a(), rigid.b(), c);
}

std::string to_text(regime r) {
  switch (r) {
    case regime::equilibrium_x:
      return "equilibrium about x";
    case regime::oscillating:
      return "oscillating";
    case regime::separatrix:
      return "separatrix";
    case regime::rotating:
      return "rotating";
    case regime::equilibrium_y:
      return "equilibrium about y";
    case regime::equilibrium_z:
      break;
  }
  return "equilibrium about z";
}

// ---------------------------------------------------------------------------------------------
// Motions

motion::motion(const body& rigid, const exact_real& c) : motion(rigid.a(), rigid.b(), c) {}

motion::motion(exact_real a, exact_real b, exact_real c, polhode::regime known)
    : a_(std::move(a)),
      b_(std::move(b)),
      c_(std::move(c)),
      regime_(known == regime::equilibrium_y ? regime::separatrix : known) {}

motion::motion(exact_real a, exact_real b, exact_real c)
    : a_(std::move(a)), b_(std::move(b)), c_(std::move(c)) {
  if (a_.sign() < 0) throw input_error("a = " + to_text(a_) + ": it must not be negative");
  if (b_.sign() < 0 || b_ >= 1) {
    throw input_error("b = " + to_text(b_) + ": it must be at least 0 and below 1");
  }
  regime_ = regime_by(a_, b_, c_);
}

motion::factors motion::factors_of_lambda2() const {
  factors result = is_about_x(regime_) ? factors{a_ - c_, b_} : factors{a_, b_ + c_};
  if (result.first.sign() == 0 || result.second.sign() == 0) {
    throw input_error("a = " + to_text(a_) + ", b = " + to_text(b_) + ", c = " + to_text(c_) +
                      ": two moments are equal, and J does not move in the body; lambda is 0");
  }
  return result;
}

exact_real motion::lambda2() const {
  const auto [first, second] = factors_of_lambda2();
  return first * second;
}

exact_real motion::m1() const { return (is_about_x(regime_) ? -c_ : c_) * (a_ + b_) / lambda2(); }

/// By lambda^2 - lambda^2 m_1, which is b (a-c) + c (a+b) = a (b+c) where the motion oscillates,
/// and a (b+c) - c (a+b) = b (a-c) else.
exact_real motion::m() const {
  const exact_real other = is_about_x(regime_) ? a_ * (b_ + c_) : b_ * (a_ - c_);
  return other / lambda2();
}

exact_real motion::kappa() const {
  const auto [first, second] = factors_of_lambda2();
  return (is_about_x(regime_) ? b_ + c_ : b_) / first;
}

std::array<exact_real, 3> motion::greatest_squares() const {
  const auto [first, second] = factors_of_lambda2();
  const exact_real sum = a_ + b_;
  const exact_real x_end = b_ + c_;
  const exact_real z_end = a_ - c_;
  return {z_end / sum, is_about_x(regime_) ? x_end / second : z_end / first, x_end / sum};
}

exact_real motion::turning_point() const {
  return is_about_x(regime_) && b_.sign() != 0 ? -c_ / b_ : exact_real(0);
}

ball motion::period(precision p, work_count* work) const {
  refuse_unless_periodic();
  const ball root = sqrt(m1().at(p));
  const ball one(1, p);
  ball mean;
  if (work == nullptr) {
    mean = agm(one, root);
  } else {  // the same mean, by steps that are counted
    const agm_sums counted = agm_with_sum(one, root);
    mean = counted.mean;
    ++work->integrals;
    work->agm_steps += counted.steps;
  }
  return 2 * pi(p) / (mean * sqrt(lambda2().at(p)));
}

ball motion::phase(precision p) const {
  refuse_unless_periodic();
  // At a turning point c + b u = 0.
  const exact_real last = is_about_x(regime_) && b_.sign() != 0 ? exact_real(0) : c_;
  return 2 * detail::phase_integral_of(a_, b_, c_, turning_point(), last, p);
}

void motion::refuse_equilibrium() const {
  if (!is_equilibrium(regime_)) return;
  throw input_error(
      "c = " + to_text(c_) + ": " + to_text(regime_) +
      ", where the angular momentum does not move in the body; give c between -b and a, "
      "ends excluded");
}

void motion::refuse_unless_periodic() const {
  refuse_equilibrium();
  if (regime_ != regime::separatrix) return;
  throw input_error(
      "c = 0: on the separatrix the Montgomery phase is infinite; give c < 0 or "
      "c > 0");
}

// ---------------------------------------------------------------------------------------------
// The phase's integral

ball detail::phase_integral_of(const exact_real& a, const exact_real& b, const exact_real& c,
                               const exact_real& u, const exact_real& last, precision p) {
  const exact_real left = 1 - u;
  const exact_real total = a + b;
  const exact_real end = b + c;
  const ball x = u.at(p);
  const ball y = ((a + b * u) / total).at(p);
  const ball z = (last / end).at(p);
  const carlson_pair integrals = carlson_rf_rj(x, y, z, ball(1, p));
  const ball sum = (1 - b) * integrals.rf + b * left / 3 * integrals.rj;
  return 2 * sqrt((left / (total * end)).at(p)) * sum;
}

}  // namespace polhode
