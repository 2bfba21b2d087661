#pragma once

// A function that Arb has at points, with what is proved of it beside its values: where it is
// analytic, bounds over sets and towards infinity, its derivative. Compiled only where Arb is.
//
// Arb's values over sets are wide: a hypergeometric series of sets of radius r about z has a radius
// of r e^|z|. So a set Z with the middle m has f(m) + (Z - m) f', f' a mean of the derivative over
// the segments from m to Z's points (the mean value theorem of complex functions: f(z) - f(m) =
// (z - m) times the integral of f'(m + t (z - m)) for 0 <= t <= 1), with the bounds of |f'| that
// stand beside each function. A rectangle is convex.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arb_library.hpp"
#include "arb_numbers.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/library_functions.hpp"

namespace polhode::arb_functions_impl {

using detail::arb;
using detail::arb_number;
using formula = std::optional<std::string>;
using majorant = std::optional<further_function::majorant_formula>;
using leading = std::optional<further_function::leading_formula>;

inline constexpr precision few_bits = 64;

/// f's order, if it has one, and its variable.
struct call {
  const ball* order;
  complex_ball z;
  [[nodiscard]] bool is_real() const { return sign_of(z.im) == certain_sign::zero; }
};

/// Upper bounds of |f| and |f'|, where there are such.
struct bounds {
  magnitude size = magnitude::infinity();
  magnitude slope = magnitude::infinity();
};

/// f is analytic everywhere.
[[nodiscard]] inline obstacle nothing(const call&) { return obstacle::none; }

/// A function f(order, z) or f(z).
struct definition {
  expression_function what;
  bool has_order = false;
  /// Sets r to an enclosure of the value.
  void (*value)(acb_ptr r, acb_srcptr order, acb_srcptr z, slong p) = nullptr;
  /// What keeps f from being analytic on the rectangle z; none where it is.
  obstacle (*in_the_way)(const call& x) = nothing;
  /// Bounds over the rectangle z, on which f is analytic; nullptr: Arb has good values over sets.
  bounds (*over)(const call& x) = nullptr;
  /// A bound of the derivative in the order, over the order's set, at a single z or over a set;
  /// nullptr: none is known. With it the values over a set of orders are that of its middle and an
  /// error. Over the set itself Arb loses the bits that cancel in its sums, or takes minutes.
  magnitude (*over_order)(const call& x) = nullptr;
  const char* slope = "";  // f' as a formula in the names of its arguments
  std::function<bool(known_arguments)> may_be_defined = nullptr;
  /// f is defined at no number of the real set x.
  bool (*is_nowhere_defined)(const ball* order, const ball& x) = nullptr;
  /// The range where f is defined, over a real set x beyond the end of its domain.
  ball (*where_defined)(const ball* order, const ball& x) = nullptr;
  std::function<formula(known_arguments)> simpler = nullptr;
  /// Of |f(x)| for x > 0, or for x < 0 where sign is -1; `order` is nullptr where f has none.
  majorant (*bound)(const ball* order, int sign) = nullptr;
  /// f' over real sets, where the formula does not have it; nullptr: it has.
  ball (*slope_over)(const ball* order, const ball& x) = nullptr;
  /// f is monotonic over the real set x, on which it is analytic: its values lie between those at
  /// the ends.
  bool (*is_monotonic)(const ball* order, const ball& x) = nullptr;
  /// f over real sets, where more is known of them; nullptr: as over rectangles.
  ball (*over_reals)(const ball* order, const ball& x, precision p) = nullptr;
  /// f near 0, and from |x| = 4 on; `order` is nullptr where f has none.
  leading (*near_zero)(const ball* order, int sign) = nullptr;
  leading (*near_infinity)(const ball* order, int sign) = nullptr;
  /// f as a formula that shows its pole at -k.
  formula (*at_pole)(const ball* order, long k) = nullptr;
  /// Analytic functions of which f is the quotient.
  jet<ball, 1> (*numerator)(const jet<ball, 1>& x) = nullptr;
  jet<ball, 1> (*divisor)(const jet<ball, 1>& x) = nullptr;
};

// The functions by kind, and digamma, of which balls and regions have values of their own.
[[nodiscard]] std::vector<definition> bessel_functions();
[[nodiscard]] std::vector<definition> airy_functions();
[[nodiscard]] std::vector<definition> exponential_integrals();
[[nodiscard]] std::vector<definition> error_functions();
[[nodiscard]] std::vector<definition> other_functions();
[[nodiscard]] further_function digamma_function();
/// The function of that name among them.
[[nodiscard]] const definition& named(std::string_view name);

/// f's value with as many bits as it takes for p known ones; where the order is no single number,
/// fewer.
[[nodiscard]] complex_ball value_of(const definition& f, const call& x, precision p);
/// f on the rectangle x.z; undefined where it is not known to be analytic there.
[[nodiscard]] complex_ball value_or_undefined(const definition& f, const call& x, precision p);

/// Needs Re z > 0.
[[nodiscard]] obstacle left_half(const call& x);
/// At 0, -1, -2, ....
[[nodiscard]] obstacle poles_of_gamma(const call& x);
[[nodiscard]] bool is_whole(const ball& order);

[[nodiscard]] leading leading_term(std::string main, std::string rest);
[[nodiscard]] leading oscillating_beside(std::string main, std::string rest);
/// Where f is not defined for x < 0: a formula that is not, either.
[[nodiscard]] leading not_defined();
[[nodiscard]] majorant steady(std::string text);
[[nodiscard]] majorant oscillating(std::string text);

[[nodiscard]] ball upper_of(const magnitude& x);
/// At least the greatest |t| of a set of real numbers, and at most the least of one: single
/// numbers.
[[nodiscard]] ball greatest_size(const ball& t);
[[nodiscard]] ball least_of(const ball& t);

/// f at the ends of a set of real numbers, on which it is monotonic.
template <class F>
[[nodiscard]] ball at_ends(const F& f, const ball& x, precision p) {
  if (!x.is_bounded()) return ball::undefined(p);
  detail::mpfr_cell end(p + 64);
  x.lower(end.get());
  const ball lower(end.get());
  x.upper(end.get());
  return hull(f(lower), f(ball(end.get())));
}
/// A step h of an order, a power of two: 1, or for a small z about 1/|log2 |z||, in which a power
/// of z whose exponent is the order does not change much.
[[nodiscard]] inline ball step_of_order(const ball& z) {
  long step = 0;
  for (long k = -z.magnitude_lower().log2_floor(); k > 1; k /= 2) ++step;
  return scale(ball(1, few_bits), -step);
}
/// The greatest number of the set.
[[nodiscard]] inline ball upper_end(const ball& x) {
  detail::mpfr_cell end(x.precision() + 64);
  x.upper(end.get());
  return ball(end.get());
}
[[nodiscard]] inline bool always(const ball*, const ball&) { return true; }
[[nodiscard]] inline bool where_positive(const ball*, const ball& x) {
  return certainly_positive(x);
}

[[nodiscard]] inline bool where_not_zero(const ball*, const ball& x) {
  return certainly_positive(x) || certainly_negative(x);
}

[[nodiscard]] inline bool not_positive(const ball*, const ball& x) {
  return certainly_less_equal(x, ball(0, few_bits));
}
/// x < 0, and the order is no whole number.
[[nodiscard]] inline bool negative_with_broken_order(const ball* order, const ball& x) {
  return certainly_negative(x) && holds_no_integer(*order);
}

[[nodiscard]] bool is_number(const std::optional<pi_combination>& x);
[[nodiscard]] bool is_exactly(const std::optional<pi_combination>& x, long n);
[[nodiscard]] bool last_is_positive(known_arguments x);

}  // namespace polhode::arb_functions_impl
