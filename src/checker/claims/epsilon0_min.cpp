// epsilon0_min, by its formula and as a root.

#include "statements/epsilon0_min.hpp"
#include "answers.hpp"
#include "checker/examination.hpp"
#include "checker/functions.hpp"
#include "constants.hpp"
#include "list.hpp"

namespace polhode::checker {
namespace {

void check_epsilon0_min(examination& e) {
  e.read_no_inputs();
  e.number("epsilon0_min", epsilon0_min);
  e.fact(statements::root_of_log_tan,
         // log(tan(x/2)) increases on (0, pi), so that the root is where the signs differ, and
         // tan(x/2) = e^-pi is the formula.
         [&](precision bits) {
           const auto value = [&](const rational& x) {
             const sine_and_cosine at = sin_cos(exactly(rational(x / 2), bits));
             return log(at.sine / at.cosine) + pi(bits);
           };
           const interval zero = exactly(0, bits);
           return all_of(
               {below(value(rational(86, 1000)), zero), below(zero, value(rational(87, 1000)))});
         });
  examination::decimals(e.witness("second_route"), epsilon0_min);
}

}  // namespace

claim epsilon0_min_claim() { return {statements::epsilon0_min(), check_epsilon0_min}; }

}  // namespace polhode::checker
