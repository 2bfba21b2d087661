#include "proofs/turning_points.hpp"

#include "polhode/arithmetic/elementary.hpp"
#include "statements/shared.hpp"

namespace polhode::proofs {

std::string counted(const integer& count) {
  if (count == 0) return "no k >= 1";
  return (count == 1 ? "k = 1" : "k = 1 ... " + count.str()) + " and no other k >= 1";
}

std::string multiple_of_pi(const rational& q) {
  std::string result = q == 1 ? "pi" : numerator(q) == 1 ? "pi" : numerator(q).str() + " pi";
  if (denominator(q) != 1) result += "/" + denominator(q).str();
  return result;
}

void add_brackets(certificate& c, const body& rigid, const integer& count,
                  const std::function<rational(int k)>& q, const std::string& key,
                  const std::function<void(int k, const root_bracket& u)>& follow) {
  constexpr int most_brackets = 6;
  const int shown = count < most_brackets ? static_cast<int>(count) : most_brackets;
  for (int k = 1; k <= shown; ++k) {
    const auto bracket = bracket_half_phase_root(rigid, q(k));
    json& witness = c.witness[key];
    if (!bracket) {
      witness.push_back(nullptr);
      note_missing_witness(
          c, statements::fill(statements::bracket_of_half_phase, {multiple_of_pi(q(k))}));
      continue;
    }
    c.facts.push_back({statements::fill(statements::half_phase_passes,
                                        {multiple_of_pi(q(k)), in_decimals(*bracket)}),
                       passes_half_phase(rigid, q(k), *bracket), step_kind::enclosed});
    witness.push_back(as_json(*bracket));
    if (follow) follow(k, *bracket);
  }
}

void add_absence(certificate& c, const body& rigid, const rational& q) {
  c.facts.push_back(
      {statements::fill(statements::half_phase_stays_above, {to_text(q), multiple_of_pi(q)}),
       !exceeds_geometric_constant(q, rigid) && is_decided([&](precision p) {
         return certainly_less(pi(p) * q, half_phase(rigid, rational(1, 2), p));
       }),
       step_kind::enclosed});
}

}  // namespace polhode::proofs
