#pragma once

// Boost.Math's quadrature and elliptic integrals over mpfr_float, to be measured beside our own.

#include <functional>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "quantity.hpp"

namespace polhode::cost {

/// A function over a finite range, at mpfr_float's precision of the moment.
struct uncertified_integral {
  std::function<mpfr_float(const mpfr_float& x)> f;
  mpfr_float from;
  mpfr_float to;
};
/// Makes it, with constants at that precision.
using integral_maker = std::function<uncertified_integral()>;

[[nodiscard]] method boost_tanh_sinh(integral_maker make);
[[nodiscard]] method boost_gauss_kronrod(integral_maker make);

/// A value that is computed at mpfr_float's precision of the moment, so many digits and a few more.
[[nodiscard]] method in_mpfr_float(std::string name, std::string description, long most_digits,
                                   std::function<mpfr_float()> compute);
/// A value computed in double.
[[nodiscard]] method in_double(std::string description, std::function<double()> compute);

[[nodiscard]] mpfr_float boost_rf(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z);
[[nodiscard]] mpfr_float boost_rj(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z,
                                  const mpfr_float& p);
[[nodiscard]] double boost_rf(double x, double y, double z);
[[nodiscard]] double boost_rj(double x, double y, double z, double p);

}  // namespace polhode::cost
