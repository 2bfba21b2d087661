#pragma once

// A function taken apart into oscillations, by its graph: step 1 of what oscillation.hpp describes.
//
//   f(x) |dx/dy| = sum over w of W_w(y) e^(i w y),   x = p + s y^theta,
//
// with W_w = u + i v, u and v formulas in y. The sum and the product of such sums is one; the sine
// or cosine of P = w y + R is one where P is known as a sum of powers of y, and R's are not
// positive.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/expression/symbol.hpp"
#include "polhode/expression/wave_amplitudes.hpp"
#include "quadrature/formula/formula_graph.hpp"

namespace polhode::detail::oscillations {

/// The sum of q_n times constants by their names; the empty name stands for 1.
using frequency = std::map<std::string, rational>;

/// u + i v, 0 where there is none.
struct amplitude {
  std::optional<symbol> re;
  std::optional<symbol> im;
};

/// The variables of the symbols below. After these come the numbers of separated::numbers.
constexpr std::size_t variable_y = 0;
constexpr std::size_t variable_unit = 1;  // i
constexpr std::size_t first_number = 2;

/// Two variables are the amplitudes P and Q of wave_amplitudes.hpp, of this function at slope y +
/// shift, which are constants.
struct function_amplitudes {
  std::size_t variable;  // P; the next one is Q
  wave_function of;
  symbol slope;
  symbol shift;
};

/// f(x) |dx/dy| taken apart.
struct separated {
  /// The amplitudes of e^(i w y), those of w and -w conjugate; nothing where f is not found to be
  /// such a sum.
  std::optional<std::map<frequency, amplitude>> terms;
  /// Where a phase grows like another power than y: that power.
  std::optional<rational> growth;
  /// The constants of frequencies, by their names.
  std::map<std::string, symbol> constants;
  /// The values of the variables from first_number on, by the precision; empty functions for those
  /// of `amplitudes`.
  std::vector<std::function<possibly_exact_constant(precision)>> numbers;
  std::vector<function_amplitudes> amplitudes;
  /// Constants that must be positive.
  std::vector<symbol> positive;
};

/// f between x = at + s and `at`, or an infinity, as a function of y with x = at + s y^theta. The
/// integral counts with this sign.
[[nodiscard]] separated separate(const std::shared_ptr<const formula_graph>& f, const end_point& at,
                                 const end_point& s, const rational& theta, int sign);

}  // namespace polhode::detail::oscillations
