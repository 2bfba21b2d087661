#include "polhode/rigid_body/rotor.hpp"

#include "polhode/arithmetic/elementary.hpp"
#include "rigid_body/rotor_double.hpp"
#include "rigid_body/rotor_motion.hpp"

namespace polhode {

template <class T>
rotor<T>::rotor(const initial_state& state, precision p)
    : motion_(std::make_shared<const detail::rotor_motion<T>>(state, p)) {}

template <class T>
rotor_sample<T> rotor<T>::sample(const rational& t) const {
  return motion_->sample(t);
}
template <class T>
rotor_attitude<T> rotor<T>::attitude(const rational& t) const {
  return motion_->attitude(t);
}
template <class T>
rotor_sample<T> rotor<T>::sample(double t) const requires std::same_as<T, double> {
  return motion_->sample(t);
}
template <class T>
rotor_attitude<T> rotor<T>::attitude(double t) const requires std::same_as<T, double> {
  return motion_->attitude(t);
}
template <class T>
const initial_state& rotor<T>::state() const {
  return motion_->state();
}
template <class T>
const work_count& rotor<T>::work() const {
  return motion_->work();
}
template <class T>
T rotor<T>::momentum_size() const {
  return motion_->size();
}

namespace {

/// turns T - 2 slip, T = 2/cycles, times 2 pi.
ball phase_of(const detail::rotor_rates& rates) {
  const ball turns = scale(rates.turns / rates.cycles - rates.slip, 1);
  return 2 * pi(turns.precision()) * turns;
}

}  // namespace

template <class T>
std::optional<T> rotor<T>::period() const {
  if (!is_periodic(state().regime())) return std::nullopt;
  return motion_->number(2 / motion_->rates().cycles);
}
template <class T>
std::optional<T> rotor<T>::phase_per_period() const {
  if (!is_periodic(state().regime())) return std::nullopt;
  return motion_->number(phase_of(motion_->rates()));
}
template <class T>
T rotor<T>::mean_precession() const {
  const detail::rotor_rates& rates = motion_->rates();
  if (is_periodic(state().regime())) return motion_->number(phase_of(rates) * rates.cycles / 2);
  if (is_equilibrium(state().regime())) {
    return motion_->number(2 * pi(rates.turns.precision()) * rates.turns);
  }
  const exact_real& middle = state().tensor().moments()[1];
  const exact_real square = state().squared_momentum() / (middle * middle);
  return motion_->number(sqrt(square.at(rates.turns.precision())));
}

template class rotor<ball>;
template class rotor<mpfr_float>;
template class rotor<double>;

}  // namespace polhode
