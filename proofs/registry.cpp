#include "polhode/arithmetic/exact.hpp"
#include "proofs/claims.hpp"

namespace polhode::proofs {
namespace {

/// In a cell of a table a | would end the cell.
std::string as_cell(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c;
  }
  return result + " | ";
}

std::string command_of(const claim& c) {
  std::string result = "`polhode certify " + c.name;
  if (c.subject != claim_subject::none) result += " --ab 12.65,0.0629";
  if (c.subject == claim_subject::motion) result += " --u 1/4";
  return result + '`';
}

}  // namespace

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
                            large_a_claim(),
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
        result.tier = c.tier;
        result.argument = c.argument;
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

std::string table_heading() {
  return "| claim | paper | statement | method | command | time | verdict |\n"
         "|---|---|---|---|---|---|---|\n";
}

std::string table_row(const claim& c) {
  return "| `" + c.name + "` | " + as_cell(c.reference) + as_cell(c.statement) + as_cell(c.method) +
         command_of(c) + " |";
}

}  // namespace polhode::proofs
