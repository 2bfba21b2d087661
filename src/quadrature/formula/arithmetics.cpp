// Formulas in the arithmetics of quadrature: what these have under other names than those of a
// formula's functions, or by way of other functions.

#include "quadrature/formula/arithmetics.hpp"

#include <array>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/expression/evaluation.hpp"
#include "polhode/expression/library_functions.hpp"

namespace polhode {

namespace detail {

/// What both kinds of series make of what they have; what they have not is blocked.
template <class Series>
struct series_supplement {
  static Series sinpi(const Series& x) { return sin(x * known_number(pi_combination{0, 1})); }
  static Series cospi(const Series& x) { return cos(x * known_number(pi_combination{0, 1})); }
  static Series hypot(const Series& x, const Series& y) { return sqrt(x * x + y * y); }
  /// Of odd n, of negative numbers too.
  static Series root(const Series& x, long n) {
    if (n % 2 != 0 && x.sign() < 0) return -pow(-x, rational(1, n));
    return pow(x, rational(1, n));
  }
};

/// A formula in these names over a kind of series.
template <class Series>
Series formula_over(const std::string& text, std::vector<std::string> names,
                    const std::vector<Series>& x) {
  constexpr precision p = 192;
  const expression formula(text, {std::move(names), {}, library_functions()});
  return formula.evaluator<Series>(p)(std::span<const Series>(x));
}

template <class Series>
bool is_unknown(const Series& x) {
  return x.is_blocked();
}
bool is_unknown(const growth_bound& x) { return x.is_unknown(); }

/// A function of size at most `bound`, which is a series in these arguments.
template <class Series, class F>
std::optional<Series> of_size(const F& f, const Series& bound) {
  if (is_unknown(bound)) return std::nullopt;
  constexpr precision p = 192;
  return bound * bound.bounded_like(name_of_function(f), hull(ball(-1, p), ball(1, p)));
}

/// The same of an f that oscillates with x.
template <class Series, class F>
std::optional<Series> of_size(const F& f, const Series& bound, const Series& x, bool oscillates) {
  auto result = of_size(f, bound);
  if constexpr (std::same_as<Series, growth_bound>) {
    if (result && oscillates) return result->oscillating_as(x);
  }
  return result;
}

/// f(x) over a kind of series where the last argument tends to 0 or grows, by f's leading term
/// there. None where f has none.
template <class Series, class F>
std::optional<Series> by_leading_term(const F& f, const std::vector<Series>& x,
                                      const std::vector<ball>& values) {
  if constexpr (requires { f.near_zero; }) {
    constexpr long far = 4;
    const Series& last = x.back();
    const ball& size = values.back();
    const int sign = last.sign();
    if (sign == 0) return std::nullopt;
    const bool is_near = contains_zero(size) && certainly_less_equal(2 * abs(size), ball(1, 64));
    const Series positive = sign > 0 ? last : -last;
    const bool is_far =
        !size.is_bounded() && (positive - positive.constant_like(rational(far))).sign() > 0;
    const auto& known = is_near ? f.near_zero : f.near_infinity;
    if (!known || !(is_near || is_far)) return std::nullopt;
    const auto near = known(std::span(values).first(values.size() - 1), sign);
    if (!near) return std::nullopt;
    const auto names = argument_names(f.what);
    const auto rest = of_size(f, formula_over(near->rest, names, x), last, near->oscillates);
    if (!rest) return std::nullopt;
    const Series main = formula_over(near->main, names, x);
    // A wave that the series cannot follow may still have a bound.
    if (near->oscillates && is_unknown(main)) return std::nullopt;
    return main + *rest;
  } else {
    return std::nullopt;
  }
}

/// f(x) by its majorant. None where f has none.
template <class Series, class F>
std::optional<Series> by_majorant(const F& f, const std::vector<Series>& x,
                                  const std::vector<ball>& values) {
  if constexpr (requires { f.majorant; }) {
    const int sign = x.back().sign();
    if (!f.majorant || sign == 0) return std::nullopt;
    const auto known = f.majorant(std::span(values).first(values.size() - 1), sign);
    if (!known) return std::nullopt;
    return of_size(f, formula_over(known->text, argument_names(f.what), x), x.back(),
                   known->oscillates);
  } else {
    return std::nullopt;
  }
}

/// f(x), of which no argument is blocked, by its leading term; else by its values over those of x,
/// where they are bounded; else by its majorant.
template <class Series, class F, class Range>
Series of_values(const F& f, const Range& arguments, const std::vector<ball>& values) {
  const std::vector<Series> x(arguments.begin(), arguments.end());
  if (auto result = by_leading_term(f, x, values)) return *std::move(result);
  const ball value = f.value(values);
  if (!value.is_bounded()) {
    if (auto result = by_majorant(f, x, values)) return *std::move(result);
  }
  return x.front().bounded_like(name_of_function(f), value);
}

template <>
struct supplement<tail_series> : series_supplement<tail_series> {
  template <class F, class Range>
  static tail_series further(const F& f, const Range& x) {
    std::vector<ball> values;
    values.reserve(x.size());
    for (const tail_series& v : x) {
      if (v.is_blocked()) return v;
      values.push_back(v.values());
    }
    return of_values<tail_series>(f, x, values);
  }
};
template <>
struct supplement<end_series> : series_supplement<end_series> {
  static end_series expm1(const end_series& x) { return exp(x) - 1; }
  static end_series log1p(const end_series& x) { return log(x + 1); }
  /// By its derivative; where x tends to -k by Gamma(x) = Gamma(x + k + 1)/(x (x+1) ... (x+k)).
  static end_series gamma(const end_series& x) {
    if (x.is_blocked() || !has_digamma()) return x.is_blocked() ? x : end_series::blocked("gamma");
    const std::optional<long> pole = pole_of_gamma(x);
    if (!pole) {
      static const further_function by_slope =
          of_gamma("gamma", "gamma(x)*digamma(x)", [](const auto& t) { return polhode::gamma(t); });
      return of_derivative(by_slope, {}, x);
    }
    end_series product = x;
    for (long k = 1; k <= *pole; ++k) product = product * (x + k);
    return gamma(x + (*pole + 1)) / product;
  }
  /// By its derivative; where x tends to 0 by log Gamma(x) = log Gamma(x + 1) - log x.
  static end_series log_gamma(const end_series& x) {
    if (x.is_blocked() || !has_digamma()) {
      return x.is_blocked() ? x : end_series::blocked("log_gamma");
    }
    const std::optional<long> pole = pole_of_gamma(x);
    if (pole) return *pole == 0 ? log_gamma(x + 1) - log(x) : end_series::blocked("log_gamma");
    static const further_function by_slope =
        of_gamma("log_gamma", "digamma(x)", [](const auto& t) { return polhode::log_gamma(t); });
    return of_derivative(by_slope, {}, x);
  }
  /// Of a function that has a formula for its derivative, with rational constants for its first
  /// arguments.
  template <class F, class Range>
  static end_series further(const F& f, const Range& x) {
    const std::string_view name = name_of_function(f);
    if constexpr (requires { f.slope; }) {
      std::vector<rational> first;
      for (const end_series& v : x) {
        if (v.is_blocked()) return v;
        if (first.size() + 1 == x.size()) break;
        const std::optional<rational> q = v.rational_constant();
        if (!q) break;
        first.push_back(*q);
      }
      if (first.size() + 1 == x.size()) {
        if (auto result = at_pole(f, first, {x.begin(), x.end()})) return *std::move(result);
        if (!f.slope.empty()) return of_derivative(f, first, x.back());
      }
    }
    return end_series::blocked(name);
  }

 private:
  static bool has_digamma() { return !arb_functions()->empty(); }
  /// A function of the table, as one with a formula for its derivative.
  template <class F>
  static further_function of_gamma(const char* name, const char* slope, const F& f) {
    further_function result;
    result.what = {name, "x", "", ""};
    result.slope = slope;
    result.value = [f](std::span<const ball> x) { return f(x[0]); };
    result.over_regions = [f](std::span<const region> x) { return f(x[0]); };
    return result;
  }
  /// k where x tends to -k, of few.
  static std::optional<long> pole_of_gamma(const end_series& x) {
    constexpr long most = 50;
    const auto start = x.tends_to_0() ? std::optional(0L) : x.exact_value_at_0();
    if (!start || *start > 0 || *start < -most) return std::nullopt;
    return -*start;
  }
  /// Where the last argument tends to a pole of f.
  static std::optional<end_series> at_pole(const further_function& f,
                                           const std::vector<rational>& first,
                                           const std::vector<end_series>& x) {
    if (!f.at_pole) return std::nullopt;
    const std::optional<long> pole = pole_of_gamma(x.back());
    if (!pole) return std::nullopt;
    std::vector<ball> orders;
    orders.reserve(first.size());
    for (const rational& q : first) orders.emplace_back(q, 192);
    const auto text = f.at_pole(orders, *pole);
    return text ? std::optional(formula_over(*text, argument_names(f.what), x)) : std::nullopt;
  }
  static end_series of_derivative(const further_function& f, const std::vector<rational>& first,
                                  const end_series& x) {
    const expression slope(f.slope, {argument_names(f.what), {}, library_functions()});
    const auto with_first = [&](const auto& last) {
      std::vector<std::remove_cvref_t<decltype(last)>> all;
      all.reserve(first.size() + 1);
      for (const rational& q : first) all.push_back(last.constant_like(q));
      all.push_back(last);
      return all;
    };
    constexpr precision p = 192;
    const auto value = [&](const known_number& at) {
      std::string call = f.what.name + "(";
      std::vector<ball> balls;
      for (const rational& q : first) {
        call += q.str() + ", ";
        balls.emplace_back(q, p);
      }
      balls.push_back(at.enclosure());
      if (!at.exact()) return known_number(f.value(balls));
      // As formulas have it: exactly, where that is known.
      call += at.exact()->str() + ")";
      try {
        return expression(call, {{}, {}, library_functions()}).known_value(p);
      } catch (const expression_error&) {
        return known_number(ball::undefined(p));
      }
    };
    const auto over = [&](const region& z) {
      std::vector<region> arguments;
      arguments.reserve(first.size() + 1);
      for (const rational& q : first) arguments.push_back(constant_region(q, z));
      arguments.push_back(z);
      return f.over_regions(arguments);
    };
    return x.composed(f.what.name, value, over, [&](const end_series& y) {
      return slope.evaluator<end_series>(p)(with_first(y));
    });
  }
};

template <>
struct supplement<symmetry> {
  static symmetry number(const rational& q) { return symmetry(q); }
  static symmetry constant(const instruction& i) {
    return i.what == operation::pi ? symmetry(pi_combination{0, 1}) : symmetry::some_constant();
  }
  /// Under what leaves all arguments as they are, so is the value: as any function of them.
  template <class F, class Range>
  static symmetry further(const F&, const Range& x) {
    symmetry all = x.front();
    for (const symmetry& v : x) all = agm(all, v);
    return gamma(all);
  }
};

/// As for balls.
template <>
struct supplement<angle> {
  template <class F, class Range>
  static angle further(const F& f, const Range& x) {
    std::vector<ball> values;
    values.reserve(x.size());
    for (const angle& a : x) values.push_back(a.value());
    return angle(f.value(values));
  }
};

/// What a jet of regions has beside its own functions: the value of the region's function, and its
/// derivative. Not available are those of gamma, log_gamma and agm.
template <>
struct supplement<jet<region, 1>> {
  using series = jet<region, 1>;

  static series expm1(const series& x) {
    return with_value(exp(x), named<operation::expm1>::over(x[0]));
  }
  static series log1p(const series& x) {
    return with_value(log(x + 1), named<operation::log1p>::over(x[0]));
  }
  static series sinpi(const series& x) {
    return with_value(sin(x * pi(x[0].precision() + 64)), named<operation::sinpi>::over(x[0]));
  }
  static series cospi(const series& x) {
    return with_value(cos(x * pi(x[0].precision() + 64)), named<operation::cospi>::over(x[0]));
  }
  static series abs(const series& x) {
    const region value = named<operation::abs>::over(x[0]);
    if (!value.is_analytic()) return constant(value);
    if (x[0].re().lower() > 0) return x;
    return x[0].re().upper() < 0 ? -x : not_available("abs");
  }
  static series floor(const series& x) { return constant(named<operation::floor>::over(x[0])); }
  static series ceil(const series& x) { return constant(named<operation::ceil>::over(x[0])); }
  static series min(const series& x, const series& y) {
    return chosen(x, y, named<operation::min>::over(x[0], y[0]), y[0] - x[0]);
  }
  static series max(const series& x, const series& y) {
    return chosen(x, y, named<operation::max>::over(x[0], y[0]), x[0] - y[0]);
  }
  static series hypot(const series& x, const series& y) { return sqrt(x * x + y * y); }
  static series atan2(const series& y, const series& x) {
    const series slope = (x * y[1] - y * x[1]) / (x * x + y * y);
    return from(named<operation::atan2>::over(y[0], x[0]), slope[0]);
  }
  static series power(const series& x, const series& y) {
    return with_value(exp(y * log(x)), named<operation::power>::over(x[0], y[0]));
  }
  /// (z^(1/n))' = z^(1/n)/(n z) for every branch.
  static series root(const series& x, long n) {
    const region value = named<operation::root>::over(x[0], n);
    return from(value, value * x[1] / (x[0] * n));
  }
  /// (2/sqrt(pi)) e^(-x^2) x'.
  static series erf(const series& x) { return from(named<operation::erf>::over(x[0]), bell(x)); }
  static series erfc(const series& x) { return from(named<operation::erfc>::over(x[0]), -bell(x)); }
  template <class F, class Range>
  static series further(const F& f, const Range&) {
    return not_available(name_of_function(f));
  }

 private:
  static series from(const region& value, const region& slope) {
    series result;
    result[0] = value;
    result[1] = slope;
    return result;
  }
  static series with_value(series x, const region& value) {
    x[0] = value;
    return x;
  }
  static series constant(const region& value) { return from(value, value * 0); }
  static series not_available(std::string_view name) {
    return constant(region::blocked(obstacle::unknown, name));
  }
  /// x where Re distance > 0 on the whole region, y where it is < 0; the value says whether either
  /// is so.
  static series chosen(const series& x, const series& y, const region& value,
                       const region& distance) {
    if (!value.is_analytic()) return constant(value);
    if (distance.re().lower() > 0) return x;
    return distance.re().upper() < 0 ? y : not_available("min or max");
  }
  static region bell(const series& x) {
    const precision p = x[0].precision() + 64;
    return exp(-square(x[0])) * x[1] * (2 / sqrt(pi(p)));
  }
};

template <>
struct supplement<growth_bound> {
  static growth_bound sinpi(const growth_bound& x) { return sin(x * half_turn(x)); }
  static growth_bound cospi(const growth_bound& x) { return cos(x * half_turn(x)); }
  static growth_bound expm1(const growth_bound& x) { return exp(x) - x.constant_like(rational(1)); }
  static growth_bound log1p(const growth_bound& x) { return log(x + x.constant_like(rational(1))); }
  static growth_bound sinh(const growth_bound& x) {
    return (exp(x) - exp(-x)) * x.constant_like(rational(1, 2));
  }
  static growth_bound cosh(const growth_bound& x) {
    return (exp(x) + exp(-x)) * x.constant_like(rational(1, 2));
  }
  static growth_bound hypot(const growth_bound& x, const growth_bound& y) {
    return sqrt(x * x + y * y);
  }
  template <class F, class Range>
  static growth_bound further(const F& f, const Range& x) {
    std::vector<ball> values;
    values.reserve(x.size());
    for (const growth_bound& v : x) {
      if (v.is_unknown())
        return v.is_nowhere_defined() ? v : growth_bound::blocked(name_of_function(f));
      values.push_back(v.values());
    }
    return of_values<growth_bound>(f, x, values);
  }

 private:
  static growth_bound half_turn(const growth_bound& x) {
    return x.constant_like(known_number(pi_combination{0, 1}));
  }
};

/// Not known are the functions that complex_ball.hpp has not.
template <>
struct supplement<analytic_ball> {
  template <class F, class Range>
  static analytic_ball further(const F&, const Range& x) {
    const analytic_ball& any = x.front();
    return analytic_ball(complex_ball::undefined(any.precision()));
  }
};

template <class T>
T value_of_operation(const formula_node& node, const T& x, const T& y) {
  T result;
  execute<T>(instruction{node.what, 0, 0, 0, node.number}, result, x, y);
  return result;
}
template <class T>
T value_of_call(const further_function& f, const std::vector<T>& operands) {
  return value_over<T>(f, operands);
}
#define POLHODE_NODES_OVER(T)                                                         \
  template T value_of_operation<T>(const formula_node& node, const T& x, const T& y); \
  template T value_of_call<T>(const further_function& f, const std::vector<T>& operands);
POLHODE_NODES_OVER(ball)
POLHODE_NODES_OVER(slope_jet)
POLHODE_NODES_OVER(region)
POLHODE_NODES_OVER(end_series)
#undef POLHODE_NODES_OVER

bool is_known_over_analytic_balls(operation what) {
  switch (what) {
#define POLHODE_KNOWN(f, ...) \
  case operation::f:          \
    return named<operation::f>::is_own<analytic_ball>;
    POLHODE_FUNCTION_TABLE(POLHODE_KNOWN, POLHODE_KNOWN, POLHODE_KNOWN, POLHODE_NO_ROW)
    POLHODE_KNOWN(power)
#undef POLHODE_KNOWN
    default:
      return false;
  }
}

}  // namespace detail

template class compiled_expression<jet<region, 1>>;
template class compiled_expression<angle>;
template class compiled_expression<symmetry>;
template class compiled_expression<end_series>;
template class compiled_expression<growth_bound>;
template class compiled_expression<tail_series>;
template class compiled_expression<analytic_ball>;

}  // namespace polhode
