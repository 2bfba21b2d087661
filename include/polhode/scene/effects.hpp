#pragma once

// The effects that a scene may ask for. They form a graph: an effect may need the results of
// others. Of the wanted ones and all that they need each is computed once; those that do not need
// each other, in parallel.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "polhode/arithmetic/verdict.hpp"
#include "polhode/certificate/certificate.hpp"
#include "polhode/rigid_body/work.hpp"
#include "polhode/scene/scene.hpp"

namespace polhode {

/// What an effect needs of a scene.
struct effect_needs {
  bool distinct = false;  // three different moments
  bool motion = false;    // c
  bool start = false;     // the angular momentum in the body
  bool time = false;      // when
};

struct effect_description {
  std::string name;
  std::string summary;  // one line
  effect_needs needs;
  std::vector<std::string> after;  // the effects whose results it takes
};

/// In the order of the documentation.
[[nodiscard]] const std::vector<effect_description>& all_effects();
[[nodiscard]] const effect_description* find_effect(const std::string& name);

/// The wanted effects and all that they need, each once, every one after those that it needs.
[[nodiscard]] std::vector<std::string> closure_of(const std::vector<std::string>& want);

/// One number of a result: an enclosure, or an exact rational.
struct effect_number {
  std::string name;  // "period"
  ball enclosure;
  std::optional<rational> exact;
  std::string unit;       // "day", "rad", or empty
  bool is_range = false;  // of all members of the body's ranges, not of one number
};

/// A curve or a series in time: its columns, one number each row, and what it is drawn against.
struct effect_table {
  std::vector<std::string> columns;
  std::vector<std::string> units;  // of the columns; empty where a number has none
  std::vector<std::vector<ball>> rows;
  std::vector<rational> first;  // the exact first column, columns[0]
  std::map<std::pair<std::size_t, std::size_t>, rational>
      exact;  // cells of rows[i][k] that are known to be rational, by (i, k)
  long digits = 0;
  bool certified = true;  // where not, numbers in double, each as if it were exact
};

struct effect_result {
  std::string name;
  status verdict = status::certified;
  std::string why;  // where not certified
  std::vector<effect_number> numbers;
  std::vector<std::pair<std::string, std::string>> words;  // "regime": "rotating"
  std::optional<effect_table> table;
  std::vector<std::string> remarks;
  work_count work;

  /// The enclosure of one of its numbers; nothing where it has none of the name.
  [[nodiscard]] const ball* number(const std::string& wanted) const;
};

/// The results in the order of closure_of(want), of which `wanted` tells those that were asked for.
struct scene_report {
  std::vector<effect_result> effects;
  std::vector<std::string> wanted;
  status verdict = status::certified;

  [[nodiscard]] const effect_result* find(const std::string& name) const;
};

/// Computes what the scene wants. What cannot be certified is said so in its result.
[[nodiscard]] scene_report compute(const scene& what);

}  // namespace polhode
