#include "formula_integrand.hpp"

#include <array>
#include <span>
#include <vector>

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
template class compiled_expression<end_series>;
template class compiled_expression<tail_series>;

namespace cli {

detail::integrand integrand_of(const expression& f) {
  constexpr precision series_bits = 192;
  detail::integrand result;
  result.over = [f, in_hardware = f.evaluator<region>(64)](const region& x) {
    return x.is_in_hardware() ? in_hardware(x) : f.evaluator<region>(x.precision())(x);
  };
  result.evaluator = [f](precision p) -> std::function<ball(const ball&)> {
    return f.evaluator<ball>(p);
  };
  result.near_end = f.evaluator<end_series>(series_bits);
  result.near_infinity = f.evaluator<tail_series>(series_bits);
  return result;
}

detail::complex_integrand complex_integrand_of(const expression& f) {
  detail::complex_integrand result;
  result.over = [f, in_hardware = f.evaluator<region>(64)](const region& z) {
    if (z.is_in_hardware()) {
      const std::array values{z, region(double_interval(0), double_interval(1))};
      return in_hardware(std::span<const region>(values));
    }
    const std::array values{z, region::in_balls(complex_ball::i(z.precision()))};
    return f.evaluator<region>(z.precision())(std::span<const region>(values));
  };
  result.evaluator = [f](precision p) -> std::function<complex_ball(const complex_ball&)> {
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

}  // namespace cli
}  // namespace polhode
