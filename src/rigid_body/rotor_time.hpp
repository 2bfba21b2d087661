#pragma once

// A time, reduced by whole periods of J and by whole turns about J.

#include "rigid_body/rotor_scalars.hpp"
#include "rigid_body/rotor_tables.hpp"

namespace polhode::detail {

/// The moment t: u = 2K(N + cycle), on the separatrix u = cycle; turns t - slip N = whole +
/// fraction with |fraction| <= 1/2.
template <class T>
struct moment {
  T cycle;
  bool odd = false;  // N
  T whole;
  T fraction;
};

/// By rates that have so many bits more than `bits` as |cycles t|, |turns t| have before the point:
/// a hypothesis.
[[nodiscard]] moment<ball> reduced(const rotor_rates& rates, regime kind, const rational& t,
                                   precision bits);

/// By these rates of the state's motion where they have the bits, and by others with more where t
/// needs them. A time with more than 2^24 bits before the point is not reduced well: the result is
/// as wide as it is.
[[nodiscard]] moment<ball> reduced(const initial_state& state, const rotor_rates& rates,
                                   const rational& t, precision bits);

template <class T>
moment<T> as_scalars(const moment<ball>& x, precision bits) {
  return {as_scalar<T>(x.cycle, bits), x.odd, as_scalar<T>(x.whole, x.whole.precision()),
          as_scalar<T>(x.fraction, bits)};
}

}  // namespace polhode::detail
