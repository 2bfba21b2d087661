#include "polhode/quadrature/zero_free_ends.hpp"

#include <mutex>
#include <utility>

#include "polhode/expression/evaluation.hpp"
#include "polhode/expression/symbol.hpp"
#include "quadrature/formula/arithmetics.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode {

struct zero_free_ends::formula {
  explicit formula(expression given) : f(std::move(given)) {}

  expression f;
  std::once_flag is_prepared;
  detail::integrand prepared;
};

namespace zero_free_ends_impl {
namespace {

/// f where its argument is x(t). The evaluator is one of its own for each call, as several threads
/// may ask at a time.
growth_bound growth(const expression& f, const growth_bound& x) {
  return f.evaluator<growth_bound>(192)(x);
}

/// p + s t^q for 0 < t <= 1/4.
growth_bound argument(const pi_combination& p, const rational& s, long q) {
  return growth_bound::argument(known_number(p), known_number(s), q, 0.25);
}

/// |f| >= c t^a with c > 0.
bool has_no_zero(const growth_bound& f) { return !f.is_blocked() && !f.least_factor().is_zero(); }

/// x = p - log(t) with p = from - 3/2, or -x for from < 0, which takes all values beyond `from`: it
/// decreases to p + log(4) < |from| at t = 1/4. There exp(x) is exp(p)/t, so that sums of
/// exponentials are sums of powers.
growth_bound far(const rational& from) {
  const growth_bound t = argument({}, 1, 1);
  const growth_bound x = t.constant_like(rational(abs(from) - rational(3, 2))) - log(t);
  return from > 0 ? x : -x;
}

/// f(at + side exp(-s)) as a formula in s; nothing where that is not available.
std::optional<expression> in_exponential(const expression& f, const pi_combination& at, int side) {
  const symbol x = symbol::variable(0);
  const expression point = *formula_of(end_point(at));
  const symbol end = point.evaluate(std::span<const symbol>());
  try {
    // With the factor |dx/ds| of the substitution it is f again.
    return expression(f(x) / (symbol(side) * (x - end)), f.names()).in_exponential(&point, side);
  } catch (const input_error&) {
    return std::nullopt;  // it has no value anywhere
  }
}

/// f(side exp(s)) as a formula in s; nothing where that is not available.
std::optional<expression> in_logarithm(const expression& f, int side) {
  const symbol x = symbol::variable(0);
  try {
    // With the factor |dx/ds| of the substitution it is f again.
    return expression(f(x) / (symbol(side) * x), f.names()).in_exponential(nullptr, side);
  } catch (const input_error&) {
    return std::nullopt;  // it has no value anywhere
  }
}

/// 1/f by exponentials that decay; nothing where that is not available.
std::optional<expression> reciprocal_by_decay(const expression& f) {
  try {
    return expression(1 / f(symbol::variable(0)), f.names()).with_decaying_exponentials();
  } catch (const input_error&) {
    return std::nullopt;  // it has no value anywhere
  }
}

}  // namespace
}  // namespace zero_free_ends_impl

using namespace zero_free_ends_impl;

zero_free_ends::zero_free_ends(expression f) : formula_(std::make_shared<formula>(std::move(f))) {}

bool zero_free_ends::beside(const pi_combination& at, const rational& width) const {
  const expression& f = formula_->f;
  const growth_bound bound = growth(f, argument(at, 4 * width, 1));
  if (bound.is_nowhere_defined() || has_no_zero(bound)) return true;
  if (f.variables().size() == 1) {
    // The series, in which exact rules know the values at the point, has a sign.
    std::call_once(formula_->is_prepared, [&] { formula_->prepared = integrand_of(f); });
    const end_series x =
        end_series::argument(known_number(at), known_number(rational(4 * width)), 1, 0.25);
    if (formula_->prepared.near_end(x).sign() != 0) return true;
    // |x - at| <= |width| is s >= -log |width|.
    const rational from = lower_rational(-log(ball(rational(abs(width)), 64)));
    const auto in_s = from > 0 ? in_exponential(f, at, width > 0 ? 1 : -1) : std::nullopt;
    if (in_s) {
      const growth_bound beyond = growth(*in_s, argument({}, from / 4, -1));
      if (beyond.is_nowhere_defined() || has_no_zero(beyond)) return true;
    }
  }
  // 1/x is beyond 1/width.
  return at.is_zero() &&
         has_no_zero(growth(f, growth_bound::reciprocal_of(far(rational(1 / width)))));
}

bool zero_free_ends::beyond(const rational& from) const {
  // x = (from/4)/t takes all values beyond `from`, too.
  const expression& f = formula_->f;
  if (has_no_zero(growth(f, argument({}, from / 4, -1))) || has_no_zero(growth(f, far(from)))) {
    return true;
  }
  // Where exponentials grow.
  const auto along = tail_series::argument(known_number(rational(from / 4)), 0.25);
  if (f.evaluator<tail_series>(192)(along).sign() != 0) return true;
  if (f.variables().size() != 1) return false;
  // Where 1/f has values, f is not 0.
  const auto reciprocal = from > 0 ? reciprocal_by_decay(f) : std::nullopt;
  if (reciprocal && !growth(*reciprocal, argument({}, from / 4, -1)).is_blocked()) return true;
  // |x| >= |from| is s >= log |from|, where powers of log |x| are powers of s.
  const rational from_s = lower_rational(log(ball(rational(abs(from)), 64)));
  const auto in_s = from_s > 0 ? in_logarithm(f, from > 0 ? 1 : -1) : std::nullopt;
  return in_s && has_no_zero(growth(*in_s, argument({}, from_s / 4, -1)));
}

}  // namespace polhode
