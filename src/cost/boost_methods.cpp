#include "boost_methods.hpp"

#include <cmath>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::cost {
namespace {

/// Boost's mpfr_float takes the thread's precision for what has none of its own: so many decimal
/// digits while this lives.
class digits_of_thread {
 public:
  explicit digits_of_thread(long digits) : before_(mpfr_float::thread_default_precision()) {
    mpfr_float::thread_default_precision(static_cast<unsigned>(digits));
  }
  ~digits_of_thread() { mpfr_float::thread_default_precision(before_); }
  digits_of_thread(const digits_of_thread&) = delete;
  digits_of_thread& operator=(const digits_of_thread&) = delete;
  digits_of_thread(digits_of_thread&&) = delete;
  digits_of_thread& operator=(digits_of_thread&&) = delete;

 private:
  unsigned before_;
};

constexpr long guard_digits = 5;

/// log10 of |error/value|, nothing where it is not a number.
std::optional<double> log10_of_ratio(const mpfr_float& error, const mpfr_float& value) {
  if (value == 0 || !isfinite(error)) return std::nullopt;
  if (error == 0) return -1e9;
  return static_cast<double>(log10(abs(mpfr_float(error / value))));
}

template <class Rule>
estimate integrate_by(const Rule& rule, const integral_maker& make, long digits) {
  const digits_of_thread scope(digits + guard_digits);
  const uncertified_integral what = make();
  estimate result;
  const auto counted = [&](const mpfr_float& x) {
    ++result.evaluations;
    return what.f(x);
  };
  const mpfr_float tolerance = pow(mpfr_float(10), -static_cast<int>(digits));
  mpfr_float error = 0;
  const mpfr_float value = rule(counted, what.from, what.to, tolerance, error);
  result.value = ball(value);
  result.log10_claimed = log10_of_ratio(error, value);
  return result;
}

}  // namespace

method boost_tanh_sinh(integral_maker make) {
  return {"boost tanh-sinh", "Boost.Math's double exponential rule over mpfr_float", false, 3000,
          [make = std::move(make)](long digits) {
            return integrate_by(
                [](const auto& f, const mpfr_float& a, const mpfr_float& b,
                   const mpfr_float& tolerance, mpfr_float& error) {
                  boost::math::quadrature::tanh_sinh<mpfr_float> rule;
                  return rule.integrate(f, a, b, tolerance, &error);
                },
                make, digits);
          }};
}

method boost_gauss_kronrod(integral_maker make) {
  return {"boost gauss-kronrod", "Boost.Math's adaptive 61 point rule over mpfr_float", false, 300,
          [make = std::move(make)](long digits) {
            return integrate_by(
                [](const auto& f, const mpfr_float& a, const mpfr_float& b,
                   const mpfr_float& tolerance, mpfr_float& error) {
                  constexpr unsigned most_depth = 10;
                  return boost::math::quadrature::gauss_kronrod<mpfr_float, 61>::integrate(
                      f, a, b, most_depth, tolerance, &error);
                },
                make, digits);
          }};
}

method in_mpfr_float(std::string name, std::string description, long most_digits,
                     std::function<mpfr_float()> compute) {
  return {std::move(name), std::move(description), false, most_digits,
          [compute = std::move(compute)](long digits) {
            const digits_of_thread scope(digits + guard_digits);
            return estimate{ball(compute()), std::nullopt, 0};
          }};
}

method in_double(std::string description, std::function<double()> compute) {
  return {"double", std::move(description), false, 16, [compute = std::move(compute)](long) {
            return estimate{ball::exactly(compute()), std::nullopt, 0};
          }};
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
