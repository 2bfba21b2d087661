// Whether C and S intersect.

#include "statements/intersection.hpp"
#include "brackets.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_intersection(examination& e) {
  const body rigid = check_body_and_steps(e);
  check_I(e);
  const bool meets = rigid.is_above_I(2);
  e.fact(statements::fill(statements::meets_or_not,
                          {(meets ? "<" : ">="), (meets ? "positive" : "not positive")}),
         meets == (4 * e.a() * e.b() + 3 * e.b() * e.b() + 2 * e.b() > 1));
  check_values_of_half_phase(
      e, meets ? 1 : 0, [](int) { return rational(2); }, "intersection");
}

}  // namespace

claim intersection_claim() { return {statements::intersection(), check_intersection}; }

}  // namespace polhode::checker
