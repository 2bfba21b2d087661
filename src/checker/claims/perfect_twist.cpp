// Where a perfect twist occurs.

#include "statements/perfect_twist.hpp"
#include "brackets.hpp"
#include "checker/elliptic.hpp"
#include "checker/functions.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

/// Whether (q+1)^2 a (a+b) - (a+1)^2 > 0: it is a (a + b)((q+1)^2 - (J+1)^2), which decides where
/// (J+1)^2 is known without a and b.
bool has_positive_excess(const body& rigid, const real& polynomial, const rational& q) {
  const auto known = rigid.of ? rigid.of->squared_J_plus_1() : std::nullopt;
  return known ? *known < (q + 1) * (q + 1) : polynomial.sign() > 0;
}

void check_rotating_root(examination& e, const rational& q, const real& polynomial,
                         const std::string& what, const std::string& key) {
  const body rigid = body_of(e);
  const real& a = rigid.a;
  const bool exists = rigid.is_above_J(q);
  const std::string target = q == 1 ? "pi" : q.str() + " pi";
  e.fact(statements::fill(statements::root_exists_or_not, {std::string(exists ? "< " : ">= "),
                                                           q.str(), (exists ? "a " : "no "), what}),
         exists == has_positive_excess(rigid, polynomial, q));
  if (!exists) {
    e.fact(statements::fill(statements::rotating_phase_stays_above, {q.str()}),
           [&](precision bits) {
             const interval value = pi(bits) * exactly(q, bits);
             return all_of({below(value, rotating_phase(a, rigid.b, a / 2, bits)),
                            below(value, rotating_phase(a, rigid.b, 3 * a / 4, bits))});
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
  const body rigid = check_body_and_steps(e);
  check_J(e);
  const real& a = rigid.a;
  const real ab = a * rigid.b;
  check_rotating_root(e, 2, 8 * a * a + 9 * ab - 2 * a - 1, "perfect twist", "c0_over_a");
  check_rotating_root(e, 1, 3 * a * a + 4 * ab - 2 * a - 1, "full turn", "full_turn_c_over_a");
}

}  // namespace

claim perfect_twist_claim() { return {statements::perfect_twist(), check_perfect_twist}; }

}  // namespace polhode::checker
