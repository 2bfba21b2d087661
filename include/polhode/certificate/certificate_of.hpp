#pragma once

// Certificates of what was found of a formula, from the results of integrate and isolate_roots.
//
//   const formula_over_range what{parse("4/(1+x^2)"), parse("0", {}), parse("1", {})};
//   // for `polhode check`:
//   const json c = certificate_of(what, integrate(what.f, 0, 1, {.digits = 25}), 20);
//
// docs/certificates.md says what they hold. This header needs nlohmann/json.

#include "polhode/certificate/certificate.hpp"
#include "polhode/certificate/formula_certificates.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/roots/isolate.hpp"
#include "polhode/roots/systems.hpp"

namespace polhode {

/// The certificate, in its JSON form, of the integral `found` of what.f over its range. Its number
/// is a little wider than the enclosure: to show so many digits, the integral has to be found with
/// some four more. Throws input_error where it is not certified, and as integral_certificate does.
[[nodiscard]] json certificate_of(const formula_over_range& what, const integral& found,
                                  long digits);

/// The certificate, in its JSON form, of the roots `found` of what.f in its range, to so many
/// digits. Throws input_error as expect_checkable does for the roots, and as roots_certificate
/// does.
[[nodiscard]] json certificate_of(const formula_over_range& what, const root_set& found,
                                  long digits);

/// Formulas in as many variables, and a side of a box for each; `from` and `to` have no variables.
struct system_over_box {
  std::vector<expression> f;
  std::vector<expression> from;
  std::vector<expression> to;
};

/// Throws input_error where a checker would not know what a formula or an end is made of, or how
/// many there are, and says so.
void expect_checkable(const system_over_box& what);

/// The certificate, in its JSON form, of the roots `found` of the system in its box, to so many
/// digits: the enclosures, widened by 10^-digits/100, and a box around each on which the matrix of
/// derivatives is regular. Throws input_error as expect_checkable does; where a root is not proved
/// to be simple and the only one in its place; and where no such box is found: at a root on a face
/// of the box.
[[nodiscard]] json certificate_of(const system_over_box& what, const system_root_set& found,
                                  long digits);

/// Throws input_error where no certificate can hold the roots, and says why: the function is 0
/// everywhere, or not defined everywhere; a root is multiple, or is not proved to be the only one
/// in its place.
void expect_checkable(const root_set& found);

}  // namespace polhode
