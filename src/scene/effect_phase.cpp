// Effects of a motion c: regime, period, Montgomery phase; and the curves over c.

#include <array>
#include <optional>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/curve_motions.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "scene/effect_context.hpp"

namespace polhode::detail {
namespace {

/// Exactly about the intermediate axis, where that is known.
bool is_on_middle_axis(const effect_context& x) {
  return x.what.state->start && x.start().regime() == regime::equilibrium_y;
}
constexpr const char* middle_axis = "exactly about the intermediate axis: an unstable equilibrium";

/// What there is to say where nothing is periodic.
void remark_unless_periodic(effect_result& result, const effect_context& x, const char* what) {
  const regime motion = x.regime();
  if (is_on_middle_axis(x)) {
    result.remarks.push_back(std::string(middle_axis) + ", and there is no " + what);
  } else if (motion == regime::separatrix) {
    result.remarks.push_back(std::string("on the separatrix ") + what + " is infinite");
  } else if (!is_periodic(motion)) {
    result.remarks.push_back(to_text(motion) +
                             ": the angular momentum does not move in the body, and there is no " +
                             what);
  }
}

/// A table over the curve's motions; none where one of its numbers is not certified.
template <class F>
effect_result curve(const effect_context& x, const std::string& column, const std::string& name,
                    const F& at) {
  effect_result result;
  effect_table table;
  table.columns = {"c", column};
  table.units = {"", "rad"};
  table.digits = x.digits();
  for (const rational& c : curve_motions(x.rigid(), x.what.c_range, x.what.points)) {
    const std::optional<certain_number> found = at(c);
    if (!found) continue;
    result.work += found->work;
    if (found->verdict != status::certified) {
      not_certified(result, name + " at c = " + to_text(c) + " was not certified (" +
                                to_text(found->why) + ")");
      return result;
    }
    table.first.push_back(c);
    table.rows.push_back({found->enclosure});
  }
  add_exact(result, "points", rational(static_cast<long>(table.rows.size())));
  result.table = std::move(table);
  return result;
}

}  // namespace

effect_result regime_effect(const effect_context& x) {
  effect_result result;
  result.words = {{"regime", to_text(x.regime())}};
  add(result, "c", x.c(), x.working_digits());
  if (is_on_middle_axis(x)) result.remarks.emplace_back(middle_axis);
  return result;
}

effect_result period(const effect_context& x) {
  effect_result result;
  remark_unless_periodic(result, x, "period");
  if (!is_periodic(x.regime())) return result;
  const long digits = x.working_digits();
  const ball natural = enclose_to_digits(
      [&](precision p) { return x.motion().period(p, &result.work); }, digits, ample_guard(digits));
  if (natural.is_undefined()) {
    not_certified(result, "the period was not certified");
    return result;
  }
  const ball unit_of_time = natural_time(x.what, natural.precision() + 32);
  if (x.what.time_kind != scene::time_scale::natural)
    add(result, "period", natural * unit_of_time, x.what.time_unit.name);
  add(result, "natural_period", natural, "I_y/J");
  return result;
}

effect_result montgomery_phase_effect(const effect_context& x) {
  effect_result result;
  remark_unless_periodic(result, x, "phase");
  if (!is_periodic(x.regime())) return result;
  const certain_number phase = montgomery_phase_to_digits(x.motion(), x.working_digits());
  add(result, "phase", phase, "rad");
  if (phase.verdict != status::certified) return result;
  const ball dynamic = (1 + x.c()) * x.number("period", "natural_period");
  add(result, "dynamic", dynamic, "rad");
  const ball geometric = phase.enclosure - dynamic;
  if (to_decimal_enclosure(geometric, x.digits()).has(x.digits())) {
    add(result, "geometric", geometric, "rad");
  } else {  // it cancels near c = -b
    add(result, "geometric", geometric_phase_to_digits(x.motion(), x.digits()), "rad");
  }
  return result;
}

/// The mean rates at which the three axes turn about the angular momentum J, and the wobble, which
/// is that of the axis around which J goes.
///
/// Over one period T of J in the body the body turns about J by the phase P, and the azimuth of
/// each of its axes about J advances by P and a whole number of turns. phi is the azimuth of the
/// least axis z, up to a constant: P = phi(T) - phi(0) without a turn more. The difference of the
/// azimuths of two axes is a function of J's place in the body, continuous where J lies on neither
/// of the two lines. Along J's closed path around one of these lines and not the other it changes
/// by one turn, along a path around neither by none. J goes around x (the greatest axis) where the
/// motion is oscillating, and around z where it is rotating; so the axis that J goes around and the
/// two others differ by a turn a period, and the two others agree. Its sign is the same for all
/// bodies and motions of a regime, by continuity. Near the steady rotation about x of a body with
/// I_y = I_z, x turns at the rate |J|/I_y and the body at |J|/I_x, with 2 pi/T = |J|/I_y - |J|/I_x:
/// the azimuth of x advances by P + 2 pi. Near that about z with I_x = I_y, z turns at |J|/I_y and
/// the body at |J|/I_z > |J|/I_y, with 2 pi/T = |J|/I_z - |J|/I_y: the azimuths of x and y advance
/// by P + 2 pi.
effect_result mean_precession(const effect_context& x) {
  effect_result result;
  const regime motion = x.regime();
  const std::string per_time =
      x.what.time_kind == scene::time_scale::natural ? "J/I_y" : "rad per " + x.what.time_unit.name;
  const precision p = bits_for_digits(x.working_digits()) + 64;
  const ball unit_of_time = natural_time(x.what, p);
  constexpr std::array<const char*, 3> names{"greatest_axis", "middle_axis", "least_axis"};
  if (is_periodic(motion)) {
    const ball phase = x.number("montgomery_phase", "phase");
    const ball time = x.number("period", "natural_period") * unit_of_time;
    const std::size_t around = motion == regime::oscillating ? 0 : 2;
    const auto rate_of = [&](std::size_t axis) {
      const bool has_turn_more = motion == regime::oscillating ? axis == 0 : axis != 2;
      return ball((has_turn_more ? phase + 2 * pi(p) : phase) / time);
    };
    const ball wobble = rate_of(around);
    add(result, "wobble", wobble, per_time);
    add(result, "wobble_period", 2 * pi(p) / wobble, x.what.time_unit.name);
    for (std::size_t axis = 0; axis < names.size(); ++axis)
      add(result, names[axis], rate_of(axis), per_time);
    result.remarks.push_back(std::string("the wobble is the mean rate of the ") +
                             (around == 0 ? "greatest" : "least") +
                             " axis, around which the angular momentum goes; the others turn with "
                             "the body");
    return result;
  }
  // The body turns about the axis along J, at I_y/I_x = 1 - b, 1 or I_y/I_z = 1 + a in |J|/I_y. On
  // the separatrix the motion stays, but for a finite time, by the intermediate axis, where the
  // rate is 1.
  const std::size_t along = motion == regime::equilibrium_x   ? 0
                            : motion == regime::equilibrium_z ? 2
                                                              : 1;
  const exact_real natural = along == 0   ? 1 - x.rigid().b()
                             : along == 2 ? 1 + x.rigid().a()
                                          : exact_real(1);
  const ball rate = natural.at(p) / unit_of_time;
  for (std::size_t axis = 0; axis < names.size(); ++axis)
    if (axis != along) add(result, names[axis], rate, per_time);
  add(result, "turn_period", 2 * pi(p) / rate, x.what.time_unit.name);
  result.remarks.push_back(
      is_on_middle_axis(x)           ? std::string(middle_axis) + ": the rate of rotation"
      : motion == regime::separatrix ? "on the separatrix: the limit for long times"
                                     : to_text(motion) + ": the rate of rotation");
  return result;
}

effect_result montgomery_curve(const effect_context& x) {
  return curve(x, "phase", "the phase", [&](const rational& c) -> std::optional<certain_number> {
    if (!is_periodic(regime_of(x.rigid(), c))) return std::nullopt;  // infinite on the separatrix
    return montgomery_phase_to_digits(x.rigid(), c, x.digits());
  });
}

effect_result twist_curve(const effect_context& x) {
  return curve(x, "epsilon", "epsilon", [&](const rational& c) -> std::optional<certain_number> {
    return defect_to_digits(x.rigid(), c, x.digits());
  });
}

}  // namespace polhode::detail
