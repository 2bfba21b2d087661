#include "quantities.hpp"

#include <fmt/format.h>

#include "cli/options/motion_option.hpp"
#include "cli/output/errors.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"

namespace polhode::cli {
namespace {

void check_phase(const body& rigid, const rational& c) { refuse_equilibrium(rigid, c, "phase"); }

certain_number exactly(const integer& n) {
  certain_number result;
  result.enclosure = ball(rational(n), 64);
  result.verdict = status::certified;
  return result;
}

/// The range of an integer that grows with a and b.
template <integer (*of)(const body&)>
std::optional<ball> range_of_integer(const body_box& box, const rational_range&, long) {
  return hull(exactly(of(box.least())).enclosure, exactly(of(box.greatest())).enclosure);
}

template <integer (*of)(const body&)>
certain_number integer_of(const body& rigid, const rational&, long) {
  return exactly(of(rigid));
}

integer is_non_physical(const body& rigid) {
  return rigid.kind() == body_kind::non_physical ? 1 : 0;
}

void check_nothing(const body&, const rational&) {}

}  // namespace

const std::vector<quantity>& all_quantities() {
  static const std::vector<quantity> quantities{
      {.name = "phase",
       .description = "Montgomery phase, unwrapped",
       .unit = "rad",
       .of_motion = true,
       .compute = montgomery_phase_to_digits,
       .check = check_phase,
       .range =
           [](const body_box& box, const rational_range& c, long digits) {
             return std::optional(box.montgomery_phase(c, bits_for_digits(digits) + 32));
           },
       .infinite_at_0 = true,
       .microseconds = 25},
      {.name = "epsilon",
       .description = "defect epsilon(c) of the tennis racket effect",
       .unit = "rad",
       .of_motion = true,
       .compute = defect_to_digits,
       .check = [](const body& rigid,
                   const rational& c) { refuse_equilibrium(rigid, c, "epsilon(c)"); },
       .range = [](const body_box& box, const rational_range& c,
                   long digits) { return std::optional(box.twist(c, digits)); },
       .microseconds = 180},
      {.name = "epsilon0",
       .description = "defect on the separatrix",
       .unit = "rad",
       .of_motion = false,
       .compute = [](const body& rigid, const rational&,
                     long digits) { return separatrix_defect_to_digits(rigid, digits); },
       .check = check_nothing,
       .range = [](const body_box& box, const rational_range&,
                   long digits) { return std::optional(box.separatrix_defect(digits)); },
       .microseconds = 30},
      {.name = "c0",
       .description = "motion of the perfect twist",
       .unit = "1",
       .of_motion = false,
       .compute = [](const body& rigid, const rational&,
                     long digits) { return perfect_twist_to_digits(rigid, digits); },
       .check =
           [](const body& rigid, const rational&) {
             if (has_perfect_twist(rigid)) return;
             throw usage_error(
                 fmt::format("a = {}, b = {}: there is no perfect twist and no c0, since J >= 2",
                             to_text(rigid.a()), to_text(rigid.b())));
           },
       .range = [](const body_box& box, const rational_range&, long digits) -> std::optional<ball> {
         if (box.has_perfect_twist() == false) return std::nullopt;
         return box.perfect_twist(digits);
       },
       .microseconds = 200},
      {.name = "intersections",
       .description = "how often the curves C and S meet",
       .unit = "1",
       .of_motion = false,
       .compute = integer_of<intersection_count>,
       .check = check_nothing,
       .range = range_of_integer<intersection_count>,
       .is_whole = true,
       .microseconds = 5},
      {.name = "meetings",
       .description = "how often the curve C meets S or crosses pi/2",
       .unit = "1",
       .of_motion = false,
       .compute = integer_of<meeting_count>,
       .check = check_nothing,
       .range = range_of_integer<meeting_count>,
       .is_whole = true,
       .microseconds = 5},
      {.name = "physical",
       .description = "1 for a body that masses can have, else 0",
       .unit = "1",
       .of_motion = false,
       .compute = [](const body& rigid, const rational&,
                     long) { return exactly(1 - is_non_physical(rigid)); },
       .check = check_nothing,
       .range = [](const body_box& box, const rational_range&, long) -> std::optional<ball> {
         return hull(exactly(1 - is_non_physical(box.least())).enclosure,
                     exactly(1 - is_non_physical(box.greatest())).enclosure);
       },
       .is_whole = true,
       .microseconds = 4}};
  return quantities;
}

}  // namespace polhode::cli
