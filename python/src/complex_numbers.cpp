// polhode.complex_ball: a complex number, or all numbers of a rectangle.

#include <complex>

#include <fmt/format.h>
#include <pybind11/complex.h>

#include "conversions.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode::python {

namespace {

complex_ball made(py::handle re, py::handle im, long digits) {
  const precision p = bits_for_digits(checked_digits(digits)) + 8;
  const auto part = [p](py::handle x) {
    return py::isinstance<ball>(x) ? x.cast<ball>().with_precision(p)
                                   : ball(rational_from(x, "a part"), p);
  };
  if (py::isinstance<complex_ball>(re) || PyComplex_Check(re.ptr()) != 0) {
    if (!rational_from(im, "a part").is_zero()) {
      throw wrong_type("complex_ball takes one complex number, or a real and an imaginary part");
    }
    return complex_from(re, p)->with_precision(p);
  }
  return {part(re), part(im)};
}

template <class F>
auto with_other(F f) {
  return [f](const complex_ball& z, py::handle other) -> py::object {
    const auto w = complex_from(other, z.precision());
    if (!w) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
    return py::cast(f(z, *w));
  };
}

py::object power(const complex_ball& z, py::handle exponent) {
  if (PyIndex_Check(exponent.ptr()) != 0 && PyBool_Check(exponent.ptr()) == 0) {
    return py::cast(pow(z, exponent.cast<long>()));
  }
  const auto w = complex_from(exponent, z.precision());
  if (!w) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
  return py::cast(pow(z, *w));
}

bool is_one_number(const complex_ball& z, const complex_ball& w) {
  return z.is_exact() && w.is_exact() && contains(z, w);
}
bool apart(const complex_ball& z, const complex_ball& w) {
  return !z.is_undefined() && !w.is_undefined() && !overlaps(z, w);
}

/// Of ==, and of != where `equal` is false.
auto comparison(bool equal) {
  return [equal](const complex_ball& z, py::handle other) -> py::object {
    const auto w = complex_from(other, z.precision());
    if (!w) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
    if (is_one_number(z, *w)) return py::bool_(equal);
    if (apart(z, *w)) return py::bool_(!equal);
    throw undecided("it is not decided whether both numbers are one: ask overlaps");
  };
}

std::string text_of(const complex_ball& z) { return complex_text(z, digits_of(z.precision())); }

}  // namespace

void declare_complex_numbers(py::module_& m) {
  py::class_<complex_ball>(m, "complex_ball",
                           R"doc(A complex number that is known to lie in a rectangle.

complex_ball("0.1", 2), complex_ball(1+2j), complex_ball(ball_of_the_real_part, 0). Every
operation's result holds the result for all numbers of its operands. The functions of polhode take
complex balls too, and have their principal values, for every number of the set.

>>> import polhode
>>> print(polhode.complex_ball(1, 2) * 1j, polhode.sqrt(polhode.complex_ball(-4)))
-2 + 1j 0 + 2j
)doc")
      .def(py::init(&made), py::arg("real"), py::arg("imag") = 0,
           py::arg("digits") = default_digits)
      .def_readonly("real", &complex_ball::re, "A ball that holds the real part.")
      .def_readonly("imag", &complex_ball::im, "A ball that holds the imaginary part.")
      .def_property_readonly("is_exact", &complex_ball::is_exact, "It is one number.")
      .def_property_readonly("is_bounded", &complex_ball::is_bounded)
      .def_property_readonly("is_undefined", &complex_ball::is_undefined, "Nothing is known of it.")
      .def_property_readonly("precision", &complex_ball::precision, "The bits of each part.")
      .def("conjugate", [](const complex_ball& z) { return conj(z); })
      .def(
          "arg", [](const complex_ball& z) { return arg(z); }, "The angle, in (-pi, pi].")
      .def("contains",
           with_other([](const complex_ball& z, const complex_ball& w) { return contains(z, w); }),
           "It holds the other one.")
      .def("overlaps",
           with_other([](const complex_ball& z, const complex_ball& w) { return overlaps(z, w); }),
           "Both have a number in common.")
      .def("__neg__", [](const complex_ball& z) { return -z; })
      .def("__pos__", [](const complex_ball& z) { return z; })
      .def("__abs__", [](const complex_ball& z) { return abs(z); })
      .def("__add__", with_other([](const auto& z, const auto& w) { return z + w; }))
      .def("__radd__", with_other([](const auto& z, const auto& w) { return w + z; }))
      .def("__sub__", with_other([](const auto& z, const auto& w) { return z - w; }))
      .def("__rsub__", with_other([](const auto& z, const auto& w) { return w - z; }))
      .def("__mul__", with_other([](const auto& z, const auto& w) { return z * w; }))
      .def("__rmul__", with_other([](const auto& z, const auto& w) { return w * z; }))
      .def("__truediv__", with_other([](const auto& z, const auto& w) { return z / w; }))
      .def("__rtruediv__", with_other([](const auto& z, const auto& w) { return w / z; }))
      .def("__pow__", [](const complex_ball& z, py::handle w) { return power(z, w); })
      .def("__rpow__", with_other([](const auto& z, const auto& w) { return pow(w, z); }))
      .def("__eq__", comparison(true))
      .def("__ne__", comparison(false))
      .def("__complex__",
           [](const complex_ball& z) {
             return std::complex<double>(nearest_double(z.re), nearest_double(z.im));
           })
      .def("__str__", &text_of)
      .def("__repr__", [](const complex_ball& z) { return "<complex_ball " + text_of(z) + ">"; })
      .def("_repr_latex_", [](const complex_ball& z) { return "$" + text_of(z) + "$"; })
      .def(py::pickle(
          [](const complex_ball& z) {
            return py::make_tuple(to_exact_text(z.re), to_exact_text(z.im), z.precision());
          },
          [](const py::tuple& state) {
            const auto part = [&](std::size_t i) {
              return parse_exact_text(state[i].cast<std::string>())
                  .with_precision(state[2].cast<precision>());
            };
            return complex_ball(part(0), part(1));
          }))
      .attr("__hash__") = py::none();
}

}  // namespace polhode::python
