#pragma once

// What the effects are computed from.

#include <map>

#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "polhode/rigid_body/motion.hpp"
#include "polhode/scene/effects.hpp"

namespace polhode::detail {

struct effect_context {
  const scene& what;
  /// The results of the effects that this one comes after.
  std::map<std::string, const effect_result*> before;

  [[nodiscard]] const body& rigid() const { return *what.body.axes->rigid(); }
  [[nodiscard]] const polhode::motion& motion() const { return *what.state->motion; }
  [[nodiscard]] const exact_real& c() const { return motion().c(); }
  [[nodiscard]] polhode::regime regime() const { return motion().regime(); }
  [[nodiscard]] bool has_motion() const { return what.state && what.state->motion; }
  /// The scene's, with the rotor's start.
  [[nodiscard]] const initial_state& start() const { return *what.state->start; }
  [[nodiscard]] long digits() const { return what.digits; }
  /// Digits of what other effects compute with: they lose a few.
  [[nodiscard]] long working_digits() const { return what.digits + 15; }
  [[nodiscard]] const ball& number(const std::string& effect, const std::string& name) const;
};

/// (I_y/J) over the scene's unit of time, to about p bits.
[[nodiscard]] ball natural_time(const scene& what, precision p);

void add(effect_result& to, const std::string& name, const ball& value,
         const std::string& unit = "");
/// "intersection_2", "crossing_1": the m-th meeting, from m = 1 on.
[[nodiscard]] std::string meeting_name(const integer& m);
void add_exact(effect_result& to, const std::string& name, const rational& value,
               const std::string& unit = "");
/// As the rational number that it is, or to so many digits.
void add(effect_result& to, const std::string& name, const exact_real& value, long digits,
         const std::string& unit = "");
/// Makes the result not certified where this number is not; else adds it. Its work is counted in
/// either case.
void add(effect_result& to, const std::string& name, const certain_number& value,
         const std::string& unit = "");
void not_certified(effect_result& to, const std::string& why);

/// No number is computed with more guard bits than this for want of a decision: a motion that is
/// nearer than some 10^-9000 to another kind may be left not certified.
inline constexpr precision greatest_guard = 1L << 15;

/// Of a body with uncertainties: adds the ranges of a result's numbers over all bodies within them,
/// and what is said of all.
void add_ranges(effect_result& to, const effect_context& x);

// The effects, by their names.
[[nodiscard]] effect_result planarity(const effect_context& x);
[[nodiscard]] effect_result inertial_defect(const effect_context& x);
[[nodiscard]] effect_result regime_effect(const effect_context& x);
[[nodiscard]] effect_result period(const effect_context& x);
[[nodiscard]] effect_result montgomery_phase_effect(const effect_context& x);
[[nodiscard]] effect_result mean_precession(const effect_context& x);
[[nodiscard]] effect_result montgomery_curve(const effect_context& x);
[[nodiscard]] effect_result tennis_racket(const effect_context& x);
[[nodiscard]] effect_result full_turn(const effect_context& x);
[[nodiscard]] effect_result intersections(const effect_context& x);
[[nodiscard]] effect_result twist_curve(const effect_context& x);
[[nodiscard]] effect_result signature(const effect_context& x);
[[nodiscard]] effect_result momentum(const effect_context& x);
[[nodiscard]] effect_result attitude(const effect_context& x);
[[nodiscard]] effect_result flips(const effect_context& x);
[[nodiscard]] effect_result audit(const effect_context& x);
[[nodiscard]] effect_result sensitivity(const effect_context& x);

}  // namespace polhode::detail
