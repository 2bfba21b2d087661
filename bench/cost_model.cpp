// cost::estimate_cost beside what it is an estimate of, and their ratio: bench_cost_model [MOST_DIGITS]

#include <cstdlib>
#include <iostream>

#include <fmt/format.h>

#include "cost/measure.hpp"

int main(int argc, char** argv) {
  using namespace polhode::cost;
  const long most = argc > 1 ? std::atol(argv[1]) : 100'000;
  std::cout << fmt::format("{:<18}{:>10}{:>14}{:>14}{:>10}\n", "quantity", "digits", "estimate/s",
                           "measured/s", "ratio");
  for (const quantity& q : quantities()) {
    const cost_model model(q);
    for (const long digits : {100L, 1000L, 10'000L, 100'000L, 1'000'000L}) {
      if (digits > most || digits > q.methods.front().most_digits) break;
      const double estimate = model.seconds(digits);
      constexpr double most_seconds = 20;
      if (estimate > most_seconds) break;
      const double measured = measure(q.methods.front(), digits, std::nullopt, 0).seconds;
      std::cout << fmt::format("{:<18}{:>10}{:>14.3g}{:>14.3g}{:>10.2f}\n", q.name, digits,
                               estimate, measured, estimate / measured)
                << std::flush;
    }
  }
}
