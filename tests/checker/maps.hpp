#pragma once

// A certificate of a map, for the tests: made here and not by the program.

#include <string>
#include <utility>
#include <vector>

#include "formulas.hpp"
#include "statements/map.hpp"

namespace polhode::test {

/// Of `intersections` and `physical` over 1 <= a <= 4, 1/10 <= b <= 1/2 in six cells. The first is
/// 0 for q <= 1/4, 1 up to 9/4 and 2 up to 25/4, with q = 1/I^2 = b (a+b)/(1-b)^2.
inline json map_json() {
  const std::vector<const statements::mapped_quantity*> chosen{
      statements::find_mapped("intersections"), statements::find_mapped("physical")};
  certificate c;
  c.claim = statements::map_claim;
  c.statement = statements::fill(statements::map_statement, {"1", "4", "1/10", "1/2"});
  c.formula = statements::map_formula(chosen);
  c.method = statements::map_method;
  c.tier = proof_tier::with_words;
  for (const statements::stated_text& s : statements::map_grounds(chosen)) {
    c.argument.push_back(
        {s.kind == statements::proved_in_coq ? step_kind::kernel : step_kind::argued,
         std::string(s.statement)});
  }
  const auto undecided = [&](const char* name, const char* cells, const char* percent) {
    c.facts.push_back({statements::fill(statements::map_fact, {name, cells, "6", percent, ""}),
                       true, step_kind::enclosed});
  };
  undecided("intersections", "4", "79.17");  // 0.1 + 0.25 + 0.4 + 0.2 of 1.2
  undecided("physical", "3", "70.84");       // 0.25 + 0.2 + 0.4
  const json cells =
      json::parse(R"([["? 1"], ["b 1/4", "1 1", "? ?"], ["1 ?"], ["b 2/5", "? ?", "? 0"]])");
  c.witness = json{{"a", {"1", "2", "4"}}, {"b", {"1/10", "1/5", "1/2"}}, {"cells", cells}};
  c.conclude();
  return to_json(c, {{"quantities", "intersections physical"},
                     {"a_from", "1"},
                     {"a_to", "4"},
                     {"b_from", "1/10"},
                     {"b_to", "1/2"},
                     {"scale", "linear"}});
}

}  // namespace polhode::test
