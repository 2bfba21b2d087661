// boostorg/math#383: gauss_kronrod in mpfr_float gave wrong digits, its nodes being made before the
// precision was set.

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include "side_by_side.hpp"

int main() {
  using Real = boost::multiprecision::mpfr_float;
  Real::thread_default_precision(30);
  return ports::integral<Real>(
      "exp(-t^2/2) from 0 to infinity, in mpfr_float with 30 digits",
      [] {
        using boost::math::quadrature::gauss_kronrod;
        const auto f = [](Real t) -> Real { return exp(-t * t / 2); };
        ports::boost_answer<Real> result;
        result.value = gauss_kronrod<Real, 21>::integrate(
            f, Real(0), std::numeric_limits<Real>::infinity(), 10, Real("1e-15"), &result.claimed);
        return result;
      },
      [](auto t) { return exp(-t * t / 2); }, 0, std::numeric_limits<Real>::infinity());
}
