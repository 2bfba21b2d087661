// Symbols, formulas and the functions of both symbols and balls.

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "conversions.hpp"
#include "formulas.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/evaluation.hpp"
#include "polhode/expression/formula_of.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"

namespace polhode::python {

namespace {

constexpr const char* no_branch =
    "a function that is to be proved cannot branch on its argument: write it with abs, min, max, "
    "floor, ceil or sign, or split the range where the formula changes";
constexpr const char* no_number =
    "a formula is no number: write polhode.sin(x) for math.sin(x), and polhode.eval(f) for the "
    "value of a formula without variables";

template <class F>
auto with_other(F f) {
  return [f](const symbol& x, py::handle other) -> py::object {
    const auto y = symbol_from(other);
    if (!y) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
    return py::cast(f(x, *y));
  };
}

/// A name that lives as long as the program, as symbol::call asks for.
std::string_view kept(const std::string& name) {
  static std::set<std::string> names;
  return *names.insert(name).first;
}

using on_balls = std::function<ball(std::span<const ball>)>;

/// A function under its name, by the number of its arguments: over balls, or empty where it is
/// evaluated as a formula.
struct named_function {
  std::string description;
  std::map<std::size_t, on_balls> of_arity;
};

std::size_t arity_of(const expression_function& f) {
  return 1 + static_cast<std::size_t>(std::count(f.arguments.begin(), f.arguments.end(), ','));
}

const std::map<std::string, named_function>& all_functions() {
  static const std::map<std::string, named_function> table = [] {
    std::map<std::string, named_function> result;
    const auto add = [&](const expression_function& f, std::size_t arity, const on_balls& value) {
      named_function& known = result[f.name];
      known.description +=
          fmt::format("{}{}({}): {}; defined for {}.", known.description.empty() ? "" : "\n",
                      f.name, f.arguments, f.description, f.domain);
      known.of_arity[arity] = value;
    };
    for (const expression_function& f : expression_functions()) add(f, arity_of(f), nullptr);
    for (const further_function& f : *library_functions()) add(f.what, f.arity, f.value);
#define POLHODE_OF_ONE(f, ...) \
  result.at(#f).of_arity.at(1) = &detail::named<detail::operation::f>::value;
#define POLHODE_OF_TWO(f, ...) \
  result.at(#f).of_arity.at(2) = &detail::named<detail::operation::f>::value;
    POLHODE_FUNCTION_TABLE(POLHODE_OF_ONE, POLHODE_OF_TWO, POLHODE_OF_TWO, POLHODE_NO_ROW)
#undef POLHODE_OF_ONE
#undef POLHODE_OF_TWO
    return result;
  }();
  return table;
}

/// The arguments of a call: balls and exact numbers, and symbols among them.
class numbers_or_symbols {
 public:
  numbers_or_symbols(const py::args& arguments, std::string what)
      : arguments_(arguments), what_(std::move(what)) {
    for (const py::handle x : arguments) {
      has_symbol_ = has_symbol_ || py::isinstance<symbol>(x);
      if (py::isinstance<ball>(x)) bits_ = x.cast<const ball&>().precision();
      if (is_complex(x)) {
        has_complex_ = true;
        if (py::isinstance<complex_ball>(x)) bits_ = x.cast<const complex_ball&>().precision();
      }
    }
  }
  [[nodiscard]] bool has_symbol() const { return has_symbol_; }
  [[nodiscard]] bool has_complex() const { return has_complex_; }
  /// Those of a ball among them, which exact numbers take.
  [[nodiscard]] precision bits() const { return bits_; }
  [[nodiscard]] std::vector<ball> balls() const {
    std::vector<ball> result;
    for (const py::handle x : arguments_) {
      result.push_back(py::isinstance<ball>(x) ? x.cast<ball>()
                                               : ball(rational_from(x, what_.c_str()), bits_));
    }
    return result;
  }
  [[nodiscard]] std::vector<complex_ball> complex_balls() const {
    std::vector<complex_ball> result;
    for (const py::handle x : arguments_) {
      const auto z = complex_from(x, bits_);
      result.push_back(z ? *z : complex_ball(ball(rational_from(x, what_.c_str()), bits_)));
    }
    return result;
  }
  [[nodiscard]] std::vector<symbol> symbols() const {
    std::vector<symbol> result;
    for (const py::handle x : arguments_) {
      const auto s = symbol_from(x);
      result.push_back(s ? *s : symbol(rational_from(x, what_.c_str())));
    }
    return result;
  }

 private:
  const py::args& arguments_;
  std::string what_;
  static bool is_complex(py::handle x) {
    return py::isinstance<complex_ball>(x) || PyComplex_Check(x.ptr()) != 0;
  }

  bool has_symbol_ = false;
  bool has_complex_ = false;
  precision bits_ = bits_for_digits(default_digits) + 8;
};

/// A list, a tuple, or an array of NumPy that has a length: a number of NumPy's has none.
bool is_list(py::handle x) {
  return py::isinstance<py::list>(x) || py::isinstance<py::tuple>(x) ||
         (py::hasattr(x, "__array__") && py::hasattr(x, "ndim") && x.attr("ndim").cast<long>() > 0);
}

/// f(arguments); where some of them are lists or arrays, which have one length, the list of the
/// results for their members.
template <class F>
py::object member_by_member(const py::args& arguments, const F& f, int depth = 0) {
  constexpr int deepest = 32;  // a list may be a member of itself
  if (depth > deepest) throw input_error("the lists are nested too deeply");
  std::optional<std::size_t> length;
  for (const py::handle x : arguments) {
    if (!is_list(x)) continue;
    const std::size_t own = py::len(x);
    if (length && *length != own) {
      throw input_error(fmt::format("the lists have {} and {} members", *length, own));
    }
    length = own;
  }
  if (!length) return f(arguments);
  py::list results;
  for (std::size_t i = 0; i < *length; ++i) {
    py::list members;
    for (const py::handle x : arguments) {
      if (is_list(x)) {
        members.append(x.attr("__getitem__")(i));
      } else {
        members.append(x);
      }
    }
    results.append(member_by_member(py::args(py::tuple(members)), f, depth + 1));
  }
  return results;
}

/// The function of that name of so many variables.
expression of_variables(const std::string& name, std::size_t count) {
  std::vector<symbol> variables;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) {
    variables.push_back(symbol::variable(i));
    names.push_back(fmt::format("z{}", i));
  }
  return formula_of(symbol::call(kept(name), variables), names);
}

/// As in a formula, these take any number of arguments from two on: f(f(x, y), z).
bool takes_more_than_two(const std::string& name) {
  return name == "min" || name == "max" || name == "hypot";
}

py::object call(const std::string& name, const named_function& f, const py::args& arguments) {
  const auto of_balls = f.of_arity.find(arguments.size());
  if (of_balls == f.of_arity.end() && arguments.size() > 2 && takes_more_than_two(name)) {
    py::object result = arguments[0];
    for (std::size_t i = 1; i < arguments.size(); ++i) {
      result = call(name, f, py::args(py::make_tuple(result, arguments[i])));
    }
    return result;
  }
  if (of_balls == f.of_arity.end()) {
    std::string arities;
    for (const auto& [arity, value] : f.of_arity) {
      arities += fmt::format("{}{}", arities.empty() ? "" : " or ", arity);
    }
    throw wrong_type(fmt::format("{} takes {} argument{}, not {}", name, arities,
                                 arities == "1" ? "" : "s", arguments.size()));
  }
  const numbers_or_symbols given(arguments, "the argument of " + name);
  if (given.has_complex()) {
    const expression formula = of_variables(name, arguments.size());
    return py::cast(formula.evaluate(std::span<const complex_ball>(given.complex_balls())));
  }
  if (!given.has_symbol() && of_balls->second) return py::cast(of_balls->second(given.balls()));
  const symbol result = symbol::call(kept(name), given.symbols());
  if (given.has_symbol()) return py::cast(result);
  return py::cast(formula_of(result, {}).value(given.bits()));
}

py::object value_at(const expression& f, const py::args& arguments) {
  const numbers_or_symbols given(arguments, "a value");
  if (arguments.size() == 0) return py::cast(f.value(given.bits()));
  if (given.has_complex()) {
    return py::cast(f.evaluate(std::span<const complex_ball>(given.complex_balls())));
  }
  if (given.has_symbol()) return py::cast(f.evaluate(std::span<const symbol>(given.symbols())));
  return py::cast(f.evaluate(std::span<const ball>(given.balls())));
}

/// How SymPy writes what Polhode writes otherwise.
std::string from_sympy(const py::object& f) {
  const py::object substitute = py::module_::import("re").attr("sub");
  auto text = py::str(f).cast<std::string>();
  const std::vector<std::pair<const char*, const char*>> names{{R"(\*\*)", "^"},
                                                               {R"(\bAbs\b)", "abs"},
                                                               {R"(\bE\b)", "e"},
                                                               {R"(\bMax\b)", "max"},
                                                               {R"(\bMin\b)", "min"},
                                                               {R"(\bceiling\b)", "ceil"},
                                                               {R"(\bloggamma\b)", "log_gamma"},
                                                               {R"(\bEulerGamma\b)", "euler_gamma"},
                                                               {R"(\bCatalan\b)", "catalan"},
                                                               {R"(\boo\b)", "inf"}};
  for (const auto& [from, to] : names) {
    text = substitute(from, to, text).cast<std::string>();
  }
  return text;
}

bool is_of_sympy(py::handle f) {
  return py::str(py::type::of(f).attr("__module__")).cast<std::string>().starts_with("sympy");
}

/// Of a text in x the name may be another one, if it is the only one.
std::vector<std::string> names_for(const std::string& text,
                                   const std::vector<std::string>& variables) {
  const bool is_usual = variables == std::vector<std::string>{"x"};
  return is_usual ? std::vector{variable_of(text)} : variables;
}
expression of_text(const std::string& text, const std::vector<std::string>& variables) {
  return parse(text, names_for(text, variables));
}

}  // namespace

expression formula_from(py::handle f, const std::vector<std::string>& variables) {
  if (py::isinstance<expression>(f)) return f.cast<expression>();
  if (py::isinstance<py::str>(f)) return of_text(f.cast<std::string>(), variables);
  if (const auto s = symbol_from(f)) return formula_of(*s, variables);
  if (is_of_sympy(f)) {
    return of_text(from_sympy(py::reinterpret_borrow<py::object>(f)), variables);
  }
  if (PyCallable_Check(f.ptr()) == 0) {
    throw wrong_type(
        fmt::format("a function is given as a text, \"exp(-x^2)\", or as lambda x: "
                    "polhode.exp(-x*x), not as {}",
                    py::repr(py::type::of(f)).cast<std::string>()));
  }
  py::list symbols;
  for (std::size_t i = 0; i < variables.size(); ++i) symbols.append(symbol::variable(i));
  const py::object value = py::reinterpret_borrow<py::object>(f)(*py::tuple(symbols));
  const auto s = symbol_from(value);
  if (!s) {
    throw wrong_type(fmt::format(
        "the function returned {}, which is no formula: write it with + - * / ** and the functions "
        "of polhode",
        py::repr(value).cast<std::string>()));
  }
  return formula_of(*s, variables);
}

end_point end_from(py::handle x) {
  if (PyFloat_Check(x.ptr()) != 0) {
    const double value = PyFloat_AsDouble(x.ptr());
    if (value == std::numeric_limits<double>::infinity()) return end_point::infinity();
    if (value == -std::numeric_limits<double>::infinity()) return -end_point::infinity();
  }
  if (py::isinstance<py::str>(x)) {
    const auto text = x.cast<std::string>();
    if (text == "inf" || text == "oo" || text == "+inf") return end_point::infinity();
    if (text == "-inf" || text == "-oo") return -end_point::infinity();
  }
  if (py::isinstance<ball>(x)) return end_point(x.cast<ball>());
  if (const auto q = py::isinstance<symbol>(x) || py::isinstance<py::str>(x)
                         ? std::nullopt
                         : exact_number_from(x)) {
    return end_point(*q);
  }
  if (is_of_sympy(x)) {
    const std::string text = from_sympy(py::reinterpret_borrow<py::object>(x));
    if (text == "inf" || text == "-inf") return end_from(py::str(text));
  }
  return end_point_of(formula_from(x, {}));
}

expression equation_from(py::handle f, const std::vector<std::string>& variables) {
  if (!py::isinstance<py::str>(f)) return formula_from(f, variables);
  const auto text = f.cast<std::string>();
  return parse_equation(text, names_for(text, variables));
}

void declare_formulas(py::module_& m) {
  py::class_<symbol>(m, "Symbol", R"doc(A number that is not known yet, in a formula.

A function that is handed to integrate or roots is called once with a Symbol, and what it does is
the formula. polhode.pi, polhode.e, polhode.euler_gamma and polhode.catalan are constants.)doc")
      .def("__neg__", [](const symbol& x) { return -x; })
      .def("__pos__", [](const symbol& x) { return x; })
      .def("__abs__", [](const symbol& x) { return abs(x); })
      .def("__add__", with_other([](const symbol& x, const symbol& y) { return x + y; }))
      .def("__radd__", with_other([](const symbol& x, const symbol& y) { return y + x; }))
      .def("__sub__", with_other([](const symbol& x, const symbol& y) { return x - y; }))
      .def("__rsub__", with_other([](const symbol& x, const symbol& y) { return y - x; }))
      .def("__mul__", with_other([](const symbol& x, const symbol& y) { return x * y; }))
      .def("__rmul__", with_other([](const symbol& x, const symbol& y) { return y * x; }))
      .def("__truediv__", with_other([](const symbol& x, const symbol& y) { return x / y; }))
      .def("__rtruediv__", with_other([](const symbol& x, const symbol& y) { return y / x; }))
      .def("__pow__", with_other([](const symbol& x, const symbol& y) { return pow(x, y); }))
      .def("__rpow__", with_other([](const symbol& x, const symbol& y) { return pow(y, x); }))
      .def("__bool__", [](const symbol&) -> bool { throw wrong_type(no_branch); })
      .def("__lt__", [](const symbol&, py::handle) -> bool { throw wrong_type(no_branch); })
      .def("__le__", [](const symbol&, py::handle) -> bool { throw wrong_type(no_branch); })
      .def("__gt__", [](const symbol&, py::handle) -> bool { throw wrong_type(no_branch); })
      .def("__ge__", [](const symbol&, py::handle) -> bool { throw wrong_type(no_branch); })
      .def("__eq__", [](const symbol&, py::handle) -> bool { throw wrong_type(no_branch); })
      .def("__ne__", [](const symbol&, py::handle) -> bool { throw wrong_type(no_branch); })
      .def("__float__", [](const symbol&) -> double { throw wrong_type(no_number); })
      .def("__int__", [](const symbol&) -> long { throw wrong_type(no_number); })
      .def("__repr__",
           [](const symbol& x) {
             constexpr std::size_t most = 8;
             std::vector<std::string> names{"x", "y", "z"};
             for (std::size_t i = names.size(); i < most; ++i)
               names.push_back(fmt::format("x{}", i));
             return "<formula " + formula_of(x, names).to_text() + ">";
           })
      .attr("__hash__") = py::none();
  py::class_<expression>(m, "Formula", "A formula in variables: polhode.formula(\"exp(-x^2)\").")
      .def("__str__", &expression::to_text)
      .def("__repr__", [](const expression& f) { return "<formula " + f.to_text() + ">"; })
      .def_property_readonly("variables", &expression::variables)
      .def(
          "__call__",
          [](const expression& f, const py::args& arguments) {
            if (arguments.size() != f.variables().size()) {
              throw wrong_type(
                  fmt::format("the formula has {} variables, and {} numbers were given",
                              f.variables().size(), arguments.size()));
            }
            return member_by_member(arguments,
                                    [&](const py::args& one) { return value_at(f, one); });
          },
          "The value at balls, complex balls or exact numbers; at symbols, a formula; at lists, a "
          "list.");
  m.def("formula", &formula_from, py::arg("f"),
        py::arg("variables") = std::vector<std::string>{"x"},
        "A formula in the variables, of a text, a function of symbols, or a SymPy expression.");
  py::dict functions;
  for (const auto& [name, f] : all_functions()) {
    const std::string text =
        f.description + "\nOf balls, complex balls, exact numbers, symbols, and lists of them.";
    m.def(
        name.c_str(),
        [name = name, &f = f](const py::args& x) {
          return member_by_member(x, [&](const py::args& one) { return call(name, f, one); });
        },
        text.c_str());
    functions[name.c_str()] = f.description;
  }
  m.attr("functions") = functions;
  for (const char* name : {"pi", "e", "euler_gamma", "catalan"}) {
    m.attr(name) = symbol::constant(name);
  }
}

}  // namespace polhode::python
