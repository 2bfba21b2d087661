#pragma once

// The recurrence (1) of taylor_series.hpp in integers, and the sums that are formed of its numbers.

#include <cstddef>
#include <optional>
#include <vector>

#include "local_polynomial.hpp"
#include "polhode/arithmetic/ball.hpp"

namespace polhode::detail {

/// z as an integer in units of 2^-F.
struct fixed_point_number {
  integer value;
  magnitude error;  // of z
};
[[nodiscard]] fixed_point_number in_fixed_point(const ball& z, long f);

/// G(z) = sum of e_n z^n / (n + p + 1), at one z with |z| <= 1, term by term.
class antiderivative {
 public:
  antiderivative(fixed_point_number z, long f) : z_(std::move(z)), f_(f) {
    mpz_setbit(power_.backend().data(), static_cast<mp_bitcnt_t>(f));
  }
  /// b_n = e_n / (n + p + 1), for n = 0, 1, ...
  void add(const integer& b) {
    mpz_ptr term = term_.backend().data();
    mpz_ptr power = power_.backend().data();
    const auto shift = static_cast<mp_bitcnt_t>(f_);
    mpz_mul(term, b.backend().data(), power);
    mpz_tdiv_q_2exp(term, term, shift);
    sum_ += term_;
    mpz_mul(power, power, z_.value.backend().data());
    mpz_tdiv_q_2exp(power, power, shift);
  }
  [[nodiscard]] const integer& sum() const { return sum_; }
  [[nodiscard]] const magnitude& error_of_z() const { return z_.error; }

 private:
  fixed_point_number z_;
  long f_;
  integer power_;  // z^n
  integer term_;
  integer sum_;
};

/// The real or the imaginary part of a series, and of its integral.
struct series_part {
  std::vector<integer> a;  // the last of the a_n, in a ring
  integer at_plus;         // the sum of the b_n, which is G(1)
  integer at_minus;        // G(-1)
  long terms = 0;          // the e_n that are not 0
  integer sum_of_sizes;    // of the |e_n|
  integer of_powers;       // the sum of the (n - 1) |b_n|, n >= 2
  std::optional<antiderivative> at_low;
  std::optional<antiderivative> at_high;

  /// b_n and e_n, which is not kept.
  void add(const integer& b, integer& e, long n, bool is_cut) {
    if (mpz_sgn(e.backend().data()) != 0) ++terms;
    at_plus += b;
    if (!is_cut) return;
    if (n % 2 == 0) {
      at_minus += b;
    } else {
      at_minus -= b;
    }
    if (at_low) at_low->add(b);
    if (at_high) at_high->add(b);
    mpz_abs(e.backend().data(), e.backend().data());
    sum_of_sizes += e;
    if (n < 2) return;
    const bool is_negative = mpz_sgn(b.backend().data()) < 0;
    (is_negative ? mpz_submul_ui : mpz_addmul_ui)(of_powers.backend().data(), b.backend().data(),
                                                  static_cast<unsigned long>(n - 1));
  }
};

/// Q, S = s + i t and P, in integers, and p.
struct taylor_recurrence {
  integers q;
  integers s;
  integers t;
  integers numerator;
  rational power;
};

/// Which terms are wanted.
struct wanted_terms {
  long f = 0;  // in units of 2^-f
  long most_terms = 0;
  bool only_even = false;  // of the sums; a_n are all of them
  bool is_cut = false;
};

struct computed_terms {
  long count = 0;
  long divisions = 0;  // by (1), of numbers that are not 0: N of the theorem
};

/// Adds the terms to the real part and, where there are two, the imaginary one. Returns nullopt
/// where that takes more terms than allowed, or where the series does not converge.
[[nodiscard]] std::optional<computed_terms> add_terms(const taylor_recurrence& of,
                                                      const wanted_terms& wanted,
                                                      std::vector<series_part>& part);

}  // namespace polhode::detail
