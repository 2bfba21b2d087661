// The numbers that the paper prints and that are right.

#include "statements/printed_numbers.hpp"
#include "proofs/claims.hpp"
#include "proofs/printed_values.hpp"

namespace polhode::proofs {
namespace {

certificate prove_printed_numbers(const request& wanted) {
  certificate c;
  add_printed_numbers(c, right_numbers(), rounding::right, wanted.digits);
  c.conclude();
  return c;
}

}  // namespace

claim printed_numbers_claim() { return {statements::printed_numbers(), prove_printed_numbers}; }

}  // namespace polhode::proofs
