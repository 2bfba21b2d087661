#pragma once

// An integral again, by another rule and with other cuts, as `polhode integrate --verify` finds it.
//
//   const integral first = integrate(f, 0, 1, {.digits = 30});
//   const second_opinion second = integral_again(f, 0, 1, first, 30);

#include <optional>
#include <string>

#include "polhode/expression/expression.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/verify/second_opinion.hpp"

namespace polhode {

/// A rational number certainly between a and b, about 0.37 of the way; its denominator is 3 times a
/// power of two, so that it is no point that halving the range leads to. Of an infinite range it is
/// one that is not far from the finite end, or from 0. None where the ends are not told apart, or
/// are beyond 2^65536.
[[nodiscard]] std::optional<rational> cut_between(const end_point& a, const end_point& b);

/// The certified integral `first` of f from a to b again, to about as many digits, as the sum of
/// two integrals up to a cut and from there (additivity). The rules that are not among first's are
/// tried one after the other until one confirms it. Where none does, first's own are tried: they
/// confirm it only where none of the others is applicable, as up to infinity, and not where one of
/// them failed. Throws contradiction_error where an enclosure of the sum has no number in common
/// with first's, or where one of the two integrals is proved to diverge; and std::invalid_argument
/// where first is not certified, or digits < 1.
[[nodiscard]] second_opinion integral_again(const prepared_integrand& f, const end_point& a,
                                            const end_point& b, const integral& first, long digits,
                                            int threads = 1);

/// The certified integral along a path again, backwards and with every piece cut. There is one rule
/// for paths, and so it is the same. Throws as the first integral_again does.
[[nodiscard]] second_opinion integral_again(const detail::complex_integrand& f, const path& along,
                                            const contour_integral& first, long digits,
                                            int threads = 1);

/// The same for a formula.
[[nodiscard]] second_opinion integral_again(const expression& f, const end_point& a,
                                            const end_point& b, const integral& first, long digits,
                                            int threads = 1);
[[nodiscard]] second_opinion integral_again(const expression& f, const path& along,
                                            const contour_integral& first, long digits,
                                            int threads = 1);
/// The same for a generic function of one argument.
template <class F>
[[nodiscard]] second_opinion integral_again(const F& f, const end_point& a, const end_point& b,
                                            const integral& first, long digits, int threads = 1) {
  return integral_again(formula_of(f), a, b, first, digits, threads);
}

/// "Taylor series, 33 panels": how an integral was found.
[[nodiscard]] std::string route_text(const integral_account& account);

}  // namespace polhode
