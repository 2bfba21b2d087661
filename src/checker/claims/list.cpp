#include "list.hpp"

#include <algorithm>
#include <array>

namespace polhode::checker {

const claim* find_claim(std::string_view name) {
#define POLHODE_CHECKER_ROW(name, subject) name##_claim(),
  static const std::array claims{POLHODE_CLAIMS(POLHODE_CHECKER_ROW)};
#undef POLHODE_CHECKER_ROW
  const auto* const found =
      std::find_if(claims.begin(), claims.end(), [&](const claim& c) { return c.name == name; });
  return found == claims.end() ? nullptr : &*found;
}

}  // namespace polhode::checker
