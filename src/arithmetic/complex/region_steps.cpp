// Functions of regions that are analytic on each side of their kinks and jumps: a set that meets
// one is blocked.

#include <utility>

#include "arithmetic/complex/region_shapes.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode {

region abs(const region& z) {
  if (!z.is_analytic()) return z;
  switch (region::functions::sign_of_real_part(z)) {
    case 1:
      return z;
    case -1:
      return -z;
    default:
      return region::blocked(obstacle::kink, "abs");
  }
}

region min(const region& z, const region& w) {
  region difference = z - w;
  if (!difference.is_analytic()) return difference;
  const int sign = region::functions::sign_of_real_part(difference);
  if (sign == 0) return region::blocked(obstacle::kink, "min");
  return sign < 0 ? z : w;
}

region max(const region& z, const region& w) {
  region difference = z - w;
  if (!difference.is_analytic()) return difference;
  const int sign = region::functions::sign_of_real_part(difference);
  if (sign == 0) return region::blocked(obstacle::kink, "max");
  return sign > 0 ? z : w;
}

region floor(const region& z) {
  return region::functions::step(z, "floor", [](const ball& x) { return floor(x); });
}
region ceil(const region& z) {
  return region::functions::step(z, "ceil", [](const ball& x) { return ceil(x); });
}

}  // namespace polhode
