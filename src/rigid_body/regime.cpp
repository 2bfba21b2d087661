#include "polhode/rigid_body/regime.hpp"

namespace polhode {

regime regime_of(const body& rigid, const rational& c) {
  const rational least(-rigid.b());
  if (c < least || c > rigid.a()) {
    throw input_error("c = " + to_text(c) + ": it must be from -b = " + to_text(least) +
                      " to a = " + to_text(rigid.a()));
  }
  if (c == least) return regime::equilibrium_x;
  if (c == rigid.a()) return regime::equilibrium_z;
  if (c == 0) return regime::separatrix;
  return c < 0 ? regime::oscillating : regime::rotating;
}

std::string to_text(regime r) {
  switch (r) {
    case regime::equilibrium_x:
      return "equilibrium about x";
    case regime::oscillating:
      return "oscillating";
    case regime::separatrix:
      return "separatrix";
    case regime::rotating:
      return "rotating";
    case regime::equilibrium_z:
      break;
  }
  return "equilibrium about z";
}

}  // namespace polhode
