#include "calls.hpp"

#include <cctype>
#include <map>
#include <optional>
#include <string>

namespace polhode::detail {

namespace {

std::string in_words(const pi_combination& x) {
  if (x.r == 0) return brief(x.q);
  const std::string multiple = x.r == 1 ? "pi" : (x.r == -1 ? "-pi" : brief(x.r) + "*pi");
  return x.q == 0 ? multiple : brief(x.q) + " + " + multiple;
}

bool occurs_in(const std::string& formula, const std::string& name) {
  const auto is_letter = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  for (std::size_t at = formula.find(name); at != std::string::npos;
       at = formula.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_letter(formula[at - 1])) &&
        (end == formula.size() || !is_letter(formula[end]))) {
      return true;
    }
  }
  return false;
}

/// What a simpler formula leaves out must be a rational number, for which the domain has been
/// decided, or, as the first argument, q + r pi: of another nobody would see that it is not in the
/// domain, or not defined.
bool keeps(const std::string& formula, const std::vector<std::string>& names,
           const std::vector<std::optional<pi_combination>>& known) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (known[i] && (i == 0 || known[i]->is_rational())) continue;
    if (!occurs_in(formula, names[i])) return false;
  }
  return true;
}

}  // namespace

node_id call_further(graph& g, const further_function& f, const std::vector<node_id>& operands) {
  const std::vector<std::string> names = argument_names(f.what);
  std::vector<std::optional<pi_combination>> known;
  std::string text;
  for (const node_id x : operands) {
    known.push_back(known_value(g, x));
    text += (text.empty() ? "" : ", ") +
            (known.back() ? in_words(*known.back()) : names[known.size() - 1]);
  }
  if (f.may_be_defined && !f.may_be_defined(known)) {
    throw undefined_operation(f.what.name + "(" + text + ") is not defined: it needs " +
                              f.what.domain);
  }
  if (f.simpler) {
    if (const auto formula = f.simpler(known); formula && keeps(*formula, names, known)) {
      std::map<std::string, node_id, std::less<>> by_name;
      for (std::size_t i = 0; i < names.size(); ++i) by_name[names[i]] = operands[i];
      return read_expression(g, *formula, by_name);
    }
  }
  return g.call({&f, operands});
}

}  // namespace polhode::detail
