// What is not right as printed, beside what is.

#include <array>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"
#include "proofs/half_phase.hpp"
#include "proofs/printed_values.hpp"
#include "proofs/rotating_phase.hpp"
#include "proofs/separatrix.hpp"
#include "statements/errata.hpp"

namespace polhode::proofs {
namespace {

bool phase_increases_in_c(const body& rigid) {
  return is_decided([&](precision p) {
    return certainly_less(montgomery_phase(rigid, -rigid.b() * rational(3, 4), p),
                          montgomery_phase(rigid, -rigid.b() / 4, p));
  });
}

void add_words(certificate& c) {
  const rational water_a = water_at_equilibrium().a().exact();
  c.facts.push_back(
      {statements::fill(statements::a_above_1, {to_decimal(ball(water_a, 64), 8)}),
       water_a > 0 && water_a < 1 && water_at_equilibrium().kind() == body_kind::physical,
       step_kind::exact});
  c.facts.push_back({statements::phase_is_said_to_decrease,
                     phase_increases_in_c(with_ab("12.65", "0.0629")), step_kind::enclosed});
  const body rigid = with_ab("12.65", "0.0629");
  const auto c0 = bracket_rotating_phase_root(rigid, 2);
  c.facts.push_back(
      {statements::fill(statements::range_of_c0, {c0 ? in_decimals(*c0) : std::string("?")}),
       c0 && c0->lower > 0 && passes_rotating_phase(rigid, 2, *c0), step_kind::enclosed});
  const body planar = with_ab("1", "1/3");
  c.facts.push_back({statements::planar_body,
                     planar.exact_geometric_constant() == rational(1) &&
                         planar.kind() == body_kind::planar && count_crossings(planar) == 0,
                     step_kind::exact});
  const body once = with_ab("18.27", "0.0629");
  c.facts.push_back({statements::one_meeting,
                     once.kind() == body_kind::non_physical && count_intersections(once) == 1,
                     step_kind::exact});
  const body twice = with_ab("39.95", "0.0629");
  c.facts.push_back({statements::exactly_n_plus_1,
                     exceeds_geometric_constant(rational(2, 3), twice) &&
                         !exceeds_geometric_constant(rational(2, 5), twice) &&
                         count_intersections(twice) == 2,
                     step_kind::exact});
  const body at_two = with_ab("77/40", "1/10");
  c.facts.push_back(
      {statements::no_meeting_at_2,
       at_two.exact_geometric_constant() == rational(2) && count_intersections(at_two) == 0,
       step_kind::exact});
}

/// Where G(u) passes 2 pi for a = 12.65, b = 0.0629.
root_bracket meeting_point() {
  return {parse_rational("0.053943792"), parse_rational("0.053943793")};
}

void add_curve(certificate& c) {
  const body rigid = with_ab("12.65", "0.0629");
  const root_bracket u = meeting_point();
  c.facts.push_back({statements::many_epsilon_for_one_c,
                     passes_half_phase(rigid, 2, u) && is_decided([&](precision p) {
                       const ball sine = sin(ball(rational(2, 5), p));
                       return certainly_less(ball(u.upper, p), sine * sine);
                     }),
                     step_kind::enclosed});
  c.facts.push_back({statements::period_is_said_to_decrease, is_decided([&](precision p) {
                       return certainly_less(montgomery_phase(rigid, -rigid.b() / 2, p),
                                             montgomery_phase(rigid, -rigid.b() / 8, p));
                     }),
                     step_kind::enclosed});
  const body first = with_ab("2", "1/4");
  const body second = with_ab("4", "1/100");
  c.facts.push_back({statements::epsilon0_across_b,
                     first.kind() != body_kind::non_physical &&
                         second.kind() != body_kind::non_physical && is_decided([&](precision p) {
                           const ball half(rational(1, 2), p);
                           return certainly_less(separatrix_defect(first, p), half) &&
                                  certainly_less(half, separatrix_defect(second, p));
                         }),
                     step_kind::enclosed});
  add_steps(c, statements::errata().steps);
}

certificate prove_errata(const request& wanted) {
  certificate c;
  add_printed_numbers(c, wrong_numbers(), rounding::wrong, wanted.digits);
  // What figure 7 meant.
  constexpr int places = 3;
  const std::array<std::array<const char*, 3>, 4> meant{{{"12.65", "1.045", "wrong"},
                                                         {"13.89", "1", "right"},
                                                         {"15.38", "0.951", "right"},
                                                         {"18.27", "0.872", "wrong"}}};
  for (const auto& [a, printed, verdict] : meant) {
    const ball value = with_ab(a, "0.0629").geometric_constant(64);
    const bool right = std::string(verdict) == "right";
    c.facts.push_back(
        {statements::fill(statements::meant_by_figure_7,
                          {as_read(printed, places), a, verdict, to_decimal(value, 8)}),
         check_rounding(printed, places, value) == (right ? rounding::right : rounding::wrong),
         step_kind::enclosed});
  }
  add_words(c);
  add_curve(c);
  c.conclude();
  return c;
}

}  // namespace

claim errata_claim() { return {statements::errata(), prove_errata}; }

}  // namespace polhode::proofs
