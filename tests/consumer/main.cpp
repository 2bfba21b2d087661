// A program that uses an installed Polhode and nothing else: the square root of 2, certified.

#include <iostream>

#include <polhode/arithmetic/ball.hpp>
#include <polhode/arithmetic/elementary.hpp>
#include <polhode/arithmetic/text.hpp>

int main() {
  const polhode::ball two{2, 200};  // the integer 2, to be worked with at 200 bits
  std::cout << polhode::to_decimal(sqrt(two), 50) << '\n';
}
