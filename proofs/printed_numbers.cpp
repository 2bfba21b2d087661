// The numbers that the paper prints and that are right.

#include "proofs/claims.hpp"
#include "proofs/printed_values.hpp"

namespace polhode::proofs {
namespace {

certificate prove_printed_numbers(const request& wanted) {
  certificate c;
  c.formula = "|printed - value| <= half a unit of the last place printed";
  c.method =
      "Each number is enclosed from its formula in ball arithmetic (beta by interval Newton), and "
      "compared with the printed decimal as an exact rational. Those that are wrong are in the "
      "claim "
      "errata.";
  add_printed_numbers(c, right_numbers(), rounding::right, wanted.digits);
  c.conclude();
  return c;
}

}  // namespace

claim printed_numbers_claim() {
  return {"figs. 6, 7, eqs. (39), (40), section 8",
          "The numbers in the captions, in section 7 and in the conclusion are those of their "
          "formulas, to the last digit printed, but for those in errata.",
          "enclosures against the printed decimals",
          prove_printed_numbers,
          proof_tier::by_machine,
          {gauss_mean(), gudermannian()}};
}

}  // namespace polhode::proofs
