#include "root_bracket.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {
namespace {

constexpr precision least_bits = 64;

mpz_ptr data(integer& n) { return n.backend().data(); }
mpz_srcptr data(const integer& n) { return n.backend().data(); }

/// About log2 |x|; of 0, that of the least number that counts.
long log2_of(const rational& x) {
  if (x == 0) return std::numeric_limits<long>::min() / 4;
  const mpq_srcptr q = x.backend().data();
  return static_cast<long>(mpz_sizeinbase(mpq_numref(q), 2)) -
         static_cast<long>(mpz_sizeinbase(mpq_denref(q), 2));
}

rational power_of_two(long n) {
  const integer power = integer(1) << static_cast<unsigned long>(std::abs(n));
  return n >= 0 ? rational(power) : rational(1, power);
}

/// A dyadic number at a distance of at most an eighth of the width from x.
rational near(const rational& x, const rational& width) {
  const rational step = power_of_two(log2_of(width) - 4);
  return rational(floor_of(rational(x / step))) * step;
}

/// The bracket with the values at its ends.
class refinement {
 public:
  refinement(polynomial_values& p, exact_interval bracket)
      : p_(p),
        bracket_(std::move(bracket)),
        at_lower_(p.at(*bracket_.lower, 1)),
        at_upper_(p.at(*bracket_.upper, 1)) {}

  exact_interval to(long bits) && {
    if (polynomial_values::signum(at_lower_) == 0) return point(*bracket_.lower);
    if (polynomial_values::signum(at_upper_) == 0) return point(*bracket_.upper);
    if (polynomial_values::signum(at_lower_) == polynomial_values::signum(at_upper_)) {
      throw std::logic_error("internal error: a polynomial has one sign at both ends of a bracket");
    }
    // A narrow bracket is one in which p is almost straight.
    long log_parts = std::max((bits - missing_bits(bits)) / 2, 2L);
    while (!is_narrow(bits) && !bracket_.is_point()) {
      if (step(std::min(log_parts, missing_bits(bits)))) {
        log_parts *= 2;
      } else {
        log_parts = std::max(log_parts / 2, 2L);
        (void)root_is_below(inner_point(bracket_), 1);
      }
    }
    return bracket_;
  }

 private:
  static exact_interval point(const rational& x) { return {x, x}; }

  [[nodiscard]] bool is_narrow(long bits) const {
    return bracket_.width() <=
           power_of_two(-bits) * std::max(abs(*bracket_.lower), abs(*bracket_.upper));
  }

  /// About as many as the width lacks, and at least 2.
  [[nodiscard]] long missing_bits(long bits) const {
    const long size = std::max(log2_of(*bracket_.lower), log2_of(*bracket_.upper));
    return std::max(bits - size + log2_of(bracket_.width()) + 2, 2L);
  }

  /// Keeps the side of x with the root. A point outside of the bracket is left alone.
  bool root_is_below(const rational& x, precision accuracy) {
    if (x <= *bracket_.lower) return false;
    if (x >= *bracket_.upper) return true;
    ball value = p_.at(x, accuracy);
    const int s = polynomial_values::signum(value);
    if (s == 0) {
      bracket_ = point(x);
      return true;
    }
    const bool below = s == polynomial_values::signum(at_upper_);
    (below ? bracket_.upper : bracket_.lower) = x;
    (below ? at_upper_ : at_lower_) = std::move(value);
    return below;
  }

  void sharpen(ball& value, const rational& at, precision accuracy) {
    if (value.radius() > scale(value.magnitude_lower(), -accuracy)) value = p_.at(at, accuracy);
  }

  /// Whether the root is in the part at which the secant points.
  bool step(long log_parts) {
    sharpen(at_lower_, *bracket_.lower, log_parts + 8);
    sharpen(at_upper_, *bracket_.upper, log_parts + 8);
    const ball share = (at_lower_ / (at_lower_ - at_upper_)).middle();
    if (!share.is_bounded()) return false;
    const rational width = bracket_.width() * power_of_two(-log_parts);
    const rational aim = *bracket_.lower + bracket_.width() * lower_rational(share);
    const precision accuracy = 2 * log_parts + 8;  // what the next step asks for
    if (root_is_below(near(aim - width / 2, width), accuracy)) return bracket_.is_point();
    return root_is_below(near(aim + width / 2, width), accuracy);
  }

  polynomial_values& p_;
  exact_interval bracket_;
  ball at_lower_;
  ball at_upper_;
};

}  // namespace

long common_exponent(const std::vector<integer>& p) {
  long k = 0;
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (p[i] != 0) k = std::gcd(k, static_cast<long>(i));
  }
  return std::max(k, 1L);
}

polynomial_values::polynomial_values(const std::vector<integer>& p, precision bits)
    : exponent_(common_exponent(p)) {
  for (std::size_t k = 0; k < p.size(); k += static_cast<std::size_t>(exponent_)) {
    p_.push_back(p[k]);
  }
  for (const integer& c : p_) {
    longest_ = std::max(longest_, mpz_sizeinbase(data(c), 2));
  }
  set_precision(std::max(bits, least_bits));
}

int polynomial_values::signum(const ball& value) {
  const certain_sign s = sign_of(value);
  if (s == certain_sign::unknown) throw std::logic_error("the value of a polynomial has no sign");
  return s == certain_sign::positive ? 1 : (s == certain_sign::negative ? -1 : 0);
}

void polynomial_values::set_precision(precision bits) {
  bits_ = bits;
  shifted_.resize(p_.size());
  for (std::size_t k = 0; k < p_.size(); ++k) {
    mpz_mul_2exp(data(shifted_[k]), data(p_[k]), static_cast<mp_bitcnt_t>(bits));
  }
}

// Fixed-point arithmetic in units of 2^-w, w = bits_. Let y be the argument, n r's degree, Y the
// integer below y 2^w with y 2^w = Y + d, 0 <= d < 1, |y| <= 1. Horner's scheme gives integers V_n
// = c_n 2^w, V_k = floor(V_(k+1) Y / 2^w) + c_k 2^w, and with v_k for the exact values in the same
// units, e_k = |V_k - v_k|: v_k = v_(k+1) y + c_k 2^w, so that
//   e_k <= e_(k+1) |y| + |V_(k+1)| d / 2^w + 1 <= e_(k+1) + 1 + |V_(k+1)| / 2^w.
// The last term is left out where d = 0. So e_0 <= n (1 + m), m - 1 the whole part of max |V_k| /
// 2^w. For |y| > 1, r(y) = y^n s(1/y) with the coefficients of s in the reverse order.
ball polynomial_values::fixed_point_value(const rational& y) {
  const bool reversed = abs(y) > 1;
  const mpq_srcptr q = y.backend().data();
  const mpz_srcptr above = reversed ? mpq_denref(q) : mpq_numref(q);
  const mpz_srcptr below = reversed ? mpq_numref(q) : mpq_denref(q);
  const auto w = static_cast<mp_bitcnt_t>(bits_);
  integer argument;
  integer rest;
  mpz_mul_2exp(data(argument), above, w);
  mpz_fdiv_qr(data(argument), data(rest), data(argument), below);
  const std::size_t n = p_.size() - 1;
  const auto coefficient = [&](std::size_t k) -> const integer& {
    return shifted_[reversed ? n - k : k];
  };
  integer value = coefficient(n);
  std::size_t longest = mpz_sizeinbase(data(value), 2);
  for (std::size_t k = n; k-- > 0;) {
    mpz_mul(data(value), data(value), data(argument));
    mpz_fdiv_q_2exp(data(value), data(value), w);
    mpz_add(data(value), data(value), data(coefficient(k)));
    longest = std::max(longest, mpz_sizeinbase(data(value), 2));
  }
  const auto count = magnitude::from_integer_up(n);
  magnitude error = count;
  if (rest != 0) {
    // |V_k| / 2^w < 2^(longest - w).
    error = add_up(error,
                   scale(count, static_cast<std::int64_t>(longest) - static_cast<std::int64_t>(w)));
  }
  const precision p = std::max<precision>(static_cast<precision>(longest), 2);
  const ball result = scale(ball(value, p).enlarged(error), -bits_);
  return reversed ? result * pow(ball(y, bits_), static_cast<long>(n)) : result;
}

ball polynomial_values::at(const rational& x, precision relative_bits) {
  if (bits_ < relative_bits + 16) set_precision(std::max(least_bits, relative_bits + 32));
  rational y = x;
  for (long k = 1; k < exponent_; ++k) y *= x;
  // With about so many bits r(y) is exact.
  const mpq_srcptr q = y.backend().data();
  const std::size_t of_y =
      std::max(mpz_sizeinbase(mpq_numref(q), 2), mpz_sizeinbase(mpq_denref(q), 2));
  const auto most = static_cast<precision>(longest_ + p_.size() * (of_y + 1)) + relative_bits;
  while (true) {
    ++evaluations_;
    ball value = fixed_point_value(y);
    if (value.radius() <= scale(value.magnitude_lower(), -relative_bits)) return value;
    if (bits_ > most) break;
    set_precision(bits_ + bits_ / 2);
  }
  rational value = 0;
  for (std::size_t k = p_.size(); k-- > 0;) value = value * y + rational(p_[k]);
  return {value, bits_};
}

rational inner_point(const exact_interval& b) {
  const rational& low = *b.lower;
  const rational& high = *b.upper;
  if (low > 0 && high > 16 * low) return power_of_two((log2_of(low) + log2_of(high)) / 2);
  if (high < 0 && low < 16 * high) return -power_of_two((log2_of(low) + log2_of(high)) / 2);
  return near(b.middle(), b.width() / 4);
}

exact_interval narrowed(polynomial_values& p, exact_interval bracket, long bits) {
  if (bracket.is_point()) return bracket;
  return refinement(p, std::move(bracket)).to(bits);
}

}  // namespace polhode::detail
