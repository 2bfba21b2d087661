#include "quadrature/formula/symmetry.hpp"

namespace polhode {

namespace {

/// Numbers that have become longer are forgotten: what is made of them is known less well, and no
/// worse.
bool is_short(const rational& q) {
  constexpr std::size_t most_bits = 4096;
  return mpz_sizeinbase(numerator(q).backend().data(), 2) <= most_bits &&
         mpz_sizeinbase(denominator(q).backend().data(), 2) <= most_bits;
}
bool is_short(const pi_combination& x) { return is_short(x.q) && is_short(x.r); }

std::optional<integer> whole(const rational& q) {
  if (denominator(q) != 1) return std::nullopt;
  return numerator(q);
}

bool is_odd_number(const integer& k) { return mpz_odd_p(k.backend().data()) != 0; }

/// (q + r pi) (q' + r' pi) where that has no square of pi.
std::optional<pi_combination> product(const pi_combination& x, const pi_combination& y) {
  if (x.is_rational()) return y * x.q;
  if (y.is_rational()) return x * y.q;
  return std::nullopt;
}

}  // namespace

symmetry symmetry::known(int sign, const pi_combination& shift) {
  symmetry v;
  if (!is_short(shift)) return v;
  v.sign_ = sign;
  v.shift_ = shift;
  return v;
}

symmetry::symmetry(const pi_combination& value) {
  sign_ = 1;
  constant_ = true;
  if (is_short(value)) value_ = value;
}

symmetry symmetry::some_constant() {
  symmetry v;
  v.sign_ = 1;
  v.constant_ = true;
  return v;
}

symmetry symmetry::reflection(const pi_combination& a) { return known(-1, a * 2); }
symmetry symmetry::translation(const pi_combination& by) { return known(1, by); }

/// A constant k: k = k + 0, and k = -k + 2k.
symmetry symmetry::with_sign(int sign) const {
  if (sign_ == sign) return *this;
  if (!value_) return {};
  return known(sign, *value_ * 2);
}

symmetry operator-(const symmetry& u) {
  if (u.value_) return symmetry(-*u.value_);
  symmetry v = u;
  v.shift_ = -u.shift_;
  return v;
}

/// (e u + c) + (e v + d) = e (u + v) + (c + d).
symmetry operator+(const symmetry& u, const symmetry& v) {
  if (u.constant_ && v.constant_) {
    if (u.value_ && v.value_) return symmetry(*u.value_ + *v.value_);
    return symmetry::some_constant();
  }
  if (u.constant_) return v + u;
  const symmetry w = v.with_sign(u.sign_);
  if (u.sign_ == 0 || w.sign_ == 0) return {};
  return symmetry::known(u.sign_, u.shift_ + w.shift_);
}

/// k (e v + c) = e (k v) + k c.
symmetry symmetry::times(const pi_combination& constant) const {
  const std::optional<pi_combination> shift = product(constant, shift_);
  if (sign_ == 0 || !shift) return {};
  return known(sign_, *shift);
}

/// (e u) (e' v) = e e' (u v); and a constant times e v + c.
symmetry operator*(const symmetry& u, const symmetry& v) {
  if (u.constant_ && v.constant_) {
    if (u.value_ && v.value_) {
      if (const auto value = product(*u.value_, *v.value_)) return symmetry(*value);
    }
    return symmetry::some_constant();
  }
  if (u.value_ && !v.shift_.is_zero()) return v.times(*u.value_);
  if (v.value_ && !u.shift_.is_zero()) return u.times(*v.value_);
  if (u.sign_ == 0 || v.sign_ == 0 || !u.shift_.is_zero() || !v.shift_.is_zero()) return {};
  return symmetry::known(u.sign_ * v.sign_, {});
}

/// 1/v has the sign of v where c = 0. A multiple r pi divided by r' pi is rational.
symmetry operator/(const symmetry& u, const symmetry& v) {
  if (v.value_) {
    const pi_combination& k = *v.value_;
    if (k.is_zero()) return {};  // undefined everywhere
    if (k.is_rational()) return u * symmetry(pi_combination{1 / k.q, 0});
    if (k.q == 0 && u.value_ && u.value_->q == 0) {
      return symmetry(pi_combination{u.value_->r / k.r, 0});
    }
    if (k.q == 0 && !u.constant_ && u.sign_ != 0 && u.shift_.q == 0) {
      return symmetry::known(u.sign_, {u.shift_.r / k.r, 0});
    }
  }
  if (u.constant_ && v.constant_) return symmetry::some_constant();
  if (u.sign_ == 0 || v.sign_ == 0 || !u.shift_.is_zero() || !v.shift_.is_zero()) return {};
  return symmetry::known(u.sign_ * v.sign_, {});
}

symmetry symmetry::under_any_function() const {
  if (constant_) return some_constant();
  return is_invariant() ? *this : symmetry();
}
symmetry symmetry::under_odd_function() const { return is_odd() ? *this : under_any_function(); }
symmetry symmetry::under_even_function() const {
  return is_odd() ? known(1, {}) : under_any_function();
}

symmetry symmetry::of_two(const symmetry& u, const symmetry& v) {
  if (u.constant_ && v.constant_) return some_constant();
  return u.is_invariant() && v.is_invariant() ? known(1, {}) : symmetry();
}

symmetry pow(const symmetry& v, long n) {
  if (v.value_ && v.value_->is_rational()) {  // small powers of numbers stay known
    if (n >= 0 && n <= 8) {
      rational power = 1;
      for (long i = 0; i < n; ++i) power *= v.value_->q;
      return symmetry(power);
    }
  }
  return n % 2 != 0 ? v.under_odd_function() : v.under_even_function();
}

std::optional<integer> symmetry::half_turns() const {
  if (shift_.q != 0) return std::nullopt;
  return whole(shift_.r);
}
std::optional<integer> symmetry::halves() const {
  if (!shift_.is_rational()) return std::nullopt;
  return whole(shift_.q);
}

symmetry symmetry::under_circular_function(bool is_sine, const std::optional<integer>& k) const {
  if (constant_) return some_constant();
  if (sign_ == 0 || !k) return {};
  const int turned = is_odd_number(*k) ? -1 : 1;
  return known(is_sine ? turned * sign_ : turned, {});
}

symmetry tan(const symmetry& v) {
  if (v.constant_) return symmetry::some_constant();
  if (v.sign_ == 0 || !v.half_turns()) return {};
  return symmetry::known(v.sign_, {});
}

symmetry acos(const symmetry& v) {
  return v.is_odd() ? symmetry::known(-1, {0, 1}) : v.under_any_function();
}

symmetry erfc(const symmetry& v) {
  return v.is_odd() ? symmetry::known(-1, {2, 0}) : v.under_any_function();
}

}  // namespace polhode
