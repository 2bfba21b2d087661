#include "expression/exact/terms.hpp"

namespace polhode::detail::exact_parts {

rational content(const exact_sum& x) {
  integer above = 0;
  integer below = 1;
  for (const auto& [m, c] : x) {
    above = gcd(above, numerator(c));
    below = lcm(below, denominator(c));
  }
  return rational(above) / rational(below);
}

monomial merged(const monomial& x, const monomial& y) {
  monomial result;
  result.reserve(x.size() + y.size());
  auto i = x.begin();
  auto j = y.begin();
  while (i != x.end() || j != y.end()) {
    if (j == y.end() || (i != x.end() && i->first < j->first)) {
      result.push_back(*i++);
    } else if (i == x.end() || j->first < i->first) {
      result.push_back(*j++);
    } else {
      const rational exponent = i->second + j->second;
      if (exponent != 0) result.emplace_back(i->first, exponent);
      ++i;
      ++j;
    }
  }
  return result;
}

std::optional<rational> plain_number(const exact_sum& x) {
  if (x.empty()) return rational(0);
  if (x.size() == 1 && x.begin()->first.empty()) return x.begin()->second;
  return std::nullopt;
}

rational exponent_in(const monomial& m, generator_id g) {
  for (const auto& [id, exponent] : m) {
    if (id == g) return exponent;
  }
  return 0;
}

monomial without(monomial m, generator_id g) {
  std::erase_if(m, [g](const auto& part) { return part.first == g; });
  return m;
}

}  // namespace polhode::detail::exact_parts
