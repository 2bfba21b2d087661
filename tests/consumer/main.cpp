#include <iostream>
#include <polhode/arithmetic/elementary.hpp>
#include <polhode/arithmetic/text.hpp>
#include <polhode/roots/newton.hpp>

int main() {
  using polhode::ball;
  const auto f = [](const ball& x) { return cos(x) - x; };
  const auto slope = [](const ball& x) { return -sin(x) - 1; };
  const ball start = hull(ball(7, 64) / 10, ball(8, 64) / 10);  // [0.7, 0.8]
  const polhode::root_enclosure r = refine_root(f, slope, start, 340);
  std::cout << to_text(r.verdict) << ": " << to_decimal(r.root, 100) << '\n';
}
