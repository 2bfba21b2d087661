#pragma once

// Integrals of a person's generic function over a type Real of their own.
//
//   using Real = boost::multiprecision::mpfr_float_50;
//   const auto f = [](auto x) { return exp(-x * x) / (1 + x); };
//   const auto i = polhode::integrate<Real>(f, 0, 1);            // i.value, i.truncation_error
//   const auto c = polhode::integrate<polhode::ball>(f, 0, 1);   // c.enclosure
//
// f is called once with a symbol (expression/symbol.hpp), which makes it a formula; of the formula
// it is proved where it is analytic and how large it is there, and so which rule with how many
// nodes is enough, as integrate.hpp in quadrature/ has it. With a ball the result is an enclosure.
// With another Real the same rule is summed over values of f in Real: then what the rule leaves
// out, the truncation error, is proved, and the rounding errors in the values of f are not. The
// type of the result says so.
//
// f(x) at a Real is f itself where it returns numbers: double, and Boost's numbers without
// expression templates or with a lambda that says its type. A lambda that returns an expression
// template returns references to numbers that may be gone; then, and for long double, f's formula
// is evaluated in its place, by MPFR with as many bits as Real has.

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/real/function.hpp"
#include "polhode/real/limit.hpp"
#include "polhode/real/number.hpp"
#include "polhode/real/policy.hpp"

namespace polhode {

struct real_integrate_options {
  /// Relative digits of the truncation error; by default all that Real has, or that the policy asks
  /// for.
  std::optional<long> digits = std::nullopt;
  /// An absolute goal beside it, as a power of two.
  std::optional<long> absolute_exponent = std::nullopt;
  quadrature_rule rule = quadrature_rule::automatic;
  long most_evaluations = 20'000'000;
  /// On how many threads f is evaluated; 0 for as many as the machine has processors.
  int threads = 1;
  /// Also integrate with balls, and say what that costs: price in the result.
  bool report = false;
  std::function<void(const integration_progress&)> progress = {};
};

/// What a proof of the rounding errors too costs for one integrand: the same integral with values
/// in Real and with balls.
struct price_of_certainty {
  double seconds = 0;
  double seconds_certified = 0;
  /// How many times as long the certified one takes.
  [[nodiscard]] double ratio() const { return seconds > 0 ? seconds_certified / seconds : 0; }
  /// The certified one.
  ball enclosure = ball::undefined(64);
};

/// What is proved of an integral that was summed in a Real.
enum class truncation_verdict {
  // But for rounding errors, the integral is within truncation_error of the value, and the goal is
  // reached.
  proved,
  not_proved  // it is not, and `obstacle` says why
};

[[nodiscard]] std::string to_text(truncation_verdict v);

/// An integral whose truncation error is proved, and whose rounding errors are not.
template <floating_real R>
struct rounded_integral {
  /// The rule's sum over values of f in R. Where the verdict is not_proved: what was reached, a NaN
  /// where that is nothing.
  R value = std::numeric_limits<R>::quiet_NaN();
  /// An upper bound of what the rule leaves out; infinite where none is known.
  R truncation_error = std::numeric_limits<R>::infinity();
  truncation_verdict verdict = truncation_verdict::not_proved;
  reason why = reason::none;
  /// What stood in the way and where, in words; empty where it is proved.
  std::string obstacle;
  integral_account account;
  std::optional<price_of_certainty> price;
};

namespace detail {

[[nodiscard]] inline integrate_options options_for(const real_integrate_options& given,
                                                   long digits) {
  integrate_options result;
  result.digits = digits;
  result.absolute_exponent = given.absolute_exponent;
  result.rule = given.rule;
  result.most_evaluations = given.most_evaluations;
  result.threads = given.threads;
  result.progress = given.progress;
  return result;
}

/// Throws input_error for digits that are none.
inline void expect_digits(long digits) {
  if (digits < 1) {
    throw input_error("digits is " + std::to_string(digits) + "; it must be a number from 1");
  }
}

template <class Work>
[[nodiscard]] double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The shorter of two: the first one pays for nodes that are made once in a process.
template <class Work>
[[nodiscard]] double seconds_of_two(const Work& work) {
  const double first = seconds_of(work);
  return std::min(first, seconds_of(work));
}

}  // namespace detail

/// The integral of a generic function f from a to b, an enclosure: as integrate in
/// quadrature/integrate.hpp, with f recorded once instead of compiled for each arithmetic, and 15
/// digits unless options has others.
template <class Real, class F>
requires std::same_as<Real, ball>
[[nodiscard]] integral integrate(const F& f, const range_limit<ball>& a, const range_limit<ball>& b,
                                 const integrate_options& options = {}) {
  return integrate(formula_of<detail::symbol_of_real<Real>>(f), a.point(), b.point(), options);
}

/// The integral of a generic function f from a to b, summed in Real. The order of the ends,
/// infinite ends and ends where f is singular are as in quadrature/integrate.hpp. Without a policy
/// of Boost's the verdict says what is not proved, and input_error is thrown for ends and options
/// that are no numbers; with a policy, its evaluation_error and domain_error decide.
template <class Real, class F, class Policy = answer_by_verdict>
requires floating_real<Real>
[[nodiscard]] rounded_integral<Real> integrate(const F& f, const range_limit<Real>& a,
                                               const range_limit<Real>& b,
                                               const real_integrate_options& options = {},
                                               const Policy& policy = {}) {
  constexpr const char* function = "polhode::integrate<%1%>(f, a, b)";
  rounded_integral<Real> result;
  try {
    const precision bits = detail::working_bits<Real>(a, b);
    const long digits = options.digits.value_or(detail::digits_wanted<Real, Policy>(bits));
    detail::expect_digits(digits);
    const expression formula = formula_of<detail::symbol_of_real<Real>>(f);
    const integrate_options goal = detail::options_for(options, digits);
    const prepared_integrand certified(formula);
    const prepared_integrand rounded = certified.with_values(
        detail::values_as_balls<Real>(f, formula, bits), a.point(), b.point());
    const auto sum = [&](const prepared_integrand& g) {
      return integrate(g, a.point(), b.point(), goal);
    };
    const integral found = sum(rounded);
    result.value = nearest_as<Real>(found.enclosure, bits);
    const auto error = detail::truncation_of(found.enclosure);
    result.truncation_error = upper_as<Real>(error, bits);
    if (!found.enclosure.is_bounded()) {
      result.truncation_error = std::numeric_limits<Real>::infinity();
    }
    result.verdict = found.verdict == status::certified ? truncation_verdict::proved
                                                        : truncation_verdict::not_proved;
    result.why = found.why;
    result.obstacle = found.obstacle;
    result.account = found.account;
    if (options.report) {
      price_of_certainty price;
      price.seconds = detail::seconds_of_two([&] { static_cast<void>(sum(rounded)); });
      price.seconds_certified =
          detail::seconds_of_two([&] { price.enclosure = sum(certified).enclosure; });
      result.price = price;
    }
  } catch (const input_error& error) {
    result.value = detail::bad_input<Real>(function, error, policy);
    result.obstacle = error.what();
    return result;
  }
  if (result.verdict == truncation_verdict::not_proved) {
    result.value = detail::not_proved(function, result.obstacle, result.value, policy);
  }
  return result;
}

/// Refuses any other Real.
template <class Real, class F, class... Rest>
requires(!real_or_ball<Real> && std::is_class_v<F>) void integrate(const F& /*f*/,
                                                                   const Rest&... /*rest*/) {
  static_assert(detail::real_needed<Real>::reported);
}

}  // namespace polhode
