#include "periods.hpp"

#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "quadrature/formula/formula_graph.hpp"
#include "quadrature/formula/symmetry.hpp"

namespace polhode::detail {

namespace {

constexpr precision search_bits = 384;

std::size_t length_of(const rational& q) {
  return mpz_sizeinbase(numerator(q).backend().data(), 2) +
         mpz_sizeinbase(denominator(q).backend().data(), 2);
}

/// The rational number that x seems to be: one much shorter than x. To search with.
std::optional<rational> short_rational(const ball& x) {
  if (!x.is_bounded() || contains_zero(x)) return std::nullopt;
  const rational q = simplest_between(lower_rational(x), upper_rational(x));
  constexpr std::size_t most_length = 300;
  return length_of(q) <= most_length ? std::optional(q) : std::nullopt;
}

/// Of sin, cos or tan of an argument with this slope.
std::optional<pi_combination> period_of_slope(operation rule, const ball& slope) {
  if (rule == operation::sinpi || rule == operation::cospi) {
    const auto q = short_rational(slope);
    return q ? std::optional(pi_combination{abs(2 / *q), 0}) : std::nullopt;
  }
  if (const auto q = short_rational(slope)) return pi_combination{0, abs(2 / *q)};
  if (const auto q = short_rational(slope / pi(search_bits))) return pi_combination{abs(2 / *q), 0};
  return std::nullopt;
}

/// The period that all circular functions in it would have if their arguments were affine. To
/// search with.
std::optional<pi_combination> period_to_try(const formula_graph& f) {
  std::size_t last = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (f.node(i).is_circular()) last = i + 1;
  }
  if (last == 0) return std::nullopt;
  const slope_jet x = slope_jet::variable(ball(0, search_bits));
  const auto values = evaluate(f, search_bits, x, choices(f.size()), last - 1);
  std::optional<pi_combination> common;
  for (std::size_t i = 0; i < last; ++i) {
    if (!f.node(i).is_circular()) continue;
    const ball& slope = values[f.node(i).left][1];
    if (slope.is_bounded() && sign_of(slope) == certain_sign::zero) continue;  // of a constant
    const auto own = period_of_slope(f.node(i).what, slope);
    if (!own) return std::nullopt;
    common = common ? common_period(*common, *own) : own;
    if (!common) return std::nullopt;
  }
  return common;
}

/// The greatest whole number that is certainly not above the length of the range in periods.
std::optional<integer> whole_count(const end_point& a, const end_point& b,
                                   const pi_combination& period) {
  for (precision p = 128; p <= 65536; p *= 2) {
    const ball quotient = (b.at(p) - a.at(p)) / period.at(p);
    if (!quotient.is_bounded()) return std::nullopt;
    const rational low = lower_rational(quotient);
    if (upper_rational(quotient) - low > rational(1, 1024)) continue;
    return floor_of(low);
  }
  return std::nullopt;
}

/// x + n period.
end_point moved(const end_point& x, const pi_combination& period, const integer& n) {
  const pi_combination by = period * rational(n);
  if (x.form()) return end_point(*x.form() + by);
  const auto more = static_cast<precision>(mpz_sizeinbase(n.backend().data(), 2)) + 64;
  return end_point([=](precision p) { return x.at(p + more) + by.at(p + more); });
}

}  // namespace

namespace {

std::optional<pi_combination> proved_period(const integrand& f) {
  if (!f.graph || !f.under) return std::nullopt;
  std::optional<pi_combination> period = period_to_try(*f.graph());
  if (!period || !f.under(symmetry::translation(*period)).is_invariant()) return std::nullopt;
  return period;
}

}  // namespace

std::optional<whole_periods> whole_periods_of(const integrand& f, const end_point& a,
                                              const end_point& b) {
  constexpr long least = 64;
  if (a.is_infinite() || b.is_infinite()) return std::nullopt;
  const std::optional<pi_combination> period = proved_period(f);
  if (!period) return std::nullopt;
  std::optional<integer> count = whole_count(a, b, *period);
  if (!count || *count < least) return std::nullopt;
  if (a.form() && b.form()) {
    // Where the range is whole periods, the count from a ball may be less by one.
    for (const integer& n : {*count, integer(*count + 1)}) {
      if (*b.form() - *a.form() == *period * rational(n)) {
        return whole_periods{n, moved(a, *period, 1), std::nullopt};
      }
    }
  }
  return whole_periods{*count, moved(a, *period, 1), moved(b, *period, integer(-*count))};
}

}  // namespace polhode::detail

namespace polhode {

std::optional<pi_combination> period_of(const expression& f) {
  return detail::proved_period(integrand_of(f));
}

}  // namespace polhode
