// Each must not compile, by one sentence: check.cmake has them, in this order.

#include <boost/multiprecision/cpp_dec_float.hpp>

#include <cmath>

#include <polhode/real/integrate.hpp>
#include <polhode/real/roots.hpp>

int main() {
  using polhode::integrate;
#if REFUSED == 1
  return integrate<polhode::mpfr_float>([](auto x) { return 0.1 * x; }, 0, 1).value > 0;
#elif REFUSED == 2
  return integrate<double>([](double x) { return x; }, 0, 1).value > 0;
#elif REFUSED == 3
  return integrate<double>([n = 0](auto x) mutable { return x + ++n; }, 0, 1).value > 0;
#elif REFUSED == 4
  return integrate<double>([](auto x) { return x < 0 ? -x : x; }, 0, 1).value > 0;
#elif REFUSED == 5
  integrate<float>([](auto x) { return x; }, 0, 1);
#elif REFUSED == 6
  return integrate<double>([](auto x) { return sin(x, x); }, 0, 1).value > 0;
#elif REFUSED == 7
  using Real = boost::multiprecision::cpp_dec_float_50;
  integrate<Real>([](auto x) { return x; }, 0, 1);
#elif REFUSED == 8
  using Real = boost::multiprecision::cpp_dec_float_50;
  polhode::find_root<Real>([](auto x) { return x; }, 0, 1);
#elif REFUSED == 9
  using Real = polhode::mpfr_float;
  return integrate<Real>([](auto x) { return decltype(x)(0.1) * x; }, 0, 1).value > 0;
#elif REFUSED == 10
  return integrate<double>([](auto x) { return std::sin(x); }, 0, 1).value > 0;
#elif REFUSED == 11
  return integrate([](double x) { return x; }, 0, 1).account.panels > 0;
#elif REFUSED == 12
  return polhode::isolate_roots([](double x) { return x; }, 0, 1).regions.empty();
#elif REFUSED == 13
  return polhode::isolate_roots([](auto x) { return x * x - 0.3; }, 0, 1).regions.empty();
#elif REFUSED == 14
  return (0.5 * polhode::ball(1, 64)).is_exact();
#elif REFUSED == 15
  const double k = 0.5;
  return integrate([k](auto x) { return k * exp(x) - k; }, 0, 1).account.panels > 0;
#elif REFUSED == 16
  return integrate([](auto x) { return x < 0 ? -x : x; }, 0, 1).account.panels > 0;
#endif
}
