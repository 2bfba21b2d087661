#pragma once

// The real ball: a set of reals that is known to hold a number.
//
// THE INCLUSION PRINCIPLE. Every operation of this library that takes balls and returns a ball
// obeys it: if x_1, ..., x_n are reals in the operands' sets and f(x_1, ..., x_n) is defined, then
// it lies in the result's set. The comment above a function says only what it adds to that.
//
// A ball has one of two forms, which differ in how tightly they hold a set, never in what they
// mean:
//   midpoint and radius   the cheap form of a number known to many digits: an MPFR number and a
//                         radius of 31 bits rounded up (the style of Arb: F. Johansson, 2017);
//   two end points        the tight form of a wide set: two MPFR numbers, rounded outward, either
//                         of which may be infinite (the style of MPFI and IEEE 1788).
// Results with a radius above 2^-24 of the midpoint pass to end points; end points that were
// rounded, and are closer together than 2^-(precision/2) of their size, pass to midpoint and
// radius. A ball may also be *undefined*: the operation is not defined on the whole of its operands
// (a root of [-1, 1], a division by [0, 1]). Undefined spreads to every result, prints as
// "undefined", and answers "possibly" and never "certainly" to every question.
//
// Precision is a property of the value, in bits. A result has the largest precision among its
// operands; integers and rationals have none of their own. There is no global and no thread-local
// state that changes a result: the same call gives the same bits on every thread.
//
// There is no operator< and no construction from double, on purpose: see certainly_less below, and
// ball::exactly for a double that is meant as the exact number it is.

#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <type_traits>
#include <utility>

#include <gmp.h>
#include <mpfr.h>

#include "polhode/arithmetic/magnitude.hpp"
#include "polhode/arithmetic/mpfr_cell.hpp"

namespace polhode {

/// Numbers of Boost.Multiprecision (or anything of their shape), taken exactly. No Boost header is
/// needed to name them here.
template <class N>
concept integer_like = requires(const N& n) {
  { n.backend().data() } -> std::convertible_to<mpz_srcptr>;
};
template <class N>
concept rational_like = requires(const N& n) {
  { n.backend().data() } -> std::convertible_to<mpq_srcptr>;
};
template <class N>
concept mpfr_like = requires(const N& n) {
  { n.backend().data() } -> std::convertible_to<mpfr_srcptr>;
};
template <class N>
concept machine_integer = std::integral<N> && !std::same_as<N, bool> && sizeof(N) <= sizeof(long);

class ball;
namespace detail {
/// A precision that was checked when the balls it comes from were made.
struct room {
  precision bits;
};
[[nodiscard]] inline room room_for(const ball& x, const ball& y);
}  // namespace detail

class ball {
 public:
  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;
  /// Exactly 0, at 64 bits.
  ball() noexcept : first_(64) {}
  explicit ball(detail::room r) : first_(r.bits) {}

  ball(const ball&) = default;
  ball& operator=(const ball&) = default;
  /// A ball that was moved from is undefined, with 64 bits.
  ball(ball&& other) noexcept
      : first_(std::move(other.first_)),
        second_(std::move(other.second_)),
        radius_(other.radius_),
        form_(other.form_) {
    other.empty();
  }
  ball& operator=(ball&& other) noexcept {
    if (this != &other) {
      first_ = std::move(other.first_);
      second_ = std::move(other.second_);
      radius_ = other.radius_;
      form_ = other.form_;
      other.empty();
    }
    return *this;
  }
  ~ball() = default;

  /// The integer n; where it has more than p bits, the enclosure of it with p bits.
  template <machine_integer N>
  ball(N n, precision p) {
    if constexpr (std::is_signed_v<N>) {
      set_integer(static_cast<long>(n), p);
    } else {
      set_integer(static_cast<unsigned long>(n), p);
    }
  }
  ball(mpz_srcptr n, precision p);
  ball(mpq_srcptr q, precision p);
  template <integer_like N>
  ball(const N& n, precision p) : ball(static_cast<mpz_srcptr>(n.backend().data()), p) {}
  template <rational_like N>
  ball(const N& q, precision p) : ball(static_cast<mpq_srcptr>(q.backend().data()), p) {}

  /// The number x itself, with x's precision. A NaN gives the undefined ball, an infinity the
  /// undefined ball too (it is no real number).
  explicit ball(mpfr_srcptr x);
  template <mpfr_like N>
  explicit ball(const N& x) : ball(static_cast<mpfr_srcptr>(x.backend().data())) {}

  /// A double is a decimal only by accident: "0.1" is a text to be parsed (exact.hpp).
  template <std::floating_point N>
  ball(N, precision) = delete;
  /// A number needs a precision, ball(0, 64): 0 alone would be a null pointer to an mpfr_t.
  template <std::integral N>
  explicit ball(N) = delete;

  /// The exact value of a double, as a number of 53 bits or more.
  static ball exactly(double x, precision p = 53);

  /// The set of x with |x - midpoint| <= radius, with the midpoint's precision.
  static ball from_midpoint_radius(mpfr_srcptr midpoint, const magnitude& radius);
  /// The set [lower, upper] (IEEE 1788: numsToInterval), ends rounded outward to p bits.
  /// Infinite ends are allowed on their own sides. Throws std::invalid_argument where
  /// lower > upper, where an end is a NaN, or where an end is infinite on the wrong side.
  static ball from_end_points(mpfr_srcptr lower, mpfr_srcptr upper, precision p);
  static ball undefined(precision p);
  /// All reals.
  static ball entire(precision p);

  [[nodiscard]] polhode::precision precision() const { return mpfr_get_prec(first_.get()); }
  [[nodiscard]] bool is_undefined() const { return form_ == form::undefined; }
  /// Defined, and both ends finite.
  [[nodiscard]] bool is_bounded() const;
  /// A single real number.
  [[nodiscard]] bool is_exact() const;

  /// Sets r, which keeps its own precision, to a lower bound of the set, as close as r's precision
  /// allows (or an upper one). The infimum of an undefined ball is a NaN.
  void lower(mpfr_ptr r) const;
  void upper(mpfr_ptr r) const;
  /// Sets r to a number near the middle of the set. It carries no guarantee but this:
  /// it is a member of a bounded set when r has at least precision() bits.
  void midpoint(mpfr_ptr r) const;

  /// An upper bound of |x - midpoint|; infinite where the ball is unbounded or undefined.
  [[nodiscard]] magnitude radius() const;
  /// Bounds of |x| over the set: magnitude_upper >= max |x|, magnitude_lower <= min |x|.
  /// (IEEE 1788: mag, mig.) Infinite and 0 where undefined.
  [[nodiscard]] magnitude magnitude_upper() const;
  [[nodiscard]] magnitude magnitude_lower() const;

  /// An enclosure of the same set with p bits: wider where p is less than precision().
  [[nodiscard]] ball with_precision(polhode::precision p) const;
  /// The middle of the set as an exact ball of the same precision; undefined if not bounded.
  [[nodiscard]] ball middle() const;
  /// The set, grown by error on both sides.
  [[nodiscard]] ball enlarged(const magnitude& error) const;

  ball& operator+=(const ball& y);
  ball& operator-=(const ball& y);
  ball& operator*=(const ball& y);
  ball& operator/=(const ball& y);

  // The operations, in three-address form: the result may be one of the operands, and its storage
  // is used again. The operators below are made of these.
  friend void add(ball& result, const ball& x, const ball& y);
  friend void subtract(ball& result, const ball& x, const ball& y);
  friend void multiply(ball& result, const ball& x, const ball& y);
  /// Undefined where y holds 0.
  friend void divide(ball& result, const ball& x, const ball& y);
  /// x * y + z, rounded once.
  friend void fma(ball& result, const ball& x, const ball& y, const ball& z);
  friend void add(ball& result, const ball& x, long y);
  friend void subtract(ball& result, long x, const ball& y);
  friend void multiply(ball& result, const ball& x, long y);
  friend void divide(ball& result, const ball& x, long y);
  friend void square(ball& result, const ball& x);
  /// Undefined where x holds a negative number.
  friend void sqrt(ball& result, const ball& x);
  /// x * 2^n, exactly.
  friend void scale(ball& result, const ball& x, long n);
  friend void negate(ball& result, const ball& x);

 private:
  friend struct ball_access;  // src/arithmetic: the same principle, in other files

  enum class form : std::uint8_t { midpoint_radius, end_points, undefined };

  void set_integer(long n, polhode::precision p);
  void set_integer(unsigned long n, polhode::precision p);
  /// What is left of a ball whose cells were taken.
  void empty() noexcept {
    first_.reset(64);
    form_ = form::undefined;
  }

  detail::mpfr_cell first_;   // the midpoint, or the lower end
  detail::mpfr_cell second_;  // the upper end; meaningful only in the form of end points
  magnitude radius_;
  form form_ = form::midpoint_radius;
};

[[nodiscard]] inline detail::room detail::room_for(const ball& x, const ball& y) {
  return {x.precision() < y.precision() ? y.precision() : x.precision()};
}

// ---------------------------------------------------------------------------------------------
// Operators. Mixed with machine integers, and with Boost's integers and rationals, all exact.

namespace detail {
template <class X>
concept ball_operand = std::same_as<std::remove_cvref_t<X>, ball>;

/// op(r, x, y) in the storage of an operand that is about to end, or else in a new ball.
template <auto op, ball_operand X, ball_operand Y>
[[nodiscard]] ball combined(X&& x, Y&& y) {
  if constexpr (!std::is_lvalue_reference_v<X> && !std::is_const_v<X>) {
    op(x, x, y);
    return std::forward<X>(x);
  } else if constexpr (!std::is_lvalue_reference_v<Y> && !std::is_const_v<Y>) {
    op(y, x, y);
    return std::forward<Y>(y);
  } else {
    ball r(room_for(x, y));
    op(r, x, y);
    return r;
  }
}
inline constexpr auto add_balls = [](ball& r, const ball& x, const ball& y) { add(r, x, y); };
inline constexpr auto subtract_balls = [](ball& r, const ball& x, const ball& y) {
  subtract(r, x, y);
};
inline constexpr auto multiply_balls = [](ball& r, const ball& x, const ball& y) {
  multiply(r, x, y);
};
inline constexpr auto divide_balls = [](ball& r, const ball& x, const ball& y) { divide(r, x, y); };
}  // namespace detail

template <detail::ball_operand X, detail::ball_operand Y>
[[nodiscard]] ball operator+(X&& x, Y&& y) {
  return detail::combined<detail::add_balls>(std::forward<X>(x), std::forward<Y>(y));
}
template <detail::ball_operand X, detail::ball_operand Y>
[[nodiscard]] ball operator-(X&& x, Y&& y) {
  return detail::combined<detail::subtract_balls>(std::forward<X>(x), std::forward<Y>(y));
}
template <detail::ball_operand X, detail::ball_operand Y>
[[nodiscard]] ball operator*(X&& x, Y&& y) {
  return detail::combined<detail::multiply_balls>(std::forward<X>(x), std::forward<Y>(y));
}
template <detail::ball_operand X, detail::ball_operand Y>
[[nodiscard]] ball operator/(X&& x, Y&& y) {
  return detail::combined<detail::divide_balls>(std::forward<X>(x), std::forward<Y>(y));
}
[[nodiscard]] inline ball operator-(const ball& x) {
  ball r;
  negate(r, x);
  return r;
}
[[nodiscard]] inline ball operator+(const ball& x) { return x; }

template <class N>
concept exact_number = machine_integer<N> || integer_like<N> || rational_like<N>;

namespace detail {
template <class N>
concept fits_long = machine_integer<N> &&(std::is_signed_v<N> || sizeof(N) < sizeof(long));
}  // namespace detail

template <exact_number N>
[[nodiscard]] ball operator+(const ball& x, const N& y) {
  ball r(detail::room{x.precision()});
  if constexpr (detail::fits_long<N>) {
    add(r, x, static_cast<long>(y));
  } else {
    add(r, x, ball(y, x.precision()));
  }
  return r;
}
template <exact_number N>
[[nodiscard]] ball operator+(const N& x, const ball& y) {
  return y + x;
}
template <exact_number N>
[[nodiscard]] ball operator-(const N& x, const ball& y) {
  ball r(detail::room{y.precision()});
  if constexpr (detail::fits_long<N>) {
    subtract(r, static_cast<long>(x), y);
  } else {
    subtract(r, ball(x, y.precision()), y);
  }
  return r;
}
template <exact_number N>
[[nodiscard]] ball operator-(const ball& x, const N& y) {
  ball r = y - x;
  negate(r, r);
  return r;
}
template <exact_number N>
[[nodiscard]] ball operator*(const ball& x, const N& y) {
  ball r(detail::room{x.precision()});
  if constexpr (detail::fits_long<N>) {
    multiply(r, x, static_cast<long>(y));
  } else {
    multiply(r, x, ball(y, x.precision()));
  }
  return r;
}
template <exact_number N>
[[nodiscard]] ball operator*(const N& x, const ball& y) {
  return y * x;
}
template <exact_number N>
[[nodiscard]] ball operator/(const ball& x, const N& y) {
  ball r(detail::room{x.precision()});
  if constexpr (detail::fits_long<N>) {
    divide(r, x, static_cast<long>(y));
  } else {
    divide(r, x, ball(y, x.precision()));
  }
  return r;
}
template <exact_number N>
[[nodiscard]] ball operator/(const N& x, const ball& y) {
  ball r(detail::room{y.precision()});
  divide(r, ball(x, y.precision()), y);
  return r;
}

inline ball& ball::operator+=(const ball& y) {
  add(*this, *this, y);
  return *this;
}
inline ball& ball::operator-=(const ball& y) {
  subtract(*this, *this, y);
  return *this;
}
inline ball& ball::operator*=(const ball& y) {
  multiply(*this, *this, y);
  return *this;
}
inline ball& ball::operator/=(const ball& y) {
  divide(*this, *this, y);
  return *this;
}
template <exact_number N>
ball& operator+=(ball& x, const N& y) {
  return x = x + y;
}
template <exact_number N>
ball& operator-=(ball& x, const N& y) {
  return x = x - y;
}
template <exact_number N>
ball& operator*=(ball& x, const N& y) {
  return x = x * y;
}
template <exact_number N>
ball& operator/=(ball& x, const N& y) {
  return x = x / y;
}

// ---------------------------------------------------------------------------------------------
// Comparisons. "certainly" holds for every choice of members, "possibly" for at least one.
// An undefined operand makes every "certainly" false and every "possibly" true.

[[nodiscard]] bool certainly_less(const ball& x, const ball& y);
[[nodiscard]] bool certainly_less_equal(const ball& x, const ball& y);
[[nodiscard]] bool possibly_less(const ball& x, const ball& y);
[[nodiscard]] bool certainly_less(const ball& x, long y);
[[nodiscard]] bool certainly_greater(const ball& x, long y);
[[nodiscard]] bool overlaps(const ball& x, const ball& y);
/// x's set holds the whole of y's set, or the number y. A yes is exact, and so is a no except at
/// the ends of a ball kept by midpoint and radius, where they are not representable.
[[nodiscard]] bool contains(const ball& x, const ball& y);
[[nodiscard]] bool contains(const ball& x, mpq_srcptr y);
[[nodiscard]] bool contains(const ball& x, long y);
template <machine_integer N>
[[nodiscard]] bool contains(const ball& x, N y) {
  if constexpr (detail::fits_long<N>) {
    return contains(x, static_cast<long>(y));
  } else {
    return contains(x, ball(y, 64));
  }
}
template <rational_like N>
[[nodiscard]] bool contains(const ball& x, const N& y) {
  return contains(x, static_cast<mpq_srcptr>(y.backend().data()));
}
[[nodiscard]] bool contains_zero(const ball& x);

/// The sign of every member, where they have the same.
enum class certain_sign : std::int8_t { negative = -1, zero = 0, positive = 1, unknown = 2 };
[[nodiscard]] certain_sign sign_of(const ball& x);
[[nodiscard]] inline bool certainly_positive(const ball& x) {
  return sign_of(x) == certain_sign::positive;
}
[[nodiscard]] inline bool certainly_negative(const ball& x) {
  return sign_of(x) == certain_sign::negative;
}

// ---------------------------------------------------------------------------------------------
// Sets. Precision as for every operation.

/// The least ball that holds both sets (IEEE 1788: convexHull).
[[nodiscard]] ball hull(const ball& x, const ball& y);
/// The common part of the two sets; undefined where there is none (IEEE 1788: intersection, empty).
[[nodiscard]] ball intersection(const ball& x, const ball& y);

/// Prints a true enclosure: the decimals that are certain, or the two ends (see text.hpp).
std::ostream& operator<<(std::ostream& out, const ball& x);

}  // namespace polhode
