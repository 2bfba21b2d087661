// A narrow peak between the nodes of a rule: Boost's adaptive Gauss-Kronrod rule sees zeros, and
// claims an error of 0. sqrt(pi) 10^-4.

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "side_by_side.hpp"

int main() {
  return ports::integral<double>(
      "exp(-10^8 (x - 1/3)^2) from -4 to 4",
      [] {
        const auto f = [](double x) { return std::exp(-1e8 * (x - 1 / 3.0) * (x - 1 / 3.0)); };
        ports::boost_answer<double> result;
        result.value = boost::math::quadrature::gauss_kronrod<double, 15>::integrate(
            f, -4.0, 4.0, 10, 1e-12, &result.claimed);
        return result;
      },
      [](auto x) {
        using polhode::literals::operator""_r;
        return exp(-1e8 * (x - "1/3"_r) * (x - "1/3"_r));
      },
      -4, 4);
}
