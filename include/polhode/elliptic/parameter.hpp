#pragma once

// The parameter of elliptic integrals and functions, m = k^2 (not the modulus k), given by m or by
// m1 = 1 - m: near m = 1 only m1 tells how near.

#include <utility>

#include "polhode/arithmetic/boost_bridge.hpp"

namespace polhode {

/// T is ball, mpfr_float or double. A T converts: elliptic_k(m) is K of the parameter m.
template <class T>
class elliptic_parameter {
 public:
  elliptic_parameter(T m)  // NOLINT(google-explicit-constructor): what it most often is
      : given_(std::move(m)) {}
  static elliptic_parameter with_complement(const T& m1) {
    elliptic_parameter result(m1);
    result.by_complement_ = true;
    return result;
  }

  /// m, or m1 where is_complement().
  [[nodiscard]] const T& given() const { return given_; }
  [[nodiscard]] bool is_complement() const { return by_complement_; }
  [[nodiscard]] T m() const { return by_complement_ ? T(1 - given_) : given_; }
  [[nodiscard]] T m1() const { return by_complement_ ? given_ : T(1 - given_); }

 private:
  T given_;
  bool by_complement_ = false;
};

}  // namespace polhode
