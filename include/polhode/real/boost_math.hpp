#pragma once

// What a generic function for the templates over Real may call by Boost.Math's names, and the exact
// numbers that may stand beside a Real.
//
//   [](auto x) { using T = decltype(x); return boost::math::constants::pi<T>() *
//   boost::math::ellint_1(x) * "0.1"_r; }
//
// When such a function is recorded, x is a symbol: pi is then the number pi itself, not a decimal
// of it. Boost's elliptic integrals take the modulus k, those of formulas the parameter m = k^2,
// and ellint_3(k, n, phi) is ellipticPi(n, phi, k^2); signs and principal values are the same.

#include <cmath>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/math_fwd.hpp>

#include "polhode/real/number.hpp"

// ---------------------------------------------------------------------------------------------
// Boost's constants, as symbols.

namespace boost::math::constants::detail {

#define POLHODE_BOOST_CONSTANT(name, formula)                                                     \
  template <>                                                                                     \
  struct constant_##name<polhode::symbol> {                                                       \
    template <class Tag>                                                                          \
    [[nodiscard]] static polhode::symbol get(const Tag& /*of*/) {                                 \
      using polhode::symbol;                                                                      \
      using polhode::cbrt, polhode::cos, polhode::cosh, polhode::exp, polhode::log, polhode::pow; \
      using polhode::sin, polhode::sinh, polhode::sqrt, polhode::zeta;                            \
      [[maybe_unused]] auto pi = symbol::constant("pi");                                          \
      [[maybe_unused]] auto e = symbol::constant("e");                                            \
      [[maybe_unused]] const auto number = [](long n) { return symbol(n); };                      \
      return formula;                                                                             \
    }                                                                                             \
  };                                                                                              \
  template <class R>                                                                              \
  struct constant_##name<polhode::machine_symbol<R>> {                                            \
    template <class Tag>                                                                          \
    [[nodiscard]] static polhode::machine_symbol<R> get(const Tag& of) {                          \
      return constant_##name<polhode::symbol>::get(of);                                           \
    }                                                                                             \
  };
POLHODE_BOOST_CONSTANT(half, number(1) / 2)
POLHODE_BOOST_CONSTANT(third, number(1) / 3)
POLHODE_BOOST_CONSTANT(two_thirds, number(2) / 3)
POLHODE_BOOST_CONSTANT(twothirds, number(2) / 3)
POLHODE_BOOST_CONSTANT(sixth, number(1) / 6)
POLHODE_BOOST_CONSTANT(three_quarters, number(3) / 4)
POLHODE_BOOST_CONSTANT(root_two, sqrt(number(2)))
POLHODE_BOOST_CONSTANT(root_three, sqrt(number(3)))
POLHODE_BOOST_CONSTANT(half_root_two, sqrt(number(2)) / 2)
POLHODE_BOOST_CONSTANT(one_div_root_two, 1 / sqrt(number(2)))
POLHODE_BOOST_CONSTANT(ln_two, log(number(2)))
POLHODE_BOOST_CONSTANT(ln_ten, log(number(10)))
POLHODE_BOOST_CONSTANT(ln_ln_two, log(log(number(2))))
POLHODE_BOOST_CONSTANT(root_ln_four, sqrt(log(number(4))))
POLHODE_BOOST_CONSTANT(log2_e, 1 / log(number(2)))
POLHODE_BOOST_CONSTANT(log10_e, 1 / log(number(10)))
POLHODE_BOOST_CONSTANT(one_div_log10_e, log(number(10)))
POLHODE_BOOST_CONSTANT(pi, pi)
POLHODE_BOOST_CONSTANT(half_pi, pi / 2)
POLHODE_BOOST_CONSTANT(third_pi, pi / 3)
POLHODE_BOOST_CONSTANT(quarter_pi, pi / 4)
POLHODE_BOOST_CONSTANT(sixth_pi, pi / 6)
POLHODE_BOOST_CONSTANT(two_pi, 2 * pi)
POLHODE_BOOST_CONSTANT(two_thirds_pi, 2 * pi / 3)
POLHODE_BOOST_CONSTANT(three_quarters_pi, 3 * pi / 4)
POLHODE_BOOST_CONSTANT(four_thirds_pi, 4 * pi / 3)
POLHODE_BOOST_CONSTANT(pi_minus_three, pi - 3)
POLHODE_BOOST_CONSTANT(four_minus_pi, 4 - pi)
POLHODE_BOOST_CONSTANT(one_div_pi, 1 / pi)
POLHODE_BOOST_CONSTANT(two_div_pi, 2 / pi)
POLHODE_BOOST_CONSTANT(one_div_two_pi, 1 / (2 * pi))
POLHODE_BOOST_CONSTANT(root_pi, sqrt(pi))
POLHODE_BOOST_CONSTANT(root_half_pi, sqrt(pi / 2))
POLHODE_BOOST_CONSTANT(root_two_pi, sqrt(2 * pi))
POLHODE_BOOST_CONSTANT(log_root_two_pi, log(2 * pi) / 2)
POLHODE_BOOST_CONSTANT(one_div_root_pi, 1 / sqrt(pi))
POLHODE_BOOST_CONSTANT(root_one_div_pi, 1 / sqrt(pi))
POLHODE_BOOST_CONSTANT(one_div_root_two_pi, 1 / sqrt(2 * pi))
POLHODE_BOOST_CONSTANT(two_div_root_pi, 2 / sqrt(pi))
POLHODE_BOOST_CONSTANT(root_two_div_pi, sqrt(2 / pi))
POLHODE_BOOST_CONSTANT(pi_sqr, pi* pi)
POLHODE_BOOST_CONSTANT(pi_sqr_div_six, pi* pi / 6)
POLHODE_BOOST_CONSTANT(pi_cubed, pi* pi* pi)
POLHODE_BOOST_CONSTANT(cbrt_pi, cbrt(pi))
POLHODE_BOOST_CONSTANT(one_div_cbrt_pi, 1 / cbrt(pi))
POLHODE_BOOST_CONSTANT(pi_pow_e, pow(pi, e))
POLHODE_BOOST_CONSTANT(e, e)
POLHODE_BOOST_CONSTANT(e_pow_pi, exp(pi))
POLHODE_BOOST_CONSTANT(root_e, sqrt(e))
POLHODE_BOOST_CONSTANT(exp_minus_half, exp(number(-1) / 2))
POLHODE_BOOST_CONSTANT(exp_minus_one, exp(number(-1)))
POLHODE_BOOST_CONSTANT(degree, pi / 180)
POLHODE_BOOST_CONSTANT(radian, 180 / pi)
POLHODE_BOOST_CONSTANT(sin_one, sin(number(1)))
POLHODE_BOOST_CONSTANT(cos_one, cos(number(1)))
POLHODE_BOOST_CONSTANT(sinh_one, sinh(number(1)))
POLHODE_BOOST_CONSTANT(cosh_one, cosh(number(1)))
POLHODE_BOOST_CONSTANT(phi, (1 + sqrt(number(5))) / 2)
POLHODE_BOOST_CONSTANT(ln_phi, log((1 + sqrt(number(5))) / 2))
POLHODE_BOOST_CONSTANT(euler, symbol::constant("euler_gamma"))
POLHODE_BOOST_CONSTANT(catalan, symbol::constant("catalan"))
POLHODE_BOOST_CONSTANT(zeta_two, pi* pi / 6)
POLHODE_BOOST_CONSTANT(zeta_three, zeta(number(3)))
#undef POLHODE_BOOST_CONSTANT

}  // namespace boost::math::constants::detail

// ---------------------------------------------------------------------------------------------
// Boost.Math's functions, of symbols.

namespace boost::math {

// Those of one argument are no templates, and so preferred to Boost's; those of more are templates
// as Boost's are, and more constrained.

#define POLHODE_BOOST_OF_ONE(name, formula)                             \
  [[nodiscard]] inline polhode::symbol name(const polhode::symbol& x) { \
    using polhode::symbol;                                              \
    return formula;                                                     \
  }                                                                     \
  [[nodiscard]] inline polhode::machine_symbol<double> name(            \
      const polhode::machine_symbol<double>& x) {                       \
    return boost::math::name(static_cast<const polhode::symbol&>(x));   \
  }                                                                     \
  [[nodiscard]] inline polhode::machine_symbol<long double> name(       \
      const polhode::machine_symbol<long double>& x) {                  \
    return boost::math::name(static_cast<const polhode::symbol&>(x));   \
  }
POLHODE_BOOST_OF_ONE(tgamma, gamma(x))
POLHODE_BOOST_OF_ONE(lgamma, log_gamma(x))
POLHODE_BOOST_OF_ONE(erf, symbol::call("erf", {x}))
POLHODE_BOOST_OF_ONE(erfc, symbol::call("erfc", {x}))
POLHODE_BOOST_OF_ONE(expm1, symbol::call("expm1", {x}))
POLHODE_BOOST_OF_ONE(log1p, symbol::call("log1p", {x}))
POLHODE_BOOST_OF_ONE(cbrt, symbol::call("cbrt", {x}))
POLHODE_BOOST_OF_ONE(zeta, symbol::call("zeta", {x}))
POLHODE_BOOST_OF_ONE(sqrt1pm1, sqrt(1 + x) - 1)
POLHODE_BOOST_OF_ONE(sin_pi, sinpi(x))
POLHODE_BOOST_OF_ONE(cos_pi, cospi(x))
POLHODE_BOOST_OF_ONE(asinh, symbol::call("asinh", {x}))
POLHODE_BOOST_OF_ONE(acosh, symbol::call("acosh", {x}))
POLHODE_BOOST_OF_ONE(atanh, symbol::call("atanh", {x}))
POLHODE_BOOST_OF_ONE(ellint_1, symbol::call("ellipticK", {x * x}))
POLHODE_BOOST_OF_ONE(ellint_2, symbol::call("ellipticE", {x * x}))
POLHODE_BOOST_OF_ONE(ellint_d, symbol::call("ellipticD", {x * x}))
#undef POLHODE_BOOST_OF_ONE

#define POLHODE_BOOST_OF_TWO(name, formula)                                 \
  template <class A, class B>                                               \
  requires polhode::detail::call_of_symbols<A, B>                           \
  [[nodiscard]] polhode::detail::symbol_for<A, B> name(A first, B second) { \
    using polhode::symbol;                                                  \
    using S = polhode::detail::symbol_for<A, B>;                            \
    const symbol x = S(first);                                              \
    const symbol y = S(second);                                             \
    return S(formula);                                                      \
  }
POLHODE_BOOST_OF_TWO(hypot, symbol::call("hypot", {x, y}))
POLHODE_BOOST_OF_TWO(ellint_1, symbol::call("ellipticF", {y, x* x}))
POLHODE_BOOST_OF_TWO(ellint_2, symbol::call("ellipticE", {y, x* x}))
POLHODE_BOOST_OF_TWO(ellint_d, symbol::call("ellipticD", {y, x* x}))
POLHODE_BOOST_OF_TWO(ellint_3, symbol::call("ellipticPi", {y, x* x}))
POLHODE_BOOST_OF_TWO(ellint_rc, symbol::call("carlsonRC", {x, y}))
POLHODE_BOOST_OF_TWO(jacobi_sn, symbol::call("jacobiSN", {y, x* x}))
POLHODE_BOOST_OF_TWO(jacobi_cn, symbol::call("jacobiCN", {y, x* x}))
POLHODE_BOOST_OF_TWO(jacobi_dn, symbol::call("jacobiDN", {y, x* x}))
#undef POLHODE_BOOST_OF_TWO

template <class A, class B, class C>
requires polhode::detail::call_of_symbols<A, B, C>
[[nodiscard]] polhode::detail::symbol_for<A, B, C> ellint_3(A k, B n, C phi) {
  using S = polhode::detail::symbol_for<A, B, C>;
  const S modulus(k);
  return polhode::symbol::call("ellipticPi", {S(n), S(phi), modulus * modulus});
}
template <class A, class B, class C>
requires polhode::detail::call_of_symbols<A, B, C>
[[nodiscard]] polhode::detail::symbol_for<A, B, C> ellint_rf(A x, B y, C z) {
  using S = polhode::detail::symbol_for<A, B, C>;
  return polhode::symbol::call("carlsonRF", {S(x), S(y), S(z)});
}
template <class A, class B, class C>
requires polhode::detail::call_of_symbols<A, B, C>
[[nodiscard]] polhode::detail::symbol_for<A, B, C> ellint_rd(A x, B y, C z) {
  using S = polhode::detail::symbol_for<A, B, C>;
  return polhode::symbol::call("carlsonRD", {S(x), S(y), S(z)});
}
template <class A, class B, class C>
requires polhode::detail::call_of_symbols<A, B, C>
[[nodiscard]] polhode::detail::symbol_for<A, B, C> ellint_rg(A x, B y, C z) {
  using S = polhode::detail::symbol_for<A, B, C>;
  return polhode::symbol::call("carlsonRG", {S(x), S(y), S(z)});
}
template <class A, class B, class C, class D>
requires polhode::detail::call_of_symbols<A, B, C, D>
[[nodiscard]] polhode::detail::symbol_for<A, B, C, D> ellint_rj(A x, B y, C z, D p) {
  using S = polhode::detail::symbol_for<A, B, C, D>;
  return polhode::symbol::call("carlsonRJ", {S(x), S(y), S(z), S(p)});
}

}  // namespace boost::math

// ---------------------------------------------------------------------------------------------
// Exact numbers beside a Real: converted to it, to nearest.

namespace polhode {

namespace detail {
/// q at the precision of x.
template <floating_real R>
[[nodiscard]] R number_like(const R& x, const rational& q) {
  precision p = usual_bits<R>();
  if constexpr (has_variable_precision<R>) p = precision_of(x);
  mpfr_float exact = zero_of_precision(p);
  mpfr_set_q(exact.backend().data(), q.backend().data(), MPFR_RNDN);
  return rounded_to<R>(exact.backend().data(), p, MPFR_RNDN);
}
}  // namespace detail

#define POLHODE_EXACT_BESIDE_REAL(op)                                                        \
  template <floating_real R>                                                                 \
  [[nodiscard]] R operator op(const rational_literal& q, const R& x) {                       \
    return R(detail::number_like(x, q.value()) op x);                                        \
  }                                                                                          \
  template <floating_real R>                                                                 \
  [[nodiscard]] R operator op(const R& x, const rational_literal& q) {                       \
    return R(x op detail::number_like(x, q.value()));                                        \
  }                                                                                          \
  template <detail::boost_expression E>                                                      \
  [[nodiscard]] typename E::result_type operator op(const rational_literal& q, const E& x) { \
    return q op typename E::result_type(x);                                                  \
  }                                                                                          \
  template <detail::boost_expression E>                                                      \
  [[nodiscard]] typename E::result_type operator op(const E& x, const rational_literal& q) { \
    return typename E::result_type(x) op q;                                                  \
  }
POLHODE_EXACT_BESIDE_REAL(+)
POLHODE_EXACT_BESIDE_REAL(-)
POLHODE_EXACT_BESIDE_REAL(*)
POLHODE_EXACT_BESIDE_REAL(/)
#undef POLHODE_EXACT_BESIDE_REAL

template <floating_real R>
[[nodiscard]] R pow(const R& x, const rational_literal& q) {
  using std::pow;
  return R(pow(x, detail::number_like(x, q.value())));
}

}  // namespace polhode

namespace boost::multiprecision {

// A rational number beside a number of Boost's with a floating point, which Boost leaves to the
// person: the rational is converted, to nearest. Here, as this is where the compiler looks for
// operators of both.
#define POLHODE_RATIONAL_BESIDE_REAL(op)                                                      \
  template <polhode::detail::boost_real R>                                                    \
  [[nodiscard]] R operator op(const polhode::rational& q, const R& x) {                       \
    return polhode::rational_literal(q) op x;                                                 \
  }                                                                                           \
  template <polhode::detail::boost_real R>                                                    \
  [[nodiscard]] R operator op(const R& x, const polhode::rational& q) {                       \
    return x op polhode::rational_literal(q);                                                 \
  }                                                                                           \
  template <polhode::detail::boost_expression E>                                              \
  requires polhode::detail::boost_real<typename E::result_type>                               \
  [[nodiscard]] typename E::result_type operator op(const polhode::rational& q, const E& x) { \
    return polhode::rational_literal(q) op x;                                                 \
  }                                                                                           \
  template <polhode::detail::boost_expression E>                                              \
  requires polhode::detail::boost_real<typename E::result_type>                               \
  [[nodiscard]] typename E::result_type operator op(const E& x, const polhode::rational& q) { \
    return x op polhode::rational_literal(q);                                                 \
  }
POLHODE_RATIONAL_BESIDE_REAL(+)
POLHODE_RATIONAL_BESIDE_REAL(-)
POLHODE_RATIONAL_BESIDE_REAL(*)
POLHODE_RATIONAL_BESIDE_REAL(/)
#undef POLHODE_RATIONAL_BESIDE_REAL

}  // namespace boost::multiprecision
