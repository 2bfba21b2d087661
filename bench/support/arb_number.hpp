#pragma once

// Arb's balls beside ours. Only where POLHODE_HAVE_ARB is defined.

#include <stdexcept>

#include <acb.h>
#include <arb.h>

#include "polhode/arithmetic/ball.hpp"

namespace polhode::bench {

class arb_number {
 public:
  arb_number() { arb_init(value_); }
  arb_number(const arb_number& other) : arb_number() { arb_set(value_, other.value_); }
  arb_number& operator=(const arb_number& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  ~arb_number() { arb_clear(value_); }
  [[nodiscard]] arb_ptr get() { return value_; }
  [[nodiscard]] arb_srcptr get() const { return value_; }

 private:
  arb_t value_;
};

class acb_number {
 public:
  acb_number() { acb_init(value_); }
  acb_number(const acb_number& other) : acb_number() { acb_set(value_, other.value_); }
  acb_number& operator=(const acb_number& other) {
    acb_set(value_, other.value_);
    return *this;
  }
  ~acb_number() { acb_clear(value_); }
  [[nodiscard]] acb_ptr get() { return value_; }
  [[nodiscard]] acb_srcptr get() const { return value_; }

 private:
  acb_t value_;
};

/// The set of x, with p bits.
[[nodiscard]] inline ball from_arb(arb_srcptr x, precision p) {
  polhode::detail::mpfr_cell lower(p);
  polhode::detail::mpfr_cell upper(p);
  arb_get_interval_mpfr(lower.get(), upper.get(), x);
  return ball::from_end_points(lower.get(), upper.get(), p);
}

/// Contestants must compute the same number: throws where the enclosures are disjoint, or where
/// either has not the relative accuracy of `bits` bits.
inline void require_agreement(const ball& ours, arb_srcptr theirs, long bits) {
  const ball other = from_arb(theirs, ours.precision());
  const auto accurate = [bits](const ball& x) {
    return x.radius() <= scale(x.magnitude_lower(), -bits);
  };
  if (!overlaps(ours, other)) throw std::logic_error("the contestants' results are disjoint");
  if (!accurate(ours)) throw std::logic_error("our result is less accurate than was asked");
  if (!accurate(other)) throw std::logic_error("Arb's result is less accurate than was asked");
}

}  // namespace polhode::bench
