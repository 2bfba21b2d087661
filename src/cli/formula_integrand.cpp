#include "formula_integrand.hpp"

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
  POLHODE_RECORDED(sinpi)
  POLHODE_RECORDED(cospi)
  POLHODE_RECORDED(gamma)
  POLHODE_RECORDED(log_gamma)
  POLHODE_RECORDED(erf)
  POLHODE_RECORDED(erfc)
  POLHODE_RECORDED_OF_TWO(hypot)
  POLHODE_RECORDED_OF_TWO(agm)
  POLHODE_RECORDED_OF_TWO(atan2)
  POLHODE_RECORDED_OF_TWO(power)
  static recorded abs(const recorded& x) { return size_of(x); }
  static recorded floor(const recorded& x) { return integer_below(x); }
  static recorded ceil(const recorded& x) { return integer_above(x); }
  static recorded min(const recorded& x, const recorded& y) { return smaller(x, y); }
  static recorded max(const recorded& x, const recorded& y) { return greater(x, y); }
  static recorded power_integer(const recorded& x, long n) { return pow(x, n); }
  static recorded root(const recorded& x, long n) {
    return x.applied(recorded_operation::of([](const auto& v, const auto&, long order) {
                       return supplement<std::remove_cvref_t<decltype(v)>>::root(v, order);
                     }),
                     x, n);
  }

 private:
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

}  // namespace detail

template class compiled_expression<end_series>;
template class compiled_expression<tail_series>;
template class compiled_expression<recorded>;

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
  result.record = [f](const recorded& x, precision p) { return f.evaluator<recorded>(p)(x); };
  return result;
}

}  // namespace cli
}  // namespace polhode
