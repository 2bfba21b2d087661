#include "formula_forms.hpp"

#include <algorithm>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "quadrature/formula/formula_graph.hpp"

namespace polhode::detail {

std::vector<bool> parts_of_node(const formula_graph& f, std::size_t node) {
  std::vector<bool> is_part(node + 1);
  is_part[node] = true;
  for (std::size_t k = node + 1; k-- > 0;) {
    if (is_part[k]) f.for_each_operand(f.node(k), [&](std::size_t x) { is_part[x] = true; });
  }
  return is_part;
}

std::optional<affine> affine_of(const maybe_sum& form) {
  if (!form) return std::nullopt;
  const auto p = taking_apart::as_polynomial(*form);
  if (!p || p->degree() != 1) return std::nullopt;
  return affine{p->coefficients()[1], p->coefficients()[0]};
}

std::optional<rational> between(const ball& x, const ball& y) {
  if (certainly_less(x, 1) && certainly_greater(y, 1)) return rational(1);
  const ball next = x + abs(x) + 1;  // near x, where y is far
  const ball middle = (certainly_less(next, y) ? next : (x + y) / 2).middle();
  constexpr long most = 100'000;
  const magnitude size = middle.magnitude_upper();
  if (size.is_infinite() || (!size.is_zero() && std::abs(size.log2_floor()) > most)) {
    return std::nullopt;
  }
  return lower_rational(middle);
}
std::optional<rational> beyond(const ball& x) {
  return certainly_less(x, 1) ? std::optional<rational>(1) : between(x, x * 3 + 1);
}

namespace {

/// p(-y).
rational_polynomial reflected(const rational_polynomial& p) {
  std::vector<rational> c = p.coefficients();
  for (std::size_t k = 1; k < c.size(); k += 2) c[k] = -c[k];
  return rational_polynomial(std::move(c));
}

}  // namespace

substitution argument_itself(const formula_graph& f, int sign, const rational& inside,
                             const forms* plain) {
  const taking_apart apart(inside);
  const auto leaf = [&f, sign, apart, plain](std::size_t i) -> maybe_sum {
    const formula_node& node = f.node(i);
    if (node.is_argument()) {
      return hyperexponential_sum{
          apart.of_polynomial(rational_polynomial({rational(0), rational(sign)}))};
    }
    if (plain == nullptr) return std::nullopt;
    const auto rule = node.what;
    const bool is_exponential = rule == operation::exp;
    const bool is_circular = rule == operation::sin || rule == operation::cos;
    if (!is_exponential && !is_circular && rule != operation::sinh && rule != operation::cosh) {
      return std::nullopt;
    }
    const maybe_sum& form = (*plain)[node.left];
    auto p = form ? taking_apart::as_polynomial(*form) : std::nullopt;
    if (!p) return std::nullopt;
    if (sign < 0) p = reflected(*p);
    if (is_circular) return hyperexponential_sum{with_phase(number(1), *p, rule == operation::sin)};
    hyperexponential up;
    up.exponent = *p;
    if (is_exponential) return hyperexponential_sum{up};
    hyperexponential down;
    down.exponent = *p * rational_polynomial({rational(-1)});
    up.coefficient = rational(1, 2);
    down.coefficient = rational(rule == operation::cosh ? 1 : -1, 2);
    return hyperexponential_sum{up, down};
  };
  return {inside, leaf};
}

}  // namespace polhode::detail
