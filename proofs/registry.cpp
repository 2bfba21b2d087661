#include <stdexcept>
#include <utility>

#include "polhode/arithmetic/exact.hpp"
#include "proofs/claims.hpp"

namespace polhode::proofs {
namespace {

/// In a cell of a table a | would end the cell.
std::string as_cell(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c;
  }
  return result + " | ";
}

std::string command_of(const claim& c) {
  std::string result = "`polhode certify " + std::string(c.name);
  if (c.subject != claim_subject::none) result += " --ab 12.65,0.0629";
  if (c.subject == claim_subject::motion) result += " --u 1/4";
  return result + '`';
}

proof_tier tier_named(std::string_view text) {
  for (const proof_tier t :
       {proof_tier::by_kernel, proof_tier::by_machine, proof_tier::with_words}) {
    if (to_text(t) == text) return t;
  }
  throw std::logic_error("no tier of proofs is called " + std::string(text));
}

step_kind kind_named(std::string_view text) {
  for (const step_kind k : {step_kind::kernel, step_kind::argued, step_kind::cited}) {
    if (to_text(k) == text) return k;
  }
  throw std::logic_error("no kind of steps is called " + std::string(text));
}

}  // namespace

const std::vector<claim>& all_claims() {
  static const std::vector<claim> claims = [] {
    std::vector<claim> list;
    const auto add = [&list](claim_subject subject, claim c) {
      c.subject = subject;
      list.push_back(std::move(c));
    };
#define POLHODE_ADD(name, subject) add(claim_subject::subject, name##_claim());
    POLHODE_CLAIMS(POLHODE_ADD)
#undef POLHODE_ADD
    // What a claim says is written once: a proof adds notes on the given body to the method.
    for (claim& c : list) {
      c.prove = [c](const request& wanted) {
        if (wanted.digits < 1) {
          throw input_error(std::to_string(wanted.digits) + " digits: it must be at least 1");
        }
        certificate result = c.prove(wanted);
        result.claim = c.name;
        result.statement = c.statement;
        result.reference = c.reference;
        result.formula = c.formula;
        result.method.insert(0, c.method);
        result.tier = tier_named(c.tier);
        for (const auto& [kind, statement] : c.argument) {
          result.argument.push_back({kind_named(kind), std::string(statement)});
        }
        return result;
      };
    }
    return list;
  }();
  return claims;
}

const claim* find_claim(std::string_view name) {
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
  return "| `" + std::string(c.name) + "` | " + as_cell(c.reference) + as_cell(c.statement) +
         as_cell(c.technique) + command_of(c) + " |";
}

}  // namespace polhode::proofs
