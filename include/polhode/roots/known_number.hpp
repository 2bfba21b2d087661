#pragma once

// A real number that is known exactly, as a rational one or as q + r pi, or by an enclosure: the scalar of jets in
// which "is 0" can be decided. Exact are the results of + - * / and the values of functions at the few points where
// they are evidently rational (exp 0, cos 0, sin pi, sqrt of a square, ...).

#include <optional>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/pi_combination.hpp"

namespace polhode::detail {

class known_number {
 public:
  known_number() : known_number(rational(0), 64) {}
  known_number(const rational& q, precision p) : exact_(q), enclosure_(q, p) {}
  known_number(const pi_combination& x, precision p) : enclosure_(x.at(p)) {
    if (x.is_rational()) {
      exact_ = x.q;
    } else {
      with_pi_ = x;
    }
  }
  explicit known_number(ball x) : enclosure_(std::move(x)) {}

  [[nodiscard]] const std::optional<rational>& exact() const { return exact_; }
  /// q + r pi where it is known to be that with r != 0; it is no rational number then.
  [[nodiscard]] const std::optional<pi_combination>& with_pi() const { return with_pi_; }
  [[nodiscard]] const ball& enclosure() const { return enclosure_; }
  [[nodiscard]] bool is_exactly(long n) const { return exact_ && *exact_ == n; }

  friend known_number operator-(const known_number& x) {
    if (x.exact_) return x.like(-*x.exact_);
    if (x.with_pi_) return x.like(-*x.with_pi_);
    return known_number(-x.enclosure_);
  }
  friend known_number operator+(const known_number& x, const known_number& y) {
    if (x.exact_ && y.exact_) return x.like(*x.exact_ + *y.exact_);
    if (const auto s = x.form(), t = y.form(); s && t) return x.like(*s + *t);
    return known_number(x.enclosure_ + y.enclosure_);
  }
  friend known_number operator-(const known_number& x, const known_number& y) { return x + (-y); }
  /// 0 times a number is 0, however little is known of the number if it is defined.
  friend known_number operator*(const known_number& x, const known_number& y) {
    if (x.exact_ && y.exact_) return x.like(*x.exact_ * *y.exact_);
    const bool defined = !x.enclosure_.is_undefined() && !y.enclosure_.is_undefined();
    if (defined && (x.is_exactly(0) || y.is_exactly(0))) return x.like(rational(0));
    if (x.with_pi_ && y.exact_) return x.like(*x.with_pi_ * *y.exact_);
    if (x.exact_ && y.with_pi_) return x.like(*y.with_pi_ * *x.exact_);
    return known_number(x.enclosure_ * y.enclosure_);
  }
  friend known_number operator/(const known_number& x, const known_number& y) {
    if (x.exact_ && y.exact_ && *y.exact_ != 0) return x.like(*x.exact_ / *y.exact_);
    if (x.with_pi_ && y.exact_ && *y.exact_ != 0) return x.like(*x.with_pi_ * (1 / *y.exact_));
    if (x.is_exactly(0) && !y.enclosure_.is_undefined() && !contains_zero(y.enclosure_)) return x;
    return known_number(x.enclosure_ / y.enclosure_);
  }
  known_number& operator+=(const known_number& y) { return *this = *this + y; }
  friend known_number operator+(const known_number& x, long n) { return x + x.like(n); }
  friend known_number operator-(const known_number& x, long n) { return x - x.like(n); }
  friend known_number operator*(const known_number& x, long n) { return x * x.like(n); }
  friend known_number operator/(const known_number& x, long n) { return x / x.like(n); }

  /// x, or its enclosure where it is too long to be kept.
  [[nodiscard]] known_number like(const pi_combination& x) const {
    constexpr std::size_t longest = 1U << 14;
    known_number r(x, enclosure_.precision());
    const auto is_long = [](const rational& q) {
      const mpq_srcptr parts = q.backend().data();
      return mpz_sizeinbase(mpq_numref(parts), 2) > longest ||
             mpz_sizeinbase(mpq_denref(parts), 2) > longest;
    };
    if (is_long(x.q) || is_long(x.r)) {
      r.exact_.reset();
      r.with_pi_.reset();
    }
    return r;
  }
  [[nodiscard]] known_number like(const rational& q) const { return like(pi_combination{q, 0}); }
  [[nodiscard]] known_number like(long n) const { return like(rational(n)); }

 private:
  [[nodiscard]] std::optional<pi_combination> form() const {
    return exact_ ? pi_combination{*exact_, 0} : with_pi_;
  }

  std::optional<rational> exact_;
  std::optional<pi_combination> with_pi_;
  ball enclosure_;
};

[[nodiscard]] known_number sqrt(const known_number& x);
// exp(0) = 1, log(1) = 0, sin(0) = 0, ..., and sin, cos and tan at multiples of pi/2.
[[nodiscard]] known_number exp(const known_number& x);
[[nodiscard]] known_number log(const known_number& x);
[[nodiscard]] known_number sin(const known_number& x);
[[nodiscard]] known_number cos(const known_number& x);
[[nodiscard]] known_number tan(const known_number& x);
[[nodiscard]] known_number asin(const known_number& x);
[[nodiscard]] known_number acos(const known_number& x);
[[nodiscard]] known_number atan(const known_number& x);
[[nodiscard]] known_number sinh(const known_number& x);
[[nodiscard]] known_number cosh(const known_number& x);
[[nodiscard]] known_number tanh(const known_number& x);
[[nodiscard]] known_number asinh(const known_number& x);
[[nodiscard]] known_number acosh(const known_number& x);
[[nodiscard]] known_number atanh(const known_number& x);

}  // namespace polhode::detail
