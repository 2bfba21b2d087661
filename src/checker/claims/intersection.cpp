// Whether C and S intersect.

#include "statements/intersection.hpp"
#include "brackets.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

/// Whether 4ab + 3b^2 + 2b - 1 > 0: it is b (a + b)(4 - I^2), which decides where I^2 is known
/// without a and b.
bool has_positive_excess(const body& rigid) {
  const auto known = rigid.of ? rigid.of->squared_I() : std::nullopt;
  if (known) return *known < 4;
  return 4 * rigid.a * rigid.b + 3 * rigid.b * rigid.b + 2 * rigid.b > 1;
}

void check_intersection(examination& e) {
  const body rigid = check_body_and_steps(e);
  check_I(e);
  const bool meets = rigid.is_above_I(2);
  e.fact(statements::fill(statements::meets_or_not,
                          {(meets ? "<" : ">="), (meets ? "positive" : "not positive")}),
         meets == has_positive_excess(rigid));
  check_values_of_half_phase(
      e, meets ? 1 : 0, [](int) { return rational(2); }, "intersection");
}

}  // namespace

claim intersection_claim() { return {statements::intersection(), check_intersection}; }

}  // namespace polhode::checker
