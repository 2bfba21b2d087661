#pragma once

// The region: a set of complex numbers on which a function is being bounded, and the knowledge
// whether the function is analytic there.
//
// A region is a rectangle in hardware doubles with outward rounding, some tens of nanoseconds an
// operation. Put regions into a generic function f that was written for real arguments: the result
// is an enclosure of f's analytic continuation over the rectangle, or says that none was proved:
//   a square root, logarithm or power meets its branch cut, a division or a tangent a pole, abs,
//   min or max the line where it changes from one analytic piece to another, floor or ceil a jump.
// The answer is in the value (`is_analytic`, `why`, `where`) and spreads to every result made of
// it, so that no caller can pass it by: a bound asked of a region that is not analytic is infinite.
//
// Beside the rectangle a region may know more of |z| than the rectangle tells: exp(z) with a large
// imaginary part lies in a ring, whose rectangle holds 0, and yet 1/exp(z) or 1/(1 + exp(z)) has no
// pole there. What exp, sin, cos, sinh and cosh know of their size goes through + - * / and powers.
// Such a set is not convex: what a mean value lies in is its convex_hull().
//
// What the functions mean off the real line: abs(z) is z where Re z > 0 and -z where Re z < 0, the
// continuation of |x| from either side; min and max likewise pick the one that is smaller or
// greater in its real part; floor(z) is the constant that it is on the real numbers of the same
// real part.
//
// Where a result leaves the range of doubles (overflow, underflow) the rectangle gets a power of
// two as a factor, in sums, products, quotients, powers, roots, exp, sin, cos, sinh and cosh; where
// that does not serve it is computed again, and carried on, with balls of 64 bits, whose exponents
// go as far.

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/double_interval.hpp"

namespace polhode {

/// What rectangle.hpp needs of a double_interval: there are no narrow sets and no more bits to
/// raise.
template <>
struct real_set<double_interval> {
  static constexpr bool has_narrow = false;

  static bool is_undefined(double_interval x) { return x.is_undefined(); }
  static bool is_bounded(double_interval x) { return x.is_bounded(); }
  static bool is_exact(double_interval x) { return x.is_exact(); }
  static bool is_zero(double_interval x) { return x.is_exact() && contains_zero(x); }
  static bool is_machine_integer(double_interval x, long& n) {
    if (!x.is_exact() || !(x.lower() >= -0x1p53 && x.lower() <= 0x1p53)) return false;
    n = static_cast<long>(x.lower());
    return contains(double_interval(n), x);
  }
  static bool not_negative(double_interval x) { return !x.is_undefined() && x.lower() >= 0; }

  static double_interval integer(long n, double_interval) { return double_interval(n); }
  static double_interval pi(double_interval) { return 4 * atan(double_interval(1)); }
  static double_interval undefined(double_interval) { return double_interval::undefined(); }
  static rectangle<double_interval> unit(double_interval like) {
    return {integer(1, like), integer(0, like)};
  }

  static double_interval raised(double_interval x, long) { return x; }
  static double_interval doubled(double_interval x) { return x; }
  static double_interval rounded(double_interval x, double_interval) { return x; }
  static double_interval coarse(double_interval x) { return x; }
  static long bits_before_point(double_interval) { return 0; }

  static double_interval lower_end(double_interval x) { return end(x, x.lower()); }
  static double_interval upper_end(double_interval x) { return end(x, x.upper()); }

  static double_interval modulus(double_interval x, double_interval y) { return hypot(x, y); }
  static std::pair<double_interval, double_interval> sin_cos(double_interval x) {
    return polhode::sin_cos(x);
  }
  static std::pair<double_interval, double_interval> sinh_cosh(double_interval x) {
    return {sinh(x), cosh(x)};
  }

  static bool is_narrow(double_interval) { return false; }
  static double_interval middle(double_interval x) { return double_interval(x.midpoint()); }
  static bool is_steady(const rectangle<double_interval>&) { return false; }
  static bool enlarge(double_interval&, double_interval, double_interval, double_interval,
                      double_interval) {
    return false;
  }
  static rectangle<double_interval> quotient(const rectangle<double_interval>& z,
                                             const rectangle<double_interval>&) {
    return {undefined(z.re), undefined(z.im)};
  }

 private:
  /// An end as a point; where it is infinite, all numbers beyond the greatest finite one.
  static double_interval end(double_interval x, double value) {
    constexpr double most = std::numeric_limits<double>::max();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    if (x.is_undefined()) return x;
    if (value == infinite) return {most, infinite};
    if (value == -infinite) return {-infinite, -most};
    return double_interval(value);
  }
};

/// Why a function is not proved analytic on a region.
enum class obstacle {
  none,
  branch_cut,  // of sqrt, log, pow, an inverse function
  pole,        // of a quotient, tan, tanh, a negative power
  kink,        // of abs, min, max
  jump,        // of floor, ceil
  undefined,   // the region itself is undefined
  unknown      // not proved, for want of an enclosure of the function on regions
};

[[nodiscard]] std::string to_text(obstacle o);

class region {
 public:
  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;
  /// {0}.
  region() = default;
  /// A rectangle, a real interval or a real number.
  region(double_interval re, double_interval im) : hardware_{re, im} { settle(); }
  explicit region(double_interval re) : region(re, double_interval(0)) {}
  /// The set of a ball or a complex ball.
  explicit region(const ball& re) { *this = from_balls({re, ball(0, re.precision())}); }
  explicit region(const complex_ball& z) { *this = from_balls(z); }
  /// The set of z, kept in balls of z's precision and carried on so: for points so close together
  /// that hardware doubles do not tell them apart.
  [[nodiscard]] static region in_balls(const complex_ball& z);

  /// The answer of a function that met an obstacle: obstacle::unknown where it has no enclosure
  /// over any region. The function's name must outlive the region: a literal.
  [[nodiscard]] static region blocked(obstacle why, std::string_view function);

  /// The function computed so far is proved analytic on a neighbourhood of everything it was given.
  [[nodiscard]] bool is_analytic() const { return obstacle_ == obstacle::none; }
  [[nodiscard]] obstacle why() const { return obstacle_; }
  /// The name of the function that met the obstacle; empty where there is none.
  [[nodiscard]] std::string_view where() const { return where_; }

  /// Bounds of |z| over the set; infinite and 0 where it is not analytic.
  [[nodiscard]] magnitude magnitude_upper() const;
  [[nodiscard]] magnitude magnitude_lower() const;
  /// A convex set that holds this one: without a lower bound of |z| that is not its rectangle's.
  [[nodiscard]] region convex_hull() const;
  /// The parts, rounded outward; undefined where not analytic.
  [[nodiscard]] double_interval re() const;
  [[nodiscard]] double_interval im() const;
  /// The set as a complex ball, of 64 bits where it is kept in the hardware.
  [[nodiscard]] complex_ball to_complex_ball() const;
  /// The set is kept in hardware doubles (times a power of two), not in balls.
  [[nodiscard]] bool is_in_hardware() const { return balls_ == nullptr; }
  /// 53, or that of the balls it is kept in.
  [[nodiscard]] polhode::precision precision() const {
    return balls_ == nullptr ? 53 : balls_->precision();
  }

  friend region operator+(const region& z) { return z; }
  friend region operator-(const region& z);
  friend region operator+(const region& z, const region& w);
  friend region operator-(const region& z, const region& w);
  friend region operator*(const region& z, const region& w);
  friend region operator/(const region& z, const region& w);

  region& operator+=(const region& w) { return *this = *this + w; }
  region& operator-=(const region& w) { return *this = *this - w; }
  region& operator*=(const region& w) { return *this = *this * w; }
  region& operator/=(const region& w) { return *this = *this / w; }

  friend region square(const region& z);
  friend region sqrt(const region& z);
  friend region exp(const region& z);
  friend region log(const region& z);
  friend region sin(const region& z);
  friend region cos(const region& z);
  friend region tan(const region& z);
  friend region asin(const region& z);
  friend region acos(const region& z);
  friend region atan(const region& z);
  friend region sinh(const region& z);
  friend region cosh(const region& z);
  friend region tanh(const region& z);
  friend region asinh(const region& z);
  friend region acosh(const region& z);
  friend region atanh(const region& z);
  friend region pow(const region& z, long n);
  /// exp(w log z), with log's branch cut, whatever w is.
  friend region pow(const region& z, const region& w);
  friend region abs(const region& z);
  friend region min(const region& z, const region& w);
  friend region max(const region& z, const region& w);
  friend region floor(const region& z);
  friend region ceil(const region& z);

 private:
  static region from_balls(const complex_ball& z, bool keep_balls = false);
  /// Marks an undefined set.
  void settle();
  [[nodiscard]] bool needs_balls() const;

  struct scaled;
  struct not_scaled;
  struct scaled_interval;
  static constexpr double moderate_exponent =
      600;  // e^600 and e^-600 are far from a double's limits
  /// Analytic, and a rectangle in hardware without a factor.
  [[nodiscard]] bool is_moderate() const {
    return is_analytic() && is_in_hardware() && exponent_ == 0;
  }
  [[nodiscard]] bool knows_modulus() const;
  [[nodiscard]] scaled_interval modulus() const;
  /// With that known of |z|.
  [[nodiscard]] region with_modulus(const scaled_interval& m) &&;
  static region rotating(double_interval size, double_interval angle);
  static region hyperbolic(double_interval x, double_interval y, bool is_cosh);
  template <class Hardware, class Balls, class Scaled = not_scaled>
  static region combined(const region& z, const region& w, Hardware&& hardware, Balls&& balls,
                         const Scaled& scaled_form = {}, bool zero_is_news = false);
  struct functions;

  static constexpr double_interval not_known{detail::unchecked{}, 0, detail::infinity};

  rectangle<double_interval> hardware_;
  long exponent_ = 0;  // the set is 2^exponent_ times hardware_
  double_interval modulus_ =
      not_known;  // holds |z| for z in hardware_: what the rectangle does not tell
  std::shared_ptr<const complex_ball> balls_;  // the set, where the hardware's range was left
  obstacle obstacle_ = obstacle::none;
  std::string_view where_;
};

// With exact numbers, balls and complex balls, which are constants, rounded no worse than the
// region is.
namespace detail {
template <class N>
concept region_constant = exact_number<N> || std::same_as<N, ball> || std::same_as<N, complex_ball>;
template <region_constant N>
[[nodiscard]] region constant_region(const N& n, const region& like) {
  if constexpr (!exact_number<N>) {
    if (like.is_in_hardware()) return region(n);
    return region::in_balls(complex_ball(n));
  } else {
    if (!like.is_in_hardware()) {
      return region::in_balls({ball(n, like.precision()), ball(0, like.precision())});
    }
    // Beyond the range of doubles, or below it (an end is 0 and n is not), with the exponents of
    // balls.
    const double_interval x(n);
    const bool left_range = x.is_out_of_range() || (contains_zero(x) && !x.is_exact());
    return left_range ? region(ball(n, 64)) : region(x);
  }
}
}  // namespace detail

template <detail::region_constant N>
[[nodiscard]] region operator+(const region& z, const N& n) {
  return z + detail::constant_region(n, z);
}
template <detail::region_constant N>
[[nodiscard]] region operator+(const N& n, const region& z) {
  return detail::constant_region(n, z) + z;
}
template <detail::region_constant N>
[[nodiscard]] region operator-(const region& z, const N& n) {
  return z - detail::constant_region(n, z);
}
template <detail::region_constant N>
[[nodiscard]] region operator-(const N& n, const region& z) {
  return detail::constant_region(n, z) - z;
}
template <detail::region_constant N>
[[nodiscard]] region operator*(const region& z, const N& n) {
  return z * detail::constant_region(n, z);
}
template <detail::region_constant N>
[[nodiscard]] region operator*(const N& n, const region& z) {
  return detail::constant_region(n, z) * z;
}
template <detail::region_constant N>
[[nodiscard]] region operator/(const region& z, const N& n) {
  return z / detail::constant_region(n, z);
}
template <detail::region_constant N>
[[nodiscard]] region operator/(const N& n, const region& z) {
  return detail::constant_region(n, z) / z;
}

/// exp(e log z), with log's branch cut.
template <rational_like N>
[[nodiscard]] region pow(const region& z, const N& e) {
  return pow(z, detail::constant_region(e, z));
}
template <class N>
requires std::same_as<N, ball> || std::same_as<N, complex_ball>
[[nodiscard]] region pow(const region& z, const N& e) {
  return pow(z, detail::constant_region(e, z));
}

/// i z.
[[nodiscard]] inline region times_i(const region& z) { return complex_ball::i(64) * z; }

}  // namespace polhode
