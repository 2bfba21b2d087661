// The example of Boost.Math's pages on finding roots: the cube root of 28 by Newton's method.

#include <boost/math/tools/roots.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "side_by_side.hpp"

int main() {
  using Real = boost::multiprecision::cpp_bin_float_50;
  return ports::root<Real>(
      "x^3 = 28, in cpp_bin_float_50",
      [] {
        const auto f = [](const Real& x) {
          return std::make_pair(Real(x * x * x - 28), Real(3 * x * x));
        };
        std::uintmax_t iterations = 50;
        ports::boost_answer<Real> result;
        result.value = boost::math::tools::newton_raphson_iterate(
            f, Real(3), Real(1), Real(28), std::numeric_limits<Real>::digits * 6 / 10, iterations);
        return result;
      },
      [](auto x) { return x * x * x - 28; }, 1, 28);
}
