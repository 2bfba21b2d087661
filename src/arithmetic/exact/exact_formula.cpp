#include "polhode/arithmetic/exact_formula.hpp"

namespace polhode {

exact_formula::pointer exact_formula::of(const pi_combination& x) {
  return std::make_shared<const exact_formula>(exact_formula{{}, {}, x, 1});
}

exact_formula::pointer exact_formula::of(std::string_view function, std::vector<pointer> operands) {
  std::size_t size = 1;
  for (const pointer& x : operands) {
    if (x == nullptr) return nullptr;
    size += x->size;
  }
  if (size > longest) return nullptr;
  return std::make_shared<const exact_formula>(
      exact_formula{function, std::move(operands), {}, size});
}

}  // namespace polhode
