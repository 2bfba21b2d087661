#include "exponential_variable.hpp"

#include <span>
#include <utility>

#include "polhode/expression/symbol.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

namespace {

/// f(x + e), of one variable.
expression shifted(const expression& f, const expression& e) {
  return expression(f(symbol::variable(0) + e.evaluate(std::span<const symbol>())), f.names());
}

}  // namespace

std::optional<substituted> in_exponential_variable(const expression& f, const end_point& a,
                                                   const end_point& b) {
  auto in_u = f.by_exponential();
  if (!in_u) return std::nullopt;
  const ball slope = in_u->slope.value(64);
  if (contains_zero(slope)) return std::nullopt;
  const bool grows = certainly_positive(slope);
  const end_point& greatest = grows ? b : a;
  const end_point& origin = greatest.is_infinite() ? (grows ? a : b) : greatest;
  symbol e(0);
  if (!origin.is_infinite()) {
    const std::optional<expression> at = formula_of(origin);
    if (!at) return std::nullopt;
    e = at->evaluate(std::span<const symbol>());
    in_u = shifted(f, *at).by_exponential();
    if (!in_u) return std::nullopt;
  }
  const auto image = [&](const end_point& x) -> std::optional<end_point> {
    if (x.is_infinite()) return (x.infinite_sign() > 0) == grows ? end_point::infinity() : 0;
    if (&x == &origin) return end_point(1);
    const std::optional<expression> at = formula_of(x);
    if (!at) return std::nullopt;
    const symbol distance = at->evaluate(std::span<const symbol>()) - e;
    const symbol c = in_u->slope.evaluate(std::span<const symbol>());
    return end_point_of(expression(exp(c * distance), {}));
  };
  const auto lower = image(a);
  const auto upper = image(b);
  if (!lower || !upper) return std::nullopt;
  return substituted{integrand_of(in_u->formula), *lower, *upper};
}

}  // namespace polhode::detail
