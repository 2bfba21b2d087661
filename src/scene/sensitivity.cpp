// How the period and the Montgomery phase depend on the body and the motion; and what must be
// conserved.

#include <algorithm>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "polhode/rigid_body/half_phase.hpp"
#include "scene/effect_context.hpp"
#include "scene/motion.hpp"
#include "scene/sensitivity.hpp"

namespace polhode::detail {
namespace {

/// Derivatives in a, b, c.
struct slopes {
  ball a, b, c;
};

/// T in I_y/J and the Montgomery phase, with their derivatives.
///
/// With L = lambda^2 and m1 (motion.hpp) T = 4 R_F(0, m1, 1)/sqrt L, and dR_F(0,y,1)/dy =
/// -R_D(0,1,y)/6 (DLMF 19.18.1), so that for q = a, b, c
///   dT/dq = (4/lambda) [-R_D(0,1,m1)/6 dm1/dq - R_F(0,m1,1)/(2L) dL/dq].
/// The phase is (1+c) T - alpha with alpha = the integral of cos theta dpsi around. As x = cos^2
/// psi gives cos^2 theta = (c+bx)/(a+bx) and dpsi/dt = sqrt((a+bx)(c+bx)), and as the ends of an
/// oscillation, where cos theta = 0, contribute nothing,
///   dalpha/da = -(1/2) the integral of cos^2 theta dt = -(1/2) that of J_z^2,
///   dalpha/db =  (1/2) the integral of x sin^2 theta dt = (1/2) that of J_x^2,
///     dalpha/dc = T/2,
/// over a period, |J| = 1. With B = the integral of cn^2 over a quarter in u, the integral of J_x^2
/// is 4 A^2 B/lambda where the body rotates and that of J_z^2 is 4 C^2 B/lambda where it
/// oscillates, A^2 = (a-c)/(a+b), C^2 = (b+c)/(a+b); the other one follows from a J_z^2 - b J_x^2 =
/// c, with two terms of one sign. B = m1 R_D(0,1,m1)/3 (DLMF 19.25.1).
struct derivatives {
  ball period;
  slopes of_period;
  slopes of_phase;
};

ball at(const exact_real& x, precision p) { return x.at(p); }
ball at(const ball& x, precision /*p*/) { return x; }

/// Number: exact_real, or ball for all motions whose a, b and c are in balls.
template <class Number>
derivatives derivatives_of(const sensitivity_point<Number>& of, precision p) {
  const Number& a = of.a;
  const Number& b = of.b;
  const Number& c = of.c;
  const Number total = a + b;
  const Number x_end = b + c;
  const Number z_end = a - c;
  const bool rotating = of.rotating;
  // With each of a, b and c as seldom as can be, for ranges: share is |c|/(b + c) or |c|/(a - c).
  const Number l = rotating ? a * x_end : b * z_end;
  const Number share = rotating ? 1 / (1 + b / c) : 1 / (1 - a / c);
  const Number m1 = share * (1 + (rotating ? b / a : a / b));
  // In a, b, c.
  const triple<Number> dl = rotating ? triple<Number>{x_end, a, a} : triple<Number>{b, z_end, -b};
  const triple<Number> dm1 =
      rotating ? triple<Number>{-share * b / (a * a), -share * (1 - c / a) / x_end,
                                (1 + b / a) * b / (x_end * x_end)}
               : triple<Number>{-share * (1 + c / b) / z_end, -share * a / (b * b),
                                -(1 + a / b) * a / (z_end * z_end)};
  const ball lambda = sqrt(at(l, p));
  const ball y = at(m1, p);
  const ball rf = carlson_rf(ball(0, p), y, ball(1, p));
  const ball rd = carlson_rd(ball(0, p), ball(1, p), y);
  const auto slope = [&](std::size_t q) {
    return 4 / lambda * (-rd * (dm1[q] / 6) - rf * (dl[q] / (2 * l)));
  };
  derivatives result;
  result.period = 4 * rf / lambda;
  result.of_period = {slope(0), slope(1), slope(2)};
  const ball quarter = y * rd / 3;
  ball x2;
  ball z2;
  if (rotating) {
    x2 = 4 * (z_end / total) * quarter / lambda;
    z2 = (c * result.period + b * x2) / a;
  } else {
    z2 = 4 * (x_end / total) * quarter / lambda;
    x2 = (a * z2 - c * result.period) / b;
  }
  const Number factor = 1 + c;
  result.of_phase = {factor * result.of_period.a + scale(z2, -1),
                     factor * result.of_period.b - scale(x2, -1),
                     factor * result.of_period.c + scale(result.period, -1)};
  return result;
}

bool has_digits(const ball& x, long digits) {
  if (!x.is_bounded()) return false;
  return to_decimal_enclosure(x, digits).has(digits);
}

/// Guard bits: small differences of a, b and c cost some.
precision most_guard_of(const effect_context& x) {
  const precision sizes =
      size_in_bits(x.rigid().a()) + size_in_bits(x.rigid().b()) + size_in_bits(x.c());
  return ample_guard(x.digits()) + std::min(8 * sizes, greatest_guard);
}

}  // namespace

/// By moments it is d log T/d log I for I_x, I_y, I_z at fixed angular momentum vector, where T is
/// T I_y/J in time and c = I_y (J_x^2/I_x + J_y^2/I_y + J_z^2/I_z)/J^2 - 1; and d phase/d log I.
template <class Number>
std::vector<effect_number> derivatives_at(const sensitivity_point<Number>& of, precision p) {
  const derivatives d = derivatives_of(of, p);
  std::vector<effect_number> result;
  const auto put = [&](const std::string& name, const ball& x, const std::string& unit = "") {
    result.push_back({name, x, {}, unit});
  };
  put("dT_da", d.of_period.a, "I_y/J");
  put("dT_db", d.of_period.b, "I_y/J");
  put("dT_dc", d.of_period.c, "I_y/J");
  put("dphase_da", d.of_phase.a, "rad");
  put("dphase_db", d.of_phase.b, "rad");
  put("dphase_dc", d.of_phase.c, "rad");
  if (!of.vectors) return result;
  const triple<Number>& m = of.vectors->moments;
  const triple<Number>& j = of.vectors->direction_squares;
  // I da/dI, I db/dI, I dc/dI.
  const Number none = 0 * m[0];
  const std::array<triple<Number>, 3> chain{
      {{none, m[1] / m[0], -m[1] * j[0] / m[0]},
       {m[1] / m[2], -m[1] / m[0], m[1] * (j[0] / m[0] + j[2] / m[2])},
       {-m[1] / m[2], none, -m[1] * j[2] / m[2]}}};
  const auto along = [&](const slopes& s, std::size_t i) {
    return chain[i][0] * s.a + chain[i][1] * s.b + chain[i][2] * s.c;
  };
  const std::array<const char*, 3> axis{"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    put(std::string("dlogT_dlogI") + axis[i], along(d.of_period, i) / d.period + (i == 1 ? 1 : 0));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    put(std::string("dphase_dlogI") + axis[i], along(d.of_phase, i), "rad");
  }
  return result;
}
template std::vector<effect_number> derivatives_at(const sensitivity_point<ball>& of, precision p);

namespace {
/// The scene's own motion.
sensitivity_point<exact_real> point_of(const effect_context& x) {
  const motion& of = x.motion();
  sensitivity_point<exact_real> result{of.a(), of.b(), of.c(), of.regime() == regime::rotating, {}};
  if (x.what.state->momentum) {
    result.vectors = {x.what.body.moments(), x.start().direction_squares()};
  }
  return result;
}
}  // namespace

effect_result sensitivity(const effect_context& x) {
  effect_result result;
  const long digits = x.digits();
  const precision p0 = bits_for_digits(digits) + 64;
  // The middle axis is unstable: a small departure grows as e^(sqrt(ab) t) (c = 0 in the solution
  // on the separatrix).
  const ball growth = sqrt((x.rigid().a() * x.rigid().b()).at(p0));
  add(result, "e_folding_time_at_middle_axis", natural_time(x.what, p0) / growth,
      x.what.time_unit.name);
  if (!is_periodic(x.regime())) {
    result.remarks.push_back(to_text(x.regime()) + ": no period and no phase to differentiate");
    return result;
  }
  const precision most = most_guard_of(x);
  const sensitivity_point<exact_real> point = point_of(x);
  for (precision guard = 64;; guard *= 2) {
    const std::vector<effect_number> found = derivatives_at(point, bits_for_digits(digits) + guard);
    result.work.integrals += 2;
    const bool enough = std::all_of(found.begin(), found.end(), [&](const effect_number& n) {
      return has_digits(n.enclosure, digits);
    });
    if (!enough && guard < most) continue;
    for (const effect_number& n : found) add(result, n.name, n.enclosure, n.unit);
    return result;
  }
}

namespace {
/// Two routes to the phase's slope: the identity, and the integral differentiated (half_phase.hpp).
ball difference_of_slopes(const effect_context& x, precision p) {
  const motion& of = x.motion();
  const ball by_identity = derivatives_of(point_of(x), p).of_phase.c;
  const exact_real u = of.turning_point();
  const ball direct =
      of.regime() == regime::rotating
          ? 2 * rotating_half_phase_slope(x.rigid(), of.c().at(p))
          : -2 * oscillating_half_phase_slope(x.rigid(), {u.at(p), (1 - u).at(p)}) / of.b().at(p);
  return direct / by_identity - 1;
}
}  // namespace

effect_result audit(const effect_context& x) {
  effect_result result;
  const magnitude tolerance =
      magnitude::power_of_two(1 - static_cast<std::int64_t>(bits_for_digits(x.digits())));
  const precision most = most_guard_of(x);
  bool narrow = false;
  bool broken = false;
  for (precision guard = 64; !narrow && !broken && guard <= most; guard *= 2) {
    result.numbers.clear();
    narrow = true;
    const auto expect_zero = [&](const std::string& name, const ball& difference) {
      result.numbers.push_back({name, difference, {}, "", true});
      narrow = narrow && difference.is_bounded() && difference.radius() <= tolerance;
      broken = broken || (difference.is_bounded() && !contains_zero(difference));
    };
    const precision p = bits_for_digits(x.working_digits()) + guard;
    result.work += audit_motion(x, p, expect_zero);
    if (is_periodic(x.regime())) {
      expect_zero("phase_slope", difference_of_slopes(x, p));
      result.work.integrals += 5;
    }
  }
  result.words = {{"all_hold", broken ? "no" : narrow ? "yes" : "not decided"}};
  result.remarks.emplace_back(
      "each is enclosed in an interval that must hold 0: the relative change of what is conserved, "
      "or the difference "
      "of two routes");
  if (broken) {
    not_certified(result, "a conserved quantity was not conserved: please report this");
  } else if (!narrow) {
    not_certified(result,
                  "the greatest precision that is tried does not decide to the digits asked for");
  }
  return result;
}

}  // namespace polhode::detail
