#pragma once

// The periodic trapezoidal rule for even functions: integrals of the form
//
//     integral from 0 to pi of g(cos t) dt.
//
// t -> g(cos t) is even and 2 pi-periodic, so the rule with 2n nodes (2k+1) pi / (2n) on the whole
// circle needs the n of them in (0, pi) only; all weights are pi / n. (The same nodes and weights
// are Gauss and Chebyshev's for g(x) / sqrt(1 - x^2) on [-1, 1]: gauss_chebyshev_sum.) It converges
// geometrically, at the rate of the strip in which g(cos t) is analytic, and everything at the
// nodes is real arithmetic.
//
// An integrand is an object that says two things of g:
//
//   template <scalar T> auto evaluator(precision p) const;
//       a function object T -> T: g at the cosine it is given, with p bits;
//   std::optional<strip_bound> bound_on_strip(const ball& half_width) const;
//       a bound of |g(cos t)| for |Im t| <= H (error_bounds.hpp says what that claims), or nothing
//       where the integrand cannot prove one.

#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

#include "polhode/arithmetic/certified_answer.hpp"
#include "polhode/arithmetic/scalar.hpp"
#include "polhode/arithmetic/verdict.hpp"
#include "polhode/quadrature/error_bounds.hpp"
#include "polhode/quadrature/rule_sum.hpp"

namespace polhode {

/// A number of nodes and the proof that it suffices.
struct periodic_plan {
  long nodes = 0;             // n, on the half circle; 0 where no plan was found
  strip_bound strip;          // the bound it rests on
  ball truncation_error;      // >= |rule - integral| over (0, pi)
  reason why = reason::none;  // where nodes == 0
};

/// Looks for the least n for which the proved truncation error is at most 2^(-bits), and for the
/// strip that proves it. The search is heuristic; the error in the result is proved. Fails with
/// not_analytic where no strip was proved, with evaluation_limit where n would exceed most_nodes.
[[nodiscard]] periodic_plan plan_periodic_trapezoid(
    const std::function<std::optional<strip_bound>(const ball& half_width)>& bound_on_strip,
    long bits, long most_nodes);

namespace detail {

/// w^j for j = 0 ... count-1, where w = c + i s lies on the unit circle: {cosines, sines}. Each
/// power is the product of two of half its exponent, so that errors grow with the logarithm of j.
template <scalar T>
struct circle_powers {
  std::vector<T> cosines;
  std::vector<T> sines;

  circle_powers(const T& c, const T& s, long count, precision p) {
    cosines.reserve(static_cast<std::size_t>(count));
    sines.reserve(static_cast<std::size_t>(count));
    for (long j = 0; j < count; ++j) {
      if (j == 0) {
        append(scalar_from<T>(1, p), scalar_from<T>(0, p));
      } else if (j == 1) {
        append(c, s);
      } else {
        const auto low = static_cast<std::size_t>(j / 2);
        const auto high = static_cast<std::size_t>(j) - low;
        append(T(cosines[low] * cosines[high] - sines[low] * sines[high]),
               T(sines[low] * cosines[high] + cosines[low] * sines[high]));
      }
    }
  }

 private:
  void append(T c, T s) {
    cosines.push_back(std::move(c));
    sines.push_back(std::move(s));
  }
};

}  // namespace detail

/// The rule itself: (pi / n) * sum of g(cos((2k+1) pi / (2n))), k = 0 ... n-1, evaluated with p
/// bits. With T = ball an enclosure of the rule's value, which the truncation error is then to be
/// added to; with T = mpfr_float the uncertified value. It calls g n times.
///
/// cos of a sum of two tabulated angles costs two multiplications, so the nodes cost no cosine
/// each; and they come in pairs c, -c.
template <scalar T, class Integrand>
[[nodiscard]] T periodic_trapezoid_sum(const Integrand& integrand, long n, precision p) {
  const auto g = integrand.template evaluator<T>(p);
  const T step = scalar_pi<T>(p) / (2 * n);
  const auto [sine, cosine] = sin_cos(step);
  const long pairs = n / 2;
  long block = 1;
  while (block * block < pairs) ++block;
  // Angle (2k+1) h with k = i * block + j: (2 * block * i) h + (2j+1) h.
  const detail::circle_powers<T> fine(cosine, sine, 2 * block + 1, p);
  const auto last = static_cast<std::size_t>(2 * block);
  const detail::circle_powers<T> coarse(fine.cosines[last], fine.sines[last],
                                        (pairs + block - 1) / block, p);
  T sum = n % 2 == 0 ? scalar_from<T>(0, p) : g(scalar_from<T>(0, p));
  T node = scalar_from<T>(0, p);
  for (long k = 0; k < pairs; ++k) {
    const auto i = static_cast<std::size_t>(k / block);
    const auto j = static_cast<std::size_t>(2 * (k % block) + 1);
    node = coarse.cosines[i] * fine.cosines[j] - coarse.sines[i] * fine.sines[j];
    sum += g(node);
    node = -node;
    sum += g(node);
  }
  return T(sum * (2 * step));
}

/// An integral by the trapezoidal rule.
struct trapezoid_integral : certified_answer<ball> {
  polhode::precision precision = 0;  // working bits
  long evaluations = 0;              // at nodes, over all precisions tried
};

struct periodic_integral : trapezoid_integral {
  periodic_plan plan;
};

struct trapezoid_options {
  long most_nodes = 20'000'000;
  precision most_precision = precision{1} << 26;
};

namespace detail {

/// The rule's value, in a ball of radius at most 2^-bits: sum(p) encloses it with p bits but for
/// what is left out, which `left_out` bounds, well below 2^-bits. The precision is raised until the
/// rounding errors allow that radius. Verdicts: certified; or not_certified with not_defined, where
/// a sum is undefined, or precision_limit.
[[nodiscard]] trapezoid_integral sum_to_bits(const std::function<ball(precision)>& sum, long nodes,
                                             const magnitude& left_out, long bits,
                                             precision most_precision);

}  // namespace detail

/// Encloses the integral from 0 to pi of g(cos t) dt in a ball of radius at most 2^(-bits).
/// Verdicts: certified; or not_certified with not_analytic, evaluation_limit, precision_limit, or
/// not_defined (g is undefined at a node).
template <class Integrand>
[[nodiscard]] periodic_integral integrate_periodic(const Integrand& integrand, long bits,
                                                   const trapezoid_options& options = {}) {
  periodic_integral result;
  result.plan = plan_periodic_trapezoid(
      [&](const ball& half_width) { return integrand.bound_on_strip(half_width); }, bits + 1,
      options.most_nodes);
  if (result.plan.nodes == 0) {
    result.why = result.plan.why;
    return result;
  }
  const long n = result.plan.nodes;
  const auto sum = [&](precision p) { return periodic_trapezoid_sum<ball>(integrand, n, p); };
  static_cast<trapezoid_integral&>(result) = detail::sum_to_bits(
      sum, n, result.plan.truncation_error.magnitude_upper(), bits, options.most_precision);
  return result;
}

namespace detail {

/// f as an integrand of periodic_trapezoid.hpp.
template <class F>
struct function_of_cosine {
  const F& f;
  template <scalar T>
  [[nodiscard]] auto evaluator(precision) const {
    return [&g = f](const T& x) -> T { return g(x); };
  }
};

}  // namespace detail

/// (pi/n) times the sum of f(cos((2j+1) pi/(2n))), j = 0 ... n-1, with p bits: about the integral
/// of f(x)/sqrt(1 - x^2) over [-1, 1], and exactly so for polynomials of degree below 2n. With T =
/// ball an enclosure of the rule's value, with T = mpfr_float the uncertified value. It calls f n
/// times. Throws std::invalid_argument for n < 1.
template <scalar T, class F>
requires function_on<F, T>
[[nodiscard]] T gauss_chebyshev_sum(const F& f, long n, precision p) {
  if (n < 1) throw std::invalid_argument("gauss_chebyshev_sum: at least 1 node is needed");
  // With x = cos t the integral is that of f(cos t) over (0, pi), and the rule the trapezoidal one.
  return periodic_trapezoid_sum<T>(detail::function_of_cosine<F>{f}, n, p);
}

/// pi/(n+1) times the sum of sin(j pi/(n+1))^2 f(cos(j pi/(n+1))), j = 1 ... n, with p bits: about
/// the integral of f(x) sqrt(1 - x^2) over [-1, 1], and exactly so for polynomials of degree below
/// 2n. Otherwise as above.
template <scalar T, class F>
requires function_on<F, T>
[[nodiscard]] T gauss_chebyshev_second_sum(const F& f, long n, precision p) {
  if (n < 1) throw std::invalid_argument("gauss_chebyshev_second_sum: at least 1 node is needed");
  const T step(scalar_pi<T>(p) / (n + 1));
  const auto [sine, cosine] = sin_cos(step);
  const long pairs = n / 2;  // j and n + 1 - j; for odd n the node 0 is left
  const detail::circle_powers<T> at(cosine, sine, pairs + 1, p);
  T sum = n % 2 == 0 ? scalar_from<T>(0, p) : f(scalar_from<T>(0, p));
  for (long k = 1; k <= pairs; ++k) {
    const auto j = static_cast<std::size_t>(k);
    const T& node = at.cosines[j];
    T value = f(node);
    value += f(T(-node));
    detail::accumulate(sum, T(at.sines[j] * at.sines[j]), value);
  }
  return T(sum * step);
}

}  // namespace polhode
