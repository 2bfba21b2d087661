// The twist defect on the separatrix decreases in a.

#include <optional>

#include "constants.hpp"
#include "list.hpp"
#include "shapes.hpp"
#include "statements/epsilon0_decreases.hpp"

namespace polhode::checker {
namespace {

void check_epsilon0_decreases(examination& e) {
  const body rigid = check_body_and_steps(e);
  const body other{2 * rigid.a, rigid.b};
  std::optional<range> first;
  std::optional<range> second;
  if (!e.is_missing(statements::fill(statements::enclosure_of, {"epsilon0"}))) {
    first = e.root_number("epsilon0", true, separatrix_equation(rigid));
  }
  if (!e.is_missing(statements::fill(statements::enclosure_of, {"epsilon0 for 2a"}))) {
    second = e.root_number("epsilon0 for 2a", true, separatrix_equation(other));
  }
  if (e.is_missing(statements::order_for_double_a)) return;
  const place where = e.fact(statements::smaller_for_double_a, enclosed);
  if (!first || !second) where.not_checkable("the certificate has no enclosures of both");
  if (second->lower >= first->upper) where.refute("it is not so of the two enclosures");
  if (second->upper >= first->lower) where.not_checkable("the two enclosures overlap");
}

}  // namespace

claim epsilon0_decreases_claim() {
  return {statements::epsilon0_decreases(), check_epsilon0_decreases};
}

}  // namespace polhode::checker
