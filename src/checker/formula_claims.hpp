#pragma once

// Certificates about formulas that someone gave: an integral, and all roots in a range. What they say follows from their inputs.

#include <array>
#include <string>

#include "document.hpp"
#include "examination.hpp"
#include "formula.hpp"

namespace polhode::checker {

/// Refuses to do more than so much: one unit is about one product of numbers of 64 bits, and all of it some five seconds.
class work_limit {
 public:
  void spend(long units, const place& where) {
    left_ -= units;
    if (left_ < 0) where.not_checkable("it takes more work than this checker does");
  }
  /// An evaluation of f.
  void spend(const formula& f, long bits, const place& where) {
    spend((f.cost() + 1) * (1 + bits / 64), where);
  }

 private:
  long left_ = 4'000'000;
};

/// Bits of evaluations over sets, which decide no digits: tried one after the other.
inline constexpr std::array<long, 3> region_bits{128, 512, 2048};

/// A formula and a range, as a certificate's inputs give them.
struct formula_inputs {
  formula f;
  formula from;
  formula to;
  std::string variable;

  /// {`name`: f, "variable": …, "from": …, "to": …}.
  static formula_inputs read(const place& inputs, const char* name);
};

/// A number's exact ends, lower < upper, with its decimals checked, and how many bits tell the ends apart.
struct number_ends {
  range exact;
  long bits;
};
[[nodiscard]] number_ends read_number(const place& number);

/// The integral and the roots, as /claim names them: throws refusal, or adds what was shown to the report.
void check_integral(const place& certificate, report& result);
void check_roots(const place& certificate, report& result);

}  // namespace polhode::checker
