#pragma once

// A limit of integration: an exact number, a real number that can be had to any precision, or an
// infinity.

#include <functional>
#include <utility>

#include "polhode/arithmetic/exact.hpp"

namespace polhode {

class limit {
 public:
  template <machine_integer N>
  limit(N n)  // NOLINT(google-explicit-constructor): exact
      : limit(rational(n)) {}
  limit(const rational& q)  // NOLINT(google-explicit-constructor): exact
      : at_([q](precision p) { return ball(q, p); }), exact_(true), value_(q) {}
  /// The set x, whose width the result cannot fall below.
  limit(const ball& x)  // NOLINT(google-explicit-constructor): the same set
      : at_([x](precision) { return x; }) {}
  /// A number that at(p) encloses with p bits, such as pi: limit([](precision p) { return pi(p); }).
  explicit limit(std::function<ball(precision)> at) : at_(std::move(at)) {}
  /// A double is a decimal only by accident: see ball.
  template <std::floating_point N>
  limit(N) = delete;

  [[nodiscard]] static limit infinity() { return limit(1, infinite{}); }
  friend limit operator-(const limit& x) {
    if (x.infinite_ != 0) return {-x.infinite_, infinite{}};
    if (x.exact_) return limit(rational(-x.value_));
    return limit([at = x.at_](precision p) { return -at(p); });
  }

  /// 1 for infinity, -1 for -infinity, else 0.
  [[nodiscard]] int infinite_sign() const { return infinite_; }
  [[nodiscard]] bool is_exact() const { return exact_; }
  /// The number, where it is exact.
  [[nodiscard]] const rational& exact_value() const { return value_; }
  /// An enclosure with p bits; undefined for an infinity.
  [[nodiscard]] ball at(precision p) const { return infinite_ == 0 ? at_(p) : ball::undefined(p); }

 private:
  struct infinite {};
  limit(int sign, infinite) : infinite_(sign) {}

  std::function<ball(precision)> at_;
  bool exact_ = false;
  rational value_ = 0;
  int infinite_ = 0;
};

}  // namespace polhode
