#pragma once

// The integral of a function, with a proof.
//
//   integral i = integrate([](auto x) { return exp(-x * x); }, 0, 1, {.digits = 50});
//   integral j = integrate(parse("sin(x)"), 0, end_point_of(parse("pi/2", {})));
//
// A generic function is called once, with a symbol, and becomes a formula (formula_of.hpp). What
// makes a formula not analytic (a square root's branch cut, a pole, |x|, floor) shows when it is
// evaluated over a `region`, a cheap complex rectangle: nothing needs to be declared and nothing
// can be forgotten.
//
// How: a sum of functions whose logarithmic derivative is rational, in x, e^(k x) or sin^2 (k x),
// is integrated by its Taylor series (src/quadrature/series). For others the range is cut where
// abs, min, max, floor or ceil passes from one analytic function to another, at points that are
// found to any precision. Each piece is cut into panels. Around each, a Bernstein ellipse is
// covered by regions, which prove that f is analytic inside and give M >= |f|; the Gauss-Legendre
// rule with n nodes is then off by at most a multiple of M rho^(-2n) (error_bounds.hpp). Where no
// ellipse is proved the panel is halved. Where f is found to be even about both limits, or
// periodic, the trapezoidal rule may serve with less work. end_series.hpp describes an end where f
// is singular, or a point between the limits where the range is cut.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "polhode/arithmetic/certified_answer.hpp"
#include "polhode/arithmetic/end_point.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/goal.hpp"
#include "polhode/arithmetic/polynomial.hpp"
#include "polhode/arithmetic/verdict.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/formula_of.hpp"
#include "polhode/quadrature/rule.hpp"

namespace polhode {

/// What of a sum over panels is done; there may be several sums, one after the other.
struct integration_progress {
  long panels_done = 0;
  long panels = 0;  // of the plan
  long nodes = 0;   // of the panel that is begun
};

struct integrate_options {
  /// The goal: a radius of at most 10^-digits of the value. Where the value is 0, or smaller than
  /// 10^-digits of the integral of |f|, that size stands for the value's.
  long digits = 15;
  /// An absolute goal beside it, as a power of two: a radius of at most 2^absolute_exponent will
  /// do.
  std::optional<long> absolute_exponent = std::nullopt;
  [[nodiscard]] polhode::goal goal() const { return {digits, absolute_exponent}; }
  /// Of f, at nodes and over regions; and terms of Taylor series.
  long most_evaluations = 20'000'000;
  /// How often a panel may be halved; by default as often as the goal may need.
  std::optional<long> most_depth = std::nullopt;
  /// Bits that rounding errors may raise the working precision to; by default 64 times the goal's.
  std::optional<precision> most_precision = std::nullopt;
  /// Bytes that the nodes and weights of the rules may take together, by an estimate; by default
  /// without limit.
  std::optional<double> most_memory = std::nullopt;
  /// A rule to insist on. Where it does not apply the verdict says so (not_applicable), and what is
  /// missing.
  quadrature_rule rule = quadrature_rule::automatic;
  /// On how many threads f is evaluated at the nodes; 0 for as many as the machine has processors,
  /// which are the most. The result is the same bit for bit.
  int threads = 1;
  /// Called before the nodes of a panel are summed, by the thread that integrates; may be empty.
  std::function<void(const integration_progress&)> progress = {};
};

/// What it cost.
struct integral_account {
  long evaluations = 0;         // of f at real nodes
  long region_evaluations = 0;  // of f over complex regions
  long panels = 0;
  long most_nodes = 0;  // of one panel; or terms of a series
  long terms = 0;       // of Taylor series, in all
  /// The rules that were used, each once. None where bounds of f were enough.
  std::vector<quadrature_rule> rules;
  polhode::precision precision = 0;
  double seconds_for_bounds = 0;
  double seconds_for_sums = 0;

  /// What both cost: sums, the greatest most_nodes and precision, the rules of both.
  integral_account& operator+=(const integral_account& other);
};

/// An integral with its proof, or how far it got. T: ball, or complex_ball.
template <class T>
struct certified_integral : certified_answer<T> {
  integral_account account;
};
struct integral : certified_integral<ball> {};

namespace detail {
struct integrand;
}  // namespace detail

/// A formula with what its integrals need of it, which is made once: for several integrals.
class prepared_integrand {
 public:
  /// Throws input_error where f has more than one variable.
  explicit prepared_integrand(const expression& f);

  /// The same function. Each evaluation, on whatever thread, calls one of these as well.
  [[nodiscard]] prepared_integrand watched(std::function<void()> over_region,
                                           std::function<void()> at_node) const;
  /// The same function, for integrals from a to b, with other values at the nodes, which may be off
  /// by rounding errors. The formula's own values, of balls, stay
  ///   - for every argument that is more than a rounded number: bounds of f over a set are made of
  ///     such, and must hold;
  ///   - where the others are not defined;
  ///   - beside ends of the range that are not 0: a rounded x says too little there of its distance
  ///     from the end, where f may be singular.
  [[nodiscard]] prepared_integrand with_values(const std::function<ball(const ball&)>& values,
                                               const end_point& a, const end_point& b) const;

  [[nodiscard]] const expression& formula() const { return formula_; }
  [[nodiscard]] const detail::integrand& functions() const { return *functions_; }

 private:
  prepared_integrand(expression f, detail::integrand functions);

  expression formula_;
  std::shared_ptr<const detail::integrand> functions_;
};

/// A period of f, proved by its symmetry; nothing where none is found. Throws
/// input_error where f has more than one variable.
[[nodiscard]] std::optional<pi_combination> period_of(const expression& f);

/// The integral of f from a to b; that from b to a with its sign changed where a > b, 0 where a =
/// b. Limits may be infinite (end_point::infinity()), and f singular at them, where end_series.hpp
/// finds it integrable. Verdicts: certified; not_certified with not_analytic (obstacle says what
/// and where), not_integrable, evaluation_limit, precision_limit, not_applicable. The enclosure
/// holds the integral with every verdict. Throws input_error where f has more than one variable.
[[nodiscard]] integral integrate(const expression& f, const end_point& a, const end_point& b,
                                 const integrate_options& options = {});

/// The same of a formula that is prepared.
[[nodiscard]] integral integrate(const prepared_integrand& f, const end_point& a,
                                 const end_point& b, const integrate_options& options = {});

/// The same of a generic function of one argument, through its formula (formula_of).
template <class F>
[[nodiscard]] integral integrate(const F& f, const end_point& a, const end_point& b,
                                 const integrate_options& options = {}) {
  return integrate(formula_of(f), a, b, options);
}

/// The integral of p from a to b: F(b) - F(a) for F = the sum of p_n x^(n+1)/(n+1) (negative of
/// that from b to a). None where the number would be too long: where the coefficients, or the
/// powers of the ends, have more than about 2^20 bits.
[[nodiscard]] std::optional<rational> exact_integral(const rational_polynomial& p,
                                                     const rational& a, const rational& b);

/// The integral of f from a to b where it is found to be a rational number, for f that is, between
/// rational points (of abs, min, max, floor and ceil), a rational function whose antiderivative is
/// one, such a function of the root of a linear form, or a sum of x^n exp(k x), x^n sin(k x) and
/// x^n cos(k x), or one of x^k log(x)^n over x >= 0; for f that is 0 but for isolated points; and
/// for f that is integrable over a half of the range and odd about its middle, but for a constant.
/// Ends may be infinite. None for other f, for integrals that diverge, where an end is not shown to
/// be a number, and where the result would be long.
[[nodiscard]] std::optional<rational> exact_integral(const expression& f, const end_point& a,
                                                     const end_point& b);

/// A formula without variables as an end of a range; exactly, where it is found to be q + r pi with
/// rational q and r. Throws input_error where it has a variable.
[[nodiscard]] end_point end_point_of(const expression& f);

/// A formula without variables of the number that x is: of q + r pi, or the one that end_point_of
/// was given. None for an infinity, and for a number of which enclosures alone are known.
[[nodiscard]] std::optional<expression> formula_of(const end_point& x);

}  // namespace polhode
