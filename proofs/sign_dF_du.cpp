// The sign of dF(-bu,u)/du: the paper's lemma in appendix A, on which both theorems rest.

#include "statements/sign_dF_du.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/derivative_identity.hpp"
#include "proofs/periodic_witness.hpp"
#include "proofs/slope_sweep.hpp"

namespace polhode::proofs {
namespace {

/// dG/du by AGM with the digits that are asked for, or as many as 4 raises of the precision give.
ball slope_to_digits(const oscillating_motion& motion, long digits) {
  ball x;
  precision p = bits_for_digits(digits) + 64;
  for (int i = 0; i < 4; ++i, p *= 2) {
    x = half_phase_slope(motion, p);
    if (x.is_bounded() && to_decimal_enclosure(x, digits).digits >= digits) break;
  }
  return x;
}

void add_value(certificate& c, const request& wanted) {
  constexpr long most_quadrature_digits = 1000;
  constexpr long most_nodes = 200'000;
  const oscillating_motion& motion = wanted.motion;
  (void)requested_body(c, wanted);
  c.inputs.emplace_back("u", motion.u);
  const ball value = slope_to_digits(motion, wanted.digits);
  c.numbers.push_back({"dF_du", value, wanted.digits});
  c.facts.push_back(
      {statements::slope_is_negative, certainly_negative(value), step_kind::enclosed});

  // The quadrature's goal is absolute; the size of the value turns it into digits.
  const long digits = std::min(wanted.digits, most_quadrature_digits);
  const auto size = value.is_bounded() ? value.magnitude_upper().log2_floor() : 0;
  long bits = bits_for_digits(digits) + 8 - static_cast<long>(size);
  trapezoid_options options;
  options.most_nodes = most_nodes;
  periodic_integral q = integrate_periodic(half_phase_slope_integrand(motion), bits, options);
  // A little more where an end of the enclosure is on the other side of a digit's.
  constexpr int most_attempts = 8;
  for (int i = 0; i < most_attempts && q.verdict == status::certified &&
                  to_decimal_enclosure(q.enclosure, digits).digits < digits;
       ++i) {
    bits += 32;
    q = integrate_periodic(half_phase_slope_integrand(motion), bits, options);
  }
  json& witness = c.witness["quadrature"];
  witness = json{{"verdict", to_text(q.verdict)}};
  add_periodic_plan(witness, q.plan);
  // (A strip exists for every u > 0; one narrower than the search goes is of no use either.)
  if (q.why == reason::evaluation_limit || q.why == reason::not_analytic) {
    witness["note"] = statements::fill(statements::too_near_0, {std::to_string(most_nodes)});
    return;
  }
  witness["value"] = to_json(q.enclosure, digits);
  c.facts.push_back({statements::fill(statements::slope_by_quadrature, {std::to_string(digits)}),
                     q.verdict == status::certified && overlaps(q.enclosure, value) &&
                         certainly_negative(q.enclosure),
                     step_kind::enclosed});
}

void add_sign_for_all(certificate& c, const oscillating_motion& motion) {
  const identity_check identity = check_derivative_identity();
  c.facts.push_back({identity.statement, identity.holds, step_kind::exact});
  c.witness["identity"] = json{{"points", identity.points}, {"degrees", identity.degrees}};
  c.facts.push_back({statements::factors_are_positive, identity.holds && numerator_is_positive(),
                     step_kind::exact});

  const sweep_result sweep = sweep_slope();
  c.facts.push_back(
      {statements::fill(statements::sweep_of_all_parameters, {std::to_string(sweep.boxes)}),
       sweep.holds, step_kind::enclosed});
  const precision p = 64;
  const ball integral = slope_enclosure(point_of(motion, p));
  const ball factor = -ball(motion.u, p) * sqrt((motion.b * (motion.a + motion.b)).at(p));
  c.facts.push_back({statements::sweep_holds_value,
                     integral.is_bounded() && overlaps(integral, factor * c.numbers[0].enclosure),
                     step_kind::enclosed});
  json boxes = json::array();
  for (const sweep_box& box : sweep.covering) {
    json sides = json::array();
    for (std::size_t i = 0; i < box.low.size(); ++i) {
      sides.push_back({to_text(box.low[i]), to_text(box.high[i])});
    }
    boxes.push_back(std::move(sides));
  }
  c.witness["sweep"] = json{{"bound", to_text(sweep.bound)}, {"boxes", std::move(boxes)}};
}

certificate prove_sign(const request& wanted) {
  check(wanted.motion);
  certificate c;
  add_value(c, wanted);
  add_sign_for_all(c, wanted.motion);
  c.conclude();
  return c;
}

}  // namespace

claim sign_dF_du_claim() { return {statements::sign_dF_du(), prove_sign}; }

}  // namespace polhode::proofs
