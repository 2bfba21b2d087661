// The Python module polhode._polhode.

#include "conversions.hpp"
#include "interruptible.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/version.hpp"

namespace polhode::python {

namespace {

newfunc make_instance = nullptr;  // pybind11's

/// An object of a class that has one of C++ behind it. pybind11 ends the interpreter for another:
/// for its own base class, which pickle's protocols 0 and 1 call.
PyObject* made_or_refused(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
  if (!py::detail::all_type_info(type).empty()) return make_instance(type, arguments, keywords);
  PyErr_Format(PyExc_TypeError, "%s makes no objects; pickle needs protocol 2 or later",
               type->tp_name);
  return nullptr;
}

void refuse_objects_of_the_base_class() {
  auto* base = reinterpret_cast<PyTypeObject*>(py::detail::get_internals().instance_base);
  make_instance = base->tp_new;
  base->tp_new = &made_or_refused;
}

}  // namespace

}  // namespace polhode::python

PYBIND11_MODULE(_polhode, m) {
  namespace py = pybind11;
  using namespace polhode::python;
  refuse_objects_of_the_base_class();
  m.doc() = "Verified arbitrary-precision numerics.";
  py::register_exception<undecided>(m, "Undecided", PyExc_ValueError);
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const wrong_type& e) {
      PyErr_SetString(PyExc_TypeError, e.what());
    }
  });
  m.attr("__version__") = POLHODE_VERSION;
  declare_numbers(m);
  declare_complex_numbers(m);
  declare_formulas(m);
  declare_integrals(m);
  declare_computations(m);
  py::module_::import("atexit").attr("register")(py::cpp_function(expect_the_end));
}
