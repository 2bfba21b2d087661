#pragma once

// Complex balls to and from Arb's. Compiled only where Arb is found.

#include "arb_library.hpp"
#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode::detail {

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
  [[nodiscard]] complex_ball to_complex_ball(precision p) const;
  /// About how many bits of it are known.
  [[nodiscard]] long accuracy() const { return -arb().acb_rel_error_bits(z_); }

 private:
  acb_t z_;
};

}  // namespace polhode::detail
