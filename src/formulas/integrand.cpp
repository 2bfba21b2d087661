#include "polhode/formulas/integrand.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/evaluation.hpp"

namespace polhode {

namespace detail {

namespace {

// Found by their arguments, under names that no member of `supplement` hides.
tail_series nearly_minus_one(const tail_series& x) { return expm1(x); }
tail_series of_one_more(const tail_series& x) { return log1p(x); }

/// For series: what they lack is blocked, or made of what they have.
template <class Series>
struct series_supplement {
  static Series expm1(const Series& x) { return exp(x) - 1; }
  static Series log1p(const Series& x) { return log(x + 1); }
  static Series sinpi(const Series& x) { return sin(x * pi(128)); }
  static Series cospi(const Series& x) { return cos(x * pi(128)); }
  static Series abs(const Series& x) { return abs_of(x); }
  static Series floor(const Series& x) { return floor_of(x); }
  static Series ceil(const Series& x) { return ceil_of(x); }
  static Series min(const Series& x, const Series& y) { return min_of(x, y); }
  static Series max(const Series& x, const Series& y) { return max_of(x, y); }
  static Series hypot(const Series& x, const Series& y) { return sqrt(x * x + y * y); }
  static Series agm(const Series& x, const Series&) { return x.blocked("agm"); }
  static Series atan2(const Series& y, const Series&) { return y.blocked("atan2"); }
  static Series power_integer(const Series& x, long n) { return pow(x, n); }
  static Series power(const Series& x, const Series& y) { return pow(x, y); }
  /// Of odd n, of negative numbers too.
  static Series root(const Series& x, long n) {
    if (n % 2 != 0 && x.sign() < 0) return -pow(-x, rational(1, n));
    return pow(x, rational(1, n));
  }
  static Series gamma(const Series& x) { return x.blocked("gamma"); }
  static Series log_gamma(const Series& x) { return x.blocked("log_gamma"); }
  static Series erf(const Series& x) { return x.blocked("erf"); }
  static Series erfc(const Series& x) { return x.blocked("erfc"); }

 private:
  // Found by their arguments, under names that no member hides.
  static Series abs_of(const Series& x) {
    using polhode::abs;
    return abs(x);
  }
  static Series floor_of(const Series& x) {
    using polhode::floor;
    return floor(x);
  }
  static Series ceil_of(const Series& x) {
    using polhode::ceil;
    return ceil(x);
  }
  static Series min_of(const Series& x, const Series& y) {
    using polhode::min;
    return min(x, y);
  }
  static Series max_of(const Series& x, const Series& y) {
    using polhode::max;
    return max(x, y);
  }
};

}  // namespace

template <>
struct supplement<end_series> : series_supplement<end_series> {};
template <>
struct supplement<tail_series> : series_supplement<tail_series> {
  static tail_series expm1(const tail_series& x) { return nearly_minus_one(x); }
  static tail_series log1p(const tail_series& x) { return of_one_more(x); }
};

namespace {

// Found by their arguments, under names that no member of `supplement` hides.
#define POLHODE_OF_ONE(f) \
  symmetry f##_of(const symmetry& v) { return f(v); }
#define POLHODE_OF_TWO(f) \
  symmetry f##_of(const symmetry& u, const symmetry& v) { return f(u, v); }
POLHODE_OF_ONE(expm1)
POLHODE_OF_ONE(log1p)
POLHODE_OF_ONE(sinpi)
POLHODE_OF_ONE(cospi)
POLHODE_OF_ONE(abs)
POLHODE_OF_ONE(floor)
POLHODE_OF_ONE(ceil)
POLHODE_OF_ONE(gamma)
POLHODE_OF_ONE(log_gamma)
POLHODE_OF_ONE(erf)
POLHODE_OF_ONE(erfc)
POLHODE_OF_TWO(min)
POLHODE_OF_TWO(max)
POLHODE_OF_TWO(hypot)
POLHODE_OF_TWO(agm)
POLHODE_OF_TWO(atan2)
#undef POLHODE_OF_ONE
#undef POLHODE_OF_TWO
symmetry root_of(const symmetry& v, long n) { return root(v, n); }

/// What every arithmetic answers of a function that it has not.
constexpr auto not_available = [](const auto& v, const auto&, long) {
  using T = std::remove_cvref_t<decltype(v)>;
  constexpr const char* name = "a function of a formula";
  if constexpr (std::same_as<T, ball>) {
    return ball::undefined(v.precision());
  } else if constexpr (std::same_as<T, region>) {
    return region::blocked(obstacle::unknown, name);
  } else if constexpr (is_jet<T>::value) {
    return T::constant(ball::undefined(v[0].precision()), v.order());
  } else {
    return v.blocked(name);
  }
};

}  // namespace

template <>
struct supplement<symmetry> {
  static symmetry number(const rational& q) { return symmetry(q); }
  static symmetry constant(const instruction& i) {
    return i.what == operation::pi ? symmetry(pi_combination{0, 1}) : symmetry::some_constant();
  }
  static symmetry expm1(const symmetry& v) { return expm1_of(v); }
  static symmetry log1p(const symmetry& v) { return log1p_of(v); }
  static symmetry sinpi(const symmetry& v) { return sinpi_of(v); }
  static symmetry cospi(const symmetry& v) { return cospi_of(v); }
  static symmetry abs(const symmetry& v) { return abs_of(v); }
  static symmetry floor(const symmetry& v) { return floor_of(v); }
  static symmetry ceil(const symmetry& v) { return ceil_of(v); }
  static symmetry gamma(const symmetry& v) { return gamma_of(v); }
  static symmetry log_gamma(const symmetry& v) { return log_gamma_of(v); }
  static symmetry erf(const symmetry& v) { return erf_of(v); }
  static symmetry erfc(const symmetry& v) { return erfc_of(v); }
  static symmetry min(const symmetry& u, const symmetry& v) { return min_of(u, v); }
  static symmetry max(const symmetry& u, const symmetry& v) { return max_of(u, v); }
  static symmetry hypot(const symmetry& u, const symmetry& v) { return hypot_of(u, v); }
  static symmetry agm(const symmetry& u, const symmetry& v) { return agm_of(u, v); }
  static symmetry atan2(const symmetry& y, const symmetry& x) { return atan2_of(y, x); }
  static symmetry power_integer(const symmetry& v, long n) { return pow(v, n); }
  static symmetry power(const symmetry& u, const symmetry& v) { return pow(u, v); }
  static symmetry root(const symmetry& v, long n) { return root_of(v, n); }
  /// Under what leaves all arguments as they are, so is the value: as any function of them.
  static symmetry further(const further_function&, const std::vector<symmetry>& x) {
    symmetry all = x.front();
    for (const symmetry& v : x) all = agm_of(all, v);
    return gamma_of(all);
  }
};

/// As for balls.
template <>
struct supplement<angle> {
  using on_balls = supplement<ball>;

  static angle expm1(const angle& x) { return angle(on_balls::expm1(x.value())); }
  static angle log1p(const angle& x) { return angle(on_balls::log1p(x.value())); }
  static angle sinpi(const angle& x) { return angle(on_balls::sinpi(x.value())); }
  static angle cospi(const angle& x) { return angle(on_balls::cospi(x.value())); }
  static angle abs(const angle& x) { return angle(on_balls::abs(x.value())); }
  static angle floor(const angle& x) { return angle(on_balls::floor(x.value())); }
  static angle ceil(const angle& x) { return angle(on_balls::ceil(x.value())); }
  static angle gamma(const angle& x) { return angle(on_balls::gamma(x.value())); }
  static angle log_gamma(const angle& x) { return angle(on_balls::log_gamma(x.value())); }
  static angle erf(const angle& x) { return angle(on_balls::erf(x.value())); }
  static angle erfc(const angle& x) { return angle(on_balls::erfc(x.value())); }
  static angle min(const angle& x, const angle& y) { return of_two(on_balls::min, x, y); }
  static angle max(const angle& x, const angle& y) { return of_two(on_balls::max, x, y); }
  static angle hypot(const angle& x, const angle& y) { return of_two(on_balls::hypot, x, y); }
  static angle agm(const angle& x, const angle& y) { return of_two(on_balls::agm, x, y); }
  static angle atan2(const angle& y, const angle& x) { return of_two(on_balls::atan2, y, x); }
  static angle power_integer(const angle& x, long n) {
    return angle(on_balls::power_integer(x.value(), n));
  }
  static angle power(const angle& x, const angle& y) { return of_two(on_balls::power, x, y); }
  static angle root(const angle& x, long n) { return angle(on_balls::root(x.value(), n)); }
  static angle further(const further_function& f, const std::vector<angle>& x) {
    std::vector<ball> values;
    values.reserve(x.size());
    for (const angle& a : x) values.push_back(a.value());
    return angle(f.value(values));
  }

 private:
  static angle of_two(ball (*f)(const ball&, const ball&), const angle& x, const angle& y) {
    return angle(f(x.value(), y.value()));
  }
};
/// An operation that each arithmetic has in its own supplement.
#define POLHODE_RECORDED(f)                                                        \
  static recorded f(const recorded& x) {                                           \
    return x.applied(recorded_operation::of([](const auto& v, const auto&, long) { \
                       return supplement<std::remove_cvref_t<decltype(v)>>::f(v);  \
                     }),                                                           \
                     x);                                                           \
  }
#define POLHODE_RECORDED_OF_TWO(f)                                                   \
  static recorded f(const recorded& x, const recorded& y) {                          \
    return x.applied(recorded_operation::of([](const auto& v, const auto& w, long) { \
                       return supplement<std::remove_cvref_t<decltype(v)>>::f(v, w); \
                     }),                                                             \
                     y);                                                             \
  }
template <>
struct supplement<recorded> {
  POLHODE_RECORDED(expm1)
  POLHODE_RECORDED(log1p)
  POLHODE_RECORDED(gamma)
  POLHODE_RECORDED(log_gamma)
  POLHODE_RECORDED(erf)
  POLHODE_RECORDED(erfc)
  POLHODE_RECORDED_OF_TWO(hypot)
  POLHODE_RECORDED_OF_TWO(agm)
  POLHODE_RECORDED_OF_TWO(atan2)
  static recorded sinpi(const recorded& x) {
    return circular(
        x,
        [](const auto& v, const auto&, long) {
          return supplement<std::remove_cvref_t<decltype(v)>>::sinpi(v);
        },
        recorded_rule::sinpi);
  }
  static recorded cospi(const recorded& x) {
    return circular(
        x,
        [](const auto& v, const auto&, long) {
          return supplement<std::remove_cvref_t<decltype(v)>>::cospi(v);
        },
        recorded_rule::cospi);
  }
  static recorded abs(const recorded& x) { return size_of(x); }
  static recorded floor(const recorded& x) { return integer_below(x); }
  static recorded ceil(const recorded& x) { return integer_above(x); }
  static recorded min(const recorded& x, const recorded& y) { return smaller(x, y); }
  static recorded max(const recorded& x, const recorded& y) { return greater(x, y); }
  static recorded power_integer(const recorded& x, long n) { return pow(x, n); }
  static recorded power(const recorded& x, const recorded& y) {
    recorded_operation operation = recorded_operation::of([](const auto& v, const auto& w, long) {
      return supplement<std::remove_cvref_t<decltype(v)>>::power(v, w);
    });
    operation.rule = recorded_rule::power;
    return x.applied(operation, y);
  }
  static recorded root(const recorded& x, long n) {
    recorded_operation operation =
        recorded_operation::of([](const auto& v, const auto&, long order) {
          return supplement<std::remove_cvref_t<decltype(v)>>::root(v, order);
        });
    operation.rule = recorded_rule::root;
    return x.applied(operation, x, n);
  }
  static recorded further(const further_function&, const std::vector<recorded>& x) {
    return x.front().applied(recorded_operation::of(not_available), x.front());
  }

 private:
  template <class F>
  static recorded circular(const recorded& x, F f, recorded_rule rule) {
    recorded_operation operation = recorded_operation::of(f);
    operation.rule = rule;
    return x.applied(operation, x);
  }
  // Found by their arguments, under names that no member hides.
  static recorded size_of(const recorded& x) {
    using polhode::abs;
    return abs(x);
  }
  static recorded integer_below(const recorded& x) {
    using polhode::floor;
    return floor(x);
  }
  static recorded integer_above(const recorded& x) {
    using polhode::ceil;
    return ceil(x);
  }
  static recorded smaller(const recorded& x, const recorded& y) {
    using polhode::min;
    return min(x, y);
  }
  static recorded greater(const recorded& x, const recorded& y) {
    using polhode::max;
    return max(x, y);
  }
};
#undef POLHODE_RECORDED
#undef POLHODE_RECORDED_OF_TWO

/// What a jet of regions has beside its own functions: the value of the region's function, and its derivative. Not
/// available are those of gamma, log_gamma and agm.
template <>
struct supplement<jet<region, 1>> {
  using series = jet<region, 1>;
  using on_regions = supplement<region>;

  static series expm1(const series& x) { return with_value(exp(x), on_regions::expm1(x[0])); }
  static series log1p(const series& x) { return with_value(log(x + 1), on_regions::log1p(x[0])); }
  static series sinpi(const series& x) {
    return with_value(sin(x * pi(x[0].precision() + 64)), on_regions::sinpi(x[0]));
  }
  static series cospi(const series& x) {
    return with_value(cos(x * pi(x[0].precision() + 64)), on_regions::cospi(x[0]));
  }
  static series abs(const series& x) {
    const region value = on_regions::abs(x[0]);
    if (!value.is_analytic()) return constant(value);
    if (x[0].re().lower() > 0) return x;
    return x[0].re().upper() < 0 ? -x : not_available("abs");
  }
  static series floor(const series& x) { return constant(on_regions::floor(x[0])); }
  static series ceil(const series& x) { return constant(on_regions::ceil(x[0])); }
  static series min(const series& x, const series& y) {
    return chosen(x, y, on_regions::min(x[0], y[0]), y[0] - x[0]);
  }
  static series max(const series& x, const series& y) {
    return chosen(x, y, on_regions::max(x[0], y[0]), x[0] - y[0]);
  }
  static series hypot(const series& x, const series& y) { return sqrt(x * x + y * y); }
  static series agm(const series&, const series&) { return not_available("agm"); }
  static series atan2(const series& y, const series& x) {
    const series slope = (x * y[1] - y * x[1]) / (x * x + y * y);
    return from(on_regions::atan2(y[0], x[0]), slope[0]);
  }
  static series power_integer(const series& x, long n) { return pow(x, n); }
  static series power(const series& x, const series& y) {
    return with_value(exp(y * log(x)), on_regions::power(x[0], y[0]));
  }
  /// (z^(1/n))' = z^(1/n)/(n z) for every branch.
  static series root(const series& x, long n) {
    const region value = on_regions::root(x[0], n);
    return from(value, value * x[1] / (x[0] * n));
  }
  static series gamma(const series&) { return not_available("gamma"); }
  static series log_gamma(const series&) { return not_available("log_gamma"); }
  /// (2/sqrt(pi)) e^(-x^2) x'.
  static series erf(const series& x) { return from(on_regions::erf(x[0]), bell(x)); }
  static series erfc(const series& x) { return from(on_regions::erfc(x[0]), -bell(x)); }
  static series further(const further_function& f, const std::vector<series>&) {
    return not_available(f.what.name);
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
  /// x where Re distance > 0 on the whole region, y where it is < 0; the value says whether either is so.
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

}  // namespace detail

template class compiled_expression<jet<region, 1>>;
template class compiled_expression<angle>;
template class compiled_expression<symmetry>;
template class compiled_expression<end_series>;
template class compiled_expression<tail_series>;
template class compiled_expression<recorded>;

namespace {

/// Throws input_error unless f has at most so many variables.
void expect_variables(const expression& f, std::size_t most, const char* what) {
  const std::vector<std::string>& names = f.variables();
  if (names.size() <= most) return;
  throw input_error(
      fmt::format("the variables of the formula are {}; {}", fmt::join(names, ", "), what));
}

}  // namespace

detail::integrand integrand_of(const expression& f) {
  expect_variables(f, 1, "an integrand has one, its argument");
  constexpr precision series_bits = 192;
  detail::integrand result;
  result.over = [f, in_hardware = f.evaluator<region>(64)](const region& x) {
    return x.is_in_hardware() ? in_hardware(x) : f.evaluator<region>(x.precision())(x);
  };
  result.evaluator = [f](precision p) -> std::function<ball(const ball&)> {
    return f.evaluator<ball>(p);
  };
  result.angle_evaluator = [f](precision p) -> std::function<ball(const angle&)> {
    return [g = f.evaluator<angle>(p)](const angle& x) { return g(x).value(); };
  };
  result.near_end = f.evaluator<end_series>(series_bits);
  result.near_infinity = f.evaluator<tail_series>(series_bits);
  result.under = f.evaluator<symmetry>(series_bits);
  result.record = [f](const recorded& x, precision p) { return f.evaluator<recorded>(p)(x); };
  return result;
}

limit limit_of(const expression& f) {
  expect_variables(f, 0, "a limit has none");
  if (f.exact_value()) return limit(*f.exact_value());
  const symmetry value = f.evaluator<symmetry>(64)(symmetry());
  if (value.value()) return limit(*value.value());
  return limit([f](precision p) { return f.value(p); });
}

detail::complex_integrand complex_integrand_of(const expression& f) {
  expect_variables(f, 2, "an integrand along a path has its argument and the imaginary unit");
  const bool has_unit = f.variables().size() == 2;
  detail::complex_integrand result;
  result.over = [f, has_unit, in_hardware = f.evaluator<region>(64)](const region& z) {
    const auto value = [&](const auto& g, const region& unit) {
      if (!has_unit) return g(z);
      const std::array values{z, unit};
      return g(std::span<const region>(values));
    };
    if (z.is_in_hardware()) {
      return value(in_hardware, region(double_interval(0), double_interval(1)));
    }
    return value(f.evaluator<region>(z.precision()),
                 region::in_balls(complex_ball::i(z.precision())));
  };
  result.evaluator = [f,
                      has_unit](precision p) -> std::function<complex_ball(const complex_ball&)> {
    if (!has_unit) return f.evaluator<complex_ball>(p);
    return [g = f.evaluator<complex_ball>(p), i = complex_ball::i(p)](const complex_ball& z) {
      const std::array values{z, i};
      return g(std::span<const complex_ball>(values));
    };
  };
  return result;
}

namespace {

/// The argument and the parameters.
template <class T>
std::vector<T> with_argument(const T& x, std::vector<T> parameters) {
  parameters.insert(parameters.begin(), x);
  return parameters;
}

/// f at jets by the i-th parameter.
template <class T>
jet<T, 1> jet_of(const expression& f, const T& x, const detail::parameter_box& box, std::size_t i) {
  const detail::jets_by_parameter<T> jets(x, detail::parameters_like(box, x), i);
  const std::vector<jet<T, 1>> values = with_argument(jets.argument, jets.parameters);
  return f.evaluator<jet<T, 1>>(x.precision() + 64)(std::span<const jet<T, 1>>(values));
}

}  // namespace

detail::parametric_integrand parametric_integrand_of(const expression& f) {
  constexpr precision series_bits = 192;
  detail::parametric_integrand result;
  result.over_box = [f](const detail::parameter_box& box) {
    const auto at = [f, box](precision p) {
      return [g = f.evaluator<ball>(p),
              parameters = detail::parameters_like(box, ball(0, p))](const ball& x) {
        const std::vector<ball> values = with_argument(x, parameters);
        return g(std::span<const ball>(values));
      };
    };
    const auto with = [box](const auto& g) {
      return [g, box](const auto& x) {
        using T = std::remove_cvref_t<decltype(x)>;
        const std::vector<T> values = with_argument(x, detail::parameters_like(box, x));
        return g(std::span<const T>(values));
      };
    };
    detail::integrand of_box;
    of_box.over = [f, with, in_hardware = with(f.evaluator<region>(64))](const region& x) {
      return x.is_in_hardware() ? in_hardware(x) : with(f.evaluator<region>(x.precision()))(x);
    };
    of_box.evaluator = [at](precision p) -> std::function<ball(const ball&)> { return at(p); };
    of_box.near_end = with(f.evaluator<end_series>(series_bits));
    of_box.near_infinity = with(f.evaluator<tail_series>(series_bits));
    return of_box;
  };
  result.derivative = [f](const detail::parameter_box& box, std::size_t i) {
    return detail::integrand_without_series(
        [f, box, i](const auto& x) { return detail::slope_of(jet_of(f, x, box, i)); });
  };
  return result;
}

// ---------------------------------------------------------------------------------------------
// The integrals

integral integrate(const expression& f, const limit& a, const limit& b,
                   const integrate_options& options) {
  return detail::integrate_function(integrand_of(f), a, b, options);
}

contour_integral integrate_along(const expression& f, const path& along,
                                 const integrate_options& options) {
  const detail::complex_integrand g = complex_integrand_of(f);
  if (const auto name = f.function_not_analytic()) {
    contour_integral refused;
    refused.why = reason::not_analytic;
    refused.obstacle = fmt::format("{} is not analytic in the complex plane", *name);
    return refused;
  }
  return detail::integrate_path(g, along, options);
}

box_integral integrate_box(const expression& f, const limit& a, const limit& b,
                           const std::vector<parameter_range>& box, const box_options& options) {
  if (f.variables().size() != box.size() + 1) {
    throw input_error(
        fmt::format("the formula has {} variables and the box {} sides; it must have a side for "
                    "each variable behind the first",
                    f.variables().size(), box.size()));
  }
  return detail::integrate_function_over_box(parametric_integrand_of(f), a, b, box, options);
}

}  // namespace polhode
