#pragma once

// Certificates of what someone asked for: an integral, all roots of a formula in a range, and a map
// of bodies. What they say follows from their inputs.

#include <array>
#include <string>

#include "document.hpp"
#include "examination.hpp"
#include "formula.hpp"

namespace polhode::checker {

/// Bits of evaluations over sets, which decide no digits: tried one after the other.
inline constexpr std::array<long, 3> region_bits{128, 512, 2048};

/// A name that a variable may have.
[[nodiscard]] const std::string& read_variable(const place& where);
/// An end of a range, a formula without variables: the number, or two that it lies between.
[[nodiscard]] range end_of(const formula& f, const place& where);

/// A formula and a range, as a certificate's inputs give them.
struct formula_inputs {
  formula f;
  formula from;
  formula to;
  std::string variable;
  place where;  // of the inputs

  /// {`name`: f, "variable": …, "from": …, "to": …}.
  static formula_inputs read(const place& inputs, const char* name);
};

/// A number's exact ends, lower < upper, with its decimals checked, and how many bits tell the ends
/// apart.
struct number_ends {
  range exact;
  long bits;
  long digits;  // that both ends share
};
[[nodiscard]] number_ends read_number(const place& number);

/// The integral, the roots of a formula and of a system, and the map, as /claim names them: throws
/// refusal, or adds what was shown to the report.
void check_integral(const place& certificate, report& result);
void check_roots(const place& certificate, report& result);
void check_system(const place& certificate, report& result);
void check_map(const place& certificate, report& result);

}  // namespace polhode::checker
