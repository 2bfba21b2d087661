// One header for all, and what it says of its version.

#include <iostream>

#include <polhode/polhode.hpp>

int main() {
  using namespace polhode;
  const integral i = integrate([](const auto& x) { return exp(-x * x) / 2; }, 0, 1);
  std::cout << version_major << '.' << version_minor << '.' << version_patch << ' '
            << to_decimal(i.enclosure, 15) << '\n';
  const expression f = parse("exp(-x^2) - k", {"x"}, {{"k", "1/2"}});
  std::cout << to_decimal(integrate(f, 0, 1).enclosure, 15) << ' '
            << isolate_roots(f, 0, 1).regions.size() << '\n';
}
