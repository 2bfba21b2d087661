// cost::estimate_cost beside what it is an estimate of, their ratio, and at the end how far off the
// estimates were: bench_cost_model [MOST_DIGITS]

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include <fmt/format.h>

#include "cost/measure.hpp"

int main(int argc, char** argv) {
  using namespace polhode::cost;
  const long most = argc > 1 ? std::atol(argv[1]) : 1'000'000;
  if (most < 1) {
    std::cerr << "usage: bench_cost_model [MOST_DIGITS]\n";
    return 2;
  }
  std::cout << fmt::format("{:<18}{:>10}{:>14}{:>14}{:>10}\n", "quantity", "digits", "estimate/s",
                           "measured/s", "ratio");
  double sum = 0;
  double worst = 0;
  int count = 0;
  int within_two = 0;
  for (const quantity& q : quantities()) {
    const method& m = q.methods.front();
    for (const long digits : {100L, 1000L, 10'000L, 100'000L, 1'000'000L}) {
      if (digits > most || digits > m.most_digits) break;
      const double estimate = estimate_cost(q.name, digits);
      constexpr double most_seconds = 20;
      if (estimate > most_seconds) break;
      (void)m.compute(digits);  // what is made once and kept
      const double measured = undisturbed_seconds([&] { (void)m.compute(digits); });
      std::cout << fmt::format("{:<18}{:>10}{:>14.3g}{:>14.3g}{:>10.2f}\n", q.name, digits,
                               estimate, measured, estimate / measured)
                << std::flush;
      const double error = std::abs(std::log(estimate / measured));
      sum += error;
      worst = std::max(worst, error);
      ++count;
      if (error <= std::log(2)) ++within_two;
    }
  }
  if (count == 0) return 0;
  std::cout << fmt::format(
      "error of the estimates: a factor of {:.2f} in the mean, {:.2f} at worst; {} of {} are "
      "within "
      "a factor of 2\n",
      std::exp(sum / count), std::exp(worst), within_two, count);
}
