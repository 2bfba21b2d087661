#pragma once

// The real interval in hardware doubles: what bounds are made of where a few nanoseconds count and
// 53 bits are plenty. The complex region for integrands stands on it.
//
// A double_interval is a closed set [lower, upper] of reals, whose ends are doubles and may be
// infinite; or it is *undefined*, with the meaning and the manners of an undefined ball. It obeys
// the inclusion principle of ball.hpp, and the comments below say only what they add to it.
//
// Rounding is outward and never touches the rounding mode. A sum's end is the tightest double, by
// its exact error; any other end is rounded to nearest and moved one step outward, but a 0 that is
// exact stays 0. The functions in the second half come from approximations in plain double
// arithmetic, widened by a bound that is proved in src/arithmetic/hardware/. The bounds below are
// relative to the value at an end; an end of the result is at most 2 bound + 2^-51 of its size
// away from the range's, and at 0, or where the result is subnormal, a few steps of 2^-1074.
//
//   function             domain       bound     remarks
//   + -                  R            -         the tightest ends
//   * /  square          R; divisor   2^-52     undefined where the divisor holds 0
//                        not 0
//   sqrt                 [0, inf)     2^-52     of perfect squares: exact
//   abs min max scale    R            0         scale: but for overflow and underflow
//   pow(x, n)            R; R\{0},    |n| 2^-51 x^0 = 1; the bound to first order
//                        n < 0
//   hypot                R^2          2^-51     without overflow on the way
//   exp                  R            2^-51     exp(1000) = [largest double, inf]
//   expm1                R            2^-49
//   log                  (0, inf)     2^-50
//   log1p                (-1, inf)    2^-49
//   sin, cos             R            2^-50     and for |x| > pi/4 absolutely 2^-94, or 2^-132
//                                               where one of them is below 2^-31; [-1, 1] beyond
//                                               2^20: see needs_wider_range
//   tan                  no odd pi/2  2^-48     undefined beyond 2^20
//   asin, acos           [-1, 1]      2^-49
//   atan, atan2          R; R^2 less  2^-50     atan2 is undefined where the rectangle meets its
//                        (-inf, 0]              cut y = 0, x <= 0
//   sinh, tanh, asinh    R            2^-49
//   cosh                 R            2^-50
//   acosh                [1, inf)     2^-49
//   atanh                (-1, 1)      2^-49
//
// An operand that is not wholly in the domain gives the undefined interval. Where one operand lies
// in another, the result of an arithmetic operation lies in the other's result; for the functions
// that holds with the larger result widened by the bound, unless the operands have that end in
// common, where it holds as it is.
//
// What is assumed of the machine: IEEE 754 binary64 with every operation rounded on its own, to
// nearest, subnormals kept. The lines below refuse what a compiler admits to; the rounding mode and
// "flush to zero" are states of a running thread, which a library linked with -ffast-math may have
// changed: double_interval::environment_is_sound() asks. (Clang says nothing of -fassociative-math
// alone, and no compiler of -ffp-contract; a fused step in a sum's error would be none too few, but
// CMake's target sets it off.)

#include <bit>
#include <cfloat>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <stdexcept>
#include <utility>

#include "polhode/arithmetic/ball.hpp"

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "polhode: intervals in doubles are unsound under -ffast-math and its parts"
#endif
#if !defined(FLT_EVAL_METHOD) || FLT_EVAL_METHOD != 0
#error \
    "polhode: intervals in doubles need FLT_EVAL_METHOD == 0 (on 32-bit x86: -msse2 -mfpmath=sse)"
#endif
static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "polhode: intervals in doubles need IEEE 754 binary64");

namespace polhode {
namespace detail {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double largest_double = std::numeric_limits<double>::max();
inline constexpr double least_normal_double = std::numeric_limits<double>::min();
inline constexpr double least_double = std::numeric_limits<double>::denorm_min();

/// The least double above x; inf and a NaN stay what they are. Where v is the exact result of an
/// operation and x is v rounded to nearest, v <= next_up(x), overflow and underflow included.
[[nodiscard]] constexpr double next_up(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x + 0.0);  // -0 becomes 0
  return x < infinity ? std::bit_cast<double>(bits + (1 | (bits >> 63))) : x;
}
[[nodiscard]] constexpr double next_down(double x) { return -next_up(-x); }

/// a + b - sum, for sum = RN(a + b): exactly (T. Dekker's Fast2Sum, which does not overflow on the
/// way either: S. Boldo, S. Graillat, J.-M. Muller 2017). For an infinite sum of finite numbers it
/// is an infinity of the other sign; for infinite operands a NaN.
[[nodiscard]] inline double sum_error(double a, double b, double sum) {
  const bool ordered = std::abs(a) >= std::abs(b);
  const double large = ordered ? a : b;
  const double small = ordered ? b : a;
  return small - (sum - large);
}
[[nodiscard]] inline double add_down(double a, double b) {
  const double sum = a + b;
  const double error = sum_error(a, b, sum);
  return error >= 0 ? sum : next_down(sum);
}
[[nodiscard]] inline double add_up(double a, double b) { return -add_down(-a, -b); }

/// A product of ends. An infinite end is a limit of reals: 0 times it is 0.
[[nodiscard]] inline double multiply_down(double a, double b) {
  if (a == 0 || b == 0) return 0;
  const double p = next_down(a * b);
  return (a > 0) == (b > 0) && p < 0 ? 0 : p;
}
[[nodiscard]] inline double multiply_up(double a, double b) { return -multiply_down(-a, b); }

/// Quotients of ends for b > 0, not both infinite.
[[nodiscard]] inline double divide_down(double a, double b) {
  const double q = next_down(a / b);
  return a >= 0 && q < 0 ? 0 : q;
}
[[nodiscard]] inline double divide_up(double a, double b) { return -divide_down(-a, b); }

/// Square roots of ends x >= 0. A root r of at most 26 bits has an exact square, which decides on
/// which side of the true root it lies.
[[nodiscard]] inline double sqrt_down(double x) {
  const double r = std::sqrt(x);
  const bool is_short = (std::bit_cast<std::uint64_t>(r) & 0x7ffffffU) == 0;
  return is_short && r * r <= x ? r : next_down(r);
}
[[nodiscard]] inline double sqrt_up(double x) {
  const double r = std::sqrt(x);
  const bool is_short = (std::bit_cast<std::uint64_t>(r) & 0x7ffffffU) == 0;
  return is_short && r * r >= x ? r : next_up(r);
}

/// x * 2^n for an end x.
[[nodiscard]] double scale_down(double x, long n);
[[nodiscard]] inline double scale_up(double x, long n) { return -scale_down(-x, n); }

struct unchecked {};

}  // namespace detail

class double_interval {
 public:
  /// {0}.
  constexpr double_interval() = default;

  /// The integer n; where a double does not hold it, the two doubles around it or further out.
  template <machine_integer N>
  double_interval(N n) {  // NOLINT(google-explicit-constructor): exact, as for a ball
    const auto x = static_cast<double>(n);
    const bool exact = std::abs(x) <= 0x1p53;
    lower_ = exact ? x : detail::next_down(x);
    upper_ = exact ? x : detail::next_up(x);
  }
  template <integer_like N>
  double_interval(const N& n)  // NOLINT(google-explicit-constructor)
      : double_interval(from_integer(n.backend().data())) {}
  template <rational_like N>
  double_interval(const N& q)  // NOLINT(google-explicit-constructor)
      : double_interval(from_rational(q.backend().data())) {}

  /// The double x itself, exactly. A NaN or an infinity, no real number, gives the undefined set.
  template <class N>
  requires std::same_as<N, double> || std::same_as<N, float>
  explicit double_interval(N number) {
    const auto x = static_cast<double>(number);
    lower_ = upper_ = x - x == 0 ? x : std::numeric_limits<double>::quiet_NaN();
  }

  /// The set [lower, upper] (IEEE 1788: numsToInterval). Infinite ends are allowed on their own
  /// sides. Throws std::invalid_argument where lower > upper, where an end is a NaN, or where an
  /// end is infinite on the wrong side.
  double_interval(double lower, double upper) : lower_(lower), upper_(upper) {
    if (!(lower <= upper && lower < detail::infinity && upper > -detail::infinity)) {
      throw std::invalid_argument(
          "ends of a double_interval: two numbers are needed, the lower one not above the upper "
          "one; -inf may be a lower end only and inf an upper end only");
    }
  }
  /// The set [lower, upper], for ends that the constructor above is known to accept.
  constexpr double_interval(detail::unchecked, double lower, double upper)
      : lower_(lower), upper_(upper) {}

  static constexpr double_interval undefined() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {detail::unchecked{}, nan, nan};
  }
  /// All reals.
  static constexpr double_interval entire() {
    return {detail::unchecked{}, -detail::infinity, detail::infinity};
  }
  static double_interval from_integer(mpz_srcptr n);
  static double_interval from_rational(mpq_srcptr q);
  /// The tightest ends around the ball's; those beyond the range of doubles as for an overflow.
  static double_interval from_ball(const ball& x);

  /// The calling thread rounds to nearest and keeps subnormals.
  [[nodiscard]] static bool environment_is_sound();

  [[nodiscard]] bool is_undefined() const { return !(lower_ <= upper_); }
  /// Never a NaN, and 0 is never -0; -inf and inf where undefined, so that no bound drawn from the
  /// ends is a false one.
  [[nodiscard]] double lower() const { return is_undefined() ? -detail::infinity : lower_ + 0.0; }
  [[nodiscard]] double upper() const { return is_undefined() ? detail::infinity : upper_ + 0.0; }
  /// Defined, and both ends finite.
  [[nodiscard]] bool is_bounded() const {
    return lower_ > -detail::infinity && upper_ < detail::infinity;
  }
  /// A single real number.
  [[nodiscard]] bool is_exact() const { return lower_ == upper_; }
  /// An end is infinite or subnormal: the exponents of doubles did not suffice, or may not in the
  /// next step, and a ball can do better. False where undefined. It is enough to ask after each
  /// operation that may leave the range, and to try a ball also where a result is undefined: a
  /// lower end that underflowed to 0 looks like any other 0 (as in [1e-200, 1]^2).
  [[nodiscard]] bool is_out_of_range() const {
    const auto lost = [](double end) {
      return std::abs(end) < detail::least_normal_double ? end != 0
                                                         : std::abs(end) == detail::infinity;
    };
    return lost(lower_) || lost(upper_);
  }

  friend double_interval operator+(double_interval x) { return x; }
  friend double_interval operator-(double_interval x) { return ends(-x.upper_, -x.lower_); }
  friend double_interval operator+(double_interval x, double_interval y) {
    return ends(detail::add_down(x.lower_, y.lower_), detail::add_up(x.upper_, y.upper_));
  }
  friend double_interval operator-(double_interval x, double_interval y) {
    return ends(detail::add_down(x.lower_, -y.upper_), detail::add_up(x.upper_, -y.lower_));
  }
  /// The range's ends are two of the four products of ends.
  friend double_interval operator*(double_interval x, double_interval y) {
    const double a = x.lower_ * y.lower_;
    const double b = x.lower_ * y.upper_;
    const double c = x.upper_ * y.lower_;
    const double d = x.upper_ * y.upper_;
    const double low = least(least(a, b), least(c, d));
    const double high = greatest(greatest(a, b), greatest(c, d));
    const double all = (a + b) + (c + d);  // a NaN or infinite where one of them is
    if (low != 0 && high != 0 && std::abs(all) < detail::infinity) [[likely]] {
      return ends(detail::next_down(low), detail::next_up(high));
    }
    return multiply_with_care(x, y);
  }
  /// Undefined where y holds 0.
  friend double_interval operator/(double_interval x, double_interval y) {
    if (y.upper_ < 0) {
      x = -x;
      y = -y;
    }
    if (!(y.lower_ > 0) || x.is_undefined()) return undefined();
    return ends(detail::divide_down(x.lower_, x.lower_ >= 0 ? y.upper_ : y.lower_),
                detail::divide_up(x.upper_, x.upper_ >= 0 ? y.lower_ : y.upper_));
  }
  double_interval& operator+=(double_interval y) { return *this = *this + y; }
  double_interval& operator-=(double_interval y) { return *this = *this - y; }
  double_interval& operator*=(double_interval y) { return *this = *this * y; }
  double_interval& operator/=(double_interval y) { return *this = *this / y; }

  /// max |x| and min |x| over the set (IEEE 1788: mag, mig), exactly; inf and 0 where undefined.
  [[nodiscard]] double magnitude() const { return greatest(std::abs(lower()), std::abs(upper())); }
  [[nodiscard]] double mignitude() const {
    if (lower_ > 0) return lower_;
    return upper_ < 0 ? -upper_ : 0;
  }
  /// upper - lower, rounded up; inf where undefined.
  [[nodiscard]] double width() const { return detail::add_up(upper(), -lower()); }
  /// A member near the middle; the largest double of its sign for a half-infinite set, 0 for all
  /// reals and where undefined.
  [[nodiscard]] double midpoint() const {
    if (!is_bounded()) {
      if (lower_ > -detail::infinity) return detail::largest_double;
      return upper_ < detail::infinity ? -detail::largest_double : 0;
    }
    // RN(lower + upper) is in [2 lower, 2 upper], and its half, rounded, in [lower, upper].
    const double sum = lower_ + upper_;
    return (std::abs(sum) < detail::infinity ? 0.5 * sum : 0.5 * lower_ + 0.5 * upper_) + 0.0;
  }
  /// [lower, midpoint] and [midpoint, upper].
  [[nodiscard]] std::pair<double_interval, double_interval> split() const {
    if (is_undefined()) return {*this, *this};
    return {ends(lower_, midpoint()), ends(midpoint(), upper_)};
  }

  friend double_interval abs(double_interval x) {
    return x.is_undefined() ? undefined() : ends(x.mignitude(), x.magnitude());
  }
  /// x^2, never below 0 (IEEE 1788: sqr; where x * x would not know that both are the same number).
  friend double_interval square(double_interval x) {
    if (x.is_undefined()) return undefined();
    const double low = x.mignitude();
    const double high = x.magnitude();
    return ends(detail::multiply_down(low, low), detail::multiply_up(high, high));
  }
  friend double_interval sqrt(double_interval x) {
    if (!(x.lower_ >= 0)) return undefined();
    return ends(detail::sqrt_down(x.lower_), detail::sqrt_up(x.upper_));
  }
  /// {min(s, t): s in x, t in y}, exactly; and max.
  friend double_interval min(double_interval x, double_interval y) {
    if (x.is_undefined() || y.is_undefined()) return undefined();
    return ends(least(x.lower_, y.lower_), least(x.upper_, y.upper_));
  }
  friend double_interval max(double_interval x, double_interval y) {
    if (x.is_undefined() || y.is_undefined()) return undefined();
    return ends(greatest(x.lower_, y.lower_), greatest(x.upper_, y.upper_));
  }
  /// The least interval that holds both sets (IEEE 1788: convexHull).
  friend double_interval hull(double_interval x, double_interval y) {
    if (x.is_undefined() || y.is_undefined()) return undefined();
    return ends(least(x.lower_, y.lower_), greatest(x.upper_, y.upper_));
  }
  /// The common part; undefined where there is none.
  friend double_interval intersection(double_interval x, double_interval y) {
    if (x.is_undefined() || y.is_undefined()) return undefined();
    const double low = greatest(x.lower_, y.lower_);
    const double high = least(x.upper_, y.upper_);
    return low <= high ? ends(low, high) : undefined();
  }
  /// x * 2^n, exactly but for overflow and underflow.
  friend double_interval scale(double_interval x, long n) {
    if (x.is_undefined()) return undefined();
    return ends(detail::scale_down(x.lower_, n), detail::scale_up(x.upper_, n));
  }

  // "certainly" holds for every choice of members, "possibly" for at least one. An undefined
  // operand makes every "certainly" false and every "possibly" true. Integers mix in; a double y is
  // double_interval(y).
  [[nodiscard]] friend bool certainly_less(double_interval x, double_interval y) {
    return x.upper_ < y.lower_;
  }
  [[nodiscard]] friend bool certainly_less_equal(double_interval x, double_interval y) {
    return x.upper_ <= y.lower_;
  }
  [[nodiscard]] friend bool certainly_greater(double_interval x, double_interval y) {
    return certainly_less(y, x);
  }
  [[nodiscard]] friend bool possibly_less(double_interval x, double_interval y) {
    return !(x.lower_ >= y.upper_);
  }
  [[nodiscard]] friend bool overlaps(double_interval x, double_interval y) {
    return !(x.upper_ < y.lower_ || y.upper_ < x.lower_);
  }
  /// x's set holds the whole of y's. As for balls: false where one is undefined.
  [[nodiscard]] friend bool contains(double_interval x, double_interval y) {
    return x.lower_ <= y.lower_ && y.upper_ <= x.upper_;
  }
  [[nodiscard]] friend bool contains(double_interval x, double y) {
    return x.lower_ <= y && y <= x.upper_ && std::abs(y) < detail::infinity;
  }
  /// True also where undefined.
  [[nodiscard]] friend bool contains_zero(double_interval x) {
    return !(x.lower_ > 0 || x.upper_ < 0);
  }
  [[nodiscard]] friend bool certainly_positive(double_interval x) { return x.lower_ > 0; }
  [[nodiscard]] friend bool certainly_negative(double_interval x) { return x.upper_ < 0; }

 private:
  static constexpr double_interval ends(double lower, double upper) {
    return {detail::unchecked{}, lower, upper};
  }
  static constexpr double least(double a, double b) { return b < a ? b : a; }
  static constexpr double greatest(double a, double b) { return a < b ? b : a; }
  static double_interval multiply_with_care(double_interval x, double_interval y);

  // Both are NaNs in the undefined interval, which arithmetic carries on by itself.
  double lower_ = 0;
  double upper_ = 0;
};

/// With a 0 among the four products, an infinity, or an undefined operand.
inline double_interval double_interval::multiply_with_care(double_interval x, double_interval y) {
  if (x.is_undefined() || y.is_undefined()) return undefined();
  using detail::multiply_down;
  using detail::multiply_up;
  return ends(least(least(multiply_down(x.lower_, y.lower_), multiply_down(x.lower_, y.upper_)),
                    least(multiply_down(x.upper_, y.lower_), multiply_down(x.upper_, y.upper_))),
              greatest(greatest(multiply_up(x.lower_, y.lower_), multiply_up(x.lower_, y.upper_)),
                       greatest(multiply_up(x.upper_, y.lower_), multiply_up(x.upper_, y.upper_))));
}

/// An enclosure of x with p bits: the set itself for p >= 53, but for the rounding of a radius to
/// 31 bits in a ball that keeps a midpoint.
[[nodiscard]] ball to_ball(const double_interval& x, precision p);

/// Prints two ends that are rounded outward to 17 digits, or "undefined".
std::ostream& operator<<(std::ostream& out, const double_interval& x);

// ---------------------------------------------------------------------------------------------
// Functions; the table is at the top.

/// x^n; x^0 = 1 everywhere.
[[nodiscard]] double_interval pow(double_interval x, long n);
[[nodiscard]] double_interval hypot(double_interval x, double_interval y);
/// Its upper end.
[[nodiscard]] double hypot_up(double_interval x, double_interval y);

[[nodiscard]] double_interval exp(double_interval x);
[[nodiscard]] double_interval expm1(double_interval x);
[[nodiscard]] double_interval log(double_interval x);
[[nodiscard]] double_interval log1p(double_interval x);

/// Whether sin, cos and tan of x are worth asking a ball: x is bounded and narrower than a circle,
/// but reaches beyond 2^20, and the functions below do not reduce it modulo pi.
[[nodiscard]] bool needs_wider_range(double_interval x);
[[nodiscard]] double_interval sin(double_interval x);
[[nodiscard]] double_interval cos(double_interval x);
/// {sin x, cos x}, for little more than the price of one.
[[nodiscard]] std::pair<double_interval, double_interval> sin_cos(double_interval x);
[[nodiscard]] double_interval tan(double_interval x);

[[nodiscard]] double_interval asin(double_interval x);
[[nodiscard]] double_interval acos(double_interval x);
[[nodiscard]] double_interval atan(double_interval x);
/// The range of arg(s + i t), in (-pi, pi), for s in x and t in y. Undefined where the rectangle
/// meets (-inf, 0], the cut with its branch point.
[[nodiscard]] double_interval atan2(double_interval y, double_interval x);

[[nodiscard]] double_interval sinh(double_interval x);
[[nodiscard]] double_interval cosh(double_interval x);
[[nodiscard]] double_interval tanh(double_interval x);
[[nodiscard]] double_interval asinh(double_interval x);
[[nodiscard]] double_interval acosh(double_interval x);
[[nodiscard]] double_interval atanh(double_interval x);

// ---------------------------------------------------------------------------------------------
// What the functions rest on. It is here only so that the tests can measure it.

namespace detail::approximation {

// Constants. pi is not a double: half_pi and pi_ lie below pi/2 and pi, by less than a step.
inline constexpr double half_pi = 0x1.921fb54442d18p+0;
inline constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
// pi/2 = half_pi_1 + half_pi_2 + half_pi_3 + less than 2^-118; multiples of 2^-31 and 2^-63.
inline constexpr double half_pi_1 = 0x1.921fb544p+0;
inline constexpr double half_pi_2 = 0x1.0b4611a8p-34;
inline constexpr double half_pi_3 = -0x1.d9cceba3f91f2p-66;
// pi/2 = half_pi_1 + half_pi_2 + half_pi_4 + half_pi_5 + half_pi_6 + less than 2^-184; multiples of
// 2^-96 and 2^-128.
inline constexpr double half_pi_4 = -0x1.d9cceba4p-66;
inline constexpr double half_pi_5 = 0x1.b839a2p-104;
inline constexpr double half_pi_6 = 0x1.48127044533e6p-130;
inline constexpr double log2_e = 0x1.71547652b82fep+0;
// log 2 = log_2_high + log_2_low + less than 2^-96; log_2_high is a multiple of 2^-42.
inline constexpr double log_2_high = 0x1.62e42fefa38p-1;
inline constexpr double log_2_low = 0x1.ef35793c7673p-45;
// atan(j/8), to nearest.
inline constexpr double atan_of_eighths[9] = {
    0x0p+0,
    0x1.fd5ba9aac2f6ep-4,
    0x1.f5b75f92c80ddp-3,
    0x1.6f61941e4def1p-2,
    0x1.dac670561bb4fp-2,
    0x1.1e00babdefeb4p-1,
    0x1.4978fa3269ee1p-1,
    0x1.700a7c5784634p-1,
    0x1.921fb54442d18p-1,
};

// The proved bounds: |value - f(x)| <= bound |value|.
inline constexpr double exp_bound = 0x1p-51;
inline constexpr double expm1_bound = 0x1p-49;
inline constexpr double log_bound = 0x1p-50;
inline constexpr double log1p_bound = 0x1p-49;
inline constexpr double circular_bound = 0x1p-50;     // and, where turns != 0,
inline constexpr double circular_absolute = 0x1p-94;  // this beside it, or
inline constexpr double circular_absolute_at_multiples =
    0x1p-132;  // this: circular::absolute says which
inline constexpr double angle_bound = 0x1p-50;
inline constexpr double asin_bound = 0x1p-49;
inline constexpr double sinh_bound = 0x1p-49;  // tanh, asinh, acosh, atanh too
inline constexpr double cosh_bound = 0x1p-50;

/// e^x = fraction * 2^exponent. Hypothesis: |x| <= 746.
struct scaled {
  double fraction;
  long exponent;
};
[[nodiscard]] scaled exp(double x);
/// |x| <= 50.
[[nodiscard]] double expm1(double x);
/// log(2^n x), for 0 < x < inf and |n| <= 1.
[[nodiscard]] double log(double x, int n = 0);
/// -1 < x < inf.
[[nodiscard]] double log1p(double x);
/// |x| <= 2^20.
struct circular {
  double sine;
  double cosine;
  long turns;  // the multiple of pi/2 nearest to x
  double absolute;
};
[[nodiscard]] circular sin_cos(double x);
/// arg(x + i y) for y >= 0, not both 0 and not both infinite.
[[nodiscard]] double angle(double y, double x);
/// |x| <= 1.
[[nodiscard]] double asin(double x);
[[nodiscard]] double acos(double x);
/// 0 <= x <= 40; asinh for 0 <= x < inf, acosh for 1 <= x < inf, atanh for 0 <= x < 1.
[[nodiscard]] double sinh(double x);
[[nodiscard]] double cosh(double x);
[[nodiscard]] double tanh(double x);
[[nodiscard]] double asinh(double x);
[[nodiscard]] double acosh(double x);
[[nodiscard]] double atanh(double x);

}  // namespace detail::approximation
}  // namespace polhode
