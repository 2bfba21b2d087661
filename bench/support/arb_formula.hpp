#pragma once

// Formulas over Arb's complex balls, for acb_calc_integrate. Only where POLHODE_HAVE_ARB is
// defined.

#include <acb_calc.h>
#include <acb_hypgeom.h>

#include <string_view>

#include "arb_number.hpp"
#include "polhode/expression/evaluation.hpp"

namespace polhode::bench {

/// A complex ball, computed with the precision of the call of arb_formula that is under way.
class arb_value {
 public:
  arb_value() = default;
  explicit arb_value(const ball& x) {
    const mpfr_float low = lower(x);
    const mpfr_float high = upper(x);
    arb_set_interval_mpfr(acb_realref(z_.get()), low.backend().data(), high.backend().data(),
                          x.precision());
  }
  explicit arb_value(acb_srcptr z) { acb_set(z_.get(), z); }

  [[nodiscard]] acb_srcptr get() const { return z_.get(); }
  /// What a function is that is not here: nowhere defined.
  [[nodiscard]] static arb_value blocked(const char*) {
    return made([](acb_ptr r, slong) { acb_indeterminate(r); });
  }

  friend arb_value operator+(const arb_value& x, const arb_value& y) {
    return made([&](acb_ptr r, slong p) { acb_add(r, x.get(), y.get(), p); });
  }
  friend arb_value operator-(const arb_value& x, const arb_value& y) {
    return made([&](acb_ptr r, slong p) { acb_sub(r, x.get(), y.get(), p); });
  }
  friend arb_value operator*(const arb_value& x, const arb_value& y) {
    return made([&](acb_ptr r, slong p) { acb_mul(r, x.get(), y.get(), p); });
  }
  friend arb_value operator/(const arb_value& x, const arb_value& y) {
    return made([&](acb_ptr r, slong p) { acb_div(r, x.get(), y.get(), p); });
  }
  friend arb_value operator-(const arb_value& x) {
    return made([&](acb_ptr r, slong) { acb_neg(r, x.get()); });
  }
  friend arb_value pow(const arb_value& x, long n) {
    return made([&](acb_ptr r, slong p) { acb_pow_si(r, x.get(), n, p); });
  }
  friend arb_value pow(const arb_value& x, const arb_value& y) {
    return made([&](acb_ptr r, slong p) {
      acb_pow_analytic(r, x.get(), y.get(), must_be_analytic ? 1 : 0, p);
    });
  }
#define POLHODE_ENTIRE(name, function)                                 \
  friend arb_value name(const arb_value& x) {                          \
    return made([&](acb_ptr r, slong p) { function(r, x.get(), p); }); \
  }
  POLHODE_ENTIRE(exp, acb_exp)
  POLHODE_ENTIRE(sin, acb_sin)
  POLHODE_ENTIRE(cos, acb_cos)
  POLHODE_ENTIRE(tan, acb_tan)
  POLHODE_ENTIRE(sinh, acb_sinh)
  POLHODE_ENTIRE(cosh, acb_cosh)
  POLHODE_ENTIRE(tanh, acb_tanh)
  POLHODE_ENTIRE(erf, acb_hypgeom_erf)
  POLHODE_ENTIRE(gamma, acb_gamma)
#undef POLHODE_ENTIRE
#define POLHODE_PIECEWISE(name, function)                                                        \
  friend arb_value name(const arb_value& x) {                                                    \
    return made([&](acb_ptr r, slong p) { function(r, x.get(), must_be_analytic ? 1 : 0, p); }); \
  }
  POLHODE_PIECEWISE(sqrt, acb_sqrt_analytic)
  POLHODE_PIECEWISE(log, acb_log_analytic)
  POLHODE_PIECEWISE(abs, acb_real_abs)
  POLHODE_PIECEWISE(floor, acb_real_floor)
  POLHODE_PIECEWISE(ceil, acb_real_ceil)
#undef POLHODE_PIECEWISE
  friend arb_value max(const arb_value& x, const arb_value& y) {
    return made([&](acb_ptr r, slong p) {
      acb_real_max(r, x.get(), y.get(), must_be_analytic ? 1 : 0, p);
    });
  }
  friend arb_value min(const arb_value& x, const arb_value& y) {
    return made([&](acb_ptr r, slong p) {
      acb_real_min(r, x.get(), y.get(), must_be_analytic ? 1 : 0, p);
    });
  }
  /// Its cuts run from i and -i outwards along the imaginary axis.
  friend arb_value atan(const arb_value& x) {
    if (must_be_analytic && arb_contains_zero(acb_realref(x.get())) != 0) {
      arb_number size;
      arb_abs(size.get(), acb_imagref(x.get()));
      arb_sub_ui(size.get(), size.get(), 1, working_precision);
      if (arb_is_negative(size.get()) == 0) return blocked("atan");
    }
    return made([&](acb_ptr r, slong p) { acb_atan(r, x.get(), p); });
  }
  friend arb_value airy(const arb_value& x) {
    return made(
        [&](acb_ptr r, slong p) { acb_hypgeom_airy(r, nullptr, nullptr, nullptr, x.get(), p); });
  }
  friend arb_value bessel_i_scaled(const arb_value& order, const arb_value& x) {
    return made(
        [&](acb_ptr r, slong p) { acb_hypgeom_bessel_i_scaled(r, order.get(), x.get(), p); });
  }
  /// The principal branch, whose cut runs from -1/e to the left.
  friend arb_value lambert_w(const arb_value& x) {
    if (must_be_analytic && arb_contains_zero(acb_imagref(x.get())) != 0) {
      arb_number from_cut;
      arb_const_e(from_cut.get(), working_precision);
      arb_mul(from_cut.get(), from_cut.get(), acb_realref(x.get()), working_precision);
      arb_add_ui(from_cut.get(), from_cut.get(), 1, working_precision);
      if (arb_is_positive(from_cut.get()) == 0) return blocked("lambertW");
    }
    constexpr fmpz principal[1] = {0};
    return made([&](acb_ptr r, slong p) { acb_lambertw(r, x.get(), principal, 0, p); });
  }

 private:
  friend class arb_formula;
  template <class F>
  static arb_value made(const F& f) {
    arb_value r;
    f(r.z_.get(), working_precision);
    return r;
  }

  static inline slong working_precision = 64;
  static inline bool must_be_analytic = false;
  acb_number z_;
};

}  // namespace polhode::bench

namespace polhode::detail {

/// The functions of the library that are known over balls, by Arb's own.
template <>
struct supplement<bench::arb_value> {
  template <class F, class Range>
  static bench::arb_value further(const F& f, const Range& x) {
    const std::string_view name = name_of_function(f);
    if (name == "airyAi") return airy(x.front());
    if (name == "besselIx") return bessel_i_scaled(x.front(), x.back());
    if (name == "lambertW") return lambert_w(x.front());
    return bench::arb_value::blocked(name_of_function(f));
  }
};

}  // namespace polhode::detail

namespace polhode::bench {

/// A formula as an integrand of acb_calc_integrate. The precision of its constants is p.
class arb_formula {
 public:
  arb_formula(const expression& f, precision p) : f_(f.evaluator<arb_value>(p)) {}

  /// acb_calc_func_t, with an arb_formula as its data.
  static int over(acb_ptr result, const acb_t z, void* data, slong order, slong p) {
    arb_value::working_precision = p;
    arb_value::must_be_analytic = order != 0;
    acb_set(result, static_cast<const arb_formula*>(data)->f_(arb_value(z)).get());
    return 0;
  }

 private:
  compiled_expression<arb_value> f_;
};

}  // namespace polhode::bench
