// The twist defect on the separatrix decreases in a.

#include <optional>

#include "checker/facts.hpp"
#include "constants.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_epsilon0_decreases(examination& e) {
  const body rigid = check_body_and_steps(e);
  const body other{2 * e.a(), e.b()};
  std::optional<range> first;
  std::optional<range> second;
  if (!e.is_missing(facts::enclosure_of_epsilon0)) {
    first = e.root_number("epsilon0", true, separatrix_equation(rigid));
  }
  if (!e.is_missing("an enclosure of epsilon0 for 2a")) {
    second = e.root_number("epsilon0 for 2a", true, separatrix_equation(other));
  }
  if (e.is_missing("the order of epsilon0 for a and 2a")) return;
  const place where = e.fact(
      "at the given b, by interval Newton: epsilon0 for 2a is below epsilon0 for the given a",
      enclosed);
  if (!first || !second) where.not_checkable("the certificate has no enclosures of both");
  if (second->lower >= first->upper) where.refute("it is not so of the two enclosures");
  if (second->upper >= first->lower) where.not_checkable("the two enclosures overlap");
}

}  // namespace

claim epsilon0_decreases_claim() {
  return {
      .name = "epsilon0_decreases",
      .reference = "lemma 5",
      .statement = "The twist defect on the separatrix, epsilon0(a, b), decreases as a increases.",
      .formula = "a < a'  =>  epsilon0(a', b) < epsilon0(a, b)",
      .method =
          "For all a > 0, 0 < b < 1: the integrand of F(0,u) decreases strictly in a, and F(0,u) "
          "decreases in u. At epsilon0(a) the integral for a' > a is below 2 pi, so its root is "
          "smaller. Computed: the polynomial steps.",
      .steps = {facts::integrand_decreases_in_a, facts::integrand_is_positive},
      .tier = by_kernel,
      .argument = {in_coq("DecreaseInA.lemma_5")},
      .check = check_epsilon0_decreases};
}

}  // namespace polhode::checker
