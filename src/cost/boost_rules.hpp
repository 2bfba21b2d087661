#pragma once

// Boost.Math's quadrature and elliptic integrals over mpfr_float. The source reads none of our
// headers: its templates take as long to compile as a batch, and no change of ours asks for it.

#include <functional>

#include <boost/multiprecision/mpfr.hpp>

namespace polhode::cost {

using boost::multiprecision::mpfr_float;

/// A function over a finite range, at mpfr_float's precision of the moment.
struct uncertified_integral {
  std::function<mpfr_float(const mpfr_float& x)> f;
  mpfr_float from;
  mpfr_float to;
};

struct uncertified_value {
  mpfr_float value;
  mpfr_float error;  // as the rule estimates it
};

/// The double exponential rule.
[[nodiscard]] uncertified_value by_tanh_sinh(const uncertified_integral& x,
                                             const mpfr_float& tolerance);
/// The adaptive Gauss-Kronrod rule with 61 points.
[[nodiscard]] uncertified_value by_gauss_kronrod(const uncertified_integral& x,
                                                 const mpfr_float& tolerance);

[[nodiscard]] mpfr_float boost_rf(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z);
[[nodiscard]] mpfr_float boost_rj(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z,
                                  const mpfr_float& p);
[[nodiscard]] double boost_rf(double x, double y, double z);
[[nodiscard]] double boost_rj(double x, double y, double z, double p);

}  // namespace polhode::cost
