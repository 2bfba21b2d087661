#include "polhode/arithmetic/gamma_quotients.hpp"

#include <optional>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/special_functions.hpp"

namespace polhode {
namespace {

using series = jet<ball, 1>;

/// y = x + n, P = x (x+1) ... (x+n-1) and its derivative in x, and 1/Gamma(y).
struct shifted {
  series y;
  series product;
  series slope;
  series inverse;
};

/// With y > 1/2. None where that takes many factors.
std::optional<shifted> shifted_up(const series& x) {
  constexpr long most_factors = 1000;
  if (!x[0].is_bounded() || certainly_less(x[0], ball(-most_factors, 64))) return std::nullopt;
  const auto number = [&](long n) { return series::constant(ball(n, x[0].precision())); };
  shifted r{x, number(1), number(0), number(0)};
  for (long factors = 0; !certainly_positive(r.y[0] - rational(1, 2)); ++factors) {
    if (factors == most_factors) return std::nullopt;
    r.slope = r.slope * r.y + r.product;
    r.product *= r.y;
    r.y += number(1);
  }
  r.inverse[0] = 1 / gamma(r.y[0]);
  r.inverse[1] = -r.inverse[0] * digamma(r.y[0]) * r.y[1];
  return r;
}

series undefined_like(const series& x) {
  return detail::value_alone<1>(ball::undefined(x[0].precision()), 1);
}

}  // namespace

series reciprocal_gamma(const series& x) {
  if (!x[0].is_bounded() && certainly_positive(x[0])) {
    return detail::value_alone<1>(1 / gamma(x[0]), 1);
  }
  const auto up = shifted_up(x);
  return up ? up->product * up->inverse : undefined_like(x);
}

series digamma_over_gamma(const series& x, const std::function<ball(const ball&)>& trigamma) {
  const auto up = shifted_up(x);
  if (!up) return undefined_like(x);
  series psi;
  psi[0] = digamma(up->y[0]);
  psi[1] = trigamma(up->y[0]) * up->y[1];
  return (up->product * psi - up->slope) * up->inverse;
}

}  // namespace polhode
