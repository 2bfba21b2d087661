#pragma once

// The elementary functions of one variable, each with its oracles.

#include <ostream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/special_functions.hpp"
#include "support/exact_set.hpp"
#include "support/real.hpp"

#ifdef POLHODE_HAVE_MPFI
#include <mpfi.h>
#endif

namespace polhode::support {

enum class shape { increasing, decreasing, other };

struct elementary_function {
  const char* name;
  void (*in_place)(ball&, const ball&);
  ball (*of)(const ball&);
  int (*by_mpfr)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  shape is;
  /// The function is defined on all of the set.
  bool (*defined_on)(const exact_set&);
  /// Exponentially: at a large number the value is a rational of millions of digits.
  bool grows = false;
#ifdef POLHODE_HAVE_MPFI
  int (*by_mpfi)(mpfi_ptr, mpfi_srcptr);
#endif
};

inline std::ostream& operator<<(std::ostream& out, const elementary_function& f) {
  return out << f.name;
}

/// sin, cos and their kin, whose thin results are looser where the slope is near 0.
inline bool is_circular(std::string_view name) {
  return name == "sin" || name == "cos" || name == "sinpi" || name == "cospi";
}

namespace detail {
inline bool grows(std::string_view name) {
  return name == "exp" || name == "exp2" || name == "exp10" || name == "sinh" || name == "cosh" ||
         name == "expm1" || name == "erfc";  // which falls as fast
}
inline bool everywhere(const exact_set&) { return true; }
inline bool above_zero(const exact_set& x) { return x.lower && *x.lower > 0; }
inline bool above_minus_one(const exact_set& x) { return x.lower && *x.lower > -1; }
inline bool from_zero(const exact_set& x) { return x.lower && *x.lower >= 0; }
inline bool from_one(const exact_set& x) { return x.lower && *x.lower >= 1; }
inline bool in_closed_unit(const exact_set& x) {
  return x.is_bounded() && *x.lower >= -1 && *x.upper <= 1;
}
inline bool in_open_unit(const exact_set& x) {
  return x.is_bounded() && *x.lower > -1 && *x.upper < 1;
}
/// No odd multiple of pi/2 inside: both ends have the same floor(x / pi + 1/2).
inline bool between_poles(const exact_set& x) {
  if (!x.is_bounded()) return false;
  const auto branch = [](const rational& q) {
    const precision p = 200 + 2 * std::max(bit_length(numerator(q)), bit_length(denominator(q)));
    real turns(p);
    mpfr_const_pi(turns, MPFR_RNDN);
    const real number(p, q, MPFR_RNDN);
    mpfr_div(turns, number, turns, MPFR_RNDN);
    mpfr_add_d(turns, turns, 0.5, MPFR_RNDN);
    integer floor;
    mpfr_get_z(floor.backend().data(), turns, MPFR_RNDD);
    return floor;
  };
  return branch(*x.lower) == branch(*x.upper);
}
}  // namespace detail

#ifdef POLHODE_HAVE_MPFI
#define POLHODE_MPFI_OF(f) , mpfi_##f
#define POLHODE_NO_MPFI , nullptr
#else
#define POLHODE_MPFI_OF(f)
#define POLHODE_NO_MPFI
#endif
// clang-format off
#define POLHODE_FUNCTION(f, shape, domain)                                                        \
  {#f, [](ball& r, const ball& x) { f(r, x); }, [](const ball& x) { return f(x); }, mpfr_##f,     \
   shape, detail::domain, detail::grows(#f) POLHODE_MPFI_OF(f)}
// A function that MPFI does not have.
#define POLHODE_OTHER_FUNCTION(f, shape, domain)                                                  \
  {#f, [](ball& r, const ball& x) { r = f(x); }, [](const ball& x) { return f(x); }, mpfr_##f,    \
   shape, detail::domain, detail::grows(#f) POLHODE_NO_MPFI}
// The same with an in-place form, and with another name in MPFR.
#define POLHODE_FUNCTION_OF_MPFR(f, by_mpfr, shape, domain)                                       \
  {#f, [](ball& r, const ball& x) { f(r, x); }, [](const ball& x) { return f(x); }, by_mpfr,      \
   shape, detail::domain, detail::grows(#f) POLHODE_NO_MPFI}
// clang-format on

inline const std::vector<elementary_function>& elementary_functions() {
  static const std::vector<elementary_function> all = {
      POLHODE_FUNCTION(exp, shape::increasing, everywhere),
      POLHODE_FUNCTION(log, shape::increasing, above_zero),
      POLHODE_FUNCTION(exp2, shape::increasing, everywhere),
      POLHODE_FUNCTION_OF_MPFR(exp10, mpfr_exp10, shape::increasing, everywhere),
      POLHODE_FUNCTION(log2, shape::increasing, above_zero),
      POLHODE_FUNCTION(log10, shape::increasing, above_zero),
      POLHODE_FUNCTION(sqrt, shape::increasing, from_zero),
      POLHODE_FUNCTION_OF_MPFR(rsqrt, mpfr_rec_sqrt, shape::decreasing, above_zero),
      POLHODE_FUNCTION(sin, shape::other, everywhere),
      POLHODE_FUNCTION(cos, shape::other, everywhere),
      POLHODE_FUNCTION(tan, shape::increasing, between_poles),  // on each branch
      POLHODE_FUNCTION(asin, shape::increasing, in_closed_unit),
      POLHODE_FUNCTION(acos, shape::decreasing, in_closed_unit),
      POLHODE_FUNCTION(atan, shape::increasing, everywhere),
      POLHODE_FUNCTION(sinh, shape::increasing, everywhere),
      POLHODE_FUNCTION(cosh, shape::other, everywhere),
      POLHODE_FUNCTION(tanh, shape::increasing, everywhere),
      POLHODE_FUNCTION(asinh, shape::increasing, everywhere),
      POLHODE_FUNCTION(acosh, shape::increasing, from_one),
      POLHODE_FUNCTION(atanh, shape::increasing, in_open_unit),
      POLHODE_FUNCTION(expm1, shape::increasing, everywhere),
      POLHODE_FUNCTION(log1p, shape::increasing, above_minus_one),
      POLHODE_OTHER_FUNCTION(sinpi, shape::other, everywhere),
      POLHODE_OTHER_FUNCTION(cospi, shape::other, everywhere),
      POLHODE_OTHER_FUNCTION(erf, shape::increasing, everywhere),
      POLHODE_OTHER_FUNCTION(erfc, shape::decreasing, everywhere),
  };
  return all;
}
#undef POLHODE_FUNCTION
#undef POLHODE_OTHER_FUNCTION
#undef POLHODE_FUNCTION_OF_MPFR
#undef POLHODE_MPFI_OF
#undef POLHODE_NO_MPFI

/// Two MPFR numbers with the value between them.
struct enclosure {
  real lower;
  real upper;
};
template <class Function>
enclosure enclose(Function&& f, precision p) {
  enclosure e{real(p), real(p)};
  f(e.lower.get(), MPFR_RNDD);
  f(e.upper.get(), MPFR_RNDU);
  return e;
}
/// f at the dyadic number q.
inline enclosure value_at(const elementary_function& f, const rational& q, precision p) {
  const real x = exact_real(q);
  return enclose([&](mpfr_ptr r, mpfr_rnd_t rounding) { f.by_mpfr(r, x, rounding); }, p);
}

/// The range of f over a bounded set in its domain, each end given to p bits by an enclosure of it:
/// MPFR at the ends for a monotone function; MPFI, where it is there, for the others.
struct range {
  enclosure lower;
  enclosure upper;
};
inline bool has_range(const elementary_function& f) {
#ifdef POLHODE_HAVE_MPFI
  return f.is != shape::other || f.by_mpfi != nullptr;
#else
  return f.is != shape::other;
#endif
}
inline range range_over(const elementary_function& f, const exact_set& x, precision p) {
  const rational& a = x.lower.value();
  const rational& b = x.upper.value();
  if (f.is != shape::other) {
    const bool up = f.is == shape::increasing;
    return {value_at(f, up ? a : b, p), value_at(f, up ? b : a, p)};
  }
#ifdef POLHODE_HAVE_MPFI
  const real low = exact_real(a);
  const real high = exact_real(b);
  mpfi_t in;
  mpfi_t out;
  mpfi_init2(in, std::max(mpfr_get_prec(low.get()), mpfr_get_prec(high.get())));
  mpfi_init2(out, p);
  mpfi_interv_fr(in, low, high);
  f.by_mpfi(out, in);
  // MPFI's ends are rounded outward at p bits: the true end is less than two units further in.
  range r{{real(p), real(p)}, {real(p), real(p)}};
  mpfi_get_left(r.lower.lower, out);
  mpfr_set(r.lower.upper, r.lower.lower, MPFR_RNDN);
  mpfi_get_right(r.upper.upper, out);
  mpfr_set(r.upper.lower, r.upper.upper, MPFR_RNDN);
  mpfi_clear(out);
  mpfi_clear(in);
  const auto is_extreme = [](mpfr_srcptr v) {
    return mpfr_cmp_si(v, 1) == 0 || mpfr_cmp_si(v, -1) == 0;
  };
  if (!is_extreme(r.lower.lower)) {
    mpfr_nextabove(r.lower.upper);
    mpfr_nextabove(r.lower.upper);
  }
  if (!is_extreme(r.upper.upper)) {
    mpfr_nextbelow(r.upper.lower);
    mpfr_nextbelow(r.upper.lower);
  }
  return r;
#else
  throw std::logic_error("range_over: needs MPFI");
#endif
}

}  // namespace polhode::support
