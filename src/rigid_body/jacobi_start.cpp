#include "polhode/rigid_body/jacobi_start.hpp"

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/elliptic/carlson.hpp"

namespace polhode {

jacobi_start jacobi_start_of(const initial_state& state) {
  if (is_equilibrium(state.regime())) {
    throw input_error(to_text(state.regime()) +
                      ": J does not move in the body, and has no place in a period");
  }
  const bool oscillating = state.regime() == regime::oscillating;
  const triple<exact_real> greatest = state.motion().greatest_squares();
  const triple<exact_real>& squares = state.direction_squares();
  const triple<int>& senses = state.direction_signs();
  const exact_real x = squares[0] / greatest[0];
  const exact_real z = squares[2] / greatest[2];
  jacobi_start result;
  result.sine = senses[1];
  result.cosine = oscillating ? senses[2] : -senses[0];
  result.sine2 = squares[1] / greatest[1];
  result.cosine2 = oscillating ? z : x;
  result.delta2 = oscillating ? x : z;
  return result;
}

ball jacobi_start::distance(precision p) const {
  return sqrt(sine2.at(p)) * carlson_rf(cosine2.at(p), delta2.at(p), ball(1, p));
}

}  // namespace polhode
