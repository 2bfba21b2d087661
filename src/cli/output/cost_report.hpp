#pragma once

// What polhode cost has measured, and how it is written down.

#include <optional>
#include <string>
#include <vector>

#include "cost/measure.hpp"

namespace polhode::cli {

struct measured_method {
  const cost::method* what = nullptr;
  std::vector<cost::measurement> points;  // by digits
  std::vector<long> left_out;             // digits for which there was no time
};

struct measured_quantity {
  const cost::quantity* what = nullptr;
  std::vector<measured_method> methods;
};

/// Of a family of hard cases: the points are by the exponent, `digits` of each is what was asked
/// for.
struct measured_family {
  const cost::hard_family* what = nullptr;
  long digits = 0;
  struct method_points {
    std::string name;
    bool certified = false;
    std::vector<std::pair<long, cost::measurement>> points;
    std::vector<long> left_out;  // exponents
  };
  std::vector<method_points> methods;
};

struct cost_report {
  std::vector<long> digits;
  std::vector<measured_quantity> quantities;
  std::vector<measured_family> families;
};

/// For a terminal of 100 columns.
[[nodiscard]] std::string as_text(const cost_report& report);
/// Every measurement in a line.
[[nodiscard]] std::string as_csv(const cost_report& report);
[[nodiscard]] std::string as_json(const cost_report& report);

struct cost_picture {
  std::string name;     // of its files
  std::string program;  // gnuplot's, but for the terminal
};
[[nodiscard]] std::vector<cost_picture> pictures_of(const cost_report& report);

/// The pictures' names, without computing anything: of those quantities and families.
[[nodiscard]] std::vector<std::string> picture_names(
    const std::vector<const cost::quantity*>& quantities,
    const std::vector<const cost::hard_family*>& families);

}  // namespace polhode::cli
