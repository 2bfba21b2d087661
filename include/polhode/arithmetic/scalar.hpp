#pragma once

// What a rule or an iteration that is a template over the scalar needs beyond the operators, for
// the two scalars of the library: with `ball` the template computes an enclosure, with `mpfr_float`
// the uncertified value, from the same code.

#include <type_traits>
#include <utility>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/exact_real.hpp"

namespace polhode {

template <class T>
concept scalar = std::same_as<T, ball> || std::same_as<T, mpfr_float>;

/// The exact number q with p bits, as a scalar.
template <scalar T>
[[nodiscard]] T scalar_from(const rational& q, precision p) {
  if constexpr (std::same_as<T, ball>) {
    return ball(q, p);
  } else {
    T r = zero_of_precision(p);
    mpfr_set_q(r.backend().data(), q.backend().data(), MPFR_RNDN);
    return r;
  }
}
template <scalar T>
[[nodiscard]] T scalar_from(long n, precision p) {
  if constexpr (std::same_as<T, ball>) {
    return {n, p};
  } else {
    T r = zero_of_precision(p);
    mpfr_set_si(r.backend().data(), n, MPFR_RNDN);
    return r;
  }
}
/// A number of which every digit can be had: rounded where T encloses nothing.
template <scalar T>
[[nodiscard]] T scalar_from(const exact_real& x, precision p) {
  if constexpr (std::same_as<T, ball>) {
    return x.at(p);
  } else {
    return scalar_from<T>(x.is_rational() ? x.exact() : lower_rational(x.at(p).middle()), p);
  }
}

/// pi with p bits.
template <scalar T>
[[nodiscard]] T scalar_pi(precision p) {
  if constexpr (std::same_as<T, ball>) {
    return pi(p);
  } else {
    T r = zero_of_precision(p);
    mpfr_const_pi(r.backend().data(), MPFR_RNDN);
    return r;
  }
}

/// {sin x, cos x}, with the precision of x.
[[nodiscard]] inline std::pair<mpfr_float, mpfr_float> sin_cos(const mpfr_float& x) {
  std::pair<mpfr_float, mpfr_float> r{zero_of_precision(precision_of(x)),
                                      zero_of_precision(precision_of(x))};
  mpfr_sin_cos(r.first.backend().data(), r.second.backend().data(), x.backend().data(), MPFR_RNDN);
  return r;
}

}  // namespace polhode
