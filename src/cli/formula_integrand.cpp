#include "formula_integrand.hpp"

#include <array>
#include <span>

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

}  // namespace detail

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

}  // namespace cli
}  // namespace polhode
