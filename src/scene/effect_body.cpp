// Effects of the body alone.

#include <algorithm>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "scene/effect_context.hpp"

namespace polhode::detail {
namespace {

/// Of I_x. Less is what rounding leaves where a body is flat.
const rational smallest_margin(1, 1'000'000'000);

std::string yes_or_no(bool holds) { return holds ? "yes" : "no"; }

void add_constant(effect_result& to, const std::string& name, const std::optional<rational>& exact,
                  const enclosing_function& f, const effect_context& x) {
  if (exact) return add_exact(to, name, *exact);
  const precision sizes = size_in_bits(x.rigid().a()) + size_in_bits(x.rigid().b());
  add(to, name,
      enclose_to_digits(f, x.working_digits(), 8 * sizes + ample_guard(x.working_digits())));
}

}  // namespace

effect_result planarity(const effect_context& x) {
  const scene_body& of = x.what.body;
  effect_result result;
  result.words = {{"kind", to_text(of.kind)}};
  if (of.kind == body_kind::undecided) {
    not_certified(result,
                  "undecided: within the uncertainties there are physical bodies and others");
    return result;
  }
  if (of.ranges) return result;
  const exact_real margin = of.axes->margin();
  if (!of.has_unit) {
    add(result, "margin", margin, x.working_digits());
  } else if (of.size.power == 0) {
    add(result, "margin", margin * of.size.factor, x.working_digits(), "kg m^2");
  } else {
    const precision p = bits_for_digits(x.working_digits()) + 64;
    add(result, "margin", of.size.at(p) * margin, "kg m^2");
  }
  add(result, "relative_margin", margin / of.moments()[0], x.working_digits());
  if (of.kind != body_kind::planar &&
      certainly_less(abs((margin / of.moments()[0]).at(64)), ball(smallest_margin, 64))) {
    result.remarks.push_back("planar but for " +
                             to_decimal(result.numbers.front().exact
                                            ? ball(*result.numbers.front().exact, 64)
                                            : result.numbers.front().enclosure,
                                        3) +
                             (of.has_unit ? " kg m^2" : "") +
                             ", the size of a rounding error; the numbers are taken as written");
  }
  result.remarks.emplace_back("margin = I_y + I_z - I_x" +
                              std::string(of.has_unit ? "" : ", in the unit of the moments") +
                              ", negative where the triangle inequality is violated");
  return result;
}

effect_result inertial_defect(const effect_context& x) {
  const scene_body& of = x.what.body;
  effect_result result;
  if (of.ranges) {
    if (!of.ranges->is_ordered()) {
      not_certified(
          result,
          "the order of the axes is undecided within the uncertainties, and so are the constants");
      return result;
    }
    const precision p = bits_for_digits(x.working_digits()) + 32;
    result.numbers = {{"I", of.ranges->geometric_constant(p), {}, "", true},
                      {"J", of.ranges->second_geometric_constant(p), {}, "", true}};
    return result;
  }
  if (!of.axes->rigid()) {
    result.remarks.emplace_back(
        "two moments are equal, a symmetric top: there is no intermediate axis, and a or b is 0");
    return result;
  }
  const body& rigid = x.rigid();
  add(result, "a", rigid.a(), x.working_digits());
  add(result, "b", rigid.b(), x.working_digits());
  add_constant(
      result, "I", rigid.exact_geometric_constant(),
      [&](precision p) { return rigid.geometric_constant(p); }, x);
  add_constant(
      result, "J", rigid.exact_second_geometric_constant(),
      [&](precision p) { return rigid.second_geometric_constant(p); }, x);
  return result;
}

effect_result full_turn(const effect_context& x) {
  effect_result result;
  result.words = {{"exists", yes_or_no(has_full_turn(x.rigid()))}};
  if (has_full_turn(x.rigid())) add(result, "c", full_turn_to_digits(x.rigid(), x.digits()));
  return result;
}

std::string meeting_name(const integer& m) {
  return (m % 2 != 0 ? "intersection_" : "crossing_") + integer((m + 1) / 2).str();
}

effect_result intersections(const effect_context& x) {
  effect_result result;
  const body& rigid = x.rigid();
  add_exact(result, "count", rational(intersection_count(rigid)));
  add_exact(result, "crossings", rational(crossing_count(rigid)));
  const integer all = meeting_count(rigid);
  const integer listed = std::min(all, integer(x.what.listed));
  for (integer m = 1; m <= listed; ++m) {
    const meeting one = meeting_to_digits(rigid, m, x.digits());
    result.work += one.work;
    if (one.verdict != status::certified) {
      not_certified(result, "the c with G(u) = 2 pi/" + m.str() + " was not certified (" +
                                to_text(one.why) + ")");
      return result;
    }
    const std::string which = meeting_name(m);
    add(result, which + "_c", one.c);
    if (m % 2 != 0) add(result, which + "_epsilon", one.epsilon, "rad");
  }
  if (listed < all)
    result.remarks.push_back("and " + integer(all - listed).str() +
                             " more, not listed (listed = " + std::to_string(x.what.listed) + ")");
  return result;
}

effect_result tennis_racket(const effect_context& x) {
  effect_result result;
  const body& rigid = x.rigid();
  result.words = {{"injective", yes_or_no(is_injective(rigid))},
                  {"perfect_twist", yes_or_no(has_perfect_twist(rigid))}};
  add(result, "epsilon0", separatrix_defect_to_digits(rigid, x.digits()), "rad");
  if (has_perfect_twist(rigid)) add(result, "c0", perfect_twist_to_digits(rigid, x.digits()));
  if (!x.has_motion()) return result;
  const regime motion = x.regime();
  if (is_equilibrium(motion)) {
    result.remarks.emplace_back(
        to_text(motion) +
        ": the angular momentum does not move in the body, and there is no epsilon(c)");
    return result;
  }
  const twist t = twist_to_digits(rigid, x.motion(), x.digits());
  result.work += t.work;
  if (t.verdict != status::certified) {
    not_certified(result, "epsilon(c) was not certified (" + to_text(t.why) + ")");
    return result;
  }
  add(result, "epsilon", t.epsilon, "rad");
  add(result, "slope", t.slope, "rad");
  add_exact(result, "branch", rational(t.branch));
  return result;
}

/// The theorems on physical bodies: propositions on I and on the injectivity of epsilon(c), and the
/// bound of the Montgomery phase.
effect_result signature(const effect_context& x) {
  effect_result result;
  const body& rigid = x.rigid();
  const bool physical = rigid.kind() != body_kind::non_physical;
  const exact_real excess =
      rigid.kind() == body_kind::planar ? 0 : 1 - 2 * rigid.b() - rigid.a() * rigid.b();
  result.words = {
      {"physical", yes_or_no(physical)},
      {"phase_of_oscillations_above_2_pi", yes_or_no(physical)},
      {"epsilon_injective", yes_or_no(is_injective(rigid))},
      {"perfect_twist", yes_or_no(has_perfect_twist(rigid))},
      {"full_turn", yes_or_no(has_full_turn(rigid))},
  };
  // The witnesses: the sign of 1 - 2b - ab is that of I - 1; 2 pi I bounds the phase from below,
  // and is approached.
  add(result, "one_minus_2b_minus_ab", excess, x.working_digits());
  // Of any motion that oscillates: -b < c < 0.
  const certain_number bound = montgomery_phase_limit_to_digits(
      rigid, rational(-rational_below(rigid.b(), 32) / 2), x.digits());
  add(result, "greatest_lower_bound_of_phase", bound, "rad");
  add_exact(result, "intersections", rational(intersection_count(rigid)));
  result.remarks.emplace_back(
      physical ? "all five follow from I >= 1, I_y + I_z >= I_x, and the signs of 2 - J and 1 - J"
               : "I < 1, I_y + I_z < I_x: no mass distribution has these moments");
  return result;
}

}  // namespace polhode::detail
