#pragma once

// A bare MPFR number for tests, so that an oracle shares nothing with the code that it judges.

#include <algorithm>
#include <utility>

#include <mpfr.h>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::support {

class real {
 public:
  explicit real(mpfr_prec_t bits) { mpfr_init2(value_, bits); }
  real(mpfr_prec_t bits, long n) : real(bits) { mpfr_set_si(value_, n, MPFR_RNDN); }
  /// The rational q, rounded: exact where it is a dyadic number that fits.
  real(mpfr_prec_t bits, const rational& q, mpfr_rnd_t rounding) : real(bits) {
    mpfr_set_q(value_, q.backend().data(), rounding);
  }
  real(const real& other) : real(mpfr_get_prec(other.value_)) {
    mpfr_set(value_, other.value_, MPFR_RNDN);
  }
  real(real&& other) noexcept : real(2) { mpfr_swap(value_, other.value_); }
  real& operator=(real other) noexcept {
    mpfr_swap(value_, other.value_);
    return *this;
  }
  ~real() { mpfr_clear(value_); }

  /// 2^n.
  static real power_of_two(long n) {
    real r(64);
    mpfr_set_ui_2exp(r, 1, n, MPFR_RNDN);
    return r;
  }
  static real infinity(int sign) {
    real r(64);
    mpfr_set_inf(r, sign);
    return r;
  }
  static real nan() { return real(64); }

  // Passes for an MPFR argument, as mpfr_t itself does.
  operator mpfr_ptr() { return value_; }           // NOLINT(google-explicit-constructor)
  operator mpfr_srcptr() const { return value_; }  // NOLINT(google-explicit-constructor)
  [[nodiscard]] mpfr_ptr get() { return value_; }
  [[nodiscard]] mpfr_srcptr get() const { return value_; }

  [[nodiscard]] bool is_finite() const { return mpfr_number_p(value_) != 0; }

 private:
  mpfr_t value_;
};

/// The value of a finite MPFR number.
inline rational to_rational(mpfr_srcptr x) {
  rational q;
  mpfr_get_q(q.backend().data(), x);
  return q;
}

/// 2^n, exactly.
inline rational power_of_two(long n) {
  rational q(1);
  if (n >= 0) {
    mpq_mul_2exp(q.backend().data(), q.backend().data(), static_cast<mp_bitcnt_t>(n));
  } else {
    mpq_div_2exp(q.backend().data(), q.backend().data(), static_cast<mp_bitcnt_t>(-n));
  }
  return q;
}

inline long bit_length(const integer& n) {
  return n == 0 ? 0 : static_cast<long>(mpz_sizeinbase(n.backend().data(), 2));
}

/// The dyadic number q as an MPFR number, exactly.
inline real exact_real(const rational& q) {
  const long bits = std::max({bit_length(numerator(q)), bit_length(denominator(q)), 64L});
  return {bits, q, MPFR_RNDN};
}

/// floor(log2 |q|) for q != 0.
inline long log2_floor(const rational& q) {
  const rational size = abs(q);
  const long guess = bit_length(numerator(size)) - bit_length(denominator(size));
  return size < power_of_two(guess) ? guess - 1 : guess;
}

/// The unit in the last place of a p-bit number of the size of q; 0 for 0.
inline rational ulp(const rational& q, precision p) {
  return q == 0 ? rational(0) : power_of_two(log2_floor(q) + 1 - p);
}

/// The value of a finite magnitude.
inline rational to_rational(const magnitude& m) {
  return m.is_zero() ? rational(0)
                     : rational(m.fraction()) * power_of_two(static_cast<long>(m.exponent()));
}

}  // namespace polhode::support
