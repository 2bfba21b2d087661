#pragma once

// Random operands, the same on every machine for the same seed.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/exact_set.hpp"
#include "support/real.hpp"

namespace polhode::support {

/// The environment variable POLHODE_TEST_EFFORT: a factor on the number of random trials.
inline double effort() {
  const char* text = std::getenv("POLHODE_TEST_EFFORT");
  const double factor = text == nullptr ? 1.0 : std::strtod(text, nullptr);
  return factor > 0 ? factor : 1.0;
}

/// for (repeat trial(1000); trial.again();): so many times at effort 1, or until a check fails.
class repeat {
 public:
  explicit repeat(double at_effort_one)
      : left_(std::max(1L, static_cast<long>(at_effort_one * effort()))) {}
  bool again() { return left_-- > 0 && !::testing::Test::HasFailure(); }

 private:
  long left_;
};

enum class kind {
  exact,   // one number
  thin,    // a radius around the last place, from far below it to 2^-25 of the midpoint
  narrow,  // two ends that agree to some bits
  wide,    // two ends that have nothing in common
  across_zero,
  touching_zero,  // an end is 0
  huge,
  tiny,
  special,     // 0, +-1, +-1/2, +-2, alone or as an end or the middle of a set
  half_turns,  // around a multiple of pi/2
  half_infinite,
  entire,
};
inline constexpr std::array every_kind = {
    kind::exact,       kind::thin,          kind::narrow,        kind::wide,
    kind::across_zero, kind::touching_zero, kind::huge,          kind::tiny,
    kind::special,     kind::half_turns,    kind::half_infinite, kind::entire};

class random_source {
 public:
  explicit random_source(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  /// A number from least to most, both included. (std::uniform_int_distribution differs between
  /// standard libraries.)
  long between(long least, long most) {
    const auto count = static_cast<std::uint64_t>(most) - static_cast<std::uint64_t>(least) + 1;
    const std::uint64_t step = count == 0 ? bits() : bits() % count;
    return static_cast<long>(static_cast<std::uint64_t>(least) + step);
  }
  bool one_in(long n) { return between(1, n) == 1; }
  template <class Container>
  const auto& choose(const Container& from) {
    return from[static_cast<std::size_t>(between(0, static_cast<long>(std::size(from)) - 1))];
  }

  precision any_precision() {
    static constexpr std::array<precision, 12> usual = {2,   24,  53,  63,  64,  65,
                                                        113, 128, 255, 256, 257, 333};
    return one_in(2) ? choose(usual) : between(2, one_in(8) ? 1000 : 300);
  }

  /// An integer of at most that many bits; few of them are set in one case of four.
  integer any_integer(long most_bits) {
    const long length = between(1, most_bits);
    integer n = 0;
    if (one_in(4)) {
      for (int i = 0; i < 3; ++i) n |= integer(1) << static_cast<unsigned>(between(0, length - 1));
    } else {
      for (long have = 0; have < length; have += 64) n = (n << 64) | integer(bits());
      n >>= static_cast<unsigned>(bit_length(n) > length ? bit_length(n) - length : 0);
    }
    return one_in(2) ? n : integer(-n);
  }
  /// Not dyadic as a rule.
  rational any_rational(long most_bits) {
    integer denominator = any_integer(most_bits);
    if (denominator == 0) denominator = 1;
    return rational(any_integer(most_bits)) / rational(denominator);
  }

  /// A number of p bits, not 0, with its binary exponent in [least, most].
  real any_real(precision p, long least, long most) {
    integer n = any_integer(one_in(3) ? std::min<long>(p, 20) : p);
    if (n == 0) n = 1;
    real r(p);
    mpfr_set_z_2exp(r, n.backend().data(), -bit_length(n), MPFR_RNDN);
    mpfr_set_exp(r, between(least, most));
    return r;
  }

  magnitude any_magnitude(long least_exponent, long most_exponent) {
    if (one_in(20)) return {};
    const std::uint64_t fraction = one_in(4) ? std::uint64_t{1} << 30 : (bits() >> 33) | (1U << 30);
    return magnitude::from_bits_up(fraction, between(least_exponent, most_exponent));
  }

  /// A radius for a number of that exponent: below 2^-10 of it, and mostly below the 2^-24 from
  /// which on a ball is kept by its end points.
  magnitude thin_radius(mpfr_exp_t exponent, precision p) {
    long below = one_in(2) ? p + between(-8, 8) : between(25, std::max<long>(p + 30, 60));
    if (one_in(6)) below = between(10, 26);
    const long e = exponent - std::max(below, 10L) - 31;
    return any_magnitude(e, e);
  }

  ball between_ends(const real& a, const real& b, precision p) {
    return mpfr_lessequal_p(a, b) != 0 ? ball::from_end_points(a, b, p)
                                       : ball::from_end_points(b, a, p);
  }

  ball any_ball(precision p, kind k) {
    switch (k) {
      case kind::exact:
        return one_in(20) ? ball(0, p) : ball(any_real(p, -30, 30).get());
      case kind::thin: {
        const real m = any_real(p, -30, 30);
        return ball::from_midpoint_radius(m, thin_radius(mpfr_get_exp(m), p));
      }
      case kind::narrow: {
        const real a = any_real(p, -8, 8);
        real b(p);
        const real step = any_real(p, -70, -1);
        mpfr_mul(b, a, step, MPFR_RNDN);
        mpfr_add(b, a, b, MPFR_RNDN);
        return between_ends(a, b, p);
      }
      case kind::wide: {
        real a = any_real(p, -6, 6);
        real b = any_real(p, -6, 6);
        const int sign = one_in(2) ? 1 : -1;
        mpfr_setsign(a, a, sign < 0 ? 1 : 0, MPFR_RNDN);
        mpfr_setsign(b, b, sign < 0 ? 1 : 0, MPFR_RNDN);
        return between_ends(a, b, p);
      }
      case kind::across_zero: {
        real a = any_real(p, -20, 6);
        real b = any_real(p, -20, 6);
        mpfr_setsign(a, a, 1, MPFR_RNDN);
        mpfr_setsign(b, b, 0, MPFR_RNDN);
        return ball::from_end_points(a, b, p);
      }
      case kind::touching_zero:
        return between_ends(real(p, 0), any_real(p, -20, 6), p);
      case kind::huge:
      case kind::tiny: {
        const long least = k == kind::huge ? 100 : -1200;
        const long most = k == kind::huge ? 1200 : -100;
        const real m = any_real(p, least, most);
        if (one_in(3)) return ball(m.get());
        if (one_in(2)) return between_ends(m, any_real(p, least, most), p);
        return ball::from_midpoint_radius(m, thin_radius(mpfr_get_exp(m), p));
      }
      case kind::special: {
        const long twice = choose(std::array{0L, 1L, -1L, 2L, -2L, 4L, -4L});
        real m(p, twice);
        mpfr_div_2ui(m, m, 1, MPFR_RNDN);
        switch (between(0, 3)) {
          case 0:
            return ball(m.get());
          case 1:
            return between_ends(m, real(p, between(-2, 2)), p);
          case 2:
            return between_ends(m, any_real(p, -p - 4, 1), p);
          default:
            return ball::from_midpoint_radius(m, thin_radius(0, p));
        }
      }
      case kind::half_turns: {
        real m(p);
        mpfr_const_pi(m, MPFR_RNDN);
        mpfr_mul_si(m, m, between(-9, 9), MPFR_RNDN);
        mpfr_div_2ui(m, m, 1, MPFR_RNDN);
        if (one_in(2)) {  // where sin or cos is an extremum to about the last place
          const real step = any_real(p, -p / 2 - 6, -p / 2 + 6);
          mpfr_add(m, m, step, MPFR_RNDN);
        }
        switch (between(0, 2)) {
          case 0:
            return ball(m.get());
          case 1:
            return ball::from_midpoint_radius(m, thin_radius(2, p));
          default: {
            real other = any_real(p, -20, 3);
            mpfr_add(other, other, m, MPFR_RNDN);
            return between_ends(m, other, p);
          }
        }
      }
      case kind::half_infinite: {
        const int side = one_in(2) ? 1 : -1;
        return between_ends(one_in(3) ? real(p, between(-1, 1)) : any_real(p, -10, 10),
                            real::infinity(side), p);
      }
      case kind::entire:
        return ball::entire(p);
    }
    return ball::undefined(p);
  }
  ball any_ball(precision p) { return any_ball(p, any_kind()); }
  ball any_ball() { return any_ball(any_precision()); }
  /// Unbounded sets are drawn less often than the others.
  kind any_kind() {
    const kind k = choose(every_kind);
    return k == kind::entire && !one_in(3) ? kind::thin : k;
  }

  /// A dyadic number in the set: an end, one very near an end, the middle, or any other. Beyond the
  /// finite end of an unbounded set, sizes up to 2^60 are drawn.
  rational member(const exact_set& x) {
    rational low = x.lower ? *x.lower : rational(0);
    rational high = x.upper ? *x.upper : rational(0);
    if (!x.lower || !x.upper) {
      const rational span = power_of_two(between(-20, 60));
      if (!x.lower && !x.upper) {
        low = -span;
        high = span;
      } else if (!x.lower) {
        low = high - span;
      } else {
        high = low + span;
      }
    }
    const rational width = high - low;
    switch (between(0, 7)) {
      case 0:
        return low;
      case 1:
        return high;
      case 2:
        return low + width * power_of_two(-between(20, 200));
      case 3:
        return high - width * power_of_two(-between(20, 200));
      case 4:
        return low + width / 2;
      default:
        return low + width * rational(bits() >> 32) * power_of_two(-32);
    }
  }
  rational member(const ball& x) { return member(exact(x)); }

  /// A defined ball inside y, of y's precision: thin, narrow or with ends in common with y.
  ball inside(const ball& y) {
    const exact_set set = exact(y);
    rational a = member(set);
    rational b = one_in(3) ? a : member(set);
    if (b < a) std::swap(a, b);
    const precision p = y.precision();
    const real low(p, a, MPFR_RNDU);
    const real high(p, b, MPFR_RNDD);
    if (mpfr_lessequal_p(low, high) != 0) {
      ball x = ball::from_end_points(low, high, p);
      if (set.holds(exact(x))) return x;
    }
    return y;
  }

  /// A ball to be overwritten: any form, any storage, also moved from.
  ball used_ball() {
    if (one_in(6)) return ball::undefined(any_precision());
    ball x = any_ball();
    if (one_in(5)) {
      const ball taken = std::move(x);
      return x;  // NOLINT(bugprone-use-after-move): on purpose
    }
    return x;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace polhode::support
