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
    return certainly_less(montgomery_phase(rigid, rational(-rigid.b().exact() * 3 / 4), p),
                          montgomery_phase(rigid, rational(-rigid.b().exact() / 4), p));
  });
}

void add_words(certificate& c) {
  const rational water_a = water_at_equilibrium().a().exact();
  c.facts.push_back(
      {"section 2 says \"by definition, a > 1\": a > 0 is right; the water molecule of "
       "section 8 has a = " +
           to_decimal(ball(water_a, 64), 8) + " and I > 1",
       water_a > 0 && water_a < 1 && water_at_equilibrium().kind() == body_kind::physical,
       step_kind::exact});
  c.facts.push_back(
      {"section 1 says that the phase of oscillating motion is a decreasing function of c: it "
       "increases, for a = 12.65, b = 0.0629 from c = -3b/4 to -b/4 (for all bodies: the claim "
       "montgomery_oscillating)",
       phase_increases_in_c(with_ab("12.65", "0.0629")), step_kind::enclosed});
  const body rigid = with_ab("12.65", "0.0629");
  const auto c0 = bracket_rotating_phase_root(rigid, 2);
  c.facts.push_back(
      {"proposition 3 seeks c0 in (-b, a): it lies in (0, a), for a = 12.65, b = 0.0629 "
       "at c0/a between " +
           (c0 ? in_decimals(*c0) : std::string("?")),
       c0 && c0->lower > 0 && passes_rotating_phase(rigid, 2, *c0), step_kind::enclosed});
  const body planar = with_ab("1", "1/3");
  c.facts.push_back(
      {"section 8 says \"if and only if I > 1\": theorem 3 has I >= 1; the planar body a "
       "= 1, b = 1/3 has I = 1, is physical, and epsilon(c) never crosses pi/2",
       planar.exact_geometric_constant() == rational(1) && planar.kind() == body_kind::planar &&
           count_crossings(planar) == 0,
       step_kind::exact});
  const body once = with_ab("18.27", "0.0629");
  c.facts.push_back(
      {"section 6.2 says that for non-physical bodies C and S intersect several times: "
       "for 2/3 <= I < 1 exactly once, as for a = 18.27, b = 0.0629",
       once.kind() == body_kind::non_physical && count_intersections(once) == 1, step_kind::exact});
  const body twice = with_ab("39.95", "0.0629");
  c.facts.push_back(
      {"theorem 4 says at least n, and one more beyond the n-th, for I < 2/(2n+1): there are "
       "exactly n + 1 for 2/(2n+3) <= I < 2/(2n+1); for a = 39.95, b = 0.0629, where n = 1, there "
       "are 2",
       exceeds_geometric_constant(rational(2, 3), twice) &&
           !exceeds_geometric_constant(rational(2, 5), twice) && count_intersections(twice) == 2,
       step_kind::exact});
  const body at_two = with_ab("77/40", "1/10");
  c.facts.push_back(
      {"lemma 2 says that C and S intersect if and only if I <= 2: at I = 2 the point u "
       "= 1 is only a limit, as for a = 77/40, b = 1/10, where there is no intersection",
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
  c.facts.push_back(
      {"lemma 1 says that there is one epsilon for each c: at a = 12.65, b = 0.0629 G(u) passes 2 "
       "pi between u = 0.053943792 and 0.053943793, at c between -0.0033930646 and -0.0033930645, "
       "where C meets S; there psi(phi + 2 pi) = -psi(phi) on the whole orbit, so that each "
       "epsilon from epsilon* to pi - epsilon* belongs to this one c, such as 0.4, 0.9 and 1.4, as "
       "sin^2 0.4 > u",
       passes_half_phase(rigid, 2, u) && is_decided([&](precision p) {
         const ball sine = sin(ball(rational(2, 5), p));
         return certainly_less(ball(u.upper, p), sine * sine);
       }),
       step_kind::enclosed});
  c.facts.push_back(
      {"appendix B says that the period T_phi(c) is a decreasing function: by lemma 6 T_phi = 2 "
       "F(-bu,u) decreases in u = -c/b and so increases in c, for a = 12.65, b = 0.0629 from c = "
       "-b/2 to -b/8",
       is_decided([&](precision p) {
         return certainly_less(montgomery_phase(rigid, rational(-rigid.b().exact() / 2), p),
                               montgomery_phase(rigid, rational(-rigid.b().exact() / 8), p));
       }),
       step_kind::enclosed});
  const body first = with_ab("2", "1/4");
  const body second = with_ab("4", "1/100");
  c.facts.push_back(
      {"section 7 says that by lemma 5, which is for one b, epsilon0 is smallest as a -> infinity: "
       "for one b bodies are physical up to a = 1/b - 2 only, and between physical bodies of "
       "different b a greater a may have a greater epsilon0: for a = 2, b = 1/4 it is below 1/2, "
       "for a = 4, b = 1/100 above (what follows is so: the claim limit_minimum)",
       first.kind() != body_kind::non_physical && second.kind() != body_kind::non_physical &&
           is_decided([&](precision p) {
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
        {std::string("figure 7 with b = 0.0629 in place of 0.06: ") + as_read(printed, places) +
             " for a = " + a + " would be " + verdict + ", I = " + to_decimal(value, 8),
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
