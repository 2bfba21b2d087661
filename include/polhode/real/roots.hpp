#pragma once

// Roots of a person's generic function over a type Real of their own, each proved.
//
//   using Real = boost::multiprecision::mpfr_float_100;
//   const auto r = polhode::find_root<Real>([](auto x) { return cos(x) - x; }, 0, 1);
//   // r.value, r.lower <= the root <= r.upper, r.verdict == root_verdict::unique
//
// f is called once with a symbol (expression/symbol.hpp), which makes it a formula; what is proved
// is proved of the formula, by balls (roots/isolate.hpp), and rounded outward to Real. A person may
// choose one of Boost.Math's iterations to look for the root; the proof afterwards is the same.

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include "polhode/arithmetic/interval.hpp"
#include "polhode/real/function.hpp"
#include "polhode/real/limit.hpp"
#include "polhode/real/number.hpp"
#include "polhode/real/policy.hpp"
#include "polhode/roots/isolate.hpp"

namespace polhode {

/// Who looks for the root before it is proved.
enum class root_engine {
  isolation,  // all of the interval is searched with balls; what is found is the only root there is
  toms748,    // boost::math::tools::toms748_solve, which needs a change of sign
  newton,     // boost::math::tools::newton_raphson_iterate, from the middle of the interval
  halley,     // boost::math::tools::halley_iterate
  schroeder   // boost::math::tools::schroder_iterate
};

struct real_root_options {
  /// Digits of the root; by default all that Real has, or that the policy asks for.
  std::optional<long> digits = std::nullopt;
  root_engine engine = root_engine::isolation;
  /// Of an iteration of Boost's.
  std::uintmax_t most_iterations = 500;
  /// Of the isolation.
  isolate_options isolation = {};
};

namespace detail {
/// No number: a NaN, or an undefined ball.
template <class Real>
[[nodiscard]] Real no_number() {
  if constexpr (std::same_as<Real, ball>) {
    return ball::undefined(64);
  } else {
    return std::numeric_limits<Real>::quiet_NaN();
  }
}
}  // namespace detail

/// A root with the bracket that is proved to hold it.
template <class Real>
struct certified_root {
  /// Near the middle of the bracket; a NaN (an undefined ball) where there is no root to show.
  Real value = detail::no_number<Real>();
  /// lower <= root <= upper; every root of the region lies between them where the verdict is not
  /// that of one root.
  Real lower = detail::no_number<Real>();
  Real upper = detail::no_number<Real>();
  /// What is proved of the roots in the interval; by an iteration of Boost's, of those in [lowest,
  /// greatest].
  root_verdict verdict = root_verdict::unresolved;
  /// No other root lies between these. NaNs (undefined balls) where that is not proved, or no
  /// number of type Real is in the box of the proof.
  Real lowest = detail::no_number<Real>();
  Real greatest = detail::no_number<Real>();
  /// Where it is proved; else 0.
  long multiplicity = 0;
  /// The root, or one of them, where it is known to be this rational number.
  std::optional<rational> exact;
  /// The radius is at most 10^-digits of the root's size (of the interval's, where the root may be
  /// 0).
  bool reached = false;
  /// Of the iteration of Boost's that was chosen.
  std::uintmax_t iterations = 0;
  /// Why it is not resolved, in words.
  std::string remark;
};

template <class Real>
struct certified_roots {
  /// In ascending order.
  std::vector<certified_root<Real>> roots;
  /// The whole interval was searched, every root is proved to be one (is_one_root), and there is no
  /// other.
  bool resolved = false;
  /// f is 0 everywhere; there are no roots in the list then.
  bool identically_zero = false;
  /// Where f is 0 on intervals; their roots are not in the list.
  std::vector<zero_interval> zero_intervals;
  isolation_account account;
};

namespace detail {

/// Bounds of a ball's set as numbers of type Real, which may be ball: then exact balls.
template <class Real>
[[nodiscard]] Real end_as(const ball& x, precision p, mpfr_rnd_t direction) {
  if constexpr (std::same_as<Real, ball>) {
    if (direction == MPFR_RNDN) return x;
    mpfr_float end = zero_of_precision(p);
    if (direction == MPFR_RNDD) {
      x.lower(end.backend().data());
    } else {
      x.upper(end.backend().data());
    }
    if (mpfr_number_p(end.backend().data()) == 0) return ball::undefined(p);
    return ball(end);
  } else {
    return bound_as<Real>(x, p, direction);
  }
}

/// The ends of a box, rounded inward: what is unique in the box is unique between them.
template <class Real>
void set_box(Real& lowest, Real& greatest, const ball& box, precision p) {
  constexpr precision enough = 128;
  mpfr_float lower = zero_of_precision(std::max(p, box.precision()) + enough);
  mpfr_float upper = lower;
  box.lower(lower.backend().data());
  box.upper(upper.backend().data());
  const auto is_outside = [&](const mpfr_float& end) {
    return mpfr_number_p(end.backend().data()) != 0 && !contains(box, ball(end));
  };
  if (is_outside(lower)) mpfr_nextabove(lower.backend().data());
  if (is_outside(upper)) mpfr_nextbelow(upper.backend().data());
  if constexpr (std::same_as<Real, ball>) {
    lowest = ball(lower);
    greatest = ball(upper);
  } else {
    lowest = rounded_to<Real>(lower.backend().data(), p, MPFR_RNDU);
    greatest = rounded_to<Real>(upper.backend().data(), p, MPFR_RNDD);
    if (lowest > greatest) lowest = greatest = no_number<Real>();
  }
}

template <class Real>
[[nodiscard]] precision bits_between(const range_limit<Real>& a, const range_limit<Real>& b,
                                     std::optional<long> digits) {
  constexpr precision guard = 16;
  if constexpr (std::same_as<Real, ball>) {
    return bits_for_digits(digits.value_or(15)) + guard;
  } else {
    return working_bits<Real>(a, b);
  }
}

template <class Real, class Policy>
[[nodiscard]] long root_digits(const real_root_options& options, precision p) {
  long digits = 15;
  if constexpr (!std::same_as<Real, ball>) digits = digits_wanted<Real, Policy>(p);
  digits = options.digits.value_or(digits);
  if (digits < 1) {
    throw input_error("digits is " + std::to_string(digits) + "; it must be a number from 1");
  }
  return digits;
}

template <class Real>
void set_bracket(certified_root<Real>& root, const ball& enclosure, precision p) {
  root.value = end_as<Real>(enclosure, p, MPFR_RNDN);
  root.lower = end_as<Real>(enclosure, p, MPFR_RNDD);
  root.upper = end_as<Real>(enclosure, p, MPFR_RNDU);
}

/// A region of an isolation, refined.
template <class Real>
[[nodiscard]] certified_root<Real> root_of(const root_region& region, long digits, precision p) {
  certified_root<Real> result;
  const refined_root refined = refine(region, digits);
  result.exact = refined.exact;
  const bool is_one = is_one_root(region.verdict);
  set_bracket(result,
              !is_one         ? region.box
              : refined.exact ? ball(*refined.exact, std::max<precision>(p, 64))
                              : refined.enclosure,
              p);
  result.verdict = region.verdict;
  result.multiplicity = region.multiplicity;
  if (is_one) set_box(result.lowest, result.greatest, region.box, p);
  result.reached = is_one && (refined.exact || refined.verdict == status::certified);
  result.remark = region.remark;
  return result;
}

/// What an iteration of Boost's ends at; a NaN where it gives up.
template <floating_real Real, class F>
[[nodiscard]] Real found_by(root_engine engine, const F& f, const expression& formula,
                            const Real& lower, const Real& upper, precision p,
                            std::uintmax_t& iterations) {
  const thread_precision<Real> scope(p);
  if (engine == root_engine::toms748) {
    const auto value = values_in<Real>(f, formula, p);
    const Real at_lower = value(lower);
    const Real at_upper = value(upper);
    if (at_lower == 0) return lower;
    if (at_upper == 0) return upper;
    const auto close = [p](const Real& a, const Real& b) {
      using std::abs;
      using std::ldexp;
      return abs(Real(a - b)) <= ldexp(Real(abs(a)), 2 - static_cast<int>(p));
    };
    const auto bracket = boost::math::tools::toms748_solve(value, lower, upper, at_lower, at_upper,
                                                           close, iterations);
    return Real((bracket.first + bracket.second) / 2);
  }
  const auto jets = formula.evaluator<jet<ball, 2>>(p);
  const auto at = [&](const Real& x) {
    const jet<ball, 2> y = jets(jet<ball, 2>::variable(ball_of(x).with_precision(p)));
    const auto number = [p](const ball& b) { return nearest_as<Real>(b, p); };
    return std::make_tuple(number(y[0]), number(y[1]), number(2 * y[2]));
  };
  const auto first_two = [&](const Real& x) {
    const auto y = at(x);
    return std::make_tuple(std::get<0>(y), std::get<1>(y));
  };
  const Real middle = Real((lower + upper) / 2);
  const int bits = static_cast<int>(p) - 2;
  switch (engine) {
    case root_engine::newton:
      return boost::math::tools::newton_raphson_iterate(first_two, middle, lower, upper, bits,
                                                        iterations);
    case root_engine::halley:
      return boost::math::tools::halley_iterate(at, middle, lower, upper, bits, iterations);
    default:
      return boost::math::tools::schroder_iterate(at, middle, lower, upper, bits, iterations);
  }
}

/// The same options without by_period: the answers here are about the whole interval.
[[nodiscard]] inline isolate_options over_all_periods(isolate_options options) {
  options.by_period = false;
  return options;
}

/// The proof that f has exactly one root near x: by interval Newton, in boxes around x that grow
/// from a few units in its last place.
[[nodiscard]] root_enclosure proved_near(const expression& formula, const ball& x,
                                         const ball& interval, precision p);

/// Its result as a root, where there is one.
template <class Real>
[[nodiscard]] certified_root<Real> root_near(const expression& formula, const ball& x,
                                             const ball& interval, long digits, precision p) {
  certified_root<Real> result;
  const root_enclosure proof = proved_near(formula, x, interval, bits_for_digits(digits) + 16);
  result.verdict = proof.verdict;
  set_bracket(result, proof.root, p);
  if (proof.verdict == root_verdict::unique) {
    set_box(result.lowest, result.greatest, proof.box, p);
    result.multiplicity = 1;
    result.reached = true;
  } else {
    result.remark = "no box around what the iteration found is proved to hold exactly one root";
  }
  return result;
}

}  // namespace detail

/// All roots of a generic function f with lower <= x <= upper, each with its bracket. Real: a
/// floating_real, or ball. Throws input_error for an interval that is none and digits below 1.
template <class Real, class F>
requires real_or_ball<Real>
[[nodiscard]] certified_roots<Real> isolate_roots(const F& f, const range_limit<Real>& lower,
                                                  const range_limit<Real>& upper,
                                                  const real_root_options& options = {}) {
  const precision p = detail::bits_between<Real>(lower, upper, options.digits);
  const long digits = detail::root_digits<Real, answer_by_verdict>(options, p);
  const root_set found = isolate_roots(formula_of<detail::symbol_of_real<Real>>(f), lower.point(),
                                       upper.point(), detail::over_all_periods(options.isolation));
  certified_roots<Real> result;
  result.resolved = found.complete && found.is_resolved();
  result.identically_zero = found.identically_zero;
  result.zero_intervals = found.zero_intervals;
  result.account = found.account;
  for (const root_region& region : found.regions) {
    result.resolved = result.resolved && region.verdict != root_verdict::infinitely_many;
    result.roots.push_back(detail::root_of<Real>(region, digits, p));
  }
  return result;
}

/// The root of a generic function f with lower <= x <= upper. By isolation, unique or multiple says
/// that there is no other; where there are several, the verdict is at_least_one, and the bracket
/// that of the lowest. By an iteration of Boost's, unique says that it is the only one in [lowest,
/// greatest]. Real: a floating_real; or ball, by isolation. Without a policy of Boost's, the
/// verdict says what is not proved; with one, its evaluation_error decides where there is no proved
/// root.
template <class Real, class F, class Policy = answer_by_verdict>
requires real_or_ball<Real>
[[nodiscard]] certified_root<Real> find_root(const F& f, const range_limit<Real>& lower,
                                             const range_limit<Real>& upper,
                                             const real_root_options& options = {},
                                             const Policy& policy = {}) {
  constexpr const char* function = "polhode::find_root<%1%>(f, lower, upper)";
  certified_root<Real> result;
  try {
    const precision p = detail::bits_between<Real>(lower, upper, options.digits);
    const long digits = detail::root_digits<Real, Policy>(options, p);
    const expression formula = formula_of<detail::symbol_of_real<Real>>(f);
    if (options.engine == root_engine::isolation) {
      const root_set found = isolate_roots(formula, lower.point(), upper.point(),
                                           detail::over_all_periods(options.isolation));
      if (!found.zero_intervals.empty()) {
        result.remark = "the function is 0 on an interval";
      } else if (!found.regions.empty()) {
        result = detail::root_of<Real>(found.regions.front(), digits, p);
        if (found.regions.size() > 1 && result.verdict != root_verdict::unresolved) {
          result.verdict = root_verdict::at_least_one;
          result.remark = std::to_string(found.regions.size()) +
                          " places may have roots; isolate_roots finds them all";
        }
      } else if (found.complete && !found.identically_zero) {
        result.verdict = root_verdict::none;
        result.remark = "the function has no root there";
      } else {
        result.remark = found.identically_zero ? "the function is 0 everywhere"
                                               : "the search was not completed";
      }
    } else if constexpr (floating_real<Real>) {
      if (lower.point().is_infinite() || upper.point().is_infinite()) {
        throw input_error("an iteration of Boost's needs a finite interval");
      }
      const ball first = lower.point().at(p);
      const ball last = upper.point().at(p);
      std::uintmax_t iterations = options.most_iterations;
      const Real x = detail::found_by<Real>(options.engine, f, formula, upper_as<Real>(first, p),
                                            lower_as<Real>(last, p), p, iterations);
      result = detail::root_near<Real>(formula, ball_of(x).with_precision(p), hull(first, last),
                                       digits, p);
      result.iterations = iterations;
    } else {
      throw input_error("Boost's iterations need a floating-point Real; a ball is for isolation");
    }
  } catch (const input_error& error) {
    if constexpr (floating_real<Real>) {
      result.value = detail::bad_input<Real>(function, error, policy);
      result.remark = error.what();
      return result;
    } else {
      throw;
    }
  } catch (const std::domain_error& error) {  // no change of sign
    result.remark = std::string("the iteration gave up: ") + error.what();
  } catch (const boost::math::evaluation_error& error) {
    result.remark = std::string("the iteration gave up: ") + error.what();
  }
  const bool proved = is_one_root(result.verdict);
  if constexpr (floating_real<Real>) {
    if (!proved) result.value = detail::not_proved(function, result.remark, result.value, policy);
  }
  return result;
}

/// Refuses any other Real.
template <class Real, class F, class... Rest>
requires(!real_or_ball<Real> && std::is_class_v<F>) void isolate_roots(const F& /*f*/,
                                                                       const Rest&... /*rest*/) {
  static_assert(detail::real_needed<Real>::reported);
}

/// Refuses any other Real.
template <class Real, class F, class... Rest>
requires(!real_or_ball<Real> && std::is_class_v<F>) void find_root(const F& /*f*/,
                                                                   const Rest&... /*rest*/) {
  static_assert(detail::real_needed<Real>::reported);
}

}  // namespace polhode
