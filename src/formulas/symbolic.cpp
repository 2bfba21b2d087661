#include "polhode/formulas/symbolic.hpp"

#include "polhode/formulas/elliptic_functions.hpp"

namespace polhode {

expression formula_of(const symbol& s, const std::vector<std::string>& variables) {
  return expression(s, {variables, {}, elliptic_functions()});
}

}  // namespace polhode
