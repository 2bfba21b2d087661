// The limit a -> infinity for one b: the paper's section 7. The argument:
// proofs/arguments/large_a.md.

#include "statements/large_a.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_large_a(const request&) {
  certificate c;
  add_steps(c, statements::large_a().steps);
  c.conclude();
  return c;
}

}  // namespace

claim large_a_claim() { return {statements::large_a(), prove_large_a}; }

}  // namespace polhode::proofs
