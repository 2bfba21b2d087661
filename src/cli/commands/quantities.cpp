#include "quantities.hpp"

#include <fmt/format.h>

#include "cli/options/motion_option.hpp"
#include "cli/output/errors.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"

namespace polhode::cli {
namespace {

void check_phase(const body& rigid, const rational& c) { refuse_equilibrium(rigid, c, "phase"); }

certain_number exactly(const integer& n) {
  return {status::certified, reason::none, ball(rational(n), 64)};
}

}  // namespace

const std::vector<quantity>& all_quantities() {
  static const std::vector<quantity> quantities{
      {"phase", "Montgomery phase, unwrapped", true, montgomery_phase_to_digits, check_phase, true},
      {"epsilon", "defect epsilon(c) of the tennis racket effect", true,
       [](const body& rigid, const rational& c, long digits) {
         const twist t = twist_to_digits(rigid, c, digits, with_slope::no);
         return certain_number{t.verdict, t.why, t.epsilon};
       },
       [](const body& rigid, const rational& c) { refuse_equilibrium(rigid, c, "epsilon(c)"); }},
      {"epsilon0", "defect on the separatrix", false,
       [](const body& rigid, const rational&, long digits) {
         return separatrix_defect_to_digits(rigid, digits);
       },
       [](const body&, const rational&) {}},
      {"c0", "motion of the perfect twist", false,
       [](const body& rigid, const rational&, long digits) {
         return perfect_twist_to_digits(rigid, digits);
       },
       [](const body& rigid, const rational&) {
         if (has_perfect_twist(rigid)) return;
         throw usage_error(
             fmt::format("a = {}, b = {}: there is no perfect twist and no c0, since J >= 2",
                         to_text(rigid.a()), to_text(rigid.b())));
       }},
      {"meetings", "motions in which the curves C and S meet", false,
       [](const body& rigid, const rational&, long) { return exactly(meeting_count(rigid)); },
       [](const body&, const rational&) {}},
      {"physical", "1 for a body that masses can have, else 0", false,
       [](const body& rigid, const rational&, long) {
         return exactly(rigid.kind() == body_kind::non_physical ? 0 : 1);
       },
       [](const body&, const rational&) {}}};
  return quantities;
}

}  // namespace polhode::cli
