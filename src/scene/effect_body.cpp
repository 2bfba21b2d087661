// Effects of the body alone.

#include <algorithm>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "scene/effect_context.hpp"

namespace polhode::detail {
namespace {

std::string yes_or_no(bool holds) { return holds ? "yes" : "no"; }

void add_constant(effect_result& to, const std::string& name, const std::optional<rational>& exact,
                  const enclosing_function& f, const effect_context& x) {
  if (exact) return add_exact(to, name, *exact);
  const scene_body& of = x.what.body;
  const precision sizes = of.tensor ? of.tensor->lost_bits()
                                    : size_in_bits(of.rigid->a()) + size_in_bits(of.rigid->b());
  add(to, name,
      enclose_to_digits(f, x.working_digits(),
                        8 * sizes + 15 * bits_for_digits(x.working_digits()) + 1024));
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
  if (of.margin) {
    if (!of.has_unit) {
      add_exact(result, "margin", *of.margin);
    } else if (of.size.power == 0) {
      add_exact(result, "margin", *of.margin * of.size.factor, "kg m^2");
    } else {
      const precision p = bits_for_digits(x.working_digits()) + 64;
      add(result, "margin", of.size.at(p) * *of.margin, "kg m^2");
    }
    add_exact(result, "relative_margin", *of.margin / (*of.moments)[0]);
    result.remarks.emplace_back("margin = I_y + I_z - I_x" +
                                std::string(of.has_unit ? "" : ", in the unit of the moments") +
                                ", negative where the triangle inequality is violated");
  }
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
  if (of.tensor) {
    const inertia_tensor& tensor = *of.tensor;
    const auto one_if_planar =
        of.kind == body_kind::planar ? std::optional<rational>(1) : std::nullopt;
    add_constant(
        result, "a", {}, [&](precision p) { return tensor.a(p); }, x);
    add_constant(
        result, "b", {}, [&](precision p) { return tensor.b(p); }, x);
    add_constant(
        result, "I", one_if_planar, [&](precision p) { return tensor.geometric_constant(p); }, x);
    add_constant(
        result, "J", {}, [&](precision p) { return tensor.second_geometric_constant(p); }, x);
    return result;
  }
  if (!of.rigid) {
    result.remarks.emplace_back(
        "two moments are equal, a symmetric top: there is no intermediate axis, and a or b is 0");
    return result;
  }
  const body& rigid = *of.rigid;
  add_exact(result, "a", rigid.a().exact());
  add_exact(result, "b", rigid.b().exact());
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
    const bool meets = m % 2 != 0;
    const std::string which = (meets ? "intersection_" : "crossing_") + integer((m + 1) / 2).str();
    add(result, which + "_c", one.c);
    if (meets) add(result, which + "_epsilon", one.epsilon, "rad");
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
  const twist t = twist_to_digits(rigid, x.c(), x.digits());
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

/// The theorems on physical bodies: propositions on I and on the injectivity of epsilon(c), and the bound of the Montgomery phase.
effect_result signature(const effect_context& x) {
  effect_result result;
  const body& rigid = x.rigid();
  const rational& b = rigid.b().exact();
  const rational excess(1 - 2 * b - rigid.a().exact() * b);
  const bool physical = excess >= 0;
  result.words = {
      {"physical", yes_or_no(physical)},
      {"phase_of_oscillations_above_2_pi", yes_or_no(physical)},
      {"epsilon_injective", yes_or_no(is_injective(rigid))},
      {"perfect_twist", yes_or_no(has_perfect_twist(rigid))},
      {"full_turn", yes_or_no(has_full_turn(rigid))},
  };
  // The witnesses: the sign of 1 - 2b - ab is that of I - 1; 2 pi I bounds the phase from below, and is approached.
  add_exact(result, "one_minus_2b_minus_ab", excess);
  const certain_number bound = montgomery_phase_limit_to_digits(rigid, rational(-b), x.digits());
  add(result, "greatest_lower_bound_of_phase", bound, "rad");
  add_exact(result, "intersections", rational(intersection_count(rigid)));
  result.remarks.emplace_back(
      physical ? "all five follow from I >= 1, I_y + I_z >= I_x, and the signs of 2 - J and 1 - J"
               : "I < 1, I_y + I_z < I_x: no mass distribution has these moments");
  return result;
}

}  // namespace polhode::detail
