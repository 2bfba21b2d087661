#include "constants.hpp"

#include "answers.hpp"
#include "checker/elliptic.hpp"
#include "checker/functions.hpp"

namespace polhode::checker {

interval epsilon0_min(precision bits) { return atan(exp(-pi(bits))).scaled(1); }

interval delta_psi_max(precision bits) { return pi(bits) - epsilon0_min(bits).scaled(1); }

interval mean_equation(const rational& x, precision bits) {
  const mean_and_sum s = agm_with_sum(sqrt(exactly(rational(1 + x), bits)), sqrt(exactly(x, bits)));
  return s.mean.scaled(1) - exactly(1, bits);
}

std::function<interval(const rational& x, precision bits)> separatrix_equation(const body& rigid) {
  return [rigid](const rational& epsilon, precision bits) {
    // The root is below pi/2: beyond, the sign is that on its upper side.
    if (is_below(pi(bits) / 2, exactly(epsilon, bits))) return exactly(-1, bits);
    if (epsilon <= 0 || !is_below(exactly(epsilon, bits), pi(bits) / 2)) {
      throw undecided("it is not known to be between 0 and pi/2");
    }
    const sine_and_cosine at = sin_cos(exactly(epsilon, bits));
    return separatrix_phase(rigid.a, rigid.b, square(at.sine), square(at.cosine)) -
           pi(bits).scaled(1);
  };
}

}  // namespace polhode::checker
