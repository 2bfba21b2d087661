#pragma once

// The hot path: sums, products, quotients and roots of balls by midpoint. At small precisions an
// MPFR operation takes some 10 ns, so the error is kept as bare integers until it is normalised,
// once.

#include <cstdint>
#include <utility>

#include "ball_access.hpp"

namespace polhode::detail {

/// A bound bits * 2^exponent with bits < 2^62; exact zero where bits == 0.
struct raw_error {
  std::uint64_t bits = 0;
  std::int64_t exponent = 0;
};

/// x + y, rounded up.
inline raw_error raw_sum(const raw_error& x, const raw_error& y) {
  if (y.bits == 0) return x;
  if (x.bits == 0) return y;
  const bool x_leads = x.exponent >= y.exponent;
  const raw_error& lead = x_leads ? x : y;
  const raw_error& rest = x_leads ? y : x;
  const std::int64_t gap = lead.exponent - rest.exponent;
  return {lead.bits + (gap < 64 ? rest.bits >> gap : 0) + 1, lead.exponent};
}

/// x with half the bits, rounded up: two of these have a sum that is in range again.
inline raw_error halved(const raw_error& x) {
  if (x.bits == 0) return x;
  return {(x.bits >> 1) + 1, x.exponent + 1};
}

/// A finite magnitude with 30 zero bits behind it, so that sums lose little.
inline raw_error raw(const magnitude& x) {
  return {std::uint64_t{x.fraction()} << 30, x.exponent() - 30};
}

/// factor * x, rounded up, for factor below 2^31.
inline raw_error raw_product(std::uint64_t factor, std::int64_t factor_exponent,
                             const magnitude& x) {
  return {factor * x.fraction(), factor_exponent + x.exponent()};
}

/// |x| < (top bits + 1) * 2^(exp - 30) for a regular number: 30 bits of it.
struct leading_bits {
  explicit leading_bits(mpfr_srcptr x)
      : bits(static_cast<const mp_limb_t*>(
                 mpfr_custom_get_significand(x))[(mpfr_get_prec(x) - 1) / GMP_NUMB_BITS] >>
             34),
        exponent(std::int64_t{mpfr_get_exp(x)} - 30) {}
  std::uint64_t bits;
  std::int64_t exponent;
};

/// A ball by midpoint with that radius is too wide for its form, and is to pass to end points.
[[nodiscard]] bool is_wide(mpfr_srcptr midpoint, const magnitude& radius);
void pass_to_end_points(ball& r);

/// ball_access::finish for a midpoint that is a regular number and an error from above.
inline void finish_regular(ball& r, mpfr_srcptr midpoint, int ternary, raw_error error) {
  if (mpfr_regular_p(midpoint) == 0) {
    ball_access::finish(
        r, ternary,
        error.bits == 0 ? magnitude{} : magnitude::from_bits_up(error.bits, error.exponent));
    return;
  }
  if (ternary != 0) {
    const mpfr_prec_t p = mpfr_get_prec(midpoint);
    const auto* significand = static_cast<const mp_limb_t*>(mpfr_custom_get_significand(midpoint));
    if (significand[(p - 1) / GMP_NUMB_BITS] == mp_limb_t{1} << (GMP_NUMB_BITS - 1)) {
      // A bare top bit: perhaps an underflow, which rounding_error knows about.
      error = raw_sum(error, raw(rounding_error(midpoint)));
    } else {
      error =
          raw_sum(error, {std::uint64_t{1} << 60, std::int64_t{mpfr_get_exp(midpoint)} - p - 61});
    }
  }
  if (error.bits == 0) {
    ball_access::set_thin(r, {});
    return;
  }
  ball_access::set_thin(r, magnitude::from_many_bits_up(error.bits, error.exponent));
  if (is_wide(midpoint, ball_access::radius(r))) pass_to_end_points(r);
}

/// Sets r to the number f computes at p bits, within `error`; f may read balls that alias r.
template <class F>
inline void set_regular(ball& r, precision p, const raw_error& error, F&& f) {
  mpfr_cell& cell = ball_access::first(r);
  if (mpfr_get_prec(cell.get()) == p) {
    const int ternary = f(cell.get());
    finish_regular(r, cell.get(), ternary, error);
  } else {
    mpfr_cell fresh(p);
    const int ternary = f(fresh.get());
    cell = std::move(fresh);
    finish_regular(r, cell.get(), ternary, error);
  }
}

/// The error of x * y for |x - mx| <= rx, |y - my| <= ry: |mx| ry + (|my| + ry) rx. For a ball by
/// midpoint ry < 2^-23 |my|, so |my| + ry < |my| + 2^(7) units of its 30 leading bits.
inline raw_error product_error(const ball& x, const ball& y) {
  const magnitude& rx = ball_access::radius(x);
  const magnitude& ry = ball_access::radius(y);
  raw_error error;
  if (!ry.is_zero()) {
    if (mpfr_regular_p(ball_access::first(x)) == 0) return error;  // x is 0: the product is exact
    const leading_bits mx(ball_access::first(x));
    error = raw_product(mx.bits + 1, mx.exponent, ry);
  }
  if (!rx.is_zero()) {
    if (mpfr_regular_p(ball_access::first(y)) == 0) return {};
    const leading_bits my(ball_access::first(y));
    error = raw_sum(error, raw_product(my.bits + 129, my.exponent, rx));
  }
  return error;
}

}  // namespace polhode::detail
