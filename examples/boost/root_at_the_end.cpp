// boostorg/math#423: x / sqrt(x^2 - 1/4) from 1/2, where x^2 - 1/4 cancels beside the singular end.
// The integral is 1.

#include <boost/math/quadrature/tanh_sinh.hpp>

#include "side_by_side.hpp"

int main() {
  return ports::integral<double>(
      "x/sqrt(x^2 - 1/4) from 1/2 to sqrt(5)/2",
      [] {
        boost::math::quadrature::tanh_sinh<double> integrator;
        const auto f = [](double x) { return x / std::sqrt(x * x - 0.25); };
        ports::boost_answer<double> result;
        result.value = integrator.integrate(
            f, 0.5, std::sqrt(1.25), std::numeric_limits<double>::epsilon(), &result.claimed);
        return result;
      },
      [](auto x) { return x / sqrt(x * x - 0.25); }, 0.5, sqrt(polhode::symbol(1.25)));
}
