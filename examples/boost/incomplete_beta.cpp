// From the review of Boost's double exponential rules (boostorg/math#66): x^(a-1) (1-x)^(b-1) with
// a = 1/20 and b = 3, from 0 to 1/2000. Nearly all of the integral lies beside 0.

#include <boost/math/quadrature/tanh_sinh.hpp>

#include "side_by_side.hpp"

int main() {
  using polhode::literals::operator""_r;
  return ports::integral<double>(
      "x^(-19/20) (1-x)^2 from 0 to 1/2000",
      [] {
        boost::math::quadrature::tanh_sinh<double> integrator;
        const auto f = [](double x) { return std::pow(x, -0.95) * (1 - x) * (1 - x); };
        ports::boost_answer<double> result;
        result.value = integrator.integrate(f, 0.0, 0.0005, 1e-9, &result.claimed);
        return result;
      },
      [](auto x) { return pow(x, "-19/20"_r) * (1 - x) * (1 - x); }, 0, "1/2000"_r);
}
