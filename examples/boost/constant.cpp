// boostorg/math#702: the constant 2 from -10 to 10, in a lambda that returns an int. tanh_sinh
// answered 20; Boost 1.81 refuses an int when it is compiled, so that it has to be 2.0. The
// integral is 40.

#include <boost/math/quadrature/tanh_sinh.hpp>

#include "side_by_side.hpp"

int main() {
  return ports::integral<double>(
      "2 from -10 to 10",
      [] {
        boost::math::quadrature::tanh_sinh<double> integrator;
        const auto f = [](double) { return 2.0; };
        ports::boost_answer<double> result;
        double error = 0;
        result.value = integrator.integrate(f, -10.0, 10.0, 1e-9, &error);
        result.claimed = error;
        return result;
      },
      [](auto) { return 2; }, -10, 10);
}
