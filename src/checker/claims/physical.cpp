// Which bodies are physical.

#include "statements/physical.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

/// "15703/2558283", or "0.0104...".
std::string in_words(const real& x, budget& work) {
  constexpr long digits = 12;
  return x.is_rational() ? x.exact().str() : decimal_for_reading(x, digits, work);
}

void check_physical(examination& e) {
  const body rigid = check_body_and_steps(e);
  check_I(e);
  const real above = rigid.squared_I() - 1;
  // Of a planar body by its tensor it is 0, which irrational a and b do not say.
  const real excess = rigid.of && rigid.kind() == 0 ? 0 : 1 + 1 / (1 + rigid.a) - 1 / (1 - rigid.b);
  e.fact(statements::fill(
             statements::kind_of_body,
             {in_words(excess, e.work()), in_words(above, e.work()), rigid.kind_in_words()}),
         excess.sign() == above.sign() && excess.sign() == rigid.kind());
}

}  // namespace

claim physical_claim() { return {statements::physical(), check_physical}; }

}  // namespace polhode::checker
