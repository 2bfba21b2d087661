// polhode.ball: a real number, or all numbers of a set.

#include <cstring>

#include <fmt/format.h>
#include <pybind11/operators.h>

#include "conversions.hpp"
#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/scalar.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode::python {

namespace {

ball made(py::handle x, long digits) {
  const precision p = bits_for_digits(checked_digits(digits)) + 8;
  if (py::isinstance<ball>(x)) return x.cast<ball>().with_precision(p);
  return {rational_from(x, "a ball"), p};
}

/// The other operand, exactly: with x's precision.
std::optional<ball> beside(const ball& x, py::handle other) {
  if (py::isinstance<ball>(other)) return other.cast<ball>();
  if (const auto q = exact_number_from(other)) return ball(*q, x.precision());
  return std::nullopt;
}

template <class F>
auto with_other(F f) {
  return [f](const ball& x, py::handle other) -> py::object {
    const auto y = beside(x, other);
    if (!y) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
    return py::cast(f(x, *y));
  };
}

/// Of a relation, of which `is_so` and `is_not` prove that it holds, and that it does not.
template <class F, class G>
auto comparison(const char* sign, F is_so, G is_not) {
  return [=](const ball& x, py::handle other) -> py::object {
    const auto y = beside(x, other);
    if (!y) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
    if (is_so(x, *y)) return py::bool_(true);
    if (is_not(x, *y)) return py::bool_(false);
    constexpr long few = 20;
    throw undecided(fmt::format(
        "the enclosures {} and {} do not decide \"{}\": compute with more digits, or ask "
        "certainly_less or overlaps",
        to_decimal(x, few), to_decimal(*y, few), sign));
  };
}

bool is_one_number(const ball& x, const ball& y) {
  return x.is_exact() && y.is_exact() && contains(x, y);
}
bool less(const ball& x, const ball& y) { return certainly_less(x, y); }
bool greater(const ball& x, const ball& y) { return certainly_less(y, x); }
bool at_most(const ball& x, const ball& y) { return certainly_less_equal(x, y); }
bool at_least(const ball& x, const ball& y) { return certainly_less_equal(y, x); }
bool apart(const ball& x, const ball& y) {
  return !x.is_undefined() && !y.is_undefined() && !overlaps(x, y);
}

py::object power(const ball& x, py::handle exponent) {
  if (PyIndex_Check(exponent.ptr()) != 0 && PyBool_Check(exponent.ptr()) == 0) {
    return py::cast(pow(x, exponent.cast<long>()));
  }
  const auto y = beside(x, exponent);
  if (!y) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
  return py::cast(pow(x, *y));
}

/// As of a text, [[fill]align][width], and behind a point the number of digits.
py::str formatted(const ball& x, const std::string& how) {
  const std::size_t point = how.rfind('.');
  const std::string digits = point == std::string::npos ? "" : how.substr(point + 1);
  const bool has_digits = !digits.empty() && digits.size() <= 9 &&
                          digits.find_first_not_of("0123456789") == std::string::npos;
  if (point == std::string::npos || has_digits) {
    const std::string text =
        to_decimal(x, has_digits ? checked_digits(std::stol(digits)) : digits_of(x.precision()));
    try {
      return py::str(text).attr("__format__")(how.substr(0, point));
    } catch (const py::error_already_set& error) {
      if (!error.matches(PyExc_ValueError)) throw;
    }
  }
  throw input_error(
      "the format of a ball is a width and a number of digits, as in f\"{x:.20}\" and "
      "f\"{x:>30.20}\", not \"" +
      how + "\"");
}

std::string latex(const ball& x) {
  const decimal_enclosure d = to_decimal_enclosure(x, digits_of(x.precision()));
  std::string text = to_text(d);
  const auto replace = [&](const std::string& from, const std::string& to) {
    if (const auto at = text.find(from); at != std::string::npos) text.replace(at, from.size(), to);
  };
  replace("...", "\\ldots");
  replace("±", "\\pm");
  if (const auto at = text.find('e'); at != std::string::npos && d.radius == "0") {
    text = text.substr(0, at) + "\\cdot 10^{" + text.substr(at + 1) + "}";
  }
  return "$" + text + "$";
}

ball expect_bounded(const ball& x) {
  if (!x.is_bounded()) throw input_error("the ball is not bounded, so that it has no ends");
  return x;
}

}  // namespace

void declare_numbers(py::module_& m) {
  py::class_<ball>(m, "ball",
                   R"doc(A real number that is known to lie in a set, or every number of it.

ball("0.1", digits=50), ball(Fraction(1, 3)), ball(2). Every operation's result holds the result for
all numbers of its operands. A float is taken only where it is an integer: ball.exactly(0.5) is the
binary number itself. A comparison that the sets do not decide raises polhode.Undecided.)doc")
      .def(py::init(&made), py::arg("value"), py::arg("digits") = default_digits)
      .def_static(
          "exactly", [](double x) { return ball::exactly(x, bits_for_digits(default_digits)); },
          py::arg("value"), "The binary number that a float is.")
      .def_static(
          "hull_of",
          [](py::handle low, py::handle high, long digits) {
            return hull(made(low, digits), made(high, digits));
          },
          py::arg("lower"), py::arg("upper"), py::arg("digits") = default_digits,
          "All numbers from lower to upper.")
      .def_property_readonly(
          "mid",
          [](const ball& x) { return to_python(lower_rational(expect_bounded(x).middle())); },
          "The middle, a Fraction.")
      .def_property_readonly(
          "rad",
          [](const ball& x) {
            const rational middle = lower_rational(expect_bounded(x).middle());
            const rational above = upper_rational(x) - middle;
            const rational below = middle - lower_rational(x);
            return to_python(above < below ? below : above);
          },
          "The greatest distance of a number in it from mid, a Fraction.")
      .def_property_readonly(
          "lower", [](const ball& x) { return to_python(lower_rational(expect_bounded(x))); },
          "The lower end, a Fraction.")
      .def_property_readonly(
          "upper", [](const ball& x) { return to_python(upper_rational(expect_bounded(x))); },
          "The upper end, a Fraction.")
      .def(
          "decimals",
          [](const ball& x, long digits) {
            const decimal_enclosure d =
                to_decimal_enclosure(expect_bounded(x), checked_digits(digits));
            const py::object decimal = py::module_::import("decimal").attr("Decimal");
            return py::make_tuple(decimal(d.lower), decimal(d.upper));
          },
          py::arg("digits") = default_digits,
          "Two Decimals of about so many digits, between which every number of the set lies.")
      .def_property_readonly("is_exact", &ball::is_exact, "It is one number.")
      .def_property_readonly("is_bounded", &ball::is_bounded)
      .def_property_readonly("is_undefined", &ball::is_undefined, "Nothing is known of it.")
      .def_property_readonly("precision", &ball::precision, "The bits that it is kept with.")
      .def(
          "digits",
          [](const ball& x) {
            return to_decimal_enclosure(x, 10 * digits_of(x.precision())).digits;
          },
          "The number of significant digits that are certain.")
      .def("contains", with_other([](const ball& x, const ball& y) { return contains(x, y); }),
           "It holds the other ball, or the number.")
      .def("overlaps", with_other([](const ball& x, const ball& y) { return overlaps(x, y); }),
           "Both have a number in common.")
      .def("__neg__", [](const ball& x) { return -x; })
      .def("__pos__", [](const ball& x) { return x; })
      .def("__abs__", [](const ball& x) { return abs(x); })
      .def("__add__", with_other([](const ball& x, const ball& y) { return x + y; }))
      .def("__radd__", with_other([](const ball& x, const ball& y) { return y + x; }))
      .def("__sub__", with_other([](const ball& x, const ball& y) { return x - y; }))
      .def("__rsub__", with_other([](const ball& x, const ball& y) { return y - x; }))
      .def("__mul__", with_other([](const ball& x, const ball& y) { return x * y; }))
      .def("__rmul__", with_other([](const ball& x, const ball& y) { return y * x; }))
      .def("__truediv__", with_other([](const ball& x, const ball& y) { return x / y; }))
      .def("__rtruediv__", with_other([](const ball& x, const ball& y) { return y / x; }))
      .def("__pow__", [](const ball& x, py::handle y) { return power(x, y); })
      .def("__rpow__", with_other([](const ball& x, const ball& y) { return pow(y, x); }))
      .def("__lt__", comparison("<", less, at_least))
      .def("__gt__", comparison(">", greater, at_most))
      .def("__le__", comparison("<=", at_most, greater))
      .def("__ge__", comparison(">=", at_least, less))
      .def("__eq__", comparison("==", is_one_number, apart))
      .def("__ne__", comparison("!=", apart, is_one_number))
      .def("__float__", [](const ball& x) { return nearest_double(x); })
      .def("__bool__",
           [](const ball& x) {
             if (is_one_number(x, ball(0, x.precision()))) return false;
             if (contains_zero(x)) throw undecided("it is not decided whether this ball is 0");
             return true;
           })
      .def("__format__", &formatted)
      .def(
          "_mpmath_",
          [](const ball& x, long bits, const std::string& rounding) {
            // mpmath's own conversion does not look at these, and may end the interpreter.
            if (bits < 0 || rounding.size() != 1 || !std::strchr("nfcdu", rounding[0])) {
              throw input_error("_mpmath_ is for mpmath: bits >= 0, and one of n, f, c, d, u");
            }
            const mpfr_float middle = midpoint(expect_bounded(x));
            integer mantissa;
            long exponent = 0;
            if (mpfr_zero_p(middle.backend().data()) == 0) {
              exponent = mpfr_get_z_2exp(mantissa.backend().data(), middle.backend().data());
            }
            const py::object make = py::module_::import("mpmath.libmp").attr("from_man_exp");
            return py::module_::import("mpmath").attr("mp").attr("make_mpf")(
                make(to_python(mantissa), exponent, bits, rounding));
          },
          "The middle as mpmath.mpf(ball) has it, rounded to mpmath's precision.")
      .def("__str__", [](const ball& x) { return to_decimal(x, digits_of(x.precision())); })
      .def("__repr__",
           [](const ball& x) { return "<ball " + to_decimal(x, digits_of(x.precision())) + ">"; })
      .def("_repr_latex_", &latex)
      .def(py::pickle([](const ball& x) { return py::make_tuple(to_exact_text(x), x.precision()); },
                      [](const py::tuple& state) {
                        return parse_exact_text(state[0].cast<std::string>())
                            .with_precision(state[1].cast<precision>());
                      }))
      .attr("__hash__") = py::none();
  m.def(
      "certainly_less",
      [](py::handle x, py::handle y) {
        const auto as_ball = [](py::handle z) {
          return py::isinstance<ball>(z) ? z.cast<ball>() : ball(rational_from(z, "a number"), 128);
        };
        return certainly_less(as_ball(x), as_ball(y));
      },
      py::arg("x"), py::arg("y"), "Every number in x is less than every number in y.");
}

}  // namespace polhode::python
