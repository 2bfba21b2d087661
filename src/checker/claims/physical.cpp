// Which bodies are physical.

#include "statements/physical.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_physical(examination& e) {
  const body rigid = check_body_and_steps(e);
  check_I(e);
  const rational excess(1 + 1 / (1 + e.a()) - 1 / (1 - e.b()));
  const rational above(rigid.squared_I() - 1);
  const auto sign = [](const rational& q) { return q > 0 ? 1 : q < 0 ? -1 : 0; };
  e.fact(statements::fill(statements::kind_of_body,
                          {excess.str(), above.str(), rigid.kind_in_words()}),
         sign(excess) == sign(above) && sign(excess) == rigid.kind());
}

}  // namespace

claim physical_claim() { return {statements::physical(), check_physical}; }

}  // namespace polhode::checker
