// Where a perfect twist occurs.

#include "statements/perfect_twist.hpp"
#include "brackets.hpp"
#include "checker/elliptic.hpp"
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
  e.fact(statements::fill(statements::root_exists_or_not, {std::string(exists ? "< " : ">= "),
                                                           q.str(), (exists ? "a " : "no "), what}),
         exists == (polynomial > 0));
  if (!exists) {
    e.fact(statements::fill(statements::rotating_phase_stays_above, {q.str()}),
           [&](precision bits) {
             const interval value = pi(bits) * exactly(q, bits);
             return all_of({below(value, rotating_phase(a, e.b(), rational(a / 2), bits)),
                            below(value, rotating_phase(a, e.b(), rational(3 * a / 4), bits))});
           });
    return;
  }
  const place where = e.witness(key);
  if (where.value().is_null()) {
    if (!e.is_missing(statements::fill(statements::bracket_of_root, {what})))
      where.malformed("it must be a bracket");
    return;
  }
  const range s = examination::bracket(where);
  e.fact(statements::fill(statements::rotating_phase_passes, {target, in_decimals(s, e.work())}),
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

claim perfect_twist_claim() { return {statements::perfect_twist(), check_perfect_twist}; }

}  // namespace polhode::checker
