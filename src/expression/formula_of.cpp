#include "polhode/expression/formula_of.hpp"

#include "polhode/expression/library_functions.hpp"
#include "symbol_graph.hpp"

namespace polhode {

expression formula_of(const symbol& s, const std::vector<std::string>& variables) {
  return expression(s, {variables, {}, library_functions()});
}

expression complex_formula_of(const symbol& s) {
  std::vector<std::string> variables{"z"};
  if (detail::has_imaginary_unit(s)) variables.emplace_back("i");
  return formula_of(s, variables);
}

std::vector<std::string> detail::numbered_names(const std::string& name, std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i) names.push_back(name + std::to_string(i));
  return names;
}

}  // namespace polhode
