#include <utility>

#include "parts_by_variable.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "quadrature/formula/formula_graph.hpp"

namespace polhode::detail {

namespace {

class in_exponential {
 public:
  explicit in_exponential(const formula_range& of)
      : f_(of.f), a_(of.a), b_(of.b), plain_(of.plain) {}

  /// y = e^(slope x + offset), of which the functions in the formula have integer powers.
  bool add(std::size_t node, hyperexponential_integrals& result) const {
    std::optional<affine> base;
    const std::vector<bool> is_part = parts_of_node(f_, node);
    for (std::size_t i = 0; i <= node; ++i) {
      if (!is_part[i] || !f_.node(i).is_exponential()) continue;
      const auto w = affine_of((*plain_)[f_.node(i).left]);
      if (!w) continue;
      if (!base) {
        base = w;
        continue;
      }
      const rational ratio = w->slope / base->slope;
      if (w->offset != ratio * base->offset) return false;
      // The greatest number of which 1 and the ratio are multiples.
      const rational unit(integer(1), denominator(ratio));
      base = affine{base->slope * unit, base->offset * unit};
    }
    if (!base) return false;
    if (base->slope < 0) base = affine{-base->slope, -base->offset};
    const auto end = [&](const end_point& x) -> end_point {
      if (x.is_infinite()) return x.infinite_sign() > 0 ? x : 0;
      if (x.exact() && base->slope * *x.exact() + base->offset == 0) return 1;
      return end_point([x, w = *base](precision p) { return exp(x.at(p) * w.slope + w.offset); });
    };
    hyperexponential_integral range;
    range.lower = end(a_);
    range.upper = end(b_);
    range.begins_at_0 = true;
    const ball low = range.lower.at(128);
    const std::optional<rational> found_inside =
        range.upper.is_infinite() ? beyond(low) : between(low, range.upper.at(128));
    if (!found_inside) return false;
    const rational& inside = *found_inside;
    const substitution by{inside, [&](std::size_t i) -> maybe_sum {
                            if (!f_.node(i).is_exponential()) return std::nullopt;
                            const auto w = affine_of((*plain_)[f_.node(i).left]);
                            if (!w) return std::nullopt;
                            return exponential(f_.node(i).what, w->slope / base->slope, inside);
                          }};
    const forms found(f_, node, by);
    if (!found[node]) return false;
    // dx = dy / (slope y)
    append(result, *found[node], product(number(rational(1) / base->slope), power_of_variable(-1)),
           range);
    return true;
  }

 private:
  /// exp, sinh, cosh or tanh of n times log y.
  [[nodiscard]] static maybe_sum exponential(operation rule, const rational& n,
                                             const rational& inside) {
    constexpr long greatest = 1000;
    if (!is_integer(n) || abs(n) > greatest) return std::nullopt;
    const hyperexponential up = power_of_variable(n);
    if (rule == operation::exp) return hyperexponential_sum{up};
    // (y^|n| +- y^-|n|)/2 = (y^(2 |n|) +- 1)/2 * y^-|n|
    const auto size = static_cast<std::size_t>(abs(numerator(n)));
    if (2 * size > static_cast<std::size_t>(greatest_degree)) return std::nullopt;
    const taking_apart apart(inside);
    const auto half_of = [&](long sign) {
      std::vector<rational> c(2 * size + 1);
      c[2 * size] = 1;
      c[0] = sign;
      hyperexponential result = product(apart.of_polynomial(rational_polynomial(std::move(c))),
                                        power_of_variable(rational(-static_cast<long>(size))));
      result.coefficient /= sign < 0 && n < 0 ? -2 : 2;
      return result;
    };
    maybe_sum cosine = hyperexponential_sum{half_of(1)};
    maybe_sum sine = hyperexponential_sum{half_of(-1)};
    if (rule == operation::cosh) return cosine;
    if (rule == operation::sinh) return sine;
    const maybe_sum inverse = apart.raised(*cosine, -1);
    return inverse ? apart.multiplied(*sine, *inverse) : std::nullopt;
  }

  const formula_graph& f_;
  const end_point& a_;
  const end_point& b_;
  const forms* plain_;
};

}  // namespace

bool add_in_exponential(const formula_range& of, std::size_t node,
                        hyperexponential_integrals& result) {
  return in_exponential(of).add(node, result);
}

}  // namespace polhode::detail
