#pragma once

// Methods over mpfr_float and double, Boost.Math's among them, to be measured beside our own.

#include <functional>

#include "boost_rules.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "quantity.hpp"

namespace polhode::cost {

/// Makes one, with constants at mpfr_float's precision of the moment.
using integral_maker = std::function<uncertified_integral()>;

[[nodiscard]] method boost_tanh_sinh(integral_maker make);
[[nodiscard]] method boost_gauss_kronrod(integral_maker make);

/// A value that is computed at mpfr_float's precision of the moment, so many digits and a few more.
[[nodiscard]] method in_mpfr_float(std::string name, std::string description, long most_digits,
                                   std::function<mpfr_float()> compute);
/// A value computed in double.
[[nodiscard]] method in_double(std::string description, std::function<double()> compute);

}  // namespace polhode::cost
