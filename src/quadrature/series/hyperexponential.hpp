#pragma once

// Formulas that are hyperexponential: f'/f is a rational function. They are the products
//
//   f(y) = c p_1(y)^e_1 ... p_m(y)^e_m exp(s(y) + i t(y))
//
// with polynomials p_i, s and t that have rational coefficients, rational e_i, and a number c. The
// coefficients of such a function's Taylor series follow from a few of those before them
// (taylor_series.hpp). Of f with t != 0 the real or the imaginary part is meant.
//
// Where a formula is a sum of such, in x itself, in y = e^(k x + d), or in y = sin^2 (k x), cos(k
// x) or sin(k x), it is taken apart: its integral is a sum of integrals of hyperexponential
// functions of y. All of this is about real functions on a range, with one sign where a root of
// them is taken: branches and cuts have no part in it.

#include <optional>
#include <vector>

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/arithmetic/polynomial.hpp"
#include "quadrature/formula/formula_graph.hpp"
#include "tiling/tiling.hpp"

namespace polhode::detail {

/// base(y)^exponent. The base is not constant, has coprime integer coefficients, and is expected to
/// be positive where it must not vanish.
struct polynomial_power {
  rational_polynomial base;
  rational exponent;
  /// It must be positive between the ends of the range, whatever the exponent: a root of it was
  /// taken.
  bool must_be_positive = false;

  bool operator==(const polynomial_power&) const = default;
};

/// |x|^exponent of a number x that is not 0.
struct constant_power {
  enum class kind : std::uint8_t {
    rational,  // value
    node,      // the formula's node
    pi
  };
  kind what = kind::rational;
  rational value;
  std::size_t node = 0;
  rational exponent = 1;

  bool operator==(const constant_power&) const = default;
};

struct hyperexponential {
  rational coefficient = 1;
  std::vector<constant_power> constants;
  std::vector<polynomial_power> powers;
  rational_polynomial exponent;  // s
  rational_polynomial phase;     // t: 0, or with a positive leading coefficient
  bool is_sine = false;          // sin t instead of cos t

  /// c with p bits; undefined where it has no value.
  [[nodiscard]] ball constant(const formula_graph& f, precision p) const;

  bool operator==(const hyperexponential&) const = default;
};

/// x^e of x > 0; half-integer powers by the square root.
[[nodiscard]] ball power_of_positive(const ball& x, const rational& e);

/// The integral of a hyperexponential function of y, from lower to upper.
struct hyperexponential_integral {
  hyperexponential function;
  end_point lower = 0;  // less than upper
  end_point upper = 0;
  /// y >= 0 and, where it is given, y <= the second, are natural bounds of the variable, which the
  /// range may be prolonged to: an irrational end close to it is no place to begin a series at.
  bool begins_at_0 = false;
  std::optional<rational> greatest = std::nullopt;
};

/// Integrals whose sum is that of f from a to b, where f is found to be such a sum; a < b as far as
/// is known. The equality holds if each `must_be_positive` does between the ends of its range.
[[nodiscard]] std::optional<std::vector<hyperexponential_integral>> hyperexponential_parts(
    const formula_graph& f, const end_point& a, const end_point& b);

}  // namespace polhode::detail
