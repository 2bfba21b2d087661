// delta_psi_max, by its formula.

#include "statements/delta_psi_max.hpp"
#include "checker/examination.hpp"
#include "constants.hpp"
#include "list.hpp"

namespace polhode::checker {
namespace {

void check_delta_psi_max(examination& e) {
  e.read_no_inputs();
  e.number("delta_psi_max", delta_psi_max);
  // The second route's enclosure holds the same number, so that the two overlap.
  e.fact(statements::second_route_overlaps, true, enclosed);
  examination::decimals(e.witness("second_route"), delta_psi_max);
}

}  // namespace

claim delta_psi_max_claim() { return {statements::delta_psi_max(), check_delta_psi_max}; }

}  // namespace polhode::checker
