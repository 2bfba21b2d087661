// Must not compile, and for one reason only: 0.5 is a double.

#include <polhode/quadrature/integrate.hpp>

int main() {
  using namespace polhode;
  return integrate([](const auto& x) { return 0.5 * exp(x) + pow(x, 0.25); }, 0, 1).verdict ==
                 status::certified
             ? 0
             : 1;
}
