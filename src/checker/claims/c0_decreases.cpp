// The perfect twist decreases in a.

#include "statements/c0_decreases.hpp"
#include "brackets.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_c0_decreases(examination& e) {
  const body rigid = check_body_and_steps(e);
  const body other{2 * rigid.a, rigid.b};
  if (!rigid.is_above_J(2)) {
    e.add_to_method(statements::there_is_no_c0);
    return;
  }
  if (e.is_missing(statements::bracket_of_c0)) return;
  const range first = examination::bracket(e.witness("c0_over_a"));
  const range second = examination::bracket(e.witness("c0_over_a_for_2a"));
  e.fact(statements::fill(statements::smaller_c0_for_double_a, {in_decimals(first, e.work())}),
         [&](precision bits) {
           return all_of({passes_rotating_phase(rigid, 2, first, bits + size_of(first)),
                          passes_rotating_phase(other, 2, second, bits + size_of(second)),
                          tri(other.a * second.upper < rigid.a * first.lower)});
         });
}

}  // namespace

claim c0_decreases_claim() { return {statements::c0_decreases(), check_c0_decreases}; }

}  // namespace polhode::checker
