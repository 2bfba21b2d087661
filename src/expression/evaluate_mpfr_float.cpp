#include "polhode/expression/evaluation.hpp"

namespace polhode::detail {
namespace {

using unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using binary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

unary function_of_one(operation what) {
  switch (what) {
#define POLHODE_MPFR(f) \
  case operation::f:    \
    return mpfr_##f;
    POLHODE_MPFR(sqrt)
    POLHODE_MPFR(exp)
    POLHODE_MPFR(expm1)
    POLHODE_MPFR(log)
    POLHODE_MPFR(log1p)
    POLHODE_MPFR(sin)
    POLHODE_MPFR(cos)
    POLHODE_MPFR(tan)
    POLHODE_MPFR(asin)
    POLHODE_MPFR(acos)
    POLHODE_MPFR(atan)
    POLHODE_MPFR(sinh)
    POLHODE_MPFR(cosh)
    POLHODE_MPFR(tanh)
    POLHODE_MPFR(asinh)
    POLHODE_MPFR(acosh)
    POLHODE_MPFR(atanh)
    POLHODE_MPFR(gamma)
    POLHODE_MPFR(erf)
    POLHODE_MPFR(erfc)
#undef POLHODE_MPFR
    case operation::negate:
      return [](mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t d) { return mpfr_neg(r, x, d); };
    case operation::abs:
      return [](mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t d) { return mpfr_abs(r, x, d); };
    case operation::floor:
      return [](mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t) { return mpfr_floor(r, x); };
    case operation::ceil:
      return [](mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t) { return mpfr_ceil(r, x); };
    case operation::log_gamma:
      return [](mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t d) {
        int sign = 0;
        return mpfr_lgamma(r, &sign, x, d);
      };
    default:
      return nullptr;
  }
}

binary function_of_two(operation what) {
  switch (what) {
    case operation::add:
      return mpfr_add;
    case operation::subtract:
      return mpfr_sub;
    case operation::multiply:
      return mpfr_mul;
    case operation::divide:
      return mpfr_div;
    case operation::power:
      return mpfr_pow;
    case operation::min:
      return mpfr_min;
    case operation::max:
      return mpfr_max;
    case operation::hypot:
      return mpfr_hypot;
    case operation::agm:
      return mpfr_agm;
    case operation::atan2:
      return mpfr_atan2;
    default:
      return nullptr;
  }
}

}  // namespace

template <>
void execute(const instruction& i, mpfr_float& r, const mpfr_float& x, const mpfr_float& y) {
  const mpfr_srcptr a = x.backend().data();
  const mpfr_srcptr b = y.backend().data();
  mpfr_float value = zero_of_precision(std::max(precision_of(x), precision_of(y)));
  const mpfr_ptr v = value.backend().data();
  if (const unary f = function_of_one(i.what)) {
    f(v, a, MPFR_RNDN);
  } else if (const binary g = function_of_two(i.what)) {
    g(v, a, b, MPFR_RNDN);
  } else if (i.what == operation::power_integer) {
    mpfr_pow_si(v, a, i.number, MPFR_RNDN);
  } else if (i.what == operation::root) {
    mpfr_rootn_ui(v, a, static_cast<unsigned long>(i.number), MPFR_RNDN);
  } else {  // among them sinpi and cospi, which balls reduce exactly
    ball around;
    execute<ball>(i, around, ball(x), ball(y));
    value = midpoint(around);
    mpfr_swap(r.backend().data(), value.backend().data());
    return;
  }
  mpfr_swap(r.backend().data(), v);
}

}  // namespace polhode::detail

namespace polhode {

template class compiled_expression<mpfr_float>;

}  // namespace polhode
