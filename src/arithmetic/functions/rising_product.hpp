#pragma once

namespace polhode::detail {

/// z (z + 1) ... (z + n - 1), four factors by two products: with u = z (z + 3) they are u (u + 2),
/// and (z + 4)(z + 7) = u + 8 z + 28.
template <class T>
T rising_product(const T& z, long n) {
  constexpr long group = 4;
  T product(ball(1, z.precision()));
  long k = 0;
  if (n >= group) {
    const T eight = scale(z, 3);
    T u = z * (z + 3);
    while (true) {
      product = product * (u * (u + 2));
      k += group;
      if (k + group > n) break;
      u = u + eight + (8 * (k - group) + 28);
    }
  }
  for (; k < n; ++k) product = product * (z + k);
  return product;
}

}  // namespace polhode::detail
