// The Python module polhode._polhode.

#include "conversions.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/version.hpp"

PYBIND11_MODULE(_polhode, m) {
  namespace py = pybind11;
  using namespace polhode::python;
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
}
