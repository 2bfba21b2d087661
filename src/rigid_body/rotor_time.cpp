#include "rigid_body/rotor_time.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {
namespace {

/// x - n, n the integer nearest to the middle of x.
std::pair<ball, integer> without_whole(const ball& x) {
  integer n;
  mpfr_get_z(n.backend().data(), midpoint(x).backend().data(), MPFR_RNDN);
  return {x - n, n};
}

constexpr std::int64_t most_bits_before_point = std::int64_t{1} << 24;

/// About how many bits x has before the point.
std::int64_t bits_of(const ball& x) { return std::max<std::int64_t>(exponent_of(x) + 1, 0); }

}  // namespace

moment<ball> reduced(const rotor_rates& rates, regime kind, const rational& t, precision bits) {
  const precision all = rates.turns.precision();
  const ball time(t, all);
  moment<ball> r;
  integer n = 0;
  if (is_equilibrium(kind)) {
    r.cycle = ball(0, bits);
  } else {
    ball cycles = rates.cycles * time + rates.cycles_0;
    if (kind != regime::separatrix) std::tie(cycles, n) = without_whole(cycles);
    n += rates.half_turns_0;
    r.cycle = cycles.with_precision(bits);
  }
  r.odd = mpz_odd_p(n.backend().data()) != 0;
  const auto [fraction, whole] = without_whole(rates.turns * time - rates.slip * n);
  r.whole = ball(whole, all);
  r.fraction = fraction.with_precision(bits);
  return r;
}

moment<ball> reduced(const initial_state& state, const rotor_rates& rates, const rational& t,
                     precision bits) {
  const ball time(t, 64);
  const std::int64_t needed =
      std::max(bits_of(rates.cycles * time), bits_of(rates.turns * time)) + 8;
  // Where a time has more bits than these before the point, the result is as wide as it is.
  if (bits + needed <= rates.turns.precision() || needed > most_bits_before_point) {
    return reduced(rates, state.regime(), t, bits);
  }
  const rotor_tables more(state, bits + static_cast<precision>(needed) + 8);
  return reduced(more.rates, state.regime(), t, bits);
}

}  // namespace polhode::detail
