// Formulas as functions whose roots are looked for.

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/evaluation.hpp"
#include "polhode/quadrature/growth_bound.hpp"
#include "polhode/roots/real_function.hpp"

namespace polhode {

namespace detail {
template <>
struct supplement<function_structure> {
  using series = function_structure::exact_series;

  // e^x - 1 and log(1 + x): exactly 0 where x is.
  static function_structure expm1(const function_structure& x) {
    return function_structure::applied(
        x, [](const auto& t) { return named<operation::expm1>::over(t); },
        [](const ball& t) { return std::optional<ball>(polhode::expm1(t)); },
        [](const series& t) { return exp(t) - 1; });
  }
  static function_structure log1p(const function_structure& x) {
    return function_structure::applied(
        x, [](const auto& t) { return named<operation::log1p>::over(t); },
        [](const ball& t) { return natural_domain::log1p(t); },
        [](const series& t) { return log(t + 1); });
  }
  static function_structure power(const function_structure& x, const function_structure& y) {
    return function_structure::applied_to_two(
        x, y, [](const auto& s, const auto& t) { return named<operation::power>::over(s, t); },
        natural_power);
  }
  static function_structure root(const function_structure& x, long n) {
    return function_structure::applied(
        x, [n](const auto& t) { return named<operation::root>::over(t, n); },
        [n](const ball& t) { return natural_domain::root(t, static_cast<unsigned long>(n)); },
        [n](const series& t) {
          const known_number value =
              t[0].is_exactly(0) || t[0].is_exactly(1)
                  ? t[0]
                  : known_number(named<operation::root>::over(t[0].enclosure(), n));
          return function_structure::value_alone(t, value);
        });
  }
  /// A new factor, over its natural domain, without a series.
  template <class F, class Range>
  static function_structure further(const F& f, const Range& x) {
    return function_structure::applied_to_many(
        {x.begin(), x.end()}, [&](const std::vector<jet<ball, 1>>& t) { return on_jets(f, t); },
        [&](const std::vector<ball>& t) { return f.value(t); });
  }

 private:
  static jet<ball, 1> on_jets(const further_function& f, const std::vector<jet<ball, 1>>& t) {
    return value_over<jet<ball, 1>>(f, t);
  }
  template <operation what>
  static jet<ball, 1> on_jets(const named<what>&, const std::vector<jet<ball, 1>>& t) {
    return named<what>::of(std::span<const jet<ball, 1>>(t));
  }
};

}  // namespace detail

template class compiled_expression<function_structure>;

real_function::real_function(const expression& f) {
  if (f.variables().size() > 1) {
    throw input_error(
        fmt::format("the variables of the formula are {}; roots are found of a function of one",
                    fmt::join(f.variables(), ", ")));
  }
  // Above this degree it is a function like others: exact arithmetic would take too long.
  constexpr long most_degree = 2000;
  if (auto q = f.quotient()) {
    long below = 0;
    for (const repeated_factor& d : q->divisors) {
      below += d.factor.degree() * std::max(d.multiplicity, 1L);
    }
    if (std::max(q->numerator.degree(), below) <= most_degree) {
      quotient_ = std::make_shared<const rational_quotient>(std::move(*q));
    }
  }
  using slope_type = jet<ball, 1>;
  using series_type = jet<ball, dynamic_order>;
  at_ = [f](precision p) {
    function_evaluator e;
    e.value = f.evaluator<ball>(p);
    e.slope = [g = f.evaluator<slope_type>(p)](const ball& x) {
      return g(slope_type::variable(x));
    };
    e.derivative = [slope = e.slope](const ball& x) { return slope(x)[1]; };
    e.series = [g = f.evaluator<series_type>(p)](const ball& x, int n) {
      return g(series_type::variable(x, n));
    };
    return e;
  };
  over_ = [f, in_hardware = f.evaluator<region>(64)](const region& x) {
    return x.is_in_hardware() ? in_hardware(x) : f.evaluator<region>(x.precision())(x);
  };
  structure_ = [f](const function_structure& x) {
    return f.evaluator<function_structure>(x.numerator().at_point.precision())(x);
  };
  // On 0 < t <= 1/4, where the argument is p + s t^q. An evaluator of its own for each call, as
  // several threads may ask at a time.
  const auto growth = [f](const rational& p, const rational& s, long q) {
    return f.evaluator<growth_bound>(192)(
        growth_bound::argument(known_number(p), known_number(s), q, 0.25));
  };
  // |f| >= c t^a with c > 0.
  const auto has_no_root = [](const growth_bound& bound) {
    return !bound.is_blocked() && !bound.least_factor().is_zero();
  };
  no_root_beside_ = [growth, has_no_root](const rational& at, const rational& width) {
    const growth_bound bound = growth(at, 4 * width, 1);
    return bound.is_nowhere_defined() || has_no_root(bound);
  };
  // x = (from/4)/t is beyond `from`. Where f is not defined there, that is to be said: no proof.
  no_root_beyond_ = [growth, has_no_root](const rational& from) {
    return has_no_root(growth(0, from / 4, -1));
  };
}

}  // namespace polhode
