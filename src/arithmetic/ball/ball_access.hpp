#pragma once

// What the files of src/arithmetic share: the inside of a ball, and the two ways of making one.

#include "polhode/arithmetic/ball.hpp"

namespace polhode {

struct ball_access {
  using form = ball::form;

  static detail::mpfr_cell& first(ball& x) { return x.first_; }
  static mpfr_srcptr first(const ball& x) { return x.first_.get(); }
  static detail::mpfr_cell& second(ball& x) { return x.second_; }
  static mpfr_srcptr second(const ball& x) { return x.second_.get(); }
  static const magnitude& radius(const ball& x) { return x.radius_; }
  static form form_of(const ball& x) { return x.form_; }
  static bool is_midpoint_radius(const ball& x) { return x.form_ == form::midpoint_radius; }

  static void set_undefined(ball& r, precision p) {
    r.first_.reset(p);
    r.form_ = form::undefined;
  }
  static void set_form(ball& r, form f) { r.form_ = f; }
  static void set_thin(ball& r, const magnitude& radius) {
    r.radius_ = radius;
    r.form_ = form::midpoint_radius;
  }

  /// r's midpoint was just set by an MPFR function in round-to-nearest, which returned `ternary`.
  /// Makes r the ball of that midpoint whose radius is `error` plus the rounding error.
  static void finish(ball& r, int ternary, const magnitude& error);

  /// Makes r the set [lower, upper]; the cells have the precision that r shall have, and are
  /// emptied. A NaN at either end makes r undefined.
  static void set_ends(ball& r, detail::mpfr_cell& lower, detail::mpfr_cell& upper);
  /// The same, but that no end is moved: what set_ends keeps by midpoint and radius, at the cost of
  /// a wider set, stays a pair of ends.
  static void set_exact_ends(ball& r, detail::mpfr_cell& lower, detail::mpfr_cell& upper);

 private:
  static void set_ends(ball& r, detail::mpfr_cell& lower, detail::mpfr_cell& upper, bool exactly);
};

namespace detail {

/// The rounding error of an MPFR result x in round-to-nearest: half a unit in the last place, or
/// the least positive number where it underflowed. Infinite where it overflowed.
[[nodiscard]] magnitude rounding_error(mpfr_srcptr x);

/// The end points of a ball, computed at precision p only where the ball does not already hold
/// them.
class end_points {
 public:
  end_points(const ball& x, precision p);
  end_points(ball&&, precision) = delete;  // they may be those that x keeps
  [[nodiscard]] mpfr_srcptr lower() const { return lower_; }
  [[nodiscard]] mpfr_srcptr upper() const { return upper_; }

 private:
  mpfr_cell computed_lower_;
  mpfr_cell computed_upper_;
  mpfr_srcptr lower_;
  mpfr_srcptr upper_;
};

/// Calls f(destination, rounding) to set a midpoint of p bits: f may read balls that alias r.
template <class F>
void set_midpoint(ball& r, precision p, const magnitude& error, F&& f) {
  mpfr_cell& cell = ball_access::first(r);
  if (mpfr_get_prec(cell.get()) == p) {
    const int ternary = f(cell.get());
    ball_access::finish(r, ternary, error);
  } else {
    mpfr_cell fresh(p);
    const int ternary = f(fresh.get());
    cell = static_cast<mpfr_cell&&>(fresh);
    ball_access::finish(r, ternary, error);
  }
}

}  // namespace detail
}  // namespace polhode
