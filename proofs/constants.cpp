#include <cmath>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "proofs/beta.hpp"
#include "proofs/claim.hpp"
#include "proofs/epsilon0_min.hpp"

namespace polhode::proofs {
namespace {

ball epsilon0_min(precision p) { return pi(p) - 2 * atan(exp(pi(p))); }

/// pi - 2 epsilon0_min = 4 arctan(e^pi) - pi.
ball delta_psi_max(precision p) { return 4 * atan(exp(pi(p))) - pi(p); }

/// What the root is where it is proved to be the only one in its box. Without existence, what is
/// left of the box encloses nothing.
ball only_root(const root_enclosure& root, precision p) {
  return root.verdict == root_verdict::unique ? root.root : ball::undefined(p);
}

/// pi - 2 epsilon0_min, with epsilon0_min from log and tan.
ball delta_psi_max_by_logarithm(precision p) {
  return pi(p) - 2 * only_root(epsilon0_min_by_logarithm(p), p);
}

/// The root of R_F(0, x, 1+x) = pi in [0.0289, 0.029], by interval Newton.
///
/// With I(x) the integral over (0, pi/2) of (x + cos^2 t)^(-1/2), K(1/(1+x)) = sqrt(1+x) I(x), so
/// that the equation of beta reads I(x) = pi; and K(1/(1+x)) = R_F(0, x/(1+x), 1) (DLMF 19.25.1),
/// which is sqrt(1+x) R_F(0, x, 1+x), as R_F is homogeneous of degree -1/2. I decreases strictly,
/// so that there is no other root.
ball beta_by_carlson(precision p) {
  const auto f = [](const ball& x) {
    return carlson_rf(ball(0, x.precision()), x, 1 + x) - pi(x.precision());
  };
  // d/dx of R_F(0, x, 1+x) is -(R_D(0, 1+x, x) + R_D(0, x, 1+x))/6 (DLMF 19.18.1).
  const auto derivative = [](const ball& x) {
    const ball zero(0, x.precision());
    return -(carlson_rd(zero, 1 + x, x) + carlson_rd(zero, x, 1 + x)) / 6;
  };
  const ball box = hull(ball(rational(289, 10000), 64), ball(rational(290, 10000), 64));
  return only_root(refine_root(f, derivative, box, p), p);
}

}  // namespace

const std::vector<constant>& all_constants() {
  static const std::vector<constant> constants{
      {"epsilon0_min",
       "minimum value of the defect epsilon0 on the separatrix, pi - 2 arctan(e^pi)", epsilon0_min,
       100, "interval Newton on log(tan(x/2)) = -pi",
       [](precision p) { return only_root(epsilon0_min_by_logarithm(p), p); }},
      {"delta_psi_max",
       "best quasi-perfect twist, Delta psi on the separatrix, pi - 2 epsilon0_min", delta_psi_max,
       100, "pi - 2 x by interval Newton on log(tan(x/2)) = -pi", delta_psi_max_by_logarithm},
      {"beta", "root of K(1/(1+beta)) = pi sqrt(1+beta), i.e. agm(sqrt(1+beta), sqrt(beta)) = 1/2",
       [](precision p) { return only_root(enclose_beta(p), p); }, 36,
       "interval Newton on Carlson's R_F(0, x, 1+x) = pi", beta_by_carlson},
  };
  return constants;
}

const constant* find_constant(const std::string& name) {
  for (const constant& c : all_constants()) {
    if (c.name == name) return &c;
  }
  return nullptr;
}

ball enclose_to_digits(const constant& c, long digits) {
  // Certain digits are missing only by bad luck (a run of 0s or 9s) once the radius is small
  // enough.
  return polhode::enclose_to_digits(c.enclose, digits, 15 * bits_for_digits(digits) + 1024);
}

double estimated_memory(const constant& c, long digits) {
  constexpr double bytes_per_digit = 0.4153;  // log2(10) / 8
  return bytes_per_digit * static_cast<double>(digits) * c.live_numbers;
}

}  // namespace polhode::proofs
