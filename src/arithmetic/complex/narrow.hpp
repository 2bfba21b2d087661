#pragma once

// Complex balls whose parts are narrow and far from MPFR's limits of exponents: they are computed
// with by midpoints and radii, to first order.

#include <algorithm>
#include <optional>
#include <utility>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/exponent_range.hpp"
#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode::detail::complex_balls {

/// By midpoint and radius, and moderate.
[[nodiscard]] inline bool is_moderate(const ball& x, const exponent_range& range) {
  return ball_access::is_midpoint_radius(x) && range.is_moderate(ball_access::first(x));
}
/// The same for a bounded ball in either form.
[[nodiscard]] inline bool has_moderate_ends(const ball& x, const exponent_range& range) {
  if (ball_access::is_midpoint_radius(x)) return is_moderate(x, range);
  return x.is_bounded() && range.is_moderate(ball_access::first(x)) &&
         range.is_moderate(ball_access::second(x));
}
[[nodiscard]] inline bool has_moderate_ends(const rectangle<ball>& z, const exponent_range& range) {
  return has_moderate_ends(z.re, range) && has_moderate_ends(z.im, range);
}

/// The midpoints and the radii of both parts of a complex ball.
struct centred {
  /// Of narrow sets.
  explicit centred(const rectangle<ball>& z)
      : re(ball_access::first(z.re)),
        im(ball_access::first(z.im)),
        re_radius(ball_access::radius(z.re)),
        im_radius(ball_access::radius(z.im)) {}
  centred(mpfr_srcptr x, const magnitude& rx, mpfr_srcptr y, const magnitude& ry)
      : re(x), im(y), re_radius(rx), im_radius(ry) {}
  [[nodiscard]] bool is_exact() const { return re_radius.is_zero() && im_radius.is_zero(); }

  mpfr_srcptr re;
  mpfr_srcptr im;
  magnitude re_radius;
  magnitude im_radius;
};

/// The same of any bounded sets.
class centred_copy {
 public:
  explicit centred_copy(const rectangle<ball>& z)
      : x_(z.re.middle()),
        y_(z.im.middle()),
        view_(ball_access::first(std::as_const(x_)), z.re.radius(),
              ball_access::first(std::as_const(y_)), z.im.radius()) {}
  centred_copy(const centred_copy&) = delete;
  centred_copy(centred_copy&&) = delete;
  centred_copy& operator=(const centred_copy&) = delete;
  centred_copy& operator=(centred_copy&&) = delete;
  ~centred_copy() = default;
  [[nodiscard]] const centred& view() const { return view_; }

 private:
  ball x_;
  ball y_;
  centred view_;
};

[[nodiscard]] inline bool is_narrow_and_moderate(const rectangle<ball>& z,
                                                 const exponent_range& range = {}) {
  return is_moderate(z.re, range) && is_moderate(z.im, range);
}
[[nodiscard]] inline bool are_narrow_and_moderate(const rectangle<ball>& z,
                                                  const rectangle<ball>& w) {
  const exponent_range range;
  return is_narrow_and_moderate(z, range) && is_narrow_and_moderate(w, range);
}

[[nodiscard]] inline precision common_precision(const rectangle<ball>& z,
                                                const rectangle<ball>& w) {
  return std::max({z.re.precision(), z.im.precision(), w.re.precision(), w.im.precision()});
}

/// a b + c d, rounded up.
[[nodiscard]] inline magnitude sum_of_products_up(const magnitude& a, const magnitude& b,
                                                  const magnitude& c, const magnitude& d) {
  return add_up(multiply_up(a, b), multiply_up(c, d));
}

/// Bounds of the sizes of the members of a set; they have the midpoint's sign where least > 0.
struct range_of_size {
  magnitude least;
  magnitude most;
};
[[nodiscard]] inline range_of_size size_of(mpfr_srcptr midpoint, const magnitude& radius) {
  return {subtract_down(magnitude::abs_down(midpoint), radius),
          add_up(magnitude::abs_up(midpoint), radius)};
}

/// Makes r the ball about `value`, rounded to r's precision, with that error and the rounding's.
inline void set_rounded(ball& r, mpfr_srcptr value, precision p, const magnitude& error) {
  set_midpoint(r, p, error, [&](mpfr_ptr m) { return mpfr_set(m, value, MPFR_RNDN); });
}

/// The quotient of moderate sets, to first order; nothing where an intermediate number left MPFR's
/// range, or b's midpoint is 0.
[[nodiscard]] std::optional<complex_ball> centred_quotient(const centred& a, const centred& b,
                                                           precision p);

}  // namespace polhode::detail::complex_balls
