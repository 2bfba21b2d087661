#include <utility>

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

stated_step bartky_transformation() {
  return {step_kind::cited,
          "Bartky's transformation of complete elliptic integrals (DLMF 19.8(i), 19.22(i))."};
}
stated_step gauss_mean() {
  return {step_kind::cited, "K and E by the arithmetic-geometric mean (Gauss; DLMF 19.8(i))."};
}
stated_step gudermannian() {
  return {step_kind::cited, "am(x | 1) is the Gudermannian, 2 arctan(e^x) - pi/2 (DLMF 22.16(i))."};
}

const std::vector<claim>& all_claims() {
  static const std::vector<claim> claims = [] {
    std::vector<claim> list;
    const auto add = [&list](const char* name, claim_subject subject, claim c) {
      c.name = name;
      c.subject = subject;
      list.push_back(std::move(c));
    };
#define POLHODE_ADD(name, subject) add(#name, claim_subject::subject, name##_claim());
    POLHODE_CLAIMS(POLHODE_ADD)
#undef POLHODE_ADD
    // What a claim is called and where it stands is written once, in its file and in claims.hpp.
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
