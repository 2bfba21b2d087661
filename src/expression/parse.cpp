#include "polhode/expression/parse.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/library_functions.hpp"

namespace polhode {
namespace {

using text_place = std::string_view::const_iterator;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Behind the number that starts there: digits, a point, an exponent.
text_place end_of_number(text_place at, text_place end) {
  const auto digits = [&](text_place from) { return std::find_if_not(from, end, is_digit); };
  at = digits(at);
  if (at != end && *at == '.') at = digits(at + 1);
  if (at == end || (*at != 'e' && *at != 'E')) return at;
  auto exponent = at + 1;
  if (exponent != end && (*exponent == '+' || *exponent == '-')) ++exponent;
  return exponent != end && is_digit(*exponent) ? digits(exponent) : at;
}

/// The names in a formula, those of functions and constants too.
std::set<std::string> names_in(std::string_view text) {
  std::set<std::string> names;
  const auto is_letter = [](char c) { return is_identifier({&c, 1}); };
  for (auto at = text.begin(); at != text.end();) {
    if (is_digit(*at)) {
      at = end_of_number(at, text.end());
    } else if (!is_letter(*at)) {
      ++at;
    } else {
      const auto end =
          std::find_if(at, text.end(), [&](char c) { return !is_letter(c) && !is_digit(c); });
      names.emplace(at, end);
      at = end;
    }
  }
  return names;
}

}  // namespace

std::vector<formula_definition> in_order_of_need(std::vector<formula_definition> definitions) {
  std::vector<formula_definition> result;
  while (!definitions.empty()) {
    const auto is_ready = [&](const formula_definition& one) {
      const std::set<std::string> needed = names_in(one.second);
      return std::none_of(
          definitions.begin(), definitions.end(),
          [&](const formula_definition& other) { return needed.contains(other.first); });
    };
    const auto next = std::find_if(definitions.begin(), definitions.end(), is_ready);
    if (next == definitions.end()) {
      std::string names;
      for (const formula_definition& one : definitions) {
        names += (names.empty() ? "" : ", ") + one.first;
      }
      throw input_error(definitions.size() == 1
                            ? fmt::format("the value of {} needs {} itself", names, names)
                            : fmt::format("the values of {} need each other", names));
    }
    result.push_back(std::move(*next));
    definitions.erase(next);
  }
  return result;
}

expression parse(std::string_view text, const std::vector<std::string>& variables,
                 const std::vector<formula_definition>& definitions) {
  return expression(text, {variables, in_order_of_need(definitions), library_functions()});
}

expression parse_equation(std::string_view text, const std::vector<std::string>& variables,
                          const std::vector<formula_definition>& definitions) {
  const std::size_t at = text.find('=');
  if (at == std::string_view::npos) return parse(text, variables, definitions);
  const std::string_view left = text.substr(0, at);
  const std::string_view right = text.substr(at + 1);
  for (const std::string_view side : {left, right}) {
    if (side.find_first_not_of(" \t\n") == std::string_view::npos ||
        side.find('=') != std::string_view::npos) {
      throw input_error("an equation has one \"=\" between two formulas");
    }
    (void)parse(side, variables, definitions);
  }
  return parse(fmt::format("({})-({})", left, right), variables, definitions);
}

std::string variable_of(std::string_view text, const std::vector<formula_definition>& definitions) {
  std::set<std::string> names = names_in(text);
  std::string usual = "x";
  if (names.contains(usual)) return usual;
  for (const expression_function& f : expression_functions()) names.erase(f.name);
  for (const expression_constant& c : expression_constants()) names.erase(c.name);
  for (const expression_alias& a : expression_aliases()) names.erase(a.name);
  for (const further_function& f : *library_functions()) names.erase(f.what.name);
  for (const formula_definition& d : definitions) names.erase(d.first);
  names.erase("i");
  return names.size() == 1 ? *names.begin() : usual;
}

}  // namespace polhode
