#pragma once

// Certificates of integrals and roots, as Python's dicts.

#include <optional>
#include <utility>

#include "conversions.hpp"
#include "formulas.hpp"
#include "interruptible.hpp"
#include "polhode/certificate/formula_certificates.hpp"

namespace polhode::python {

/// A formula and its range, with the ends as they were handed over: a certificate names them.
struct range_of_python {
  expression f;
  end_point lower;
  end_point upper;
  py::object lower_given;
  py::object upper_given;

  [[nodiscard]] std::pair<end_point, end_point> end_points() const { return {lower, upper}; }

  /// What a certificate is of. Throws input_error for an infinite range, and as expect_checkable.
  [[nodiscard]] formula_over_range checkable() const {
    if (lower.infinite_sign() != 0 || upper.infinite_sign() != 0) {
      throw input_error("no certificate: the range must be finite");
    }
    for (const py::object& end : {lower_given, upper_given}) {
      if (py::isinstance<ball>(end) && !end.cast<ball>().is_exact()) {
        throw input_error("no certificate: an end is a ball that is no single number");
      }
    }
    formula_over_range what{f, formula_from(lower_given, {}), formula_from(upper_given, {})};
    expect_checkable(what);
    return what;
  }
};

/// The certificate that make(flag) returns, as a dict.
template <class Make>
py::object certificate_to_python(std::optional<double> time_limit, Make make) {
  const std::string text =
      interruptible(time_limit, [make](const stop_flag& flag) { return make(flag).dump(); });
  return py::module_::import("json").attr("loads")(text);
}

}  // namespace polhode::python
