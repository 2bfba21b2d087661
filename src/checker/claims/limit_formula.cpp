// The limit of epsilon as a grows and b tends to 0.

#include "statements/limit_formula.hpp"
#include "answers.hpp"
#include "checker/elliptic.hpp"
#include "checker/functions.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_limit_formula(examination& e) {
  check_steps_only(e);
  e.fact(statements::mean_at_epsilon0_min, [half = rational(1, 2)](precision bits) {
    const interval one = exactly(1, bits);
    const interval cosine = (exp(pi(bits)) + exp(-pi(bits))) / 2;
    return below(agm_with_sum(one, one / cosine).mean, exactly(half, bits));
  });
}

}  // namespace

claim limit_formula_claim() { return {statements::limit_formula(), check_limit_formula}; }

}  // namespace polhode::checker
