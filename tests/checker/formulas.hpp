#pragma once

// Certificates of formulas, for the tests.

#include <string>
#include <vector>

#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/certificate_of.hpp"
#include "polhode/certificate/digest.hpp"

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

/// A side of a box: a variable, and the ends of its interval.
struct side {
  std::string variable;
  std::string from;
  std::string to;
};
inline system_over_box system_of(const std::vector<std::string>& f,
                                 const std::vector<side>& sides) {
  expression_names names;
  names.variables.clear();
  for (const side& s : sides) names.variables.push_back(s.variable);
  system_over_box what;
  for (const std::string& text : f) what.f.emplace_back(text, names);
  for (const side& s : sides) {
    what.from.push_back(read(s.from));
    what.to.push_back(read(s.to));
  }
  return what;
}
/// Of all roots in the box, whose ends are rational.
inline json system_json(const std::vector<std::string>& f, const std::vector<side>& sides,
                        long digits = 20) {
  const system_over_box what = system_of(f, sides);
  system_box box;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    box.emplace_back(what.from[i].exact_value(), what.to[i].exact_value());
  }
  return certificate_of(what, solve_system(real_system(what.f), box), digits);
}

inline void make_digest_right(json& certificate) {
  certificate.erase("digest");
  certificate["digest"] = digest_of(certificate.dump());
}

}  // namespace polhode::test
