#include <iostream>
#include <polhode/real/integrate.hpp>
int main() {
  using Real = boost::multiprecision::mpfr_float_50;
  const auto i = polhode::integrate<Real>([](auto x) { return exp(-x * x); }, 0, 1);
  std::cout << i.value.str(50) << " +- " << i.truncation_error.str(1) << '\n';
}
