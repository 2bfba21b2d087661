#pragma once

// A limit of integration: an exact number (a rational one, or q + r pi), a real number that can be had to any
// precision, or an infinity.

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/pi_combination.hpp"

namespace polhode {

class limit {
 public:
  template <machine_integer N>
  limit(N n)  // NOLINT(google-explicit-constructor): exact
      : limit(rational(n)) {}
  limit(const rational& q)  // NOLINT(google-explicit-constructor): exact
      : limit(pi_combination{q, 0}) {}
  /// The set x, whose width the result cannot fall below.
  limit(const ball& x)  // NOLINT(google-explicit-constructor): the same set
      : limit([x](precision) { return x; }) {}
  /// q + r pi, known as such: a function that is even about it, or of such a period, is integrated by fewer
  /// evaluations.
  explicit limit(const pi_combination& x)
      : at_(shared([x](precision p) { return x.at(p); })),
        exact_(x.is_rational()),
        value_(x.q),
        form_(x) {}
  /// r pi.
  [[nodiscard]] static limit pi(const rational& r = 1) { return limit(pi_combination{0, r}); }
  /// A number that at(p) encloses with p bits: limit([](precision p) { return sqrt(ball(2, p)); }).
  explicit limit(std::function<ball(precision)> at) : at_(shared(std::move(at))) {}
  /// A double is a decimal only by accident: see ball.
  template <std::floating_point N>
  limit(N) = delete;

  [[nodiscard]] static limit infinity() { return limit(1, infinite{}); }
  friend limit operator-(const limit& x) {
    if (x.infinite_ != 0) return {-x.infinite_, infinite{}};
    if (x.form_) return limit(-*x.form_);
    return limit([at = x.at_](precision p) { return -(*at)(p); });
  }

  /// 1 for infinity, -1 for -infinity, else 0.
  [[nodiscard]] int infinite_sign() const { return infinite_; }
  [[nodiscard]] bool is_exact() const { return exact_; }
  /// The number, where it is exact.
  [[nodiscard]] const rational& exact_value() const { return value_; }
  /// The number as q + r pi, where it was given so.
  [[nodiscard]] const std::optional<pi_combination>& form() const { return form_; }
  /// An enclosure with p bits; undefined for an infinity.
  [[nodiscard]] ball at(precision p) const {
    return infinite_ == 0 ? (*at_)(p) : ball::undefined(p);
  }
  /// They are the same point for certain: equal exact numbers, the same infinity, or copies of one limit.
  [[nodiscard]] bool is_same_as(const limit& other) const {
    if (infinite_ != other.infinite_) return false;
    if (infinite_ != 0) return true;
    if (form_ && other.form_) return *form_ == *other.form_;
    return at_ == other.at_;
  }

 private:
  using function = std::function<ball(precision)>;
  struct infinite {};
  limit(int sign, infinite) : infinite_(sign) {}
  static std::shared_ptr<const function> shared(function at) {
    return std::make_shared<const function>(std::move(at));
  }

  std::shared_ptr<const function> at_;
  bool exact_ = false;
  rational value_ = 0;
  std::optional<pi_combination> form_;
  int infinite_ = 0;
};

}  // namespace polhode
