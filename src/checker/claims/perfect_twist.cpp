// Where a perfect twist occurs.

#include "brackets.hpp"
#include "checker/elliptic.hpp"
#include "checker/facts.hpp"
#include "checker/functions.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_rotating_root(examination& e, const rational& q, const rational& polynomial,
                         const std::string& what, const std::string& key) {
  const body rigid = body_of(e);
  const rational& a = e.a();
  const bool exists = rigid.is_above_J(q);
  const std::string target = q == 1 ? "pi" : q.str() + " pi";
  e.fact("at the given a, b, in rationals: J " + std::string(exists ? "< " : ">= ") + q.str() +
             ", so there is " + (exists ? "a " : "no ") + what,
         exists == (polynomial > 0));
  if (!exists) {
    e.fact("at the given a, b, by the AGM: F(c,0) > " + q.str() + " pi at c = a/2 and 3a/4",
           [&](precision bits) {
             const interval value = pi(bits) * exactly(q, bits);
             return all_of({below(value, rotating_phase(a, e.b(), rational(a / 2), bits)),
                            below(value, rotating_phase(a, e.b(), rational(3 * a / 4), bits))});
           });
    return;
  }
  const place where = e.witness(key);
  if (where.value().is_null()) {
    if (!e.is_missing("a bracket of the " + what)) where.malformed("it must be a bracket");
    return;
  }
  const range s = examination::bracket(where);
  e.fact("at the given a, b, by the AGM: F(c,0) passes " + target +
             " between c/a = " + in_decimals(s, e.work()),
         [&](precision bits) { return passes_rotating_phase(rigid, q, s, bits + size_of(s)); });
}

void check_perfect_twist(examination& e) {
  e.read_body();
  e.steps();
  check_J(e);
  const rational& a = e.a();
  const rational ab(a * e.b());
  check_rotating_root(e, 2, rational(8 * a * a + 9 * ab - 2 * a - 1), "perfect twist", "c0_over_a");
  check_rotating_root(e, 1, rational(3 * a * a + 4 * ab - 2 * a - 1), "full turn",
                      "full_turn_c_over_a");
}

}  // namespace

claim perfect_twist_claim() {
  return {
      .name = "perfect_twist",
      .reference = "proposition 3, part 2",
      .statement =
          "A perfect twist, epsilon = 0, occurs if and only if J < 2, at exactly one c0, which "
          "lies in (0, a).",
      .formula = "F(c0,0) = 2 pi for some c0  <=>  J < 2; then c0 is in (0, a) and the only one",
      .method =
          "For all a > 0, 0 < b < 1, by the proof of montgomery_rotating: F(c,0) maps 0 < c < a "
          "one to one onto the values above pi J, and F(c,u) is defined at u = 0 for c > 0 only. "
          "So 2 pi is a value exactly where J < 2 (and the phase 2 F(c,0) has the value 2 pi, a "
          "full turn, exactly where J < 1). For a given body J < 2 is decided in rationals.",
      .steps = facts::with_more(
          facts::rotating_phase_steps,
          {identity("9*a*(a+b) - (a+1)^2", "8*a^2 + 9*a*b - 2*a - 1",
                    "J < 2 exactly where this is positive, as (J+1)^2 = (a+1)^2/(a(a+b))"),
           identity("4*a*(a+b) - (a+1)^2", "3*a^2 + 4*a*b - 2*a - 1",
                    "J < 1 exactly where this is positive")}),
      .tier = by_kernel,
      .argument = {in_coq("Separatrix.proposition_3_2"), in_coq("Theorems.rotating_phase_at"),
                   in_coq("Theorems.rotating_phase_decreases"), facts::bartky_transformation},
      .check = check_perfect_twist};
}

}  // namespace polhode::checker
