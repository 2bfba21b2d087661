#pragma once

// The text of a map's certificate: which values counts and kinds have on cells of the plane of
// bodies. Its statement follows from its inputs.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "statements/claim_text.hpp"

namespace polhode::statements {

/// A quantity that is decided in rationals, as `polhode map` names it.
struct mapped_quantity {
  std::string_view name;
  std::string_view formula;
  std::array<std::string_view, 2> theorems;  // of proofs/coq
};

inline constexpr std::array mapped_quantities{
    mapped_quantity{"intersections",
                    "intersections = ceil(1/I + 1/2) - 1, how often C and S meet",
                    {"Curve.theorem_4_sharp", ""}},
    mapped_quantity{"meetings",
                    "meetings = ceil(2/I) - 1, how often C meets S or crosses pi/2",
                    {"Curve.theorem_4_sharp", "Curve.lemma_3_sharp"}},
    mapped_quantity{"physical",
                    "physical = 1 where ab + 2b <= 1, and there alone epsilon(c) is injective",
                    {"Prop1.proposition_1", "Theorem3.theorem_3"}}};

[[nodiscard]] inline const mapped_quantity* find_mapped(std::string_view name) {
  for (const mapped_quantity& q : mapped_quantities) {
    if (q.name == name) return &q;
  }
  return nullptr;
}

inline constexpr std::string_view map_claim = "map";
inline constexpr std::string_view map_statement =
    "The cells cover all bodies with {} <= a <= {} and {} <= b <= {}. Each quantity has for every "
    "body of a cell the value of that cell, where the cell has one.";
inline constexpr std::string_view map_method =
    "A cell has the value that both of these bodies have: the one with the least a and b, and the "
    "one with the greatest. Both are decided in rationals.";
inline constexpr stated_text map_is_monotone = argued(
    "1/I^2 = b(a+b)/(1-b)^2 and ab + 2b increase in a and in b: every body of a cell has "
    "them between their values at two corners, and so each quantity.");

/// The sentence of a quantity, with the cells that it is not decided on, all cells, and the share
/// of the area in percent.
inline constexpr std::string_view map_fact =
    "{} is decided on all but {} of {} cells, which are at most {} % of the area{}";
inline constexpr std::string_view in_logarithms = " in log a and log b";
inline constexpr std::string_view linear_scale = "linear";
inline constexpr std::string_view logarithmic_scale = "logarithmic";
/// Of a quantity on a cell with two values of it.
inline constexpr std::string_view undecided_on_cell = "?";

/// What a map of these quantities is made of, and what it rests on.
[[nodiscard]] inline std::string map_formula(const std::vector<const mapped_quantity*>& chosen) {
  std::string result = "I = (1-b)/sqrt(b(a+b))";
  for (const mapped_quantity* q : chosen) result.append("; ").append(q->formula);
  return result;
}
[[nodiscard]] inline std::vector<stated_text> map_grounds(
    const std::vector<const mapped_quantity*>& chosen) {
  std::vector<stated_text> result;
  for (const mapped_quantity* q : chosen) {
    for (const std::string_view theorem : q->theorems) {
      bool is_new = !theorem.empty();
      for (const stated_text& s : result) is_new = is_new && s.statement != theorem;
      if (is_new) result.push_back(in_coq(theorem));
    }
  }
  result.push_back(map_is_monotone);
  return result;
}

}  // namespace polhode::statements
