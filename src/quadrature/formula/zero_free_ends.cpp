#include "polhode/quadrature/zero_free_ends.hpp"

#include <utility>

#include "base/on_first_use.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/expression/evaluation.hpp"
#include "polhode/expression/symbol.hpp"
#include "quadrature/formula/arithmetics.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode {

struct zero_free_ends::formula {
  explicit formula(expression given) : f(std::move(given)) {}

  expression f;
  detail::on_first_use<detail::integrand> prepared;
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

/// |f| >= c t^a with c > 0, and f is defined.
bool has_no_zero(const growth_bound& f) { return !f.is_unknown() && !f.least_factor().is_zero(); }

/// x = p - log(t) with p = from - 3/2, or -x for from < 0, which takes all values beyond `from`: it
/// decreases to p + log(4) < |from| at t = 1/4. There exp(x) is exp(p)/t, so that sums of
/// exponentials are sums of powers.
growth_bound far(const rational& from) {
  const growth_bound t = argument({}, 1, 1);
  const growth_bound x = t.constant_like(rational(abs(from) - rational(3, 2))) - log(t);
  return from > 0 ? x : -x;
}

/// f at x = (from/4)/t, which takes all values beyond `from`.
growth_bound growth_beyond(const expression& f, const rational& from) {
  return growth(f, argument({}, from / 4, -1));
}
/// The same where exponentials grow, at x = s/t^root; the root makes whole powers of t of broken
/// powers of x.
tail_series tail_beyond(const expression& f, const rational& from) {
  tail_series tail;
  for (const unsigned root : {1U, 2U, 3U, 6U}) {
    const rational s = from / rational(integer(1) << (2 * root));
    const auto along = tail_series::argument(known_number(s), 0.25, end_series::most_orders, root);
    tail = f.evaluator<tail_series>(192)(along);
    if (!tail.is_blocked()) break;
  }
  return tail;
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
    const detail::integrand& prepared = formula_->prepared.made_by([&] { return integrand_of(f); });
    const end_series x =
        end_series::argument(known_number(at), known_number(rational(4 * width)), 1, 0.25);
    if (prepared.near_end(x).sign() != 0) return true;
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

namespace zero_free_ends_impl {
namespace {

/// All x >= from, or x <= from where from is negative.
ball all_beyond(const rational& from) {
  constexpr precision p = 128;
  const ball end(from, p);
  mpfr_float unbounded = zero_of_precision(p);
  mpfr_set_inf(unbounded.backend().data(), from > 0 ? 1 : -1);
  return from > 0 ? from_end_points(lower(end), unbounded, p)
                  : from_end_points(unbounded, upper(end), p);
}

/// A sign that f has over all of x, where the evaluation over a ball shows it; else 0.
int sign_over(const expression& f, const ball& x) {
  const ball values = f.evaluator<ball>(x.precision())(x);
  return certainly_positive(values) ? 1 : certainly_negative(values) ? -1 : 0;
}

/// The sign of f at all x >= from, or x <= from where from is negative, by growth in x; else 0.
int sign_by_growth(const expression& f, const rational& from) {
  for (const growth_bound& v : {growth_beyond(f, from), growth(f, far(from))}) {
    if (has_no_zero(v) && v.sign() != 0) return v.sign();
  }
  return tail_beyond(f, from).sign();
}

/// f in s = log |x|, with powers of s for those of log |x|, and a number that is at most
/// log |from|.
struct in_logarithm_beyond {
  expression f;
  rational from;
};
std::optional<in_logarithm_beyond> in_logarithm(const expression& f, const rational& from) {
  if (f.variables().size() != 1) return std::nullopt;
  const rational from_s = lower_rational(log(ball(rational(abs(from)), 64)));
  const auto in_s = from_s > 0 ? in_logarithm(f, from > 0 ? 1 : -1) : std::nullopt;
  return in_s ? std::optional<in_logarithm_beyond>({*in_s, from_s}) : std::nullopt;
}

/// Proved: f has one sign at all x >= from, or x <= from where from is negative, and |f| >= c there
/// for some c > 0.
bool is_away_from_zero(const expression& f, const rational& from) {
  if (sign_over(f, all_beyond(from)) != 0) return true;
  // t^a >= 1 for a <= 0.
  const auto is_not_small = [](const growth_bound& v) {
    return has_no_zero(v) && v.sign() != 0 && v.least_exponent() <= 0;
  };
  if (is_not_small(growth_beyond(f, from)) || is_not_small(growth(f, far(from)))) return true;
  // |f| >= e^phi |h| u with u > 0, which is continuous for t > 0, has no zero there, and is
  // unbounded at t = 0.
  return tail_beyond(f, from).tends_to_infinity();
}

/// Proved: f(x) = F(x, x) with an F(x, w) of a period in w (expression::unwound) that is away from
/// 0 for all x and for the w in an interval. Then the integrals over these intervals of x, one in
/// each period, have one sign and do not tend to 0: that over x >= from diverges.
bool is_wave_away_from_zero(const expression& f, const rational& from) {
  constexpr precision p = 64;
  if (f.variables().size() != 1) return false;
  const expression outward = from > 0 ? f : expression(f(-symbol::variable(0)), f.names());
  const rational start = abs(from);
  const ball unknown = hull(ball(-1, p), ball(1, p));
  const auto waves = outward.by_waves([&](const expression& u) {
    const std::vector<ball> sets(u.variables().size() - 1, unknown);
    return zero_free_ends(u.with_sets(sets)).sign_beyond(start);
  });
  const expression& g = waves ? *waves : outward;
  for (const expression::unwound& turning : g.unwound_angles()) {
    const bool is_of_x = turning.angle.operation_count() == 0 &&
                         turning.angle.used_variables().front() == f.variables().front();
    if (!is_of_x) continue;
    std::vector<ball> sets(g.variables().size() - 1, unknown);
    sets.push_back(unknown);
    constexpr long places = 8;
    const ball period = turning.period.at(p);
    for (long k = 0; k < places; ++k) {
      sets.back() =
          hull(period * rational(3 * k + 1, 3 * places), period * rational(3 * k + 2, 3 * places));
      if (is_away_from_zero(turning.of_angle.with_sets(sets), start)) return true;
    }
  }
  return false;
}

}  // namespace
}  // namespace zero_free_ends_impl

bool zero_free_ends::beyond(const rational& from) const {
  const expression& f = formula_->f;
  if (has_no_zero(growth_beyond(f, from)) || has_no_zero(growth(f, far(from))) ||
      tail_beyond(f, from).sign() != 0) {
    return true;
  }
  const auto in_s = in_logarithm(f, from);
  return in_s && has_no_zero(growth_beyond(in_s->f, in_s->from));
}

bool zero_free_ends::diverges_beyond(const rational& from) const {
  const expression& f = formula_->f;
  if (is_away_from_zero(f, from) || is_wave_away_from_zero(f, from)) return true;
  // With one sign and |f| >= c t^a, x = (from/4)/t: the integral of c t^a over x diverges for a <=
  // 1.
  const growth_bound bound = growth_beyond(f, from);
  return has_no_zero(bound) && bound.sign() != 0 && bound.least_exponent() <= 1;
}

namespace zero_free_ends_impl {
namespace {

/// The sign of f where |f| >= c t^a with c > 0 and a < 0 shows that f is unbounded, in x; else 0.
int infinite_limit_by_growth(const expression& f, const rational& from) {
  for (const growth_bound& v : {growth_beyond(f, from), growth(f, far(from))}) {
    if (has_no_zero(v) && v.least_exponent() < 0) return v.sign();
  }
  const tail_series tail = tail_beyond(f, from);
  return tail.tends_to_infinity() ? tail.sign() : 0;
}

}  // namespace
}  // namespace zero_free_ends_impl

int zero_free_ends::infinite_limit_beyond(const rational& from) const {
  const expression& f = formula_->f;
  if (const int sign = infinite_limit_by_growth(f, from); sign != 0) return sign;
  const auto in_s = in_logarithm(f, from);
  return in_s ? infinite_limit_by_growth(in_s->f, in_s->from) : 0;
}

int zero_free_ends::sign_beyond(const rational& from) const {
  const expression& f = formula_->f;
  if (const int sign = sign_over(f, all_beyond(from)); sign != 0) return sign;
  if (const int sign = sign_by_growth(f, from); sign != 0) return sign;
  const auto in_s = in_logarithm(f, from);
  return in_s ? sign_by_growth(in_s->f, in_s->from) : 0;
}

}  // namespace polhode
