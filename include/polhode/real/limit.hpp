#pragma once

// The ends of ranges, as templates over Real take them.

#include <algorithm>
#include <string>

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/expression/formula_of.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/real/number.hpp"

namespace polhode {

/// An end of a range of numbers of type R: an R, which is the exact number that it is, an infinity
/// of R, a whole number, a rational, a double literal that is what it looks like, or an end_point.
/// R's own pi is a decimal of pi: the number pi itself is end_point::pi(), or
/// boost::math::constants::pi<symbol>().
template <class R>
class range_limit {
 public:
  template <machine_integer N>
  range_limit(N n)  // NOLINT(google-explicit-constructor): exact
      : point_(n) {}
  template <no_number_at_all N>
  range_limit(N) = delete;
  range_limit(const rational& q)  // NOLINT(google-explicit-constructor): exact
      : point_(q) {}
  range_limit(const rational_literal& q)  // NOLINT(google-explicit-constructor): exact
      : point_(q.value()) {}
  range_limit(const end_point& x)  // NOLINT(google-explicit-constructor): the same
      : point_(x) {}
  range_limit(const symbol& x)  // NOLINT(google-explicit-constructor): exact
      : point_(end_point_of(formula_of(x, {}))) {}
  range_limit(const R& x)  // NOLINT(google-explicit-constructor): exact
      : bits_(bits_of(x)) {
    set(x);
  }
  /// A double that is not the decimal it looks like, as 0.1, is refused.
  range_limit(double x)  // NOLINT(google-explicit-constructor): exact
      requires(!std::same_as<R, double>) {
    if (x - x == 0 && !exact_double::is_exact(x)) {
      problem_ = "an end of the range is the double " + std::to_string(x) +
                 ", which is not the decimal it looks like; write \"0.1\"_r or rational(1, 10) for "
                 "0.1, or "
                 "Real(x) for the number that x is";
      return;
    }
    const range_limit<double> same(x);
    point_ = same.point_;
    problem_ = same.problem_;
  }
  template <detail::boost_expression E>
  requires std::same_as<typename E::result_type, R> range_limit(
      const E& x)  // NOLINT(google-explicit-constructor): exact
      : range_limit(R(x)) {}

  /// Throws input_error where what was given is no end of a range.
  [[nodiscard]] const end_point& point() const {
    if (!problem_.empty()) throw input_error(problem_);
    return point_;
  }
  /// The precision that a number brought with it; 0 where it brought none.
  [[nodiscard]] precision bits() const { return bits_; }

 private:
  static precision bits_of(const R& x) {
    if constexpr (std::same_as<R, ball>) {
      return x.precision();
    } else if constexpr (detail::has_variable_precision<R>) {
      return precision_of(x);
    } else {
      return 0;
    }
  }
  void set(const R& x) {
    if constexpr (std::same_as<R, ball>) {
      point_ = end_point(x);
    } else if (x != x) {
      problem_ = "an end of the range is a NaN; it must be a number or an infinity";
    } else if (x - x != 0) {
      point_ = x > 0 ? end_point::infinity() : -end_point::infinity();
    } else {
      point_ = end_point(lower_rational(ball_of(x)));
    }
  }
  template <class>
  friend class range_limit;

  end_point point_ = 0;
  precision bits_ = 0;
  std::string problem_;
};

namespace detail {
/// The bits to compute with between two ends: the more precise of numbers of variable precision,
/// else those of R.
template <floating_real R>
[[nodiscard]] precision working_bits(const range_limit<R>& a, const range_limit<R>& b) {
  const precision given = std::max(a.bits(), b.bits());
  return given > 0 ? given : usual_bits<R>();
}
}  // namespace detail

}  // namespace polhode
