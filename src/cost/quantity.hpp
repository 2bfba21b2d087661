#pragma once

// What accuracy costs: quantities, each with the methods by which it can be had. Those in balls are
// certified; of the others, Boost.Math's and the library's own over mpfr_float and double, nobody
// knows the error but by the certified value.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polhode/arithmetic/ball.hpp"

namespace polhode::cost {

/// What a method gives.
struct estimate {
  ball value;  // certified: an enclosure; else the number that was computed
  /// log10 of the relative error that the method says it has, where it says.
  std::optional<double> log10_claimed;
  long evaluations = 0;  // of an integrand, where it counts them
};

struct method {
  std::string name;
  std::string description;
  bool certified = false;
  /// How many digits it can be asked for.
  long most_digits = 0;
  std::function<estimate(long digits)> compute;
};

/// No two methods have the same name.
struct quantity {
  std::string name;
  std::string description;
  std::vector<method> methods;  // the first is certified: what the library itself does
};

[[nodiscard]] const std::vector<quantity>& quantities();

/// Members of a family that get harder, to the same digits.
struct hard_family {
  std::string name;
  std::string description;  // of the exponent k
  std::vector<long> exponents;
  std::function<quantity(long exponent)> member;
};
[[nodiscard]] const std::vector<hard_family>& hard_families();

}  // namespace polhode::cost
