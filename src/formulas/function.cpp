#include "polhode/formulas/function.hpp"

#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/evaluation.hpp"
#include "polhode/formulas/integrand.hpp"

namespace polhode {

namespace detail {
namespace {

/// A function of the supplement: over jets of balls and balls, and over its natural domain.
#define POLHODE_SUPPLEMENTED(f, domain)                                         \
  static function_structure f(const function_structure& x) {                    \
    return function_structure::applied(                                         \
        x, [](const auto& t) { return on<decltype(t)>::f(t); },                 \
        [](const ball& t) { return std::optional<ball>(domain(t)); }, nullptr); \
  }
#define POLHODE_SUPPLEMENTED_TWO(f, domain)                                               \
  static function_structure f(const function_structure& x, const function_structure& y) { \
    return function_structure::applied_to_two(                                            \
        x, y, [](const auto& s, const auto& t) { return on<decltype(s)>::f(s, t); },      \
        [](const ball& s, const ball& t) { return std::optional<ball>(domain(s, t)); });  \
  }

template <class T>
using on = supplement<std::remove_cvref_t<T>>;
using on_balls = supplement<ball>;
using series = function_structure::exact_series;

// Found by their arguments, under names that no member of `supplement` hides.
function_structure size_of(const function_structure& x) { return abs(x); }
function_structure step_below(const function_structure& x) { return floor(x); }
function_structure step_above(const function_structure& x) { return ceil(x); }
function_structure lesser(const function_structure& x, const function_structure& y) {
  return min(x, y);
}
function_structure greater(const function_structure& x, const function_structure& y) {
  return max(x, y);
}
function_structure error_function(const function_structure& x) { return erf(x); }
function_structure complementary(const function_structure& x) { return erfc(x); }

}  // namespace

template <>
struct supplement<function_structure> {
  // e^x - 1 and log(1 + x): exactly 0 where x is.
  static function_structure expm1(const function_structure& x) {
    return function_structure::applied(
        x, [](const auto& t) { return on<decltype(t)>::expm1(t); },
        [](const ball& t) { return std::optional<ball>(on_balls::expm1(t)); },
        [](const series& t) { return exp(t) - 1; });
  }
  static function_structure log1p(const function_structure& x) {
    return function_structure::applied(
        x, [](const auto& t) { return on<decltype(t)>::log1p(t); },
        [](const ball& t) { return natural_domain::log1p(t); },
        [](const series& t) { return log(t + 1); });
  }
  POLHODE_SUPPLEMENTED(sinpi, on_balls::sinpi)
  POLHODE_SUPPLEMENTED(cospi, on_balls::cospi)
  POLHODE_SUPPLEMENTED(gamma, on_balls::gamma)
  POLHODE_SUPPLEMENTED(log_gamma, on_balls::log_gamma)
  POLHODE_SUPPLEMENTED_TWO(hypot, on_balls::hypot)
  POLHODE_SUPPLEMENTED_TWO(agm, on_balls::agm)
  POLHODE_SUPPLEMENTED_TWO(atan2, on_balls::atan2)
  POLHODE_SUPPLEMENTED_TWO(power, natural_power)
  static function_structure further(const further_function& f,
                                    const std::vector<function_structure>& x) {
    return function_structure::applied_to_many(
        x, [&](const std::vector<jet<ball, 1>>& t) { return value_of_further(f, t); },
        [&](const std::vector<ball>& t) { return f.value(t); });
  }
  static function_structure abs(const function_structure& x) { return size_of(x); }
  static function_structure floor(const function_structure& x) { return step_below(x); }
  static function_structure ceil(const function_structure& x) { return step_above(x); }
  static function_structure min(const function_structure& x, const function_structure& y) {
    return lesser(x, y);
  }
  static function_structure max(const function_structure& x, const function_structure& y) {
    return greater(x, y);
  }
  static function_structure erf(const function_structure& x) { return error_function(x); }
  static function_structure erfc(const function_structure& x) { return complementary(x); }
  static function_structure power_integer(const function_structure& x, long n) { return pow(x, n); }
  static function_structure root(const function_structure& x, long n) {
    return function_structure::applied(
        x, [n](const auto& t) { return on<decltype(t)>::root(t, n); },
        [n](const ball& t) { return natural_domain::root(t, static_cast<unsigned long>(n)); },
        [n](const series& t) {
          const known_number value = t[0].is_exactly(0) || t[0].is_exactly(1)
                                         ? t[0]
                                         : known_number(on_balls::root(t[0].enclosure(), n));
          return function_structure::value_alone(t, value);
        });
  }
};
#undef POLHODE_SUPPLEMENTED
#undef POLHODE_SUPPLEMENTED_TWO

}  // namespace detail

template class compiled_expression<function_structure>;

real_function function_of(const expression& f) {
  if (f.variables().size() > 1) {
    throw input_error(
        fmt::format("the variables of the formula are {}; roots are found of a function of one",
                    fmt::join(f.variables(), ", ")));
  }
  return {f};
}

range_end range_end_of(const expression& f) {
  if (const auto form = limit_of(f).form()) return range_end(*form);
  return range_end([f](precision p) { return f.value(p); });
}

root_set isolate_roots(const expression& f, const range_end& lower, const range_end& upper,
                       const isolate_options& options) {
  return isolate_roots(function_of(f), lower, upper, options);
}

}  // namespace polhode
