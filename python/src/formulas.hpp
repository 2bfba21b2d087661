#pragma once

// What Python hands over as a function, and as an end of a range.

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode::python {

/// A text, a formula, a number, a SymPy expression, or a function, which is called once with
/// symbols.
[[nodiscard]] expression formula_from(pybind11::handle f,
                                      const std::vector<std::string>& variables);
/// The same; of a text that is an equation "f = g" the formula f - g.
[[nodiscard]] expression equation_from(pybind11::handle f,
                                       const std::vector<std::string>& variables);
/// The same in z; in z and i, where it has the imaginary unit: a text with an i, or a function of
/// two arguments.
[[nodiscard]] expression complex_formula_from(pybind11::handle f);
/// An exact number, a ball, a formula without variables, or an infinity ("inf", math.inf).
[[nodiscard]] end_point end_from(pybind11::handle x);

}  // namespace polhode::python
