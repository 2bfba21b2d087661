#include "polhode/roots/isolate.hpp"

#include <algorithm>
#include <functional>

#include "search/answer.hpp"
#include "search/range.hpp"
#include "search/searcher.hpp"
#include "search/state.hpp"
#include "thread_count.hpp"
#include "zero_intervals.hpp"

namespace polhode {

namespace {

/// The parts of a bounded range in which numbers are of about one size, the rightmost first:
/// halving a range of 10^300 takes a thousand steps to what is about 1.
std::vector<detail::exact_box> by_scale(const detail::exact_box& range) {
  if (!range.is_bounded()) return {range};
  const rational growth(integer(1) << 24U);
  std::vector<rational> cuts;
  const auto add_cuts = [&](const rational& end, const rational& other) {
    for (rational cut = growth; cut < abs(end); cut *= growth) {
      const rational at = end < 0 ? rational(-cut) : cut;
      if (end < 0 ? at < other : at > other) cuts.push_back(at);
    }
  };
  add_cuts(*range.lower, *range.upper);
  add_cuts(*range.upper, *range.lower);
  std::sort(cuts.begin(), cuts.end(), std::greater<>());
  std::vector<detail::exact_box> result;
  rational upper = *range.upper;
  for (const rational& cut : cuts) {
    result.push_back({cut, upper});
    upper = cut;
  }
  result.push_back({*range.lower, upper});
  return result;
}

/// Whether f is seen to be 0 everywhere, as the derivative of a constant: sin(x)^2 + cos(x)^2 - 1.
bool is_zero_everywhere(const real_function& f) {
  const expression* const formula = f.formula();
  if (formula == nullptr || formula->variables().size() != 1) return false;
  constexpr precision p = 128;
  const ball value = f.at(p)->value(ball(rational(5, 7), p));  // one value other than 0 refutes it
  if (value.is_undefined() || !contains_zero(value)) return false;
  const auto antiderivative = formula->entire_antiderivative();
  return antiderivative && antiderivative->exact_value();
}

/// n/d without common factors, and a polynomial without multiple roots whose roots are those of
/// all divisors.
struct in_lowest_terms {
  explicit in_lowest_terms(const rational_quotient& q) : undefined({rational(1)}) {
    rational_polynomial d({rational(1)});
    for (const repeated_factor& divisor : q.divisors) {
      for (long k = 0; k < divisor.multiplicity; ++k) d = d * divisor.factor;
      const rational_polynomial once =
          divide(divisor.factor, gcd(divisor.factor, divisor.factor.derivative())).first;
      undefined = undefined * divide(once, gcd(once, undefined)).first;
    }
    const rational_polynomial common = gcd(q.numerator, d);
    above = divide(q.numerator, common).first;
    below = divide(d, common).first;
  }
  rational_polynomial above;
  rational_polynomial below;
  rational_polynomial undefined;
};

}  // namespace

root_search::root_search(const real_function& f, const end_point& lower, const end_point& upper) {
  auto s = std::make_shared<state>();
  s->f = std::make_shared<real_function>(f);
  s->lower = lower;
  s->upper = upper;
  const detail::exact_box range = detail::range_around(lower, upper);
  const auto add_factor = [&](const rational_polynomial& factor, long multiplicity,
                              std::optional<long> pole_order = std::nullopt) {
    if (factor.degree() < 1) return;
    s->pending.push_back({range, 0, detail::first_bits, s->problems.size(), {}});
    s->settled.emplace_back(range);
    s->problems.push_back({std::make_shared<real_function>(real_function::of(factor)), multiplicity,
                           true, pole_order});
  };
  const rational_quotient* const q = f.quotient().get();
  s->identically_zero =
      q == nullptr ? is_zero_everywhere(f) : q->numerator.is_zero() && q->divisors.empty();
  if (s->identically_zero) {
    // Nothing is searched.
  } else if (q == nullptr || q->numerator.is_zero()) {
    s->problems.push_back({s->f, 1, false});
    s->settled.emplace_back(range);
    for (detail::exact_box& part : by_scale(range)) {
      s->pending.push_back({std::move(part), 0, detail::first_bits, 0, {}});
    }
  } else {
    const in_lowest_terms g(*q);
    for (const repeated_factor& factor : square_free_decomposition(g.above)) {
      add_factor(divide(factor.factor, gcd(factor.factor, g.undefined)).first, factor.multiplicity);
    }
    for (const repeated_factor& factor : square_free_decomposition(g.below)) {
      add_factor(factor.factor, 1, factor.multiplicity);
    }
    add_factor(divide(g.undefined, gcd(g.undefined, g.below)).first, 1, 0);
  }
  state_ = std::move(s);
}

void root_search::run(const isolate_options& options) {
  detail::require_threads("isolate_roots", options.threads);
  auto next = std::make_shared<state>(*state_);
  detail::search(*next, options);
  state_ = std::move(next);
}

bool root_search::is_finished() const { return state_->pending.empty() && state_->concluded; }

bool root_set::is_resolved() const {
  return complete && std::all_of(regions.begin(), regions.end(), [](const root_region& r) {
           const bool is_settled =
               is_one_root(r.verdict) || r.verdict == root_verdict::infinitely_many;
           return is_settled && !r.may_lie_outside;
         });
}

root_set root_search::result() const {
  detail::expect_whole(*state_);
  return detail::answer_of(*state_);
}

namespace {

/// One period in the interval, from its lower end, or else from 0, or up to its upper end.
searched_period period_within(const end_point& lower, const end_point& upper,
                              const pi_combination& period) {
  const auto moved = [](const end_point& x, const pi_combination& by) {
    if (x.form()) return end_point(*x.form() + by);
    return end_point([=](precision p) { return x.at(p) + by.at(p); });
  };
  if (!lower.is_infinite()) return {period, lower, moved(lower, period)};
  if (!upper.is_infinite()) return {period, moved(upper, -period), upper};
  return {period, 0, end_point(period)};
}

}  // namespace

root_set isolate_roots(const real_function& f, const end_point& lower, const end_point& upper,
                       const isolate_options& options) {
  (void)detail::range_around(lower, upper);  // refuses what is no interval
  if (auto found = detail::roots_beside_zeros(f, lower, upper, options)) return *std::move(found);
  std::optional<searched_period> one;
  if (options.by_period && (lower.infinite_sign() < 0 || upper.infinite_sign() > 0)) {
    if (const auto period = f.period()) one = period_within(lower, upper, *period);
  }
  root_search s(f, one ? one->lower : lower, one ? one->upper : upper);
  s.run(options);
  root_set result = s.result();
  result.of_period = std::move(one);
  return result;
}

std::optional<rational> refute_derivative(const real_function& f,
                                          const std::function<ball(const ball&)>& derivative,
                                          const rational& lower, const rational& upper,
                                          int points) {
  constexpr precision p = 128;
  const auto at_p = f.at(p);
  const function_evaluator& e = *at_p;
  for (int k = 0; k <= points; ++k) {
    const rational x = lower + (upper - lower) * rational(k, points);
    const ball known = e.derivative(ball(x, p));
    const ball given = derivative(ball(x, p));
    if (!known.is_undefined() && !given.is_undefined() && !overlaps(known, given)) return x;
  }
  return std::nullopt;
}

}  // namespace polhode
