// One header for all, and what it says of its version.

#include <iostream>

#include <polhode/polhode.hpp>

int main() {
  using namespace polhode;
  const integral i = integrate([](const auto& x) { return exp(-x * x) / 2; }, 0, 1);
  std::cout << version_major << '.' << version_minor << '.' << version_patch << ' '
            << to_decimal(i.enclosure, 15) << '\n';
}
