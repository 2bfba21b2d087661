// Values, roots and systems.

#include <algorithm>
#include <complex>

#include <fmt/format.h>
#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include "certificates.hpp"
#include "conversions.hpp"
#include "formulas.hpp"
#include "interruptible.hpp"
#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/certificate_of.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/roots/complex_roots.hpp"
#include "polhode/roots/isolate.hpp"
#include "polhode/roots/systems.hpp"
#include "polhode/roots/zeros_in_rectangle.hpp"
#include "polhode/scene/link_inertias.hpp"

namespace polhode::python {

namespace {

// -----------------------------------------------------------------------------------------------

ball value_of(const expression& f, long digits, std::optional<double> time_limit) {
  constexpr precision most_guard = 1L << 14;
  return interruptible(time_limit, [=](const stop_flag& flag) {
    if (const auto q = f.rational_value()) return ball(*q, bits_for_digits(digits) + 8);
    return enclose_to_digits(
        [&](precision p) {
          expect_going_on(flag);
          return f.value(p);
        },
        digits, most_guard);
  });
}

/// The i-th, counted from the end for i < 0, as Python counts.
template <class T>
T item(const std::vector<T>& list, long i) {
  const auto n = static_cast<long>(list.size());
  if (i < -n || i >= n) throw py::index_error();
  return list[static_cast<std::size_t>(i < 0 ? i + n : i)];
}

// -----------------------------------------------------------------------------------------------

struct root_answer {
  ball value;
  root_verdict verdict = root_verdict::unresolved;
  long multiplicity = 0;
  std::optional<rational> exact;
  std::string remark;
  long digits = default_digits;
};

struct found_roots {
  std::vector<root_answer> roots;
  root_set found;
  bool certified = false;
};
/// With what a certificate is of.
struct roots_answer : found_roots {
  range_of_python range;
  long digits = default_digits;
};

roots_answer roots_from_python(py::handle f, py::handle a, py::handle b, long digits, int threads,
                               std::optional<double> time_limit) {
  const expression formula = equation_from(f, {"x"});
  const end_point lower = end_from(a);
  const end_point upper = end_from(b);
  (void)checked_digits(digits);
  auto found = interruptible(time_limit, [=](const stop_flag& flag) {
    isolate_options options;
    options.threads = threads;
    options.by_period = true;
    options.progress = [&](const isolation_progress&) { return !*flag; };
    found_roots result;
    result.found = isolate_roots(formula, lower, upper, options);
    result.certified = result.found.is_resolved();
    for (const root_region& region : result.found.regions) {
      expect_going_on(flag);
      root_answer r{region.enclosure, region.verdict, region.multiplicity,
                    region.exact,     region.remark,  digits};
      if (is_one_root(region.verdict)) {
        const refined_root fine = refine(region, digits + 1);
        r.value = fine.enclosure;
        r.exact = fine.exact;
        result.certified = result.certified && fine.verdict == status::certified;
      }
      result.roots.push_back(std::move(r));
    }
    return result;
  });
  return {std::move(found),
          {formula, lower, upper, py::reinterpret_borrow<py::object>(a),
           py::reinterpret_borrow<py::object>(b)},
          digits};
}

py::object certificate_of_roots(const roots_answer& a, std::optional<double> time_limit) {
  return certificate_to_python(
      time_limit, [what = a.range.checkable(), found = a.found, digits = a.digits](
                      const stop_flag&) { return certificate_of(what, found, digits); });
}

struct complex_root_answer {
  complex_zero zero;
  long digits;
};

struct complex_roots_result {
  std::vector<complex_zero> roots;
  std::vector<undecided_rectangle> undecided;
  long digits = default_digits;
  bool complete = false;
};

complex_rectangle rectangle_from(const py::sequence& corners) {
  const auto part = [&](std::size_t corner, std::size_t which) {
    const py::object both = corners[corner];
    if (!py::isinstance<py::sequence>(both) || py::len(both) != 2) {
      throw wrong_type(
          "the rectangle is given as two corners, the lower left and the upper right one, each a "
          "pair of exact numbers: ((-5, -10), (5, 10))");
    }
    const py::object number = both.cast<py::sequence>()[which];
    return rational_from(number, "a corner");
  };
  if (corners.size() != 2) {
    throw wrong_type("the rectangle is given as two corners: ((-5, -10), (5, 10))");
  }
  return {part(0, 0), part(1, 0), part(0, 1), part(1, 1)};
}

complex_roots_result complex_roots_from_python(py::handle f,
                                               const std::optional<py::sequence>& rectangle,
                                               long digits, std::optional<double> time_limit) {
  const expression formula = complex_formula_from(f);
  (void)checked_digits(digits);
  if (rectangle) {
    const complex_rectangle where = rectangle_from(*rectangle);
    return interruptible(time_limit, [=](const stop_flag& flag) {
      zeros_options options;
      options.digits = digits + 1;
      options.go_on = [&](std::size_t) { return !*flag; };
      zeros_answer found = zeros_in_rectangle(formula, where, options);
      const bool complete = found.is_complete();
      return complex_roots_result{std::move(found.zeros), std::move(found.undecided), digits,
                                  complete};
    });
  }
  const auto p = formula.polynomial();
  if (!p) {
    throw input_error(
        "the complex roots of what is no polynomial with rational coefficients are found in a "
        "rectangle: rectangle=((-5, -10), (5, 10))");
  }
  return interruptible(time_limit, [=](const stop_flag& flag) {
    const complex_roots_answer found = complex_roots(*p, digits + 1, [&](long) { return !*flag; });
    complex_roots_result result{{}, {}, digits, found.complete};
    for (const complex_root& r : found.roots) {
      result.roots.push_back({r.enclosure, r.multiplicity, true, true});
    }
    return result;
  });
}

struct found_system {
  std::vector<std::vector<ball>> roots;  // those that are proved
  std::vector<std::vector<ball>> unresolved;
  system_root_set found;
  bool certified = false;
};
/// With what a certificate is of.
struct system_answer : found_system {
  std::vector<expression> equations;
  system_box box;
  long digits = default_digits;

  /// Throws input_error for an unbounded box, and as expect_checkable.
  [[nodiscard]] system_over_box checkable() const {
    system_over_box what{equations, {}, {}};
    for (const auto& [from, to] : box) {
      if (!from || !to) throw input_error("no certificate: the box must be bounded");
      what.from.push_back(parse(to_text(*from), {}));
      what.to.push_back(parse(to_text(*to), {}));
    }
    expect_checkable(what);
    return what;
  }
};

py::object certificate_of_system(const system_answer& a, std::optional<double> time_limit) {
  return certificate_to_python(
      time_limit, [what = a.checkable(), found = a.found, digits = a.digits](const stop_flag&) {
        return certificate_of(what, found, digits);
      });
}

system_answer system_from_python(const py::sequence& equations, const py::sequence& box,
                                 const std::optional<std::vector<std::string>>& names, long digits,
                                 std::optional<double> time_limit) {
  std::vector<std::string> variables;
  if (names) {
    variables = *names;
  } else {
    const std::vector<std::string> usual{"x", "y", "z"};
    for (std::size_t i = 0; i < box.size(); ++i) {
      variables.push_back(i < usual.size() ? usual[i] : fmt::format("x{}", i));
    }
  }
  std::vector<expression> components;
  for (const py::handle f : equations) components.push_back(equation_from(f, variables));
  system_box ranges;
  for (const py::handle range : box) {
    const auto ends = range.cast<py::sequence>();
    if (ends.size() != 2) {
      throw wrong_type("the box is given as a pair of ends for each variable: [(-2, 2), (0, 1)]");
    }
    const auto end_at = [&](std::size_t i) -> std::optional<rational> {
      const py::object end = ends[i];
      if (end_from(end).infinite_sign() == (i == 0 ? -1 : 1)) return std::nullopt;
      return rational_from(end, "an end");
    };
    ranges.emplace_back(end_at(0), end_at(1));
  }
  const real_system system(components);
  (void)checked_digits(digits);
  auto found = interruptible(time_limit, [=](const stop_flag& flag) {
    system_options options;
    options.progress = [&](const isolation_progress&) { return !*flag; };
    found_system result;
    result.found = solve_system(system, ranges, options);
    result.certified = result.found.is_resolved();
    for (const system_region& region : result.found.regions) {
      expect_going_on(flag);
      if (!is_one_root(region.verdict) || region.may_lie_outside) {
        result.unresolved.push_back(region.enclosure);
        continue;
      }
      const refined_system_root fine = refine(system, region, digits);
      result.certified = result.certified && fine.verdict == status::certified;
      result.roots.push_back(fine.enclosure);
    }
    return result;
  });
  return {std::move(found), components, ranges, digits};
}

}  // namespace

void declare_computations(py::module_& m) {
  m.def(
      "eval",
      [](py::handle f, long digits, std::optional<double> time_limit) {
        return value_of(formula_from(f, {}), checked_digits(digits), time_limit);
      },
      py::arg("f"), py::arg("digits") = default_digits, py::kw_only(),
      py::arg("time_limit") = py::none(),
      R"doc(The value of a formula without variables, to so many digits where they can be had.

>>> import polhode
>>> print(f"{polhode.eval('exp(pi) - pi', 20):.20}")
19.999099979189475767...
)doc");

  py::class_<root_answer>(m, "Root", "A root, or a part of the range that may hold roots.")
      .def_readonly("value", &root_answer::value, "A ball that holds it.")
      .def_property_readonly("verdict", [](const root_answer& r) { return to_text(r.verdict); })
      .def_readonly("multiplicity", &root_answer::multiplicity, "0 where it is not known.")
      .def_property_readonly(
          "exact",
          [](const root_answer& r) -> py::object {
            return r.exact ? to_python(*r.exact) : py::object(py::none());
          },
          "The root as a Fraction, where it is known to be one.")
      .def_readonly("remark", &root_answer::remark)
      .def_property_readonly("is_proved",
                             [](const root_answer& r) { return is_one_root(r.verdict); })
      .def("__float__", [](const root_answer& r) { return nearest_double(r.value); })
      .def("__str__", [](const root_answer& r) { return to_decimal(r.value, r.digits); })
      .def("__repr__", [](const root_answer& r) {
        return fmt::format(
            "<root {}: {}>", to_decimal(r.value, r.digits),
            r.multiplicity > 1 ? fmt::format("multiple {}", r.multiplicity) : to_text(r.verdict));
      });
  py::class_<roots_answer>(m, "Roots", "All roots in a range, in ascending order: a sequence.")
      .def("__len__", [](const roots_answer& a) { return a.roots.size(); })
      .def("__getitem__", [](const roots_answer& a, long i) { return item(a.roots, i); })
      .def("__bool__", [](const roots_answer& a) { return a.certified; })
      .def("certificate", &certificate_of_roots, py::kw_only(), py::arg("time_limit") = py::none(),
           "A dict that polhode.check shows again, and `polhode check` as JSON. Raises ValueError "
           "where no certificate can hold the roots: where one is multiple, for one.")
      .def_property_readonly(
          "certified", [](const roots_answer& a) { return a.certified; },
          "These are all roots in the range, or in one period of it (`period`), each to the digits "
          "asked for.")
      .def_property_readonly("identically_zero",
                             [](const roots_answer& a) { return a.found.identically_zero; })
      .def_property_readonly(
          "zero_intervals",
          [](const roots_answer& a) {
            constexpr precision p = 128;
            py::list result;
            for (const zero_interval& z : a.found.zero_intervals) {
              result.append(py::make_tuple(z.lower.at(p), z.upper.at(p)));
            }
            return result;
          },
          "Where f is 0 on intervals: their ends, as balls.")
      .def_property_readonly(
          "singular",
          [](const roots_answer& a) {
            py::list result;
            for (const singular_place& s : a.found.singular) {
              result.append(py::make_tuple(s.place, s.pole_order));
            }
            return result;
          },
          "Places without a root: a ball, and the order of its pole or 0.")
      .def_property_readonly(
          "period",
          [](const roots_answer& a) -> py::object {
            const auto& one = a.found.of_period;
            return one ? py::object(py::cast(to_text(one->period))) : py::object(py::none());
          },
          "Of a periodic function over an unbounded range, whose roots in one period these are.")
      .def_property_readonly(
          "period_range",
          [](const roots_answer& a) -> py::object {
            constexpr precision p = 128;
            const auto& one = a.found.of_period;
            if (!one) return py::none();
            return py::make_tuple(one->lower.at(p), one->upper.at(p));
          },
          "The ends of that period, as balls.")
      .def("__repr__", [](const roots_answer& a) {
        if (a.found.identically_zero) return std::string("<0 everywhere: each point is a root>");
        const auto& one = a.found.of_period;
        std::string text =
            fmt::format("<{} root{}{}, {}", a.roots.size(), a.roots.size() == 1 ? "" : "s",
                        one ? " in one period, " + to_text(one->period) : "",
                        a.certified ? "certified" : "not certified");
        for (const root_answer& r : a.roots) text += "\n  " + to_decimal(r.value, 20);
        for (const zero_interval& z : a.found.zero_intervals) {
          text += fmt::format("\n  all of {}..{}", to_decimal(z.lower.at(128), 20),
                              to_decimal(z.upper.at(128), 20));
        }
        return text + ">";
      });
  m.def("roots", &roots_from_python, py::arg("f"), py::arg("a"), py::arg("b"),
        py::arg("digits") = default_digits, py::kw_only(), py::arg("threads") = 1,
        py::arg("time_limit") = py::none(),
        R"doc(All roots of f in [a, b], each proved; f and the ends as in integrate.

>>> import polhode
>>> for r in polhode.roots("x^3 - 3*x + 1", "-inf", "inf", digits=15): print(r)
-1.87938524157181...
0.347296355333860...
1.53208888623795...
)doc");

  py::class_<complex_root_answer>(m, "ComplexRoot", "A complex root, or several.")
      .def_property_readonly(
          "value", [](const complex_root_answer& r) { return r.zero.enclosure; },
          "A complex ball that holds it.")
      .def_property_readonly(
          "real", [](const complex_root_answer& r) { return r.zero.enclosure.re; },
          "A ball that holds the real part.")
      .def_property_readonly(
          "imag", [](const complex_root_answer& r) { return r.zero.enclosure.im; },
          "A ball that holds the imaginary part; exactly 0 where the root is proved to be real.")
      .def_property_readonly(
          "multiplicity", [](const complex_root_answer& r) { return r.zero.multiplicity; },
          "How many roots there are, with their multiplicities.")
      .def_property_readonly(
          "is_one", [](const complex_root_answer& r) { return r.zero.is_one; },
          "They are proved to be one root of that multiplicity.")
      .def_property_readonly(
          "is_inside", [](const complex_root_answer& r) { return r.zero.is_inside; },
          "It is certain that they lie in the rectangle; else they lie near its boundary.")
      .def("__complex__",
           [](const complex_root_answer& r) {
             return std::complex<double>(nearest_double(r.zero.enclosure.re),
                                         nearest_double(r.zero.enclosure.im));
           })
      .def("__str__",
           [](const complex_root_answer& r) { return complex_text(r.zero.enclosure, r.digits); })
      .def("__repr__", [](const complex_root_answer& r) {
        return fmt::format(
            "<root {}{}>", complex_text(r.zero.enclosure, r.digits),
            r.zero.multiplicity == 1 ? "" : fmt::format(": multiplicity {}", r.zero.multiplicity));
      });
  py::class_<complex_roots_result>(
      m, "ComplexRoots", "Complex roots, in ascending order of the real parts: a sequence.")
      .def("__len__", [](const complex_roots_result& a) { return a.roots.size(); })
      .def("__getitem__",
           [](const complex_roots_result& a, long i) {
             return complex_root_answer{item(a.roots, i), a.digits};
           })
      .def("__bool__", [](const complex_roots_result& a) { return a.complete; })
      .def_readonly("certified", &complex_roots_result::complete, "These are all.")
      .def_property_readonly(
          "undecided",
          [](const complex_roots_result& a) {
            py::list result;
            for (const undecided_rectangle& u : a.undecided) {
              result.append(py::make_tuple(
                  py::make_tuple(to_python(u.where.left), to_python(u.where.bottom)),
                  py::make_tuple(to_python(u.where.right), to_python(u.where.top)), u.obstacle));
            }
            return result;
          },
          "Parts of the rectangle that may hold more: two corners, and what is in the way.")
      .def("__repr__", [](const complex_roots_result& a) {
        std::string text =
            fmt::format("<{} complex root{}, {}", a.roots.size(), a.roots.size() == 1 ? "" : "s",
                        a.complete ? "certified" : "not certified");
        for (const complex_zero& z : a.roots) text += "\n  " + complex_text(z.enclosure, 20);
        return text + ">";
      });
  m.def("complex_roots", &complex_roots_from_python, py::arg("f"),
        py::arg("rectangle") = py::none(), py::arg("digits") = default_digits, py::kw_only(),
        py::arg("time_limit") = py::none(),
        R"doc(All complex roots of a polynomial, or those of an analytic function in a rectangle.

f is a text in z, which may have i, or a function of a symbol. The rectangle is two corners, the
lower left and the upper right one, each a pair of exact numbers (real part, imaginary part);
without it f has to be a polynomial with rational coefficients.

>>> import polhode
>>> for r in polhode.complex_roots("exp(z) - z", ((-5, -5), (5, 5)), digits=10): print(r)
0.3181315052... - 1.337235701...j
0.3181315052... + 1.337235701...j
)doc");

  py::class_<system_answer>(m, "SystemRoots", "The roots of a system in a box.")
      .def("__len__", [](const system_answer& a) { return a.roots.size(); })
      .def("__getitem__", [](const system_answer& a, long i) { return item(a.roots, i); })
      .def("__bool__", [](const system_answer& a) { return a.certified; })
      .def_readonly("certified", &system_answer::certified)
      .def_readonly("unresolved", &system_answer::unresolved, "Boxes that may hold more roots.")
      .def("certificate", &certificate_of_system, py::kw_only(), py::arg("time_limit") = py::none(),
           "A dict that polhode.check shows again, and `polhode check` as JSON. Raises ValueError "
           "where no certificate can hold the roots: where one is multiple, or the box unbounded.")
      .def("__repr__", [](const system_answer& a) {
        return fmt::format("<{} root{} of a system, {}>", a.roots.size(),
                           a.roots.size() == 1 ? "" : "s",
                           a.certified ? "certified" : "not certified");
      });
  m.def(
      "link_tensors",
      [](const std::string& text) {
        py::list result;
        for (const link_inertia& link : read_link_inertias(text)) {
          py::list tensor;
          for (const rational& q : link.tensor) tensor.append(to_python(q));
          result.append(py::make_tuple(link.name, tensor, link.problem));
        }
        return result;
      },
      py::arg("text"),
      "Of each link of a URDF, SDF or MuJoCo text: its name, its tensor, and why it is none.");
  m.def("solve_system", &system_from_python, py::arg("equations"), py::arg("box"),
        py::arg("variables") = py::none(), py::arg("digits") = default_digits, py::kw_only(),
        py::arg("time_limit") = py::none(),
        R"doc(All roots of a system of n equations in n variables in a box, each proved.

Each equation is a text in x, y, z, x3, ..., or in `variables`, or a function of n symbols. A side
of the box is a pair of exact numbers; an end may be polhode.oo.

>>> import polhode
>>> polhode.solve_system(["x^2 + y^2 - 1", "x - y"], [(-2, 2), (-2, 2)])
<2 roots of a system, certified>
)doc");
}

}  // namespace polhode::python
