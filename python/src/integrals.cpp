// Integrals over ranges, along paths in the complex plane, and over boxes of parameters.

#include <algorithm>
#include <chrono>
#include <complex>
#include <utility>

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include "certificates.hpp"
#include "conversions.hpp"
#include "formulas.hpp"
#include "interruptible.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/certificate_of.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/integrate_box.hpp"

namespace polhode::python {

namespace {

std::string text_of(const ball& x, long digits) { return to_decimal(x, digits); }
std::string text_of(const complex_ball& z, long digits) { return complex_text(z, digits); }

/// An integral, contour_integral or box_integral.
template <class Integral>
struct integral_answer {
  Integral found;
  long digits;
  double seconds = 0;
  [[nodiscard]] bool is_certified() const { return found.verdict == status::certified; }
  [[nodiscard]] std::string reason_text() const {
    if (is_certified()) return "";
    return found.obstacle.empty() ? to_text(found.why)
                                  : to_text(found.why) + " (" + found.obstacle + ")";
  }
  [[nodiscard]] std::string value_text() const { return text_of(found.enclosure, digits); }
  [[nodiscard]] std::string text() const {
    return fmt::format("<integral {}: {}{}>", value_text(), to_text(found.verdict),
                       is_certified() ? "" : ", " + reason_text());
  }
};

py::dict account_of(const integral_account& a, double seconds) {
  using namespace py::literals;
  py::list rules;
  for (const quadrature_rule& r : a.rules) rules.append(to_text(r));
  return py::dict("rules"_a = rules, "panels"_a = a.panels, "evaluations"_a = a.evaluations,
                  "region_evaluations"_a = a.region_evaluations, "terms"_a = a.terms,
                  "precision"_a = a.precision, "seconds"_a = seconds);
}

quadrature_rule rule_from(const std::optional<std::string>& word) {
  if (!word) return quadrature_rule::automatic;
  if (const auto rule = quadrature_rule::named(*word)) return *rule;
  std::string words;
  for (const quadrature_rule& rule : quadrature_rule::all()) {
    words += fmt::format("{}\"{}\"", words.empty() ? "" : ", ", rule.word());
  }
  throw input_error(fmt::format("there is no rule \"{}\"; the rules are {}", *word, words));
}

/// How far an integral is, from the thread that works to the one that listens.
struct progress_counts {
  std::atomic<long> done = 0;
  std::atomic<long> panels = 0;
};
using shared_counts = std::shared_ptr<progress_counts>;

/// Calls the callback, if there is one, where the counts have changed.
std::function<void()> listener(const std::optional<py::function>& callback,
                               const shared_counts& counts) {
  if (!callback) return nullptr;
  return [callback, counts, told = std::pair<long, long>(0, 0)]() mutable {
    const std::pair<long, long> now(counts->done, counts->panels);
    if (now == told) return;
    told = now;
    (*callback)(now.first, now.second);
  };
}

integrate_options options_from(long digits, int threads, std::optional<long> absolute_exponent,
                               const std::optional<std::string>& rule) {
  integrate_options options;
  options.digits = checked_digits(digits);
  options.threads = threads;
  options.absolute_exponent = absolute_exponent;
  options.rule = rule_from(rule);
  return options;
}

/// integrate(options), with options that look at the flag and count.
template <class Integrate>
auto watched(const integrate_options& options, const std::optional<py::function>& progress,
             std::optional<double> time_limit, Integrate integrate) {
  const auto counts = std::make_shared<progress_counts>();
  const auto work = [options, counts, integrate](const stop_flag& flag) {
    integrate_options own = options;
    own.progress = [flag, counts](const integration_progress& p) {
      expect_going_on(flag);
      counts->done = p.panels_done;
      counts->panels = p.panels;
    };
    const auto start = std::chrono::steady_clock::now();
    auto answer = integrate(own);
    answer.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return answer;
  };
  return interruptible(time_limit, work, listener(progress, counts));
}

/// Over a range, with what a certificate is of.
struct real_answer : integral_answer<integral> {
  range_of_python range;
};
using contour_answer = integral_answer<contour_integral>;
using box_answer = integral_answer<box_integral>;

real_answer integrate_from_python(py::handle f, py::handle a, py::handle b, long digits,
                                  int threads, std::optional<long> absolute_exponent,
                                  const std::optional<std::string>& rule,
                                  const std::optional<py::function>& progress,
                                  std::optional<double> time_limit) {
  const expression formula = formula_from(f, {"x"});
  const end_point from = end_from(a);
  const end_point to = end_from(b);
  const integrate_options options = options_from(digits, threads, absolute_exponent, rule);
  auto found = watched(options, progress, time_limit, [=](const integrate_options& own) {
    if (own.rule.is_automatic()) {
      if (const auto exact = exact_integral(formula, from, to)) {
        integral known;
        known.enclosure = ball(*exact, bits_for_digits(digits) + 64);
        known.verdict = status::certified;
        return integral_answer<integral>{std::move(known), digits};
      }
    }
    return integral_answer<integral>{integrate(formula, from, to, own), digits};
  });
  return {std::move(found),
          {formula, from, to, py::reinterpret_borrow<py::object>(a),
           py::reinterpret_borrow<py::object>(b)}};
}

py::object certificate_of_integral(const real_answer& a, std::optional<double> time_limit) {
  constexpr long more_digits = 4;  // the certificate's number is wider than the enclosure
  const formula_over_range what = a.range.checkable();
  return certificate_to_python(time_limit, [what, end_points = a.range.end_points(),
                                            digits = a.digits](const stop_flag& flag) {
    integrate_options options;
    options.digits = digits + more_digits;
    options.progress = [flag](const integration_progress&) { expect_going_on(flag); };
    return certificate_of(what, integrate(what.f, end_points.first, end_points.second, options),
                          digits);
  });
}

// -----------------------------------------------------------------------------------------------

/// A complex ball, a number, a pair of real and imaginary part, or a text in which i is the
/// imaginary unit.
path_point point_from(py::handle x) {
  const precision bits = bits_for_digits(default_digits);
  if (py::isinstance<complex_ball>(x) || PyComplex_Check(x.ptr()) != 0) {
    return path_point(*complex_from(x, bits));
  }
  if (py::isinstance<py::str>(x)) {
    const expression f = parse(x.cast<std::string>(), {"i"});
    if (f.exact_value()) return path_point(*f.exact_value());
    return path_point(
        [f](precision p) { return f.evaluator<complex_ball>(p)(complex_ball::i(p)); });
  }
  if (py::isinstance<py::tuple>(x) || py::isinstance<py::list>(x)) {
    const auto parts = py::reinterpret_borrow<py::sequence>(x);
    if (parts.size() == 2) return {end_from(parts[0]), end_from(parts[1])};
    throw wrong_type(
        "a point is a number, a pair (real part, imaginary part), or a text: \"1+2*i\"");
  }
  return path_point(end_from(x));
}

path polygon_from(py::handle points) {
  if (!py::isinstance<py::sequence>(points) || py::isinstance<py::str>(points)) {
    throw wrong_type("a path is a polhode.Path, or a list of points: [0, (1, 0), \"1+i\"], not " +
                     py::repr(points).cast<std::string>());
  }
  std::vector<path_point> corners;
  for (const py::handle x : py::reinterpret_borrow<py::sequence>(points)) {
    corners.push_back(point_from(x));
  }
  return path::polygon(corners);
}

contour_answer integrate_along_from_python(py::handle f, py::handle along, long digits, int threads,
                                           std::optional<long> absolute_exponent,
                                           const std::optional<py::function>& progress,
                                           std::optional<double> time_limit) {
  const expression formula = complex_formula_from(f);
  const path where = py::isinstance<path>(along) ? along.cast<path>() : polygon_from(along);
  const integrate_options options = options_from(digits, threads, absolute_exponent, std::nullopt);
  return watched(options, progress, time_limit, [=](const integrate_options& own) {
    return contour_answer{integrate_along(formula, where, own), digits};
  });
}

// -----------------------------------------------------------------------------------------------

parameter_range range_from(py::handle x) {
  if (py::isinstance<ball>(x)) return parameter_range(x.cast<ball>());
  if (py::isinstance<py::tuple>(x) || py::isinstance<py::list>(x)) {
    const auto ends = py::reinterpret_borrow<py::sequence>(x);
    if (ends.size() == 2) {
      return {rational_from(ends[0], "an end of a parameter"),
              rational_from(ends[1], "an end of a parameter")};
    }
  }
  throw wrong_type(
      "a parameter's range is a ball, or a pair of exact numbers: {\"k\": (1, \"1.1\")}");
}

box_answer integrate_box_from_python(py::handle f, py::handle a, py::handle b, const py::dict& box,
                                     long digits, long most_boxes,
                                     std::optional<double> time_limit) {
  std::vector<std::string> names{"x"};
  std::vector<parameter_range> ranges;
  for (const auto& [name, range] : box) {
    names.push_back(py::str(name).cast<std::string>());
    ranges.push_back(range_from(range));
  }
  const expression formula = formula_from(f, names);
  const end_point from = end_from(a);
  const end_point to = end_from(b);
  box_options options;
  options.digits = checked_digits(digits);
  options.most_boxes = most_boxes;
  return interruptible(time_limit, [=](const stop_flag& flag) {
    box_options own = options;
    own.progress = [flag](long) { expect_going_on(flag); };
    return box_answer{integrate_box(formula, from, to, ranges, own), digits};
  });
}

template <class Answer>
py::class_<Answer> declare_answer(py::module_& m, const char* name, const char* what) {
  return py::class_<Answer>(m, name, what)
      .def_property_readonly(
          "value", [](const Answer& a) { return a.found.enclosure; },
          "A ball that holds the integral, whatever the verdict.")
      .def_property_readonly("certified", &Answer::is_certified, "What was asked for is proved.")
      .def_property_readonly("reason", &Answer::reason_text,
                             "Why it is not certified; empty where it is.")
      .def("__bool__", &Answer::is_certified)
      .def("__str__", &Answer::value_text)
      .def("__repr__", &Answer::text);
}
template <class Answer>
py::class_<Answer> with_account(py::class_<Answer> answer) {
  answer.def_property_readonly(
      "account", [](const Answer& a) { return account_of(a.found.account, a.seconds); },
      "What it cost: rules, panels, evaluations, bits, seconds.");
  return answer;
}

}  // namespace

expression complex_formula_from(py::handle f) {
  if (py::isinstance<py::str>(f)) {
    const std::string name = variable_of(f.cast<std::string>());
    const expression with_unit = equation_from(f, {name, "i"});
    const std::vector<std::string> used = with_unit.used_variables();
    return std::ranges::find(used, "i") == used.end() ? equation_from(f, {name}) : with_unit;
  }
  // Of a function of two arguments the second one is the imaginary unit.
  if (PyCallable_Check(f.ptr()) != 0 && !py::isinstance<expression>(f)) {
    const py::object parameters =
        py::module_::import("inspect").attr("signature")(f).attr("parameters");
    if (py::len(parameters) == 2) return equation_from(f, {"z", "i"});
  }
  return equation_from(f, {"z"});
}

void declare_integrals(py::module_& m) {
  with_account(
      declare_answer<real_answer>(m, "Integral", "An integral with its proof, or how far it got."))
      .def("__float__", [](const real_answer& a) { return nearest_double(a.found.enclosure); })
      .def("certificate", &certificate_of_integral, py::kw_only(),
           py::arg("time_limit") = py::none(),
           "A dict that polhode.check shows again, and `polhode check` as JSON. Raises ValueError "
           "where no certificate can hold the integral: over an infinite range, for one.");
  m.def("integrate", &integrate_from_python, py::arg("f"), py::arg("a"), py::arg("b"),
        py::arg("digits") = default_digits, py::kw_only(), py::arg("threads") = 1,
        py::arg("absolute_exponent") = py::none(), py::arg("rule") = py::none(),
        py::arg("progress") = py::none(), py::arg("time_limit") = py::none(),
        R"doc(The integral of f from a to b, to so many certain digits, with a proof.

f is a text ("exp(-x^2)"), a function of a symbol (lambda x: polhode.exp(-x*x)), which is called
once, or a SymPy expression. The ends are exact numbers, texts ("pi/2", "inf") or polhode.oo.
absolute_exponent: a radius of at most 2**absolute_exponent will do. rule: one of the rules that
`polhode integrate --help` lists, "taylor-series" for one; without it the fastest is chosen.
progress: a function that is called with the panels that are done and those of the plan.
time_limit: seconds, after which TimeoutError is raised. Raises ValueError for what cannot be read;
what cannot be proved is said by the answer.

>>> import polhode
>>> print(polhode.integrate(lambda x: polhode.exp(-x*x), 0, polhode.oo, 30))
0.886226925452758013649083741670...
)doc");

  py::class_<path>(m, "Path", "A path in the complex plane: lines and arcs, one after the other.")
      .def_static("polygon", &polygon_from, py::arg("points"),
                  "Straight lines from point to point. A point is a number, a complex ball, a pair "
                  "(real part, imaginary part), or a text in which i is the imaginary unit.")
      .def_static(
          "circle",
          [](py::handle centre, py::handle radius) {
            return path::circle(point_from(centre), end_from(radius));
          },
          py::arg("centre") = 0, py::arg("radius") = 1, "Once around, counterclockwise.")
      .def_static(
          "arc",
          [](py::handle centre, py::handle radius, py::handle from, py::handle to) {
            return path::arc(point_from(centre), end_from(radius), end_from(from), end_from(to));
          },
          py::arg("centre"), py::arg("radius"), py::arg("from_angle"), py::arg("to_angle"),
          "centre + radius exp(i angle), from one angle to the other, in radians.")
      .def("__add__", [](const path& first, const path& second) { return first + second; })
      .def("__neg__", [](const path& reversed) { return -reversed; })
      .def("__len__", [](const path& p) { return p.pieces().size(); })
      .def("__repr__", [](const path& p) {
        return fmt::format("<path of {} piece{}>", p.pieces().size(),
                           p.pieces().size() == 1 ? "" : "s");
      });
  with_account(declare_answer<contour_answer>(m, "ContourIntegral",
                                              "An integral along a path, a complex ball."))
      .def("__complex__", [](const contour_answer& a) {
        return std::complex<double>(nearest_double(a.found.enclosure.re),
                                    nearest_double(a.found.enclosure.im));
      });
  m.def("integrate_along", &integrate_along_from_python, py::arg("f"), py::arg("path"),
        py::arg("digits") = default_digits, py::kw_only(), py::arg("threads") = 1,
        py::arg("absolute_exponent") = py::none(), py::arg("progress") = py::none(),
        py::arg("time_limit") = py::none(),
        R"doc(The integral of f(z) dz along a path in the complex plane.

f is a text in z, which may have i, or a function of a symbol, or of two: z and i. The path is a
polhode.Path, or a list of points as Path.polygon takes it. That f is analytic along the path is
proved, branch cuts included. Raises ValueError where the pieces do not join.

>>> import polhode
>>> half = polhode.integrate_along("1/z", [1, "i", -1], digits=20)
>>> print(f"{half.value.imag:.20}")
3.1415926535897932384...
)doc");

  declare_answer<box_answer>(m, "BoxIntegral", "The integrals for all parameters in a box.")
      .def_property_readonly(
          "attained", [](const box_answer& a) { return a.found.attained; },
          "The ends of the ball are the least and the greatest integral, to the digits asked for.")
      .def_property_readonly("boxes", [](const box_answer& a) { return a.found.boxes; })
      .def_property_readonly("integrals", [](const box_answer& a) { return a.found.integrals; });
  m.def("integrate_box", &integrate_box_from_python, py::arg("f"), py::arg("a"), py::arg("b"),
        py::arg("box"), py::arg("digits") = 15, py::kw_only(), py::arg("most_boxes") = 1,
        py::arg("time_limit") = py::none(),
        R"doc(A ball that holds the integral from a to b for every value of the parameters.

The box names the parameters with their ranges, pairs of exact numbers or balls. f is a text in x
and these names, or a function of x and of the parameters in their order. The box is cut into
most_boxes at most. digits: of the integrals at the ends.

>>> import polhode
>>> spread = polhode.integrate_box("exp(-k*x)", 0, 1, {"k": (1, "1.1")})
>>> spread.attained, round(float(spread.value.lower), 6), round(float(spread.value.upper), 6)
(True, 0.606481, 0.632121)
)doc");
}

}  // namespace polhode::python
