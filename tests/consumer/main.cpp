#include <iostream>
#include <polhode/polhode.hpp>
int main() {
  const auto f = [](const auto& x) { return exp(-x * x); };
  std::cout << to_decimal(polhode::integrate(f, 0, 1, {.digits = 50}).enclosure, 50) << '\n';
}
