#pragma once

// Python's exact numbers as Polhode's, and back.

#include <optional>
#include <stdexcept>
#include <string>

#include <pybind11/pybind11.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/symbol.hpp"

namespace polhode::python {

namespace py = pybind11;

/// TypeError in Python.
class wrong_type : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};
/// A comparison that the enclosures do not decide: polhode.Undecided in Python.
class undecided : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

inline constexpr long default_digits = 50;

[[nodiscard]] integer integer_from(py::handle x);
[[nodiscard]] py::object to_python(const integer& n);
/// A fractions.Fraction.
[[nodiscard]] py::object to_python(const rational& q);

/// An int, Fraction, Decimal, a number of mpmath or NumPy's integers, or a float that is an
/// integer; nothing for what is no number. Throws wrong_type for another float.
[[nodiscard]] std::optional<rational> exact_number_from(py::handle x);
/// The same, and a decimal or quotient as text.
[[nodiscard]] rational rational_from(py::handle x, const char* what);
/// The same numbers, a ball or a symbol; nothing for what is none of them.
[[nodiscard]] std::optional<symbol> symbol_from(py::handle x);

/// The double nearest to the middle; a NaN where nothing is known.
[[nodiscard]] double nearest_double(const ball& x);

/// Throws input_error for digits < 1.
[[nodiscard]] long checked_digits(long digits);

void declare_numbers(py::module_& m);
void declare_formulas(py::module_& m);
void declare_computations(py::module_& m);

}  // namespace polhode::python
