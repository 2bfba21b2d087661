// Each must not compile, by one sentence: check.cmake has them, in this order.

#include <polhode/real/integrate.hpp>

int main() {
  using polhode::integrate;
#if REFUSED == 1
  return integrate<double>([](auto x) { return 0.1 * x; }, 0, 1).value > 0;
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
#endif
}
