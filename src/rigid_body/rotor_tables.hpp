#pragma once

// What a rotation needs that does not depend on time, as balls of so many bits.

#include "polhode/rigid_body/rotor.hpp"
#include "rigid_body/rotor_series.hpp"

namespace polhode::detail {

/// u = 2K (cycles t + cycles_0 + half_turns_0), |cycles_0| <= 1/2, on the separatrix u = cycles t +
/// cycles_0; the angle phi is 2 pi turns t - 2 pi slip N - the lag, where N is the integer nearest
/// to u/(2K), 0 on the separatrix. A steady motion has turns only.
struct rotor_rates {
  ball cycles, cycles_0, turns, slip;
  long half_turns_0 = 0;
};

struct rotor_tables {
  /// With so many terms of the series as bits need, or with `terms` >= 2 (where the nome is not 0):
  /// what is left out is in the bounds either way.
  rotor_tables(const initial_state& state, precision bits, std::size_t terms = 0);

  rotor_rates rates;
  theta_series<ball> series;
  /// Of -dn, sn, cn (oscillating), -cn, sn, dn (rotating), -cn, sn, dn (separatrix); in a steady
  /// motion J_x, J_y, J_z over |J|.
  triple<ball> amplitude;
  /// |J|.
  ball size;
  work_count work;

 private:
  void set_circular(const motion& of, const exact_real& m, const ball& agm1, const ball& lambda,
                    precision bits);
  void set_hyperbolic(const motion& of, const exact_real& m, const ball& agm1, const ball& lambda,
                      precision bits);
  [[nodiscard]] ball counted_agm(const ball& second);
  [[nodiscard]] ball pole(const exact_real& m, const exact_real& kappa, precision bits);
  void set_factors(const std::vector<ball>& odd_powers, const std::vector<ball>& even_powers);
  std::size_t terms_;
  /// The mean of phi' in the formula, in units of |J|/I_y: mu of rotor_series.hpp.
  ball mu_;
};

}  // namespace polhode::detail
