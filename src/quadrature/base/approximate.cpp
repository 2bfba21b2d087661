#include "approximate.hpp"

#include <algorithm>
#include <cmath>

namespace polhode::detail {

double approximately(const ball& x) {
  mpfr_cell middle(64);
  x.midpoint(middle.get());
  return mpfr_get_d(middle.get(), MPFR_RNDN);
}
double approximately(const rational& q) { return mpq_get_d(q.backend().data()); }
double unit_of(double r, int bits) {
  return r > 0 && std::isfinite(r) ? std::ldexp(1.0, std::ilogb(r) - bits) : 1;
}
rational exact_double(double x) {
  rational q = 0;
  if (!std::isfinite(x)) return q;
  mpq_set_d(q.backend().data(), x);
  return q;
}

std::vector<std::complex<double>> approximate_roots(const rational_polynomial& p) {
  using complex = std::complex<double>;
  const auto n = static_cast<std::size_t>(p.degree());
  std::vector<complex> c;
  for (const rational& x : p.coefficients()) {
    c.emplace_back(approximately(rational(x / p.leading())));
  }
  if (n == 1) return {-c[0]};
  if (n == 2) {
    const complex root = std::sqrt(c[1] * c[1] - 4.0 * c[0]);
    const complex larger = (std::real(c[1]) > 0 ? -c[1] - root : -c[1] + root) / 2.0;
    return {larger, larger == 0.0 ? 0.0 : c[0] / larger};
  }
  double bound = 0;  // Fujiwara's
  for (std::size_t k = 0; k < n; ++k) {
    bound = std::max(bound, std::pow(std::abs(c[k]), 1.0 / static_cast<double>(n - k)));
  }
  std::vector<complex> roots;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = 6.2831853 * static_cast<double>(k) / static_cast<double>(n) + 0.7;
    const double size = bound * (0.5 + 0.5 * static_cast<double>(k + 1) / static_cast<double>(n));
    roots.emplace_back(size * std::cos(angle), size * std::sin(angle));
  }
  for (int step = 0; step < 100; ++step) {
    double moved = 0;
    for (std::size_t k = 0; k < n; ++k) {
      complex value = 0;
      complex slope = 0;
      for (std::size_t j = n + 1; j-- > 0;) {
        slope = slope * roots[k] + value;
        value = value * roots[k] + c[j];
      }
      if (value == 0.0) continue;
      complex others = 0;
      for (std::size_t j = 0; j < n; ++j) {
        if (j != k && roots[j] != roots[k]) others += 1.0 / (roots[k] - roots[j]);
      }
      const complex newton = value / slope;
      const complex change = newton / (1.0 - newton * others);
      if (!std::isfinite(std::abs(change))) continue;
      roots[k] -= change;
      moved = std::max(moved, std::abs(change) / (std::abs(roots[k]) + 1e-300));
    }
    if (moved < 1e-12) break;
  }
  return roots;
}

}  // namespace polhode::detail
