// boostorg/math#380: tanh_sinh in mpfr_float failed as it was set up (mended since), and a lambda
// has to say that it returns a Real. Here it may be the plain one.

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include "side_by_side.hpp"

int main() {
  using Real = boost::multiprecision::mpfr_float;
  Real::thread_default_precision(40);
  return ports::integral<Real>(
      "5 x + 7 from 0 to 1.1, in mpfr_float with 40 digits",
      [] {
        boost::math::quadrature::tanh_sinh<Real> integrator;
        const auto f = [](const Real& x) -> Real { return 5 * x + 7; };
        ports::boost_answer<Real> result;
        result.value =
            integrator.integrate(f, Real(0), Real(Real(11) / 10), Real("1e-38"), &result.claimed);
        return result;
      },
      [](auto x) { return 5 * x + 7; }, 0, polhode::rational(11, 10));
}
