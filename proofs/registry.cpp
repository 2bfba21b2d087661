#include "polhode/arithmetic/exact.hpp"
#include "proofs/claims.hpp"

namespace polhode::proofs {

const std::vector<claim>& all_claims() {
  static const std::vector<claim> claims = [] {
    std::vector<claim> list{physical_claim(),
                            montgomery_oscillating_claim(),
                            montgomery_rotating_claim(),
                            first_equation_claim(),
                            separatrix_twist_claim(),
                            perfect_twist_claim(),
                            intersection_claim(),
                            crossing_claim(),
                            injectivity_claim(),
                            count_claim(),
                            c0_decreases_claim(),
                            epsilon0_decreases_claim(),
                            limit_formula_claim(),
                            limit_minimum_claim(),
                            epsilon0_min_claim(),
                            delta_psi_max_claim(),
                            beta_claim(),
                            sign_dF_du_claim(),
                            half_phase_limits_claim(),
                            implicit_equations_claim(),
                            printed_numbers_claim(),
                            errata_claim()};
    // What a claim is called and where it stands is written once, here and in its certificate.
    for (claim& c : list) {
      c.prove = [c](const request& wanted) {
        if (wanted.digits < 1) {
          throw input_error(std::to_string(wanted.digits) + " digits: it must be at least 1");
        }
        certificate result = c.prove(wanted);
        result.claim = c.name;
        result.statement = c.statement;
        result.reference = c.reference;
        return result;
      };
    }
    return list;
  }();
  return claims;
}

const claim* find_claim(const std::string& name) {
  for (const claim& c : all_claims()) {
    if (c.name == name) return &c;
  }
  return nullptr;
}

}  // namespace polhode::proofs
