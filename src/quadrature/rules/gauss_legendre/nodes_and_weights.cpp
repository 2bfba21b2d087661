#include "quadrature/rules/gauss_legendre/nodes_and_weights.hpp"

#include <utility>

#include <gmp.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "quadrature/rules/gauss_legendre/polynomial.hpp"
#include "quadrature/rules/gauss_legendre/zero_finder.hpp"

namespace polhode::detail::legendre {

std::optional<ball> with_radius(const ball& x, precision bits, bool relative) {
  if (!x.is_bounded()) return std::nullopt;
  const ball shorter = x.with_precision(bits);
  mpfr_cell cell(bits);
  shorter.midpoint(cell.get());
  if (mpfr_regular_p(cell.get()) == 0) return std::nullopt;
  const long exponent = relative ? mpfr_get_exp(cell.get()) - bits : -bits;
  const magnitude radius = magnitude::power_of_two(exponent);
  if (shorter.radius() > radius) return std::nullopt;
  return ball::from_midpoint_radius(cell.get(), radius);
}

/// The weight of a node x is 2 / ((1 - x^2) P_n'(x)^2). With y = x^2: P_n' = 2x q' for even n, and
/// 2 x^2 q' for odd n, where q = 0. So it is 2 / (4y (1-y) q'^2), and divided by y once more for
/// odd n. At the node 0 of an odd n P_n' = q(0).
std::optional<gauss_legendre_rule> rule_with(long n, precision bits, precision bits_at_work,
                                             const std::vector<std::uint64_t>& starts) {
  const legendre_shape s(n);
  gauss_legendre_rule rule{n, bits, {}, {}};
  rule.nodes.reserve(starts.size() + 1);
  rule.weights.reserve(starts.size() + 1);
  const auto append = [&](const ball& node, const ball& weight) {
    auto x = with_radius(node, bits, false);
    auto w = with_radius(weight, bits, true);
    if (!x || !w) return false;
    rule.nodes.push_back(std::move(*x));
    rule.weights.push_back(std::move(*w));
    return true;
  };
  if (s.odd != 0) {
    // q(0), in rationals: C(n, m) C(n + 1, n) / 2^n, m = (n-1)/2, but for its sign.
    integer a;
    mpz_bin_uiui(a.backend().data(), static_cast<unsigned long>(n),
                 static_cast<unsigned long>(s.degree));
    const ball slope = scale(ball(a, bits_at_work) * (n + 1), -n);
    auto w = with_radius(2 / square(slope), bits, true);
    if (!w) return std::nullopt;
    rule.nodes.emplace_back(0, bits);
    rule.weights.push_back(std::move(*w));
  }
  for (const auto& found : zero_finder(s, bits_at_work).near(starts)) {
    if (!found) return std::nullopt;
    const ball& y = found->square;
    const ball complement = 1 - y;
    ball denominator = scale(y * complement * square(found->slope), 1);
    if (s.odd != 0) denominator *= y;
    const ball node = sqrt(y);
    if (!certainly_positive(y) || !certainly_positive(complement)) return std::nullopt;
    constexpr precision exactly = 256;  // of a product of four limbs
    const ball numerator = square(found->scale.with_precision(exactly));
    if (!append(node, numerator / denominator)) return std::nullopt;
    // The enclosures in the rule contain those of the zeros.
    const std::size_t count = rule.nodes.size();
    if (count > 1 && !certainly_positive(rule.nodes[count - 1] - rule.nodes[count - 2])) {
      return std::nullopt;
    }
  }
  return rule;
}

}  // namespace polhode::detail::legendre
