#include <algorithm>
#include <chrono>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/rules/double_exponential_plan.hpp"
#include "quadrature/rules/rules.hpp"

namespace polhode::detail {

namespace {

/// What the series of f at an end says, from one that reaches far: the farther it reaches, the
/// higher the rectangle that can be proved. Nothing where f has none.
std::optional<end_growth> growth_at(const integrand& f, const rational& end, bool is_left,
                                    const rational& length) {
  for (const rational& part : {rational(15, 16), rational(3, 4), rational(1, 2), rational(1, 4),
                               rational(1, 16), rational(1, 256)}) {
    const double reach = double_interval(rational(length * part)).midpoint();
    const end_series x =
        end_series::argument(known_number(end), known_number(rational(is_left ? 1 : -1)), 1, reach);
    if (std::optional<end_growth> found = growth_from_series(f.near_end(x), reach)) return found;
  }
  return std::nullopt;
}

/// Encloses the integral of f over (a, b), a < b, in a ball of radius at most 2^-bits. Verdicts:
/// certified; not_certified with not_analytic, also where there is no series at an end,
/// not_integrable where that says that f grows too fast, evaluation_limit, precision_limit,
/// not_defined (f is undefined at a node).
line_integral integral_over_line(const integrand& f, const rational& a, const rational& b,
                                 long bits, const trapezoid_options& options) {
  const rational length = b - a;
  line_integral result;
  const std::optional<end_growth> at_a = growth_at(f, a, true, length);
  const std::optional<end_growth> at_b = growth_at(f, b, false, length);
  if (!at_a || !at_b) {
    result.why = reason::not_analytic;
    return result;
  }
  if (at_a->exponent <= -1 || at_b->exponent <= -1) {
    result.why = reason::not_integrable;
    return result;
  }
  double_exponential_problem problem{a, b, {}, *at_a, *at_b};
  problem.over = [&](const region& u, const region& v) {
    // Which of the two ends x is computed from makes no difference to the set that it is in.
    const bool nearer_to_a = u.magnitude_upper() < v.magnitude_upper();
    return f.over(nearer_to_a ? a + u : b - v);
  };
  const double range = range_for(problem, bits + 3);
  if (range == 0) {
    result.why = reason::precision_limit;
    return result;
  }
  long evaluations = 0;
  constexpr double highest = 1.5;  // < pi/2
  line_plan plan =
      plan_trapezoid([&](double d) { return problem.rectangle(range, d, evaluations); },
                     rational(2 * rational(range)), highest, bits + 2, options.most_nodes);
  plan.region_evaluations = evaluations;
  const auto sum = [&](long n, precision p) {
    return double_exponential_sum<ball>(f.evaluator(p), a, b, rational(range), n, p);
  };
  return carry_out(std::move(plan), sum, bits, problem.beyond(range), options);
}

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

/// The integral of f from a to b, a < b as far as is known. not_applicable where the limits are not
/// two rational numbers, where f has no series at one of them, or where f after the substitution is
/// not proved analytic in a rectangle.
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
  trapezoid_options limits;
  limits.most_nodes = options.most_evaluations;
  if (options.most_precision) limits.most_precision = *options.most_precision;
  const long digit_bits = bits_for_digits(options.digits) + 2;
  const ball power = pow(ball(10, 64), options.digits);
  // A short one first, to see how large the value is; a value below 10^-digits stays out of reach.
  long bits = std::min(digit_bits, 40L);
  const auto start = clock::now();
  for (int attempts = 0; attempts < 4; ++attempts) {
    const line_integral line = integral_over_line(f, *a.exact(), *b.exact(), bits, limits);
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

class double_exponential final : public quadrature_strategy {
 public:
  [[nodiscard]] std::string_view name() const override { return "double exponential"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "tanh-sinh, between rational limits";
  }
  [[nodiscard]] std::optional<integral> attempt(const integrand& f, const end_point& a,
                                                const end_point& b,
                                                const integrate_options& options) const override {
    return integrate_by_double_exponential(f, a, b, options);
  }
};

}  // namespace

const quadrature_strategy& double_exponential_rule() {
  static const double_exponential rule;
  return rule;
}

}  // namespace polhode::detail
