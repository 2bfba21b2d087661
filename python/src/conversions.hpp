#pragma once

// Python's exact numbers as Polhode's, and back.

#include <optional>
#include <stdexcept>
#include <string>

#include <pybind11/pybind11.h>

#include "polhode/arithmetic/complex_ball.hpp"
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

/// One of those numbers, a ball, a complex ball, or a complex whose parts are integers; exact
/// numbers with p bits. Nothing for what is none of them. Throws wrong_type for another complex.
[[nodiscard]] std::optional<complex_ball> complex_from(py::handle x, precision p);
/// "1 - 2.5...j".
[[nodiscard]] std::string complex_text(const complex_ball& z, long digits);
/// The digits that a precision is worth.
[[nodiscard]] long digits_of(precision p);

/// The double nearest to the middle; a NaN where nothing is known.
[[nodiscard]] double nearest_double(const ball& x);

/// Throws input_error for digits < 1.
[[nodiscard]] long checked_digits(long digits);

void declare_numbers(py::module_& m);
void declare_complex_numbers(py::module_& m);
void declare_formulas(py::module_& m);
void declare_integrals(py::module_& m);
void declare_computations(py::module_& m);

}  // namespace polhode::python
