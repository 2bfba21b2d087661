// epsilon0_min = pi - 2 arctan(e^pi).

#include "proofs/epsilon0_min.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/mpfr_functions.hpp"
#include "polhode/arithmetic/text.hpp"
#include "proofs/claims.hpp"
#include "statements/epsilon0_min.hpp"

namespace polhode::proofs {
namespace {

/// The two routes' enclosures of epsilon0_min and the facts that tie them.
certificate prove_epsilon0_min(const request& wanted) {
  certificate c;
  const ball x = enclose_to_digits(*find_constant("epsilon0_min"), wanted.digits);
  const root_enclosure other = epsilon0_min_by_logarithm(x.precision());
  c.numbers.push_back({"epsilon0_min", x, wanted.digits});
  c.facts.push_back({statements::root_of_log_tan,
                     other.verdict == root_verdict::unique && overlaps(other.root, x),
                     step_kind::enclosed});
  c.witness["second_route"] = to_json(other.root, wanted.digits);
  c.conclude();
  return c;
}

}  // namespace

root_enclosure epsilon0_min_by_logarithm(precision p) {
  const detail::only_mpfr_functions mpfr_functions;
  const ball box = hull(ball(rational(86, 1000), 64), ball(rational(87, 1000), 64));
  const auto f = [](const ball& x) { return log(tan(x / 2)) + pi(x.precision()); };
  const auto derivative = [](const ball& x) { return 1 / sin(x); };
  return refine_root(f, derivative, box, p);
}

claim epsilon0_min_claim() { return {statements::epsilon0_min(), prove_epsilon0_min}; }

}  // namespace polhode::proofs
