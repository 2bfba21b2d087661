// boostorg/math#706: (1-x)^(-4/5) from 0 to 1, singular at the end at which a double cannot come
// near. The integral is 5.

#include <boost/math/quadrature/tanh_sinh.hpp>

#include "side_by_side.hpp"

int main() {
  using polhode::literals::operator""_r;
  return ports::integral<double>(
      "(1-x)^(-4/5) from 0 to 1",
      [] {
        boost::math::quadrature::tanh_sinh<double> integrator;
        const auto f = [](double x) { return std::pow(1 - x, -0.8); };
        ports::boost_answer<double> result;
        result.value = integrator.integrate(f, 0.0, 1.0, 1e-9, &result.claimed);
        return result;
      },
      [](auto x) { return pow(1 - x, "-4/5"_r); }, 0, 1);
}
