#include "polhode/scene/effects.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <tbb/parallel_for.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "scene/effect_context.hpp"

namespace polhode {
namespace {

using detail::effect_context;

struct effect {
  effect_description description;
  effect_result (*compute)(const effect_context&);
};

const std::vector<effect>& registry() {
  const effect_needs any{};
  const effect_needs distinct{.distinct = true};
  const effect_needs motion{.distinct = true, .motion = true};
  const effect_needs start{.distinct = true, .motion = true, .start = true};
  const effect_needs series{.start = true, .time = true};
  const effect_needs checked{.distinct = true, .motion = true, .start = true};
  static const std::vector<effect> effects{
      {{"planarity", "physical, planar or non-physical, with the margin", any, {}},
       detail::planarity},
      {{"inertial_defect", "the geometric constants I and J", any, {}}, detail::inertial_defect},
      {{"signature", "what the theorems say of this body, with witnesses", distinct, {}},
       detail::signature},
      {{"regime", "which kind of motion it is, with c", motion, {}}, detail::regime_effect},
      {{"period", "in which the angular momentum goes once around in the body", motion, {"regime"}},
       detail::period},
      {{"montgomery_phase",
        "unwrapped, with its dynamic and its geometric part",
        motion,
        {"regime", "period"}},
       detail::montgomery_phase_effect},
      {{"mean_precession",
        "the wobble, and the mean rates of the three axes about the angular momentum",
        motion,
        {"regime", "period", "montgomery_phase"}},
       detail::mean_precession},
      {{"sensitivity", "derivatives of the period and the phase", motion, {"regime"}},
       detail::sensitivity},
      {{"flips",
        "the times at which the intermediate axis turns over",
        start,
        {"regime", "period"}},
       detail::flips},
      {{"momentum", "angular momentum and velocity in the body, over time", series, {}},
       detail::momentum},
      {{"attitude", "the body's attitude in space, over time", series, {}}, detail::attitude},
      {{"audit", "energy, momentum and the phase's slope, each by two routes", checked, {"regime"}},
       detail::audit},
      {{"montgomery_curve", "the phase over c", distinct, {}}, detail::montgomery_curve},
      {{"twist_curve", "the defect epsilon over c", distinct, {}}, detail::twist_curve},
      {{"tennis_racket", "epsilon0, the perfect twist, and the defect at c", distinct, {}},
       detail::tennis_racket},
      {{"intersections", "where the curve C meets S and crosses pi/2", distinct, {}},
       detail::intersections},
      {{"full_turn", "the motion of a Montgomery phase of 2 pi while rotating", distinct, {}},
       detail::full_turn},
  };
  return effects;
}

const effect& effect_named(const std::string& name) {
  return *std::find_if(registry().begin(), registry().end(),
                       [&](const effect& one) { return one.description.name == name; });
}

void visit(const std::string& name, std::vector<std::string>& order, std::set<std::string>& seen) {
  if (!seen.insert(name).second) return;
  for (const std::string& before : effect_named(name).description.after) visit(before, order, seen);
  order.push_back(name);
}

/// A number that is wider than the digits asked for is not certified.
void check_digits(effect_result& result, long digits) {
  for (const effect_number& n : result.numbers) {
    if (n.exact || n.is_range || result.verdict != status::certified) continue;
    if (!n.enclosure.is_bounded()) {
      detail::not_certified(result, n.name + " was not enclosed");
      continue;
    }
    const decimal_enclosure d = to_decimal_enclosure(n.enclosure, digits);
    if (d.has(digits)) continue;
    detail::not_certified(result, n.name + " has " + std::to_string(d.digits) + " certain digits");
  }
}

/// Mathematics that ends without a proof is a verdict; everything else is an error.
effect_result computed(const effect& one, const effect_context& context) {
  effect_result result;
  try {
    result = one.compute(context);
    result.name = one.description.name;
    detail::add_ranges(result, context);
  } catch (const std::domain_error& error) {
    detail::not_certified(result, error.what());
  }
  result.name = one.description.name;
  check_digits(result, context.digits());
  return result;
}

}  // namespace

const std::vector<effect_description>& all_effects() {
  static const std::vector<effect_description> descriptions = [] {
    std::vector<effect_description> result;
    result.reserve(registry().size());
    for (const effect& one : registry()) result.push_back(one.description);
    return result;
  }();
  return descriptions;
}

const effect_description* find_effect(const std::string& name) {
  const auto& all = all_effects();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const effect_description& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> closure_of(const std::vector<std::string>& want) {
  std::vector<std::string> order;
  std::set<std::string> seen;
  for (const std::string& name : want) visit(name, order, seen);
  return order;
}

const ball* effect_result::number(const std::string& wanted) const {
  for (const effect_number& one : numbers) {
    if (one.name == wanted) return &one.enclosure;
  }
  return nullptr;
}

const effect_result* scene_report::find(const std::string& name) const {
  for (const effect_result& one : effects) {
    if (one.name == name) return &one;
  }
  return nullptr;
}

scene_report compute(const scene& what) {
  const std::vector<std::string> order = closure_of(what.want);
  std::map<std::string, std::size_t> place;
  // An effect's level is above those of the effects that it takes; a level's effects do not need
  // each other.
  std::vector<std::vector<std::size_t>> levels;
  std::vector<std::size_t> level(order.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    for (const std::string& before : effect_named(order[i]).description.after) {
      level[i] = std::max(level[i], level[place.at(before)] + 1);
    }
    levels.resize(std::max(levels.size(), level[i] + 1));
    levels[level[i]].push_back(i);
  }
  scene_report report;
  report.wanted = what.want;
  report.effects.resize(order.size());
  for (const std::vector<std::size_t>& here : levels) {
    tbb::parallel_for(std::size_t{0}, here.size(), [&](std::size_t k) {
      const effect& one = effect_named(order[here[k]]);
      effect_context context{what, {}};
      for (const std::string& before : one.description.after)
        context.before[before] = &report.effects[place.at(before)];
      report.effects[here[k]] = computed(one, context);
    });
  }
  for (const effect_result& one : report.effects) {
    if (one.verdict != status::certified) report.verdict = status::not_certified;
  }
  return report;
}

// ---------------------------------------------------------------------------------------------

namespace detail {

const ball& effect_context::number(const std::string& effect, const std::string& name) const {
  const ball* found = before.at(effect)->number(name);
  if (!found) throw std::domain_error(name + " was not certified");
  return *found;
}

ball natural_time(const scene& what, precision p) {
  if (what.time_kind == scene::time_scale::natural) return ball(1, p);
  const exact_real& y = what.body.moments()[1];
  const pi_scale unit = what.body.size / what.state->momentum_size / what.time_unit.size;
  return unit.at(p) * sqrt((y * y / what.state->start->squared_momentum()).at(p));
}

void add(effect_result& to, const std::string& name, const ball& value, const std::string& unit) {
  to.numbers.push_back({name, value, {}, unit});
}
void add_exact(effect_result& to, const std::string& name, const rational& value,
               const std::string& unit) {
  to.numbers.push_back({name, {}, value, unit});
}
void add(effect_result& to, const std::string& name, const exact_real& value, long digits,
         const std::string& unit) {
  if (value.is_rational()) return add_exact(to, name, value.exact(), unit);
  add(to, name, value.at(bits_for_digits(digits) + 32), unit);
}
void add(effect_result& to, const std::string& name, const certain_number& value,
         const std::string& unit) {
  to.work += value.work;
  if (value.verdict == status::certified) {
    add(to, name, value.enclosure, unit);
  } else {
    not_certified(to, name + " was not certified (" + to_text(value.why) + ")");
  }
}
void not_certified(effect_result& to, const std::string& why) {
  to.verdict = status::not_certified;
  to.why += (to.why.empty() ? "" : "; ") + why;
}

}  // namespace detail
}  // namespace polhode
