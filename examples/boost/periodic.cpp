// The example of Boost.Math's page on the trapezoidal rule: 1/(5 - 4 cos x) over a period, here to
// 50 digits. 2 pi/3.

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/trapezoidal.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "side_by_side.hpp"

int main() {
  using Real = boost::multiprecision::cpp_bin_float_50;
  return ports::integral<Real>(
      "1/(5 - 4 cos x) from 0 to 2 pi, in cpp_bin_float_50",
      [] {
        const auto f = [](const Real& x) -> Real { return 1 / (5 - 4 * cos(x)); };
        ports::boost_answer<Real> result;
        result.value =
            boost::math::quadrature::trapezoidal(f, Real(0), boost::math::constants::two_pi<Real>(),
                                                 Real("1e-48"), std::size_t{15}, &result.claimed);
        return result;
      },
      [](auto x) { return 1 / (5 - 4 * cos(x)); }, 0, polhode::end_point::pi(2));
}
