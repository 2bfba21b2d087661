#include <cmath>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "proofs/beta.hpp"
#include "proofs/claim.hpp"

namespace polhode::proofs {
namespace {

ball epsilon0_min(precision p) { return pi(p) - 2 * atan(exp(pi(p))); }

/// pi - 2 epsilon0_min = 4 arctan(e^pi) - pi.
ball delta_psi_max(precision p) { return 4 * atan(exp(pi(p))) - pi(p); }

}  // namespace

const std::vector<constant>& all_constants() {
  static const std::vector<constant> constants{
      {"epsilon0_min",
       "minimum value of the defect epsilon0 on the separatrix, pi - 2 arctan(e^pi)", epsilon0_min,
       100},
      {"delta_psi_max",
       "best quasi-perfect twist, Delta psi on the separatrix, pi - 2 epsilon0_min", delta_psi_max,
       100},
      {"beta", "root of K(1/(1+beta)) = pi sqrt(1+beta), i.e. agm(sqrt(1+beta), sqrt(beta)) = 1/2",
       [](precision p) {
         const root_enclosure root = enclose_beta(p);
         // Without existence, what is left of the box encloses nothing.
         return root.verdict == root_verdict::unique ? root.root : ball::undefined(p);
       },
       36},
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
  // Certain digits are missing only by bad luck (a run of 0s or 9s) once the radius is small enough.
  return polhode::enclose_to_digits(c.enclose, digits, 15 * bits_for_digits(digits) + 1024);
}

double estimated_memory(const constant& c, long digits) {
  constexpr double bytes_per_digit = 0.4153;  // log2(10) / 8
  return bytes_per_digit * static_cast<double>(digits) * c.live_numbers;
}

}  // namespace polhode::proofs
