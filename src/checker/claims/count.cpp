// How often C and S intersect.

#include "statements/count.hpp"
#include "brackets.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_count(examination& e) {
  const body rigid = check_body_and_steps(e);
  check_I(e);
  const integer count = rigid.intersections();
  e.witness("N").expect_text(count.str());
  const auto q = [](const integer& k) { return rational(integer(2), 2 * k - 1); };
  e.fact(statements::fill(statements::number_of_meetings, {counted(count)}),
         (count == 0 || rigid.is_above_I(q(count))) && !rigid.is_above_I(q(count + 1)));
  check_values_of_half_phase(
      e, count, [&](int k) { return q(integer(k)); }, "intersections");
}

}  // namespace

claim count_claim() { return {statements::count(), check_count}; }

}  // namespace polhode::checker
