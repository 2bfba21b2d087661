#pragma once

// Certificates of formulas, for the tests.

#include <string>
#include <vector>

#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/digest.hpp"
#include "polhode/certificate/formula_certificates.hpp"

namespace polhode::test {

inline expression read(const std::string& text, const char* variable = nullptr) {
  expression_names names;
  if (variable != nullptr) names.variables = {variable};
  return expression(text, names);
}

inline ball value_of(const std::string& formula, long digits) {
  return read(formula).value(bits_for_digits(digits) + 32);
}

/// Of an integral whose value a formula gives.
inline json integral_json(const std::string& f, const std::string& from, const std::string& to,
                          const std::string& value, long digits = 20) {
  return integral_certificate({read(f, "x"), read(from), read(to)}, value_of(value, digits),
                              digits);
}

/// Of roots that formulas give.
inline json roots_json(const std::string& f, const std::string& from, const std::string& to,
                       const std::vector<std::string>& roots, long digits = 20) {
  std::vector<ball> enclosures;
  enclosures.reserve(roots.size());
  for (const std::string& root : roots) enclosures.push_back(value_of(root, digits));
  return roots_certificate({read(f, "x"), read(from), read(to)}, enclosures, digits);
}

inline void make_digest_right(json& certificate) {
  certificate.erase("digest");
  certificate["digest"] = digest_of(certificate.dump());
}

}  // namespace polhode::test
