#include "polhode/expression/evaluation.hpp"

namespace polhode::detail {
namespace {

using unary = int(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using binary = int(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

mpfr_float of_one(unary f, const mpfr_float& x) {
  mpfr_float value = zero_of_precision(precision_of(x));
  f(value.backend().data(), x.backend().data(), MPFR_RNDN);
  return value;
}
mpfr_float of_two(binary f, const mpfr_float& x, const mpfr_float& y) {
  mpfr_float value = zero_of_precision(std::max(precision_of(x), precision_of(y)));
  f(value.backend().data(), x.backend().data(), y.backend().data(), MPFR_RNDN);
  return value;
}

}  // namespace

/// MPFR's own functions, each of which rounds once. sinpi and cospi are not among them: balls
/// reduce the argument exactly.
template <>
struct supplement<mpfr_float> {
#define POLHODE_MPFR_OF_ONE(f) \
  static mpfr_float f(const mpfr_float& x) { return of_one(mpfr_##f, x); }
#define POLHODE_MPFR_OF_TWO_AS(name, f)                              \
  static mpfr_float name(const mpfr_float& x, const mpfr_float& y) { \
    return of_two(mpfr_##f, x, y);                                   \
  }
#define POLHODE_MPFR_OF_TWO(f) POLHODE_MPFR_OF_TWO_AS(f, f)
  POLHODE_MPFR_OF_ONE(sqrt)
  POLHODE_MPFR_OF_ONE(exp)
  POLHODE_MPFR_OF_ONE(expm1)
  POLHODE_MPFR_OF_ONE(log)
  POLHODE_MPFR_OF_ONE(log1p)
  POLHODE_MPFR_OF_ONE(sin)
  POLHODE_MPFR_OF_ONE(cos)
  POLHODE_MPFR_OF_ONE(tan)
  POLHODE_MPFR_OF_ONE(asin)
  POLHODE_MPFR_OF_ONE(acos)
  POLHODE_MPFR_OF_ONE(atan)
  POLHODE_MPFR_OF_ONE(sinh)
  POLHODE_MPFR_OF_ONE(cosh)
  POLHODE_MPFR_OF_ONE(tanh)
  POLHODE_MPFR_OF_ONE(asinh)
  POLHODE_MPFR_OF_ONE(acosh)
  POLHODE_MPFR_OF_ONE(atanh)
  POLHODE_MPFR_OF_ONE(gamma)
  POLHODE_MPFR_OF_ONE(erf)
  POLHODE_MPFR_OF_ONE(erfc)
  POLHODE_MPFR_OF_TWO(min)
  POLHODE_MPFR_OF_TWO(max)
  POLHODE_MPFR_OF_TWO(hypot)
  POLHODE_MPFR_OF_TWO(agm)
  POLHODE_MPFR_OF_TWO(atan2)
  POLHODE_MPFR_OF_TWO_AS(power, pow)
  POLHODE_MPFR_OF_TWO_AS(add, add)
  POLHODE_MPFR_OF_TWO_AS(subtract, sub)
  POLHODE_MPFR_OF_TWO_AS(multiply, mul)
  POLHODE_MPFR_OF_TWO_AS(divide, div)
#undef POLHODE_MPFR_OF_ONE
#undef POLHODE_MPFR_OF_TWO_AS
#undef POLHODE_MPFR_OF_TWO
  static mpfr_float from(const ball& x) { return midpoint(x); }
  static mpfr_float copy(const mpfr_float& x) {
    mpfr_float r = zero_of_precision(precision_of(x));
    mpfr_set(r.backend().data(), x.backend().data(), MPFR_RNDN);
    return r;
  }
  template <class F, class Range>
  static mpfr_float further(const F& f, const Range& x) {
    return from(value_at_balls(f, x, [](const mpfr_float& a) { return ball(a); }));
  }
  // Macros of mpfr.h, or functions with other arguments.
  static mpfr_float negate(const mpfr_float& x) {
    return of_one([](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t d) { return mpfr_neg(r, a, d); }, x);
  }
  static mpfr_float abs(const mpfr_float& x) {
    return of_one([](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t d) { return mpfr_abs(r, a, d); }, x);
  }
  static mpfr_float floor(const mpfr_float& x) {
    return of_one([](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t) { return mpfr_floor(r, a); }, x);
  }
  static mpfr_float ceil(const mpfr_float& x) {
    return of_one([](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t) { return mpfr_ceil(r, a); }, x);
  }
  static mpfr_float log_gamma(const mpfr_float& x) {
    return of_one(
        [](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t d) {
          int sign = 0;
          return mpfr_lgamma(r, &sign, a, d);
        },
        x);
  }
  static mpfr_float power_integer(const mpfr_float& x, long n) {
    mpfr_float value = zero_of_precision(precision_of(x));
    mpfr_pow_si(value.backend().data(), x.backend().data(), n, MPFR_RNDN);
    return value;
  }
  static mpfr_float root(const mpfr_float& x, long n) {
    mpfr_float value = zero_of_precision(precision_of(x));
    mpfr_rootn_ui(value.backend().data(), x.backend().data(), static_cast<unsigned long>(n),
                  MPFR_RNDN);
    return value;
  }
};

}  // namespace polhode::detail

namespace polhode {

template class compiled_expression<mpfr_float>;

}  // namespace polhode
