#include "insisted_double_exponential.hpp"

#include <algorithm>
#include <chrono>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/double_exponential.hpp"

namespace polhode::detail {

namespace {

/// An integrand as one generic function object.
struct generic_integrand {
  const integrand* f;

  [[nodiscard]] region operator()(const region& x) const { return f->over(x); }
  [[nodiscard]] end_series operator()(const end_series& x) const { return f->near_end(x); }
  template <class T>
  requires std::same_as<T, ball>
  [[nodiscard]] auto evaluator(precision p) const { return f->evaluator(p); }
};

std::string obstacle_of(reason why) {
  switch (why) {
    case reason::not_analytic:
      return "the double exponential rule needs a series of the integrand at both limits, and a "
             "rectangle in which it is proved analytic after the substitution";
    case reason::not_integrable:
      return "the integrand grows too fast at a limit";
    case reason::evaluation_limit:
      return "more evaluations needed than allowed";
    case reason::not_defined:
      return "the integrand is undefined at a node of the double exponential rule, as where it is "
             "singular at a limit other than 0, from which nodes are told apart too late";
    default:
      return {};
  }
}

}  // namespace

integral integrate_by_double_exponential(const integrand& f, const end_point& a, const end_point& b,
                                         const integrate_options& options) {
  using clock = std::chrono::steady_clock;
  integral result;
  if (!a.exact() || !b.exact()) {
    result.why = reason::not_applicable;
    result.obstacle = "the double exponential rule needs rational limits";
    return result;
  }
  result.account.rules = {quadrature_rule::double_exponential};
  result.account.panels = 1;
  line_options limits;
  limits.most_nodes = options.most_evaluations;
  if (options.most_precision) limits.most_precision = *options.most_precision;
  const long digit_bits = bits_for_digits(options.digits) + 2;
  const ball power = pow(ball(10, 64), options.digits);
  // A short one first, to see how large the value is; a value below 10^-digits stays out of reach.
  long bits = std::min(digit_bits, 40L);
  const auto start = clock::now();
  for (int attempts = 0; attempts < 4; ++attempts) {
    const line_integral line = integrate_double_exponential(
        generic_integrand{&f}, *a.exact(), *b.exact(), bits, std::nullopt, std::nullopt, limits);
    integral_account& account = result.account;
    account.evaluations += line.evaluations;
    account.region_evaluations += line.plan.region_evaluations;
    account.most_nodes = std::max(account.most_nodes, line.plan.nodes);
    account.precision = std::max(account.precision, line.precision);
    account.seconds_for_sums = std::chrono::duration<double>(clock::now() - start).count();
    if (line.enclosure.is_bounded()) result.enclosure = line.enclosure;
    if (line.verdict != status::certified) {
      result.why = line.why == reason::not_analytic ? reason::not_applicable : line.why;
      result.obstacle = obstacle_of(line.why);
      return result;
    }
    const magnitude radius = result.enclosure.radius();
    const bool relative =
        multiply_up(radius, power.magnitude_upper()) <= result.enclosure.magnitude_lower();
    const bool absolute =
        options.absolute_exponent && radius <= magnitude::power_of_two(*options.absolute_exponent);
    if (relative || absolute) {
      result.verdict = status::certified;
      return result;
    }
    const magnitude value = result.enclosure.magnitude_upper();
    const auto size = value.is_zero() ? -digit_bits : static_cast<long>(value.log2_floor());
    const long wanted = digit_bits + 2 - std::max(size, -digit_bits);
    if (wanted <= bits) break;
    bits = wanted;
  }
  result.why = reason::precision_limit;
  return result;
}

}  // namespace polhode::detail
