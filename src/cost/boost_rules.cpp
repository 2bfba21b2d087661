#include "boost_rules.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>

namespace polhode::cost {

uncertified_value by_tanh_sinh(const uncertified_integral& x, const mpfr_float& tolerance) {
  boost::math::quadrature::tanh_sinh<mpfr_float> rule;
  uncertified_value result;
  result.value = rule.integrate(x.f, x.from, x.to, tolerance, &result.error);
  return result;
}

uncertified_value by_gauss_kronrod(const uncertified_integral& x, const mpfr_float& tolerance) {
  constexpr unsigned most_depth = 10;
  uncertified_value result;
  result.value = boost::math::quadrature::gauss_kronrod<mpfr_float, 61>::integrate(
      x.f, x.from, x.to, most_depth, tolerance, &result.error);
  return result;
}

mpfr_float boost_rf(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z) {
  return boost::math::ellint_rf(x, y, z);
}
mpfr_float boost_rj(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z,
                    const mpfr_float& p) {
  return boost::math::ellint_rj(x, y, z, p);
}
double boost_rf(double x, double y, double z) { return boost::math::ellint_rf(x, y, z); }
double boost_rj(double x, double y, double z, double p) {
  return boost::math::ellint_rj(x, y, z, p);
}

}  // namespace polhode::cost
