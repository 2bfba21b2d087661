// The example of Boost.Math's page on tanh_sinh: log(x) log(1-x), singular at both ends. 2 -
// pi^2/6.

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/log1p.hpp>

#include "side_by_side.hpp"

int main() {
  return ports::integral<double>(
      "log(x) log(1-x) from 0 to 1",
      [] {
        boost::math::quadrature::tanh_sinh<double> integrator;
        const auto f = [](double x) { return std::log(x) * boost::math::log1p(-x); };
        ports::boost_answer<double> result;
        result.value = integrator.integrate(f, 0.0, 1.0, 1e-14, &result.claimed);
        return result;
      },
      [](auto x) { return log(x) * log(1 - x); }, 0, 1);
}
