#include "proofs/periodic_witness.hpp"

#include "polhode/arithmetic/text.hpp"
#include "statements/shared.hpp"

namespace polhode::proofs {

void add_periodic_plan(json& witness, const periodic_plan& plan) {
  constexpr long supremum_digits = 10;
  constexpr long error_digits = 5;
  witness["rule"] = statements::periodic_rule;
  if (plan.nodes == 0) return;
  witness["nodes"] = plan.nodes;
  // The bounds hold for every half-width in the ball, so for its least.
  witness["half_width"] = to_text(lower_rational(plan.strip.half_width));
  witness["supremum"] = to_decimal_enclosure(plan.strip.supremum, supremum_digits).upper;
  witness["truncation_error"] = to_decimal_enclosure(plan.truncation_error, error_digits).upper;
}

}  // namespace polhode::proofs
