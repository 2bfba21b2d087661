#pragma once

// Integrals of a person's generic function along paths in the complex plane, with parts of type
// Real.
//
//   const auto i = polhode::integrate_along<Real>([](auto z) { return exp(z) / (z * z * z); },
//                                                 path::circle(0, 1));   // i.im is pi
//
// The sums are of complex balls, so that the rounding errors are proved too: Boost's own complex
// numbers need a library (MPC) that this one does without.

#include <limits>

#include "polhode/quadrature/contour.hpp"
#include "polhode/real/function.hpp"
#include "polhode/real/integrate.hpp"
#include "polhode/real/number.hpp"
#include "polhode/real/policy.hpp"

namespace polhode {

/// An integral along a path. Where the verdict is certified its parts differ from re and im by no
/// more than the errors.
template <floating_real R>
struct path_integral : certification {
  R re = std::numeric_limits<R>::quiet_NaN();
  R im = std::numeric_limits<R>::quiet_NaN();
  R re_error = std::numeric_limits<R>::infinity();
  R im_error = std::numeric_limits<R>::infinity();
  integral_account account;
};

namespace detail {
/// A number near the middle of a ball, and a bound of its distance from all of the ball.
template <floating_real R>
void set_number_and_error(const ball& x, precision p, R& value, R& error) {
  if (!x.is_bounded()) return;
  value = nearest_as<R>(x, p);
  const ball distance = x - ball_of(value);
  error = upper_as<R>(ball(0, 64).enlarged(distance.magnitude_upper()), p);
}
}  // namespace detail

/// The integral of a generic function f along a path, an enclosure: as integrate_along in
/// quadrature/contour.hpp.
template <class Real, class F>
requires std::same_as<Real, ball>
[[nodiscard]] contour_integral integrate_along(const F& f, const path& along,
                                               const integrate_options& options = {}) {
  return integrate_along(complex_formula_of<detail::symbol_of_real<Real>>(f), along, options);
}

/// The same with parts in Real, certified, rounding included. Policies as in real/integrate.hpp.
template <class Real, class F, class Policy = answer_by_verdict>
requires floating_real<Real>
[[nodiscard]] path_integral<Real> integrate_along(const F& f, const path& along,
                                                  const real_integrate_options& options = {},
                                                  const Policy& policy = {}) {
  constexpr const char* function = "polhode::integrate_along<%1%>(f, path)";
  path_integral<Real> result;
  try {
    const precision bits = usual_bits<Real>();
    const long digits = options.digits.value_or(detail::digits_wanted<Real, Policy>(bits));
    detail::expect_digits(digits);
    const contour_integral found =
        integrate_along(complex_formula_of<detail::symbol_of_real<Real>>(f), along,
                        detail::options_for(options, digits));
    detail::set_number_and_error(found.enclosure.re, bits, result.re, result.re_error);
    detail::set_number_and_error(found.enclosure.im, bits, result.im, result.im_error);
    static_cast<certification&>(result) = static_cast<const certification&>(found);
    result.account = found.account;
  } catch (const input_error& error) {
    result.re = detail::bad_input<Real>(function, error, policy);
    result.obstacle = error.what();
    return result;
  }
  if (result.verdict != status::certified) {
    result.re = detail::not_proved(function, result.obstacle, result.re, policy);
  }
  return result;
}

/// Refuses any other Real.
template <class Real, class F, class... Rest>
requires(!real_or_ball<Real> && std::is_class_v<F>) void integrate_along(const F& /*f*/,
                                                                         const Rest&... /*rest*/) {
  static_assert(detail::real_needed<Real>::reported);
}

}  // namespace polhode
