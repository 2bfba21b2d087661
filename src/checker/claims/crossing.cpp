// Where epsilon(c) is pi/2.

#include "statements/crossing.hpp"
#include "brackets.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_crossing(examination& e) {
  const body rigid = check_body_and_steps(e);
  check_I(e);
  const integer count = rigid.crossings();
  e.witness("crossings_count").expect_text(count.str());
  e.fact(statements::fill(statements::number_of_crossings, {counted(count), rigid.kind_in_words()}),
         (count == 0 || rigid.is_above_I(rational(integer(1), count))) &&
             !rigid.is_above_I(rational(integer(1), count + 1)) &&
             (count > 0) == (rigid.kind() < 0));
  check_values_of_half_phase(
      e, count, [](int k) { return rational(1, k); }, "crossings");
}

}  // namespace

claim crossing_claim() { return {statements::crossing(), check_crossing}; }

}  // namespace polhode::checker
