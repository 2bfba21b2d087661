// The example of Boost.Math's page on roots with elliptic integrals: an ellipse with an arc of
// length 300 (a quarter of 4 a E(k)) and one radius of 28; what is the other? E(k) is
// boost::math::ellint_2(k), in a function that is proved too.

#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/roots.hpp>

#include "side_by_side.hpp"

int main() {
  // 4 a E(sqrt(1 - 28^2/a^2)) = 300 for the greater radius a.
  const auto f = [](auto a) {
    using std::sqrt;
    using T = decltype(a);
    return T(4 * a * boost::math::ellint_2(T(sqrt(1 - 784 / (a * a)))) - 300);
  };
  return ports::root<double>(
      "the greater radius of an ellipse of perimeter 300 and radius 28",
      [&] {
        std::uintmax_t iterations = 50;
        const auto bracket = boost::math::tools::toms748_solve(
            f, 40.0, 100.0, boost::math::tools::eps_tolerance<double>(50), iterations);
        ports::boost_answer<double> result;
        result.value = (bracket.first + bracket.second) / 2;
        return result;
      },
      f, 40, 100);
}
