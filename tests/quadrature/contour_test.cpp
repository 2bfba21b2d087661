// Integrals along paths in the complex plane.

#include <gtest/gtest.h>

#include "polhode/quadrature/contour.hpp"

namespace polhode {
namespace {
TEST(Contour, First) {
  const auto f = [](const auto& z) { return exp(z) / pow(z, 3); };
  const contour_integral i = integrate_along(f, path::circle(0, 1), {.digits = 50});
  std::cout << to_text(i.verdict) << i.obstacle << to_decimal(i.enclosure, 50) << ' '
            << i.account.panels << ' ' << i.account.most_nodes << '\n';
}
}  // namespace
}  // namespace polhode
