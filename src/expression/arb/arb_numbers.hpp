#pragma once

// Complex balls to and from Arb's. Compiled only where Arb is found.

#include <array>

#include "arb_library.hpp"
#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode::detail {

/// A set of p bits that holds it; undefined where it is not bounded.
[[nodiscard]] complex_ball to_complex_ball(acb_srcptr z, precision p);

/// A complex number of Arb: a rectangle, of which each side is a midpoint and a radius.
class arb_number {
 public:
  /// Throws std::runtime_error where Arb cannot be loaded: before there is anything to clear.
  arb_number() {
    (void)arb();
    acb_init(z_);
  }
  /// A set that holds z; everything where z is not bounded.
  explicit arb_number(const complex_ball& z);
  arb_number(const arb_number&) = delete;
  arb_number& operator=(const arb_number&) = delete;
  ~arb_number() { arb().acb_clear(z_); }

  [[nodiscard]] acb_ptr get() { return z_; }
  [[nodiscard]] acb_srcptr get() const { return z_; }
  /// A set of p bits that holds it; undefined where it is not bounded.
  [[nodiscard]] complex_ball to_complex_ball(precision p) const {
    return detail::to_complex_ball(z_, p);
  }
  /// About how many bits of it are known.
  [[nodiscard]] long accuracy() const { return -arb().acb_rel_error_bits(z_); }

 private:
  acb_t z_;
};

/// A value and a derivative, one after the other.
class arb_jet {
 public:
  arb_jet() {
    (void)arb();
    for (acb_struct& z : z_) acb_init(&z);
  }
  arb_jet(const arb_jet&) = delete;
  arb_jet& operator=(const arb_jet&) = delete;
  ~arb_jet() {
    for (acb_struct& z : z_) arb().acb_clear(&z);
  }

  [[nodiscard]] acb_ptr get() { return z_.data(); }
  [[nodiscard]] complex_ball value(precision p) const { return to_complex_ball(z_.data(), p); }
  [[nodiscard]] complex_ball derivative(precision p) const { return to_complex_ball(&z_[1], p); }

 private:
  std::array<acb_struct, 2> z_;
};

}  // namespace polhode::detail
