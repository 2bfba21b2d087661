#include "conversions.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "polhode/arithmetic/scalar.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode::python {

integer integer_from(py::handle x) {
  const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(x.ptr()));
  if (!index) throw py::error_already_set();
  int overflow = 0;
  const long n = PyLong_AsLongAndOverflow(index.ptr(), &overflow);
  if (overflow == 0) return n;
  const auto text = py::str(py::module_::import("builtins").attr("hex")(index)).cast<std::string>();
  // "-0x1f": GMP reads the sign, and 16 as the base.
  const bool is_negative = text.front() == '-';
  integer result;
  mpz_set_str(result.backend().data(), text.c_str() + (is_negative ? 3 : 2), 16);
  return is_negative ? integer(-result) : result;
}

py::object to_python(const integer& n) {
  if (mpz_fits_slong_p(n.backend().data()) != 0) return py::int_(static_cast<long>(n));
  std::string text(mpz_sizeinbase(n.backend().data(), 16) + 2, '\0');  // with a sign
  mpz_get_str(text.data(), 16, n.backend().data());
  return py::reinterpret_steal<py::object>(PyLong_FromString(text.c_str(), nullptr, 16));
}

py::object to_python(const rational& q) {
  return py::module_::import("fractions")
      .attr("Fraction")(to_python(integer(numerator(q))), to_python(integer(denominator(q))));
}

std::optional<rational> exact_number_from(py::handle x) {
  if (PyBool_Check(x.ptr()) != 0) return std::nullopt;
  if (PyIndex_Check(x.ptr()) != 0) return rational(integer_from(x));
  if (PyFloat_Check(x.ptr()) != 0) {
    const double value = PyFloat_AsDouble(x.ptr());
    if (std::isfinite(value) && std::floor(value) == value) return rational(value);
    const auto text = py::repr(x).cast<std::string>();
    throw wrong_type(fmt::format(
        "{} is a float, a binary number that is seldom the decimal it looks like: write \"{}\", "
        "Fraction or Decimal, or ball.exactly({}) for the binary number itself",
        text, text, text));
  }
  if (py::hasattr(x, "_mpf_")) {  // (sign, mantissa, exponent, bits): (-1)^sign mantissa 2^exponent
    const auto parts = x.attr("_mpf_").cast<py::tuple>();
    const integer mantissa = integer_from(parts[1]);
    const long exponent = parts[2].cast<long>();
    constexpr long most = 1L << 24;
    if ((mantissa == 0 && exponent != 0) || std::abs(exponent) > most) {
      throw wrong_type("this mpmath number is not finite, or too great");
    }
    const rational power(integer(integer(1) << static_cast<unsigned long>(std::abs(exponent))));
    const rational size = exponent < 0 ? rational(mantissa / power) : rational(mantissa * power);
    return parts[0].cast<int>() != 0 ? rational(-size) : size;
  }
  if (py::hasattr(x, "numerator") && py::hasattr(x, "denominator")) {
    return rational(integer_from(x.attr("numerator")), integer_from(x.attr("denominator")));
  }
  if (py::hasattr(x, "as_integer_ratio")) {
    const auto ratio = x.attr("as_integer_ratio")().cast<py::tuple>();
    return rational(integer_from(ratio[0]), integer_from(ratio[1]));
  }
  return std::nullopt;
}

rational rational_from(py::handle x, const char* what) {
  if (py::isinstance<py::str>(x)) return parse_rational(x.cast<std::string>());
  if (const auto q = exact_number_from(x)) return *q;
  throw wrong_type(fmt::format(
      "{} must be an int, a Fraction, a Decimal or a text such as \"0.1\" or \"1/3\", not {}", what,
      py::repr(py::type::of(x)).cast<std::string>()));
}

std::optional<symbol> symbol_from(py::handle x) {
  if (py::isinstance<symbol>(x)) return x.cast<symbol>();
  if (py::isinstance<ball>(x)) return symbol(x.cast<ball>());
  if (const auto q = exact_number_from(x)) return symbol(*q);
  return std::nullopt;
}

std::optional<complex_ball> complex_from(py::handle x, precision p) {
  if (py::isinstance<complex_ball>(x)) return x.cast<complex_ball>();
  if (py::isinstance<ball>(x)) return complex_ball(x.cast<ball>());
  if (PyComplex_Check(x.ptr()) != 0) {
    const auto part = [&](double value) {
      if (std::isfinite(value) && std::floor(value) == value) return ball(rational(value), p);
      throw wrong_type(fmt::format(
          "{} has a part that is a float, a binary number that is seldom the decimal it looks "
          "like: write complex_ball(\"0.1\", \"0.2\")",
          py::repr(x).cast<std::string>()));
    };
    return complex_ball(part(PyComplex_RealAsDouble(x.ptr())),
                        part(PyComplex_ImagAsDouble(x.ptr())));
  }
  if (const auto q = exact_number_from(x)) return complex_ball(ball(*q, p));
  return std::nullopt;
}

std::string complex_text(const complex_ball& z, long digits) {
  if (z.is_undefined()) return "undefined";
  const std::string re = to_decimal(z.re, digits);
  if (sign_of(z.im) == certain_sign::zero) return re;
  const bool is_below = certainly_negative(z.im);
  return fmt::format("{} {} {}j", re, is_below ? '-' : '+',
                     to_decimal(is_below ? -z.im : z.im, digits));
}

long digits_of(precision p) {
  return std::max(1L, static_cast<long>(static_cast<double>(p) * 0.30103) - 2);
}

double nearest_double(const ball& x) {
  const mpfr_float middle = midpoint(x);
  return mpfr_get_d(middle.backend().data(), MPFR_RNDN);
}

long checked_digits(long digits) {
  constexpr long most = 100'000'000;
  if (digits < 1 || digits > most) {
    throw input_error(fmt::format("digits must be between 1 and {}, not {}", most, digits));
  }
  return digits;
}

}  // namespace polhode::python
